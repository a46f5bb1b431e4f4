//! Catalogue file to fill in: every key of an actuator with its meaning and its place in a data sheet.

use project::sections::{ActuatorEntry, Section};
use project::{CATALOGUE_KEYS, Key, Kind, example};
use quantities::Language;
use std::fmt::Write as _;
use words::catalogue_template;
use words::{Word, about_text};

quantities::identified! {
    /// Format of a catalogue file.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum CatalogueFormat {
        /// TOML.
        Toml = "toml",
        /// A table with a product for each row.
        Csv = "csv",
    }
}

/// Keys that a data sheet states at one place.
struct KeyGroup {
    title: Word,
    /// Place in a data sheet, and what is confused there.
    place: Word,
    keys: &'static [&'static str],
}

const GROUPS: [KeyGroup; 8] = [
    KeyGroup {
        title: catalogue_template::offer,
        place: catalogue_template::offer_place,
        keys: &["id", "maker", "series", "source", "price", "lead_time"],
    },
    KeyGroup {
        title: catalogue_template::ratings,
        place: catalogue_template::ratings_place,
        keys: &[
            "ratio",
            "torque_max",
            "speed_max",
            "stall_torque",
            "stall_current",
            "current_max",
            "torque_constant_out",
            "inertia_out",
            "mass",
            "length",
            "hollow_shaft",
            "continuous_curve",
            "short_time_curve",
        ],
    },
    KeyGroup {
        title: catalogue_template::motor,
        place: catalogue_template::motor_place,
        keys: &[
            "speed_motor_max",
            "speed_motor_rated",
            "torque_constant_motor",
            "voltage_constant_motor",
            "resistance_ll",
            "inductance_ll",
            "pole_pairs",
            "current_demagnetisation",
            "no_load_starting_current",
            "no_load_current_constant_30",
            "no_load_current_constant_80",
            "winding_temperature_max",
            "winding_time_constant",
            "dc_link_max",
            "terminal_voltage_min",
        ],
    },
    KeyGroup {
        title: catalogue_template::gear,
        place: catalogue_template::gear_place,
        keys: &[
            "gear_torque_rated",
            "gear_torque_mean_max",
            "gear_torque_momentary_max",
            "gear_speed_max",
            "gear_speed_mean_max",
            "gear_life_rated",
            "gear_life_speed",
            "stiffness_1",
            "stiffness_2",
            "stiffness_3",
            "torque_1",
            "torque_2",
            "transmission_accuracy",
            "repeatability",
            "hysteresis_loss",
            "lost_motion",
        ],
    },
    KeyGroup {
        title: catalogue_template::bearing,
        place: catalogue_template::bearing_place,
        keys: &[
            "bearing_type",
            "bearing_pitch_diameter",
            "bearing_offset",
            "bearing_dynamic",
            "bearing_static",
            "tilting_moment_max",
            "static_moment_max",
            "axial_force_max",
            "radial_force_max",
            "tilting_stiffness",
        ],
    },
    KeyGroup {
        title: catalogue_template::brake,
        place: catalogue_template::brake_place,
        keys: &["brake_torque", "brake_closing_time", "brake_opening_time"],
    },
    KeyGroup {
        title: catalogue_template::encoder,
        place: catalogue_template::encoder_place,
        keys: &["feedback_resolution", "feedback_accuracy"],
    },
    KeyGroup {
        title: catalogue_template::ambient,
        place: catalogue_template::ambient_place,
        keys: &["ambient_min", "ambient_max"],
    },
];

/// Returns a catalogue file to fill in, with comments in a language, for a file name: a product of an invented name that states
/// nothing, and every key with its symbol, an example with its unit, and its place in a data sheet.
pub(crate) fn catalogue_template(format: CatalogueFormat, file: &str, language: Language) -> String {
    match format {
        CatalogueFormat::Toml => toml(file, language),
        CatalogueFormat::Csv => csv(file, language),
    }
}

fn key_of(name: &str) -> Option<&'static Key> {
    ActuatorEntry::KEYS.iter().find(|key| key.name == name)
}

/// Returns the remarks at the head of a file.
fn remarks(file: &str, language: Language) -> Vec<String> {
    let traps = [
        catalogue_template::rms,
        catalogue_template::line_to_line,
        catalogue_template::voltage_constant,
        catalogue_template::cold,
        catalogue_template::side,
        catalogue_template::not_stated,
    ];
    let traps = traps.into_iter().map(|trap: Word| trap(language).to_owned());
    std::iter::once(catalogue_template::how_to_check(&file, language)).chain(traps).collect()
}

fn toml(file: &str, language: Language) -> String {
    let mut out: String = remarks(file, language).iter().map(|line| format!("# {line}\n")).collect();
    out.push_str("\n[catalogue]\n");
    let head = CATALOGUE_KEYS.iter().find(|key| key.name == "catalogue").map_or(&[][..], |key| key.kind.keys(false));
    for key in head {
        // Writing to a text does not fail.
        let _ = writeln!(out, "# {}  # {}", example(key).unwrap_or_default(), about_text(key.about, language));
    }
    out.push_str("\n[[actuator]]\n");
    for (index, group) in GROUPS.iter().enumerate() {
        if index > 0 {
            let _ = write!(out, "\n# {}. {}\n", (group.title)(language), (group.place)(language));
        }
        for key in group.keys.iter().filter_map(|name| key_of(name)) {
            // The name is the only value that a product must have.
            let mark = if key.required { "" } else { "# " };
            let _ = writeln!(out, "{mark}{}  # {}", example(key).unwrap_or_default(), about_text(key.about, language));
        }
    }
    out
}

fn csv(file: &str, language: Language) -> String {
    // A remark is one cell, so that no part of it is taken for a heading.
    let remark = |text: &str| format!("\"# {}\"\n", text.replace('"', "'"));
    let mut out: String = remarks(file, language).iter().map(|line| remark(line)).collect();
    let mut headings: Vec<String> = Vec::new();
    for group in &GROUPS {
        out.push_str(&remark(&format!("{}. {}", (group.title)(language), (group.place)(language))));
        for key in group.keys.iter().filter_map(|name| key_of(name)) {
            if matches!(key.kind, Kind::Rows(_)) {
                continue;
            }
            out.push_str(&remark(&format!("{}: {}", heading(key), about_text(key.about, language))));
            headings.push(heading(key));
        }
    }
    let _ = writeln!(out, "{}", headings.join(";"));
    let id = key_of("id").and_then(example).unwrap_or_default();
    let name = id.split('"').nth(1).unwrap_or_default();
    let _ = writeln!(out, "{name}{}", ";".repeat(headings.len().saturating_sub(1)));
    out
}

/// Returns the heading of a key, with the unit of its example.
fn heading(key: &Key) -> String {
    let Kind::Quantity(dimension, _) = key.kind else { return key.name.to_owned() };
    let line = example(key).unwrap_or_default();
    let unit = line.split('"').nth(1).and_then(|value| value.split_once(' ')).map(|(_, unit)| unit);
    format!("{} [{}]", key.name, unit.unwrap_or_else(|| dimension.units().first().map_or("", |unit| unit.ascii)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn products(file: &str, text: &str) -> usize {
        let parameters = crate::embedded_catalogue().own_actuator();
        let read = axis::read_products(file, text.as_bytes(), &parameters);
        read.unwrap_or_else(|faults| panic!("{text}\n{:?}", words::worded(&faults, Language::En))).len()
    }

    #[test]
    fn a_template_is_a_catalogue_file_and_names_every_key() {
        let keys: BTreeSet<&str> = ActuatorEntry::KEYS.iter().map(|key| key.name).collect();
        let grouped: Vec<&str> = GROUPS.iter().flat_map(|group| group.keys.iter().copied()).collect();
        assert_eq!(grouped.len(), keys.len());
        assert_eq!(grouped.into_iter().collect::<BTreeSet<&str>>(), keys);
        for language in Language::ALL {
            for format in CatalogueFormat::ALL {
                let file = format!("my stock.{}", format.id());
                let text = catalogue_template(format, &file, language);
                assert_eq!(products(&file, &text), 1);
                assert!(text.contains(&format!("antrieb catalogue check {file}")), "{text}");
                let is_curve = |key: &str| key.ends_with("_curve");
                for key in keys.iter().filter(|key| format == CatalogueFormat::Toml || !is_curve(key)) {
                    assert!(text.contains(key), "{format:?} {key}");
                }
            }
        }
    }

    /// Every example line of the template is read: with all keys stated there is no fault.
    #[test]
    fn a_template_with_all_its_lines_switched_on_is_read() {
        for language in Language::ALL {
            let text = catalogue_template(CatalogueFormat::Toml, "stock.toml", language);
            let is_key = |line: &&str| line.split_once(" = ").is_some_and(|(key, _)| !key.contains(' '));
            let on: Vec<&str> =
                text.lines().map(|line| line.strip_prefix("# ").filter(is_key).unwrap_or(line)).collect();
            assert!(on.iter().filter(|line| is_key(line)).count() > ActuatorEntry::KEYS.len());
            assert_eq!(products("stock.toml", &on.join("\n")), 1);
        }
    }

    /// A number in every column of the table is read with the unit of its heading.
    #[test]
    fn a_template_table_takes_numbers_in_all_its_columns() {
        let text = catalogue_template(CatalogueFormat::Csv, "stock.csv", Language::De);
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let row = lines.pop().unwrap_or_default();
        let headings = lines.last().cloned().unwrap_or_default();
        let filled = headings.split(';').zip(row.split(';')).map(|(heading, cell)| match heading {
            "bearing_type" => "crossed_roller",
            "pole_pairs" | "ratio" => "5",
            heading if heading.ends_with(']') => "1,5",
            _ => cell,
        });
        lines.push(filled.collect::<Vec<_>>().join(";"));
        assert_eq!(products("stock.csv", &lines.join("\n")), 1);
    }
}

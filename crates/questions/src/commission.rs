//! The commissioning of a code: its values in the form of a drive, and a record of measured values.

use crate::answer::cited_once;
use crate::eds;
use answers::CitedErratum;
use installation::commission as room;
use installation::commission::cia402::{self, Object};
use installation::commission::sinamics::{self, Setting};
use order_code::FeedbackKind;
use quantities::unit::DEGREE_CELSIUS;
use quantities::{Language, Measure, ThermodynamicTemperature, identified};
use std::fmt::Write as _;
use words::{ERRATUM_MARK, commission, conversion_text, gap_text, measured_key_text, object_name, parameter_name};

pub use axis::measured;
pub use room::recorded::judge;
pub use room::{Commissioning, commission};

identified! {
    /// Form of a list of values.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum DriveForm {
        /// The parameter list of a SINAMICS drive.
        Sinamics = "sinamics",
        /// The objects of CiA 402.
        Cia402 = "cia402",
        /// The neutral list.
        Plain = "plain",
    }
}

/// Returns errata for a file that a program reads, each by its id, with which `antrieb errata` finds it again.
fn named_errata(errata: &[CitedErratum]) -> Vec<String> {
    errata.iter().map(|each| format!("{ERRATUM_MARK} {}: {}", each.id, each.evidence)).collect()
}

/// Returns the default temperature of winding and sensors for measurements: that of the resistance in the manual.
#[must_use]
pub fn usual_ambient() -> ThermodynamicTemperature {
    ThermodynamicTemperature::new_in(20.0, &DEGREE_CELSIUS)
}

/// Returns the parameters of a SINAMICS drive, one per line: `p0350[0] = 2.95`, with the meaning of each after a
/// semicolon.
///
/// The numbers read back as the same value: phase values are half of those between terminals, in the unit of the
/// parameter. Unknown data follow as remarks, one per line.
#[must_use]
pub fn sinamics_script(about: &Commissioning, language: Language) -> String {
    let mut out = String::new();
    let remark = |out: &mut String, text: &str| {
        let _ = writeln!(out, "; {text}");
    };
    remark(&mut out, &commission::script_purpose(&about.code, language));
    remark(&mut out, commission::script_use(language));
    remark(&mut out, commission::script_identify(language));
    out.push('\n');
    let mut doubts: Vec<&'static str> = Vec::new();
    for line in sinamics::lines(about) {
        let number = format!("{} = {}", line.entry.name(), line.value);
        let mut errata: &[&'static str] = &[];
        let comment = match line.entry.setting {
            Setting::Value(id, unit) => {
                errata = about.get(id).map_or(&[], |known| &known.errata);
                let unit = if unit.json == "1" { String::new() } else { format!("{}  ", unit.json) };
                format!("{unit}{}; {}", parameter_name(id, language), conversion_text(id.conversion(), language))
            }
            Setting::Choice(choice) => words::choice_text(choice, language).to_owned(),
        };
        let mark = if errata.is_empty() { String::new() } else { format!("; {ERRATUM_MARK} {}", errata.join(", ")) };
        let _ = writeln!(out, "{number:<28} ; {comment}{mark}");
        doubts.extend(errata);
    }
    out.push('\n');
    for line in named_errata(&cited_once(doubts, language)) {
        remark(&mut out, &line);
    }
    remark(&mut out, commission::script_missing(language));
    if about.feedback_kind() != Some(FeedbackKind::EndatMultiturn) {
        remark(&mut out, commission::encoder_configuration(language));
    }
    for gap in about.gaps.iter().filter(|gap| **gap != room::Gap::OwnObjects) {
        remark(&mut out, &gap_text(*gap, language));
    }
    out
}

/// Returns the objects of CiA 402 in the layout of an electronic data sheet (CiA 306): a section for each object and
/// sub-object.
///
/// The sheet has no date, so that the same call gives the same bytes, and no identity of a device, which is that of the
/// drive.
///
/// # Source
/// cia-306
#[must_use]
pub fn eds(about: &Commissioning, language: Language) -> String {
    let objects = cia402::objects(about);
    let mut out = format!("; {}: {}\n", about.code, commission::eds_not_the_drive(language));
    eds::file_info(&mut out, &about.code.to_string(), commission::eds_description(language));
    let _ = writeln!(out, "[DeviceInfo]\nProductName={}\nOrderCode={}", about.code, about.code);
    eds::list(&mut out, "MandatoryObjects", &eds::MANDATORY);
    let mut indices: Vec<u16> = objects.iter().map(|object| object.index).collect();
    indices.dedup();
    eds::list(&mut out, "OptionalObjects", &indices);
    eds::list(&mut out, "ManufacturerObjects", &[]);
    mandatory(&mut out, language);
    for index in indices {
        let of_index: Vec<&Object> = objects.iter().filter(|object| object.index == index).collect();
        match of_index.as_slice() {
            [only] if only.sub == 0 => object_section(&mut out, &format!("{index:04X}"), only, language),
            several => {
                let name = several.first().map_or("", |object| group_name(object, language));
                let last = several.last().map_or(0, |object| object.sub);
                eds::group(&mut out, index, name, 8, several.len() + 1);
                eds::highest(&mut out, index, last, language);
                for object in several {
                    object_section(&mut out, &format!("{index:04X}sub{:X}", object.sub), object, language);
                }
            }
        }
    }
    out
}

/// Writes the objects that every device of CiA 301 has, with the types of the standard; their values are those of the
/// drive.
///
/// # Source
/// cia-306
fn mandatory(out: &mut String, language: Language) {
    let (unsigned_8, unsigned_32) = (cia402::DataType::Unsigned8.number(), cia402::DataType::Unsigned32.number());
    let variable = |out: &mut String, head: &str, name: &str, data_type: u16| {
        let object = eds::Variable { name, data_type, access: "ro", usual: None, range: None, mappable: false };
        eds::variable(out, head, &object);
    };
    variable(out, "1000", commission::object_device_type(language), unsigned_32);
    variable(out, "1001", commission::object_error_register(language), unsigned_8);
    eds::group(out, 0x1018, commission::object_identity(language), 9, 2);
    eds::highest(out, 0x1018, 1, language);
    variable(out, "1018sub1", commission::object_vendor(language), unsigned_32);
}

fn group_name(object: &Object, language: Language) -> &'static str {
    use cia402::ObjectId::{EncoderIncrements, EncoderRevolutions, GearMotorRevolutions, GearShaftRevolutions};
    match object.id {
        EncoderIncrements | EncoderRevolutions => commission::object_encoder(language),
        GearMotorRevolutions | GearShaftRevolutions => commission::object_gear(language),
        other => object_name(other, language),
    }
}

fn object_section(out: &mut String, head: &str, object: &Object, language: Language) {
    let variable = eds::Variable {
        name: object_name(object.id, language),
        data_type: object.data_type.number(),
        access: "rw",
        usual: Some(object.value.to_string()),
        range: None,
        mappable: false,
    };
    eds::variable(out, head, &variable);
    for line in named_errata(&cited_once(object.errata(), language)) {
        eds::remark(out, &line);
    }
}

/// Returns an empty record to fill in, with a remark on each key; brake, KTY and PTC only if the code has them.
#[must_use]
pub fn blank_record(about: &Commissioning, file: &str, language: Language) -> String {
    use project::MeasuredKey as K;
    use project::names::{MeasuredRootName, SensorName};
    let mut out = format!("# {}\n", commission::blank_purpose(&about.code, language));
    let _ = writeln!(
        out,
        "# {}\nformat = {}",
        commission::blank_use(&about.code, &file, language),
        project::MEASURED_FORMAT
    );
    let of_brake = |key| matches!(key, K::Root(MeasuredRootName::brake) | K::Brake(_));
    let of_ptc = |key| key == K::Sensor(SensorName::ptc);
    let of_kty = |key| key == K::Sensor(SensorName::kty);
    for line in project::measured_lines() {
        let absent = (!about.has_brake() && of_brake(line.key))
            || (!about.has_ptc() && of_ptc(line.key))
            || (!about.has_kty() && of_kty(line.key));
        if absent || line.key == K::Root(MeasuredRootName::format) {
            continue;
        }
        let comment = measured_key_text(line.key, language);
        let needed = if line.required { format!(" ({})", commission::needed(language)) } else { String::new() };
        if line.is_table {
            let _ = writeln!(out, "\n# {comment}\n#{}", line.text);
        } else {
            let _ = writeln!(out, "#{:<32} # {comment}{needed}", line.text);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(code: &str) -> Commissioning {
        commission(&order_code::parse(code).unwrap().code).unwrap()
    }

    /// Returns the parameter numbers with the values that a drive reads; it skips remarks.
    fn read(script: &str) -> Vec<(u16, f64)> {
        let line = |line: &str| {
            let (head, _) = line.split_once(';').unwrap_or((line, ""));
            let (number, value) = head.split_once('=')?;
            let number = number.trim().strip_prefix('p')?.strip_suffix("[0]")?.parse().ok()?;
            Some((number, value.trim().parse().ok()?))
        };
        script.lines().filter_map(line).collect()
    }

    #[test]
    fn the_script_reads_back_as_the_lines_in_either_language() {
        for (code, _) in crate::codes::list_codes(None) {
            let Some(about) = commission(code) else { continue };
            let lines: Vec<(u16, f64)> =
                sinamics::lines(&about).iter().map(|line| (line.entry.number, line.value)).collect();
            assert!(lines.len() >= 15, "{code}");
            for language in Language::ALL {
                assert_eq!(read(&sinamics_script(&about, language)), lines, "{code}");
            }
        }
    }

    /// Reads an INI file like any tool: sections with keys.
    #[test]
    fn the_data_sheet_has_a_section_for_each_object_and_its_value_reads_back() {
        let about = of("CHA-25A-100-H-M512P-B");
        let text = eds(&about, Language::En);
        let mut sections: Vec<(String, Vec<(String, String)>)> = Vec::new();
        for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with(';')) {
            match line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
                Some(name) => sections.push((name.to_owned(), Vec::new())),
                None => {
                    let (key, value) = line.split_once('=').unwrap();
                    sections.last_mut().unwrap().1.push((key.to_owned(), value.to_owned()));
                }
            }
        }
        let get = |section: &str, key: &str| {
            let (_, keys) = sections.iter().find(|(name, _)| name == section).unwrap_or_else(|| panic!("{section}"));
            keys.iter().find(|(name, _)| name == key).map(|(_, value)| value.clone())
        };
        for object in cia402::objects(&about) {
            let plain = format!("{:04X}", object.index);
            let section = if object.sub == 0 { plain } else { format!("{plain}sub{}", object.sub) };
            assert_eq!(get(&section, "DefaultValue"), Some(object.value.to_string()));
            assert_eq!(get(&section, "DataType"), Some(format!("0x{:04X}", object.data_type.number())));
        }
        assert_eq!(get("OptionalObjects", "SupportedObjects").as_deref(), Some("8"));
        assert_eq!(get("MandatoryObjects", "SupportedObjects").as_deref(), Some("3"));
        // The types are those of CiA 301; the values are those of the drive, and none is invented.
        for (section, data_type) in [("1000", "0x0007"), ("1001", "0x0005"), ("1018sub1", "0x0007")] {
            assert_eq!(get(section, "DataType").as_deref(), Some(data_type), "{section}");
            assert_eq!(get(section, "DefaultValue"), None, "{section}");
        }
        assert_eq!(get("607E", "DefaultValue").as_deref(), Some("192"));
        assert_eq!(get("608Fsub0", "DefaultValue").as_deref(), Some("2"));
    }

    #[test]
    fn an_empty_record_is_one_that_can_be_read_and_filled_in() {
        for code in ["CHA-25A-100-H-M512P-B", "CHA-14A-50-E-M128S"] {
            let about = of(code);
            for language in Language::ALL {
                let blank = blank_record(&about, "values.toml", language);
                assert_eq!(measured(&blank).unwrap(), Default::default());
                let filled = blank.replace("\n#", "\n").replace("\n ", "\n# ");
                let found = measured(&filled).unwrap_or_else(|faults| panic!("{filled}\n{faults:?}"));
                assert!(found.resistance_ll.is_some() && !found.no_load.is_empty());
                assert_eq!(found.brake_voltage.is_some(), about.has_brake());
                assert_eq!(found.ptc.is_some(), about.has_ptc());
            }
        }
    }
}

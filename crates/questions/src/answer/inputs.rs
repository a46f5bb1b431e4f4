//! The inputs of the project in the words of a language, and the mechanism that they describe.

use super::chapters::inertia;
use answers::{InputTable, Mechanism, Number, Sketch, SketchSymbol};
use axis::AxisProject;
use mechanism::MechanismId;
use mechanism::drawing::CallOut;
use project::{BODY_SHAPES, Input, input_label};
use quantities::unit::MILLIMETRE;
use quantities::{Language, Unit};
use std::f64::consts::TAU;
use words::{body_key, capitalised, key_word, schema_text, shape_title, short_label, table_of_project, unpadded};

/// Returns the values of one axis of a project file, with keys as in a file with this axis alone.
pub(super) fn inputs_of_axis(text: &str, place: usize) -> Vec<Input> {
    let own = format!("axis[{}].", place + 1);
    let of_axis = |input: Input| {
        let path = match input.path.strip_prefix(own.as_str()) {
            None if input.path.starts_with("axis[") || input.path == "format" => return None,
            Some("name") => "axis.name".to_owned(),
            inside => inside.unwrap_or(&input.path).to_owned(),
        };
        Some(Input { path, ..input })
    };
    project::inputs(text).into_iter().filter_map(of_axis).collect()
}

/// Returns the values by table, as text.
pub(super) fn tables(inputs: &[Input], language: Language) -> Vec<InputTable> {
    let mut tables: Vec<InputTable> = Vec::new();
    for input in inputs {
        let (table, name) = input.path.rsplit_once('.').unwrap_or(("", &input.path));
        // A body in a table of its own is one line of the mechanism, like a body written in a line.
        let body = table.rsplit_once(".body[");
        let table = body.map_or(table, |(outer, _)| outer);
        let place = tables.iter().position(|known| known.key == table).unwrap_or_else(|| {
            tables.push(InputTable {
                key: table.to_owned(),
                title: table_title(table, language),
                of_mechanism: table.starts_with("mechanism.") || table == "load",
                values: Vec::new(),
            });
            tables.len() - 1
        });
        let Some(table) = tables.get_mut(place) else { continue };
        if let Some((_, number)) = body {
            body_part(&mut table.values, &format!("bodies[{number}"), (input, name), language);
            continue;
        }
        // `points[2][1]`: the values of a row form one line.
        let row = name.rfind("][").map(|end| &name[..=end]);
        let value = value(input, row.unwrap_or(name), language);
        match table.values.last_mut().filter(|last| row.is_some_and(|row| last.name == row)) {
            Some(last) => last.text = format!("{}; {}", last.text, value.text),
            None => table.values.push(value),
        }
    }
    tables
}

/// Returns a value of the project for a reader without the file: table and purpose of its key, and the value as text.
#[must_use]
pub fn input_words(input: &Input, language: Language) -> [String; 2] {
    let own = input.path.strip_prefix("axis[").and_then(|rest| rest.split_once("].")).map(|(_, inside)| inside);
    let path = own.unwrap_or(&input.path);
    let (table, name) = path.rsplit_once('.').unwrap_or(("", path));
    let value = value(&Input { path: path.to_owned(), ..input.clone() }, name, language);
    // `points[2][1]`: the purpose of the list, and the place in it.
    let (list, place) = path.split_at(path.find('[').filter(|at| *at > table.len()).unwrap_or(path.len()));
    let purpose = match (value.label.as_str(), label(list, language)) {
        ("", Some(list)) => format!("{} {}", short_label(&list), place.replace("][", ", ").replace(['[', ']'], "")),
        ("", None) => body_key(name, language).unwrap_or(name).to_owned(),
        (label, _) => label.to_owned(),
    };
    let title = table_title(table, language);
    [if table.is_empty() { purpose } else { format!("{title}: {purpose}") }, value.text]
}

/// Adds a key of a body to the line of the body: the shape, or the quantity with its value.
fn body_part(values: &mut Vec<answers::Input>, line: &str, (input, name): (&Input, &str), language: Language) {
    let value = value(input, line, language);
    let text = match (name, value.tolerance) {
        ("shape", _) => body(&input.written, language),
        (_, None) => format!("{} {}", body_key(name, language).unwrap_or(name), value.text),
        (_, Some(band)) => format!("{} {} {band}", body_key(name, language).unwrap_or(name), value.text),
    };
    match values.iter_mut().find(|known| known.name == line) {
        Some(known) => known.text = format!("{}, {text}", known.text),
        None => values.push(answers::Input { name: line.to_owned(), label: String::new(), text, tolerance: None }),
    }
}

fn value(input: &Input, name: &str, language: Language) -> answers::Input {
    let short = |value: f64| unpadded(value, 4, language);
    let half = input.half_width.zip(input.amount);
    let label = label(&input.path, language).map(|label| short_label(&label)).unwrap_or_default();
    answers::Input {
        name: name.to_owned(),
        label,
        tolerance: half.map(|(half, (_, unit))| format!("± {}", with_unit(&short(half), half_unit(unit), language))),
        text: input.amount.map_or_else(
            || written(&input.path, &input.written, language),
            |(value, unit)| with_unit(&format!("{value}"), unit.symbol_in(language), language),
        ),
    }
}

/// Returns the description of a key.
fn label(path: &str, language: Language) -> Option<String> {
    input_label(path).map(|text| schema_text(text, language))
}

/// Returns the unit of a difference: kelvin for temperatures.
fn half_unit(unit: &'static Unit) -> &'static str {
    if unit.symbol == "°C" { "K" } else { unit.symbol }
}

/// Formats a number with all its digits and its unit, in the format of the language.
fn with_unit(digits: &str, unit: &str, language: Language) -> String {
    let digits = digits.replace('.', language.decimal_mark().encode_utf8(&mut [0; 4])).replace('-', "−");
    match unit {
        "" | "1" => digits,
        "°" => format!("{digits}°"),
        unit => format!("{digits} {unit}"),
    }
}

/// Formats an entry of a list: a number or a quantity in the format of the language, a word as it is.
fn list_item(item: &str, language: Language) -> String {
    let (digits, unit) = item.split_once(' ').unwrap_or((item, ""));
    match digits.parse::<f64>() {
        Ok(_) => with_unit(digits, Unit::of(unit).map_or(unit, |known| known.symbol_in(language)), language),
        Err(_) => item.to_owned(),
    }
}

/// Formats a value that is no quantity: words of a fixed set in the language, lists without brackets.
fn written(path: &str, text: &str, language: Language) -> String {
    if path.contains(".bodies[") {
        return body(text, language);
    }
    let name = path.rsplit('.').next().unwrap_or(path);
    let list = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    if let Some(list) = list {
        let items = list.split(',').map(|item| item.trim().trim_matches(['"', '\'']).trim());
        let items: Vec<String> = items.filter(|item| !item.is_empty()).map(|item| list_item(item, language)).collect();
        return items.join(if items.iter().any(|item| item.contains(',')) { "; " } else { ", " });
    }
    if let Some(word) = key_word(name, text, language) {
        return word.into_owned();
    }
    match text.parse::<f64>() {
        Ok(_) => with_unit(text, "", language),
        Err(_) => text.to_owned(),
    }
}

/// Formats a body as text: `disc diameter=420mm` becomes “disc, diameter 420 mm”.
fn body(text: &str, language: Language) -> String {
    let parts = text.split_whitespace().map(|part| match part.split_once('=') {
        None => BODY_SHAPES
            .iter()
            .find(|shape| shape.name == part)
            .map_or(part, |shape| shape_title(shape, language))
            .into(),
        Some((key, value)) => {
            let key = body_key(key, language).unwrap_or(key);
            let end = value.find(|sign: char| !matches!(sign, '0'..='9' | '.' | '-')).unwrap_or(value.len());
            let (digits, unit) = value.split_at(end);
            let value = match (Unit::of(unit), digits.is_empty()) {
                (Some(unit), false) => with_unit(digits, unit.symbol_in(language), language),
                (None, false) if unit.is_empty() => with_unit(digits, "", language),
                _ => value.to_owned(),
            };
            format!("{key} {value}")
        }
    });
    parts.collect::<Vec<String>>().join(", ")
}

/// Returns the title of a table of the project file.
fn table_title(table: &str, language: Language) -> String {
    let parts = table.split('.').filter(|part| *part != "mechanism").map(|part| {
        let number = part.split_once('[').map_or("", |(_, rest)| rest.trim_end_matches(']'));
        let of_segment = part == "bearing" && table != part;
        let name = if of_segment { "motion.bearing" } else { part.split('[').next().unwrap_or(part) };
        let known = table_of_project(name, language).map(str::to_owned);
        let known = known.or_else(|| label(&format!("mechanism.{part}"), language).map(|label| capitalised(&label)));
        let words = known.unwrap_or_else(|| part.to_owned());
        if number.is_empty() { words } else { format!("{words} {number}") }
    });
    parts.collect::<Vec<String>>().join(", ")
}

/// Returns the mechanism driven by the output flange.
pub(super) fn mechanism(project: &AxisProject, inputs: &[Input], language: Language) -> Mechanism {
    let load = &project.axis.mechanism;
    let key = load.id().key();
    let table = if load.id() == MechanismId::Load { key.to_owned() } else { format!("mechanism.{key}") };
    // `body` and `bodies` are alternatives.
    let is_stated = |key: &str| {
        let named = |name: &str| {
            name.split(['.', '[']).next().is_some_and(|name| name == key || name == "body" && key == "bodies")
        };
        let inside = |path: &str| path.strip_prefix(&table).and_then(|rest| rest.strip_prefix('.')).is_some_and(named);
        inputs.iter().any(|input| inside(&input.path))
    };
    let values = inputs.iter().map(|input| (input.path.as_str(), input.written.as_str()));
    let drawing = load.id().drawing(&axis::drawn_figures(values, &table));
    let is_shown = |it: &CallOut| it.is_of_bearing || is_stated(it.key);
    // A word, such as the shape of an arm, is no quantity with a symbol.
    let is_word = |it: &CallOut| {
        let own = inputs.iter().find(|input| input.path == format!("{table}.{}", it.key));
        own.is_some_and(|input| input.amount.is_none() && input.written.parse::<f64>().is_err())
    };
    let symbols = drawing.call_outs.iter().filter(|it| is_shown(it) && !is_word(it));
    let symbols = symbols.map(|it| SketchSymbol { key: it.key.to_owned(), symbol: it.symbol.to_owned() });
    Mechanism {
        kind: key.to_owned(),
        title: table_title(&table, language),
        sketch: Sketch {
            symbols: symbols.collect(),
            is_upright: drawing.size[1] > drawing.size[0],
            svg: drawing.picture(is_shown),
        },
        travel_mm_per_rev: load.travel_m_per_rad().map(|travel| Number::in_unit(travel * TAU, &MILLIMETRE)),
        own_travel_mm_per_rev: load
            .travel_m_per_rad()
            .map(|travel| Number::in_unit(travel * load.stage_ratio() * TAU, &MILLIMETRE)),
        bodies: project.bodies().map(|answer| inertia(&answer)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use project::{KEYS, Key};

    /// Adds the paths of the tables below some keys.
    fn tables_below(keys: &[Key], prefix: &str, found: &mut Vec<String>) {
        for key in keys {
            let path = if prefix.is_empty() { key.name.to_owned() } else { format!("{prefix}.{}", key.name) };
            let below = [key.kind.keys(false), key.kind.keys(true)];
            if below.iter().any(|below| !below.is_empty()) {
                found.push(path.clone());
                below.iter().for_each(|below| tables_below(below, &path, found));
            }
        }
    }

    /// A table has a title in words, not the name of its key.
    #[test]
    fn every_table_of_a_project_has_a_title_in_words() {
        let mut found = Vec::new();
        tables_below(KEYS, "", &mut found);
        assert!(found.len() > 20, "{found:?}");
        found.retain(|path| !path.ends_with("mechanism"));
        let wrong = found.iter().filter_map(|path| {
            let [en, de] = [Language::En, Language::De].map(|language| table_title(path, language));
            let name = path.rsplit('.').next().unwrap_or_default();
            (de.ends_with(name) || en == de || en.contains('_')).then_some((path, en, de))
        });
        let wrong: Vec<_> = wrong.collect();
        assert!(wrong.is_empty(), "{wrong:#?}");
    }

    #[test]
    fn inputs_are_reported_in_the_words_of_the_language() {
        let text = "format = 1\n[axis]\nname = \"x\"\n[mechanism.turntable]\n\
            bodies = [\"disc diameter=420mm length=12mm density=2700kg/m^3\", \"point mass=1.5kg distance=0.5m count=2\"]\n\
            [[motion]]\nlaw = \"dwell\"\ntime = \"1.5 s ± 10 %\"\nhold = \"motor\"\n\
            [requirements]\nbrake = true\nfeedback = [\"C1024\", \"M512P\"]\nambient = \"-5 degC ± 5 K\"\n";
        let found = tables(&inputs_of_axis(text, 0), Language::De);
        let lines: Vec<String> = found
            .iter()
            .flat_map(|table| {
                let line = |value: &answers::Input| {
                    let tolerance = value.tolerance.as_ref().map(|text| format!(" {text}")).unwrap_or_default();
                    format!("{}|{}|{}{tolerance}", table.title, value.name, value.text)
                };
                table.values.iter().map(line).collect::<Vec<_>>()
            })
            .collect();
        assert_eq!(
            lines,
            [
                "Achse|name|x",
                "Drehtisch oder Trommel aus Vollkörpern|bodies[1]|Scheibe, Durchmesser 420 mm, Länge 12 mm, Dichte 2700 kg/m³",
                "Drehtisch oder Trommel aus Vollkörpern|bodies[2]|Punktmasse, Masse 1,5 kg, Abstand 0,5 m, Anzahl 2",
                "Bewegung, Abschnitt 1|law|Rast",
                "Bewegung, Abschnitt 1|time|1,5 s ± 0,15 s",
                "Bewegung, Abschnitt 1|hold|durch den Motor",
                "Anforderungen|brake|gefordert",
                "Anforderungen|feedback|C1024, M512P",
                "Anforderungen|ambient|−5 °C ± 5 K",
            ]
        );
        let labels: Vec<&str> =
            found.iter().flat_map(|table| &table.values).map(|value| value.label.as_str()).collect();
        assert!(labels.iter().all(|label| !label.contains([';', '('])), "{labels:?}");
    }

    #[test]
    fn a_body_in_a_table_of_its_own_reads_as_one_in_a_line() {
        let text = "format = 1\n[mechanism.turntable]\nfriction_torque = \"2 N m\"\n[[mechanism.turntable.body]]\n\
            shape = \"disc\"\ndiameter = \"420 mm ± 1 mm\"\nlength = \"12 mm\"\ndensity = \"2700 kg/m^3\"\n\
            [[mechanism.turntable.body]]\nshape = \"point\"\nmass = \"1.5 kg\"\ncount = 2\n";
        let found = tables(&inputs_of_axis(text, 0), Language::De);
        let lines: Vec<(&str, &str)> =
            found.iter().flat_map(|table| &table.values).map(|each| (each.name.as_str(), each.text.as_str())).collect();
        assert_eq!(
            lines[1..],
            [
                ("bodies[1]", "Scheibe, Durchmesser 420 mm ± 1 mm, Länge 12 mm, Dichte 2700 kg/m³"),
                ("bodies[2]", "Punktmasse, Masse 1,5 kg, Anzahl 2"),
            ]
        );
        assert!(found.iter().all(|table| !table.key.contains("body")), "{found:?}");
    }

    #[test]
    fn values_of_a_row_stand_on_one_line() {
        let text = "format = 1\n[[axis]]\nname = \"a\"\n[[axis]]\nname = \"b\"\n[axis.mechanism.table]\n\
            points = [[\"0 deg\", \"1 kg m^2\", \"2 N m\"], [\"90 deg\", \"1.5 kg m^2\", \"0 N m\"]]\n";
        let found = tables(&inputs_of_axis(text, 1), Language::En);
        let rows: Vec<(&str, &str)> =
            found.iter().flat_map(|table| &table.values).map(|each| (each.name.as_str(), each.text.as_str())).collect();
        let points = [("points[1]", "0°; 1 kgm²; 2 Nm"), ("points[2]", "90°; 1.5 kgm²; 0 Nm")];
        assert_eq!(rows, [("name", "b"), points[0], points[1]]);
    }

    /// Numbers and quantities of a list have the decimal mark of the language, and a separator that differs from it.
    #[test]
    fn lists_of_numbers_are_written_in_the_language() {
        for (list, english, german) in [
            ("[1.5, 2, 0.25]", "1.5, 2, 0.25", "1,5; 2; 0,25"),
            ("[2, 3]", "2, 3", "2, 3"),
            ("[\"0.5 kg\", '-1.25 kg']", "0.5 kg, \u{2212}1.25 kg", "0,5 kg; \u{2212}1,25 kg"),
            ("['C1024', \"M512P\",]", "C1024, M512P", "C1024, M512P"),
            ("[]", "", ""),
        ] {
            let of = |language| written("stage.ratios", list, language);
            assert_eq!([of(Language::En), of(Language::De)], [english, german], "{list}");
        }
    }
}

//! `data` and `catalogue export`.

use crate::answer::Answer;
use crate::code::{parse_for_use, read_argument};
use crate::fault::error_word;
use crate::subject::refuse;
use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::quantities::unit::{ARCMINUTE, KILONEWTON_METRE_PER_RADIAN, NEWTON_METRE};
use workbench::quantities::{Measure, Unit, format_significant};
use workbench::text::{condition_text, evidence_text, symbol_term};
use workbench::{EXPORT_COLUMNS, Language, Sheet, export_rows, json};

/// `antrieb data CODE`
pub(crate) fn sheet(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let (reading, talk) = match parse_for_use(&read_argument(matches), as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let Some(sheet) = workbench::sheet(&reading.parsed.code) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    let data = if as_json { format!("{:#}\n", json::sheet(&sheet, language)) } else { sheet_text(&sheet, language) };
    Answer { data, talk, code: 0 }
}

fn sheet_text(sheet: &Sheet, language: Language) -> String {
    let mut out = format!("{}\n", sheet.code);
    let mut errata: Vec<&'static str> = Vec::new();
    for section in &sheet.sections {
        let (title, word) = match language {
            Language::En => (section.table.title_en, "table"),
            Language::De => (section.table.title_de, "Tabelle"),
        };
        let _ = writeln!(out, "\n{title} ({word} {})", section.table.id);
        let (symbol, value, unit, name) = match language {
            Language::En => ("symbol", "value", "unit", "name"),
            Language::De => ("Symbol", "Wert", "Einheit", "Benennung"),
        };
        let mut table =
            Table::new([(symbol, Align::Left), (value, Align::Left), (unit, Align::Left), (name, Align::Left)]);
        for row in &section.rows {
            let cell = row.cell;
            let mut name = symbol_term(cell.place.symbol, language);
            if !cell.place.condition.is_empty() {
                let _ = write!(name, " ({})", condition_text(cell.place.condition, language));
            }
            let mut value = decimal(cell.corrected, language);
            if cell.corrected != cell.printed {
                let printed = decimal(cell.printed, language);
                let _ = match language {
                    Language::En => write!(value, " (in print {printed})"),
                    Language::De => write!(value, " (im Druck {printed})"),
                };
            }
            if !cell.errata.is_empty() {
                value.push_str(" *");
                errata.extend(cell.errata.iter().filter(|id| !errata.contains(id)).copied().collect::<Vec<_>>());
            }
            let unit = Unit::of(cell.unit).map_or(cell.unit, |unit| unit.symbol);
            table.row([cell.place.symbol.to_owned(), value, unit.to_owned(), name]);
        }
        out.push_str(&table.render());
    }
    if !errata.is_empty() {
        out.push('\n');
    }
    for id in errata {
        out.push_str(&paragraph(&format!("* {id}: "), evidence_text(id, language)));
    }
    out
}

/// Printed numbers have a decimal comma; English readers get a point. Texts stay as they are.
fn decimal(text: &str, language: Language) -> String {
    let numeric = text.chars().all(|c| c.is_ascii_digit() || " ,.<>≤≥±%-".contains(c));
    if language == Language::En && numeric { text.replace(',', ".") } else { text.to_owned() }
}

/// `antrieb torsion CODE --torque "60 N m"`
pub(crate) fn torsion(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let (reading, talk) = match parse_for_use(&read_argument(matches), as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let text = matches.get_one::<String>("torque").map_or("", String::as_str);
    let torque = match workbench::read_torque(text, language) {
        Ok(torque) => torque,
        Err((message, hint)) => {
            let hint = hint.map(|hint| format!("  {hint}\n")).unwrap_or_default();
            let mut answer = Answer::fault(format!("{}: --torque: {message}\n{hint}", error_word(language)));
            if as_json {
                answer.data = format!("{:#}\n", serde_json::json!({ "errors": [{ "message": message }] }));
            }
            return answer;
        }
    };
    let Some(answer) = workbench::torsion(&reading.parsed.code, torque) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    if as_json {
        let value = json::torsion(&reading.parsed.code, &answer);
        return Answer { data: format!("{value:#}\n"), talk, code: 0 };
    }
    let number = |value: f64, digits| format_significant(value, digits, language);
    let [k1, k2, k3] = answer.curve.stiffness.map(|k| number(k.in_unit(&KILONEWTON_METRE_PER_RADIAN), 3));
    let (torque, angle) = (number(torque.in_unit(&NEWTON_METRE), 4), number(answer.angle.in_unit(&ARCMINUTE), 3));
    let radian = number(answer.angle.si() * 1e3, 3);
    let (t1, t2) = (number(answer.curve.torque_1.si(), 3), number(answer.curve.torque_2.si(), 3));
    let table = if reading.parsed.code.size.number() >= 32 { "54.4" } else { "54.3" };
    let data = match language {
        Language::En => format!(
            "{}: {angle} arcmin ({radian} mrad) under {torque} Nm, stiffness region {}\n\
             T_1 {t1} Nm, T_2 {t2} Nm, K_1 {k1}, K_2 {k2}, K_3 {k3} kNm/rad (table {table}); mean values, blocked motor\n",
            reading.parsed.code, answer.region
        ),
        Language::De => format!(
            "{}: {angle} arcmin ({radian} mrad) unter {torque} Nm, Steifigkeitsbereich {}\n\
             T_1 {t1} Nm, T_2 {t2} Nm, K_1 {k1}, K_2 {k2}, K_3 {k3} kNm/rad (Tabelle {table}); Mittelwerte, Motor blockiert\n",
            reading.parsed.code, answer.region
        ),
    };
    Answer { data, talk, code: 0 }
}

/// `antrieb catalogue export`
pub(crate) fn catalogue(matches: &ArgMatches, as_json: bool) -> Answer {
    let Some(("export", found)) = matches.subcommand() else { return Answer::none() };
    let json_wanted = as_json || found.get_one::<String>("format").is_some_and(|format| format == "json");
    if json_wanted {
        return Answer::data(format!("{:#}\n", json::export()));
    }
    let mut out = EXPORT_COLUMNS.join(",");
    out.push('\n');
    for (_, row) in export_rows() {
        let fields: Vec<String> = row.iter().map(|field| quoted(field)).collect();
        out.push_str(&fields.join(","));
        out.push('\n');
    }
    Answer::data(out)
}

/// A CSV field (RFC 4180): quoted where it holds a comma, a quote or a line break.
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

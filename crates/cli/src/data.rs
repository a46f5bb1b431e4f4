//! `data` and `catalogue export`.

use crate::answer::Answer;
use crate::code::{parse_for_use, read_argument};
use crate::fault::option_fault;
use crate::subject::refuse;
use crate::table::{Align, Table, labelled, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::answer::sheet_note_text;
use workbench::quantities::unit::{ARCMINUTE, KILONEWTON_METRE_PER_RADIAN, NEWTON_METRE};
use workbench::quantities::{Measure, Unit, format_significant};
use workbench::text::{
    cell_text, condition_text, decimal, describe_uncovered, evidence_text, symbol_term, table_title, terminal, terms,
};
use workbench::{Language, Sheet, SheetNote, SheetRow, SheetSection, Uncovered};

/// `antrieb data CODE`
pub(crate) fn sheet(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let (reading, talk) = match parse_for_use(&read_argument(matches), as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let Some(sheet) = workbench::sheet(&reading.parsed.code) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    if as_json {
        return Answer { talk, ..Answer::record(&workbench::answer::sheet(&sheet, language)) };
    }
    Answer { talk, ..Answer::data(sheet_text(&sheet, language)) }
}

fn sheet_text(sheet: &Sheet, language: Language) -> String {
    let mut out = format!("{}\n", sheet.code);
    for what in &sheet.uncovered {
        out.push_str(&paragraph(&format!("[{}] antrieb: ", letters(*what)), describe_uncovered(*what, language)));
    }
    let mut errata: Vec<&'static str> = Vec::new();
    for section in &sheet.sections {
        section_text(&mut out, section, &mut errata, language);
    }
    if !errata.is_empty() {
        out.push('\n');
    }
    for id in errata {
        out.push_str(&paragraph(&format!("* {id}: "), evidence_text(id, language)));
    }
    out
}

/// One table with its notes below it; the errata of its cells are gathered for the end of the sheet.
fn section_text(out: &mut String, section: &SheetSection, errata: &mut Vec<&'static str>, language: Language) {
    let title = table_title(section.table, language);
    let _ = writeln!(out, "\n{title} ({} {})", terminal::table(language), section.table.id);
    let heads = [terminal::symbol(language), terms::value(language), terms::unit(language), terminal::name(language)];
    let mut table = Table::new(heads.map(|head| (head, Align::Left)));
    let mut notes: Vec<(String, SheetNote)> = Vec::new();
    for row in &section.rows {
        let cell = row.cell;
        let mut name = symbol_term(cell.place.symbol, language);
        if !cell.place.condition.is_empty() {
            let _ = write!(name, " ({})", condition_text(cell.place.condition, language));
        }
        let mut value = value_text(row, language);
        for note in &row.notes {
            let _ = write!(value, " [{}]", mark_of(&mut notes, *note));
        }
        if !cell.errata.is_empty() {
            value.push_str(" *");
            errata.extend(cell.errata.iter().filter(|id| !errata.contains(id)).copied().collect::<Vec<_>>());
        }
        let unit = Unit::of(cell.unit).map_or(cell.unit, |unit| unit.symbol);
        table.row([cell.place.symbol.to_owned(), value, unit.to_owned(), name]);
    }
    out.push_str(&table.render());
    notes.sort_by(|(one, _), (other, _)| one.cmp(other));
    for (mark, note) in notes {
        out.push_str(&paragraph(&format!("[{mark}] {}", by(&note)), sheet_note_text(&note, language)));
    }
    for note in &section.notices {
        let head = if note.is_ours() { by(note) } else { format!("{}: ", terminal::note(language)) };
        out.push_str(&paragraph(&head, sheet_note_text(note, language)));
    }
    if !section.errata.is_empty() {
        let head = terminal::errata_of_this_table(language);
        let see = terminal::see(language);
        let text = format!("{} ({see} antrieb errata {})", section.errata.join(", "), section.table.id);
        out.push_str(&labelled(head, &text));
    }
}

/// Who says a note, where it is not the manual.
fn by(note: &SheetNote) -> String {
    if note.is_ours() { "antrieb: ".to_owned() } else { String::new() }
}

/// The value after errata, with the print where it differs; a value of the standard only is none of this code.
fn value_text(row: &SheetRow, language: Language) -> String {
    let cell = row.cell;
    let corrected = cell_text(cell, language);
    let value = decimal(corrected, language);
    if row.of_standard_only {
        return terminal::value_of_the_standard(&value, language);
    }
    if cell.corrected == cell.printed {
        return value;
    }
    let printed = decimal(cell.printed, language);
    terminal::value_and_print(&value, &printed, language)
}

/// The token of the code that brings what the tables do not cover.
const fn letters(what: Uncovered) -> &'static str {
    match what {
        Uncovered::LongerWithK => "K",
        Uncovered::SpecialDesign => "SP",
        Uncovered::OutputEncoder => "EC",
    }
}

/// The mark of a note in a table: the printed one, or the next small letter. What the tables do not cover of the code
/// stands at the head of the sheet.
fn mark_of(notes: &mut Vec<(String, SheetNote)>, note: SheetNote) -> String {
    if let SheetNote::Uncovered(what) = note {
        return letters(what).to_owned();
    }
    if let Some((mark, _)) = notes.iter().find(|(_, known)| *known == note) {
        return mark.clone();
    }
    let letters = notes.iter().filter(|(_, known)| known.mark().is_empty()).count();
    let mark = match note.mark() {
        "" => ('a'..='z').nth(letters).unwrap_or('z').to_string(),
        mark => mark.to_owned(),
    };
    notes.push((mark.clone(), note));
    mark
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
            return option_fault("torque", (message, hint), as_json, language);
        }
    };
    let Some(answer) = workbench::torsion(&reading.parsed.code, torque) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    if as_json {
        return Answer { talk, ..Answer::record(&workbench::answer::torsion(&reading.parsed.code, &answer)) };
    }
    let number = |value: f64, digits| format_significant(value, digits, language);
    let [k1, k2, k3] = answer.curve.stiffness.map(|k| number(k.in_unit(&KILONEWTON_METRE_PER_RADIAN), 3));
    let (torque, angle) = (number(torque.in_unit(&NEWTON_METRE), 4), number(answer.angle.in_unit(&ARCMINUTE), 3));
    let radian = number(answer.angle.si() * 1e3, 3);
    let (t1, t2) = (number(answer.curve.torque_1.si(), 3), number(answer.curve.torque_2.si(), 3));
    let table = if reading.parsed.code.size.number() >= 32 { "54.4" } else { "54.3" };
    let data = format!(
        "{}\n",
        terminal::torsion(
            &reading.parsed.code,
            &angle,
            &radian,
            &torque,
            &answer.region,
            &t1,
            &t2,
            &k1,
            &k2,
            &k3,
            &table,
            language
        )
    );
    Answer { talk, ..Answer::data(data) }
}

/// `antrieb catalogue export`
pub(crate) fn catalogue(matches: &ArgMatches, as_json: bool) -> Answer {
    let Some(("export", found)) = matches.subcommand() else { return Answer::none() };
    let json_wanted = as_json || found.get_one::<String>("format").is_some_and(|format| format == "json");
    if json_wanted {
        return Answer::record(&workbench::answer::catalogue_cells());
    }
    Answer::data(workbench::export_csv())
}

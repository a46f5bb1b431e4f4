//! `data` and `catalogue export`.

use crate::answer::Answer;
use crate::code::{parse_for_use, read_argument};
use crate::fault::option_fault;
use crate::subject::refuse;
use crate::table::{Align, Table, labelled, paragraph};
use clap::ArgMatches;
use std::fmt::Write as _;
use workbench::answer::sheet_note_text;
use workbench::quantities::Unit;
use workbench::text::{condition_text, describe_uncovered, evidence_text, symbol_term, table_title, terminal, terms};
use workbench::{Language, Sheet, SheetNote, SheetSection};

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
        out.push_str(&paragraph(
            &format!("[{}] antrieb: ", workbench::uncovered_mark(*what)),
            describe_uncovered(*what, language),
        ));
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
    let mut notes = workbench::SheetMarks::default();
    for row in &section.rows {
        let cell = row.cell;
        let mut name = symbol_term(cell.place.symbol, language);
        if !cell.place.condition.is_empty() {
            let _ = write!(name, " ({})", condition_text(cell.place.condition, language));
        }
        let mut value = workbench::sheet_value_text(row, language);
        for note in &row.notes {
            let _ = write!(value, " [{}]", notes.of(*note));
        }
        if !cell.errata.is_empty() {
            value.push_str(" *");
            errata.extend(cell.errata.iter().filter(|id| !errata.contains(id)).copied().collect::<Vec<_>>());
        }
        let unit = Unit::of(cell.unit).map_or(cell.unit, |unit| unit.symbol);
        table.row([cell.place.symbol.to_owned(), value, unit.to_owned(), name]);
    }
    out.push_str(&table.render());
    for (mark, note) in notes.sorted() {
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

/// `antrieb torsion CODE --torque "60 N m"`
pub(crate) fn torsion(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let (reading, talk) = match parse_for_use(&read_argument(matches), as_json, language) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    let given = |name: &str| matches.get_one::<String>(name).map(String::as_str);
    let twist = match workbench::read_twist(given("torque"), given("angle"), language) {
        Ok(twist) => twist,
        Err((option, fault)) => return option_fault(option, fault, as_json, language),
    };
    let Some(answer) = workbench::torsion(&reading.parsed.code, twist) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    if as_json {
        return Answer { talk, ..Answer::record(&workbench::answer::torsion(&reading.parsed.code, &answer)) };
    }
    let lines = workbench::torsion_lines(&reading.parsed.code, &answer, language);
    Answer { talk, ..Answer::data(lines.into_iter().flat_map(|line| [line, String::from("\n")]).collect()) }
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

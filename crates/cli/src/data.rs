//! `data` and `catalogue export`.

use crate::answer::CommandAnswer;
use crate::call::Call;
use crate::command::own;
use crate::table::{Align, TextTable, labelled, paragraph};
use order_code::OrderCode;
use quantities::{Language, Unit};
use questions::ProductId;
use questions::answer::sheet_note_text;
use questions::list::data::{Sheet, SheetMarks, SheetNote, SheetSection};
use questions::list::{Given, Inquiry, Unanswered, compare, data, torsion};
use std::fmt::Write as _;
use words::{
    condition_text, describe_uncovered, erratum_line, erratum_place_of, row_sign, symbol_term, table_title, terminal,
    terms,
};

/// `antrieb data CODE`
pub(crate) fn sheet(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let language = call.language;
    let further = call.texts(own::BESIDE);
    if further.is_empty() {
        return Ok(CommandAnswer::data(sheet_text(&data::found(inquiry)?, language)));
    }
    if call.as_json {
        return Err(Unanswered::option(own::BESIDE, (terminal::no_record_of_several(language).to_owned(), None)));
    }
    let first = data::Args::read(&inquiry.given)?.code;
    let read = |text: &String| {
        let given = Given::of(data::Args::ARGUMENTS, [("code".into(), text.into())], language)?;
        Ok::<_, Unanswered>(data::Args::read(&given)?.code)
    };
    let further: Vec<OrderCode> = further.iter().map(read).collect::<Result<_, _>>()?;
    let codes: Vec<OrderCode> = std::iter::once(first).chain(further).collect();
    if !compare::COMPARED.contains(&codes.len()) {
        return Err(Unanswered::message(terminal::two_to_five_codes(&codes.len(), language)));
    }
    let ids: Vec<ProductId> = codes.iter().map(ProductId::from).collect();
    let data = compare::data_of(&**inquiry.catalogue, &ids)
        .map_err(|(place, refusal)| Unanswered::Refused(refusal, ids.get(place).cloned()))?;
    Ok(CommandAnswer::data(crate::compare::data_text(&codes, &data, language)))
}

fn sheet_text(sheet: &Sheet, language: Language) -> String {
    let mut out = format!("{}\n", sheet.code);
    for what in &sheet.uncovered {
        out.push_str(&paragraph(
            &format!("[{}] {}: ", questions::texts::uncovered_mark(*what), terminal::not_of_the_manual(language)),
            &describe_uncovered(*what, language),
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
        out.push_str(&paragraph("* ", &erratum_line(id, language)));
    }
    out
}

/// Appends one table with its notes below it; the errata of its cells are collected for the end of the sheet.
fn section_text(out: &mut String, section: &SheetSection, errata: &mut Vec<&'static str>, language: Language) {
    let title = table_title(section.table, language);
    let _ = writeln!(out, "\n{title} ({} {})", terminal::table(language), section.table.id);
    let heads = [terminal::symbol(language), terms::value(language), terms::unit(language), terminal::name(language)];
    let mut table = TextTable::new(heads.map(|head| (head, Align::Left)));
    let mut notes = SheetMarks::default();
    for row in &section.rows {
        let cell = row.cell;
        let mut name = symbol_term(cell.place.symbol, language);
        if !cell.place.condition.is_empty() {
            let _ = write!(name, " ({})", condition_text(cell.place.condition, language));
        }
        let mut value = questions::texts::sheet_value_text(row, language);
        for note in &row.notes {
            let _ = write!(value, " [{}]", notes.of(*note));
        }
        if !cell.errata.is_empty() {
            value.push_str(" *");
            errata.extend(cell.errata.iter().filter(|id| !errata.contains(id)).copied().collect::<Vec<_>>());
        }
        let unit = Unit::of(cell.unit).map_or(cell.unit, |unit| unit.symbol_in(language));
        table.row([row_sign(cell.place.symbol).unwrap_or_default(), value, unit.to_owned(), name]);
    }
    out.push_str(&table.render());
    for (mark, note) in notes.sorted() {
        out.push_str(&paragraph(&format!("[{mark}] {}", by(&note, language)), &sheet_note_text(&note, language)));
    }
    for note in &section.notices {
        let head = if note.is_ours() { by(note, language) } else { format!("{}: ", terminal::note(language)) };
        out.push_str(&paragraph(&head, &sheet_note_text(note, language)));
    }
    if !section.errata.is_empty() {
        let head = terminal::errata_of_this_table(language);
        let see = terminal::see(language);
        let places: Vec<String> = section.errata.iter().map(|id| erratum_place_of(id, language)).collect();
        let text = format!("{} ({see} antrieb errata {})", places.join("; "), section.table.id);
        out.push_str(&labelled(head, &text));
    }
}

/// Returns the author of a note that is not from the manual.
fn by(note: &SheetNote, language: Language) -> String {
    if note.is_ours() { format!("{}: ", terminal::not_of_the_manual(language)) } else { String::new() }
}

/// `antrieb torsion CODE --torque "60 N m"`
pub(crate) fn torsion(call: &Call<'_>, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    let (code, found) = torsion::found(inquiry)?;
    Ok(CommandAnswer::lines(&questions::texts::torsion_lines(&code, &found, call.language)))
}

/// `antrieb catalogue export`
pub(crate) fn catalogue(call: &Call<'_>, _: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
    if call.text("format") == Some("json") {
        return Ok(CommandAnswer::record(&questions::answer::catalogue_cells()));
    }
    Ok(CommandAnswer::data(questions::list::catalogue::export_csv()))
}

//! Reads `data/`, checks it against the rules of `data/README.md`, and embeds it as static tables.
//!
//! A file that violates a rule stops the build, with all faults listed at once.
#![allow(clippy::print_stdout, reason = "a build script speaks to cargo over stdout")]

mod series;

use series_files::{AllCells, Data, ErratumEntry, KEYS, value_of, variant_of};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    println!("cargo::rerun-if-changed={}", root.display());
    let mut faults = Vec::new();
    let data = series_files::read_all(&root, &mut faults);
    let cells = series_files::cells(&data, &mut faults);
    let mut text = String::from("// Generated from data/ by the build script; do not edit.\n");
    records(&mut text, &data, &cells);
    text.push_str(&series_files::facts(&data, &mut faults));
    text.push_str(&series::records(&data.codes));
    series_files::write_out("data.rs", &text, &faults)
}

/// Distinct texts with their numbers.
#[derive(Default)]
struct Numbered {
    kept: Vec<String>,
    numbers: BTreeMap<String, usize>,
}

impl Numbered {
    fn number(&mut self, text: &str) -> usize {
        *self.numbers.entry(text.to_owned()).or_insert_with_key(|text| {
            self.kept.push(text.clone());
            self.kept.len() - 1
        })
    }
}

fn records(out: &mut String, data: &Data, AllCells { cells, ranges }: &AllCells<'_>) {
    let opt = |text: &Option<String>| text.as_deref().unwrap_or("").to_owned();
    let (mut texts, mut errata) = (Numbered::default(), Numbered::default());
    let _ = writeln!(out, "pub(crate) static PACKED: &[Packed] = &[");
    for cell in cells {
        let (document, table) = data.tables.get(cell.table).map_or(("", ""), |t| (t.source.as_str(), t.table.as_str()));
        let of_the_cell: Vec<&str> =
            cell.errata.iter().filter_map(|n| data.errata.get(*n)).map(|erratum| erratum.id.as_str()).collect();
        let limit = cell.checks_use.map_or("None".into(), |text| format!("Some(Value::{:?})", value_of(text)));
        let [drive, feedback, ratio, symbol, condition] = cell.keys.each_ref().map(|key| texts.number(key));
        let _ = writeln!(
            out,
            "Packed {{ document: {}, table: {}, symbol: {symbol}, condition: {condition}, drive: {drive}, ratio: {ratio}, \
             row: {}, column: {}, feedback: {feedback}, unit: {}, printed: {}, corrected: {}, value: Value::{:?}, \
             checks_use: {limit}, errata: {} }},",
            texts.number(document),
            texts.number(table),
            cell.row,
            cell.column,
            texts.number(cell.unit),
            texts.number(cell.printed),
            texts.number(cell.corrected),
            value_of(cell.corrected),
            errata.number(&format!("{of_the_cell:?}")),
        );
    }
    let _ = writeln!(out, "];\npub(crate) static CELL_TEXTS: &[&str] = &{:?};", texts.kept);
    let _ = writeln!(out, "pub(crate) static CELL_ERRATA: &[&[&str]] = &[");
    for list in &errata.kept {
        let _ = writeln!(out, "&{list},");
    }
    let _ = writeln!(out, "];\npub(crate) static TABLES: &[ManualTable] = &[");
    for (number, (table, (first, end))) in data.tables.iter().zip(ranges).enumerate() {
        let notes: Vec<String> = table
            .footnotes
            .iter()
            .map(|note| {
                format!(
                    "Footnote {{ mark: {:?}, symbol: {:?}, ours: {}, en: {:?}, de: {:?} }}",
                    opt(&note.mark),
                    opt(&note.symbol),
                    note.by.is_some(),
                    note.en,
                    note.de
                )
            })
            .collect();
        let row_notes: Vec<String> = table
            .rows
            .iter()
            .enumerate()
            .filter_map(|(index, row)| row.note.as_ref().map(|note| format!("({index}, {note:?})")))
            .collect();
        let _ = writeln!(
            out,
            "ManualTable {{ id: {:?}, section: {:?}, page: {}, title_en: {:?}, title_de: {:?}, source: {:?}, footnotes: &[{}], \
             row_notes: &[{}], number: {number}, first: {first}, end: {end} }},",
            table.table,
            opt(&table.section),
            table.page.unwrap_or(0),
            table.title.en,
            table.title.de,
            table.source,
            notes.join(", "),
            row_notes.join(", "),
        );
    }
    let _ = writeln!(out, "];\npub(crate) static ERRATA: &[Erratum] = &[");
    for erratum in &data.errata {
        let kind = variant_of(&erratum.kind);
        let _ = writeln!(
            out,
            "Erratum {{ id: {:?}, table: {:?}, feedbacks: &{:?}, windings: &{:?}, sizes: &{:?}, place: {:?}, place_de: {:?}, recovered: {:?}, recovered_de: {:?}, printed: {:?}, \
             printed_de: {:?}, corrected: {:?}, corrected_de: {:?}, checks_use: {:?}, \
             kind: ErratumKind::{kind}, corrected_here: {}, evidence: {:?}, evidence_de: {:?} }},",
            erratum.id,
            opt(&erratum.table),
            concerned(erratum, "feedback"),
            concerned(erratum, "winding"),
            concerned(erratum, "size"),
            erratum.place.clone().unwrap_or_else(|| place_of(erratum)),
            erratum.place_de.clone().unwrap_or_else(|| place_of(erratum)),
            erratum.recovered,
            erratum.recovered_de.as_ref().or(erratum.recovered.as_ref()),
            erratum.printed,
            erratum.printed_de.as_ref().unwrap_or(&erratum.printed),
            erratum.corrected,
            erratum.corrected_de.as_ref().unwrap_or(&erratum.corrected),
            erratum.checks_use,
            erratum.status == "corrected",
            erratum.evidence,
            erratum.evidence_de,
        );
    }
    let _ = writeln!(out, "];\npub(crate) static SOURCES: &[SourceDocument] = &[");
    for source in &data.sources {
        let _ = writeln!(out, "{source:?},");
    }
    let _ = writeln!(out, "];\npub(crate) static GLOSSARY: &[Term] = &[");
    for term in &data.glossary {
        let _ = writeln!(out, "{term:?},");
    }
    let _ = writeln!(out, "];\npub(crate) static TEXTS: &[(&str, &str)] = &[");
    for text in &data.texts {
        let _ = writeln!(out, "({:?}, {:?}),", text.printed, text.en);
    }
    let _ = writeln!(out, "];\npub(crate) static WORDS: &[ProductWord] = &[");
    for word in &data.words {
        let _ = writeln!(
            out,
            "ProductWord {{ id: {:?}, en: {:?}, de: {:?}, about_en: {:?}, about_de: {:?}, not_en: &{:?}, not_de: &{:?} }},",
            word.id, word.en, word.de, word.about_en, word.about_de, word.not_en, word.not_de,
        );
    }
    let _ = writeln!(out, "];");
}

/// Returns the words of a field in the codes that an erratum concerns; empty if the field is open.
fn concerned<'e>(erratum: &'e ErratumEntry, field: &str) -> &'e [String] {
    erratum.concerns.get(field).map_or(&[], Vec::as_slice)
}

/// Returns the place of an erratum in words, from the keys of its cell.
fn place_of(erratum: &ErratumEntry) -> String {
    KEYS.iter().filter_map(|key| erratum.cell.get(*key)).cloned().collect::<Vec<_>>().join(", ")
}

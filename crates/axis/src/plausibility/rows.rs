//! Products of a catalogue file as numbers with their places.

use super::finding::{ComparedFigure, PlausibilityFinding};
use super::rules::PlausibilityRuleId;
use crate::catalogue_csv::{self, CsvText, UnitHeading};
use crate::catalogue_files::is_csv;
use project::sections::{ActuatorEntry, CatalogueHead, Fields, Stated, StatedField};
use project::{ReadCatalogue, decoded, read_catalogue};
use std::collections::BTreeMap;

/// A product as numbers.
pub(super) struct Row {
    pub(super) id: String,
    pub(super) maker: String,
    pub(super) series: String,
    /// Place of the name.
    pub(super) line: usize,
    pub(super) column: usize,
    pub(super) values: BTreeMap<&'static str, Number>,
}

/// A value with its place.
#[derive(Clone, Debug)]
pub(super) struct Number {
    pub(super) si: f64,
    /// Value with its unit.
    pub(super) written: String,
    /// Text in the file: a string of TOML, or a cell.
    pub(super) cell: String,
    /// The file is a table, whose heading states the unit.
    pub(super) of_table: bool,
    pub(super) line: usize,
    pub(super) column: usize,
}

impl Row {
    /// Returns a value in SI.
    pub(super) fn si(&self, key: &str) -> Option<f64> {
        self.values.get(key).map(|number| number.si)
    }

    /// Returns a value that a rule compares.
    pub(super) fn figure(&self, symbol: &'static str, key: &'static str) -> Option<ComparedFigure> {
        let number = self.values.get(key)?;
        let (written, line, column) = (number.written.clone(), number.line, number.column);
        Some(ComparedFigure { symbol, key, written, line, column })
    }

    /// Returns a finding about the product, at the first of its figures or at its name.
    pub(super) fn finding(&self, rule: PlausibilityRuleId, figures: Vec<ComparedFigure>) -> PlausibilityFinding {
        let (line, column) = figures.first().map_or((self.line, self.column), |figure| (figure.line, figure.column));
        PlausibilityFinding {
            rule,
            product: self.id.clone(),
            line,
            column,
            formula: "",
            ratio: None,
            window: None,
            unit: "",
            figures,
            other: None,
        }
    }
}

/// Returns the products of a catalogue file without faults, and the headings of a table.
pub(super) fn rows(name: &str, bytes: &[u8]) -> (Vec<Row>, Vec<UnitHeading>) {
    let (text, _) = decoded(bytes);
    if !is_csv(name, bytes) {
        let ends = |at: &usize| match text.as_bytes().get(*at..) {
            Some([b'\r', b'\n', ..]) => false,
            Some([first, ..]) => matches!(first, b'\r' | b'\n'),
            _ => false,
        };
        let starts: Vec<usize> = std::iter::once(0).chain((0..text.len()).filter(ends).map(|at| at + 1)).collect();
        return (of_toml(&text, &|at| place_among(&starts, &text, at), None), Vec::new());
    }
    let CsvText { toml, places, headings, .. } = catalogue_csv::as_toml(name, bytes);
    let lines: Vec<&str> = text.lines().collect();
    (of_toml(&toml, &|at| places.at(at), Some(&lines)), headings)
}

/// Returns line and column of a place, from one; `starts` are the places at which the lines begin.
fn place_among(starts: &[usize], text: &str, at: usize) -> (usize, usize) {
    let line = starts.partition_point(|start| *start <= at);
    let start = line.checked_sub(1).and_then(|index| starts.get(index)).copied().unwrap_or_default();
    (line.max(1), text.get(start..at).map_or(1, |before| before.chars().count() + 1))
}

/// Returns the products of a text in TOML; `table` are the lines of the table from which it was made.
fn of_toml(text: &str, at: &dyn Fn(usize) -> (usize, usize), table: Option<&[&str]>) -> Vec<Row> {
    let Ok(ReadCatalogue { head, actuators, .. }) = read_catalogue(text) else { return Vec::new() };
    let of = |own: &Stated<String>, common: fn(&CatalogueHead) -> &Stated<String>| {
        let common = head.as_ref().and_then(|head| common(head).get());
        own.get().or(common).cloned().unwrap_or_default()
    };
    let row = |entry: &ActuatorEntry| {
        let (line, column) = at(entry.id.span().start);
        let number = |field: &dyn StatedField| {
            let si = field.si()?;
            let source = text.get(field.span()).unwrap_or_default();
            let written = source.trim_matches(['"', '\'']).to_owned();
            let (line, column) = at(field.span().start);
            let cell = table.map_or_else(|| source.to_owned(), |lines| cell(lines, (line, column), &written));
            Some((field.name(), Number { si, written, cell, of_table: table.is_some(), line, column }))
        };
        Row {
            id: entry.id.get().cloned().unwrap_or_default(),
            maker: of(&entry.maker, |head| &head.maker),
            series: of(&entry.series, |head| &head.series),
            line,
            column,
            values: entry.values.fields().into_iter().filter_map(number).collect(),
        }
    };
    actuators.iter().map(row).collect()
}

/// Returns a cell of a table as written: the part of the line at its place that is the number of the value.
fn cell(lines: &[&str], (line, column): (usize, usize), written: &str) -> String {
    let number = written.split(' ').next().unwrap_or_default();
    let of_line = line.checked_sub(1).and_then(|index| lines.get(index)).copied().unwrap_or_default();
    let rest: String = of_line.chars().skip(column.saturating_sub(1)).take(MOST).collect();
    let is_number = |sign: char| sign.is_ascii_digit() || "+-.,eE".contains(sign);
    let mut part = rest.get(..rest.find(|sign| !is_number(sign)).unwrap_or(rest.len())).unwrap_or_default();
    while let Some((last, _)) = part.char_indices().next_back() {
        let plain = part.replace(',', ".").parse::<f64>().ok();
        if plain.is_some() && plain == number.parse().ok() && !part.ends_with(['.', ',']) {
            return part.to_owned();
        }
        part = part.get(..last).unwrap_or_default();
    }
    number.to_owned()
}

/// Largest number of characters of a number.
const MOST: usize = 40;

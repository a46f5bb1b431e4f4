//! The check-lists as their template reads them.

use answers::{CommissionEntry, Commissioning, Fact};
use quantities::{Language, Unit};
use serde::Serialize;
use words::{capitalised, commission, grade_word, signal_word as word, terms};

/// Everything the template of the check-lists places.
#[derive(Serialize)]
pub(crate) struct CheckListDocument {
    lang: &'static str,
    title: String,
    serial_number: String,
    signature: String,
    hazards_title: String,
    what: String,
    expected: String,
    measured: String,
    page: &'static str,
    disclaimer: &'static str,
    hazards: Vec<Told>,
    lists: Vec<List>,
}

#[derive(Serialize)]
struct Told {
    signal: Option<&'static str>,
    signal_word: &'static str,
    text: String,
    source: String,
}

#[derive(Serialize)]
struct List {
    title: String,
    entries: Vec<Line>,
}

#[derive(Serialize)]
struct Line {
    signal: Option<&'static str>,
    signal_word: &'static str,
    text: String,
    shown: String,
    unit: String,
    field: bool,
    grade: &'static str,
    source: String,
}

impl CheckListDocument {
    pub(crate) fn build(sheet: &Commissioning, language: Language) -> Self {
        let line = |entry: &CommissionEntry| Line {
            signal: entry.signal.map(|signal| signal.id()),
            signal_word: entry.signal.map_or("", |signal| word(*signal, language)),
            text: entry.text.clone(),
            shown: entry.shown.clone(),
            unit: entry.unit.map_or_else(String::new, unit_shown),
            field: entry.field,
            grade: grade_word(*entry.grade, language),
            source: entry.source.clone(),
        };
        let told = |fact: &Fact| Told {
            signal: fact.signal.map(|signal| signal.id()),
            signal_word: fact.signal.map_or("", |signal| word(*signal, language)),
            text: fact.text.to_owned(),
            source: fact.source.clone(),
        };
        Self {
            lang: language.id(),
            title: capitalised(&commission::title(&sheet.code, language)),
            serial_number: capitalised(commission::serial_number(language)),
            signature: capitalised(commission::signature(language)),
            hazards_title: capitalised(commission::hazards(language)),
            what: capitalised(terms::check(language)),
            expected: capitalised(commission::expected(language)),
            measured: capitalised(commission::measured(language)),
            page: commission::page(language),
            disclaimer: commission::not_affiliated(language),
            hazards: sheet.hazards.iter().filter(|fact| fact.signal.is_some()).map(told).collect(),
            lists: sheet
                .lists
                .iter()
                .map(|list| List { title: capitalised(&list.title), entries: list.entries.iter().map(line).collect() })
                .collect(),
        }
    }
}

fn unit_shown(unit: &'static str) -> String {
    if unit == "1" { String::new() } else { Unit::of(unit).map_or(unit, |unit| unit.symbol).to_owned() }
}

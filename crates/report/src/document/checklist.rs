//! Data of the checklists for their template.

use crate::form::{FieldKind, FormField};
use answers::{CommissionEntry, CommissionList, Commissioning, Fact};
use quantities::{Language, Unit};
use serde::Serialize;
use words::{ERRATUM_MARK, capitalised, commission, erratum_line, grade_word, signal_word as word};

/// Data that the template of the checklists uses.
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
    hazards: Vec<Hazard>,
    lists: Vec<List>,
    /// Errata of the expected values.
    errata: Vec<String>,
}

#[derive(Serialize)]
struct Hazard {
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
    /// Name of the field for the tick.
    tick: String,
    /// Name of the field for the measured value; empty for a line to tick only.
    value: String,
    signal: Option<&'static str>,
    signal_word: &'static str,
    text: String,
    shown: String,
    unit: String,
    grade: &'static str,
    source: String,
}

impl CheckListDocument {
    pub(crate) fn build(sheet: &Commissioning, language: Language) -> Self {
        let line = |list: &CommissionList, (index, entry): (usize, &CommissionEntry)| Line {
            tick: field_name(list, index, entry, "done"),
            value: if entry.field { field_name(list, index, entry, "measured") } else { String::new() },
            signal: entry.signal.map(|signal| signal.id()),
            signal_word: entry.signal.map_or("", |signal| word(*signal, language)),
            text: entry.text.clone(),
            shown: entry.shown.clone(),
            unit: entry.unit.map_or_else(String::new, |unit| unit_shown(unit, language)),
            grade: grade_word(*entry.grade, language),
            source: entry.source.clone(),
        };
        let hazard = |fact: &Fact| Hazard {
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
            what: capitalised(commission::item(language)),
            expected: capitalised(commission::expected(language)),
            measured: capitalised(commission::measured(language)),
            page: commission::page(language),
            disclaimer: commission::not_affiliated(language),
            hazards: sheet.hazards.iter().filter(|fact| fact.signal.is_some()).map(hazard).collect(),
            lists: sheet
                .lists
                .iter()
                .map(|list| List {
                    title: capitalised(&list.title),
                    entries: list.entries.iter().enumerate().map(|each| line(list, each)).collect(),
                })
                .collect(),
            errata: errata(sheet, language),
        }
    }

    /// Returns the fields of the form, in the order of the pages.
    pub(crate) fn fields(&self, language: Language) -> Vec<FormField> {
        let text = |name: &str, tooltip: &str| FormField {
            name: name.to_owned(),
            kind: FieldKind::Text,
            tooltip: tooltip.to_owned(),
        };
        let mut fields = vec![text("serial_number", &self.serial_number), text("signature", &self.signature)];
        for line in self.lists.iter().flat_map(|list| &list.entries) {
            let tooltip = commission::field_done(&line.text, language);
            fields.push(FormField { name: line.tick.clone(), kind: FieldKind::Tick, tooltip });
            if !line.value.is_empty() {
                let tooltip = match line.unit.as_str() {
                    "" => commission::field_measured(&line.text, language),
                    unit => commission::field_measured_in(&line.text, &unit, language),
                };
                fields.push(text(&line.value, &tooltip));
            }
        }
        fields
    }
}

/// Returns the errata of the values that the lists show, with their evidence.
fn errata(sheet: &Commissioning, language: Language) -> Vec<String> {
    let of_lists: Vec<&str> =
        sheet.lists.iter().flat_map(|list| &list.entries).flat_map(|entry| &entry.errata).copied().collect();
    let shown = sheet.errata.iter().filter(|each| of_lists.contains(&each.id.as_str()));
    shown.map(|each| format!("{ERRATUM_MARK} {}", erratum_line(&each.id, language))).collect()
}

/// Returns the name of a field, such as `before_power-3-resistance_ll-measured`. The position, counted from 1,
/// distinguishes equal entries of a list.
fn field_name(list: &CommissionList, index: usize, entry: &CommissionEntry, what: &str) -> String {
    format!("{}-{}-{}-{what}", list.step.id(), index + 1, entry.id)
}

fn unit_shown(unit: &'static str, language: Language) -> String {
    if unit == "1" { String::new() } else { Unit::of(unit).map_or(unit, |unit| unit.symbol_in(language)).to_owned() }
}

//! A recorded commissioning, line by line.

use super::commission::shown;
use super::parts::{NOTHING, significant, unit_shown};
use answers::{Recorded, RecordedValue};
use quantities::Language;
use sizing::Verdict;
use words::{commission, grade_word, marked};

/// A measurement as text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RecordedLine {
    /// Name of the measurand, with a number if there are several.
    pub name: String,
    /// Verdict on the measurement.
    pub verdict: Verdict,
    /// Measured value, or a dash.
    pub value: String,
    /// Expected value with its band.
    pub expected: String,
    /// Unit of both values.
    pub unit: String,
    /// Basis of the band, or the reason why nothing is judged; grade and source.
    pub remark: String,
    /// Likely cause of a deviation.
    pub cause: Option<String>,
}

/// Returns the measurements of a record, in the same order.
#[must_use]
pub fn recorded(record: &Recorded, language: Language) -> Vec<RecordedLine> {
    let line = |each: &RecordedValue| RecordedLine {
        name: each.number.map_or_else(|| each.name.clone(), |number| format!("{} {number}", each.name)),
        verdict: *each.verdict,
        value: value(each, language),
        expected: expected(each, language),
        unit: unit_shown(each.unit, language),
        remark: remark(each, language),
        cause: each.cause_text.as_ref().map(|cause| commission::likely_cause(cause, language)),
    };
    record.measurements.iter().map(line).collect()
}

/// Returns `true` if a measurement is a yes or no.
fn is_direction(value: &RecordedValue) -> bool {
    value.expected.is_none() && value.high.is_none() && value.id.starts_with("direction_")
}

fn value(value: &RecordedValue, language: Language) -> String {
    match value.value {
        Some(measured) if is_direction(value) => {
            if measured.0 > 0.5 { commission::right(language) } else { commission::reversed(language) }.to_owned()
        }
        Some(measured) => shown(measured.0, language),
        None => NOTHING.to_owned(),
    }
}

fn expected(value: &RecordedValue, language: Language) -> String {
    let short = |number| significant(number, 3, language);
    match (value.expected, value.low, value.high) {
        (Some(_), Some(_), Some(_)) => {
            let band = commission::between(&short(value.low), &short(value.high), language);
            marked(format!("{} ({band})", short(value.expected)), &value.errata)
        }
        (None, _, Some(_)) => marked(commission::at_most_value(&short(value.high), language), &value.errata),
        _ => NOTHING.to_owned(),
    }
}

fn remark(value: &RecordedValue, language: Language) -> String {
    let grade = value.grade.map(|grade| grade_word(*grade, language).to_owned());
    let parts = [Some(value.remark.clone()), grade, Some(value.source.clone())];
    let parts: Vec<String> = parts.into_iter().flatten().filter(|part| !part.is_empty()).collect();
    parts.join("; ")
}

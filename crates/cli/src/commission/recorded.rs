//! A recorded commissioning, judged.

use super::{shown, unit_shown};
use crate::answer::Answer;
use crate::fault::{Source, report};
use crate::table::{Align, Table, paragraph};
use clap::ArgMatches;
use std::path::Path;
use workbench::answers::{Fit, Recorded, RecordedValue};
use workbench::text::{capitalised, commission, grade_word, terms, told, verdict_word};
use workbench::{Commissioning, Language, answer};

/// `antrieb commission CODE --record FILE`: 0 nothing is off, 1 something is, 2 the record cannot be read.
pub(super) fn record(
    about: &Commissioning,
    path: &Path,
    matches: &ArgMatches,
    as_json: bool,
    language: Language,
) -> Result<Answer, Answer> {
    let source = Source::read(path, matches, as_json, language)?;
    let measured = workbench::measured(&source.text)
        .map_err(|faults| report(&source.name, &source.text, &told(&faults, language), as_json, language))?;
    let judged = workbench::judge(about, &measured);
    let recorded = answer::recorded(about, &judged, language);
    let fits = recorded.verdict == Fit::Fits;
    let answer = if as_json { Answer::record(&recorded) } else { Answer::data(text(&recorded, language)) };
    Ok(answer.fits(fits))
}

fn text(recorded: &Recorded, language: Language) -> String {
    let summary = commission::record_summary(&recorded.off, &recorded.not_checked, language);
    let mut out = format!("{}: {summary}\n\n", capitalised(&commission::title(&recorded.code, language)));
    let heads = [
        (commission::measured(language), Align::Left),
        (terms::verdict(language), Align::Left),
        (terms::value(language), Align::Right),
        (commission::expected(language), Align::Right),
        (terms::unit(language), Align::Left),
        (terms::remark(language), Align::Left),
    ];
    let mut table = Table::new(heads);
    for each in &recorded.measurements {
        table.row([
            name(each),
            verdict_word(*each.verdict, language),
            value(each, language),
            expected(each, language),
            unit(each),
            remark(each, language),
        ]);
    }
    out.push_str(&table.render());
    for each in recorded.measurements.iter().filter(|each| each.cause_text.is_some()) {
        let cause = each.cause_text.as_deref().unwrap_or_default();
        out.push_str(&paragraph(&format!("{}: ", name(each)), &commission::likely_cause(&cause, language)));
    }
    out
}

fn name(value: &RecordedValue) -> String {
    value.number.map_or_else(|| value.name.clone(), |number| format!("{} {number}", value.name))
}

/// Whether a measurement is a yes or no.
fn is_direction(value: &RecordedValue) -> bool {
    value.expected.is_none() && value.high.is_none() && value.id.starts_with("direction_")
}

fn unit(value: &RecordedValue) -> String {
    unit_shown(value.unit)
}

fn value(value: &RecordedValue, language: Language) -> String {
    match value.value {
        Some(measured) if is_direction(value) => {
            if measured.0 > 0.5 { commission::right(language) } else { commission::reversed(language) }.to_owned()
        }
        Some(measured) => shown(measured.0, language),
        None => "–".to_owned(),
    }
}

fn expected(value: &RecordedValue, language: Language) -> String {
    match (value.expected, value.low, value.high) {
        (Some(expected), Some(low), Some(high)) => {
            let band = commission::between(&shown_short(low.0, language), &shown_short(high.0, language), language);
            format!("{} ({band})", shown_short(expected.0, language))
        }
        (None, _, Some(high)) => commission::at_most_value(&shown_short(high.0, language), language),
        _ => "–".to_owned(),
    }
}

fn shown_short(value: f64, language: Language) -> String {
    workbench::quantities::format_significant(value, 3, language)
}

fn remark(value: &RecordedValue, language: Language) -> String {
    let grade = value.grade.map(|grade| grade_word(*grade, language).to_owned());
    let parts = [Some(value.remark.clone()), grade, Some(value.source.clone())];
    let parts: Vec<String> = parts.into_iter().flatten().filter(|part| !part.is_empty()).collect();
    parts.join("; ")
}

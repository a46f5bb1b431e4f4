//! A recorded commissioning as a record.

use super::commission::in_unit;
use super::errata::cited_once;
use answers::{Fit, Id, Recorded, RecordedValue};
use installation::commission::Commissioning;
use installation::commission::recorded::{Judged, MeasurementVerdict};
use quantities::Language;
use words::{band_text, cause_text, fact_source, measurand_name, source_text, unjudged_text};

/// Returns the measured values with their verdicts.
#[must_use]
pub fn recorded(about: &Commissioning, judged: &[Judged], language: Language) -> Recorded {
    let off = judged.iter().filter(|each| each.verdict == MeasurementVerdict::Fail).count();
    Recorded {
        code: about.code.to_string(),
        verdict: Fit::of(off == 0),
        off,
        not_checked: judged.iter().filter(|each| each.verdict == MeasurementVerdict::NotChecked).count(),
        measurements: judged.iter().map(|each| value(each, language)).collect(),
        errata: cited_once(judged.iter().flat_map(errata).copied(), language),
    }
}

const fn verdict(verdict: MeasurementVerdict) -> sizing::Verdict {
    match verdict {
        MeasurementVerdict::Pass => sizing::Verdict::Pass,
        MeasurementVerdict::Fail => sizing::Verdict::Fail,
        MeasurementVerdict::Advice => sizing::Verdict::Advice,
        MeasurementVerdict::NotChecked => sizing::Verdict::NotChecked,
    }
}

/// Returns the errata of the expected value.
fn errata(judged: &Judged) -> &[&'static str] {
    judged.expected.as_ref().map_or(&[], |expected| &expected.errata)
}

fn value(judged: &Judged, language: Language) -> RecordedValue {
    let unit = judged.what.unit();
    let expected = judged.expected.as_ref();
    let fact = judged.fact.and_then(|id| catalogue::facts().iter().find(|fact| fact.id == id));
    let band = expected.map(|expected| expected.band);
    let sources: Vec<String> = judged.sources().iter().map(|source| source_text(source, language)).collect();
    RecordedValue {
        id: judged.what.id(),
        name: measurand_name(judged.what, language).to_owned(),
        number: judged.number,
        verdict: Id(verdict(judged.verdict)),
        value: judged.value.map(|si| in_unit(si, unit)),
        expected: expected.and_then(|expected| expected.nominal).map(|si| in_unit(si, unit)),
        low: expected.map(|expected| in_unit(expected.low, unit)),
        high: expected.map(|expected| in_unit(expected.high, unit)),
        unit: unit.json,
        band: band.map(installation::commission::expected::Band::id),
        remark: match (judged.unjudged, band) {
            (Some(why), _) => unjudged_text(why, language).to_owned(),
            (None, Some(band)) => band_text(band, language).to_owned(),
            (None, None) => String::new(),
        },
        cause: judged.cause.map(installation::commission::recorded::Cause::id),
        cause_text: judged.cause.map(|cause| cause_text(cause, language)),
        grade: judged.grade.map(Id),
        source: fact.map_or_else(|| sources.join("; "), |fact| fact_source(fact, language)),
        errata: errata(judged).to_vec(),
    }
}

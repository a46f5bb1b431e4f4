//! Sentences and figures of results, which the terminal and the page show alike.

mod tolerances;

pub use crate::explain::{node_amount, trust};
pub use crate::sheet::{sheet_value_text, uncovered_mark};
pub use tolerances::{
    dominating, passing_text, sampling_text, share_text, tolerance_heads, tolerance_lines, tolerance_rows, worst_text,
};

use crate::limits::{NeededLimit, limits_needed};
use crate::mends::Mend;
use crate::sizing_use::{Candidate, CandidateId, Objection};
use crate::torsion::TorsionAnswer;
use actuator::BatteryLife;
use order_code::OrderCode;
use project::RecordingRead;
use quantities::unit::{
    ARCMINUTE, DEGREE_CELSIUS, KILONEWTON_METRE_PER_RADIAN, NEWTON_METRE, PERCENT, REVOLUTION_PER_MINUTE, YEAR,
};
use quantities::{Language, Measure, Time, Unit, format_number, format_significant};
use sizing::{Amount, Check, Checks, Demand, Reserve, SAMPLES_ANEW, Unsought, Verdict};
use words::{check_title, describe_rule, encoding_guess, grade_word, source_text, symbol_term, terminal, unmet_text};

/// Whether a candidate fits, what is missing, and whether a hanging load is left without a hold.
#[must_use]
pub fn standing_text(candidate: &Candidate<'_>, language: Language) -> String {
    words::standing_text(candidate.fits(), candidate.leaves_load_unheld(), &candidate.counts(), language)
}

/// How many of its checks came to which verdict.
#[must_use]
pub fn counts_text(candidate: &Candidate<'_>, language: Language) -> String {
    words::counts_text(&candidate.counts(), language)
}

/// The verdict of a check in a word: with a value and without a limit it is only shown.
#[must_use]
pub fn verdict_text(check: &Check, language: Language) -> String {
    if check.verdict == Verdict::NotChecked && check.value.is_some() {
        return words::without_limit(language);
    }
    words::verdict_word(check.verdict, language)
}

/// The utilisation of a check that is a margin, in percent: that of a class of voltage or of a recommendation is none, and does
/// not count in the utilisation of the actuator; where it fails or advises it says why.
#[must_use]
pub fn margin_text(check: &Check, language: Language) -> String {
    percent(margin_share(check), language)
}

/// The same as a number.
#[must_use]
pub fn margin_share(check: &Check) -> Option<f64> {
    let says_why = matches!(check.verdict, Verdict::Fail | Verdict::Advice);
    check.utilisation.filter(|_| check.id.has_margin() || says_why)
}

/// A value in its unit, four digits.
#[must_use]
pub fn shown(si: f64, unit: &Unit, language: Language) -> String {
    format_significant(unit.from_si(si), 4, language)
}

/// A figure in its unit, four digits, or a dash.
#[must_use]
pub fn figure_text(figure: Option<Amount>, language: Language) -> String {
    figure.map_or_else(|| "–".into(), |figure| format_significant(figure.value(), 4, language))
}

/// The sign of a figure's unit; a dash for a plain number, nothing where there is no figure.
#[must_use]
pub fn unit_text(figure: Option<Amount>) -> &'static str {
    figure.map_or("", |figure| if figure.unit.symbol == "1" { "–" } else { figure.unit.symbol })
}

/// A utilisation in percent, or a dash.
#[must_use]
pub fn percent(utilisation: Option<f64>, language: Language) -> String {
    utilisation.map_or_else(|| "–".into(), |share| format_number(share * 100.0, 1, language))
}

/// What speaks against a candidate besides its checks.
#[must_use]
pub fn objection_text(candidate: &Candidate<'_>, objection: &Objection, language: Language) -> String {
    match (objection, &candidate.id) {
        (Objection::Unmet(unmet), _) => unmet_text(unmet, language),
        (Objection::Rule(rule), CandidateId::Code(code)) => describe_rule(code, rule, language),
        (Objection::Rule(rule), CandidateId::Own(_)) => rule.table.to_owned(),
    }
}

/// The reason of a rejection in one line: the failing check that is exceeded most, else the first objection.
#[must_use]
pub fn reason(candidate: &Candidate<'_>, language: Language) -> String {
    if let Some(check) = candidate.worst_failure() {
        let unit = check.value.map_or("", |figure| figure.unit.symbol);
        let over =
            check.utilisation.map(|_| format!(" ({} %)", percent(check.utilisation, language))).unwrap_or_default();
        return format!(
            "{}: {} {} {} {unit}{over}",
            check_title(check.id, language),
            figure_text(check.value, language),
            check.relation().unwrap_or_default(),
            figure_text(check.limit, language),
        );
    }
    candidate.objections.first().map(|objection| objection_text(candidate, objection, language)).unwrap_or_default()
}

/// What fails first, then advice, then what is not checked, then the rest; within each by utilisation.
#[must_use]
pub fn by_importance(checks: &Checks) -> Vec<&Check> {
    let rank = |check: &Check| match check.verdict {
        Verdict::Fail => 0,
        Verdict::Advice => 1,
        Verdict::NotChecked => 2,
        Verdict::Pass => 3,
    };
    let share = |check: &Check| check.utilisation.unwrap_or(f64::NEG_INFINITY);
    let mut sorted: Vec<&Check> = checks.iter().collect();
    sorted.sort_by(|a, b| rank(a).cmp(&rank(b)).then_with(|| share(b).total_cmp(&share(a))));
    sorted
}

/// The figures of a demand: symbol, value, unit.
#[must_use]
pub fn demand_figures(demand: &Demand, language: Language) -> [(&'static str, String, &'static str); 5] {
    let torque = |si: f64| shown(si, &NEWTON_METRE, language);
    let speed = |si: f64| shown(si, &REVOLUTION_PER_MINUTE, language);
    let rpm = REVOLUTION_PER_MINUTE.symbol;
    [
        ("T_rms", torque(demand.torque_rms.si()), NEWTON_METRE.symbol),
        ("T_peak", torque(demand.torque_peak.si()), NEWTON_METRE.symbol),
        ("n_av", speed(demand.speed_mean.si()), rpm),
        ("n_peak", speed(demand.speed_peak.si()), rpm),
        ("ED", format_number(PERCENT.from_si(demand.duty_factor), 2, language), PERCENT.symbol),
    ]
}

/// How far one thing may be changed, all others as they are; for what does not fit also the limits of the project that
/// would have to be others. Each with what it is a list of.
#[must_use]
pub fn reserve_lines(
    reserve: &Reserve,
    candidate: &Candidate<'_>,
    language: Language,
) -> Vec<(&'static str, Vec<String>)> {
    let number = |value: f64| format_significant(value, 4, language);
    let mut parts = Vec::new();
    if let Some(factor) = reserve.payload_factor {
        parts.push(terminal::payload_factor(&number(factor), language));
    }
    if let Some(factor) = reserve.load_factor {
        parts.push(terminal::load_factor(&number(factor), language));
    }
    if let Some(time) = reserve.cycle_time {
        parts.push(terminal::cycle_time(&number(time.si()), language));
    }
    if let Some(ambient) = reserve.ambient {
        parts.push(terminal::ambient(&number(DEGREE_CELSIUS.from_si(ambient.si())), language));
    }
    let mut lines = Vec::new();
    if !parts.is_empty() {
        let head = match (candidate.judgement_fits(), candidate.objections.is_empty()) {
            (true, true) => terminal::fits_up_to(language),
            (true, false) => terminal::checks_pass_up_to(language),
            (false, true) => terminal::would_fit_with_one_of(language),
            (false, false) => terminal::checks_would_pass_with_one_of(language),
        };
        lines.push((head, parts));
    }
    if let Some(unsought) = &reserve.unsought {
        lines.push((terminal::not_sought(language), vec![unsought_text(unsought, language)]));
    }
    if let Some(needed) = limits_needed(candidate) {
        let each = |needed: &NeededLimit| {
            let unit = needed.enough.unit;
            format!("{} {} {}", needed.key, number(needed.enough.value()), unit.symbol)
        };
        lines.push((terminal::would_fit_with_this_asked_for(language), needed.iter().map(each).collect()));
    }
    lines
}

/// Another gearing with which an actuator fits: the key with its value, or a stage that would be added, and the code.
#[must_use]
pub fn mend_text(mend: &Mend, language: Language) -> String {
    let value = format_significant(mend.unit.from_si(mend.si), 2, language);
    let what = if mend.is_stated {
        format!("{} {value} {}", mend.path, mend.unit.symbol).trim_end_matches(" 1").to_owned()
    } else {
        terminal::a_stage(&value, language)
    };
    format!("{what} ({})", mend.code)
}

/// Which changes were not sought, why, and how they are.
pub(crate) fn unsought_text(unsought: &Unsought, language: Language) -> String {
    let samples = unsought.samples.to_string();
    if unsought.pace {
        terminal::load_and_pace_not_sought(&samples, &SAMPLES_ANEW, language)
    } else {
        terminal::load_not_sought(&samples, &SAMPLES_ANEW, language)
    }
}

/// The torsion of a gear under a torque, the curve that it comes from, and what is lost at its reversal, a line each.
#[must_use]
pub fn torsion_lines(code: &OrderCode, answer: &TorsionAnswer, language: Language) -> Vec<String> {
    let number = |value: f64, digits| format_significant(value, digits, language);
    let [k1, k2, k3] = answer.curve.stiffness.map(|k| number(k.in_unit(&KILONEWTON_METRE_PER_RADIAN), 3));
    let (torque, angle) =
        (number(answer.torque.in_unit(&NEWTON_METRE), 4), number(answer.angle.in_unit(&ARCMINUTE), 3));
    let radian = number(answer.angle.si() * 1e3, 3);
    let (t1, t2) = (number(answer.curve.torque_1.si(), 3), number(answer.curve.torque_2.si(), 3));
    let table = catalogue::size_cell(code.size, code.ratio, "K_1").map_or("", |cell| cell.place.table);
    let mut lines = vec![
        terminal::torsion(code, &angle, &radian, &torque, &answer.region, language),
        terminal::torsion_curve(&t1, &t2, &k1, &k2, &k3, &table, language),
    ];
    for (symbol, lost) in [("hysteresis_loss", &answer.hysteresis_loss), ("lost_motion", &answer.lost_motion)] {
        let Some(known) = lost.known() else { continue };
        let source = format!("{}, {}", grade_word(known.grade, language), source_text(&known.source, language));
        let angle = number(known.value.in_unit(&ARCMINUTE), 3);
        lines.push(terminal::most_lost(&symbol_term(symbol, language), &angle, &source, language));
    }
    lines
}

/// The life of the encoder's battery and the exchange that follows from it, a line each.
#[must_use]
pub fn battery_lines(battery: &BatteryLife, language: Language) -> Vec<String> {
    let years = |time: Time| format_significant(time.in_unit(&YEAR), 3, language);
    let grade = grade_word(battery.life.grade, language);
    vec![
        terminal::battery(&years(battery.life.value), &grade, language),
        terminal::battery_exchange(&years(battery.exchange_recommended), &years(battery.exchange_latest), language),
    ]
}

/// What was read of a recording: file, samples, columns with their units, what was left out, what was guessed.
#[must_use]
pub fn recording_text(read: &RecordingRead, language: Language) -> String {
    // A column may carry its unit in its name already.
    let column = |name: &str, unit: &str| {
        if name.contains(['[', '(', '/']) { name.to_owned() } else { format!("{name} [{unit}]") }
    };
    let columns: Vec<String> = read.recording.columns.iter().map(|each| column(&each.name, each.unit.symbol)).collect();
    let (count, columns) = (read.recording.time_s.len(), columns.join(", "));
    let left = read.recording.left_out_before + read.recording.left_out_after;
    let mut what = terminal::recording_read(&read.file, &count, &columns, language);
    if left > 0 {
        what = format!("{what}; {}", terminal::outside_the_window(&left, language));
    }
    if let Some(guess) = encoding_guess(read.recording.encoding, language) {
        what.push_str("; ");
        what.push_str(&guess);
    }
    what
}

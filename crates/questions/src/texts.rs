//! Sentences and figures of results, shared by terminal and page.

mod changes;
mod tolerances;

pub use crate::explain::{node_amount, number_and_unit, number_text, trust};
pub use crate::sheet::{sheet_value_text, uncovered_mark};
pub use crate::sizing_use::by_importance;
pub use changes::{law_text, mend_text, reach_text};
pub use tolerances::{
    conditional_text, dominating, passing_text, sampling_text, share_text, tolerance_heads, tolerance_lines,
    tolerance_rows, worst_text,
};

use crate::limits::{NeededLimit, limits_needed};
use crate::sizing_use::{Candidate, Objection, Reason, Sizing};
use crate::torsion::TorsionAnswer;
use actuator::BatteryLife;
use axis::RecordingRead;
use configurator::{BrokenRule, ProductId, Unmet};
use quantities::unit::{
    ARCMINUTE, DEGREE_CELSIUS, HOUR, KILONEWTON_METRE_PER_RADIAN, NEWTON_METRE, PERCENT, REVOLUTION_PER_MINUTE, SECOND,
    YEAR,
};
use quantities::{
    Language, Measure, ThermodynamicTemperature, Time, Unit, format_number, format_significant, with_symbol,
};
use recording::{ColumnRead, KnownBy};
use sizing::{Amount, Check, CheckId, Demand, Fit, Proviso, Reach, Reserve, SAMPLES_ANEW, Unsought, Verdict};
use words::{
    Provisos, check_title, conditions_text, describe_rule, encoding_guess, grade_word, marked, percent_text,
    proviso_text, records, source_text, symbol_term, terminal, title_of_check, unmet_text, unpadded,
};

/// Returns the result of a candidate: fit or not, the missing data, and a load that is not held without power.
#[must_use]
pub fn standing_text(candidate: &Candidate<'_>, language: Language) -> String {
    let provisos = provisos(candidate, |check| named_text(check, language));
    let unheld = candidate.leaves_load_unheld();
    words::standing_text(candidate.fit(), &provisos, unheld, &candidate.counts(), language)
}

/// Returns the checks beyond their limits that do not reject a candidate, each by `named`.
pub fn provisos(candidate: &Candidate<'_>, named: impl Fn(&Check) -> String) -> Provisos {
    let (ratings, estimates): (Vec<&Check>, Vec<&Check>) =
        candidate.inside_bands().into_iter().partition(|check| check.is_of_another_gear());
    let listed = |checks: Vec<&Check>| checks.into_iter().map(&named).collect::<Vec<_>>().join(", ");
    Provisos { estimates: listed(estimates), ratings: listed(ratings) }
}

/// Returns the title of a check with its utilisation; inside the band of an estimate, with those by both edges.
#[must_use]
pub fn named_text(check: &Check, language: Language) -> String {
    let title = title_of_check(check, language);
    match (check.utilisation, check.utilisation_band().filter(|_| check.is_inside_band())) {
        (_, Some([low, high])) => {
            let [low, high] = [low, high].map(|share| percent(Some(share), language));
            format!("{title} {low} {} {high} %", terminal::to(language))
        }
        (Some(share), None) => format!("{title} {} %", percent(Some(share), language)),
        (None, None) => title,
    }
}

/// Returns the title of the governing check of a candidate with its utilisation; empty if no check has a limit.
#[must_use]
pub fn governing_text(candidate: &Candidate<'_>, language: Language) -> String {
    candidate.governing().map(|check| named_text(check, language)).unwrap_or_default()
}

/// Returns the number of fitting candidates, and of those that fit only if an estimate holds.
#[must_use]
pub fn fitting_text(sizing: &Sizing<'_>, language: Language) -> String {
    let [fit, if_estimate] = sizing.counts();
    // One without a single check is neither evaluated nor fitting.
    let open = sizing.not_evaluated();
    let judged = terminal::judged(fit.saturating_sub(open), &(sizing.candidates.len() - open), language);
    let judged = match open {
        0 => judged,
        open => format!("{judged}; {}", terminal::without_any_check(open, language)),
    };
    match if_estimate {
        0 => judged,
        more => {
            let provisos = || sizing.fitting().iter().map(|candidate| candidate.judgement.proviso());
            let (estimate, rating) = (provisos().any(|it| it.estimate), provisos().any(|it| it.rating));
            let condition = conditions_text(estimate, rating, language);
            format!("{judged}, {}", terminal::more_on_condition(more, &condition, language))
        }
    }
}

/// Returns the reasons for which candidates are rejected, each with the candidates: the most frequent first.
#[must_use]
pub fn rejections<'s, 'p>(sizing: &'s Sizing<'p>, language: Language) -> Vec<Rejections<'s, 'p>> {
    let mut groups: Vec<Rejections<'s, 'p>> = Vec::new();
    for candidate in sizing.rejected() {
        let Some(reason) = candidate.reason() else { continue };
        let is_check = matches!(reason, Reason::Check(_));
        let title = reason_title(&reason, language);
        match groups.iter_mut().find(|group| group.is_check == is_check && group.title == title) {
            Some(group) => group.candidates.push(candidate),
            None => groups.push(Rejections { title, is_check, candidates: vec![candidate] }),
        }
    }
    groups.sort_by(|a, b| b.candidates.len().cmp(&a.candidates.len()).then_with(|| a.title.cmp(&b.title)));
    groups
}

/// Returns the checks that every actuator fails which a check rejects, in the order of the checks: the cause where none fits.
#[must_use]
pub fn failed_by_all(sizing: &Sizing<'_>, language: Language) -> Vec<String> {
    let by_checks = sizing.rejected().iter().filter(|each| matches!(each.reason(), Some(Reason::Check(_))));
    let failing = |candidate: &Candidate<'_>| -> Vec<CheckId> {
        let checks = candidate.judgement.checks.iter().filter(|check| check.verdict == Verdict::Fail);
        checks.map(|check| check.id).collect()
    };
    let all: Vec<Vec<CheckId>> = by_checks.map(failing).collect();
    let Some((first, others)) = all.split_first() else { return Vec::new() };
    let is_of_all = |id: &&CheckId| others.iter().all(|failing| failing.contains(id));
    first.iter().filter(is_of_all).map(|id| check_title(*id, language)).collect()
}

/// A reason with the candidates that it rejects.
#[derive(Clone, Debug)]
pub struct Rejections<'s, 'p> {
    /// Reason in words, without the figures of one actuator.
    pub title: String,
    /// `true` if the reason is a check; otherwise it is a requirement or a rule of the ordering code.
    pub is_check: bool,
    /// Candidates, the one with the smallest excess first.
    pub candidates: Vec<&'s Candidate<'p>>,
}

/// Returns a reason without the figures of the individual actuator.
fn reason_title(reason: &Reason<'_>, language: Language) -> String {
    let objection = match reason {
        Reason::Check(check) => return title_of_check(check, language),
        Reason::Objection(objection) => objection,
    };
    let text = match objection {
        Objection::Unmet(Unmet::Feedback(_)) => records::feedback_not_permitted,
        Objection::Unmet(Unmet::HollowShaft { .. }) => records::hollow_shaft_too_narrow,
        Objection::Unmet(Unmet::Length { .. }) => records::too_long,
        Objection::Unmet(Unmet::Mass { .. }) => records::too_heavy,
        Objection::Unmet(Unmet::SupplyTooLow { .. }) => records::supply_too_low,
        Objection::Unmet(Unmet::Price { .. }) => records::too_expensive,
        Objection::Unmet(Unmet::LeadTime { .. }) => records::lead_time_too_long,
        Objection::Unmet(unmet @ (Unmet::Brake(_) | Unmet::Maker | Unmet::NotKnown { .. } | Unmet::NotOffered(_))) => {
            return unmet_text(unmet, language);
        }
        Objection::Rule(rule) => return records::rule_of_table(&rule.table, language),
    };
    text(language).to_owned()
}

/// Returns the numbers of the checks of a candidate by verdict.
#[must_use]
pub fn counts_text(candidate: &Candidate<'_>, language: Language) -> String {
    words::counts_text(&candidate.counts(), language)
}

/// Returns the verdict of a check in a word; with a value and without a limit of the project it is only shown.
#[must_use]
pub fn verdict_text(check: &Check, language: Language) -> String {
    match check.limit {
        _ if !check.is_without_limit() => words::verdict_word(check.verdict, language),
        None => words::without_limit(language),
        // The actuator has a limit that the project does not require.
        Some(_) => words::terms::not_required(language).to_owned(),
    }
}

/// Returns the utilisation of a check that is a margin, in percent. That of a voltage class or of a recommendation is
/// no margin and does not count for the actuator; it is shown as the reason if the check fails or gives an advice.
#[must_use]
pub fn margin_text(check: &Check, language: Language) -> String {
    percent(margin_share(check), language)
}

/// Returns the utilisation of [`margin_text`] as a number.
#[must_use]
pub fn margin_share(check: &Check) -> Option<f64> {
    check.utilisation.filter(|_| check.id.shows_utilisation(check.verdict))
}

/// Formats a value in its unit, with four digits.
#[must_use]
pub fn shown(si: f64, unit: &Unit, language: Language) -> String {
    unit.figure(si, 4, language)
}

/// Formats value or limit of a check: as [`figure_text`], a degree of protection as its code.
#[must_use]
pub fn checked_text(id: CheckId, figure: Option<Amount>, language: Language) -> String {
    match figure {
        Some(numerals) if id == CheckId::Protection => words::degree_of_protection(numerals.si),
        _ => figure_text(figure, language),
    }
}

/// Formats value and limit of a check as [`checked_text`]; where the limit is exceeded, with as many digits as tell them
/// apart.
#[must_use]
pub fn compared_texts(check: &Check, language: Language) -> [String; 2] {
    let figures = [check.value, check.limit];
    let is_exceeded = check.verdict == Verdict::Fail || check.is_inside_band();
    if let ([Some(value), Some(limit)], true) = (figures, is_exceeded) {
        let digits = quantities::digits_apart([value, limit].map(|figure| figure.value()), 4);
        if digits > 4 && check.id != CheckId::Protection {
            return [value, limit].map(|figure| figure.unit.figure(figure.si, digits, language));
        }
    }
    figures.map(|figure| checked_text(check.id, figure, language))
}

/// Formats a figure in its unit, with four digits, or as a dash.
#[must_use]
pub fn figure_text(figure: Option<Amount>, language: Language) -> String {
    figure.map_or_else(|| "–".into(), |figure| figure.unit.figure(figure.si, 4, language))
}

/// Returns the verdict on a candidate in a few words, with the kind of limit that it depends on.
#[must_use]
pub fn verdict_of(candidate: &Candidate<'_>, language: Language) -> &'static str {
    match candidate.fit() {
        Fit::FitsIfEstimate if candidate.depends_on_ratings_alone() => words::terms::fits_unless_rating(language),
        Fit::Fits if candidate.counts().are_all_open() => words::terms::not_evaluated(language),
        fit => fit_text(fit, language),
    }
}

/// Returns a verdict in a few words.
#[must_use]
pub fn fit_text(fit: Fit, language: Language) -> &'static str {
    match fit {
        Fit::Fits => words::terms::fits(language),
        Fit::FitsIfEstimate => words::terms::fits_if_estimate(language),
        Fit::DoesNotFit => words::terms::does_not_fit(language),
    }
}

/// Returns the symbol of a figure's unit; a dash for a pure number, empty without a figure.
#[must_use]
pub fn unit_text(figure: Option<Amount>, language: Language) -> &'static str {
    figure.map_or("", |figure| if figure.unit.symbol == "1" { "–" } else { figure.unit.symbol_in(language) })
}

/// Values of one check of several actuators or revisions, in a row with one unit.
#[derive(Clone, Copy, Debug)]
pub struct ValuesInRow {
    common: Option<Option<Amount>>,
}

impl ValuesInRow {
    /// Finds the unit that all values have: a check may state an angle for one actuator and a torque for another.
    #[must_use]
    pub fn of<'c>(checks: impl IntoIterator<Item = Option<&'c Check>>) -> Self {
        let mut figures = checks.into_iter().flatten().filter_map(|check| check.value.or(check.limit));
        let first = figures.next();
        let is_common = figures.all(|figure| first.is_some_and(|first| first.unit.symbol == figure.unit.symbol));
        Self { common: is_common.then_some(first) }
    }

    /// Returns the symbol of the common unit, as [`unit_text`]; empty if each value has its own.
    #[must_use]
    pub fn unit(&self, language: Language) -> &'static str {
        self.common.map_or("", |figure| unit_text(figure, language))
    }

    /// Formats the value of a check as [`checked_text`], with its unit if the row has no common one.
    #[must_use]
    pub fn value(&self, check: &Check, language: Language) -> String {
        let value = checked_text(check.id, check.value, language);
        match check.value {
            Some(figure) if self.common.is_none() => with_symbol(&value, unit_text(Some(figure), language)),
            _ => value,
        }
    }
}

/// Formats a utilisation in percent, or as a dash.
#[must_use]
pub fn percent(utilisation: Option<f64>, language: Language) -> String {
    utilisation.map_or_else(|| "–".into(), |share| percent_text(share, language))
}

/// Returns an objection to a candidate as text.
#[must_use]
pub fn objection_text(candidate: &Candidate<'_>, objection: &Objection, language: Language) -> String {
    match objection {
        Objection::Unmet(unmet) => unmet_text(unmet, language),
        Objection::Rule(rule) => rule_text(&candidate.id, rule, language),
    }
}

/// Returns a rule of the ordering tables that a product breaks as text.
#[must_use]
pub fn rule_text(id: &ProductId, rule: &BrokenRule, language: Language) -> String {
    id.order_code().map_or_else(|| rule.table.to_owned(), |code| describe_rule(code, rule, language))
}

/// Returns the reason of a rejection in one line: the governing check, else the first objection; empty if the candidate
/// fits.
#[must_use]
pub fn reason(candidate: &Candidate<'_>, language: Language) -> String {
    let reason = candidate.reason();
    if let Some(Reason::Check(check)) = reason {
        return format!("{}: {}", title_of_check(check, language), excess_text(check, language));
    }
    match reason {
        Some(Reason::Objection(objection)) => objection_text(candidate, objection, language),
        Some(Reason::Check(_)) | None => String::new(),
    }
}

/// Returns value and limit of a failing check with its utilisation; where nothing is permitted, the reason.
fn excess_text(check: &Check, language: Language) -> String {
    let permits_nothing = check.limit.is_some_and(|limit| limit.si == 0.0);
    match check.id {
        CheckId::TorqueSpeedTrace if permits_nothing => match check.utilisation {
            Some(_) => {
                let share = percent(check.utilisation, language);
                format!("{} ({share} %)", terminal::speed_beyond_the_curve(language))
            }
            None => terminal::speed_beyond_the_curve(language).to_owned(),
        },
        CheckId::BrakeHolding if permits_nothing => {
            let value = checked_text(check.id, check.value, language);
            terminal::no_brake_for(&with_unit_text(&value, check.value, language), language)
        }
        CheckId::FeedbackRange if permits_nothing => {
            let value = checked_text(check.id, check.value, language);
            terminal::not_absolute_over(&with_unit_text(&value, check.value, language), language)
        }
        _ => {
            let [value, limit] = compared_texts(check, language);
            let limit = with_unit_text(&limit, check.limit, language);
            let text = format!("{value} {} {limit}", check.relation().unwrap_or_default());
            match check.utilisation {
                Some(_) => format!("{text} ({} %)", percent(check.utilisation, language)),
                None => text,
            }
        }
    }
}

/// Formats an instant in seconds, with three digits.
#[must_use]
pub fn instant_text(instant: Time, language: Language) -> String {
    // Within a microsecond of the start: the search for the maximum ends there.
    SECOND.figure(if instant.si().abs() < 1e-6 { 0.0 } else { instant.si() }, 3, language)
}

/// Returns a number with the symbol of its unit; a plain number without.
fn with_unit_text(number: &str, figure: Option<Amount>, language: Language) -> String {
    with_symbol(number, figure.map_or("1", |figure| figure.unit.symbol_in(language)))
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

/// Returns the largest permissible changes of one quantity each with their condition, and for a candidate that does not fit the
/// limits of the project that would have to change. Each list has its heading.
#[must_use]
pub fn reserve_lines(
    reserve: &Reserve,
    candidate: &Candidate<'_>,
    language: Language,
) -> Vec<(&'static str, Vec<String>)> {
    let mut lines = change_lines(reserve, candidate, language);
    if let Some(condition) = reserve_condition(reserve, candidate, language) {
        lines.insert(1, (words::terms::not_checked(language), vec![condition]));
    }
    lines
}

/// Returns the lines of [`reserve_lines`] without the condition of the values, each a change with which an actuator fits.
#[must_use]
pub fn change_lines(
    reserve: &Reserve,
    candidate: &Candidate<'_>,
    language: Language,
) -> Vec<(&'static str, Vec<String>)> {
    let number = |value: f64| format_significant(value, 4, language);
    let mut parts = Vec::new();
    let mut add = |text: String, Proviso { estimate, rating }: Proviso| match proviso_text(estimate, rating, language) {
        Some(proviso) => parts.push(format!("{text} ({proviso})")),
        None => parts.push(text),
    };
    if let Some(reach) = reserve.payload_factor {
        add(terminal::payload_factor(&number(reach.value), language), reach.proviso);
    }
    if let Some(reach) = reserve.load_factor {
        add(terminal::load_factor(&number(reach.value), language), reach.proviso);
    }
    if let Some(reach) = reserve.cycle_time {
        add(terminal::cycle_time(&number(reach.value.si()), language), reach.proviso);
    }
    let celsius =
        |reach: Reach<ThermodynamicTemperature>| unpadded(DEGREE_CELSIUS.from_si(reach.value.si()), 4, language);
    match [reserve.ambient_least, reserve.ambient] {
        [Some(least), Some(most)] => {
            let both = Proviso {
                estimate: least.proviso.estimate || most.proviso.estimate,
                rating: least.proviso.rating || most.proviso.rating,
            };
            add(terminal::ambient_between(&celsius(least), &celsius(most), language), both);
        }
        [None, Some(most)] => add(terminal::ambient(&celsius(most), language), most.proviso),
        [Some(least), None] => add(terminal::ambient_from(&celsius(least), language), least.proviso),
        [None, None] => {}
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
            format!("{} {}", needed.key, with_unit_text(&number(needed.enough.value()), Some(needed.enough), language))
        };
        lines.push((terminal::would_fit_with_this_asked_for(language), needed.iter().map(each).collect()));
    }
    lines
}

/// Returns the condition of the values of a reserve where checks that could reject the actuator could not be made; `None` if
/// all were, or if the reserve has no value.
#[must_use]
pub fn reserve_condition(reserve: &Reserve, candidate: &Candidate<'_>, language: Language) -> Option<String> {
    let Reserve { load_factor, payload_factor, cycle_time, ambient, .. } = reserve;
    let has_value = load_factor.is_some() || payload_factor.is_some() || cycle_time.is_some() || ambient.is_some();
    let count = candidate.unmade().len();
    (has_value && count > 0).then(|| terminal::only_by_the_checks_made(&count, language))
}

/// Describes the changes that were not searched, the reason, and the remedy.
pub(crate) fn unsought_text(unsought: &Unsought, language: Language) -> String {
    let samples = unsought.samples.to_string();
    if unsought.pace {
        terminal::load_and_pace_not_sought(&samples, &SAMPLES_ANEW, language)
    } else {
        terminal::load_not_sought(&samples, &SAMPLES_ANEW, language)
    }
}

/// Returns the torsion of a gear under a torque, its curve, and the hysteresis loss, one per line.
#[must_use]
pub fn torsion_lines(id: &ProductId, answer: &TorsionAnswer, language: Language) -> Vec<String> {
    let number = |value: f64, digits| format_significant(value, digits, language);
    let [k1, k2, k3] = answer.curve.stiffness.map(|k| number(k.in_unit(&KILONEWTON_METRE_PER_RADIAN), 3));
    let (torque, angle) =
        (number(answer.torque.in_unit(&NEWTON_METRE), 4), number(answer.angle.in_unit(&ARCMINUTE), 3));
    let radian = number(answer.angle.si() * 1e3, 3);
    let (t1, t2) = (number(answer.curve.torque_1.si(), 3), number(answer.curve.torque_2.si(), 3));
    let mut lines = vec![
        terminal::torsion(id, &angle, &radian, &torque, &answer.region, language),
        terminal::torsion_curve(&t1, &t2, &k1, &k2, &k3, &answer.table, language),
    ];
    for (symbol, limit) in answer.exceeded() {
        let source = format!("{}, {}", grade_word(limit.grade, language), source_text(&limit.source, language));
        let (name, limit) = (symbol_term(symbol, language), marked(number(limit.value.si(), 4), limit.errata));
        lines.insert(1, terminal::torsion_beyond(&symbol, &limit, &name, &source, language));
    }
    for (symbol, lost) in [("hysteresis_loss", &answer.hysteresis_loss), ("lost_motion", &answer.lost_motion)] {
        let Some(known) = lost.known() else { continue };
        let source = format!("{}, {}", grade_word(known.grade, language), source_text(&known.source, language));
        let angle = number(known.value.in_unit(&ARCMINUTE), 3);
        lines.push(terminal::most_lost(&symbol_term(symbol, language), &angle, &source, language));
    }
    lines
}

/// Returns the life of the encoder battery and the resulting replacement dates, one per line.
#[must_use]
pub fn battery_lines(battery: &BatteryLife, language: Language) -> Vec<String> {
    let years = |time: Time| unpadded(time.in_unit(&YEAR), 3, language);
    let grade = grade_word(battery.life.grade, language);
    let outlives = battery.capped.then(|| words::upkeep::battery_outlives_encoder(language).to_owned());
    let lines = [
        terminal::battery_under(
            &unpadded(battery.per_day.in_unit(&HOUR), 3, language),
            &years(battery.storage),
            language,
        ),
        terminal::battery(&years(battery.life.value), &grade, language),
        terminal::battery_exchange(&years(battery.exchange_recommended), &years(battery.exchange_latest), language),
    ];
    lines.into_iter().chain(outlives).collect()
}

/// Largest number of headings without use that a text lists.
const UNUSED_SHOWN: usize = 12;

/// Lists the headings that are not used, if there are any.
fn unused_text(headings: &[String], language: Language) -> Option<String> {
    let shown = headings.iter().take(UNUSED_SHOWN).map(String::as_str).collect::<Vec<_>>().join(", ");
    match headings.len() {
        0 => None,
        count if count > UNUSED_SHOWN => {
            Some(terminal::more_columns_not_used(&shown, &(count - UNUSED_SHOWN), language))
        }
        _ => Some(terminal::columns_not_used(&shown, language)),
    }
}

/// Describes the reading of a recording: file, samples, columns with their units, omissions and assumptions.
#[must_use]
pub fn recording_text(read: &RecordingRead, language: Language) -> String {
    // The name of a column may already contain its unit.
    let column = |each: &ColumnRead| match each.known_by {
        KnownBy::Header if each.name.contains(['[', '(', '/']) => each.name.clone(),
        KnownBy::Header | KnownBy::UnitRow | KnownBy::Metadata | KnownBy::Values | KnownBy::Layout => {
            format!("{} [{}]", each.name, each.unit.symbol)
        }
    };
    let columns: Vec<String> = read.recording.columns.iter().map(column).collect();
    let (count, columns) = (read.recording.time_s.len(), columns.join(", "));
    let left = read.recording.left_out_before + read.recording.left_out_after;
    let mut what = terminal::recording_read(&read.file, &count, &columns, language);
    if left > 0 {
        what = format!("{what}; {}", terminal::outside_the_window(&left, language));
    }
    if let Some(unused) = unused_text(&read.recording.unused, language) {
        what = format!("{what}; {unused}");
    }
    if read.recording.comments > 0 {
        what = format!("{what}; {}", terminal::comments_passed_over(&read.recording.comments, language));
    }
    if let Some(guess) = encoding_guess(read.recording.encoding, language) {
        what.push_str("; ");
        what.push_str(&guess);
    }
    what
}

//! Effect of tolerances on an actuator, as text and as a table.

use crate::tolerance::{Assessment, PointKind, Sampling, Worst};
use axis::{ALL_CORNERS_MOST, AxisProject};
use quantities::{Language, Unit, format_number, format_significant};
use words::{check_title, conditions_text, percent_text, terminal, terms};

/// Formats a share in percent with one digit; infinite if no axis is possible.
#[must_use]
pub fn share_text(share: f64, language: Language) -> String {
    if share.is_finite() { percent_text(share, language) } else { "∞".to_owned() }
}

/// Formats the share of samples that pass; 100 % only if every sample passes.
#[must_use]
pub fn passing_text(assessment: &Assessment, language: Language) -> String {
    format_number((assessment.share() * 1e4).floor() / 1e2, 2, language)
}

/// Returns the number of samples that pass on a condition, and the condition; `None` without any.
#[must_use]
pub fn conditional_text(assessment: &Assessment, language: Language) -> Option<String> {
    let found = assessment.conditional;
    let condition = conditions_text(found.proviso.estimate, found.proviso.rating, language);
    (found.samples > 0).then(|| terminal::of_these_on_condition(found.samples, &condition, language))
}

/// Describes the sampling.
#[must_use]
pub fn sampling_text(sampling: Sampling, language: Language) -> String {
    let Sampling { samples, seed } = sampling;
    terminal::tolerances_head(&samples, &seed, language)
}

/// Returns the verdict at the worst point, and its check.
#[must_use]
pub fn worst_text(worst: &Worst, language: Language) -> String {
    let verdict = super::fit_text(worst.fit, language);
    let check = worst
        .check
        .map_or_else(|| terminal::no_axis_possible(language).to_owned(), |check| check_title(check, language));
    let word = format!("{verdict}: {check}");
    if worst.place == PointKind::Sample {
        return format!("{word} ({})", terminal::inside_the_band(language));
    }
    word
}

/// Returns the dominating quantity and its share.
#[must_use]
pub fn dominating(project: &AxisProject, assessment: &Assessment, language: Language) -> [String; 2] {
    let found = assessment.influence.first().and_then(|first| Some((first, project.tolerances.get(first.quantity)?)));
    match found {
        Some((first, tolerance)) => [tolerance.path.clone(), share_text(first.share, language)],
        None => [terminal::none(language).to_owned(), "–".to_owned()],
    }
}

/// Returns the results of the tolerances of one actuator without its quantities, one sentence per line.
#[must_use]
pub fn tolerance_lines(project: &AxisProject, assessment: &Assessment, language: Language) -> Vec<String> {
    let (low, high) = assessment.interval;
    let passes = passing_text(assessment, language);
    let [low, high] = [low, high].map(|share| format_number(share * 100.0, 2, language));
    let found = &assessment.utilisation;
    let [p05, p50, p95, max] = [found.p05, found.p50, found.p95, found.max].map(|share| share_text(share, language));
    let worst = share_text(assessment.worst.utilisation, language);
    let word = worst_text(&assessment.worst, language);
    let mut lines = vec![
        terminal::share_passing(&passes, &low, &high, language),
        terminal::quantiles(&p05, &p50, &p95, &max, language),
        terminal::worst_corner(&worst, &word, language),
    ];
    if let Some(conditional) = conditional_text(assessment, language) {
        lines.insert(1, conditional);
    }
    if assessment.impossible > 0 {
        let count = assessment.impossible;
        lines.push(terminal::impossible_samples(&count, language));
    }
    if project.tolerances.len() > ALL_CORNERS_MOST {
        lines.push(terminal::corner_searched(&ALL_CORNERS_MOST, language));
    }
    lines
}

/// Returns the headings of the columns of [`tolerance_rows`].
#[must_use]
pub fn tolerance_heads(language: Language) -> [&'static str; 6] {
    [
        terminal::quantity(language),
        terminal::from(language),
        terminal::to(language),
        terms::unit(language),
        terminal::worst(language),
        terminal::influence_percent(language),
    ]
}

/// Returns the quantities with band, value at the worst point and influence, sorted by influence; in the order of the
/// file if none has an influence.
#[must_use]
pub fn tolerance_rows(project: &AxisProject, assessment: &Assessment, language: Language) -> Vec<[String; 6]> {
    let shown = |si: f64, unit: &Unit| format_significant(unit.from_si(si), 5, language);
    let listed: Vec<usize> = assessment.influence.iter().map(|each| each.quantity).collect();
    let order = if listed.is_empty() { (0..project.tolerances.len()).collect() } else { listed };
    let row = |index: usize| {
        let (each, at) = (project.tolerances.get(index)?, assessment.worst.values.get(index)?);
        let share = assessment.influence.iter().find(|found| found.quantity == index).map(|found| found.share);
        Some([
            each.path.clone(),
            shown(each.at(-1.0), each.unit),
            shown(each.at(1.0), each.unit),
            each.unit.symbol_in(language).to_owned(),
            shown(*at, each.unit),
            share.map_or_else(|| "–".into(), |share| share_text(share, language)),
        ])
    };
    order.into_iter().filter_map(row).collect()
}

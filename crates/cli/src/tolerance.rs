//! The part of `size` and `check` about the effect of tolerances.

use crate::table::{Align, TextTable, paragraph};
use axis::AxisProject;
use quantities::Language;
use questions::Assessment;
use questions::list::size::Ranking;
use questions::texts::{
    dominating, passing_text, sampling_text, share_text, tolerance_heads, tolerance_lines, tolerance_rows, worst_text,
};
use words::{terminal, terms};

/// Returns the table behind a ranking; empty without tolerances.
pub(crate) fn table(ranking: &Ranking<'_>, language: Language) -> String {
    let (project, assessed) = (ranking.project, &ranking.assessed);
    let Some((_, first)) = assessed.first() else { return String::new() };
    let mut table = TextTable::new([
        (terms::ordering_code(language), Align::Left),
        (terms::utilisation_short(language), Align::Right),
        (terminal::worst_percent(language), Align::Right),
        (terminal::at_the_worst_corner(language), Align::Left),
        (terminal::passes_percent(language), Align::Right),
        (terminal::dominated_by(language), Align::Left),
        (terminal::by_percent(language), Align::Right),
    ]);
    for (candidate, assessment) in ranking.assessed() {
        let [by, by_share] = dominating(project, assessment, language);
        table.row([
            candidate.id.to_string(),
            share_text(candidate.standing.utilisation, language),
            share_text(assessment.worst.utilisation, language),
            worst_text(&assessment.worst, language),
            passing_text(assessment, language),
            by,
            by_share,
        ]);
    }
    format!("{}\n{}\n", sampling_text(first.sampling, language), table.render())
}

/// Returns the effect of the tolerances on one actuator.
pub(crate) fn detail(project: &AxisProject, assessment: &Assessment, language: Language) -> String {
    let mut out = format!("\n{}\n", sampling_text(assessment.sampling, language));
    for line in tolerance_lines(project, assessment, language) {
        out.push_str(&paragraph("  ", &line));
    }
    let [quantity, from, to, unit, worst, influence] = tolerance_heads(language);
    let mut table = TextTable::new([
        (quantity, Align::Left),
        (from, Align::Right),
        (to, Align::Right),
        (unit, Align::Left),
        (worst, Align::Right),
        (influence, Align::Right),
    ]);
    for row in tolerance_rows(project, assessment, language) {
        table.row(row);
    }
    out.push_str(&table.render());
    out
}

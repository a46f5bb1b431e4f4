//! Reserve or deficit of a candidate, and the assumptions, as text.

use crate::table::labelled;
use axis::AxisProject;
use quantities::Language;
use questions::texts::reserve_lines;
use questions::{Candidate, Reserve};
use words::{assumption_text, terms};

/// Returns the assumptions.
pub(crate) fn assumptions_text(assumptions: &[axis::Assumption], language: Language) -> String {
    let head = terms::assumed(language);
    assumptions.iter().map(|assumption| labelled(head, &assumption_text(*assumption, language))).collect()
}

/// Returns the assumptions of an answer about one actuator, first that about the actuator if none is stated.
pub(crate) fn assumptions_about(project: &AxisProject, candidate: &Candidate<'_>, language: Language) -> String {
    let best = candidate.how_named(language).map(|text| labelled(terms::assumed(language), &text)).unwrap_or_default();
    let mut concerning = project.assumptions.clone();
    concerning.retain(|assumption| candidate.is_concerned_by(*assumption));
    best + &assumptions_text(&concerning, language)
}

/// Returns the assumptions that concern the motion.
pub(crate) fn assumptions_of_motion(project: &AxisProject, language: Language) -> String {
    let concerning = project.assumptions.iter().copied().filter(|each| each.concerns_motion());
    assumptions_text(&concerning.collect::<Vec<_>>(), language)
}

/// Returns the permissible change of each quantity with all others unchanged, for an actuator that does not fit also the
/// limits of the project that would have to change; `indent` stands before each heading.
pub(crate) fn reserve_text(reserve: &Reserve, candidate: &Candidate<'_>, indent: &str, language: Language) -> String {
    let lines = reserve_lines(reserve, candidate, language);
    lines.iter().map(|(head, parts)| labelled(&format!("{indent}{head}"), &parts.join("; "))).collect()
}

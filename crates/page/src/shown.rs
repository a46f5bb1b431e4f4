//! Actuator that the page shows, and the result that it belongs to.

use crate::state::PageState;
use axis::AxisProject;
use questions::list::size::sized;
use questions::{Candidate, Progress, Rejected, Sizing, Verdict, check, check_own};

/// Result of the work of a request.
pub(crate) struct Outcome<'o, 'p> {
    pub(crate) project: Option<&'o AxisProject>,
    pub(crate) sizing: Option<&'o Sizing<'p>>,
    pub(crate) candidate: Option<&'o Candidate<'p>>,
}

/// Returns the selected actuator with every check: the requested one, else that of the project, else the best. `best`
/// has been judged with every check if it fits.
pub(crate) fn looked_at<'p>(
    state: &PageState,
    project: &'p AxisProject,
    best: Option<&Candidate<'p>>,
) -> Option<Candidate<'p>> {
    let is_best = |best: &&Candidate<'p>| match &state.code {
        Some(id) => best.id == *id,
        None => project.actuator.is_none(),
    };
    if let Some(best) = best.filter(|best| best.fits()).filter(is_best) {
        return Some(best.clone());
    }
    if let Some(found) = state.code.as_ref().and_then(|id| check(project, id).ok()) {
        return Some(found);
    }
    chosen(project, best)
}

/// Returns the selected actuator for a page that shows nothing else: the catalogue is judged only if the selection
/// depends on it.
pub(crate) fn looked_at_alone<'p>(
    state: &PageState,
    project: &'p AxisProject,
    progress: &Progress,
) -> Option<Candidate<'p>> {
    let is_sought = state.code.is_none() && project.actuator.is_none();
    let sizing = if is_sought { sized(project, 1, Rejected::Nearest, progress).ok() } else { None };
    looked_at(state, project, sizing.as_ref().and_then(Sizing::named))
}

/// Returns the default actuator of a project: its own, else the best.
pub(crate) fn chosen<'p>(project: &'p AxisProject, best: Option<&Candidate<'_>>) -> Option<Candidate<'p>> {
    if let Ok(own) = check_own(project) {
        return Some(own);
    }
    best.and_then(|best| check(project, &best.id).ok())
}

/// Returns the style classes of a candidate. One that fits as far as its checks could be made has the colour of success and a border of its own.
pub(crate) fn class(candidate: &Candidate<'_>) -> &'static str {
    match candidate.marked_as() {
        Verdict::Fail => "fail",
        Verdict::Advice => "advice",
        Verdict::Pass => "pass",
        Verdict::NotChecked if candidate.counts().are_all_open() => "not_checked",
        Verdict::NotChecked => "pass partly",
    }
}

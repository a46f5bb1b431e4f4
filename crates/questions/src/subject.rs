//! Defaults for the subject of a question: axis, actuator, corresponding axes of two projects.

use crate::progress::Progress;
use crate::sizing_use::{Candidate, Refusal, Rejected, Sizing, check, check_own, size_watched};
use axis::AxisProject;
use configurator::ProductId;
use quantities::Language;
use std::borrow::Cow;
use words::terminal;

/// Returns the axes of a project, or the one with a name, each with its place in the file.
///
/// # Errors
/// If there is no axis with that name: the names that exist.
pub(crate) fn picked(
    projects: Vec<AxisProject>,
    wanted: Option<&str>,
    language: Language,
) -> Result<Vec<(usize, AxisProject)>, String> {
    let names = names(&projects);
    let mut found: Vec<(usize, AxisProject)> = projects.into_iter().enumerate().collect();
    if let Some(wanted) = wanted {
        found.retain(|(_, project)| project.name == wanted);
        if found.is_empty() {
            return Err(terminal::no_such_axis(&wanted, &names, language));
        }
    }
    Ok(found)
}

/// Joins the names of axes for a sentence.
pub(crate) fn names<'p>(projects: impl IntoIterator<Item = &'p AxisProject>) -> String {
    let names: Vec<&str> = projects.into_iter().map(|project| project.name.as_str()).collect();
    names.join(", ")
}

/// Returns the actuator of an answer: that of an identity, else the project's own, else the one that the ranking names
/// ([`Sizing::named`]); judged by every check. `sizing` is called only if it decides.
///
/// # Errors
/// The reason why it cannot be judged.
pub fn candidate_for<'p, 's>(
    project: &'p AxisProject,
    id: Option<&ProductId>,
    sizing: impl FnOnce() -> Result<Cow<'s, Sizing<'p>>, Refusal>,
) -> Result<Candidate<'p>, Refusal>
where
    'p: 's,
{
    if let Some(id) = id {
        return check(project, id);
    }
    if project.actuator.is_some() {
        return check_own(project);
    }
    let sizing = sizing()?;
    let named = sizing.named().ok_or(Refusal::NoActuator)?;
    // A code of the ranking may break a rule with the required options: then the judgement of the ranking is used.
    let found = check(project, &named.id).unwrap_or_else(|_| named.clone());
    Ok(Candidate { is_best_of_ranking: true, ..found })
}

/// Returns the actuator of an answer as [`candidate_for`], with a ranking of its own.
///
/// # Errors
/// The reason why it cannot be judged, [`Refusal::Stopped`].
pub(crate) fn stated_or_best<'p>(
    project: &'p AxisProject,
    id: Option<&ProductId>,
    progress: &Progress,
) -> Result<Candidate<'p>, Refusal> {
    candidate_for(project, id, || Ok(Cow::Owned(size_watched(project, 1, Rejected::Nearest, progress)?)))
}

/// Returns the indices of corresponding axes of two revisions: those with equal names, and the single axes of both
/// independent of their names.
#[must_use]
pub(crate) fn paired(old: &[(usize, AxisProject)], new: &[(usize, AxisProject)]) -> Vec<(usize, usize)> {
    let names =
        |axes: &'_ [(usize, AxisProject)]| axes.iter().map(|(_, project)| project.name.clone()).collect::<Vec<_>>();
    pairs(&names(old), &names(new))
}

fn pairs(old: &[String], new: &[String]) -> Vec<(usize, usize)> {
    if old.len() == 1 && new.len() == 1 {
        return vec![(0, 0)];
    }
    let partner = |name: &String| new.iter().position(|other| other == name);
    old.iter().enumerate().filter_map(|(index, name)| Some((index, partner(name)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_of_two_revisions_are_paired_by_name_and_single_ones_whatever_theirs() {
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>();
        assert_eq!(pairs(&names(&["a"]), &names(&["b"])), [(0, 0)]);
        assert_eq!(pairs(&names(&["a", "b", "c"]), &names(&["c", "a"])), [(0, 1), (2, 0)]);
        assert_eq!(pairs(&names(&["a"]), &names(&["b", "c"])), []);
    }
}

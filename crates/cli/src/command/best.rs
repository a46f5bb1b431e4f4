//! The best actuators of the project of a call, with the values that the call states in place of the file's.

use super::folder::{axes_of, catalogues, has_ending, kind_in_place_of_a_file};
use super::meant::{self, Called};
use crate::call::catalogue_of;
use crate::changed::Statements;
use crate::source::SourceFile;
use axis::Catalogue;
use order_code::Pattern;
use quantities::Language;
use questions::embedded_catalogue;
use questions::list::Reads;
use std::ffi::OsString;
use std::path::Path;
use std::sync::Arc;

/// Project of a call as the call changes it, and the products that are offered.
pub(super) struct ProjectOfCall {
    file: SourceFile,
    axis: Option<String>,
    catalogue: Arc<dyn Catalogue>,
    language: Language,
}

impl ProjectOfCall {
    /// Reads a project as its file states it.
    pub(super) fn of_file(path: &str, language: Language) -> Option<Self> {
        let file = SourceFile::read(Path::new(path), Reads::Project, questions::MEMORY_USUAL, language).ok()?;
        Some(Self { file, axis: None, catalogue: Arc::clone(embedded_catalogue()), language })
    }

    /// Reads a project with some changes; `None` if one of them cannot be made, which the call itself reports.
    pub(super) fn changed(path: &str, stated: &Statements, words: &[OsString], language: Language) -> Option<Self> {
        let mut project = Self::of_file(path, language)?;
        project.file.change(stated, language).ok()?;
        project.axis.clone_from(&stated.axis);
        project.catalogue = catalogue_of(&catalogues(words), language).ok()?;
        Some(project)
    }

    /// Reads a project of a call with the changes that its words state.
    pub(super) fn of_call(path: &str, arguments: &[OsString], called: &Called<'_>) -> Option<Self> {
        let words = meant::understood(arguments.to_vec(), called.whole(), called.language()).arguments;
        let texts: Vec<&str> = words.iter().filter_map(|word| word.to_str()).collect();
        let changed = Self::changed(path, &Statements::of_words(&texts), &words, called.language());
        // A change that cannot be made is what the call is refused for.
        changed.or_else(|| Self::of_file(path, called.language()))
    }

    /// Returns what a function finds in the ranking of the only axis, or of the wanted one.
    fn of_sizing<T>(&self, find: impl FnOnce(&questions::Sizing<'_>) -> T) -> Option<T> {
        let source = self.file.source();
        let projects = source.projects(&self.catalogue, crate::waiting::progress(), self.language).ok()?;
        let is_wanted = |name: &str| self.axis.as_deref().is_none_or(|wanted| wanted == name);
        let mut wanted = projects.iter().filter(|project| is_wanted(&project.name));
        let project = wanted.next().filter(|_| wanted.next().is_none())?;
        Some(find(&questions::size(project)))
    }
}

/// Returns the code of the best actuator of the first project among some words; `None` if there is no answer.
pub(super) fn best_of_project(words: &[&str], language: Language) -> Option<String> {
    let is_kind = |word: &str| kind_in_place_of_a_file(word).is_some();
    let path = words.iter().find(|word| has_ending(word, &[".toml"]) || is_kind(word))?;
    best_coded(&ProjectOfCall::of_file(path, language)?)
}

/// Returns the code of the best actuator of a project; `None` if there is no answer.
pub(super) fn best_coded(project: &ProjectOfCall) -> Option<String> {
    let is_coded = |id: &str| questions::read_code(id, project.language).is_ok();
    best_products(project, 1, is_coded).into_iter().next()
}

/// Returns the names of the axes of a project that is read as its file states it, each with the code of its best actuator.
pub(super) fn best_of_axes(path: &str, language: Language) -> Vec<(String, Option<String>)> {
    let of_axis = |axis: String| {
        let project = ProjectOfCall::of_file(path, language).map(|of| ProjectOfCall { axis: Some(axis.clone()), ..of });
        let code = project.and_then(|project| best_coded(&project));
        (axis, code)
    };
    axes_of(Path::new(path)).into_iter().map(of_axis).collect()
}

/// The best of the actuators that a part of a code allows.
pub(super) struct BestOfPattern {
    pub(super) code: String,
    /// Actuators that fit, the best first: of none of them the code is the one with the smallest excess.
    pub(super) fitting: Vec<String>,
    /// Actuators that do not fit.
    pub(super) failing: Vec<String>,
}

/// Returns the best of the actuators that a part of a code allows, for a project with one axis; `None` if there is none.
pub(super) fn best_of_pattern(project: &ProjectOfCall, pattern: &Pattern) -> Option<BestOfPattern> {
    let found = project.of_sizing(|sizing| {
        let is_it = |id: &&String| {
            questions::read_code(id, project.language).is_ok_and(|read| pattern.matches(&read.parsed.code))
        };
        let ids: Vec<String> = sizing.candidates.iter().map(|candidate| candidate.id.to_string()).collect();
        let fits: Vec<String> = sizing.fitting().iter().map(|candidate| candidate.id.to_string()).collect();
        let found: Vec<&String> = ids.iter().filter(is_it).collect();
        let code = (*found.first()?).clone();
        let (fitting, failing) = found.into_iter().cloned().partition(|id| fits.contains(id));
        Some(BestOfPattern { code, fitting, failing })
    });
    found.flatten()
}

/// Returns the codes and names of the best actuators of a project with one axis that a condition admits, at most `most`: of
/// those that fit, else the one with the smallest excess.
pub(super) fn best_products(project: &ProjectOfCall, most: usize, admits: impl Fn(&str) -> bool) -> Vec<String> {
    let found = project.of_sizing(|sizing| {
        let named = sizing.named().into_iter();
        let all = named.chain(sizing.fitting().iter()).map(|candidate| candidate.id.to_string());
        let mut codes: Vec<String> = all.filter(|id| admits(id)).collect();
        let mut known: Vec<String> = Vec::new();
        codes.retain(|code| {
            !known.contains(code) && {
                known.push(code.clone());
                true
            }
        });
        codes.truncate(most);
        codes
    });
    found.unwrap_or_default()
}

//! The best actuators of the project of a call.

use super::folder::{has_ending, kind_in_place_of_a_file};
use crate::source::SourceFile;
use order_code::Pattern;
use quantities::Language;
use questions::embedded_catalogue;
use questions::list::Reads;
use std::path::Path;

/// Returns the code of the best actuator of the first project among some words; `None` if there is no answer.
pub(super) fn best_of_project(words: &[&str], language: Language) -> Option<String> {
    let is_kind = |word: &str| kind_in_place_of_a_file(word).is_some();
    let path = words.iter().find(|word| has_ending(word, &[".toml"]) || is_kind(word))?;
    best_products(path, 1, |id| questions::read_code(id, language).is_ok(), language).into_iter().next()
}

/// The best of the actuators that a part of a code allows.
pub(super) struct BestOfPattern {
    pub(super) code: String,
    /// Number of the actuators.
    pub(super) count: usize,
    /// `false` if none of them fits: the code is then the one with the smallest excess.
    pub(super) fits: bool,
}

/// Returns the best of the actuators that a part of a code allows, for a project with one axis; `None` if there is none.
pub(super) fn best_of_pattern(path: &str, pattern: &Pattern, language: Language) -> Option<BestOfPattern> {
    of_sizing(path, language, |sizing| {
        let is_it =
            |id: &&String| questions::read_code(id, language).is_ok_and(|read| pattern.matches(&read.parsed.code));
        let ids: Vec<String> = sizing.candidates.iter().map(|candidate| candidate.id.to_string()).collect();
        let found: Vec<&String> = ids.iter().filter(is_it).collect();
        let code = (*found.first()?).clone();
        let fits = sizing.fitting().iter().any(|candidate| candidate.id.to_string() == code);
        Some(BestOfPattern { code, count: found.len(), fits })
    })
    .flatten()
}

/// Returns what a function finds in the ranking of a project with one axis.
fn of_sizing<T>(path: &str, language: Language, find: impl FnOnce(&questions::Sizing<'_>) -> T) -> Option<T> {
    let file = SourceFile::read(Path::new(path), Reads::Project, questions::MEMORY_USUAL, language).ok()?;
    let projects = file.source().projects(embedded_catalogue(), crate::waiting::progress(), language).ok()?;
    let [project] = &projects[..] else { return None };
    Some(find(&questions::size(project)))
}

/// Returns the code of the best actuator of the first project among some words, or its name; `None` if there is no answer.
pub(super) fn best_product_of_project(path: &str, language: Language) -> Option<String> {
    best_products(path, 1, |_| true, language).into_iter().next()
}

/// Returns the codes and names of the best actuators of a project with one axis that a condition admits, at most `most`: of
/// those that fit, else the one with the smallest excess.
pub(super) fn best_products(path: &str, most: usize, admits: impl Fn(&str) -> bool, language: Language) -> Vec<String> {
    let found = of_sizing(path, language, |sizing| {
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

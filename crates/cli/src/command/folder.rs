//! Projects and recordings of a folder, which a call may mean.

use crate::source::SourceFile;
use project::{PROJECT_MAX_BYTES, written};
use quantities::Language;
use questions::embedded_catalogue;
use questions::list::Reads;
use std::path::{Path, PathBuf};

/// Extensions of recordings.
pub(super) const RECORDINGS: [&str; 5] = [".csv", ".csv.gz", ".parquet", ".txt", ".log"];

/// Largest number of files of a folder that are read.
const SEARCHED_MOST: usize = 50;

/// Returns `true` if a word ends in one of these extensions, in any case.
pub(super) fn has_ending(word: &str, endings: &[&str]) -> bool {
    let word = word.to_lowercase();
    endings.iter().any(|ending| word.len() > ending.len() && word.ends_with(ending))
}

/// Reads the text of a project file of limited size.
pub(super) fn text_of(path: &Path) -> Option<String> {
    let bytes = disk::read_within(std::fs::File::open(path).ok()?, PROJECT_MAX_BYTES).ok()?;
    String::from_utf8(bytes).ok()
}

/// Returns the names of the axes of a project.
pub(super) fn axes_of(path: &Path) -> Vec<String> {
    let all = text_of(path).and_then(|text| written(&text)).unwrap_or_default();
    let is_name = |path: &str| {
        path.strip_prefix("axis[").and_then(|rest| rest.split_once(']')).is_some_and(|(_, key)| key == ".name")
    };
    all.into_iter().filter(|each| is_name(&each.path)).filter_map(|each| each.value).collect()
}

/// Returns the name of the project of a recording.
pub(super) fn project_name(recording: &str) -> String {
    let stem = RECORDINGS.iter().find_map(|ending| recording.strip_suffix(ending)).unwrap_or(recording);
    format!("{stem}.toml")
}

/// Returns the project files in a folder, sorted.
pub(super) fn projects_in(folder: &Path) -> Vec<PathBuf> {
    let read = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = std::fs::read_dir(read).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let mut found: Vec<PathBuf> =
        names.filter(|name| has_ending(name, &[".toml"])).map(|name| folder.join(name)).collect();
    found.sort();
    found.truncate(SEARCHED_MOST);
    found.retain(|path| is_project(path));
    found
}

/// Returns `true` if a file is a project: it states the motion of an axis.
pub(super) fn is_project(path: &Path) -> bool {
    let all = text_of(path).and_then(|text| written(&text)).unwrap_or_default();
    all.iter().any(|each| each.path == "motion[1]" || each.path == "axis[1].motion[1]")
}

/// Returns the code of the best actuator of the first project among some words; `None` if there is no answer.
pub(super) fn best_of_project(words: &[&str], language: Language) -> Option<String> {
    let path = words.iter().find(|word| has_ending(word, &[".toml"]))?;
    best_codes(path, 1, language).into_iter().next()
}

/// Returns the codes of the best actuators of a project with one axis, at most `most`: of those that fit, else the one with the
/// smallest excess.
pub(super) fn best_codes(path: &str, most: usize, language: Language) -> Vec<String> {
    let found = || {
        let file = SourceFile::read(Path::new(path), Reads::Project, questions::MEMORY_USUAL, language).ok()?;
        let projects = file.source().projects(embedded_catalogue(), crate::waiting::progress(), language).ok()?;
        let [project] = &projects[..] else { return None };
        let sizing = questions::size(project);
        let named = sizing.named().into_iter();
        let all = named.chain(sizing.fitting().iter()).map(|candidate| candidate.id.to_string());
        let mut codes: Vec<String> = all.filter(|id| questions::read_code(id, language).is_ok()).collect();
        let mut known: Vec<String> = Vec::new();
        codes.retain(|code| {
            !known.contains(code) && {
                known.push(code.clone());
                true
            }
        });
        codes.truncate(most);
        Some(codes)
    };
    found().unwrap_or_default()
}

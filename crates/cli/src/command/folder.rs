//! Projects and recordings of a folder, which a call may mean.

use super::kind::kind;
use project::{PROJECT_MAX_BYTES, written};
use quantities::Language;
use questions::list::{OutputFile, media, new};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Extensions of recordings.
pub(crate) const RECORDINGS: [&str; 8] = [".csv", ".csv.gz", ".parquet", ".txt", ".log", ".tsv", ".dat", ".asc"];

/// Largest number of files of a folder that are read.
const SEARCHED_MOST: usize = 50;

/// Returns `true` if a word ends in one of these extensions, in any case.
pub(super) fn has_ending(word: &str, endings: &[&str]) -> bool {
    let word = word.to_lowercase();
    endings.iter().any(|ending| word.len() > ending.len() && word.ends_with(ending))
}

/// Reads the text of a project file of limited size, or that of a new project of the kind that stands in place of a file.
pub(super) fn text_of(path: &Path) -> Option<String> {
    if let Some(text) = path.to_str().and_then(|word| text_of_kind(word, Language::default())) {
        return Some(text);
    }
    let bytes = disk::read_file(path, PROJECT_MAX_BYTES).ok()?;
    String::from_utf8(bytes).ok()
}

/// Extensions of the files that a question reads besides its project.
pub(super) const TABLES: [&str; 3] = [".csv", ".csv.gz", ".parquet"];

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

/// Returns the recordings in the working folder, sorted.
pub(super) fn recordings() -> Vec<String> {
    let entries = std::fs::read_dir(".").into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let mut found: Vec<String> = names.filter(|name| has_ending(name, &RECORDINGS)).collect();
    found.sort();
    found
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

/// Returns the kind of project that a word names in place of a file; `None` if there is such a file, or a project or an axis of
/// this name in the folder.
pub(crate) fn kind_in_place_of_a_file(word: &str) -> Option<String> {
    const NO_AXES: [&str; 3] = ["sweep", "catalogue", "recording"];
    if has_ending(word, &[".toml"]) || has_ending(word, &RECORDINGS) {
        return None;
    }
    let (kind, _) = kind(&[word]).filter(|(kind, _)| !NO_AXES.contains(&kind.as_str()))?;
    let is_meant = |path: &PathBuf| {
        path.file_stem().is_some_and(|stem| stem.eq_ignore_ascii_case(word))
            || axes_of(path).iter().any(|name| name == word)
    };
    (!Path::new(word).exists() && !projects_in(Path::new("")).iter().any(is_meant)).then_some(kind)
}

/// Returns the text of a new project of the kind that a word names in place of a file.
pub(crate) fn text_of_kind(word: &str, language: Language) -> Option<String> {
    let kind = kind_in_place_of_a_file(word)?;
    let template = new::template(&kind, new::USUAL_NAME, language)?;
    template.recording.is_none().then_some(template.text)
}

/// Returns `true` if a file is a project: it states the motion of an axis.
pub(super) fn is_project(path: &Path) -> bool {
    let all = text_of(path).and_then(|text| written(&text)).unwrap_or_default();
    all.iter().any(|each| each.path == "motion[1]" || each.path == "axis[1].motion[1]")
}

/// Option of a catalogue file.
const CATALOGUE: &str = "--catalogue";

/// Returns the catalogue files that a call names.
pub(super) fn catalogues(arguments: &[OsString]) -> Vec<PathBuf> {
    let texts: Vec<&str> = arguments.iter().map(|word| word.to_str().unwrap_or_default()).collect();
    let behind = texts.windows(2).filter_map(|pair| match pair {
        [option, file] if *option == CATALOGUE => Some(*file),
        _ => None,
    });
    let joined = texts.iter().filter_map(|text| text.strip_prefix(CATALOGUE)?.strip_prefix('='));
    behind.chain(joined).map(PathBuf::from).collect()
}

/// Returns the extensions of the files of a media type.
pub(super) fn endings(file: &OutputFile) -> Vec<&'static str> {
    let of = |media: &&'static str| match *media {
        media::SVG => ".svg",
        media::PNG => ".png",
        media::PDF => ".pdf",
        media::CSV => ".csv",
        media::TOML => ".toml",
        media::XLSX => ".xlsx",
        media::CALENDAR => ".ics",
        media::PARQUET => ".parquet",
        media::JSON => ".json",
        _ if file.option == "vcd" => ".vcd",
        _ => ".txt",
    };
    file.media.iter().map(of).collect()
}

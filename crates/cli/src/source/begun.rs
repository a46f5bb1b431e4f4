//! A recording in place of a project: the project that begins with it.

use crate::command::RECORDINGS;
use crate::fault::path_text;
use crate::preview::previewed;
use project::{Edit, edit, written};
use quantities::Language;
use questions::list::{Unanswered, new};
use std::path::Path;
use words::file_trouble;

/// Kind of a project whose mechanism the recording decides.
const KIND: &str = "recording";

/// Bytes of a text file that are read to decide whether it is a project.
const HEAD: usize = 1 << 20;

/// Returns `true` if a file that exists has the ending of a recording and is no project.
pub(super) fn is_recording(path: &Path) -> bool {
    let name = path.to_string_lossy().to_lowercase();
    if !RECORDINGS.iter().any(|ending| name.len() > ending.len() && name.ends_with(ending)) || !path.is_file() {
        return false;
    }
    let bytes = disk::read_file(path, HEAD);
    let keys = bytes.ok().and_then(|bytes| String::from_utf8(bytes).ok()).and_then(|text| written(&text));
    !keys.unwrap_or_default().iter().any(|key| key.path == "motion[1]" || key.path == "axis[1]")
}

/// Returns the text of the project that begins with a recording, as `new recording` writes it.
///
/// # Errors
/// A file that is no table.
pub(super) fn text_of(path: &Path, language: Language) -> Result<String, Unanswered> {
    let named = path.file_name().map_or_else(|| path_text(path), |name| path_text(Path::new(name)));
    let found = new::recorded(KIND, &previewed(path, language)?, (&named, new::USUAL_NAME), language);
    let refused = || Unanswered::File {
        name: path_text(path),
        message: file_trouble(&std::io::ErrorKind::InvalidData.into(), language),
        is_too_large: false,
    };
    Ok(found.ok_or_else(refused)?.text)
}

/// Returns the text with its motion as a single move, which need not return to its beginning.
pub(crate) fn as_single_move(text: &str) -> Option<String> {
    edit(text, new::SINGLE_MOVE, Edit::Value("true")).ok()
}

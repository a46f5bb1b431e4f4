//! Names of files in a working folder, independent of its storage.

use axis::RECORDINGS;
use quantities::is_unseen;

/// Largest number of bytes of a name; the limit of most file systems.
const NAME_MOST: usize = 255;

/// Largest number of recordings that differ only in the number behind their name.
const LIKE_MOST: usize = 100;

/// Returns `true` if a name is that of a project file directly in the folder.
#[must_use]
pub fn is_project_name(name: &str) -> bool {
    name.len() <= NAME_MOST && name.strip_suffix(".toml").is_some_and(is_plain)
}

/// Returns the name of a project file from a typed one: trimmed, with hyphens for spaces, and with its extension.
pub(crate) fn project_name(typed: &str) -> String {
    let name = typed.split_whitespace().collect::<Vec<_>>().join("-");
    if name.is_empty() || name.ends_with(".toml") { name } else { format!("{name}.toml") }
}

/// Returns the names that a recording may have in the folder, its own first; `None` if the name is not that of a
/// recording.
#[must_use]
pub fn recording_names(name: &str) -> Option<impl Iterator<Item = String> + use<'_>> {
    let (stem, ending) = name.rsplit_once('.')?;
    if !RECORDINGS.contains(&ending.to_ascii_lowercase().as_str()) || !is_plain(stem) || name.len() > NAME_MOST - 4 {
        return None;
    }
    let like = move |turn| if turn == 1 { name.to_owned() } else { format!("{stem}-{turn}.{ending}") };
    Some((1..=LIKE_MOST).map(like))
}

/// Returns `true` if a name stays in the folder.
fn is_plain(name: &str) -> bool {
    !name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\', ':']) && !name.chars().any(is_unseen)
}

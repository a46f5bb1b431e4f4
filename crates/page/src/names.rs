//! Names of files in a working folder, the same wherever it lies.

use project::RECORDINGS;
use quantities::is_unseen;

/// Bytes of a name, as most file systems have it.
const NAME_MOST: usize = 255;

/// So many recordings may have one name and a number behind it.
const LIKE_MOST: usize = 100;

/// Whether a name is that of a project file in the folder itself.
#[must_use]
pub fn is_project_name(name: &str) -> bool {
    name.len() <= NAME_MOST && name.strip_suffix(".toml").is_some_and(is_plain)
}

/// The name of a project file as it was typed: without spaces around it, each one inside as a hyphen, and with its ending.
pub(crate) fn project_name(typed: &str) -> String {
    let name = typed.split_whitespace().collect::<Vec<_>>().join("-");
    if name.is_empty() || name.ends_with(".toml") { name } else { format!("{name}.toml") }
}

/// The names that a recording may have in the folder, its own first; none where it is no name of a recording.
#[must_use]
pub fn recording_names(name: &str) -> Option<impl Iterator<Item = String> + use<'_>> {
    let (stem, ending) = name.rsplit_once('.')?;
    if !RECORDINGS.contains(&ending.to_ascii_lowercase().as_str()) || !is_plain(stem) || name.len() > NAME_MOST - 4 {
        return None;
    }
    let like = move |turn| if turn == 1 { name.to_owned() } else { format!("{stem}-{turn}.{ending}") };
    Some((1..=LIKE_MOST).map(like))
}

/// Whether a name stays in the folder.
fn is_plain(name: &str) -> bool {
    !name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\', ':']) && !name.chars().any(is_unseen)
}

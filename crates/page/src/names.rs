//! Names of files in a working folder, independent of its storage.

use axis::{RECORDINGS, is_recording_name};
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
    let (stem, ending) = parted(name)?;
    if !is_plain(stem) || name.len() > NAME_MOST - 4 {
        return None;
    }
    let like = move |turn| if turn == 1 { name.to_owned() } else { format!("{stem}-{turn}.{ending}") };
    Some((1..=LIKE_MOST).map(like))
}

/// Splits the name of a recording before its extension, that of a packed one included: `run` and `csv.gz`.
fn parted(name: &str) -> Option<(&str, &str)> {
    is_recording_name(name).then_some(())?;
    let lower = name.to_ascii_lowercase();
    let dots = || lower.match_indices('.').map(|(place, _)| place);
    let is_ending = |place: &usize| {
        let ending = lower.get(place + 1..).unwrap_or_default().split('.').next().unwrap_or_default();
        RECORDINGS.contains(&ending)
    };
    let place = dots().rfind(is_ending)?;
    Some((name.get(..place)?, name.get(place + 1..)?))
}

/// Returns the name under which a file of any name is kept as a recording: without its folders and characters that no
/// folder takes, and with an extension, by its content if it has none.
pub(crate) fn kept_name(name: &str, bytes: &[u8]) -> String {
    let own = name.rsplit(['/', '\\']).next().unwrap_or_default().trim().trim_start_matches('.');
    let own: String = own.chars().map(|sign| if sign == ':' || is_unseen(sign) { '-' } else { sign }).collect();
    let own = if own.is_empty() { "recording".to_owned() } else { own };
    if is_recording_name(&own) {
        return own;
    }
    let ending = if bytes.starts_with(b"PAR1") { "parquet" } else { "csv" };
    format!("{own}.{ending}")
}

/// Returns `true` if a name stays in the folder.
fn is_plain(name: &str) -> bool {
    !name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\', ':']) && !name.chars().any(is_unseen)
}

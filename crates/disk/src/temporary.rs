//! Names and owner of temporary files and folders.

use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{SystemTime, UNIX_EPOCH};

/// Prefix of the names of temporary files; six characters and their check follow.
const PREFIX: &str = ".antrieb-";

/// Number of characters in the part that differs from name to name.
const DIFFERS: usize = 6;

/// Number of characters in the check.
const CHECK: usize = 8;

/// Returns a new name for a temporary file or folder: `.antrieb-3fa2b1-` and the check of the characters before it,
/// which distinguishes it from a similar name given by a user.
pub(crate) fn name() -> String {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_nanos();
    let seed = format!("{} {now} {}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
    let hash = blake3::hash(seed.as_bytes()).to_hex();
    let differs: String = hash.chars().take(DIFFERS).collect();
    format!("{PREFIX}{differs}-{}", check(&differs))
}

fn check(differs: &str) -> String {
    let hash = blake3::hash(format!("temporary file of antrieb: {differs}").as_bytes()).to_hex();
    hash.chars().take(CHECK).collect()
}

/// Returns `true` if [`name`] could have created this name.
pub(crate) fn is_name(name: &str) -> bool {
    let parts = name.strip_prefix(PREFIX).and_then(|rest| rest.split_once('-'));
    parts.is_some_and(|(differs, written)| differs.len() == DIFFERS && written == check(differs))
}

/// Returns `true` if a file or folder belongs to the user who runs the program.
#[cfg(unix)]
pub(crate) fn is_own(about: &std::fs::Metadata) -> bool {
    std::os::unix::fs::MetadataExt::uid(about) == rustix::process::geteuid().as_raw()
}

/// Returns `true`: on these systems the folder decides who may write.
#[cfg(not(unix))]
pub(crate) const fn is_own(_: &std::fs::Metadata) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_known_by_its_check() {
        let names: std::collections::BTreeSet<String> = (0..100).map(|_| name()).collect();
        assert_eq!(names.len(), 100);
        assert!(names.iter().all(|name| is_name(name)), "{names:?}");
        for strange in [".antrieb-abc123", ".antrieb-abc123-00000000", ".antrieb-notes.toml", "antrieb-abc123", ""] {
            assert!(!is_name(strange), "{strange}");
        }
    }
}

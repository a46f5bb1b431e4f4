//! Names of temporary files and folders, and the removal of those left by a killed program.

use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// Prefix of the names of temporary files; six characters and their check follow.
const PREFIX: &str = ".antrieb-";

/// Number of characters in the part that differs from name to name.
const DIFFERS: usize = 6;

/// Number of characters in the check.
const CHECK: usize = 8;

/// Time after creation within which a file being written is locked.
#[cfg(unix)]
const AGE: Duration = Duration::from_secs(60);

/// Age beyond which a file belongs to no running program on this or another machine, on systems without locks: a save
/// takes seconds.
#[cfg(not(unix))]
const AGE: Duration = Duration::from_secs(24 * 3600);

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
fn is_name(name: &str) -> bool {
    let parts = name.strip_prefix(PREFIX).and_then(|rest| rest.split_once('-'));
    parts.is_some_and(|(differs, written)| differs.len() == DIFFERS && written == check(differs))
}

/// Removes files and folders left in a folder by an interrupted save: recognised by name and owner, and no longer
/// written by any program. Errors here do not affect the save.
pub(crate) fn clear(folder: &Path) {
    let now = SystemTime::now();
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        if !entry.file_name().to_str().is_some_and(is_name) {
            continue;
        }
        // Metadata of the entry itself: a link is not followed.
        let Ok(about) = entry.metadata() else { continue };
        let age = about.modified().ok().and_then(|modified| now.duration_since(modified).ok());
        if age.is_none_or(|age| age <= AGE) || !is_own(&about) {
            continue;
        }
        if about.is_dir() {
            crate::parts::remove_left(&entry.path());
        } else if about.is_file() && is_free(&entry.path()) {
            drop(std::fs::remove_file(entry.path()));
        }
    }
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

/// Returns `true` if no running program, here or on another machine, holds the lock of a temporary file.
#[cfg(unix)]
fn is_free(path: &Path) -> bool {
    use rustix::fs::{Mode, OFlags, open};
    let flags = OFlags::RDWR | OFlags::NOFOLLOW | OFlags::CLOEXEC | OFlags::NONBLOCK;
    open(path, flags, Mode::empty()).is_ok_and(|file| std::fs::File::from(file).try_lock().is_ok())
}

#[cfg(not(unix))]
const fn is_free(_: &Path) -> bool {
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

    #[test]
    fn what_was_left_goes_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let made = |name: &str, seconds: u64| {
            let file = std::fs::File::create(folder.path().join(name)).unwrap();
            file.set_modified(SystemTime::now() - Duration::from_secs(seconds)).unwrap();
            file
        };
        let old = AGE.as_secs() + 1;
        let (fresh, left, written, named) = (name(), name(), name(), name());
        let kept = [&fresh, ".antrieb-notes.toml", ".antrieb-abc123", ".antrieb-abc123-00000000", ".other-abc123"];
        kept.iter().for_each(|name| drop(made(name, if **name == *fresh { 1 } else { 100 * old })));
        made(&left, old);
        let open = made(&written, 100 * old);
        open.try_lock().unwrap();
        std::fs::create_dir(folder.path().join(&named)).unwrap();
        clear(folder.path());
        let names = || {
            let entries = std::fs::read_dir(folder.path()).unwrap();
            entries
                .map(|entry| entry.unwrap().file_name().into_string().unwrap())
                .collect::<std::collections::BTreeSet<_>>()
        };
        let expected = |more: &[&String]| {
            kept.iter().map(|name| (*name).to_owned()).chain(more.iter().map(|name| (*name).clone())).collect()
        };
        #[cfg(unix)]
        assert_eq!(names(), expected(&[&written, &named]));
        drop(open);
        clear(folder.path());
        assert_eq!(names(), expected(&[&named]));
    }
}

//! Removal of temporary files and folders left by a killed program.

use crate::parts::remove_left;
use crate::temporary::{is_name, is_own};
use std::path::Path;
use std::time::{Duration, SystemTime};

/// Time after creation within which a file being written is locked.
#[cfg(unix)]
const AGE: Duration = Duration::from_secs(60);

/// Age beyond which a file belongs to no running program on this or another machine, on systems without locks: a save
/// takes seconds.
#[cfg(not(unix))]
const AGE: Duration = Duration::from_secs(24 * 3600);

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
            remove_left(&entry.path());
        } else if about.is_file() && is_free(&entry.path()) {
            drop(std::fs::remove_file(entry.path()));
        }
    }
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
    use crate::temporary::name;

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

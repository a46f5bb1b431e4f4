//! Temporary files that a killed program has left behind.

use std::path::Path;
use std::time::{Duration, SystemTime};

/// How the names of temporary files begin; six letters or digits follow.
pub(crate) const PREFIX: &str = ".antrieb-";

/// A save takes seconds: what is older belongs to no program that still runs, on this machine or another one.
const AGE: Duration = Duration::from_secs(24 * 3600);

/// Removes files left in a folder by an interrupted save. Errors here do not affect the save.
pub(crate) fn clear(folder: &Path) {
    let now = SystemTime::now();
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let is_ours = entry.file_name().to_str().is_some_and(is_name);
        // Of the entry itself: a link is none.
        let is_left = || {
            let about = entry.metadata().ok().filter(std::fs::Metadata::is_file)?;
            now.duration_since(about.modified().ok()?).ok()
        };
        if is_ours && is_left().is_some_and(|age| age > AGE) {
            drop(std::fs::remove_file(entry.path()));
        }
    }
}

fn is_name(name: &str) -> bool {
    let rest = name.strip_prefix(PREFIX).unwrap_or_default();
    rest.len() == 6 && rest.bytes().all(|byte| byte.is_ascii_alphanumeric())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_left_goes_and_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let made = |name: &str, hours: u64| {
            let file = std::fs::File::create(folder.path().join(name)).unwrap();
            file.set_modified(SystemTime::now() - Duration::from_secs(hours * 3600)).unwrap();
        };
        let kept = [".antrieb-new123", ".antrieb-notes.toml", ".antrieb-a b123", "antrieb-abc123", ".other-abc123"];
        kept.iter().for_each(|name| made(name, if *name == ".antrieb-new123" { 1 } else { 100 }));
        made(".antrieb-aZ09xy", 25);
        std::fs::create_dir(folder.path().join(".antrieb-folder")).unwrap();
        clear(folder.path());
        let mut left: Vec<String> = std::fs::read_dir(folder.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        left.sort();
        let mut expected: Vec<&str> = kept.iter().copied().chain([".antrieb-folder"]).collect();
        expected.sort_unstable();
        assert_eq!(left, expected);
    }

    #[test]
    fn the_names_are_those_of_the_temporary_files() {
        let file = tempfile::Builder::new().prefix(PREFIX).tempfile().unwrap();
        assert!(is_name(file.path().file_name().unwrap().to_str().unwrap()));
    }
}

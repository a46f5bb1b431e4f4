//! Files that are written: whole or not at all.

use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};
use workbench::Language;
use workbench::text::{file_trouble, terminal};

/// A file that could not be written.
#[derive(Debug)]
pub(crate) struct Unwritten {
    pub(crate) path: PathBuf,
    pub(crate) error: std::io::Error,
}

/// Writes files, each beside its place first and then renamed. Nothing is renamed before all are written. A file that
/// exists stays unless `force` says otherwise.
pub(crate) fn save(files: &[(&Path, &[u8])], force: bool) -> Result<(), Unwritten> {
    let unwritten = |path: &Path, error| Unwritten { path: path.to_owned(), error };
    let mut staged: Vec<(NamedTempFile, &Path)> = Vec::new();
    for (path, bytes) in files {
        if !force && path.exists() && !path.is_dir() {
            return Err(unwritten(path, std::io::ErrorKind::AlreadyExists.into()));
        }
        staged.push((stage(path, bytes).map_err(|error| unwritten(path, error))?, path));
    }
    for (file, path) in staged {
        let kept = if force { file.persist(path) } else { file.persist_noclobber(path) };
        kept.map_err(|fault| unwritten(path, fault.error))?;
    }
    Ok(())
}

impl Unwritten {
    /// File and trouble in one sentence.
    pub(crate) fn message(&self, language: Language) -> String {
        let what = match self.error.kind() {
            ErrorKind::NotFound | ErrorKind::NotADirectory => terminal::no_such_folder(language).to_owned(),
            ErrorKind::AlreadyExists => terminal::file_exists(language).to_owned(),
            _ => file_trouble(&self.error, language),
        };
        format!("{}: {what}", self.path.display())
    }
}

fn stage(path: &Path, bytes: &[u8]) -> std::io::Result<NamedTempFile> {
    if path.is_dir() {
        return Err(std::io::ErrorKind::IsADirectory.into());
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = Builder::new();
    builder.prefix(".antrieb-");
    readable(&mut builder);
    // What is told must be what the user named, not the name of the temporary file.
    let mut file = builder.tempfile_in(folder).map_err(|error| std::io::Error::from(error.kind()))?;
    file.write_all(bytes)?;
    file.as_file().sync_all()?;
    Ok(file)
}

/// As any other file, less what the user's mask takes away; a temporary file is private otherwise.
#[cfg(unix)]
fn readable(builder: &mut Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt;
    builder.permissions(std::fs::Permissions::from_mode(0o666));
}

#[cfg(not(unix))]
fn readable(_: &mut Builder<'_, '_>) {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.svg");
        for text in ["one", "two"] {
            save(&[(&path, text.as_bytes())], true).unwrap();
            assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn of_two_files_none_is_written_if_one_cannot_be() {
        let folder = tempfile::tempdir().unwrap();
        let (good, bad) = (folder.path().join("a.svg"), folder.path().join("none/a.png"));
        let fault = save(&[(&good, b"x"), (&bad, b"y")], true).unwrap_err();
        assert_eq!(fault.path, bad);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}

//! Reading of files: within a size limit, and for files named in a project only in permitted places.

use axis::{Files, Grant, KeptRecordings, Reach, is_referable_name};
use project::Unopened;
use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::{Path, PathBuf};

/// Reads at most `most` bytes and one more: a large file or an endless stream is not read to its end.
///
/// # Errors
/// Errors of the system.
pub fn read_within(source: impl Read, most: usize) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(most as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Opens a regular file. Other files are refused before they are opened: a pipe would block until its writer opens it, and
/// a device may never end. An entry replaced by a pipe in between does not block either.
///
/// # Errors
/// Errors of the system; [`Unopened::NoRegularFile`].
pub fn open_regular(path: &Path) -> Result<File> {
    regular(path)?;
    let file = opened(path)?;
    if file.metadata()?.is_file() { Ok(file) } else { Err(Error::other(Unopened::NoRegularFile)) }
}

#[cfg(unix)]
fn opened(path: &Path) -> Result<File> {
    use rustix::fs::{Mode, OFlags, open};
    Ok(open(path, OFlags::RDONLY | OFlags::CLOEXEC | OFlags::NONBLOCK | OFlags::NOCTTY, Mode::empty())?.into())
}

#[cfg(not(unix))]
fn opened(path: &Path) -> Result<File> {
    File::open(path)
}

/// Reads at most `most` bytes and one more of a regular file.
///
/// # Errors
/// As [`open_regular`], and errors of the system.
pub fn read_file(path: &Path, most: usize) -> Result<Vec<u8>> {
    read_within(open_regular(path)?, most)
}

/// Permitted targets of links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Links {
    /// Any target.
    Followed,
    /// Targets inside the folder only.
    Inside,
}

/// Access to the files named in a project, relative to its folder.
#[derive(Clone, Debug)]
pub struct ProjectFiles {
    /// Folder of the project.
    pub folder: PathBuf,
    /// Permitted targets of links.
    pub links: Links,
    /// Memory for all recordings of a project \[bytes\], and the permitted places of their files.
    pub grant: Grant,
}

/// [`ProjectFiles`] that keep the recordings of earlier projects.
#[derive(Debug)]
pub struct KeepingFiles {
    /// Access to the files.
    pub files: ProjectFiles,
    kept: KeptRecordings,
}

impl KeepingFiles {
    /// Creates access that keeps what is read.
    #[must_use]
    pub fn new(files: ProjectFiles) -> Self {
        Self { files, kept: KeptRecordings::default() }
    }
}

impl Files for KeepingFiles {
    fn open(&self, name: &str) -> Result<Box<dyn Read>> {
        self.files.open(name)
    }

    fn size(&self, name: &str) -> Option<u64> {
        self.files.size(name)
    }

    fn kept(&self) -> Option<&KeptRecordings> {
        Some(&self.kept)
    }

    fn grant(&self) -> Grant {
        self.files.grant()
    }
}

impl ProjectFiles {
    /// Returns the path of a regular file. Other files are refused before they are opened, because a pipe would block
    /// until its writer opens it.
    ///
    /// # Errors
    /// The obstacle; a name outside the folder counts as not found if links must stay inside.
    pub fn regular(&self, name: &str) -> Result<PathBuf> {
        let mut path = self.folder.join(name);
        if self.links == Links::Inside {
            if !Reach::Folder.admits(name) {
                return Err(ErrorKind::NotFound.into());
            }
            path = path.canonicalize()?;
            if !path.starts_with(self.folder.canonicalize()?) {
                return Err(ErrorKind::NotFound.into());
            }
        }
        regular(&path).map(|_| path)
    }

    /// Returns the path of a recording. For a remote user only files named as recordings or catalogue files are opened: a project cannot
    /// read a hidden file, a key or a note, nor through a link.
    fn recording(&self, name: &str) -> Result<PathBuf> {
        let path = self.regular(name)?;
        if self.links == Links::Inside {
            let folder = self.folder.canonicalize()?;
            let real = path.strip_prefix(&folder).ok().and_then(Path::to_str).map(|path| path.replace('\\', "/"));
            if !is_referable_name(name) || !real.is_some_and(|real| is_referable_name(&real)) {
                return Err(Error::other(Unopened::NoRecordingName));
            }
        }
        Ok(path)
    }
}

/// Returns the size of a regular file.
fn regular(path: &Path) -> Result<u64> {
    let about = path.metadata()?;
    if about.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if !about.is_file() {
        return Err(Error::other(Unopened::NoRegularFile));
    }
    Ok(about.len())
}

impl Files for ProjectFiles {
    fn open(&self, name: &str) -> Result<Box<dyn Read>> {
        Ok(Box::new(open_regular(&self.recording(name)?)?))
    }

    fn size(&self, name: &str) -> Option<u64> {
        regular(&self.recording(name).ok()?).ok()
    }

    fn grant(&self) -> Grant {
        self.grant
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn within(folder: &Path, links: Links) -> ProjectFiles {
        ProjectFiles { folder: folder.to_owned(), links, grant: Grant::default() }
    }

    #[test]
    fn so_much_is_read_and_a_byte_that_tells_of_more() {
        assert_eq!(read_within(&b"abcdef"[..], 3).unwrap(), b"abcd");
        assert_eq!(read_within(&b"abc"[..], 3).unwrap(), b"abc");
        assert_eq!(read_within(std::io::repeat(0), 10).unwrap().len(), 11);
    }

    #[cfg(unix)]
    #[test]
    fn a_folder_is_left_by_no_name_and_no_link_where_it_may_not_be() {
        use std::os::unix::fs::symlink;
        let outer = tempfile::tempdir().unwrap();
        let folder = outer.path().join("work");
        std::fs::create_dir_all(folder.join("sub")).unwrap();
        for file in [outer.path().join("far.csv"), folder.join("near.csv"), folder.join("sub/below.csv")] {
            std::fs::write(file, "x").unwrap();
        }
        symlink(outer.path().join("far.csv"), folder.join("link.csv")).unwrap();
        symlink(outer.path(), folder.join("way")).unwrap();
        symlink("sub/below.csv", folder.join("inside.csv")).unwrap();
        let inside = within(&folder, Links::Inside);
        for name in ["near.csv", "sub/below.csv", "inside.csv"] {
            assert!(inside.open(name).is_ok() && inside.size(name) == Some(1), "{name}");
        }
        let far = outer.path().join("far.csv").to_string_lossy().into_owned();
        for name in
            ["../far.csv", "sub/../../far.csv", "link.csv", "way/far.csv", "/dev/null", "/dev/zero", &far, "no.csv"]
        {
            assert!(inside.open(name).is_err() && inside.size(name).is_none(), "{name}");
        }
        let anywhere = within(&folder, Links::Followed);
        assert!(
            anywhere.open("link.csv").is_ok() && anywhere.open("../far.csv").is_ok() && anywhere.open(&far).is_ok()
        );
        assert!(anywhere.open("/dev/null").is_err(), "a device is no regular file");
        assert!(inside.open("sub").is_err() && inside.open("").is_err());
    }
}

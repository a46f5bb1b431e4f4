//! Access to a folder by its handle.
//!
//! On Unix each name is resolved in the opened folder and no link is followed, so renaming the folder cannot redirect
//! the access. On other systems names are joined to the path, and links are refused.

use crate::temporary::is_own;
use std::fs::File;
use std::io::{Error, ErrorKind, Result};
use std::path::Path;

/// An opened folder.
#[derive(Debug)]
pub(super) struct Dir {
    #[cfg(unix)]
    handle: File,
    #[cfg(not(unix))]
    path: std::path::PathBuf,
}

/// A file of the folder, by its name, that is a link, no regular file, or owned by another user.
#[derive(Debug)]
pub(super) struct Foreign(pub(super) String);

impl std::fmt::Display for Foreign {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl std::error::Error for Foreign {}

fn foreign(name: &str) -> Error {
    Error::new(ErrorKind::AlreadyExists, Foreign(name.to_owned()))
}

#[cfg(unix)]
impl Dir {
    /// Creates a folder that only the user may enter.
    pub(super) fn make(path: &Path) -> Result<()> {
        use std::os::unix::fs::DirBuilderExt;
        std::fs::DirBuilder::new().mode(0o700).create(path)
    }

    pub(super) fn open(path: &Path) -> Result<Self> {
        use rustix::fs::{Mode, OFlags, open};
        let flags = OFlags::RDONLY | OFlags::DIRECTORY | OFlags::NOFOLLOW | OFlags::CLOEXEC;
        Ok(Self { handle: open(path, flags, Mode::empty())?.into() })
    }

    /// Returns `true` if the folder belongs to the user.
    pub(super) fn is_own(&self) -> Result<bool> {
        Ok(is_own(&self.handle.metadata()?))
    }

    /// Returns `true` if the folder is still the one at a path.
    pub(super) fn is_at(&self, path: &Path) -> Result<bool> {
        use std::os::unix::fs::MetadataExt;
        let own = self.handle.metadata()?;
        Ok(path.symlink_metadata().is_ok_and(|there| (there.dev(), there.ino()) == (own.dev(), own.ino())))
    }

    /// Closes the folder to other users, if the system supports modes.
    pub(super) fn make_private(&self) {
        use std::os::unix::fs::PermissionsExt;
        drop(self.handle.set_permissions(std::fs::Permissions::from_mode(0o700)));
    }

    /// Returns `true` if a file with this name exists.
    ///
    /// # Errors
    /// The file does not belong to this program.
    pub(super) fn has(&self, name: &str) -> Result<bool> {
        use rustix::fs::{AtFlags, FileType, statat};
        match statat(&self.handle, name, AtFlags::SYMLINK_NOFOLLOW) {
            Ok(about) => {
                let is_ours = FileType::from_raw_mode(about.st_mode) == FileType::RegularFile
                    && about.st_uid == rustix::process::geteuid().as_raw();
                if is_ours { Ok(true) } else { Err(foreign(name)) }
            }
            Err(rustix::io::Errno::NOENT) => Ok(false),
            Err(error) => Err(error.into()),
        }
    }

    fn opened(&self, name: &str, more: rustix::fs::OFlags) -> Result<File> {
        use rustix::fs::{Mode, OFlags, openat};
        let flags = more | OFlags::NOFOLLOW | OFlags::CLOEXEC | OFlags::NONBLOCK;
        let file: File = match openat(&self.handle, name, flags, Mode::RUSR | Mode::WUSR) {
            Ok(file) => file.into(),
            Err(rustix::io::Errno::LOOP) => return Err(foreign(name)),
            Err(error) => return Err(error.into()),
        };
        let about = file.metadata()?;
        if about.is_file() && is_own(&about) { Ok(file) } else { Err(foreign(name)) }
    }

    /// Opens a file for reading.
    pub(super) fn open_file(&self, name: &str) -> Result<File> {
        self.opened(name, rustix::fs::OFlags::RDONLY)
    }

    /// Creates a new file.
    pub(super) fn make_file(&self, name: &str) -> Result<File> {
        use rustix::fs::OFlags;
        self.opened(name, OFlags::WRONLY | OFlags::CREATE | OFlags::EXCL)
    }

    /// Opens a file for writing, or creates it.
    pub(super) fn open_or_make(&self, name: &str) -> Result<File> {
        use rustix::fs::OFlags;
        self.opened(name, OFlags::RDWR | OFlags::CREATE)
    }

    pub(super) fn rename(&self, from: &str, to: &str) -> Result<()> {
        Ok(rustix::fs::renameat(&self.handle, from, &self.handle, to)?)
    }

    /// Removes a file if it exists.
    ///
    /// # Errors
    /// The file does not belong to this program.
    pub(super) fn remove(&self, name: &str) -> Result<()> {
        use rustix::fs::{AtFlags, unlinkat};
        if self.has(name)? {
            unlinkat(&self.handle, name, AtFlags::empty())?;
        }
        Ok(())
    }

    /// Returns the names of the entries, in order.
    pub(super) fn names(&self) -> Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in rustix::fs::Dir::read_from(&self.handle)? {
            names.extend(entry?.file_name().to_str().ok().map(str::to_owned));
        }
        names.sort();
        Ok(names)
    }
}

#[cfg(not(unix))]
impl Dir {
    /// Creates a folder.
    pub(super) fn make(path: &Path) -> Result<()> {
        std::fs::create_dir(path)
    }

    pub(super) fn open(path: &Path) -> Result<Self> {
        if !path.symlink_metadata()?.is_dir() {
            return Err(ErrorKind::NotADirectory.into());
        }
        Ok(Self { path: path.to_owned() })
    }

    /// Returns `true` if the folder belongs to the user.
    pub(super) fn is_own(&self) -> Result<bool> {
        Ok(is_own(&self.path.symlink_metadata()?))
    }

    /// Returns `true` if the path is still a folder.
    pub(super) fn is_at(&self, path: &Path) -> Result<bool> {
        Ok(path.symlink_metadata().is_ok_and(|there| there.is_dir()))
    }

    /// Does nothing: the parent folder decides who may write.
    pub(super) fn make_private(&self) {}

    /// Returns `true` if a file with this name exists.
    ///
    /// # Errors
    /// The file does not belong to this program.
    pub(super) fn has(&self, name: &str) -> Result<bool> {
        match self.path.join(name).symlink_metadata() {
            Ok(about) if about.is_file() => Ok(true),
            Ok(_) => Err(foreign(name)),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
            Err(error) => Err(error),
        }
    }

    /// Opens a file for reading.
    pub(super) fn open_file(&self, name: &str) -> Result<File> {
        if self.has(name)? { File::open(self.path.join(name)) } else { Err(ErrorKind::NotFound.into()) }
    }

    /// Creates a new file.
    pub(super) fn make_file(&self, name: &str) -> Result<File> {
        File::create_new(self.path.join(name))
    }

    /// Opens a file for writing, or creates it.
    pub(super) fn open_or_make(&self, name: &str) -> Result<File> {
        self.has(name)?;
        File::options().read(true).write(true).create(true).truncate(false).open(self.path.join(name))
    }

    pub(super) fn rename(&self, from: &str, to: &str) -> Result<()> {
        std::fs::rename(self.path.join(from), self.path.join(to))
    }

    /// Removes a file if it exists.
    ///
    /// # Errors
    /// The file does not belong to this program.
    pub(super) fn remove(&self, name: &str) -> Result<()> {
        if self.has(name)? { std::fs::remove_file(self.path.join(name)) } else { Ok(()) }
    }

    /// Returns the names of the entries, in order.
    pub(super) fn names(&self) -> Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in self.path.read_dir()? {
            names.extend(entry?.file_name().to_str().map(str::to_owned));
        }
        names.sort();
        Ok(names)
    }
}

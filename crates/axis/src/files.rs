//! Access to the files that a project refers to.

use crate::kept::KeptRecordings;
use recording::MEMORY_USUAL;
use std::io::Read;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Access to the files that a project refers to, provided by the caller.
pub trait Files {
    /// Opens a file by the name that the project gives it. A file that is not a regular one is refused, never waited
    /// for.
    ///
    /// # Errors
    /// The error of the system, or [`Unopened`](project::Unopened).
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>>;

    /// Returns its size in bytes, if that is known without reading it; a file that is too large is then not read at
    /// all.
    fn size(&self, _name: &str) -> Option<u64> {
        None
    }

    /// Returns a flag that the caller sets to cancel the reading.
    fn cancelled(&self) -> Option<Arc<AtomicBool>> {
        None
    }

    /// Returns the recordings of earlier projects, if they are kept.
    fn kept(&self) -> Option<&KeptRecordings> {
        None
    }

    /// Returns the permissions of a project.
    fn grant(&self) -> Grant {
        Grant::default()
    }
}

/// Permissions of a project for files that it refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Grant {
    /// Bytes of memory for all recordings of the project.
    pub memory: u64,
    /// Permissible folders.
    pub reach: Reach,
}

impl Default for Grant {
    /// Returns the default memory, and access to files next to the project only: a caller that serves another user
    /// decides on more.
    fn default() -> Self {
        Self { memory: MEMORY_USUAL, reach: Reach::Folder }
    }
}

/// Permissible folders of the files of a project. The name alone decides; links are resolved when the file is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// The folder of the project and those below it.
    Folder,
    /// Any folder.
    Anywhere,
}

impl Reach {
    /// Returns `true` if a name stays within. A root, a drive or a parent folder of any system is refused on all of
    /// them.
    #[must_use]
    pub fn admits(self, name: &str) -> bool {
        let is_plain = |part: &str| part != ".." && !part.contains([':', '\0']);
        self == Self::Anywhere || !name.starts_with(['/', '\\']) && name.split(['/', '\\']).all(is_plain)
    }
}

/// No access to files: a project that refers to one is refused.
#[derive(Clone, Copy, Debug)]
pub struct NoFiles;

impl Files for NoFiles {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Err(std::io::ErrorKind::Unsupported.into())
    }
}

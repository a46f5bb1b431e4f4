//! Files of this machine, for the faces: written whole or not at all, read within bounds.
//!
//! A file is written under a temporary name next to its path and then renamed ([`save`]); obstacles are reported before
//! anything is written ([`ready`]). Finished parts of a long file are kept in a marked folder next to it ([`Parts`]).
//! Only files written by this program are removed or replaced, and no link is followed. Files named in a project are
//! opened only in permitted folders ([`ProjectFiles`]).

mod left;
mod parts;
mod read;
mod save;
mod temporary;
mod unfinished;

pub use parts::{Parts, PartsTrouble};
pub use read::{KeepingFiles, Links, ProjectFiles, open_regular, read_file, read_within};
pub use save::{Unsaved, Unwritten, ready, save, save_by};
pub use unfinished::{LastWords, end};
#[cfg(unix)]
pub use unfinished::{end_on_signals, refuse_large_files};

use quantities::seen;
use std::path::Path;

/// Does nothing on systems without signals.
#[cfg(not(unix))]
pub const fn end_on_signals() {}

/// Does nothing on systems without signals.
#[cfg(not(unix))]
pub const fn refuse_large_files() {}

/// Returns a path in displayable form.
#[must_use]
pub fn path_text(path: &Path) -> String {
    seen(&path.to_string_lossy()).into_owned()
}

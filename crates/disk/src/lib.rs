//! Files of this machine, for the faces: written whole or not at all, read within bounds.
//!
//! A file that is written stands beside its place first and is then renamed ([`save`]); what is in the way is told before
//! anything is written ([`ready`]). The files that a project names are opened where they may lie ([`Beside`]).

mod left;
mod read;
mod save;
mod unfinished;

pub use read::{Beside, Links, read_within};
pub use save::{Unwritten, ready, save};
#[cfg(unix)]
pub use unfinished::end_on_signals;

use std::path::Path;
use workbench::quantities::seen;

/// Without signals there is nothing to be done.
#[cfg(not(unix))]
pub const fn end_on_signals() {}

/// A path as it may be shown.
#[must_use]
pub fn path_text(path: &Path) -> String {
    seen(&path.to_string_lossy()).into_owned()
}

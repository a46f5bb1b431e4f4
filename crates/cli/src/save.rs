//! Files that commands write, with what is in their way as an answer.

use crate::answer::Answer;
use crate::fault::{path_text, unreadable};
use std::path::{Path, PathBuf};
use workbench::Language;
use workbench::text::{SaveTrouble, save_trouble};

/// A file that could not be written.
pub(crate) struct Unwritten(disk::Unwritten);

impl Unwritten {
    /// A file whose format does not go to standard output.
    pub(crate) fn to_stdout(path: &Path) -> Self {
        Self(disk::Unwritten { path: path.to_owned(), trouble: SaveTrouble::NotToStdout })
    }

    /// The finished answer.
    pub(crate) fn answer(&self, as_json: bool, language: Language) -> Answer {
        unreadable(&path_text(&self.0.path), &save_trouble(&self.0.trouble, language), as_json, language)
    }
}

/// Writes files, all or none; a signal takes what is unfinished with it.
pub(crate) fn save(files: &[(&Path, &[u8])], inputs: &[PathBuf], force: bool) -> Result<(), Unwritten> {
    disk::end_on_signals();
    disk::save(files, inputs, force).map_err(Unwritten)
}

/// Whether files could be written there, asked before the work for them begins.
pub(crate) fn ready(files: &[&Path], inputs: &[PathBuf], force: bool) -> Result<(), Unwritten> {
    disk::ready(files, inputs, force).map_err(Unwritten)
}

//! Files that commands write, and the errors in writing them.

use crate::fault::path_text;
use quantities::Language;
use questions::list::Unanswered;
use std::path::{Path, PathBuf};
use words::{SaveTrouble, save_trouble};

/// Returns the message about a file that could not be written.
fn unwritten(unwritten: &disk::Unwritten, language: Language) -> Unanswered {
    let message = save_trouble(&unwritten.trouble, language);
    Unanswered::File { name: path_text(&unwritten.path), message, is_too_large: false }
}

/// Returns the message about a file whose format cannot go to standard output.
pub(crate) fn not_to_stdout(path: &Path, language: Language) -> Unanswered {
    unwritten(&disk::Unwritten { path: path.to_owned(), trouble: SaveTrouble::NotToStdout }, language)
}

/// Writer of the files of a call.
pub(crate) struct Saver {
    /// Files that are read and must not be written.
    pub(crate) inputs: Vec<PathBuf>,
    /// Replaces an existing file.
    pub(crate) force: bool,
    pub(crate) language: Language,
}

impl Saver {
    /// Writes files, all or none; a signal removes unfinished ones.
    pub(crate) fn save(&self, files: &[(&Path, &[u8])]) -> Result<(), Unanswered> {
        disk::end_on_signals();
        disk::save(files, &self.inputs, self.force).map_err(|why| unwritten(&why, self.language))
    }

    /// Writes a file piece by piece.
    pub(crate) fn save_by(
        &self,
        file: &Path,
        write: impl FnOnce(&mut std::fs::File) -> Result<(), Unanswered>,
    ) -> Result<(), Unanswered> {
        disk::end_on_signals();
        disk::save_by(file, &self.inputs, self.force, write).map_err(|why| match why {
            disk::Unsaved::Unwritten(why) => unwritten(&why, self.language),
            disk::Unsaved::Other(why) => why,
        })
    }

    /// Checks that files can be written, before they are computed.
    pub(crate) fn ready(&self, files: &[&Path]) -> Result<(), Unanswered> {
        disk::ready(files, &self.inputs, self.force).map_err(|why| unwritten(&why, self.language))
    }
}

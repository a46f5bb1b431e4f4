//! Files that commands write, with what is in their way.

use crate::fault::path_text;
use quantities::Language;
use questions::list::Unanswered;
use std::path::{Path, PathBuf};
use words::{SaveTrouble, save_trouble};

/// A file that could not be written.
fn unwritten(unwritten: &disk::Unwritten, language: Language) -> Unanswered {
    let message = save_trouble(&unwritten.trouble, language);
    Unanswered::File { name: path_text(&unwritten.path), message, is_too_large: false }
}

/// A file whose format does not go to standard output.
pub(crate) fn not_to_stdout(path: &Path, language: Language) -> Unanswered {
    unwritten(&disk::Unwritten { path: path.to_owned(), trouble: SaveTrouble::NotToStdout }, language)
}

/// What a call writes, and where not.
pub(crate) struct Desk<'c> {
    /// The files that are read: none of them is written.
    pub(crate) inputs: &'c [PathBuf],
    /// Whether a file that exists is replaced.
    pub(crate) force: bool,
    pub(crate) language: Language,
}

impl Desk<'_> {
    /// Writes files, all or none; a signal takes what is unfinished with it.
    pub(crate) fn save(&self, files: &[(&Path, &[u8])]) -> Result<(), Unanswered> {
        disk::end_on_signals();
        disk::save(files, self.inputs, self.force).map_err(|why| unwritten(&why, self.language))
    }

    /// Writes a file piece by piece.
    pub(crate) fn save_by(
        &self,
        file: &Path,
        write: impl FnOnce(&mut std::fs::File) -> Result<(), Unanswered>,
    ) -> Result<(), Unanswered> {
        disk::end_on_signals();
        disk::save_by(file, self.inputs, self.force, write).map_err(|why| match why {
            disk::Unsaved::Unwritten(why) => unwritten(&why, self.language),
            disk::Unsaved::Other(why) => why,
        })
    }

    /// Whether files could be written there, before the work for them begins.
    pub(crate) fn ready(&self, files: &[&Path]) -> Result<(), Unanswered> {
        disk::ready(files, self.inputs, self.force).map_err(|why| unwritten(&why, self.language))
    }
}

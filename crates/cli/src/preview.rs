//! The beginning of a recording that no project names yet.

use crate::fault::path_text;
use crate::waiting::progress;
use axis::{Files, Grant, Reach};
use quantities::Language;
use questions::Preview;
use questions::list::{Unanswered, new};
use std::io::Read;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use words::{FaultWords as _, file_trouble};

/// Returns the columns of a file and, of a text, its first rows. Its rest is not read.
///
/// # Errors
/// Errors of the system; every reason why the file is no recording.
pub(crate) fn previewed(path: &Path, language: Language) -> Result<Preview, Unanswered> {
    let name = path_text(path);
    let opened = disk::open_regular(path).map(drop);
    opened.map_err(|error| Unanswered::File {
        name: name.clone(),
        message: file_trouble(&error, language),
        is_too_large: false,
    })?;
    new::previewed(&name, &OneFile(path)).map_err(|faults| {
        Unanswered::combined(faults.iter().map(|fault| Unanswered::message(fault.text(language))).collect())
    })
}

/// A file that the call names, under any name.
struct OneFile<'p>(&'p Path);

impl Files for OneFile<'_> {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(disk::open_regular(self.0)?))
    }

    fn size(&self, _: &str) -> Option<u64> {
        self.0.metadata().ok().map(|about| about.len())
    }

    fn cancelled(&self) -> Option<Arc<AtomicBool>> {
        Some(progress().flag())
    }

    fn grant(&self) -> Grant {
        Grant { reach: Reach::Anywhere, ..Grant::default() }
    }
}

//! Recordings that a project of Python holds itself, beside the files of its folder.

use axis::{Files, Grant};
use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Content of recordings by the names that a project gives them.
pub type Recordings = Arc<BTreeMap<String, Arc<[u8]>>>;

/// Recordings that are held in memory; other names are those of files.
#[derive(Clone, Debug)]
pub struct HeldFiles<F> {
    /// Content by name.
    pub recordings: Recordings,
    /// Files under all other names.
    pub files: F,
}

impl<F: Files> Files for HeldFiles<F> {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        match self.recordings.get(name) {
            Some(content) => Ok(Box::new(Cursor::new(Arc::clone(content)))),
            None => self.files.open(name),
        }
    }

    fn size(&self, name: &str) -> Option<u64> {
        self.recordings.get(name).map_or_else(|| self.files.size(name), |content| Some(content.len() as u64))
    }

    fn cancelled(&self) -> Option<Arc<AtomicBool>> {
        self.files.cancelled()
    }

    fn grant(&self) -> Grant {
        self.files.grant()
    }
}

//! Working folder in memory, with the files stored in the browser.

use axis::{Catalogue, Files};
use page::{FileEntry, Folder, SaveFault, Shell, Storage, is_project_name, recording_names};
use project::PROJECT_MAX_BYTES;
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::io::{Cursor, ErrorKind, Read, Result};
use std::rc::Rc;
use std::sync::Arc;

/// Seconds of a day.
const DAY_S: u64 = 86_400;

/// A file.
struct Held {
    bytes: Rc<[u8]>,
    modified_s: u64,
    is_parquet: bool,
}

/// Project files and their recordings.
#[derive(Default)]
pub struct Store {
    files: RefCell<BTreeMap<String, Held>>,
    /// The file written since the last query.
    written: RefCell<Option<String>>,
    now_s: Cell<u64>,
}

impl Store {
    /// Adds a file of the browser.
    pub fn insert(&self, name: &str, bytes: &[u8], modified_s: u64) {
        let bytes: Rc<[u8]> = bytes.into();
        let is_parquet = axis::is_parquet(Box::new(Cursor::new(Rc::clone(&bytes))));
        let _ = self.files.borrow_mut().insert(name.to_owned(), Held { bytes, modified_s, is_parquet });
    }

    /// Removes a file.
    pub fn remove(&self, name: &str) {
        let _ = self.files.borrow_mut().remove(name);
    }

    /// Returns the bytes of a file.
    #[must_use]
    pub fn bytes(&self, name: &str) -> Option<Rc<[u8]>> {
        self.files.borrow().get(name).map(|file| Rc::clone(&file.bytes))
    }

    /// Returns true if a file is a recording in Parquet, packed or not.
    #[must_use]
    pub fn has_parquet(&self) -> bool {
        self.files.borrow().values().any(|file| file.is_parquet)
    }

    /// Returns the file written since the last query.
    pub fn written(&self) -> Option<String> {
        self.written.take()
    }

    /// Sets the current time in seconds since 1970.
    pub fn is_now(&self, now_s: u64) {
        self.now_s.set(now_s);
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        self.insert(name, bytes, self.now_s.get());
        *self.written.borrow_mut() = Some(name.to_owned());
    }
}

impl Files for Store {
    fn open(&self, name: &str) -> Result<Box<dyn Read>> {
        Ok(Box::new(Cursor::new(self.bytes(name).ok_or(ErrorKind::NotFound)?)))
    }

    fn size(&self, name: &str) -> Option<u64> {
        self.bytes(name).map(|bytes| bytes.len() as u64)
    }
}

impl Folder for Store {
    fn place(&self) -> Storage {
        Storage::Browser
    }

    fn list(&self) -> Result<Vec<FileEntry>> {
        let files = self.files.borrow();
        let projects = files.iter().filter(|(name, _)| is_project_name(name));
        let mut found: Vec<FileEntry> =
            projects.map(|(name, file)| FileEntry { name: name.clone(), modified_s: file.modified_s }).collect();
        found.sort_by(|a, b| b.modified_s.cmp(&a.modified_s).then_with(|| a.name.cmp(&b.name)));
        Ok(found)
    }

    fn read(&self, name: &str) -> Result<Vec<u8>> {
        let bytes = self.bytes(name).filter(|_| is_project_name(name)).ok_or(ErrorKind::NotFound)?;
        Ok(bytes.to_vec())
    }

    fn save(&self, name: &str, text: &[u8], known: Option<&str>) -> std::result::Result<(), SaveFault> {
        if !is_project_name(name) {
            return Err(SaveFault::Name);
        }
        if text.len() > PROJECT_MAX_BYTES {
            return Err(SaveFault::Disk(ErrorKind::FileTooLarge.into()));
        }
        let there = self.bytes(name).map(|bytes| self.version(&bytes));
        if there.as_deref() != known {
            return Err(SaveFault::Changed);
        }
        self.write(name, text);
        Ok(())
    }

    fn keep(&self, name: &str, bytes: &[u8]) -> std::result::Result<String, SaveFault> {
        for name in recording_names(name).ok_or(SaveFault::Name)? {
            match self.bytes(&name) {
                None => {
                    self.write(&name, bytes);
                    return Ok(name);
                }
                // A recording that already exists is not stored again.
                Some(there) if *there == *bytes => return Ok(name),
                Some(_) => {}
            }
        }
        Err(SaveFault::Disk(ErrorKind::AlreadyExists.into()))
    }
}

impl Shell for Store {
    fn files(&self) -> &dyn Files {
        self
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn days_since_1970(&self) -> Option<u64> {
        Some(self.now_s.get() / DAY_S)
    }

    fn folder(&self) -> Option<&dyn Folder> {
        Some(self)
    }

    fn version(&self, bytes: &[u8]) -> String {
        blake3::hash(bytes).to_hex().to_string()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails loudly")]

    use super::*;

    #[test]
    fn names_are_held_to_the_same_as_on_a_disk() {
        let store = Store::default();
        for name in ["a.csv", "../a.toml", ".a.toml", "a/b.toml", "", ".toml", "C:a.toml", "a\u{202e}.toml"] {
            assert!(matches!(store.save(name, b"", None), Err(SaveFault::Name)), "{name}");
        }
        for name in ["a.toml", "../a.csv", ".csv", "a.exe"] {
            assert!(matches!(store.keep(name, b""), Err(SaveFault::Name)), "{name}");
        }
        assert_eq!(store.keep("a.csv", b"1").unwrap(), "a.csv");
        assert_eq!(store.keep("a.csv", b"2").unwrap(), "a-2.csv");
        assert_eq!(store.keep("a.csv", b"1").unwrap(), "a.csv");
        assert!(store.list().unwrap().is_empty() && store.read("a.csv").is_err(), "a recording is no project");
        let large = vec![b'#'; PROJECT_MAX_BYTES + 1];
        assert!(matches!(store.save("a.toml", &large, None), Err(SaveFault::Disk(_))));
    }

    #[test]
    fn a_name_that_is_taken_is_not_written_over() {
        let store = Store::default();
        store.save("a.toml", b"one", None).unwrap();
        assert!(matches!(store.save("a.toml", b"two", None), Err(SaveFault::Changed)));
        let known = store.version(b"one");
        store.save("a.toml", b"two", Some(&known)).unwrap();
        assert!(matches!(store.save("a.toml", b"three", Some(&known)), Err(SaveFault::Changed)));
        store.remove("a.toml");
        assert!(matches!(store.save("a.toml", b"three", Some(&store.version(b"two"))), Err(SaveFault::Changed)));
        store.save("b.toml", b"x", None).unwrap();
        store.insert("c.toml", b"x", 7);
        let names: Vec<_> = store.list().unwrap().into_iter().map(|entry| entry.name).collect();
        assert_eq!(names, ["c.toml", "b.toml"]);
    }
}

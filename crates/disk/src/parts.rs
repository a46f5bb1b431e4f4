//! A folder beside a file in which finished parts of it are kept until the file is whole.
//!
//! The folder is made by this program, bears its mark and belongs to the user who runs it; any other one is left as it is. While
//! it is open it is locked. Files in it are made new, opened without following links and removed only if this program named and
//! wrote them: the folder is addressed by its handle, so what becomes of its name does not matter.

mod dir;

use crate::left;
use dir::Dir;
use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The file whose lock is that of the folder.
const LOCK: &str = "lock";

/// The file by which the folder is known, and which says to what its parts belong.
const MARK: &str = "sweep";

/// First line of the mark.
const TITLE: &str = "parts of an unfinished file of antrieb, removed when it is whole";

/// Behind the name of a file that is not whole.
const UNFINISHED: &str = ".unfinished";

/// The folder of the parts of a file, locked as long as this value lives.
#[derive(Debug)]
pub struct Parts {
    path: PathBuf,
    dir: Dir,
    /// To what the parts belong.
    mark: String,
    _lock: File,
}

/// Why a folder of parts cannot be used.
#[derive(Debug)]
pub enum PartsTrouble {
    /// Something of this name is there that this program did not make.
    Foreign,
    /// A file in it has a name of this program, and is a link or belongs to another user.
    ForeignFile(String),
    /// Another run has it open.
    Busy,
    /// Error of the system.
    System(Error),
}

impl From<Error> for PartsTrouble {
    fn from(error: Error) -> Self {
        let foreign = error.get_ref().and_then(|inner| inner.downcast_ref::<dir::Foreign>());
        match foreign {
            Some(dir::Foreign(name)) => Self::ForeignFile(name.clone()),
            None => Self::System(error),
        }
    }
}

/// How often a folder is looked at that comes and goes, and how long after each other.
const TRIES: usize = 8;
const PAUSE: Duration = Duration::from_millis(5);

impl Parts {
    /// Opens the folder of this program at a path, or makes it. Its parts are those that the last mark speaks of.
    ///
    /// # Errors
    /// [`PartsTrouble`]; then nothing is changed.
    pub fn open(path: &Path) -> std::result::Result<Self, PartsTrouble> {
        let mut trouble = PartsTrouble::Busy;
        for _ in 0..TRIES {
            match path.symlink_metadata() {
                Ok(_) => match Self::known(path) {
                    Ok(parts) => return Ok(parts),
                    Err(Some(PartsTrouble::Foreign)) => trouble = PartsTrouble::Foreign,
                    Err(Some(other)) => return Err(other),
                    Err(None) => {}
                },
                Err(error) if error.kind() == ErrorKind::NotFound => {
                    make(path)?;
                    continue;
                }
                Err(error) => return Err(error.into()),
            }
            // Another run may be removing it at this moment: its mark goes first.
            std::thread::sleep(PAUSE);
        }
        Err(trouble)
    }

    /// Opens the folder that is there; no trouble where it has just gone.
    fn known(path: &Path) -> std::result::Result<Self, Option<PartsTrouble>> {
        let system = |error: Error| match error.kind() {
            ErrorKind::NotFound => None,
            _ => Some(error.into()),
        };
        if path.symlink_metadata().map_err(system)?.is_dir() {
            let dir = Dir::open(path).map_err(system)?;
            if dir.is_own().map_err(system)? && mark(&dir).map_err(system)?.is_some() {
                return Self::locked(path, dir).map_err(|trouble| match trouble {
                    PartsTrouble::System(error) => system(error),
                    other => Some(other),
                });
            }
        }
        Err(Some(PartsTrouble::Foreign))
    }

    /// Locks an opened folder that bears the mark.
    fn locked(path: &Path, dir: Dir) -> std::result::Result<Self, PartsTrouble> {
        let lock = dir.open_or_make(LOCK)?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(std::fs::TryLockError::WouldBlock) => return Err(PartsTrouble::Busy),
            Err(std::fs::TryLockError::Error(error)) => return Err(error.into()),
        }
        // What was locked may be what the last run was just removing.
        match mark(&dir)? {
            Some(mark) if dir.has(LOCK)? && dir.is_at(path)? => {
                dir.make_private();
                Ok(Self { path: path.to_owned(), dir, mark, _lock: lock })
            }
            Some(_) => Err(Error::from(ErrorKind::NotFound).into()),
            None => {
                drop(dir.remove(LOCK));
                drop(std::fs::remove_dir(path));
                Err(Error::from(ErrorKind::NotFound).into())
            }
        }
    }

    /// To what the parts belong that are there; empty in a new folder.
    #[must_use]
    pub fn mark(&self) -> &str {
        &self.mark
    }

    /// Removes the parts that are there and notes to what those belong that will come.
    ///
    /// # Errors
    /// Of the system; a file with the name of a part that this program did not write.
    pub fn begin(&mut self, mark: &str) -> std::result::Result<(), PartsTrouble> {
        for name in self.dir.names()?.iter().filter(|name| is_part(name)) {
            self.dir.remove(name)?;
        }
        put(&self.dir, MARK, written(mark).as_bytes())?;
        mark.clone_into(&mut self.mark);
        Ok(())
    }

    /// Whether the folder still bears its mark.
    ///
    /// # Errors
    /// Of the system.
    pub fn is_marked(&self) -> std::result::Result<bool, PartsTrouble> {
        Ok(mark(&self.dir)?.is_some_and(|found| found == self.mark) && self.dir.is_at(&self.path)?)
    }

    /// Whether there is a part.
    ///
    /// # Errors
    /// Of the system; a file with the name of a part that this program did not write.
    pub fn has(&self, index: u64) -> std::result::Result<bool, PartsTrouble> {
        Ok(self.dir.has(&name(index))?)
    }

    /// Writes a part, whole or not at all.
    ///
    /// # Errors
    /// Of the system.
    pub fn put(&self, index: u64, bytes: &[u8]) -> std::result::Result<(), PartsTrouble> {
        Ok(put(&self.dir, &name(index), bytes)?)
    }

    /// Opens a part.
    ///
    /// # Errors
    /// Of the system.
    pub fn part(&self, index: u64) -> std::result::Result<File, PartsTrouble> {
        Ok(self.dir.open_file(&name(index))?)
    }

    /// Removes the parts and the folder; a file that another hand put there stays, and the folder with it.
    pub fn remove(self) {
        empty(&self.dir);
        // Only an empty folder goes.
        drop(std::fs::remove_dir(&self.path));
    }
}

/// Makes a folder with a mark: under another name until it has it, so that none without stands at the path.
fn make(path: &Path) -> Result<()> {
    let beside = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let temporary = beside.join(left::name());
    Dir::make(&temporary)?;
    let marked = Dir::open(&temporary).and_then(|dir| put(&dir, MARK, written("").as_bytes()));
    // A folder replaces an empty one only: where another run was quicker this fails, and its folder is taken.
    let placed = marked.and_then(|()| match path.symlink_metadata() {
        Ok(_) => Err(ErrorKind::AlreadyExists.into()),
        Err(_) => std::fs::rename(&temporary, path),
    });
    if placed.is_err() {
        remove_left(&temporary);
    }
    placed.or_else(|error| if path.symlink_metadata().is_ok() { Ok(()) } else { Err(error) })
}

/// The name of a part.
fn name(index: u64) -> String {
    format!("part-{index:08}.parquet")
}

fn is_part(name: &str) -> bool {
    let whole = name.strip_suffix(UNFINISHED).unwrap_or(name);
    let number = whole.strip_prefix("part-").and_then(|rest| rest.strip_suffix(".parquet"));
    number.is_some_and(|number| number.len() >= 8 && number.bytes().all(|byte| byte.is_ascii_digit()))
}

/// The mark as it is written.
fn written(mark: &str) -> String {
    format!("{TITLE}\n{mark}\n")
}

/// The mark of a folder; `None` where it has none.
fn mark(dir: &Dir) -> Result<Option<String>> {
    if !dir.has(MARK)? {
        return Ok(None);
    }
    let mut text = String::new();
    match dir.open_file(MARK)?.take(1 << 12).read_to_string(&mut text) {
        Ok(_) => {}
        Err(error) if error.kind() == ErrorKind::InvalidData => return Ok(None),
        Err(error) => return Err(error),
    }
    Ok(text.strip_prefix(TITLE).map(|mark| mark.trim().to_owned()))
}

/// Writes a file of a folder whole: under another name first.
fn put(dir: &Dir, name: &str, bytes: &[u8]) -> Result<()> {
    let unfinished = format!("{name}{UNFINISHED}");
    dir.remove(&unfinished)?;
    let written = (|| {
        let mut file = dir.make_file(&unfinished)?;
        file.write_all(bytes)?;
        file.sync_data()?;
        // A file of this name is replaced only if it is ours.
        dir.has(name)?;
        dir.rename(&unfinished, name)
    })();
    if written.is_err() {
        drop(dir.remove(&unfinished));
    }
    written
}

/// Removes all files that this program wrote into a folder, the lock last.
fn empty(dir: &Dir) {
    let names = dir.names().unwrap_or_default();
    let of_mark = |name: &str| name.strip_suffix(UNFINISHED).unwrap_or(name) == MARK;
    for name in names.iter().filter(|name| is_part(name)).chain(names.iter().filter(|name| of_mark(name))) {
        drop(dir.remove(name));
    }
    drop(dir.remove(LOCK));
}

/// Removes a folder that was not yet in its place when its run ended, if no run has it open.
pub(crate) fn remove_left(path: &Path) {
    let Ok(dir) = Dir::open(path) else { return };
    let is_free = match dir.has(LOCK) {
        Ok(true) => dir.open_or_make(LOCK).is_ok_and(|lock| lock.try_lock().is_ok()),
        Ok(false) => true,
        Err(_) => false,
    };
    if is_free && dir.is_own().unwrap_or(false) {
        empty(&dir);
        drop(std::fs::remove_dir(path));
    }
}

#[cfg(test)]
mod tests;

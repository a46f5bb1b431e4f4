//! A folder next to a file that holds its finished parts until the file is complete.
//!
//! The folder is created by this program, contains its mark and belongs to the user who runs it; any other folder is
//! left unchanged. It is locked while open. Files in it are newly created, opened without following links and removed
//! only if this program named and wrote them. The folder is addressed by its handle, so renaming it has no effect.

mod dir;

use crate::temporary;
use dir::Dir;
use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// File whose lock protects the folder.
const LOCK: &str = "lock";

/// File that identifies the folder and states the file that its parts belong to.
const MARK: &str = "sweep";

/// First line of the mark.
const TITLE: &str = "parts of an unfinished file of antrieb, removed when it is whole";

/// Suffix of a file that is not complete.
const UNFINISHED: &str = ".unfinished";

/// The folder of the parts of a file, locked as long as this value exists.
#[derive(Debug)]
pub struct Parts {
    path: PathBuf,
    dir: Dir,
    /// Identification of the run that the parts belong to.
    mark: String,
    _lock: File,
}

/// Reason why a folder of parts cannot be used.
#[derive(Debug)]
pub enum PartsTrouble {
    /// The name is in use by something that this program did not create.
    Foreign,
    /// A file in it has a name of this program, but is a link or belongs to another user.
    ForeignFile(String),
    /// Another run has the folder open.
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

/// Number of attempts to open a folder that other runs create and remove at the same time, and the pause between them.
const TRIES: usize = 8;
const PAUSE: Duration = Duration::from_millis(5);

impl Parts {
    /// Opens the folder of this program at a path, or creates it. Its parts are those of the last mark.
    ///
    /// # Errors
    /// [`PartsTrouble`]; nothing is changed then.
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
            // Another run may be removing it at this moment, starting with its mark.
            std::thread::sleep(PAUSE);
        }
        Err(trouble)
    }

    /// Opens an existing folder; returns `Err(None)` if it has just been removed.
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

    /// Locks an opened folder that contains the mark.
    fn locked(path: &Path, dir: Dir) -> std::result::Result<Self, PartsTrouble> {
        let lock = dir.open_or_make(LOCK)?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(std::fs::TryLockError::WouldBlock) => return Err(PartsTrouble::Busy),
            Err(std::fs::TryLockError::Error(error)) => return Err(error.into()),
        }
        // The locked folder may just have been removed by the last run.
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

    /// Returns the mark of the existing parts; empty in a new folder.
    #[must_use]
    pub fn mark(&self) -> &str {
        &self.mark
    }

    /// Removes the existing parts and writes the mark of the following ones.
    ///
    /// # Errors
    /// Errors of the system; a file with the name of a part that this program did not write.
    pub fn begin(&mut self, mark: &str) -> std::result::Result<(), PartsTrouble> {
        for name in &own_parts(&self.dir)? {
            self.dir.remove(name)?;
        }
        write_whole(&self.dir, MARK, written(mark).as_bytes())?;
        mark.clone_into(&mut self.mark);
        Ok(())
    }

    /// Returns `true` if the folder still has its mark.
    ///
    /// # Errors
    /// Errors of the system.
    pub fn is_marked(&self) -> std::result::Result<bool, PartsTrouble> {
        Ok(mark(&self.dir)?.is_some_and(|found| found == self.mark) && self.dir.is_at(&self.path)?)
    }

    /// Returns `true` if a part exists.
    ///
    /// # Errors
    /// Errors of the system; a file with the name of a part that this program did not write.
    pub fn has(&self, index: u64) -> std::result::Result<bool, PartsTrouble> {
        Ok(self.dir.has(&name(index))?)
    }

    /// Returns `true` if a part exists, complete and of this run: its checksum, over the mark, its number and its content,
    /// is the one stored with it. A part that a power failure has cut off, or that was copied from elsewhere, has another.
    ///
    /// # Errors
    /// Errors of the system; a file with the name of a part that this program did not write.
    pub fn holds(&self, index: u64) -> std::result::Result<bool, PartsTrouble> {
        let Some(stored) = stored(&self.dir, index)? else { return Ok(false) };
        if !self.dir.has(&name(index))? {
            return Ok(false);
        }
        let file = self.dir.open_file(&name(index))?;
        // A part of another length is not read: a sparse file may have any.
        if file.metadata()?.len() != stored.length {
            return Ok(false);
        }
        let mut sum = self.sum(index);
        let (mut file, mut piece) = (file.take(stored.length), vec![0; 1 << 16]);
        loop {
            match file.read(&mut piece)? {
                0 => break,
                length => sum.update(piece.get(..length).unwrap_or_default()),
            };
        }
        Ok(sum.finalize().to_hex().as_str() == stored.sum)
    }

    /// Returns the checksum of a part before its content.
    fn sum(&self, index: u64) -> blake3::Hasher {
        let mut sum = blake3::Hasher::new();
        sum.update(written(&self.mark).as_bytes()).update(&index.to_le_bytes());
        sum
    }

    /// Writes a part with its checksum, completely or not at all.
    ///
    /// # Errors
    /// Errors of the system; a file with the name of the part that this program did not write.
    pub fn write(&self, index: u64, bytes: &[u8]) -> std::result::Result<(), PartsTrouble> {
        if self.dir.has(&name(index))? && !self.dir.has(&sum_name(index))? {
            return Err(PartsTrouble::ForeignFile(name(index)));
        }
        let sum = self.sum(index).update(bytes).finalize().to_hex();
        write_whole(&self.dir, &sum_name(index), format!("{sum} {}", bytes.len()).as_bytes())?;
        Ok(write_whole(&self.dir, &name(index), bytes)?)
    }

    /// Opens a part.
    ///
    /// # Errors
    /// Errors of the system.
    pub fn part(&self, index: u64) -> std::result::Result<File, PartsTrouble> {
        Ok(self.dir.open_file(&name(index))?)
    }

    /// Removes the parts and the folder; a file not written by this program stays, and the folder with it.
    pub fn remove(self) {
        empty(&self.dir);
        // Only an empty folder is removed.
        drop(std::fs::remove_dir(&self.path));
    }
}

/// Creates a folder with a mark, under a temporary name first, so that no folder without a mark exists at the path.
fn make(path: &Path) -> Result<()> {
    let beside = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let temporary = beside.join(temporary::name());
    Dir::make(&temporary)?;
    let marked = Dir::open(&temporary).and_then(|dir| write_whole(&dir, MARK, written("").as_bytes()));
    // Renaming replaces an empty folder only. If another run was faster, its folder is looked at by the next attempt,
    // even if it has been removed again by then.
    let placed = marked.and_then(|()| match path.symlink_metadata() {
        Ok(_) => Err(ErrorKind::AlreadyExists.into()),
        Err(_) => std::fs::rename(&temporary, path),
    });
    placed.or_else(|error| {
        remove_left(&temporary);
        let is_taken = matches!(error.kind(), ErrorKind::AlreadyExists | ErrorKind::DirectoryNotEmpty);
        if is_taken || path.symlink_metadata().is_ok() { Ok(()) } else { Err(error) }
    })
}

/// Returns the file name of a part.
fn name(index: u64) -> String {
    format!("part-{index:08}.parquet")
}

/// Returns the file name of the checksum of a part.
fn sum_name(index: u64) -> String {
    format!("part-{index:08}.blake3")
}

/// Checksum and length of a part, as stored next to it.
struct Stored {
    sum: String,
    length: u64,
}

/// Returns the stored checksum of a part; `None` without one, or if it is damaged.
fn stored(dir: &Dir, index: u64) -> Result<Option<Stored>> {
    if !dir.has(&sum_name(index))? {
        return Ok(None);
    }
    let mut text = Vec::new();
    dir.open_file(&sum_name(index))?.take(1 << 8).read_to_end(&mut text)?;
    let read = || {
        let (sum, length) = std::str::from_utf8(&text).ok()?.split_once(' ')?;
        let is_sum = sum.len() == 64 && sum.bytes().all(|byte| byte.is_ascii_hexdigit());
        Some(Stored { sum: sum.to_owned(), length: length.parse().ok().filter(|_| is_sum)? })
    };
    Ok(read())
}

/// Returns the index in the name of a part or of its checksum.
fn index_of(name: &str) -> Option<u64> {
    let number = name.strip_prefix("part-")?;
    let number = number.strip_suffix(".parquet").or_else(|| number.strip_suffix(".blake3"))?;
    let is_index = number.len() >= 8 && number.bytes().all(|byte| byte.is_ascii_digit());
    number.parse().ok().filter(|_| is_index)
}

/// Returns the names of the parts in a folder that this program wrote, and of their checksums, the checksums last: a part
/// without its checksum is of another hand. An unfinished checksum is known by its name alone.
fn own_parts(dir: &Dir) -> Result<Vec<String>> {
    let mut own: [Vec<String>; 2] = Default::default();
    for found in dir.names()? {
        let whole = found.strip_suffix(UNFINISHED).unwrap_or(&found);
        let Some(index) = index_of(whole) else { continue };
        let is_sum = whole == sum_name(index);
        let is_own = is_sum && whole != found || dir.has(&sum_name(index)).unwrap_or(false);
        if is_own && (is_sum || whole == name(index)) {
            let [parts, sums] = &mut own;
            if is_sum { sums.push(found) } else { parts.push(found) }
        }
    }
    Ok(own.concat())
}

/// Returns the content of the mark file.
fn written(mark: &str) -> String {
    format!("{TITLE}\n{mark}\n")
}

/// Returns the mark of a folder; `None` if it has none.
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

/// Writes a complete file in a folder, under a temporary name first.
fn write_whole(dir: &Dir, name: &str, bytes: &[u8]) -> Result<()> {
    let unfinished = format!("{name}{UNFINISHED}");
    dir.remove(&unfinished)?;
    let written = (|| {
        let mut file = dir.make_file(&unfinished)?;
        file.write_all(bytes)?;
        file.sync_data()?;
        // A file with this name is replaced only if it belongs to this program.
        dir.has(name)?;
        dir.rename(&unfinished, name)
    })();
    if written.is_err() {
        drop(dir.remove(&unfinished));
    }
    written
}

/// Removes the files in a folder that this program wrote, the lock last.
fn empty(dir: &Dir) {
    let names = dir.names().unwrap_or_default();
    let of_mark = |name: &str| name.strip_suffix(UNFINISHED).unwrap_or(name) == MARK;
    let parts = own_parts(dir).unwrap_or_default();
    for name in parts.iter().chain(names.iter().filter(|name| of_mark(name))) {
        drop(dir.remove(name));
    }
    drop(dir.remove(LOCK));
}

/// Removes a folder that was not in place yet when its run ended, if no run has it open.
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

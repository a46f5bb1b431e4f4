//! How much of a file is read: every size that a file may claim has its bound here.

use crate::faults::Fault;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Largest file that is read, in bytes.
pub const FILE_BYTES_MAX: u64 = 1 << 30;

/// Memory that all recordings of a project may take, unless it is said otherwise: 512 MiB.
pub const MEMORY_USUAL: u64 = 512 << 20;

/// Most samples that are kept: 2²⁴, more than four hours at 1 kHz.
pub const SAMPLES_MAX: usize = 1 << 24;

/// Fewest samples that make a recording: two intervals, so that there is a change of speed.
pub(crate) const SAMPLES_MIN: usize = 3;

/// Most rows that are looked at, kept or outside the window: 2²⁶, eighteen hours at 1 kHz.
pub(crate) const ROWS_MAX: u64 = 1 << 26;

/// Most columns of a file; more than any logger has channels.
pub(crate) const COLUMNS_MAX: usize = 10_000;

/// Columns of a table of many axes; no project has so many keys.
pub const TABLE_COLUMNS_MAX: u64 = 1000;

/// Rows of a table whatever its size.
pub(crate) const TABLE_ROWS_FREE: u64 = 1 << 20;

/// Rows of a larger table for each of its bytes: more are made up of nothing.
pub(crate) const TABLE_ROWS_PER_BYTE: u64 = 256;

/// Most bytes in one line of a CSV, 64 KiB: bounds its text buffer.
pub const LINE_BYTES_MAX: usize = 1 << 16;

/// Values beyond this are no measurement: the bound of a project file, in SI.
pub const MAGNITUDE_MAX: f64 = 1e12;

/// Times closer together than this are no recording, in seconds.
pub const STEP_MIN_S: f64 = 1e-12;

/// Groups within groups in the schema of a Parquet file.
pub const NESTING_MAX: usize = 16;

/// Bytes in the path of a column of a Parquet file.
pub(crate) const PATH_BYTES_MAX: usize = 1024;

/// Row groups of a Parquet file.
pub(crate) const ROW_GROUPS_MAX: usize = 1 << 16;

/// A page that unpacks to more than [`PAGE_BYTES_FREE`] may not unpack to more than this many times its packed size.
pub(crate) const PAGE_RATIO_MAX: u64 = 1000;

/// What a page may unpack to whatever its packed size is: 16 MiB, many times what writers put into one.
pub(crate) const PAGE_BYTES_FREE: u64 = 16 << 20;

/// What all pages in use may unpack to, one after another: 4 GiB bound the time that they take.
pub(crate) const UNPACKED_BYTES_MAX: u64 = 4 << 30;

/// Values in one block of the delta encoding: the most that a known writer puts there.
pub const DELTA_BLOCK_MAX: u64 = 2048;

/// Names of columns that a fault carries.
pub(crate) const NAMES_MAX: usize = 20;

/// What a limit bounds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Bytes of the file.
    FileBytes,
    /// Bytes of memory for all recordings of a project.
    Memory,
    /// Rows looked at.
    Rows,
    /// Columns.
    Columns,
    /// Groups within groups of a schema.
    Nesting,
    /// Bytes in the path of a column.
    PathBytes,
    /// Row groups.
    RowGroups,
    /// How many times its packed size a page unpacks to.
    PageRatio,
    /// Bytes that all pages unpack to.
    UnpackedBytes,
    /// Values in a block of the delta encoding.
    DeltaBlock,
}

impl fmt::Display for Limit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::FileBytes => "bytes of the file",
            Self::Memory => "bytes of memory",
            Self::Rows => "rows",
            Self::Columns => "columns",
            Self::Nesting => "groups within groups",
            Self::PathBytes => "bytes in the path of a column",
            Self::RowGroups => "row groups",
            Self::PageRatio => "times the packed size of a page",
            Self::UnpackedBytes => "bytes of unpacked pages",
            Self::DeltaBlock => "values in a block of deltas",
        })
    }
}

impl Limit {
    /// A fault if there are more than the limit allows.
    pub(crate) fn hold(self, found: u64, most: u64) -> Result<(), Fault> {
        if found <= most { Ok(()) } else { Err(Fault::Beyond { limit: self, found, most }) }
    }
}

/// Memory that recordings may take, and what they took of it.
#[derive(Clone, Debug)]
pub struct Memory {
    most: u64,
    taken: u64,
    /// Set by a caller who no longer waits.
    cancelled: Option<Arc<AtomicBool>>,
}

impl Default for Memory {
    fn default() -> Self {
        Self::new(MEMORY_USUAL)
    }
}

impl Memory {
    /// So many bytes, none of them taken.
    #[must_use]
    pub const fn new(most: u64) -> Self {
        Self { most, taken: 0, cancelled: None }
    }

    /// The same, and reading ends where the flag is set.
    #[must_use]
    pub fn until(self, cancelled: Option<Arc<AtomicBool>>) -> Self {
        Self { cancelled, ..self }
    }

    /// A fault if the caller no longer waits.
    pub(crate) fn go_on(&self) -> Result<(), Fault> {
        let is_over = self.cancelled.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed));
        if is_over { Err(Fault::Stopped) } else { Ok(()) }
    }

    /// Bytes that are left.
    #[must_use]
    pub const fn left(&self) -> u64 {
        self.most.saturating_sub(self.taken)
    }

    /// Takes so many bytes.
    ///
    /// # Errors
    /// [`Fault::Beyond`] where they are not left; then nothing is taken.
    pub fn take(&mut self, bytes: u64) -> Result<(), Fault> {
        let taken = self.taken.saturating_add(bytes);
        Limit::Memory.hold(taken, self.most)?;
        self.taken = taken;
        Ok(())
    }

    /// Gives so many bytes back.
    pub const fn give_back(&mut self, bytes: u64) {
        self.taken = self.taken.saturating_sub(bytes);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_taken_up_to_its_bound_and_given_back() {
        let mut memory = Memory::new(100);
        assert_eq!(memory.take(60), Ok(()));
        assert_eq!(memory.take(41), Err(Fault::Beyond { limit: Limit::Memory, found: 101, most: 100 }));
        assert_eq!(memory.take(u64::MAX), Err(Fault::Beyond { limit: Limit::Memory, found: u64::MAX, most: 100 }));
        assert_eq!((memory.take(40), memory.left()), (Ok(()), 0));
        memory.give_back(30);
        assert_eq!(memory.left(), 30);
    }
}

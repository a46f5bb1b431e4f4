//! Size limits of a file: every size that a file may claim has its bound here.

use crate::faults::Fault;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Maximum size of a file, in bytes.
pub const FILE_BYTES_MAX: u64 = 1 << 30;

/// Default memory of all recordings of a project: 512 MiB.
pub const MEMORY_USUAL: u64 = 512 << 20;

/// Maximum number of samples kept: 2²⁴, more than four hours at 1 kHz.
pub const SAMPLES_MAX: usize = 1 << 24;

/// Minimum number of samples of a recording: two intervals, so that there is a change of speed.
pub(crate) const SAMPLES_MIN: usize = 3;

/// Maximum number of rows read, kept or outside the window: 2²⁶, eighteen hours at 1 kHz.
pub(crate) const ROWS_MAX: u64 = 1 << 26;

/// Maximum number of columns of a file; more than any logger has channels.
pub(crate) const COLUMNS_MAX: usize = 10_000;

/// Maximum number of columns of a table of many axes; no project has as many keys.
pub const TABLE_COLUMNS_MAX: u64 = 1000;

/// Number of rows permitted in a table of any size.
pub(crate) const TABLE_ROWS_FREE: u64 = 1 << 20;

/// Maximum number of rows per byte of a larger table; a higher number cannot come from real data.
pub(crate) const TABLE_ROWS_PER_BYTE: u64 = 256;

/// Maximum number of bytes in one line of a CSV, 64 KiB: bounds its text buffer.
pub const LINE_BYTES_MAX: usize = 1 << 16;

/// Maximum number of bytes of a CSV between two rows, 1 MiB of comments, empty lines or the rest of a line that is too long: a
/// packed file of nothing else is not unpacked to its end.
pub const BLANK_BYTES_MAX: u64 = 1 << 20;

/// Largest plausible magnitude of a measured value in SI, the same bound as in a project file.
pub const MAGNITUDE_MAX: f64 = 1e12;

/// Shortest interval between two samples \[s\].
pub const STEP_MIN_S: f64 = 1e-12;

/// Maximum nesting of groups in the schema of a Parquet file.
pub const NESTING_MAX: usize = 16;

/// Maximum number of bytes in the path of a column of a Parquet file.
pub(crate) const PATH_BYTES_MAX: usize = 1024;

/// Maximum number of row groups of a Parquet file.
pub(crate) const ROW_GROUPS_MAX: usize = 1 << 16;

/// Maximum ratio of unpacked to packed size of a page larger than [`PAGE_BYTES_FREE`].
pub(crate) const PAGE_RATIO_MAX: u64 = 1000;

/// Unpacked size of a page permitted at any packed size: 16 MiB, many times what writers put into one.
pub(crate) const PAGE_BYTES_FREE: u64 = 16 << 20;

/// Maximum unpacked size of all pages in use together: 4 GiB bound the time of reading.
pub(crate) const UNPACKED_BYTES_MAX: u64 = 4 << 30;

/// Maximum number of values in one block of the delta encoding: the most that a known writer puts there.
pub const DELTA_BLOCK_MAX: u64 = 2048;

/// Maximum number of column names in a fault.
pub(crate) const NAMES_MAX: usize = 20;

/// Quantity bounded by a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Bytes of the file.
    FileBytes,
    /// Bytes of memory for all recordings of a project.
    Memory,
    /// Rows read.
    Rows,
    /// Columns of the file.
    Columns,
    /// Nesting of groups in a schema.
    Nesting,
    /// Bytes in the path of a column.
    PathBytes,
    /// Row groups.
    RowGroups,
    /// Ratio of unpacked to packed size of a page.
    PageRatio,
    /// Unpacked bytes of all pages.
    UnpackedBytes,
    /// Values in a block of the delta encoding.
    DeltaBlock,
    /// Bytes of a text without a row.
    BlankBytes,
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
            Self::BlankBytes => "bytes without a row",
        })
    }
}

impl Limit {
    /// Returns an error if `found` exceeds the limit `most`.
    pub(crate) fn hold(self, found: u64, most: u64) -> Result<(), Fault> {
        if found <= most { Ok(()) } else { Err(Fault::Beyond { limit: self, found, most }) }
    }
}

/// Memory budget of recordings, and the part in use.
#[derive(Clone, Debug)]
pub struct Memory {
    most: u64,
    taken: u64,
    /// Flag by which the caller cancels reading.
    cancelled: Option<Arc<AtomicBool>>,
}

impl Default for Memory {
    fn default() -> Self {
        Self::new(MEMORY_USUAL)
    }
}

impl Memory {
    /// Creates a budget of `most` bytes, none of them in use.
    #[must_use]
    pub const fn new(most: u64) -> Self {
        Self { most, taken: 0, cancelled: None }
    }

    /// Adds a flag by which the caller cancels reading.
    #[must_use]
    pub fn until(self, cancelled: Option<Arc<AtomicBool>>) -> Self {
        Self { cancelled, ..self }
    }

    /// Returns an error if the caller cancelled.
    ///
    /// # Errors
    /// [`Fault::Stopped`].
    pub fn go_on(&self) -> Result<(), Fault> {
        let is_over = self.cancelled.as_ref().is_some_and(|flag| flag.load(Ordering::Relaxed));
        if is_over { Err(Fault::Stopped) } else { Ok(()) }
    }

    /// Returns the number of bytes left.
    #[must_use]
    pub const fn left(&self) -> u64 {
        self.most.saturating_sub(self.taken)
    }

    /// Reserves a number of bytes.
    ///
    /// # Errors
    /// [`Fault::Beyond`] if fewer bytes are left; nothing is reserved then.
    pub fn take(&mut self, bytes: u64) -> Result<(), Fault> {
        let taken = self.taken.saturating_add(bytes);
        Limit::Memory.hold(taken, self.most)?;
        self.taken = taken;
        Ok(())
    }

    /// Returns a number of reserved bytes.
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

//! Size limits of a file: every size that a file may claim has its bound here.

use std::fmt;

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

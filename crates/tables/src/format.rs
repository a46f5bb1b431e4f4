//! Formats of tables, and the memory of a long course in each.

use crate::table::Table;
use axis::AxisProject;
use questions::{Refusal, course_rows};
use std::path::Path;

/// Largest number of rows of a table on a sheet; a longer one is named on the first sheet and left to the other
/// formats. A choice of this crate that keeps a workbook small; a sheet could hold 2²⁰.
pub const SHEET_ROWS_MOST: usize = 200_000;

/// Format of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A workbook with each table on a sheet.
    Workbook,
    /// One table as CSV.
    Csv,
    /// One table as a record.
    Json,
    /// One table as Parquet.
    Parquet,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 4] = [Self::Json, Self::Csv, Self::Parquet, Self::Workbook];

    /// Returns the file extension, without the dot.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Workbook => "xlsx",
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Parquet => "parquet",
        }
    }

    /// Returns the format of a file extension.
    #[must_use]
    pub fn of_ending(ending: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.ending() == ending)
    }

    /// Returns the format of a file, by its extension.
    #[must_use]
    pub fn of(file: &Path) -> Option<Self> {
        Self::of_ending(&file.extension()?.to_string_lossy().to_ascii_lowercase())
    }

    /// Returns an upper bound of the memory for each row of a course, including its recording and its text, from a
    /// measurement with four million rows.
    const fn row_bytes(self) -> u64 {
        match self {
            Self::Csv | Self::Parquet | Self::Workbook => 256,
            Self::Json => 512,
        }
    }

    /// Checks that the requested tables, all or one, fit into this number of bytes of memory. Only the time course
    /// grows with a recording; a workbook contains it up to a limited length.
    ///
    /// # Errors
    /// [`Refusal::TooManyRows`]
    pub fn within(self, project: &AxisProject, table: Option<&str>, memory: u64) -> Result<(), Refusal> {
        if table.is_some_and(|table| table != "course") || self.course_left_out(project).is_some() {
            return Ok(());
        }
        let rows = course_rows(project);
        let needed = self.row_bytes().saturating_mul(rows as u64);
        if needed > memory { Err(Refusal::TooManyRows { rows, needed, most: memory }) } else { Ok(()) }
    }

    /// Returns `true` if a file of this format contains a table: a workbook contains none that is too long for a sheet.
    #[must_use]
    pub fn holds(self, table: &Table) -> bool {
        self != Self::Workbook || table.rows.len() <= SHEET_ROWS_MOST
    }

    /// Returns the number of instants of a course that is not computed, because it certainly exceeds a sheet: of two
    /// adjacent rows at most one can be a repetition.
    pub(crate) fn course_left_out(self, project: &AxisProject) -> Option<usize> {
        let rows = course_rows(project);
        (self == Self::Workbook && rows / 2 > SHEET_ROWS_MOST).then_some(rows)
    }
}

//! The formats, and what a long course may take in each.

use crate::table::Table;
use crate::xlsx::SHEET_ROWS_MOST;
use project::Project;
use questions::{Refusal, course_rows};
use std::path::Path;

/// How tables are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// All tables on the sheets of a workbook.
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

    /// What its files end with, without the dot.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Workbook => "xlsx",
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Parquet => "parquet",
        }
    }

    /// The format of files that end so.
    #[must_use]
    pub fn of_ending(ending: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.ending() == ending)
    }

    /// The format of a file, by the ending of its name.
    #[must_use]
    pub fn of(file: &Path) -> Option<Self> {
        Self::of_ending(&file.extension()?.to_string_lossy().to_ascii_lowercase())
    }

    /// Bytes that the program takes for each row of a course, with the recording it comes from and the text it becomes:
    /// measured with four million rows, and more than that.
    const fn row_bytes(self) -> u64 {
        match self {
            Self::Csv | Self::Parquet | Self::Workbook => 256,
            Self::Json => 512,
        }
    }

    /// Whether the requested tables, all or one, fit in this many bytes of memory. Only the time course
    /// grows with a recording; a workbook contains it up to a limited length.
    ///
    /// # Errors
    /// [`Refusal::TooManyRows`]
    pub fn within(self, project: &Project, table: Option<&str>, memory: u64) -> Result<(), Refusal> {
        if table.is_some_and(|table| table != "course") || self.course_left_out(project).is_some() {
            return Ok(());
        }
        let rows = course_rows(project);
        let needed = self.row_bytes().saturating_mul(rows as u64);
        if needed > memory { Err(Refusal::TooManyRows { rows, needed, most: memory }) } else { Ok(()) }
    }

    /// Whether a file of this format has a table: a workbook has none that is too long for a sheet.
    #[must_use]
    pub fn holds(self, table: &Table) -> bool {
        self != Self::Workbook || table.rows.len() <= SHEET_ROWS_MOST
    }

    /// How many instants a course has that is not made, because for certain a sheet does not take it: of two neighbours at
    /// most one says the same as the other.
    pub(crate) fn course_left_out(self, project: &Project) -> Option<usize> {
        let rows = course_rows(project);
        (self == Self::Workbook && rows / 2 > SHEET_ROWS_MOST).then_some(rows)
    }
}

//! Places and times in a file.

use quantities::Unit;
use std::fmt;

/// Place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FileRow {
    /// Line of a text, counted from 1 with every comment and empty line.
    Line(u64),
    /// Row of a table, counted from 1.
    Row(u64),
}

impl fmt::Display for FileRow {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(number) => write!(formatter, "line {number}"),
            Self::Row(number) => write!(formatter, "row {number}"),
        }
    }
}

/// A time in the unit of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stamp {
    /// Number as written.
    pub value: f64,
    /// Unit of the column.
    pub unit: &'static Unit,
}

impl fmt::Display for Stamp {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} {}", self.value, self.unit.ascii)
    }
}

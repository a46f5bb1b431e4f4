//! The recording as read.

use crate::layout::Role;
use quantities::{Dimension, Time, Unit};
use std::sync::Arc;

/// Recorded samples in SI. The arrays are shared with the motion built from them.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// Times since the first kept sample \[s\], rising, strictly unless the layout accepts equal ones; the
    /// first is zero.
    pub time_s: Arc<Vec<f64>>,
    /// Time of the first kept sample, in the time of the file.
    pub first_time: Time,
    /// Position, speed or both.
    pub course: RecordedCourse,
    /// Torque or force, if there is such a column.
    pub torque: Option<Series>,
    /// Columns that were read, in the order of [`Role::ALL`].
    pub columns: Vec<ColumnRead>,
    /// Encoding of the text; `None` for a format that is no text.
    pub encoding: Option<Encoding>,
    /// Headings of the columns that are not used.
    pub unused: Vec<String>,
    /// Number of comments below the heading, lines that begin with `#` and are no rows.
    pub comments: u64,
    /// Number of jumps of one revolution that were removed from the positions of a modulo axis.
    pub revolutions_removed: usize,
    /// Number of samples before the window.
    pub left_out_before: u64,
    /// Number of samples after the window.
    pub left_out_after: u64,
}

/// Encoding of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8; every byte of the header is valid.
    Utf8,
    /// UTF-16, stated by the byte order mark.
    Utf16,
    /// UTF-16, guessed from the zeros between the letters.
    Utf16Guessed,
    /// Windows-1252, which includes Latin-1: guessed, since the header is no UTF-8.
    Windows1252Guessed,
}

/// Position and speed over time; at least one is present, and both are of the same kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedCourse {
    /// Position.
    pub position: Option<Series>,
    /// Speed.
    pub speed: Option<Series>,
}

/// Kind of motion of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Rotary: rad, rad/s, Nm.
    Turning,
    /// Linear: m, m/s, N.
    Line,
}

impl Along {
    /// Returns the kind of motion of a unit.
    pub(crate) const fn of(unit: &Unit) -> Self {
        match unit.dimension {
            Dimension::Length | Dimension::Velocity | Dimension::Force => Self::Line,
            _ => Self::Turning,
        }
    }
}

/// A position or speed, torque or force at every time.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Kind of motion: rotary (rad, rad/s, Nm) or linear (m, m/s, N).
    pub along: Along,
    /// Values in SI, one per time.
    pub values: Arc<Vec<f64>>,
}

/// Assignment of a column to a role.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnRead {
    /// Role of the column.
    pub role: Role,
    /// Name as written.
    pub name: String,
    /// Unit of the values in the file.
    pub unit: &'static Unit,
    /// Origin of the unit.
    pub known_by: KnownBy,
}

/// Origin of the unit of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownBy {
    /// The name of the column: `q [deg]`.
    Header,
    /// The row under the header.
    UnitRow,
    /// The metadata of the file: a key `q.unit` or `unit:q`, or the time unit of a timestamp type.
    Metadata,
    /// The values: clock times.
    Values,
    /// The [`Layout`](crate::Layout).
    Layout,
}

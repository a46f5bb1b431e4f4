//! What was read.

use crate::layout::Role;
use quantities::{Dimension, Time, Unit};
use std::sync::Arc;

/// Recorded samples in SI. Its arrays are shared with the motion that is made of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// Times since the first kept sample \[s\], strictly rising; the first is zero.
    pub time_s: Arc<Vec<f64>>,
    /// Time of the first kept sample, as the file counts it.
    pub first_time: Time,
    /// Position, speed or both.
    pub course: Course,
    /// Torque or force, if there is such a column.
    pub torque: Option<Series>,
    /// The columns that were read, in the order of [`Role::ALL`].
    pub columns: Vec<ColumnRead>,
    /// How the text was read; `None` of a format that is no text.
    pub encoding: Option<Encoding>,
    /// Columns that hold a quantity by their name or unit, and are not used.
    pub unused: Vec<String>,
    /// How many samples lie before the window.
    pub left_out_before: u64,
    /// How many samples lie after the window.
    pub left_out_after: u64,
}

/// How the bytes of a text were read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, which every byte of the header agrees to.
    Utf8,
    /// UTF-16, as the mark at the beginning says.
    Utf16,
    /// UTF-16, guessed from the zeros between the letters.
    Utf16Guessed,
    /// Windows-1252, of which Latin-1 is a part: guessed, since the header is no UTF-8.
    Windows1252Guessed,
}

/// Position and speed over time; at least one of them is there, and both are of the same kind.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    /// Position.
    pub position: Option<Series>,
    /// Speed.
    pub speed: Option<Series>,
}

/// Whether an axis turns or moves along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Turning: rad, rad/s, Nm.
    Turning,
    /// Along a line: m, m/s, N.
    Line,
}

impl Along {
    /// The quantity by its unit.
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
    /// Turning (rad, rad/s, Nm) or along a line (m, m/s, N).
    pub along: Along,
    /// Values in SI, one per time.
    pub values: Arc<Vec<f64>>,
}

/// Which column was read as what.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnRead {
    /// What it was read as.
    pub role: Role,
    /// Its name as written.
    pub name: String,
    /// Its unit.
    pub unit: &'static Unit,
    /// Who says the unit.
    pub known_by: KnownBy,
}

/// Who says the unit of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KnownBy {
    /// The name of the column carries it: `q [deg]`.
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

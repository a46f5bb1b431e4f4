//! Motion resulting from the project.

use crate::{Number, Units};
use schemars::JsonSchema;
use serde::Serialize;

/// The motion: every segment with what was given and what followed from it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Motion {
    /// Units of time, distance, speed and acceleration; those of a linear axis are linear.
    pub units: Units,
    /// The segments in their order.
    pub segments: Vec<Segment>,
}

/// One segment.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Segment {
    /// Id of the law of motion.
    pub law: &'static str,
    /// The law in words.
    pub name: &'static str,
    /// When it begins.
    pub start: Number,
    /// How long it takes.
    pub duration: Number,
    /// The way travelled, with its sign; left out for a dwell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance: Option<Number>,
    /// The largest speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<Number>,
    /// The largest acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<Number>,
    /// What was read from the file; only of a recorded segment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recording: Option<Recording>,
}

/// What was read from the file of a recorded segment.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Recording {
    /// Its name as the project has it.
    pub file: String,
    /// How its text was read; `null` of a format that is no text.
    pub encoding: Option<TextEncoding>,
    /// How many samples are used.
    pub samples: usize,
    /// The time that the first of them had in the file, in s.
    pub first_time: Number,
    /// How many samples before the cut were left out.
    pub left_out_before: u64,
    /// How many samples after the cut were left out.
    pub left_out_after: u64,
    /// The columns that were read.
    pub columns: Vec<RecordedColumn>,
    /// Names of columns that hold a quantity by name or unit, and are not used.
    pub unused: Vec<String>,
}

/// How the text of a recording was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TextEncoding {
    /// UTF-8, which every byte of the header agrees to.
    Utf8,
    /// UTF-16, as the mark at the beginning says.
    Utf16,
    /// UTF-16, guessed from the zeros between the letters.
    Utf16Guessed,
    /// Windows-1252, of which Latin-1 is a part: guessed, since the header is no UTF-8.
    Windows1252Guessed,
}

/// A column of a recording.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RecordedColumn {
    /// What it is.
    pub role: ColumnRole,
    /// What it is called in the file.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// Source of the unit.
    pub unit_by: UnitBy,
}

/// What a column of a recording is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs, reason = "the names say it")]
pub enum ColumnRole {
    Time,
    Position,
    Speed,
    Torque,
}

/// Source of the unit of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum UnitBy {
    /// The name of the column.
    Header,
    /// A row of units below the names.
    UnitRow,
    /// The file's own metadata.
    Metadata,
    /// The values of the column: clock times.
    Values,
    /// The project file.
    Project,
}

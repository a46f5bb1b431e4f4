//! Motion resulting from the project.

use crate::{AssumptionEntry, Number, Units};
use schemars::JsonSchema;
use serde::Serialize;

/// The motion: every segment with its given and its resulting values.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Motion {
    /// Units of time, distance, speed and acceleration, those of a linear axis linear, and of the loads that a segment
    /// states.
    pub units: Units,
    /// Segments in their order.
    pub segments: Vec<Segment>,
    /// Setpoints at equal steps; only if a step is stated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub setpoints: Option<Setpoints>,
    /// Assumptions about the motion; only in the answer of `moves`, other answers have those of the axis.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub assumptions: Vec<AssumptionEntry>,
}

/// Setpoints of the motion over one cycle, its end included.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Setpoints {
    /// Units of time, position, speed and acceleration.
    pub units: Units,
    /// Time between two rows.
    pub every: Number,
    /// Number of rows.
    pub rows: usize,
    /// File with the rows, if one was written; the lists are empty then.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Instants from the start of the cycle.
    pub time: Vec<Number>,
    /// Position at each instant.
    pub position: Vec<Number>,
    /// Speed at each instant.
    pub speed: Vec<Number>,
    /// Acceleration at each instant; where it jumps, that behind the jump.
    pub acceleration: Vec<Number>,
}

/// One segment.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Segment {
    /// Id of the law of motion.
    pub law: &'static str,
    /// Name of the law.
    pub name: &'static str,
    /// Start of the segment.
    pub start: Number,
    /// Duration of the segment.
    pub duration: Number,
    /// Distance travelled, with its sign; omitted for a dwell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance: Option<Number>,
    /// Largest speed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub speed: Option<Number>,
    /// Largest acceleration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub acceleration: Option<Number>,
    /// Mass in addition to those of the mechanism; omitted if no segment states a payload.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub payload: Option<Number>,
    /// Moment of inertia in addition to that of the mechanism; omitted if no segment states one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub payload_inertia: Option<Number>,
    /// Process force as it acts: that of the mechanism plus that of the segment; omitted if no segment states one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub process_force: Option<Number>,
    /// Torque against the positive direction as it acts: the external torque of the mechanism plus the process torque
    /// of the segment; omitted if no segment states one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub external_torque: Option<Number>,
    /// Data read from the file; only for a recorded segment.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub recording: Option<Recording>,
}

/// Data read from the file of a recorded segment.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Recording {
    /// Name of the file as in the project.
    pub file: String,
    /// Encoding of the text; `null` for a format that is no text.
    pub encoding: Option<TextEncoding>,
    /// Number of samples used.
    pub samples: usize,
    /// Time of the first sample in the file, in s.
    pub first_time: Number,
    /// Number of samples left out before the window.
    pub left_out_before: u64,
    /// Number of samples left out after the window.
    pub left_out_after: u64,
    /// Number of lines skipped as comments: they begin with `#` and are no rows.
    pub comments: u64,
    /// Columns read.
    pub columns: Vec<RecordedColumn>,
    /// Headings of the columns that are not used.
    pub unused: Vec<String>,
}

/// Encoding of the text of a recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TextEncoding {
    /// UTF-8; every byte of the header is valid.
    Utf8,
    /// UTF-16, stated by the byte order mark.
    Utf16,
    /// UTF-16, guessed from the zeros between the letters.
    Utf16Guessed,
    /// Windows-1252, which includes Latin-1: guessed, since the header is no UTF-8.
    Windows1252Guessed,
}

/// A column of a recording.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RecordedColumn {
    /// Role of the column.
    pub role: ColumnRole,
    /// Name in the file.
    pub name: String,
    /// Unit of the values.
    pub unit: &'static str,
    /// Source of the unit.
    pub unit_by: UnitBy,
}

/// Role of a column in a recording.
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
    /// The metadata of the file.
    Metadata,
    /// The values of the column: clock times.
    Values,
    /// The project file.
    Project,
}

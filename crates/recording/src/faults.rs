//! Reasons why a file cannot be read as a recording.

pub use crate::damage::Damage;
use crate::layout::Role;
use crate::limits::{Limit, SAMPLES_MAX};
use crate::packed::Foreign;
pub use crate::places::{FileRow, Stamp};
use crate::series::{Along, KnownBy};
use quantities::{Angle, Dimension, Time, Unit, is_unseen};
use std::io::ErrorKind;
use std::mem::Discriminant;
use thiserror::Error;

/// A column that probably has a role.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NearColumn {
    /// Role.
    pub role: Role,
    /// Name of the column in the file.
    pub column: String,
    /// The column states a unit of the role.
    pub has_unit: bool,
}

/// Way to read a recording some of whose values are missing, or whose rows are in the wrong order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Remedy {
    /// The recording is read without the column of this role.
    Without(Role),
    /// First and last time between which no value is missing.
    Within {
        /// Time of the first row with all values, if rows before it lack some.
        from: Option<Stamp>,
        /// Time of the last one, if rows after it lack some.
        to: Option<Stamp>,
    },
    /// Rows among others are deleted.
    Delete,
    /// Time runs backwards throughout: the order of the rows is reversed.
    Reverse,
    /// Time begins anew: of several recordings one after another one is kept.
    KeepOne {
        /// Place of the first row of the second one.
        at: FileRow,
    },
    /// Time jumps back once and goes on: the clock was set back, by an hour at the end of summer time, or two recordings overlap.
    SetBack {
        /// Place of the first row after the jump.
        at: FileRow,
        /// Time to add from this row on.
        by: Stamp,
    },
    /// Two rows are exchanged.
    Exchange {
        /// Places of both.
        rows: [FileRow; 2],
    },
    /// Rows are in disorder and are sorted by time.
    Sort,
    /// The time stamps are rounded more coarsely than the rows follow one another; even ones replace them.
    EvenStamps,
    /// One of two equal rows is deleted.
    DeleteRepeated,
}

/// Reason why a file cannot be read as a recording. Quoted text of the file is shortened to 40 characters.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Fault {
    /// The source cannot be read further.
    #[error("line {line}: the source cannot be read: {kind}")]
    ReadFailed {
        /// Line being read.
        line: u64,
        /// Kind of the read error.
        kind: ErrorKind,
    },
    /// There is no header.
    #[error("the file has no header")]
    NoHeader,
    /// A line exceeds the maximum length.
    #[error("line {line}: longer than {most} bytes")]
    LineTooLong {
        /// Line number.
        line: u64,
        /// Maximum length of a line in bytes.
        most: usize,
    },
    /// A quoted cell is not closed in its line.
    #[error("line {line}: a quoted cell does not end in this line")]
    QuoteOpen {
        /// Line number.
        line: u64,
    },
    /// A row has more or fewer cells than the header.
    #[error("line {line}: {found} cells under a header of {expected}")]
    Ragged {
        /// Line number.
        line: u64,
        /// Cells in the row.
        found: usize,
        /// Cells in the header.
        expected: usize,
    },
    /// A row of whole numbers has more cells than the header: commas that separate cells are decimal signs as well.
    #[error("line {line}: {found} cells under a header of {expected}: commas are decimal signs as well")]
    CommasTwice {
        /// Line number.
        line: u64,
        /// Cells in the row.
        found: usize,
        /// Cells in the header.
        expected: usize,
    },
    /// A column named in the layout does not exist.
    #[error("no column is named \"{name}\"")]
    ColumnUnknown {
        /// Role given to the column in the layout.
        role: Role,
        /// Name in the layout.
        name: String,
        /// Closest name in the file, if one is similar.
        nearest: Option<String>,
        /// Columns of the file.
        headers: Vec<String>,
    },
    /// The layout names one column for two roles.
    #[error("the column \"{column}\" is named for two roles")]
    ColumnTwice {
        /// Name of the column.
        column: String,
        /// Both roles.
        roles: [Role; 2],
    },
    /// The file is no table: there is no number below the first line.
    #[error("no numbers stand under the first line")]
    NoTable,
    /// The numbers of a row are separated by spaces alone.
    #[error("the numbers are separated by spaces alone")]
    SpacesOnly,
    /// The file is neither text nor in a known format.
    #[error("the file is no text")]
    NotText,
    /// No column of time is found.
    #[error("no column of time is found")]
    TimeMissing {
        /// Columns of the file.
        headers: Vec<String>,
        /// Columns that probably hold the time.
        near: Vec<NearColumn>,
    },
    /// Neither a column of position nor one of speed is found.
    #[error("neither a column of position nor one of speed is found")]
    CourseMissing {
        /// Columns of the file.
        headers: Vec<String>,
        /// Columns that probably hold position or speed.
        near: Vec<NearColumn>,
    },
    /// The layout states a unit for a role that no column has.
    #[error("a unit is stated, but no column is the {role:?}")]
    UnitWithoutColumn {
        /// Role.
        role: Role,
        /// Columns of the file.
        headers: Vec<String>,
        /// Column that probably has the role.
        near: Vec<NearColumn>,
    },
    /// Several columns could have a role.
    #[error("several columns could be the {role:?}")]
    Ambiguous {
        /// Role.
        role: Role,
        /// Names of the columns that could have the role.
        columns: Vec<String>,
        /// Numbers of these columns, counted from 1.
        numbers: Vec<usize>,
    },
    /// The first line holds units alone: there are no names of columns.
    #[error("the first line holds units, no names of columns")]
    HeadingOfUnits {
        /// Role that the unit of a column permits, its number, counted from 1, and the unit.
        columns: Vec<(Role, usize, &'static Unit)>,
    },
    /// The first line holds numbers: there is no heading.
    #[error("the first line holds numbers, no names of columns")]
    HeadingMissing {
        /// Number of cells in the line.
        columns: usize,
    },
    /// The first time is written as that of a clock, in a form that is not known.
    #[error("\"{text}\" in \"{column}\" is a time in a form that is not known")]
    ClockUnknown {
        /// Name of the column.
        column: String,
        /// Cell as written.
        text: String,
    },
    /// Two columns of time with one name differ.
    #[error("{at}: two columns \"{column}\" hold different times")]
    TimesDiffer {
        /// Place in the file.
        at: FileRow,
        /// Name of the columns.
        column: String,
        /// Numbers of the columns, counted from 1.
        numbers: [usize; 2],
    },
    /// The file has another format.
    #[error("this is {format:?}")]
    Foreign {
        /// Format detected.
        format: Foreign,
    },
    /// Reading was cancelled.
    #[error("cancelled")]
    Stopped,
    /// The unit of a column is missing.
    #[error("the unit of \"{column}\" is missing")]
    UnitMissing {
        /// Role of the column.
        role: Role,
        /// Name of the column.
        column: String,
    },
    /// A unit is not known.
    #[error("\"{text}\" is no known unit")]
    UnitUnknown {
        /// Role of the column.
        role: Role,
        /// Name of the column.
        column: String,
        /// Unit as written.
        text: String,
        /// Origin of the unit.
        by: KnownBy,
        /// Known unit closest in spelling, if one is similar.
        nearest: Option<&'static Unit>,
    },
    /// A unit has another dimension than the role.
    #[error("\"{}\" is no unit of \"{column}\"", unit.ascii)]
    UnitWrong {
        /// Role of the column.
        role: Role,
        /// Name of the column.
        column: String,
        /// Unit stated.
        unit: &'static Unit,
        /// Origin of the unit.
        by: KnownBy,
    },
    /// A heading states a factor beside a unit, or a share, and the unit is stated elsewhere.
    #[error("\"{column}\" states \"{text}\", which is more than a unit")]
    UnitScaled {
        /// Name of the column.
        column: String,
        /// Text in place of the unit.
        text: String,
    },
    /// Two statements of a unit differ.
    #[error("\"{column}\" is said to be in \"{}\" and in \"{}\"", units[0].ascii, units[1].ascii)]
    UnitContradiction {
        /// Name of the column.
        column: String,
        /// Units stated.
        units: [&'static Unit; 2],
        /// Origin of each unit.
        by: [KnownBy; 2],
    },
    /// Position and speed are of different kinds, one rotary and one linear.
    #[error("position and speed do not belong together")]
    CourseMixed {
        /// Dimension of the position.
        position: Dimension,
        /// Dimension of the speed.
        speed: Dimension,
    },
    /// The window ends before it begins.
    #[error("the window ends before it begins")]
    WindowReversed {
        /// Start of the window.
        from: Time,
        /// End of the window.
        to: Time,
    },
    /// A cell is empty or null.
    #[error("{at}: the value of \"{column}\" is missing")]
    ValueMissing {
        /// Place in the file.
        at: FileRow,
        /// Name of the column.
        column: String,
    },
    /// A cell is not a number.
    #[error("{at}: the value of \"{column}\" is no number")]
    ValueUnreadable {
        /// Place in the file.
        at: FileRow,
        /// Name of the column.
        column: String,
        /// Cell as written, if it is written like a number; other text of a file is not quoted.
        text: Option<String>,
    },
    /// A cell has another unit than the first one of its column, or none.
    #[error("{at}: the value of \"{column}\" is not in \"{}\"", unit.ascii)]
    UnitOfCell {
        /// Place in the file.
        at: FileRow,
        /// Name of the column.
        column: String,
        /// Cell as written, if it is a number, with or without a unit.
        text: Option<String>,
        /// Unit of the first cell.
        unit: &'static Unit,
    },
    /// A number is infinite, not a number, or too large to be represented in SI.
    #[error("{at}: \"{text}\" in \"{column}\" is no finite number")]
    ValueNotFinite {
        /// Place in the file.
        at: FileRow,
        /// Name of the column.
        column: String,
        /// Cell as written.
        text: String,
    },
    /// A number exceeds [`MAGNITUDE_MAX`](crate::MAGNITUDE_MAX) in SI.
    #[error("{at}: \"{text}\" in \"{column}\" is beyond every measurement")]
    ValueImplausible {
        /// Place in the file.
        at: FileRow,
        /// Name of the column.
        column: String,
        /// Number as written.
        text: String,
    },
    /// A number has a decimal point in a file with decimal commas, or the reverse.
    #[error("line {line}: \"{text}\" in \"{column}\" has another decimal sign than line {decided}")]
    DecimalMixed {
        /// Line number.
        line: u64,
        /// Name of the column.
        column: String,
        /// Cell as written.
        text: String,
        /// Line that determined the decimal sign.
        decided: u64,
    },
    /// A number has separators between its thousands.
    #[error("{at}: \"{text}\" in \"{column}\" has signs between its thousands")]
    ThousandsGrouped {
        /// Place in the file.
        at: FileRow,
        /// Name of the column.
        column: String,
        /// Cell as written.
        text: String,
    },
    /// The sign in a number may be decimal or separate thousands: the column holds numbers up to 999 without a sign, and
    /// numbers with exactly three digits behind it.
    #[error("line {line}: the sign in \"{text}\" in \"{column}\" may be decimal or separate thousands")]
    ThousandsPossible {
        /// Line number.
        line: u64,
        /// Name of the column.
        column: String,
        /// Cell as written.
        text: String,
    },
    /// The position jumps against the motion, from one end of its range to the other.
    #[error("{at}: the position \"{column}\" jumps by {size} against the motion")]
    PositionJumps {
        /// Place of the sample after the jump.
        at: FileRow,
        /// Name of the column.
        column: String,
        /// Size of the jump in SI.
        size: f64,
        /// Kind of the position.
        along: Along,
        /// A speed is recorded too.
        has_speed: bool,
        /// Number of such jumps.
        count: usize,
    },
    /// A column holds other data than plain numbers.
    #[error("the column \"{column}\" holds {found}, no numbers")]
    ColumnType {
        /// Name of the column.
        column: String,
        /// Type of the column, as named by the format.
        found: String,
    },
    /// Time runs backwards.
    #[error("{at}: the time {time} follows {before}")]
    Backwards {
        /// Place of the later sample.
        at: FileRow,
        /// Time of the later sample.
        time: Stamp,
        /// Time of the sample before.
        before: Stamp,
    },
    /// Two samples have the same time.
    #[error("{at}: the same time {time} as {first}")]
    SameTime {
        /// Place of the later sample.
        at: FileRow,
        /// Place of the sample before.
        first: FileRow,
        /// Time of both samples.
        time: Stamp,
    },
    /// Two times are closer together than [`STEP_MIN_S`](crate::STEP_MIN_S).
    #[error("{at}: only {} s after the sample before", length.value)]
    TooClose {
        /// Place of the later sample.
        at: FileRow,
        /// Length of the interval.
        length: Time,
    },
    /// An interval is much longer than the others.
    #[error("{at}: a gap of {} s before this sample", length.value)]
    Gap {
        /// Place of the sample after the gap.
        at: FileRow,
        /// Length of the interval.
        length: Time,
        /// Median of all intervals.
        median: Time,
    },
    /// There are too few samples, or too few within the window.
    #[error("{found} samples, at least {least} are needed")]
    TooFewSamples {
        /// Number of samples kept.
        found: usize,
        /// Minimum number of samples of a recording.
        least: usize,
        /// Number of samples outside the window.
        outside: u64,
        /// Times of the first and the last sample of the file.
        span: Option<[Stamp; 2]>,
    },
    /// There are more samples than can be kept.
    #[error("more than {most} samples")]
    TooManySamples {
        /// Maximum number of samples.
        most: usize,
    },
    /// The file is no Parquet file, is damaged, or uses an unsupported feature.
    #[error("the Parquet file cannot be read: {reason}")]
    ParquetUnreadable {
        /// Reason.
        reason: Damage,
    },
    /// The file exceeds a size limit.
    #[error("{found} {limit}, at most {most}")]
    Beyond {
        /// Limit exceeded.
        limit: Limit,
        /// Size found or claimed.
        found: u64,
        /// Maximum size.
        most: u64,
    },
    /// The position of a turning axis begins anew after a full turn.
    #[error("{at:?}: the position begins anew after a full turn")]
    TurnBegun {
        /// Place of the first sample of the new turn.
        at: FileRow,
        /// Jump from the sample before it.
        jump: Angle,
        /// There is a column of speed, which suffices.
        has_speed: bool,
    },
    /// Columns chosen by their names belong to different axes or channels.
    #[error("the columns belong to different axes")]
    SeveralAxes {
        /// Columns with their roles, in their order.
        columns: Vec<(Role, String)>,
    },
    /// A scope states a scale or an offset of a channel, but not if the values contain it.
    #[error("the values of \"{column}\" may be scaled or not")]
    ScaleUnknown {
        /// Name of the channel.
        column: String,
        /// Scale and offset as written.
        scale: [String; 2],
    },
    /// The position moves by about half a revolution between two samples; of a modulo axis the direction is not known.
    #[error("{at:?}: the position moves by about half a revolution between two samples")]
    StepUndecided {
        /// Place of the second sample.
        at: FileRow,
        /// Time of the second sample.
        time: Stamp,
        /// Step from the sample before it.
        step: Angle,
        /// Number of such steps.
        count: usize,
    },
    /// Lines below the last row are no rows, as a footer.
    #[error("{first}; below the last row, {count} lines like it")]
    BelowRows {
        /// Fault of the first of them.
        first: Box<Fault>,
        /// Number of the lines.
        count: u64,
        /// Time of the last row.
        last: Stamp,
    },
    /// A fault of a column with a way to read the recording nevertheless.
    #[error("{fault}")]
    Advised {
        /// Fault.
        fault: Box<Fault>,
        /// Way to read the recording.
        remedy: Remedy,
    },
    /// A fault that occurs in many lines.
    #[error("{first}; {more} more like it")]
    Repeated {
        /// First occurrence.
        first: Box<Fault>,
        /// Number of further occurrences.
        more: u64,
    },
    /// There are further faults.
    #[error("{count} more faults")]
    More {
        /// Number of further faults counted.
        count: u64,
        /// Reading stopped there, so the file may contain still more.
        stopped: bool,
    },
}

/// Key of equal faults: variant and column.
pub(crate) type FaultKind = (Discriminant<Fault>, Option<String>);

impl Fault {
    /// Returns the kind of a fault in a line or its cells; `None` for a fault of the whole file.
    pub(crate) fn kind(&self) -> Option<FaultKind> {
        let column = match self {
            Self::ValueMissing { column, .. }
            | Self::ValueUnreadable { column, .. }
            | Self::ValueNotFinite { column, .. }
            | Self::ValueImplausible { column, .. }
            | Self::DecimalMixed { column, .. }
            | Self::TimesDiffer { column, .. }
            | Self::ThousandsGrouped { column, .. } => Some(column.clone()),
            Self::Ragged { .. }
            | Self::CommasTwice { .. }
            | Self::QuoteOpen { .. }
            | Self::Backwards { .. }
            | Self::SameTime { .. }
            | Self::TooClose { .. }
            | Self::TurnBegun { .. }
            | Self::Gap { .. } => None,
            _ => return None,
        };
        Some((std::mem::discriminant(self), column))
    }

    /// Returns the fault without the ways to read the recording nevertheless.
    #[must_use]
    pub fn bare(&self) -> &Self {
        match self {
            Self::BelowRows { first: fault, .. } | Self::Advised { fault, .. } => fault.bare(),
            fault => fault,
        }
    }

    /// Returns the column of a value that is missing or no number.
    pub(crate) fn column_of_value(&self) -> Option<&str> {
        match self {
            Self::ValueMissing { column, .. }
            | Self::ValueUnreadable { column, .. }
            | Self::ValueNotFinite { column, .. } => Some(column),
            _ => None,
        }
    }

    pub(crate) const fn too_many_samples() -> Self {
        Self::TooManySamples { most: SAMPLES_MAX }
    }
}

/// Shortens a text of a file for a message.
pub(crate) fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    let plain = |c: char| if is_unseen(c) { '\u{fffd}' } else { c };
    let mut short: String = text.chars().take(LONGEST).map(plain).collect();
    if text.chars().nth(LONGEST).is_some() {
        short.push('…');
    }
    short
}

//! Why a file is no recording.

use crate::FAULTS_MAX;
use crate::layout::Role;
use crate::limits::{Limit, SAMPLES_MAX};
use crate::packed::Foreign;
use crate::series::KnownBy;
use quantities::{Dimension, Time, Unit, is_unseen};
use std::fmt;
use std::io::ErrorKind;
use std::mem::Discriminant;
use thiserror::Error;

/// Where in a file.
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

/// A time as the file has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stamp {
    /// The number as written.
    pub value: f64,
    /// The unit of the column.
    pub unit: &'static Unit,
}

impl fmt::Display for Stamp {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} {}", self.value, self.unit.ascii)
    }
}

/// A column that probably has a role.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NearColumn {
    /// The role.
    pub role: Role,
    /// The column as the file names it.
    pub column: String,
    /// Whether it states a unit of the role.
    pub has_unit: bool,
}

/// What is wrong with a Parquet file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Damage {
    /// The marks of the format are missing.
    #[error("it is none")]
    NoParquet,
    /// It is encrypted.
    #[error("it is encrypted")]
    Encrypted,
    /// The pages lie in another file.
    #[error("its pages lie in another file")]
    Elsewhere,
    /// The footer is damaged.
    #[error("its footer is damaged")]
    Footer,
    /// A page is damaged.
    #[error("a page is damaged")]
    Page,
    /// A page does not unpack to what it says.
    #[error("a page does not unpack to the size that it says")]
    Packed,
    /// The columns of a row group differ in length.
    #[error("the columns of a row group differ in length")]
    Lengths,
    /// A compression that is not supported.
    #[error("compression {name} is not read")]
    Compression {
        /// Its name, or its number.
        name: String,
    },
    /// An encoding of numbers that is not supported.
    #[error("encoding {name} of numbers is not read")]
    Encoding {
        /// Its name, or its number.
        name: String,
    },
    /// The values cannot be decoded.
    #[error("the values of a page: {text}")]
    Values {
        /// What the library says.
        text: String,
    },
}

/// Why a file is no recording. Texts out of the file are shortened to 40 characters.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Fault {
    /// The source cannot be read on.
    #[error("line {line}: the source cannot be read: {kind}")]
    ReadFailed {
        /// The line that was being read.
        line: u64,
        /// What the source says.
        kind: ErrorKind,
    },
    /// There is no header.
    #[error("the file has no header")]
    NoHeader,
    /// A line is longer than is read.
    #[error("line {line}: longer than {most} bytes")]
    LineTooLong {
        /// The line.
        line: u64,
        /// Most bytes in a line.
        most: usize,
    },
    /// A quoted cell is not closed in its line.
    #[error("line {line}: a quoted cell does not end in this line")]
    QuoteOpen {
        /// The line.
        line: u64,
    },
    /// A row has more or fewer cells than the header.
    #[error("line {line}: {found} cells under a header of {expected}")]
    Ragged {
        /// The line.
        line: u64,
        /// Cells in the row.
        found: usize,
        /// Cells in the header.
        expected: usize,
    },
    /// The column that the layout names does not exist.
    #[error("no column is named \"{name}\"")]
    ColumnUnknown {
        /// What it should be read as.
        role: Role,
        /// The name in the layout.
        name: String,
        /// The name in the file that is nearest, if any is near.
        nearest: Option<String>,
        /// The columns of the file.
        headers: Vec<String>,
    },
    /// The layout names one column for two roles.
    #[error("the column \"{column}\" is named for two roles")]
    ColumnTwice {
        /// The column.
        column: String,
        /// Both roles.
        roles: [Role; 2],
    },
    /// It is no table: no number stands in the lines under the first.
    #[error("no numbers stand under the first line")]
    NoTable,
    /// No column of time is found.
    #[error("no column of time is found")]
    TimeMissing {
        /// The columns of the file.
        headers: Vec<String>,
        /// The column that it probably is.
        near: Vec<NearColumn>,
    },
    /// Neither a column of position nor one of speed is found.
    #[error("neither a column of position nor one of speed is found")]
    CourseMissing {
        /// The columns of the file.
        headers: Vec<String>,
        /// The columns that they probably are.
        near: Vec<NearColumn>,
    },
    /// Several columns could have a role.
    #[error("several columns could be the {role:?}")]
    Ambiguous {
        /// The role.
        role: Role,
        /// The columns that could have it.
        columns: Vec<String>,
        /// Their numbers, counted from 1.
        numbers: Vec<usize>,
    },
    /// The first line holds numbers: there is no heading.
    #[error("the first line holds numbers, no names of columns")]
    HeadingMissing {
        /// Cells of the line.
        columns: usize,
    },
    /// Two columns of time with one name differ.
    #[error("{at}: two columns \"{column}\" hold different times")]
    TimesDiffer {
        /// Where.
        at: FileRow,
        /// Their name.
        column: String,
        /// Their numbers, counted from 1.
        numbers: [usize; 2],
    },
    /// The file has another format.
    #[error("this is {format:?}")]
    Foreign {
        /// The format.
        format: Foreign,
    },
    /// Reading was cancelled.
    #[error("cancelled")]
    Stopped,
    /// The unit of a column is missing.
    #[error("the unit of \"{column}\" is missing")]
    UnitMissing {
        /// What the column is read as.
        role: Role,
        /// The column.
        column: String,
    },
    /// A unit is none that is known.
    #[error("\"{text}\" is no known unit")]
    UnitUnknown {
        /// What the column is read as.
        role: Role,
        /// The column.
        column: String,
        /// The unit as written.
        text: String,
        /// Who says it.
        by: KnownBy,
        /// The unit that is nearest in spelling, if any is near.
        nearest: Option<&'static Unit>,
    },
    /// A unit measures something else than the role has.
    #[error("\"{}\" is no unit of \"{column}\"", unit.ascii)]
    UnitWrong {
        /// What the column is read as.
        role: Role,
        /// The column.
        column: String,
        /// The unit.
        unit: &'static Unit,
        /// Who says it.
        by: KnownBy,
    },
    /// Two statements of a unit differ.
    #[error("\"{column}\" is said to be in \"{}\" and in \"{}\"", units[0].ascii, units[1].ascii)]
    UnitContradiction {
        /// The column.
        column: String,
        /// The units.
        units: [&'static Unit; 2],
        /// Who says which.
        by: [KnownBy; 2],
    },
    /// Position and speed are not of the same kind: one turns, the other moves along a line.
    #[error("position and speed do not belong together")]
    CourseMixed {
        /// What the position measures.
        position: Dimension,
        /// What the speed measures.
        speed: Dimension,
    },
    /// The window ends before it begins.
    #[error("the window ends before it begins")]
    WindowReversed {
        /// Its beginning.
        from: Time,
        /// Its end.
        to: Time,
    },
    /// A cell is empty or null.
    #[error("{at}: the value of \"{column}\" is missing")]
    ValueMissing {
        /// Where.
        at: FileRow,
        /// The column.
        column: String,
    },
    /// A cell is no number.
    #[error("{at}: the value of \"{column}\" is no number")]
    ValueUnreadable {
        /// Where.
        at: FileRow,
        /// The column.
        column: String,
        /// The cell as written, if it is written like a number: other text of a file is not repeated.
        text: Option<String>,
    },
    /// A number is infinite, not a number, or too large to be held in SI.
    #[error("{at}: \"{text}\" in \"{column}\" is no finite number")]
    ValueNotFinite {
        /// Where.
        at: FileRow,
        /// The column.
        column: String,
        /// The cell as written.
        text: String,
    },
    /// A number, in SI, beyond [`MAGNITUDE_MAX`](crate::MAGNITUDE_MAX).
    #[error("{at}: \"{text}\" in \"{column}\" is beyond every measurement")]
    ValueImplausible {
        /// Where.
        at: FileRow,
        /// The column.
        column: String,
        /// The number.
        text: String,
    },
    /// A number has a decimal point where others have a comma, or the reverse.
    #[error("line {line}: \"{text}\" in \"{column}\" has another decimal sign than line {decided}")]
    DecimalMixed {
        /// The line.
        line: u64,
        /// The column.
        column: String,
        /// The cell as written.
        text: String,
        /// The line that decided the decimal sign.
        decided: u64,
    },
    /// A number has signs between its thousands.
    #[error("{at}: \"{text}\" in \"{column}\" has signs between its thousands")]
    ThousandsGrouped {
        /// Where.
        at: FileRow,
        /// The column.
        column: String,
        /// The cell as written.
        text: String,
    },
    /// A column holds something else than plain numbers.
    #[error("the column \"{column}\" holds {found}, no numbers")]
    ColumnType {
        /// The column.
        column: String,
        /// Its type as the format names it.
        found: String,
    },
    /// Time runs backwards.
    #[error("{at}: the time {time} follows {before}")]
    Backwards {
        /// The later sample.
        at: FileRow,
        /// Its time.
        time: Stamp,
        /// Time of the sample before.
        before: Stamp,
    },
    /// Two samples have the same time.
    #[error("{at}: the same time {time} as {first}")]
    SameTime {
        /// The later sample.
        at: FileRow,
        /// The sample before.
        first: FileRow,
        /// Their time.
        time: Stamp,
    },
    /// Two times are closer together than [`STEP_MIN_S`](crate::STEP_MIN_S).
    #[error("{at}: only {} s after the sample before", length.value)]
    TooClose {
        /// The later sample.
        at: FileRow,
        /// Length of the interval.
        length: Time,
    },
    /// An interval is much longer than the others.
    #[error("{at}: a gap of {} s before this sample", length.value)]
    Gap {
        /// The sample after the gap.
        at: FileRow,
        /// Length of the interval.
        length: Time,
        /// Median of all intervals.
        median: Time,
    },
    /// There are too few samples, or too few inside the window.
    #[error("{found} samples, at least {least} are needed")]
    TooFewSamples {
        /// Samples that are kept.
        found: usize,
        /// Fewest samples that make a recording.
        least: usize,
        /// Samples outside the window.
        outside: u64,
        /// Time of the first and the last sample of the file.
        span: Option<[Stamp; 2]>,
    },
    /// There are more samples than are kept.
    #[error("more than {most} samples")]
    TooManySamples {
        /// Most samples that are kept.
        most: usize,
    },
    /// The file is no Parquet, is damaged, or uses what is not supported.
    #[error("the Parquet file cannot be read: {reason}")]
    ParquetUnreadable {
        /// What is wrong.
        reason: Damage,
    },
    /// The file is larger in something than is read.
    #[error("{found} {limit}, at most {most}")]
    Beyond {
        /// What there is too much of.
        limit: Limit,
        /// How much there is, or is claimed.
        found: u64,
        /// The most that is read.
        most: u64,
    },
    /// A fault that many lines have.
    #[error("{first}; {more} more like it")]
    Repeated {
        /// The first of them.
        first: Box<Fault>,
        /// How many more there are.
        more: u64,
    },
    /// There are more faults.
    #[error("{count} more faults")]
    More {
        /// How many were counted.
        count: u64,
        /// Whether the reading stopped there, so that there may be still more.
        stopped: bool,
    },
}

impl Fault {
    /// The kind of a fault of a line or of its cells.
    fn kind(&self) -> Option<FaultKind> {
        let column = match self {
            Self::ValueMissing { column, .. }
            | Self::ValueUnreadable { column, .. }
            | Self::ValueNotFinite { column, .. }
            | Self::ValueImplausible { column, .. }
            | Self::DecimalMixed { column, .. }
            | Self::TimesDiffer { column, .. }
            | Self::ThousandsGrouped { column, .. } => Some(column.clone()),
            Self::Ragged { .. }
            | Self::QuoteOpen { .. }
            | Self::Backwards { .. }
            | Self::SameTime { .. }
            | Self::TooClose { .. }
            | Self::Gap { .. } => None,
            _ => return None,
        };
        Some((std::mem::discriminant(self), column))
    }

    pub(crate) const fn too_many_samples() -> Self {
        Self::TooManySamples { most: SAMPLES_MAX }
    }
}

/// Beyond this number of faults reading stops, since the rest of a file adds nothing new.
const COUNTED_MAX: u64 = 10_000;

/// Up to this number equal faults are reported one by one; of more only the first.
const EQUAL_MAX: u64 = 3;

/// What makes faults equal: their kind, and the column.
type FaultKind = (Discriminant<Fault>, Option<String>);

/// The faults of a file, in the order found.
#[derive(Debug, Default)]
pub(crate) struct Faults {
    listed: Vec<Fault>,
    /// The kinds of those that can repeat, and how often each was found.
    kinds: Vec<(FaultKind, u64)>,
    /// How many were found and not kept.
    more: u64,
    /// Of these, how many belong to a kind of which the first is kept.
    repeated: u64,
}

impl Faults {
    pub(crate) fn push(&mut self, fault: Fault) {
        if let Some(kind) = fault.kind() {
            match self.kinds.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, count)) => {
                    *count = count.saturating_add(1);
                    if *count > EQUAL_MAX {
                        self.more = self.more.saturating_add(1);
                        self.repeated = self.repeated.saturating_add(1);
                        return;
                    }
                }
                None if self.listed.len() < FAULTS_MAX => self.kinds.push((kind, 1)),
                None => {}
            }
        }
        if self.listed.len() < FAULTS_MAX {
            self.listed.push(fault);
        } else {
            self.more = self.more.saturating_add(1);
        }
    }

    /// What is kept, with one fault in the place of many equal ones.
    fn grouped(&mut self) -> Vec<Fault> {
        let mut grouped: Vec<Fault> = Vec::new();
        let mut begun: Vec<FaultKind> = Vec::new();
        for fault in std::mem::take(&mut self.listed) {
            let kind = fault.kind();
            let count = kind.as_ref().and_then(|kind| self.kinds.iter().find(|(known, _)| known == kind));
            match (kind.clone(), count) {
                (Some(kind), Some((_, count))) if *count > EQUAL_MAX => {
                    if !begun.contains(&kind) {
                        begun.push(kind);
                        grouped.push(Fault::Repeated { first: Box::new(fault), more: count - 1 });
                    }
                }
                _ => grouped.push(fault),
            }
        }
        grouped
    }

    pub(crate) const fn none(&self) -> bool {
        self.listed.is_empty()
    }

    /// Whether reading on is of no use.
    pub(crate) const fn enough(&self) -> bool {
        self.more >= COUNTED_MAX
    }

    /// The answer, if there is no fault.
    pub(crate) fn outcome<T>(mut self, answer: Option<T>) -> Result<T, Vec<Fault>> {
        match answer {
            Some(answer) if self.listed.is_empty() => Ok(answer),
            _ => {
                let stopped = self.enough();
                let mut listed = self.grouped();
                let count = self.more - self.repeated;
                if count > 0 || stopped {
                    listed.push(Fault::More { count, stopped });
                }
                Err(listed)
            }
        }
    }
}

/// A text out of a file, shortened for a message.
pub(crate) fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    let plain = |c: char| if is_unseen(c) { '\u{fffd}' } else { c };
    let mut short: String = text.chars().take(LONGEST).map(plain).collect();
    if text.chars().nth(LONGEST).is_some() {
        short.push('…');
    }
    short
}

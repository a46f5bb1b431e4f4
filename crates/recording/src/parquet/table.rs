//! Reader of a table with any columns in parts, within the bounds of a recording: it takes no more memory than given,
//! independent of the sizes claimed in the file.

use super::footer::{Chunk, Footer, Logical, ParquetColumn, place};
use super::pages::Pages;
use super::streams::{ParquetCell, Stream};
use super::{Holds, damaged, kind, type_name, unreadable};
use crate::faults::{Damage, Fault};
use crate::limits::{Limit, TABLE_COLUMNS_MAX, TABLE_ROWS_FREE, TABLE_ROWS_PER_BYTE};
use crate::memory::Memory;
use ::parquet::basic::{ConvertedType, Type};
use bytes::Bytes;
use quantities::Unit;
use std::io::{ErrorKind, Result as IoResult};
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::AtomicU64;

/// Random access to the bytes of a file.
pub trait Ranges {
    /// Size of the file.
    fn size(&self) -> u64;

    /// Returns the bytes of a range within the file.
    ///
    /// # Errors
    /// Errors of the system.
    fn bytes(&mut self, range: Range<u64>) -> IoResult<Bytes>;
}

impl Ranges for Bytes {
    fn size(&self) -> u64 {
        self.len() as u64
    }

    fn bytes(&mut self, range: Range<u64>) -> IoResult<Bytes> {
        let place = usize::try_from(range.start).ok().zip(usize::try_from(range.end).ok());
        let place = place.filter(|(start, end)| start <= end && *end <= self.len());
        place.map(|(start, end)| self.slice(start..end)).ok_or_else(|| ErrorKind::UnexpectedEof.into())
    }
}

/// Kind of the values of a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ValueKind {
    /// Floats, doubles and decimals.
    Float,
    /// Integers with a sign.
    Integer,
    /// Integers without a sign, of 32 bits or of 64.
    Unsigned {
        /// The integers have 64 bits.
        is_long: bool,
    },
    /// Texts.
    Text,
    /// Boolean values.
    Truth,
    /// Spans of time in this unit; the values are not read.
    Duration(&'static Unit),
    /// Another kind, by the name of its type.
    Other(String),
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableColumn {
    /// Name of the column.
    pub name: String,
    /// Kind of the values.
    pub kind: ValueKind,
    /// Cells may be empty.
    pub nullable: bool,
}

/// Values of a column, `None` where a cell is empty.
#[derive(Clone, Debug, PartialEq)]
pub enum TableValues {
    /// Floats, doubles and decimals.
    Floats(Vec<Option<f64>>),
    /// Integers with a sign.
    Integers(Vec<Option<i64>>),
    /// Integers without a sign.
    Unsigned(Vec<Option<u64>>),
    /// Texts.
    Texts(Vec<Option<String>>),
    /// Boolean values.
    Truths(Vec<Option<bool>>),
    /// Number of values of another kind.
    Other(usize),
}

impl TableValues {
    /// Adds the values of further rows of the same column.
    fn append(&mut self, more: Self) {
        match (self, more) {
            (Self::Floats(values), Self::Floats(more)) => values.extend(more),
            (Self::Integers(values), Self::Integers(more)) => values.extend(more),
            (Self::Unsigned(values), Self::Unsigned(more)) => values.extend(more),
            (Self::Texts(values), Self::Texts(more)) => values.extend(more),
            (Self::Truths(values), Self::Truths(more)) => values.extend(more),
            (Self::Other(count), Self::Other(more)) => *count += more,
            // The kind of a column decides on its values, see `Table::values`.
            _ => {}
        }
    }
}

/// An open table.
pub struct Table {
    source: Box<dyn Ranges>,
    columns: Vec<TableColumn>,
    /// Columns that are read: index, type of the values, description.
    used: Vec<(usize, Holds, ParquetColumn)>,
    /// Row groups still to be read, the next one last: number of rows and chunks of each.
    groups: Vec<(u64, Vec<Chunk>)>,
    streams: Vec<Stream>,
    /// Number of rows left in the open group.
    left: u64,
    memory: Memory,
    held: u64,
}

impl Table {
    /// Opens a table; the memory for reading it is taken from `memory`.
    ///
    /// # Errors
    /// The fault of the file.
    pub fn open(mut source: Box<dyn Ranges>, mut memory: Memory) -> Result<Self, Fault> {
        const TAIL: u64 = 8;
        let size = source.size();
        let tail = source.bytes(size.saturating_sub(TAIL)..size).map_err(unread)?;
        let place = place(size, &tail)?;
        // The parsed footer takes a few times as much memory.
        memory.take((place.end - place.start).saturating_mul(8))?;
        let bytes = source.bytes(place.clone()).map_err(unread)?;
        let rows_most = TABLE_ROWS_FREE.max(size.saturating_mul(TABLE_ROWS_PER_BYTE));
        let footer = Footer::of(&bytes, place.start, rows_most)?;
        Limit::Columns.hold(footer.columns.len() as u64, TABLE_COLUMNS_MAX)?;
        let mut used = Vec::new();
        let mut columns = Vec::new();
        for (index, column) in footer.columns.iter().enumerate() {
            let (kind, holds) = value_kind(column);
            columns.push(TableColumn { name: column.path.clone(), kind, nullable: column.defined > 0 });
            used.extend(holds.map(|holds| (index, holds, column.clone())));
        }
        let wanted: Vec<usize> = used.iter().map(|(index, ..)| *index).collect();
        let mut groups = Vec::new();
        if wanted.is_empty() {
            // Rows without a readable column.
            groups.push((footer.rows, Vec::new()));
        } else {
            footer.groups(&wanted, |chunks| {
                groups.push((chunks.first().map_or(0, |chunk| chunk.values), chunks));
                Ok(())
            })?;
        }
        groups.reverse();
        Ok(Self { source, columns, used, groups, streams: Vec::new(), left: 0, memory, held: 0 })
    }

    /// Returns the columns of the table.
    #[must_use]
    pub fn columns(&self) -> &[TableColumn] {
        &self.columns
    }

    /// Skips rows.
    ///
    /// # Errors
    /// The fault of the file.
    pub fn skip(&mut self, mut rows: u64) -> Result<(), Fault> {
        while rows > 0 {
            // Whole groups are not read.
            if self.left == 0 {
                match self.groups.last() {
                    None => return Ok(()),
                    Some((count, _)) if *count <= rows => {
                        rows -= count;
                        let _ = self.groups.pop();
                        continue;
                    }
                    Some(_) => self.begin()?,
                }
            }
            let most = usize::try_from(rows.min(SKIPPED_AT_ONCE)).unwrap_or(0);
            let count = self.fill(most)?;
            rows -= (count as u64).min(rows);
            if count == 0 && self.left > 0 {
                return Err(damaged(Damage::Lengths));
            }
        }
        Ok(())
    }

    /// Returns the next `rows` rows, fewer only at the end of the table; `None` after the last. The groups of the file
    /// leave no trace: a part that is counted in rows begins at the same row whatever their sizes.
    ///
    /// # Errors
    /// The fault of the file.
    pub fn next(&mut self, rows: usize) -> Result<Option<Vec<TableValues>>, Fault> {
        let (mut found, mut count): (Option<Vec<TableValues>>, usize) = (None, 0);
        while count < rows {
            if self.left == 0 {
                if self.groups.is_empty() {
                    break;
                }
                self.begin()?;
                continue;
            }
            let more = self.fill(rows - count)?;
            if more == 0 {
                return Err(damaged(Damage::Lengths));
            }
            count += more;
            let values = self.values(more, count)?;
            match &mut found {
                None => found = Some(values),
                Some(found) => found.iter_mut().zip(values).for_each(|(found, more)| found.append(more)),
            }
        }
        Ok(found)
    }

    /// Opens the next group.
    fn begin(&mut self) -> Result<(), Fault> {
        self.streams.clear();
        self.memory.give_back(self.held);
        self.held = 0;
        let Some((rows, chunks)) = self.groups.pop() else { return Ok(()) };
        let packed = chunks.iter().map(|chunk| chunk.bytes.len() as u64).sum();
        self.memory.take(packed)?;
        self.held = packed;
        let spent: Arc<AtomicU64> = Arc::default();
        for ((index, holds, column), mut chunk) in self.used.iter().zip(chunks) {
            let range = chunk.bytes.start as u64..chunk.bytes.end as u64;
            let bytes = self.source.bytes(range).map_err(unread)?;
            chunk.bytes = 0..bytes.len();
            let memory = (self.memory.clone(), self.used.len());
            let pages = Pages::new(bytes, chunk, column, memory, Arc::clone(&spent))?;
            let name = self.columns.get(*index).map_or("", |column| column.name.as_str());
            self.streams.push(Stream::open(name, *holds, column, pages)?);
        }
        self.left = rows;
        Ok(())
    }

    /// Reads up to `most` rows of the open group and returns their number.
    fn fill(&mut self, most: usize) -> Result<usize, Fault> {
        let most = most.min(usize::try_from(self.left).unwrap_or(usize::MAX));
        let mut count = if self.streams.is_empty() { most } else { 0 };
        for (number, stream) in self.streams.iter_mut().enumerate() {
            let found = stream.fill_up_to(most).map_err(unreadable)?;
            if number > 0 && found != count {
                return Err(damaged(Damage::Lengths));
            }
            count = found;
        }
        self.left -= count as u64;
        Ok(count)
    }

    /// Returns the rows read last, column by column; `held` is their number with those before that are returned together.
    fn values(&mut self, count: usize, held: usize) -> Result<Vec<TableValues>, Fault> {
        // A text of a dictionary may occur in every row.
        let lengths = self.streams.iter().flat_map(|stream| &stream.texts).map(|text| text.len() as u64);
        let mut bounded = self.memory.clone();
        bounded.take(lengths.sum::<u64>().saturating_mul(3))?;
        bounded.take((self.columns.len() as u64).saturating_mul(held as u64).saturating_mul(CELL_BYTES))?;
        let mut found: Vec<TableValues> = self.columns.iter().map(|_| TableValues::Other(count)).collect();
        for ((index, ..), stream) in self.used.iter().zip(&self.streams) {
            let Some((slot, column)) = found.get_mut(*index).zip(self.columns.get(*index)) else { continue };
            let cells = stream.cells.iter();
            *slot = match &column.kind {
                ValueKind::Float => TableValues::Floats(cells.map(|cell| number(*cell)).collect()),
                ValueKind::Unsigned { .. } => {
                    let whole = |cell: &ParquetCell| match cell {
                        ParquetCell::Integer(value) => u64::try_from(*value).ok(),
                        // Above 2⁶³, to the precision of a float.
                        ParquetCell::Float(value) => Some(*value as u64),
                        ParquetCell::Null | ParquetCell::Text(_) | ParquetCell::Truth(_) => None,
                    };
                    TableValues::Unsigned(cells.map(whole).collect())
                }
                ValueKind::Integer => {
                    let whole =
                        |cell: &ParquetCell| if let ParquetCell::Integer(value) = cell { Some(*value) } else { None };
                    TableValues::Integers(cells.map(whole).collect())
                }
                ValueKind::Text => {
                    let text = |cell: &ParquetCell| {
                        let ParquetCell::Text(number) = cell else { return None };
                        Some(String::from_utf8_lossy(stream.texts.get(*number)?.data()).into_owned())
                    };
                    TableValues::Texts(cells.map(text).collect())
                }
                ValueKind::Truth => {
                    let truth =
                        |cell: &ParquetCell| if let ParquetCell::Truth(value) = cell { Some(*value) } else { None };
                    TableValues::Truths(cells.map(truth).collect())
                }
                ValueKind::Duration(_) | ValueKind::Other(_) => TableValues::Other(count),
            };
        }
        Ok(found)
    }
}

/// Number of rows skipped at a time.
const SKIPPED_AT_ONCE: u64 = 8192;

/// Bytes of a cell in all its representations.
const CELL_BYTES: u64 = 48;

fn number(cell: ParquetCell) -> Option<f64> {
    match cell {
        ParquetCell::Float(value) => Some(value),
        ParquetCell::Integer(value) => Some(value as f64),
        ParquetCell::Null | ParquetCell::Text(_) | ParquetCell::Truth(_) => None,
    }
}

/// Returns the kind of the values of a column and, if they can be read, their type.
fn value_kind(column: &ParquetColumn) -> (ValueKind, Option<Holds>) {
    let plain = Holds { unsigned: false, scale: None, time: None };
    let is_plain = column.logical == Logical::Plain && column.converted == ConvertedType::NONE;
    match column.physical {
        _ if column.repeated => {}
        Type::BYTE_ARRAY if column.logical == Logical::Text || column.converted == ConvertedType::UTF8 => {
            return (ValueKind::Text, Some(plain));
        }
        Type::BOOLEAN if is_plain => return (ValueKind::Truth, Some(plain)),
        _ => {}
    }
    match kind(column).filter(|holds| holds.time.is_none()) {
        Some(holds) => {
            let is_float = holds.scale.is_some() || !matches!(column.physical, Type::INT32 | Type::INT64);
            let is_long = column.physical == Type::INT64;
            let kind = match (is_float, holds.unsigned) {
                (true, _) => ValueKind::Float,
                (false, true) => ValueKind::Unsigned { is_long },
                (false, false) => ValueKind::Integer,
            };
            (kind, Some(holds))
        }
        None => match column.logical {
            Logical::Duration(unit) if !column.repeated => (ValueKind::Duration(unit), None),
            _ => (ValueKind::Other(type_name(column)), None),
        },
    }
}

fn unread(error: std::io::Error) -> Fault {
    Fault::ReadFailed { line: 0, kind: error.kind() }
}

//! Footer of a Parquet file: schema, metadata and the position of the pages.

use super::arrow::{self, Noted, TimeType};
use super::damaged;
use super::thrift::{Broken, Stop, Thrift, ThriftType};
use crate::faults::{Damage, Fault};
use crate::limits::{COLUMNS_MAX, Limit, NESTING_MAX, PATH_BYTES_MAX, ROW_GROUPS_MAX, ROWS_MAX};
use ::parquet::basic::{ConvertedType, Type};
use quantities::Unit;
use quantities::unit::{MICROSECOND, MILLISECOND, NANOSECOND};
use std::ops::Range;

/// Magic bytes at the end of a file, and those of a file with an encrypted footer.
const MARK: &[u8] = b"PAR1";
const MARK_ENCRYPTED: &[u8] = b"PARE";

/// Number of bytes after the footer: its length and the magic bytes.
const TAIL: usize = 8;

/// Maximum length of a unit in the metadata.
const UNIT_BYTES_MAX: usize = 64;

/// Content of the footer.
#[derive(Debug)]
pub(super) struct Footer<'b> {
    /// Columns of values, in the order of the schema.
    pub(super) columns: Vec<ParquetColumn>,
    /// Number of rows claimed by the file.
    pub(super) rows: u64,
    /// Units in the metadata, each with its key.
    pub(super) units: Vec<(String, String)>,
    /// List of row groups, not parsed yet.
    groups: Option<Thrift<'b>>,
    /// Number of bytes before the footer, which contain all pages.
    data: u64,
    rows_most: u64,
}

/// A column of values.
#[derive(Clone, Debug)]
pub(super) struct ParquetColumn {
    /// Name, preceded by those of the enclosing groups.
    pub(super) path: String,
    pub(super) physical: Type,
    pub(super) logical: Logical,
    /// Converted type, as used by older files.
    pub(super) converted: ConvertedType,
    /// Maximum definition level; zero if there are no nulls.
    pub(super) defined: i16,
    /// A row may have any number of values.
    pub(super) repeated: bool,
    /// Number of bytes of a value of fixed length.
    pub(super) width: u64,
    /// Number of decimal places of a decimal.
    pub(super) scale: i64,
    /// Unit in the metadata of the field.
    pub(super) unit: Option<String>,
}

/// Meaning of the values of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Logical {
    /// No logical type is stated.
    Plain,
    Integer {
        signed: bool,
    },
    /// A decimal.
    Decimal,
    /// Texts.
    Text,
    /// Times in this unit.
    Timestamp(&'static Unit),
    /// Spans of time in this unit.
    Duration(&'static Unit),
    /// Floats of two bytes.
    Half,
    /// Other data than numbers, by its name in the format.
    Other(&'static str),
}

/// The pages of a column in a row group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Chunk {
    /// Compression, as the number in the format.
    pub(super) codec: i64,
    /// Number of values including nulls.
    pub(super) values: u64,
    /// Position in the file.
    pub(super) bytes: Range<usize>,
}

/// Returns the position of the footer of a file of `size` bytes, from its last bytes.
pub(super) fn place(size: u64, tail: &[u8]) -> Result<Range<u64>, Fault> {
    let no_parquet = || damaged(Damage::NoParquet);
    let before = size.checked_sub(TAIL as u64).ok_or_else(no_parquet)?;
    let (length, mark) = tail.split_first_chunk::<4>().ok_or_else(no_parquet)?;
    match mark {
        MARK => {}
        MARK_ENCRYPTED => return Err(damaged(Damage::Encrypted)),
        _ => return Err(no_parquet()),
    }
    let start = before.checked_sub(u32::from_le_bytes(*length).into()).filter(|start| *start >= MARK.len() as u64);
    start.map(|start| start..before).ok_or_else(|| damaged(Damage::Footer))
}

impl<'b> Footer<'b> {
    /// Reads the footer of a file.
    pub(super) fn read(file: &'b [u8]) -> Result<Self, Fault> {
        let tail = file.len().checked_sub(TAIL).and_then(|at| file.get(at..)).unwrap_or_default();
        let place = place(file.len() as u64, tail)?;
        let range = usize::try_from(place.start).ok().zip(usize::try_from(place.end).ok());
        let footer = range.and_then(|(start, end)| file.get(start..end)).ok_or_else(|| damaged(Damage::Footer))?;
        Self::of(footer, place.start, ROWS_MAX)
    }

    /// Parses a footer that follows `data` bytes of pages, with at most `rows_most` rows.
    pub(super) fn of(footer: &'b [u8], data: u64, rows_most: u64) -> Result<Self, Fault> {
        let mut read = Self { columns: Vec::new(), rows: 0, units: Vec::new(), groups: None, data, rows_most };
        let (mut has_schema, mut noted) = (false, Vec::new());
        let footer = Thrift::new(footer).structure(|thrift, id, kind| {
            match (id, kind) {
                (2, ThriftType::List) => {
                    read.columns = schema(thrift)?;
                    has_schema = true;
                }
                (3, ThriftType::Integer) => read.rows = thrift.natural()?,
                (4, ThriftType::List) => {
                    read.groups = Some(thrift.clone());
                    thrift.skip(kind)?;
                }
                (5, ThriftType::List) => metadata(thrift, &mut read.units, &mut noted)?,
                (8, ThriftType::Struct) => return Err(damaged(Damage::Encrypted).into()),
                _ => thrift.skip(kind)?,
            }
            Ok(())
        });
        footer.map_err(|stop| stop.or(Damage::Footer))?;
        if !has_schema {
            return Err(damaged(Damage::Footer));
        }
        Limit::Rows.hold(read.rows, rows_most)?;
        for (index, column) in read.columns.iter_mut().enumerate() {
            column.complete(index, &noted);
        }
        Ok(read)
    }

    /// Visits the row groups with the chunks of the requested columns, in the order requested.
    pub(super) fn groups(
        &self,
        wanted: &[usize],
        mut group: impl FnMut(Vec<Chunk>) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let Some(mut thrift) = self.groups.clone() else { return Ok(()) };
        let mut each = || {
            let (kind, count) = thrift.list()?;
            if kind != ThriftType::Struct && count > 0 {
                return Err(Stop::Broken);
            }
            Limit::RowGroups.hold(count as u64, ROW_GROUPS_MAX as u64)?;
            let mut before = 0_u64;
            for _ in 0..count {
                let (rows, chunks) = self.group(&mut thrift, wanted)?;
                before = before.saturating_add(rows);
                Limit::Rows.hold(before, self.rows_most)?;
                group(chunks)?;
            }
            Ok(())
        };
        each().map_err(|stop| stop.or(Damage::Footer))
    }

    fn group(&self, thrift: &mut Thrift<'b>, wanted: &[usize]) -> Result<(u64, Vec<Chunk>), Stop> {
        let (mut rows, mut found) = (None, vec![None; self.columns.len()]);
        let mut is_wanted = vec![false; self.columns.len()];
        for index in wanted {
            if let Some(flag) = is_wanted.get_mut(*index) {
                *flag = true;
            }
        }
        thrift.structure(|thrift, id, kind| {
            match (id, kind) {
                (1, ThriftType::List) => {
                    let (kind, count) = thrift.list()?;
                    if kind != ThriftType::Struct || count != self.columns.len() {
                        return Err(Stop::Broken);
                    }
                    for (is_wanted, found) in is_wanted.iter().zip(&mut found) {
                        if *is_wanted {
                            *found = Some(self.chunk(thrift)?);
                        } else {
                            thrift.skip(kind)?;
                        }
                    }
                }
                (3, ThriftType::Integer) => rows = Some(thrift.natural()?),
                _ => thrift.skip(kind)?,
            }
            Ok(())
        })?;
        let rows = rows.ok_or(Broken)?;
        let mut chunks = Vec::new();
        for index in wanted {
            let chunk = found.get(*index).and_then(Option::as_ref).ok_or(Broken)?;
            // Columns without repetition have one value, possibly null, per row.
            if chunk.values != rows {
                return Err(damaged(Damage::Lengths).into());
            }
            chunks.push(chunk.clone());
        }
        Ok((rows, chunks))
    }

    fn chunk(&self, thrift: &mut Thrift<'b>) -> Result<Chunk, Stop> {
        let (mut codec, mut values, mut length) = (None, None, None);
        let (mut data, mut dictionary) = (None, None);
        thrift.structure(|thrift, id, kind| {
            match (id, kind) {
                (1, ThriftType::Binary) => return Err(damaged(Damage::Elsewhere).into()),
                (8, ThriftType::Struct) => return Err(damaged(Damage::Encrypted).into()),
                (3, ThriftType::Struct) => thrift.structure(|thrift, id, kind| {
                    match (id, kind) {
                        (4, ThriftType::Integer) => codec = Some(thrift.integer()?),
                        (5, ThriftType::Integer) => values = Some(thrift.natural()?),
                        (7, ThriftType::Integer) => length = Some(thrift.natural()?),
                        (9, ThriftType::Integer) => data = Some(thrift.natural()?),
                        (11, ThriftType::Integer) => dictionary = Some(thrift.natural()?),
                        _ => thrift.skip(kind)?,
                    }
                    Ok(())
                })?,
                _ => thrift.skip(kind)?,
            }
            Ok(())
        })?;
        let (codec, values, length) = (codec.ok_or(Broken)?, values.ok_or(Broken)?, length.ok_or(Broken)?);
        let data = data.ok_or(Broken)?;
        // Some writers state a dictionary at position zero where there is none.
        let start = dictionary.filter(|at| *at > 0).map_or(data, |at| at.min(data));
        let end = start.checked_add(length).filter(|end| *end <= self.data).ok_or(Broken)?;
        let place = |at: u64| usize::try_from(at).map_err(|_| Broken);
        Ok(Chunk { codec, values, bytes: place(start)?..place(end)? })
    }
}

impl ParquetColumn {
    /// Adds the type of time and the unit that the Arrow schema states. Where Parquet has a type of its own, that one
    /// counts: a writer may have converted the values.
    fn complete(&mut self, index: usize, noted: &[Noted]) {
        let own = noted.get(index).filter(|noted| noted.path == self.path);
        let Some(own) = own.or_else(|| noted.iter().find(|noted| noted.path == self.path)) else { return };
        self.unit.clone_from(&own.unit);
        // polars states that the integers have a sign.
        let is_bare = matches!(self.physical, Type::INT32 | Type::INT64)
            && matches!(self.converted, ConvertedType::NONE | ConvertedType::INT_32 | ConvertedType::INT_64)
            && matches!(self.logical, Logical::Plain | Logical::Integer { signed: true });
        match own.time {
            Some(TimeType::Duration(unit)) if is_bare => self.logical = Logical::Duration(unit),
            Some(TimeType::Instant(unit)) if is_bare => self.logical = Logical::Timestamp(unit),
            _ => {}
        }
    }
}

/// An element of the schema: a group or a column.
#[derive(Default)]
struct Element<'b> {
    name: &'b [u8],
    physical: Option<i64>,
    repetition: i64,
    children: Option<i64>,
    converted: Option<i64>,
    logical: Option<Logical>,
    width: i64,
    scale: i64,
}

/// A group of the schema whose elements follow.
struct Group {
    /// Number of elements still to come.
    left: u64,
    /// Length of the path up to the group.
    path: usize,
    defined: i16,
    repeated: bool,
}

/// Parses the columns of the schema, which lists its tree in depth-first order.
fn schema(thrift: &mut Thrift<'_>) -> Result<Vec<ParquetColumn>, Stop> {
    let (kind, count) = thrift.list()?;
    if kind != ThriftType::Struct || count == 0 {
        return Err(Stop::Broken);
    }
    let root = element(thrift)?;
    let mut open = vec![Group { left: children(&root, thrift)?, path: 0, defined: 0, repeated: false }];
    let (mut columns, mut path) = (Vec::new(), String::new());
    for _ in 1..count {
        while open.last().is_some_and(|group| group.left == 0) {
            let _ = open.pop();
        }
        let depth = open.len() as u64;
        let group = open.last_mut().ok_or(Broken)?;
        group.left -= 1;
        let each = element(thrift)?;
        path.truncate(group.path);
        if !path.is_empty() {
            path.push('.');
        }
        path.push_str(&String::from_utf8_lossy(each.name));
        Limit::PathBytes.hold(path.len() as u64, PATH_BYTES_MAX as u64)?;
        let defined = group.defined + i16::from(each.repetition != 0);
        let repeated = group.repeated || each.repetition == 2;
        if let Some(physical) = each.physical {
            Limit::Columns.hold(columns.len() as u64 + 1, COLUMNS_MAX as u64)?;
            columns.push(ParquetColumn {
                path: path.clone(),
                physical: physical_type(physical).ok_or(Broken)?,
                logical: each.logical.unwrap_or(Logical::Plain),
                converted: converted_type(each.converted),
                defined,
                repeated,
                width: u64::try_from(each.width).unwrap_or(0),
                scale: each.scale,
                unit: None,
            });
        } else {
            Limit::Nesting.hold(depth, NESTING_MAX as u64)?;
            open.push(Group { left: children(&each, thrift)?, path: path.len(), defined, repeated });
        }
    }
    if open.iter().any(|group| group.left > 0) { Err(Stop::Broken) } else { Ok(columns) }
}

/// Returns the number of elements claimed by a group; each takes at least one byte.
fn children(group: &Element<'_>, thrift: &Thrift<'_>) -> Result<u64, Broken> {
    u64::try_from(group.children.unwrap_or(0)).ok().filter(|count| *count <= thrift.left() as u64).ok_or(Broken)
}

fn element<'b>(thrift: &mut Thrift<'b>) -> Result<Element<'b>, Stop> {
    let mut read = Element::default();
    thrift.structure(|thrift, id, kind| {
        match (id, kind) {
            (1, ThriftType::Integer) => read.physical = Some(thrift.integer()?),
            (2, ThriftType::Integer) => read.width = thrift.integer()?,
            (3, ThriftType::Integer) => read.repetition = thrift.integer()?,
            (7, ThriftType::Integer) => read.scale = thrift.integer()?,
            (4, ThriftType::Binary) => read.name = thrift.binary()?,
            (5, ThriftType::Integer) => read.children = Some(thrift.integer()?),
            (6, ThriftType::Integer) => read.converted = Some(thrift.integer()?),
            (10, ThriftType::Struct) => read.logical = Some(logical(thrift)?),
            _ => thrift.skip(kind)?,
        }
        Ok(())
    })?;
    Ok(read)
}

/// Parses the union that states the logical type in its only field.
fn logical(thrift: &mut Thrift<'_>) -> Result<Logical, Stop> {
    let mut found = Logical::Other("OTHER");
    thrift.structure(|thrift, id, kind| {
        match (id, kind) {
            (1 | 4, ThriftType::Struct) => {
                found = Logical::Text;
                thrift.skip(kind)?;
            }
            (5, ThriftType::Struct) => {
                found = Logical::Decimal;
                thrift.skip(kind)?;
            }
            (7 | 8, ThriftType::Struct) => {
                let mut unit = None;
                thrift.structure(|thrift, id, kind| match (id, kind) {
                    (2, ThriftType::Struct) => thrift.structure(|thrift, id, kind| {
                        unit = match id {
                            1 => Some(&MILLISECOND),
                            2 => Some(&MICROSECOND),
                            3 => Some(&NANOSECOND),
                            _ => None,
                        };
                        Ok(thrift.skip(kind)?)
                    }),
                    _ => Ok(thrift.skip(kind)?),
                })?;
                found = unit.map_or(Logical::Other("TIME"), Logical::Timestamp);
            }
            (10, ThriftType::Struct) => {
                let mut signed = true;
                thrift.structure(|thrift, id, kind| {
                    if let (2, ThriftType::Bool(says)) = (id, kind) {
                        signed = says;
                    }
                    Ok(thrift.skip(kind)?)
                })?;
                found = Logical::Integer { signed };
            }
            (15, _) => {
                found = Logical::Half;
                thrift.skip(kind)?;
            }
            _ => {
                // Numbers of the union LogicalType in parquet.thrift.
                found = Logical::Other(match id {
                    2 => "MAP",
                    3 => "LIST",
                    6 => "DATE",
                    11 => "NULL",
                    12 => "JSON",
                    13 => "BSON",
                    14 => "UUID",
                    _ => "OTHER",
                });
                thrift.skip(kind)?;
            }
        }
        Ok(())
    })?;
    Ok(found)
}

/// Parses the metadata: units under the keys `q.unit` and `unit:q`, and the Arrow schema.
fn metadata(thrift: &mut Thrift<'_>, units: &mut Vec<(String, String)>, noted: &mut Vec<Noted>) -> Result<(), Stop> {
    let (kind, count) = thrift.list()?;
    for _ in 0..count {
        if kind != ThriftType::Struct {
            return Err(Stop::Broken);
        }
        let (mut key, mut value): (&[u8], &[u8]) = (&[], &[]);
        thrift.structure(|thrift, id, kind| {
            match (id, kind) {
                (1, ThriftType::Binary) => key = thrift.binary()?,
                (2, ThriftType::Binary) => value = thrift.binary()?,
                _ => thrift.skip(kind)?,
            }
            Ok(())
        })?;
        if key == arrow::KEY && noted.is_empty() {
            *noted = arrow::noted(value);
        }
        let is_unit = key.ends_with(b".unit") || key.starts_with(b"unit:");
        if is_unit && key.len() <= PATH_BYTES_MAX + b".unit".len() && value.len() <= UNIT_BYTES_MAX {
            Limit::Columns.hold(units.len() as u64 + 1, 2 * COLUMNS_MAX as u64)?;
            let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
            units.push((text(key), text(value)));
        }
    }
    Ok(())
}

const fn physical_type(code: i64) -> Option<Type> {
    Some(match code {
        0 => Type::BOOLEAN,
        1 => Type::INT32,
        2 => Type::INT64,
        3 => Type::INT96,
        4 => Type::FLOAT,
        5 => Type::DOUBLE,
        6 => Type::BYTE_ARRAY,
        7 => Type::FIXED_LEN_BYTE_ARRAY,
        _ => return None,
    })
}

/// Converted types, in the order of their numbers in the format.
const CONVERTED: [ConvertedType; 22] = [
    ConvertedType::UTF8,
    ConvertedType::MAP,
    ConvertedType::MAP_KEY_VALUE,
    ConvertedType::LIST,
    ConvertedType::ENUM,
    ConvertedType::DECIMAL,
    ConvertedType::DATE,
    ConvertedType::TIME_MILLIS,
    ConvertedType::TIME_MICROS,
    ConvertedType::TIMESTAMP_MILLIS,
    ConvertedType::TIMESTAMP_MICROS,
    ConvertedType::UINT_8,
    ConvertedType::UINT_16,
    ConvertedType::UINT_32,
    ConvertedType::UINT_64,
    ConvertedType::INT_8,
    ConvertedType::INT_16,
    ConvertedType::INT_32,
    ConvertedType::INT_64,
    ConvertedType::JSON,
    ConvertedType::BSON,
    ConvertedType::INTERVAL,
];

fn converted_type(code: Option<i64>) -> ConvertedType {
    let Some(code) = code else { return ConvertedType::NONE };
    // An unknown number at least shows that these are no plain numbers.
    usize::try_from(code).ok().and_then(|code| CONVERTED.get(code)).copied().unwrap_or(ConvertedType::BSON)
}

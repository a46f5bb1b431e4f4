//! Types in the Arrow schema, which writers of data frames store next to the schema of Parquet. Parquet has no type for
//! a duration: without this schema its values are bare integers.
//!
//! The schema is an Arrow message, a FlatBuffer in base64 (Arrow columnar format, *Serialization and Interprocess
//! Communication*; tables `Message`, `Schema`, `Field`, `Duration`). Every offset is checked; a schema that does not
//! follow the format states nothing.

use super::thrift::Broken;
use crate::limits::{COLUMNS_MAX, NESTING_MAX};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use quantities::Unit;
use quantities::unit::{MICROSECOND, MILLISECOND, NANOSECOND, SECOND};

/// Key of the schema in the metadata of a file.
pub(super) const KEY: &[u8] = b"ARROW:schema";

/// Maximum length of a unit in the metadata of a field.
const UNIT_BYTES_MAX: usize = 64;

/// Statements about a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Noted {
    /// Name, preceded by those of the enclosing groups.
    pub(super) path: String,
    /// Unit of a type of time.
    pub(super) time: Option<TimeType>,
    /// Unit in the metadata of the field, under `unit`.
    pub(super) unit: Option<String>,
}

/// A type of time for which Parquet may have none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TimeType {
    /// A span of time.
    Duration(&'static Unit),
    /// An instant: a date, a time of day, a timestamp.
    Instant(&'static Unit),
}

/// Returns the statements about all columns of values, in the order of the schema; none for a damaged schema.
pub(super) fn noted(text: &[u8]) -> Vec<Noted> {
    let mut found = Vec::new();
    let Ok(bytes) = STANDARD.decode(text.trim_ascii()) else { return found };
    if schema(&bytes, &mut found).is_err() {
        found.clear();
    }
    found
}

fn schema(bytes: &[u8], found: &mut Vec<Noted>) -> Result<(), Broken> {
    /// Number of a schema among the kinds of messages.
    const SCHEMA: u8 = 1;
    // A length precedes the message, and since version 0.15 a mark precedes the length.
    let (head, rest) = bytes.split_first_chunk::<4>().ok_or(Broken)?;
    let message = if *head == [0xff; 4] { rest.get(4..).ok_or(Broken)? } else { rest };
    let message = FlatTable::root(message)?;
    if message.byte(1)? != Some(SCHEMA) {
        return Err(Broken);
    }
    fields(&message.table(2)?.ok_or(Broken)?.tables(1)?, "", 0, found)
}

fn fields(fields: &[FlatTable<'_>], above: &str, depth: usize, found: &mut Vec<Noted>) -> Result<(), Broken> {
    if depth > NESTING_MAX {
        return Err(Broken);
    }
    for field in fields {
        let name = String::from_utf8_lossy(field.text(0)?.unwrap_or_default());
        let path = if above.is_empty() { name.into_owned() } else { format!("{above}.{name}") };
        let children = field.tables(5)?;
        if !children.is_empty() {
            self::fields(&children, &path, depth + 1, found)?;
            continue;
        }
        if found.len() >= COLUMNS_MAX {
            return Err(Broken);
        }
        found.push(Noted { path, time: time(field)?, unit: unit(field)? });
    }
    Ok(())
}

/// Returns the type of time of a field.
fn time(field: &FlatTable<'_>) -> Result<Option<TimeType>, Broken> {
    // Numbers of the types in the format, and of their units where none is stated.
    let (is_duration, usual) = match field.byte(2)? {
        Some(8 | 9) => (false, 1),
        Some(10) => (false, 0),
        Some(18) => (true, 1),
        _ => return Ok(None),
    };
    let is_date = field.byte(2)? == Some(8);
    let number = field.table(3)?.map(|of| of.short(0)).transpose()?.flatten().unwrap_or(usual);
    let unit = match (number, is_date) {
        // Days.
        (0, true) => return Ok(None),
        (0, false) => &SECOND,
        (1, _) => &MILLISECOND,
        (2, _) => &MICROSECOND,
        (3, _) => &NANOSECOND,
        _ => return Err(Broken),
    };
    Ok(Some(if is_duration { TimeType::Duration(unit) } else { TimeType::Instant(unit) }))
}

/// Returns the unit in the metadata of a field.
fn unit(field: &FlatTable<'_>) -> Result<Option<String>, Broken> {
    for pair in field.tables(6)? {
        let is_unit = pair.text(0)?.is_some_and(|key| key.eq_ignore_ascii_case(b"unit") || key == b"units");
        if let Some(value) = pair.text(1)?.filter(|value| is_unit && value.len() <= UNIT_BYTES_MAX) {
            return Ok(Some(String::from_utf8_lossy(value).trim().to_owned()).filter(|value| !value.is_empty()));
        }
    }
    Ok(None)
}

/// A table of a FlatBuffer; fields are addressed by their number.
#[derive(Clone, Copy)]
struct FlatTable<'b> {
    bytes: &'b [u8],
    at: usize,
}

impl<'b> FlatTable<'b> {
    /// Returns the table at the root of a buffer.
    fn root(bytes: &'b [u8]) -> Result<Self, Broken> {
        Ok(Self { bytes, at: indirect(bytes, 0)? })
    }

    /// Returns the position of the value of a field; `None` if it is absent.
    fn place(&self, field: usize) -> Result<Option<usize>, Broken> {
        let back = i32::from_le_bytes(array(self.bytes, self.at)?);
        let at = i64::try_from(self.at).map_err(|_| Broken)?;
        let offsets = usize::try_from(at - i64::from(back)).map_err(|_| Broken)?;
        let size = usize::from(u16::from_le_bytes(array(self.bytes, offsets)?));
        let slot = 4 + 2 * field;
        if slot + 2 > size {
            return Ok(None);
        }
        let offset = usize::from(u16::from_le_bytes(array(self.bytes, offsets + slot)?));
        Ok((offset > 0).then_some(self.at + offset))
    }

    fn byte(&self, field: usize) -> Result<Option<u8>, Broken> {
        self.place(field)?.map(|at| array(self.bytes, at).map(|[byte]| byte)).transpose()
    }

    fn short(&self, field: usize) -> Result<Option<i16>, Broken> {
        self.place(field)?.map(|at| array(self.bytes, at).map(i16::from_le_bytes)).transpose()
    }

    fn table(&self, field: usize) -> Result<Option<Self>, Broken> {
        let table = |at| Ok(Self { bytes: self.bytes, at: indirect(self.bytes, at)? });
        self.place(field)?.map(table).transpose()
    }

    fn text(&self, field: usize) -> Result<Option<&'b [u8]>, Broken> {
        let Some(at) = self.place(field)? else { return Ok(None) };
        let (start, length) = vector(self.bytes, at)?;
        let end = start.checked_add(length).ok_or(Broken)?;
        self.bytes.get(start..end).map(Some).ok_or(Broken)
    }

    /// Returns the tables of a vector; none if it is absent.
    fn tables(&self, field: usize) -> Result<Vec<Self>, Broken> {
        let Some(at) = self.place(field)? else { return Ok(Vec::new()) };
        let (start, count) = vector(self.bytes, at)?;
        if count > COLUMNS_MAX {
            return Err(Broken);
        }
        let table = |number: usize| Ok(Self { bytes: self.bytes, at: indirect(self.bytes, start + 4 * number)? });
        (0..count).map(table).collect()
    }
}

/// Returns the position of the first element of a vector, and the number of its elements.
fn vector(bytes: &[u8], at: usize) -> Result<(usize, usize), Broken> {
    let start = indirect(bytes, at)?;
    let count = usize::try_from(u32::from_le_bytes(array(bytes, start)?)).map_err(|_| Broken)?;
    Ok((start + 4, count))
}

/// Returns the position that an offset points to.
fn indirect(bytes: &[u8], at: usize) -> Result<usize, Broken> {
    let offset = usize::try_from(u32::from_le_bytes(array(bytes, at)?)).map_err(|_| Broken)?;
    at.checked_add(offset).filter(|place| *place < bytes.len()).ok_or(Broken)
}

fn array<const N: usize>(bytes: &[u8], at: usize) -> Result<[u8; N], Broken> {
    bytes.get(at..).and_then(<[u8]>::first_chunk::<N>).copied().ok_or(Broken)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A damaged schema states nothing and is left in bounded time.
    #[test]
    fn a_damaged_schema_states_nothing() {
        arbtest::arbtest(|u| {
            let bytes: Vec<u8> = u.arbitrary()?;
            let mut framed = vec![0xff; 4];
            framed.extend((bytes.len() as u32).to_le_bytes());
            framed.extend(&bytes);
            let mut found = Vec::new();
            let _ = schema(&framed, &mut found);
            assert!(found.len() <= COLUMNS_MAX);
            Ok(())
        });
        assert_eq!(noted(b"no base64!"), []);
        assert_eq!(noted(b""), []);
    }
}

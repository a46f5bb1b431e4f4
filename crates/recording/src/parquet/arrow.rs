//! Schema of Arrow in the metadata of a Parquet file, read as far as it says more than the types of Parquet: durations, which
//! Parquet stores as plain integers.
//!
//! The value of `ARROW:schema` is a message of Arrow's IPC format in base64, a FlatBuffer of tables that refer to their
//! fields by offsets. Every offset is checked; what does not fit together is no schema.

use crate::limits::COLUMNS_MAX;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use quantities::Unit;
use quantities::unit::{MICROSECOND, MILLISECOND, NANOSECOND, SECOND};

/// Maximum length of a schema in base64; longer ones are not read.
const SCHEMA_BYTES_MAX: usize = 4 << 20;

/// Number of the schema among the kinds of messages.
const SCHEMA: u8 = 1;
/// Number of the duration among the types.
const DURATION: u8 = 18;

/// Returns the top-level columns that hold durations, each with its unit, from the value of `ARROW:schema`.
pub(super) fn durations(schema: &[u8]) -> Vec<(String, &'static Unit)> {
    if schema.len() > SCHEMA_BYTES_MAX {
        return Vec::new();
    }
    let message = STANDARD.decode(schema.trim_ascii()).unwrap_or_default();
    found(&message).unwrap_or_default()
}

fn found(message: &[u8]) -> Option<Vec<(String, &'static Unit)>> {
    // The length of the message stands before it, since Arrow 0.15 after four bytes of ones.
    let bytes = match message.split_first_chunk::<4>()? {
        (&[0xff, 0xff, 0xff, 0xff], rest) => rest.get(4..)?,
        (_, rest) => rest,
    };
    let message = Table { bytes, at: number(bytes, 0)? };
    if message.byte(1) != Some(SCHEMA) {
        return None;
    }
    let (first, count) = message.table(2)?.vector(1)?;
    let mut durations = Vec::new();
    for place in 0..count.min(COLUMNS_MAX) {
        let at = first.checked_add(4 * place)?;
        let field = Table { bytes, at: at.checked_add(number(bytes, at)?)? };
        if field.byte(2) != Some(DURATION) {
            continue;
        }
        // Milliseconds are the value that a FlatBuffer leaves out.
        let unit = match field.table(3)?.byte(0) {
            Some(0) => &SECOND,
            None | Some(1) => &MILLISECOND,
            Some(2) => &MICROSECOND,
            Some(3) => &NANOSECOND,
            Some(_) => continue,
        };
        durations.push((field.text(0)?, unit));
    }
    Some(durations)
}

/// Table of a FlatBuffer.
#[derive(Clone, Copy)]
struct Table<'b> {
    bytes: &'b [u8],
    at: usize,
}

impl<'b> Table<'b> {
    /// Returns the position of a field; `None` if it is left out.
    fn field(&self, number_of_field: usize) -> Option<usize> {
        let back = i32::from_le_bytes(*self.bytes.get(self.at..)?.first_chunk::<4>()?);
        let list = i64::try_from(self.at).ok()?.checked_sub(i64::from(back))?;
        let list = self.bytes.get(usize::try_from(list).ok()?..)?;
        let short = |at: usize| Some(usize::from(u16::from_le_bytes(*list.get(at..)?.first_chunk::<2>()?)));
        let place = 4 + 2 * number_of_field;
        if place + 2 > short(0)? {
            return None;
        }
        short(place).filter(|offset| *offset > 0)?.checked_add(self.at)
    }

    /// Returns the position that a field refers to.
    fn target(&self, number_of_field: usize) -> Option<usize> {
        let at = self.field(number_of_field)?;
        at.checked_add(number(self.bytes, at)?)
    }

    fn byte(&self, number_of_field: usize) -> Option<u8> {
        self.bytes.get(self.field(number_of_field)?).copied()
    }

    fn table(&self, number_of_field: usize) -> Option<Self> {
        Some(Self { bytes: self.bytes, at: self.target(number_of_field)? })
    }

    /// Returns the position of the first entry and the number of entries.
    fn vector(&self, number_of_field: usize) -> Option<(usize, usize)> {
        let at = self.target(number_of_field)?;
        Some((at.checked_add(4)?, number(self.bytes, at)?))
    }

    fn text(&self, number_of_field: usize) -> Option<String> {
        let (first, length) = self.vector(number_of_field)?;
        let bytes: &'b [u8] = self.bytes.get(first..first.checked_add(length)?)?;
        Some(std::str::from_utf8(bytes).ok()?.to_owned())
    }
}

/// Returns the number of four bytes at a position.
fn number(bytes: &[u8], at: usize) -> Option<usize> {
    let four = bytes.get(at..)?.first_chunk::<4>()?;
    usize::try_from(u32::from_le_bytes(*four)).ok()
}

//! Reader of the Thrift compact protocol for untrusted input.
//!
//! Lengths and counts are checked against the remaining bytes before they are used, and nothing is allocated. Unused
//! data is skipped to a bounded depth. The reader of the library accepts the same input, but allocates the claimed
//! sizes and recurses without a bound.

use crate::faults::{Damage, Fault};

/// Maximum nesting of structures that are skipped.
const DEPTH_MAX: u8 = 32;

/// Maximum number of bytes of a 64-bit number.
const VARINT_BYTES_MAX: u32 = 10;

/// Type of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ThriftType {
    /// Boolean: a field contains its value, an element of a list takes a byte.
    Bool(bool),
    Byte,
    /// An integer of 16, 32 or 64 bits, all in the same encoding.
    Integer,
    Double,
    Binary,
    List,
    Map,
    Struct,
    Uuid,
}

impl ThriftType {
    const fn of(code: u8) -> Option<Self> {
        Some(match code {
            1 => Self::Bool(true),
            2 => Self::Bool(false),
            3 => Self::Byte,
            4..=6 => Self::Integer,
            7 => Self::Double,
            8 => Self::Binary,
            9 | 10 => Self::List,
            11 => Self::Map,
            12 => Self::Struct,
            13 => Self::Uuid,
            _ => return None,
        })
    }
}

/// The bytes do not follow the protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Broken;

/// Reason why a structure was not read: the bytes or their content.
#[derive(Debug)]
pub(super) enum Stop {
    Broken,
    Refused(Fault),
}

impl From<Broken> for Stop {
    fn from(_: Broken) -> Self {
        Self::Broken
    }
}

impl From<Fault> for Stop {
    fn from(fault: Fault) -> Self {
        Self::Refused(fault)
    }
}

impl Stop {
    /// Converts the reason to a fault; bytes that do not follow the protocol become `damage`.
    pub(super) fn or(self, damage: Damage) -> Fault {
        match self {
            Self::Broken => super::damaged(damage),
            Self::Refused(fault) => fault,
        }
    }
}

/// Cursor over the bytes.
#[derive(Clone, Debug)]
pub(super) struct Thrift<'b> {
    rest: &'b [u8],
}

impl<'b> Thrift<'b> {
    pub(super) const fn new(bytes: &'b [u8]) -> Self {
        Self { rest: bytes }
    }

    /// Returns the number of bytes not read yet.
    pub(super) const fn left(&self) -> usize {
        self.rest.len()
    }

    fn byte(&mut self) -> Result<u8, Broken> {
        let (first, rest) = self.rest.split_first().ok_or(Broken)?;
        self.rest = rest;
        Ok(*first)
    }

    fn take(&mut self, count: usize) -> Result<&'b [u8], Broken> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or(Broken)?;
        self.rest = rest;
        Ok(taken)
    }

    pub(super) fn varint(&mut self) -> Result<u64, Broken> {
        let mut value = 0;
        for place in 0..VARINT_BYTES_MAX {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f).wrapping_shl(7 * place);
            if byte & 0x80 == 0 {
                return Ok(value);
            }
        }
        Err(Broken)
    }

    pub(super) fn integer(&mut self) -> Result<i64, Broken> {
        let coded = self.varint()?;
        Ok((coded >> 1).cast_signed() ^ -((coded & 1).cast_signed()))
    }

    /// Reads a non-negative integer.
    pub(super) fn natural(&mut self) -> Result<u64, Broken> {
        u64::try_from(self.integer()?).map_err(|_| Broken)
    }

    pub(super) fn binary(&mut self) -> Result<&'b [u8], Broken> {
        let length = self.varint()?;
        self.take(usize::try_from(length).map_err(|_| Broken)?)
    }

    /// Reads the header of a list and returns type and number of its elements. Each takes at least one byte.
    pub(super) fn list(&mut self) -> Result<(ThriftType, usize), Broken> {
        let head = self.byte()?;
        // Some writers state no type for an empty list.
        if head == 0 {
            return Ok((ThriftType::Byte, 0));
        }
        let kind = ThriftType::of(head & 0x0f).ok_or(Broken)?;
        let count = match head >> 4 {
            15 => usize::try_from(self.varint()?).map_err(|_| Broken)?,
            count => usize::from(count),
        };
        if count > self.left() { Err(Broken) } else { Ok((kind, count)) }
    }

    /// Reads a structure: passes every field to `field`, which reads or skips its content.
    pub(super) fn structure(
        &mut self,
        mut field: impl FnMut(&mut Self, i64, ThriftType) -> Result<(), Stop>,
    ) -> Result<(), Stop> {
        let mut id = 0_i64;
        loop {
            let head = self.byte()?;
            if head & 0x0f == 0 {
                return Ok(());
            }
            let kind = ThriftType::of(head & 0x0f).ok_or(Broken)?;
            id = match head >> 4 {
                0 => self.integer()?,
                step => id.saturating_add(i64::from(step)),
            };
            field(self, id, kind)?;
        }
    }

    /// Skips the content of a field.
    pub(super) fn skip(&mut self, kind: ThriftType) -> Result<(), Broken> {
        match kind {
            // The value is part of the field header.
            ThriftType::Bool(_) => Ok(()),
            other => self.skip_element(other, DEPTH_MAX),
        }
    }

    fn skip_element(&mut self, kind: ThriftType, depth: u8) -> Result<(), Broken> {
        let depth = depth.checked_sub(1).ok_or(Broken)?;
        match kind {
            ThriftType::Bool(_) | ThriftType::Byte => drop(self.byte()?),
            ThriftType::Integer => drop(self.varint()?),
            ThriftType::Double => drop(self.take(8)?),
            ThriftType::Uuid => drop(self.take(16)?),
            ThriftType::Binary => drop(self.binary()?),
            ThriftType::List => {
                let (kind, count) = self.list()?;
                for _ in 0..count {
                    self.skip_element(kind, depth)?;
                }
            }
            ThriftType::Map => {
                let count = self.varint()?;
                if count > self.left() as u64 {
                    return Err(Broken);
                }
                if count > 0 {
                    let kinds = self.byte()?;
                    let key = ThriftType::of(kinds >> 4).ok_or(Broken)?;
                    let value = ThriftType::of(kinds & 0x0f).ok_or(Broken)?;
                    for _ in 0..count {
                        self.skip_element(key, depth)?;
                        self.skip_element(value, depth)?;
                    }
                }
            }
            ThriftType::Struct => loop {
                let head = self.byte()?;
                if head & 0x0f == 0 {
                    break;
                }
                if head >> 4 == 0 {
                    let _ = self.integer()?;
                }
                match ThriftType::of(head & 0x0f).ok_or(Broken)? {
                    ThriftType::Bool(_) => {}
                    kind => self.skip_element(kind, depth)?,
                }
            },
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_and_end() {
        assert_eq!(Thrift::new(&[0xac, 0x02]).varint(), Ok(300));
        assert_eq!(Thrift::new(&[0x03]).integer(), Ok(-2));
        assert_eq!(Thrift::new(&[0xff; 20]).varint(), Err(Broken));
        assert_eq!(Thrift::new(&[0x80]).varint(), Err(Broken));
    }

    #[test]
    fn a_count_without_bytes_is_refused_before_anything_is_done() {
        // 2³¹ − 1 structures in six bytes.
        assert_eq!(Thrift::new(&[0xfc, 0xff, 0xff, 0xff, 0xff, 0x07]).list(), Err(Broken));
        assert_eq!(Thrift::new(&[0xff, 0xff, 0xff, 0xff, 0x0f, b'x']).binary(), Err(Broken));
        assert_eq!(Thrift::new(&[0xff, 0x7f, 0x88]).skip(ThriftType::Map), Err(Broken));
    }

    #[test]
    fn structures_within_structures_are_passed_over_to_a_bounded_depth() {
        let nested = |depth: usize| [vec![0x1c; depth], vec![0; depth + 1]].concat();
        assert_eq!(Thrift::new(&nested(20)).skip(ThriftType::Struct), Ok(()));
        assert_eq!(Thrift::new(&nested(1_000_000)).skip(ThriftType::Struct), Err(Broken));
        assert_eq!(Thrift::new(&[0x19; 1_000_000]).skip(ThriftType::List), Err(Broken));
    }
}

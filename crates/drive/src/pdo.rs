//! Process data: permitted values of the PDO parameters, and the objects mapped into a PDO.

use crate::abort::Abort;
use crate::dictionary::{Access, Address, Dictionary, MAPPED_MOST};

/// Bit 31 of a COB-ID: the PDO is disabled.
pub(crate) const OFF: i64 = 1 << 31;

/// Offset from the index of a communication parameter to that of its mapping.
const TO_MAPPING: u16 = 0x200;

/// Largest transmission type that depends on the SYNC message.
pub(crate) const CYCLIC_MOST: i64 = 240;

/// Bits that fit into a PDO.
const BITS_MOST: i64 = 64;

/// Checks that a value may be written into a PDO parameter.
pub(crate) fn check(dictionary: &Dictionary, at: Address, value: i64) -> Result<(), Abort> {
    let is_mapping = at.index & TO_MAPPING != 0;
    if !is_mapping {
        return match at.sub {
            // Bit 30 forbids remote frames, which this bus lacks; the identifier has 11 bit.
            1 if value & 0x3FFF_F800 != 0 || value & 0x7FF == 0 => Err(Abort::Value),
            2 if !(0..=CYCLIC_MOST).contains(&value) && !matches!(value, 254 | 255) => Err(Abort::Value),
            _ => Ok(()),
        };
    }
    let parameter = at.index - TO_MAPPING;
    if dictionary.number(parameter, 1) & OFF == 0 {
        return Err(Abort::State);
    }
    let is_received = at.index < 0x1800;
    if at.sub == 0 {
        let count = u8::try_from(value).unwrap_or(MAPPED_MOST);
        let mut bits = 0;
        for sub in 1..=count {
            let mapped = dictionary.number(at.index, sub);
            carries(dictionary, mapped, is_received)?;
            bits += mapped & 0xFF;
        }
        return if bits > BITS_MOST { Err(Abort::TooLongForPdo) } else { Ok(()) };
    }
    if dictionary.number(at.index, 0) != 0 {
        return Err(Abort::State);
    }
    if value == 0 { Ok(()) } else { carries(dictionary, value, is_received) }
}

/// Returns the address of the object in a mapping entry.
pub(crate) fn address(mapped: i64) -> Address {
    let [sub, low, high] = [8, 16, 24].map(|bits| u8::try_from(mapped >> bits & 0xFF).unwrap_or(0));
    Address::new(u16::from_le_bytes([low, high]), sub)
}

/// Checks that a PDO can contain the object of a mapping entry.
fn carries(dictionary: &Dictionary, mapped: i64, is_received: bool) -> Result<(), Abort> {
    let entry = dictionary.entry(address(mapped))?;
    let is_writable = entry.access == Access::ReadWrite;
    let size = i64::from(entry.data_type.bytes()) * 8;
    if !entry.mappable || size != mapped & 0xFF || (is_received && !is_writable) {
        return Err(Abort::NotMappable);
    }
    Ok(())
}

/// A PDO as configured by its objects.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Pdo {
    /// COB-ID; `None` if the PDO is disabled.
    pub(crate) id: Option<u16>,
    /// Transmission type.
    pub(crate) kind: i64,
    /// Mapped objects.
    pub(crate) objects: Vec<Address>,
}

impl Pdo {
    /// Reads the PDO with the communication parameter at an index.
    pub(crate) fn of(dictionary: &Dictionary, parameter: u16) -> Self {
        let cob = dictionary.number(parameter, 1);
        let mapping = parameter + TO_MAPPING;
        let count = u8::try_from(dictionary.number(mapping, 0)).unwrap_or(0);
        Self {
            id: (cob & OFF == 0).then(|| u16::try_from(cob & 0x7FF).unwrap_or(0)),
            kind: dictionary.number(parameter, 2),
            objects: (1..=count).map(|sub| address(dictionary.number(mapping, sub))).collect(),
        }
    }
}

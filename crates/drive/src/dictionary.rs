//! Object dictionary of the drive: address, type, access, range and initial value of each object, and the stored
//! values.

use crate::abort::Abort;
use crate::given::Given;
use crate::scale::{INCREMENTS_USUAL, Scale};
use installation::commission::cia402::DataType;
use quantities::identified;
use std::collections::BTreeMap;

/// Address of an object: index and sub-index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Address {
    /// Index of the object.
    pub index: u16,
    /// Sub-index within the index.
    pub sub: u8,
}

impl Address {
    /// Creates the address from an index and a sub-index.
    #[must_use]
    pub const fn new(index: u16, sub: u8) -> Self {
        Self { index, sub }
    }
}

identified! {
    /// Access to an object; its identifier is the name used in an EDS.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Access {
        /// Constant value.
        Constant = "const",
        /// Written by the drive only.
        ReadOnly = "ro",
        /// Written by a controller.
        ReadWrite = "rw",
    }
}

/// Value of an object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// Integer value.
    Number(i64),
    /// Text value.
    Text(String),
}

/// Description of an object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Address of the object.
    pub at: Address,
    /// Name of the object or sub-object in the profile, which is not translated.
    pub name: &'static str,
    /// Name of the index, if it has several sub-objects.
    pub group: Option<&'static str>,
    /// Data type of the value.
    pub data_type: DataType,
    /// Access of a controller.
    pub access: Access,
    /// The object can be mapped into a PDO.
    pub mappable: bool,
    /// Smallest and largest permitted value.
    pub range: [i64; 2],
    /// Unit of the value; empty for pure numbers and bit fields.
    pub unit: &'static str,
    /// Initial value.
    pub usual: Value,
}

/// Objects of a drive with their present values.
#[derive(Clone, Debug)]
pub(crate) struct Dictionary {
    slots: BTreeMap<Address, (Entry, Value)>,
}

/// Unit of positions.
pub(crate) const INC: &str = "inc";
const INC_S: &str = "inc/s";
const INC_S2: &str = "inc/s²";

/// Upper limit of the objects mapped into one PDO.
pub(crate) const MAPPED_MOST: u8 = 8;

const fn one(index: u16, name: &'static str, data_type: DataType, usual: i64) -> Entry {
    Entry {
        at: Address::new(index, 0),
        name,
        group: None,
        data_type,
        access: Access::ReadWrite,
        mappable: false,
        range: data_type.range(),
        unit: "",
        usual: Value::Number(usual),
    }
}

impl Entry {
    fn sub(self, sub: u8, group: &'static str) -> Self {
        Self { at: Address::new(self.at.index, sub), group: Some(group), ..self }
    }

    fn constant(self) -> Self {
        Self { access: Access::Constant, ..self }
    }

    fn read_only(self) -> Self {
        Self { access: Access::ReadOnly, ..self }
    }

    fn mapped(self) -> Self {
        Self { mappable: true, ..self }
    }

    fn within(self, least: i64, most: i64) -> Self {
        Self { range: [least, most], ..self }
    }

    fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }
}

/// Returns sub-object 0 of an index with several sub-objects.
fn highest(index: u16, group: &'static str, sub: u8) -> Entry {
    one(index, "Highest sub-index supported", DataType::Unsigned8, i64::from(sub)).sub(0, group).constant()
}

/// Names of the four PDOs.
const RECEIVED: [[&str; 2]; 4] = [
    ["RPDO 1 communication parameter", "RPDO 1 mapping parameter"],
    ["RPDO 2 communication parameter", "RPDO 2 mapping parameter"],
    ["RPDO 3 communication parameter", "RPDO 3 mapping parameter"],
    ["RPDO 4 communication parameter", "RPDO 4 mapping parameter"],
];
const SENT: [[&str; 2]; 4] = [
    ["TPDO 1 communication parameter", "TPDO 1 mapping parameter"],
    ["TPDO 2 communication parameter", "TPDO 2 mapping parameter"],
    ["TPDO 3 communication parameter", "TPDO 3 mapping parameter"],
    ["TPDO 4 communication parameter", "TPDO 4 mapping parameter"],
];

/// Initial mapping of the PDOs. Received: controlword alone, with mode, with target position, with target velocity.
/// Sent: statusword alone, with mode, with position, with velocity.
///
/// # Source
/// cia-402: the predefined PDOs of the profile
const RECEIVED_USUAL: [&[u32]; 4] =
    [&[0x6040_0010], &[0x6040_0010, 0x6060_0008], &[0x6040_0010, 0x607A_0020], &[0x6040_0010, 0x60FF_0020]];
const SENT_USUAL: [&[u32]; 4] =
    [&[0x6041_0010], &[0x6041_0010, 0x6061_0008], &[0x6041_0010, 0x6064_0020], &[0x6041_0010, 0x606C_0020]];
const ENTRIES: [&str; 8] = [
    "Mapped object 1",
    "Mapped object 2",
    "Mapped object 3",
    "Mapped object 4",
    "Mapped object 5",
    "Mapped object 6",
    "Mapped object 7",
    "Mapped object 8",
];

/// Number of errors stored in 1003h.
pub(crate) const ERRORS_MOST: u8 = 8;
const ERRORS: [&str; 8] = [
    "Standard error field 1",
    "Standard error field 2",
    "Standard error field 3",
    "Standard error field 4",
    "Standard error field 5",
    "Standard error field 6",
    "Standard error field 7",
    "Standard error field 8",
];

/// Returns the objects of a drive, sorted by address.
#[must_use]
pub(crate) fn entries(given: &Given, scale: &Scale, most: [f64; 2], ramp_rad_s2: f64) -> Vec<Entry> {
    let mut list = Vec::new();
    communication(&mut list, given);
    pdos(&mut list, given.node);
    own(&mut list, given);
    profile(&mut list, scale, most, ramp_rad_s2);
    // Motor values come from the commissioning data, so that both agree.
    for object in &given.objects {
        let at = Address::new(object.index, object.sub);
        if let Some(entry) = list.iter_mut().find(|entry| entry.at == at) {
            entry.usual = Value::Number(i64::from(object.value));
            entry.unit = object.unit;
            entry.data_type = object.data_type;
        }
    }
    list.sort_by_key(|entry| entry.at);
    list
}

/// Adds the objects of CiA 301.
fn communication(list: &mut Vec<Entry>, given: &Given) {
    use DataType::{Unsigned8, Unsigned16, Unsigned32, VisibleString};
    let node = i64::from(given.node);
    let text = |index, name, text: &str| Entry {
        usual: Value::Text(text.to_owned()),
        ..one(index, name, VisibleString, 0).constant()
    };
    // A servo drive of profile 402.
    list.push(one(0x1000, "Device type", Unsigned32, 0x0002_0192).constant());
    list.push(one(0x1001, "Error register", Unsigned8, 0).read_only().mapped());
    let field = "Pre-defined error field";
    list.push(one(0x1003, "Number of errors", Unsigned8, 0).sub(0, field).within(0, 0));
    for (sub, name) in (1..).zip(ERRORS) {
        list.push(one(0x1003, name, Unsigned32, 0).sub(sub, field).read_only());
    }
    list.push(one(0x1005, "COB-ID SYNC message", Unsigned32, 0x80).constant());
    list.push(text(0x1008, "Manufacturer device name", &given.name));
    list.push(text(0x100A, "Manufacturer software version", env!("CARGO_PKG_VERSION")));
    list.push(one(0x1014, "COB-ID EMCY", Unsigned32, 0x80 + node).constant());
    let heard = "Consumer heartbeat time";
    list.push(highest(0x1016, heard, 1));
    list.push(one(0x1016, "Consumer heartbeat time 1", Unsigned32, 0).sub(1, heard).within(0, 0x007F_FFFF));
    list.push(one(0x1017, "Producer heartbeat time", Unsigned16, 0).unit("ms"));
    let identity = "Identity object";
    list.push(highest(0x1018, identity, 4));
    // Vendor id zero: no registered vendor.
    list.push(one(0x1018, "Vendor-ID", Unsigned32, 0).sub(1, identity).constant());
    list.push(one(0x1018, "Product code", Unsigned32, 0x402).sub(2, identity).constant());
    list.push(one(0x1018, "Revision number", Unsigned32, 1).sub(3, identity).constant());
    list.push(one(0x1018, "Serial number", Unsigned32, i64::from(given.seed)).sub(4, identity).constant());
}

/// Adds communication and mapping parameters of the PDOs.
fn pdos(list: &mut Vec<Entry>, node: u8) {
    use DataType::{Unsigned8, Unsigned16, Unsigned32};
    let node = i64::from(node);
    let mut kind = |base: u16, names: [[&'static str; 2]; 4], held: [&[u32]; 4], cob: i64, is_sent: bool| {
        for ((number, [parameter, mapping]), held) in (0..).zip(names).zip(held) {
            let (index, mapped) = (base + number, base + 0x200 + number);
            // Only the first PDO is enabled; the others have bit 31 set.
            let off = if number == 0 { 0 } else { 1 << 31 };
            let cob = cob + 0x100 * i64::from(number) + node + off;
            list.push(highest(index, parameter, if is_sent { 5 } else { 2 }));
            list.push(one(index, "COB-ID used by PDO", Unsigned32, cob).sub(1, parameter));
            list.push(one(index, "Transmission type", Unsigned8, 255).sub(2, parameter));
            if is_sent {
                // Continuously changing values are sent at intervals of at least 10 ms.
                let inhibit = if number < 2 { 0 } else { 100 };
                list.push(one(index, "Inhibit time", Unsigned16, inhibit).sub(3, parameter).unit("0.1 ms"));
                list.push(one(index, "Event timer", Unsigned16, 0).sub(5, parameter).unit("ms"));
            }
            let count = i64::try_from(held.len()).unwrap_or(0);
            list.push(
                one(mapped, "Number of mapped objects", Unsigned8, count)
                    .sub(0, mapping)
                    .within(0, i64::from(MAPPED_MOST)),
            );
            for (place, name) in (0_u8..).zip(ENTRIES) {
                let usual = held.get(usize::from(place)).map_or(0, |mapped| i64::from(*mapped));
                list.push(one(mapped, name, Unsigned32, usual).sub(place + 1, mapping));
            }
        }
    };
    kind(0x1400, RECEIVED, RECEIVED_USUAL, 0x200, false);
    kind(0x1800, SENT, SENT_USUAL, 0x180, true);
}

/// Adds the manufacturer-specific objects.
fn own(list: &mut Vec<Entry>, given: &Given) {
    use DataType::{Integer16, Unsigned8, Unsigned16, Unsigned32};
    list.push(one(0x2000, "Simulated time", Unsigned32, 0).read_only().mapped().unit("ms"));
    if given.has_kty {
        list.push(one(0x2001, "Winding temperature", Integer16, 0).read_only().mapped().unit("0.1 °C"));
    }
    list.push(one(0x2002, "Overload I2t", Unsigned16, 0).read_only().mapped().unit("0.1 %"));
    list.push(one(0x2003, "Brake closed", Unsigned8, 0).read_only().mapped());
    list.push(one(0x2010, "Disturbance", Unsigned8, 0).within(0, i64::from(DISTURBANCES) - 1));
}

/// Number of values of 2010h, including no disturbance.
pub(crate) const DISTURBANCES: u8 = 8;

/// Adds the objects of CiA 402.
fn profile(list: &mut Vec<Entry>, scale: &Scale, most: [f64; 2], ramp: f64) {
    use DataType::{Integer8, Integer16, Integer32, Unsigned8, Unsigned16, Unsigned32};
    let of = |rad: f64| scale.plain(rad);
    let [fastest, _] = most;
    let pi = std::f64::consts::PI;
    list.push(one(0x603F, "Error code", Unsigned16, 0).read_only().mapped());
    list.push(one(0x6040, "Controlword", Unsigned16, 0).mapped());
    list.push(one(0x6041, "Statusword", Unsigned16, 0).read_only().mapped());
    list.push(one(0x605A, "Quick stop option code", Integer16, 2).within(0, 6));
    list.push(one(0x605B, "Shutdown option code", Integer16, 0).within(0, 1));
    list.push(one(0x605C, "Disable operation option code", Integer16, 1).within(0, 1));
    list.push(one(0x605D, "Halt option code", Integer16, 1).within(1, 2));
    list.push(one(0x605E, "Fault reaction option code", Integer16, 2).within(0, 2));
    list.push(one(0x6060, "Modes of operation", Integer8, 0).mapped());
    list.push(one(0x6061, "Modes of operation display", Integer8, 0).read_only().mapped());
    list.push(one(0x6062, "Position demand value", Integer32, 0).read_only().mapped().unit(INC));
    list.push(one(0x6064, "Position actual value", Integer32, 0).read_only().mapped().unit(INC));
    // 1°, 10 ms; 0.05°, 10 ms: chosen by antrieb.
    list.push(one(0x6065, "Following error window", Unsigned32, of(pi / 180.0)).unit(INC));
    list.push(one(0x6066, "Following error time out", Unsigned16, 10).unit("ms"));
    list.push(one(0x6067, "Position window", Unsigned32, of(pi / 3600.0)).unit(INC));
    list.push(one(0x6068, "Position window time", Unsigned16, 10).unit("ms"));
    list.push(one(0x606B, "Velocity demand value", Integer32, 0).read_only().mapped().unit(INC_S));
    list.push(one(0x606C, "Velocity actual value", Integer32, 0).read_only().mapped().unit(INC_S));
    // The speed windows are in inc/s like the speeds: 16 bit of the profile would end at a hundredth of the top speed.
    list.push(one(0x606D, "Velocity window", Unsigned16, of(0.002 * fastest).min(65_535)).unit(INC_S));
    list.push(one(0x606E, "Velocity window time", Unsigned16, 10).unit("ms"));
    list.push(one(0x606F, "Velocity threshold", Unsigned16, of(0.002 * fastest).min(65_535)).unit(INC_S));
    list.push(one(0x6070, "Velocity threshold time", Unsigned16, 10).unit("ms"));
    list.push(one(0x6072, "Max torque", Unsigned16, 65_535).mapped().unit("0.1 %"));
    list.push(one(0x6073, "Max current", Unsigned16, 65_535).unit("0.1 %"));
    list.push(one(0x6075, "Motor rated current", Unsigned32, 1000).within(1, i64::from(u32::MAX)).unit("mA"));
    list.push(one(0x6076, "Motor rated torque", Unsigned32, 1000).within(1, i64::from(u32::MAX)).unit("mNm"));
    list.push(one(0x6077, "Torque actual value", Integer16, 0).read_only().mapped().unit("0.1 %"));
    list.push(one(0x6078, "Current actual value", Integer16, 0).read_only().mapped().unit("0.1 %"));
    list.push(one(0x6079, "DC link circuit voltage", Unsigned32, 0).read_only().mapped().unit("mV"));
    list.push(one(0x607A, "Target position", Integer32, 0).mapped().unit(INC));
    let limit = "Software position limit";
    list.push(highest(0x607D, limit, 2));
    let whole = Integer32.range();
    list.push(one(0x607D, "Min position limit", Integer32, whole[0]).sub(1, limit).unit(INC));
    list.push(one(0x607D, "Max position limit", Integer32, whole[1]).sub(2, limit).unit(INC));
    list.push(one(0x607E, "Polarity", Unsigned8, 0));
    list.push(one(0x607F, "Max profile velocity", Unsigned32, of(fastest)).mapped().unit(INC_S));
    list.push(one(0x6080, "Max motor speed", Unsigned32, scale.motor_rpm(fastest)).unit("1/min"));
    let positive = |index, name, value: i64, unit| {
        one(index, name, Unsigned32, value.max(1)).mapped().within(1, i64::from(u32::MAX)).unit(unit)
    };
    list.push(positive(0x6081, "Profile velocity", of(0.5 * fastest), INC_S));
    list.push(positive(0x6083, "Profile acceleration", of(0.5 * ramp), INC_S2));
    list.push(positive(0x6084, "Profile deceleration", of(0.5 * ramp), INC_S2));
    list.push(positive(0x6085, "Quick stop deceleration", of(ramp), INC_S2));
    list.push(one(0x6086, "Motion profile type", Integer16, 0).within(0, 0));
    let natural = |index, name, value: i64, sub, group| {
        one(index, name, Unsigned32, value).sub(sub, group).within(1, i64::from(u32::MAX))
    };
    let encoder = "Position encoder resolution";
    list.push(highest(0x608F, encoder, 2));
    list.push(natural(0x608F, "Encoder increments", INCREMENTS_USUAL, 1, encoder).unit(INC));
    list.push(natural(0x608F, "Motor revolutions", 1, 2, encoder));
    let gear = "Gear ratio";
    list.push(highest(0x6091, gear, 2));
    list.push(natural(0x6091, "Motor revolutions", scale.ratio(), 1, gear));
    list.push(natural(0x6091, "Shaft revolutions", 1, 2, gear));
    let feed = "Feed constant";
    list.push(highest(0x6092, feed, 2));
    list.push(natural(0x6092, "Feed", scale.increments_of_a_turn(), 1, feed).unit(INC));
    list.push(natural(0x6092, "Shaft revolutions", 1, 2, feed));
    let period = "Interpolation time period";
    list.push(highest(0x60C2, period, 2));
    list.push(one(0x60C2, "Interpolation time period value", Unsigned8, 10).sub(1, period).within(1, 255));
    list.push(one(0x60C2, "Interpolation time index", Integer8, -3).sub(2, period).within(-4, 0));
    list.push(one(0x60F4, "Following error actual value", Integer32, 0).read_only().mapped().unit(INC));
    list.push(one(0x60FF, "Target velocity", Integer32, 0).mapped().unit(INC_S));
    list.push(one(0x6402, "Motor type", Unsigned16, 10).constant());
    // Profile position, profile velocity, cyclic synchronous position.
    list.push(one(0x6502, "Supported drive modes", Unsigned32, 0b1000_0101).constant());
}

impl Dictionary {
    pub(crate) fn new(list: Vec<Entry>) -> Self {
        let slot = |entry: Entry| (entry.at, (entry.clone(), entry.usual));
        Self { slots: list.into_iter().map(slot).collect() }
    }

    /// Iterates over the objects with their initial values.
    pub(crate) fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.slots.values().map(|(entry, _)| entry)
    }

    /// Returns an object.
    pub(crate) fn entry(&self, at: Address) -> Result<&Entry, Abort> {
        self.slots.get(&at).map(|(entry, _)| entry).ok_or_else(|| {
            let of_index = Address::new(at.index, 0)..=Address::new(at.index, u8::MAX);
            if self.slots.range(of_index).next().is_some() { Abort::NoSubIndex } else { Abort::NoObject }
        })
    }

    /// Returns the stored value.
    pub(crate) fn stored(&self, at: Address) -> Option<&Value> {
        self.slots.get(&at).map(|(_, value)| value)
    }

    /// Returns the stored number; zero for a text or a missing object.
    pub(crate) fn number(&self, index: u16, sub: u8) -> i64 {
        match self.stored(Address::new(index, sub)) {
            Some(Value::Number(number)) => *number,
            Some(Value::Text(_)) | None => 0,
        }
    }

    /// Checks that a number may be written into an object.
    pub(crate) fn check(&self, at: Address, value: i64) -> Result<(), Abort> {
        let entry = self.entry(at)?;
        if entry.access != Access::ReadWrite {
            return Err(Abort::ReadOnly);
        }
        let [least, most] = entry.range;
        if value > most {
            Err(Abort::TooHigh)
        } else if value < least {
            Err(Abort::TooLow)
        } else {
            Ok(())
        }
    }

    /// Resets the objects from one index to another to their initial values.
    pub(crate) fn restart(&mut self, from: u16, to: u16) {
        for (_, (entry, value)) in self.slots.range_mut(Address::new(from, 0)..=Address::new(to, u8::MAX)) {
            value.clone_from(&entry.usual);
        }
    }

    /// Stores a number if the object exists.
    pub(crate) fn store(&mut self, index: u16, sub: u8, value: i64) {
        if let Some((_, place)) = self.slots.get_mut(&Address::new(index, sub)) {
            *place = Value::Number(value);
        }
    }
}

/// Conversion between numbers and their bytes, lowest byte first.
pub mod parts {
    use crate::{Abort, DataType};

    /// Returns the bytes of a number.
    #[must_use]
    pub fn bytes(data_type: DataType, value: i64) -> Vec<u8> {
        value.to_le_bytes().into_iter().take(usize::from(data_type.bytes())).collect()
    }

    /// Returns the number stored in bytes.
    ///
    /// # Errors
    /// The number of bytes differs from the size of the type.
    pub fn number(data_type: DataType, bytes: &[u8]) -> Result<i64, Abort> {
        let size = usize::from(data_type.bytes());
        match bytes.len() {
            given if given > size => return Err(Abort::TooLong),
            given if given < size => return Err(Abort::TooShort),
            _ => {}
        }
        let raw = bytes.iter().rev().fold(0_i64, |sum, byte| sum << 8 | i64::from(*byte));
        let [least, most] = data_type.range();
        Ok(if raw > most { raw - (most - least + 1) } else { raw })
    }
}

//! Reasons for which an object cannot be read or written.

/// An SDO abort code.
///
/// # Source
/// cia-301
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Abort {
    /// The toggle bit did not alternate.
    Toggle = 0x0503_0000,
    /// The command specifier is not valid or unknown.
    Specifier = 0x0504_0001,
    /// A read-only object was written.
    ReadOnly = 0x0601_0002,
    /// The object does not exist.
    NoObject = 0x0602_0000,
    /// The object cannot be mapped into a PDO.
    NotMappable = 0x0604_0041,
    /// Number and length of the mapped objects exceed a PDO.
    TooLongForPdo = 0x0604_0042,
    /// The data is too long for the type.
    TooLong = 0x0607_0012,
    /// The data is too short for the type.
    TooShort = 0x0607_0013,
    /// The sub-index does not exist.
    NoSubIndex = 0x0609_0011,
    /// The value is not permitted.
    Value = 0x0609_0030,
    /// The value is too high.
    TooHigh = 0x0609_0031,
    /// The value is too low.
    TooLow = 0x0609_0032,
    /// The device cannot accept the value in its present state.
    State = 0x0800_0022,
}

impl Abort {
    /// Returns the abort code transferred on the bus.
    #[must_use]
    pub const fn code(self) -> u32 {
        self as u32
    }
}

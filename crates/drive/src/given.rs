//! Data of a drive in addition to its twin.

use installation::commission::cia402::Object;

/// Data of a drive in addition to its twin.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// Node number on the bus, 1 to 127.
    pub node: u8,
    /// Manufacturer device name (1008h).
    pub name: String,
    /// Seed of the phases and the noise, also the serial number.
    pub seed: u32,
    /// Objects with values from the commissioning data of the code.
    pub objects: Vec<Object>,
    /// The feedback retains its turns by a battery.
    pub has_battery: bool,
    /// The motor connector has contacts for the KTY of the winding, so that a drive can read it.
    pub has_kty: bool,
}

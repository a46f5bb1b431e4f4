//! The place of installation that the data of an actuator hold for.

use provenance::Datum;
use quantities::{Acceleration, Length, Ratio};
use std::fmt;

/// Permissible conditions at the place of installation, besides the ambient temperature.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Environment {
    /// Altitude above sea level below which the data hold.
    pub altitude_max: Datum<Length>,
    /// Degree of protection.
    pub protection: Datum<Protection>,
    /// Relative humidity, lowest and highest.
    pub humidity: Datum<(Ratio, Ratio)>,
    /// Vibration resistance.
    pub vibration_max: Datum<Acceleration>,
    /// Shock resistance.
    pub shock_max: Datum<Acceleration>,
}

/// Degree of protection by its two numerals.
///
/// # Source
/// EN 60034-5
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Protection {
    /// First numeral: protection against contact and solid objects, 0 to 6.
    pub solids: u8,
    /// Second numeral: protection against water, 0 to 9.
    pub water: u8,
}

/// Second numerals from which on a degree does not contain the lower ones: the tests by immersion are other tests than those by jets
/// of water.
const IMMERSION: u8 = 7;

impl Protection {
    /// Reads `IP65`; `None` for anything else.
    #[must_use]
    pub fn read(text: &str) -> Option<Self> {
        let mut numerals = text.strip_prefix("IP")?.chars();
        let mut next = || numerals.next()?.to_digit(10).and_then(|numeral| u8::try_from(numeral).ok());
        let (solids, water) = (next()?, next()?);
        (numerals.next().is_none() && solids <= 6).then_some(Self { solids, water })
    }

    /// Returns `true` if what has this degree of protection meets a required one against water.
    ///
    /// # Valid
    /// Degrees against immersion (7 to 9) do not contain those against jets (5, 6): between both only the same numeral is sufficient.
    #[must_use]
    pub const fn meets_water(self, required: Self) -> bool {
        let (has, asks) = (self.water, required.water);
        has == asks || has > asks && (has < IMMERSION || asks >= IMMERSION || asks < 5)
    }

    /// Returns `true` if what has this degree of protection meets a required one against contact and solid objects.
    #[must_use]
    pub const fn meets_solids(self, required: Self) -> bool {
        self.solids >= required.solids
    }
}

impl fmt::Display for Protection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "IP{}{}", self.solids, self.water)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may fail")]
mod tests {
    use super::*;

    #[test]
    fn degrees_of_protection_are_compared_by_numeral() {
        let of = |text: &str| Protection::read(text).unwrap();
        let meets = |has: &str, asks: &str| (of(has).meets_solids(of(asks)), of(has).meets_water(of(asks)));
        assert_eq!(meets("IP65", "IP65"), (true, true));
        assert_eq!(meets("IP65", "IP54"), (true, true));
        assert_eq!(meets("IP65", "IP56"), (true, false));
        assert_eq!(meets("IP65", "IP67"), (true, false));
        assert_eq!(meets("IP54", "IP65"), (false, false));
        // Immersion does not prove jets, but drops of water.
        assert_eq!(meets("IP67", "IP65"), (true, false));
        assert_eq!(meets("IP67", "IP64"), (true, true));
        assert_eq!(meets("IP68", "IP67"), (true, true));
        assert_eq!(of("IP65").to_string(), "IP65");
        for text in ["", "IP", "IP6", "IP655", "IP75", "ip65", "65", "IP6x", "IP٦٥"] {
            assert_eq!(Protection::read(text), None, "{text}");
        }
    }
}

//! The lines of a generated project file.

use arbitrary::{Result, Unstructured};
use std::fmt::Write as _;

/// Spellings of the units of a dimension, each with the number of them per unit of the first.
pub(super) type UnitSpellings = &'static [(&'static str, f64)];

pub(super) const ANGLE: UnitSpellings = &[("deg", 1.0), ("rad", 0.017_453_292_519_943_295), ("arcmin", 60.0)];
pub(super) const SPEED: UnitSpellings = &[("1/min", 1.0), ("rad/s", 0.104_719_755), ("deg/s", 6.0)];
pub(super) const ACCELERATION: UnitSpellings = &[("rad/s^2", 1.0)];
pub(super) const JERK: UnitSpellings = &[("rad/s^3", 1.0)];
pub(super) const LENGTH: UnitSpellings = &[("mm", 1.0), ("m", 1e-3)];
pub(super) const WAY_SPEED: UnitSpellings = &[("m/s", 1.0)];
pub(super) const WAY_ACCELERATION: UnitSpellings = &[("m/s^2", 1.0)];
pub(super) const WAY_JERK: UnitSpellings = &[("m/s^3", 1.0)];
pub(super) const TIME: UnitSpellings = &[("s", 1.0), ("ms", 1e3)];
pub(super) const LIFE: UnitSpellings = &[("h", 1.0)];
pub(super) const MASS: UnitSpellings = &[("kg", 1.0), ("g", 1e3)];
pub(super) const INERTIA: UnitSpellings = &[("kg m^2", 1.0), ("kg cm^2", 1e4)];
pub(super) const TORQUE: UnitSpellings = &[("N m", 1.0)];
pub(super) const FORCE: UnitSpellings = &[("N", 1.0), ("kN", 1e-3)];
pub(super) const VOLTAGE: UnitSpellings = &[("V", 1.0)];
pub(super) const CURRENT: UnitSpellings = &[("A", 1.0)];
pub(super) const TEMPERATURE: UnitSpellings = &[("degC", 1.0)];

/// Numbers at the limits of real machines, of the file format and of a float.
const EDGES: [&str; 12] =
    ["0", "-1", "1e-300", "1e-12", "1e-6", "1e-3", "1e4", "1e6", "1e9", "1e12", "1e300", "1.7e308"];

/// The text written so far, and settings of the generation.
pub(super) struct Page<'u, 'b> {
    pub(super) u: &'u mut Unstructured<'b>,
    pub(super) text: String,
    /// Prefix of table names: `axis.` for one of several axes.
    pub(super) prefix: &'static str,
    pub(super) tolerances: usize,
    /// Some amounts take extreme values.
    pub(super) edges: bool,
    /// A stage may have several ratios.
    pub(super) ratios: bool,
    /// Keys of `[bearing]` that affect the loads of the mechanism; empty if none do.
    pub(super) effective: &'static [&'static str],
}

impl Page<'_, '_> {
    pub(super) fn table(&mut self, name: &str) {
        let _ = writeln!(self.text, "[{}{name}]", self.prefix);
    }

    pub(super) fn row(&mut self, name: &str) {
        let _ = writeln!(self.text, "[[{}{name}]]", self.prefix);
    }

    /// Writes a key with a value as given.
    pub(super) fn plain(&mut self, key: &str, value: impl std::fmt::Display) {
        let _ = writeln!(self.text, "{key} = {value}");
    }

    pub(super) fn word(&mut self, key: &str, value: &str) {
        let _ = writeln!(self.text, "{key} = \"{value}\"");
    }

    pub(super) fn often(&mut self) -> Result<bool> {
        self.u.ratio(3, 4)
    }

    pub(super) fn seldom(&mut self) -> Result<bool> {
        self.u.ratio(1, 6)
    }

    /// Returns a number between two, evenly distributed over its powers of ten.
    pub(super) fn between(&mut self, low: f64, high: f64) -> Result<f64> {
        let share = f64::from(self.u.arbitrary::<u8>()?) / 255.0;
        Ok(if low > 0.0 { low * (high / low).powf(share) } else { low + (high - low) * share })
    }

    /// Returns a quantity of this size, in some cases with an extreme value or a tolerance.
    pub(super) fn amount(&mut self, value: f64, units: UnitSpellings) -> Result<String> {
        let (unit, factor) = *self.u.choose(units)?;
        if self.edges && self.u.ratio(1, 24)? {
            return Ok(format!("{} {unit}", self.u.choose(&EDGES)?));
        }
        let mut text = format!("{} {unit}", rounded(value * factor));
        if self.tolerances > 0 && self.u.ratio(1, 6)? {
            self.tolerances -= 1;
            let half = self.u.choose(&["5 %", "1 %", "20 %", "0.1 %", "60 %"])?;
            let _ = write!(text, " ± {half}");
        }
        Ok(text)
    }

    /// Writes a key with a quantity of this size.
    pub(super) fn exactly(&mut self, key: &str, value: f64, units: UnitSpellings) -> Result<()> {
        let amount = self.amount(value, units)?;
        self.word(key, &amount);
        Ok(())
    }

    /// Returns a quantity of this size without tolerance or extreme value, for values that others must agree with.
    pub(super) fn literal(&mut self, value: f64, units: UnitSpellings) -> Result<String> {
        let (unit, factor) = *self.u.choose(units)?;
        Ok(format!("{} {unit}", rounded(value * factor)))
    }

    /// Writes a key with a quantity between two sizes.
    pub(super) fn key(&mut self, key: &str, low: f64, high: f64, units: UnitSpellings) -> Result<()> {
        let value = self.between(low, high)?;
        self.exactly(key, value, units)
    }

    /// Writes the key in a share of the cases.
    pub(super) fn may(&mut self, key: &str, low: f64, high: f64, units: UnitSpellings) -> Result<()> {
        if self.u.ratio(1, 3)? { self.key(key, low, high, units) } else { Ok(()) }
    }

    /// Writes a plain number.
    pub(super) fn number(&mut self, key: &str, low: f64, high: f64) -> Result<()> {
        let value = rounded(self.between(low, high)?);
        self.plain(key, value);
        Ok(())
    }

    /// Writes a plain number in a share of the cases.
    pub(super) fn may_number(&mut self, key: &str, low: f64, high: f64) -> Result<()> {
        if self.u.ratio(1, 3)? { self.number(key, low, high) } else { Ok(()) }
    }

    /// Writes one of several words in a share of the cases.
    pub(super) fn may_word(&mut self, key: &str, words: &[&str]) -> Result<()> {
        if self.u.ratio(1, 3)? {
            let word = *self.u.choose(words)?;
            self.word(key, word);
        }
        Ok(())
    }
}

/// Rounds to three significant digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

//! Numbers in the form of data exchange.

use quantities::Unit;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// A number as computed, written with twelve significant digits, which removes digits caused by a change of unit only.
/// A value that is not finite is written `null`, a negative zero as zero.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Number(pub f64);

impl Number {
    /// Converts an SI value to a unit.
    #[must_use]
    pub fn in_unit(si: f64, unit: &Unit) -> Self {
        Self(unit.from_si(si))
    }

    /// Returns the number as written; `None` if it is not finite.
    #[must_use]
    pub fn written(self) -> Option<f64> {
        if !self.0.is_finite() {
            return None;
        }
        Some(if self.0 == 0.0 { 0.0 } else { format!("{:.11e}", self.0).parse().unwrap_or(self.0) })
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.written() {
            Some(number) => serializer.serialize_f64(number),
            None => serializer.serialize_unit(),
        }
    }
}

impl JsonSchema for Number {
    fn schema_name() -> Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "rounded to twelve significant digits; null where it is not finite",
            "type": ["number", "null"]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twelve_digits_and_no_noise() {
        let written = |value: f64| serde_json::to_string(&Number(value)).unwrap_or_default();
        assert_eq!(written(0.1 + 0.2), "0.3");
        assert_eq!(written(-0.0), "0.0");
        assert_eq!(written(216.0), "216.0");
        assert_eq!(written(123_456_789.012_345_6), "123456789.012");
        assert_eq!(written(f64::INFINITY), "null");
        assert_eq!(written(f64::NAN), "null");
    }
}

//! Numbers as data exchange has them.

use quantities::Unit;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// A number, kept as it was computed and written with twelve significant digits: without those that only a change of unit
/// has made. What is not finite is written `null`, a negative zero as zero.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Number(pub f64);

impl Number {
    /// An SI value in a unit.
    #[must_use]
    pub fn in_unit(si: f64, unit: &Unit) -> Self {
        Self(unit.from_si(si))
    }

    /// The number as it is written, if it is.
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

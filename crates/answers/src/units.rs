//! Units of the figures of a record.

use quantities::Unit;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// Units of the figures, by symbol or field: `{"T": "Nm", "n": "1/min"}`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Units(Vec<(&'static str, &'static str)>);

impl Units {
    /// Creates the units of the given fields.
    #[must_use]
    pub fn of(units: &[(&'static str, &Unit)]) -> Self {
        Self(units.iter().map(|(of, unit)| (*of, unit.json)).collect())
    }

    /// Returns the unit of a field in the form of data exchange.
    #[must_use]
    pub fn unit(&self, of: &str) -> Option<&'static str> {
        self.0.iter().find(|(name, _)| *name == of).map(|(_, unit)| *unit)
    }
}

impl Serialize for Units {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}

impl JsonSchema for Units {
    fn schema_name() -> Cow<'static, str> {
        "Units".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "the units of the figures, by symbol or field",
            "type": "object",
            "additionalProperties": { "type": "string" }
        })
    }
}

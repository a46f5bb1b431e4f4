//! JSON Schema of the answers, the source of their reference page.

use crate::Fit;
use schemars::{JsonSchema, SchemaGenerator, generate::SchemaSettings};
use serde::Serialize;
use serde_json::{Map, Value, json};

/// Version of the records. It increases when a field is removed or changes its meaning, not when one is added.
pub const VERSION: u32 = 1;

/// Answers for several axes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "Axes_of_{T}")]
pub struct Axes<T> {
    /// Worst verdict of the axes.
    pub verdict: Fit,
    /// Answer for each axis.
    pub axes: Vec<T>,
}

/// Answer for one axis or for several.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(rename = "Answered_for_{T}")]
pub enum Answered<T> {
    /// Answer for the only axis.
    One(T),
    /// Answers for several axes.
    Several(Axes<T>),
}

impl<T> Answered<T> {
    /// Wraps the answers of all axes: a single one unchanged, several with the common verdict.
    #[must_use]
    pub fn of(axes: Vec<T>, verdict: Fit) -> Self {
        match <[T; 1]>::try_from(axes) {
            Ok([one]) => Self::One(one),
            Err(axes) => Self::Several(Axes { verdict, axes }),
        }
    }
}

/// The record that answers a command, with its schema.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// Command, including the option that changes the answer.
    pub command: &'static str,
    schema: fn(&mut SchemaGenerator) -> schemars::Schema,
}

impl Record {
    /// Creates the entry for the record `T` as the answer of a command.
    #[must_use]
    pub const fn of<T: JsonSchema>(command: &'static str) -> Self {
        Self { command, schema: SchemaGenerator::subschema_for::<T> }
    }
}

/// Generates the JSON Schema of answers: one per command under `properties`, the shared records under `$defs`.
#[must_use]
pub fn schema(records: &[Record]) -> Value {
    let mut generator = SchemaSettings::draft2020_12().into_generator();
    let mut properties = Map::new();
    for record in records {
        properties.insert(record.command.to_owned(), (record.schema)(&mut generator).into());
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Answers of antrieb",
        "description": format!("what `--json` writes for each command, version {VERSION}"),
        "type": "object",
        "properties": properties,
        "$defs": generator.take_definitions(true),
    })
}

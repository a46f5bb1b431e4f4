//! The JSON Schema of every answer, and the reference page made from it.

use crate::{
    Battery, Bearings, CatalogueCell, CodeFaults, CodeReading, CommissionAnswer, CommissionWritten, Comparison,
    Completion, Curves, Difference, Errata, Explanations, ExportWritten, Faults, FilesWritten, Fit, Glossary, Inertia,
    Judgement, Licences, ListedCode, Motion, Mount, PlotWritten, Recorded, ReportWritten, Sheet, Sizing, Table,
    Torsion, Upkeep, Wiring, WiringCheck,
};
use schemars::{JsonSchema, SchemaGenerator, generate::SchemaSettings};
use serde::Serialize;
use serde_json::{Map, Value};

/// Version of the records. It rises when a field goes or changes its meaning, not when one is added.
pub const VERSION: u32 = 1;

/// The answers of several axes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "Axes_of_{T}")]
pub struct Axes<T> {
    /// Whether every axis fits.
    pub verdict: Fit,
    /// The answer of each axis.
    pub axes: Vec<T>,
}

/// The answer of the only axis, or those of several.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
#[schemars(rename = "Answered_for_{T}")]
pub enum Answered<T> {
    /// Of one axis.
    One(T),
    /// Of several.
    Several(Axes<T>),
}

impl<T> Answered<T> {
    /// The answer of all axes: one alone as it is, several with whether every one fits.
    #[must_use]
    pub fn of(mut axes: Vec<T>, fits: bool) -> Self {
        match (axes.len(), axes.pop()) {
            (1, Some(one)) => Self::One(one),
            (_, last) => {
                axes.extend(last);
                Self::Several(Axes { verdict: Fit::of(fits), axes })
            }
        }
    }
}

/// A command and the record that it answers with.
struct CommandRecord {
    command: &'static str,
    schema: fn(&mut SchemaGenerator) -> schemars::Schema,
}

const fn one<T: JsonSchema>(command: &'static str) -> CommandRecord {
    CommandRecord { command, schema: SchemaGenerator::subschema_for::<T> }
}

/// Every command with an answer, in the order of the reference page.
const ENTRIES: &[CommandRecord] = &[
    one::<Answered<Sizing>>("size"),
    one::<Answered<Judgement>>("check"),
    one::<Answered<Explanations>>("explain"),
    one::<Answered<Comparison>>("compare"),
    one::<Answered<Difference>>("diff"),
    one::<Answered<Bearings>>("bearing"),
    one::<Motion>("moves"),
    one::<Curves>("curve"),
    one::<Torsion>("torsion"),
    one::<Battery>("battery"),
    one::<Mount>("mount"),
    one::<Upkeep>("upkeep"),
    one::<Inertia>("inertia"),
    one::<CommissionAnswer>("commission"),
    one::<Recorded>("commission --record"),
    one::<Vec<CommissionWritten>>("commission --out"),
    one::<Glossary>("glossary"),
    one::<Licences>("licences"),
    one::<FilesWritten>("new --out"),
    one::<ReportWritten>("report"),
    one::<ExportWritten>("export --out"),
    one::<Table>("export --table"),
    one::<PlotWritten>("plot"),
    one::<CodeReading>("code parse"),
    one::<Vec<ListedCode>>("code list"),
    one::<Completion>("code complete"),
    one::<Sheet>("data"),
    one::<Wiring>("wiring"),
    one::<WiringCheck>("wiring --check"),
    one::<Errata>("errata"),
    one::<Vec<CatalogueCell>>("catalogue export"),
    one::<CodeFaults>("faults of a code"),
    one::<Faults>("faults"),
];

/// The JSON Schema of the answers: each command's under `properties`, the records that they share under `$defs`.
#[must_use]
pub fn schema() -> Value {
    let mut generator = SchemaSettings::draft2020_12().into_generator();
    let mut properties = Map::new();
    for entry in ENTRIES {
        properties.insert(entry.command.to_owned(), (entry.schema)(&mut generator).into());
    }
    let definitions = generator.take_definitions(true);
    let mut root = Map::new();
    root.insert("$schema".into(), "https://json-schema.org/draft/2020-12/schema".into());
    root.insert("title".into(), "Answers of antrieb".into());
    root.insert("description".into(), format!("what `--json` writes for each command, version {VERSION}").into());
    root.insert("type".into(), "object".into());
    root.insert("properties".into(), Value::Object(properties));
    root.insert("$defs".into(), Value::Object(definitions));
    Value::Object(root)
}

//! Run of the digital twin.

use crate::{Id, Number};
use provenance::Grade;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use sizing::Verdict;
use std::borrow::Cow;
use twin::{EventKind, Loop, Reaction, ScenarioId};

/// `simulate`: what the digital twin of an axis does.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Simulation {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or the name of the project's own actuator.
    pub code: String,
    /// What happens.
    pub scenario: Id<ScenarioId>,
    /// The scenario in words.
    pub title: String,
    /// When it happens \[s\]; `null`: the whole run is the scenario.
    pub at: Option<Number>,
    /// How the drive reacts to a stop and to its own faults.
    pub reaction: Id<Reaction>,
    /// Cycles that are run.
    pub cycles: u32,
    /// Seed of phases and noise.
    pub seed: u64,
    /// Simulated time \[s\].
    pub time: Number,
    /// Steps of the solver.
    pub steps: u64,
    /// One of them \[µs\].
    pub step: Number,
    /// Temperature of the air \[°C\].
    pub ambient: Number,
    /// Temperatures of winding and housing at the start \[°C\].
    pub start: [Number; 2],
    /// The run in figures.
    pub summary: Figures,
    /// Operation over days by the mean losses of the cycle, in figures; `null` where no days are requested.
    pub averaged: Option<Figures>,
    /// Figures with a limit.
    pub verdicts: Vec<SimulatedVerdict>,
    /// What happened, by time.
    pub events: Vec<SimulatedEvent>,
    /// How the encoder failed; `null`: it did not.
    pub encoder_failure: Option<EncoderFailure>,
    /// What the sizing said, what the twin shows, and why they differ; of the cycle alone.
    pub comparison: Vec<Compared>,
    /// The loops of the control, the innermost first.
    pub loops: Vec<ControlLoop>,
    /// The gains in use.
    pub gains: Figures,
    /// Whether they follow from the rule; else the project states some.
    pub gains_by_rule: bool,
    /// Every parameter of the model.
    pub parameters: Vec<ModelParameter>,
    /// What was assumed or left out, in words.
    pub notes: Vec<String>,
    /// The file that the course was written to; `null`: none.
    pub trace: Option<String>,
}

/// Figures, written as an object by their identifiers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures(pub Vec<Figure>);

/// A figure with its unit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Figure {
    /// Identifier.
    #[serde(skip)]
    pub id: &'static str,
    /// In words.
    pub title: String,
    /// The value; `null` where there is none.
    pub value: Option<Number>,
    /// Its unit.
    pub unit: &'static str,
}

impl Serialize for Figures {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|figure| (figure.id, figure)))
    }
}

impl JsonSchema for Figures {
    fn schema_name() -> Cow<'static, str> {
        "Figures".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let figure = generator.subschema_for::<Figure>();
        json_schema!({ "type": "object", "additionalProperties": figure })
    }
}

/// A figure with its limit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedVerdict {
    /// Identifier.
    pub id: &'static str,
    /// In words.
    pub title: String,
    /// Whether the limit is kept.
    pub verdict: Id<Verdict>,
    /// The value.
    pub value: Option<Number>,
    /// The largest permitted.
    pub limit: Option<Number>,
    /// Unit of both.
    pub unit: &'static str,
    /// How far the limit can be trusted.
    pub grade: Option<Id<Grade>>,
    /// Where the limit is from.
    pub source: Option<String>,
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedEvent {
    /// When \[s\].
    pub time: Number,
    /// What.
    pub event: Id<EventKind>,
    /// In words.
    pub title: String,
}

/// An encoder that fails, and what the drive notices of it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderFailure {
    /// What fails: a failure of the scenario, or `battery`.
    pub failure: &'static str,
    /// How the drive notices it; `null`: it does not.
    pub finding: Option<&'static str>,
    /// After which time \[ms\].
    pub after: Option<Number>,
    /// The angle that is read less the true one, at the output, when it is noticed, else at the end \[°\].
    pub error: Number,
    /// The whole in words.
    pub title: String,
}

/// A figure of the sizing beside that of the twin.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Compared {
    /// The check of the sizing.
    pub id: Id<sizing::CheckId>,
    /// In words.
    pub title: String,
    /// What the sizing said.
    pub sizing: Number,
    /// What the twin shows.
    pub twin: Number,
    /// Unit of both.
    pub unit: &'static str,
    /// Why they differ, in words.
    pub why: String,
}

/// A loop with its margins.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ControlLoop {
    /// Which.
    pub id: Id<Loop>,
    /// In words.
    pub title: String,
    /// Frequency at which the open loop has magnitude one \[Hz\].
    pub crossover: Option<Number>,
    /// Phase margin \[°\].
    pub phase_margin: Option<Number>,
    /// Gain margin \[dB\].
    pub gain_margin: Option<Number>,
    /// Frequency up to which it follows within 3 dB \[Hz\].
    pub bandwidth: Option<Number>,
    /// Whether it is stable.
    pub stable: bool,
}

/// A parameter of the model.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ModelParameter {
    /// Its key.
    pub key: &'static str,
    /// Its value; `null` where nothing is known.
    pub value: Option<Number>,
    /// Its unit.
    pub unit: &'static str,
    /// How far it can be trusted.
    pub grade: Option<Id<Grade>>,
    /// Where it is from.
    pub source: Option<String>,
}

//! Run of the digital twin.

use crate::{AssumptionEntry, Id, Number};
use provenance::Grade;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use sizing::{RunCheckId, Verdict};
use std::borrow::Cow;
use twin::{EventEffect, EventKind, Loop, MotionDirection, Reaction, ScenarioId};

/// `simulate`: behaviour of the digital twin of an axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Simulation {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or the name of the project's own actuator.
    pub code: String,
    /// Id of the scenario.
    pub scenario: Id<ScenarioId>,
    /// Name of the scenario.
    pub title: String,
    /// Instant of the event \[s\]; `null` if the whole run is the scenario.
    pub at: Option<Number>,
    /// Choice of this instant as the worst one; `null` if it is stated or the scenario has none.
    pub instant: Option<WorstInstant>,
    /// Reaction of the servo drive to a stop and to its own faults.
    pub reaction: Id<Reaction>,
    /// Number of cycles.
    pub cycles: u32,
    /// Seed of phases and noise.
    pub seed: u64,
    /// Simulated time \[s\].
    pub time: Number,
    /// Number of steps of the solver.
    pub steps: u64,
    /// Duration of one step \[µs\].
    pub step: Number,
    /// Ambient temperature \[°C\].
    pub ambient: Number,
    /// Temperatures of winding and housing at the start \[°C\].
    pub start: [Number; 2],
    /// Figures of the run.
    pub summary: Figures,
    /// Figures of an operation over days with the mean losses of the cycle; `null` if no days are requested.
    pub averaged: Option<Figures>,
    /// Temperatures over the first and the last day of this operation; empty if no days are requested.
    pub days: Vec<DayOfOperation>,
    /// Figures with a limit.
    pub verdicts: Vec<SimulatedVerdict>,
    /// Events in chronological order.
    pub events: Vec<SimulatedEvent>,
    /// Failure of the encoder; `null` if there is none.
    pub encoder_failure: Option<EncoderFailure>,
    /// Results of sizing and twin with the reason for the difference; for the cycle only.
    pub comparison: Vec<Compared>,
    /// Control loops, the innermost first.
    pub loops: Vec<ControlLoop>,
    /// Gains in use.
    pub gains: Figures,
    /// `true` if the gains follow from the rule; `false` if the project states some.
    pub gains_by_rule: bool,
    /// Parameters of the model.
    pub parameters: Vec<ModelParameter>,
    /// Choices and omissions of the model, as text.
    pub notes: Vec<String>,
    /// Assumptions of the axis.
    pub assumptions: Vec<AssumptionEntry>,
    /// File of the recorded signals; `null` if none was written.
    pub trace: Option<String>,
}

/// Choice of the worst instant of an event.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorstInstant {
    /// Id of the effect by which the worst instant is chosen.
    pub effect: Id<EventEffect>,
    /// Number of instants examined.
    pub examined: u32,
    /// `true` if the limit of the steps left further instants out.
    pub limited: bool,
    /// Worst instant of every direction of motion, the chosen one first.
    pub directions: Vec<WorstOfDirection>,
    /// Farthest ways beyond the ends of the motion; empty if the axis stays between them or has none.
    pub overruns: Vec<EndOverrun>,
    /// Choice as text.
    pub title: String,
}

/// Farthest way beyond an end of the motion after an event.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EndOverrun {
    /// Direction of the output in which the end is passed.
    pub end: Id<MotionDirection>,
    /// Instant of the event \[s\].
    pub at: Number,
    /// Distance of the farthest position from the end.
    pub value: Number,
    /// Unit of the distance: mm along a linear axis, else degrees.
    pub unit: &'static str,
    /// The axis comes to rest within the examined time.
    pub rests: bool,
}

/// Worst instant of a direction of motion.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct WorstOfDirection {
    /// Direction of the output at the instant.
    pub direction: Id<MotionDirection>,
    /// Instant \[s\].
    pub at: Number,
    /// Effect of the event at this instant.
    pub value: Number,
    /// Unit of the effect.
    pub unit: &'static str,
    /// `true` if the axis comes to rest within two seconds, or if the event does not stop it.
    pub rests: bool,
}

/// Temperatures over a day of operation.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DayOfOperation {
    /// Number of the day, from one.
    pub day: u32,
    /// Temperatures at the beginning of the day and at the end of each hour.
    pub hours: Vec<HourOfOperation>,
}

/// Temperatures at the end of an hour.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct HourOfOperation {
    /// Time since the beginning of the day \[h\]; the operation begins at zero.
    pub hour: u32,
    /// Mean temperature of the winding over a cycle \[°C\].
    pub winding: Number,
    /// Highest temperature of the winding in this hour, within a cycle \[°C\].
    pub winding_peak: Number,
    /// Temperature of the housing \[°C\].
    pub housing: Number,
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
    /// Name of the figure.
    pub title: String,
    /// Value; `null` if there is none.
    pub value: Option<Number>,
    /// Unit of the value.
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
    pub id: Id<RunCheckId>,
    /// Name of the figure.
    pub title: String,
    /// Verdict on the limit.
    pub verdict: Id<Verdict>,
    /// Value of the figure.
    pub value: Option<Number>,
    /// Largest permitted value.
    pub limit: Option<Number>,
    /// Unit of value and limit.
    pub unit: &'static str,
    /// Grade of the limit.
    pub grade: Option<Id<Grade>>,
    /// Source of the limit.
    pub source: Option<String>,
}

/// An event of the run.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedEvent {
    /// Instant \[s\].
    pub time: Number,
    /// Kind of event.
    pub event: Id<EventKind>,
    /// Name of the event.
    pub title: String,
}

/// A failing encoder, and its detection by the servo drive.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EncoderFailure {
    /// Kind of failure: a failure of the scenario, or `battery`.
    pub failure: &'static str,
    /// Kind of detection by the servo drive; `null` if it is not detected.
    pub finding: Option<&'static str>,
    /// Time until detection \[ms\].
    pub after: Option<Number>,
    /// Measured minus true angle at the output, at detection, else at the end \[°\].
    pub error: Number,
    /// Failure and detection as text.
    pub title: String,
}

/// A figure of the sizing next to that of the twin.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Compared {
    /// Id of the check of the sizing.
    pub id: Id<sizing::CheckId>,
    /// Name of the check.
    pub title: String,
    /// Result of the sizing.
    pub sizing: Number,
    /// Result of the twin.
    pub twin: Number,
    /// Unit of both results.
    pub unit: &'static str,
    /// Reason for the difference, as text.
    pub why: String,
}

/// A control loop with its margins.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ControlLoop {
    /// Id of the loop.
    pub id: Id<Loop>,
    /// Name of the loop.
    pub title: String,
    /// Frequency at which the open loop has magnitude one \[Hz\].
    pub crossover: Option<Number>,
    /// Phase margin \[°\].
    pub phase_margin: Option<Number>,
    /// Gain margin \[dB\].
    pub gain_margin: Option<Number>,
    /// Frequency up to which the loop follows within 3 dB \[Hz\].
    pub bandwidth: Option<Number>,
    /// `true` if the loop is stable.
    pub stable: bool,
}

/// A parameter of the model.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ModelParameter {
    /// Key of the parameter in the table `[twin.measured]`.
    pub key: &'static str,
    /// Name of the parameter.
    pub title: String,
    /// Value; `null` if it is unknown.
    pub value: Option<Number>,
    /// Unit of the value.
    pub unit: &'static str,
    /// Grade of the value.
    pub grade: Option<Id<Grade>>,
    /// Source of the value.
    pub source: Option<String>,
}

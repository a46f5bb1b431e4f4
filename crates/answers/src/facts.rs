//! Facts stated in prose by a source: hazards, rules, limits.

use crate::{Id, Number};
use catalogue::{Bound, LifeStep, SignalWord};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;

/// A hazard, a rule or a limit, in the project's own words.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Fact {
    /// Id of the fact.
    pub id: &'static str,
    /// Signal word of ISO 3864-2 and ANSI Z535.6; `null` for a plain statement.
    pub signal: Option<Id<SignalWord>>,
    /// Step of the work to which it applies; `null` if it always applies.
    pub step: Option<Id<LifeStep>>,
    /// Text of the fact.
    pub text: &'static str,
    /// Figures in the text.
    pub values: Vec<FactValue>,
    /// Source of the fact.
    pub source: String,
    /// Grade of the fact.
    pub grade: Id<Grade>,
}

/// A figure of a fact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FactValue {
    /// Id among several figures; `null` for the only one.
    pub id: Option<&'static str>,
    /// Value of the figure.
    pub number: Number,
    /// Unit in ASCII; empty for pure numbers.
    pub unit: &'static str,
    /// Kind of bound.
    pub bound: Id<Bound>,
}

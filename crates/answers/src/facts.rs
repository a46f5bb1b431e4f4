//! Facts stated in prose by a source: hazards, rules, limits.

use crate::{Id, Number};
use catalogue::{Bound, Signal, Step};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;

/// A hazard, a rule or a limit, in our words.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Fact {
    /// Its id.
    pub id: &'static str,
    /// Signal word of ISO 3864-2 and ANSI Z535.6; `null` for a plain statement.
    pub signal: Option<Id<Signal>>,
    /// When it matters; `null`: always.
    pub step: Option<Id<Step>>,
    /// What it says.
    pub text: &'static str,
    /// The figures in it.
    pub values: Vec<FactValue>,
    /// Where it stands.
    pub source: String,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
}

/// A figure of a fact.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FactValue {
    /// Which of several; `null` for the only one.
    pub id: Option<&'static str>,
    /// The figure.
    pub number: Number,
    /// Its unit in ASCII; empty for pure numbers.
    pub unit: &'static str,
    /// What it bounds.
    pub bound: Id<Bound>,
}

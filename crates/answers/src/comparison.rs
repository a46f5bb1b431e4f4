//! Comparison of actuators side by side, and of an actuator before and after a change.

use crate::{AssumptionEntry, Check, CitedErratum, Fit, Id, Number};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::CheckId;

/// An actuator in a comparison.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Head {
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// Verdict on the actuator.
    pub verdict: Fit,
    /// Utilisation of the governing check; 1 is the limit.
    pub utilisation: Number,
    /// Id of the governing check.
    pub tightest: Option<Id<CheckId>>,
    /// Number of questions that could not be answered because a datum is missing.
    pub open_questions: usize,
    /// Requirements not met and rules violated, as text.
    pub objections: Vec<String>,
}

/// A figure for each actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DatumRow {
    /// Symbol of the figure.
    pub symbol: &'static str,
    /// Unit of the values.
    pub unit: &'static str,
    /// One value per actuator, `null` if it has none.
    pub values: Vec<Option<Number>>,
    /// Ids of the errata that touch the value of each actuator.
    pub errata: Vec<Vec<&'static str>>,
}

/// A check for each actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckRow {
    /// Id of the check.
    pub id: Id<CheckId>,
    /// Name of the check.
    pub title: String,
    /// Index of the better actuator, from 0; `null` if none is better.
    pub better: Option<usize>,
    /// Results per actuator, `null` if an actuator has no such check.
    pub answers: Vec<Option<Check>>,
}

/// `compare`: several actuators for the same axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Comparison {
    /// Name of the axis.
    pub axis: String,
    /// The actuators, in the requested order.
    pub candidates: Vec<Head>,
    /// Index of the actuator with the best rank, from 0.
    pub better: Option<usize>,
    /// Demand on each actuator.
    pub demand: Vec<DatumRow>,
    /// Data of each actuator.
    pub data: Vec<DatumRow>,
    /// Errata that touch the data.
    pub errata: Vec<CitedErratum>,
    /// Comparison check by check.
    pub checks: Vec<CheckRow>,
    /// Assumptions of the axis.
    pub assumptions: Vec<AssumptionEntry>,
}

/// A value that differs between two project files.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct InputChange {
    /// Key of the value.
    pub path: String,
    /// Value as written in the first file; `null` if it is missing there.
    pub old: Option<String>,
    /// Value as written in the second file; `null` if it is missing there.
    pub new: Option<String>,
}

/// A figure before and after.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DatumChange {
    /// Symbol of the figure.
    pub symbol: &'static str,
    /// Unit of the values.
    pub unit: &'static str,
    /// Value in the first project.
    pub before: Option<Number>,
    /// Value in the second project.
    pub after: Option<Number>,
}

/// A check before and after.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckChange {
    /// Id of the check.
    pub id: Id<CheckId>,
    /// Name of the check.
    pub title: String,
    /// `true` if any part of the result differs.
    pub changed: bool,
    /// Difference of the utilisations.
    pub change: Option<Number>,
    /// Result in the first project.
    pub before: Option<Check>,
    /// Result in the second project.
    pub after: Option<Check>,
}

/// `diff`: effect of another revision of a project on an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Difference {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// Verdict in the second project.
    pub verdict: Fit,
    /// Result in the first project.
    pub before: Head,
    /// Result in the second project.
    pub after: Head,
    /// Best ordering code for the first project.
    pub best_before: Option<String>,
    /// Best ordering code for the second project.
    pub best_after: Option<String>,
    /// Demand before and after.
    pub demand: Vec<DatumChange>,
    /// Comparison check by check.
    pub checks: Vec<CheckChange>,
    /// Values of the project files that differ.
    pub inputs: Vec<InputChange>,
}

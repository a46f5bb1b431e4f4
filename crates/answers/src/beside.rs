//! Comparison of actuators side by side, and of an actuator before and after a change.

use crate::{Check, Fit, Id, Number};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::CheckId;

/// An actuator in a comparison.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Head {
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// Whether nothing speaks against it.
    pub verdict: Fit,
    /// Utilisation of the governing check; 1 is the limit.
    pub utilisation: Number,
    /// Id of the check that it belongs to.
    pub tightest: Option<Id<CheckId>>,
    /// How many questions could not be answered for want of a datum.
    pub open_questions: usize,
    /// Requirements not met and rules broken, in words.
    pub objections: Vec<String>,
}

/// A figure of each actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DatumRow {
    /// Its symbol.
    pub symbol: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// One value for each actuator, `null` where there is none.
    pub values: Vec<Option<Number>>,
}

/// A check of each actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckRow {
    /// Which check.
    pub id: Id<CheckId>,
    /// Its name in words.
    pub title: String,
    /// Index of the actuator that does better, from 0; `null` where none does.
    pub better: Option<usize>,
    /// The answers, `null` where an actuator has no such check.
    pub answers: Vec<Option<Check>>,
}

/// `compare`: several actuators for the same axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Comparison {
    /// Name of the axis.
    pub axis: String,
    /// The actuators, in the requested order.
    pub candidates: Vec<Head>,
    /// Index of the actuator that ranks best, from 0.
    pub better: Option<usize>,
    /// The demand on each.
    pub demand: Vec<DatumRow>,
    /// What each is.
    pub data: Vec<DatumRow>,
    /// Check by check.
    pub checks: Vec<CheckRow>,
}

/// A value that differs between two project files.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct InputChange {
    /// Its key.
    pub path: String,
    /// As written in the first file; `null` where it is not there.
    pub old: Option<String>,
    /// As written in the second file; `null` where it is not there.
    pub new: Option<String>,
}

/// A figure before and after.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DatumChange {
    /// Its symbol.
    pub symbol: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// In the first project.
    pub before: Option<Number>,
    /// In the second project.
    pub after: Option<Number>,
}

/// A check before and after.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckChange {
    /// Which check.
    pub id: Id<CheckId>,
    /// Its name in words.
    pub title: String,
    /// Whether anything about it is another.
    pub changed: bool,
    /// Difference of the utilisations.
    pub change: Option<Number>,
    /// In the first project.
    pub before: Option<Check>,
    /// In the second project.
    pub after: Option<Check>,
}

/// `diff`: what another revision of a project does to an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Difference {
    /// Name of the axis.
    pub axis: String,
    /// The actuator.
    pub code: String,
    /// Whether it fits in the second project.
    pub verdict: Fit,
    /// In the first project.
    pub before: Head,
    /// In the second project.
    pub after: Head,
    /// The best ordering code for the first project.
    pub best_before: Option<String>,
    /// The best ordering code for the second project.
    pub best_after: Option<String>,
    /// The demand before and after.
    pub demand: Vec<DatumChange>,
    /// Check by check.
    pub checks: Vec<CheckChange>,
    /// The values of the project files that differ.
    pub inputs: Vec<InputChange>,
}

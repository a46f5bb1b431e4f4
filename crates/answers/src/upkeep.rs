//! Storage, maintenance, shutdown and disposal of an actuator.

use crate::{Battery, CitedErratum, Fact, Fit, Id};
use installation::upkeep::{Rule, Task};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;

/// `upkeep`: what is to be done, and by when.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Upkeep {
    /// Ordering code.
    pub code: String,
    /// Whether the storage is within what is permitted.
    pub verdict: Fit,
    /// Day of delivery, as `2026-03-01`.
    pub delivered: String,
    /// Day on which service begins.
    pub in_service: String,
    /// Day that the plan is looked at from; `null`: not stated.
    pub today: Option<String>,
    /// The plan, by date.
    pub plan: Vec<Planned>,
    /// Life of the encoder's battery; `null` without one, or where the hours of operation are not stated.
    pub battery: Option<Battery>,
    /// What was assumed, and what the manual does not state, in words.
    pub notes: Vec<String>,
    /// Transport and storage.
    pub storage: Vec<Fact>,
    /// In service.
    pub service: Vec<Fact>,
    /// Shutting down, in the order of the steps.
    pub shutdown: Vec<Fact>,
    /// Disposal.
    pub disposal: Vec<Fact>,
    /// Errata of the text that the plan rests on.
    pub errata: Vec<CitedErratum>,
    /// The iCalendar file that the plan was written to; `null`: none.
    pub calendar: Option<String>,
}

/// A line of the plan.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Planned {
    /// What.
    pub task: Id<Task>,
    /// The task in words.
    pub title: String,
    /// How binding.
    pub rule: Id<Rule>,
    /// The rule in words, with its interval.
    pub rule_text: String,
    /// Interval of a series, as ISO 8601 writes it: `P6M`, `P90D`.
    pub interval: Option<String>,
    /// The date; of a series the first.
    pub first: String,
    /// Of a series the first date that is not before today, if today is stated.
    pub next: String,
    /// Whether it lies before today, if today is stated.
    pub passed: bool,
    /// Id of the fact that it rests on.
    pub fact: &'static str,
    /// What the fact says.
    pub text: &'static str,
    /// Where the date is from.
    pub source: String,
    /// How far it can be trusted; `null` where it follows from an interval that the user states.
    pub grade: Option<Id<Grade>>,
}

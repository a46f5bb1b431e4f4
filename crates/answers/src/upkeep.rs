//! Storage, maintenance, shutdown and disposal of an actuator.

use crate::{Battery, CitedErratum, Fact, Fit, Id};
use installation::upkeep::{DateRule, Task};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;

/// `upkeep`: maintenance tasks and their dates.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Upkeep {
    /// Ordering code.
    pub code: String,
    /// Verdict on the storage against the permitted limits.
    pub verdict: Fit,
    /// Day of delivery, such as `2026-03-01`.
    pub delivered: String,
    /// First day of service.
    pub in_service: String,
    /// Reference day of the plan; `null` if not stated.
    pub today: Option<String>,
    /// Plan by date.
    pub plan: Vec<Planned>,
    /// Life of the encoder's battery; `null` without one, or if the hours of operation are not stated.
    pub battery: Option<Battery>,
    /// Assumptions, and points that the manual does not state, as text.
    pub notes: Vec<String>,
    /// Facts on transport and storage.
    pub storage: Vec<Fact>,
    /// Facts on service.
    pub service: Vec<Fact>,
    /// Facts on shutdown, in the order of the steps.
    pub shutdown: Vec<Fact>,
    /// Facts on disposal.
    pub disposal: Vec<Fact>,
    /// Errata of the text that the plan depends on.
    pub errata: Vec<CitedErratum>,
    /// iCalendar file of the plan; `null` if none was written.
    pub calendar: Option<String>,
}

/// A task of the plan.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Planned {
    /// Id of the task.
    pub task: Id<Task>,
    /// Name of the task.
    pub title: String,
    /// Binding force of the task.
    pub rule: Id<DateRule>,
    /// Rule as text, with its interval.
    pub rule_text: String,
    /// Interval of a series in ISO 8601: `P6M`, `P90D`.
    pub interval: Option<String>,
    /// Date; the first one of a series.
    pub first: String,
    /// First date of a series that is not before today, if today is stated.
    pub next: String,
    /// `true` if the date lies before today, if today is stated.
    pub passed: bool,
    /// Id of the fact that requires the task.
    pub fact: &'static str,
    /// Text of the fact.
    pub text: &'static str,
    /// Source of the date.
    pub source: String,
    /// Grade of the date; `null` if it follows from an interval stated by the user.
    pub grade: Option<Id<Grade>>,
}

//! One check, and the derivation of its figures.

use crate::{Id, Number};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::derivation::Formula;
use sizing::{CheckId, Direction, Part, Verdict};

/// Result of one check.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Check {
    /// Id of the check.
    pub id: Id<CheckId>,
    /// Name of the check.
    pub title: String,
    /// Verdict of the check. `advice` also means: within the band of an estimate.
    pub verdict: Id<Verdict>,
    /// Value demanded by the axis; may be present with `not_checked`, if only the limit is missing.
    pub value: Option<Number>,
    /// Limit of the actuator, or limit required by the project.
    pub limit: Option<Number>,
    /// Unit of value and limit: `Nm` `1/min` `A` `V` `W` `kgm^2` `N` `mm` `h` `a` `deg` `arcmin` `arcsec` `rev` `Hz`
    /// `degC` `1`.
    pub unit: Option<&'static str>,
    /// Required relation of the value to the limit.
    pub direction: Id<Direction>,
    /// Part of the actuator concerned.
    pub part: Id<Part>,
    /// value/limit for `at_most`, limit/value for `at_least`; `null` if it has no meaning.
    pub utilisation: Option<Number>,
    /// `true` if the ranking uses this utilisation; `false` for a recommendation, and for a class that is met or not.
    pub margin: bool,
    /// Instant of the worst case within the cycle, in s.
    pub at: Option<Number>,
    /// Grade of the figures: the worst of all inputs.
    pub grade: Option<Id<Grade>>,
    /// Source of the limit, then of the value, joined by `; `.
    pub source: Option<String>,
    /// The sources as a list.
    pub sources: Vec<String>,
    /// Symbol of the missing datum, or the project key that would set the limit.
    pub missing: Option<String>,
    /// Remarks, as text.
    pub notes: Vec<String>,
    /// Ids of the errata that value or limit depend on; their evidence is in `notes`. Omitted if there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub errata: Vec<&'static str>,
    /// `true` if the limit is a rating of another manufacturer's gear, for faces that mark it.
    #[serde(skip)]
    pub is_of_another_gear: bool,
    /// `true` if a datum is missing, not only the limit of the project.
    #[serde(skip)]
    pub is_open: bool,
}

/// An erratum that a figure depends on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CitedErratum {
    /// Id of the erratum.
    pub id: String,
    /// Text of the manual, value used, and reason.
    pub evidence: String,
}

/// A figure and its derivation.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Node {
    /// Symbol of the figure.
    pub symbol: String,
    /// Meaning of the symbol; omitted if there is no term for it.
    #[serde(skip_serializing_if = "String::is_empty")]
    #[schemars(default)]
    pub term: String,
    /// Formula in symbols; omitted for a value that was read instead of computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub formula: Option<String>,
    /// Formula with the values inserted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figures: Option<String>,
    /// Formula as a syntax tree, for faces that typeset it; absent for a search without a formula.
    #[serde(skip)]
    pub tree: Option<Formula>,
    /// Condition under which the formula of a search or an integral holds.
    #[serde(skip)]
    pub condition: Option<String>,
    /// Result of the formula.
    pub value: Number,
    /// Unit of the result.
    pub unit: &'static str,
    /// Grade of the figure; `null` for the steps of a computation, which have the grade of their inputs.
    pub grade: Option<Id<Grade>>,
    /// Source of the figure: cell, equation, model or key.
    pub source: String,
    /// Page of the manual, for faces that show it next to the source.
    #[serde(skip)]
    pub page: Option<u16>,
    /// Page of `docs/theory` that explains the figure, for faces that show it.
    #[serde(skip)]
    pub model: Option<&'static str>,
    /// Errata that the figure depends on; omitted if there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub errata: Vec<CitedErratum>,
    /// `true` if the figure is derived above already; omitted otherwise.
    #[serde(skip_serializing_if = "is_false")]
    #[schemars(default)]
    pub repeated: bool,
    /// Inputs of the figure; omitted if there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub operands: Vec<Node>,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the form that serde asks for")]
const fn is_false(value: &bool) -> bool {
    !*value
}

/// Derivations of both sides of a check.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Derivation {
    /// Derivation of the demanded value.
    pub value: Option<Node>,
    /// Derivation of the limit.
    pub limit: Option<Node>,
}

/// A check with the derivation of its value and its limit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Explained {
    /// Result of the check.
    #[serde(flatten)]
    pub check: Check,
    /// Value and limit that the check compares, as text.
    pub meaning: &'static str,
    /// Derivation of its figures.
    pub derivation: Derivation,
}

/// `explain`: the checks of an actuator with their derivations.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Explanations {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// The requested checks.
    pub checks: Vec<Explained>,
    /// Assumptions.
    pub assumptions: Vec<AssumptionEntry>,
}

/// An assumption, made where the project states nothing.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct AssumptionEntry {
    /// Keys that take its place, separated by commas; `null` if no key does.
    pub key: Option<String>,
    /// Value in effect, as the keys state it; `null` if no value is.
    pub value: Option<String>,
    /// The assumption as text.
    pub why: String,
}

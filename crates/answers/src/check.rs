//! One check, and the derivation of its figures.

use crate::{Id, Number};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::{CheckId, Direction, Part, Verdict};

/// The answer of one check.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Check {
    /// Which check.
    pub id: Id<CheckId>,
    /// Its name in words.
    pub title: String,
    /// What came out. `advice` also means: inside the band of an estimate.
    pub verdict: Id<Verdict>,
    /// What the axis asks; with `not_checked` it may still be there, when only the limit is missing.
    pub value: Option<Number>,
    /// What the actuator gives or the project asks.
    pub limit: Option<Number>,
    /// Unit of both: `Nm` `1/min` `A` `V` `W` `kgm^2` `N` `mm` `h` `a` `deg` `arcmin` `arcsec` `rev` `Hz` `degC` `1`.
    pub unit: Option<&'static str>,
    /// How the value must lie to the limit.
    pub direction: Id<Direction>,
    /// The part of the actuator that it is about.
    pub part: Id<Part>,
    /// value/limit for `at_most`, limit/value for `at_least`; `null` where it makes no sense.
    pub utilisation: Option<Number>,
    /// Whether the ranking looks at that utilisation: not of a recommendation nor of a class that is met or not.
    pub margin: bool,
    /// Instant of the worst case within the cycle, in s.
    pub at: Option<Number>,
    /// How far the figures can be trusted: the worst of all that went in.
    pub grade: Option<Id<Grade>>,
    /// Source of the limit, then of the value, joined by `; `.
    pub source: Option<String>,
    /// The same sources, each by itself.
    pub sources: Vec<String>,
    /// Symbol of the datum that is missing, or the key of the project that would give the limit.
    pub missing: Option<String>,
    /// Remarks, in words.
    pub notes: Vec<String>,
    /// Only where a value or limit rests on one: the ids of the errata, whose evidence stands in `notes`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub errata: Vec<&'static str>,
}

/// An erratum that a figure rests on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CitedErratum {
    /// Its id.
    pub id: String,
    /// What stands in print, what is used, and why.
    pub evidence: String,
}

/// A figure and how it came about.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Node {
    /// Its symbol.
    pub symbol: String,
    /// What the symbol means; left out where there is no term for it.
    #[serde(skip_serializing_if = "String::is_empty")]
    #[schemars(default)]
    pub term: String,
    /// The formula, in symbols; left out for what was read and not computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub formula: Option<String>,
    /// The formula with its figures put in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figures: Option<String>,
    /// The result.
    pub value: Number,
    /// Its unit.
    pub unit: &'static str,
    /// How far it can be trusted; `null` for the steps of a computation, which are as good as what went in.
    pub grade: Option<Id<Grade>>,
    /// Where it stands: cell, equation, model or key.
    pub source: String,
    /// The page of the manual, for those who show it beside the source.
    #[serde(skip)]
    pub page: Option<u16>,
    /// The page of `docs/theory` that explains it, for the same.
    #[serde(skip)]
    pub model: Option<&'static str>,
    /// The errata that it rests on; left out where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub errata: Vec<CitedErratum>,
    /// Whether it is derived above already; left out where not.
    #[serde(skip_serializing_if = "is_false")]
    #[schemars(default)]
    pub repeated: bool,
    /// What went in; left out where nothing did.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub operands: Vec<Node>,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the form that serde asks for")]
const fn is_false(value: &bool) -> bool {
    !*value
}

/// Where both sides of a check come from.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Derivation {
    /// Of what the axis asks.
    pub value: Option<Node>,
    /// Of what is permitted.
    pub limit: Option<Node>,
}

/// A check with the derivation of its value and its limit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Explained {
    /// The check.
    #[serde(flatten)]
    pub check: Check,
    /// How its figures came about.
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
    /// What was assumed, in words.
    pub assumptions: Vec<String>,
}

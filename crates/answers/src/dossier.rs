//! Content of a report.

use crate::{CitedErratum, DataLine, Explained, Id, Inertia, Judgement, Number, Operation, Sizing};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::CheckId;

/// Data of an axis and of the chosen actuator for a report.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Dossier {
    /// The actuator; its checks are in the order of their importance.
    pub judgement: Judgement,
    /// Numbers of checks by verdict.
    pub counts: CheckCounts,
    /// `true` for a single move, which ends at another position than it begins.
    pub single_move: bool,
    /// Ranking of the catalogue with every candidate.
    pub sizing: Sizing,
    /// Reasons for rejections, the most frequent first.
    pub rejections: Vec<RejectionGroup>,
    /// Project as written, table by table.
    pub inputs: Vec<InputTable>,
    /// Load on the flange.
    pub mechanism: Mechanism,
    /// Cycle on the actuator, segment by segment; `null` if the inertia of the actuator is not known.
    pub operation: Option<Operation>,
    /// Printed data of the actuator; empty for one of the project.
    pub data_sheet: Vec<DataLine>,
    /// Checks with their derivations.
    pub explained: Vec<Explained>,
    /// Missing data of checks that could not be made or have no limit.
    pub missing: Vec<Missing>,
    /// Parts to order; empty if the actuator does not fit.
    pub bill_of_material: Vec<Item>,
    /// Bolted joints of the actuator.
    pub screws: Vec<ScrewJoint>,
    /// Documents that the sources refer to.
    pub documents: Vec<Document>,
    /// Errata that the figures of the actuator depend on.
    pub errata: Vec<ErratumUsed>,
    /// Versions and hashes of the inputs and the data used.
    pub fingerprints: Fingerprints,
}

/// Number of checks by verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CheckCounts {
    /// Checks passed.
    pub passed: usize,
    /// Checks with advice.
    pub advised: usize,
    /// Checks failed.
    pub failed: usize,
    /// Checks not made because a datum is missing.
    pub not_checked: usize,
    /// Checks shown without a limit of the project.
    pub without_limit: usize,
    /// Checks made that can reject the actuator.
    pub deciding: usize,
    /// Requirements with a missing datum.
    pub requirements_open: usize,
}

/// A reason for rejections with the actuators rejected: the governing check; if no check fails, a requirement that is
/// not met or a rule of the ordering code.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RejectionGroup {
    /// Reason as text: the requirement, or the title of the check.
    pub reason: String,
    /// `true` if a check fails; `false` for a requirement or a rule of the ordering code.
    pub is_check: bool,
    /// Ordering codes in alphabetical order.
    pub codes: Vec<String>,
}

/// A table of the project file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct InputTable {
    /// Key of the table as for a single axis: `load`, `motion[2]`; empty for values before the first table.
    pub key: String,
    /// Subject of the table, as text.
    pub title: String,
    /// `true` if the table describes the mechanism.
    pub of_mechanism: bool,
    /// Values in the order of the file.
    pub values: Vec<Input>,
}

/// A value of the project file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Input {
    /// Name of the key within the table: `inertia`, `bodies[1]`.
    pub name: String,
    /// Name as text; empty if there is none.
    pub label: String,
    /// Value as written, in the words and number format of the language.
    pub text: String,
    /// Tolerance to either side with its unit; `null` for an exact value.
    pub tolerance: Option<String>,
}

/// Load on the flange.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Mechanism {
    /// Key in the project file: `load`, `screw`.
    pub kind: String,
    /// Name of the mechanism.
    pub title: String,
    /// Principle drawing with symbols for the keys stated.
    pub sketch: Sketch,
    /// Travel along the line per revolution of the actuator in mm; `null` for a rotary mechanism.
    pub travel_mm_per_rev: Option<Number>,
    /// Travel along the line per revolution of the mechanism in mm, behind a stage if there is one; `null` for a rotary
    /// mechanism.
    pub own_travel_mm_per_rev: Option<Number>,
    /// Bodies with their masses and moments of inertia; for a turntable only.
    pub bodies: Option<Inertia>,
}

/// A principle drawing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sketch {
    /// Drawing as SVG with text in the font family Inter.
    pub svg: String,
    /// `true` if the drawing is higher than wide.
    pub is_upright: bool,
    /// Symbols in the drawing, by name of the key.
    pub symbols: Vec<SketchSymbol>,
}

/// A symbol of a drawing.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SketchSymbol {
    /// Name of the key.
    pub key: String,
    /// Symbol; the part after `_` is its index.
    pub symbol: String,
}

/// Missing data of a check.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Missing {
    /// Id of the check.
    pub check: Id<CheckId>,
    /// Missing data, as text.
    pub text: String,
}

/// A line of the bill of material.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Item {
    /// Number of the line.
    pub item: String,
    /// Number of pieces.
    pub quantity: String,
    /// Ordering code of the part.
    pub code: String,
    /// Description of the part.
    pub text: String,
    /// Source of the entry.
    pub source: Option<String>,
}

/// A bolted joint of the actuator.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ScrewJoint {
    /// Name of the joint.
    pub joint: String,
    /// Number, size and property class of the screws.
    pub screws: String,
    /// Diameter of the bolt circle.
    pub circle: String,
    /// Tightening torque.
    pub torque: String,
    /// Torque transmitted by the joint.
    pub text: String,
    /// Source of the values.
    pub source: Option<String>,
}

/// A document that sources refer to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Document {
    /// Id in the data.
    pub id: String,
    /// Short name used by the sources.
    pub short: String,
    /// Title of the document.
    pub title: String,
    /// Number, edition and date; empty if unknown.
    pub edition: String,
    /// Publisher.
    pub publisher: String,
    /// Further remark.
    pub note: String,
}

/// An erratum with the check that refers to it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ErratumUsed {
    /// The erratum.
    #[serde(flatten)]
    pub erratum: CitedErratum,
    /// Title of the first check that depends on it.
    pub check: String,
}

/// Versions and hashes that make a result repeatable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Fingerprints {
    /// Version of the program.
    pub program: String,
    /// Hash of the project file and its recordings.
    pub project: String,
    /// Hash of the catalogue.
    pub catalogue: String,
}

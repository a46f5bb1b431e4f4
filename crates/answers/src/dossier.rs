//! Content of a report.

use crate::{CitedErratum, Explained, Id, Inertia, Judgement, Number, Sizing};
use schemars::JsonSchema;
use serde::Serialize;
use sizing::CheckId;

/// An axis with everything there is to tell of it and of the actuator chosen.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Dossier {
    /// The actuator; its checks stand in the order of their importance.
    pub judgement: Judgement,
    /// The counts of its checks.
    pub counts: CheckCounts,
    /// Whether the motion is a single move, which ends elsewhere than it begins.
    pub single_move: bool,
    /// The catalogue ranked, with every candidate.
    pub sizing: Sizing,
    /// Why the others are rejected, the most frequent reason first.
    pub rejections: Vec<RejectionGroup>,
    /// The project as it was written, table by table.
    pub inputs: Vec<InputTable>,
    /// What hangs on the flange.
    pub mechanism: Mechanism,
    /// The checks with their derivations.
    pub explained: Vec<Explained>,
    /// What the checks lack that could not be made or have no limit.
    pub missing: Vec<Missing>,
    /// What is ordered; empty where the actuator does not fit.
    pub bill_of_material: Vec<Item>,
    /// How it is screwed on.
    pub screws: Vec<ScrewJoint>,
    /// The documents that the sources cite.
    pub documents: Vec<Document>,
    /// The errata that the figures of the actuator rest on.
    pub errata: Vec<ErratumUsed>,
    /// What was put in and which data were used.
    pub fingerprints: Fingerprints,
}

/// How many checks came to which verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CheckCounts {
    /// Passed.
    pub passed: usize,
    /// Advised.
    pub advised: usize,
    /// Failed.
    pub failed: usize,
    /// Not checked for want of a datum.
    pub not_checked: usize,
    /// Shown without a limit of the project.
    pub without_limit: usize,
    /// Requirements for which a datum is missing.
    pub requirements_open: usize,
}

/// A reason for which actuators are rejected, and whom it rejects: the governing check; where none fails a requirement that is not
/// met, or a rule of the ordering code.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RejectionGroup {
    /// The reason in words: the requirement, or the title of the check.
    pub reason: String,
    /// Whether a check fails; else a requirement or a rule of the ordering code is in the way.
    pub is_check: bool,
    /// The ordering codes in alphabetical order.
    pub codes: Vec<String>,
}

/// A table of the project file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct InputTable {
    /// Its key, as if the axis stood alone: `load`, `motion[2]`; empty for what stands before all tables.
    pub key: String,
    /// What it is about, in words.
    pub title: String,
    /// Whether it describes the mechanism.
    pub of_mechanism: bool,
    /// Its values in the order of the file.
    pub values: Vec<Input>,
}

/// A value of the project file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Input {
    /// Its name within the table: `inertia`, `bodies[1]`.
    pub name: String,
    /// The name in words; empty where there are none.
    pub label: String,
    /// What is written there, in the words and with the signs of the language.
    pub text: String,
    /// How far it may lie to either side, with its unit; `null` where it is exact.
    pub tolerance: Option<String>,
}

/// What hangs on the flange.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Mechanism {
    /// Its key in the project file: `load`, `screw`.
    pub kind: String,
    /// What it is called.
    pub title: String,
    /// Its principle drawing, which calls out the keys that are stated.
    pub sketch: Sketch,
    /// The way along its line that one turn of the actuator makes, in mm; `null` without a line.
    pub travel_mm_per_rev: Option<Number>,
    /// The bodies with their masses and inertias; only of a turntable.
    pub bodies: Option<Inertia>,
}

/// A principle drawing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sketch {
    /// SVG, its text in the family Inter.
    pub svg: String,
    /// Whether it is higher than wide.
    pub is_upright: bool,
    /// The symbols that it calls out, by the name of the key.
    pub symbols: Vec<SketchSymbol>,
}

/// A symbol of a drawing.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SketchSymbol {
    /// The name of the key.
    pub key: String,
    /// The symbol; what follows `_` is its index.
    pub symbol: String,
}

/// What a check lacks.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Missing {
    /// Which check.
    pub check: Id<CheckId>,
    /// What it lacks, in words.
    pub text: String,
}

/// A line of the bill of material.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Item {
    /// Number of the line.
    pub item: String,
    /// How many.
    pub quantity: String,
    /// What to order it by.
    pub code: String,
    /// What it is.
    pub text: String,
    /// Where that stands.
    pub source: Option<String>,
}

/// A joint of the actuator.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ScrewJoint {
    /// Which joint.
    pub joint: String,
    /// Number, size and class of the screws.
    pub screws: String,
    /// Diameter of the bolt circle.
    pub circle: String,
    /// Tightening torque.
    pub torque: String,
    /// What the joint transmits.
    pub text: String,
    /// Where that stands.
    pub source: Option<String>,
}

/// A document that sources cite.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Document {
    /// How sources call it.
    pub id: String,
    /// Its title.
    pub title: String,
    /// Its number, edition and date; empty where they are not known.
    pub edition: String,
    /// Who published it.
    pub publisher: String,
    /// What else is to be known of it.
    pub note: String,
}

/// An erratum with the check that cites it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ErratumUsed {
    /// The erratum.
    #[serde(flatten)]
    pub erratum: CitedErratum,
    /// Title of the first check that rests on it.
    pub check: String,
}

/// What makes a result repeatable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Fingerprints {
    /// Version of the program.
    pub program: String,
    /// Hash of the project file and its recordings.
    pub project: String,
    /// Hash of the catalogue.
    pub catalogue: String,
}

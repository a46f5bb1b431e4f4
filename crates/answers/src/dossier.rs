//! All that a report lays out.

use crate::{CitedErratum, Explained, Judgement, Sizing};
use schemars::JsonSchema;
use serde::Serialize;

/// An axis with everything there is to tell of it and of the actuator chosen.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Dossier {
    /// The actuator.
    pub judgement: Judgement,
    /// The catalogue ranked, with every candidate.
    pub sizing: Sizing,
    /// The project as it was written.
    pub inputs: Vec<Input>,
    /// The checks with their derivations.
    pub explained: Vec<Explained>,
    /// What is ordered.
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

/// A value of the project file.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Input {
    /// Its key: `load.inertia`, `motion[2].speed`.
    pub key: String,
    /// The key in words; empty where there are none.
    pub label: String,
    /// What is written there, without the quotes.
    pub text: String,
    /// How far it may lie to either side, with its unit; `null` where it is exact.
    pub tolerance: Option<String>,
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

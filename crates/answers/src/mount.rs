//! Mounting of an actuator.

use crate::{CitedErratum, Fact, Fit, Id, Number, TableCell, Units};
use installation::fit::{FitKind, Side};
use installation::joint::LoadCase;
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::Verdict;

/// `mount`: fits, tolerances, dimensions and screw joints of an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Mount {
    /// Ordering code.
    pub code: String,
    /// Whether no joint slips under torque alone.
    pub verdict: Fit,
    /// Units of the figures, by field.
    pub units: Units,
    /// What the tables do not cover of the code, and what the figures rest on, in words.
    pub notes: Vec<String>,
    /// The pilots with the bores over them, load first.
    pub pilots: Vec<Pilot>,
    /// Tolerances of the output flange.
    pub tolerances: Vec<MountValue>,
    /// Dimensions, mass, mounting plate, degree of protection.
    pub dimensions: Vec<MountValue>,
    /// Whether the mass requires lifting gear; `null` if no mass is printed for the code.
    pub lifting_gear: Option<bool>,
    /// The screw joints, load first.
    pub joints: Vec<Joint>,
    /// Requirements of the manual, in the order of a machine's life.
    pub facts: Vec<Fact>,
    /// Errata of what stands above.
    pub errata: Vec<CitedErratum>,
}

/// A pilot with the bore over it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Pilot {
    /// Which side.
    pub side: Id<Side>,
    /// The side in words.
    pub title: String,
    /// Nominal diameter.
    pub nominal: Number,
    /// Tolerance zone of the pilot.
    pub zone: &'static str,
    /// Upper limit deviation of the pilot.
    pub upper: Number,
    /// Lower limit deviation of the pilot.
    pub lower: Number,
    /// Zone that the manual recommends for the bore.
    pub recommended: &'static str,
    /// Tolerance zone of the bore; `null` for limit deviations of one's own.
    pub bore: Option<&'static str>,
    /// Upper limit deviation of the bore.
    pub bore_upper: Number,
    /// Lower limit deviation of the bore.
    pub bore_lower: Number,
    /// Smallest clearance; interference is negative.
    pub clearance_min: Number,
    /// Largest clearance.
    pub clearance_max: Number,
    /// By how much the part may sit off centre: half of the largest clearance, none with interference.
    pub off_centre_max: Number,
    /// What the fit is.
    pub fit: Id<FitKind>,
    /// The same in words.
    pub fit_text: String,
    /// How far the clearances can be trusted.
    pub grade: Id<Grade>,
    /// Where the figures are from.
    pub sources: Vec<String>,
}

/// A printed value.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MountValue {
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// The field's word for it.
    pub name: String,
    /// The value; `null` where none is printed for the code.
    pub value: TableCell,
    /// Its unit in ASCII; empty for texts.
    pub unit: &'static str,
    /// How far it can be trusted; `null` without a value.
    pub grade: Option<Id<Grade>>,
    /// Where it is from; `null` without a value.
    pub source: Option<String>,
}

/// A screw joint.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Joint {
    /// Which side.
    pub side: Id<Side>,
    /// The side in words.
    pub title: String,
    /// Number of screws.
    pub count: Option<Number>,
    /// Thread.
    pub size: Option<String>,
    /// Property class.
    pub class: Option<String>,
    /// Diameter of the bolt circle.
    pub bolt_circle: Option<Number>,
    /// Tightening torque of a screw.
    pub tightening_torque: Option<Number>,
    /// Torque that the joint transmits, faces degreased.
    pub transmissible_torque: Option<Number>,
    /// Coefficient of friction that it holds for.
    pub friction: Option<Number>,
    /// Clamp force of a screw that it implies: estimated.
    pub clamp_force: Option<Number>,
    /// Where the printed values are from.
    pub source: Option<String>,
    /// The joint under each load.
    pub cases: Vec<JointCase>,
}

/// A joint under a load.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointCase {
    /// Which load.
    pub case: Id<LoadCase>,
    /// The load in words.
    pub title: String,
    /// The torque; `null` without one, or where none is known.
    pub torque: Option<Number>,
    /// Where the torque is from.
    pub torque_source: Option<String>,
    /// Share of the transmissible torque, torque alone.
    pub utilisation: Option<Number>,
    /// Verdict on torque alone.
    pub verdict: Id<Verdict>,
    /// How far the share can be trusted.
    pub grade: Option<Id<Grade>>,
    /// Tilting moment that acts with it.
    pub moment: Option<Number>,
    /// Where the moment is from.
    pub moment_source: Option<String>,
    /// Share of the clamp force that the screw relieved most loses: estimated.
    pub relieved: Option<Number>,
    /// Share of the friction left that torque and forces take: estimated; `null` where the joint opens.
    pub utilisation_together: Option<Number>,
    /// Verdict on everything at once; `advice` where the estimate does not suffice.
    pub verdict_together: Id<Verdict>,
    /// What is missing for a verdict, in words.
    pub missing: Option<String>,
}

//! Mounting of an actuator.

use crate::{AssumptionEntry, CitedErratum, Fact, Fit, Id, Number, TableCell, Units};
use installation::fit::{FitKind, Side};
use installation::joint::LoadCase;
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;
use sizing::Verdict;

/// `mount`: fits, tolerances, dimensions and bolted joints of an actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Mount {
    /// Ordering code.
    pub code: String,
    /// Verdict on slipping of the joints under torque alone.
    pub verdict: Fit,
    /// Units of the figures, by field.
    pub units: Units,
    /// Remarks on data not covered by the tables, and on the basis of the figures, as text.
    pub notes: Vec<String>,
    /// Assumptions of the axis whose loads act on the joints; empty without a project.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub assumptions: Vec<AssumptionEntry>,
    /// Pilots with their bores, load side first.
    pub pilots: Vec<Pilot>,
    /// Tolerances of the output flange.
    pub tolerances: Vec<MountValue>,
    /// Dimensions, mass, mounting plate, degree of protection.
    pub dimensions: Vec<MountValue>,
    /// `true` if the mass requires lifting gear; `null` if the manual states no mass for the code.
    pub lifting_gear: Option<bool>,
    /// Bolted joints, load side first.
    pub joints: Vec<Joint>,
    /// Requirements of the manual, in the order of a machine's life.
    pub facts: Vec<Fact>,
    /// Errata of the values above.
    pub errata: Vec<CitedErratum>,
}

/// A pilot with its bore.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Pilot {
    /// Side of the actuator.
    pub side: Id<Side>,
    /// Name of the side.
    pub title: String,
    /// Nominal diameter.
    pub nominal: Number,
    /// Tolerance zone of the pilot.
    pub zone: &'static str,
    /// Upper limit deviation of the pilot.
    pub upper: Number,
    /// Lower limit deviation of the pilot.
    pub lower: Number,
    /// Tolerance zone recommended by the manual for the bore.
    pub recommended: &'static str,
    /// Tolerance zone of the bore; `null` for user-defined limit deviations.
    pub bore: Option<&'static str>,
    /// Upper limit deviation of the bore.
    pub bore_upper: Number,
    /// Lower limit deviation of the bore.
    pub bore_lower: Number,
    /// Smallest clearance; interference is negative.
    pub clearance_min: Number,
    /// Largest clearance.
    pub clearance_max: Number,
    /// Largest offset of the part from the centre: half of the largest clearance, zero with interference.
    pub off_centre_max: Number,
    /// Kind of fit.
    pub fit: Id<FitKind>,
    /// Kind of fit as text.
    pub fit_text: String,
    /// Grade of the clearances.
    pub grade: Id<Grade>,
    /// Sources of the figures.
    pub sources: Vec<String>,
}

/// A value stated in the manual.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MountValue {
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// Technical term.
    pub name: String,
    /// Value; `null` if the manual states none for the code.
    pub value: TableCell,
    /// Unit in ASCII; empty for texts.
    pub unit: &'static str,
    /// Grade of the value; `null` without a value.
    pub grade: Option<Id<Grade>>,
    /// Source of the value; `null` without a value.
    pub source: Option<String>,
    /// Ids of the errata that touch it.
    pub errata: Vec<&'static str>,
}

/// A bolted joint.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Joint {
    /// Side of the actuator.
    pub side: Id<Side>,
    /// Name of the side.
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
    /// Torque transmitted by the joint with degreased faces.
    pub transmissible_torque: Option<Number>,
    /// Friction coefficient assumed for this torque.
    pub friction: Option<Number>,
    /// Clamp force per screw that follows from it: estimated.
    pub clamp_force: Option<Number>,
    /// Source of the stated values.
    pub source: Option<String>,
    /// Ids of the errata that touch the tightening torque.
    pub tightening_errata: Vec<&'static str>,
    /// Ids of the errata that touch the torque that the joint transmits.
    pub transmissible_errata: Vec<&'static str>,
    /// Results for each load.
    pub cases: Vec<JointCase>,
}

/// A joint under a load.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct JointCase {
    /// Load case.
    pub case: Id<LoadCase>,
    /// Name of the load case.
    pub title: String,
    /// Torque; `null` without one, or if unknown.
    pub torque: Option<Number>,
    /// Source of the torque.
    pub torque_source: Option<String>,
    /// Ids of the errata that touch the torque.
    pub torque_errata: Vec<&'static str>,
    /// Share of the transmissible torque, torque alone.
    pub utilisation: Option<Number>,
    /// Verdict on torque alone.
    pub verdict: Id<Verdict>,
    /// Grade of the utilisation.
    pub grade: Option<Id<Grade>>,
    /// Tilting moment acting at the same time.
    pub moment: Option<Number>,
    /// Source of the moment.
    pub moment_source: Option<String>,
    /// Ids of the errata that touch the moment.
    pub moment_errata: Vec<&'static str>,
    /// Share of its clamp force lost by the screw relieved most: estimated.
    pub relieved: Option<Number>,
    /// Share of the remaining friction used by torque and forces: estimated; `null` if the joint opens.
    pub utilisation_together: Option<Number>,
    /// Verdict on all loads together; `advice` if the estimate is not sufficient.
    pub verdict_together: Id<Verdict>,
    /// Missing data for a verdict, as text.
    pub missing: Option<String>,
}

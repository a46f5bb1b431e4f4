//! Records of single subjects: curves, torsion, bearing, battery, inertia.

use crate::{AssumptionEntry, Check, Id, Number, Units};
use provenance::Grade;
use schemars::JsonSchema;
use serde::Serialize;

/// `curve`: the curves of the torque-speed plane.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Curves {
    /// Ordering code.
    pub code: String,
    /// Units of speed, torque, voltage and duty factor.
    pub units: Units,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// One curve of the torque-speed plane.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Curve {
    /// Duty of the curve.
    pub kind: CurveKind,
    /// Duty factor of S3 in %; `null` for other duties.
    #[serde(rename = "ED")]
    pub duty: Option<Number>,
    /// Name of the curve.
    pub title: String,
    /// Terminal voltage of the curve, rms; `null` if it holds for all voltages.
    pub voltage: Option<Number>,
    /// Speed and torque, by rising speed.
    pub points: Vec<[Number; 2]>,
    /// Upper edge of an estimate's band; `null` if there is none.
    pub upper: Option<Vec<[Number; 2]>>,
    /// Grade of the curve.
    pub grade: Id<Grade>,
    /// Source of the curve.
    pub source: String,
}

/// Duty of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CurveKind {
    /// Continuous.
    Continuous,
    /// Intermittent periodic duty.
    #[serde(rename = "S3")]
    S3,
    /// Short time.
    ShortTime,
}

/// `torsion`: twist angle of a gear under a torque.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Torsion {
    /// Ordering code.
    pub code: String,
    /// Torque.
    pub torque: Number,
    /// Twist angle in rad.
    pub angle_rad: Number,
    /// Twist angle in arcmin.
    pub angle_arcmin: Number,
    /// Number of the linear section of the curve in which the angle lies, from 1 to 3.
    pub region: u8,
    /// End of the first section.
    #[serde(rename = "T_1")]
    pub torque_1: Number,
    /// End of the second section.
    #[serde(rename = "T_2")]
    pub torque_2: Number,
    /// Stiffness of the three sections.
    #[serde(rename = "K")]
    pub stiffness: [Number; 3],
    /// Maximum hysteresis loss after full torque in both directions; `null` if the manual states none.
    pub hysteresis_loss: Option<Number>,
    /// Maximum lost motion under a few per cent of the rated torque in both directions; `null` if the manual states
    /// none.
    pub lost_motion: Option<Number>,
    /// Limits of actuator and gear that the torque exceeds; the curve is not stated beyond them.
    pub exceeds: Vec<TorqueExceeded>,
    /// Units of torque, stiffness and angles.
    pub units: Units,
    /// Source of the curve.
    pub source: String,
}

/// A limit that a torque exceeds.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct TorqueExceeded {
    /// Symbol of the limit: `T_max`, `T_M`.
    pub symbol: &'static str,
    /// Limit.
    pub limit: Number,
    /// Grade of the limit.
    pub grade: Id<Grade>,
    /// Source of the limit.
    pub source: String,
    /// Ids of the errata that concern the limit.
    pub errata: Vec<&'static str>,
}

/// `bearing`: output bearing of each size under the loads of the project.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Bearings {
    /// Results for every size.
    pub sizes: Vec<BearingOfSize>,
    /// Assumptions of the axis.
    pub assumptions: Vec<AssumptionEntry>,
}

/// Output bearing of one size.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BearingOfSize {
    /// Size of the actuator.
    pub size: String,
    /// `true` if none of the checks fails.
    pub fits: bool,
    /// Checks of the bearing.
    pub checks: Vec<Check>,
}

/// `battery`: life of the encoder's battery.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Battery {
    /// Operation per day \[h\].
    pub hours_per_day: Number,
    /// Storage before use in `unit`.
    pub storage: Number,
    /// Life in `unit`.
    pub life: Number,
    /// Recommended time of the replacement.
    pub exchange_recommended: Number,
    /// Latest time of the replacement.
    pub exchange_latest: Number,
    /// `true` if the life is limited by the cell instead of its charge.
    pub capped: bool,
    /// Unit of the times in years.
    pub unit: &'static str,
    /// Grade of the life.
    pub grade: Id<Grade>,
    /// Source of the life.
    pub source: String,
}

/// `inertia`: solid bodies about the axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Inertia {
    /// The bodies.
    pub bodies: Vec<Body>,
    /// Moment of inertia of all bodies about the axis.
    #[serde(rename = "J")]
    pub inertia: Number,
    /// Mass of all bodies.
    #[serde(rename = "m")]
    pub mass: Number,
    /// Centre of gravity of all bodies.
    pub centre: Centre,
    /// Largest torque of gravity with a horizontal axis.
    #[serde(rename = "T_gravity_max")]
    pub gravity_torque: Number,
    /// Units of the figures.
    pub units: Units,
}

/// A centre of gravity in polar coordinates about the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Centre {
    /// Distance from the axis.
    #[serde(rename = "r")]
    pub radius: Number,
    /// Direction of the centre of gravity.
    pub angle: Number,
}

/// One body, or several equal ones at equal angles.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Body {
    /// Id of the shape.
    pub shape: &'static str,
    /// Number of equal bodies.
    pub count: u32,
    /// Mass of one body.
    #[serde(rename = "m")]
    pub mass: Number,
    /// Distance of the body's centre from the axis.
    #[serde(rename = "r")]
    pub distance: Number,
    /// Direction of the first body.
    pub angle: Number,
    /// Moment of inertia of one body about its own centre.
    #[serde(rename = "J_own")]
    pub own: Number,
    /// Parallel-axis (Steiner) share of the moment of inertia.
    #[serde(rename = "J_steiner")]
    pub steiner: Number,
    /// Moment of inertia of all equal bodies about the axis.
    #[serde(rename = "J")]
    pub total: Number,
}

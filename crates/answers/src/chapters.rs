//! Records of single subjects: curves, torsion, bearing, battery, inertia.

use crate::{Check, Id, Number, Units};
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
    /// Which duty.
    pub kind: CurveKind,
    /// Duty factor of S3 in %; `null` of the others.
    #[serde(rename = "ED")]
    pub duty: Option<Number>,
    /// Its name in words.
    pub title: String,
    /// DC link voltage that it holds for; `null` where it holds for all.
    pub voltage: Option<Number>,
    /// Speed and torque, by rising speed.
    pub points: Vec<[Number; 2]>,
    /// Upper edge of an estimate's band; `null` where there is none.
    pub upper: Option<Vec<[Number; 2]>>,
    /// How far it can be trusted.
    pub grade: Id<Grade>,
    /// Where it is from.
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

/// `torsion`: the angle by which a gear yields under a torque.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Torsion {
    /// Ordering code.
    pub code: String,
    /// The torque.
    pub torque: Number,
    /// The angle in rad.
    pub angle_rad: Number,
    /// The same angle in arcmin.
    pub angle_arcmin: Number,
    /// Which of the three straight pieces of the curve it lies on, from 1.
    pub region: u8,
    /// End of the first piece.
    #[serde(rename = "T_1")]
    pub torque_1: Number,
    /// End of the second piece.
    #[serde(rename = "T_2")]
    pub torque_2: Number,
    /// Stiffness of the three pieces.
    #[serde(rename = "K")]
    pub stiffness: [Number; 3],
    /// Most that is lost by hysteresis after full torque to both sides; `null` where none is printed.
    pub hysteresis_loss: Option<Number>,
    /// Most that is lost under a few per cent of the rated torque to both sides; `null` where none is printed.
    pub lost_motion: Option<Number>,
    /// Units of torque, stiffness and lost angles.
    pub units: Units,
    /// Where the curve is from.
    pub source: &'static str,
}

/// `bearing`: the output bearing of each size under the loads of the project.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Bearings {
    /// Every size.
    pub sizes: Vec<BearingOfSize>,
}

/// The output bearing of one size.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BearingOfSize {
    /// The size.
    pub size: String,
    /// Whether none of its checks fails.
    pub fits: bool,
    /// The checks of the bearing.
    pub checks: Vec<Check>,
}

/// `battery`: the life of the encoder's battery.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Battery {
    /// Life in `unit`.
    pub life: Number,
    /// When it should be exchanged.
    pub exchange_recommended: Number,
    /// When it must be exchanged.
    pub exchange_latest: Number,
    /// Whether the life is that of the cell, not of its charge.
    pub capped: bool,
    /// Unit of the three.
    pub unit: &'static str,
    /// How far the life can be trusted.
    pub grade: Id<Grade>,
    /// Where it is from.
    pub source: String,
}

/// `inertia`: solid bodies about the axis.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Inertia {
    /// Body by body.
    pub bodies: Vec<Body>,
    /// Moment of inertia of all about the axis.
    #[serde(rename = "J")]
    pub inertia: Number,
    /// Mass of all.
    #[serde(rename = "m")]
    pub mass: Number,
    /// Centre of gravity of all.
    pub centre: Centre,
    /// Largest torque of gravity if the axis lies horizontally.
    #[serde(rename = "T_gravity_max")]
    pub gravity_torque: Number,
    /// The units of the figures.
    pub units: Units,
}

/// A centre of gravity in polar coordinates about the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Centre {
    /// Distance from the axis.
    #[serde(rename = "r")]
    pub radius: Number,
    /// Direction.
    pub angle: Number,
}

/// One body, or several alike at equal angles.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Body {
    /// Id of its shape.
    pub shape: &'static str,
    /// How many.
    pub count: u32,
    /// Mass of one of them.
    #[serde(rename = "m")]
    pub mass: Number,
    /// Distance of the centre from the axis.
    #[serde(rename = "r")]
    pub distance: Number,
    /// Direction of the first.
    pub angle: Number,
    /// Inertia of one of them about the own centre.
    #[serde(rename = "J_own")]
    pub own: Number,
    /// What the distance adds to that.
    #[serde(rename = "J_steiner")]
    pub steiner: Number,
    /// Both together, of all of them.
    #[serde(rename = "J")]
    pub total: Number,
}

//! Demand of the axis on any actuator.

use crate::{Number, Units};
use schemars::JsonSchema;
use serde::Serialize;

/// How the figures of a demand were found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DemandMode {
    /// By the manual's equations 69.1 to 69.4.
    Manual,
    /// By exact integration.
    Integral,
}

/// The figures of a demand.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DemandFigures {
    /// Effective torque in Nm.
    #[serde(rename = "T_rms")]
    pub torque_rms: Number,
    /// Largest torque in Nm.
    #[serde(rename = "T_peak")]
    pub torque_peak: Number,
    /// Mean speed in 1/min.
    #[serde(rename = "n_av")]
    pub speed_mean: Number,
    /// Largest speed in 1/min.
    #[serde(rename = "n_peak")]
    pub speed_peak: Number,
    /// Share of the cycle in which the axis moves, in %.
    #[serde(rename = "ED")]
    pub duty_factor: Number,
}

/// The three torques of a move of the manual's form, in its direction, in Nm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MoveTorques {
    /// While accelerating.
    #[serde(rename = "T_1")]
    pub accelerate: Number,
    /// While running.
    #[serde(rename = "T_2")]
    pub run: Number,
    /// While braking.
    #[serde(rename = "T_3")]
    pub brake: Number,
}

/// The demand; where the manual's equations describe the axis, their figures with the exact integrals beside them.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Demand {
    /// `integral` where the manual's equations do not describe the axis: then the figures are those of the integrals, and
    /// the three torques, `moves` and `integral` are left out.
    pub mode: DemandMode,
    /// The figures.
    #[serde(flatten)]
    pub figures: DemandFigures,
    /// The torques of the governing move.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub torques: Option<MoveTorques>,
    /// The units of the figures.
    pub units: Units,
    /// With several moves only: the torques of each.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub moves: Vec<MoveTorques>,
    /// With several moves only: number of the move with the largest torque, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub governing_move: Option<usize>,
    /// The same figures by exact integration; checks use these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub integral: Option<IntegralDemand>,
}

/// The figures by exact integration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct IntegralDemand {
    /// The figures.
    #[serde(flatten)]
    pub figures: DemandFigures,
    /// Always `integral`.
    pub mode: DemandMode,
}

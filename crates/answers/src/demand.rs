//! Demand of the axis on any actuator.

use crate::{Number, Units};
use schemars::JsonSchema;
use serde::Serialize;

/// Method by which the figures of a demand are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum DemandMode {
    /// The manual's equations 69.1 to 69.4.
    Manual,
    /// Exact integration.
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

/// Torques in the three phases of a move of the manual's form, in its direction, in Nm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MoveTorques {
    /// Torque during acceleration.
    #[serde(rename = "T_1")]
    pub accelerate: Number,
    /// Torque at constant speed.
    #[serde(rename = "T_2")]
    pub run: Number,
    /// Torque during deceleration.
    #[serde(rename = "T_3")]
    pub brake: Number,
}

/// The demand; if the manual's equations describe the axis, their figures together with the exact integrals.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Demand {
    /// `integral` if the manual's equations do not describe the axis, also if a move brakes in another time than it
    /// accelerates: then the figures are those of the integrals, and
    /// the three torques, `moves` and `integral` are omitted.
    pub mode: DemandMode,
    /// Figures of the demand.
    #[serde(flatten)]
    pub figures: DemandFigures,
    /// Torques of the governing move.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub torques: Option<MoveTorques>,
    /// Units of the figures.
    pub units: Units,
    /// Torques of each move; only with several moves.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub moves: Vec<MoveTorques>,
    /// Number of the move with the largest torque, from 1; only with several moves.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub governing_move: Option<usize>,
    /// Figures by exact integration, which the checks use.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub integral: Option<IntegralDemand>,
}

/// Figures of the demand by exact integration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct IntegralDemand {
    /// Figures of the demand.
    #[serde(flatten)]
    pub figures: DemandFigures,
    /// `integral` in every case.
    pub mode: DemandMode,
}

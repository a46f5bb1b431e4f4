//! The cycle on the chosen actuator, segment by segment, and the printed data of that actuator.

use crate::Number;
use schemars::JsonSchema;
use serde::Serialize;

/// The cycle on the chosen actuator.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Operation {
    /// The segments of the motion in their order.
    pub segments: Vec<SegmentLoad>,
    /// The whole cycle.
    pub cycle: SegmentLoad,
    /// Shaft of the motor; `null` without a ratio.
    pub motor: Option<MotorSide>,
    /// Largest inertia of the load at the output in kgm².
    pub inertia_load: Number,
    /// Inertia of the actuator at the output in kgm².
    pub inertia_own: Number,
    /// Duty type that the cycle corresponds to.
    pub duty: Duty,
}

/// Load of the actuator within a segment; `null` where a datum is not known.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SegmentLoad {
    /// Duration in s.
    pub duration: Number,
    /// Largest torque at the output in Nm, own inertia included.
    pub torque_peak: Number,
    /// Effective torque in Nm.
    pub torque_rms: Number,
    /// Largest output speed in 1/min.
    pub speed_peak: Number,
    /// Largest motor current in A, rms of a phase, with the gear at the ambient temperature.
    pub current_peak_cold: Option<Number>,
    /// Largest motor current in A, rms of a phase, in the settled cycle, as all values below.
    pub current_peak: Option<Number>,
    /// Effective motor current in A.
    pub current_rms: Option<Number>,
    /// Largest power taken at the motor terminals in W.
    pub power_peak: Option<Number>,
    /// Energy taken at the motor terminals in J.
    pub energy_taken: Option<Number>,
    /// Energy returned at the motor terminals in J.
    pub energy_returned: Option<Number>,
}

/// Speed and torque at the shaft of the motor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MotorSide {
    /// Reduction ratio.
    pub ratio: Number,
    /// Largest speed in 1/min.
    pub speed_peak: Number,
    /// Mean speed in 1/min.
    pub speed_mean: Number,
    /// Largest torque in Nm with the gear at the ambient temperature, friction included; `null` where the torque constant or
    /// the current is not known.
    pub torque_peak_cold: Option<Number>,
    /// Largest torque in Nm in the settled cycle.
    pub torque_peak: Option<Number>,
    /// Effective torque in Nm in the settled cycle.
    pub torque_rms: Option<Number>,
    /// Ids of the errata of the motor torque constant, on which both torques rest.
    pub torque_errata: &'static [&'static str],
}

/// Duty type of IEC 60034-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Duty {
    /// Designation, `S1` to `S8`.
    pub id: &'static str,
    /// Name.
    pub name: &'static str,
    /// Properties of the cycle from which it follows.
    pub reason: &'static str,
}

/// A printed value of the chosen actuator.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct DataLine {
    /// Symbol; empty where the print has none.
    pub symbol: &'static str,
    /// The field's word for it.
    pub name: String,
    /// The value after errata, with the printed one where it differs; `–` where none is printed.
    pub value: String,
    /// Unit; empty for texts and pure numbers.
    pub unit: String,
    /// Number of the table.
    pub table: &'static str,
    /// Ids of the errata that touch it.
    pub errata: &'static [&'static str],
}

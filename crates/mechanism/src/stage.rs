//! A stage between the actuator and the mechanism: belt, gear or coupling.

use crate::{Extra, Mechanism, Output};
use quantities::{Angle, Length, Measure, MomentOfInertia, Torque, TorsionalStiffness};

/// Kind of the stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StageKind {
    /// Two pulleys and a belt.
    Belt,
    /// A gear pair.
    Gear,
    /// A coupling, ratio 1.
    Coupling,
}

/// A stage between the actuator and the mechanism. The motion is stated at the mechanism; the output of the actuator
/// turns i_s times as far.
///
/// q = i_s q_2, T = (T_2 + J_2 α_2)/(i_s η) + J_1 α
///
/// # Symbols
/// index 2 at the mechanism; i_s ratio, J_1 and J_2 inertia on the side of the actuator and of the mechanism, η
/// efficiency
/// # Source
/// docs/theory/stage.md
/// # Valid
/// both sides have the same sign of rotation; elasticity and backlash do not affect the torque of the cycle
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// Kind of the stage.
    pub kind: StageKind,
    /// i_s: turns of the actuator's output per turn of the mechanism, greater than zero.
    pub ratio: f64,
    /// η_1 while the actuator drives \[1\].
    pub efficiency_driving: f64,
    /// η_2 while the mechanism drives \[1\].
    pub efficiency_driven: f64,
    /// J_1: inertia of parts turning with the actuator.
    pub inertia_driving: MomentOfInertia,
    /// J_2: inertia of parts turning with the mechanism.
    pub inertia_driven: MomentOfInertia,
    /// K_s: torsional stiffness on the side of the mechanism; `None` if rigid.
    pub stiffness: Option<TorsionalStiffness>,
    /// Backlash on the side of the mechanism; `None` if there is none.
    pub backlash: Option<Angle>,
    /// d_1: pitch diameter of the wheel on the actuator, for the force on the flange.
    pub pitch_diameter: Option<Length>,
}

impl Stage {
    /// Returns `true` if the stage leaves torque and speed unchanged.
    #[must_use]
    pub fn changes_nothing(&self) -> bool {
        self.ratio == 1.0
            && self.efficiency_driving == 1.0
            && self.efficiency_driven == 1.0
            && self.inertia_driving.si() == 0.0
            && self.inertia_driven.si() == 0.0
    }

    /// Returns the state of the mechanism beyond the stage.
    pub(crate) fn behind(&self, output: &Output) -> Output {
        Output {
            position_rad: output.position_rad / self.ratio,
            speed_rad_s: output.speed_rad_s / self.ratio,
            acceleration_rad_s2: output.acceleration_rad_s2 / self.ratio,
            direction: output.direction,
        }
    }

    /// Returns T_2 + J_2 α_2, the torque transmitted by the stage \[Nm\].
    pub(crate) fn handed_on(&self, torque: f64, behind: &Output) -> f64 {
        torque + self.inertia_driven.si() * behind.acceleration_rad_s2
    }

    /// Returns the torque on the actuator side for a transmitted torque, without the inertia on that side \[Nm\].
    pub(crate) fn taken(&self, handed_on: f64, direction: f64) -> f64 {
        with_losses(handed_on, direction, [self.efficiency_driving, self.efficiency_driven]) / self.ratio
    }

    /// Returns the force at the circumference of the wheel on the actuator for a transmitted torque \[N\]. While the mechanism
    /// drives, it is not known where the losses occur: they are not counted as a relief.
    pub(crate) fn tangential(&self, handed_on: f64, direction: f64) -> f64 {
        let torque = self.taken(handed_on, direction).abs().max((handed_on / self.ratio).abs());
        torque / (0.5 * self.pitch_diameter.map_or(0.0, Measure::si))
    }

    /// Returns the torque at the output of the actuator \[Nm\].
    pub(crate) fn torque(&self, torque: f64, behind: &Output, output: &Output) -> f64 {
        self.taken(self.handed_on(torque, behind), output.direction)
            + self.inertia_driving.si() * output.acceleration_rad_s2
    }

    /// Returns (J + J_2)/i_s² + J_1, the inertia at the output of the actuator \[kgm²\].
    pub(crate) fn inertia(&self, inertia: f64) -> f64 {
        (inertia + self.inertia_driven.si()) / (self.ratio * self.ratio) + self.inertia_driving.si()
    }
}

/// Returns a torque on the input side of losses, using the efficiency for driving or driven; at rest without losses.
pub(crate) fn with_losses(torque: f64, direction: f64, [driving, driven]: [f64; 2]) -> f64 {
    let power = torque * direction;
    if power > 0.0 {
        torque / driving
    } else if power < 0.0 {
        torque * driven
    } else {
        torque
    }
}

impl Mechanism {
    /// Returns the stage if it changes torque or speed.
    pub(crate) fn gearing(&self) -> Option<&Stage> {
        self.stage.as_ref().filter(|stage| !stage.changes_nothing())
    }

    /// Returns the turns of the actuator's output per turn of the mechanism; 1 without a stage.
    #[must_use]
    pub fn stage_ratio(&self) -> f64 {
        self.stage.as_ref().map_or(1.0, |stage| stage.ratio)
    }

    /// Returns the torque transmitted by the stage to the mechanism \[Nm\], at whose change of sign driving and driven
    /// side are exchanged. Zero without a stage.
    #[must_use]
    pub fn stage_torque(&self, output: &Output, extra: &Extra) -> f64 {
        self.loading(extra).at(output).stage_nm
    }

    /// Returns the stiffness between the motor and the mechanism, at the output of the actuator: gear and stage in
    /// series.
    ///
    /// 1/K' = 1/K + i_s²/K_s
    ///
    /// # Symbols
    /// K stiffness of the gear, K_s stiffness of the stage on the side of the mechanism [Nm/rad], i_s ratio
    /// # Source
    /// docs/theory/stage.md
    /// # Valid
    /// K without a stage or with a rigid one
    #[must_use]
    pub fn in_series(&self, gear: TorsionalStiffness) -> TorsionalStiffness {
        match self.stage.as_ref().and_then(|stage| Some((stage.ratio, stage.stiffness?.si()))) {
            Some((n, stage)) => TorsionalStiffness::from_si(gear.si() / (1.0 + gear.si() * n * n / stage)),
            None => gear,
        }
    }

    /// Returns the torque of the Coulomb friction at the output of the actuator.
    #[must_use]
    pub fn coulomb_torque(&self) -> Torque {
        Torque::from_si(self.before_stage(self.friction.coulomb.si()))
    }

    /// Returns a torque at rest, at the output of the actuator; losses are not counted as a relief.
    pub(crate) fn before_stage(&self, torque: f64) -> f64 {
        torque / self.gearing().map_or(1.0, |stage| stage.ratio)
    }
}

#[cfg(test)]
#[path = "stage_tests.rs"]
mod tests;

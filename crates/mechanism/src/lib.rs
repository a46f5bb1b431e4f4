//! From what is moved to torque and inertia at the output of the actuator.
//!
//! So far the load is given directly; screws, arms, belts and tables will join here.

mod body;

pub use body::{Body, BodyError, BodyFault, BodyInertia, Inertia, Orientation, Shape, inertia};

use quantities::{AngularAcceleration, Measure, MomentOfInertia, Torque};

/// A load given at the output of the actuator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectLoad {
    /// J_L: moment of inertia at the output.
    pub inertia: MomentOfInertia,
    /// T_L: magnitude of the Coulomb friction torque at the output; opposes every motion, vanishes at rest.
    pub friction_torque: Torque,
}

impl DirectLoad {
    /// Torque that the output must give to accelerate an inertia against the friction.
    ///
    /// T = (J_L + J_own) α + T_L σ
    ///
    /// # Symbols  J_own further inertia on the same shaft \[kgm²\], α acceleration [rad/s²], σ direction of motion (+1, 0, −1)
    /// # Source   cha-manual eq. 69.1 and 69.2, with the sign of the direction made explicit
    /// # Valid    friction independent of speed
    #[must_use]
    pub fn torque(&self, own_inertia: MomentOfInertia, acceleration: AngularAcceleration, direction: f64) -> Torque {
        quantities::torque_of(self.inertia + own_inertia, acceleration)
            + Torque::from_si(self.friction_torque.si() * direction)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_helps_braking_and_is_gone_at_rest() {
        let load = DirectLoad { inertia: MomentOfInertia::from_si(1.3), friction_torque: Torque::from_si(5.0) };
        let own = MomentOfInertia::from_si(1.063);
        let alpha = 40.0 * std::f64::consts::TAU / 60.0 / 0.1;
        let at = |alpha, direction| load.torque(own, AngularAcceleration::from_si(alpha), direction).si();
        assert!((at(alpha, 1.0) - 103.98).abs() < 0.005, "T_1 of the worked example");
        assert!((at(-alpha, 1.0) - -93.98).abs() < 0.005, "T_3 of the worked example");
        assert!((at(-alpha, -1.0) - -103.98).abs() < 0.005, "the mirror image");
        assert_eq!(at(0.0, 0.0), 0.0);
    }
}

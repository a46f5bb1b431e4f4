//! Friction at the output, divided by its dependence on the motion.

use quantities::{Measure, Torque, ViscousFriction};

/// Friction, and the torque that does not reverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// T_c: Coulomb friction, opposes the motion, zero at rest.
    pub coulomb: Torque,
    /// b: viscous friction, proportional to the speed.
    pub viscous: ViscousFriction,
    /// T_e: external torque against the positive direction; it does not reverse with the motion and acts at rest too.
    pub external: Torque,
}

impl Friction {
    /// Returns zero friction and zero external torque.
    #[must_use]
    pub fn none() -> Self {
        Self { coulomb: Torque::from_si(0.0), viscous: ViscousFriction::from_si(0.0), external: Torque::from_si(0.0) }
    }
}

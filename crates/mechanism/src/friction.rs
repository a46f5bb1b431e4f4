//! Friction at the output, split by how it depends on the motion.

use quantities::{Measure, Torque, ViscousFriction};

/// Friction and the torque that does not reverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// T_c: Coulomb friction, opposes the motion, gone at rest.
    pub coulomb: Torque,
    /// b: viscous friction, proportional to the speed.
    pub viscous: ViscousFriction,
    /// T_e: external torque against the positive direction; it does not reverse with the motion and acts at rest too.
    pub external: Torque,
}

impl Friction {
    /// None at all.
    #[must_use]
    pub fn none() -> Self {
        Self { coulomb: Torque::from_si(0.0), viscous: ViscousFriction::from_si(0.0), external: Torque::from_si(0.0) }
    }
}

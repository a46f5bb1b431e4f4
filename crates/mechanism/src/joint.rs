//! A joint whose torque is recorded with its motion.

use quantities::{MomentOfInertia, Torque};

/// A joint of a robot: inverse dynamics or a measurement gave the torque at every instant, with inertia, gravity and the
/// friction of the arm in it.
///
/// # Valid    inertia and holding torque are only for the checks that look beyond the recorded torque: ratio of inertias,
/// natural frequency and brake
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Largest inertia that the joint feels; zero if it is not stated.
    pub inertia: MomentOfInertia,
    /// Largest torque that holds the arm at rest.
    pub holding_torque: Option<Torque>,
}

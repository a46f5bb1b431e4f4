//! The products of mechanics that `uom` keeps apart by kind: torque is no energy, an angle is no mere ratio.

use crate::{AngularAcceleration, AngularVelocity, MomentOfInertia, Power, Time, Torque};

/// T = J α
#[must_use]
pub fn torque_of(inertia: MomentOfInertia, acceleration: AngularAcceleration) -> Torque {
    (inertia * acceleration).into()
}

/// P = T ω
#[must_use]
pub fn power_of(torque: Torque, speed: AngularVelocity) -> Power {
    torque * speed
}

/// α = Δω / Δt
#[must_use]
pub fn acceleration_of(speed_change: AngularVelocity, duration: Time) -> AngularAcceleration {
    (speed_change / duration).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Measure;

    #[test]
    fn the_products_have_the_right_size() {
        let torque = torque_of(MomentOfInertia::from_si(2.0), AngularAcceleration::from_si(3.0));
        assert!((torque.si() - 6.0).abs() < 1e-15);
        assert!((power_of(torque, AngularVelocity::from_si(0.5)).si() - 3.0).abs() < 1e-15);
        assert!((acceleration_of(AngularVelocity::from_si(3.0), Time::from_si(2.0)).si() - 1.5).abs() < 1e-15);
    }
}

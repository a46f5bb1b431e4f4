//! The products of mechanics that `uom` keeps apart by kind (torque is no energy, an angle no mere ratio), and those of
//! the constants that are newtypes here.

use crate::measure::{
    Measure, NoLoadCurrentConstant, TiltingStiffness, TorqueConstant, TorsionalStiffness, ViscousFriction,
    VoltageConstant,
};
use crate::{
    Acceleration, Angle, AngularAcceleration, AngularVelocity, ElectricCurrent, ElectricPotential, Force, Mass,
    MomentOfInertia, Power, Time, Torque,
};
use std::ops::{Div, Mul};

/// Torque that gives an inertia an angular acceleration.
///
/// T = J α
#[must_use]
pub fn torque_of(inertia: MomentOfInertia, acceleration: AngularAcceleration) -> Torque {
    (inertia * acceleration).into()
}

/// Power of a torque at a speed.
///
/// P = T ω
#[must_use]
pub fn power_of(torque: Torque, speed: AngularVelocity) -> Power {
    torque * speed
}

/// Mean angular acceleration of a change of speed.
///
/// α = Δω / Δt
#[must_use]
pub fn acceleration_of(speed_change: AngularVelocity, duration: Time) -> AngularAcceleration {
    (speed_change / duration).into()
}

/// Force that gives a mass an acceleration.
///
/// F = m a
#[must_use]
pub fn force_of(mass: Mass, acceleration: Acceleration) -> Force {
    mass * acceleration
}

/// `constant * cause = effect`, in either order, and `effect / constant = cause`.
macro_rules! linear {
    ($($constant:ty: $cause:ty => $effect:ty;)*) => {$(
        impl Mul<$cause> for $constant {
            type Output = $effect;

            fn mul(self, cause: $cause) -> $effect {
                <$effect>::from_si(self.si() * cause.si())
            }
        }

        impl Mul<$constant> for $cause {
            type Output = $effect;

            fn mul(self, constant: $constant) -> $effect {
                constant * self
            }
        }

        impl Div<$constant> for $effect {
            type Output = $cause;

            fn div(self, constant: $constant) -> $cause {
                <$cause>::from_si(self.si() / constant.si())
            }
        }
    )*};
}

linear! {
    TorqueConstant: ElectricCurrent => Torque;
    VoltageConstant: AngularVelocity => ElectricPotential;
    NoLoadCurrentConstant: AngularVelocity => ElectricCurrent;
    TorsionalStiffness: Angle => Torque;
    TiltingStiffness: Angle => Torque;
    ViscousFriction: AngularVelocity => Torque;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::{
        ARCMINUTE, REVOLUTION_PER_MINUTE, TORSIONAL_NEWTON_METRE_PER_ARCMINUTE, VOLT_PER_THOUSAND_REVOLUTIONS,
    };
    use crate::{Energy, Length};

    fn close(value: f64, expected: f64) -> bool {
        (value - expected).abs() <= 1e-14 * expected.abs()
    }

    #[test]
    fn the_products_have_the_right_kind_and_size() {
        let torque = torque_of(MomentOfInertia::from_si(2.0), AngularAcceleration::from_si(3.0));
        assert!(close(torque.si(), 6.0));
        assert!(close(power_of(torque, AngularVelocity::from_si(0.5)).si(), 3.0));
        assert!(close(acceleration_of(AngularVelocity::from_si(3.0), Time::from_si(2.0)).si(), 1.5));
        assert!(close(force_of(Mass::from_si(2.0), Acceleration::from_si(9.5)).si(), 19.0));
    }

    #[test]
    fn uom_alone_tells_torque_from_energy() {
        let work: Energy = Force::from_si(3.0) * Length::from_si(2.0);
        let torque: Torque = (Force::from_si(3.0) * Length::from_si(2.0)).into();
        let turning: Energy = torque * Angle::from_si(2.0);
        assert!(close(work.si(), 6.0));
        assert!(close(torque.si(), 6.0));
        assert!(close(turning.si(), 12.0));
    }

    #[test]
    fn constants_lead_from_cause_to_effect_and_back() {
        let constant = TorqueConstant::from_si(16.5);
        let torque = constant * ElectricCurrent::from_si(2.0);
        assert!(close(torque.si(), 33.0));
        assert!(close((ElectricCurrent::from_si(2.0) * constant).si(), 33.0));
        assert!(close((torque / constant).si(), 2.0));
        let induced = VoltageConstant::new_in(23.0, &VOLT_PER_THOUSAND_REVOLUTIONS)
            * AngularVelocity::new_in(500.0, &REVOLUTION_PER_MINUTE);
        assert!(close(induced.si(), 11.5));
        let twist = Torque::from_si(30.0) / TorsionalStiffness::new_in(10.0, &TORSIONAL_NEWTON_METRE_PER_ARCMINUTE);
        assert!(close(twist.in_unit(&ARCMINUTE), 3.0));
        assert!(close((NoLoadCurrentConstant::from_si(0.5) * AngularVelocity::from_si(4.0)).si(), 2.0));
        assert!(close((ViscousFriction::from_si(0.5) * AngularVelocity::from_si(4.0)).si(), 2.0));
        assert!(close((TiltingStiffness::from_si(0.5) * Angle::from_si(4.0)).si(), 2.0));
    }
}

//! Products of the constants defined as newtypes in this crate.

use crate::measure::{
    Measure, NoLoadCurrentConstant, TiltingStiffness, TorqueConstant, TorsionalStiffness, ViscousFriction,
    VoltageConstant,
};
use crate::{Angle, AngularVelocity, ElectricCurrent, ElectricPotential, Torque};
use std::ops::{Div, Mul};

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
    use crate::{Energy, Force, Length};

    fn close(value: f64, expected: f64) -> bool {
        (value - expected).abs() <= 1e-14 * expected.abs()
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

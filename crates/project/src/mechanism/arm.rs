//! An unbalanced arm.

use super::parts::{Friction, Losses, StartAngle};
use super::{Driven, MechanismName, OnFlange};
use crate::about::About;
use crate::read::Reader;
use crate::stated::StatedField;
use crate::section::section;
use mechanism::{MechanismKind, Rotor, RotorKind};
use quantities::{Measure, Angle, Length, Mass, MomentOfInertia};

section! {
    /// An arm whose centre of mass is off the axis.
    Arm, ArmName of About::Mechanism, MechanismName::Arm {
        inertia: MomentOfInertia => not_negative, needed;
        mass: Mass => not_negative, needed;
        centre_distance: Length => not_negative, needed;
        payload_distance: Length => not_negative;
        axis_tilt: Angle => needed;
        ..start: StartAngle;
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Driven for Arm {
    fn kind(&self, _: &mut Reader<'_>) -> Option<MechanismKind> {
        Some(MechanismKind::Rotor(Rotor {
            kind: RotorKind::Arm,
            inertia: self.inertia.value()?,
            mass: self.mass.value()?,
            radius: self.centre_distance.value()?,
            payload_radius: self.payload_distance.or_zero(),
            angle: Angle::from_si(0.0),
            tilt: self.axis_tilt.value()?,
        }))
    }

    fn carries(&self) -> bool {
        self.payload_distance.is_written() && self.payload_distance.value().is_none_or(|distance| distance.si() > 0.0)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Bodies(&self.axis_tilt))
    }
}

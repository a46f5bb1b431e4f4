//! An unbalanced arm.

use crate::fault::AxisReport;
use crate::driven::{Driven, OnFlange, TURNED};
use mechanism::{MechanismKind, Rotor, RotorKind};
use project::sections::{Arm, StatedField};
use quantities::{Angle, Dimension, Measure};

impl Driven for Arm {
    fn kind(&self, _: &mut AxisReport<'_>) -> Option<MechanismKind> {
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

    fn shared(&self) -> &'static [Dimension] {
        TURNED
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Bodies(&self.axis_tilt))
    }
}

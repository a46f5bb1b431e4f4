//! Crank, rod and slider.

use crate::fault::AxisReport;
use crate::driven::{Driven, OnFlange};
use mechanism::MechanismKind;
use project::sections::{SliderCrank, StatedField};
use project::Fault;
use quantities::{Angle, Measure};

impl Driven for SliderCrank {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        let (crank, rod) = (self.crank.value()?, self.rod.value()?);
        if rod.si() <= crank.si() {
            report.fault(self.rod.span(), Fault::RodTooShort, None);
            return None;
        }
        Some(MechanismKind::SliderCrank(mechanism::SliderCrank {
            crank,
            rod,
            inertia: self.slide.inertia.or_zero(),
            mass: self.slide.mass.value()?,
            inclination: self.slide.inclination.or_zero(),
            angle: Angle::from_si(0.0),
        }))
    }

    fn gearing(&self) -> Option<&dyn StatedField> {
        Some(&self.crank)
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }
}

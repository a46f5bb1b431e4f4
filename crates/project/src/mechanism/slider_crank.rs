//! Crank, rod and slider.

use super::parts::{Friction, Losses, ProcessForce, Slide, StartAngle};
use super::{Driven, MechanismName, OnFlange};
use crate::Fault;
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use mechanism::MechanismKind;
use quantities::{Measure, Angle, Length};

section! {
    /// A crank that moves a slider by a rod.
    SliderCrank, SliderCrankName of About::Mechanism, MechanismName::SliderCrank {
        crank: Length => positive, needed, example("50 mm");
        rod: Length => positive, needed, example("200 mm");
        ..slide: Slide;
        ..start: StartAngle;
        ..process: ProcessForce;
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Driven for SliderCrank {
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind> {
        let (crank, rod) = (self.crank.value()?, self.rod.value()?);
        if rod.si() <= crank.si() {
            reader.fault(self.rod.span(), Fault::RodTooShort, None);
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

//! Crank, coupler and rocker.

use super::parts::{Friction, Losses, StartAngle};
use super::{Driven, MechanismName, OnFlange, sound};
use crate::Assumption;
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use mechanism::MechanismKind;
use quantities::{Angle, Length, Mass, MomentOfInertia, Torque};

section! {
    /// A four-bar linkage with a rotating crank.
    FourBar, FourBarName of About::Mechanism, MechanismName::FourBar {
        ground: Length => positive, needed, example("400 mm");
        crank: Length => positive, needed, example("100 mm");
        coupler: Length => positive, needed, example("350 mm");
        rocker: Length => positive, needed, example("250 mm");
        crossed: bool;
        inertia: MomentOfInertia => not_negative, noted(Assumption::PartsWithoutInertia);
        coupler_mass: Mass => not_negative, noted(Assumption::CouplerWeightless);
        coupler_centre: Length => not_negative, example("175 mm");
        coupler_inertia: MomentOfInertia => not_negative;
        rocker_mass: Mass => not_negative, noted(Assumption::RockerWeightless);
        rocker_centre: Length => not_negative, example("125 mm");
        rocker_inertia: MomentOfInertia => not_negative;
        rocker_torque: Torque;
        axis_tilt: Angle => needed;
        inclination: Angle => noted(Assumption::GroundHorizontal);
        ..start: StartAngle;
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Driven for FourBar {
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind> {
        let linkage = mechanism::FourBar {
            ground: self.ground.value()?,
            crank: self.crank.value()?,
            coupler: self.coupler.value()?,
            rocker: self.rocker.value()?,
            is_crossed: self.crossed.value().unwrap_or(false),
            inertia: self.inertia.or_zero(),
            coupler_mass: self.coupler_mass.or_zero(),
            coupler_centre: self.coupler_centre.or_zero(),
            coupler_inertia: self.coupler_inertia.or_zero(),
            rocker_mass: self.rocker_mass.or_zero(),
            rocker_centre: self.rocker_centre.or_zero(),
            rocker_inertia: self.rocker_inertia.or_zero(),
            rocker_torque: self.rocker_torque.or_zero(),
            inclination: self.inclination.or_zero(),
            tilt: self.axis_tilt.value()?,
        };
        sound(self, linkage.faults(), reader)?;
        Some(MechanismKind::FourBar(linkage))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.coupler_mass, &self.coupler_inertia, &self.rocker_inertia]
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }
}

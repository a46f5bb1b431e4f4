//! Crank, coupler and rocker.

use crate::fault::AxisReport;
use super::parts::level;
use crate::driven::{Driven, OnFlange, sound};
use mechanism::MechanismKind;
use project::sections::{FourBar, StatedField};

impl Driven for FourBar {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
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
            tilt: level(&self.axis_tilt)?,
        };
        sound(self, linkage.faults(), report)?;
        Some(MechanismKind::FourBar(linkage))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.coupler_mass, &self.coupler_inertia, &self.rocker_inertia]
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }
}

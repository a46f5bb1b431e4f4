//! A web that is wound up or off.

use crate::fault::AxisReport;
use crate::choices;
use crate::driven::{Driven, OnFlange, sound};
use mechanism::MechanismKind;
use project::choices::WebWinding;
use project::sections::{StatedField, Winder};

impl Driven for Winder {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        let winding = if self.winding.is_written() { self.winding.value()? } else { self.winding() };
        let of_the_roll = match winding {
            WebWinding::Up => &self.core_diameter,
            WebWinding::Off => &self.full_diameter,
        };
        let start = if self.start_diameter.is_written() { &self.start_diameter } else { of_the_roll };
        let start_diameter = start.value()?;
        let winder = mechanism::Winder {
            winding: choices::winding(winding),
            core_diameter: self.core_diameter.value()?,
            full_diameter: self.full_diameter.value()?,
            start_diameter,
            thickness: self.thickness.value()?,
            width: self.width.value()?,
            density: self.density.value()?,
            tension: self.tension.value()?,
            inertia: self.inertia.or_zero(),
        };
        sound(self, winder.faults(), report)?;
        Some(MechanismKind::Winder(winder))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.density]
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Roll)
    }
}

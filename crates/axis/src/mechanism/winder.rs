//! A web that is wound up or off.

use crate::fault::AxisReport;
use crate::choices;
use crate::driven::{Driven, OnFlange, sound};
use mechanism::MechanismKind;
use project::sections::{StatedField, Winder};

impl Driven for Winder {
    fn kind(&self, report: &mut AxisReport<'_>) -> Option<MechanismKind> {
        let winder = mechanism::Winder {
            winding: choices::winding(self.winding.value()?),
            core_diameter: self.core_diameter.value()?,
            full_diameter: self.full_diameter.value()?,
            start_diameter: self.start_diameter.value()?,
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
        Some(OnFlange::Wheel)
    }
}

//! A web that is wound up or off.

use super::parts::{Friction, Losses};
use super::{Driven, MechanismName, OnFlange, sound};
use crate::Assumption;
use crate::about::About;
use crate::read::Reader;
use crate::section::section;
use crate::stated::StatedField;
use crate::value::choices;
use mechanism::{MechanismKind, Winding};
use quantities::{Force, Length, MassDensity, MomentOfInertia};

choices! {
    Winding { Up = "up", Off = "off" }
}

section! {
    /// A roll whose diameter changes with every turn.
    Winder, WinderName of About::Mechanism, MechanismName::Winder {
        winding: Winding => needed;
        core_diameter: Length => positive, needed, example("90 mm");
        full_diameter: Length => positive, needed, example("400 mm");
        start_diameter: Length => positive, needed, example("90 mm");
        thickness: Length => positive, needed, example("0.2 mm");
        width: Length => positive, needed, example("600 mm");
        density: MassDensity => positive, needed, example("900 kg/m^3");
        tension: Force => not_negative, needed, example("120 N");
        inertia: MomentOfInertia => not_negative, noted(Assumption::PartsWithoutInertia);
        ..friction: Friction;
        ..losses: Losses;
    }
}

impl Driven for Winder {
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind> {
        let winder = mechanism::Winder {
            winding: self.winding.value()?,
            core_diameter: self.core_diameter.value()?,
            full_diameter: self.full_diameter.value()?,
            start_diameter: self.start_diameter.value()?,
            thickness: self.thickness.value()?,
            width: self.width.value()?,
            density: self.density.value()?,
            tension: self.tension.value()?,
            inertia: self.inertia.or_zero(),
        };
        sound(self, winder.faults(), reader)?;
        Some(MechanismKind::Winder(winder))
    }

    fn inertia(&self) -> Vec<&dyn StatedField> {
        vec![&self.inertia, &self.density]
    }

    fn on_flange(&self) -> Option<OnFlange<'_>> {
        Some(OnFlange::Wheel)
    }
}

//! A web that is wound up or off.

use super::parts::{Friction, Losses};
use super::MechanismName;
use crate::KeyDefault;
use crate::about::About;
use crate::choices::WebWinding;
use crate::section::section;
use quantities::{Force, Length, MassDensity, MomentOfInertia};

section! {
    /// A roll whose diameter changes with every turn.
    Winder, WinderName of About::Mechanism, MechanismName::Winder {
        winding: WebWinding = WebWinding::Up => noted(KeyDefault::WindsUp);
        core_diameter: Length => positive, needed, example("90 mm");
        full_diameter: Length => positive, needed, example("400 mm");
        start_diameter: Length => positive, example("90 mm"), noted(KeyDefault::RollToWind);
        thickness: Length => positive, needed, example("0.2 mm");
        width: Length => positive, needed, example("600 mm");
        density: MassDensity => positive, needed, example("900 kg/m^3");
        tension: Force => not_negative, needed, example("120 N");
        inertia: MomentOfInertia => not_negative, noted(KeyDefault::PartsWithoutInertia);
        ..friction: Friction;
        ..losses: Losses;
    }
}

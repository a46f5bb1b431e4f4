//! Stage between actuator and mechanism.

use crate::KeyDefault;
use crate::about::About;
use crate::choices::StageKind;
use crate::section::section;
use crate::value::Numbers;
use quantities::{Angle, Length, MomentOfInertia, TorsionalStiffness};

/// Largest number of ratios to choose from; the catalogue is judged for each.
const RATIOS_MOST: usize = 16;

section! {
    /// Stage between actuator and mechanism.
    StageSection, StageName of About::Stage {
        kind: StageKind => needed;
        ratio: f64 => within(0.01, 1000.0), example("2.5");
        ratios: Numbers => within(0.01, 1000.0), at_most(RATIOS_MOST);
        efficiency: f64 = 1.0 => within(0.01, 1.0), example("0.95"), noted(KeyDefault::StageNoLosses);
        efficiency_back: f64 = 1.0 => within(0.0, 1.0), example("0.9"), noted(KeyDefault::StageLossesDoNotHelp);
        inertia_driving: MomentOfInertia => not_negative;
        inertia_driven: MomentOfInertia => not_negative, noted(KeyDefault::StageWithoutInertia);
        stiffness: TorsionalStiffness => positive, noted(KeyDefault::StageRigid);
        backlash: Angle => not_negative, example("3 arcmin"), noted(KeyDefault::StageNoBacklash);
        pitch_diameter: Length => positive;
    }
}

impl StageSection {
    /// Returns the ratios to choose from.
    #[must_use]
    pub fn ratios(&self) -> &[f64] {
        self.ratios.get().map_or(&[], |ratios| ratios.0.as_slice())
    }
}

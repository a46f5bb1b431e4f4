//! Stage between actuator and mechanism, and the best of several ratios.

use crate::about::About;
use crate::read::Reader;
use crate::section::{Fields, section};
use crate::stated::StatedField;
use crate::value::{Numbers, choices};
use crate::{Assumption, Fault, Hint};
use mechanism::{Stage, StageKind};
use quantities::{Angle, Length, MomentOfInertia, TorsionalStiffness};

/// Largest number of ratios to choose from; the catalogue is judged for each.
const RATIOS_MOST: usize = 16;

section! {
    /// Stage between actuator and mechanism.
    StageSection, StageName of About::Stage {
        kind: StageKind => needed;
        ratio: f64 => within(0.01, 1000.0), example("2.5");
        ratios: Numbers => within(0.01, 1000.0), at_most(RATIOS_MOST);
        efficiency: f64 = 1.0 => within(0.01, 1.0), example("0.95"), noted(Assumption::StageNoLosses);
        efficiency_back: f64 = 1.0 => within(0.0, 1.0), example("0.9"), noted(Assumption::StageLossesDoNotHelp);
        inertia_driving: MomentOfInertia => not_negative;
        inertia_driven: MomentOfInertia => not_negative, noted(Assumption::StageWithoutInertia);
        stiffness: TorsionalStiffness => positive, noted(Assumption::StageRigid);
        backlash: Angle => not_negative, example("3 arcmin"), noted(Assumption::StageNoBacklash);
        pitch_diameter: Length => positive;
    }
}

choices! {
    StageKind { Belt = "belt", Gear = "gear", Coupling = "coupling" }
}

/// Result of one of several ratios.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioAnswer {
    /// i_s: turns of the actuator's output per turn of the mechanism.
    pub ratio: f64,
    /// The best actuator of the catalogue, if one fits.
    pub answer: Option<String>,
    /// Utilisation of the first candidate with this ratio, fitting or not.
    pub utilisation: f64,
    /// Number of fitting actuators.
    pub fitting: usize,
    /// The project uses this ratio.
    pub chosen: bool,
}

impl StageSection {
    /// Returns the ratios to choose from.
    pub(crate) fn ratios(&self) -> &[f64] {
        self.ratios.get().map_or(&[], |ratios| ratios.0.as_slice())
    }

    pub(crate) fn build(&self, reader: &mut Reader<'_>) -> Option<Stage> {
        let kind = self.kind.value()?;
        if self.ratio.is_written() && self.ratios.is_written() {
            reader.fault(self.ratios.span(), Fault::RatioAndRatios, None);
        }
        if kind == StageKind::Coupling {
            let unit = self.ratio.value() == Some(1.0);
            let ratio: Option<&dyn StatedField> = (!unit).then_some(&self.ratio);
            let others: [&dyn StatedField; 2] = [&self.ratios, &self.pitch_diameter];
            for field in ratio.into_iter().chain(others).filter(|field| field.is_given()) {
                reader.fault(field.span(), Fault::NoRatioInACoupling { key: field.name() }, None);
            }
        } else if !self.ratio.is_written() && !self.ratios.is_written() {
            let fault = Fault::MissingKey { path: self.ratio.path(), list: false };
            let start = self.head().span.start;
            reader.fault(start..start + 1, fault, Some(Hint::Example("ratio = 2.5".to_owned())));
        }
        Some(Stage {
            kind,
            ratio: self.ratio.value().or_else(|| self.ratios().first().copied()).unwrap_or(1.0),
            efficiency_driving: self.efficiency(),
            efficiency_driven: self.efficiency_back(),
            inertia_driving: self.inertia_driving.or_zero(),
            inertia_driven: self.inertia_driven.or_zero(),
            stiffness: self.stiffness.value(),
            backlash: self.backlash.value(),
            pitch_diameter: self.pitch_diameter.value(),
        })
    }

    /// Adds the defaults about the stage that the file leaves open.
    pub(crate) fn assumptions(&self, found: &mut Vec<Assumption>) {
        found.extend(self.efficiency.note().or_else(|| self.efficiency_back.note()));
        found.extend(self.inertia_driven.note().filter(|_| !self.inertia_driving.is_given()));
        found.extend([self.stiffness.note(), self.backlash.note()].into_iter().flatten());
        if self.ratios.is_given() {
            found.push(Assumption::StageRatioChosen);
        }
    }
}

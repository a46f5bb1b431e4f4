//! How the load is geared to the actuator, and the same axis with another gearing.

use crate::mechanism::Driven;
use crate::read::Reader;
use crate::stated::Field;
use crate::{Project, finish, prepare};
use mechanism::{Stage, StageKind};
use quantities::unit::{MILLIMETRE, ONE};
use quantities::{Measure, MomentOfInertia, Unit};

/// A key from which follows how far the load moves with a turn of the actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Gearing {
    /// Its path: `mechanism.screw.lead`, `stage.ratio`.
    pub path: String,
    /// Its value in SI.
    pub si: f64,
    /// The unit in which it is shown.
    pub unit: &'static Unit,
}

impl Project {
    /// The keys that are stated: lead, diameter of a pulley, roller or drum, radius of a crank, ratio of a stage.
    #[must_use]
    pub fn gearings(&self) -> Vec<Gearing> {
        let of = |field: &dyn Field, unit| Some(Gearing { path: field.path(), si: field.si()?, unit });
        let lever = self.root.driven().and_then(Driven::gearing).and_then(|field| of(field, &MILLIMETRE));
        // Of several ratios the best is chosen already.
        let stage = self.root.parts.stage.get().filter(|stage| stage.ratios().is_empty());
        lever.into_iter().chain(stage.and_then(|stage| of(&stage.ratio, &ONE))).collect()
    }

    /// The project with another value of a key, in SI; `None` where it cannot be built.
    #[must_use]
    pub fn with_value(&self, path: &str, si: f64) -> Option<Self> {
        let mut root = self.root.clone();
        root.set(path, si)?;
        let mut reader = Reader::new("");
        let draft = prepare(&root, &mut reader)?;
        (reader.fault_count() == 0).then(|| Self { axis: finish(&root, draft), root, ..self.clone() })
    }

    /// The project with a stage without losses and inertia where it has none; its loads on the flange are not known.
    #[must_use]
    pub fn with_stage(&self, ratio: f64) -> Option<Self> {
        if self.axis.mechanism.stage.is_some() {
            return None;
        }
        let none = MomentOfInertia::from_si(0.0);
        let stage = Stage {
            kind: StageKind::Gear,
            ratio,
            efficiency_driving: 1.0,
            efficiency_driven: 1.0,
            inertia_driving: none,
            inertia_driven: none,
            stiffness: None,
            backlash: None,
            pitch_diameter: None,
        };
        let mut draft = prepare(&self.root, &mut Reader::new(""))?;
        draft.mechanism.stage = Some(stage);
        draft.motion = draft.motion.geared(ratio);
        (draft.bearing.has_loads, draft.bearing.derived) = (false, None);
        Some(Self { axis: finish(&self.root, draft), ..self.clone() })
    }
}

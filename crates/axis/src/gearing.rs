//! Gearing between load and actuator, and the axis with another gearing.

use crate::axis_project::AxisProject;
use crate::draft::{finish, prepare};
use crate::driven::Driven;
use crate::fault::AxisReport;
use crate::mechanism::driven;
use mechanism::{Stage, StageKind};
use project::sections::StatedField;
use quantities::unit::{MILLIMETRE, ONE};
use quantities::{Measure, MomentOfInertia, Unit};

/// A key that decides the travel of the load per turn of the actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Gearing {
    /// Path: `mechanism.screw.lead`, `stage.ratio`.
    pub path: String,
    /// Value in SI.
    pub si: f64,
    /// Unit for display.
    pub unit: &'static Unit,
}

impl AxisProject {
    /// Returns the stated keys: lead, diameter of a pulley, roller or drum, radius of a crank, ratio of a stage.
    #[must_use]
    pub fn gearings(&self) -> Vec<Gearing> {
        let of = |field: &dyn StatedField, unit| Some(Gearing { path: field.path(), si: field.si()?, unit });
        let lever = driven(&self.root.parts).and_then(Driven::gearing).and_then(|field| of(field, &MILLIMETRE));
        // Of several ratios the best has been chosen already.
        let stage = self.root.parts.stage.get().filter(|stage| stage.ratios().is_empty());
        lever.into_iter().chain(stage.and_then(|stage| of(&stage.ratio, &ONE))).collect()
    }

    /// Returns the project with another value of a key, in SI; `None` if it cannot be built.
    #[must_use]
    pub fn with_value(&self, path: &str, si: f64) -> Option<Self> {
        let mut root = self.root.clone();
        root.set(path, si)?;
        let mut report = AxisReport::new("");
        let draft = prepare(&root, &*self.catalogue, &mut report)?;
        (report.fault_count() == 0).then(|| Self { axis: finish(&root, draft), root, ..self.clone() })
    }

    /// Returns the project with an added stage without losses and inertia; its loads on the flange are unknown.
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
        let mut draft = prepare(&self.root, &*self.catalogue, &mut AxisReport::new(""))?;
        draft.mechanism.stage = Some(stage);
        draft.motion = draft.motion.geared(ratio);
        (draft.bearing.has_loads, draft.bearing.derived) = (false, None);
        Some(Self { axis: finish(&self.root, draft), ..self.clone() })
    }
}

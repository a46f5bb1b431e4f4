//! Gearing, counterweight and share of the load of an actuator, and the axis with other values of them.

use crate::axis_project::AxisProject;
use crate::draft::{finish, prepare};
use crate::driven::Driven;
use crate::fault::AxisReport;
use crate::mechanism::driven;
use crate::source::AxisSource;
use mechanism::{Stage, StageKind};
use project::choices::Law;
use project::sections::{Counterweight, Fields, StatedField, group};
use project::{Kind, key_at};
use quantities::unit::{KILOGRAM, MILLIMETRE, ONE};
use quantities::{Measure, MomentOfInertia, Unit};

/// A key that decides the travel of the load per turn of the actuator.
#[derive(Clone, Debug, PartialEq)]
pub struct Gearing {
    /// Path within the axis: `mechanism.screw.lead`, `stage.ratio`.
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
        let of = |field: &dyn StatedField, unit| Some(Gearing { path: self.within(field), si: field.si()?, unit });
        let lever = driven(&self.root.parts).and_then(Driven::gearing).and_then(|field| of(field, &MILLIMETRE));
        // Of several ratios the best has been chosen already.
        let stage = self.root.parts.stage.get().filter(|stage| stage.ratios().is_empty());
        lever.into_iter().chain(stage.and_then(|stage| of(&stage.ratio, &ONE))).collect()
    }

    /// Returns the counterweight of a mechanism that can have one, zero if it is not stated, and the mass that it balances
    /// at most: the moved mass with the largest payload.
    #[must_use]
    pub fn counterweight(&self) -> Option<(Gearing, f64)> {
        let load = driven(&self.root.parts)?;
        let stated = &group::<Counterweight>(load)?.counterweight;
        let payloads = self.root.segments().iter().filter_map(|segment| segment.payload.si());
        let balanced = load.field("mass")?.si()? + payloads.fold(0.0, f64::max);
        Some((Gearing { path: self.within(stated), si: stated.si().unwrap_or(0.0), unit: &KILOGRAM }, balanced))
    }

    /// Returns the stated quantities of the load and of its segments of which each of several equal actuators carries a
    /// share, and the project as one of `count` actuators drives it. `None` for a load with a single drive, with a recorded
    /// torque, or without such quantities.
    #[must_use]
    pub fn shared_by(&self, count: u32) -> Option<(Vec<Gearing>, Self)> {
        let load = driven(&self.root.parts)?;
        let dimensions = load.shared();
        if dimensions.is_empty() || self.recordings.iter().any(|read| read.recording.torque.is_some()) {
            return None;
        }
        let segments = self.root.segments().iter().flat_map(Fields::fields);
        let all = load.fields().into_iter().chain(segments).filter_map(|field| {
            let path = self.within(field);
            let Kind::Quantity(dimension, _) = key_at(&path)?.kind else { return None };
            let unit = dimensions.contains(&dimension).then(|| dimension.units().first()).flatten()?;
            Some(Gearing { si: field.si()? / f64::from(count), path, unit })
        });
        let shares: Vec<Gearing> = all.filter(|share| share.si != 0.0).collect();
        let project = self.with_values(shares.iter().map(|share| (share.path.as_str(), share.si)))?;
        (!shares.is_empty()).then_some((shares, project))
    }

    /// Returns the path of a field within the axis.
    fn within(&self, field: &dyn StatedField) -> String {
        let path = field.path();
        path.strip_prefix(&*self.root.head().path).map_or(&*path, |inside| inside.trim_start_matches('.')).to_owned()
    }

    /// Returns the project with another value of a key, in SI; `None` if it cannot be built.
    #[must_use]
    pub fn with_value(&self, path: &str, si: f64) -> Option<Self> {
        self.with_values([(path, si)])
    }

    fn with_values<'v>(&self, values: impl IntoIterator<Item = (&'v str, f64)>) -> Option<Self> {
        let mut root = self.root.clone();
        for (path, si) in values {
            root.set(path, si)?;
        }
        self.rebuilt(root)
    }

    /// Returns the project with a law in place of every one that is open, and the paths of these keys; `None` without an
    /// open law, or if the moves are not possible with it.
    #[must_use]
    pub fn with_open_laws(&self, law: Law) -> Option<(Self, Vec<String>)> {
        let mut root = self.root.clone();
        let paths = root.decide_laws(law);
        Some((self.rebuilt(root)?, paths)).filter(|(_, paths)| !paths.is_empty())
    }

    fn rebuilt(&self, root: AxisSource) -> Option<Self> {
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

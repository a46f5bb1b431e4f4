//! The root of the project file, and what belongs to one axis.

use crate::about::About;
use crate::curves::CurveSection;
use crate::flange::Bearing;
use crate::mechanism::{DirectLoad, Driven, Mechanisms};
use crate::motion::Segment;
use crate::own::ActuatorSection;
use crate::read::joined;
use crate::requirements::{DriveSection, RequirementsSection};
use crate::section::{Fields, Section, section, set};
use crate::stage::StageSection;
use crate::stated::{SectionHead, StatedField};
use crate::twin::TwinSection;
use crate::value::{OneOrMany, Tables};

/// Format version of the project file.
const FORMAT: i64 = 1;

section! {
    /// A whole project file.
    Root, RootName of About::Root {
        format: u32 => whole(FORMAT, FORMAT), needed;
        axis: OneOrMany<AxisTable, OneOfSeveral>;
        ..parts: Parts;
        curve: Tables<CurveSection>;
    }
}

section! {
    /// Settings of a single axis.
    AxisTable, AxisName of About::Axis {
        name: String;
        single_move: bool;
    }
}

section! {
    /// One of several axes, with the keys that a single one has at the root.
    OneOfSeveral, OneOfSeveralName of About::OneOfSeveral {
        name: String => needed;
        single_move: bool;
        ..parts: Parts;
    }
}

section! {
    /// Load, motion and all other tables of an axis.
    Parts, PartsName of About::Parts {
        load: DirectLoad;
        mechanism: Mechanisms;
        stage: StageSection;
        motion: Tables<Segment>;
        bearing: Bearing;
        requirements: RequirementsSection;
        drive: DriveSection;
        actuator: ActuatorSection;
        twin: TwinSection;
    }
}

/// The keys of the root of the project file.
pub const KEYS: &[crate::Key] = Root::KEYS;

/// One axis, alone or among several.
#[derive(Clone, Debug)]
pub(crate) struct AxisSection {
    pub(crate) name: Option<String>,
    pub(crate) single_move: bool,
    pub(crate) parts: Parts,
}

impl AxisSection {
    /// Creates a single axis.
    pub(crate) fn single(root: Root) -> Self {
        let (name, single_move) = match root.axis.get() {
            Some(OneOrMany::One(axis)) => (axis.name.get().cloned(), axis.single_move.value()),
            Some(OneOrMany::Many(_)) | None => (None, None),
        };
        Self { name, single_move: single_move.unwrap_or(false), parts: root.parts }
    }

    /// Creates one of several axes.
    pub(crate) fn of_several(axis: OneOfSeveral) -> Self {
        let single_move = axis.single_move.value().unwrap_or(false);
        Self { name: axis.name.get().cloned(), single_move, parts: axis.parts }
    }

    pub(crate) fn head(&self) -> &SectionHead {
        self.parts.head()
    }

    /// Returns a path within the axis as it is in the file.
    pub(crate) fn path(&self, path: &str) -> String {
        joined(&self.head().path, path)
    }

    pub(crate) fn segments(&self) -> &[Segment] {
        self.parts.motion.get().map_or(&[], |all| all.0.as_slice())
    }

    /// Returns `true` if a segment has its own loads on the flange.
    pub(crate) fn has_loads_of_segments(&self) -> bool {
        self.segments().iter().any(|segment| segment.bearing.is_given())
    }

    pub(crate) fn driven(&self) -> Option<&dyn Driven> {
        self.parts.driven()
    }

    /// Replaces the value of a quantity, in SI; its path is the one within the axis.
    pub(crate) fn set(&mut self, path: &str, si: f64) -> Option<()> {
        set(&mut self.parts, path, si)
    }

    /// Replaces several ratios by one.
    pub(crate) fn set_ratio(&mut self, ratio: f64) {
        if let Some(stage) = self.parts.stage.get_mut() {
            let span = stage.ratios.span();
            stage.ratios.clear();
            stage.ratio.give(ratio, span);
        }
    }
}

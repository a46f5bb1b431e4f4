//! The root of the project file, and what belongs to one axis.

use crate::about::About;
use crate::axis_names::named_apart;
use crate::choices::Law;
use crate::curves::CurveSection;
use crate::flange::Bearing;
use crate::mechanism::{DirectLoad, Mechanisms};
use crate::motion::{Segment, SegmentLaw};
use crate::own::{ActuatorSection, CatalogueSection};
use crate::read::{Reader, joined};
use crate::report::FaultReport;
use crate::requirements::{DriveSection, RequirementsSection};
use crate::section::{Fields, Section, section, set, states};
use crate::stage::StageSection;
use crate::stated::{SectionHead, Stated, StatedField};
use crate::tolerance::{self, Tolerance};
use crate::twin::TwinSection;
use crate::value::{OneOrMany, Tables};
use crate::{Diagnostic, Fault};
use quantities::Time;

/// Format version of the project file.
const FORMAT: i64 = 1;

section! {
    /// A whole project file.
    Root, RootName of About::Root {
        format: u32 => whole(FORMAT, FORMAT), needed;
        axis: OneOrMany<AxisTable, OneOfSeveral>;
        ..parts: Parts;
        curve: Tables<CurveSection>;
        catalogue: CatalogueSection;
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

/// A project file: its axes, and what they share.
#[derive(Clone, Debug)]
pub struct Project {
    /// Axes in the order of the file; a file without `[[axis]]` is one axis.
    pub axes: Vec<AxisSection>,
    /// Values that belong to no axis alone.
    pub shared: Shared,
}

/// Values that the axes of a file share.
#[derive(Clone, Debug)]
pub struct Shared {
    /// Curves of the user for actuators of the catalogue.
    pub curves: Vec<CurveSection>,
    /// Catalogue files, and whether the series in the program is offered.
    pub catalogue: Option<CatalogueSection>,
}

/// One axis, alone or among several.
#[derive(Clone, Debug)]
pub struct AxisSection {
    /// Name, if one is stated.
    pub name: Option<String>,
    /// The motion is a single move.
    pub single_move: bool,
    /// Tables of the axis.
    pub parts: Parts,
    /// Quantities with a tolerance in the order of the reader, under their keys within the axis.
    pub tolerances: Vec<Tolerance>,
}

/// A project file as read, with its faults so far; an axis that is built from it adds its own.
#[derive(Debug)]
pub struct ReadProject<'t> {
    /// Values of the file; refused ones are marked.
    pub project: Project,
    /// Faults of keys, units and values.
    pub report: FaultReport<'t>,
}

/// Reads a project file with one axis or several.
///
/// # Errors
/// If the file is too large. Faults of its text are in the report.
pub fn read(text: &str) -> Result<ReadProject<'_>, Vec<Diagnostic>> {
    let mut reader = Reader::of_file(text)?;
    let mut root: Root = reader.read();
    let curves = root.curve.get_mut().map(|all| std::mem::take(&mut all.0)).unwrap_or_default();
    let catalogue = root.catalogue.get().cloned();
    let several = match root.axis.get_mut() {
        Some(OneOrMany::Many(several)) => std::mem::take(several),
        Some(OneOrMany::One(_)) | None => Vec::new(),
    };
    let axes = if several.is_empty() {
        vec![AxisSection::single(root, &reader.tolerances)]
    } else {
        for field in root.parts.fields().into_iter().filter(|field| field.is_written()) {
            reader.fault(field.span(), Fault::OutsideTheAxes { key: field.name() }, None);
        }
        named_apart(several.iter().map(|axis| &axis.name), &mut reader.report);
        let of_several = |(index, axis)| AxisSection::of_several(axis, tolerance::of_axis(&reader.tolerances, index));
        several.into_iter().enumerate().map(of_several).collect()
    };
    Ok(ReadProject { project: Project { axes, shared: Shared { curves, catalogue } }, report: reader.report })
}

/// Returns `true` for a single move; a faulty statement counts as one, so that no cycle needs to close.
fn is_single(stated: &Stated<bool>) -> bool {
    stated.value().unwrap_or(stated.is_written())
}

impl AxisSection {
    /// Creates a single axis.
    fn single(root: Root, tolerances: &[Tolerance]) -> Self {
        let (name, single_move) = match root.axis.get() {
            Some(OneOrMany::One(axis)) => (axis.name.get().cloned(), is_single(&axis.single_move)),
            Some(OneOrMany::Many(_)) | None => (None, false),
        };
        Self { name, single_move, parts: root.parts, tolerances: tolerances.to_vec() }
    }

    /// Creates one of several axes.
    fn of_several(axis: OneOfSeveral, tolerances: Vec<Tolerance>) -> Self {
        let single_move = is_single(&axis.single_move);
        Self { name: axis.name.get().cloned(), single_move, parts: axis.parts, tolerances }
    }

    /// Returns its place in the file; the path of a single axis is empty.
    #[must_use]
    pub fn head(&self) -> &SectionHead {
        self.parts.head()
    }

    /// Returns a path within the axis as it is in the file.
    #[must_use]
    pub fn path(&self, path: &str) -> String {
        joined(&self.head().path, path)
    }

    /// Returns the segments of its motion.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        self.parts.motion.get().map_or(&[], |all| all.0.as_slice())
    }

    /// Returns `true` if a segment has its own loads on the flange.
    #[must_use]
    pub fn has_loads_of_segments(&self) -> bool {
        self.segments().iter().any(|segment| segment.bearing.is_given())
    }

    /// Replaces the value of a quantity, in SI; its path is the one within the axis.
    pub fn set(&mut self, path: &str, si: f64) -> Option<()> {
        set(&mut self.parts, path, si)
    }

    /// Returns `true` if one of several keys, separated by commas, is stated. Names that are no keys count as stated.
    #[must_use]
    pub fn states(&self, keys: &str) -> bool {
        let own = &self.head().path;
        keys.split(", ").any(|key| {
            let within = key.strip_prefix(&**own).map_or(key, |rest| rest.trim_start_matches('.'));
            states(&self.parts, within)
        })
    }

    /// Replaces the smoothing of a recorded segment, counted from zero; without a window the segment is not smoothed.
    pub fn set_smoothing(&mut self, segment: usize, window: Option<Time>) {
        let segments = self.parts.motion.get_mut();
        if let Some(segment) = segments.and_then(|segments| segments.0.get_mut(segment)) {
            let span = segment.smoothing.span();
            segment.smoothing.clear();
            if let Some(window) = window {
                segment.smoothing.give(window, span);
            }
        }
    }

    /// Decides every law that is open, and returns the paths of their keys.
    pub fn decide_laws(&mut self, law: Law) -> Vec<String> {
        let segments = self.parts.motion.get_mut().into_iter().flat_map(|segments| &mut segments.0);
        let open = segments.filter(|segment| segment.law.value() == Some(SegmentLaw::Open));
        open.map(|segment| {
            let span = segment.law.span();
            segment.law.give(SegmentLaw::Law(law), span);
            segment.law.path()
        })
        .collect()
    }

    /// Replaces several ratios by one.
    pub fn set_ratio(&mut self, ratio: f64) {
        if let Some(stage) = self.parts.stage.get_mut() {
            let span = stage.ratios.span();
            stage.ratios.clear();
            stage.ratio.give(ratio, span);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CURVE: &str = "[[curve]]\nkind = \"continuous\"\ncode = \"CHA-25A-*\"\nsource = \"measured\"\n\
        points = [[\"0 1/min\", \"32 N m\"], [\"40 1/min\", \"25 N m\"]]\n";

    /// A file is its axes in their order, each with the tolerances under its own keys, and what they share.
    #[test]
    fn a_file_is_its_axes_and_what_they_share() {
        for count in 0..5_usize {
            for curves in 0..3_usize {
                let load =
                    |head: &str, index: usize| format!("[{head}load]\ninertia = \"{} kg m^2 ± 1 %\"\n", index + 1);
                let several =
                    (0..count).map(|index| format!("[[axis]]\nname = \"a{index}\"\n{}", load("axis.", index)));
                let axes = if count == 0 { load("", 0) } else { several.collect() };
                let text = format!("format = 1\n{axes}{}", CURVE.repeat(curves));
                let ReadProject { project, report } = read(&text).unwrap();
                assert_eq!((project.axes.len(), project.shared.curves.len()), (count.max(1), curves), "{text}");
                assert!(report.into_faults().is_empty(), "{text}");
                for (index, axis) in project.axes.iter().enumerate() {
                    assert_eq!(axis.name.clone(), (count > 0).then(|| format!("a{index}")), "{text}");
                    let [tolerance] = axis.tolerances.as_slice() else { panic!("{text}") };
                    #[allow(clippy::cast_precision_loss, reason = "a small number")]
                    let nominal = (index + 1) as f64;
                    assert_eq!((tolerance.path.as_str(), tolerance.nominal), ("load.inertia", nominal), "{text}");
                    let head = if count == 0 { String::new() } else { format!("axis[{}]", index + 1) };
                    assert_eq!(&*axis.head().path, head, "{text}");
                }
            }
        }
    }
}

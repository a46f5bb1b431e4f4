//! One axis of a project, built from its section.

use crate::assumption::Assumption;
use crate::bodies::{InertiaAnswer, summed};
use crate::catalogue::Catalogue;
use crate::catalogue_files;
use crate::curves;
use crate::draft::{assumptions, build_actuator, finish, prepare, requirements};
use crate::fault::{AxisDiagnostic, AxisReport};
use crate::files::{Files, NoFiles};
use crate::mechanism::driven;
use crate::recordings::{RecordingRead, Recordings};
use crate::source::AxisSource;
use crate::stage::RatioAnswer;
use crate::tolerance;
use crate::twin::{self, TwinInput};
use configurator::{Product, Requirements};
use order_code::{Option1, Option2};
use project::sections::{AxisSection, Fields as _, StageSection, StatedField};
use project::{Diagnostic, Fault, ReadProject, SegmentLaw, Tolerance};
use quantities::Time;
use sizing::Axis;
use std::ops::Range as Span;
use std::sync::Arc;

/// One axis of a project, complete: load and motion, requirements, and the defaults that were used.
#[derive(Clone, Debug)]
pub struct AxisProject {
    /// Name of the axis; empty if none is given.
    pub name: String,
    /// Load and motion.
    pub axis: Axis,
    /// Requirements on the actuator.
    pub requirements: Requirements,
    /// Required sensor option.
    pub option_1: Option<Option1>,
    /// Required cable and connector option.
    pub option_2: Option<Option2>,
    /// The user's own actuator, if there is one.
    pub actuator: Option<Product>,
    /// Result of each of several ratios of the stage; empty for one ratio or no stage.
    pub ratios: Vec<RatioAnswer>,
    /// Settings of the simulation.
    pub twin: TwinInput,
    /// Recordings that the motion consists of.
    pub recordings: Vec<RecordingRead>,
    /// Defaults that were used.
    pub assumptions: Vec<Assumption>,
    /// Quantities with a tolerance, in the order of the reader.
    pub tolerances: Vec<Tolerance>,
    pub(crate) catalogue: Arc<dyn Catalogue>,
    /// The axis as read: it contains the places of the values, and with tolerances it is built again with other values.
    pub(crate) root: AxisSource,
}

/// Chooses among the possible ratios of a stage, in the order of the file; returns the project with the chosen one. The
/// second argument builds the project with a ratio.
pub type Choose<'c> = &'c dyn Fn(&[f64], &dyn Fn(f64) -> Option<AxisProject>) -> Option<AxisProject>;

impl AxisProject {
    /// Returns `true` if it is one of several axes of its file.
    #[must_use]
    pub fn is_of_several(&self) -> bool {
        !self.root.head().path.is_empty()
    }

    /// Returns the place in the file of a stated value of the simulation or of its measured values, by its key.
    #[must_use]
    pub fn place_in_twin(&self, key: &str) -> Option<Span<usize>> {
        let twin = self.root.parts.twin.get()?;
        let measured = twin.measured.get().and_then(|measured| measured.field(key));
        twin.field(key).or(measured).filter(|field| field.is_given()).map(StatedField::span)
    }

    /// Returns the catalogue with which the axis was read, with the user's curves.
    #[must_use]
    pub fn catalogue(&self) -> &Arc<dyn Catalogue> {
        &self.catalogue
    }

    /// Returns the solid bodies that the axis turns, with their inertia; `None` for other loads.
    #[must_use]
    pub fn bodies(&self) -> Option<InertiaAnswer> {
        summed(driven(&self.root.parts)?.bodies()?)
    }

    /// Reads a project file with one axis that refers to no other file.
    ///
    /// # Errors
    /// Every fault of the file, each with its place, in the order of the file.
    pub fn read(text: &str, catalogue: &Arc<dyn Catalogue>, choose: Choose<'_>) -> Result<Self, Vec<AxisDiagnostic>> {
        let mut axes = Self::read_all(text, &NoFiles, catalogue, choose)?;
        match (axes.pop(), axes.is_empty()) {
            (Some(only), true) => Ok(only),
            _ => Err(vec![Diagnostic::at(text, 0..0, Fault::OneAxisOnly.into(), None)]),
        }
    }

    /// Reads a project file with one axis or several, in their order, and the files that it refers to.
    ///
    /// # Errors
    /// Every fault of the file, each with its place, in the order of the file.
    pub fn read_all(
        text: &str,
        files: &dyn Files,
        catalogue: &Arc<dyn Catalogue>,
        choose: Choose<'_>,
    ) -> Result<Vec<Self>, Vec<AxisDiagnostic>> {
        let read =
            project::read(text).map_err(|faults| faults.into_iter().map(Diagnostic::into_other).collect::<Vec<_>>())?;
        Self::build_all(read, files, catalogue, choose)
    }

    /// Builds the axes of a project, in their order, with the files that it refers to.
    ///
    /// # Errors
    /// Every fault of the file, those of its text included, each with its place, in the order of the file.
    pub fn build_all(
        read: ReadProject<'_>,
        files: &dyn Files,
        catalogue: &Arc<dyn Catalogue>,
        choose: Choose<'_>,
    ) -> Result<Vec<Self>, Vec<AxisDiagnostic>> {
        let ReadProject { project, report } = read;
        let mut report: AxisReport<'_> = report.into_other();
        let with_files = catalogue_files::read(project.shared.catalogue.as_ref(), files, catalogue, &mut report);
        let catalogue = with_files.as_ref().unwrap_or(catalogue);
        let with_curves = curves::read(&project.shared.curves, catalogue, &mut report);
        let catalogue = with_curves.as_ref().unwrap_or(catalogue);
        let mut recordings = Recordings::new(files);
        let mut build = |section: AxisSection| {
            let source = AxisSource::read(section, &mut recordings, &mut report);
            Self::build(source, (catalogue, choose), &mut report)
        };
        let axes: Vec<Option<Self>> = project.axes.into_iter().map(&mut build).collect();
        let faults = report.into_faults();
        match axes.into_iter().collect::<Option<Vec<Self>>>() {
            Some(axes) if faults.is_empty() => Ok(axes),
            _ => Err(faults),
        }
    }

    /// Returns the law of a segment, counted from zero.
    #[must_use]
    pub fn law(&self, segment: usize) -> Option<SegmentLaw> {
        self.root.segments().get(segment)?.law.value()
    }

    /// Returns the project with another smoothing of a recorded segment, counted from zero, as a cycle or as a single move;
    /// `None` if that axis is impossible.
    #[must_use]
    pub fn smoothed(&self, segment: usize, window: Option<Time>, is_single: bool) -> Option<Self> {
        let mut root = self.root.clone();
        root.set_smoothing(segment, window);
        root.single_move = is_single;
        let mut report = AxisReport::new("");
        let draft = prepare(&root, &*self.catalogue, &mut report).filter(|_| report.fault_count() == 0)?;
        let axis = finish(&root, draft);
        let assumptions = self.assumptions_of(&root, &axis);
        Some(Self { axis, root, assumptions, ..self.clone() })
    }

    /// Builds one axis; `None` after a fault.
    fn build(
        root: AxisSource,
        (catalogue, choose): (&Arc<dyn Catalogue>, Choose<'_>),
        report: &mut AxisReport<'_>,
    ) -> Option<Self> {
        let root = &root;
        let axis = prepare(root, &**catalogue, report).map(|draft| finish(root, draft));
        let actuator = build_actuator(root, &**catalogue, report);
        let tolerances = root.tolerances.clone();
        for window in tolerances.iter().filter(|each| each.path.ends_with("].from") || each.path.ends_with("].to")) {
            report.fault(window.span.clone(), Fault::NoTolerance, None);
        }
        if report.fault_count() == 0 && axis.is_some() {
            tolerance::hold(root, &**catalogue, &tolerances, report);
        }
        let required = root.parts.requirements.get();
        let axis = axis?;
        let project = Self {
            ratios: Vec::new(),
            name: root.name.clone().unwrap_or_default(),
            catalogue: Arc::clone(catalogue),
            twin: root.parts.twin.get().map(twin::input).unwrap_or_default(),
            recordings: root.recordings().cloned().collect(),
            assumptions: assumptions(root, &axis, catalogue.offers_series(), !tolerances.is_empty()),
            requirements: requirements(root),
            option_1: required.and_then(|required| required.option_1.value()),
            option_2: required.and_then(|required| required.option_2.value()),
            axis,
            actuator,
            root: root.clone(),
            tolerances,
        };
        let ratios = root.parts.stage.get().map_or(&[][..], StageSection::ratios);
        if ratios.is_empty() || report.fault_count() > 0 {
            return Some(project);
        }
        let with_ratio = |ratio: f64| project.with_ratio(root, ratio);
        Some(choose(ratios, &with_ratio).unwrap_or_else(|| project.clone()))
    }

    /// Returns the defaults used by a variant of the project. Its root has the chosen ratio in place of the stated ones, whose
    /// choice is said all the same.
    fn assumptions_of(&self, root: &AxisSource, axis: &Axis) -> Vec<Assumption> {
        let mut found = assumptions(root, axis, self.catalogue.offers_series(), !self.tolerances.is_empty());
        let is_choice = |each: &Assumption| matches!(each, Assumption::StageRatioChosen(_));
        if let Some(place) = self.assumptions.iter().position(is_choice).filter(|_| !found.iter().any(is_choice)) {
            let chosen = Assumption::StageRatioChosen(axis.mechanism.stage_ratio());
            found.insert(place.min(found.len()), chosen);
        }
        found
    }

    /// Returns the project with one ratio instead of several; `None` if that axis is impossible.
    fn with_ratio(&self, root: &AxisSource, ratio: f64) -> Option<Self> {
        let mut root = root.clone();
        root.set_ratio(ratio);
        let draft = prepare(&root, &*self.catalogue, &mut AxisReport::new(""))?;
        let axis = finish(&root, draft);
        let assumptions = self.assumptions_of(&root, &axis);
        Some(Self { axis, root, assumptions, ..self.clone() })
    }
}

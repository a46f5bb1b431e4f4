//! Quantities with a tolerance: their paths, and the project with other values of them.

use crate::read::Reader;
use crate::recorded;
use crate::root::AxisSection;
use crate::{Catalogue, Diagnostic, Fault, Hint};
use crate::{Project, build_actuator, finish, prepare, requirements};
use configurator::{Product, Requirements};
use quantities::Unit;
use sizing::Axis;
use std::ops::Range as Span;

/// Largest number of quantities of a file with a tolerance.
pub(crate) const TOLERANCES_MOST: usize = 64;

/// Largest number of toleranced quantities for which every corner of their bands is checked: 2¹⁰ of them.
pub const ALL_CORNERS_MOST: usize = 10;

/// A quantity of a project with values in nominal ± half-width.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Key: `load.inertia`, `motion[2].speed`, `mechanism.table.points[1][3]`, `mechanism.turntable.bodies[1].mass`.
    pub path: String,
    /// Nominal value in SI.
    pub nominal: f64,
    /// Half-width of the band, in SI, greater than zero.
    pub half_width: f64,
    /// Unit in which the value is written.
    pub unit: &'static Unit,
    /// Place of the half-width in the file, in bytes.
    pub span: Span<usize>,
}

impl Tolerance {
    /// Returns the value at a share of the half-width from nominal, −1 to 1; in SI.
    #[must_use]
    pub fn at(&self, share: f64) -> f64 {
        self.nominal + share * self.half_width
    }
}

/// Returns the tolerances of one axis of a file, under their keys within the axis.
pub(crate) fn of_axis(all: &[Tolerance], index: Option<usize>) -> Vec<Tolerance> {
    let Some(index) = index else { return all.to_vec() };
    let prefix = format!("axis[{}].", index + 1);
    let inside = |each: &Tolerance| {
        let path = each.path.strip_prefix(&prefix)?.to_owned();
        Some(Tolerance { path, ..each.clone() })
    };
    all.iter().filter_map(inside).collect()
}

/// Returns the sign of a quantity at a corner: bit k of the corner is set if quantity k is at its upper end.
#[must_use]
pub const fn sign(corner: usize, quantity: usize) -> f64 {
    if corner >> quantity & 1 == 1 { 1.0 } else { -1.0 }
}

/// Reports the first tolerance within which the project cannot be built: each quantity at its ends with the others
/// nominal, and then, where these are possible, the corners.
pub(crate) fn hold(root: &AxisSection, catalogue: &dyn Catalogue, tolerances: &[Tolerance], reader: &mut Reader<'_>) {
    let recorded: usize = root.segments().iter().map(recorded::samples).sum();
    let mut root = root.clone();
    let mut fails = |values: &[(&Tolerance, f64)], reader: &Reader<'_>| {
        for (tolerance, share) in values {
            let _ = root.set(&tolerance.path, tolerance.at(*share));
        }
        let mut trial = Reader::new(reader.text);
        let own = values.iter().any(|(tolerance, _)| tolerance.path.starts_with("actuator."));
        let built = prepare(&root, catalogue, &mut trial).is_some();
        if own {
            build_actuator(&root, catalogue, &mut trial);
        }
        for (tolerance, _) in values {
            let _ = root.set(&tolerance.path, tolerance.nominal);
        }
        let fault = trial.into_faults().into_iter().next();
        if built && fault.is_none() { None } else { Some(fault) }
    };
    let mut sound = true;
    for tolerance in tolerances {
        let found = [-1.0, 1.0].iter().find_map(|end| Some((*end, fails(&[(tolerance, *end)], reader)?)));
        if let Some((end, fault)) = found {
            sound = false;
            let (fault, hint) = impossible(&[(tolerance, end)], fault);
            reader.fault(tolerance.span.clone(), fault, hint);
        }
    }
    if !sound || tolerances.len() < 2 {
        return;
    }
    let all = tolerances.len() <= ALL_CORNERS_MOST && recorded << tolerances.len() <= SAMPLES_BUILT_MOST;
    // Of very many corners only the two with all quantities low or high.
    let corners = if all { 0..1 << tolerances.len() } else { 0..2 };
    for corner in corners {
        let end = |index: usize| if all { sign(corner, index) } else { sign(corner, 0) };
        let values: Vec<(&Tolerance, f64)> =
            tolerances.iter().enumerate().map(|(index, each)| (each, end(index))).collect();
        if let Some(fault) = fails(&values, reader) {
            let (fault, hint) = impossible(&values, fault);
            let place = tolerances.first().map(|first| first.span.clone()).unwrap_or_default();
            reader.fault(place, fault, hint);
            return;
        }
    }
}

/// Largest number of samples of recordings for the motions of the corners: about a third of a second.
const SAMPLES_BUILT_MOST: usize = 1 << 26;

/// Returns the fault of values within the tolerances for which the axis is impossible.
fn impossible(values: &[(&Tolerance, f64)], found: Option<Diagnostic>) -> (Fault, Option<Hint>) {
    let (why, hint) = found.map_or((None, None), |found| (Some(Box::new(found.fault)), found.hint));
    let named = |(tolerance, end): &(&Tolerance, f64)| (tolerance.path.clone(), tolerance.at(*end), tolerance.unit);
    (Fault::ImpossibleWithin { values: values.iter().map(named).collect(), why }, hint)
}

/// A project whose quantities can be varied repeatedly without reading the file again.
#[derive(Clone, Debug)]
pub struct Varied<'p> {
    project: &'p Project,
    root: AxisSection,
    paths: Vec<&'p str>,
    of_requirements: bool,
    of_actuator: bool,
}

/// Parts of a project with other values; `None` for the unaffected ones.
#[derive(Debug)]
pub struct Variant {
    /// Load and motion.
    pub axis: Axis,
    /// Requirements on the actuator.
    pub requirements: Option<Requirements>,
    /// The user's own actuator.
    pub actuator: Option<Product>,
}

impl<'p> Varied<'p> {
    /// Creates the variation of its toleranced quantities; `None` for a project without tolerances.
    #[must_use]
    pub fn new(project: &'p Project) -> Option<Self> {
        let paths = project.tolerances.iter().map(|tolerance| tolerance.path.as_str()).collect();
        (!project.tolerances.is_empty()).then(|| Self::over(project, paths))
    }

    /// Creates the variation of the quantities and plain numbers at some paths within the axis, all of which the
    /// project states.
    #[must_use]
    pub fn over(project: &'p Project, paths: Vec<&'p str>) -> Self {
        let touches = |table: &str| paths.iter().any(|path| path.starts_with(table));
        Self {
            of_requirements: touches("requirements."),
            of_actuator: touches("actuator."),
            root: project.root.clone(),
            project,
            paths,
        }
    }

    /// Returns the project as stated.
    #[must_use]
    pub const fn project(&self) -> &'p Project {
        self.project
    }

    /// Builds the project with one value, in SI, for each path in their order.
    ///
    /// # Errors
    /// The reason why it cannot be built: faults without a place in a file.
    pub fn at(&mut self, values: &[f64]) -> Result<Variant, Vec<Diagnostic>> {
        for (path, value) in self.paths.iter().zip(values) {
            self.root.set(path, *value).ok_or_else(Vec::new)?;
        }
        let mut reader = Reader::new("");
        let draft = prepare(&self.root, &*self.project.catalogue, &mut reader);
        let actuator = self.of_actuator.then(|| build_actuator(&self.root, &*self.project.catalogue, &mut reader));
        let Some(draft) = draft.filter(|_| reader.fault_count() == 0) else { return Err(reader.into_faults()) };
        Ok(Variant {
            axis: finish(&self.root, draft),
            requirements: self.of_requirements.then(|| requirements(&self.root)),
            actuator: actuator.flatten(),
        })
    }
}

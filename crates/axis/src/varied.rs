//! An axis with other values of its quantities.

use crate::axis_project::AxisProject;
use crate::draft::{build_actuator, finish, prepare, requirements};
use crate::fault::{AxisDiagnostic, AxisReport};
use crate::source::AxisSource;
use configurator::{Product, Requirements};
use sizing::Axis;

/// A project whose quantities can be varied repeatedly without reading the file again.
#[derive(Clone, Debug)]
pub struct Varied<'p> {
    project: &'p AxisProject,
    root: AxisSource,
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
    pub fn new(project: &'p AxisProject) -> Option<Self> {
        let paths = project.tolerances.iter().map(|tolerance| tolerance.path.as_str()).collect();
        (!project.tolerances.is_empty()).then(|| Self::over(project, paths))
    }

    /// Creates the variation of the quantities and plain numbers at some paths within the axis, all of which the
    /// project states.
    #[must_use]
    pub fn over(project: &'p AxisProject, paths: Vec<&'p str>) -> Self {
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
    pub const fn project(&self) -> &'p AxisProject {
        self.project
    }

    /// Builds the project with one value, in SI, for each path in their order.
    ///
    /// # Errors
    /// The reason why it cannot be built: faults without a place in a file.
    pub fn at(&mut self, values: &[f64]) -> Result<Variant, Vec<AxisDiagnostic>> {
        for (path, value) in self.paths.iter().zip(values) {
            self.root.set(path, *value).ok_or_else(Vec::new)?;
        }
        let mut report = AxisReport::new("");
        let draft = prepare(&self.root, &*self.project.catalogue, &mut report);
        let actuator = self.of_actuator.then(|| build_actuator(&self.root, &*self.project.catalogue, &mut report));
        let Some(draft) = draft.filter(|_| report.fault_count() == 0) else { return Err(report.into_faults()) };
        Ok(Variant {
            axis: finish(&self.root, draft),
            requirements: self.of_requirements.then(|| requirements(&self.root)),
            actuator: actuator.flatten(),
        })
    }
}

//! Common part of rows: the project with their words, and the actuators to judge.

use super::judged::{Entrant, Judged, RowAxis};
use super::{Answer, Holds, Sweep, Value, Wanted};
use crate::reading::read_all_with;
use axis::{AxisProject, Varied};
use configurator::ProductId;
use project::Heading;
use sizing::{Screen, Screening};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The project file with some words inserted, read with the numbers of one row.
pub(super) struct Template {
    project: AxisProject,
    /// Screen of the project's own catalogue, if its curves take the place of others.
    own_screen: OnceLock<Screen>,
}

/// Products of the catalogue ranked for many axes: without options, and with the encoder at the output.
pub(super) type Screens = [OnceLock<Screen>; 2];

impl Template {
    const fn of(project: AxisProject) -> Self {
        Self { project, own_screen: OnceLock::new() }
    }

    fn screen<'s>(&'s self, sweep: &'s Sweep, entrants: &[Entrant<'_>]) -> &'s Screen {
        let [bare, with_encoder] = &sweep.screens;
        let is_shared = Arc::ptr_eq(self.project.catalogue(), &sweep.options.catalogue);
        let known = match (is_shared, self.project.option_1) {
            (false, _) => &self.own_screen,
            (true, Some(_)) => with_encoder,
            (true, None) => bare,
        };
        known.get_or_init(|| Entrant::screen(entrants))
    }
}

/// Templates by their words.
#[derive(Default)]
pub(super) struct Templates(Mutex<BTreeMap<Vec<String>, Arc<Template>>>);

/// Largest number of templates kept; beyond it all are read anew.
const KEPT_MOST: usize = 4096;

impl Sweep {
    /// Returns the template for some words, created with the numbers of a row if it does not exist.
    ///
    /// # Errors
    /// The reason why the project of that row cannot be read.
    pub(super) fn template(&self, words: &[String], values: &[Value<'_>]) -> Result<Arc<Template>, String> {
        let lock = || self.templates.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().get(words) {
            return Ok(Arc::clone(known));
        }
        let made = Arc::new(Template::of(self.project_with(values)?));
        let mut kept = lock();
        if kept.len() >= KEPT_MOST {
            kept.clear();
        }
        // Another thread may have been faster: either template serves.
        Ok(Arc::clone(kept.entry(words.to_vec()).or_insert(made)))
    }

    /// Reads the project with the values of a row from its text.
    ///
    /// # Errors
    /// The reason why it cannot be read.
    fn project_with(&self, values: &[Value<'_>]) -> Result<AxisProject, String> {
        let text = self.text_with(values);
        let mut projects =
            read_all_with(&text, &*self.files, &self.options.catalogue).map_err(|faults| self.reasons(&faults))?;
        let (place, _) = self.axis;
        if place < projects.len() { Ok(projects.swap_remove(place)) } else { Err(String::new()) }
    }

    fn reasons(&self, faults: &[axis::AxisDiagnostic]) -> String {
        let each = words::worded(faults, self.options.language).into_iter().map(|fault| fault.message);
        each.collect::<Vec<_>>().join("; ")
    }

    fn numbers(&self) -> impl Iterator<Item = &Heading> {
        self.columns.iter().filter_map(|column| match &column.holds {
            Holds::Key(heading) if heading.is_number() => Some(heading),
            Holds::Key(_) | Holds::Code(_) => None,
        })
    }
}

/// Judges the rows of one template, one after the other.
pub(super) struct Judge<'s> {
    sweep: &'s Sweep,
    project: &'s AxisProject,
    varied: Varied<'s>,
    entrants: Vec<Entrant<'s>>,
    screening: Screening<'s>,
    /// `true` for each actuator that meets the requirements of the project besides the checks.
    meets: Vec<bool>,
    numbers: Vec<f64>,
}

impl<'s> Judge<'s> {
    pub(super) fn of(template: &'s Template, sweep: &'s Sweep) -> Self {
        let project = &template.project;
        let paths = sweep.numbers().map(|heading| heading.path.as_str()).collect();
        let entrants = Entrant::all(project);
        Self {
            sweep,
            project,
            varied: Varied::over(project, paths),
            screening: Screening::of(template.screen(sweep, &entrants)),
            meets: entrants.iter().map(|entrant| entrant.meets(&project.requirements)).collect(),
            entrants,
            numbers: Vec::new(),
        }
    }

    /// Returns the answer for a row.
    pub(super) fn row(&mut self, values: &[Value<'_>]) -> Answer {
        let product = self.sweep.product(values);
        // Selecting among several ratios requires a judgement of the catalogue for each: the row is read separately.
        if !self.project.ratios.is_empty() {
            let project = self.sweep.project_with(values)?;
            return self.judged(&RowAxis::of(&project), product.as_ref(), true);
        }
        self.numbers.clear();
        self.numbers.extend(self.sweep.columns.iter().zip(values).filter_map(|(column, value)| {
            match (&column.holds, value) {
                (Holds::Key(heading), Value::Number(number)) => heading.si(*number),
                _ => None,
            }
        }));
        let variant = self.varied.at(&self.numbers).map_err(|faults| self.sweep.reasons(&faults))?;
        let requirements = variant.requirements.as_ref().unwrap_or(&self.project.requirements);
        let row = RowAxis { axis: &variant.axis, requirements, project: self.project };
        self.judged(&row, product.as_ref(), variant.requirements.is_some())
    }

    fn judged(&mut self, row: &RowAxis<'_>, product: Option<&ProductId>, meets_anew: bool) -> Answer {
        let options = &self.sweep.options;
        if let Some(id) = product {
            return row.of_product(id, &options.wanted, options.language);
        }
        Ok(match &options.wanted {
            Wanted::Best => {
                if meets_anew {
                    self.meets.clear();
                    self.meets.extend(self.entrants.iter().map(|entrant| entrant.meets(row.requirements)));
                }
                Judged::Best(row.best(&self.entrants, &mut self.screening, &self.meets))
            }
            Wanted::Every(checks) => Judged::Every(row.every(&self.entrants, checks)),
            Wanted::Front => Judged::Front(row.front(&self.entrants)),
        })
    }
}

//! Reading of a project file, with the best of several ratios.

#[cfg(test)]
mod bodies_tests;
#[cfg(test)]
mod flange_tests;
#[cfg(test)]
mod lift_tests;
#[cfg(test)]
mod project_tests;
#[cfg(test)]
mod stage_tests;

use crate::list::{Cost, Unanswered};
use crate::progress::{Progress, Stopped};
use crate::sizing_use::{Refusal, Rejected, size_watched};
use crate::templates::unstated_figures;
use crate::tolerance::Draw;
use axis::{
    Assumption, AxisDiagnostic, AxisFault, AxisProject, Catalogue, FileCatalogue, Files, Grant, KeptRecordings,
    RatioAnswer,
};
use configurator::Product;
use quantities::Language;
use serde_json::Value;
use sizing::{StepObserver, Unobserved, finished, rank};
use std::cell::Cell;
use std::io::Read;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, LazyLock};

/// Returns the catalogue that is embedded in the program: a face hands it, or one of its own, to each call. Below the
/// faces only [`read`], [`read_all`] and the default options of a sweep use it, for callers without a catalogue.
pub fn embedded_catalogue() -> &'static Arc<dyn Catalogue> {
    static EMBEDDED: LazyLock<Arc<dyn Catalogue>> = LazyLock::new(|| configurator::Catalogue::cha());
    &EMBEDDED
}

/// Returns a catalogue with the products of catalogue files beside its own; each file is its name and its bytes.
///
/// # Errors
/// Every fault of the files, each with its place; a product of two files.
pub fn with_catalogue_files(
    base: &Arc<dyn Catalogue>,
    files: impl IntoIterator<Item = (String, Vec<u8>)>,
    language: Language,
) -> Result<Arc<dyn Catalogue>, Unanswered> {
    let parameters = base.own_actuator();
    let (mut products, mut refused): (Vec<Product>, Vec<Unanswered>) = (Vec::new(), Vec::new());
    for (name, bytes) in files {
        let faults = match axis::read_products(&name, &bytes, &parameters) {
            Ok(own) => {
                let is_known = |product: &Product| products.iter().any(|known| known.id == product.id);
                let twice = |product: &Product| AxisFault::ProductOfTwoFiles { id: product.id.to_string() };
                let twice: Vec<AxisFault> = own.iter().filter(|product| is_known(product)).map(twice).collect();
                products.extend(own);
                twice.into_iter().map(|fault| AxisDiagnostic::at("", 0..0, fault, None)).collect()
            }
            Err(faults) => faults,
        };
        if !faults.is_empty() {
            let (text, _) = project::decoded(&bytes);
            refused.push(Unanswered::unread(Unread::Faults(faults), &name, &text, language));
        }
    }
    if refused.is_empty() {
        Ok(Arc::new(FileCatalogue::new(base, true, products)))
    } else {
        Err(Unanswered::combined(refused))
    }
}

/// Reads a project file with one axis that refers to no other file, with the embedded catalogue.
///
/// # Errors
/// Every fault of the file, each with its place, in the order of the file; [`words::worded`] words them.
pub fn read(text: &str) -> Result<AxisProject, Vec<AxisDiagnostic>> {
    read_with(text, embedded_catalogue())
}

/// Reads a project file with one axis or several, in their order, and the files that it refers to, with the embedded
/// catalogue.
///
/// # Errors
/// Every fault of the file, each with its place, in the order of the file; [`words::worded`] words them.
pub fn read_all(text: &str, files: &dyn Files) -> Result<Vec<AxisProject>, Vec<AxisDiagnostic>> {
    read_all_with(text, files, embedded_catalogue())
}

/// Reads like [`read`], with a catalogue.
///
/// # Errors
/// As [`read`].
pub fn read_with(text: &str, catalogue: &Arc<dyn Catalogue>) -> Result<AxisProject, Vec<AxisDiagnostic>> {
    let read = AxisProject::read(text, catalogue, &|ratios, with| finished(best_ratio(ratios, with, &Unobserved)));
    read.map(|mut project| {
        with_template(text, std::slice::from_mut(&mut project));
        project
    })
}

/// Reads like [`read_all`], with a catalogue.
///
/// # Errors
/// As [`read_all`].
pub fn read_all_with(
    text: &str,
    files: &dyn Files,
    catalogue: &Arc<dyn Catalogue>,
) -> Result<Vec<AxisProject>, Vec<AxisDiagnostic>> {
    let read =
        AxisProject::read_all(text, files, catalogue, &|ratios, with| finished(best_ratio(ratios, with, &Unobserved)));
    read.map(|mut projects| {
        with_template(text, &mut projects);
        projects
    })
}

/// Adds the figures of the template, which no one has stated, to the assumptions of the only axis of a file.
fn with_template(text: &str, projects: &mut [AxisProject]) {
    if let [project] = projects {
        project.assumptions.extend(unstated_figures(text).into_iter().map(Assumption::OfTemplate));
    }
}

/// Reasons why there is no project.
#[derive(Clone, Debug, PartialEq)]
pub enum Unread {
    /// Every fault of the file, each with its place, in the order of the file.
    Faults(Vec<AxisDiagnostic>),
    /// The best of several ratios was not searched: the call was cancelled, or the search exceeds the usual time.
    Refused(Refusal),
}

/// Reads like [`read_all_with`], but can be cancelled: among several ratios of a stage the best is searched, and the
/// catalogue judged for each.
///
/// # Errors
/// [`Unread`].
pub fn read_all_watched(
    text: &str,
    files: &dyn Files,
    catalogue: &Arc<dyn Catalogue>,
    progress: &Progress,
) -> Result<Vec<AxisProject>, Unread> {
    let refused = Cell::new(None);
    let choose = |ratios: &[f64], with: &dyn Fn(f64) -> Option<AxisProject>| {
        let first = ratios.iter().find_map(|ratio| with(*ratio)).filter(|_| !progress.is_limited());
        // This work precedes that of the question itself.
        let ranking = Cost::Ranking { complete: 0, draw: Draw::default() };
        let quick = first.map_or(Ok(()), |first| ranking.is_quick_for(&first, ratios.len()));
        let found = quick.and_then(|()| best_ratio(ratios, with, progress).map_err(Refusal::from));
        found.unwrap_or_else(|refusal| {
            refused.set(Some(refusal));
            None
        })
    };
    let cancellable = Cancellable { files, progress, opened: Cell::new(false) };
    let read = AxisProject::read_all(text, &cancellable, catalogue, &choose);
    // Only the reading of a file can be interrupted; the faults of a text alone are complete.
    let stopped = || (read.is_err() && cancellable.opened.get() && progress.is_over()).then(|| Refusal::from(Stopped));
    refused
        .take()
        .or_else(stopped)
        .map_or_else(|| read.map_err(Unread::Faults), |refusal| Err(Unread::Refused(refusal)))
        .map(|mut projects| {
            with_template(text, &mut projects);
            projects
        })
}

/// Files that can be read until the call is cancelled.
struct Cancellable<'f> {
    files: &'f dyn Files,
    progress: &'f Progress,
    opened: Cell<bool>,
}

impl Files for Cancellable<'_> {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        self.opened.set(true);
        self.files.open(name)
    }

    fn size(&self, name: &str) -> Option<u64> {
        self.files.size(name)
    }

    fn cancelled(&self) -> Option<Arc<AtomicBool>> {
        Some(self.progress.flag())
    }

    fn kept(&self) -> Option<&KeptRecordings> {
        self.files.kept()
    }

    fn grant(&self) -> Grant {
        self.files.grant()
    }
}

/// Returns the JSON Schema of the project file (draft 2020-12).
#[must_use]
pub(crate) fn schema(language: Language) -> Value {
    project::schema(&|text| words::schema_text(text, language))
}

/// Returns the project with the ratio that gives the best actuator of the catalogue, by the rule of the ranking: a
/// smaller actuator first, then the wider margin. Among equals the first in the file is taken.
///
/// Every ratio is judged separately, because it changes the axis and not the actuator: all results for the axis (demand,
/// motion, checks, report) then belong to one ratio, and each candidate of the ranking is judged under the same.
///
/// # Errors
/// If it was cancelled.
fn best_ratio<W: StepObserver>(
    ratios: &[f64],
    with: &dyn Fn(f64) -> Option<AxisProject>,
    watch: &W,
) -> Result<Option<AxisProject>, W::Stop> {
    let mut answers: Vec<RatioAnswer> = Vec::new();
    let mut best: Option<(AxisProject, sizing::Standing, usize)> = None;
    for ratio in ratios {
        let Some(trial) = with(*ratio) else { continue };
        let sizing = size_watched(&trial, 0, Rejected::Nearest, watch)?;
        let Some(first) = sizing.named() else { continue };
        let standing = first.standing;
        answers.push(RatioAnswer {
            ratio: *ratio,
            answer: sizing.answer().map(|answer| answer.id.to_string()),
            utilisation: standing.utilisation,
            fitting: sizing.fitting().len(),
            chosen: false,
        });
        drop(sizing);
        if best.as_ref().is_none_or(|(_, other, _)| rank(&standing, other).is_lt()) {
            best = Some((trial, standing, answers.len() - 1));
        }
    }
    let Some((mut chosen, _, index)) = best else { return Ok(None) };
    if let Some(answer) = answers.get_mut(index) {
        answer.chosen = true;
    }
    chosen.ratios = answers;
    Ok(Some(chosen))
}

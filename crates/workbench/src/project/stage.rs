//! The stage between actuator and mechanism, and the best of several ratios.

use super::read::Reader;
use super::section::{Entry, Section};
use super::{Assumption, Project, finish, prepare};
use crate::sizing_use::size;
use crate::text::{Speak, stage as words};
use mechanism::{Stage, StageKind};
use quantities::{Language, Measure, MomentOfInertia};
use sizing::rank;

/// Most ratios among which the best is sought; the catalogue is judged for each.
pub(super) const RATIOS_MOST: usize = 16;

/// What one of several ratios gives.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioAnswer {
    /// i_s: turns of the actuator's output per turn of the mechanism.
    pub ratio: f64,
    /// The best actuator of the catalogue, if one fits.
    pub answer: Option<String>,
    /// Utilisation of the candidate that comes first with this ratio, whether it fits or not.
    pub utilisation: f64,
    /// How many fit.
    pub fitting: usize,
    /// Whether the project goes on with it.
    pub chosen: bool,
}

/// The stage that a file describes.
pub(super) fn read(root: &Section, reader: &mut Reader<'_>, language: Language) -> Option<Stage> {
    let section = root.table("stage")?;
    let kind = match section.text("kind")? {
        "belt" => StageKind::Belt,
        "gear" => StageKind::Gear,
        _ => StageKind::Coupling,
    };
    let (ratio, ratios) = (section.number("ratio"), section.numbers("ratios"));
    let both = section.has("ratio") && section.has("ratios");
    if both {
        reader.fault(section.span_of("ratios"), words::ratio_or_ratios(language), None);
    }
    if kind == StageKind::Coupling {
        for key in ["ratio", "ratios", "pitch_diameter"].into_iter().filter(|key| section.get(key).is_some()) {
            let unit = key == "ratio" && ratio == Some(1.0);
            if !unit {
                reader.fault(section.span_of(key), words::no_ratio_in_a_coupling(key, language), None);
            }
        }
    } else if !section.has("ratio") && !section.has("ratios") {
        let hint = language.for_example("ratio = 2.5");
        let start = section.span.start;
        reader.fault(start..start + 1, language.missing_key("stage", "ratio", false), Some(hint));
    }
    let none = || MomentOfInertia::from_si(0.0);
    Some(Stage {
        kind,
        ratio: ratio.or_else(|| ratios.first().copied()).unwrap_or(1.0),
        efficiency_driving: section.number("efficiency").unwrap_or(1.0),
        efficiency_driven: section.number("efficiency_back").unwrap_or(1.0),
        inertia_driving: section.quantity("inertia_driving").unwrap_or_else(none),
        inertia_driven: section.quantity("inertia_driven").unwrap_or_else(none),
        stiffness: section.quantity("stiffness"),
        backlash: section.quantity("backlash"),
        pitch_diameter: section.quantity("pitch_diameter"),
    })
}

/// The project with the ratio that gives the best actuator of the catalogue, by the rule of the ranking: a smaller actuator
/// first, then the wider margin. Of equals the first in the file.
///
/// Each ratio is judged by itself, because it changes the axis and not the actuator: all that is told of the axis (demand,
/// motion, checks, report) is then of one ratio, and each candidate of the ranking is judged under the same.
pub(super) fn with_best_ratio(project: Project, root: &Section, language: Language) -> Project {
    let ratios = root.table("stage").map(|section| section.numbers("ratios").to_vec()).unwrap_or_default();
    let mut answers: Vec<RatioAnswer> = Vec::new();
    let mut best: Option<(Project, sizing::Standing, usize)> = None;
    for ratio in ratios {
        let mut root = root.clone();
        root.set_ratio(ratio);
        let Some(draft) = prepare(&root, &mut Reader::new("", language), language) else { continue };
        let trial =
            Project { axis: finish(&root, draft), root: project.root.is_some().then_some(root), ..project.clone() };
        let sizing = size(&trial);
        let Some(first) = sizing.candidates.first() else { continue };
        let standing = first.standing;
        answers.push(RatioAnswer {
            ratio,
            answer: sizing.answer().map(|answer| answer.id.to_string()),
            utilisation: standing.utilisation,
            fitting: sizing.candidates.iter().filter(|candidate| candidate.fits()).count(),
            chosen: false,
        });
        drop(sizing);
        if best.as_ref().is_none_or(|(_, other, _)| rank(&standing, other).is_lt()) {
            best = Some((trial, standing, answers.len() - 1));
        }
    }
    match best {
        Some((chosen, _, index)) => {
            if let Some(answer) = answers.get_mut(index) {
                answer.chosen = true;
            }
            Project { ratios: answers, ..chosen }
        }
        None => project,
    }
}

/// Defaults about the stage that the file leaves open.
pub(super) fn assumptions(root: &Section, found: &mut Vec<Assumption>) {
    let Some(section) = root.table("stage") else { return };
    let open = |key: &str| section.get(key).is_none();
    if open("efficiency") {
        found.push(Assumption::StageNoLosses);
    } else if open("efficiency_back") {
        found.push(Assumption::StageLossesDoNotHelp);
    }
    if open("inertia_driving") && open("inertia_driven") {
        found.push(Assumption::StageWithoutInertia);
    }
    if open("stiffness") {
        found.push(Assumption::StageRigid);
    }
    if open("backlash") {
        found.push(Assumption::StageNoBacklash);
    }
    if !open("ratios") {
        found.push(Assumption::StageRatioChosen);
    }
}

impl Section {
    /// One ratio in the place of several.
    fn set_ratio(&mut self, ratio: f64) {
        if let Some((Entry::Table(stage), _)) = self.entries.get_mut("stage") {
            let span = stage.span_of("ratios");
            stage.entries.remove("ratios");
            stage.entries.insert("ratio", (Entry::Number(ratio), span));
        }
    }
}

#[cfg(test)]
#[path = "stage_tests.rs"]
mod tests;

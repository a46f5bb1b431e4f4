//! The stage between actuator and mechanism, and the best of several ratios.

use crate::read::{Reader, joined};
use crate::section::{Entry, Section};
use crate::{Assumption, Fault, Hint};
use mechanism::{Stage, StageKind};
use quantities::{Measure, MomentOfInertia};

/// Most ratios among which the best is sought; the catalogue is judged for each.
pub(crate) const RATIOS_MOST: usize = 16;

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
pub(crate) fn read(root: &Section, reader: &mut Reader<'_>) -> Option<Stage> {
    let section = root.table("stage")?;
    let kind = match section.text("kind")? {
        "belt" => StageKind::Belt,
        "gear" => StageKind::Gear,
        _ => StageKind::Coupling,
    };
    let (ratio, ratios) = (section.number("ratio"), section.numbers("ratios"));
    let both = section.has("ratio") && section.has("ratios");
    if both {
        reader.fault(section.span_of("ratios"), Fault::RatioAndRatios, None);
    }
    if kind == StageKind::Coupling {
        for key in ["ratio", "ratios", "pitch_diameter"].into_iter().filter(|key| section.get(key).is_some()) {
            let unit = key == "ratio" && ratio == Some(1.0);
            if !unit {
                reader.fault(section.span_of(key), Fault::NoRatioInACoupling { key }, None);
            }
        }
    } else if !section.has("ratio") && !section.has("ratios") {
        let fault = Fault::MissingKey { path: joined(&section.path, "ratio"), list: false };
        let start = section.span.start;
        reader.fault(start..start + 1, fault, Some(Hint::Example("ratio = 2.5".to_owned())));
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

/// Defaults about the stage that the file leaves open.
pub(crate) fn assumptions(root: &Section, found: &mut Vec<Assumption>) {
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
    pub(crate) fn set_ratio(&mut self, ratio: f64) {
        if let Some((Entry::Table(stage), _)) = self.entries.get_mut("stage") {
            let span = stage.span_of("ratios");
            stage.entries.remove("ratios");
            stage.entries.insert("ratio", (Entry::Number(ratio), span));
        }
    }
}

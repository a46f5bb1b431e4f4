//! Stage between actuator and mechanism, and the best of several ratios.

use crate::assumption::{Assumption, unstated};
use crate::choices;
use crate::fault::AxisReport;
use mechanism::{Stage, StageKind};
use project::sections::{Fields, StageSection, StatedField};
use project::{Fault, Hint};

/// Result of one of several ratios.
#[derive(Clone, Debug, PartialEq)]
pub struct RatioAnswer {
    /// i_s: turns of the actuator's output per turn of the mechanism.
    pub ratio: f64,
    /// The best actuator of the catalogue, if one fits.
    pub answer: Option<String>,
    /// Utilisation of the first candidate with this ratio, fitting or not.
    pub utilisation: f64,
    /// Number of fitting actuators.
    pub fitting: usize,
    /// The project uses this ratio.
    pub chosen: bool,
}

/// Builds the stage, and reports its faults.
pub(crate) fn build(section: &StageSection, report: &mut AxisReport<'_>) -> Option<Stage> {
    let kind = choices::stage_kind(section.kind.value()?);
    if section.ratio.is_written() && section.ratios.is_written() {
        report.fault(section.ratios.span(), Fault::RatioAndRatios, None);
    }
    if kind == StageKind::Coupling {
        let unit = section.ratio.value() == Some(1.0);
        let ratio: Option<&dyn StatedField> = (!unit).then_some(&section.ratio);
        let others: [&dyn StatedField; 2] = [&section.ratios, &section.pitch_diameter];
        for field in ratio.into_iter().chain(others).filter(|field| field.is_given()) {
            report.fault(field.span(), Fault::NoRatioInACoupling { key: field.name() }, None);
        }
    } else if !section.ratio.is_written() && !section.ratios.is_written() {
        let fault = Fault::MissingKey { path: section.ratio.path(), list: false };
        let start = section.head().span.start;
        report.fault(start..start + 1, fault, Some(Hint::Example("ratio = 2.5".to_owned())));
    }
    Some(Stage {
        kind,
        ratio: section.ratio.value().or_else(|| section.ratios().first().copied()).unwrap_or(1.0),
        efficiency_driving: section.efficiency(),
        efficiency_driven: section.efficiency_back(),
        inertia_driving: section.inertia_driving.or_zero(),
        inertia_driven: section.inertia_driven.or_zero(),
        stiffness: section.stiffness.value(),
        backlash: section.backlash.value(),
        pitch_diameter: section.pitch_diameter.value(),
    })
}

/// Adds the defaults about the stage that the file leaves open, and the ratio in use if several are stated.
pub(crate) fn assumptions(section: &StageSection, ratio: f64, found: &mut Vec<Assumption>) {
    found.extend(unstated(&section.efficiency).or_else(|| unstated(&section.efficiency_back)));
    found.extend(unstated(&section.inertia_driven).filter(|_| !section.inertia_driving.is_given()));
    found.extend([unstated(&section.stiffness), unstated(&section.backlash)].into_iter().flatten());
    if section.ratios.is_given() {
        found.push(Assumption::StageRatioChosen(ratio));
    }
}

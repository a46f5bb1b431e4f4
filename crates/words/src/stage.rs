//! Words about the stage between actuator and mechanism.

use super::either;
use project::{Assumption, RatioAnswer};
use quantities::{Language, format_number, format_significant};

/// What the ratios of a stage give, one after the other; empty for a stage of one ratio.
#[must_use]
pub fn ratios_text(ratios: &[RatioAnswer], language: Language) -> String {
    let each = ratios.iter().map(|answer| {
        let ratio = format_significant(answer.ratio, 4, language);
        let share = format_number(answer.utilisation * 100.0, 1, language);
        let found = match (&answer.answer, answer.fitting) {
            (Some(code), 1) => either(
                language,
                format!("{code} at {share} %, the only one that fits"),
                format!("{code} bei {share} %, der einzige geeignete"),
            ),
            (Some(code), many) => either(
                language,
                format!("{code} at {share} %, {many} fit"),
                format!("{code} bei {share} %, {many} sind geeignet"),
            ),
            (None, _) => either(language, "none fits", "keiner ist geeignet"),
        };
        let chosen = if answer.chosen { either(language, " (chosen)", " (gewählt)") } else { String::new() };
        format!("{ratio}: {found}{chosen}")
    });
    each.collect::<Vec<_>>().join("; ")
}

/// What is taken for granted about a stage: English, German.
pub(super) const fn assumed(assumption: Assumption) -> (&'static str, &'static str) {
    match assumption {
        Assumption::StageNoLosses => (
            "no efficiency of the stage given: 1 assumed",
            "kein Wirkungsgrad der Zwischenstufe angegeben: 1 angenommen",
        ),
        Assumption::StageLossesDoNotHelp => (
            "no stage.efficiency_back given: while the mechanism drives, the losses of the stage do not help to brake",
            "kein stage.efficiency_back angegeben: treibt der Mechanismus, so helfen die Verluste der Stufe nicht beim Bremsen",
        ),
        Assumption::StageWithoutInertia => (
            "no inertia of the stage given: 0 kgm² assumed",
            "keine Massenträgheit der Stufe angegeben: 0 kgm² angenommen",
        ),
        Assumption::StageRigid => {
            ("no stage.stiffness given: the stage is rigid", "kein stage.stiffness angegeben: die Stufe ist starr")
        }
        Assumption::StageNoBacklash => (
            "no stage.backlash given: the stage has no backlash",
            "kein stage.backlash angegeben: die Stufe hat kein Spiel",
        ),
        Assumption::StageRatioChosen => (
            "of stage.ratios the one with the best actuator of the catalogue",
            "aus stage.ratios diejenige mit dem besten Antrieb des Katalogs",
        ),
        Assumption::MechanismOnOwnBearings => (
            "with a stage the mechanism rests on bearings of its own: the flange bears the stage only",
            "mit einer Zwischenstufe ruht der Mechanismus auf eigenen Lagern: der Flansch trägt nur die Stufe",
        ),
        _ => ("", ""),
    }
}

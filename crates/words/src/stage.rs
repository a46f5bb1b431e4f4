//! Words about the stage between actuator and mechanism.

use super::either;
use project::RatioAnswer;
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

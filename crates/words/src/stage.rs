//! Words for the stage between actuator and mechanism.

use crate::percent_text;
use crate::quantity::unpadded;
use crate::terminal;
use crate::texts::said;
use axis::RatioAnswer;
use quantities::{Language, format_significant};

/// Largest number of digits of a proposed ratio.
const RATIO_DIGITS: usize = 5;

/// Describes a stage to add by the keys that state it, whose numbers have a decimal point in every language; where loads on
/// the flange must be stated anew, these keys do not suffice.
#[must_use]
pub fn stage_by_its_keys(ratio: f64, changes_flange_loads: bool, language: Language) -> String {
    let [shown, stated] = [language, Language::En].map(|language| unpadded(ratio, RATIO_DIGITS, language));
    if changes_flange_loads {
        terminal::a_stage_with_new_loads(&shown, language)
    } else {
        terminal::a_stage_by_its_keys(&shown, &stated, language)
    }
}

/// Returns the answers for the ratios of a stage, in order; empty for a stage with one ratio.
#[must_use]
pub fn ratios_text(ratios: &[RatioAnswer], language: Language) -> String {
    let each = ratios.iter().map(|answer| {
        let ratio = format_significant(answer.ratio, 4, language);
        let share = percent_text(answer.utilisation, language);
        let found = match (&answer.answer, answer.fitting) {
            (Some(code), 1) => said!(language =>
                "{code} with {share} %, the only one that fits"
                | "{code} mit {share} %, einziger geeigneter Antrieb"
            ),
            (Some(code), many) => said!(language =>
                "{code} with {share} %, {many} fit"
                | "{code} mit {share} %, {many} geeignet"
            ),
            (None, _) => said!(language =>
                "none fits, the nearest has {share} %" | "keiner ist geeignet, der nächste hat {share} %"
            ),
        };
        let chosen = if answer.chosen { said!(language => " (chosen)" | " (gewählt)") } else { String::new() };
        format!("{ratio}: {found}{chosen}")
    });
    each.collect::<Vec<_>>().join("; ")
}

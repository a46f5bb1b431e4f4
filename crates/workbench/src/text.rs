//! What antrieb says, in English and German. Both stand side by side, so that none can be missing.

mod codes;
mod derivation;
pub(crate) mod flange;
mod motion;
mod notes;
mod reading;
mod recording;
mod results;
pub(crate) mod stage;
pub(crate) mod tolerance;

pub use codes::{describe_code_error, describe_field, describe_rule, describe_token};
pub use derivation::{found_text, symbol_shown};
pub(crate) use derivation::{step_term, step_terms};
pub use motion::law_text;
pub(crate) use reading::Speak;
pub use reading::file_trouble;
pub use results::{
    assumption_text, check_missing, check_title, condition_text, curve_title, evidence_text, figure_term, grade_about,
    grade_word, note_text, ranking_rule, source_text, standing_text, symbol_term, unmet_text, unmet_title,
    verdict_count, verdict_word,
};

pub use stage::ratios_text;

use quantities::Language;

/// Chooses between the two languages.
pub(crate) fn either(language: Language, en: impl Into<String>, de: impl Into<String>) -> String {
    match language {
        Language::En => en.into(),
        Language::De => de.into(),
    }
}

//! What antrieb says, in English and German: every sentence, title and term. Both languages stand side by side, so that
//! none can be missing.
//!
//! Whoever has an identifier with its arguments asks here for the text: a check, a note, an assumption, a law, a rule, a fault.
//! Nothing is computed here and nothing read.

mod bodies;
mod codes;
mod derivation;
mod errata;
mod faults;
mod flange;
mod motion;
mod notes;
mod recording;
mod results;
mod saving;
mod schema;
mod stage;
mod usage;

pub use bodies::shape_title;
pub use codes::{describe_code_error, describe_field, describe_rule, describe_token, describe_uncovered};
pub use derivation::{found_text, step_term, step_terms, symbol_shown};
pub use errata::{erratum_kind, erratum_place, erratum_status};
pub use faults::{Told, battery_fault, fault_text, file_trouble, hint_text, told};
pub use motion::law_text;
pub use recording::encoding_guess;
pub use results::{
    assumption_text, check_missing, check_title, condition_text, curve_title, evidence_text, figure_term, grade_about,
    grade_word, note_text, ranking_rule, requirement_title, source_text, standing_text, symbol_term, unmet_text,
    verdict_count, verdict_word,
};
pub use saving::{SaveTrouble, save_trouble};
pub use schema::schema_text;
pub use stage::ratios_text;
pub use usage::{Usage, UsageHint, usage_hint, usage_text};

use quantities::Language;

/// Chooses between the two languages.
#[must_use]
pub fn either(language: Language, en: impl Into<String>, de: impl Into<String>) -> String {
    match language {
        Language::En => en.into(),
        Language::De => de.into(),
    }
}

//! Texts of antrieb in English and German: every sentence, title and term. Both languages stand side by side, so that
//! none can be missing.
//!
//! Returns the text for an identifier with its arguments: a check, a note, an assumption, a law, a rule, a fault.
//! Nothing is computed here and nothing read.

mod actuator_keys;
mod angular_errors;
mod assumptions;
mod axis_faults;
mod bodies;
pub mod catalogue_template;
mod check_meanings;
mod codes;
pub mod commission;
mod commissioned;
mod derivation;
pub mod encoder;
mod errata;
mod examples;
mod facts;
mod faults;
mod file_trouble;
mod geometry;
mod glossary_page;
pub mod help;
mod hyphens;
pub mod identification;
pub mod incoming;
mod keys;
mod letters;
mod measured_keys;
mod mechanism_keys;
mod models;
mod motion;
pub mod mounting;
mod notes;
pub mod operation;
pub mod page;
pub mod pages;
pub mod pictures;
mod plain;
pub mod plausibility;
mod print;
mod project_file;
mod project_page;
mod quantity;
mod recorded_keys;
mod recorded_samples;
pub mod recorded_template;
mod recording;
pub mod records;
pub mod report;
pub mod requests;
mod results;
mod saving;
mod schema;
pub mod serving;
pub mod simulation;
pub mod spoken;
mod stage;
mod step_terms;
pub mod sweeps;
pub mod tables;
pub mod terminal;
pub mod terms;
mod texts;
mod titles;
mod toml_syntax;
mod twin_keys;
mod unmet;
pub mod upkeep;
mod usage;
pub mod views;
pub mod wiring;

pub use angular_errors::error_kind_text;
pub use assumptions::assumption_text;
pub use axis_faults::battery_fault;
pub use bodies::shape_title;
pub use check_meanings::check_meaning;
pub use codes::{describe_code_error, describe_field, describe_rule, describe_token, describe_uncovered};
pub use commissioned::{
    band_text, cause_text, choice_text, conversion_text, gap_text, measurand_name, object_name, parameter_name,
    unjudged_text,
};
pub use derivation::{found_condition, found_text, symbol_shown};
pub use errata::{ERRATUM_MARK, erratum_kind, erratum_line, erratum_place, erratum_place_of, erratum_status, marked};
pub use examples::{
    EXAMPLE_TEXTS, example_text, figures_of_a_template, how_to_run, paths_stated_of_template, stated_of_template,
};
pub use facts::{fact_source, fact_text, signal_word, step_title};
pub use faults::{FaultWords, Worded, fault_text, hint_text, own_hint, worded};
pub use file_trouble::file_trouble;
pub use glossary_page::{glossary_page, glossary_symbol, glossary_symbols};
pub use hyphens::hyphenated;
pub use keys::{about_text, key_text};
pub use letters::{is_vowel, stands_before_a_number};
pub use measured_keys::{measured_key_text, measured_label};
pub use models::{MODELS, chapter_name, model_name};
pub use motion::{law_text, segment_load};
pub use notes::note_text;
pub use plain::{purpose_of, without_keys};
pub use print::{
    cell_text, decimal, document_note, document_short, document_title, erratum_readings, own_and_foreign, short,
    table_note, table_title, term_remark, typeset, word_meaning,
};
pub use project_file::{body_key, key_word, short_label, table_of_project};
pub use project_page::project_page;
pub use quantity::{percent_text, quantity_fault, quantity_hint, unpadded};
pub use recording::{encoding_guess, recording_text, role_key, role_text, table_text};
pub use results::{
    Counts, Provisos, advice_word, check_missing, check_title, condition_text, conditions_text, counts_text,
    curve_title, degree_of_protection, equation_text, evidence_text, figure_term, grade_about, grade_word, minutes,
    missing_data_text, part_title, proviso_text, ranking_rule, row_name, row_sign, source_text, standing_text,
    symbol_term, title_of_check, verdict_count, verdict_word, without_limit,
};
pub use saving::{SaveTrouble, save_trouble};
pub use schema::schema_text;
pub use stage::{ratios_text, stage_by_its_keys};
pub use step_terms::{step_term, step_terms};
pub use texts::{Text, Word};
pub use titles::check_titles;
pub use unmet::unmet_text;
pub use usage::{Usage, UsageHint, usage_hint, usage_text};

use quantities::Language;

/// Returns the value of the language.
pub(crate) const fn pick<T: Copy>(language: Language, en: T, de: T) -> T {
    match language {
        Language::En => en,
        Language::De => de,
    }
}

/// Returns a text with a capital first letter, as in a title.
#[must_use]
pub fn capitalised(text: &str) -> String {
    // A symbol at the head keeps its letter: `n_N, rated motor speed`, `m, mass`, `t₁`, and `m` alone.
    let head = text.split([',', ' ']).next().unwrap_or_default();
    let is_indexed = head.contains(['_', '(']) || head.chars().skip(1).any(char::is_numeric);
    if is_indexed || head.chars().count() == 1 && matches!(text.chars().nth(1), None | Some(',')) {
        return text.to_owned();
    }
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Every module of texts by name, for tests of all texts.
pub const MODULES: &[(&str, &[Text])] = &[
    ("catalogue_template", catalogue_template::TEXTS),
    ("commission", commission::TEXTS),
    ("encoder", encoder::TEXTS),
    ("help", help::TEXTS),
    ("help::library", help::library::TEXTS),
    ("help::values", help::values::TEXTS),
    ("incoming", incoming::TEXTS),
    ("mounting", mounting::TEXTS),
    ("page", page::TEXTS),
    ("operation", operation::TEXTS),
    ("pages", pages::TEXTS),
    ("pictures", pictures::TEXTS),
    ("plausibility", plausibility::TEXTS),
    ("recorded_template", recorded_template::TEXTS),
    ("records", records::TEXTS),
    ("report", report::TEXTS),
    ("requests", requests::TEXTS),
    ("serving", serving::TEXTS),
    ("identification", identification::TEXTS),
    ("simulation", simulation::TEXTS),
    ("sweeps", sweeps::TEXTS),
    ("tables", tables::TEXTS),
    ("terminal", terminal::TEXTS),
    ("terms", terms::TEXTS),
    ("wiring", wiring::TEXTS),
    ("upkeep", upkeep::TEXTS),
    ("views", views::TEXTS),
];

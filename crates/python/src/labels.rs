//! Words by which Python shows answers.

use provenance::Grade;
use quantities::Language;
use words::{grade_word, terminal, terms};

/// Returns the words by their names; grades under their ids.
#[must_use]
pub fn labels(language: Language) -> Vec<(&'static str, &'static str)> {
    let own = [
        ("fits", terms::fits(language)),
        ("fits_if_estimate", terms::fits_if_estimate(language)),
        ("not_evaluated", terms::not_evaluated(language)),
        ("does_not_fit", terms::does_not_fit(language)),
        ("none_fits", terminal::no_actuator_fits(language)),
        ("candidates", terms::candidates(language)),
        ("nearest_miss", terminal::nearest_miss(language)),
        ("axis", terms::axis(language)),
        ("code", terms::ordering_code(language)),
        ("utilisation", terms::utilisation_short(language)),
        ("tightest", terms::tightest_check(language)),
        ("check", terms::check(language)),
        ("verdict", terms::verdict(language)),
        ("value", terms::value(language)),
        ("limit", terms::limit(language)),
        ("unit", terms::unit(language)),
        ("pass", terms::pass(language)),
        ("fail", terms::fail(language)),
        ("advice", terms::advice(language)),
        ("not_checked", terms::not_checked(language)),
        ("required", terminal::asked(language)),
        ("permitted", terminal::permitted(language)),
        ("see_above", terminal::see_above(language)),
        ("assumptions", terms::assumptions(language)),
    ];
    let grades = [Grade::Printed, Grade::Computed, Grade::Published, Grade::Estimated, Grade::Assumed];
    own.into_iter().chain(grades.map(|grade| (grade.id(), grade_word(grade, language)))).collect()
}

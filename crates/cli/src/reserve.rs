//! What a candidate leaves in reserve or lacks, and what was assumed, as text.

use crate::table::labelled;
use workbench::quantities::unit::DEGREE_CELSIUS;
use workbench::quantities::{Language, Measure, format_significant};
use workbench::text::{assumption_text, terminal, terms};
use workbench::{Candidate, NeededLimit, Reserve, limits_needed};

/// What was taken because nobody stated it.
pub(crate) fn assumptions_text(assumptions: &[workbench::Assumption], language: Language) -> String {
    let head = terms::assumed(language);
    assumptions.iter().map(|assumption| labelled(head, &assumption_text(*assumption, language))).collect()
}

/// How far one thing may be changed, all others as they are; for what does not fit also the limits of the project that
/// would have to be others.
pub(crate) fn reserve_text(reserve: &Reserve, candidate: &Candidate<'_>, language: Language) -> String {
    let number = |value: f64| format_significant(value, 4, language);
    let mut parts = Vec::new();
    if let Some(factor) = reserve.payload_factor {
        let factor = number(factor);
        parts.push(terminal::payload_factor(&factor, language));
    }
    if let Some(factor) = reserve.load_factor {
        let factor = number(factor);
        parts.push(terminal::load_factor(&factor, language));
    }
    if let Some(time) = reserve.cycle_time {
        let time = number(time.si());
        parts.push(terminal::cycle_time(&time, language));
    }
    if let Some(ambient) = reserve.ambient {
        let ambient = number(DEGREE_CELSIUS.from_si(ambient.si()));
        parts.push(terminal::ambient(&ambient, language));
    }
    let mut out = String::new();
    if !parts.is_empty() {
        let head = match (candidate.judgement_fits(), candidate.objections.is_empty()) {
            (true, true) => terminal::fits_up_to(language),
            (true, false) => terminal::checks_pass_up_to(language),
            (false, true) => terminal::would_fit_with_one_of(language),
            (false, false) => terminal::checks_would_pass_with_one_of(language),
        };
        out.push_str(&labelled(head, &parts.join("; ")));
    }
    if let Some(needed) = limits_needed(candidate) {
        let each = |needed: &NeededLimit| {
            let unit = needed.enough.unit;
            format!("{} {} {}", needed.key, number(needed.enough.value()), unit.symbol)
        };
        let all: Vec<String> = needed.iter().map(each).collect();
        let head = terminal::would_fit_with_this_asked_for(language);
        out.push_str(&labelled(head, &all.join("; ")));
    }
    out
}

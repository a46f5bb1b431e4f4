//! What a candidate leaves in reserve or lacks, and what was assumed, as text.

use crate::say::t;
use crate::table::paragraph;
use workbench::quantities::unit::DEGREE_CELSIUS;
use workbench::quantities::{Language, Measure, format_significant};
use workbench::text::assumption_text;
use workbench::{Candidate, NeededLimit, Reserve, limits_needed};

/// What was taken because nobody stated it.
pub(crate) fn assumptions_text(assumptions: &[workbench::Assumption], language: Language) -> String {
    let head = t(language, "assumed: ", "angenommen: ");
    assumptions.iter().map(|assumption| paragraph(&head, &assumption_text(*assumption, language))).collect()
}

/// How far one thing may be changed, all others as they are; for what does not fit also the limits of the project that
/// would have to be others.
pub(crate) fn reserve_text(reserve: &Reserve, candidate: &Candidate<'_>, language: Language) -> String {
    let number = |value: f64| format_significant(value, 4, language);
    let mut parts = Vec::new();
    if let Some(factor) = reserve.payload_factor {
        let factor = number(factor);
        parts.push(t(language, &format!("payload × {factor}"), &format!("Nutzlast × {factor}")));
    }
    if let Some(factor) = reserve.load_factor {
        let factor = number(factor);
        parts.push(t(
            language,
            &format!("all masses and inertias × {factor}"),
            &format!("alle Massen und Trägheiten × {factor}"),
        ));
    }
    if let Some(time) = reserve.cycle_time {
        let time = number(time.si());
        parts.push(t(language, &format!("cycle of {time} s"), &format!("Zyklus von {time} s")));
    }
    if let Some(ambient) = reserve.ambient {
        let ambient = number(DEGREE_CELSIUS.from_si(ambient.si()));
        parts.push(t(language, &format!("ambient {ambient} °C"), &format!("Umgebung {ambient} °C")));
    }
    let mut out = String::new();
    if !parts.is_empty() {
        let head = match (candidate.judgement_fits(), candidate.objections.is_empty()) {
            (true, true) => t(language, "fits up to, one at a time: ", "geeignet bis zu, je für sich: "),
            (true, false) => t(
                language,
                "all checks pass up to, one at a time: ",
                "alle Nachweise sind erfüllt bis zu, je für sich: ",
            ),
            (false, true) => t(language, "would fit with one of: ", "wäre geeignet mit einem von: "),
            (false, false) => {
                t(language, "all checks would pass with one of: ", "alle Nachweise wären erfüllt mit einem von: ")
            }
        };
        out.push_str(&paragraph(&head, &parts.join("; ")));
    }
    if let Some(needed) = limits_needed(candidate) {
        let each = |needed: &NeededLimit| {
            let unit = needed.enough.unit;
            format!("{} {} {}", needed.key, number(needed.enough.value()), unit.symbol)
        };
        let all: Vec<String> = needed.iter().map(each).collect();
        let head = t(language, "would fit with this asked for: ", "wäre geeignet, wenn nur dies gefordert wäre: ");
        out.push_str(&paragraph(&head, &all.join("; ")));
    }
    out
}

//! Answers laid out as chapters, for whoever shows them: a terminal, a page, a sheet of paper.

mod commission;
mod mount;
mod upkeep;
mod wiring;

pub use commission::commission;
pub use mount::mount;
pub use upkeep::upkeep;
pub use wiring::wiring;

use answers::{Fact, Hazard, Number};
use quantities::{Language, Unit, format_significant};
use words::signal_word;

/// Facts as hazards and rules, in their order.
fn hazards(facts: &[Fact], language: Language) -> Vec<Hazard> {
    let hazard = |fact: &Fact| Hazard {
        level: fact.signal.map_or("", |signal| signal.id()),
        word: fact.signal.map_or("", |signal| signal_word(*signal, language)),
        text: fact.text.to_owned(),
        source: fact.source.clone(),
    };
    facts.iter().map(hazard).collect()
}

/// What stands for nothing.
const NOTHING: &str = "–";

/// A number with so many digits that count.
fn significant(value: Option<Number>, digits: usize, language: Language) -> String {
    value.map_or_else(|| NOTHING.to_owned(), |value| format_significant(value.0, digits, language))
}

/// A number as the print has it: no more digits than it needs.
fn plain(value: Option<Number>, language: Language) -> String {
    let text = value.and_then(|value| value.written()).map_or_else(|| NOTHING.to_owned(), |value| value.to_string());
    text.replace('.', &language.decimal_mark().to_string())
}

/// A unit of the records as people write it; nothing for a pure number.
fn unit_shown(unit: &str) -> String {
    if unit == "1" { String::new() } else { Unit::of(unit).map_or(unit, |unit| unit.symbol).to_owned() }
}

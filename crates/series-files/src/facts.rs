//! Facts stated in prose by a source: checked for their form and written as static records.

use crate::code::variant_of;
use crate::fact_file::FactEntry;
use crate::read::Data;
use std::collections::BTreeSet;

const GRADES: &[&str] = &["printed", "published", "assumed"];
const TOPICS: &[&str] = &["wiring", "mount", "commission", "upkeep", "safety"];
const SIGNALS: &[&str] = &["danger", "warning", "caution", "notice", "info"];
const STEPS: &[&str] = &[
    "transport",
    "mounting",
    "wiring",
    "before_power",
    "first_motion",
    "after_a_day",
    "in_service",
    "shutdown",
    "disposal",
];
const BOUNDS: &[&str] = &["above", "below", "at_least", "at_most", "about", "exactly"];

/// Returns the variant of a word in `catalogue`'s type; reports an unknown word with the known ones.
fn variant(what: &str, word: &str, words: &[&str], at: &str, faults: &mut Vec<String>) -> String {
    if !words.contains(&word) {
        faults.push(format!("{at}: unknown {what} `{word}`, known are {}", words.join(", ")));
    }
    variant_of(word)
}

fn is_snake_case(id: &str) -> bool {
    id.starts_with(|c: char| c.is_ascii_lowercase())
        && id.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
}

/// Removes the spaces that group digits, so that `10 000 Pa` contains the number 10000.
fn ungrouped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    while let Some(c) = characters.next() {
        let space = matches!(c, ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}');
        let between =
            out.ends_with(|c: char| c.is_ascii_digit()) && characters.peek().is_some_and(char::is_ascii_digit);
        if !(space && between) {
            out.push(c);
        }
    }
    out
}

/// Returns `true` if a number occurs in the text and is not part of a longer one.
fn has_figure(text: &str, figure: &str) -> bool {
    let text = ungrouped(text);
    text.match_indices(figure).any(|(start, _)| {
        let digit = |c: char| c.is_ascii_digit();
        let before = text.get(..start).unwrap_or_default();
        let after = text.get(start + figure.len()..).unwrap_or_default();
        let decimals = after.strip_prefix(['.', ',']).is_some_and(|rest| rest.starts_with(digit));
        !before.ends_with(digit) && !after.starts_with(digit) && !decimals
    })
}

/// Checks the facts and returns them as source text of `FACTS`, in the types of `catalogue`.
pub fn embed(data: &Data, faults: &mut Vec<String>) -> String {
    let mut seen = BTreeSet::new();
    let mut out = String::from("pub(crate) static FACTS: &[Fact] = &[\n");
    for fact in &data.facts {
        let at = format!("{}: fact `{}`", fact.file, fact.id);
        if !seen.insert(fact.id.as_str()) {
            faults.push(format!("{at} stands twice"));
        }
        if !is_snake_case(&fact.id) {
            faults.push(format!("{at}: an identifier has small letters, digits and _"));
        }
        if !data.sources.iter().any(|source| source.id == fact.source) {
            faults.push(format!("{at}: source `{}` is not in sources.toml", fact.source));
        }
        for (key, text) in [("section", &fact.section), ("en", &fact.en), ("de", &fact.de)] {
            if text.trim().is_empty() {
                faults.push(format!("{at}: `{key}` is empty"));
            }
        }
        if fact.en == fact.de {
            faults.push(format!("{at}: both languages have the same text"));
        }
        if fact.topics.is_empty() {
            faults.push(format!("{at}: without a topic no answer shows it"));
        }
        out.push_str(&record(fact, data, &at, faults));
        out.push_str(",\n");
    }
    out.push_str("];\n");
    out
}

/// Returns one record as Rust source.
fn record(fact: &FactEntry, data: &Data, at: &str, faults: &mut Vec<String>) -> String {
    let grade = variant("kind", fact.kind.as_deref().unwrap_or("printed"), GRADES, at, faults);
    let topics: Vec<String> =
        fact.topics.iter().map(|topic| format!("Topic::{}", variant("topic", topic, TOPICS, at, faults))).collect();
    let mut optional = |kind: &str, what: &str, word: &Option<String>, words: &[&str]| {
        word.as_ref().map_or_else(
            || "None".to_owned(),
            |word| format!("Some({kind}::{})", variant(what, word, words, at, faults)),
        )
    };
    let signal = optional("SignalWord", "signal word", &fact.signal, SIGNALS);
    let step = optional("LifeStep", "step", &fact.step, STEPS);
    let values = values(fact, at, faults);
    format!(
        "Fact {{ id: {:?}, section: {:?}, document: {:?}, grade: provenance::Grade::{grade}, topics: &[{}], \
         signal: {signal}, step: {step}, holds_for: {}, values: &[{values}], en: {:?}, de: {:?} }}",
        fact.id,
        fact.section,
        fact.source,
        topics.join(", "),
        holds_for(fact, data, at, faults),
        fact.en,
        fact.de,
    )
}

fn holds_for(fact: &FactEntry, data: &Data, at: &str, faults: &mut Vec<String>) -> String {
    let codes = &fact.holds_for;
    let Some(code) = data.codes.get(fact.series) else { return String::new() };
    let series = format!("order_code::Series::at({})", fact.series);
    let mut list = |field: &str, kind: &str, words: &[String]| {
        let mut values = Vec::new();
        for word in words {
            match code.place(field, word) {
                Some(place) => values.push(format!("order_code::{kind}::at({series}, {place})")),
                None => {
                    let known = code.words(field).join(", ");
                    faults.push(format!("{at}: unknown {field} `{word}`, known are {known}"));
                }
            }
        }
        values.join(", ")
    };
    format!(
        "HoldsFor {{ series: {series}, sizes: &[{}], windings: &[{}], feedbacks: &[{}], brake: {:?}, output_encoder: {:?}, kty: {:?} }}",
        list("size", "Size", &codes.size),
        list("winding", "Winding", &codes.winding),
        list("feedback", "Feedback", &codes.feedback),
        codes.brake,
        codes.ec,
        codes.kty,
    )
}

fn values(fact: &FactEntry, at: &str, faults: &mut Vec<String>) -> String {
    if fact.value.is_some() && !fact.values.is_empty() {
        faults.push(format!("{at}: has `value` and `values`; several figures all stand in `values`"));
    }
    let mut ids = BTreeSet::new();
    let mut out = Vec::new();
    for value in fact.value.iter().chain(&fact.values) {
        let id = value.id.as_deref().unwrap_or("");
        if !fact.values.is_empty() && !is_snake_case(id) {
            faults.push(format!("{at}: each of several values has an `id` of its own, not `{id}`"));
        }
        if !ids.insert(id) {
            faults.push(format!("{at}: the value `{id}` stands twice"));
        }
        let unit = value.unit.as_deref().unwrap_or("");
        if !unit.is_empty() && quantities::Unit::of(unit).is_none() {
            faults.push(format!("{at}: unknown unit `{unit}`"));
        }
        let en = format!("{}", value.number);
        for (language, text, figure) in [("en", &fact.en, en.clone()), ("de", &fact.de, en.replace('.', ","))] {
            if !has_figure(text, &figure) {
                faults.push(format!("{at}: the figure {figure} does not stand in the text `{language}`"));
            }
        }
        out.push(format!(
            "FactValue {{ id: {id:?}, number: {:?}, unit: {unit:?}, bound: Bound::{} }}",
            value.number,
            variant("bound", &value.bound, BOUNDS, at, faults),
        ));
    }
    out.join(", ")
}

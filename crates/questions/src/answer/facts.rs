//! Facts as records.

use answers::{FactValue, Id, Number};
use catalogue::Fact;
use quantities::Language;
use words::{fact_source, fact_text};

/// Returns the facts with their texts.
#[must_use]
pub fn facts(facts: &[&'static Fact], language: Language) -> Vec<answers::Fact> {
    let value = |value: &catalogue::FactValue| FactValue {
        id: Some(value.id).filter(|id| !id.is_empty()),
        number: Number(value.number),
        unit: value.unit,
        bound: Id(value.bound),
    };
    let record = |fact: &&'static Fact| answers::Fact {
        id: fact.id,
        signal: fact.signal.map(Id),
        step: fact.step.map(Id),
        text: fact_text(fact, language),
        values: fact.values.iter().map(value).collect(),
        source: fact_source(fact, language),
        grade: Id(fact.grade),
    };
    facts.iter().map(record).collect()
}

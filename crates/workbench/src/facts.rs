//! The facts in prose that concern an ordering code.

use catalogue::{Fact, Topic};
use order_code::OrderCode;

/// What is stated on a topic about a code, gravest signal word first, then in the order of a machine's life and of the data;
/// safety is stated on every topic.
#[must_use]
pub fn facts_about(topic: Topic, code: &OrderCode) -> Vec<&'static Fact> {
    let mut facts: Vec<&Fact> = catalogue::facts().iter().filter(|fact| fact.is_shown(topic, code)).collect();
    facts.sort_by_key(|fact| (fact.signal.is_none(), fact.signal, fact.step));
    facts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::list_codes;

    #[test]
    fn every_fact_is_shown_on_some_topic_for_some_code() {
        let codes = list_codes(None);
        for fact in catalogue::facts() {
            let shown = codes.iter().any(|(code, _)| {
                Topic::ALL.iter().filter(|topic| **topic != Topic::Safety).any(|topic| fact.is_shown(*topic, code))
            });
            assert!(shown, "{}: no code has what it holds for", fact.id);
        }
    }

    #[test]
    fn the_brake_is_never_called_safe_where_there_is_none_to_speak_of() {
        let codes = list_codes(None);
        for (code, _) in codes {
            let told = facts_about(Topic::Wiring, code).iter().any(|fact| fact.id == "brake_is_not_safe");
            assert_eq!(told, code.brake == order_code::Brake::With, "{code}");
        }
    }
}

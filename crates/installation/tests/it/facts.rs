//! The facts in prose: each appears in some answer, in the required order.
#![allow(missing_docs, clippy::unwrap_used, reason = "a test fails loudly")]

use catalogue::{Fact, Topic};
use installation::facts::{Order, facts_about};
use order_code::{Brake, OrderCode};

fn codes() -> Vec<OrderCode> {
    configurator::all().iter().map(|(code, _)| *code).collect()
}

fn ids(facts: &[&'static Fact]) -> Vec<&'static str> {
    let mut ids: Vec<&str> = facts.iter().map(|fact| fact.id).collect();
    ids.sort_unstable();
    ids
}

#[test]
fn every_fact_is_shown_on_some_topic_for_some_code() {
    let codes = codes();
    for fact in catalogue::facts() {
        let shown = codes.iter().any(|code| {
            Topic::ALL.iter().filter(|topic| **topic != Topic::Safety).any(|topic| fact.is_shown(*topic, code))
        });
        assert!(shown, "{}: no code has what it holds for", fact.id);
    }
}

#[test]
fn the_brake_is_never_called_safe_where_there_is_none_to_speak_of() {
    for code in codes() {
        let stated = facts_about(Topic::Wiring, &code, Order::Data).iter().any(|fact| fact.id == "brake_is_not_safe");
        assert_eq!(stated, code.brake == Brake::With, "{code}");
    }
}

#[test]
fn the_order_changes_nothing_but_the_order() {
    let code = order_code::parse("CHA-58A-100-H-M512P-B").unwrap().code;
    for topic in [Topic::Wiring, Topic::Mount, Topic::Commission, Topic::Upkeep] {
        let [data, gravest, life] =
            [Order::Data, Order::Gravest, Order::Life].map(|order| facts_about(topic, &code, order));
        assert_eq!(ids(&data), ids(&gravest));
        assert_eq!(ids(&data), ids(&life));
        assert!(gravest.is_sorted_by_key(|fact| (fact.signal.is_none(), fact.signal)), "{topic:?}");
        assert!(life.is_sorted_by_key(|fact| (fact.step.is_none(), fact.step)), "{topic:?}");
    }
}

#[test]
fn lifting_gear_is_for_what_is_heavy() {
    let stated = |text: &str| {
        let code = order_code::parse(text).unwrap().code;
        facts_about(Topic::Mount, &code, Order::Life).iter().any(|fact| fact.id == "hoist_above_20_kg")
    };
    assert!(stated("CHA-58A-100-H-M512P-B") && !stated("CHA-14A-50-E-M128S"));
}

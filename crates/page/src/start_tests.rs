#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use super::*;
use project::Written;
use quantities::MomentOfInertia;
use std::collections::BTreeMap;

/// Returns figures of a user's own: those of the template, each changed in its last digits; words as they are.
fn own_figures(begin: &Begin) -> BTreeMap<&'static str, String> {
    let figure = |path: &'static str| {
        let usual = begin.of_template(path);
        let (number, unit) = usual.split_once(' ').unwrap_or((&usual, ""));
        let value = match number.parse::<f64>() {
            // A number of falls is whole.
            Ok(number) if unit.is_empty() => format!("{}", number + 1.0),
            Ok(number) => format!("{:.3} {unit}", number * 1.01),
            Err(_) => "taper".to_owned(),
        };
        (path, value)
    };
    begin.paths().map(figure).collect()
}

/// Every quantity of a project that a beginning makes was typed, repeats what was typed, or is listed as assumed; a word is
/// that of the plain motion.
#[test]
fn a_beginning_states_what_was_typed_and_nothing_else() {
    for begin in BEGINS.iter() {
        let own = own_figures(begin);
        let text = begin.text(|path| own.get(path).cloned(), false);
        let project = questions::read(&text).unwrap_or_else(|faults| panic!("{text}\n{faults:?}"));
        for Written { path, value, .. } in written(&text).unwrap() {
            let Some(value) = value else { continue };
            let repeats = |typed: &String| *typed == value || reversed(typed) == value;
            let is_repeated = begin.repeated().any(|(of, place, _)| place == path && own.get(of).is_some_and(repeats));
            let is_typed = own.get(path.as_str()).is_some_and(|typed| *typed == value) || is_repeated;
            let is_of_the_plain_motion = path.ends_with(".law") || path == "axis.single_move" || path == "format";
            let is_shape_of_the_plain_body = path == "mechanism.turntable.body[1].shape";
            assert!(is_typed || is_of_the_plain_motion || is_shape_of_the_plain_body, "{path} = {value}\n{text}");
        }
        let typed = own.keys().filter(|path| !text.contains(own.get(*path).unwrap().as_str())).collect::<Vec<_>>();
        assert!(typed.is_empty(), "{typed:?}\n{text}");
        // A law that is not decided is listed, with the keys that would decide it.
        let assumed = project.assumed();
        let open = text.matches("law = \"open\"").count();
        let listed = assumed.iter().find(|each| each.assumption == axis::Assumption::LawOpen);
        assert_eq!(listed.map_or(0, |each| each.keys.len()), open, "{text}");
        if text.contains("single_move") {
            assert!(assumed.iter().any(|each| each.assumption == axis::Assumption::SingleMoveRepeats));
        }
    }
}

#[test]
fn a_beginning_without_a_value_leaves_its_key_out() {
    for begin in BEGINS.iter() {
        let text = begin.text(|_| None, false);
        let stated = written(&text).unwrap();
        for path in begin.paths() {
            assert!(!stated.iter().any(|key| key.path == path), "{path}\n{text}");
        }
    }
}

#[test]
fn every_way_to_begin_asks_for_at_most_six_rows_and_has_an_answer() {
    assert_eq!(BEGINS.iter().filter(|begin| begin.has_tile).count(), MechanismId::ALL.len() - 2);
    for begin in BEGINS.iter() {
        assert!(begin.asked.len() <= ASKED_MOST && begin.asked.len() >= 4, "{:?}", begin.mechanism);
        assert!(
            begin.paths().all(|path| key_at(path).is_some() && !begin.of_template(path).is_empty()),
            "{}",
            begin.text
        );
        let own = own_figures(begin);
        let text = begin.text(|path| own.get(path).cloned(), false);
        let project = questions::read(&text).unwrap_or_else(|faults| panic!("{text}\n{faults:?}"));
        assert!(questions::size(&project).fits(), "{text}");
    }
}

/// Taking an assumption writes the value in effect: the assumption is gone, and the demand is the same.
#[test]
fn an_assumption_that_is_taken_changes_nothing_but_its_mention() {
    for begin in BEGINS.iter() {
        let text = begin.text(|_| None, true);
        let project = questions::read(&text).unwrap();
        let demand = |project: &axis::AxisProject| project.axis.demand(MomentOfInertia::from_si(0.1));
        for each in project.assumed() {
            let Some(value) = each.value.as_ref().filter(|_| each.is_alone) else { continue };
            assert!(!each.keys.is_empty(), "{:?}", each.assumption);
            let take = |text: String, key: &String| edit(&text, key, Edit::Value(value)).unwrap();
            let taken = each.keys.iter().fold(text.clone(), take);
            let read = questions::read(&taken).unwrap_or_else(|faults| panic!("{taken}\n{faults:?}"));
            assert!(!read.assumptions.contains(&each.assumption), "{:?}\n{taken}", each.assumption);
            assert_eq!(format!("{:?}", demand(&read)), format!("{:?}", demand(&project)), "{taken}");
        }
    }
}

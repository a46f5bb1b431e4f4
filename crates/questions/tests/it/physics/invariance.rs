//! Properties that a quantity must not depend on: direction of the motion, spelling of the units, time at which the cycle begins, language.

use crate::physics::{checks, read};
use quantities::Language;
use sizing::{Check, Checks};
use testkit::projects::{Drawn, Draws, LAWS, mechanisms, moved};

const CODE: &str = "CHA-32A-100-H-C1024";
const BEARING: &str = "load_factor = 1.2\noperating_condition = \"normal\"\n";
const REQUIREMENTS: &str = "supply = \"560 V\"\nambient = \"25 degC\"\n";

/// There and back with rests between, by two laws.
fn cycle(drawn: &Drawn, draws: &mut Draws) -> Vec<String> {
    let stroke = drawn.stroke_deg.min(400.0);
    let time = draws.within(0.8, 3.0);
    let (there, back) = (draws.one_of(&LAWS), draws.one_of(&LAWS));
    vec![
        moved(there, stroke, time),
        "[[motion]]\nlaw = \"dwell\"\ntime = \"0.6 s\"\n".to_owned(),
        moved(back, -stroke, 1.3 * time),
        "[[motion]]\nlaw = \"dwell\"\ntime = \"0.3 s\"\n".to_owned(),
    ]
}

/// Every check has the same value, limit, verdict and utilisation.
fn same(a: &Checks, b: &Checks, about: &str) {
    assert_eq!(a.len(), b.len(), "{about}");
    let close = |a: f64, b: f64| a == b || (a - b).abs() <= 1e-8 * a.abs().max(b.abs()) + 1e-12;
    for (a, b) in a.iter().zip(b) {
        assert_eq!((a.id, a.verdict, a.missing), (b.id, b.verdict, b.missing), "{about}");
        for (a_si, b_si) in [(a.value, b.value), (a.limit, b.limit)] {
            let (Some(a_si), Some(b_si)) = (a_si, b_si) else { continue };
            // Beyond the largest speed nothing is permitted, and each instant there is as bad.
            if a.limit.is_some_and(|limit| limit.si == 0.0) {
                continue;
            }
            assert!(close(a_si.si, b_si.si), "{:?}: {} {} {about}", a.id, a_si.si, b_si.si);
        }
        if let (Some(x), Some(y)) = (a.utilisation, b.utilisation) {
            assert!(close(x, y), "{:?}: {x} {y} {about}", a.id);
        }
    }
}

fn each(seeds: std::ops::Range<u64>, mut look: impl FnMut(&Drawn, &mut Draws)) {
    for seed in seeds {
        let mut draws = Draws::new(1000 + seed);
        let all = mechanisms(&mut draws);
        all.iter().for_each(|drawn| look(drawn, &mut draws));
    }
}

/// A cycle has no first segment: begun with its last dwell it demands and wears the same.
#[test]
fn a_cycle_may_begin_with_any_of_its_dwells() {
    each(0..2, |drawn, draws| {
        let parts = cycle(drawn, draws);
        let text = |parts: &[String]| drawn.project(&parts.concat(), BEARING, REQUIREMENTS);
        let mut later = parts.clone();
        later.rotate_right(1);
        same(&checks(&read(&text(&parts)), CODE), &checks(&read(&text(&later)), CODE), &text(&parts));
    });
}

/// Degrees are radians and turns, seconds are milliseconds.
#[test]
fn the_spelling_of_a_unit_changes_nothing() {
    each(2..4, |drawn, draws| {
        let text = drawn.project(&cycle(drawn, draws).concat(), BEARING, REQUIREMENTS);
        let mut respelled = String::new();
        for line in text.lines() {
            let converted = [
                (" deg\"", std::f64::consts::PI / 180.0, " rad\""),
                (" s\"", 1000.0, " ms\""),
                (" mm\"", 1e-3, " m\""),
            ]
            .into_iter()
            .find_map(|(unit, factor, other)| {
                let (key, value) = line.split_once(" = \"")?;
                let number: f64 = value.strip_suffix(unit)?.parse().ok()?;
                Some(format!("{key} = \"{}{other}", number * factor))
            });
            respelled.push_str(&converted.unwrap_or_else(|| line.to_owned()));
            respelled.push('\n');
        }
        assert_ne!(text, respelled);
        same(&checks(&read(&text), CODE), &checks(&read(&respelled), CODE), &text);
    });
}

/// A dwell in two parts is the dwell.
#[test]
fn a_dwell_divided_in_two_is_the_same_dwell() {
    each(4..6, |drawn, draws| {
        let parts = cycle(drawn, draws);
        let mut divided = parts.clone();
        divided[1] =
            "[[motion]]\nlaw = \"dwell\"\ntime = \"0.2 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"0.4 s\"\n".to_owned();
        let text = |parts: &[String]| drawn.project(&parts.concat(), BEARING, REQUIREMENTS);
        same(&checks(&read(&text(&parts)), CODE), &checks(&read(&text(&divided)), CODE), &text(&parts));
    });
}

/// A balanced load runs backwards as it runs forwards.
#[test]
fn a_mirrored_motion_demands_the_same() {
    each(6..9, |drawn, draws| {
        if drawn.key != "load" {
            return;
        }
        let parts = cycle(drawn, draws);
        let mirrored: Vec<String> = parts
            .iter()
            .map(|part| {
                if part.contains("\"-") {
                    part.replace("\"-", "\"")
                } else {
                    part.replace("distance = \"", "distance = \"-")
                }
            })
            .collect();
        let text = |parts: &[String]| drawn.project(&parts.concat(), BEARING, REQUIREMENTS);
        same(&checks(&read(&text(&parts)), CODE), &checks(&read(&text(&mirrored)), CODE), &text(&parts));
    });
}

/// The record of a check says the same in both languages but for its words.
#[test]
fn the_language_changes_no_number() {
    each(9..10, |drawn, draws| {
        let text = drawn.project(&cycle(drawn, draws).concat(), BEARING, REQUIREMENTS);
        let found = checks(&read(&text), CODE);
        let [en, de] = [Language::En, Language::De].map(|language| {
            let of = |check: &Check| {
                let record = questions::answer::check(check, language);
                (record.id, record.value, record.limit, record.utilisation)
            };
            found.iter().map(|check| format!("{:?}", of(check))).collect::<Vec<_>>()
        });
        assert_eq!(en, de);
    });
}

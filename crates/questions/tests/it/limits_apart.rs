//! A value that exceeds its limit is written differently from the limit, by however little.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use configurator::Unmet;
use quantities::{Language, Length, Mass, Measure};
use questions::texts::{by_importance, compared_texts};
use questions::{Amount, Check, Verdict};
use words::unmet_text;

const TEXT: &str = "format = 1\n[load]\ninertia = \"0.4 kg m^2\"\nfriction_torque = \"3 N m\"\n\
    [[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.4 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"0.6 s\"\n";

/// Every check of an actuator with a value and a limit, made to fail by an excess of one in 10⁴ to one in 10⁷.
#[test]
fn a_check_that_fails_shows_two_numbers() {
    let project = questions::read(TEXT).unwrap();
    let sizing = questions::size(&project);
    let (mut seen, mut more) = (0, 0);
    for candidate in sizing.candidates.iter().step_by(23) {
        for check in by_importance(&candidate.judgement.checks) {
            let Some(limit) = check.limit.filter(|limit| limit.si != 0.0 && check.value.is_some()) else { continue };
            for excess in [1e-4, 3e-5, 1e-6, 1e-7] {
                let value = Amount { si: limit.si * (1.0 + excess), ..limit };
                let beyond = Check { verdict: Verdict::Fail, value: Some(value), ..check.clone() };
                for language in [Language::En, Language::De] {
                    let [value, limit] = compared_texts(&beyond, language);
                    assert!(value != limit, "{:?} {value} {limit}", check.id);
                    more += u32::from(value.len() > 7);
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 500 && more > 100, "{seen} {more}");
}

/// Size and mass of an actuator beside those that the project permits.
#[test]
fn a_requirement_that_is_not_met_shows_two_numbers() {
    for excess in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7] {
        for base in [0.027, 0.0123, 1.9, 41.3] {
            let (large, small) = (base * (1.0 + excess), base);
            let unmet = [
                Unmet::HollowShaft { has: Length::from_si(small), needs: Length::from_si(large) },
                Unmet::Length { has: Length::from_si(large), permits: Length::from_si(small) },
                Unmet::Mass { has: Mass::from_si(large), permits: Mass::from_si(small) },
            ];
            for (unmet, language) in unmet.iter().flat_map(|unmet| [(unmet, Language::En), (unmet, Language::De)]) {
                let text = unmet_text(unmet, language);
                let numbers: Vec<&str> =
                    text.split(' ').filter(|word| word.starts_with(|c: char| c.is_ascii_digit())).collect();
                assert!(numbers.len() == 2 && numbers[0] != numbers[1], "{text}");
            }
        }
    }
}

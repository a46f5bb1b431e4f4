//! Properties over every code of the grammar, 30 720 of them.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test fails loudly"
)]

use order_code::{
    Brake, CodeError, Departure, Feedback, Field, Option1, Option2, OrderCode, Pattern, Ratio, Size, Slot, Winding,
    parse,
};

fn every_code() -> Vec<OrderCode> {
    let mut codes = Vec::new();
    for &size in Size::ALL {
        for &ratio in Ratio::ALL {
            for &winding in Winding::ALL {
                for &feedback in Feedback::ALL {
                    for brake in [Brake::Without, Brake::With] {
                        for option_1 in [None, Some(Option1::EC)] {
                            for option_2 in [None, Some(Option2::K), Some(Option2::R), Some(Option2::S)] {
                                for special in [false, true] {
                                    codes.push(OrderCode {
                                        size,
                                        ratio,
                                        winding,
                                        feedback,
                                        brake,
                                        option_1,
                                        option_2,
                                        special,
                                    });
                                }
                            }
                        }
                    }
                }
            }
        }
    }
    assert_eq!(codes.len(), 30_720);
    codes
}

/// What is left of a spelling when only letters and digits count.
fn bare(text: &str) -> String {
    text.chars().filter(|c| c.is_ascii_alphanumeric()).collect::<String>().to_ascii_uppercase()
}

#[test]
fn printing_and_reading_are_inverse() {
    for code in every_code() {
        let text = code.to_string();
        let parsed = parse(&text).unwrap();
        assert_eq!(parsed.code, code);
        assert!(parsed.is_canonical(), "{text}: {:?}", parsed.departures);
        let joined: Vec<&str> = parsed.spans.iter().map(|(_, span)| &text[span.clone()]).collect();
        assert_eq!(joined.join("-"), text, "the spans cover the text");
    }
}

#[test]
fn loose_spellings_mean_the_same_code_and_are_reported() {
    for code in every_code() {
        let text = code.to_string();
        for loose in [
            text.to_lowercase(),
            text.replace('-', " "),
            text.replace('-', ""),
            text.replace('-', " - "),
            text.replace('-', "–"),
            format!(" {text}\n"),
        ] {
            let parsed = parse(&loose).unwrap_or_else(|faults| panic!("{loose}: {faults}"));
            assert_eq!(parsed.code, code, "{loose}");
            assert!(!parsed.is_canonical(), "{loose} was accepted silently");
        }
    }
}

#[test]
fn one_wrong_letter_never_becomes_another_code() {
    let letters = "ABCEHKLMNPRSX0123458-* ";
    for code in every_code().into_iter().step_by(61) {
        let text = code.to_string();
        let characters: Vec<char> = text.chars().collect();
        let mut mutants: Vec<String> = Vec::new();
        for index in 0..characters.len() {
            let mut shorter = characters.clone();
            shorter.remove(index);
            mutants.push(shorter.into_iter().collect());
            for letter in letters.chars() {
                let mut changed = characters.clone();
                changed[index] = letter;
                mutants.push(changed.iter().collect());
                let mut longer = characters.clone();
                longer.insert(index, letter);
                mutants.push(longer.into_iter().collect());
            }
            if index > 0 {
                let mut swapped = characters.clone();
                swapped.swap(index - 1, index);
                mutants.push(swapped.into_iter().collect());
            }
        }
        for mutant in mutants {
            match parse(&mutant) {
                Ok(parsed) => assert_eq!(bare(&parsed.code.to_string()), bare(&mutant), "{mutant}"),
                Err(faults) => {
                    assert!(faults.iter().count() > 0);
                    for fault in faults.iter() {
                        assert!(mutant.get(fault.span()).is_some(), "{mutant}: {fault:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn every_fault_at_once_with_its_place() {
    let faults = parse("CHA-21A-101-H-C1025").unwrap_err();
    let found: Vec<(std::ops::Range<usize>, Option<&str>)> =
        faults.iter().map(|fault| (fault.span(), fault.nearest())).collect();
    assert_eq!(found.len(), 3, "{found:?}");
    assert_eq!(found[0].0, 4..7);
    assert!(found[0].1.is_some());
    assert_eq!(found[1], (8..11, Some("100")));
    assert_eq!(found[2], (14..19, Some("C1024")));
}

#[test]
fn faults_are_named() {
    let first = |text: &str| parse(text).unwrap_err().iter().next().cloned().unwrap();
    assert_eq!(first(""), CodeError::Empty);
    assert_eq!(first("  "), CodeError::Empty);
    assert!(matches!(first("20A-100-H-C1024"), CodeError::Missing { field: Field::Series, at: 0 }));
    assert!(matches!(first("CHA-20-100-H-C1024"), CodeError::UnknownToken { field: Field::Size, .. }));
    assert_eq!(first("CHA-20-100-H-C1024").nearest(), Some("20A"));
    assert!(matches!(first("CHA-20A-100-H"), CodeError::Missing { field: Field::Feedback, .. }));
    assert!(matches!(first("CHA-20A-100-H-C1024-"), CodeError::EmptyPart { .. }));
    assert!(matches!(first("CHA--20A-100-H-C1024"), CodeError::EmptyPart { .. }));
    assert!(matches!(first("CHA-20A-100-H-C1024-B-B"), CodeError::Repeated { field: Field::Brake, .. }));
    assert!(matches!(first("CHA-20A-100-H-C1024-EC-B"), CodeError::OutOfOrder { field: Field::Brake, .. }));
    assert!(matches!(first("CHA-20A-100-C1024-H"), CodeError::Missing { field: Field::Winding, .. }));
    assert!(matches!(first(&"C".repeat(65)), CodeError::TooLong { .. }));
    assert!(matches!(first("CHA-20A-100-H-C1024-*"), CodeError::UnknownToken { .. }));
}

#[test]
fn departures_say_what_was_written() {
    let parsed = parse("cha 20a100-H-C1024").unwrap();
    assert!(parsed.departures.contains(&Departure::LowerCase { span: 0..3 }));
    assert!(parsed.departures.contains(&Departure::Separator { span: 3..4 }));
    assert!(parsed.departures.contains(&Departure::MissingHyphen { at: 7 }));
}

#[test]
fn patterns_allow_exactly_their_codes() {
    let pattern = Pattern::parse("CHA-20A-100-H-*").unwrap();
    assert_eq!(pattern.size, Slot::Exactly(Size::S20A));
    assert_eq!(every_code().iter().filter(|code| pattern.matches(code)).count(), 5 * 2 * 2 * 4 * 2);
    let all = every_code();
    assert_eq!(all.iter().filter(|code| Pattern::parse("").unwrap().matches(code)).count(), all.len());
    let braked = Pattern::parse("CHA-*-100-*-M512P-B").unwrap();
    assert!(all.iter().filter(|code| braked.matches(code)).all(|code| code.brake == Brake::With));
    assert!(Pattern::parse("CHA-?").is_err());
    assert!(Pattern::parse("CHA-20B").is_err());
}

#[test]
fn no_text_makes_it_panic() {
    let pieces =
        ["CHA", "-", "20A", " ", "100", "H", "*", "C1024", "é", "\u{0}", "–", "B", "EC", "K", "SP", "ß", "∞", "\t"];
    let mut state: u64 = 7;
    for _ in 0..50_000 {
        let mut text = String::new();
        for _ in 0..state % 12 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            text.push_str(pieces[usize::try_from(state >> 33).unwrap() % pieces.len()]);
        }
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        for faults in [parse(&text).err(), Pattern::parse(&text).err()].into_iter().flatten() {
            for fault in faults.iter() {
                assert!(text.get(fault.span()).is_some(), "{text:?}: {fault:?}");
                let _ = (fault.nearest(), fault.expected(), fault.to_string());
            }
        }
    }
}

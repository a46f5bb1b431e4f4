//! Properties over every code of the grammar, 30 720 of them.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test fails loudly"
)]

use crate::codes;

use codes::every_code;
use order_code::{Brake, Departure, OrderCode, Pattern, Series, Size, Slot, parse};
use std::collections::BTreeSet;

/// Characters that no word contains: first letters that turn into one of a word when made small or capital (long s, Kelvin sign, dotless
/// i), look-alikes (Cyrillic, full width, Roman), then what is no letter.
const STRANGERS: &str =
    "\u{17f}\u{212a}\u{131}\u{410}\u{421}\u{415}\u{ff12}\u{216c}\u{e9}\u{0}\t\n\u{200b}\u{301}_/.?*";
const WORDS: &str = "ABCEHKLMNPRSX0123458- –";

/// Returns a spelling without separators, in upper case.
fn bare(text: &str) -> String {
    text.trim().chars().filter(|c| !" -–".contains(*c)).collect::<String>().to_ascii_uppercase()
}

/// A text is refused, or it is the code that it spells.
fn hold(text: &str) {
    match parse(text) {
        Ok(parsed) => {
            let canonical = parsed.code.to_string();
            assert_eq!(bare(&canonical), bare(text), "{text:?}");
            assert_eq!(parsed.is_canonical(), canonical == text, "{text:?}: {:?}", parsed.departures);
            for (field, span) in &parsed.spans {
                assert_eq!(text[span.clone()].to_ascii_uppercase(), parsed.code.token(*field).unwrap(), "{text:?}");
            }
            for span in parsed.departures.iter().filter_map(Departure::span) {
                assert!(text.get(span).is_some(), "{text:?}: {:?}", parsed.departures);
            }
        }
        Err(faults) => {
            assert!(faults.iter().next().is_some(), "{text:?}");
            for fault in &faults {
                assert!(text.get(fault.span()).is_some(), "{text:?}: {fault:?}");
                let (expected, nearest) = (fault.expected(), fault.nearest());
                assert!(nearest.is_none_or(|near| expected.contains(&near)), "{text:?}: {fault:?}");
                assert!(!fault.to_string().chars().any(char::is_control), "{text:?}: {fault}");
            }
        }
    }
    if let Err(faults) = Pattern::parse(text) {
        assert!(faults.iter().next().is_some(), "{text:?}");
        assert!(faults.iter().all(|fault| text.get(fault.span()).is_some()), "{text:?}: {faults:?}");
    }
}

#[test]
fn printing_and_reading_are_inverse() {
    let mut texts = BTreeSet::new();
    for code in every_code() {
        let text = code.to_string();
        let parsed = parse(&text).unwrap();
        assert_eq!(parsed.code, code);
        assert!(parsed.is_canonical(), "{text}: {:?}", parsed.departures);
        let joined: Vec<&str> = parsed.spans.iter().map(|(_, span)| &text[span.clone()]).collect();
        assert_eq!(joined.join("-"), text, "the spans cover the text");
        texts.insert(text);
    }
    assert_eq!(texts.len(), every_code().len(), "no two codes print alike");
}

/// Without hyphens, too: no code can be read in two ways, and no two codes look alike.
#[test]
fn loose_spellings_mean_the_same_code_and_are_reported() {
    let mut glued = BTreeSet::new();
    for (index, code) in every_code().into_iter().enumerate() {
        let text = code.to_string();
        let hyphens = text.matches('-').count();
        let count = |loose: &str, wanted: fn(&Departure) -> bool| {
            let parsed = parse(loose).unwrap_or_else(|faults| panic!("{loose}: {faults}"));
            assert_eq!(parsed.code, code, "{loose}");
            let (of_kind, others): (Vec<_>, Vec<_>) = parsed.departures.into_iter().partition(wanted);
            assert!(others.is_empty(), "{loose}: {others:?}");
            of_kind.len()
        };
        let with_letters = text.split('-').filter(|token| token.contains(|c: char| c.is_ascii_alphabetic())).count();
        assert_eq!(count(&text.to_lowercase(), |d| matches!(d, Departure::LowerCase { .. })), with_letters);
        // Every code with the common spellings, every eleventh with the rare ones.
        let rare = if index % 11 == 0 { usize::MAX } else { 1 };
        for spaces in [" ", " - ", "- ", " -", "   ", "\u{a0}"].into_iter().take(rare) {
            let loose = text.replace('-', spaces);
            assert_eq!(count(&loose, |d| matches!(d, Departure::Spaces { .. })), hyphens);
        }
        for dash in ["–", "—", "‐", "‑", "‒", "―", "−"].into_iter().take(rare) {
            assert_eq!(count(&text.replace('-', dash), |d| matches!(d, Departure::OtherDash { .. })), hyphens);
        }
        let without = text.replace('-', "");
        assert_eq!(count(&without, |d| matches!(d, Departure::MissingHyphen { .. })), hyphens);
        assert!(glued.insert(without), "{text}");
        for around in [format!(" {text}"), format!("{text}\r\n"), format!("\t{text} ")].into_iter().take(rare) {
            assert_eq!(count(&around, |d| *d == Departure::SurroundingSpace), 1);
        }
    }
}

#[test]
fn one_hyphen_missing_at_any_place_is_reported_there() {
    for code in every_code().into_iter().step_by(7) {
        let text = code.to_string();
        for (at, _) in text.match_indices('-') {
            let loose = format!("{}{}", &text[..at], &text[at + 1..]);
            let parsed = parse(&loose).unwrap();
            assert_eq!((parsed.code, parsed.departures), (code, vec![Departure::MissingHyphen { at }]), "{loose}");
        }
    }
}

#[test]
fn one_wrong_letter_never_becomes_another_code() {
    // A step that shares no factor with the counts of the fields, so that each field takes all its values.
    for code in every_code().into_iter().step_by(1_237) {
        let characters: Vec<char> = code.to_string().chars().collect();
        for index in 0..=characters.len() {
            let (before, after) = characters.split_at(index);
            let spell = |middle: &[char], rest: usize| {
                before.iter().chain(middle).chain(after.iter().skip(rest)).collect::<String>()
            };
            hold(&spell(&[], 1));
            for letter in WORDS.chars().chain(STRANGERS.chars()) {
                hold(&spell(&[letter], 0));
                hold(&spell(&[letter], 1));
            }
            if let [first, second, ..] = after {
                hold(&spell(&[*second, *first], 2));
            }
        }
    }
}

#[test]
fn a_stranger_is_always_refused() {
    for code in every_code().into_iter().step_by(977) {
        let text = code.to_string();
        for at in 0..=text.len() {
            for stranger in STRANGERS.chars() {
                let outside = (at == 0 || at == text.len()) && stranger.is_whitespace();
                let wrong = format!("{}{stranger}{}", &text[..at], &text[at..]);
                assert_eq!(parse(&wrong).is_ok(), outside, "{wrong:?}");
            }
        }
    }
}

#[test]
fn two_words_swapped_are_refused_without_calling_any_missing() {
    for code in every_code().into_iter().step_by(131) {
        let text = code.to_string();
        let words: Vec<&str> = text.split('-').collect();
        for index in 1..words.len() {
            let mut swapped = words.clone();
            swapped.swap(index - 1, index);
            for separator in ["-", " "] {
                let wrong = swapped.join(separator);
                let faults = parse(&wrong).unwrap_err();
                let kinds: Vec<String> = faults.iter().map(ToString::to_string).collect();
                assert!(matches!(kinds.as_slice(), [only] if only.contains("wrong place")), "{wrong}: {kinds:?}");
            }
        }
    }
}

#[test]
fn a_word_twice_is_refused_wherever_it_is_repeated() {
    for code in every_code().into_iter().step_by(131) {
        let text = code.to_string();
        let words: Vec<&str> = text.split('-').collect();
        for index in 0..words.len() {
            for at in index + 1..=words.len() {
                let mut twice = words.clone();
                twice.insert(at, words[index]);
                let wrong = twice.join("-");
                let kinds: Vec<String> = parse(&wrong).unwrap_err().iter().map(ToString::to_string).collect();
                assert!(matches!(kinds.as_slice(), [only] if only.contains("given twice")), "{wrong}: {kinds:?}");
            }
        }
    }
}

#[test]
fn a_word_left_out_is_missing_there_or_was_optional() {
    for code in every_code().into_iter().step_by(131) {
        let text = code.to_string();
        let words: Vec<&str> = text.split('-').collect();
        for index in 0..words.len() {
            let mut fewer = words.clone();
            fewer.remove(index);
            let shorter = fewer.join("-");
            match parse(&shorter) {
                Ok(_) => assert!(index > 4, "{shorter}"),
                Err(faults) => {
                    assert!(index <= 4, "{shorter}");
                    let kinds: Vec<String> = faults.iter().map(ToString::to_string).collect();
                    assert!(matches!(kinds.as_slice(), [only] if only.contains("missing")), "{shorter}: {kinds:?}");
                }
            }
        }
    }
}

struct Dice(u64);

impl Dice {
    fn below(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap() % sides
    }
}

#[test]
fn no_text_makes_it_panic() {
    let pieces = [
        "CHA", "-", "20A", " ", "100", "H", "*", "C1024", "é", "\u{0}", "–", "B", "EC", "K", "SP", "RES", "ß", "∞",
        "\t", "S", "P", "cha", "M5", "\u{feff}",
    ];
    let mut dice = Dice(7);
    for _ in 0..15_000 {
        let text: String = (0..dice.below(12)).map(|_| pieces[dice.below(pieces.len())]).collect();
        hold(&text);
        let bytes: Vec<u8> = (0..dice.below(24)).map(|_| u8::try_from(dice.below(256)).unwrap()).collect();
        hold(&String::from_utf8_lossy(&bytes));
    }
    for word in ["CHA", "RES", "EC", "S", "-", "*", " ", "é", "–"] {
        for times in [1, 2, 16, 21, 32, 64, 65, 10_000] {
            hold(&word.repeat(times));
        }
    }
}

#[test]
fn patterns_allow_exactly_their_codes() {
    let all = every_code();
    let allowed = |text: &str| {
        let pattern = Pattern::parse(text).unwrap();
        all.iter().filter(|code| pattern.matches(code)).collect::<Vec<&OrderCode>>()
    };
    for open in ["", "  ", "*", "CHA", "CHA-*", "CHA-*-*-*-*-*-*-*-*", "*-*"] {
        assert_eq!(allowed(open).len(), all.len(), "{open}");
    }
    for text in ["CHA-20A-100-H-*", "CHA-20A-100-H", "cha 20a 100 h", "CHA20A100H", "*-20A-100-H"] {
        assert_eq!(Pattern::parse(text).unwrap().size, Slot::Exactly(Size::of(Series::default(), "20A").unwrap()));
        assert_eq!(allowed(text).len(), 5 * 2 * 2 * 4 * 2, "{text}");
    }
    assert_eq!(allowed("CHA-20A-100-H-C1024").len(), 32);
    assert_eq!(allowed("CHA-20A-100-H-C1024-B").len(), 16);
    assert_eq!(allowed("CHA-20A-100-H-C1024-*-EC").len(), 16);
    assert_eq!(allowed("CHA-20A-100-H-C1024-SP").len(), 16);
    let braked = allowed("CHA-*-100-*-M512P-B");
    assert_eq!(braked.len(), 8 * 4 * 2 * 4 * 2);
    assert!(braked.iter().all(|code| code.brake == Brake::With));
    for wrong in [
        "CHA-?",
        "?",
        "CHA-20B",
        "CHA-20A*",
        "CHA-2*",
        "CHA-20A-",
        "-",
        "CHA--20A",
        "20A",
        "CHA-100",
        "CHA-.*",
        "CHA-*-*-*-*-*-*-*-*-*",
    ] {
        assert!(Pattern::parse(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn every_code_is_a_pattern_that_allows_it() {
    for code in every_code() {
        assert!(Pattern::parse(&code.to_string()).unwrap().matches(&code), "{code}");
    }
}

//! Every unit, in each of its spellings and with each prefix, read back: the prefix multiplies, or the text is no unit.

#![allow(clippy::panic, clippy::string_slice, clippy::indexing_slicing, reason = "a test may fail")]

use quantities::unit::ALL;
use quantities::{Unit, parse};

/// Prefixes of the SI and their factors (SI brochure, 9th edition, table 7).
const PREFIXES: [(&str, f64); 12] = [
    ("G", 1e9),
    ("M", 1e6),
    ("k", 1e3),
    ("h", 1e2),
    ("da", 1e1),
    ("d", 1e-1),
    ("c", 1e-2),
    ("m", 1e-3),
    ("u", 1e-6),
    ("µ", 1e-6),
    ("n", 1e-9),
    ("p", 1e-12),
];

#[test]
fn every_spelling_reads_back() {
    // The one of a ratio is written without a unit.
    for unit in ALL.iter().filter(|unit| unit.ascii != "1") {
        for spelling in unit.spellings() {
            for value in [1.0, 1.5, -2.25, 4e-3] {
                let text = format!("{value:e} {spelling}");
                let reading = parse(unit.dimension, &text).unwrap_or_else(|fault| panic!("{text}: {fault}"));
                assert_eq!((reading.unit, reading.value), (*unit, value), "{text}");
                assert_eq!(reading.si.to_bits(), unit.to_si(value).to_bits(), "{text}");
            }
        }
    }
}

/// A prefix in front of a factor above the fraction multiplies the value by its own, to the power of the factor.
#[test]
fn a_prefix_multiplies_or_makes_no_unit() {
    let mut read = 0;
    for unit in ALL.iter().filter(|unit| unit.to_si(0.0) == 0.0) {
        // The spelling of project files has a space between factors.
        for spelling in [unit.ascii] {
            let above = spelling.find('/').unwrap_or(spelling.len());
            for (place, sign) in spelling.char_indices().take_while(|(place, _)| *place < above) {
                let before = spelling[..place].chars().next_back();
                // Factors begin after a space; the digit of a power of ten precedes one too.
                let begins = sign.is_alphabetic() && before.is_none_or(|before| before == ' ');
                if !begins || spelling.starts_with("GD") {
                    continue;
                }
                let factor = spelling[place..above].split(' ').next().unwrap_or_default();
                let power = match factor.trim_start_matches(char::is_alphabetic) {
                    "" => 1,
                    "^2" | "²" => 2,
                    "^3" | "³" => 3,
                    "^-1" | "⁻¹" => -1,
                    _ => continue,
                };
                for (prefix, size) in PREFIXES {
                    let text = format!("{}{prefix}{}", &spelling[..place], &spelling[place..]);
                    // The German word for a degree.
                    if text.contains("Grad") {
                        continue;
                    }
                    let Some(found) = Unit::of_dimension(unit.dimension, &text) else { continue };
                    let expected = unit.to_si(1.0) * size.powi(power);
                    let value = found.to_si(1.0);
                    assert!(
                        (value - expected).abs() <= 1e-13 * expected,
                        "{text} is {found:?}, {value} for {expected}"
                    );
                    read += 1;
                }
            }
        }
    }
    assert!(read > 60, "{read}");
}

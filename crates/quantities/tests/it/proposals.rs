//! A proposed unit keeps the meaning of the text: no prefix, power or quantity changes.

use quantities::unit::ALL;
use quantities::{Dimension, Unit};
use std::collections::BTreeMap;

const PREFIXES: [(&str, f64); 17] = [
    ("", 1.0),
    ("E", 1e18),
    ("P", 1e15),
    ("T", 1e12),
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
    ("f", 1e-15),
];

fn proposed(dimension: Dimension, text: &str) -> Option<f64> {
    if Unit::of_dimension(dimension, text).is_some() {
        return None;
    }
    Unit::nearest(dimension, text).map(|unit| unit.to_si(1.0) - unit.to_si(0.0))
}

fn is_near(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-9 * expected.abs()
}

/// A unit with any prefix is proposed with its own value or not at all.
#[test]
fn no_proposal_changes_a_prefix() {
    use Dimension::*;
    for (dimension, base, si) in [
        (Torque, "Nm", 1.0),
        (Torque, "N m", 1.0),
        (Torque, "N·mm", 1e-3),
        (Force, "N", 1.0),
        (Time, "s", 1.0),
        (Time, "sec", 1.0),
        (Length, "m", 1.0),
        (Length, "in", 0.0254),
        (Mass, "g", 1e-3),
        (Mass, "t", 1e3),
        (Angle, "rad", 1.0),
        (Angle, "deg", 0.017_453_292_519_943_295),
        (Voltage, "V", 1.0),
        (EffectiveVoltage, "V", 1.0),
        (Current, "A", 1.0),
        (Power, "W", 1.0),
        (Energy, "J", 1.0),
        (Frequency, "Hz", 1.0),
        (Pressure, "Pa", 1.0),
        (Pressure, "bar", 1e5),
        (Resistance, "ohm", 1.0),
        (Inductance, "H", 1.0),
        (MomentOfInertia, "g m^2", 1e-3),
        (MomentOfInertia, "g cm^2", 1e-7),
        (Velocity, "m/s", 1.0),
        (Acceleration, "m/s^2", 1.0),
        (AngularVelocity, "rad/s", 1.0),
        (AngularVelocity, "rpm", 0.104_719_755_119_659_77),
        (AngularAcceleration, "rad/s^2", 1.0),
        (TorsionalStiffness, "N m/rad", 1.0),
        (TorqueConstant, "N m/A", 1.0),
        (Lead, "m/rev", 1.0),
    ] {
        for (prefix, factor) in PREFIXES {
            for text in [format!("{prefix}{base}"), format!("{prefix}{base}").to_uppercase()] {
                let is_plain = text == format!("{prefix}{base}");
                if let Some(found) = proposed(dimension, &text) {
                    // In upper case a letter may be lost, the size of a prefix never.
                    let expected = match prefix {
                        _ if is_plain => factor * si,
                        "M" | "m" => 1e6 * si,
                        _ => found,
                    };
                    assert!(
                        is_near(found, expected),
                        "{text} as {dimension:?}: proposed {found:e}, written {expected:e}"
                    );
                }
            }
        }
    }
}

/// A unit of another quantity is never turned into one of the quantity expected.
#[test]
fn no_proposal_changes_the_quantity() {
    for dimension in Dimension::ALL {
        for unit in ALL.iter().filter(|unit| unit.dimension != *dimension) {
            for spelling in unit.spellings() {
                if let Some(found) = proposed(*dimension, spelling) {
                    let written = unit.to_si(1.0) - unit.to_si(0.0);
                    assert!(
                        is_near(found, written),
                        "{spelling} as {dimension:?}: proposed {found:e}, written {written:e}"
                    );
                }
            }
        }
    }
}

/// Returns products of units with their prefixes: text without signs of products, with value and quantity.
fn products() -> BTreeMap<String, Vec<(f64, String)>> {
    const SYMBOLS: [(&str, f64, &str); 14] = [
        ("N", 1.0, "N"),
        ("m", 1.0, "m"),
        ("s", 1.0, "s"),
        ("g", 1e-3, "kg"),
        ("rad", 1.0, "rad"),
        ("V", 1.0, "V"),
        ("A", 1.0, "A"),
        ("W", 1.0, "W"),
        ("J", 1.0, "J"),
        ("Hz", 1.0, "Hz"),
        ("Pa", 1.0, "Pa"),
        ("H", 1.0, "H"),
        ("ohm", 1.0, "ohm"),
        ("min", 60.0, "s"),
    ];
    let mut singles = Vec::new();
    for (prefix, factor) in PREFIXES {
        for (name, si, of) in SYMBOLS {
            for (power, sign) in [(1, ""), (2, "2")] {
                if name != "min" || prefix.is_empty() {
                    singles.push((format!("{prefix}{name}{sign}"), (factor * si).powi(power), format!("{of}{power}")));
                }
            }
        }
    }
    let mut found: BTreeMap<String, Vec<(f64, String)>> = BTreeMap::new();
    let mut put = |text: String, value: f64, of: String| found.entry(text).or_default().push((value, of));
    for (text, value, of) in &singles {
        put(text.clone(), *value, of.clone());
        for (second, factor, other) in &singles {
            put(format!("{text}{second}"), value * factor, format!("{of}{other}"));
            put(format!("{text}/{second}"), value / factor, format!("{of}/{other}"));
        }
    }
    found
}

/// Every spelling with random edits: a text that reads as a product of prefixes and units is proposed with that value
/// or not at all.
#[test]
fn a_proposal_for_a_corrupted_spelling_keeps_its_value() {
    let products = products();
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = |most: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        usize::try_from(state % most as u64).unwrap()
    };
    let letters: Vec<char> = "NmMkKcdhunpgsradVAWJHzPaohinlbftUeEGT/2 ·^-".chars().collect();
    let (mut read, mut made) = (0, 0);
    for _ in 0..15_000 {
        let unit = ALL[next(ALL.len())];
        let spellings: Vec<&str> = unit.spellings().collect();
        let mut signs: Vec<char> = spellings[next(spellings.len())].chars().collect();
        for _ in 0..=next(2) {
            let place = next(signs.len().max(1));
            let sign = letters[next(letters.len())];
            match next(5) {
                0 if signs.len() > 1 => drop(signs.remove(place)),
                1 => signs.insert(place, sign),
                2 if place + 1 < signs.len() => signs.swap(place, place + 1),
                3 => {
                    signs[place] = if signs[place].is_lowercase() {
                        signs[place].to_ascii_uppercase()
                    } else {
                        signs[place].to_ascii_lowercase()
                    }
                }
                _ => signs[place] = sign,
            }
        }
        let text: String = signs.into_iter().collect();
        let Some(found) = proposed(unit.dimension, &text) else { continue };
        made += 1;
        // With signs of products there are fewer meanings.
        if text.contains([' ', '·', '-']) {
            continue;
        }
        let bare = text.replace('^', "");
        let Some(meant) = products.get(&bare) else { continue };
        read += 1;
        assert!(
            meant.iter().any(|(value, _)| is_near(found, *value)),
            "{text} as {:?}: proposed {found:e}, written {meant:?}",
            unit.dimension
        );
    }
    assert!(made > 500 && read > 5, "{made} proposals, {read} of them products");
}

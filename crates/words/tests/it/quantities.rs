//! Messages for a text that is no quantity, in both languages.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use quantities::{Dimension, Language, QuantityError, parse};
use words::{quantity_fault, quantity_hint};

fn fault(dimension: Dimension, text: &str) -> QuantityError {
    match parse(dimension, text) {
        Err(fault) => fault,
        Ok(reading) => panic!("{text:?} reads as {reading:?}"),
    }
}

#[test]
fn messages_and_hints_speak_both_languages() {
    let units_en =
        "units of torque: N m, kN m, daN m, mN m, N cm, cN m, N mm, lbf in, lbf ft, ozf in, kgf m, kgf cm, gf cm";
    let units_de = "Einheiten für Drehmoment: N m, kN m, daN m, mN m, N cm, cN m, N mm, lbf in, lbf ft, ozf in, kgf m, kgf cm, gf cm";
    for (text, message, hint) in [
        (
            "",
            ["empty, expected a torque such as \"5 N m\"", "leer: erwartet wird ein Drehmoment, zum Beispiel „5 N m“"],
            [units_en, units_de],
        ),
        (
            "N m",
            [
                "the number is missing before \"N m\", expected a torque such as \"5 N m\"",
                "vor „N m“ fehlt die Zahl: erwartet wird ein Drehmoment, zum Beispiel „5 N m“",
            ],
            [units_en, units_de],
        ),
        (
            "1 000 Nm",
            ["\"1 000\" is not a number", "„1 000“ ist keine Zahl"],
            [
                "write digits without separators of thousands, for example \"5 N m\"",
                "Ziffern ohne Tausendertrennzeichen schreiben, zum Beispiel „5 N m“",
            ],
        ),
        (
            "1,5 Nm",
            ["decimal comma in \"1,5\"", "Dezimalkomma in „1,5“"],
            ["write a decimal point: 1.5", "mit Dezimalpunkt schreiben: 1.5"],
        ),
        (
            "1,500 Nm",
            ["decimal comma in \"1,500\"", "Dezimalkomma in „1,500“"],
            [
                "write a decimal point: 1.500; or, without thousands separator: 1500",
                "mit Dezimalpunkt schreiben: 1.500; oder ohne Tausendertrennzeichen: 1500",
            ],
        ),
        (
            "-,5 Nm",
            ["decimal comma in \"-,5\"", "Dezimalkomma in „-,5“"],
            ["write a decimal point: -0.5", "mit Dezimalpunkt schreiben: -0.5"],
        ),
        (
            "5",
            [
                "the unit is missing, expected a torque such as \"5 N m\"",
                "die Einheit fehlt: erwartet wird ein Drehmoment, zum Beispiel „5 N m“",
            ],
            [units_en, units_de],
        ),
        ("5 furlong", ["unknown unit \"furlong\"", "unbekannte Einheit „furlong“"], [units_en, units_de]),
        (
            "5 kg",
            [
                "\"kg\" is a unit of mass, expected a unit of torque",
                "„kg“ ist eine Einheit der Größe Masse, erwartet wird ein Drehmoment",
            ],
            [units_en, units_de],
        ),
    ] {
        let fault = fault(Dimension::Torque, text);
        assert_eq!([quantity_fault(&fault, Language::En), quantity_fault(&fault, Language::De)], message);
        assert_eq!(
            [quantity_hint(&fault, Language::En).unwrap(), quantity_hint(&fault, Language::De).unwrap()],
            hint,
            "{text}"
        );
        assert_eq!(fault.to_string(), message[0]);
    }
    assert_eq!(quantity_fault(&fault(Dimension::Torque, "1e999 Nm"), Language::De), "„1e999“ ist keine endliche Zahl");
    assert_eq!(quantity_hint(&fault(Dimension::Torque, "1e999 Nm"), Language::De), None);
}

#[test]
fn the_nearest_unit_is_reported_with_those_that_are_valid() {
    let fault = fault(Dimension::Force, "5 kn");
    assert_eq!(
        quantity_hint(&fault, Language::En).unwrap(),
        "did you mean \"kN\"? units of force: N, kN, daN, MN, mN, lbf, kgf, gf, ozf"
    );
    assert_eq!(
        quantity_hint(&fault, Language::De).unwrap(),
        "gemeint ist vielleicht „kN“; Einheiten für Kraft: N, kN, daN, MN, mN, lbf, kgf, gf, ozf"
    );
}

#[test]
fn long_texts_make_short_hints() {
    for text in [format!("5 {}", "é".repeat(10_000)), "é".repeat(10_000), format!("1,{}", "5".repeat(10_000))] {
        let fault = fault(Dimension::Torque, &text);
        assert!(quantity_hint(&fault, Language::De).is_some_and(|hint| hint.chars().count() < 150));
    }
}

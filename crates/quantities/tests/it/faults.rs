//! Every fault of a text: its kind, its place, its words.

use quantities::{Dimension, QuantityError, Torque, parse, parse_as};

#[allow(clippy::panic, reason = "part of a test")]
fn fault(dimension: Dimension, text: &str) -> QuantityError {
    match parse(dimension, text) {
        Err(fault) => fault,
        Ok(reading) => panic!("{text:?} reads as {reading:?}"),
    }
}

/// Returns the kind of the fault and the part of the text that it points to.
fn kind_and_place(dimension: Dimension, text: &str) -> (&'static str, &str) {
    let fault = fault(dimension, text);
    let kind = match fault {
        QuantityError::Empty { .. } => "empty",
        QuantityError::NumberMissing { .. } => "number missing",
        QuantityError::NumberUnreadable { .. } => "number unreadable",
        QuantityError::DecimalComma { .. } => "comma",
        QuantityError::NotFinite { .. } => "not finite",
        QuantityError::UnitMissing { .. } => "unit missing",
        QuantityError::UnitUnknown { .. } => "unit unknown",
        QuantityError::WrongQuantity { .. } => "wrong quantity",
        QuantityError::FlywheelEffect { .. } => "flywheel effect",
        _ => "new",
    };
    (kind, text.get(fault.span()).unwrap_or("no place in the text"))
}

#[test]
fn quantities_as_people_write_them() {
    for (dimension, text, si) in [
        (Dimension::MomentOfInertia, "1.3 kg m^2", 1.3),
        (Dimension::MomentOfInertia, "1.3kgm²", 1.3),
        (Dimension::MomentOfInertia, "1.12 10^-4 kgm^2", 1.12e-4),
        (Dimension::MomentOfInertia, "1.12 10⁻⁴ kgm²", 1.12e-4),
        (Dimension::MomentOfInertia, "1.12·10⁻⁴ kgm²", 1.12e-4),
        (Dimension::NoLoadCurrentConstant, "6.6 10^-3 A/min^-1", 0.063_025_357_464_390_55),
        (Dimension::Torque, " 5 N m ", 5.0),
        (Dimension::Torque, "+5\u{a0}N\u{a0}m", 5.0),
        (Dimension::Torque, "-5e-1 Nm", -0.5),
        (Dimension::Torque, "−5E+1Nm", -50.0),
        (Dimension::Torque, "5e−1 Nm", 0.5),
        (Dimension::Torque, ".5 Nm", 0.5),
        (Dimension::Torque, "5. Nm", 5.0),
        (Dimension::AngularVelocity, "40 1/min", 4.188_790_204_786_391),
        (Dimension::AngularVelocity, "40 min⁻¹", 4.188_790_204_786_391),
        (Dimension::Temperature, "40 degC", 313.15),
        (Dimension::Temperature, "40 °C", 313.15),
        (Dimension::TemperatureInterval, "40 K", 40.0),
        (Dimension::Ratio, "0.5", 0.5),
        (Dimension::Ratio, "50 %", 0.5),
        (Dimension::Ratio, "500‰", 0.5),
    ] {
        let read = parse(dimension, text).unwrap().si;
        assert!((read - si).abs() <= 1e-14 * si.abs(), "{text}: {read}");
    }
    assert!((parse_as::<Torque>("5 N m").unwrap().value - 5.0).abs() < 1e-15);
    assert_eq!(parse(Dimension::Ratio, "0.5").unwrap().unit.ascii, "1");
}

#[test]
fn every_fault_has_its_kind_and_place() {
    for (text, kind, place) in [
        ("", "empty", ""),
        ("  ", "empty", "  "),
        (" N m ", "number missing", "N m"),
        ("kg", "number missing", "kg"),
        (" five Nm", "number unreadable", "five"),
        ("- 5 Nm", "number unreadable", "-"),
        (". Nm", "number unreadable", "."),
        ("1 000 Nm", "number unreadable", "1 000"),
        ("1\u{202f}000 Nm", "number unreadable", "1\u{202f}000"),
        ("1 000", "number unreadable", "1 000"),
        ("1'000 Nm", "number unreadable", "1'000"),
        ("1_000 Nm", "number unreadable", "1_000"),
        ("1.000.000 Nm", "number unreadable", "1.000.000"),
        ("1.000,5 Nm", "number unreadable", "1.000,5"),
        ("1,000,000 Nm", "number unreadable", "1,000,000"),
        ("5, Nm", "number unreadable", "5,"),
        (" 1,5 Nm", "comma", "1,5"),
        ("1,5e3 Nm", "comma", "1,5e3"),
        ("-1,5", "comma", "-1,5"),
        ("-,5 Nm", "comma", "-,5"),
        ("1e999 Nm", "not finite", "1e999"),
        ("1e308 kNm", "not finite", "1e308"),
        ("NaN Nm", "not finite", "NaN"),
        ("-inf Nm", "not finite", "-inf"),
        ("∞ Nm", "not finite", "∞"),
        ("5", "unit missing", "5"),
        (" 0 ", "unit missing", "0"),
        ("5 Nn", "unit unknown", "Nn"),
        ("5µ Nm", "unit unknown", "µ Nm"),
        ("5 10^-4 Nm", "unit unknown", "10^-4 Nm"),
        ("0x10 Nm", "unit unknown", "x10 Nm"),
        ("5 Nm 3", "unit unknown", "Nm 3"),
        ("5 1", "number unreadable", "5 1"),
        ("5 kg", "wrong quantity", "kg"),
        ("5 N", "wrong quantity", "N"),
        ("40 1/min", "wrong quantity", "1/min"),
    ] {
        assert_eq!(kind_and_place(Dimension::Torque, text), (kind, place), "{text:?}");
    }
    assert_eq!(kind_and_place(Dimension::Ratio, "1 000"), ("number unreadable", "1 000"));
    // A unit that begins with a digit is not part of the number before it.
    assert_eq!(kind_and_place(Dimension::AngularVelocity, "40,5 1/min"), ("comma", "40,5"));
    assert_eq!(kind_and_place(Dimension::MomentOfInertia, "1,12 10^-4 kgm^2"), ("comma", "1,12"));
    assert_eq!(kind_and_place(Dimension::AngularVelocity, "1 000 1/min"), ("number unreadable", "1 000"));
    assert_eq!(kind_and_place(Dimension::AngularVelocity, "1.000,5 1/min"), ("number unreadable", "1.000,5"));
    assert_eq!(kind_and_place(Dimension::AngularVelocity, "401/min"), ("unit unknown", "/min"));
}

#[test]
fn a_misspelt_unit_brings_the_nearest_one() {
    for (dimension, text, near) in [
        (Dimension::Torque, "5 NM", Some("N m")),
        (Dimension::Torque, "5 knm", Some("kN m")),
        (Dimension::Torque, "5 kN mm", Some("N m")),
        (Dimension::Torque, "5 lbf-im", Some("lbf in")),
        (Dimension::AngularVelocity, "40 1/mn", Some("1/min")),
        (Dimension::AngularVelocity, "40 rac/s", Some("rad/s")),
        (Dimension::AngularVelocity, "40/min", Some("1/min")),
        (Dimension::Power, "4 KW", Some("kW")),
        (Dimension::Temperature, "40 C", None),
        // A text that reads as another unit, or whose first letter may be a prefix, gets no proposal.
        (Dimension::Torque, "5 nm", None),
        (Dimension::Torque, "5 Nn", None),
        (Dimension::Torque, "5 MNm", None),
        (Dimension::Torque, "5 MNM", None),
        (Dimension::MomentOfInertia, "1 kgm^3", None),
        (Dimension::MomentOfInertia, "1 kgm", None),
        (Dimension::Length, "1 MM", None),
        (Dimension::Length, "1 U", None),
        (Dimension::Force, "1 mn", None),
        (Dimension::Angle, "90 grad", None),
        (Dimension::Angle, "90 brad", None),
        (Dimension::Lead, "40 mm/rad", None),
        (Dimension::EffectiveVoltage, "400 Vpp", None),
        (Dimension::Torque, "5 q", None),
        (Dimension::Torque, "5 furlong", None),
    ] {
        let QuantityError::UnitUnknown { nearest, .. } = fault(dimension, text) else { panic!("{text}") };
        assert_eq!(nearest.map(|unit| unit.ascii), near, "{text}");
    }
}

#[test]
fn long_texts_make_short_messages() {
    for text in [format!("5 {}", "é".repeat(10_000)), "é".repeat(10_000), format!("1,{}", "5".repeat(10_000))] {
        let fault = fault(Dimension::Torque, &text);
        assert!(fault.to_string().chars().count() < 120, "{fault}");
        assert!(text.get(fault.span()).is_some());
    }
}

#[test]
fn no_text_makes_it_panic() {
    let pieces = [
        "1", ".", "e", "-", "+", ",", " ", "N", "m", "²", "µ", "°", "∞", "\u{0}", "/", "min", "é", "−", "'",
        "\u{202f}", "10^", "⁻", "kg", "Ω", "0", "(", "%", "NaN", "𝟏", "e\u{301}",
    ];
    let mut state: u64 = 1;
    let mut next = move |below: usize| {
        // Knuth's MMIX generator.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 33).unwrap() % below
    };
    for round in 0..30_000 {
        let mut text: String = (0..next(9)).map(|_| pieces[next(pieces.len())]).collect();
        if round % 2 == 0 {
            text.insert_str(0, ["1.5 ", "-2e3", "40 1/"][next(3)]);
        }
        for dimension in [Dimension::AngularVelocity, Dimension::Ratio, Dimension::Temperature] {
            match parse(dimension, &text) {
                Ok(reading) => assert!(reading.si.is_finite() && reading.unit.dimension == dimension, "{text:?}"),
                Err(fault) => {
                    assert!(text.get(fault.span()).is_some(), "{text:?} {fault:?}");
                }
            }
        }
    }
}

/// GD² is four times the moment of inertia: its units are read only where it is named.
#[test]
fn a_flywheel_effect_is_read_by_its_name_only() {
    for (text, place) in
        [("5 kgf m^2", "kgf m^2"), ("5 kp·m²", "kp·m²"), ("5 kgf-cm²", "kgf-cm²"), ("5 gf cm^2", "gf cm^2")]
    {
        assert_eq!(kind_and_place(Dimension::MomentOfInertia, text), ("flywheel effect", place));
    }
    for (text, si) in
        [("5 GD^2 kgf m^2", 1.25), ("5 GD² kgf·m²", 1.25), ("5 GD² kp m²", 1.25), ("5 GD² kgf cm²", 1.25e-4)]
    {
        assert_eq!(parse(Dimension::MomentOfInertia, text).map(|reading| reading.si), Ok(si), "{text}");
    }
}

/// Returns the kind of fault and the text at its place, for every fault of a quantity.
fn all_faults(dimension: Dimension, text: &str) -> Vec<(&'static str, String)> {
    let of = |error: &QuantityError| match error {
        QuantityError::DecimalComma { .. } => "comma",
        QuantityError::NumberUnreadable { .. } => "number",
        QuantityError::UnitUnknown { .. } => "unit",
        QuantityError::UnitMissing { .. } => "no unit",
        QuantityError::WrongQuantity { .. } => "quantity",
        _ => "other",
    };
    let faults = quantities::quantity_faults(dimension, text);
    faults.iter().map(|error| (of(error), text[error.span()].to_owned())).collect()
}

/// A faulty number does not hide what follows it, and every fault keeps its place.
#[test]
fn a_faulty_number_does_not_hide_a_faulty_unit() {
    let units = [
        (" foo", Some("unit")),
        ("foo", Some("unit")),
        (" kg", Some("quantity")),
        (" N m", None),
        (" ± 10 %", Some("no unit")),
    ];
    for (number, kind) in
        [("0,3", "comma"), ("-0,3", "comma"), ("−1,5e3", "comma"), ("1 000", "number"), ("1.000,5", "number")]
    {
        for (unit, fault) in units {
            let text = format!(" {number}{unit}");
            let found = all_faults(Dimension::Torque, &text);
            let kinds: Vec<&str> = found.iter().map(|(kind, _)| *kind).collect();
            assert_eq!(kinds, std::iter::once(kind).chain(fault).collect::<Vec<_>>(), "{text}: {found:?}");
            assert_eq!(found[0].1, number, "{text}");
            if fault.is_some_and(|fault| fault != "no unit") {
                assert_eq!(found[1].1, unit.trim(), "{text}");
            }
        }
    }
    assert_eq!(
        all_faults(Dimension::Torque, "1,5 N m ± 0,1 foo"),
        [("comma", "1,5".to_owned()), ("comma", "0,1".to_owned()), ("unit", "foo".to_owned())]
    );
    assert!(all_faults(Dimension::Torque, "1.5 N m ± 10 %").is_empty());
    assert_eq!(all_faults(Dimension::Torque, "about 5 N m").len(), 1);
}

use super::*;
use crate::units::unit::*;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b.abs().max(1e-300)
}

#[test]
fn factors_against_values_typed_by_hand() {
    for (unit, si) in [
        (&REVOLUTION_PER_MINUTE, 0.104_719_755_119_659_77),
        (&ARCMINUTE, 2.908_882_086_657_216e-4),
        (&ARCSECOND, 4.848_136_811_095_36e-6),
        (&NEWTON_CENTIMETRE, 0.01),
        (&GRAM_SQUARE_CENTIMETRE, 1e-7),
        (&TEN_THOUSANDTH_KILOGRAM_SQUARE_METRE, 1e-4),
        (&YEAR, 31_557_600.0),
        (&STANDARD_GRAVITY, 9.806_65),
        (&DEGREE, 0.017_453_292_519_943_295),
        (&VOLT_PER_THOUSAND_REVOLUTIONS, 1.0 / 104.719_755_119_659_77),
        (&MILLIAMPERE_PER_REVOLUTION_PER_MINUTE, 9.549_296_585_513_72e-3),
        (&NEWTON_METRE_PER_ARCMINUTE, 3_437.746_770_784_939),
        (&KILONEWTON_METRE_PER_RADIAN, 1000.0),
        (&PERCENT, 0.01),
        (&BAR, 1e5),
        (&MILLIHENRY, 1e-3),
        (&TONNE, 1000.0),
    ] {
        assert!(close(unit.to_si(1.0), si), "{}: {} is not {si}", unit.ascii, unit.to_si(1.0));
    }
    assert!(close(DEGREE_CELSIUS.to_si(40.0), 313.15));
}

#[test]
fn every_unit_converts_there_and_back() {
    for unit in ALL {
        for value in [1.0, 0.37, 1234.5] {
            let back = unit.from_si(unit.to_si(value));
            assert!((back - value).abs() <= 1e-12 * value + 1e-10, "{}: {value} -> {back}", unit.ascii);
        }
    }
}

#[test]
fn no_spelling_means_two_units_of_one_dimension() {
    let mut seen: Vec<(Dimension, String, &str)> = Vec::new();
    for unit in ALL {
        let mut own: Vec<String> =
            [unit.ascii, unit.symbol, unit.json].iter().chain(unit.others).map(|text| canonical(text)).collect();
        own.sort();
        own.dedup();
        for spelling in own {
            let clash = seen.iter().find(|(dimension, known, _)| *dimension == unit.dimension && *known == spelling);
            assert!(clash.is_none(), "{spelling} means {} and {:?}", unit.ascii, clash);
            seen.push((unit.dimension, spelling, unit.ascii));
        }
    }
}

#[test]
fn every_dimension_has_a_unit_and_a_readable_example() {
    for unit in ALL {
        let dimension = unit.dimension;
        assert!(!dimension.units().is_empty());
        assert!(crate::parse(dimension, dimension.example()).is_ok(), "{}", dimension.example());
    }
}

#[test]
fn spellings_of_the_tables_are_known() {
    for spelling in [
        "Nm",
        "min^-1",
        "A",
        "10^-3 A/min^-1",
        "10^-4 kgm^2",
        "kgm^2",
        "V",
        "V/1000 min^-1",
        "ohm",
        "mH",
        "ms",
        "s",
        "kg",
        "mm",
        "m",
        "N",
        "Nm/rad",
        "10^3 Nm/rad",
        "Nm/arcmin",
        "arcmin",
        "arcsec",
        "rad",
        "degC",
        "mA",
        "uA",
        "kHz",
        "W",
        "a",
        "h",
        "%",
        "g",
        "bit",
        "Pa",
        "Mohm",
        "Nm/A",
    ] {
        assert!(Unit::of(spelling).is_some(), "{spelling}");
    }
    assert!(Unit::of("furlong").is_none());
    assert!(Unit::of("").is_none());
}

#[test]
fn case_and_dimension_decide() {
    assert_eq!(Unit::of_dimension(Dimension::Torque, "mNm").unwrap().ascii, "mN m");
    assert!(Unit::of_dimension(Dimension::Torque, "MNm").is_none());
    assert_eq!(Unit::of_dimension(Dimension::Mass, "g").unwrap().ascii, "g");
    assert_eq!(Unit::of_dimension(Dimension::Acceleration, "g").unwrap().dimension, Dimension::Acceleration);
    assert_eq!(Unit::of("kg·m²").unwrap().ascii, "kg m^2");
    assert_eq!(Unit::of("min⁻¹").unwrap().ascii, "1/min");
}

//! Every unit against its factor, typed by hand from its definition: SI brochure (9th edition) for the units of the SI
//! and those accepted beside it, CGPM 1901 for standard gravity, IAU for the Julian year.

use quantities::unit::*;
use quantities::{Dimension, Unit};

/// Unit and its value in SI.
const FACTORS: &[(&Unit, f64)] = &[
    (&NEWTON_METRE, 1.0),
    (&KILONEWTON_METRE, 1000.0),
    (&MILLINEWTON_METRE, 0.001),
    (&NEWTON_CENTIMETRE, 0.01),
    (&NEWTON_MILLIMETRE, 0.001),
    (&REVOLUTION_PER_MINUTE, 0.104_719_755_119_659_77),
    (&RADIAN_PER_SECOND, 1.0),
    (&DEGREE_PER_SECOND, 0.017_453_292_519_943_295),
    (&REVOLUTION_PER_SECOND, std::f64::consts::TAU),
    (&RADIAN_PER_SECOND_SQUARED, 1.0),
    (&RADIAN_PER_SECOND_CUBED, 1.0),
    (&DEGREE_PER_SECOND_CUBED, std::f64::consts::PI / 180.0),
    (&METRE_PER_SECOND_CUBED, 1.0),
    (&DEGREE_PER_SECOND_SQUARED, 0.017_453_292_519_943_295),
    (&KILOGRAM_SQUARE_METRE, 1.0),
    (&TEN_THOUSANDTH_KILOGRAM_SQUARE_METRE, 1e-4),
    (&KILOGRAM_SQUARE_CENTIMETRE, 1e-4),
    (&GRAM_SQUARE_CENTIMETRE, 1e-7),
    (&SECOND, 1.0),
    (&MILLISECOND, 1e-3),
    (&MICROSECOND, 1e-6),
    (&NANOSECOND, 1e-9),
    (&MINUTE, 60.0),
    (&HOUR, 3600.0),
    (&DAY, 86_400.0),
    (&YEAR, 31_557_600.0),
    (&MILLIMETRE, 1e-3),
    (&METRE, 1.0),
    (&CENTIMETRE, 1e-2),
    (&MICROMETRE, 1e-6),
    (&KILOMETRE, 1e3),
    (&SQUARE_MILLIMETRE, 1e-6),
    (&SQUARE_CENTIMETRE, 1e-4),
    (&SQUARE_METRE, 1.0),
    (&KILOGRAM, 1.0),
    (&GRAM, 1e-3),
    (&TONNE, 1e3),
    (&KILOGRAM_PER_CUBIC_METRE, 1.0),
    (&GRAM_PER_CUBIC_CENTIMETRE, 1e3),
    (&KILOGRAM_PER_CUBIC_DECIMETRE, 1e3),
    (&NEWTON, 1.0),
    (&KILONEWTON, 1e3),
    (&MEGANEWTON, 1e6),
    (&MILLINEWTON, 1e-3),
    (&AMPERE, 1.0),
    (&MILLIAMPERE, 1e-3),
    (&MICROAMPERE, 1e-6),
    (&VOLT, 1.0),
    (&MILLIVOLT, 1e-3),
    (&KILOVOLT, 1e3),
    (&OHM, 1.0),
    (&MILLIOHM, 1e-3),
    (&KILOOHM, 1e3),
    (&MEGAOHM, 1e6),
    (&OHM_SQUARE_MILLIMETRE_PER_METRE, 1e-6),
    (&OHM_METRE, 1.0),
    (&MILLIHENRY, 1e-3),
    (&HENRY, 1.0),
    (&MICROHENRY, 1e-6),
    (&DEGREE, 0.017_453_292_519_943_295),
    (&RADIAN, 1.0),
    (&MILLIRADIAN, 1e-3),
    (&ARCMINUTE, 2.908_882_086_657_216e-4),
    (&ARCSECOND, 4.848_136_811_095_36e-6),
    (&REVOLUTION, std::f64::consts::TAU),
    (&WATT, 1.0),
    (&KILOWATT, 1e3),
    (&JOULE, 1.0),
    (&KILOJOULE, 1e3),
    (&WATT_HOUR, 3600.0),
    (&DEGREE_CELSIUS, 274.15),
    (&KELVIN, 1.0),
    (&KELVIN_DIFFERENCE, 1.0),
    (&HERTZ, 1.0),
    (&KILOHERTZ, 1e3),
    (&PASCAL, 1.0),
    (&KILOPASCAL, 1e3),
    (&MEGAPASCAL, 1e6),
    (&BAR, 1e5),
    (&METRE_PER_SECOND, 1.0),
    (&MILLIMETRE_PER_SECOND, 1e-3),
    (&METRE_PER_MINUTE, 0.016_666_666_666_666_666),
    (&METRE_PER_SECOND_SQUARED, 1.0),
    (&STANDARD_GRAVITY, 9.806_65),
    (&PERCENT, 0.01),
    (&ONE, 1.0),
    (&PER_MILLE, 0.001),
    (&NEWTON_METRE_PER_AMPERE, 1.0),
    (&VOLT_PER_THOUSAND_REVOLUTIONS, 0.009_549_296_585_513_72),
    (&VOLT_SECOND_PER_RADIAN, 1.0),
    (&AMPERE_PER_REVOLUTION_PER_MINUTE, 9.549_296_585_513_72),
    (&MILLIAMPERE_PER_REVOLUTION_PER_MINUTE, 0.009_549_296_585_513_72),
    (&AMPERE_SECOND_PER_RADIAN, 1.0),
    (&NEWTON_METRE_PER_RADIAN, 1.0),
    (&KILONEWTON_METRE_PER_RADIAN, 1000.0),
    (&TORSIONAL_NEWTON_METRE_PER_ARCMINUTE, 3_437.746_770_784_939),
    (&NEWTON_METRE_PER_ARCMINUTE, 3_437.746_770_784_939),
    (&TILTING_NEWTON_METRE_PER_RADIAN, 1.0),
    (&TILTING_KILONEWTON_METRE_PER_RADIAN, 1000.0),
    (&NEWTON_METRE_SECOND_PER_RADIAN, 1.0),
    (&NEWTON_METRE_PER_REVOLUTION_PER_MINUTE, 9.549_296_585_513_72),
    (&BIT, 1.0),
    (&POUND_FORCE_INCH, 0.112_984_829_027_616_7),
    (&POUND_FORCE_FOOT, 1.355_817_948_331_400_4),
    (&OUNCE_FORCE_INCH, 0.007_061_551_814_226_044),
    (&POUND_SQUARE_INCH, 2.926_396_534_292e-4),
    (&POUND_SQUARE_FOOT, 0.042_140_110_093_804_8),
    (&OUNCE_SQUARE_INCH, 1.828_997_833_932_5e-5),
    (&POUND_FORCE_INCH_SECOND_SQUARED, 0.112_984_829_027_616_7),
    // 1 lbf ft; of the other kilogram-force units 9.80665 N by CGPM 1901.
    (&SLUG_SQUARE_FOOT, 1.355_817_948_331_400_4),
    (&OUNCE_FORCE_INCH_SECOND_SQUARED, 0.007_061_551_814_226_044),
    (&KILOGRAM_FORCE_METRE_SECOND_SQUARED, 9.806_65),
    (&KILOGRAM_FORCE_CENTIMETRE_SECOND_SQUARED, 0.098_066_5),
    (&KILOGRAM_FORCE_METRE, 9.806_65),
    (&KILOGRAM_FORCE_CENTIMETRE, 0.098_066_5),
    (&GRAM_FORCE_CENTIMETRE, 9.806_65e-5),
    (&KILOGRAM_FORCE, 9.806_65),
    (&GRAM_SQUARE_METRE, 1e-3),
    (&KILOGRAM_SQUARE_MILLIMETRE, 1e-6),
    (&GRAM_SQUARE_MILLIMETRE, 1e-9),
    (&INCH, 0.0254),
    (&FOOT, 0.3048),
    (&MILLIMETRE_PER_REVOLUTION, 1e-3),
    (&METRE_PER_REVOLUTION, 1.0),
    (&CENTIMETRE_PER_REVOLUTION, 1e-2),
    (&INCH_PER_REVOLUTION, 0.0254),
    (&POUND, 0.453_592_37),
    (&OUNCE, 0.028_349_523_125),
    (&POUND_PER_CUBIC_INCH, 27_679.904_710_203_125),
    (&POUND_PER_CUBIC_FOOT, 16.018_463_373_960_14),
    (&POUND_FORCE, 4.448_221_615_260_5),
    (&OUNCE_FORCE, 0.278_013_850_953_781_2),
    (&EFFECTIVE_VOLT, 1.0),
    (&DEGREE_FAHRENHEIT, 255.927_777_777_777_8),
    (&POUND_FORCE_PER_SQUARE_INCH, 6_894.757_293_168_361),
    (&MILLIMETRE_PER_MINUTE, 1.0 / 60_000.0),
    (&INCH_PER_SECOND, 0.0254),
    (&FOOT_PER_SECOND, 0.3048),
    (&INCH_PER_MINUTE, 0.0254 / 60.0),
    (&FOOT_PER_MINUTE, 0.00508),
    (&MILLIMETRE_PER_SECOND_SQUARED, 1e-3),
    (&INCH_PER_SECOND_SQUARED, 0.0254),
    (&FOOT_PER_SECOND_SQUARED, 0.3048),
    (&MILLIMETRE_PER_SECOND_CUBED, 1e-3),
    (&INCH_PER_SECOND_CUBED, 0.0254),
    (&TORSIONAL_POUND_FORCE_INCH_PER_ARCMINUTE, 388.413_231_137_377_75),
    (&POUND_FORCE_INCH_PER_RADIAN, 0.112_984_829_027_616_7),
];

fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-14 * expected.abs()
}

#[test]
fn one_of_each_unit_in_si() {
    for (unit, si) in FACTORS {
        assert!(close(unit.to_si(1.0), *si), "{unit:?}: {} is not {si}", unit.to_si(1.0));
    }
}

#[test]
fn no_unit_goes_unchecked() {
    for unit in ALL {
        assert!(FACTORS.iter().any(|(checked, _)| checked == unit), "{unit:?} has no factor typed by hand");
    }
    let by_dimension: usize = Dimension::ALL.iter().map(|dimension| dimension.units().len()).sum();
    assert_eq!((by_dimension, FACTORS.len()), (ALL.len(), ALL.len()));
}

#[test]
fn temperatures_have_an_offset() {
    assert!(close(DEGREE_CELSIUS.to_si(40.0), 313.15));
    assert!(close(DEGREE_CELSIUS.to_si(0.0), 273.15));
    assert!(DEGREE_CELSIUS.to_si(-273.15).abs() < 1e-12);
    assert!(close(KELVIN.to_si(40.0), 40.0));
}

#[test]
fn every_unit_converts_there_and_back() {
    for unit in ALL {
        // The offset of a temperature reduces the precision of a small value.
        let slack = if unit.dimension == Dimension::Temperature { 1e-10 } else { 0.0 };
        for value in [0.0, 1.0, -1.0, 0.37, 1234.5, 1e-9, 1e12] {
            let back = unit.from_si(unit.to_si(value));
            assert!((back - value).abs() <= 1e-14 * value.abs() + slack, "{unit:?}: {value} -> {back}");
        }
    }
}

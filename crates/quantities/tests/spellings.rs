//! Which spellings mean which unit.

use quantities::unit::ALL;
use quantities::{Dimension, Language, Unit, format_significant, parse};

/// What the spelling means where a quantity of the dimension is expected, in the spelling of project files.
fn meaning(dimension: Dimension, spelling: &str) -> Option<&'static str> {
    Unit::of_dimension(dimension, spelling).map(|unit| unit.ascii)
}

#[test]
fn no_spelling_means_two_units_of_one_dimension() {
    for unit in ALL {
        for spelling in unit.spellings() {
            assert_eq!(meaning(unit.dimension, spelling), Some(unit.ascii), "{spelling} of {unit:?}");
        }
    }
}

#[test]
fn every_unit_reads_back_what_it_writes() {
    for unit in ALL.iter().filter(|unit| unit.ascii != "1") {
        for spelling in unit.spellings() {
            for value in [12.5, -0.0025, 1_234_567.0] {
                let text = format!("{} {spelling}", format_significant(value, 5, Language::En));
                let reading = parse(unit.dimension, &text).unwrap();
                assert!((reading.value - value).abs() <= 1e-15 * value.abs(), "{text}");
                assert_eq!(reading.unit, *unit, "{text}");
                assert!((reading.si - unit.to_si(value)).abs() <= 1e-14 * unit.to_si(value).abs(), "{text}");
            }
        }
    }
}

#[test]
fn spellings_as_people_write_them() {
    use Dimension::*;
    for (dimension, spellings, unit) in [
        (Torque, &["Nm", "N m", "N·m", "N*m", "N ⋅ m", "N\u{a0}m"][..], "N m"),
        (Torque, &["kNm", "kN m"], "kN m"),
        (Torque, &["Ncm"], "N cm"),
        (Torque, &["mNm", "mN m"], "mN m"),
        (AngularVelocity, &["rpm", "1/min", "min^-1", "min⁻¹", "min-1", "rev/min", "U/min"], "1/min"),
        (MomentOfInertia, &["kg m^2", "kgm²", "kg m2", "kg·m²", "kg*m^2"], "kg m^2"),
        (MomentOfInertia, &["kg cm^2", "kgcm²"], "kg cm^2"),
        (MomentOfInertia, &["g cm^2", "gcm²"], "g cm^2"),
        (MomentOfInertia, &["10^-4 kgm^2", "10⁻⁴ kgm²", "10⁻⁴·kg·m²"], "10^-4 kg m^2"),
        (Current, &["A", "Aeff", "Arms"], "A"),
        (Voltage, &["V", "VDC", "V DC", "Veff"], "V"),
        (Resistance, &["ohm", "Ohm", "Ω", "\u{2126}"], "ohm"),
        (Resistance, &["Mohm", "MΩ"], "Mohm"),
        (Resistance, &["mohm", "mΩ"], "mohm"),
        (Length, &["um", "µm", "μm"], "um"),
        (Angle, &["deg", "°"], "deg"),
        (Angle, &["arcmin", "′"], "arcmin"),
        (AngularVelocity, &["deg/s", "°/s"], "deg/s"),
        (Temperature, &["degC", "°C", "° C"], "degC"),
        (Ratio, &["%"], "%"),
        (Ratio, &["‰"], "‰"),
        (VoltageConstant, &["V/1000 min^-1", "V/1000 min⁻¹", "V/(1000 min⁻¹)"], "V/1000 1/min"),
        (NoLoadCurrentConstant, &["10^-3 A/min^-1", "mA/rpm"], "10^-3 A/(1/min)"),
        (TorsionalStiffness, &["Nm/arcmin"], "N m/arcmin"),
        (TiltingStiffness, &["Nm/arcmin"], "N m/arcmin"),
    ] {
        for spelling in spellings {
            assert_eq!(meaning(dimension, spelling), Some(unit), "{spelling}");
        }
    }
}

#[test]
fn spellings_of_the_tables_are_known() {
    // Listed in data/README.md.
    let spellings = "Nm, min^-1, A, 10^-3 A/min^-1, 10^-4 kgm^2, kgm^2, V, V/1000 min^-1, ohm, mH, ms, s, kg, mm, m, N, \
                     Nm/rad, 10^3 Nm/rad, Nm/arcmin, arcmin, arcsec, rad, degC, mA, uA, kHz, W, a, h, %, g, bit, Pa, \
                     Mohm, Nm/A";
    for spelling in spellings.split(", ") {
        assert!(Unit::of(spelling).is_some(), "{spelling}");
    }
}

#[test]
fn case_matters() {
    assert_eq!(meaning(Dimension::Force, "mN"), Some("mN"));
    assert_eq!(meaning(Dimension::Force, "MN"), Some("MN"));
    for wrong in ["nm", "NM", "MNm", "mn m", "Nmm m"] {
        assert_eq!(meaning(Dimension::Torque, wrong), None, "{wrong}");
    }
    assert_eq!(meaning(Dimension::Time, "S"), None);
}

#[test]
fn the_dimension_decides_and_mass_comes_first() {
    assert_eq!(Unit::of("g").unwrap().dimension, Dimension::Mass);
    assert!(parse(Dimension::Mass, "9 g").unwrap().si < 0.01);
    assert!(parse(Dimension::Acceleration, "9 g").unwrap().si > 88.0);
    assert_eq!(Unit::of("K").unwrap().dimension, Dimension::Temperature);
    assert_eq!(Unit::of("Nm/rad").unwrap().dimension, Dimension::TorsionalStiffness);
}

#[test]
fn what_is_ambiguous_or_no_unit_is_refused() {
    // 1/s is rad/s to some and revolutions per second to others; V/rad/s is not V/(rad/s).
    for wrong in ["1/s", "s^-1", "V/rad/s", "A min", "C", "furlong", "", " ", "·", "(N m)", "Nm)", "N/m"] {
        assert_eq!(Unit::of(wrong), None, "{wrong}");
    }
    let far_apart = format!("N{}x", " ".repeat(50));
    assert_eq!(Unit::of(&far_apart), None);
    assert_eq!(Unit::of(&"N".repeat(100_000)), None);
}

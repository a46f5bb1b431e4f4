//! Spellings and the units they denote.

use quantities::unit::ALL;
use quantities::{Dimension, Language, Unit, format_significant, parse};

/// Returns the unit of a spelling in the context of a dimension, in the spelling of project files.
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
        (Voltage, &["V", "VDC", "V DC"], "V"),
        (EffectiveVoltage, &["V", "VAC", "V AC", "Veff", "V_eff", "Vrms", "V~"], "V"),
        (Lead, &["mm", "mm/rev", "mm/U"], "mm"),
        (Lead, &["in/rev"], "in"),
        (Torque, &["lbf in", "lbf·in", "in lbf", "in-lbf"], "lbf in"),
        (MomentOfInertia, &["lb in^2", "lb·in²"], "lb in^2"),
        (MomentOfInertia, &["lb ft^2", "WK² lb·ft²", "WK2 lb ft2", "Wk^2 lb ft^2"], "lb ft^2"),
        (TorsionalStiffness, &["kN m/rad", "kNm/rad", "kN·m/rad", "N·m/mrad"], "10^3 N m/rad"),
        (TorsionalStiffness, &["kN m/arcmin", "kNm/arcmin", "kN·m/′"], "kN m/arcmin"),
        (TiltingStiffness, &["kN m/rad", "kNm/rad", "kN·m/rad", "N·m/mrad"], "10^3 N m/rad"),
        (Torque, &["in-lb", "lb-in", "lb·in", "in.-lb.", "in lbs", "inch-lbs"], "lbf in"),
        (Torque, &["ft-lb", "lb-ft", "ft.lbs", "foot-lbs", "ft·lbf"], "lbf ft"),
        (Torque, &["oz-in", "in-oz", "oz.in", "ozf·in"], "ozf in"),
        (Torque, &["m·N", "m N", "newton meter", "Newton-Meter"], "N m"),
        (Torque, &["kgf m", "kgf·m", "kgf-m", "kp m", "kpm"], "kgf m"),
        (Torque, &["kgf cm", "kgf·cm", "kgfcm", "kp cm"], "kgf cm"),
        (MomentOfInertia, &["kg.m2", "kg-m^2", "kg.m²"], "kg m^2"),
        (MomentOfInertia, &["g m^2"], "g m^2"),
        (MomentOfInertia, &["lb-in²", "lbm in^2", "lb-in^2"], "lb in^2"),
        (MomentOfInertia, &["oz-in²", "oz·in²"], "oz in^2"),
        (MomentOfInertia, &["lb in s^2", "lb-in-s²", "lbf·in·s²", "in-lb-sec²"], "lbf in s^2"),
        (MomentOfInertia, &["oz-in-s²", "oz in sec^2"], "ozf in s^2"),
        (MomentOfInertia, &["kgf cm s²", "kgf·cm·s²", "kp cm s^2"], "kgf cm s^2"),
        (MomentOfInertia, &["slug ft²", "slug-ft^2", "lb-ft-s²"], "slug ft^2"),
        (AngularVelocity, &["RPM", "rev/minute", "turns/min", "revolutions/min"], "1/min"),
        (AngularVelocity, &["rad s^-1", "rad·s⁻¹", "radians/sec"], "rad/s"),
        (AngularVelocity, &["deg·s⁻¹", "deg s^-1", "degrees/s", "° s⁻¹", "Grad/s"], "deg/s"),
        (AngularVelocity, &["turns/s", "rev s^-1"], "rev/s"),
        (AngularAcceleration, &["rad s^-2", "rad·s⁻²", "rad/sec^2"], "rad/s^2"),
        (Angle, &["degrees", "degree", "Deg", "Grad"], "deg"),
        (Angle, &["turns", "turn", "revolutions", "Umdrehungen"], "rev"),
        (Time, &["msec", "milliseconds", "Millisekunden"], "ms"),
        (Time, &["usec", "µsec"], "us"),
        (Velocity, &["mm s^-1", "mm·s⁻¹"], "mm/s"),
        (Force, &["kgf", "kp"], "kgf"),
        (Mass, &["lb", "lbs"], "lb"),
        (Temperature, &["degF", "°F"], "degF"),
        (AngularVelocity, &["rev/s", "rps", "U/s"], "rev/s"),
        (Time, &["s", "sec"], "s"),
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

/// Writers of units sort the factors alphabetically, with a sign between them: a metre newton is no millinewton.
#[test]
fn a_product_is_a_product_in_every_order() {
    use Dimension::*;
    for (dimension, spellings, unit) in [
        (Torque, &["m·N", "m*N", "m * N", "m×N", "m N", "m ⋅ N", "m\u{a0}N"][..], "N m"),
        (Torque, &["m·kN"], "kN m"),
        (Torque, &["cm·N"], "N cm"),
        (Torque, &["mm·N"], "N mm"),
        (MomentOfInertia, &["m²·kg", "m ** 2 * kg", "kg * m ** 2", "m^2 kg"], "kg m^2"),
        (TorsionalStiffness, &["m·N/rad", "m * N / rad", "N·m/rad"], "N m/rad"),
        (TorqueConstant, &["m·N/A"], "N m/A"),
        (ViscousFriction, &["m·N·s/rad", "s·N·m/rad"], "N m s/rad"),
    ] {
        for spelling in spellings {
            assert_eq!(meaning(dimension, spelling), Some(unit), "{spelling}");
        }
    }
    for (dimension, spellings) in [
        (Force, &["m·N", "m*N", "m N", "m × N", "M·N", "k·N"][..]),
        (Torque, &["m·N·m", "m N m", "k·N·m", "m·Nm"]),
        (Time, &["m·s", "m s", "m * s", "u·s"]),
        (Current, &["m·A", "m A"]),
        (Length, &["m·m", "m m", "k·m"]),
        (Power, &["k·W", "m·W"]),
    ] {
        for spelling in spellings {
            assert_eq!(meaning(dimension, spelling), None, "{spelling}");
        }
    }
    assert_eq!(parse(Torque, "60 m·N").unwrap().si, 60.0);
    assert!(parse(Force, "85 m*N").is_err());
}

/// No sign of a product in a spelling turns the preceding text into a prefix; if the factors are those of the unit, the
/// sign is equivalent to the space. Every unit, every place.
#[test]
fn a_sign_of_a_product_never_makes_a_prefix() {
    let mut refused = 0;
    for unit in ALL {
        for spelling in unit.spellings() {
            let letters: Vec<char> = spelling.chars().collect();
            for at in 1..letters.len() {
                let (before, behind) = (letters[at - 1], letters[at]);
                if !(before.is_alphanumeric() && behind.is_alphabetic()) {
                    continue;
                }
                let factors = [&letters[..at], &letters[at..]].map(|part| part.iter().collect::<String>());
                for sign in ["·", " * ", "×"] {
                    let written = factors.join(sign);
                    let found = Unit::of_dimension(unit.dimension, &written);
                    // In a unit that is written with a space at that place the sign is that space.
                    let spaced = factors.join(" ");
                    let is_product = unit.spellings().any(|own| same(own, &spaced));
                    if !is_product {
                        assert_ne!(found, Some(*unit), "{written} as {unit:?}");
                        refused += 1;
                    }
                }
            }
        }
    }
    assert!(refused > 300, "{refused}");
}

/// Returns `true` if a spelling has a space wherever another one has.
fn same(own: &str, spaced: &str) -> bool {
    let raised = [
        ('⁻', "-"),
        ('¹', "1"),
        ('²', "2"),
        ('³', "3"),
        ('⁴', "4"),
        ('⁶', "6"),
        ('Ω', "ohm"),
        ('µ', "u"),
        ('°', "deg"),
        ('^', ""),
    ];
    let plain = |text: &str| raised.iter().fold(text.to_owned(), |text, (sign, letters)| text.replace(*sign, letters));
    let places = |text: &str| {
        let spaces = text.match_indices(' ').enumerate();
        spaces.map(|(before, (at, _))| at - before).collect::<Vec<_>>()
    };
    let [own, spaced] = [plain(own), plain(spaced)];
    own.replace(' ', "") == spaced.replace(' ', "") && places(&spaced).iter().all(|at| places(&own).contains(at))
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

/// A spelling that states the kind of a value never denotes another quantity: effective and DC voltage, mass and force,
/// temperature scales, revolutions and radians.
#[test]
fn a_spelling_does_not_change_its_meaning() {
    use Dimension::*;
    for (dimension, spellings) in [
        (Voltage, &["VAC", "V AC", "Veff", "V_eff", "Vrms", "V_rms", "Vpp", "Vpk", "V~"][..]),
        (EffectiveVoltage, &["VDC", "V DC", "Vpp", "Vpk"]),
        (Current, &["Apk", "App", "A_peak", "ADC"]),
        (Force, &["lb", "lbs", "kg", "oz", "m·N", "m N", "M N", "k N"]),
        (Mass, &["lbf", "ozf", "kgf", "kp"]),
        (Torque, &["kg m", "lb", "mN", "m kN m"]),
        (Temperature, &["C", "F", "deg", "°", "R"]),
        (TemperatureInterval, &["degC", "degF"]),
        (AngularVelocity, &["1/s", "Hz", "s^-1"]),
        (Angle, &["U", "r", "min", "sec", "m", "'", "grad"]),
        (Time, &["m s", "m·s", "Ms"]),
        (Length, &["mm/rev", "in/rev"]),
        (Lead, &["mm/rad", "rev/mm", "1/in"]),
        (Power, &["HP", "ps", "VA"]),
        (MomentOfInertia, &["kgf m^2", "kp m²", "kgf cm²", "GD^2", "GD² kgf"]),
    ] {
        for spelling in spellings {
            assert_eq!(meaning(dimension, spelling), None, "{spelling} as {dimension:?}");
        }
    }
}

/// Factors by definition, against NIST SP 811 (2008), appendix B.8.
#[test]
fn units_of_inch_and_pound_have_the_factors_of_nist() {
    for (dimension, text, si) in [
        (Dimension::Torque, "1 lbf in", 1.129_848e-1),
        (Dimension::Torque, "1 lbf ft", 1.355_818),
        (Dimension::Torque, "1 ozf in", 7.061_552e-3),
        (Dimension::Torque, "1 oz-in", 7.061_552e-3),
        (Dimension::Torque, "1 in-lb", 1.129_848e-1),
        (Dimension::Torque, "1 ft-lb", 1.355_818),
        (Dimension::Torque, "1 kgf m", 9.806_65),
        (Dimension::Torque, "1 kgf cm", 9.806_65e-2),
        (Dimension::Force, "1 kgf", 9.806_65),
        // 1 slug is 14.593 90 kg, 1 ft is 0.3048 m.
        (Dimension::MomentOfInertia, "1 slug ft^2", 1.355_818),
        (Dimension::MomentOfInertia, "1 lb-in-s²", 1.129_848e-1),
        (Dimension::MomentOfInertia, "1 oz-in-s²", 7.061_552e-3),
        (Dimension::MomentOfInertia, "1 kgf cm s²", 9.806_65e-2),
        (Dimension::MomentOfInertia, "1 lb in^2", 2.926_397e-4),
        (Dimension::MomentOfInertia, "1 lb ft^2", 4.214_011e-2),
        (Dimension::Force, "1 lbf", 4.448_222),
        (Dimension::Mass, "1 lb", 4.535_924e-1),
        (Dimension::Mass, "1 oz", 2.834_952e-2),
        (Dimension::Pressure, "1 psi", 6.894_757e3),
        (Dimension::MassDensity, "1 lb/in^3", 2.767_990e4),
        (Dimension::MassDensity, "1 lb/ft^3", 1.601_846e1),
        (Dimension::Velocity, "1 ft/min", 5.08e-3),
        (Dimension::Temperature, "212 degF", 373.15),
        (Dimension::Lead, "0.5 in/rev", 0.0127),
        (Dimension::Mass, "1 slug", 1.459_390e1),
        (Dimension::Length, "1 mil", 2.54e-5),
        (Dimension::Power, "1 hp", 7.456_999e2),
        (Dimension::Power, "1 PS", 7.354_988e2),
        (Dimension::Energy, "1 kW h", 3.6e6),
        (Dimension::Velocity, "1 km/h", 2.777_778e-1),
        (Dimension::Force, "1 gf", 9.806_65e-3),
    ] {
        let found = parse(dimension, text).unwrap().si;
        assert!((found - si).abs() <= 5e-7 * si, "{text}: {found}");
    }
}

/// A symbol of a German answer has no English word, and is read as the same unit in a project file.
#[test]
fn a_symbol_for_german_readers_is_read_again() {
    for unit in ALL {
        let symbol = unit.symbol_in(Language::De);
        assert!(!symbol.contains("rev"), "{symbol}");
        assert_eq!(unit.symbol_in(Language::En), unit.symbol);
        // A lead along one revolution is shown as a length.
        let read =
            Unit::of_dimension(unit.dimension, symbol.trim_end_matches('.')).unwrap_or_else(|| panic!("{symbol}"));
        assert_eq!(read.symbol, unit.symbol);
    }
}

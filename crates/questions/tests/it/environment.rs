//! Conditions at the place of installation, as the tables 13.1 and 13.2 print them for the windings.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use questions::{Fit, check, size};
use sizing::{Check, CheckId, Note, Verdict};

const AXIS: &str = "format = 1\n[load]\ninertia = \"0.05 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"20 1/min\"\n\
    accelerate = \"0.2 s\"\nrun = \"0.5 s\"\nbrake = \"0.2 s\"\npause = \"0.5 s\"\n[requirements]\n";

fn found(code: &str, keys: &str, id: CheckId) -> Check {
    let project = questions::read(&format!("{AXIS}{keys}\n")).unwrap();
    let found = check(&project, &order_code::parse(code).unwrap().code).unwrap();
    found.judgement.checks.iter().find(|check| check.id == id).unwrap().clone()
}

/// Typed by hand from page 13: 1000 m for H and N, none for E; all else alike.
#[test]
fn the_print_differs_by_winding() {
    let (e, h) = ("CHA-17A-50-E-RES", "CHA-17A-50-H-RES");
    let limit = |check: &Check| check.limit.map(|limit| limit.value());
    let low = "altitude = \"800 m\"";
    let of_h = found(h, low, CheckId::Altitude);
    assert_eq!((of_h.verdict, limit(&of_h)), (Verdict::Pass, Some(1000.0)));
    assert_eq!(found(e, low, CheckId::Altitude).missing, Some("altitude"));
    for code in [e, h] {
        for (keys, id, verdict, most) in [
            ("protection = \"IP65\"", CheckId::Protection, Verdict::Pass, 65.0),
            ("protection = \"IP67\"", CheckId::Protection, Verdict::Fail, 65.0),
            ("humidity_max = 0.8", CheckId::Humidity, Verdict::Pass, 80.0),
            ("humidity_min = 0.1", CheckId::HumidityMin, Verdict::Fail, 20.0),
            ("vibration = \"5 g\"", CheckId::Vibration, Verdict::Pass, 5.0),
            ("vibration = \"60 m/s^2\"", CheckId::Vibration, Verdict::Fail, 5.0),
            ("shock = \"31 g\"", CheckId::Shock, Verdict::Fail, 30.0),
        ] {
            let check = found(code, keys, id);
            assert_eq!(check.verdict, verdict, "{code} {keys}");
            assert!((limit(&check).unwrap() - most).abs() < 1e-9, "{code} {keys}");
            assert_eq!(check.grade, Some(provenance::Grade::Printed));
        }
        assert_eq!(found(code, "mounting = \"flange_up\"", CheckId::Mounting).missing, Some("mounting_position"));
    }
}

/// k_H T_cont decides above the printed altitude, and where none is printed: equal to the continuous torque of the check of it.
#[test]
fn above_the_printed_altitude_the_stated_derating_decides() {
    for code in ["CHA-17A-50-E-RES", "CHA-25A-50-H-C1024"] {
        let keys = |factor: f64| format!("altitude = \"2500 m\"\naltitude_derating = {factor}");
        let torque = found(code, "", CheckId::ContinuousTorque);
        let (value, full) = (torque.value.unwrap().si, torque.limit.unwrap().si);
        for (factor, verdict) in [(0.9, Verdict::Pass), (1.0, Verdict::Pass)] {
            let check = found(code, &keys(factor), CheckId::Altitude);
            assert_eq!(check.verdict, verdict, "{code} {factor}");
            assert!((check.limit.unwrap().si - factor * full).abs() < 1e-12 * full);
            assert!((check.value.unwrap().si - value).abs() < 1e-12 * value);
        }
    }
    let heavy = AXIS.replace("0.05 kg m^2", "3 kg m^2");
    let verdict = |keys: &str| {
        let project = questions::read(&format!("{heavy}{keys}\n")).unwrap();
        let found = check(&project, &order_code::parse("CHA-25A-50-H-C1024").unwrap().code).unwrap();
        let of = |id| found.judgement.checks.iter().find(|check| check.id == id).unwrap().clone();
        (of(CheckId::ContinuousTorque).utilisation.unwrap(), of(CheckId::Altitude))
    };
    let (share, _) = verdict("altitude = \"2500 m\"");
    assert!(share > 0.15 && share < 1.0, "{share}");
    let (_, derated) = verdict(&format!("altitude = \"2500 m\"\naltitude_derating = {}", (0.5 * share).max(0.1)));
    assert_eq!(derated.verdict, Verdict::Fail);
}

/// Above the altitude of the manual every limit by heat says that it is not derated, and the check that derates that it does so alone.
#[test]
fn limits_that_are_not_derated_say_so() {
    let by_heat = [CheckId::ContinuousTorque, CheckId::Thermal, CheckId::OverloadI2t];
    let (e, h) = ("CHA-17A-50-E-RES", "CHA-25A-50-H-C1024");
    for (code, keys, is_beyond) in [
        (h, "", false),
        (h, "altitude = \"999 m\"", false),
        (h, "altitude = \"1000 m\"", true),
        (h, "altitude = \"2500 m\"\naltitude_derating = 0.9", true),
        (e, "altitude = \"500 m\"", true),
    ] {
        for id in by_heat {
            let check = found(code, keys, id);
            let limit = found(code, "", id).limit.map(|limit| limit.si);
            assert_eq!(check.limit.map(|limit| limit.si), limit, "{code} {keys} {id:?}");
            assert_eq!(check.notes.contains(&Note::NotDeratedForAltitude), is_beyond, "{code} {keys} {id:?}");
        }
        if keys.contains("altitude") {
            let alone = found(code, keys, CheckId::Altitude).notes.contains(&Note::DeratesThisCheckOnly);
            assert_eq!(alone, keys.contains("derating"), "{code} {keys}");
        }
    }
}

/// No actuator is selected by a condition that no winding meets; one that E does not print puts the others first; ranking and check agree.
#[test]
fn requirements_of_the_place_select() {
    let of = |keys: &str| {
        let project = questions::read(&format!("{AXIS}{keys}\n")).unwrap();
        let sizing = size(&project);
        for each in sizing.candidates.iter().step_by(11) {
            let Some(code) = each.id.order_code() else { continue };
            if let Ok(alone) = check(&project, code) {
                assert_eq!(each.judgement.fit(), alone.judgement.fit(), "{code} {keys}");
            }
        }
        sizing.candidates.iter().filter(|each| each.fit() == Fit::Fits).count()
    };
    let all = of("");
    assert!(all > 50, "{all}");
    assert_eq!(
        of("altitude = \"500 m\"\nprotection = \"IP54\"\nhumidity_min = 0.3\nhumidity_max = 0.6\nvibration = \"1 g\""),
        all
    );
    assert_eq!(of("protection = \"IP68\""), 0);
    assert_eq!(of("shock = \"50 g\""), 0);
}

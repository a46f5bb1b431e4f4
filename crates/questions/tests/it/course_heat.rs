//! The course of the temperatures is that which the check judges, also where the coil of an open brake heats the housing.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use quantities::{Language, Measure};
use questions::{CheckId, check, course};

#[test]
fn the_course_reaches_the_temperature_of_the_check() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let (mut with_brake, mut without) = (0, 0);
    for name in ["hoist", "winder", "tilting-arm", "scissor-lift", "turntable", "screw-axis"] {
        let text = std::fs::read_to_string(format!("{folder}/{name}.toml")).unwrap();
        // Of a tolerance the nominal value is judged.
        let text = text.split(" ± ").collect::<Vec<_>>();
        let text = match text.as_slice() {
            [only] => (*only).to_owned(),
            _ => continue,
        };
        let Ok(project) = questions::read(&text) else { continue };
        for code in ["CHA-14A-80-N-D2048", "CHA-17A-100-H-M128S", "CHA-25A-100-H-C1024", "CHA-32A-50-H-C1024"] {
            for brake in ["", "-B"] {
                let code = questions::read_code(&format!("{code}{brake}"), Language::En).unwrap().parsed.code;
                let Ok(candidate) = check(&project, &code) else { continue };
                let judged = candidate.judgement.checks.iter().find(|check| check.id == CheckId::Thermal).unwrap();
                let Some(value) = judged.value else { continue };
                let course = course(&project, &candidate);
                let highest =
                    course.samples.iter().filter_map(|sample| sample.winding_k).fold(f64::NEG_INFINITY, f64::max);
                // The course is sampled at 32 instants of a piece.
                assert!((highest - value.si).abs() < 0.05, "{name}, {}: {highest} K for {} K", candidate.id, value.si);
                let coil = candidate.parameters.brake.holding_current.known().map_or(0.0, |current| current.value.si());
                if coil > 0.0 { with_brake += 1 } else { without += 1 }
            }
        }
    }
    assert!(with_brake >= 6 && without >= 6, "{with_brake} {without}");
}

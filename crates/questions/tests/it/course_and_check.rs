//! The temperature of the winding over the cycle, as pictures, workbook and tables show it, reaches the value of its check, with
//! and without the coil of an open brake.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use quantities::Language;
use questions::{CheckId, check, course, read};

#[test]
fn the_course_of_the_winding_reaches_the_value_of_the_check() {
    let texts = [
        include_str!("../../../../examples/hoist.toml"),
        include_str!("../../../../examples/winder.toml"),
        include_str!("../../../../examples/turntable.toml"),
        include_str!("../../../../examples/slewing-arm.toml"),
    ];
    let codes = [
        "CHA-14A-80-N-D2048-B",
        "CHA-14A-80-N-D2048",
        "CHA-17A-80-N-D2048-B",
        "CHA-25A-50-H-C1024-B",
        "CHA-25A-50-H-C1024",
    ];
    let mut compared = 0;
    for text in texts {
        let project = read(text).unwrap();
        for code in codes {
            let code = questions::read_code(code, Language::En).unwrap().parsed.code;
            let found = check(&project, &code).unwrap();
            let thermal = found.judgement.checks.iter().find(|check| check.id == CheckId::Thermal).unwrap();
            let Some(value) = thermal.value else { continue };
            let samples = course(&project, &found).samples;
            let warmest = samples.iter().filter_map(|sample| sample.winding_k).fold(f64::NEG_INFINITY, f64::max);
            // Between two samples the swing of the winding may be a little larger.
            assert!((warmest - value.si).abs() < 0.05, "{code}: {warmest} {}", value.si);
            compared += 1;
        }
    }
    assert!(compared >= 15, "{compared}");
}

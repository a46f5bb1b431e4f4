//! Project files: whatever the text, no panic; a refusal has a place, an answer has no NaN.
#![allow(clippy::indexing_slicing, reason = "JSON answers null for a missing key")]

use arbtest::arbtest;
use fuzz::{budget_ms, mutate};
use serde_json::Value;
use workbench::{Language, Project, json, size};

const FULL: &str = r#"
format = 1
[axis]
name = "full"
[load]
inertia = "1.3 kg m^2"
friction_torque = "5 N m"
[[motion]]
law = "manual"
speed = "40 1/min"
accelerate = "0.1 s"
run = "0.1 s"
brake = "0.1 s"
pause = "1 s"
[bearing]
radial_force = "500 N"
radial_distance = "50 mm"
axial_force = "200 N"
axial_distance = "30 mm"
load_factor = 1.2
operating_condition = "normal"
[requirements]
feedback = ["M512P"]
hollow_shaft_min = "18 mm"
length_max = "300 mm"
mass_max = "20 kg"
brake = true
supply = "560 V"
ambient = "40 degC"
bearing_life_min = "20000 h"
tilt_angle_max = "1 arcmin"
option_1 = "EC"
[actuator]
name = "own"
ratio = 50
torque_max = "127 N m"
inertia_out = "1.063 kg m^2"
continuous_curve = [["0 1/min", "50 N m"], ["70 1/min", "30 N m"]]
"#;

const STARTS: [&str; 4] = [
    include_str!("../../examples/indexing-table.toml"),
    include_str!("../../examples/manual-example.toml"),
    include_str!("../../examples/two-way-shuttle.toml"),
    FULL,
];

/// Every verdict that compares numbers has both of them; JSON would turn a NaN or an infinity into null.
fn checks_are_whole(value: &Value) {
    for check in value["checks"].as_array().into_iter().flatten() {
        let judged = ["pass", "fail", "advice"].iter().any(|verdict| check["verdict"] == *verdict);
        assert!(judged || check["verdict"] == "not_checked", "{check}");
        assert!(!judged || (check["value"].is_number() && check["limit"].is_number()), "{check}");
        assert!(judged || check["missing"].is_string(), "{check}");
    }
    for name in ["T_rms", "T_peak", "n_av", "n_peak", "ED"] {
        let demand = &value["demand"];
        assert!(demand.is_null() || demand[name].is_number(), "{name}: {demand}");
    }
}

fn hold(text: &str) {
    for language in [Language::En, Language::De] {
        match Project::read(text, language) {
            Ok(project) => {
                let sizing = size(&project);
                let value = json::sizing(&sizing, 1, language);
                for each in value["ranking"].as_array().into_iter().flatten() {
                    checks_are_whole(each);
                }
                if !value["own"].is_null() {
                    checks_are_whole(&value["own"]);
                }
                if let Some(first) = sizing.candidates.first() {
                    checks_are_whole(&json::candidate(first, language));
                }
            }
            Err(faults) => {
                assert!(!faults.is_empty());
                for fault in faults {
                    assert!(fault.line >= 1 && fault.column >= 1 && !fault.message.is_empty(), "{fault:?}");
                    assert!(text.get(fault.span.clone()).is_some(), "{text:?}: {fault:?}");
                }
            }
        }
    }
}

#[test]
fn projects_from_any_text() {
    arbtest(|u| {
        hold(&String::from_utf8_lossy(&u.arbitrary::<Vec<u8>>()?));
        Ok(())
    })
    .budget_ms(budget_ms(4));
}

#[test]
fn projects_with_a_few_edits() {
    arbtest(|u| {
        let start = u.choose(&STARTS)?;
        let edits: Vec<(u16, u8)> = u.arbitrary()?;
        hold(&mutate(start, edits.get(..edits.len().min(6)).unwrap_or_default()));
        Ok(())
    })
    .budget_ms(budget_ms(1));
}

/// Valid files with extreme numbers: the arithmetic must stay finite or be refused.
#[test]
fn projects_with_extreme_numbers() {
    let numbers = ["0", "1e-300", "1e-9", "1", "1e9", "1e150", "1e300", "1.7e308"];
    arbtest(|u| {
        let picks: [u8; 8] = u.arbitrary()?;
        let pick = |index: usize| {
            numbers.get(usize::from(picks.get(index).copied().unwrap_or(0)) % numbers.len()).copied().unwrap_or("1")
        };
        let text = FULL
            .replace("1.3 kg", &format!("{} kg", pick(0)))
            .replace("5 N m", &format!("{} N m", pick(1)))
            .replace("40 1/min", &format!("{} 1/min", pick(2)))
            .replace("accelerate = \"0.1", &format!("accelerate = \"{}", pick(3)))
            .replace("run = \"0.1", &format!("run = \"{}", pick(4)))
            .replace("brake = \"0.1", &format!("brake = \"{}", pick(5)))
            .replace("500 N\"", &format!("{} N\"", pick(6)))
            .replace("50 mm", &format!("{} mm", pick(7)));
        hold(&text);
        Ok(())
    })
    .budget_ms(budget_ms(2));
}

#[test]
fn the_starting_points_are_valid() {
    for start in STARTS {
        assert!(Project::read(start, Language::En).is_ok());
        hold(start);
    }
}

//! A cycle that begins in motion, simulated: the first cycle is like the others, whatever the mechanism.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

use crate::simulated;

use serde_json::Value;
use simulated::simulated;

/// A figure of the summary.
fn figure(answer: &Value, section: &str, id: &str) -> f64 {
    answer[section][id]["value"].as_f64().unwrap()
}

/// Asserts that the first cycle has the torque, speed, current and following error of four.
fn is_steady(text: &str, code: &'static str, what: &str) -> bool {
    let of = |cycles| simulated(text, &[("code", code), ("cycles", cycles), ("cold", "true")]).ok();
    let Some(((one, fits), (four, _))) = of("1").zip(of("4")) else { return false };
    for (id, share) in [("torque_peak", 0.05), ("speed_peak", 0.003), ("current_peak", 0.05), ("following_peak", 0.1)] {
        let [a, b] = [&one, &four].map(|answer| figure(answer, "summary", id));
        assert!((a / b - 1.0).abs() < share, "{what}: {id} {a} in the first cycle, {b} in four");
    }
    let stopped = one["events"].as_array().unwrap().iter().any(|event| event["event"] == "pulses_off");
    assert!(!stopped && (fits || what != "fits"), "{what}: {}", one["verdicts"]);
    true
}

const MID: &str = "format = 1\n[load]\ninertia = \"0.5 kg m^2\"\nfriction_torque = \"3 N m\"\n\
    [[motion]]\nlaw = \"constant\"\nspeed = \"60 1/min\"\ntime = \"0.5 s\"\n\
    [[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\nspeed = \"60 1/min\"\nacceleration = \"30 rad/s^2\"\nend_speed = \"60 1/min\"\n\
    [requirements]\nsupply = \"560 V\"\n";

/// A chain whose end joins its beginning at speed, and the four-bar linkage of the examples.
#[test]
fn chains_that_begin_at_speed() {
    assert!(is_steady(MID, "CHA-25A-50-H-C1024", "fits"));
    let four_bar = include_str!("../../../../examples/four-bar.toml");
    assert!(is_steady(four_bar, "CHA-20A-80-H-C1024", "fits"));
    let (answer, _) = simulated(four_bar, &[("code", "CHA-20A-80-H-C1024")]).unwrap();
    let peak = figure(&answer, "summary", "speed_peak");
    assert!((peak / 25.0 - 1.0).abs() < 0.01, "{peak}");
}

/// Points of a periodic motion begin in motion and in acceleration.
#[test]
fn periodic_points_that_begin_at_speed() {
    let points = "format = 1\n[load]\ninertia = \"0.5 kg m^2\"\nfriction_torque = \"3 N m\"\n\
        [[motion]]\nlaw = \"points\"\nspline = \"cubic\"\nends = \"periodic\"\npoints = [[\"0 s\", \"0 deg\"], [\"0.25 s\", \"100 deg\"], [\"0.5 s\", \"180 deg\"], [\"0.75 s\", \"260 deg\"], [\"1 s\", \"360 deg\"]]\n\
        [requirements]\nsupply = \"560 V\"\n";
    assert!(is_steady(points, "CHA-25A-50-H-C1024", "points"));
}

/// Mechanisms of the examples turned at a constant speed, but for scissor lift and winder, whose cycles differ from each other.
#[test]
fn every_mechanism_turned_at_a_constant_speed() {
    let examples = [
        include_str!("../../../../examples/belt-axis.toml"),
        include_str!("../../../../examples/conveyor.toml"),
        include_str!("../../../../examples/four-bar.toml"),
        include_str!("../../../../examples/hoist.toml"),
        include_str!("../../../../examples/screw-axis.toml"),
        include_str!("../../../../examples/slewing-arm.toml"),
        include_str!("../../../../examples/slider-crank.toml"),
        include_str!("../../../../examples/tilting-arm.toml"),
        include_str!("../../../../examples/turntable.toml"),
    ];
    let mut judged = 0;
    for text in examples {
        let from = text.find("[mechanism.").unwrap();
        let end = from + text[from..].find("[[motion]]").unwrap();
        let name = text[from..].lines().next().unwrap();
        for (speed, time) in [("30 1/min", "2 s"), ("-40 1/min", "1.5 s")] {
            let axis = format!(
                "format = 1\n[axis]\nname = \"a\"\nsingle_move = true\n{}\n[[motion]]\nlaw = \"constant\"\nspeed = \"{speed}\"\ntime = \"{time}\"\n[requirements]\nsupply = \"560 V\"\n",
                &text[from..end]
            );
            judged += usize::from(is_steady(&axis, "CHA-32A-50-H-C1024", name));
        }
    }
    assert!(judged >= 10, "{judged}");
}

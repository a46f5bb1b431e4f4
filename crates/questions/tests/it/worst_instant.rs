//! The instant of an event that a call leaves open is the worst one of the cycle.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

use crate::simulated::simulated;
use testkit::projects::{Draws, LAWS, mechanisms};

const CODE: (&str, &str) = ("code", "CHA-40A-50-H-C1024-B");

/// Largest amount by which an instant of the grid may exceed the chosen one: relative, and in degrees. The search ends at
/// steps of a two hundred and fifty-sixth of a move.
const TOLERANCE: (f64, f64) = (0.005, 0.02);

/// Instants of the grid over the cycle.
const GRID: u32 = 9;

/// Returns the stopping angle \[°\] after an event; infinite if the axis does not come to rest.
fn angle(record: &serde_json::Value) -> f64 {
    record["summary"]["stop_angle"]["value"].as_f64().unwrap_or(f64::INFINITY)
}

fn move_of(law: &str, distance: f64, time: f64, payload: &str) -> String {
    format!("[[motion]]\nlaw = \"{law}\"\ndistance = \"{distance:.3} deg\"\ntime = \"{time:.3} s\"\n{payload}")
}

fn dwell(time: f64, hold: &str) -> String {
    format!("[[motion]]\nlaw = \"dwell\"\ntime = \"{time:.3} s\"\nhold = \"{hold}\"\n")
}

/// No instant of a grid leads to a longer way than the chosen one, after a power failure and after every reaction to an
/// emergency stop, for every mechanism.
#[test]
fn no_instant_of_a_cycle_is_worse_than_the_chosen_one() {
    let (mut compared, mut backwards) = (0, 0);
    for seed in [8] {
        let mut draws = Draws::new(seed);
        for drawn in mechanisms(&mut draws) {
            let distance = draws.within(60.0, 110.0);
            let (out, back) = (draws.within(0.5, 0.8), draws.within(0.5, 0.8));
            let payload =
                if drawn.sections.contains("bodies") || drawn.key == "load" { "" } else { "payload = \"1 kg\"\n" };
            let payload = if draws.within(0.0, 1.0) > 0.5 { payload } else { "" };
            let hold = draws.one_of(&["brake", "motor"]);
            let motion = [
                move_of(draws.one_of(&LAWS), distance, out, ""),
                dwell(0.4, hold),
                move_of(draws.one_of(&LAWS), -distance, back, payload),
                dwell(0.4, hold),
            ]
            .concat();
            let text = format!("format = 1\n[axis]\n{}{motion}[twin]\ncold = true\n", drawn.sections);
            let (scenario, reaction) =
                draws.one_of(&[("power_failure", "ramp"), ("emergency_stop", "brake"), ("emergency_stop", "ramp")]);
            let options = [CODE, ("scenario", scenario), ("reaction", reaction)];
            // A load that is too large for this actuator, or whose way is too short, has no run to compare.
            let Ok((cycle, _)) = simulated(&text, &[CODE]) else { continue };
            let faults =
                cycle["verdicts"].as_array().unwrap().iter().find(|each| each["id"] == "drive_faults").unwrap();
            if faults["value"] != 0.0 {
                continue;
            }
            let (chosen, _) = simulated(&text, &options).unwrap();
            let worst = &chosen["instant"]["directions"][0];
            let examined = chosen["instant"]["examined"].as_u64().unwrap();
            assert!(examined > 5 && examined <= u64::from(twin::INSTANTS_MOST), "{examined}");
            assert_eq!(worst["at"], chosen["at"]);
            let found = angle(&chosen);
            // The examined way is that of the run, in its unit.
            let said = worst["value"].as_f64().unwrap();
            let way = &chosen["summary"][if worst["unit"] == "mm" { "stop_travel" } else { "stop_angle" }]["value"];
            let way = way.as_f64().unwrap_or(f64::INFINITY);
            assert!(way.is_infinite() || (said - way).abs() < 1e-9 * way.max(1.0), "{said} {way} {text}");
            let travels = chosen["summary"]["stop_travel"]["value"].is_number();
            assert!(travels == (worst["unit"] == "mm") || worst["effect"] != "travel", "{text}");
            backwards += u32::from(worst["direction"] == "negative");
            for place in 0..GRID {
                let at = (out + back + 0.8) * (f64::from(place) + 0.5) / f64::from(GRID);
                let at = format!("{at:.4} s");
                let (other, _) = simulated(&text, &[&options[..], &[("at", at.as_str())]].concat()).unwrap();
                let (relative, absolute) = TOLERANCE;
                assert!(
                    angle(&other) <= found * (1.0 + relative) + absolute,
                    "{scenario} {reaction}: {} at {at}, {found} at {}\n{text}",
                    angle(&other),
                    chosen["at"],
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 9 * 8 && backwards > 2, "{compared} {backwards}");
}

/// A vertical axis travels farther after a power failure on its way down, and the mirrored axis in the other direction
/// by the same angle.
#[test]
fn a_mirrored_axis_has_the_mirrored_worst_instant() {
    let run = |inclination: f64, distance: f64| {
        let text = format!(
            "format = 1\n[axis]\n[mechanism.belt]\npulley_diameter = \"128 mm\"\nmass = \"40 kg\"\n\
             inclination = \"{inclination} deg\"\n{}{}{}{}",
            move_of("open", distance, 0.7, ""),
            dwell(1.0, "brake"),
            move_of("open", -distance, 0.7, ""),
            dwell(1.0, "brake"),
        );
        let code = ("code", "CHA-32A-30-H-C1024-B");
        let (record, _) = simulated(&text, &[code, ("scenario", "power_failure")]).unwrap();
        let direction = record["instant"]["directions"][0]["direction"].as_str().unwrap().to_owned();
        let title = record["instant"]["title"].as_str().unwrap();
        assert!(title.contains("in negative direction") && title.contains("in positive direction"), "{title}");
        // The way along the guide is the angle times the radius.
        let travel = record["summary"]["stop_travel"]["value"].as_f64().unwrap();
        assert!((travel - angle(&record).to_radians() * 64.0).abs() < 1e-6 * travel, "{travel}");
        (direction, angle(&record), record["at"].as_f64().unwrap())
    };
    let (down, way, at) = run(90.0, 358.1);
    assert!(down == "negative" && way > 219.0 && (1.9..2.2).contains(&at), "{down} {way} {at}");
    let (mirrored, other, other_at) = run(-90.0, -358.1);
    assert_eq!(mirrored, "positive");
    assert!((other / way - 1.0).abs() < 0.01 && (other_at - at).abs() < 0.02, "{way} {other} {at} {other_at}");
}

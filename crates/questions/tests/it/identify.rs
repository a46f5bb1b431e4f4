//! A run of the twin, identified, and what it says put into the project.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, clippy::panic, reason = "a test may fail")]

use axis::{AxisProject, Files};
use quantities::Language;
use questions::list::identify::Identification;
use questions::list::{Argument, Given, Inquiry, ReferencedText, identify, simulate};
use questions::{Progress, TwinSample};
use std::borrow::Cow;
use std::io::Read;

const CODE: (&str, &str) = ("code", "CHA-25A-50-H-C1024");

/// An arm that swings both ways, with planted friction and a torque; then `[twin.measured]` and its lines.
fn arm(inertia: &str, mass: &str, measured: &str) -> String {
    format!(
        r#"
format = 1
[axis]
name = "arm"
[mechanism.arm]
inertia = "{inertia}"
mass = "{mass}"
centre_distance = "200 mm"
axis_tilt = "90 deg"
start_angle = "20 deg"
friction_torque = "1.5 N m"
[[motion]]
law = "modified_sine"
distance = "90 deg"
time = "0.9 s"
[[motion]]
law = "modified_sine"
distance = "-90 deg"
time = "0.7 s"
[[motion]]
law = "modified_sine"
distance = "60 deg"
time = "0.8 s"
[[motion]]
law = "modified_sine"
distance = "-60 deg"
time = "0.6 s"
[requirements]
supply = "560 V"
{measured}"#
    )
}

/// One file, whatever its name.
struct One(String);

struct Bytes(Vec<u8>);

impl Files for Bytes {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.clone())))
    }
}

impl Files for One {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.clone().into_bytes())))
    }
}

fn inquiry<'a>(
    arguments: &'static [Argument],
    pairs: &[(&'static str, &'static str)],
    text: &'a str,
    files: &'a dyn Files,
    progress: &'a Progress,
) -> Inquiry<'a> {
    let pairs = pairs.iter().map(|(name, value)| (Cow::Borrowed(*name), Cow::Borrowed(*value)));
    Inquiry {
        given: Given::of(arguments, pairs, Language::En).unwrap(),
        sources: vec![ReferencedText { name: "axis.toml".to_owned(), bytes: Cow::Borrowed(text.as_bytes()), files }],
        catalogue: questions::embedded_catalogue(),
        days_since_1970: None,
        progress,
        refuses_long: true,
        by_axes: false,
        language: Language::En,
    }
}

/// The course of the project's cycle as the columns that are read.
fn course(text: &str) -> String {
    course_of(text, CODE.1)
}

fn course_of(text: &str, code: &'static str) -> String {
    let (progress, none) = (Progress::endless(), One(String::new()));
    let inquiry = inquiry(simulate::Args::ARGUMENTS, &[("code", code), ("cold", "true")], text, &none, &progress);
    let (_, project): (_, AxisProject) = inquiry.axis(None, questions::list::Cost::Other).unwrap();
    let args = simulate::Args::read(&inquiry.given).unwrap();
    let run = args.simulated(&project, &inquiry, true).unwrap();
    let row = |s: &TwinSample| {
        format!(
            "{},{},{},{},{},{},{}\n",
            s.time_s, s.position_rad, s.speed_rad_s, s.acceleration_rad_s2, s.motor_rad_s, s.torque_nm, s.current_q_a
        )
    };
    let head = "time_s,position_rad,speed_rad_s,acceleration_rad_s2,motor_speed_rad_s,torque_nm,current_q_a\n";
    head.to_owned() + &run.course.iter().map(row).collect::<String>()
}

fn identified(text: &str, trace: String) -> Identification {
    identified_of(text, trace, CODE.1)
}

fn identified_of(text: &str, trace: String, code: &'static str) -> Identification {
    let (progress, files) = (Progress::endless(), One(trace));
    let pairs = [("code", code), ("trace", "run.csv")];
    identify::found(&inquiry(identify::Args::ARGUMENTS, &pairs, text, &files, &progress)).unwrap()
}

fn value(found: &Identification, id: &str) -> (f64, f64, Option<f64>) {
    let row = found.estimates.iter().find(|each| each.id == id).unwrap_or_else(|| panic!("{id} of {found:?}"));
    (row.value.written().unwrap(), row.half_width.written().unwrap(), row.stated.and_then(answers::Number::written))
}

/// The planted values lie in the intervals of the twin's own run without noise, of projects whose moves carry a payload at times.
#[test]
fn payloads_that_a_move_carries_are_not_taken_for_the_load() {
    let arm = include_str!("../../../../examples/slewing-arm.toml");
    let tilting = include_str!("../../../../examples/tilting-arm.toml");
    let shuttle = include_str!("../../../../examples/two-way-shuttle.toml");
    for text in [arm, tilting, shuttle] {
        let found = identified(text, course(text));
        assert!(found.doubts.is_empty(), "{found:?}");
        let mut held = Vec::new();
        for each in &found.estimates {
            let (value, half, stated) = value(&found, each.id);
            // The friction of the actuator is that of its temperature.
            if each.id.starts_with("no_load") {
                continue;
            }
            if let Some(stated) = stated {
                let off = if each.id == "gravity_angle" { (value - stated).rem_euclid(360.0) } else { value - stated };
                let off = if off > 180.0 { 360.0 - off } else { off.abs() };
                assert!(off <= half, "{}: {value} ± {half}, {stated} of {text}", each.id);
                held.push(each.id);
            }
        }
        assert!(["load_inertia", "coulomb", "viscous"].iter().all(|id| held.contains(id)), "{held:?}");
        // The shuttle is a flywheel of a sixth of the rotor: its run says nothing of the torque constant.
        let is_open = found.open.iter().any(|open| open.id == "torque_constant_out");
        assert_eq!(is_open, text == shuttle, "{found:?}");
        assert_eq!(found.overrides.contains("torque_constant_out"), text != shuttle, "{}", found.overrides);
    }
}

/// A load without constant factors: what the run says beside the stated load, and what it leaves open.
#[test]
fn a_load_that_changes_gives_its_friction_and_a_linear_drive_its_inertia() {
    let belt = include_str!("../../../../examples/belt-axis.toml");
    let crank = include_str!("../../../../examples/slider-crank.toml");
    let constant = "law = \"constant\"\nspeed = \"30 1/min\"\ntime = \"2 s\"\n";
    assert!(crank.contains(constant));
    let sine =
        |way: i32, time: f64| format!("law = \"modified_sine\"\ndistance = \"{way} deg\"\ntime = \"{time} s\"\n");
    let there_and_back =
        [(200, 0.8), (-200, 0.9), (120, 0.6), (-120, 0.5)].map(|(way, time)| sine(way, time)).join("\n[[motion]]\n");
    let crank = crank.replace(constant, &there_and_back);
    for (text, is_linear) in [(belt, true), (crank.as_str(), false)] {
        let found = identified(text, course(text));
        assert!(found.doubts.is_empty(), "{found:?}");
        assert!(found.open.iter().any(|open| open.id == "gravity"), "{:?}", found.open);
        assert_eq!(found.estimates.iter().any(|each| each.id == "load_inertia"), is_linear, "{found:?}");
        if is_linear {
            let (inertia, half, stated) = value(&found, "load_inertia");
            assert!((inertia - stated.unwrap()).abs() <= half && half < 0.02 * inertia, "{found:?}");
        } else {
            let (coulomb, half, _) = value(&found, "coulomb");
            assert!((coulomb - 1.0).abs() <= half && half < 0.5, "{found:?}");
        }
    }
}

/// A project that is wrong about its load: the run of the right one corrects it, inertia, friction and gravity.
#[test]
fn the_overrides_make_a_wrong_project_run_like_the_right_one() {
    let right = arm("2.4 kg m^2", "5 kg", "");
    let wrong = arm("1.1 kg m^2", "2 kg", "");
    let trace = course(&right);
    let found = identified(&wrong, trace.clone());
    let (inertia, half, stated) = value(&found, "load_inertia");
    assert!(stated.unwrap() < 1.3 && inertia > 2.3 && half < 0.01, "{found:?}");
    for key in ["load_inertia", "load_coulomb", "load_gravity", "load_gravity_angle", "torque_constant_out"] {
        assert!(found.overrides.contains(&format!("\n{key} = ")), "{}", found.overrides);
    }
    // The wrong project with these lines runs as the right one does.
    let corrected = arm("1.1 kg m^2", "2 kg", &format!("[twin]\n{}", found.overrides));
    let again = identified(&right, course(&corrected));
    for id in ["load_inertia", "gravity", "coulomb"] {
        let ((before, half, _), (after, other, stated)) = (value(&found, id), value(&again, id));
        assert!((before - after).abs() < half + other + 1e-4 * before, "{id}: {before} {after}");
        assert!((after - stated.unwrap()).abs() < 3.0 * (half + other) + 5e-3 * after, "{id}: {after} {stated:?}");
    }
}

/// A Parquet file with other headings is answered as a text with them: its columns, and the headings to write.
#[test]
fn other_headings_are_answered_alike_in_either_format() {
    let text = arm("2.4 kg m^2", "5 kg", "");
    let refused = |trace: &[u8]| {
        let (progress, files) = (Progress::endless(), Bytes(trace.to_vec()));
        let inquiry = inquiry(identify::Args::ARGUMENTS, &[CODE, ("trace", "run.csv")], &text, &files, &progress);
        let faults = identify::found(&inquiry).unwrap_err().faults(None, Language::En).errors;
        faults.into_iter().map(|fault| fault.message).collect::<Vec<_>>()
    };
    let parquet = include_bytes!("../../../recording/tests/data/pyarrow_gzip.parquet");
    let names = recording::column_names(&recording::Bytes::from_static(parquet)).unwrap();
    let csv = format!("{}\n", names.join(";"));
    let faults = refused(parquet);
    assert_eq!(faults, refused(csv.as_bytes()));
    assert!(faults[0].contains("the file has") && names.iter().all(|name| faults[0].contains(name)), "{faults:?}");
}

/// Every cell that is no number is reported with its line, and a Parquet file that cannot be read.
#[test]
fn every_wrong_cell_of_a_run_is_reported() {
    let text = arm("2.4 kg m^2", "5 kg", "");
    let refused = |trace: String| {
        let (progress, files) = (Progress::endless(), One(trace));
        let inquiry = inquiry(identify::Args::ARGUMENTS, &[CODE, ("trace", "run.csv")], &text, &files, &progress);
        let faults = identify::found(&inquiry).unwrap_err().faults(None, Language::En).errors;
        faults.into_iter().map(|fault| fault.message).collect::<Vec<_>>()
    };
    let head = "time_s,position_rad,speed_rad_s,acceleration_rad_s2,motor_speed_rad_s,torque_nm,current_q_a\n";
    let faults = refused(format!("{head}0,0,0,0,0,0,0\nx,0,0,0,0,0,0\n1,0,0,0,0,0,\n"));
    assert_eq!(faults.len(), 2, "{faults:?}");
    assert!(faults[0].contains("line 3") && faults[1].contains("line 4") && faults[1].contains("current_q_a"));
    assert_eq!(refused(format!("{head}{}", "a,b,c,d,e,f,g\n".repeat(100))).len(), 20);
    // A number that no machine shows, a time that stands still; a line of remarks counts.
    let beyond = refused(format!("# of the bench\n{head}0,0,0,0,0,0,0\n1,0,0,0,0,1e308,0\n2,-1e9,0,0,0,0,0\n"));
    assert_eq!(beyond.len(), 2, "{beyond:?}");
    assert!(beyond[0].contains("line 4") && beyond[0].contains("torque_nm"), "{beyond:?}");
    assert!(beyond[1].contains("line 5") && beyond[1].contains("position_rad"), "{beyond:?}");
    let still = refused(format!("# of the bench\n{head}0,0,0,0,0,0,0\n1,0,0,0,0,0,0\n1,0,0,0,0,0,0\n"));
    assert!(still.len() == 1 && still[0].contains("line 5"), "{still:?}");
    assert!(refused("PAR1".to_owned())[0].contains("Parquet"));
    // Columns that are missing are one fault, beside those of the cells.
    let lacking = refused("time_s,torque_nm\n0,x\n".to_owned());
    assert!(
        lacking.len() == 2 && lacking[0].contains("motor_speed_rad_s") && lacking[1].contains("line 2"),
        "{lacking:?}"
    );
    assert!(!lacking[0].contains("acceleration"), "{lacking:?}");
}

/// Headings of other loggers are answered with the content of the file and what to write, a preamble with its last line,
/// dates with one fault, and separators of thousands are found.
#[test]
fn what_to_write_for_a_foreign_run_is_said() {
    let text = arm("2.4 kg m^2", "5 kg", "");
    let refused = |trace: &str| {
        let (progress, files) = (Progress::endless(), One(trace.to_owned()));
        let inquiry = inquiry(identify::Args::ARGUMENTS, &[CODE, ("trace", "run.csv")], &text, &files, &progress);
        let faults = identify::found(&inquiry).unwrap_err().faults(None, Language::En).errors;
        faults.into_iter().map(|fault| fault.message).collect::<Vec<_>>()
    };
    let holds = |trace: &str, parts: &[&str]| {
        let all = refused(trace);
        assert_eq!(all.len(), 1, "{all:?}");
        for part in parts {
            assert!(all[0].contains(part), "{part}: {all:?}");
        }
    };
    holds(
        "time,position,motor speed,torque,i_q\n0,0,0,0,0\n",
        &["time_s for", "position_rad for", "motor_speed_rad_s for", "torque_nm for", "current_q_a for"],
    );
    // Of two columns of a signal none is taken.
    holds(
        "time_ms;time 2 (ms);position_deg;pos 2 [deg];Motordrehzahl 1 (1/min);Motordrehzahl 2 (1/min)\n0;0;0;0;0;0\n",
        &["time_ms", "times 0.001", "times 0.0174533", "times 0.10472", "torque_nm"],
    );
    // One with its unit is.
    for clear in [
        "time [s],position [deg],motor speed [rad/s],torque [Nm],i_q [A]\n0,0,0,0,0\n",
        "time_ms;position_deg;Motordrehzahl (1/min);torque_nm;current_q_a\n0;0;0;0;0\n",
    ] {
        holds(clear, &["too few samples"]);
    }
    let head = "time_s;position_rad;motor_speed_rad_s;torque_nm;current_q_a\n";
    holds(&format!("Drive trace 14.03.2025\nsample time;1 ms\n\n{head}0;0;0;0;0\n"), &["line 4", "1 to 3"]);
    holds(
        &format!("{head}s;deg;1/min;Nm;A\n0;0;0;0;0\n"),
        &["line 2", "position_rad in \"deg\", values times 0.0174533", "motor_speed_rad_s in \"1/min\""],
    );
    let rows: String = (0..50).map(|k| format!("2025-03-14T10:00:00.{k:03};0;0;0;0\n")).collect();
    holds(&format!("{head}{rows}"), &["line 2", "2025-03-14T10:00:00.000", "seconds"]);
    let rows: String = (996..1010).map(|k| format!("{k};0;0;{};0\n", if k < 1000 { "998" } else { "1.002" })).collect();
    holds(&format!("{head}{rows}"), &["1.002", "thousands", "torque_nm"]);
}

/// Quantities that a run at the limit of the current does not determine are listed.
#[test]
fn a_run_at_the_limit_says_what_it_leaves_open() {
    let heavy = arm("60 kg m^2", "60 kg", "[twin]\nlimits = true\n");
    let found = identified(&heavy, course(&heavy));
    assert!(found.notes.iter().any(|note| note.contains("at its limit")), "{:?}", found.notes);
    assert!(found.open.iter().any(|open| open.id == "torque_constant_out"), "{:?}", found.open);
    assert!(value(&found, "load_inertia").0 > 50.0);
}

/// Losses by direction of power are those of the project, not inertia, friction, or a lag: over mechanisms, codes and
/// efficiencies the intervals hold the stated values, and no sign is impossible.
#[test]
fn losses_of_a_transmission_are_not_taken_for_inertia_and_friction() {
    let conveyor = include_str!("../../../../examples/conveyor.toml");
    let belt = include_str!("../../../../examples/belt-axis.toml");
    let screw = include_str!("../../../../examples/screw-axis.toml");
    let stage = include_str!("../../../../examples/stage-axis.toml");
    let cases = [
        (conveyor, "efficiency = 0.9 ", "CHA-14A-50-N-D2048"),
        (belt, "efficiency = 0.95", "CHA-14A-50-N-D2048"),
        (belt, "efficiency = 0.95", "CHA-20A-50-H-C1024"),
        (screw, "efficiency = 0.9", "CHA-14A-50-N-D2048-B"),
        (stage, "efficiency = ", "CHA-20A-50-H-C1024"),
        (stage, "efficiency = ", "CHA-25A-100-H-C1024"),
        // The kinematic error swings the torque to the other side of the power.
        (belt, "efficiency = 0.95", "CHA-25A-50-H-C1024"),
        (conveyor, "efficiency = 0.9 ", "CHA-25A-50-H-C1024"),
        // Limit of the speed.
        (belt, "efficiency = 0.95", "CHA-25A-100-H-C1024"),
    ];
    // Of the first move, without losses.
    let coulomb = |text: &str| match text {
        _ if text.contains("mechanism.belt") => Some(0.06 * (35.0 + 0.02 * 25.0 * 9.806_65)),
        _ if text.contains("mechanism.conveyor") => Some(0.05 * 60.0),
        _ if text.contains("mechanism.screw") => Some(0.04 / std::f64::consts::TAU * 120.0),
        _ => None,
    };
    let mut inertias = 0;
    let mut wrong = Vec::new();
    for (text, key, code) in cases {
        let line = text.lines().find(|line| line.starts_with(key.trim_end())).unwrap_or_else(|| panic!("{key}"));
        for other in ["0.95", "0.8", "0.6"] {
            let text = text.replace(line, &format!("efficiency = {other}"));
            let found = identified_of(&text, course_of(&text, code), code);
            let case = format!("{code} {other} {}", text.lines().next().unwrap());
            let late = found.signals.iter().filter(|signal| signal.id.ends_with("delay"));
            wrong.extend(late.map(|signal| format!("{case} {}", signal.id)));
            wrong.extend(found.doubts.iter().map(|doubt| format!("{case} {doubt:?}")));
            for each in &found.estimates {
                let (value, half, stated) = value(&found, each.id);
                let truth = match each.id {
                    "viscous" => Some(0.0),
                    "coulomb" => coulomb(&text),
                    "load_inertia" | "torque_constant_out" => stated,
                    _ => None,
                };
                inertias += usize::from(each.id == "load_inertia");
                if value < -half || truth.is_some_and(|truth| (value - truth).abs() > half) {
                    wrong.push(format!("{case} {}: {value} ± {half}, {truth:?}", each.id));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(inertias >= 15, "{inertias}");
}

/// A run at the limit of the speed lags the motion, so that the payload of a window is open near its change; and an error of a
/// thousandth of the torque is no lag of it.
#[test]
fn slow_and_late_runs_show_neither_wrong_payloads_nor_lags() {
    let hoist = include_str!("../../../../examples/hoist.toml");
    let belt = include_str!("../../../../examples/belt-axis.toml");
    let lift = include_str!("../../../../examples/scissor-lift.toml");
    let cases = [
        (hoist, "efficiency = 0.95", &["0.9", "0.7"][..], &["CHA-25A-100-H-C1024-B", "CHA-25A-50-H-C1024-B"][..]),
        (belt, "efficiency = 0.95", &["1.0"], &["CHA-20A-100-H-C1024", "CHA-17A-120-N-D2048"]),
        (
            lift,
            "efficiency = 0.85",
            &["0.85"],
            &["CHA-14A-50-N-D2048-B", "CHA-20A-50-H-C1024-B", "CHA-17A-100-N-D2048-B"],
        ),
    ];
    let mut wrong = Vec::new();
    for (text, key, efficiencies, codes) in cases {
        for (efficiency, code) in efficiencies.iter().flat_map(|of| codes.iter().map(move |code| (of, code))) {
            let text = text.replace(key, &format!("efficiency = {efficiency}"));
            let found = identified_of(&text, course_of(&text, code), code);
            let late = found.signals.iter().filter(|signal| signal.id.ends_with("delay"));
            wrong.extend(late.map(|signal| format!("{code} {efficiency} {}", signal.id)));
            wrong.extend(found.doubts.iter().map(|doubt| format!("{code} {efficiency} {doubt:?}")));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A run partly at the limit of the current gives no parameter of the motor with an impossible sign or an interval without it.
#[test]
fn a_run_partly_at_the_limit_gives_no_impossible_values() {
    let text = include_str!("../../../../examples/slewing-arm.toml");
    for code in ["CHA-17A-80-N-D2048-B", "CHA-17A-100-N-D2048-B", "CHA-17A-50-N-D2048-B", "CHA-20A-80-H-C1024-B"] {
        let found = identified_of(text, course_of(text, code), code);
        assert!(found.doubts.is_empty(), "{code} {found:#?}");
        for each in &found.estimates {
            let (value, half, stated) = value(&found, each.id);
            assert!(value >= -half && half < 1e3, "{code} {} {found:#?}", each.id);
            if let Some(stated) = stated.filter(|_| !each.id.starts_with("no_load") && each.id != "gravity_angle") {
                assert!((value - stated).abs() <= half, "{code} {} {found:#?}", each.id);
            }
            // Friction lies between that of a cold and of a warm gear.
            if each.id == "no_load_starting_current" {
                assert!((value - stated.unwrap()).abs() <= half + 0.7 * stated.unwrap(), "{code} {found:#?}");
            }
        }
    }
}

/// A measured load of a mechanism that changes with the position is refused with its key.
#[test]
fn a_measured_load_that_replaces_nothing_is_refused() {
    let crank = include_str!("../../../../examples/slider-crank.toml");
    let text = format!("{crank}\n[twin.measured]\nload_inertia = \"1 kg m^2\"\n");
    let (progress, none) = (Progress::endless(), One(String::new()));
    let inquiry = inquiry(simulate::Args::ARGUMENTS, &[CODE], &text, &none, &progress);
    let args = simulate::Args::read(&inquiry.given).unwrap();
    let why = simulate::record(&args, &inquiry).unwrap_err();
    let faults = why.faults(None, Language::En);
    assert!(faults.errors[0].message.contains("measured.load_inertia"), "{faults:?}");
}

/// An offset and a delay of the current are reported and taken into account, and a gap between two runs is no spacing of rows.
#[test]
fn zeros_and_delays_of_the_current_are_reported() {
    let text = arm("2.4 kg m^2", "5 kg", "");
    let trace = course(&text);
    let rows: Vec<(&str, f64)> = trace
        .lines()
        .skip(1)
        .map(|line| line.rsplit_once(',').unwrap())
        .map(|(rest, current)| (rest, current.parse().unwrap()))
        .collect();
    let step = |row: &str| row.split(',').next().unwrap().parse::<f64>().unwrap();
    let late = (0.006 / (step(rows[1].0) - step(rows[0].0))).round() as usize;
    let mut other = trace.lines().next().unwrap().to_owned();
    for (place, (rest, _)) in rows.iter().enumerate() {
        other.push_str(&format!("\n{rest},{}", rows[place.saturating_sub(late)].1 + 0.05));
    }
    let found = identified(&text, other);
    assert!(found.doubts.is_empty() && !found.overrides.contains("load_external"), "{found:?}");
    let signal = |id: &str| {
        let row = found.signals.iter().find(|each| each.id == id).unwrap_or_else(|| panic!("{id} of {found:?}"));
        assert!(row.significant && row.column == "current_q_a", "{row:?}");
        (row.value.written().unwrap(), row.half_width.written().unwrap())
    };
    let ((zero, of_zero), (delay, of_delay)) = (signal("current_zero"), signal("current_delay"));
    assert!((zero - 0.05).abs() < of_zero && of_zero < 0.03, "{zero} {of_zero}");
    assert!((delay - 6.0).abs() < of_delay.max(0.2) && of_delay < 1.0, "{delay} {of_delay}");
    let (constant, half, stated) = value(&found, "torque_constant_out");
    assert!((constant - stated.unwrap()).abs() < half, "{constant} {half} {stated:?}");
    for part in ["lags the position", "zeros of current_q_a and torque_nm"] {
        assert!(found.notes.iter().any(|note| note.contains(part)), "{:?}", found.notes);
    }
}

/// Scattered stamps, held values and filters are notes with their size, and the planted values remain within the intervals; stamps that
/// the signals do not follow either way are a doubt.
#[test]
fn stamps_held_values_and_filters_are_reported() {
    let text = arm("2.4 kg m^2", "5 kg", "");
    let trace = course(&text);
    let head = trace.lines().next().unwrap();
    let cells = |line: &str| line.split(',').map(|cell| cell.parse::<f64>().unwrap()).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = trace.lines().skip(1).map(cells).collect();
    let step = rows[1][0] - rows[0][0];
    let scatter = |place: usize, by: f64| by * ((place * 7919 % 101) as f64 / 50.0 - 1.0) * step;
    let written = |change: &dyn Fn(usize, &mut Vec<f64>)| {
        let mut written = head.to_owned();
        for (place, row) in rows.iter().enumerate() {
            let mut row = row.clone();
            change(place, &mut row);
            written.push('\n');
            written.push_str(&row.iter().map(f64::to_string).collect::<Vec<_>>().join(","));
        }
        identified(&text, written)
    };
    let is_right = |found: &Identification| {
        assert!(found.doubts.is_empty(), "{:?}", found.doubts);
        let (inertia, half, stated) = value(found, "load_inertia");
        assert!((inertia - stated.unwrap()).abs() < half && half < 0.02 * inertia, "{inertia} ± {half}");
    };
    let scattered = written(&|place, row| row[0] += scatter(place, 0.3));
    is_right(&scattered);
    assert!(scattered.notes.iter().any(|note| note.contains("time stamps scatter by")), "{:?}", scattered.notes);
    let held = written(&|place, row| row[5] = rows[place / 4 * 4][5]);
    is_right(&held);
    assert!(held.notes.iter().any(|note| note.starts_with("torque_nm is updated every")), "{:?}", held.notes);
    let neither = written(&|place, row| {
        let by = scatter(place, 0.3);
        let other = (place + 1).min(rows.len() - 1);
        let share = 0.5 * by.abs() / step;
        let [from, to] = [if by < 0.0 { place.saturating_sub(1) } else { other }, place];
        (1..row.len()).for_each(|cell| row[cell] = rows[to][cell] + share * (rows[from][cell] - rows[to][cell]));
        row[0] += by;
    });
    let doubts: Vec<(&str, &str)> = neither.doubts.iter().map(|doubt| (doubt.id, doubt.column)).collect();
    assert_eq!(doubts, [("time_stamps", "time_s")], "{:?}", neither.doubts);
    assert!(neither.overrides.is_empty() && neither.doubts[0].text.contains("scatter by"), "{:?}", neither.doubts);
}

/// Lines for the project say only what the run knows: no zero for what it leaves open, nothing of a run with a wrong convention.
#[test]
fn lines_for_the_project_hold_only_what_the_run_knows() {
    let text = arm("2.4 kg m^2", "5 kg", "").replace("friction_torque = \"1.5 N m\"\n", "");
    let found = identified(&text, course(&text));
    assert!(value(&found, "coulomb").0.abs() < value(&found, "coulomb").1, "{found:?}");
    assert!(!found.overrides.contains("load_coulomb") && !found.overrides.contains("\"0 "), "{}", found.overrides);
    assert!(found.overrides.contains("load_inertia"), "{}", found.overrides);
    // One way: no friction, no constant torque.
    let head = text.split("[[motion]]").next().unwrap();
    let one_way = format!(
        "{head}[[motion]]\nlaw = \"modified_sine\"\ndistance = \"90 deg\"\ntime = \"0.9 s\"\n[[motion]]\nlaw = \"modified_sine\"\ndistance = \"270 deg\"\ntime = \"1.5 s\"\n[requirements]\nsupply = \"560 V\"\n"
    );
    let found = identified(&one_way, course(&one_way));
    assert!(found.estimates.iter().all(|each| each.id != "coulomb" && each.id != "external"), "{found:?}");
    assert!(!found.overrides.contains("coulomb") && !found.overrides.contains("external"), "{}", found.overrides);
    assert!(found.open.iter().any(|open| open.id == "coulomb"), "{:?}", found.open);
    // The current as rms.
    let trace = course(&text);
    let mut lines = trace.lines();
    let mut rms = lines.next().unwrap().to_owned();
    for line in lines {
        let (rest, current) = line.rsplit_once(',').unwrap();
        rms.push_str(&format!("\n{rest},{}", current.parse::<f64>().unwrap() / std::f64::consts::SQRT_2));
    }
    let found = identified(&text, rms);
    assert!(found.doubts.len() == 1 && found.doubts[0].id == "rms" && found.overrides.is_empty(), "{found:?}");
    assert!(found.doubts[0].text.contains("current_q_a") && found.doubts[0].text.contains('√'), "{found:?}");
    assert!(found.doubts[0].text.contains("1.41"), "{found:?}");
}

/// A run says the same with other separators, decimal commas, encodings and columns beside those that are read.
#[test]
fn a_run_is_read_alike_in_every_dialect() {
    let text = arm("2.4 kg m^2", "5 kg", "");
    let trace = course(&text);
    let expected = identified(&text, trace.clone());
    let german = trace.replace(',', ";").replace('.', ",").replace('\n', "\r\n");
    let quoted: String = trace.lines().map(|line| format!("\"{}\",\"ä\"\n", line.replace(',', "\",\""))).collect();
    let (head, rows) = trace.split_once('\n').unwrap();
    let with_units = format!("{head}\ns,rad,rad/s,rad/s²,rad/s,N m,A\n{rows}");
    for other in
        [with_units, german.clone(), format!("sep=;\n# of the bench\n\n{german}"), trace.replace(',', "\t"), quoted]
    {
        assert_eq!(identified(&text, other), expected);
    }
}

/// Rows are counted before the work: more than take ten seconds are refused with their number, unless the call has a time limit;
/// a cancelled work ends.
#[test]
fn a_long_run_is_counted_before_the_work() {
    let text = arm("2.4 kg m^2", "5 kg", "");
    let run = course(&text);
    let answered = |trace: Vec<u8>, refuses_long: bool, progress: &Progress| {
        let files = Bytes(trace);
        let arguments = inquiry(identify::Args::ARGUMENTS, &[CODE, ("trace", "run.csv")], &text, &files, progress);
        identify::found(&Inquiry { refuses_long, ..arguments }).map_err(|why| {
            let faults = why.faults(Some(7.0), Language::En).errors;
            faults.into_iter().map(|fault| fault.message).collect::<String>()
        })
    };
    // A footer alone, which claims its rows.
    let parquet = |rows: i64| {
        let names = ["time_s", "position_rad", "motor_speed_rad_s", "torque_nm", "current_q_a"];
        let column =
            |name| testkit::parquet::FileColumn { name, physical: 5, codec: 0, values: rows, pages: Vec::new() };
        testkit::parquet::file(rows, &names.map(column))
    };
    let most = 1 << 21;
    let refused = answered(parquet(most + 1), true, &Progress::endless()).unwrap_err();
    assert!(refused.starts_with("2097153 rows of the run take more than about 10 seconds"), "{refused}");
    assert!(refused.contains("at most 2097152") && refused.contains("--deadline"), "{refused}");
    for (rows, refuses_long) in [(most, true), (most + 1, false)] {
        let other = answered(parquet(rows), refuses_long, &Progress::endless()).unwrap_err();
        assert!(!other.contains("seconds"), "{other}");
    }
    let progress = Progress::endless();
    assert!(answered(run.clone().into_bytes(), true, &progress).is_ok());
    let (steps, _) = progress.progress();
    assert!(steps > 30, "a step is a window: {steps}");
    let progress = Progress::endless();
    progress.displace();
    assert!(answered(run.into_bytes(), false, &progress).unwrap_err().contains("7"));
}

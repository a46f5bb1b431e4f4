//! A motion recorded at the motor is that at the output, divided by the ratio of the recorded gear; the side is never
//! taken without a word.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use axis::Assumption;
use axis::{AxisFault, AxisProject, Files};
use project::Fault;
use quantities::{Measure, MomentOfInertia};
use std::fmt::Write as _;

struct Given(String);

impl Files for Given {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.clone())))
    }
}

/// A quarter turn forth and back in one second each, with a torque of 3 to 5 Nm, at a shaft that turns `ratio` times as
/// far.
fn recording(headings: [&str; 3], ratios: [f64; 3]) -> Given {
    let [angle, speed, torque] = headings;
    let mut text = format!("t [s];{angle};{speed};{torque}\n");
    for k in 0..=1000 {
        let t = f64::from(k) * 2e-3;
        let turn = std::f64::consts::TAU * t / 2.0;
        let (q, n, m) = (45.0 * (1.0 - turn.cos()), 45.0 * std::f64::consts::PI * turn.sin() / 6.0, 4.0 + turn.sin());
        let [of_q, of_n, of_m] = ratios;
        writeln!(text, "{t:.3};{:.12};{:.12};{:.12}", q * of_q, n * of_n, m / of_m).unwrap();
    }
    Given(text)
}

const AT_OUTPUT: [&str; 3] = ["q [deg]", "n [1/min]", "M [Nm]"];

fn read(load: &str, keys: &str, files: &Given) -> Result<AxisProject, Vec<AxisFault>> {
    let text = format!(
        "format = 1\n[axis]\nname = \"side\"\n{load}\n[[motion]]\nlaw = \"recorded\"\nfile = \"r.csv\"\n{keys}\n"
    );
    let read = questions::read_all(&text, files);
    read.map(|mut all| all.remove(0)).map_err(|all| all.into_iter().map(|each| each.fault).collect())
}

fn figures(project: &AxisProject) -> [f64; 4] {
    let demand = project.axis.demand(MomentOfInertia::from_si(0.1));
    [demand.torque_rms.si(), demand.torque_peak.si(), demand.speed_peak.si(), demand.speed_mean.si()]
}

const LOAD: &str = "[load]\ninertia = \"0.4 kg m^2\"\nfriction_torque = \"2 N m\"";
const STAGE: &str = "[load]\ninertia = \"0.4 kg m^2\"\n[stage]\nkind = \"belt\"\nratio = 2.5";
const JOINT: &str = "[mechanism.joint]\ninertia = \"0.4 kg m^2\"\nholding_torque = \"5 N m\"";

#[test]
fn a_recording_of_the_motor_is_that_of_the_output_over_the_ratio_of_its_gear() {
    for load in [LOAD, STAGE, JOINT] {
        let output = read(load, "", &recording(AT_OUTPUT, [1.0; 3])).unwrap();
        assert!(output.assumptions.contains(&Assumption::RecordedAtOutput));
        for [q, n, m] in [[80.0, 80.0, 80.0], [1.0, 50.0, 1.0], [1.0, 1.0, 160.0], [0.5, 0.5, 0.5]] {
            let keys = format!("recorded_ratio = {{ position = {q}, speed = {n}, torque = {m} }}");
            let motor = read(load, &keys, &recording(AT_OUTPUT, [q, n, m])).unwrap();
            for (found, expected) in figures(&motor).into_iter().zip(figures(&output)) {
                assert!((found / expected - 1.0).abs() < 1e-6, "{found} for {expected} with {keys} under {load}");
            }
            assert!(!motor.assumptions.contains(&Assumption::RecordedAtOutput));
            assert_eq!(motor.assumptions.contains(&Assumption::RecordedTorqueOfMotor), m != 1.0);
        }
        // A side that is stated for some columns is open for the others.
        let partly = read(load, "recorded_ratio = { speed = 80 }", &recording(AT_OUTPUT, [1.0, 80.0, 1.0])).unwrap();
        assert!(partly.assumptions.contains(&Assumption::RecordedAtOutput));
    }
}

/// A negative ratio is that of a gear that turns the other way; a ratio above 0 is listed as taken to turn alike.
#[test]
fn a_recorded_gear_may_turn_the_other_way() {
    let mechanism = "[mechanism.arm]\ninertia = \"0.9 kg m^2\"\nmass = \"8 kg\"\ncentre_distance = \"0.3 m\"\n\
                     axis_tilt = \"90 deg\"\nstart_angle = \"20 deg\"";
    for load in [LOAD, STAGE, JOINT, mechanism] {
        let output = read(load, "", &recording(AT_OUTPUT, [1.0; 3])).unwrap();
        for ratio in [80.0, 50.0, 1.0, 0.5] {
            let keys = |i: f64| format!("recorded_ratio = {{ position = {i}, speed = {i}, torque = {i} }}");
            let motor = read(load, &keys(-ratio), &recording(AT_OUTPUT, [-ratio; 3])).unwrap();
            for (found, expected) in figures(&motor).into_iter().zip(figures(&output)) {
                assert!((found / expected - 1.0).abs() < 1e-6, "{found} for {expected} with {ratio} under {load}");
            }
            assert!(!motor.assumptions.contains(&Assumption::RecordedTurnsAlike));
            assert_eq!(motor.assumptions.contains(&Assumption::RecordedTorqueOfMotor), ratio != 1.0);
            let alike = read(load, &keys(ratio), &recording(AT_OUTPUT, [ratio; 3])).unwrap();
            assert_eq!(alike.assumptions.contains(&Assumption::RecordedTurnsAlike), ratio != 1.0);
        }
    }
    for ratio in ["0", "1e-5", "-1e-5"] {
        let faults = read(LOAD, &format!("recorded_ratio = {{ speed = {ratio} }}"), &recording(AT_OUTPUT, [1.0; 3]));
        assert!(matches!(faults.unwrap_err().as_slice(), [AxisFault::Stated(Fault::RatioTooSmall { .. })]), "{ratio}");
    }
}

#[test]
fn columns_of_the_motor_need_their_ratio() {
    let headings = ["r0482[1]: Position [deg]", "r0061[0]: Speed actual value [1/min]", "Motor.Torque [Nm]"];
    let files = recording(headings, [1.0, 80.0, 80.0]);
    let faults = read(LOAD, "", &files).unwrap_err();
    let [fault @ AxisFault::Stated(Fault::MotorSide { ratios, headings: named, .. })] = faults.as_slice() else {
        panic!("{faults:?}")
    };
    assert_eq!((ratios.as_slice(), named.len()), (&[("speed", None), ("torque", None)][..], 2));
    // The line of the message is read as it stands.
    for language in quantities::Language::ALL {
        let text = words::own_hint(fault, language).unwrap();
        let line = &text[text.find("recorded_ratio").unwrap()..=text.find('}').unwrap()];
        let project = read(LOAD, line, &files).unwrap();
        let output = read(LOAD, "", &recording(AT_OUTPUT, [1.0; 3])).unwrap();
        for (found, expected) in figures(&project).into_iter().zip(figures(&output)) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{found} for {expected}");
        }
    }
    let faults = read(LOAD, "recorded_ratio = { speed = 50 }", &files).unwrap_err();
    assert!(
        matches!(faults.as_slice(), [AxisFault::Stated(Fault::MotorSide { ratios, .. })] if ratios == &[("speed", Some(50.0)), ("torque", None)]),
        "{faults:?}"
    );
    let at_output = "recorded_ratio = { speed = 1, torque = 1 }";
    read(LOAD, at_output, &recording(headings, [1.0; 3])).unwrap();
}

#[test]
fn a_ratio_without_a_rotary_column_is_refused() {
    let faults = read(
        LOAD,
        "columns = { torque = \"none\" }\nrecorded_ratio = { torque = 80 }",
        &recording(AT_OUTPUT, [1.0; 3]),
    );
    assert!(
        matches!(faults.unwrap_err().as_slice(), [AxisFault::Stated(Fault::NoColumnWithRatio { path })] if path.ends_with("recorded_ratio.torque"))
    );
    let screw = "[mechanism.screw]\nlead = \"10 mm\"\nmass = \"5 kg\"";
    let along = ["x [mm]", "v [mm/s]", "F [N]"];
    let faults = read(screw, "recorded_ratio = { position = 80 }", &recording(along, [1.0; 3])).unwrap_err();
    assert!(
        faults.iter().any(|fault| matches!(fault, AxisFault::Stated(Fault::NoColumnWithRatio { .. }))),
        "{faults:?}"
    );
}

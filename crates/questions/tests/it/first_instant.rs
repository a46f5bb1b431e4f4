//! The instant of every extremum is the first among equals: neither the unit of an input nor the segment at which the cycle is
//! written to begin moves it.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test may fail")]

use quantities::{Language, Measure};
use sizing::CheckId;

/// Values of a flywheel and its bearing loads: inertia, friction, viscous friction, force, lever.
type Values = [&'static str; 5];

const METRIC: Values = ["1.3 kg m^2", "5 N m", "0.5 N m s/rad", "500 N", "50 mm"];

/// Writes the values in other units, in as many digits as a number has.
const OTHERS: [Values; 3] = [
    ["1.3 kg m^2", "0.5098581064889641 kgf m", "0.5 N m s/rad", "500 N", "50 mm"],
    [
        "30.849468037069674 lb ft^2",
        "44.253728957902 lbf in",
        "0.5 N m s/rad",
        "112.40447154985 lbf",
        "1.9685039370078742 in",
    ],
    ["13000 kg cm^2", "3.68781074649183 lbf ft", "52.35987755982989 N m/krpm", "50.98581064889641 kgf", "0.05 m"],
];

const FORTH: &str =
    "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\nspeed = \"30 1/min\"\nacceleration = \"20 rad/s^2\"\n";
const BACK: &str =
    "[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\nspeed = \"30 1/min\"\nacceleration = \"20 rad/s^2\"\n";
const SMOOTH: &str = "[[motion]]\nlaw = \"modified_sine\"\ndistance = \"70 deg\"\ntime = \"0.3 s\"\n";
const BACK_SMOOTH: &str = "[[motion]]\nlaw = \"modified_sine\"\ndistance = \"-70 deg\"\ntime = \"0.3 s\"\n";
const REST: &str = "[[motion]]\nlaw = \"dwell\"\ntime = \"0.25 s\"\n";

/// Returns the instants of the checks \[s\].
fn instants(values: Values, moves: &[&str], head: &str) -> Vec<(CheckId, f64)> {
    let [inertia, friction, viscous, force, lever] = values;
    let text = format!(
        "format = 1\n[load]\ninertia = \"{inertia}\"\nfriction_torque = \"{friction}\"\nviscous_friction = \"{viscous}\"\n\
         [bearing]\nmechanism = \"ignore\"\nradial_force = \"{force}\"\nradial_distance = \"{lever}\"\naxial_force = \"0 N\"\n\
         axial_distance = \"0 mm\"\n{head}{}",
        moves.concat()
    );
    let project = questions::read(&text).unwrap();
    let code = questions::read_code("CHA-25A-50-H-C1024", Language::En).unwrap().parsed.code;
    let checks = questions::check(&project, &code).unwrap().judgement.checks;
    checks.iter().filter_map(|check| Some((check.id, check.at?.si()))).collect()
}

fn same(all: &[(CheckId, f64)], others: &[(CheckId, f64)], what: &str) {
    assert_eq!(all.len(), others.len(), "{what}");
    for ((id, at), (other, instant)) in all.iter().zip(others) {
        assert!(id == other && (at - instant).abs() < 1e-9, "{what}, {}: {at} {instant}", id.id());
    }
}

/// Cycles in which the largest values recur: the move and its mirror image, with and without pauses.
const CYCLES: [&[&str]; 4] = [
    &[FORTH, BACK],
    &[FORTH, REST, BACK, REST],
    &[SMOOTH, BACK_SMOOTH],
    &[SMOOTH, REST, BACK_SMOOTH, REST, FORTH, BACK, FORTH, BACK],
];

#[test]
fn units_do_not_move_the_instants() {
    for (number, cycle) in CYCLES.iter().enumerate() {
        let metric = instants(METRIC, cycle, "");
        assert!(metric.len() >= 6, "{metric:?}");
        for other in OTHERS {
            same(&metric, &instants(other, cycle, ""), &format!("cycle {number}, {other:?}"));
        }
    }
}

/// Move and mirror image alternate with equal pauses, so that everything recurs in half the cycle; begun at a pause, the first
/// instants are those of the same place in this period.
#[test]
fn the_beginning_of_the_cycle_does_not_choose_among_equals() {
    let head = "[requirements]\nambient = \"20 degC\"\n";
    for [forth, back] in [[FORTH, BACK], [SMOOTH, BACK_SMOOTH]] {
        let all = instants(METRIC, &[forth, REST, back, REST], head);
        let begun_at_a_pause = instants(METRIC, &[REST, back, REST, forth], head);
        // 90° at 3.1416 rad/s: 0.5 s and the 0.15708 s of one ramp.
        let of_move = if forth == FORTH { 0.5 + std::f64::consts::PI / 20.0 } else { 0.3 };
        let period = of_move + 0.25;
        for ((id, at), (_, begun)) in all.iter().zip(&begun_at_a_pause) {
            let expected = (at - of_move).rem_euclid(period);
            // The end of a period is the beginning of the next one.
            let off = (begun - expected).abs();
            assert!(off < 1e-9 || (off - period).abs() < 1e-9, "{}: {at} {begun}", id.id());
            assert!(*at < period + 1e-9, "{}: {at} is not the first", id.id());
        }
    }
}

/// Beyond the speed of an actuator the trace has no limit of torque, and its value is the torque at the largest speed: there the
/// acceleration vanishes, and a conveyor needs its friction alone, T = F d/(2 η). An instant beside it at which the speed is
/// equal up to rounding has another torque.
#[test]
fn beyond_the_speed_the_torque_is_that_of_the_largest_speed() {
    let mut found = 0;
    for (law, time, force, diameter) in
        [("modified_sine", 2.0, 60.0, 100.0), ("polynomial_5", 1.7, 35.0, 90.0), ("simple_sine", 1.3, 150.0, 70.0)]
    {
        let text = format!(
            "format = 1\n[axis]\nname = \"belt\"\n[mechanism.conveyor]\nroller_diameter = \"{diameter} mm\"\nmass = \"80 kg\"\n\
             inertia = \"0.01 kg m^2\"\nfriction_force = \"{force} N\"\nefficiency = 0.9\n[[motion]]\nlaw = \"{law}\"\n\
             distance = \"500 mm\"\ntime = \"{time} s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\
             [requirements]\nsupply = \"560 V\"\n"
        );
        let project = questions::read(&text).unwrap();
        let friction_nm = force * 1e-3 * diameter / 2.0 / 0.9;
        for code in questions::size(&project).rejected() {
            let Some(code) = code.id.order_code() else { continue };
            let candidate = questions::check(&project, code).unwrap();
            let mut checks = candidate.judgement.checks.iter();
            let trace = checks.find(|check| check.id == sizing::CheckId::TorqueSpeedTrace).unwrap();
            let (Some(value), Some(limit)) = (trace.value, trace.limit) else { continue };
            if limit.si == 0.0 {
                found += 1;
                assert!(
                    (value.si - friction_nm).abs() <= 1e-9 * friction_nm,
                    "{law}, {code}: {} {friction_nm}",
                    value.si
                );
            }
        }
    }
    assert!(found > 50, "{found} actuators are too slow");
}

/// One text as every file.
struct Only(String);

impl axis::Files for Only {
    fn open(&self, _name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::io::Cursor::new(self.0.clone().into_bytes())))
    }
}

/// The largest torque on a plateau of the speed is reported, though one sample beside it is faster by a rounding of the
/// logger; a sample that is faster by a visible share is the fastest alone.
#[test]
fn a_sample_faster_by_rounding_hides_no_plateau() {
    let mut found = 0;
    for (off, is_hidden) in [(0.0, false), (1e-10, false), (1e-5, true)] {
        let rows = (0..=400).map(|row| {
            let t = f64::from(row) * 0.01;
            let speed = if row == 120 { 9.0 * (1.0 + off) } else { (f64::from(row.min(400 - row)) * 0.1).min(9.0) };
            let torque = if row == 250 { 750.0 } else { 250.0 };
            format!("{t},{speed:.12},{torque}\n")
        });
        let text = "t [s],speed [rad/s],torque [Nm]\n".to_owned() + &rows.collect::<String>();
        let project = "format = 1\n[load]\ninertia = \"0.1 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = \"a.csv\"\n\
            [requirements]\nsupply = \"560 V\"\n";
        let project = questions::read_all(project, &Only(text)).unwrap().remove(0);
        for code in questions::size(&project).rejected().iter().step_by(9) {
            let Some(code) = code.id.order_code() else { continue };
            let candidate = questions::check(&project, code).unwrap();
            let mut checks = candidate.judgement.checks.iter();
            let trace = checks.find(|check| check.id == CheckId::TorqueSpeedTrace).unwrap();
            let (Some(value), Some(limit)) = (trace.value, trace.limit) else { continue };
            if limit.si == 0.0 {
                found += 1;
                let is_largest = (value.si - 750.0).abs() < 1.0;
                assert_eq!(is_largest, !is_hidden, "{off}, {code}: {} at {:?}", value.si, trace.at);
            }
        }
    }
    assert!(found > 30, "{found}");
}

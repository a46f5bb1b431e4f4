//! The law `points` from the project file to the demand, against values of other hands and closed forms.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may fail")]

use axis::AxisProject;
use quantities::Measure;
use std::f64::consts::TAU;

/// The points of `crates/motion/tests/reference_points.rs`.
const POINTS: [(f64, f64); 6] = [(0.0, 0.0), (0.1, 0.2), (0.25, 1.1), (0.3, 1.0), (0.55, -0.4), (0.7, 0.0)];

/// Instant, position, speed and acceleration of the cubic spline with natural ends: SciPy 1.17.1,
/// `validation/splines/splines.py`.
const NATURAL: [[f64; 4]; 7] = [
    [0.0, 0.0, 0.462648542361, 0.0],
    [0.07, 0.0851165529623, 2.72255518509, 64.5687612208],
    [0.2, 0.902329752168, 6.30843236157, -67.5664985324],
    [0.28, 1.06975958964, -2.67701188339, -93.1646747029],
    [0.41, 0.317129690006, -7.1343487048, 3.21400701034],
    [0.66, -0.180792270003, 4.23607238323, 21.2800775128],
    [0.7, 0.0, 4.66167393349, 0.0],
];

/// Comparison of the quintic spline with stated ends.
const STATED: [[f64; 4]; 7] = [
    [0.0, 0.0, 0.5, -3.0],
    [0.07, 0.0845773274701, 2.77145352539, 66.7629198122],
    [0.2, 0.896841816198, 6.42215424565, -69.5036864942],
    [0.28, 1.07768818063, -2.67501801693, -125.358580267],
    [0.41, 0.0557910439372, -9.26319166208, 41.5241589607],
    [0.66, 0.0298901927145, 0.649987057661, -89.758147809],
    [0.7, 0.0, -1.5, 8.0],
];

const STATES_ENDS: &str = "spline = \"quintic\"\nends = \"stated\"\nstart_speed = \"0.5 rad/s\"\nend_speed = \"-1.5 rad/s\"\n\
    start_acceleration = \"-3 rad/s^2\"\nend_acceleration = \"8 rad/s^2\"\n";

const LOAD: &str = "[load]\ninertia = \"2 kg m^2\"\nfriction_torque = \"3 N m\"\n";

fn text(load: &str, points: &str, more: &str) -> String {
    format!(
        "format = 1\n[axis]\nsingle_move = true\n{load}[[motion]]\nlaw = \"points\"\npoints = [{points}]\n{more}\
         [requirements]\nsupply = \"560 V\"\n"
    )
}

/// The points as rows, each column with its unit and a factor.
fn rows(points: &[(f64, f64)], over: (f64, &str), position: (f64, &str)) -> String {
    let row = |(t, q): &(f64, f64)| format!("[\"{} {}\", \"{} {}\"]", t * over.0, over.1, q * position.0, position.1);
    points.iter().map(row).collect::<Vec<_>>().join(", ")
}

fn read(text: &str) -> AxisProject {
    questions::read(text).unwrap()
}

/// Printed to twelve digits: half of the last one, and the rounding of both sides.
fn agrees(project: &AxisProject, expected: &[[f64; 4]]) {
    for [t, position, speed, acceleration] in expected {
        let pieces = project.axis.motion.pieces();
        let piece = pieces.iter().rev().find(|piece| *t + 1e-12 >= piece.start_s).unwrap();
        let state = piece.at(t - piece.start_s);
        let close = |found: f64, expected: f64, scale: f64| (found - expected).abs() < 8e-12 * scale;
        assert!(close(state.position_rad, *position, 1.0), "{t}: {state:?}");
        assert!(close(state.speed_rad_s, *speed, 2.0), "{t}: {state:?}");
        assert!(close(state.acceleration_rad_s2, *acceleration, 100.0), "{t}: {state:?}");
    }
}

#[test]
fn points_over_the_time_are_the_spline_of_scipy() {
    let over_time = rows(&POINTS, (1.0, "s"), (1.0, "rad"));
    agrees(&read(&text(LOAD, &over_time, "spline = \"cubic\"\nends = \"natural\"\n")), &NATURAL);
    agrees(&read(&text(LOAD, &over_time, STATES_ENDS)), &STATED);
}

/// A master of 90 min⁻¹ turns by 3π rad in a second: the same instants, as its angles.
#[test]
fn points_over_the_angle_of_a_master_are_the_same_motion() {
    let over_master = rows(&POINTS, (1.5 * 360.0, "deg"), (1.0, "rad"));
    let more = format!("master_speed = \"90 1/min\"\n{STATES_ENDS}");
    agrees(&read(&text(LOAD, &over_master, &more)), &STATED);
}

/// A lead of 20 mm: 20 mm / 2π along the line per radian.
#[test]
fn points_along_a_line_are_the_same_motion() {
    let along = rows(&POINTS, (1000.0, "ms"), (20.0 / TAU, "mm"));
    let screw = "[mechanism.screw]\nlead = \"20 mm\"\nmass = \"5 kg\"\n";
    agrees(&read(&text(screw, &along, "spline = \"cubic\"\nends = \"natural\"\n")), &NATURAL);
}

/// q = 3τ² − 2τ³ is a cubic from rest to rest: whatever its points, the spline is that polynomial. With T = 0.8 s and a
/// quarter turn α falls from 6·(π/2)/T² to its negative, and the speed reaches 1.5·(π/2)/T at half time.
#[test]
fn a_cubic_through_points_of_a_cubic_demands_what_the_polynomial_does() {
    let quarter = TAU / 4.0;
    let points = [0.0, 0.11, 0.3, 0.52, 0.8].map(|t: f64| {
        let tau = t / 0.8;
        (t, quarter * (3.0 - 2.0 * tau) * tau * tau)
    });
    let project = read(&text(LOAD, &rows(&points, (1.0, "s"), (1.0, "rad")), "spline = \"cubic\"\nends = \"rest\"\n"));
    let (inertia, friction) = (2.0, 3.0);
    let alpha = 6.0 * quarter / (0.8 * 0.8);
    let demand = project.axis.demand(quantities::MomentOfInertia::from_si(0.0));
    let close = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-9;
    assert!(close(demand.torque_peak.si(), inertia * alpha + friction), "{:?}", demand.torque_peak);
    assert!(close(demand.speed_peak.si(), 1.5 * quarter / 0.8), "{:?}", demand.speed_peak);
    // T = Jα(1 − 2τ) + T_f while it moves forward all the way: T_rms² = (Jα)²/3 + T_f².
    let rms = ((inertia * alpha).powi(2) / 3.0 + friction * friction).sqrt();
    assert!(close(demand.torque_rms.si(), rms), "{:?} {rms}", demand.torque_rms);
    let notes = project.assumptions;
    assert!(notes.contains(&axis::Assumption::SplineThroughPoints(motion::Spline::Cubic)), "{notes:?}");
}

/// Line and identifier of every fault.
fn faults(text: &str) -> Vec<(usize, &'static str)> {
    let found = questions::read(text).err().unwrap_or_default();
    found.iter().map(|each| (each.line, each.fault.id())).collect()
}

#[test]
fn all_faults_of_a_table_are_reported_at_once_with_their_places() {
    let wrong = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"2 kg m^2\"\n[[motion]]\nlaw = \"points\"\n\
        points = [\n[\"0 s\", \"0 deg\"],\n[\"0.2 s\", \"10 deg\"],\n[\"0.2 s\", \"20 deg\"],\n[\"0.1 s\", \"30 deg\"],\n]\n\
        master_speed = \"30 1/min\"\nspline = \"cubic\"\nends = \"rest\"\nstart_speed = \"1 1/min\"\n\
        end_acceleration = \"1 rad/s^2\"\n";
    let expected = [
        (11, "points_not_increasing"),
        (12, "points_not_increasing"),
        (14, "master_of_times"),
        (17, "key_of_another_kind"),
        (18, "key_of_another_kind"),
    ];
    assert_eq!(faults(wrong), expected);
    let missing = text(LOAD, "[\"0 deg\", \"0 mm\"]", "ends = \"stated\"\n");
    let expected = [(7, "missing_key"), (9, "no_line"), (9, "points_too_few"), (9, "missing_key")];
    let found = faults(&missing);
    assert!(expected.iter().all(|each| found.contains(each)), "{found:?}");
    let mixed = text(
        LOAD,
        "[\"0 s\", \"0 deg\"],\n[\"20 deg\", \"5 deg\"],\n[\"2 s\", \"7 mm\"]",
        "spline = \"cubic\"\nends = \"rest\"\n",
    );
    assert_eq!(faults(&mixed), [(10, "unlike_first_point"), (11, "unlike_first_point")]);
    let unit = text(
        LOAD,
        "[\"0 s\", \"0 deg\"], [\"1 s\", \"5 N\"], [\"2\", \"7 deg\"]",
        "spline = \"cubic\"\nends = \"rest\"\n",
    );
    let found = faults(&unit);
    assert!(found.contains(&(9, "unit_of_another_quantity")) && found.contains(&(9, "unit_missing")), "{found:?}");
}

#[test]
fn a_table_joins_its_neighbours_in_speed() {
    let with = |ends: &str| {
        format!(
            "format = 1\n[axis]\nsingle_move = true\n{LOAD}[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\nhold = \"motor\"\n\
             [[motion]]\nlaw = \"points\"\npoints = [[\"0 s\", \"0 deg\"], [\"0.3 s\", \"40 deg\"], [\"0.6 s\", \"50 deg\"]]\n\
             spline = \"cubic\"\n{ends}\n"
        )
    };
    assert_eq!(faults(&with("ends = \"rest\"")), []);
    assert_eq!(faults(&with("ends = \"natural\"")), [(13, "points_speed_jumps")]);
    assert_eq!(
        faults(&with("ends = \"stated\"\nstart_speed = \"0 1/min\"\nend_speed = \"2 1/min\"")),
        [],
        "a single move may end in motion"
    );
}

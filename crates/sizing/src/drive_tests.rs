use super::*;
use crate::check::Verdict;
use crate::judge::{Scope, judge};
use actuator::{Drivetrain, Parameters};
use mechanism::{Extra, Mechanism};
use motion::{Closing, ManualMove, Motion, SegmentSpec};
use provenance::{CellRef, Datum, Sourced};
use quantities::{AngularVelocity, MomentOfInertia, NoLoadCurrentConstant, Torque, TorqueConstant};
use std::sync::Arc;

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("54.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

/// Returns an actuator with J_out = 2 kgm², k_Tout = 10 Nm/A, I_s = 0.5 A and K = 0.1 A/(rad/s) at every temperature.
fn actuator() -> Parameters {
    let constant = NoLoadCurrentConstant::from_si(0.1);
    Parameters {
        inertia_out: known(MomentOfInertia::from_si(2.0)),
        ..Drivetrain {
            torque_constant_out: known(TorqueConstant::from_si(10.0)),
            no_load_starting_current: known(ElectricCurrent::from_si(0.5)),
            no_load_current_constant_cold: known(constant),
            no_load_current_constant_warm: known(constant),
            no_load_temperatures: known([303.15, 353.15].map(quantities::ThermodynamicTemperature::from_si)),
            friction_printed_from: known(quantities::ThermodynamicTemperature::from_si(293.15)),
            stall_current_includes_friction: true,
            ..Drivetrain::unknown()
        }
        .into()
    }
}

/// Returns a load of 1 kgm² at 5 rad/s after 0.5 s with 10 rad/s², for 1 s, and back to rest in 0.5 s.
///
/// T = 30 Nm, 0, −30 Nm, so that I = 3 + 0.5 + 0.1 ω: 3.5 to 4 A; 1 A; −3 + 0.5 + 0.1 ω: −2 to −2.5 A; 0 at rest.
fn axis(pause: f64, drive: [Option<f64>; 3]) -> Axis {
    let second = Time::from_si;
    let moved = SegmentSpec::Manual(ManualMove {
        speed: AngularVelocity::from_si(5.0),
        accelerate: second(0.5),
        run: second(1.0),
        brake: second(0.5),
        pause: second(pause),
    });
    let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
    let motion = Motion::new(&[moved], None, Closing::Speed).unwrap();
    let mut axis = Axis::new(load, motion, vec![Extra::none()]);
    let [continuous, peak, time] = drive;
    axis.asked.drive_current_continuous = continuous.map(ElectricCurrent::from_si);
    axis.asked.drive_current_peak = peak.map(ElectricCurrent::from_si);
    axis.asked.drive_peak_time = time.map(second);
    axis
}

fn check(axis: &Axis, actuator: &Parameters, id: CheckId) -> Option<Check> {
    judge(axis, actuator, Scope::All).checks.iter().find(|check| check.id == id).cloned()
}

/// Returns verdict, value and limit of a check.
fn judged(id: CheckId, pause: f64, drive: [Option<f64>; 3]) -> (Verdict, f64, f64) {
    let check = check(&axis(pause, drive), &actuator(), id).unwrap();
    (check.verdict, check.value.unwrap().si, check.limit.unwrap().si)
}

fn near(found: f64, value: f64) {
    assert!((found - value).abs() < 1e-9, "{found} {value}");
}

/// The largest current is 4 A, at the end of the acceleration.
#[test]
fn the_peak_current_by_hand() {
    for (limit, verdict) in [(3.99, Verdict::Fail), (4.0, Verdict::Pass), (4.01, Verdict::Pass)] {
        let (found, value, at) = judged(CheckId::DriveCurrentPeak, 2.0, [None, Some(limit), None]);
        assert_eq!((found, at), (verdict, limit));
        near(value, 4.0);
    }
    let at = check(&axis(2.0, [None, Some(5.0), None]), &actuator(), CheckId::DriveCurrentPeak).unwrap().at.unwrap();
    near(at.si(), 0.5);
}

/// ∫I² dt = 0.5 (3.5² + 3.5·4 + 4²)/3 + 1 + 0.5 (2² + 2·2.5 + 2.5²)/3 = 127/12 A²s over 4 s.
#[test]
fn the_effective_current_by_hand() {
    let effective = (127.0_f64 / 48.0).sqrt();
    for (limit, verdict) in [(1.62, Verdict::Fail), (effective, Verdict::Pass), (1.63, Verdict::Pass)] {
        let (found, value, _) = judged(CheckId::DriveCurrent, 2.0, [Some(limit), None, None]);
        assert_eq!(found, verdict, "{limit}");
        near(value, effective);
    }
}

/// I rises by 1 A/s while accelerating and |I| while braking: above 3.75 A for the last 0.25 s of the acceleration, above
/// 2.25 A for all of it, above 0.9 A from the beginning to the end of the move, above 1.9 A also over the seam of a cycle
/// without a pause.
#[test]
fn the_longest_time_above_the_continuous_current_by_hand() {
    let longest = |pause: f64, level: f64| {
        let axis = axis(pause, [None; 3]);
        let actuator = actuator();
        let electrics = crate::electrics::Electrics::of(&axis, &actuator);
        let currents = Currents::of(&axis, &actuator, &electrics).unwrap();
        longest_above(&axis, &currents, level)
    };
    near(longest(2.0, 4.5), 0.0);
    near(longest(2.0, 3.75), 0.25);
    near(longest(2.0, 2.25), 0.5);
    near(longest(2.0, 0.9), 2.0);
    near(longest(0.0, 1.9), 1.0);
    near(longest(0.0, 0.9), 2.0);
    for (limit, verdict) in [(0.24, Verdict::Fail), (0.25, Verdict::Pass), (0.26, Verdict::Pass)] {
        let (found, value, _) = judged(CheckId::DrivePeakTime, 2.0, [Some(3.75), Some(40.0), Some(limit)]);
        assert_eq!(found, verdict, "{limit}");
        near(value, 0.25);
    }
}

/// A current that lies at the continuous one but for rounding is not above it, with one sample of a plateau 10⁻¹⁰ higher or
/// lower as without; a millionth above, the whole plateau is.
#[test]
fn a_plateau_at_the_continuous_current_is_not_above_it() {
    for off in [0.0, 1e-10, -1e-10] {
        let speed: Vec<f64> = (0..41).map(|k| if k == 20 { 5.0 * (1.0 + off) } else { 5.0 }).collect();
        let samples = motion::Samples {
            time_s: Arc::new((0..41).map(|k| f64::from(k) * 0.05).collect()),
            speed_rad_s: Some(Arc::new(speed)),
            torque_nm: Some(Arc::new(vec![30.0; 41])),
            ..motion::Samples::default()
        };
        let recorded = motion::Recorded::new(samples, motion::Treatment::default()).unwrap();
        let load = Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0));
        let motion = Motion::new(&[SegmentSpec::Recorded(Arc::new(recorded))], None, Closing::Speed).unwrap();
        let axis = Axis::new(load, motion, vec![Extra::none()]);
        let actuator = actuator();
        let electrics = crate::electrics::Electrics::of(&axis, &actuator);
        let currents = Currents::of(&axis, &actuator, &electrics).unwrap();
        // 30 Nm and 5 rad/s: 3 + 0.5 + 0.5 A.
        for (share, expected) in [(1.0, 0.0), (1.0 - 1e-11, 0.0), (1.0 + 1e-11, 0.0), (1.0 - 1e-6, 2.0)] {
            let longest = longest_above(&axis, &currents, 4.0 * share);
            assert!((longest - expected).abs() < 1e-9, "{off}, {share}: {longest}");
        }
    }
}

/// Every rating of the drive has a check of its own: the one that is exceeded fails, the others keep their values.
#[test]
fn each_rating_has_a_check_of_its_own() {
    use CheckId::{DriveCurrent, DriveCurrentPeak, DrivePeakTime};
    let kept = [1.7, 8.0, 2.1];
    for (at, exceeded) in [(0, 1.6), (1, 3.9), (2, 0.4)] {
        let mut drive = kept.map(Some);
        drive[at] = Some(exceeded);
        for (place, id) in [DriveCurrent, DriveCurrentPeak, DrivePeakTime].into_iter().enumerate() {
            let (verdict, _, limit) = judged(id, 2.0, drive);
            let expected = if place == at { (Verdict::Fail, exceeded) } else { (Verdict::Pass, kept[place]) };
            assert_eq!((verdict, limit), expected, "{id:?}");
        }
    }
}

#[test]
fn without_a_rating_there_is_no_check_and_without_a_current_none_is_made() {
    let of = |actuator: &Parameters, drive, id| check(&axis(2.0, drive), actuator, id);
    let time_only = [None, None, Some(1.0)];
    assert!(of(&actuator(), time_only, CheckId::DriveCurrent).is_none());
    assert!(of(&actuator(), time_only, CheckId::DriveCurrentPeak).is_none());
    let missing = of(&actuator(), time_only, CheckId::DrivePeakTime).unwrap().missing;
    assert_eq!(missing, Some("drive.current_continuous"));
    let unknown = Parameters { inertia_out: known(MomentOfInertia::from_si(2.0)), ..Parameters::unknown() };
    let found = of(&unknown, [Some(3.0), None, None], CheckId::DriveCurrent).unwrap();
    assert_eq!((found.verdict, found.missing), (Verdict::NotChecked, Some("k_Tout")));
}

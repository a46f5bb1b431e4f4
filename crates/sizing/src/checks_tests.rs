use super::*;
use crate::brake_times::brakings;
use crate::judge::{Scope, judge};
use crate::notes::Note;
use crate::{Supply, SupplyFrom};
use actuator::{Brake, Drivetrain, Feedback, FeedbackSide, Gear, ScrewJoint};
use mechanism::{Extra, Mechanism};
use motion::{Closing, Given, Hold, Law, ManualMove, Motion, SegmentSpec};
use provenance::{CellRef, Datum, Sourced};
use quantities::{
    Angle, AngularAcceleration, AngularVelocity, ElectricPotential, Measure, MomentOfInertia, Time, Torque,
};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("54.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

/// Returns an actuator with i = 100, J_out = 2 kgm² and a brake of 60 Nm.
fn actuator() -> Parameters {
    let joint = || ScrewJoint { transmissible_torque: known(Torque::from_si(500.0)), ..ScrewJoint::default() };
    Parameters {
        inertia_out: known(MomentOfInertia::from_si(2.0)),
        brake: Brake {
            holding_torque: known(Torque::from_si(60.0)),
            closing_time: known(Time::from_si(0.07)),
            opening_time: known(Time::from_si(0.11)),
            brakings_max: known(1e7),
            ..Brake::default()
        },
        ..Drivetrain {
            ratio: known(100.0),
            dc_link_max: known(ElectricPotential::from_si(680.0)),
            screw_joint_load: joint(),
            screw_joint_housing: joint(),
            ..Drivetrain::unknown()
        }
        .into()
    }
}

fn unbraked() -> Parameters {
    Parameters { brake: Brake::absent(), ..actuator() }
}

fn swing(acceleration: f64) -> SegmentSpec {
    let given = Given {
        distance: Some(Angle::from_si(1.0)),
        acceleration: Some(AngularAcceleration::from_si(acceleration)),
        ..Given::default()
    };
    SegmentSpec::Move(Law::Triangle, given)
}

fn dwell(time: f64, hold: Hold) -> SegmentSpec {
    SegmentSpec::Dwell(Time::from_si(time), hold)
}

/// Returns a load of 1 kgm² with friction 3 Nm and a constant torque of 39 Nm.
fn axis(segments: &[SegmentSpec]) -> Axis {
    let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(3.0));
    let mut pull = Extra::none();
    pull.torque = Torque::from_si(39.0);
    let times = crate::BrakeTimes { closing: Time::from_si(0.07), opening: Time::from_si(0.11) };
    Axis::braked(load, Motion::new(segments, None, Closing::Speed).unwrap(), vec![pull; segments.len()], times)
}

fn check(axis: &Axis, actuator: &Parameters, id: CheckId) -> Check {
    judge(axis, actuator, Scope::All).checks.iter().find(|check| check.id == id).unwrap().clone()
}

/// ∫T² over the dwells: 39² Nm² for as long as the motor holds.
#[test]
fn the_motor_holds_until_the_brake_has_closed_and_while_it_opens() {
    let moving = [swing(4.0)];
    let square = |segments: &[SegmentSpec]| {
        let axis = axis(segments);
        let demand = axis.demand(MomentOfInertia::from_si(2.0));
        demand.torque_rms.si().powi(2) * axis.moments().duration.si()
    };
    let move_alone = square(&moving);
    let held = |dwells: &[SegmentSpec]| {
        let all: Vec<SegmentSpec> = moving.iter().chain(dwells).cloned().collect();
        (square(&all) - move_alone) / (39.0 * 39.0)
    };
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a} {b}");
    near(held(&[dwell(1.0, Hold::Motor)]), 1.0);
    near(held(&[dwell(1.0, Hold::Brake)]), 0.18);
    near(held(&[dwell(0.05, Hold::Brake)]), 0.05);
    near(held(&[dwell(0.18, Hold::Brake)]), 0.18);
    // Between two dwells that the brake holds it stays closed.
    near(held(&[dwell(0.6, Hold::Brake), dwell(0.4, Hold::Brake)]), 0.18);
    near(held(&[dwell(0.6, Hold::Brake), dwell(0.4, Hold::Motor)]), 0.58);
    // And over the seam of the cycle.
    let around = [dwell(0.5, Hold::Brake), swing(4.0), dwell(0.5, Hold::Brake)];
    near((square(&around) - move_alone) / (39.0 * 39.0), 0.18);
    let course = crate::Course::of(&axis(&[swing(4.0), dwell(1.0, Hold::Brake)]), &actuator());
    let held: f64 = course
        .samples
        .windows(2)
        .map(|pair| {
            let rests = pair[0].acceleration_rad_s2 == 0.0 && pair[1].acceleration_rad_s2 == 0.0;
            let both = pair[0].torque_nm.min(pair[1].torque_nm);
            if rests && both > 38.0 { pair[1].time_s - pair[0].time_s } else { 0.0 }
        })
        .sum();
    near(held, 0.18);
}

/// Once a cycle of the move of 1 s and a dwell of 1 s: 2·10⁷ s.
#[test]
fn brakings_are_counted() {
    let mut axis = axis(&[swing(4.0), dwell(1.0, Hold::Brake)]);
    let of = |axis: &Axis| check(axis, &actuator(), CheckId::BrakeHolding);
    let lasting = of(&axis).notes.iter().find_map(|note| match note {
        Note::BrakingsLast { each_cycle, lasts } => Some((*each_cycle, lasts.unwrap().si())),
        _ => None,
    });
    let (each, lasts) = lasting.unwrap();
    assert!(each == 1.0 && (lasts / 2e7 - 1.0).abs() < 1e-12, "{lasts}");
    for (life, verdict) in [(1.99e7, Verdict::Pass), (2.01e7, Verdict::Fail)] {
        axis.asked.service_life = Some(Time::from_si(life));
        let found = check(&axis, &actuator(), CheckId::BrakeApplications);
        assert_eq!(found.verdict, verdict);
        assert!((found.value.unwrap().si - life / 2.0).abs() < 1e-3 && found.limit.unwrap().si == 1e7);
    }
    let short = self::axis(&[swing(4.0), dwell(0.05, Hold::Brake)]);
    let noted = |note: &Note| matches!(note, Note::DwellTooShortForBrake { shortest, .. } if (shortest.si() - 0.05).abs() < 1e-12);
    assert!(of(&short).notes.iter().any(noted));
    let small = Parameters { brake: Brake { closing_time: Datum::NotPrinted, ..actuator().brake }, ..actuator() };
    assert!(check(&short, &small, CheckId::BrakeHolding).notes.contains(&Note::BrakeTimesAssumed));
    // Kept open for the move and the last 0.11 s of the dwell.
    assert!((axis.brake_open_share().si() - 1.11 / 2.0).abs() < 1e-12);
    assert_eq!(short.brake_open_share().si(), 1.0);
}

/// Returns path, work of the brake and time of a stop, by small steps: no torque but 39 Nm for 0.07 s, then 60 Nm against it.
fn stepped(inertia: f64, speed: f64) -> [f64; 3] {
    let (dt, mut speed) = (1e-6, speed);
    let [mut path, mut work, mut time] = [0.0; 3];
    while time < 0.07 || speed > 0.0 {
        let brake = if time < 0.07 { 0.0 } else { 60.0 };
        let after = speed + (39.0 - brake) / inertia * dt;
        let way = 0.5 * (speed + after.max(0.0)) * dt;
        path += way;
        work += brake * way;
        (time, speed) = (time + dt, after);
    }
    [path, work, time]
}

/// A stop is that of the load that is the worst: a light one gathers speed until the brake has closed, a heavy one has the energy.
#[test]
fn a_stop_by_the_brake_is_no_shorter_than_that_of_any_load_of_the_cycle() {
    for (acceleration, added) in [(1e-4, 20.0), (0.05, 20.0), (4.0, 20.0), (60.0, 20.0), (4.0, 0.0)] {
        let plain = axis(&[swing(acceleration), swing(acceleration)]);
        let mut extras = plain.extras.clone();
        extras[1].inertia = MomentOfInertia::from_si(added);
        let axis = Axis::new(plain.mechanism.clone(), plain.motion.clone(), extras);
        let found = check(&axis, &actuator(), CheckId::BrakeEmergency);
        let Some(Note::BrakeStop(stop)) = found.notes.iter().find(|note| matches!(note, Note::BrakeStop(_))) else {
            panic!("{found:?}")
        };
        let speed = axis.moments().speed_peak.si();
        let loads = [3.0, 3.0 + 0.3 * added, 3.0 + added].map(|inertia| stepped(inertia, speed));
        let shown = [stop.angle.si(), stop.energy.si(), stop.time.si()];
        for (k, shown) in shown.into_iter().enumerate() {
            let worst = loads.iter().map(|each| each[k]).fold(0.0, f64::max);
            assert!((shown / worst - 1.0).abs() < 1e-4, "{acceleration} {added} {k}: {shown} {loads:?}");
        }
        assert!((found.value.unwrap().si - stop.angle.si()).abs() < 1e-12);
    }
}

/// 60 Nm hold 39 Nm 1.538 times.
#[test]
fn the_brake_holds_with_the_safety_that_is_asked() {
    let mut axis = axis(&[swing(4.0), dwell(1.0, Hold::Motor)]);
    for (safety, verdict) in [(None, Verdict::Pass), (Some(1.53), Verdict::Pass), (Some(1.54), Verdict::Fail)] {
        axis.asked.holding_safety = safety;
        let found = check(&axis, &actuator(), CheckId::BrakeHolding);
        assert_eq!(found.verdict, verdict, "{safety:?}");
        assert!((found.utilisation.unwrap() - 39.0 / 60.0 * safety.unwrap_or(1.0)).abs() < 1e-12);
    }
}

#[test]
fn a_hanging_load_without_a_brake_is_reported_and_not_rejected() {
    let hanging = axis(&[swing(4.0), dwell(1.0, Hold::Motor)]);
    let found = check(&hanging, &unbraked(), CheckId::BrakeHolding);
    assert_eq!(found.verdict, Verdict::Advice);
    assert_eq!(found.notes[..], [Note::NothingHoldsWithoutPower]);
    assert!(judge(&hanging, &unbraked(), Scope::All).fits());
    let unknown = Parameters { brake: Brake::default(), ..actuator() };
    let found = check(&hanging, &unknown, CheckId::BrakeHolding);
    assert_eq!((found.verdict, found.missing), (Verdict::NotChecked, Some("T_Br")));
    let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(3.0));
    let level = Axis::new(load, Motion::new(&[swing(4.0)], None, Closing::Speed).unwrap(), Vec::new());
    assert!(judge(&level, &unbraked(), Scope::All).checks.iter().all(|check| check.id != CheckId::BrakeHolding));
}

#[test]
fn the_dc_link_may_rise_above_its_stationary_limit_for_a_while() {
    let mut axis = axis(&[swing(4.0)]);
    let of = |axis: &Axis| check(axis, &unbraked(), CheckId::DcLink);
    let volt = ElectricPotential::from_si;
    for (supply, rise, verdict, value) in [
        (560.0, None, Verdict::Pass, 560.0),
        (560.0, Some(120.0), Verdict::Pass, 560.0),
        (560.0, Some(200.0), Verdict::Advice, 760.0),
        (700.0, Some(200.0), Verdict::Fail, 700.0),
    ] {
        axis.supply = Some(Supply { reserve: 0.9, from: SupplyFrom::DcLink(volt(supply)) });
        axis.asked.dc_link_rise = rise.map(volt);
        let found = of(&axis);
        assert_eq!((found.verdict, found.value.unwrap().si), (verdict, value));
    }
}

/// J_out α = 80 Nm turns the rotor and passes neither joint: the load takes 1·40 + 39 + 3 Nm, and the housing the
/// angular momentum of the rotor besides, 2/100·40 Nm. The reaction by the momenta of rotor and load, one by one.
#[test]
fn the_joints_carry_what_passes_them() {
    let axis = axis(&[swing(40.0)]);
    let load = check(&axis, &actuator(), CheckId::ScrewJointLoad).value.unwrap().si;
    let housing = check(&axis, &actuator(), CheckId::ScrewJointHousing).value.unwrap().si;
    assert!((load - 82.0).abs() < 1e-9, "{load}");
    let rotor = 2.0 / (100.0 * 100.0);
    for sense in [1.0, -1.0] {
        // d/dt of the angular momentum inside the actuator; on it act the load and the housing.
        let inside: f64 = sense * rotor * 100.0 * 40.0;
        assert!((82.0 + inside) <= housing + 1e-9);
    }
    assert!((housing - 82.8).abs() < 1e-9, "{housing}");
}

#[test]
fn a_collision_above_the_ratcheting_torque_is_against_advice() {
    let mut axis = axis(&[swing(4.0)]);
    let gear = |rated: Datum<Torque>| {
        let mut own = actuator();
        own.gear = Gear {
            collision_torque_max: rated,
            ratcheting_torque: known(Torque::from_si(200.0)),
            buckling_torque: known(Torque::from_si(330.0)),
            ..Gear::default()
        };
        own
    };
    let noted = Note::Ratcheting { ratcheting: Torque::from_si(200.0), buckling: Some(Torque::from_si(330.0)) };
    let rated = known(Torque::from_si(110.0));
    for (torque, of, verdict) in [
        (190.0, Datum::NotPrinted, Verdict::NotChecked),
        (210.0, Datum::NotPrinted, Verdict::Advice),
        (100.0, rated.clone(), Verdict::Pass),
        (210.0, rated, Verdict::Fail),
    ] {
        axis.asked.collision_torque = Some(Torque::from_si(torque));
        let found = check(&axis, &gear(of), CheckId::CollisionTorque);
        assert_eq!(found.verdict, verdict, "{torque}");
        assert!(found.notes.contains(&noted));
    }
}

/// A resolver is absolute within one turn of the motor; its reference is lost for 1/i, not for 4096/i.
#[test]
fn an_endless_axis_names_the_turns_of_its_encoder() {
    let run = ManualMove {
        speed: AngularVelocity::from_si(1.0),
        accelerate: Time::from_si(0.1),
        run: Time::from_si(1.0),
        brake: Time::from_si(0.1),
        pause: Time::from_si(0.1),
    };
    let axis = axis(&[SegmentSpec::Manual(run)]);
    let of = |turns: Datum<f64>| {
        let feedback = Feedback { single_turn_absolute: true, turns_absolute: turns, ..Feedback::default() };
        let actuator = Parameters { feedback, feedback_out: Feedback::absent(FeedbackSide::Output), ..unbraked() };
        check(&axis, &actuator, CheckId::FeedbackRange).notes[0].clone()
    };
    assert_eq!(of(Datum::NotApplicable), Note::ReferenceLost { turns: 1.0 });
    assert_eq!(of(known(4096.0)), Note::ReferenceLost { turns: 4096.0 });
}

#[test]
fn without_torque_the_gear_has_no_life_to_tell() {
    let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
    let given =
        Given { speed: Some(AngularVelocity::from_si(1.0)), time: Some(Time::from_si(1.0)), ..Given::default() };
    let motion = Motion::new(&[SegmentSpec::Move(Law::Constant, given)], None, Closing::Speed).unwrap();
    let gear = Gear { rated_torque: known(Torque::from_si(25.0)), ..Gear::default() };
    let mut own = unbraked();
    own.gear = gear;
    let mut axis = Axis::new(load, motion, Vec::new());
    axis.asked.gear_life_min = Some(Time::from_si(3.6e7));
    let found = check(&axis, &own, CheckId::GearLife);
    assert_eq!((found.verdict, found.missing), (Verdict::NotChecked, Some("gear_load")));
}

/// The list is sorted by stage, and the results of an actuator, some of which others share, are in its order.
#[test]
fn results_are_in_the_order_of_the_list() {
    assert!(CheckId::ALL.is_sorted_by_key(|id| id.stage()));
    let found = judge(&axis(&[swing(10.0), dwell(1.0, Hold::Motor)]), &actuator(), Scope::All).checks;
    let ids: Vec<CheckId> = found.iter().map(|check| check.id).collect();
    assert!(ids.is_sorted_by(|a, b| a < b) && ids.len() == found.len(), "{ids:?}");
    assert!(CheckId::ALL.iter().all(|id| found.of(*id).is_some() == ids.contains(id)));
    assert!(ids.contains(&CheckId::PeakSpeed) && ids.contains(&CheckId::PeakTorque), "{ids:?}");
}

/// A rest that the brake holds may be divided into any dwells, also across the end of the cycle: T_rms, the number of brakings and the
/// time in which the coil draws current are those of one dwell.
#[test]
fn dividing_a_rest_that_the_brake_holds_changes_nothing() {
    let of = |parts: &[f64], at_end: &[f64]| {
        let mut segments: Vec<SegmentSpec> = parts.iter().map(|time| dwell(*time, Hold::Brake)).collect();
        segments.extend([swing(10.0), swing(10.0)]);
        segments.extend(at_end.iter().map(|time| dwell(*time, Hold::Brake)));
        let axis = axis(&segments);
        let rms = axis.demand(MomentOfInertia::from_si(2.0)).torque_rms.si();
        [rms, brakings(&axis).each_cycle, axis.brake_open_share().si()]
    };
    // t_c = 70 ms, t_o = 110 ms: rests that are longer, equal and shorter.
    for whole in [0.4, 0.18, 0.1] {
        let expected = of(&[whole], &[]);
        let tenths = [0.1 * whole; 10];
        let divided: [(&[f64], &[f64]); 5] = [
            (&[0.15 * whole, 0.85 * whole], &[]),
            (&[0.85 * whole, 0.15 * whole], &[]),
            (&tenths, &[]),
            (&[0.3 * whole], &[0.7 * whole]),
            (&[0.05 * whole, 0.05 * whole], &[0.1 * whole, 0.8 * whole]),
        ];
        for (parts, at_end) in divided {
            let found = of(parts, at_end);
            for (one, other) in found.iter().zip(&expected) {
                assert!(
                    (one - other).abs() < 1e-12 * other.max(1.0),
                    "{whole} {parts:?} {at_end:?}: {found:?} {expected:?}"
                );
            }
        }
    }
}

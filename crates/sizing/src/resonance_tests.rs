use super::*;
use crate::judge::{Scope, judge};
use actuator::{Drivetrain, Gear};
use mechanism::{Mechanism, MechanismKind, SliderCrank};
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use provenance::{CellRef, Datum};
use quantities::unit::REVOLUTION_PER_MINUTE as RPM;
use quantities::{Angle, AngularVelocity, Length, Mass, MomentOfInertia, Time, Torque, TorsionalStiffness};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("54.1", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

/// Returns the gear of the manual's example with a rotor of 3 kgm².
fn actuator() -> Parameters {
    Parameters {
        inertia_out: known(MomentOfInertia::from_si(3.0)),
        ..Drivetrain {
            ratio: known(100.0),
            gear: Gear {
                stiffness: [6.7e4, 1.1e5, 1.2e5].map(|k| known(TorsionalStiffness::from_si(k))),
                ..Gear::default()
            },
            ..Drivetrain::unknown()
        }
        .into()
    }
}

fn hold(speed: f64, time: f64) -> SegmentSpec {
    let given = Given {
        speed: Some(AngularVelocity::new_in(speed, &RPM)),
        time: Some(Time::from_si(time)),
        ..Given::default()
    };
    SegmentSpec::Move(Law::Constant, given)
}

fn check(axis: &Axis) -> Check {
    let judged = judge(axis, &actuator(), Scope::All);
    judged.checks.iter().find(|check| check.id == CheckId::ResonanceSpeed).unwrap().clone()
}

/// Returns the speed n of 2 i n/60 = f by hand.
fn resonant(k: f64, inertia: f64) -> f64 {
    60.0 * (k / inertia).sqrt() / (2.0 * std::f64::consts::PI) / 200.0
}

/// J = 1 kgm², and in a second segment 3 kgm² more: each held speed meets the resonance of its own inertia.
#[test]
fn every_inertia_of_the_cycle_counts() {
    let axis = |speed| {
        let motion = Motion::new(&[hold(speed, 1.0), hold(speed, 1.0)], None, Closing::Speed).unwrap();
        let mut heavy = Extra::none();
        heavy.inertia = MomentOfInertia::from_si(3.0);
        let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
        Axis::new(load, motion, vec![Extra::none(), heavy])
    };
    for k in [6.7e4, 1.1e5, 1.2e5] {
        for load in [1.0, 4.0] {
            for inertia in [load, load * 3.0 / (load + 3.0)] {
                let found = check(&axis(resonant(k, inertia)));
                assert_eq!(found.verdict, Verdict::Advice, "{k} {inertia}");
                assert!(found.value.unwrap().si < 1e-12);
                let at = if load == 1.0 { 0.0 } else { 1.0 };
                assert!((found.at.unwrap().si() - at).abs() < 1e-12, "{k} {inertia}");
            }
        }
    }
    // Between the lines there is room: above the highest of J = 1 with a free rotor.
    assert_eq!(check(&axis(resonant(1.2e5, 0.75) * 1.2)).verdict, Verdict::Pass);
    // Far above it the distance is what it is, beyond 100 %.
    let far = check(&axis(resonant(1.2e5, 0.75) * 30.0));
    assert!((far.value.unwrap().si - 29.0).abs() < 1e-9, "{far:?}");
    assert!((far.utilisation.unwrap() - 0.1 / 29.0).abs() < 1e-12, "{far:?}");
}

/// While a crank turns its inertia changes: every speed between the resonances of the largest and the least is one.
#[test]
fn a_changing_inertia_resonates_over_a_range() {
    let crank = SliderCrank {
        crank: Length::from_si(0.3),
        rod: Length::from_si(1.0),
        inertia: MomentOfInertia::from_si(0.5),
        mass: Mass::from_si(10.0),
        inclination: Angle::from_si(0.0),
        angle: Angle::from_si(0.0),
    };
    let axis = |speed: f64| {
        let motion =
            Motion::new(&[hold(speed, 120.0 / speed)], Some(Angle::from_si(0.3)), Closing::Revolutions).unwrap();
        let load = Mechanism {
            kind: MechanismKind::SliderCrank(crank),
            ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
        };
        Axis::new(load, motion, Vec::new())
    };
    let (largest, least) = axis(10.0).trace.inertia();
    let (largest, least) = (largest.si(), least.si());
    assert!(largest > 1.5 * least);
    let (low, high) = (resonant(6.7e4, largest), resonant(6.7e4, least));
    let d = |speed| check(&axis(speed)).value.unwrap().si;
    for share in [0.02, 0.5, 0.98] {
        assert!(d(low + share * (high - low)) < 1e-12, "{share}");
    }
    assert!((d(0.9 * low) - 0.1).abs() < 1e-4, "{}", d(0.9 * low));
    let again = judge(&axis(0.9 * low), &actuator(), Scope::All);
    let note = again.checks.iter().find(|check| check.id == CheckId::ResonanceSpeed).unwrap().notes[0].clone();
    let Note::ResonanceSpeeds(speeds) = note else { panic!("{note:?}") };
    let ResonanceSpeeds { blocked, free: Some(free) } = *speeds else { panic!("{speeds:?}") };
    assert!((blocked[0].0.in_unit(&RPM) / low - 1.0).abs() < 1e-4 && blocked[0].1.in_unit(&RPM) > 1.1 * low);
    assert!(free.iter().zip(blocked).all(|(free, blocked)| free.0.si() > blocked.0.si()));
}

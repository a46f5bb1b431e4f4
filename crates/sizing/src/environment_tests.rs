use super::*;
use crate::judge::{Scope, judge};
use actuator::{Drivetrain, Environment, Parameters, Protection};
use mechanism::Mechanism;
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use provenance::{CellRef, Grade, Source, Sourced};
use quantities::{AngularVelocity, Length, MomentOfInertia, Ratio, Time, Torque};

fn known<T>(value: T) -> Datum<T> {
    const CELL: CellRef = CellRef::of_the_manual("13.2", "x", "");
    Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
}

fn in_g(value: f64) -> Acceleration {
    Acceleration::new_in(value, &STANDARD_GRAVITY)
}

/// Returns an actuator with the data of table 13.2.
fn actuator() -> Parameters {
    let environment = Environment {
        altitude_max: known(Length::from_si(1000.0)),
        protection: known(Protection { solids: 6, water: 5 }),
        humidity: known((Ratio::from_si(0.2), Ratio::from_si(0.8))),
        vibration_max: known(in_g(5.0)),
        shock_max: known(in_g(30.0)),
    };
    Drivetrain { environment, ..Drivetrain::unknown() }.into()
}

fn axis(state: impl Fn(&mut crate::AxisRequirements)) -> Axis {
    let load = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(1.0));
    let given =
        Given { speed: Some(AngularVelocity::from_si(1.0)), time: Some(Time::from_si(1.0)), ..Given::default() };
    let motion = Motion::new(&[SegmentSpec::Move(Law::Constant, given)], None, Closing::Speed).unwrap();
    let mut axis = Axis::new(load, motion, Vec::new());
    state(&mut axis.asked);
    axis
}

fn found(id: CheckId, actuator: &Parameters, state: impl Fn(&mut crate::AxisRequirements)) -> Option<Check> {
    judge(&axis(state), actuator, Scope::All).checks.iter().find(|check| check.id == id).cloned()
}

const ALL: [CheckId; 6] =
    [CheckId::Altitude, CheckId::Protection, CheckId::Humidity, CheckId::Vibration, CheckId::Shock, CheckId::Mounting];

#[test]
fn what_is_not_stated_is_not_checked_and_not_listed() {
    for id in ALL {
        assert!(found(id, &actuator(), |_| {}).is_none(), "{id:?}");
    }
}

/// Judges on both sides of each limit, at the limit, and for an actuator without values in the manual.
#[test]
fn each_limit_is_judged_on_both_sides() {
    type State = (CheckId, fn(&mut crate::AxisRequirements, f64), &'static [(f64, Verdict)]);
    let cases: [State; 4] = [
        (
            CheckId::Vibration,
            |asked, x| asked.vibration = Some(in_g(x)),
            &[(4.9, Verdict::Pass), (5.0, Verdict::Pass), (5.1, Verdict::Fail)],
        ),
        (
            CheckId::Shock,
            |asked, x| asked.shock = Some(in_g(x)),
            &[(0.0, Verdict::Pass), (30.0, Verdict::Pass), (30.1, Verdict::Fail)],
        ),
        (
            CheckId::Humidity,
            |asked, x| asked.humidity_max = Some(x),
            &[(0.1, Verdict::Fail), (0.2, Verdict::Pass), (0.8, Verdict::Pass), (0.81, Verdict::Fail)],
        ),
        (
            CheckId::Altitude,
            |asked, x| asked.altitude = Some(Length::from_si(x)),
            &[
                (-400.0, Verdict::Pass),
                (999.0, Verdict::Pass),
                (1000.0, Verdict::NotChecked),
                (2000.0, Verdict::NotChecked),
            ],
        ),
    ];
    for (id, state, values) in cases {
        for (value, verdict) in values {
            let check = found(id, &actuator(), |asked| state(asked, *value)).unwrap();
            assert_eq!(check.verdict, *verdict, "{id:?} {value}");
            assert!(check.workings.is_empty());
            let unknown = found(id, &Parameters::unknown(), |asked| state(asked, *value)).unwrap();
            assert_eq!(unknown.verdict, Verdict::NotChecked, "{id:?} {value}");
        }
    }
}

#[test]
fn each_end_of_the_humidity_of_the_place_is_checked() {
    let of = |id, humidity: f64| {
        let check = found(id, &actuator(), |asked| match id {
            CheckId::HumidityMin => asked.humidity_min = Some(humidity),
            _ => asked.humidity_max = Some(humidity),
        });
        let check = check.unwrap();
        (check.verdict, check.value.unwrap().si, check.limit.unwrap().si, check.relation())
    };
    assert_eq!(of(CheckId::Humidity, 0.7), (Verdict::Pass, 0.7, 0.8, Some("≤")));
    assert_eq!(of(CheckId::Humidity, 0.9), (Verdict::Fail, 0.9, 0.8, Some(">")));
    assert_eq!(of(CheckId::Humidity, 0.1), (Verdict::Fail, 0.1, 0.2, Some("<")));
    assert_eq!(of(CheckId::HumidityMin, 0.1), (Verdict::Fail, 0.1, 0.2, Some("<")));
    assert_eq!(of(CheckId::HumidityMin, 0.9), (Verdict::Fail, 0.9, 0.8, Some(">")));
    assert_eq!(of(CheckId::HumidityMin, 0.3), (Verdict::Pass, 0.3, 0.2, Some("≥")));
}

#[test]
fn degrees_of_protection_show_the_numeral_that_is_not_met() {
    let of = |text: &str| {
        let check = found(CheckId::Protection, &actuator(), |asked| asked.protection = Protection::read(text)).unwrap();
        (check.verdict, check.value.unwrap().si, check.limit.unwrap().si, check.relation())
    };
    assert_eq!(of("IP54"), (Verdict::Pass, 54.0, 65.0, Some("≤")));
    assert_eq!(of("IP65"), (Verdict::Pass, 65.0, 65.0, Some("≤")));
    assert_eq!(of("IP67"), (Verdict::Fail, 67.0, 65.0, Some(">")));
    assert_eq!(of("IP56"), (Verdict::Fail, 6.0, 5.0, Some(">")));
}

/// No manual says which positions are permitted.
#[test]
fn a_mounting_position_is_named_as_not_checked() {
    let check = found(CheckId::Mounting, &actuator(), |asked| {
        asked.mounting = Some(crate::MountingPosition::FlangeDown);
    });
    let check = check.unwrap();
    assert_eq!((check.verdict, check.missing), (Verdict::NotChecked, Some("mounting_position")));
}

#[test]
fn above_the_printed_altitude_the_missing_derating_is_named() {
    let high = |asked: &mut crate::AxisRequirements| asked.altitude = Some(Length::from_si(1500.0));
    let check = found(CheckId::Altitude, &actuator(), high).unwrap();
    assert_eq!(check.missing, Some("requirements.altitude_derating"));
    let mut unprinted = actuator();
    unprinted.drivetrain = std::sync::Arc::new(Drivetrain::unknown());
    assert_eq!(found(CheckId::Altitude, &unprinted, high).unwrap().missing, Some("altitude"));
}

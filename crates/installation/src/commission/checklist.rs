//! Check-lists: requirements of the manual for each step, and expected values of this code with room for the measured ones.

use super::expected::{Expected, Measurand};
use super::{Commissioning, Parameter, ParameterId};
use crate::facts::{Order, facts_about};
use catalogue::{Fact, Step, Topic};
use quantities::unit::{MINUTE, REVOLUTION_PER_MINUTE};
use quantities::{AngularVelocity, Measure, ThermodynamicTemperature, Time};

/// Speed of the motor in a test run (cha-manual section 9.5), in 1/min; the fact `test_run_short` has it.
const TEST_SPEED: (&str, &str) = ("test_run_short", "speed_motor");

/// The steps that have a list.
pub const STEPS: [Step; 3] = [Step::BeforePower, Step::FirstMotion, Step::AfterADay];

/// One line of a list.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// What the prose says.
    Fact(&'static Fact),
    /// A value to measure at a condition, with what it should be.
    Measure {
        /// What it should be.
        expected: Expected,
        /// The condition in which that holds.
        at: Condition,
    },
    /// A value of the list to set or to compare.
    Value(Parameter),
    /// A limit of the test run.
    Limit {
        /// Speed of the motor.
        speed_motor: AngularVelocity,
        /// The same at the flange.
        speed_out: AngularVelocity,
        /// How long at the most.
        time: Time,
    },
}

/// The condition of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// None.
    Any,
    /// Temperature of winding or gear.
    Temperature(ThermodynamicTemperature),
    /// Speed of the motor.
    SpeedMotor(AngularVelocity),
    /// Speed of the flange, and the temperature of the gear.
    SpeedOut(AngularVelocity, ThermodynamicTemperature),
}

/// The list of one step.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckList {
    /// Which step.
    pub step: Step,
    /// Its lines: the prose first, then the figures.
    pub items: Vec<Item>,
}

/// The speed of the motor in a test run and how long it may last, as the prose has them.
#[must_use]
pub fn test_run() -> Option<(AngularVelocity, Time)> {
    let fact = catalogue::fact(TEST_SPEED.0)?;
    let value = |id: &str| fact.values.iter().find(|value| value.id == id).map(|value| value.number);
    let speed = AngularVelocity::new_in(value(TEST_SPEED.1)?, &REVOLUTION_PER_MINUTE);
    Some((speed, Time::new_in(value("time")?, &MINUTE)))
}

/// The three lists of a code; `ambient` is the temperature at which winding and sensors are measured.
#[must_use]
pub fn lists(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<CheckList> {
    let facts = facts_about(Topic::Commission, &about.code, Order::Data);
    let list = |step: Step| {
        let of_step = facts.iter().filter(|fact| fact.step == Some(step));
        let mut items: Vec<Item> = of_step.map(|fact| Item::Fact(fact)).collect();
        items.extend(match step {
            Step::BeforePower => before_power(about, ambient),
            Step::FirstMotion => first_motion(about, ambient),
            _ => after_a_day(about),
        });
        CheckList { step, items }
    };
    STEPS.into_iter().map(list).collect()
}

/// A value to measure, where it is known what it should be.
fn measure(expected: Option<Expected>, at: Condition) -> Option<Item> {
    Some(Item::Measure { expected: expected?, at })
}

fn before_power(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<Item> {
    let cold = [about.expected_resistance(ambient), about.expected_kty(ambient), about.expected_ptc(ambient)];
    let at_any = [
        about.expected_inductance(),
        about.expected_brake_voltage(),
        about.expected_brake(Measurand::BrakeOpeningCurrent),
        about.expected_brake(Measurand::BrakeHoldingCurrent),
        about.expected_brake(Measurand::BrakeOpeningTime),
        about.expected_brake(Measurand::BrakeClosingTime),
    ];
    let set = [ParameterId::SpeedMotorMax, ParameterId::SpeedOutMax, ParameterId::CurrentLimit, ParameterId::PolePairs];
    let cold = cold.map(|expected| measure(expected, Condition::Temperature(ambient)));
    let at_any = at_any.map(|expected| measure(expected, Condition::Any));
    let values = set.map(|id| about.get(id).cloned().map(Item::Value));
    cold.into_iter().chain(at_any).chain(values).flatten().collect()
}

/// Speeds of motor and flange in a test run, and how long it lasts at most.
fn test_speeds(about: &Commissioning) -> Option<(AngularVelocity, AngularVelocity, Time)> {
    let (speed_motor, time) = test_run()?;
    let ratio = about.get(ParameterId::ReductionRatio)?.si;
    Some((speed_motor, AngularVelocity::from_si(speed_motor.si() / ratio), time))
}

fn first_motion(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<Item> {
    let Some((speed_motor, speed_out, time)) = test_speeds(about) else { return Vec::new() };
    let at = Condition::SpeedMotor(speed_motor);
    let items = [
        Some(Item::Limit { speed_motor, speed_out, time }),
        measure(about.expected_ratio(), at),
        measure(about.expected_emf(speed_motor), at),
        measure(about.expected_no_load(speed_out, ambient), Condition::SpeedOut(speed_out, ambient)),
    ];
    items.into_iter().flatten().collect()
}

fn after_a_day(about: &Commissioning) -> Vec<Item> {
    let warning = about.get(ParameterId::WindingWarning).cloned().map(Item::Value);
    let current = test_speeds(about).zip(about.warm_gear()).and_then(|((_, speed_out, _), warm)| {
        measure(about.expected_no_load(speed_out, warm), Condition::SpeedOut(speed_out, warm))
    });
    warning.into_iter().chain(current).collect()
}

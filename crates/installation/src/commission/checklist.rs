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
    let fact = catalogue::facts().iter().find(|fact| fact.id == TEST_SPEED.0)?;
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

fn before_power(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<Item> {
    let at = Condition::Temperature(ambient);
    let cold = [about.expected_resistance(ambient), about.expected_kty(ambient), about.expected_ptc(ambient)];
    let brake = [
        about.expected_brake_voltage(),
        about.expected_brake(Measurand::BrakeOpeningCurrent),
        about.expected_brake(Measurand::BrakeHoldingCurrent),
        about.expected_brake(Measurand::BrakeOpeningTime),
        about.expected_brake(Measurand::BrakeClosingTime),
    ];
    let set = [ParameterId::SpeedMotorMax, ParameterId::SpeedOutMax, ParameterId::CurrentLimit, ParameterId::PolePairs];
    let measured = cold.into_iter().flatten().map(|expected| Item::Measure { expected, at });
    let inductance = about.expected_inductance().map(|expected| Item::Measure { expected, at: Condition::Any });
    let brake = brake.into_iter().flatten().map(|expected| Item::Measure { expected, at: Condition::Any });
    let values = set.into_iter().filter_map(|id| about.get(id).cloned()).map(Item::Value);
    measured.chain(inductance).chain(brake).chain(values).collect()
}

fn first_motion(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<Item> {
    let Some((speed_motor, time)) = test_run() else { return Vec::new() };
    let Some(ratio) = about.get(ParameterId::ReductionRatio) else { return Vec::new() };
    let speed_out = AngularVelocity::from_si(speed_motor.si() / ratio.si);
    let ratio =
        about.expected_ratio().map(|expected| Item::Measure { expected, at: Condition::SpeedMotor(speed_motor) });
    let emf = about.expected_emf(speed_motor);
    let emf = emf.map(|expected| Item::Measure { expected, at: Condition::SpeedMotor(speed_motor) });
    let current = about.expected_no_load(speed_out, ambient);
    let current = current.map(|expected| Item::Measure { expected, at: Condition::SpeedOut(speed_out, ambient) });
    [Item::Limit { speed_motor, speed_out, time }].into_iter().chain(ratio).chain(emf).chain(current).collect()
}

fn after_a_day(about: &Commissioning) -> Vec<Item> {
    let warm = about.warm_gear();
    let warning = about.get(ParameterId::WindingWarning).cloned().map(Item::Value);
    let test = test_run().zip(about.get(ParameterId::ReductionRatio));
    let current = test.and_then(|((speed_motor, _), ratio)| {
        let speed_out = AngularVelocity::from_si(speed_motor.si() / ratio.si);
        let warm = warm?;
        let expected = about.expected_no_load(speed_out, warm)?;
        Some(Item::Measure { expected, at: Condition::SpeedOut(speed_out, warm) })
    });
    warning.into_iter().chain(current).collect()
}

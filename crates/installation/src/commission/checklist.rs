//! Checklists: requirements of the manual for each step, and expected values of the code with space for measured ones.

use super::expected::{ExpectedValue, Measurand};
use super::{Commissioning, ParameterId, ParameterToSet};
use crate::facts::{Order, facts_about};
use catalogue::{Fact, LifeStep, Topic};
use quantities::unit::{MINUTE, REVOLUTION_PER_MINUTE};
use quantities::{AngularVelocity, Measure, ThermodynamicTemperature, Time};

/// Fact and value that state the motor speed of a test run (cha-manual section 9.5).
const TEST_SPEED: (&str, &str) = ("test_run_short", "speed_motor");

/// Steps with a checklist.
pub const STEPS: [LifeStep; 3] = [LifeStep::BeforePower, LifeStep::FirstMotion, LifeStep::AfterADay];

/// A line of a checklist.
#[derive(Clone, Debug, PartialEq)]
pub enum ChecklistItem {
    /// A fact of the manual.
    Fact(&'static Fact),
    /// A value to measure under a condition.
    Measure {
        /// Expected value.
        expected: ExpectedValue,
        /// Condition to which the expected value applies.
        at: Condition,
    },
    /// A value to set or to compare.
    Value(ParameterToSet),
    /// Limits of the test run.
    Limit {
        /// Largest motor speed.
        speed_motor: AngularVelocity,
        /// Largest flange speed.
        speed_out: AngularVelocity,
        /// Longest duration.
        time: Time,
    },
}

/// Condition of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Any condition.
    Any,
    /// Temperature of winding or gear.
    Temperature(ThermodynamicTemperature),
    /// Motor speed.
    SpeedMotor(AngularVelocity),
    /// Flange speed, and the temperature of the gear.
    SpeedOut(AngularVelocity, ThermodynamicTemperature),
}

/// Checklist of one step.
#[derive(Clone, Debug, PartialEq)]
pub struct CheckList {
    /// Step of the commissioning.
    pub step: LifeStep,
    /// Lines: facts first, then values.
    pub items: Vec<ChecklistItem>,
}

/// Returns the motor speed and the longest duration of a test run, from the facts of the manual.
#[must_use]
pub fn test_run() -> Option<(AngularVelocity, Time)> {
    let fact = catalogue::fact(TEST_SPEED.0)?;
    let value = |id: &str| fact.values.iter().find(|value| value.id == id).map(|value| value.number);
    let speed = AngularVelocity::new_in(value(TEST_SPEED.1)?, &REVOLUTION_PER_MINUTE);
    Some((speed, Time::new_in(value("time")?, &MINUTE)))
}

/// Returns the three checklists of a code; `ambient` is the temperature at which winding and sensors are measured.
#[must_use]
pub fn lists(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<CheckList> {
    let facts = facts_about(Topic::Commission, &about.code, Order::Data);
    let list = |step: LifeStep| {
        let of_step = facts.iter().filter(|fact| fact.step == Some(step));
        let mut items: Vec<ChecklistItem> = of_step.map(|fact| ChecklistItem::Fact(fact)).collect();
        items.extend(match step {
            LifeStep::BeforePower => before_power(about, ambient),
            LifeStep::FirstMotion => first_motion(about, ambient),
            _ => after_a_day(about),
        });
        CheckList { step, items }
    };
    STEPS.into_iter().map(list).collect()
}

/// Returns a value to measure, if the expected value is known.
fn measure(expected: Option<ExpectedValue>, at: Condition) -> Option<ChecklistItem> {
    Some(ChecklistItem::Measure { expected: expected?, at })
}

fn before_power(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<ChecklistItem> {
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
    let values = set.map(|id| about.get(id).cloned().map(ChecklistItem::Value));
    cold.into_iter().chain(at_any).chain(values).flatten().collect()
}

/// Returns motor speed, flange speed and longest duration of a test run.
fn test_speeds(about: &Commissioning) -> Option<(AngularVelocity, AngularVelocity, Time)> {
    let (speed_motor, time) = test_run()?;
    let ratio = about.get(ParameterId::ReductionRatio)?.si;
    Some((speed_motor, AngularVelocity::from_si(speed_motor.si() / ratio), time))
}

fn first_motion(about: &Commissioning, ambient: ThermodynamicTemperature) -> Vec<ChecklistItem> {
    let Some((speed_motor, speed_out, time)) = test_speeds(about) else { return Vec::new() };
    let at = Condition::SpeedMotor(speed_motor);
    let items = [
        Some(ChecklistItem::Limit { speed_motor, speed_out, time }),
        measure(about.expected_ratio(), at),
        measure(about.expected_emf(speed_motor), at),
        measure(about.expected_no_load(speed_out, ambient), Condition::SpeedOut(speed_out, ambient)),
    ];
    items.into_iter().flatten().collect()
}

fn after_a_day(about: &Commissioning) -> Vec<ChecklistItem> {
    let warning = about.get(ParameterId::WindingWarning).cloned().map(ChecklistItem::Value);
    let current = test_speeds(about).zip(about.warm_gear()).and_then(|((_, speed_out, _), warm)| {
        measure(about.expected_no_load(speed_out, warm), Condition::SpeedOut(speed_out, warm))
    });
    warning.into_iter().chain(current).collect()
}

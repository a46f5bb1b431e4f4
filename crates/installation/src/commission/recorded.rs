//! Evaluation of a recorded commissioning: measured values compared with expected ones, and likely causes of
//! deviations.

mod causes;

pub use causes::Cause;

use super::Commissioning;
use super::counting::counting_fact;
use super::expected::{ExpectedValue, Measurand};

use provenance::{Grade, Source};
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricPotential, ElectricalResistance, Frequency, Inductance, Measure,
    ThermodynamicTemperature, Time,
};

/// Direction of rotation as seen from the front.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Clockwise.
    Clockwise,
    /// Counter-clockwise.
    CounterClockwise,
}

/// Direction of the counted position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counting {
    /// The position increases.
    Rising,
    /// The position decreases.
    Falling,
}

/// No-load current at one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoLoad {
    /// Flange speed.
    pub speed_out: AngularVelocity,
    /// No-load current, rms.
    pub current: ElectricCurrent,
    /// Temperature of the gear, assumed equal to that of the housing.
    pub temperature: ThermodynamicTemperature,
}

/// Measured values of a commissioning.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasuredValues {
    /// Temperature of the winding during the resistance measurement.
    pub winding_temperature: Option<ThermodynamicTemperature>,
    /// Resistance between two terminals.
    pub resistance_ll: Option<ElectricalResistance>,
    /// Inductance between two terminals.
    pub inductance_ll: Option<Inductance>,
    /// Induced voltage between two terminals, rms, and the motor speed.
    pub emf: Option<(ElectricPotential, AngularVelocity)>,
    /// Temperature of the winding during the measurement of its sensors.
    pub sensor_temperature: Option<ThermodynamicTemperature>,
    /// Resistance of the KTY.
    pub kty: Option<ElectricalResistance>,
    /// Resistance of the PTC.
    pub ptc: Option<ElectricalResistance>,
    /// Voltage at the brake.
    pub brake_voltage: Option<ElectricPotential>,
    /// Opening current of the brake.
    pub brake_opening_current: Option<ElectricCurrent>,
    /// Holding current of the brake.
    pub brake_holding_current: Option<ElectricCurrent>,
    /// Opening time of the brake.
    pub brake_opening_time: Option<Time>,
    /// Closing time of the brake.
    pub brake_closing_time: Option<Time>,
    /// Direction of the motor as seen from the front.
    pub direction_motor: Option<Turn>,
    /// Simultaneous direction of the flange.
    pub direction_flange: Option<Turn>,
    /// Simultaneous direction of the position.
    pub position: Option<Counting>,
    /// Motor speed.
    pub speed_motor: Option<AngularVelocity>,
    /// Simultaneous flange speed.
    pub speed_flange: Option<AngularVelocity>,
    /// Simultaneous frequency of the current.
    pub electrical_frequency: Option<Frequency>,
    /// No-load currents.
    pub no_load: Vec<NoLoad>,
}

/// Verdict on a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasurementVerdict {
    /// The value is inside the band.
    Pass,
    /// The value is outside the band.
    Fail,
    /// The value is outside an estimated band.
    Advice,
    /// The value is not measured, or there is no value to compare it with.
    NotChecked,
}

/// Reason for which a measurement is not checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unjudged {
    /// The record has no value.
    NotMeasured,
    /// The manual states no value for the code or the condition.
    NotStated,
    /// The code lacks the part.
    NotThere,
}

/// A measurement with its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// Measured quantity.
    pub what: Measurand,
    /// Number of the measurement from one, if there are several.
    pub number: Option<usize>,
    /// Measured value in SI; for a direction one if correct, zero if not.
    pub value: Option<f64>,
    /// Expected value.
    pub expected: Option<ExpectedValue>,
    /// Verdict on the measurement.
    pub verdict: MeasurementVerdict,
    /// Likely cause of a deviation.
    pub cause: Option<Cause>,
    /// Reason for which the measurement is not checked.
    pub unjudged: Option<Unjudged>,
    /// Fact that states the correct direction, by its id; used if there is no band.
    pub fact: Option<&'static str>,
    /// Grade of trust in the verdict.
    pub grade: Option<Grade>,
}

impl Judged {
    fn open(what: Measurand, value: Option<f64>, why: Unjudged) -> Self {
        Self {
            what,
            number: None,
            value,
            expected: None,
            verdict: MeasurementVerdict::NotChecked,
            cause: None,
            unjudged: Some(why),
            fact: None,
            grade: None,
        }
    }

    fn of(value: f64, expected: ExpectedValue, cause: Option<Cause>) -> Self {
        let inside = value >= expected.low && value <= expected.high;
        let cause = cause.filter(|_| !inside);
        let verdict = match (inside, expected.band.is_firm() || cause.is_some_and(Cause::is_certain)) {
            (true, _) => MeasurementVerdict::Pass,
            (false, true) => MeasurementVerdict::Fail,
            (false, false) => MeasurementVerdict::Advice,
        };
        Self {
            what: expected.what,
            number: None,
            value: Some(value),
            grade: Some(expected.grade),
            expected: Some(expected),
            verdict,
            cause,
            unjudged: None,
            fact: None,
        }
    }

    /// Creates the verdict on a direction that a fact of the manual states.
    fn by_fact(what: Measurand, right: bool, fact: &'static str, cause: Cause) -> Self {
        Self {
            what,
            number: None,
            value: Some(if right { 1.0 } else { 0.0 }),
            expected: None,
            verdict: if right { MeasurementVerdict::Pass } else { MeasurementVerdict::Fail },
            cause: (!right).then_some(cause),
            unjudged: None,
            fact: Some(fact),
            grade: Some(Grade::Printed),
        }
    }

    /// Returns the sources of the expected value.
    #[must_use]
    pub fn sources(&self) -> &[Source] {
        self.expected.as_ref().map_or(&[], |expected| &expected.sources)
    }
}

/// Compares a record with the data of a code: one entry for each quantity, and one for each point of the no-load
/// current. Values missing in the record are `not checked`, never passed.
#[must_use]
pub fn judge(about: &Commissioning, measured: &MeasuredValues) -> Vec<Judged> {
    let mut judged = Vec::new();
    for what in Measurand::ALL {
        match what {
            Measurand::NoLoadCurrent => judged.extend(no_load(about, measured)),
            what => judged.push(one(about, measured, what)),
        }
    }
    judged
}

fn one(about: &Commissioning, measured: &MeasuredValues, what: Measurand) -> Judged {
    let (value, expected) = match what {
        Measurand::ResistanceLl => {
            let winding = measured.winding_temperature;
            (measured.resistance_ll.map(Measure::si), winding.and_then(|winding| about.expected_resistance(winding)))
        }
        Measurand::InductanceLl => (measured.inductance_ll.map(Measure::si), about.expected_inductance()),
        Measurand::Emf => {
            let expected = measured.emf.and_then(|(_, speed)| about.expected_emf(speed));
            (measured.emf.map(|(voltage, _)| voltage.si()), expected)
        }
        Measurand::Kty => {
            let sensor = measured.sensor_temperature;
            (measured.kty.map(Measure::si), sensor.and_then(|sensor| about.expected_kty(sensor)))
        }
        Measurand::Ptc => {
            let sensor = measured.sensor_temperature;
            (measured.ptc.map(Measure::si), sensor.and_then(|sensor| about.expected_ptc(sensor)))
        }
        Measurand::BrakeVoltage => (measured.brake_voltage.map(Measure::si), about.expected_brake_voltage()),
        Measurand::BrakeOpeningCurrent => (measured.brake_opening_current.map(Measure::si), about.expected_brake(what)),
        Measurand::BrakeHoldingCurrent => (measured.brake_holding_current.map(Measure::si), about.expected_brake(what)),
        Measurand::BrakeOpeningTime => (measured.brake_opening_time.map(Measure::si), about.expected_brake(what)),
        Measurand::BrakeClosingTime => (measured.brake_closing_time.map(Measure::si), about.expected_brake(what)),
        Measurand::DirectionFlange => {
            return match (measured.direction_motor, measured.direction_flange) {
                (Some(motor), Some(flange)) => Judged::by_fact(what, motor != flange, REVERSED, Cause::SameDirection),
                _ => Judged::open(what, None, Unjudged::NotMeasured),
            };
        }
        Measurand::DirectionPosition => return position(about, measured),
        Measurand::Ratio => (quotient(measured.speed_motor, measured.speed_flange), about.expected_ratio()),
        Measurand::PolePairs => {
            let turns = measured.speed_motor.map(|speed| speed.si().abs() / std::f64::consts::TAU);
            let frequency = measured.electrical_frequency.map(Measure::si);
            let value = turns.zip(frequency).filter(|(turns, _)| *turns > 0.0).map(|(turns, hertz)| hertz / turns);
            (value, about.expected_pole_pairs())
        }
        // The points of the no-load current are compared individually.
        Measurand::NoLoadCurrent => return Judged::open(what, None, Unjudged::NotMeasured),
    };
    let is_there = match what {
        Measurand::Kty => about.has_kty(),
        Measurand::Ptc => about.has_ptc(),
        other => !other.is_of_the_brake() || about.has_brake(),
    };
    if !is_there {
        return Judged::open(what, value, Unjudged::NotThere);
    }
    compare(about, what, value, expected)
}

fn quotient(one: Option<AngularVelocity>, other: Option<AngularVelocity>) -> Option<f64> {
    let other = other.map(|speed| speed.si().abs()).filter(|speed| *speed > 0.0)?;
    Some(one?.si().abs() / other)
}

fn compare(about: &Commissioning, what: Measurand, value: Option<f64>, expected: Option<ExpectedValue>) -> Judged {
    match (value, expected) {
        (None, _) => Judged::open(what, None, Unjudged::NotMeasured),
        // An open or short-circuited sensor is detected at any temperature.
        (Some(value), None) => match causes::of_a_broken_sensor(what, value) {
            Some(cause) => Judged {
                verdict: MeasurementVerdict::Fail,
                cause: Some(cause),
                ..Judged::open(what, Some(value), Unjudged::NotStated)
            },
            None => Judged::open(what, Some(value), Unjudged::NotStated),
        },
        (Some(value), Some(expected)) => {
            let cause = causes::of(about, value, &expected);
            Judged::of(value, expected, cause)
        }
    }
}

/// Fact that the gear reverses the direction.
pub(super) const REVERSED: &str = "direction_reversed_by_gear";

fn position(about: &Commissioning, measured: &MeasuredValues) -> Judged {
    let what = Measurand::DirectionPosition;
    let (Some(motor), Some(counting)) = (measured.direction_motor, measured.position) else {
        return Judged::open(what, None, Unjudged::NotMeasured);
    };
    let Some(fact) = counting_fact(&about.code) else { return Judged::open(what, None, Unjudged::NotStated) };
    let right = (motor == Turn::Clockwise) == (counting == Counting::Rising);
    Judged::by_fact(what, right, fact.id, Cause::CountingReversed)
}

fn no_load(about: &Commissioning, measured: &MeasuredValues) -> Vec<Judged> {
    let what = Measurand::NoLoadCurrent;
    if measured.no_load.is_empty() {
        return vec![Judged::open(what, None, Unjudged::NotMeasured)];
    }
    let judged = |(number, point): (usize, &NoLoad)| {
        let expected = about.expected_no_load(point.speed_out, point.temperature);
        let value = point.current.si().abs();
        let mut judged = compare(about, what, Some(value), expected);
        judged.number = Some(number);
        if let Some(cause) = causes::of_speed(about, point.speed_out) {
            judged.cause = Some(cause);
            judged.verdict = MeasurementVerdict::Fail;
        }
        judged
    };
    (1..).zip(&measured.no_load).map(judged).collect()
}

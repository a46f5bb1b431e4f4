//! The parameter list of a SINAMICS drive: which parameter takes which value, in which unit.
//!
//! Only parameter numbers from public documents are listed; other required values are a [`Gap`](super::Gap) or are
//! referred to the list manual of the drive.

use super::{Commissioning, ParameterId, clean};
use order_code::FeedbackKind;
use quantities::Unit;
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, HERTZ, KILOGRAM, KILOGRAM_SQUARE_METRE, MILLIHENRY, NEWTON_METRE, NEWTON_METRE_PER_AMPERE,
    OHM, ONE, REVOLUTION_PER_MINUTE, VOLT_PER_THOUSAND_REVOLUTIONS,
};

/// What a parameter of the drive is set to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// The value of the list, in this unit.
    Value(ParameterId, &'static Unit),
    /// A choice of the drive.
    Choice(Choice),
}

/// A choice by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// The motor is a rotating synchronous motor with permanent magnets.
    Synchronous,
    /// The encoder reports its data itself, over EnDat.
    IdentifiedEncoder,
    /// The data of the encoder are entered.
    EnteredEncoder,
    /// The temperature sensor comes in with the motor's encoder.
    SensorAtEncoder,
    /// The sensor is a KTY 84.
    SensorKty,
}

impl Choice {
    /// Its number.
    #[must_use]
    pub const fn number(self) -> u16 {
        match self {
            Self::Synchronous => 2,
            Self::IdentifiedEncoder => 10_100,
            Self::EnteredEncoder => 9999,
            Self::SensorAtEncoder => 1,
            Self::SensorKty => 2,
        }
    }
}

/// One parameter of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriveParameter {
    /// Number of the parameter; its index is that of the data set of motor or encoder, 0.
    pub number: u16,
    /// What it is set to.
    pub setting: Setting,
    /// Document that names it.
    pub document: &'static str,
}

const fn entry(number: u16, id: ParameterId, unit: &'static Unit, document: &'static str) -> DriveParameter {
    DriveParameter { number, setting: Setting::Value(id, unit), document }
}

const fn choice(number: u16, choice: Choice, document: &'static str) -> DriveParameter {
    DriveParameter { number, setting: Setting::Choice(choice), document }
}

/// Data list of a permanent-magnet synchronous motor.
const MOTOR_DATA: &str = "sinamics-s150";

/// List of all parameters of the servo drives.
const LIST: &str = "sinamics-s120-list";

/// Parameters of an encoder.
const ENCODER: &str = "sinamics-s200";

/// The parameters in the order of their numbers.
pub static ENTRIES: [DriveParameter; 25] = [
    choice(300, Choice::Synchronous, LIST),
    entry(310, ParameterId::FrequencyRated, &HERTZ, MOTOR_DATA),
    entry(311, ParameterId::SpeedMotorRated, &REVOLUTION_PER_MINUTE, MOTOR_DATA),
    entry(314, ParameterId::PolePairs, &ONE, MOTOR_DATA),
    entry(316, ParameterId::TorqueConstantMotor, &NEWTON_METRE_PER_AMPERE, MOTOR_DATA),
    entry(317, ParameterId::VoltageConstant, &VOLT_PER_THOUSAND_REVOLUTIONS, LIST),
    entry(318, ParameterId::StallCurrent, &AMPERE, LIST),
    entry(319, ParameterId::StallTorqueMotor, &NEWTON_METRE, LIST),
    entry(322, ParameterId::SpeedMotorMax, &REVOLUTION_PER_MINUTE, MOTOR_DATA),
    entry(323, ParameterId::CurrentLimit, &AMPERE, MOTOR_DATA),
    entry(341, ParameterId::InertiaMotor, &KILOGRAM_SQUARE_METRE, MOTOR_DATA),
    entry(344, ParameterId::Mass, &KILOGRAM, MOTOR_DATA),
    entry(350, ParameterId::ResistancePhase, &OHM, MOTOR_DATA),
    entry(356, ParameterId::InductancePhase, &MILLIHENRY, MOTOR_DATA),
    entry(357, ParameterId::InductancePhase, &MILLIHENRY, MOTOR_DATA),
    choice(400, Choice::IdentifiedEncoder, ENCODER),
    choice(400, Choice::EnteredEncoder, ENCODER),
    entry(408, ParameterId::EncoderLines, &ONE, ENCODER),
    entry(421, ParameterId::EncoderTurns, &ONE, ENCODER),
    entry(423, ParameterId::EncoderPositions, &ONE, ENCODER),
    choice(600, Choice::SensorAtEncoder, "sinamics-s120-functions"),
    choice(601, Choice::SensorKty, "sinamics-g220"),
    entry(604, ParameterId::WindingWarning, &DEGREE_CELSIUS, "sinamics-g120xa"),
    entry(605, ParameterId::WindingShutdown, &DEGREE_CELSIUS, "sinamics-g120xa"),
    entry(640, ParameterId::CurrentLimit, &AMPERE, "sinamics-g120xa"),
];

/// A parameter of the drive with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Which.
    pub entry: &'static DriveParameter,
    /// The number to write, in the unit of the entry.
    pub value: f64,
}

/// The parameters whose values are known. The numbers are those of the list to fifteen digits: nothing is rounded.
#[must_use]
pub fn lines(commissioning: &Commissioning) -> Vec<Line> {
    let is_identified = commissioning.code.feedback.kind() == Some(FeedbackKind::EndatMultiturn);
    let holds = |choice: Choice| match choice {
        Choice::Synchronous => true,
        Choice::IdentifiedEncoder => is_identified,
        Choice::EnteredEncoder => !is_identified,
        Choice::SensorAtEncoder | Choice::SensorKty => commissioning.has_kty(),
    };
    let value = |entry: &DriveParameter| match entry.setting {
        Setting::Choice(choice) => holds(choice).then(|| f64::from(choice.number())),
        Setting::Value(id, unit) => commissioning.get(id).map(|parameter| clean(unit.from_si(parameter.si))),
    };
    ENTRIES.iter().filter_map(|entry| Some(Line { entry, value: value(entry)? })).collect()
}

impl DriveParameter {
    /// The parameter as drives and their tools write it: `p0350[0]`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("p{:04}[0]", self.number)
    }
}

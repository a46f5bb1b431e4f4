//! The parameter list of a SINAMICS drive: which parameter takes which value, in which unit.
//!
//! Only parameter numbers from public documents are listed; other required values are a [`Gap`](super::Gap) or are
//! referred to the list manual of the drive.

use super::{Commissioning, ParameterId, clean};
use quantities::Unit;
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, HERTZ, KILOGRAM, KILOGRAM_SQUARE_METRE, MILLIHENRY, NEWTON_METRE_PER_AMPERE, OHM, ONE,
    REVOLUTION_PER_MINUTE,
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
    /// The temperature sensor comes in with the motor's encoder.
    SensorAtEncoder,
    /// The sensor is a KTY 84.
    SensorKty,
}

impl Choice {
    /// Its number.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::SensorAtEncoder => 1,
            Self::SensorKty => 2,
        }
    }
}

/// One parameter of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriveParameter {
    /// Number of the parameter; its index is that of the motor data set, 0.
    pub number: u16,
    /// What it is set to.
    pub setting: Setting,
    /// Document that names it.
    pub document: &'static str,
}

const fn entry(number: u16, id: ParameterId, unit: &'static Unit, document: &'static str) -> DriveParameter {
    DriveParameter { number, setting: Setting::Value(id, unit), document }
}

/// Data list of a permanent-magnet synchronous motor.
const MOTOR_DATA: &str = "sinamics-s150";

/// The parameters in the order of their numbers.
pub static ENTRIES: [DriveParameter; 16] = [
    entry(310, ParameterId::FrequencyRated, &HERTZ, MOTOR_DATA),
    entry(311, ParameterId::SpeedMotorRated, &REVOLUTION_PER_MINUTE, MOTOR_DATA),
    entry(314, ParameterId::PolePairs, &ONE, MOTOR_DATA),
    entry(316, ParameterId::TorqueConstantMotor, &NEWTON_METRE_PER_AMPERE, MOTOR_DATA),
    entry(322, ParameterId::SpeedMotorMax, &REVOLUTION_PER_MINUTE, MOTOR_DATA),
    entry(323, ParameterId::CurrentLimit, &AMPERE, MOTOR_DATA),
    entry(341, ParameterId::InertiaMotor, &KILOGRAM_SQUARE_METRE, MOTOR_DATA),
    entry(344, ParameterId::Mass, &KILOGRAM, MOTOR_DATA),
    entry(350, ParameterId::ResistancePhase, &OHM, MOTOR_DATA),
    entry(356, ParameterId::InductancePhase, &MILLIHENRY, MOTOR_DATA),
    entry(357, ParameterId::InductancePhase, &MILLIHENRY, MOTOR_DATA),
    DriveParameter {
        number: 600,
        setting: Setting::Choice(Choice::SensorAtEncoder),
        document: "sinamics-s120-functions",
    },
    DriveParameter { number: 601, setting: Setting::Choice(Choice::SensorKty), document: "sinamics-g220" },
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
    let value = |entry: &DriveParameter| match entry.setting {
        Setting::Choice(choice) => Some(f64::from(choice.number())),
        Setting::Value(id, unit) => commissioning.get(id).map(|parameter| clean(unit.from_si(parameter.si))),
    };
    ENTRIES.iter().filter_map(|entry| Some(Line { entry, value: value(entry)? })).collect()
}

/// Values that such a drive requires under a number that no available document names; see its list manual.
pub static TO_LOOK_UP: [ParameterId; 3] =
    [ParameterId::VoltageConstant, ParameterId::StallCurrent, ParameterId::StallTorqueMotor];

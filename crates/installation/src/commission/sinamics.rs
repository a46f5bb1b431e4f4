//! Parameter list of a SINAMICS drive: value and unit of each parameter.
//!
//! Only parameter numbers from public documents are listed; other required values are [`Gap`](super::Gap)s or left to
//! the list manual of the drive.

use super::{Commissioning, ParameterId, clean};
use order_code::FeedbackKind;
use quantities::Unit;
use quantities::unit::{
    AMPERE, DEGREE_CELSIUS, HERTZ, KILOGRAM, KILOGRAM_SQUARE_METRE, MILLIHENRY, NEWTON_METRE, NEWTON_METRE_PER_AMPERE,
    OHM, ONE, REVOLUTION_PER_MINUTE, VOLT_PER_THOUSAND_REVOLUTIONS,
};

/// Setting of a parameter of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// A value of the list, in a unit.
    Value(ParameterId, &'static Unit),
    /// An option of the drive.
    Choice(ParameterChoice),
}

/// An option by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterChoice {
    /// Motor type: rotating synchronous motor with permanent magnets.
    Synchronous,
    /// Encoder whose data are identified over EnDat.
    IdentifiedEncoder,
    /// Encoder whose data are entered.
    EnteredEncoder,
    /// Temperature sensor connected through the motor encoder.
    SensorAtEncoder,
    /// Temperature sensor of type KTY 84.
    SensorKty,
}

impl ParameterChoice {
    /// Returns the number of the option.
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

/// A parameter of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterToSet {
    /// Number of the parameter; its index is that of the data set of motor or encoder, 0.
    pub number: u16,
    /// Setting of the parameter.
    pub setting: Setting,
    /// Document that defines the parameter.
    pub document: &'static str,
}

const fn entry(number: u16, id: ParameterId, unit: &'static Unit, document: &'static str) -> ParameterToSet {
    ParameterToSet { number, setting: Setting::Value(id, unit), document }
}

const fn choice(number: u16, choice: ParameterChoice, document: &'static str) -> ParameterToSet {
    ParameterToSet { number, setting: Setting::Choice(choice), document }
}

/// Document with the data of a permanent-magnet synchronous motor.
const MOTOR_DATA: &str = "sinamics-s150";

/// Document with all parameters of the servo drives.
const LIST: &str = "sinamics-s120-list";

/// Document with the parameters of an encoder.
const ENCODER: &str = "sinamics-s200";

/// Parameters in the order of their numbers.
pub static ENTRIES: [ParameterToSet; 25] = [
    choice(300, ParameterChoice::Synchronous, LIST),
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
    choice(400, ParameterChoice::IdentifiedEncoder, ENCODER),
    choice(400, ParameterChoice::EnteredEncoder, ENCODER),
    entry(408, ParameterId::EncoderLines, &ONE, ENCODER),
    entry(421, ParameterId::EncoderTurns, &ONE, ENCODER),
    entry(423, ParameterId::EncoderPositions, &ONE, ENCODER),
    choice(600, ParameterChoice::SensorAtEncoder, "sinamics-s120-functions"),
    choice(601, ParameterChoice::SensorKty, "sinamics-g220"),
    entry(604, ParameterId::WindingWarning, &DEGREE_CELSIUS, "sinamics-g120xa"),
    entry(605, ParameterId::WindingShutdown, &DEGREE_CELSIUS, "sinamics-g120xa"),
    entry(640, ParameterId::CurrentLimit, &AMPERE, "sinamics-g120xa"),
];

/// A parameter of the drive with its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterLine {
    /// Parameter of the drive.
    pub entry: &'static ParameterToSet,
    /// Number to write, in the unit of the entry.
    pub value: f64,
}

/// Returns the parameters with known values. The numbers are those of the list to fifteen digits, without further
/// rounding.
#[must_use]
pub fn lines(commissioning: &Commissioning) -> Vec<ParameterLine> {
    let is_identified = commissioning.feedback_kind() == Some(FeedbackKind::EndatMultiturn);
    let holds = |choice: ParameterChoice| match choice {
        ParameterChoice::Synchronous => true,
        ParameterChoice::IdentifiedEncoder => is_identified,
        ParameterChoice::EnteredEncoder => !is_identified,
        ParameterChoice::SensorAtEncoder | ParameterChoice::SensorKty => commissioning.has_kty(),
    };
    let value = |entry: &ParameterToSet| match entry.setting {
        Setting::Choice(choice) => holds(choice).then(|| f64::from(choice.number())),
        Setting::Value(id, unit) => commissioning.get(id).map(|parameter| clean(unit.from_si(parameter.si))),
    };
    ENTRIES.iter().filter_map(|entry| Some(ParameterLine { entry, value: value(entry)? })).collect()
}

impl ParameterToSet {
    /// Returns the parameter as written by drives and their tools: `p0350[0]`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("p{:04}[0]", self.number)
    }
}

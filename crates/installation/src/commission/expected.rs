//! What a measurement should give, with the band about it and what the band rests on.

use super::{Commissioning, ParameterId, sensors};
use actuator::{NoLoadFriction, copper_resistance};
use catalogue::{Cell, Value};
use provenance::{Grade, Source};
use quantities::unit::{AMPERE, DEGREE_CELSIUS, MILLIHENRY, MILLISECOND, OHM, ONE, VOLT};
use quantities::{AngularVelocity, ElectricalResistance, Measure, ThermodynamicTemperature, Unit, identified};

identified! {
    /// What is measured.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Measurand {
        /// Resistance between two terminals at the temperature of the winding.
        ResistanceLl = "resistance_ll",
        /// Inductance between two terminals.
        InductanceLl = "inductance_ll",
        /// Induced voltage between two terminals at a speed of the motor, rms.
        Emf = "emf",
        /// Resistance of the KTY at a temperature.
        Kty = "kty",
        /// Resistance of the PTC at a temperature.
        Ptc = "ptc",
        /// Voltage at the brake.
        BrakeVoltage = "brake_voltage",
        /// Current while the brake opens.
        BrakeOpeningCurrent = "brake_opening_current",
        /// Current that keeps it open.
        BrakeHoldingCurrent = "brake_holding_current",
        /// Time until it is open.
        BrakeOpeningTime = "brake_opening_time",
        /// Time until it is closed.
        BrakeClosingTime = "brake_closing_time",
        /// Whether the flange turns against the motor.
        DirectionFlange = "direction_flange",
        /// Whether the position rises while the motor turns clockwise.
        DirectionPosition = "direction_position",
        /// Speed of the motor over that of the flange.
        Ratio = "ratio",
        /// Electrical over mechanical frequency of the motor.
        PolePairs = "pole_pairs",
        /// Current without load at a speed, rms.
        NoLoadCurrent = "no_load_current",
    }
}

impl Measurand {
    /// The unit in which it is shown.
    #[must_use]
    pub fn unit(self) -> &'static Unit {
        match self {
            Self::ResistanceLl | Self::Kty | Self::Ptc => &OHM,
            Self::InductanceLl => &MILLIHENRY,
            Self::Emf | Self::BrakeVoltage => &VOLT,
            Self::BrakeOpeningCurrent | Self::BrakeHoldingCurrent | Self::NoLoadCurrent => &AMPERE,
            Self::BrakeOpeningTime | Self::BrakeClosingTime => &MILLISECOND,
            Self::DirectionFlange | Self::DirectionPosition | Self::Ratio | Self::PolePairs => &ONE,
        }
    }

    /// Whether there is no such value without a brake.
    pub(super) const fn is_of_the_brake(self) -> bool {
        matches!(
            self,
            Self::BrakeVoltage
                | Self::BrakeOpeningCurrent
                | Self::BrakeHoldingCurrent
                | Self::BrakeOpeningTime
                | Self::BrakeClosingTime
        )
    }
}

identified! {
    /// What the band about a value rests on.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Band {
        /// A tolerance that the manual prints.
        Printed = "printed",
        /// What another maker lets the data of its servo motors be off: R ±10 %, k_E ±7.5 % (simodrive-611a).
        ServoMotors = "servo_motors",
        /// Least and largest resistance of the sensor's data sheet (nxp-kty84): ±3 % at 100 °C, wider away from it.
        KtySheet = "kty_data_sheet",
        /// The bounds of DIN 44081.
        Din44081 = "din_44081",
        /// What a joint with such a gear was identified to lie off its catalogue (table friction-identified): one share of the
        /// constant part, another of that which grows with the speed.
        Friction = "friction",
        /// No source states one: ours.
        Ours = "ours",
        /// There is one right answer; 2 % are ours, for reading two values.
        Exact = "exact",
    }
}

impl Band {
    /// Whether a value outside is wrong by itself; otherwise it is only advice.
    #[must_use]
    pub const fn is_firm(self) -> bool {
        matches!(self, Self::Printed | Self::ServoMotors | Self::KtySheet | Self::Din44081 | Self::Exact)
    }

    /// How far it can be trusted.
    #[must_use]
    pub const fn grade(self) -> Grade {
        match self {
            Self::Printed => Grade::Printed,
            Self::ServoMotors | Self::KtySheet | Self::Din44081 => Grade::Published,
            Self::Friction => Grade::Estimated,
            Self::Ours | Self::Exact => Grade::Assumed,
        }
    }
}

/// What a measurement should give. All in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// What is measured.
    pub what: Measurand,
    /// The value; `None` where there is an upper bound alone.
    pub nominal: Option<f64>,
    /// Lower edge.
    pub low: f64,
    /// Upper edge.
    pub high: f64,
    /// What the band rests on.
    pub band: Band,
    /// Where the value stands.
    pub sources: Vec<Source>,
    /// How far value and band can be trusted.
    pub grade: Grade,
}

/// Half-widths of the bands, as shares.
const RESISTANCE: f64 = 0.10;
const VOLTAGE_CONSTANT: f64 = 0.075;
/// Computed without saturation (cha-manual section 11.1), and no source states the deviation.
const INDUCTANCE: f64 = 0.25;
/// The supply may be 10 % off (printed), the coil as much as a winding.
const BRAKE_CURRENT: f64 = 0.20;
/// A time depends on voltage, wear and the circuit of the coil.
const BRAKE_TIME: f64 = 0.5;
/// Reading of two speeds.
const READING: f64 = 0.02;

impl Commissioning {
    fn about(&self, what: Measurand, id: ParameterId, (share, band): (f64, Band)) -> Option<Expected> {
        let parameter = self.get(id)?;
        Some(Expected {
            what,
            nominal: Some(parameter.si),
            low: parameter.si * (1.0 - share),
            high: parameter.si * (1.0 + share),
            band,
            sources: parameter.sources.clone(),
            grade: parameter.grade.worst(band.grade()),
        })
    }

    /// R = R_LL (1 + 3.93e-3 (ϑ − 20 °C)), see [`copper_resistance`].
    #[must_use]
    pub fn expected_resistance(&self, winding: ThermodynamicTemperature) -> Option<Expected> {
        let at_20 = self.about(Measurand::ResistanceLl, ParameterId::ResistanceLl, (RESISTANCE, Band::ServoMotors))?;
        let factor = copper_resistance(ElectricalResistance::from_si(1.0), winding).si();
        Some(scaled(at_20, factor))
    }

    /// L_LL as printed.
    #[must_use]
    pub fn expected_inductance(&self) -> Option<Expected> {
        self.about(Measurand::InductanceLl, ParameterId::InductanceLl, (INDUCTANCE, Band::Ours))
    }

    /// U = k_EM n, rms between two terminals.
    #[must_use]
    pub fn expected_emf(&self, speed_motor: AngularVelocity) -> Option<Expected> {
        let per_speed =
            self.about(Measurand::Emf, ParameterId::VoltageConstant, (VOLTAGE_CONSTANT, Band::ServoMotors))?;
        Some(scaled(per_speed, speed_motor.si().abs()))
    }

    /// R of the KTY, see [`sensors::kty_resistance`], within [`sensors::kty_band`]; `None` where it is not led out.
    #[must_use]
    pub fn expected_kty(&self, sensor: ThermodynamicTemperature) -> Option<Expected> {
        let nominal = sensors::kty_resistance(sensor).filter(|_| self.has_kty())?;
        let [low, high] = sensors::kty_band(sensor)?.map(Measure::si);
        let place = sensors::kty_cell(sensor);
        Some(Expected {
            what: Measurand::Kty,
            nominal: Some(nominal.si()),
            low,
            high,
            band: Band::KtySheet,
            sources: place.map(|cell| Source::Published(&cell.place)).into_iter().collect(),
            grade: Band::KtySheet.grade(),
        })
    }

    /// The bound of a cold PTC; `None` without one, and from T_NAT − 20 K on, where the standard says nothing for a while.
    #[must_use]
    pub fn expected_ptc(&self, sensor: ThermodynamicTemperature) -> Option<Expected> {
        let response = configurator::ptc_cell(&self.code).filter(|_| self.has_ptc())?;
        let celsius = response.limit().number()?;
        let cold = sensors::ptc_bounds().into_iter().next()?;
        let from_response = sensor.in_unit(&DEGREE_CELSIUS) - celsius;
        (from_response <= -20.0).then_some(())?;
        Some(Expected {
            what: Measurand::Ptc,
            nominal: None,
            low: SHORT_CIRCUIT_OHM,
            high: cold.limit().number()?,
            band: Band::Din44081,
            sources: vec![Source::Published(&cold.place), Source::Cell(&response.place)],
            grade: Band::Din44081.grade(),
        })
    }

    /// U_Br with its printed tolerance.
    #[must_use]
    pub fn expected_brake_voltage(&self) -> Option<Expected> {
        let drive = catalogue::drive(self.code.size, self.code.winding, self.code.feedback)?;
        let cell = drive.cell("U_Br", "", self.code.feedback, self.code.ratio).filter(|_| self.has_brake())?;
        let Value::Tolerance { plus_minus_percent, .. } = cell.limit() else { return None };
        self.about(Measurand::BrakeVoltage, ParameterId::BrakeVoltage, (plus_minus_percent / 100.0, Band::Printed))
    }

    /// A current or a time of the brake.
    #[must_use]
    pub fn expected_brake(&self, what: Measurand) -> Option<Expected> {
        let (id, share) = match what {
            Measurand::BrakeOpeningCurrent => (ParameterId::BrakeOpeningCurrent, BRAKE_CURRENT),
            Measurand::BrakeHoldingCurrent => (ParameterId::BrakeHoldingCurrent, BRAKE_CURRENT),
            Measurand::BrakeOpeningTime => (ParameterId::BrakeOpeningTime, BRAKE_TIME),
            Measurand::BrakeClosingTime => (ParameterId::BrakeClosingTime, BRAKE_TIME),
            _ => return None,
        };
        self.about(what, id, (share, Band::Ours))
    }

    /// The temperature of the warm gear, the warmest for which the no-load current is printed.
    #[must_use]
    pub fn warm_gear(&self) -> Option<ThermodynamicTemperature> {
        NoLoadFriction::of(&self.actuator).ok().map(|law| law.warmest())
    }

    /// I = I_NLS + K_INL(ϑ) |n|, n at the output, see [`NoLoadFriction`].
    ///
    /// # Valid
    /// Uncoupled, steady speed. Below the coldest printed temperature by extrapolation, whose band widens the one here (docs/theory/current.md).
    #[must_use]
    pub fn expected_no_load(&self, speed_out: AngularVelocity, gear: ThermodynamicTemperature) -> Option<Expected> {
        let law = NoLoadFriction::of(&self.actuator).ok()?;
        let at = law.at(gear);
        let (starting, growing) = (at.starting.si(), at.constant.si() * speed_out.si().abs());
        let (below, beyond) = law.cold_band(gear).ok()?.unwrap_or((1.0, 1.0));
        let (start, growth) =
            (self.get(ParameterId::NoLoadStartingCurrent)?, self.get(ParameterId::NoLoadCurrentConstant30)?);
        let (off_starting, off_growing) = (deviation("dev_starting")?, deviation("dev_growing")?);
        let band = [off_starting.1, off_growing.1].map(|cell| Source::Published(&cell.place)).to_vec();
        let (off_starting, off_growing) = (off_starting.0, off_growing.0);
        Some(Expected {
            what: Measurand::NoLoadCurrent,
            nominal: Some(starting + growing),
            low: below * (starting * (1.0 - off_starting) + growing * (1.0 - off_growing)),
            high: beyond * (starting * (1.0 + off_starting) + growing * (1.0 + off_growing)),
            band: Band::Friction,
            sources: [start.sources.clone(), growth.sources.clone(), vec![Source::Model { name: "current" }], band]
                .concat(),
            grade: start.grade.worst(growth.grade).worst(Band::Friction.grade()),
        })
    }

    /// i of the gear, by two speeds.
    #[must_use]
    pub fn expected_ratio(&self) -> Option<Expected> {
        self.about(Measurand::Ratio, ParameterId::ReductionRatio, (READING, Band::Exact))
    }

    /// p of the motor, by frequency and speed.
    #[must_use]
    pub fn expected_pole_pairs(&self) -> Option<Expected> {
        self.about(Measurand::PolePairs, ParameterId::PolePairs, (READING, Band::Exact))
    }
}

/// Below it a drive takes a temperature sensor for short-circuited (sinamics-g115d).
pub const SHORT_CIRCUIT_OHM: f64 = 20.0;

/// Above it a PTC is open. Ours: the standard has no upper bound of one that has responded, which stays below some 100 kΩ.
pub const PTC_OPEN_OHM: f64 = 1e6;

/// Above it a drive takes a KTY for open (sinamics-g115d).
pub const KTY_OPEN_OHM: f64 = 2120.0;

/// Below it a drive takes a KTY for short-circuited (sinamics-g115d).
pub const KTY_SHORT_OHM: f64 = 50.0;

/// How far identified friction lay off the catalogue, as a share, with its cell.
fn deviation(symbol: &str) -> Option<(f64, &'static Cell)> {
    let cell = catalogue::table_cell("friction-identified", symbol)?;
    Some((cell.limit().number()? / 100.0, cell))
}

fn scaled(expected: Expected, factor: f64) -> Expected {
    Expected {
        nominal: expected.nominal.map(|nominal| nominal * factor),
        low: expected.low * factor,
        high: expected.high * factor,
        grade: expected.grade.worst(Grade::Computed),
        ..expected
    }
}

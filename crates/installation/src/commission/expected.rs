//! Expected values of measurements, with their bands and the sources of these.

use super::{Commissioning, ParameterId, ParameterToSet, sensors};
use actuator::{NoLoadFriction, copper_resistance};
use catalogue::{Cell, Value};
use provenance::{Grade, Source};
use quantities::unit::{AMPERE, DEGREE_CELSIUS, MILLIHENRY, MILLISECOND, OHM, ONE, VOLT};
use quantities::{AngularVelocity, ElectricalResistance, Measure, ThermodynamicTemperature, Unit, identified};

identified! {
    /// A quantity to measure.
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
        /// Opening current of the brake.
        BrakeOpeningCurrent = "brake_opening_current",
        /// Holding current of the brake.
        BrakeHoldingCurrent = "brake_holding_current",
        /// Opening time of the brake.
        BrakeOpeningTime = "brake_opening_time",
        /// Closing time of the brake.
        BrakeClosingTime = "brake_closing_time",
        /// Direction of the flange opposite to the motor.
        DirectionFlange = "direction_flange",
        /// Increasing position while the motor turns clockwise.
        DirectionPosition = "direction_position",
        /// Motor speed over flange speed.
        Ratio = "ratio",
        /// Electrical over mechanical frequency of the motor.
        PolePairs = "pole_pairs",
        /// No-load current at a speed, rms.
        NoLoadCurrent = "no_load_current",
    }
}

impl Measurand {
    /// Returns the unit of display.
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

    /// Returns `true` if the quantity requires a brake.
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
    /// Basis of the band of an expected value.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Band {
        /// Tolerance stated in the manual.
        Printed = "printed",
        /// Tolerances of another manufacturer's servo motors: R ±10 %, k_E ±7.5 % (simodrive-611a).
        ServoMotors = "servo_motors",
        /// Smallest and largest resistance in the sensor's data sheet (nxp-kty84): ±3 % at 100 °C, wider at other
        /// temperatures.
        KtySheet = "kty_data_sheet",
        /// Bounds of DIN 44081.
        Din44081 = "din_44081",
        /// Deviation of the identified friction of a joint with such a gear from its catalogue (table
        /// friction-identified): one share of the constant part, another of the part that grows with the speed.
        Friction = "friction",
        /// Chosen by antrieb, because no source states a tolerance.
        Ours = "ours",
        /// A single correct value, with 2 % chosen by antrieb for reading errors of two values.
        Exact = "exact",
    }
}

impl Band {
    /// Returns `true` if a value outside the band is wrong; otherwise it is only advice.
    #[must_use]
    pub const fn is_firm(self) -> bool {
        matches!(self, Self::Printed | Self::ServoMotors | Self::KtySheet | Self::Din44081 | Self::Exact)
    }

    /// Returns the grade of trust.
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

/// Expected value of a measurement, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct ExpectedValue {
    /// Quantity to measure.
    pub what: Measurand,
    /// Expected value; `None` if there is only an upper bound.
    pub nominal: Option<f64>,
    /// Lower edge of the band.
    pub low: f64,
    /// Upper edge of the band.
    pub high: f64,
    /// Basis of the band.
    pub band: Band,
    /// Sources of the value.
    pub sources: Vec<Source>,
    /// Grade of trust in value and band.
    pub grade: Grade,
    /// Errata that concern the value.
    pub errata: Vec<&'static str>,
}

/// Half widths of the bands, relative to the value \[1\].
const RESISTANCE: f64 = 0.10;
const VOLTAGE_CONSTANT: f64 = 0.075;
/// Computed without saturation (cha-manual section 11.1); no source states the deviation.
const INDUCTANCE: f64 = 0.25;
/// 10 % tolerance of the supply (manual), and as much for the coil as for a winding.
const BRAKE_CURRENT: f64 = 0.20;
/// The times depend on voltage, wear and the circuit of the coil.
const BRAKE_TIME: f64 = 0.5;
/// Reading error of two speeds.
const READING: f64 = 0.02;

impl Commissioning {
    fn about(&self, what: Measurand, id: ParameterId, (share, band): (f64, Band)) -> Option<ExpectedValue> {
        let parameter = self.get(id)?;
        Some(ExpectedValue {
            what,
            nominal: Some(parameter.si),
            low: parameter.si * (1.0 - share),
            high: parameter.si * (1.0 + share),
            band,
            sources: parameter.sources.clone(),
            grade: parameter.grade.worst(band.grade()),
            errata: parameter.errata.clone(),
        })
    }

    /// Returns the winding resistance R = R_LL (1 + 3.93e-3 (ϑ − 20 °C)), see [`copper_resistance`].
    #[must_use]
    pub fn expected_resistance(&self, winding: ThermodynamicTemperature) -> Option<ExpectedValue> {
        let at_20 = self.about(Measurand::ResistanceLl, ParameterId::ResistanceLl, (RESISTANCE, Band::ServoMotors))?;
        let factor = copper_resistance(ElectricalResistance::from_si(1.0), winding).si();
        Some(scaled(at_20, factor))
    }

    /// Returns L_LL of the manual.
    #[must_use]
    pub fn expected_inductance(&self) -> Option<ExpectedValue> {
        self.about(Measurand::InductanceLl, ParameterId::InductanceLl, (INDUCTANCE, Band::Ours))
    }

    /// Returns the induced voltage U = k_EM n, rms between two terminals.
    #[must_use]
    pub fn expected_emf(&self, speed_motor: AngularVelocity) -> Option<ExpectedValue> {
        let per_speed =
            self.about(Measurand::Emf, ParameterId::VoltageConstant, (VOLTAGE_CONSTANT, Band::ServoMotors))?;
        Some(scaled(per_speed, speed_motor.si().abs()))
    }

    /// Returns the resistance of the KTY, see [`sensors::kty_resistance`], with the band [`sensors::kty_band`]; `None`
    /// if no connector has contacts for it.
    #[must_use]
    pub fn expected_kty(&self, sensor: ThermodynamicTemperature) -> Option<ExpectedValue> {
        let nominal = sensors::kty_resistance(sensor).filter(|_| self.has_kty())?;
        let [low, high] = sensors::kty_band(sensor)?.map(Measure::si);
        let place = sensors::kty_cell(sensor);
        Some(ExpectedValue {
            what: Measurand::Kty,
            nominal: Some(nominal.si()),
            low,
            high,
            band: Band::KtySheet,
            sources: place.iter().map(|cell| Source::Published(&cell.place)).collect(),
            grade: Band::KtySheet.grade(),
            errata: errata_of(place),
        })
    }

    /// Returns the bound of a cold PTC; `None` without a PTC, and from T_NAT − 20 K on, above which the standard states
    /// no bound for a range.
    #[must_use]
    pub fn expected_ptc(&self, sensor: ThermodynamicTemperature) -> Option<ExpectedValue> {
        let response = self.ptc_response()?;
        let celsius = response.limit().number()?;
        let cold = sensors::ptc_bounds().into_iter().next()?;
        let from_response = sensor.in_unit(&DEGREE_CELSIUS) - celsius;
        (from_response <= -20.0).then_some(())?;
        Some(ExpectedValue {
            what: Measurand::Ptc,
            nominal: None,
            low: SHORT_CIRCUIT_OHM,
            high: cold.limit().number()?,
            band: Band::Din44081,
            sources: vec![Source::Published(&cold.place), Source::Cell(&response.place)],
            grade: Band::Din44081.grade(),
            errata: errata_of([cold, response]),
        })
    }

    /// Returns U_Br with the tolerance of the manual.
    #[must_use]
    pub fn expected_brake_voltage(&self) -> Option<ExpectedValue> {
        let drive = catalogue::drive(self.code.size, self.code.winding, self.code.feedback)?;
        let cell = drive.cell("U_Br", "", self.code.feedback, self.code.ratio).filter(|_| self.has_brake())?;
        let Value::Tolerance { plus_minus_percent, .. } = cell.limit() else { return None };
        self.about(Measurand::BrakeVoltage, ParameterId::BrakeVoltage, (plus_minus_percent / 100.0, Band::Printed))
    }

    /// Returns a current or a time of the brake.
    #[must_use]
    pub fn expected_brake(&self, what: Measurand) -> Option<ExpectedValue> {
        let (id, share) = match what {
            Measurand::BrakeOpeningCurrent => (ParameterId::BrakeOpeningCurrent, BRAKE_CURRENT),
            Measurand::BrakeHoldingCurrent => (ParameterId::BrakeHoldingCurrent, BRAKE_CURRENT),
            Measurand::BrakeOpeningTime => (ParameterId::BrakeOpeningTime, BRAKE_TIME),
            Measurand::BrakeClosingTime => (ParameterId::BrakeClosingTime, BRAKE_TIME),
            _ => return None,
        };
        self.about(what, id, (share, Band::Ours))
    }

    /// Returns the temperature of a warm gear, the highest for which the manual states the no-load current.
    #[must_use]
    pub fn warm_gear(&self) -> Option<ThermodynamicTemperature> {
        NoLoadFriction::of(&self.actuator).ok().map(|law| law.warmest())
    }

    /// Returns the no-load current I = I_NLS + K_INL(ϑ) |n|, n at the output, see [`NoLoadFriction`].
    ///
    /// # Valid
    /// Uncoupled, at constant speed. Below the lowest temperature of the manual by extrapolation, whose band widens
    /// this one (docs/theory/current.md).
    #[must_use]
    pub fn expected_no_load(
        &self,
        speed_out: AngularVelocity,
        gear: ThermodynamicTemperature,
    ) -> Option<ExpectedValue> {
        let law = NoLoadFriction::of(&self.actuator).ok()?;
        let at = law.at(gear);
        let (starting, growing) = (at.starting.si(), at.constant.si() * speed_out.si().abs());
        let (below, beyond) = law.cold_band(gear).ok()?.unwrap_or((1.0, 1.0));
        let start = self.get(ParameterId::NoLoadStartingCurrent)?;
        // The value at a temperature of the manual is stated; between and below them it follows from both.
        let stated = [
            (law.cold_start(), ParameterId::NoLoadCurrentConstant30),
            (law.warmest(), ParameterId::NoLoadCurrentConstant80),
        ];
        let (at_one, of_both) = (stated.iter().filter(|(at, _)| *at == gear), stated.iter());
        let used: Vec<ParameterId> = at_one.map(|(_, id)| *id).collect();
        let used = if used.is_empty() { of_both.map(|(_, id)| *id).collect() } else { used };
        let growths: Vec<&ParameterToSet> = used.into_iter().filter_map(|id| self.get(id)).collect();
        let (off_starting, off_growing) = (deviation("dev_starting")?, deviation("dev_growing")?);
        let band = [off_starting.1, off_growing.1].map(|cell| Source::Published(&cell.place)).to_vec();
        let (off_starting, off_growing) = (off_starting.0, off_growing.0);
        Some(ExpectedValue {
            what: Measurand::NoLoadCurrent,
            nominal: Some(starting + growing),
            low: below * (starting * (1.0 - off_starting) + growing * (1.0 - off_growing)),
            high: beyond * (starting * (1.0 + off_starting) + growing * (1.0 + off_growing)),
            band: Band::Friction,
            sources: std::iter::once(start)
                .chain(growths.iter().copied())
                .flat_map(|datum| datum.sources.clone())
                .chain([Source::Model { name: "current" }])
                .chain(band)
                .collect(),
            grade: growths
                .iter()
                .fold(start.grade, |worst, datum| worst.worst(datum.grade))
                .worst(Band::Friction.grade()),
            errata: std::iter::once(start).chain(growths).flat_map(|datum| datum.errata.clone()).collect(),
        })
    }

    /// Returns the reduction ratio i, from two speeds.
    #[must_use]
    pub fn expected_ratio(&self) -> Option<ExpectedValue> {
        self.about(Measurand::Ratio, ParameterId::ReductionRatio, (READING, Band::Exact))
    }

    /// Returns the number of pole pairs p, from frequency and speed.
    #[must_use]
    pub fn expected_pole_pairs(&self) -> Option<ExpectedValue> {
        self.about(Measurand::PolePairs, ParameterId::PolePairs, (READING, Band::Exact))
    }
}

/// Resistance below which a drive considers a temperature sensor short-circuited \[Ω\] (sinamics-g115d).
pub const SHORT_CIRCUIT_OHM: f64 = 20.0;

/// Resistance above which a PTC is open \[Ω\]. Chosen by antrieb: the standard has no upper bound after the response,
/// which stays below some 100 kΩ.
pub const PTC_OPEN_OHM: f64 = 1e6;

/// Resistance above which a drive considers a KTY open \[Ω\] (sinamics-g115d).
pub const KTY_OPEN_OHM: f64 = 2120.0;

/// Resistance below which a drive considers a KTY short-circuited \[Ω\] (sinamics-g115d).
pub const KTY_SHORT_OHM: f64 = 50.0;

/// Returns the errata of some cells.
fn errata_of(cells: impl IntoIterator<Item = &'static Cell>) -> Vec<&'static str> {
    cells.into_iter().flat_map(|cell| cell.errata).copied().collect()
}

/// Returns the relative deviation of identified friction from the catalogue, with its cell.
fn deviation(symbol: &str) -> Option<(f64, &'static Cell)> {
    let cell = catalogue::table_cell("friction-identified", symbol)?;
    Some((cell.limit().number()? / 100.0, cell))
}

fn scaled(expected: ExpectedValue, factor: f64) -> ExpectedValue {
    ExpectedValue {
        nominal: expected.nominal.map(|nominal| nominal * factor),
        low: expected.low * factor,
        high: expected.high * factor,
        grade: expected.grade.worst(Grade::Computed),
        ..expected
    }
}

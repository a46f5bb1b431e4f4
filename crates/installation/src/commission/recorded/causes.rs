//! Typical causes of deviations, by the quotient of measured and expected value.

use crate::commission::expected::{
    ExpectedValue, KTY_OPEN_OHM, KTY_SHORT_OHM, Measurand, PTC_OPEN_OHM, SHORT_CIRCUIT_OHM,
};
use crate::commission::{Commissioning, ParameterId, sensors};
use order_code::Ratio;
use quantities::unit::DEGREE_CELSIUS;
use quantities::{AngularVelocity, ElectricalResistance, Measure};
use std::f64::consts::SQRT_2;

/// Most likely cause of a deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cause {
    /// Half of the expected value: value of a single phase.
    OnePhase,
    /// Twice the expected value: a value between terminals taken for a phase value and doubled.
    Doubled,
    /// Three quarters of the resistance: two terminals were connected.
    TerminalsJoined,
    /// Winding temperature different from the stated one, approximately this one \[°C\].
    WindingTemperature(f64),
    /// A small resistance increased by leads and contacts \[Ω\].
    Leads(f64),
    /// Open circuit.
    Open,
    /// Short circuit.
    Short,
    /// 1/√3: measured against the star point.
    PhaseVoltage,
    /// √2: the amplitude instead of the rms value.
    Amplitude,
    /// √2/√3: the amplitude against the star point.
    PhaseAmplitude,
    /// 2√2: from peak to peak.
    PeakToPeak,
    /// √3: taken for a phase value and converted.
    RootThree,
    /// Twice or half the expected value, so that the speed may be wrong by a factor of two: pole pairs or reading of
    /// the frequency.
    SpeedFactor,
    /// Flange speed instead of motor speed.
    SpeedOfFlange,
    /// Slightly low: hot or partly demagnetised magnets.
    Magnets,
    /// KTY at this temperature \[°C\], or with reversed polarity.
    KtyPolesOrTemperature(f64),
    /// Measurement of the other sensor.
    OtherSensor,
    /// PTC after its response: hot winding or open circuit.
    PtcResponded,
    /// No current: brake not connected, or its supply switched off.
    BrakeNotConnected,
    /// Half the voltage.
    HalfVoltage,
    /// Holding current instead of opening current.
    HoldingCurrent,
    /// Opening current instead of holding current, because nothing reduces it.
    OpeningCurrent,
    /// Slow brake: voltage too low, or a diode across the coil slows the decay of its current.
    SlowBrake,
    /// Much more current than friction explains: closed or dragging brake, jammed hollow shaft, commutation offset.
    Dragging,
    /// 1/√2: converted to rms once too often.
    ConvertedTwice,
    /// Faster than the flange can turn: the motor speed.
    SpeedOfMotor,
    /// Motor and flange observed from opposite sides: equal directions in the record.
    SameDirection,
    /// Position counting in the opposite direction: signals or phases exchanged, or inverted by the drive.
    CountingReversed,
    /// Ratio of another gear.
    OtherRatio(Ratio),
    /// Number of pole pairs found.
    PolePairs(f64),
}

impl Cause {
    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::OnePhase => "one_phase",
            Self::Doubled => "doubled",
            Self::TerminalsJoined => "terminals_joined",
            Self::WindingTemperature(_) => "winding_temperature",
            Self::Leads(_) => "leads",
            Self::Open => "open",
            Self::Short => "short",
            Self::PhaseVoltage => "phase_voltage",
            Self::Amplitude => "amplitude",
            Self::PhaseAmplitude => "phase_amplitude",
            Self::PeakToPeak => "peak_to_peak",
            Self::RootThree => "root_three",
            Self::SpeedFactor => "speed_factor",
            Self::SpeedOfFlange => "speed_of_flange",
            Self::Magnets => "magnets",
            Self::KtyPolesOrTemperature(_) => "kty_poles_or_temperature",
            Self::OtherSensor => "other_sensor",
            Self::PtcResponded => "ptc_responded",
            Self::BrakeNotConnected => "brake_not_connected",
            Self::HalfVoltage => "half_voltage",
            Self::HoldingCurrent => "holding_current",
            Self::OpeningCurrent => "opening_current",
            Self::SlowBrake => "slow_brake",
            Self::Dragging => "dragging",
            Self::ConvertedTwice => "converted_twice",
            Self::SpeedOfMotor => "speed_of_motor",
            Self::SameDirection => "same_direction",
            Self::CountingReversed => "counting_reversed",
            Self::OtherRatio(_) => "other_ratio",
            Self::PolePairs(_) => "pole_pairs",
        }
    }

    /// Returns `true` if a value with this cause is wrong for any width of the band: the pattern is a slip, not
    /// scatter.
    #[must_use]
    pub const fn is_certain(self) -> bool {
        !matches!(self, Self::SlowBrake | Self::Leads(_) | Self::Amplitude | Self::ConvertedTwice)
    }
}

/// Largest relative distance of a quotient from that of a cause \[1\]. The inductance has a wide band of its own.
const NEAR: f64 = 0.05;
const NEAR_INDUCTANCE: f64 = 0.15;
const NEAR_BRAKE: f64 = 0.15;

/// Factor on the expected current above which friction is excluded \[1\].
const DRAGGING: f64 = 2.0;

/// Largest resistance of leads and contacts of a two-wire measurement \[Ω\].
const LEADS_MOST_OHM: f64 = 0.5;

fn is_close(quotient: f64, pattern: f64, share: f64) -> bool {
    (quotient / pattern - 1.0).abs() <= share
}

fn first(quotient: f64, share: f64, patterns: &[(f64, Cause)]) -> Option<Cause> {
    patterns.iter().find(|(pattern, _)| is_close(quotient, *pattern, share)).map(|(_, cause)| *cause)
}

/// Returns the likely cause of a value that differs from the expected one; `None` if no pattern fits.
pub(super) fn of(about: &Commissioning, value: f64, expected: &ExpectedValue) -> Option<Cause> {
    let quotient = value / expected.nominal.unwrap_or(expected.high);
    if let Some(cause) = of_a_broken_sensor(expected.what, value) {
        return Some(cause);
    }
    match expected.what {
        Measurand::ResistanceLl => resistance(about, value, quotient, expected),
        Measurand::InductanceLl => match quotient {
            ..0.1 => Some(Cause::Short),
            _ => first(quotient, NEAR_INDUCTANCE, &[(0.5, Cause::OnePhase), (2.0, Cause::Doubled)]),
        },
        Measurand::Emf => emf(about, quotient),
        Measurand::Kty => kty(about, value),
        Measurand::Ptc => ptc(value, expected),
        Measurand::BrakeVoltage => match quotient {
            ..0.05 => Some(Cause::BrakeNotConnected),
            _ => first(quotient, NEAR_BRAKE, &[(0.5, Cause::HalfVoltage)]),
        },
        Measurand::BrakeOpeningCurrent | Measurand::BrakeHoldingCurrent => brake_current(about, expected, quotient),
        Measurand::BrakeOpeningTime | Measurand::BrakeClosingTime => (quotient > 1.0).then_some(Cause::SlowBrake),
        Measurand::NoLoadCurrent => {
            first(quotient, NEAR, &[(SQRT_2, Cause::Amplitude), (1.0 / SQRT_2, Cause::ConvertedTwice)])
                .or_else(|| (quotient > DRAGGING).then_some(Cause::Dragging))
        }
        Measurand::Ratio => {
            let other = Ratio::all(about.code.series()).find(|ratio| is_close(value, f64::from(ratio.value()), 0.02));
            other.map(Cause::OtherRatio)
        }
        Measurand::PolePairs => Some(Cause::PolePairs(value)),
        Measurand::DirectionFlange | Measurand::DirectionPosition => None,
    }
}

/// Returns the cause of a speed that the flange cannot reach, which is that of the motor.
pub(super) fn of_speed(about: &Commissioning, speed_out: AngularVelocity) -> Option<Cause> {
    let (most, ratio) = (about.get(ParameterId::SpeedMotorMax)?, about.get(ParameterId::ReductionRatio)?);
    (speed_out.si().abs() > 1.05 * most.si / ratio.si).then_some(Cause::SpeedOfMotor)
}

fn resistance(about: &Commissioning, value: f64, quotient: f64, expected: &ExpectedValue) -> Option<Cause> {
    match quotient {
        ..0.1 => return Some(Cause::Short),
        10.0.. => return Some(Cause::Open),
        _ => {}
    }
    let patterns = [(0.5, Cause::OnePhase), (0.75, Cause::TerminalsJoined), (2.0, Cause::Doubled)];
    if let Some(cause) = first(quotient, NEAR, &patterns) {
        return Some(cause);
    }
    let excess = value - expected.nominal?;
    let at_20 = about.get(ParameterId::ResistanceLl)?.si;
    if excess > 0.0 && excess <= LEADS_MOST_OHM && at_20 <= 3.0 * LEADS_MOST_OHM {
        return Some(Cause::Leads(excess));
    }
    // Inverse of the law of copper, from two of its points.
    let degree = |celsius: f64| quantities::ThermodynamicTemperature::new_in(celsius, &DEGREE_CELSIUS);
    let rise = actuator::copper_resistance(ElectricalResistance::from_si(1.0), degree(21.0)).si() - 1.0;
    let celsius = 20.0 + (value / at_20 - 1.0) / rise;
    (-20.0..=180.0).contains(&celsius).then_some(Cause::WindingTemperature(celsius))
}

fn emf(about: &Commissioning, quotient: f64) -> Option<Cause> {
    let root_three = 3.0_f64.sqrt();
    let ratio = about.get(ParameterId::ReductionRatio).map_or(1.0, |ratio| ratio.si);
    let patterns = [
        (1.0 / root_three, Cause::PhaseVoltage),
        (SQRT_2 / root_three, Cause::PhaseAmplitude),
        (SQRT_2, Cause::Amplitude),
        (root_three, Cause::RootThree),
        (2.0 * SQRT_2, Cause::PeakToPeak),
        (0.5, Cause::SpeedFactor),
        (2.0, Cause::SpeedFactor),
        (ratio, Cause::SpeedOfFlange),
        (1.0 / ratio, Cause::SpeedOfFlange),
    ];
    match first(quotient, NEAR, &patterns) {
        None if quotient < 0.02 => Some(Cause::Open),
        None if (0.6..1.0).contains(&quotient) => Some(Cause::Magnets),
        found => found,
    }
}

/// Returns the cause of an open or short-circuited temperature sensor at any temperature; `None` otherwise.
pub(super) fn of_a_broken_sensor(what: Measurand, value: f64) -> Option<Cause> {
    match (what, value) {
        (Measurand::Kty, ..KTY_SHORT_OHM) | (Measurand::Ptc, ..SHORT_CIRCUIT_OHM) => Some(Cause::Short),
        (Measurand::Kty, KTY_OPEN_OHM..) | (Measurand::Ptc, PTC_OPEN_OHM..) => Some(Cause::Open),
        _ => None,
    }
}

fn kty(about: &Commissioning, value: f64) -> Option<Cause> {
    match value {
        ..=250.0 if about.has_ptc() => Some(Cause::OtherSensor),
        _ => {
            let shown = sensors::kty_temperature(ElectricalResistance::from_si(value))?;
            Some(Cause::KtyPolesOrTemperature(shown.in_unit(&DEGREE_CELSIUS)))
        }
    }
}

fn ptc(value: f64, expected: &ExpectedValue) -> Option<Cause> {
    // A KTY has 330 Ω at -50 °C and 880 Ω at 80 °C.
    const KTY_OHM: std::ops::Range<f64> = 330.0..880.0;
    const RESPONDED_OHM: f64 = 1330.0;
    if value >= RESPONDED_OHM {
        Some(Cause::PtcResponded)
    } else if value > expected.high && KTY_OHM.contains(&value) {
        Some(Cause::OtherSensor)
    } else {
        None
    }
}

fn brake_current(about: &Commissioning, expected: &ExpectedValue, quotient: f64) -> Option<Cause> {
    if quotient < 0.05 {
        return Some(Cause::BrakeNotConnected);
    }
    let opening = about.get(ParameterId::BrakeOpeningCurrent).map(|parameter| parameter.si);
    let holding = about.get(ParameterId::BrakeHoldingCurrent).map(|parameter| parameter.si);
    let share = opening.zip(holding).map(|(opening, holding)| holding / opening).filter(|share| *share < 0.9);
    match (expected.what, share) {
        // Half the voltage and the holding current may be similar; the holding current is then more likely.
        (Measurand::BrakeOpeningCurrent, Some(share)) if is_close(quotient, share, 0.1) => Some(Cause::HoldingCurrent),
        (Measurand::BrakeHoldingCurrent, Some(share)) if is_close(quotient, 1.0 / share, 0.1) => {
            Some(Cause::OpeningCurrent)
        }
        _ => first(quotient, NEAR_BRAKE, &[(0.5, Cause::HalfVoltage)]),
    }
}

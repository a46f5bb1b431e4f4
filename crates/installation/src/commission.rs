//! Motor data of an ordering code for the drive, and measured values of the commissioning.
//!
//! A neutral list of [`ParameterToSet`]s, each in SI with its sources; the formats of the drives ([`sinamics`], [`cia402`])
//! are tables that assign a parameter, a unit and a rounding, and compute nothing else. Values that the manual does not
//! state are [`Gap`]s.

pub mod checklist;
pub mod cia402;
mod counting;
pub mod encoder;
pub mod expected;
pub mod recorded;
pub mod sensors;
pub mod sinamics;

use crate::commission::encoder::EncoderRow;
use actuator::Parameters;
use catalogue::{Cell, Drive};
use order_code::{Brake, FeedbackKind, OrderCode};
use provenance::{Datum, Grade, Source};
use quantities::unit::{
    AMPERE, AMPERE_PER_REVOLUTION_PER_MINUTE, DEGREE_CELSIUS, HERTZ, KILOGRAM, KILOGRAM_SQUARE_METRE, MILLIHENRY,
    MILLISECOND, NEWTON_METRE, NEWTON_METRE_PER_AMPERE, OHM, ONE, REVOLUTION_PER_MINUTE, VOLT,
    VOLT_PER_THOUSAND_REVOLUTIONS,
};
use quantities::{Measure, MomentOfInertia, ThermodynamicTemperature, Unit, identified};

macro_rules! parameters {
    ($($(#[$doc:meta])* $name:ident => $id:literal, $symbol:literal, $unit:ident, $conversion:ident;)+) => {
        /// A value to enter in a drive.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum ParameterId { $($(#[$doc])* $name,)+ }

        impl ParameterId {
            /// The parameters in the order of the list.
            pub const ALL: &'static [Self] = &[$(Self::$name),+];

            /// Returns the identifier used in data exchange.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$name => $id,)+ }
            }

            /// Returns the symbol of the tables or of the computed value.
            #[must_use]
            pub const fn symbol(self) -> &'static str {
                match self { $(Self::$name => $symbol,)+ }
            }

            /// Returns the unit used in the list.
            #[must_use]
            pub fn unit(self) -> &'static Unit {
                match self { $(Self::$name => &$unit,)+ }
            }

            /// Returns the conversion from the value of the manual.
            #[must_use]
            pub const fn conversion(self) -> Conversion {
                match self { $(Self::$name => Conversion::$conversion,)+ }
            }
        }
    };
}

parameters! {
    /// Reduction ratio of the gear.
    ReductionRatio => "reduction_ratio", "i", ONE, AsPrinted;
    /// Pole pairs of the motor.
    PolePairs => "pole_pairs", "p", ONE, AsPrinted;
    /// Largest motor speed.
    SpeedMotorMax => "speed_motor_max", "n_mot_max", REVOLUTION_PER_MINUTE, AsPrinted;
    /// Rated motor speed.
    SpeedMotorRated => "speed_motor_rated", "n_N", REVOLUTION_PER_MINUTE, AsPrinted;
    /// Frequency of the current at rated speed.
    FrequencyRated => "frequency_rated", "f_N", HERTZ, Frequency;
    /// Largest output speed.
    SpeedOutMax => "speed_out_max", "n_max", REVOLUTION_PER_MINUTE, AsPrinted;
    /// Largest output torque.
    TorqueOutMax => "torque_out_max", "T_max", NEWTON_METRE, AsPrinted;
    /// Stall torque at the output.
    StallTorqueOut => "stall_torque_out", "T_0", NEWTON_METRE, AsPrinted;
    /// Motor torque at stall current.
    StallTorqueMotor => "stall_torque_motor", "T_0M", NEWTON_METRE, TorqueOfCurrent;
    /// Largest current, rms.
    CurrentMax => "current_max", "I_max", AMPERE, AsPrinted;
    /// Largest current, amplitude.
    CurrentMaxPeak => "current_max_peak", "I_max_pk", AMPERE, Amplitude;
    /// Stall current, rms.
    StallCurrent => "stall_current", "I_0", AMPERE, AsPrinted;
    /// Stall current, amplitude.
    StallCurrentPeak => "stall_current_peak", "I_0_pk", AMPERE, Amplitude;
    /// Current at which demagnetisation begins, rms.
    CurrentDemagnetisation => "current_demagnetisation", "I_E", AMPERE, AsPrinted;
    /// Smaller of I_max and I_E, rms.
    CurrentLimit => "current_limit", "I_lim", AMPERE, Smaller;
    /// Torque constant of the motor.
    TorqueConstantMotor => "torque_constant_motor", "k_TM", NEWTON_METRE_PER_AMPERE, AsPrinted;
    /// Torque constant at the output.
    TorqueConstantOut => "torque_constant_out", "k_Tout", NEWTON_METRE_PER_AMPERE, AsPrinted;
    /// Voltage constant, rms between two terminals.
    VoltageConstant => "voltage_constant_motor", "k_EM", VOLT_PER_THOUSAND_REVOLUTIONS, AsPrinted;
    /// Induced voltage at rated speed, rms between two terminals.
    EmfRated => "emf_rated", "U_EMF", VOLT, EmfOfSpeed;
    /// Resistance between two terminals at 20 °C.
    ResistanceLl => "resistance_ll", "R_LL", OHM, AsPrinted;
    /// Resistance of one phase at 20 °C.
    ResistancePhase => "resistance_phase", "R_ph", OHM, PhaseOfStar;
    /// Inductance between two terminals.
    InductanceLl => "inductance_ll", "L_LL", MILLIHENRY, AsPrinted;
    /// Inductance of one phase.
    InductancePhase => "inductance_phase", "L_ph", MILLIHENRY, PhaseOfStar;
    /// Moment of inertia on the motor side, of the ordered variant with or without brake.
    InertiaMotor => "inertia_motor", "J", KILOGRAM_SQUARE_METRE, FromTenThousandths;
    /// Mass of the actuator.
    Mass => "mass", "m", KILOGRAM, AsPrinted;
    /// Largest steady voltage of the DC link.
    DcLinkMax => "dc_link_max", "U_DCmax", VOLT, AsPrinted;
    /// No-load starting current, rms.
    NoLoadStartingCurrent => "no_load_starting_current", "I_NLS", AMPERE, AsPrinted;
    /// No-load current constant at 30 °C, per output speed.
    NoLoadCurrentConstant30 => "no_load_current_constant_30", "K_INL_30", AMPERE_PER_REVOLUTION_PER_MINUTE, AsPrinted;
    /// No-load current constant at 80 °C, per output speed.
    NoLoadCurrentConstant80 => "no_load_current_constant_80", "K_INL_80", AMPERE_PER_REVOLUTION_PER_MINUTE, AsPrinted;
    /// Winding temperature at which the drive warns.
    WindingWarning => "winding_warning", "T_KTY_warning", DEGREE_CELSIUS, AsPrinted;
    /// Winding temperature at which the drive switches off.
    WindingShutdown => "winding_shutdown", "T_KTY_shutdown", DEGREE_CELSIUS, AsPrinted;
    /// Increments of the feedback per motor turn.
    EncoderIncrements => "encoder_increments", "inc", ONE, AsPrinted;
    /// Periods of the incremental tracks per motor turn; pole pairs of a resolver.
    EncoderLines => "encoder_lines", "z", ONE, AsPrinted;
    /// Absolute positions per motor turn.
    EncoderPositions => "encoder_positions", "N_1", ONE, AsPrinted;
    /// Motor turns counted by an absolute feedback.
    EncoderTurns => "encoder_turns", "N_t", ONE, AsPrinted;
    /// Voltage of the brake.
    BrakeVoltage => "brake_voltage", "U_Br", VOLT, AsPrinted;
    /// Opening current of the brake.
    BrakeOpeningCurrent => "brake_opening_current", "I_OBr", AMPERE, AsPrinted;
    /// Holding current of the brake, which keeps it open.
    BrakeHoldingCurrent => "brake_holding_current", "I_HBr", AMPERE, AsPrinted;
    /// Opening time of the brake.
    BrakeOpeningTime => "brake_opening_time", "t_o", MILLISECOND, AsPrinted;
    /// Closing time of the brake.
    BrakeClosingTime => "brake_closing_time", "t_c", MILLISECOND, AsPrinted;
    /// Holding torque of the brake at the output.
    BrakeHoldingTorque => "brake_holding_torque", "T_Br", NEWTON_METRE, AsPrinted;
}

identified! {
    /// Conversion from the value of the manual.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Conversion {
        /// Value of the manual, including errata.
        AsPrinted = "as_printed",
        /// Unit conversion from 1e-4 kgm² in the manual to kgm².
        FromTenThousandths = "from_1e-4_kgm2",
        /// Half of the value between two terminals: star winding (cha-manual section 11.1).
        PhaseOfStar = "half_of_line_to_line",
        /// √2 times the rms value of a sinusoidal current.
        Amplitude = "rms_times_sqrt_2",
        /// f_N = p n_N/60.
        Frequency = "p*n_N/60",
        /// U = k_EM n_N/1000.
        EmfOfSpeed = "k_EM*n_N",
        /// T = k_TM I_0.
        TorqueOfCurrent = "k_TM*I_0",
        /// Smaller of two values.
        Smaller = "min(I_max, I_E)",
    }
}

/// A value to enter in a drive, with its sources.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterToSet {
    /// Kind of value.
    pub id: ParameterId,
    /// Value in SI.
    pub si: f64,
    /// Sources of the input values.
    pub sources: Vec<Source>,
    /// Grade of trust.
    pub grade: Grade,
    /// Errata that concern the value.
    pub errata: Vec<&'static str>,
}

impl ParameterToSet {
    /// Returns the value in the unit of the list, without rounding errors of the conversion.
    #[must_use]
    pub fn value(&self) -> f64 {
        clean(self.id.unit().from_si(self.si))
    }
}

/// Rounds a number to fifteen significant digits, which keeps the digits of the manual and removes rounding errors of
/// unit conversion.
///
/// The relative error is at most 5e-16.
#[must_use]
pub fn clean(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

/// A value that a drive may require but no source states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gap {
    /// Rated current, torque and power at rated speed, which no table states.
    RatedPoint,
    /// Rated voltage of the motor.
    RatedVoltage,
    /// Angle between encoder and rotor.
    CommutationOffset,
    /// Currents and time of the pole position identification.
    PolePosition,
    /// Thermal time constant of the winding for I²t.
    ThermalTimeConstant,
    /// Saliency, the difference of the inductances along and across the rotor, and saturation.
    Saliency,
    /// Gains of the loops.
    LoopGains,
    /// Direction of the position for clockwise rotation of the motor, which the manual does not state for the resolver.
    Counting,
    /// Resistance, inductance, inertia and pole pairs, for which CiA 402 has no objects.
    OwnObjects,
    /// A value with a dash in the table.
    NotPrinted(ParameterId),
}

impl Gap {
    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::RatedPoint => "rated_point",
            Self::RatedVoltage => "rated_voltage",
            Self::CommutationOffset => "commutation_offset",
            Self::PolePosition => "pole_position_identification",
            Self::ThermalTimeConstant => "thermal_time_constant",
            Self::Saliency => "saliency",
            Self::LoopGains => "loop_gains",
            Self::Counting => "direction_of_counting",
            Self::OwnObjects => "own_objects",
            Self::NotPrinted(parameter) => parameter.id(),
        }
    }
}

/// Commissioning data of one code.
#[derive(Clone, Debug)]
pub struct Commissioning {
    /// Ordering code of the actuator.
    pub code: OrderCode,
    /// Known values in the order of [`ParameterId::ALL`].
    pub parameters: Vec<ParameterToSet>,
    /// Values that are not known.
    pub gaps: Vec<Gap>,
    /// Data of the manual on the encoders.
    pub encoder: Vec<EncoderRow>,
    /// Parameters of the actuator.
    pub actuator: Parameters,
}

impl Commissioning {
    /// Returns a parameter, if its value is known.
    #[must_use]
    pub fn get(&self, id: ParameterId) -> Option<&ParameterToSet> {
        self.parameters.iter().find(|parameter| parameter.id == id)
    }

    /// Returns `true` if a connector has contacts for the PTC of the winding.
    #[must_use]
    pub fn has_ptc(&self) -> bool {
        catalogue::leads_out_ptc(&self.code)
    }

    /// Returns the cell with the response temperature of the PTC, if a connector has contacts for it.
    #[must_use]
    pub fn ptc_response(&self) -> Option<&'static Cell> {
        configurator::ptc_cell(&self.code).filter(|_| self.has_ptc())
    }

    /// Returns the kind of the motor feedback.
    #[must_use]
    pub fn feedback_kind(&self) -> Option<FeedbackKind> {
        self.code.feedback.kind()
    }

    /// Returns `true` if a connector has contacts for the KTY of the winding.
    #[must_use]
    pub fn has_kty(&self) -> bool {
        catalogue::leads_out_kty(&self.code)
    }

    /// Returns `true` if the code has a brake.
    #[must_use]
    pub fn has_brake(&self) -> bool {
        self.code.brake == Brake::With
    }
}

/// Returns the commissioning data of a code; `None` if the manual has no data for it.
#[must_use]
pub fn commission(code: &OrderCode) -> Option<Commissioning> {
    let actuator = configurator::parameters(code)?;
    let drive = catalogue::drive(code.size, code.winding, code.feedback)?;
    let mut parameters = Vec::new();
    let mut gaps = vec![
        Gap::RatedPoint,
        Gap::RatedVoltage,
        Gap::CommutationOffset,
        Gap::PolePosition,
        Gap::ThermalTimeConstant,
        Gap::Saliency,
        Gap::LoopGains,
        Gap::OwnObjects,
    ];
    if counting::counting_fact(code).is_none() {
        gaps.push(Gap::Counting);
    }
    for &id in ParameterId::ALL {
        match find(id, code, drive, &actuator) {
            Found::Known(parameter) => parameters.push(parameter),
            Found::NotPrinted => gaps.push(Gap::NotPrinted(id)),
            Found::NotApplicable => {}
        }
    }
    Some(Commissioning { code: *code, parameters, gaps, encoder: encoder::rows(code), actuator })
}

/// Result of the search for a parameter.
enum Found {
    Known(ParameterToSet),
    NotPrinted,
    NotApplicable,
}

/// Returns a datum as a parameter.
fn plain<Q: Measure>(id: ParameterId, datum: &Datum<Q>) -> Found {
    number(id, datum, Q::si)
}

fn number<T: Copy>(id: ParameterId, datum: &Datum<T>, si: impl Fn(T) -> f64) -> Found {
    match datum {
        Datum::Known(known) => Found::Known(ParameterToSet {
            id,
            si: si(known.value),
            sources: vec![known.source.clone()],
            grade: known.grade,
            errata: known.errata.to_vec(),
        }),
        Datum::NotPrinted => Found::NotPrinted,
        Datum::NotApplicable => Found::NotApplicable,
    }
}

/// Returns a datum multiplied by a factor, such as ½ or √2.
fn times<Q: Measure>(id: ParameterId, datum: &Datum<Q>, factor: f64) -> Found {
    computed(plain(id, datum), |si| si * factor)
}

fn computed(found: Found, change: impl Fn(f64) -> f64) -> Found {
    match found {
        Found::Known(parameter) => Found::Known(ParameterToSet {
            si: change(parameter.si),
            grade: parameter.grade.worst(Grade::Computed),
            ..parameter
        }),
        other => other,
    }
}

/// Combines two data into a third.
fn joined(one: Found, other: Found, join: impl Fn(f64, f64) -> f64) -> Found {
    match (one, other) {
        (Found::Known(one), Found::Known(other)) => Found::Known(ParameterToSet {
            id: one.id,
            si: join(one.si, other.si),
            grade: one.grade.worst(other.grade).worst(Grade::Computed),
            sources: [one.sources, other.sources].concat(),
            errata: [one.errata, other.errata].concat(),
        }),
        (Found::NotPrinted, _) | (_, Found::NotPrinted) => Found::NotPrinted,
        _ => Found::NotApplicable,
    }
}

fn find(id: ParameterId, code: &OrderCode, drive: &'static Drive, actuator: &Parameters) -> Found {
    use ParameterId as P;
    let identity = |value: f64| value;
    match id {
        P::ReductionRatio => number(id, &actuator.ratio, identity),
        P::PolePairs => number(id, &actuator.pole_pairs, identity),
        P::SpeedMotorMax => plain(id, &actuator.speed_motor_max),
        P::SpeedMotorRated => plain(id, &actuator.speed_motor_rated),
        // A speed in rad/s divided by 2π is a frequency in Hz.
        P::FrequencyRated => {
            let (pairs, speed) = (number(id, &actuator.pole_pairs, identity), plain(id, &actuator.speed_motor_rated));
            joined(pairs, speed, |pairs, speed| pairs * speed / std::f64::consts::TAU)
        }
        P::SpeedOutMax => plain(id, &actuator.speed_max),
        P::TorqueOutMax => plain(id, &actuator.torque_max),
        P::StallTorqueOut => plain(id, &actuator.stall_torque),
        P::StallTorqueMotor => {
            let (constant, current) = (plain(id, &actuator.torque_constant_motor), plain(id, &actuator.stall_current));
            joined(constant, current, |constant, current| constant * current)
        }
        P::CurrentMax => plain(id, &actuator.current_max),
        P::CurrentMaxPeak => times(id, &actuator.current_max, std::f64::consts::SQRT_2),
        P::StallCurrent => plain(id, &actuator.stall_current),
        P::StallCurrentPeak => times(id, &actuator.stall_current, std::f64::consts::SQRT_2),
        P::CurrentDemagnetisation => plain(id, &actuator.current_demagnetisation),
        P::CurrentLimit => limit(id, actuator),
        P::TorqueConstantMotor => plain(id, &actuator.torque_constant_motor),
        P::TorqueConstantOut => plain(id, &actuator.torque_constant_out),
        P::VoltageConstant => plain(id, &actuator.voltage_constant_motor),
        P::EmfRated => {
            let (constant, speed) =
                (plain(id, &actuator.voltage_constant_motor), plain(id, &actuator.speed_motor_rated));
            joined(constant, speed, |constant, speed| constant * speed)
        }
        P::ResistanceLl => plain(id, &actuator.resistance_ll),
        P::ResistancePhase => times(id, &actuator.resistance_ll, 0.5),
        P::InductanceLl => plain(id, &actuator.inductance_ll),
        P::InductancePhase => times(id, &actuator.inductance_ll, 0.5),
        P::InertiaMotor => {
            let symbol = if code.brake == Brake::With { "J_brake" } else { "J" };
            plain(id, &drive.datum::<MomentOfInertia>(symbol, "", code.feedback, code.ratio))
        }
        P::Mass => plain(id, &actuator.mass),
        P::DcLinkMax => plain(id, &actuator.dc_link_max),
        P::NoLoadStartingCurrent => plain(id, &actuator.no_load_starting_current),
        P::NoLoadCurrentConstant30 => plain(id, &actuator.no_load_current_constant_cold),
        P::NoLoadCurrentConstant80 => plain(id, &actuator.no_load_current_constant_warm),
        P::WindingWarning => threshold(id, code, "warning"),
        P::WindingShutdown => threshold(id, code, "shutdown"),
        P::EncoderIncrements => {
            let steps = encoder::increments(code).and_then(|cell| Some(cell.sourced(cell.limit().number()?)));
            number(id, &Datum::of(steps), identity)
        }
        P::EncoderLines => encoder_count(id, code, &["n_1_lines", "pole_pairs_resolver"]),
        P::EncoderPositions => encoder_count(id, code, &["positions_per_turn"]),
        P::EncoderTurns => encoder_count(id, code, &["turns"]),
        P::BrakeVoltage => plain(id, &actuator.brake.voltage),
        P::BrakeOpeningCurrent => plain(id, &actuator.brake.opening_current),
        P::BrakeHoldingCurrent => plain(id, &actuator.brake.holding_current),
        P::BrakeOpeningTime => plain(id, &actuator.brake.opening_time),
        P::BrakeClosingTime => plain(id, &actuator.brake.closing_time),
        P::BrakeHoldingTorque => plain(id, &actuator.brake.holding_torque),
    }
}

/// Returns a count of the motor feedback from the row with one of these symbols; a feedback without the row has no such
/// count.
fn encoder_count(id: ParameterId, code: &OrderCode, symbols: &[&str]) -> Found {
    let rows = encoder::rows(code);
    let cell = rows
        .iter()
        .filter(|row| row.side == encoder::EncoderSide::Motor)
        .find(|row| symbols.contains(&row.cell.place.symbol));
    match cell.and_then(|row| Some(row.cell.sourced(row.cell.limit().number()?))) {
        Some(count) => number(id, &Datum::Known(count), |value: f64| value),
        None => Found::NotApplicable,
    }
}

/// Returns I_max, or I_E if it is stated and smaller: a drive must not receive a current that demagnetises the magnets.
fn limit(id: ParameterId, actuator: &Parameters) -> Found {
    let largest = plain(id, &actuator.current_max);
    match plain(id, &actuator.current_demagnetisation) {
        Found::Known(magnets) => joined(largest, Found::Known(magnets), f64::min),
        _ => largest,
    }
}

/// Returns a threshold of the winding temperature.
fn threshold(id: ParameterId, code: &OrderCode, which: &str) -> Found {
    // A drive can supervise only sensors with contacts at a connector.
    if !catalogue::leads_out_kty(code) {
        return Found::NotApplicable;
    }
    let table = catalogue::SeriesData::of(code.series()).thresholds;
    let cell = catalogue::table_cells(table).iter().find(|cell| cell.place.condition == which);
    cell.map_or(Found::NotPrinted, |cell| plain(id, &catalogue::datum_of::<ThermodynamicTemperature>(cell)))
}

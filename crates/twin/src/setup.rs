//! What is simulated, and why something cannot be.

use crate::control::Gains;
use crate::drive::Limits;
use crate::parameters::Parameters;
use crate::scenario::Scenario;
use feedback::{Encoder, Failure};
use mechanism::{Extra, Mechanism};
use motion::Motion;
use provenance::Missing;

/// Parts of the model, each of which can be switched off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "switches")]
pub struct Switches {
    /// Friction of motor, gear and teeth.
    pub friction: bool,
    /// Hysteresis of the gear.
    pub hysteresis: bool,
    /// Kinematic error of the gear.
    pub kinematic_error: bool,
    /// The sample by which the current loop is late.
    pub delay: bool,
    /// Limits of current, voltage and speed, and the supervision.
    pub limits: bool,
    /// Errors of the measured angle and current.
    pub noise: bool,
}

impl Default for Switches {
    /// Everything on.
    fn default() -> Self {
        Self { friction: true, hysteresis: true, kinematic_error: true, delay: true, limits: true, noise: true }
    }
}

impl Switches {
    /// Everything off: the linear drive.
    #[must_use]
    pub const fn none() -> Self {
        Self { friction: false, hysteresis: false, kinematic_error: false, delay: false, limits: false, noise: false }
    }
}

/// Voltages that the supply gives to the DC link by itself \[V\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supply {
    /// Under load at the lowest mains: what the drive works with.
    pub least_v: f64,
    /// Without load at nominal mains.
    pub nominal_v: f64,
    /// Without load at the highest mains: from there on what comes back raises the voltage.
    pub most_v: f64,
}

impl Supply {
    /// A DC link that is stated: one voltage.
    #[must_use]
    pub const fn of(voltage_v: f64) -> Self {
        Self { least_v: voltage_v, nominal_v: voltage_v, most_v: voltage_v }
    }
}

/// What is simulated.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// The actuator and the model.
    pub parameters: &'a Parameters,
    /// What is moved.
    pub mechanism: &'a Mechanism,
    /// How it shall move.
    pub motion: &'a Motion,
    /// What each segment of the motion adds to the load.
    pub extras: &'a [Extra],
    /// What happens.
    pub scenario: Scenario,
    /// Which parts of the model count.
    pub switches: Switches,
    /// The supply of the DC link.
    pub supply: Supply,
    /// Share of U_DC/√2 that the drive can give.
    pub modulation: f64,
    /// Temperature of the air \[K\].
    pub ambient_k: f64,
    /// Temperatures of winding and housing at the start \[K\]; without them those of the air.
    pub start_k: Option<[f64; 2]>,
    /// Gains; without them those of the rule.
    pub gains: Option<Gains>,
    /// What is supervised; without it what follows from the data.
    pub limits: Option<Limits>,
    /// The signals of the feedback on the motor; without them it cannot fail.
    pub encoder: Option<&'a Encoder>,
    /// Whether the position loop is closed over the encoder at the output instead of that of the motor.
    pub loop_at_output: bool,
    /// Within this angle of its last position the axis counts as settled \[rad\].
    pub settled_rad: f64,
    /// Steps of the solver in one period of the current loop.
    pub substeps: u32,
    /// Seed of phases and noise.
    pub seed: u64,
    /// A speed that is stepped to instead of the motion [rad/s].
    pub speed_step: Option<f64>,
}

/// The DC link at which the assumed parts of a drive are rated \[V\]: the mean of a rectifier at 400 V.
pub(crate) const SUPPLY_USUAL_V: f64 = 560.0;

/// Steps of the solver in one period of the current loop, unless stated: 10.4 µs each.
pub const SUBSTEPS_USUAL: u32 = 6;

/// More steps in one period gain nothing and cost time.
pub(crate) const SUBSTEPS_MOST: u32 = 1000;

/// The largest product of step and eigenvalue with which the method of fourth order is accurate.
pub(crate) const STEP_MOST: f64 = 0.7;

impl<'a> Setup<'a> {
    /// A load and its motion on an actuator, everything else as usual.
    #[must_use]
    pub fn of(parameters: &'a Parameters, mechanism: &'a Mechanism, motion: &'a Motion, extras: &'a [Extra]) -> Self {
        Self {
            parameters,
            mechanism,
            motion,
            extras,
            scenario: Scenario::default(),
            switches: Switches::default(),
            supply: Supply::of(SUPPLY_USUAL_V),
            modulation: 1.0,
            ambient_k: 293.15,
            start_k: None,
            gains: None,
            limits: None,
            encoder: None,
            loop_at_output: false,
            settled_rad: std::f64::consts::TAU / 21_600.0,
            substeps: SUBSTEPS_USUAL,
            seed: 0,
            speed_step: None,
        }
    }
}

/// Why something cannot be simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// A datum of the actuator is not known.
    Missing(Missing),
    /// The torque of the load is recorded with its motion: it does not follow from a state.
    RecordedTorque,
    /// A measured value, by its key, that replaces nothing: the load changes with the position, or with the direction of the power.
    NotOfThisLoad(&'static str),
    /// The load has no inertia.
    NoInertia,
    /// The step is too long for the stiffest part.
    StepTooLong {
        /// Steps in one period of the current loop that would do.
        substeps: u32,
    },
    /// The scenario needs a brake, and the actuator has none.
    NoBrake,
    /// The scenario needs a battery in the feedback, and it has none.
    NoBattery,
    /// The feedback fails, and its signals are not known.
    NoEncoder,
    /// The feedback cannot fail so, but in these ways.
    NotOfThisEncoder {
        /// How it shall fail.
        failure: Failure,
        /// How it can.
        possible: [Option<Failure>; Failure::ALL.len()],
    },
    /// The position loop is closed at the output, and no encoder is there.
    NoOutputEncoder,
    /// The scenario takes place after the end of the run.
    AfterTheEnd {
        /// The end \[s\].
        end_s: f64,
    },
    /// The load moves at the instant of a scenario that begins at rest.
    NotAtRest,
    /// The load rests at the instant at which it shall meet a stop.
    AtRest,
    /// Gains with which a loop swings up.
    Unstable,
    /// A value that is not finite or out of its bounds, by its key.
    OutOfRange(&'static str),
}

impl From<Missing> for Fault {
    fn from(missing: Missing) -> Self {
        Self::Missing(missing)
    }
}

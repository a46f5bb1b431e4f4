//! Setup of a simulation, and reasons for which it is impossible.

use crate::control::Gains;
use crate::control_loop::Loop;
use crate::drive::Limits;
use crate::parameters::Parameters;
use crate::scenario::{Part, Scenario};
use feedback::{Encoder, Failure};
use mechanism::{Extra, Mechanism};
use motion::Motion;
use provenance::Missing;

/// Parts of the model that can be switched off individually.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "switches")]
pub struct Switches {
    /// Friction of motor, gear and teeth.
    pub friction: bool,
    /// Hysteresis of the gear.
    pub hysteresis: bool,
    /// Kinematic error of the gear.
    pub kinematic_error: bool,
    /// Delay of the current loop by one sample.
    pub delay: bool,
    /// Limits of current, voltage and speed, and the supervision.
    pub limits: bool,
    /// Errors of the measured angle and current.
    pub noise: bool,
}

impl Default for Switches {
    /// Returns the complete model.
    fn default() -> Self {
        Self { friction: true, hysteresis: true, kinematic_error: true, delay: true, limits: true, noise: true }
    }
}

impl Switches {
    /// Returns the linear drive, with all parts switched off.
    #[must_use]
    pub const fn none() -> Self {
        Self { friction: false, hysteresis: false, kinematic_error: false, delay: false, limits: false, noise: false }
    }
}

/// Voltages of the DC link with supply but without regeneration \[V\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supply {
    /// Voltage under load at the lowest mains, used for the drive.
    pub least_v: f64,
    /// Voltage without load at nominal mains.
    pub nominal_v: f64,
    /// Voltage without load at the highest mains, above which regeneration raises the voltage.
    pub most_v: f64,
}

impl Supply {
    /// Creates a DC link with a single stated voltage.
    #[must_use]
    pub const fn of(voltage_v: f64) -> Self {
        Self { least_v: voltage_v, nominal_v: voltage_v, most_v: voltage_v }
    }
}

/// Setup of a simulation.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// Parameters of actuator and model.
    pub parameters: &'a Parameters,
    /// Mechanism of the load.
    pub mechanism: &'a Mechanism,
    /// Motion of the cycle.
    pub motion: &'a Motion,
    /// Additions of each segment of the motion to the load.
    pub extras: &'a [Extra],
    /// Scenario of the run.
    pub scenario: Scenario,
    /// Part of the motion to run; `None` for all cycles.
    pub part: Option<Part>,
    /// Parts of the model that are switched on.
    pub switches: Switches,
    /// Supply of the DC link.
    pub supply: Supply,
    /// Share of U_DC/√2 available from the drive \[1\].
    pub modulation: f64,
    /// Ambient temperature \[K\].
    pub ambient_k: f64,
    /// Initial temperatures of winding and housing \[K\]; `None` for ambient temperature.
    pub start_k: Option<[f64; 2]>,
    /// Gains of the loops; `None` for the default gains.
    pub gains: Option<Gains>,
    /// Limits of the supervision; `None` for those derived from the data.
    pub limits: Option<Limits>,
    /// Signals of the motor feedback; without them it cannot fail.
    pub encoder: Option<&'a Encoder>,
    /// The position loop is closed by the encoder at the output instead of that of the motor.
    pub loop_at_output: bool,
    /// Distance from the last position within which the axis counts as settled \[rad\].
    pub settled_rad: f64,
    /// Solver steps per period of the current loop.
    pub substeps: u32,
    /// Seed of phases and noise.
    pub seed: u64,
    /// Speed step instead of the motion [rad/s].
    pub speed_step: Option<f64>,
}

/// DC link voltage at which the assumed parts of a drive are rated \[V\]: the mean of a rectifier at 400 V.
pub(crate) const SUPPLY_USUAL_V: f64 = 560.0;

/// Default solver steps per period of the current loop: 10.4 µs each.
pub const SUBSTEPS_USUAL: u32 = 6;

/// Upper limit of the solver steps per period; more gain nothing.
pub(crate) const SUBSTEPS_MOST: u32 = 1000;

/// Largest product of step and eigenvalue at which the fourth-order method is accurate.
pub(crate) const STEP_MOST: f64 = 0.7;

impl<'a> Setup<'a> {
    /// Creates a setup of a load and its motion on an actuator, with default values otherwise.
    #[must_use]
    pub fn of(parameters: &'a Parameters, mechanism: &'a Mechanism, motion: &'a Motion, extras: &'a [Extra]) -> Self {
        Self {
            parameters,
            mechanism,
            motion,
            extras,
            scenario: Scenario::default(),
            part: None,
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

/// Reason for which a simulation is impossible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// A datum of the actuator is unknown.
    Missing(Missing),
    /// The torque of the load is recorded with its motion and does not follow from the state.
    RecordedTorque,
    /// A measured value, by its key, does not apply: the load changes with the position, or with the direction of the
    /// power.
    NotOfThisLoad(&'static str),
    /// The load has no inertia.
    NoInertia,
    /// The step is too long for the stiffest part of the model.
    StepTooLong {
        /// Number of steps per period of the current loop that would suffice.
        substeps: u32,
    },
    /// The scenario needs a brake, but the actuator has none.
    NoBrake,
    /// The scenario needs a battery in the feedback, but there is none.
    NoBattery,
    /// The scenario needs the signals of the feedback, which are unknown.
    NoEncoder,
    /// The feedback cannot have this failure.
    NotOfThisEncoder {
        /// Failure of the scenario.
        failure: Failure,
        /// Failures that the feedback can have.
        possible: [Option<Failure>; Failure::ALL.len()],
    },
    /// The position loop is closed at the output, but there is no encoder.
    NoOutputEncoder,
    /// The event of the scenario is after the end of the run.
    AfterTheEnd {
        /// End of the run \[s\].
        end_s: f64,
    },
    /// The load moves at the instant of an event that happens at rest.
    NotAtRest,
    /// The load is at rest at the instant at which it should hit a stop.
    AtRest,
    /// The gains make a loop unstable.
    Unstable {
        /// The innermost unstable loop.
        of: Loop,
        /// Factor on its gain at the limit of stability, if the loop has one.
        limit: Option<f64>,
    },
    /// A value, by its key, is not finite or out of range.
    OutOfRange(&'static str),
    /// A value is above the one that limits it, both by their keys: one may be stated and the other a default.
    Above {
        /// The value that is too large.
        lower: &'static str,
        /// The value that limits it.
        upper: &'static str,
    },
}

impl From<Missing> for Fault {
    fn from(missing: Missing) -> Self {
        Self::Missing(missing)
    }
}

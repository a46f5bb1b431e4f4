//! Scenarios of a run, and the reactions of the drive.

use feedback::{Failure, Finding};
use quantities::identified;

identified! {
    /// Reaction of a drive that ends a motion.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum Reaction {
        /// Brakes the axis along a ramp, then closes the brake and switches off.
        #[default]
        Ramp = "ramp",
        /// Switches off and closes the brake.
        Brake = "brake",
        /// Switches off and lets the axis coast.
        Coast = "coast",
    }
}

identified! {
    /// A scenario.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
    pub enum ScenarioId {
        /// The cycle of the project without disturbance.
        #[default]
        Cycle = "cycle",
        /// A stop on demand at an instant, with the stated reaction.
        EmergencyStop = "emergency_stop",
        /// Mains and control fail at an instant: pulses off, the brake closes.
        PowerFailure = "power_failure",
        /// The brake does not open.
        BrakeStuck = "brake_stuck",
        /// The drive switches off at rest while the brake closes at the same instant: the load sags.
        HangingLoad = "hanging_load",
        /// The load is clamped at an instant.
        BlockedLoad = "blocked_load",
        /// The feedback fails at an instant.
        EncoderFailure = "encoder_failure",
        /// Battery and supply of the feedback failed before the start: it has lost its turns, while its word is valid.
        BatteryLoss = "battery_loss",
        /// The supply of the DC link drops for a limited time.
        LinkSag = "link_sag",
        /// Operation at the highest permitted ambient temperature.
        HotAmbient = "hot_ambient",
        /// Cold start at the lowest permitted ambient temperature.
        ColdGrease = "cold_grease",
        /// The load hits a stop.
        Collision = "collision",
    }
}

impl ScenarioId {
    /// Returns the scenario with an identifier.
    #[must_use]
    pub fn of(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|each| each.id() == id)
    }

    /// Returns `true` if the scenario is an event at an instant.
    #[must_use]
    pub const fn has_instant(self) -> bool {
        match self {
            Self::Cycle | Self::BrakeStuck | Self::BatteryLoss | Self::HotAmbient | Self::ColdGrease => false,
            Self::HangingLoad
            | Self::EmergencyStop
            | Self::PowerFailure
            | Self::BlockedLoad
            | Self::EncoderFailure
            | Self::LinkSag
            | Self::Collision => true,
        }
    }
}

/// Part of a motion that is run instead of the whole.
///
/// The run begins at the state of the motion at that instant: an axis in motion runs up along it, with the temperatures of
/// the setup. Times of the run count from the beginning of the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Time of the motion at which the run begins \[s\].
    pub from_s: f64,
    /// Duration of the run along the motion \[s\].
    pub for_s: f64,
}

/// A scenario with its parameters.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scenario {
    /// Kind of scenario.
    pub id: ScenarioId,
    /// Instant of the event \[s\]; `None` for the instant of the highest speed, or for the start if the event happens
    /// at rest.
    pub at_s: Option<f64>,
    /// Reaction of the drive to a stop on demand and to its own faults.
    pub reaction: Reaction,
    /// Failure of the feedback; `None` for a cable without signals.
    pub failure: Option<Failure>,
    /// Number of cycles; zero means one.
    pub cycles: u32,
    /// The run begins at ambient temperature instead of the settled state of the repeated cycle.
    pub cold: bool,
}

impl Scenario {
    /// Returns `true` if the run begins in the settled state of the repeated cycle.
    #[must_use]
    pub fn starts_warm(&self) -> bool {
        !self.cold && self.id != ScenarioId::ColdGrease
    }
}

/// Failure of the feedback, and its detection by the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Failed {
    /// Kind of failure; `None` for a loss of the turns with the battery.
    pub failure: Option<Failure>,
    /// Check that detected the failure, and the time from the failure to its detection \[s\]; `None` if undetected.
    pub noticed: Option<(Finding, f64)>,
    /// Error of the angle read by the drive at the output \[rad\], at detection or else at the end.
    pub error_rad: f64,
}

/// An event of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// Time of the event \[s\].
    pub time_s: f64,
    /// Kind of event.
    pub kind: EventKind,
}

identified! {
    /// Kind of event.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum EventKind {
        /// The event of the scenario occurs.
        Scenario = "scenario",
        /// The drive stops along a ramp.
        Ramp = "ramp",
        /// The inverter switches its pulses off.
        PulsesOff = "pulses_off",
        /// The brake is commanded to close.
        BrakeCloses = "brake_closes",
        /// The brake has closed at rest.
        BrakeClosed = "brake_closed",
        /// The brake has closed on a moving axis.
        BrakeClosedMoving = "brake_closed_moving",
        /// The brake has opened.
        BrakeOpen = "brake_open",
        /// The closed brake slips.
        BrakeSlips = "brake_slips",
        /// The axis came to rest after a stop.
        AtRest = "at_rest",
        /// The current reached its limit, or the voltage its largest value.
        Limited = "limited",
        /// The overload supervision I²t responds.
        Overload = "overload",
        /// The winding temperature sensor reached the warning.
        WindingWarning = "winding_warning",
        /// The winding temperature sensor reached the shutdown temperature.
        WindingShutdown = "winding_shutdown",
        /// The PTC of the winding responds.
        PtcResponse = "ptc_response",
        /// The following error exceeds its limit.
        FollowingError = "following_error",
        /// The DC link voltage is below its lower limit.
        LinkLow = "link_low",
        /// The DC link voltage is above its upper limit.
        LinkHigh = "link_high",
        /// The braking resistor was switched on.
        BrakeResistor = "brake_resistor",
        /// The drive detects the failure of the feedback: no valid position.
        NoPosition = "no_position",
        /// The feedback has lost its turns, undetected.
        TurnsLost = "turns_lost",
        /// The current reached the demagnetisation current.
        Demagnetisation = "demagnetisation",
        /// The torque through the gear exceeded the collision torque.
        CollisionTorque = "collision_torque",
        /// The speed exceeds the largest motor speed.
        Overspeed = "overspeed",
        /// The simulation diverged and ends here.
        Diverged = "diverged",
    }
}

//! What happens to the axis: scenarios and the reaction of the drive.

use feedback::{Failure, Finding};
use quantities::identified;

identified! {
    /// How a drive ends a motion.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum Reaction {
        /// Brakes the axis along a ramp, closes the brake and switches off.
        #[default]
        Ramp = "ramp",
        /// Switches off and closes the brake.
        Brake = "brake",
        /// Switches off; the axis runs out.
        Coast = "coast",
    }
}

identified! {
    /// What happens to the axis.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
    pub enum ScenarioId {
        /// The cycle of the project.
        #[default]
        Cycle = "cycle",
        /// A stop on demand at an instant, by the stated reaction.
        EmergencyStop = "emergency_stop",
        /// Mains and control fail at an instant: no pulses, the brake closes.
        PowerFailure = "power_failure",
        /// The brake does not open.
        BrakeStuck = "brake_stuck",
        /// The drive switches off at rest and the brake closes at the same instant: the load sags.
        HangingLoad = "hanging_load",
        /// The load is clamped at an instant.
        BlockedLoad = "blocked_load",
        /// The feedback fails at an instant.
        EncoderFailure = "encoder_failure",
        /// Battery and supply of the feedback have failed before the start: it has lost its turns, and its word is valid.
        BatteryLoss = "battery_loss",
        /// The supply of the DC link drops for a while.
        LinkSag = "link_sag",
        /// The warmest permitted ambient.
        HotAmbient = "hot_ambient",
        /// Everything as cold as the coldest permitted ambient.
        ColdGrease = "cold_grease",
        /// The load meets a stop.
        Collision = "collision",
    }
}

impl ScenarioId {
    /// The scenario of an identifier.
    #[must_use]
    pub fn of(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|each| each.id() == id)
    }
}

/// A scenario with what is stated of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scenario {
    /// What happens.
    pub id: ScenarioId,
    /// When it happens \[s\]; without it when the axis is fastest, at the start for what begins at rest.
    pub at_s: Option<f64>,
    /// How the drive reacts to a stop on demand and to its own faults.
    pub reaction: Reaction,
    /// How the feedback fails; without it no signal arrives.
    pub failure: Option<Failure>,
    /// So many cycles are run; none means one.
    pub cycles: u32,
    /// Whether the drive begins cold, as the ambient air; warm is the settled state of the repeated cycle.
    pub cold: bool,
}

/// How the feedback failed, and what the drive noticed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Failed {
    /// What failed; `None`: the battery, and with it the turns.
    pub failure: Option<Failure>,
    /// What the drive noticed, and how long after the failure \[s\]; `None`: nothing.
    pub noticed: Option<(Finding, f64)>,
    /// The angle that it read less the true one, at the output \[rad\]: when it noticed, else at the end.
    pub error_rad: f64,
}

/// Something that happened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// When \[s\].
    pub time_s: f64,
    /// What.
    pub kind: EventKind,
}

identified! {
    /// What happened.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum EventKind {
        /// The scenario takes place.
        Scenario = "scenario",
        /// The drive stops along a ramp.
        Ramp = "ramp",
        /// The inverter gives no pulses any more.
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
        /// The current reached its limit or the voltage its largest value.
        Limited = "limited",
        /// Overload supervision I²t.
        Overload = "overload",
        /// The sensor of the winding reached its warning.
        WindingWarning = "winding_warning",
        /// The sensor of the winding reached its shutdown.
        WindingShutdown = "winding_shutdown",
        /// The PTC of the winding responds.
        PtcResponse = "ptc_response",
        /// The position lags behind its set-point by more than is permitted.
        FollowingError = "following_error",
        /// The DC link is below its least voltage.
        LinkLow = "link_low",
        /// The DC link is above its largest voltage.
        LinkHigh = "link_high",
        /// The brake resistor was switched on.
        BrakeResistor = "brake_resistor",
        /// The drive notices that the feedback has failed: no valid position.
        NoPosition = "no_position",
        /// The feedback has lost its turns, which nothing shows.
        TurnsLost = "turns_lost",
        /// The current reached that of demagnetisation.
        Demagnetisation = "demagnetisation",
        /// The gear passed more than the collision torque.
        CollisionTorque = "collision_torque",
        /// The speed exceeds the largest of the motor.
        Overspeed = "overspeed",
        /// A value left every bound: the run ends here.
        Diverged = "diverged",
    }
}

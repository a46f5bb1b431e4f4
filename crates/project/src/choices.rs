//! Choices of the file: each value with its word. `axis` gives them their meaning in the engine.

use crate::value::{WordChoice, choice, choices_by_id};
use quantities::identified;

identified! {
    /// Law of a move.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Law {
        /// Constant acceleration, constant speed, constant deceleration.
        Trapezoid = "trapezoid",
        /// Constant acceleration, constant deceleration; quadratic parabola in VDI 2143.
        Triangle = "triangle",
        /// Seven phases of constant jerk.
        Jerk = "jerk",
        /// Polynomial of the fifth degree.
        Polynomial5 = "polynomial_5",
        /// Modified sine.
        ModifiedSine = "modified_sine",
        /// Modified acceleration trapezoid.
        ModifiedTrapezoid = "modified_trapezoid",
        /// Simple sine.
        SimpleSine = "simple_sine",
        /// Inclined sine.
        InclinedSine = "inclined_sine",
        /// Constant speed.
        Constant = "constant",
    }

    /// Holding of the load in a dwell.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Hold {
        /// The motor holds the load.
        Motor = "motor",
        /// The closed brake holds the load.
        Brake = "brake",
        /// The load stays in place by itself.
        Free = "free",
    }

    /// Spline through the points of a cam table.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Spline {
        /// Third degree.
        Cubic = "cubic",
        /// Fifth degree.
        Quintic = "quintic",
    }

    /// Orientation of a body.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Orientation {
        /// Parallel to the axis of rotation.
        Parallel = "parallel",
        /// Perpendicular to the axis of rotation.
        Perpendicular = "perpendicular",
    }

    /// Kind of a stage.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum StageKind {
        /// Two pulleys and a belt.
        Belt = "belt",
        /// A gear pair.
        Gear = "gear",
        /// A coupling.
        Coupling = "coupling",
    }

    /// Distribution of the mass of an arm along its length.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum ArmShape {
        /// Slender, with the mass evenly distributed.
        Rod = "rod",
        /// Rectangular, with the mass evenly distributed over length and width.
        Bar = "bar",
        /// Slender, tapering to a point.
        Taper = "taper",
        /// The whole mass at the end.
        Point = "point",
    }

    /// Design of the output bearing of an actuator.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum BearingDesign {
        /// Crossed roller bearing.
        CrossedRoller = "crossed_roller",
        /// Four-point contact ball bearing.
        FourPoint = "four_point",
    }

    /// Direction in which a winder moves its web.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum WebWinding {
        /// Wound onto the roll.
        Up = "up",
        /// Wound off the roll.
        Off = "off",
    }

    /// Operating condition of the output bearing.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum OperatingCondition {
        /// Normal operation.
        Normal = "normal",
        /// Vibration or shock.
        Shock = "shock",
        /// High transmission accuracy.
        HighAccuracy = "high_accuracy",
    }

    /// Data that a project leaves out knowingly: what depends on them is not checked.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum LeftOut {
        /// Voltage of the DC link.
        Supply = "supply",
        /// Loads on the output flange.
        FlangeLoads = "flange_loads",
        /// Conditions of use.
        Conditions = "conditions",
        /// Field of application.
        Application = "application",
    }

    /// Phases that feed a rectifier.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum MainsPhases {
        /// One phase.
        Single = "single",
        /// Three phases.
        Three = "three",
    }

    /// Position in which an actuator is mounted.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum MountingPosition {
        /// The axis of rotation is horizontal.
        Horizontal = "horizontal",
        /// The output flange is on top.
        FlangeUp = "flange_up",
        /// The output flange is at the bottom.
        FlangeDown = "flange_down",
        /// The position changes in operation.
        Changing = "changing",
    }

    /// Field of application that needs the approval of the manufacturer.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum SpecialApplication {
        /// Aviation and space flight.
        Aerospace = "aerospace",
        /// Explosive atmospheres.
        ExplosiveAtmosphere = "explosive_atmosphere",
        /// Nuclear plants.
        Nuclear = "nuclear",
        /// Vacuum.
        Vacuum = "vacuum",
        /// Household.
        Household = "household",
        /// Medicine.
        Medical = "medical",
        /// Contact with the human body.
        HumanContact = "human_contact",
        /// Lifting of persons.
        LiftingOfPersons = "lifting_of_persons",
        /// Amusement.
        Amusement = "amusement",
    }

    /// Reaction of a drive that ends a motion.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Reaction {
        /// A ramp, then the brake.
        Ramp = "ramp",
        /// Switches off and closes the brake.
        Brake = "brake",
        /// Switches off.
        Coast = "coast",
    }

    /// Failure of an encoder.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Failure {
        /// The second track or the sine winding.
        Track = "track",
        /// Weak tracks or windings.
        Amplitude = "amplitude",
        /// No signal.
        Cable = "cable",
        /// A wrong bit in each word.
        Check = "check",
        /// An error that the encoder reports.
        ErrorBit = "error_bit",
        /// The data line of the word.
        DataLine = "data_line",
    }

    /// Scenario of a simulation.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum ScenarioId {
        /// The cycle without disturbance.
        Cycle = "cycle",
        /// A stop on demand.
        EmergencyStop = "emergency_stop",
        /// Mains and control fail.
        PowerFailure = "power_failure",
        /// The brake does not open.
        BrakeStuck = "brake_stuck",
        /// The load sags while the brake closes.
        HangingLoad = "hanging_load",
        /// The load is clamped.
        BlockedLoad = "blocked_load",
        /// The feedback fails.
        EncoderFailure = "encoder_failure",
        /// The feedback has lost its turns.
        BatteryLoss = "battery_loss",
        /// The supply of the DC link drops.
        LinkSag = "link_sag",
        /// Highest permitted ambient temperature.
        HotAmbient = "hot_ambient",
        /// Lowest permitted ambient temperature.
        ColdGrease = "cold_grease",
        /// The load hits a stop.
        Collision = "collision",
    }

    /// Direction of rotation, seen from the front.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Turn {
        /// Clockwise.
        Clockwise = "cw",
        /// Counterclockwise.
        CounterClockwise = "ccw",
    }

    /// Direction in which a position counts.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Counting {
        /// Upwards.
        Rising = "rising",
        /// Downwards.
        Falling = "falling",
    }
}

choices_by_id! {
    Hold, Spline, Orientation, StageKind, ArmShape, BearingDesign, WebWinding, OperatingCondition, LeftOut, MainsPhases, MountingPosition, SpecialApplication, Reaction, Failure, ScenarioId, Turn, Counting
}

/// Degree of protection of a rotating machine by EN 60034-5, or one of immersion and of jets at high pressure by EN 60529.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProtectionDegree(&'static str);

impl ProtectionDegree {
    /// Returns its letters and numerals: `IP65`.
    #[must_use]
    pub const fn code(self) -> &'static str {
        self.0
    }
}

impl WordChoice for ProtectionDegree {
    const WORDS: &'static [&'static str] = &[
        "IP00", "IP10", "IP12", "IP13", "IP20", "IP21", "IP22", "IP23", "IP43", "IP44", "IP54", "IP55", "IP56", "IP64",
        "IP65", "IP66", "IP67", "IP68", "IP69",
    ];

    fn of_word(word: &str) -> Option<Self> {
        Self::WORDS.iter().find(|known| **known == word).map(|known| Self(known))
    }
}

choice!(ProtectionDegree);

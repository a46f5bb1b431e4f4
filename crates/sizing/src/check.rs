//! The answer of one check.

use crate::notes::Notes;
use derivation::Step;
use provenance::{Grade, Source};
use quantities::{Time, Unit};

/// How a value must lie to its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Value ≤ limit; the utilisation is value by limit.
    AtMost,
    /// Value ≥ limit; the utilisation is limit by value.
    AtLeast,
}

impl Direction {
    /// The identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::AtMost => "at_most",
            Self::AtLeast => "at_least",
        }
    }

    /// The sign between a value and its limit that is true: ≤, >, ≥ or <.
    #[must_use]
    pub fn relation(self, passes: bool, value: f64, limit: f64) -> &'static str {
        // What passes keeps its limit, also where it is at it but for rounding.
        match self {
            Self::AtMost if passes || value.abs() <= limit.abs() => "≤",
            Self::AtMost => ">",
            Self::AtLeast if passes || value >= limit => "≥",
            Self::AtLeast => "<",
        }
    }
}

/// What the utilisation of a check says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Margin {
    /// A share of the limit: what is left is a margin that the ranking looks at.
    Share,
    /// That of a recommendation, which the ranking leaves out.
    Recommendation,
    /// Of a class that is met or not, such as a voltage: there is nothing between.
    Class,
}

/// The part of the actuator that a check is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Part {
    Drive,
    Thermal,
    Energy,
    Gear,
    OutputBearing,
    Brake,
    Feedback,
    Screws,
}

impl Part {
    /// Every part, in the order of a report.
    pub const ALL: &[Self] = &[
        Self::Drive,
        Self::Thermal,
        Self::Energy,
        Self::Gear,
        Self::OutputBearing,
        Self::Brake,
        Self::Feedback,
        Self::Screws,
    ];

    /// The identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Drive => "drive",
            Self::Thermal => "thermal",
            Self::Energy => "energy",
            Self::Gear => "gear",
            Self::OutputBearing => "output_bearing",
            Self::Brake => "brake",
            Self::Feedback => "feedback",
            Self::Screws => "screws",
        }
    }
}

/// What can mend a check that fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mended {
    /// A smaller load or another pace of the motion may.
    LoadOrPace,
    /// Another pace alone.
    Pace,
    /// Neither of them.
    Neither,
}

/// What there is to say of a check before it is answered.
struct Entry {
    id: &'static str,
    part: Part,
    direction: Direction,
    margin: Margin,
    mended: Mended,
}

/// The list of checks: everything that is the same for each answer of a check stands here and nowhere else.
macro_rules! checks {
    ($($(#[$about:meta])* $name:ident: $id:literal, $part:ident, $direction:ident, $margin:ident, $mended:ident;)*) => {
        /// Identifier of a check, part of the contract with scripts.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum CheckId {
            $($(#[$about])* $name,)*
        }

        impl CheckId {
            /// Every check.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            const fn entry(self) -> Entry {
                match self {
                    $(Self::$name => Entry {
                        id: $id,
                        part: Part::$part,
                        direction: Direction::$direction,
                        margin: Margin::$margin,
                        mended: Mended::$mended,
                    },)*
                }
            }
        }
    };
}

checks! {
    /// Peak torque against T_max.
    PeakTorque: "peak_torque", Drive, AtMost, Share, LoadOrPace;
    /// Peak speed against n_mot,max/i.
    PeakSpeed: "peak_speed", Drive, AtMost, Share, Pace;
    /// Mean speed against n_N/i.
    MeanSpeed: "mean_speed", Drive, AtMost, Share, Pace;
    /// Effective torque against the continuous torque at the mean speed.
    ContinuousTorque: "continuous_torque", Thermal, AtMost, Share, LoadOrPace;
    /// Peak motor current against I_max.
    PeakCurrent: "peak_current", Drive, AtMost, Share, LoadOrPace;
    /// Peak motor current against I_E.
    Demagnetisation: "demagnetisation", Drive, AtMost, Share, LoadOrPace;
    /// Terminal voltage of the motor against what the DC link gives.
    Voltage: "voltage", Energy, AtMost, Share, LoadOrPace;
    /// Load inertia against three times the own inertia.
    InertiaRatio: "inertia_ratio", Drive, AtMost, Recommendation, LoadOrPace;
    /// Cubic mean torque against T_A.
    GearMeanTorque: "gear_mean_torque", Gear, AtMost, Share, LoadOrPace;
    /// Life of the wave-generator bearing against the life required.
    GearLife: "gear_life", Gear, AtLeast, Share, LoadOrPace;
    /// Torsion of the gear under the largest torque against the torsion permitted.
    Torsion: "torsion", Gear, AtMost, Share, LoadOrPace;
    /// First natural frequency against the least asked for.
    NaturalFrequency: "natural_frequency", Gear, AtLeast, Share, LoadOrPace;
    /// Axial force on the flange against the permissible one.
    BearingAxial: "bearing_axial", OutputBearing, AtMost, Share, LoadOrPace;
    /// Radial force on the flange against the permissible one.
    BearingRadial: "bearing_radial", OutputBearing, AtMost, Share, LoadOrPace;
    /// Tilting moment against the permissible one.
    BearingTiltingMoment: "bearing_tilting_moment", OutputBearing, AtMost, Share, LoadOrPace;
    /// Life of the output bearing against the life required.
    BearingLife: "bearing_life", OutputBearing, AtLeast, Share, LoadOrPace;
    /// Static safety of the output bearing against that of the operating condition.
    BearingStatic: "bearing_static", OutputBearing, AtLeast, Share, LoadOrPace;
    /// Tilt of the flange against the tilt permitted.
    TiltAngle: "tilt_angle", OutputBearing, AtMost, Share, LoadOrPace;
    /// Ambient temperature against the operating range.
    Ambient: "ambient", Thermal, AtMost, Share, Neither;
    /// Every instant of the cycle against the short-time torque at its speed.
    TorqueSpeedTrace: "torque_speed_trace", Drive, AtMost, Share, LoadOrPace;
    /// Temperature of the winding in the steady cycle against its warning threshold.
    Thermal: "thermal", Thermal, AtMost, Share, LoadOrPace;
    /// Filtered square of the current against that of I_0.
    OverloadI2t: "overload_i2t", Thermal, AtMost, Share, LoadOrPace;
    /// Mean input speed of the gear against its limit.
    GearMeanInputSpeed: "gear_mean_input_speed", Gear, AtMost, Share, Pace;
    /// Torque of a collision against T_M.
    CollisionTorque: "collision_torque", Gear, AtMost, Share, LoadOrPace;
    /// Distance of the speeds that the cycle holds from those at which the wave generator excites the load.
    ResonanceSpeed: "resonance_speed", Gear, AtLeast, Recommendation, LoadOrPace;
    /// Sum of all angular errors against what is permitted.
    ErrorBudget: "error_budget", Feedback, AtMost, Share, LoadOrPace;
    /// Torque that holds the load against the holding torque of the brake.
    BrakeHolding: "brake_holding", Brake, AtMost, Share, LoadOrPace;
    /// Stop by the brake alone: its angle and number.
    BrakeEmergency: "brake_emergency", Brake, AtMost, Share, LoadOrPace;
    /// DC link voltage against U_DCmax.
    DcLink: "dc_link", Energy, AtMost, Class, Neither;
    /// Mean regenerated power against what supply or resistor take.
    Regeneration: "regeneration", Energy, AtMost, Share, LoadOrPace;
    /// Travel against the absolute range of the feedback.
    FeedbackRange: "feedback_range", Feedback, AtMost, Share, LoadOrPace;
    /// Step of the position at the output against what is asked.
    FeedbackResolution: "feedback_resolution", Feedback, AtMost, Share, Neither;
    /// Life of the encoder's battery against what is asked.
    Battery: "battery", Feedback, AtLeast, Share, Neither;
    /// Peak torque against what the screws of the load transmit.
    ScrewJointLoad: "screw_joint_load", Screws, AtMost, Share, LoadOrPace;
    /// Peak torque against what the screws of the housing transmit.
    ScrewJointHousing: "screw_joint_housing", Screws, AtMost, Share, LoadOrPace;
    /// Field of application against those that need approval.
    Application: "application", Drive, AtMost, Share, LoadOrPace;
}

impl CheckId {
    /// The identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        self.entry().id
    }

    /// The part of the actuator that it is about.
    #[must_use]
    pub const fn part(self) -> Part {
        self.entry().part
    }

    /// How its value must lie to its limit; that of the ambient temperature has two, see [`Check::direction`].
    #[must_use]
    pub const fn direction(self) -> Direction {
        self.entry().direction
    }

    /// What its utilisation says.
    #[must_use]
    pub const fn margin(self) -> Margin {
        self.entry().margin
    }

    /// Whether its utilisation tells a margin that the ranking looks at.
    #[must_use]
    pub const fn has_margin(self) -> bool {
        matches!(self.margin(), Margin::Share)
    }

    /// Whether it can do no more than advise: what it compares with is a recommendation.
    #[must_use]
    pub const fn is_recommendation(self) -> bool {
        matches!(self.margin(), Margin::Recommendation)
    }

    /// Whether its answer hangs neither on the load nor on the pace of the motion.
    #[must_use]
    pub const fn is_of_the_place(self) -> bool {
        matches!(self.entry().mended, Mended::Neither)
    }

    /// Whether its answer hangs on the pace of the motion alone.
    #[must_use]
    pub(crate) const fn is_of_the_pace(self) -> bool {
        matches!(self.entry().mended, Mended::Pace)
    }
}

/// The answer of a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Inside the limit.
    Pass,
    /// Outside the limit.
    Fail,
    /// Inside every limit, but a recommendation is broken.
    Advice,
    /// A datum is missing; see [`Check::missing`].
    NotChecked,
}

impl Verdict {
    /// The identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fail => "fail",
            Self::Advice => "advice",
            Self::NotChecked => "not_checked",
        }
    }
}

/// A number with the unit that people read it in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Value in SI.
    pub si: f64,
    /// Unit to show it in.
    pub unit: &'static Unit,
}

impl Figure {
    /// The value in its unit.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.unit.from_si(self.si)
    }
}

/// The answer of one check, with everything needed to question it.
#[derive(Clone, Debug)]
pub struct Check {
    /// Which check.
    pub id: CheckId,
    /// Its answer.
    pub verdict: Verdict,
    /// What the axis asks.
    pub value: Option<Figure>,
    /// What the actuator gives.
    pub limit: Option<Figure>,
    /// |value| / |limit|; for a recommendation the same ratio.
    pub utilisation: Option<f64>,
    /// Instant of the worst case within the cycle.
    pub at: Option<Time>,
    /// The worst grade among the inputs.
    pub grade: Option<Grade>,
    /// Where the value comes from.
    pub value_source: Option<Source>,
    /// Where the limit comes from.
    pub limit_source: Option<Source>,
    /// Symbol of the datum that is missing.
    pub missing: Option<&'static str>,
    /// Remarks.
    pub notes: Notes,
    /// How value and limit came about; empty unless it was asked for.
    pub workings: Box<[Step]>,
}

impl Check {
    /// How the value must lie to the limit. A range has two limits, of which the nearer one is told.
    #[must_use]
    pub fn direction(&self) -> Direction {
        match (self.id, self.value, self.limit) {
            (CheckId::Ambient, Some(value), Some(limit)) if self.verdict == Verdict::Fail && value.si < limit.si => {
                Direction::AtLeast
            }
            _ => self.id.direction(),
        }
    }

    /// The sign between value and limit that is true: ≤, >, ≥ or <; none where one of them is missing.
    #[must_use]
    pub fn relation(&self) -> Option<&'static str> {
        Some(self.direction().relation(self.verdict == Verdict::Pass, self.value?.si, self.limit?.si))
    }
}

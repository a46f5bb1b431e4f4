//! The answer of one check.

use derivation::Step;
use provenance::{Grade, Source};
use quantities::{
    Angle, AngularVelocity, ElectricPotential, Energy, Frequency, Length, Power, ThermodynamicTemperature, Time,
    Torque, Unit,
};
use std::borrow::Cow;

/// Identifier of a check, part of the contract with scripts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum CheckId {
    /// Peak torque against T_max.
    PeakTorque,
    /// Peak speed against n_mot,max/i.
    PeakSpeed,
    /// Mean speed against n_N/i.
    MeanSpeed,
    /// Effective torque against the continuous torque at the mean speed.
    ContinuousTorque,
    /// Peak motor current against I_max.
    PeakCurrent,
    /// Peak motor current against I_E.
    Demagnetisation,
    /// Terminal voltage of the motor against what the DC link gives.
    Voltage,
    /// Load inertia against three times the own inertia.
    InertiaRatio,
    /// Cubic mean torque against T_A.
    GearMeanTorque,
    /// Life of the wave-generator bearing against the life required.
    GearLife,
    /// Torsion of the gear under the largest torque against the torsion permitted.
    Torsion,
    /// First natural frequency against the least asked for.
    NaturalFrequency,
    /// Axial force on the flange against the permissible one.
    BearingAxial,
    /// Radial force on the flange against the permissible one.
    BearingRadial,
    /// Tilting moment against the permissible one.
    BearingTiltingMoment,
    /// Life of the output bearing against the life required.
    BearingLife,
    /// Static safety of the output bearing against that of the operating condition.
    BearingStatic,
    /// Tilt of the flange against the tilt permitted.
    TiltAngle,
    /// Ambient temperature against the operating range.
    Ambient,
    /// Every instant of the cycle against the short-time torque at its speed.
    TorqueSpeedTrace,
    /// Temperature of the winding in the steady cycle against its warning threshold.
    Thermal,
    /// Filtered square of the current against that of I_0.
    OverloadI2t,
    /// Mean input speed of the gear against its limit.
    GearMeanInputSpeed,
    /// Torque of a collision against T_M.
    CollisionTorque,
    /// Distance of the speeds that the cycle holds from those at which the wave generator excites the load.
    ResonanceSpeed,
    /// Sum of all angular errors against what is permitted.
    ErrorBudget,
    /// Torque that holds the load against the holding torque of the brake.
    BrakeHolding,
    /// Stop by the brake alone: its angle and number.
    BrakeEmergency,
    /// DC link voltage against U_DCmax.
    DcLink,
    /// Mean regenerated power against what supply or resistor take.
    Regeneration,
    /// Travel against the absolute range of the feedback.
    FeedbackRange,
    /// Step of the position at the output against what is asked.
    FeedbackResolution,
    /// Life of the encoder's battery against what is asked.
    Battery,
    /// Peak torque against what the screws of the load transmit.
    ScrewJointLoad,
    /// Peak torque against what the screws of the housing transmit.
    ScrewJointHousing,
    /// Field of application against those that need approval.
    Application,
}

impl CheckId {
    /// Every check.
    pub const ALL: [Self; 36] = [
        Self::PeakTorque,
        Self::PeakSpeed,
        Self::MeanSpeed,
        Self::ContinuousTorque,
        Self::PeakCurrent,
        Self::Demagnetisation,
        Self::Voltage,
        Self::InertiaRatio,
        Self::GearMeanTorque,
        Self::GearLife,
        Self::Torsion,
        Self::NaturalFrequency,
        Self::BearingAxial,
        Self::BearingRadial,
        Self::BearingTiltingMoment,
        Self::BearingLife,
        Self::BearingStatic,
        Self::TiltAngle,
        Self::Ambient,
        Self::TorqueSpeedTrace,
        Self::Thermal,
        Self::OverloadI2t,
        Self::GearMeanInputSpeed,
        Self::CollisionTorque,
        Self::ResonanceSpeed,
        Self::ErrorBudget,
        Self::BrakeHolding,
        Self::BrakeEmergency,
        Self::DcLink,
        Self::Regeneration,
        Self::FeedbackRange,
        Self::FeedbackResolution,
        Self::Battery,
        Self::ScrewJointLoad,
        Self::ScrewJointHousing,
        Self::Application,
    ];
    /// Whether its utilisation tells a margin that the ranking looks at: not that of a recommendation, nor that of a
    /// voltage class, which is met or not.
    #[must_use]
    pub const fn has_margin(self) -> bool {
        !matches!(self, Self::InertiaRatio | Self::ResonanceSpeed | Self::DcLink)
    }

    /// Whether its answer hangs neither on the load nor on the pace of the motion.
    pub(crate) const fn is_of_the_place(self) -> bool {
        matches!(self, Self::DcLink | Self::Ambient | Self::FeedbackResolution | Self::Battery)
    }

    /// The identifier used in data exchange.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::PeakTorque => "peak_torque",
            Self::PeakSpeed => "peak_speed",
            Self::MeanSpeed => "mean_speed",
            Self::ContinuousTorque => "continuous_torque",
            Self::PeakCurrent => "peak_current",
            Self::Demagnetisation => "demagnetisation",
            Self::Voltage => "voltage",
            Self::InertiaRatio => "inertia_ratio",
            Self::GearMeanTorque => "gear_mean_torque",
            Self::GearLife => "gear_life",
            Self::Torsion => "torsion",
            Self::NaturalFrequency => "natural_frequency",
            Self::BearingAxial => "bearing_axial",
            Self::BearingRadial => "bearing_radial",
            Self::BearingTiltingMoment => "bearing_tilting_moment",
            Self::BearingLife => "bearing_life",
            Self::BearingStatic => "bearing_static",
            Self::TiltAngle => "tilt_angle",
            Self::Ambient => "ambient",
            Self::TorqueSpeedTrace => "torque_speed_trace",
            Self::Thermal => "thermal",
            Self::OverloadI2t => "overload_i2t",
            Self::GearMeanInputSpeed => "gear_mean_input_speed",
            Self::CollisionTorque => "collision_torque",
            Self::ResonanceSpeed => "resonance_speed",
            Self::ErrorBudget => "error_budget",
            Self::BrakeHolding => "brake_holding",
            Self::BrakeEmergency => "brake_emergency",
            Self::DcLink => "dc_link",
            Self::Regeneration => "regeneration",
            Self::FeedbackRange => "feedback_range",
            Self::FeedbackResolution => "feedback_resolution",
            Self::Battery => "battery",
            Self::ScrewJointLoad => "screw_joint_load",
            Self::ScrewJointHousing => "screw_joint_housing",
            Self::Application => "application",
        }
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

/// What a reader must know about a check beyond its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// Friction counts with the gear as cold as the air and with the gear as warm as the cycle makes it, if that is known;
    /// the larger current decides.
    FrictionTemperatures {
        /// Of the air.
        cold: ThermodynamicTemperature,
        /// Of the housing in the settled cycle.
        settled: Option<ThermodynamicTemperature>,
    },
    /// Below 20 °C friction is extrapolated; it may be so many times smaller or larger.
    FrictionExtrapolated {
        /// Smallest factor.
        low: f64,
        /// Largest factor.
        high: f64,
    },
    /// Only the cold gear asks for more than the limit.
    UntilWarm,
    /// The limit is the lower edge of an estimate; the upper edge is this figure.
    EstimatedUpTo(Figure),
    /// The value lies between the edges of an estimate.
    InsideBand,
    /// The utilisation is that of the rise above this temperature.
    RiseAbove(ThermodynamicTemperature),
    /// The cycle is not short against the winding's time constant; the effective value alone is not safe.
    CycleNotShort {
        /// Duration of the cycle.
        cycle: Time,
    },
    /// Eq. 69.2 takes the braking torque from the accelerating time; the exact integral decides.
    BrakingTorqueAssumed,
    /// The recommendation holds for highly dynamic duty.
    RecommendationForHighDynamics,
    /// The axis swings by less than 5°: the bearing may fret for want of lubrication.
    SwingTooSmall {
        /// Swing of the axis.
        swing: Angle,
    },
    /// Swings below 5° among larger ones: the bearing may fret for want of lubrication.
    SmallSwings {
        /// How many happen in one cycle.
        count: usize,
        /// The largest of them.
        largest: Angle,
        /// Their share of the angle travelled.
        share: f64,
    },
    /// The gear's rating is that of an interchangeable gear of another maker with the same T_R.
    RatingOfInterchangeableGear,
    /// The permissible loads hold one at a time; together the life and the static safety decide.
    LoadsOneAtATime,
    /// The winding's temperature is an estimate; from cold it reaches its warning threshold after this time, if ever.
    WarmUp(Option<Time>),
    /// The largest temperature of the housing in the steady cycle.
    Housing(ThermodynamicTemperature),
    /// The load hangs: a built-in holding brake is no safety brake.
    HangingLoad,
    /// While the brake closes the load sags by this angle.
    Sag(Angle),
    /// A stop by the brake alone from the peak speed.
    BrakeStop {
        /// Angle until rest.
        angle: Angle,
        /// Time until rest.
        time: Time,
        /// Heat in the brake.
        energy: Energy,
        /// How many such stops are permitted, if printed.
        permitted: Option<f64>,
    },
    /// The load drives harder than the brake holds.
    BrakeDoesNotStop,
    /// In a dwell nothing holds the load but its friction.
    NothingHolds,
    /// The load hangs and the actuator has no brake: without power nothing holds it.
    NothingHoldsWithoutPower,
    /// Some dwells held by the brake are shorter than it takes to close and to open: the motor holds all of them.
    DwellTooShortForBrake {
        /// The shortest of them.
        shortest: Time,
        /// t_c + t_o
        needed: Time,
    },
    /// t_c and t_o of this brake are not printed: those printed for the larger sizes were taken.
    BrakeTimesAssumed,
    /// How long the permitted applications of the brake at standstill last.
    BrakingsLast {
        /// Applications in one cycle.
        each_cycle: f64,
        /// Operation until the permitted number is reached, if that is printed.
        lasts: Option<Time>,
    },
    /// While energy comes back the DC link may rise above U_DCmax, for a short time only.
    DcLinkRises {
        /// Supply and rise together.
        to: ElectricPotential,
        /// The rise that stays below U_DCmax.
        free: ElectricPotential,
    },
    /// Torques at which a cup-type gear of the same size ratchets and buckles, for orientation.
    Ratcheting {
        /// At this torque the teeth jump.
        ratcheting: Torque,
        /// At this torque the flexspline buckles, if published.
        buckling: Option<Torque>,
    },
    /// The motion asks for a brake that the actuator does not have.
    NoBrake,
    /// Electrical energy of one cycle at the motor terminals.
    EnergyPerCycle {
        /// Taken in.
        motoring: Energy,
        /// Given back.
        regenerated: Energy,
        /// Largest power given back.
        peak: Power,
    },
    /// How many collisions of the stated duration the gear bears at the peak speed.
    CollisionsPermitted(f64),
    /// What a capacitor bank must have to take back what one cycle returns at a stretch.
    Capacitor {
        /// Energy at a stretch.
        energy: Energy,
        /// Capacitance for the rise of the DC link voltage.
        capacitance_f: f64,
    },
    /// An axis that turns on and on loses its absolute reference where the count overflows.
    ReferenceLost {
        /// Turns of the motor that the encoder tells apart.
        turns: f64,
    },
    /// The position is not absolute: it must be searched after each switching on.
    NeedsReferencing,
    /// The encoder with its battery should be exchanged after the first, must be after the second time.
    BatteryExchange {
        /// Recommended.
        recommended: Time,
        /// At the latest.
        latest: Time,
    },
    /// The field of application needs a risk assessment and the maker's approval (section 2.4).
    ApprovalNeeded,
    /// Output speeds at which the wave generator excites the load in the three regions of stiffness: each from that of
    /// the largest to that of the least inertia of the cycle.
    ResonanceSpeeds {
        /// The load swings alone.
        blocked: [(AngularVelocity, AngularVelocity); 3],
        /// The rotor swings against it, if its inertia is known.
        free: Option<[(AngularVelocity, AngularVelocity); 3]>,
    },
    /// First natural frequency of load and free rotor against each other.
    FreeRotor(Frequency),
    /// The budget by root of squares, and at the lever arm if there is one.
    Budget {
        /// Root of the sum of squares.
        root_sum_square: Angle,
        /// Worst case at the lever arm.
        deviation: Option<Length>,
        /// How many contributions are not known.
        missing: usize,
    },
    /// The limit is the safe side of an open contradiction in the print: the erratum.
    Erratum(&'static str),
}

/// Remarks of a check. Most are the same for every candidate, and shared.
pub type Notes = Cow<'static, [Note]>;

impl Note {
    /// Whether the remark cites an erratum.
    #[must_use]
    pub const fn is_erratum(&self) -> bool {
        matches!(self, Self::Erratum(_))
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
    pub workings: Vec<Step>,
}

//! Defaults that the user did not confirm.

use motion::{
    Alternating, MadeUp, OutlyingColumn, OutlyingValues, Remark, RestNoise, SlowMotion, SparseSamples, Spline,
    Spurious, SteppedColumn,
};
use project::KeyDefault;
use project::choices::LeftOut;
use project::sections::StatedField;

/// A default that the user did not confirm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Assumption {
    /// Default of a key that is not stated.
    Default(KeyDefault),
    /// Not all conditions of use are stated: those that are missing are within the manufacturer's.
    ConditionsWithinRange,
    /// The plate of table 13.3 cools the actuator.
    CoolingPlate,
    /// The DC link is that of a three-phase rectifier without control.
    Rectifier,
    /// The DC link is that of an uncontrolled three-phase rectifier, and the mains voltage varies by 10 %.
    RectifierAndDeviation,
    /// The DC link is that of a single-phase rectifier without control.
    SinglePhaseRectifier,
    /// The DC link is that of an uncontrolled single-phase rectifier, and the mains voltage varies by 10 %.
    SinglePhaseRectifierAndDeviation,
    /// I_0 of the user's actuator is taken to include the no-load starting current.
    OwnStallCurrentIncludesFriction,
    /// T_0 of the user's actuator is above its T_max: a limit of the motor alone.
    OwnStallTorqueAboveLargest,
    /// I_0 of the user's actuator is above its I_max: a limit of the motor alone.
    OwnStallCurrentAboveLargest,
    /// n_N of the user's actuator is above its n_mot,max: a limit of the motor alone.
    OwnRatedSpeedAboveLargest,
    /// Figure of the template with which the project began, not stated since.
    OfTemplate(TemplateFigure),
    /// No loads on the flange are given: the output bearing is not judged.
    NoFlangeLoads,
    /// The loads on the flange are constant over the cycle.
    FlangeLoadsConstant,
    /// The moments of radial and axial force point in the same direction.
    FlangeMomentsAligned,
    /// The loads on the flange follow from the mechanism.
    FlangeLoadsOfMechanism,
    /// Stated loads add to them at their worst.
    FlangeLoadsAddUp,
    /// The loads of the mechanism on the flange are ignored, as stated in the file.
    FlangeLoadsIgnored,
    /// Loads on the flange of a segment replace those of the mechanism there, as stated in the file.
    FlangeLoadsReplaced,
    /// The bodies on the flange have no products of inertia.
    FlangeBodiesFlat,
    /// No tilt of the axis is given: the flange looks upwards.
    FlangeUpwards,
    /// A payload given by its inertia loads the flange with no weight.
    PayloadInertiaWeightless,
    /// With a stage the mechanism does not load the flange.
    MechanismOnOwnBearings,
    /// The ratio of the stage in use, of several that are stated: that of the best actuator of the catalogue.
    StageRatioChosen(f64),
    /// The law of a move is not decided.
    LawOpen,
    /// Neither duration nor distance of a constant speed is stated: one revolution.
    OneRevolution,
    /// A ramp of the web is not stated.
    WebRamps,
    /// A trapezoid given by two quantities accelerates, runs and brakes for a third of the time each.
    TrapezoidThirds,
    /// A single move is judged as if it were repeated without a pause.
    SingleMoveRepeats,
    /// A quantity with a tolerance is uniform within its band and independent of the others.
    UniformTolerances,
    /// A dwell behind a move with a payload states none: nothing is carried in it.
    NoPayloadInDwell,
    /// The payload of a turntable lies in the direction of the common centre of mass of the bodies.
    PayloadTowardsCentre,
    /// The length of an arm is stated without its shape: a rod.
    ArmIsRod,
    /// The length of an arm is stated without the distance of the payload: at the end of the arm.
    PayloadAtArmEnd,
    /// The recorded torque is a process torque, added to the torque of the mechanism.
    RecordedTorqueAdds,
    /// The recorded rotary quantities are those at the output.
    RecordedAtOutput,
    /// The recorded shaft turns in the direction of the output.
    RecordedTurnsAlike,
    /// Inertia and friction of the recorded motor and gear are not removed from a torque recorded at the motor.
    RecordedTorqueOfMotor,
    /// Speed and acceleration are differences of a recorded position, not smoothed.
    RecordedPositionDifferentiated,
    /// The recorded position is that of a modulo axis; its jumps of one revolution are removed.
    RecordedModulo,
    /// An end of the part of a recording lies beside its samples.
    RecordedWindow(WindowEnd),
    /// Noise of a recorded speed at rest is treated as zero.
    RecordedRest(RestNoise),
    /// Slow motion of a recording between its moves that may be meant as rest.
    RecordedSlow(SlowMotion),
    /// A recorded speed changes its sign from sample to sample and counts as motion.
    RecordedAlternating(Alternating),
    /// A key of a recording does not do what it is stated for.
    RecordedKey(Remark),
    /// A recording or a cam table, by its segment from 1, does not move; the largest speed [rad/s] that `standstill` hides.
    Motionless(usize, f64),
    /// The distance of a move is shorter than its change of speed takes: the axis comes back.
    Overruns(Overrun),
    /// The resolution of a recording in value or time causes an apparent acceleration, with the torque that the load would
    /// need for it \[Nm\].
    RecordedSteps(MadeUp, f64),
    /// Samples of a recording are too far apart for the acceleration of its motion.
    RecordedSparse(SparseSamples),
    /// Values of a recorded column are far beside those before and behind.
    RecordedOutliers(OutlyingValues),
    /// A recorded torque has white noise of this standard deviation \[Nm\].
    RecordedTorqueNoise(f64),
    /// The motion between the points of a cam table is a spline with continuous derivatives.
    SplineThroughPoints(Spline),
}

/// A figure of a template.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TemplateFigure {
    /// Path of the key.
    pub path: &'static str,
    /// Value as stated in the template.
    pub value: &'static str,
}

/// End of the part of a recording in use (`from`, `to`) that is no instant of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindowEnd {
    /// `true` for the start, `false` for the end.
    pub is_start: bool,
    /// Stated instant \[s\].
    pub stated_s: f64,
    /// Instant of the first or the last sample in use \[s\].
    pub used_s: f64,
}

/// Steps of a position, as an example.
const OUTLIERS: OutlyingValues = OutlyingValues { column: OutlyingColumn::Torque, count: 1, time_s: 1.2, value: 900.0 };
const STEPS: MadeUp = MadeUp {
    column: SteppedColumn::Position,
    cause: Spurious::Steps { step: 1.7e-8, smoothing_s: Some(3.3e-3) },
    interval_s: 60e-6,
    acceleration_rad_s2: 4.8,
    motion_rad_s2: 0.31,
};

impl Assumption {
    /// Assumptions in their order, with example arguments.
    pub const ALL: [Self; 99] = [
        Self::OfTemplate(TemplateFigure { path: "mechanism.hoist.drum_diameter", value: "120 mm" }),
        Self::Default(KeyDefault::NoFriction),
        Self::Default(KeyDefault::AmbientWithinRange),
        Self::ConditionsWithinRange,
        Self::CoolingPlate,
        Self::Default(KeyDefault::ModulationReserve),
        Self::Default(KeyDefault::NoSupply),
        Self::Rectifier,
        Self::RectifierAndDeviation,
        Self::SinglePhaseRectifier,
        Self::SinglePhaseRectifierAndDeviation,
        Self::OwnStallCurrentIncludesFriction,
        Self::OwnStallTorqueAboveLargest,
        Self::OwnStallCurrentAboveLargest,
        Self::OwnRatedSpeedAboveLargest,
        Self::NoFlangeLoads,
        Self::FlangeLoadsConstant,
        Self::FlangeMomentsAligned,
        Self::FlangeLoadsOfMechanism,
        Self::FlangeLoadsAddUp,
        Self::FlangeLoadsIgnored,
        Self::FlangeLoadsReplaced,
        Self::Default(KeyDefault::FlangeBearsAll),
        Self::FlangeBodiesFlat,
        Self::FlangeUpwards,
        Self::PayloadInertiaWeightless,
        Self::Default(KeyDefault::WheelWeightless),
        Self::Default(KeyDefault::SpurTeeth),
        Self::MechanismOnOwnBearings,
        Self::Default(KeyDefault::StageNoLosses),
        Self::Default(KeyDefault::StageLossesDoNotHelp),
        Self::Default(KeyDefault::StageWithoutInertia),
        Self::Default(KeyDefault::StageRigid),
        Self::Default(KeyDefault::StageNoBacklash),
        Self::StageRatioChosen(2.5),
        Self::Default(KeyDefault::NoLosses),
        Self::Default(KeyDefault::LossesDoNotHelp),
        Self::Default(KeyDefault::TravelHorizontal),
        Self::Default(KeyDefault::GroundHorizontal),
        Self::Default(KeyDefault::AxisVertical),
        Self::Default(KeyDefault::PartsWithoutInertia),
        Self::Default(KeyDefault::RopeWeightless),
        Self::Default(KeyDefault::SheavesNoLosses),
        Self::Default(KeyDefault::ArmsWeightless),
        Self::Default(KeyDefault::CouplerWeightless),
        Self::Default(KeyDefault::RockerWeightless),
        Self::Default(KeyDefault::AxisLevel),
        Self::Default(KeyDefault::StartsAtZero),
        Self::Default(KeyDefault::WindsUp),
        Self::Default(KeyDefault::RollToWind),
        Self::Default(KeyDefault::OneScissor),
        Self::LawOpen,
        Self::OneRevolution,
        Self::WebRamps,
        Self::TrapezoidThirds,
        Self::SingleMoveRepeats,
        Self::Default(KeyDefault::OrdinaryApplication),
        Self::UniformTolerances,
        Self::Default(KeyDefault::MotorHolds),
        Self::NoPayloadInDwell,
        Self::PayloadTowardsCentre,
        Self::ArmIsRod,
        Self::PayloadAtArmEnd,
        Self::RecordedTorqueAdds,
        Self::RecordedAtOutput,
        Self::RecordedTurnsAlike,
        Self::RecordedTorqueOfMotor,
        Self::RecordedPositionDifferentiated,
        Self::RecordedModulo,
        Self::RecordedWindow(WindowEnd { is_start: true, stated_s: 1.0005, used_s: 1.001 }),
        Self::RecordedWindow(WindowEnd { is_start: false, stated_s: 12.5, used_s: 12.4995 }),
        Self::RecordedRest(RestNoise { speed_rad_s: 1e-3, duration_s: 9.0, place_rad: 2e-5 }),
        Self::RecordedSlow(SlowMotion { speed_rad_s: 4e-3, place_rad: 2e-3, duration_s: 3.0 }),
        Self::RecordedAlternating(Alternating { share: 0.15, speed_rad_s: 0.02 }),
        Self::RecordedKey(Remark::NotHeld),
        Self::RecordedKey(Remark::EvenAlready),
        Self::RecordedKey(Remark::FollowsStamps),
        Self::RecordedKey(Remark::StandstillSteps {
            speed_rad_s: 0.1,
            acceleration_rad_s2: 180.0,
            without_rad_s2: 19.0,
        }),
        Self::Motionless(2, 0.0),
        Self::Motionless(2, 0.1),
        Self::Overruns(Overrun { segment: 3, stated_rad: 0.0884, plain_rad: 0.0885, travel_m_per_rad: None }),
        Self::Overruns(Overrun { segment: 3, stated_rad: 0.0884, plain_rad: 0.0885, travel_m_per_rad: Some(0.01) }),
        Self::RecordedSteps(STEPS, 0.5),
        Self::RecordedTorqueNoise(0.8),
        Self::RecordedOutliers(OUTLIERS),
        Self::RecordedOutliers(OutlyingValues { column: OutlyingColumn::Speed, count: 2, ..OUTLIERS }),
        Self::RecordedOutliers(OutlyingValues { column: OutlyingColumn::Position, ..OUTLIERS }),
        Self::RecordedSparse(SparseSamples { interval_s: 0.1, share: 0.15 }),
        Self::RecordedSteps(MadeUp { cause: Spurious::Steps { step: 1.7e-8, smoothing_s: None }, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { column: SteppedColumn::Speed, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { cause: Spurious::Held { period_s: 8e-3 }, ..STEPS }, 0.5),
        Self::RecordedSteps(
            MadeUp { cause: Spurious::Held { period_s: 8e-3 }, column: SteppedColumn::Speed, ..STEPS },
            0.5,
        ),
        Self::RecordedSteps(MadeUp { cause: Spurious::Updates { smoothing_s: Some(0.05) }, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { cause: Spurious::Updates { smoothing_s: None }, ..STEPS }, 0.5),
        Self::RecordedSteps(MadeUp { cause: Spurious::Stamps { scatter_s: 3e-4 }, ..STEPS }, 0.5),
        Self::RecordedSteps(
            MadeUp { cause: Spurious::Noise { deviation: 1e-6, rms_rad_s2: 1.2, smoothing_s: Some(0.05) }, ..STEPS },
            0.5,
        ),
        Self::RecordedSteps(
            MadeUp {
                cause: Spurious::Noise { deviation: 1e-3, rms_rad_s2: 1.2, smoothing_s: None },
                column: SteppedColumn::Speed,
                ..STEPS
            },
            0.5,
        ),
        Self::SplineThroughPoints(Spline::Cubic),
        Self::SplineThroughPoints(Spline::Quintic),
    ];
}

impl Assumption {
    /// Returns the word of `requirements.leave_out` with which a project leaves it open knowingly.
    #[must_use]
    pub const fn left_out(self) -> Option<LeftOut> {
        match self {
            Self::Default(KeyDefault::NoSupply) => Some(LeftOut::Supply),
            Self::Default(KeyDefault::OrdinaryApplication) => Some(LeftOut::Application),
            Self::NoFlangeLoads => Some(LeftOut::FlangeLoads),
            Self::ConditionsWithinRange => Some(LeftOut::Conditions),
            _ => None,
        }
    }

    /// Returns `true` if the assumption concerns position, speed or duration of the motion, not the load alone.
    #[must_use]
    pub const fn concerns_motion(self) -> bool {
        matches!(
            self,
            Self::LawOpen
                | Self::OneRevolution
                | Self::WebRamps
                | Self::TrapezoidThirds
                | Self::SingleMoveRepeats
                | Self::RecordedAtOutput
                | Self::RecordedTurnsAlike
                | Self::RecordedPositionDifferentiated
                | Self::RecordedModulo
                | Self::RecordedWindow(_)
                | Self::RecordedRest(_)
                | Self::RecordedSlow(_)
                | Self::RecordedAlternating(_)
                | Self::RecordedKey(_)
                | Self::Motionless(..)
                | Self::Overruns(_)
                | Self::RecordedSteps(..)
                | Self::RecordedSparse(_)
                | Self::RecordedOutliers(_)
                | Self::SplineThroughPoints(_)
                | Self::Default(KeyDefault::StartsAtZero | KeyDefault::WindsUp | KeyDefault::RollToWind)
        )
    }
}

/// Returns the default of a field that is not stated, if its key has one.
pub(crate) fn unstated(field: &dyn StatedField) -> Option<Assumption> {
    field.note().map(Assumption::Default)
}

/// A move in which the axis comes back, because its distance is shorter than its change of speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overrun {
    /// Number of the segment, from 1.
    pub segment: usize,
    /// Distance of the move \[rad\], signed.
    pub stated_rad: f64,
    /// Distance of the plain change of speed \[rad\], signed.
    pub plain_rad: f64,
    /// Travel per angle of a linear mechanism [m/rad].
    pub travel_m_per_rad: Option<f64>,
}

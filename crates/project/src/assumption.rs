//! Defaults that the file leaves open.

use motion::{Alternating, MadeUp, Remark, RestNoise, Spline, Spurious, SteppedColumn};

/// A default that the user did not confirm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Assumption {
    /// No friction torque is given: zero is assumed.
    NoFriction,
    /// No ambient temperature is given: the values of the manual hold up to 40 °C.
    AmbientWithinRange,
    /// Not all conditions of use are stated: those that are missing are within the manufacturer's.
    ConditionsWithinRange,
    /// The plate of table 13.3 cools the actuator.
    CoolingPlate,
    /// A DC link voltage is given without a modulation reserve.
    ModulationReserve,
    /// No DC link voltage is given: the terminal voltage is not checked.
    NoSupply,
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
    /// No share is given: the flange bears the loads of the mechanism alone.
    FlangeBearsAll,
    /// The bodies on the flange have no products of inertia.
    FlangeBodiesFlat,
    /// No tilt of the axis is given: the flange looks upwards.
    FlangeUpwards,
    /// A payload given by its inertia loads the flange with no weight.
    PayloadInertiaWeightless,
    /// No mass of pulley, pinion or crank is given.
    WheelWeightless,
    /// No helix angle is given: spur teeth.
    SpurTeeth,
    /// With a stage the mechanism does not load the flange.
    MechanismOnOwnBearings,
    /// No efficiency of the stage is given.
    StageNoLosses,
    /// No efficiency of the stage for driving backwards is given.
    StageLossesDoNotHelp,
    /// No inertia of the stage is given.
    StageWithoutInertia,
    /// No stiffness of the stage is given.
    StageRigid,
    /// No backlash of the stage is given.
    StageNoBacklash,
    /// The best of several ratios was chosen.
    StageRatioChosen,
    /// No efficiency of the mechanism is given: one is assumed.
    NoLosses,
    /// No efficiency for driving backwards is given: the losses do not help to brake.
    LossesDoNotHelp,
    /// No inclination of a linear travel is given: horizontal.
    TravelHorizontal,
    /// No inclination of the ground link of a four-bar linkage is given: horizontal.
    GroundHorizontal,
    /// No tilt of the axis of rotation is given: vertical.
    AxisVertical,
    /// No inertia of the rotating parts of a mechanism is given: zero.
    PartsWithoutInertia,
    /// No mass of the rope is given: zero.
    RopeWeightless,
    /// No efficiency of the rope sheaves is given: one.
    SheavesNoLosses,
    /// No mass of the arms of a scissor lift is given: zero.
    ArmsWeightless,
    /// No mass of the coupler of a four-bar linkage is given: zero.
    CouplerWeightless,
    /// No mass of the rocker of a four-bar linkage is given: zero.
    RockerWeightless,
    /// A trapezoid given by two quantities accelerates, runs and brakes for a third of the time each.
    TrapezoidThirds,
    /// A single move is judged as if it were repeated without a pause.
    SingleMoveRepeats,
    /// No special field of application is stated.
    OrdinaryApplication,
    /// A quantity with a tolerance is uniform within its band and independent of the others.
    UniformTolerances,
    /// The motor carries the load in a dwell without `hold`.
    MotorHolds,
    /// A dwell behind a move with a payload states none: nothing is carried in it.
    NoPayloadInDwell,
    /// The payload of a turntable lies in the direction of the common centre of mass of the bodies.
    PayloadTowardsCentre,
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
    /// Noise of a recorded speed at rest is treated as zero.
    RecordedRest(RestNoise),
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
    /// The motion between the points of a cam table is a spline with continuous derivatives.
    SplineThroughPoints(Spline),
}

/// Steps of a position, as an example.
const STEPS: MadeUp = MadeUp {
    column: SteppedColumn::Position,
    cause: Spurious::Steps { step: 1.7e-8, smoothing_s: Some(3.3e-3) },
    interval_s: 60e-6,
    acceleration_rad_s2: 4.8,
    motion_rad_s2: 0.31,
};

impl Assumption {
    /// Assumptions in their order, with example arguments.
    pub const ALL: [Self; 78] = [
        Self::NoFriction,
        Self::AmbientWithinRange,
        Self::ConditionsWithinRange,
        Self::CoolingPlate,
        Self::ModulationReserve,
        Self::NoSupply,
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
        Self::FlangeBearsAll,
        Self::FlangeBodiesFlat,
        Self::FlangeUpwards,
        Self::PayloadInertiaWeightless,
        Self::WheelWeightless,
        Self::SpurTeeth,
        Self::MechanismOnOwnBearings,
        Self::StageNoLosses,
        Self::StageLossesDoNotHelp,
        Self::StageWithoutInertia,
        Self::StageRigid,
        Self::StageNoBacklash,
        Self::StageRatioChosen,
        Self::NoLosses,
        Self::LossesDoNotHelp,
        Self::TravelHorizontal,
        Self::GroundHorizontal,
        Self::AxisVertical,
        Self::PartsWithoutInertia,
        Self::RopeWeightless,
        Self::SheavesNoLosses,
        Self::ArmsWeightless,
        Self::CouplerWeightless,
        Self::RockerWeightless,
        Self::TrapezoidThirds,
        Self::SingleMoveRepeats,
        Self::OrdinaryApplication,
        Self::UniformTolerances,
        Self::MotorHolds,
        Self::NoPayloadInDwell,
        Self::PayloadTowardsCentre,
        Self::RecordedTorqueAdds,
        Self::RecordedAtOutput,
        Self::RecordedTurnsAlike,
        Self::RecordedTorqueOfMotor,
        Self::RecordedPositionDifferentiated,
        Self::RecordedModulo,
        Self::RecordedRest(RestNoise { speed_rad_s: 1e-3, duration_s: 9.0 }),
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
        Self::SplineThroughPoints(Spline::Cubic),
        Self::SplineThroughPoints(Spline::Quintic),
    ];
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

//! Defaults of keys.

/// Default of a key that is listed as an assumption if the key is not stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeyDefault {
    /// No friction torque is given: zero is assumed.
    NoFriction,
    /// No ambient temperature is given: the values of the manual hold up to 40 °C.
    AmbientWithinRange,
    /// A DC link voltage is given without a modulation reserve.
    ModulationReserve,
    /// No DC link voltage is given: the terminal voltage is not checked.
    NoSupply,
    /// No share is given: the flange bears the loads of the mechanism alone.
    FlangeBearsAll,
    /// No mass of pulley, pinion or crank is given.
    WheelWeightless,
    /// No helix angle is given: spur teeth.
    SpurTeeth,
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
    /// No tilt of the axis of rotation is given: horizontal, with the whole weight.
    AxisLevel,
    /// No position at the beginning of the motion is given: zero.
    StartsAtZero,
    /// No direction of a winder is given: it winds up.
    WindsUp,
    /// No diameter at position zero is given: the core is wound up, the full roll is wound off.
    RollToWind,
    /// No number of stages of a scissor lift is given: one.
    OneScissor,
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
    /// No special field of application is stated.
    OrdinaryApplication,
    /// The motor carries the load in a dwell without `hold`.
    MotorHolds,
}

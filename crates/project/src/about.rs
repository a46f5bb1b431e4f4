//! What the keys of the project file are for, by name; `words` has the texts.

use installation::commission::expected::Measurand;

macro_rules! abouts {
    ($($name:ident)+) => {
        /// What a key of the project file is for. A key is named after its table; keys that are for the same have one name.
        #[allow(missing_docs, reason = "each is named after its key")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum About {
            $($name,)+
            /// A key of a record of measured values.
            Measured(MeasuredKey),
        }

        impl About {
            /// Every purpose of a key of the project file.
            pub const ALL: &'static [Self] = &[$(Self::$name),+];
        }
    };
}

abouts! {
    Format Axis Load Mechanism Stage Motion Bearing Requirements Actuator Curve CurveKind CurveCode CurvePoints
    CurveSource AxisName AxisSingleMove LoadInertia FrictionTorque ViscousFriction ExternalTorque Efficiency
    EfficiencyBack Mass TurningInertia Inclination Counterweight FrictionForce FrictionCoefficient ProcessForce
    StartAngle MechanismTurntable MechanismArm MechanismScrew MechanismBelt MechanismConveyor MechanismSliderCrank
    MechanismJoint MechanismTable StageKind StageRatio StageRatios StageEfficiency StageEfficiencyBack
    StageInertiaDriving StageInertiaDriven StageStiffness StageBacklash StagePitchDiameter BodyShape BodyDiameter
    BodyLength BodyOuter BodyInner BodyA BodyB BodyHeight BodyAxis BodyMass BodyDensity BodyDistance BodyAngle
    BodyCount TurntableBody TurntableBodies TurntableAxisTilt TurntableStartAngle TurntablePayloadDistance ArmInertia
    ArmMass ArmCentreDistance ArmAxisTilt ScrewLead BeltPulleyDiameter ConveyorRollerDiameter SliderCrankCrank
    SliderCrankRod TablePoints JointInertia JointHoldingTorque ColumnsTime ColumnsPosition ColumnsSpeed ColumnsTorque
    UnitsTime UnitsPosition UnitsSpeed UnitsTorque MotionLaw MotionSpeed MotionAccelerate MotionRun MotionBrake
    MotionPause MotionDistance MotionTime MotionAcceleration MotionJerk MotionEndSpeed MotionHold MotionFile
    MotionColumns MotionUnits MotionFrom MotionTo MotionSmoothing MotionStandstill MotionGaps MotionPayload
    MotionPayloadInertia MotionProcessForce MotionProcessTorque MotionBearing RadialForce RadialDistance AxialForce
    AxialDistance BearingLoadFactor BearingOperatingCondition BearingMechanism BearingOverhang BearingPayloadOverhang
    BearingFlangeShare BearingBeltTension BearingPressureAngle BearingHelixAngle BearingWheelMass BearingAxisTilt
    RequirementsFeedback RequirementsBrake RequirementsHollowShaftMin RequirementsLengthMax RequirementsMassMax
    RequirementsSupply RequirementsModulationReserve RequirementsAmbient RequirementsBearingLifeMin
    RequirementsGearLifeMin RequirementsTorsionMax RequirementsNaturalFrequencyMin RequirementsTiltAngleMax
    RequirementsAngleErrorMax RequirementsLeverArm RequirementsDeviationMax RequirementsResolutionMax
    RequirementsAbsolute RequirementsStopAngleMax RequirementsEmergencyStops RequirementsHoldingSafety
    RequirementsServiceLife RequirementsRegenerationPowerMax RequirementsOperationPerDay RequirementsStorage
    RequirementsBatteryLifeMin RequirementsCollisionTorque RequirementsCollisionTime RequirementsCollisions
    RequirementsPositionLoop RequirementsDcLinkRise RequirementsSpecialApplication RequirementsOption1
    RequirementsOption2 ActuatorName ActuatorRatio ActuatorTorqueMax ActuatorSpeedMax ActuatorSpeedMotorMax
    ActuatorSpeedMotorRated ActuatorInertiaOut ActuatorStallTorque ActuatorStallCurrent ActuatorCurrentMax
    ActuatorCurrentDemagnetisation ActuatorNoLoadStartingCurrent ActuatorNoLoadCurrentConstant30
    ActuatorNoLoadCurrentConstant80 ActuatorTorqueConstantOut ActuatorTorqueConstantMotor ActuatorVoltageConstantMotor
    ActuatorResistanceLl ActuatorWindingTemperatureMax ActuatorInductanceLl ActuatorPolePairs ActuatorMass
    ActuatorLength ActuatorHollowShaft ActuatorDcLinkMax ActuatorTerminalVoltageMin ActuatorShortTimeCurve
    ActuatorContinuousCurve
}

/// A key of a record of measured values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasuredKey {
    /// `format`
    Format,
    /// `[winding]`
    Winding,
    /// `winding.temperature`
    WindingTemperature,
    /// `winding.resistance_ll`
    ResistanceLl,
    /// `winding.inductance_ll`
    InductanceLl,
    /// `[emf]`
    Emf,
    /// `emf.voltage_ll`
    EmfVoltage,
    /// `emf.speed_motor`
    EmfSpeed,
    /// `[sensor]`
    Sensor,
    /// `sensor.temperature`
    SensorTemperature,
    /// `sensor.kty`
    Kty,
    /// `sensor.ptc`
    Ptc,
    /// `[brake]`
    Brake,
    /// `brake.voltage`
    BrakeVoltage,
    /// `brake.opening_current`
    OpeningCurrent,
    /// `brake.holding_current`
    HoldingCurrent,
    /// `brake.opening_time`
    OpeningTime,
    /// `brake.closing_time`
    ClosingTime,
    /// `[direction]`
    Direction,
    /// `direction.motor`
    DirectionMotor,
    /// `direction.flange`
    DirectionFlange,
    /// `direction.position`
    DirectionPosition,
    /// `[speed]`
    Speed,
    /// `speed.motor`
    SpeedMotor,
    /// `speed.flange`
    SpeedFlange,
    /// `speed.electrical_frequency`
    SpeedFrequency,
    /// `[[no_load]]`
    NoLoad,
    /// `no_load.speed_out`
    NoLoadSpeed,
    /// `no_load.current`
    NoLoadCurrent,
    /// `no_load.temperature`
    NoLoadTemperature,
}

impl MeasuredKey {
    /// What is measured with it; none of what only says under which conditions.
    #[must_use]
    pub const fn measurand(self) -> Option<Measurand> {
        Some(match self {
            Self::ResistanceLl => Measurand::ResistanceLl,
            Self::InductanceLl => Measurand::InductanceLl,
            Self::EmfVoltage => Measurand::Emf,
            Self::Kty => Measurand::Kty,
            Self::Ptc => Measurand::Ptc,
            Self::BrakeVoltage => Measurand::BrakeVoltage,
            Self::OpeningCurrent => Measurand::BrakeOpeningCurrent,
            Self::HoldingCurrent => Measurand::BrakeHoldingCurrent,
            Self::OpeningTime => Measurand::BrakeOpeningTime,
            Self::ClosingTime => Measurand::BrakeClosingTime,
            Self::NoLoadCurrent => Measurand::NoLoadCurrent,
            _ => return None,
        })
    }
}

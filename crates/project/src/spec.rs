//! The project file, key by key: one description from which the reader, its messages and the JSON Schema come.

use crate::about::About;
use crate::bodies::{BODY_SHARED, BOX, BodyShape, CONE, CYLINDER, DISC, POINT, ROD, SPHERE, TUBE};
use crate::{Expected, Range};
use quantities::Dimension;

/// What may stand behind a key.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// A number with its unit, written as text.
    Quantity(Dimension, Range),
    /// A number with a unit of one of two dimensions: of the rotation, or of the line of a linear mechanism.
    Along(Dimension, Dimension, Range),
    /// A plain number within bounds.
    Number(f64, f64),
    /// A list of plain numbers within bounds, and how many at most.
    Numbers(f64, f64, usize),
    /// A whole number within bounds.
    Integer(i64, i64),
    /// `true` or `false`.
    Bool,
    /// Free text of bounded length.
    Text,
    /// One of these words.
    OneOf(&'static [&'static str]),
    /// A list of these words.
    ListOf(&'static [&'static str]),
    /// Rows of quantities, `[["0 1/min", "32 N m"], …]`.
    Rows(&'static [Dimension]),
    /// A table.
    Table(&'static [Key]),
    /// A table, or an array of tables with more in them.
    OneOrMany(&'static [Key], &'static [Key]),
    /// Solid bodies, one text each.
    Bodies,
    /// An array of tables, each of one of several kinds.
    Variants(&'static Variants),
}

impl Kind {
    /// What may stand there, for a fault.
    pub(crate) const fn expected(&self) -> Expected {
        match *self {
            Self::Quantity(dimension, _) => Expected::Quantity(dimension),
            Self::Along(turning, line, _) => Expected::Along(turning, line),
            Self::Number(..) => Expected::Number,
            Self::Numbers(..) => Expected::Numbers,
            Self::Integer(..) => Expected::Integer,
            Self::Bool => Expected::Bool,
            Self::Text => Expected::Text,
            Self::OneOf(words) => Expected::OneOf(words),
            Self::ListOf(words) => Expected::ListOf(words),
            Self::Rows(_) => Expected::Rows,
            Self::Table(_) | Self::OneOrMany(..) => Expected::Table,
            Self::Bodies => Expected::Bodies,
            Self::Variants(_) => Expected::Tables,
        }
    }
}

/// Tables of several kinds that share a description: one key says which kind it is, and so which others belong.
#[derive(Debug)]
pub struct Variants {
    /// The keys of all kinds.
    pub keys: &'static [Key],
    /// The key that names the kind.
    pub by: &'static str,
    /// Name, keys that must be there, keys that may be there besides those of every kind.
    pub kinds: &'static [(&'static str, &'static [&'static str], &'static [&'static str])],
    /// Keys that every kind may have.
    pub shared: &'static [&'static str],
}

/// One key of the project file.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    /// Its name in the file.
    pub name: &'static str,
    /// What may stand behind it.
    pub kind: Kind,
    /// Whether its table must have it.
    pub required: bool,
    /// What it is for.
    pub about: About,
}

pub(crate) const fn key(name: &'static str, kind: Kind, required: bool, about: About) -> Key {
    Key { name, kind, required, about }
}

pub(crate) const fn quantity(name: &'static str, d: Dimension, range: Range, about: About) -> Key {
    key(name, Kind::Quantity(d, range), false, about)
}

const fn along(name: &'static str, d: [Dimension; 2], range: Range, about: About) -> Key {
    let [turning, line] = d;
    key(name, Kind::Along(turning, line, range), false, about)
}

pub(crate) const fn needed(name: &'static str, d: Dimension, range: Range, about: About) -> Key {
    key(name, Kind::Quantity(d, range), true, about)
}

/// The format of the project file that this version reads.
pub(crate) const FORMAT: i64 = 1;

/// Feedback systems in the spelling of the ordering code.
pub(crate) const FEEDBACKS: &[&str] = &["C1024", "M512P", "RES", "D2048", "M128S"];

/// Fields of application of section 2.4.
pub(crate) const APPLICATIONS: &[&str] = &[
    "aerospace",
    "explosive_atmosphere",
    "nuclear",
    "vacuum",
    "household",
    "medical",
    "human_contact",
    "lifting_of_persons",
    "amusement",
];

/// The root of the project file, and under its tables every other key.
#[rustfmt::skip] // one line per key
pub const ROOT: &[Key] = &[
    key("format", Kind::Integer(FORMAT, FORMAT), true, About::Format),
    key("axis", Kind::OneOrMany(AXIS, AXES), false, About::Axis),
    key("load", Kind::Table(LOAD), false, About::Load),
    key("mechanism", Kind::Table(MECHANISM), false, About::Mechanism),
    key("stage", Kind::Table(STAGE), false, About::Stage),
    key("motion", Kind::Variants(&MOTIONS), false, About::Motion),
    key("bearing", Kind::Table(BEARING), false, About::Bearing),
    key("requirements", Kind::Table(REQUIREMENTS), false, About::Requirements),
    key("actuator", Kind::Table(ACTUATOR), false, About::Actuator),
    key("curve", Kind::Variants(&CURVES), false, About::Curve),
];

/// Curves of the user for actuators of the catalogue.
#[rustfmt::skip] // one line per kind
static CURVES: Variants = Variants {
    keys: CURVE,
    by: "kind",
    kinds: &[
        ("continuous", &["code", "points", "source"], &[]),
        ("s3_50", &["code", "points", "source"], &[]),
        ("s3_25", &["code", "points", "source"], &[]),
        ("short_time", &["code", "points", "source"], &[]),
    ],
    shared: &[],
};

#[rustfmt::skip] // one line per key
const CURVE: &[Key] = &[
    key("kind", Kind::OneOf(&["continuous", "s3_50", "s3_25", "short_time"]), true, About::CurveKind),
    key("code", Kind::Text, false, About::CurveCode),
    key("points", Kind::Rows(&[Dimension::AngularVelocity, Dimension::Torque]), false, About::CurvePoints),
    key("source", Kind::Text, false, About::CurveSource),
];

#[rustfmt::skip] // one line per key
const AXIS: &[Key] = &[
    key("name", Kind::Text, false, About::AxisName),
    key("single_move", Kind::Bool, false, About::AxisSingleMove),
];

/// One of several axes: what stands at the root for a single one.
#[rustfmt::skip] // one line per key
const AXES: &[Key] = &[
    key("name", Kind::Text, true, About::AxisName),
    key("single_move", Kind::Bool, false, About::AxisSingleMove),
    key("load", Kind::Table(LOAD), false, About::Load),
    key("mechanism", Kind::Table(MECHANISM), false, About::Mechanism),
    key("stage", Kind::Table(STAGE), false, About::Stage),
    key("motion", Kind::Variants(&MOTIONS), false, About::Motion),
    key("bearing", Kind::Table(BEARING), false, About::Bearing),
    key("requirements", Kind::Table(REQUIREMENTS), false, About::Requirements),
    key("actuator", Kind::Table(ACTUATOR), false, About::Actuator),
];

#[rustfmt::skip] // one line per key
const LOAD: &[Key] = &[
    needed("inertia", Dimension::MomentOfInertia, Range::NotNegative, About::LoadInertia),
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE,
];

#[rustfmt::skip] // one line per key
const FRICTION_TORQUE: Key = quantity("friction_torque", Dimension::Torque, Range::NotNegative, About::FrictionTorque);
#[rustfmt::skip] // one line per key
const VISCOUS_FRICTION: Key = quantity("viscous_friction", Dimension::ViscousFriction, Range::NotNegative, About::ViscousFriction);
#[rustfmt::skip] // one line per key
const EXTERNAL_TORQUE: Key = quantity("external_torque", Dimension::Torque, Range::Any, About::ExternalTorque);
#[rustfmt::skip] // one line per key
const EFFICIENCY: Key = key("efficiency", Kind::Number(0.01, 1.0), false, About::Efficiency);
#[rustfmt::skip] // one line per key
const EFFICIENCY_BACK: Key = key("efficiency_back", Kind::Number(0.0, 1.0), false, About::EfficiencyBack);
#[rustfmt::skip] // one line per key
const MASS: Key = needed("mass", Dimension::Mass, Range::NotNegative, About::Mass);
#[rustfmt::skip] // one line per key
const TURNING_INERTIA: Key = quantity("inertia", Dimension::MomentOfInertia, Range::NotNegative, About::TurningInertia);
#[rustfmt::skip] // one line per key
const INCLINATION: Key = quantity("inclination", Dimension::Angle, Range::Any, About::Inclination);
#[rustfmt::skip] // one line per key
const COUNTERWEIGHT: Key = quantity("counterweight", Dimension::Mass, Range::NotNegative, About::Counterweight);
#[rustfmt::skip] // one line per key
const FRICTION_FORCE: Key = quantity("friction_force", Dimension::Force, Range::NotNegative, About::FrictionForce);
#[rustfmt::skip] // one line per key
const FRICTION_COEFFICIENT: Key = key("friction_coefficient", Kind::Number(0.0, 10.0), false, About::FrictionCoefficient);
#[rustfmt::skip] // one line per key
const PROCESS_FORCE: Key = quantity("process_force", Dimension::Force, Range::Any, About::ProcessForce);
#[rustfmt::skip] // one line per key
const START_ANGLE: Key = needed("start_angle", Dimension::Angle, Range::Any, About::StartAngle);

#[rustfmt::skip] // one line per key
const MECHANISM: &[Key] = &[
    key("turntable", Kind::Table(TURNTABLE), false, About::MechanismTurntable),
    key("arm", Kind::Table(ARM), false, About::MechanismArm),
    key("screw", Kind::Table(SCREW), false, About::MechanismScrew),
    key("belt", Kind::Table(BELT), false, About::MechanismBelt),
    key("conveyor", Kind::Table(CONVEYOR), false, About::MechanismConveyor),
    key("slider_crank", Kind::Table(SLIDER_CRANK), false, About::MechanismSliderCrank),
    key("joint", Kind::Table(JOINT), false, About::MechanismJoint),
    key("table", Kind::Table(TABLE), false, About::MechanismTable),
];

#[rustfmt::skip] // one line per key
const STAGE: &[Key] = &[
    key("kind", Kind::OneOf(&["belt", "gear", "coupling"]), true, About::StageKind),
    key("ratio", Kind::Number(0.01, 1000.0), false, About::StageRatio),
    key("ratios", Kind::Numbers(0.01, 1000.0, crate::stage::RATIOS_MOST), false, About::StageRatios),
    key("efficiency", Kind::Number(0.01, 1.0), false, About::StageEfficiency),
    key("efficiency_back", Kind::Number(0.0, 1.0), false, About::StageEfficiencyBack),
    quantity("inertia_driving", Dimension::MomentOfInertia, Range::NotNegative, About::StageInertiaDriving),
    quantity("inertia_driven", Dimension::MomentOfInertia, Range::NotNegative, About::StageInertiaDriven),
    quantity("stiffness", Dimension::TorsionalStiffness, Range::Positive, About::StageStiffness),
    quantity("backlash", Dimension::Angle, Range::NotNegative, About::StageBacklash),
    quantity("pitch_diameter", Dimension::Length, Range::Positive, About::StagePitchDiameter),
];

/// Solid bodies by their shapes.
static BODIES: Variants = Variants {
    keys: BODY,
    by: "shape",
    kinds: &[
        of_shape(CYLINDER),
        of_shape(DISC),
        of_shape(TUBE),
        of_shape(BOX),
        of_shape(CONE),
        of_shape(SPHERE),
        of_shape(POINT),
        of_shape(ROD),
    ],
    shared: BODY_SHARED,
};

/// What a shape needs and what it may have besides.
const fn of_shape(shape: BodyShape) -> (&'static str, &'static [&'static str], &'static [&'static str]) {
    (shape.name, shape.dimensions, if shape.may_lie { &["axis"] } else { &[] })
}

/// A solid body, in a table of the project file and in one line of text alike.
#[rustfmt::skip] // one line per key
pub(crate) const BODY: &[Key] = &[
    key("shape", Kind::OneOf(&["cylinder", "disc", "tube", "box", "cone", "sphere", "point", "rod"]), true, About::BodyShape),
    quantity("diameter", Dimension::Length, Range::Positive, About::BodyDiameter),
    quantity("length", Dimension::Length, Range::Positive, About::BodyLength),
    quantity("outer", Dimension::Length, Range::Positive, About::BodyOuter),
    quantity("inner", Dimension::Length, Range::NotNegative, About::BodyInner),
    quantity("a", Dimension::Length, Range::Positive, About::BodyA),
    quantity("b", Dimension::Length, Range::Positive, About::BodyB),
    quantity("height", Dimension::Length, Range::Positive, About::BodyHeight),
    key("axis", Kind::OneOf(&["parallel", "perpendicular"]), false, About::BodyAxis),
    quantity("mass", Dimension::Mass, Range::Positive, About::BodyMass),
    quantity("density", Dimension::MassDensity, Range::Positive, About::BodyDensity),
    quantity("distance", Dimension::Length, Range::NotNegative, About::BodyDistance),
    quantity("angle", Dimension::Angle, Range::Any, About::BodyAngle),
    key("count", Kind::Integer(1, u32::MAX as i64), false, About::BodyCount),
];

#[rustfmt::skip] // one line per key
const TURNTABLE: &[Key] = &[
    key("body", Kind::Variants(&BODIES), false, About::TurntableBody),
    key("bodies", Kind::Bodies, false, About::TurntableBodies),
    quantity("axis_tilt", Dimension::Angle, Range::Any, About::TurntableAxisTilt),
    quantity("start_angle", Dimension::Angle, Range::Any, About::TurntableStartAngle),
    quantity("payload_distance", Dimension::Length, Range::NotNegative, About::TurntablePayloadDistance),
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const ARM: &[Key] = &[
    needed("inertia", Dimension::MomentOfInertia, Range::NotNegative, About::ArmInertia),
    needed("mass", Dimension::Mass, Range::NotNegative, About::ArmMass),
    needed("centre_distance", Dimension::Length, Range::NotNegative, About::ArmCentreDistance),
    quantity("payload_distance", Dimension::Length, Range::NotNegative, About::TurntablePayloadDistance),
    needed("axis_tilt", Dimension::Angle, Range::Any, About::ArmAxisTilt),
    START_ANGLE, FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const SCREW: &[Key] = &[
    needed("lead", Dimension::Length, Range::Positive, About::ScrewLead),
    MASS, TURNING_INERTIA, INCLINATION, COUNTERWEIGHT, FRICTION_FORCE, FRICTION_COEFFICIENT, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const BELT: &[Key] = &[
    needed("pulley_diameter", Dimension::Length, Range::Positive, About::BeltPulleyDiameter),
    MASS, TURNING_INERTIA, INCLINATION, COUNTERWEIGHT, FRICTION_FORCE, FRICTION_COEFFICIENT, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const CONVEYOR: &[Key] = &[
    needed("roller_diameter", Dimension::Length, Range::Positive, About::ConveyorRollerDiameter),
    MASS, TURNING_INERTIA, INCLINATION, FRICTION_FORCE, FRICTION_COEFFICIENT, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const SLIDER_CRANK: &[Key] = &[
    needed("crank", Dimension::Length, Range::Positive, About::SliderCrankCrank),
    needed("rod", Dimension::Length, Range::Positive, About::SliderCrankRod),
    MASS, TURNING_INERTIA, INCLINATION, START_ANGLE, PROCESS_FORCE,
    FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const TABLE: &[Key] = &[
    key("points", Kind::Rows(&[Dimension::Angle, Dimension::MomentOfInertia, Dimension::Torque]), true, About::TablePoints),
    START_ANGLE, FRICTION_TORQUE, VISCOUS_FRICTION, EXTERNAL_TORQUE, EFFICIENCY, EFFICIENCY_BACK,
];

#[rustfmt::skip] // one line per key
const JOINT: &[Key] = &[
    quantity("inertia", Dimension::MomentOfInertia, Range::Positive, About::JointInertia),
    quantity("holding_torque", Dimension::Torque, Range::NotNegative, About::JointHoldingTorque),
];

/// Names of the columns of a recording; `none` where a name must not be taken for a role.
#[rustfmt::skip] // one line per key
const COLUMNS: &[Key] = &[
    key("time", Kind::Text, false, About::ColumnsTime),
    key("position", Kind::Text, false, About::ColumnsPosition),
    key("speed", Kind::Text, false, About::ColumnsSpeed),
    key("torque", Kind::Text, false, About::ColumnsTorque),
];

#[rustfmt::skip] // one line per key
const UNITS: &[Key] = &[
    key("time", Kind::Text, false, About::UnitsTime),
    key("position", Kind::Text, false, About::UnitsPosition),
    key("speed", Kind::Text, false, About::UnitsSpeed),
    key("torque", Kind::Text, false, About::UnitsTorque),
];

/// The laws of motion with the keys that each needs and those it may have.
#[rustfmt::skip] // one line per law
static MOTIONS: Variants = Variants {
    keys: MOTION,
    by: "law",
    kinds: &[
        ("manual", &["speed", "accelerate", "run", "brake", "pause"], &[]),
        ("trapezoid", &[], &["distance", "time", "speed", "acceleration", "end_speed"]),
        ("triangle", &[], &["distance", "time", "speed", "acceleration"]),
        ("jerk", &["distance", "speed", "acceleration", "jerk"], &["end_speed"]),
        ("polynomial_5", &[], &["distance", "time", "speed", "acceleration", "end_speed"]),
        ("modified_sine", &[], &["distance", "time", "speed", "acceleration"]),
        ("modified_trapezoid", &[], &["distance", "time", "speed", "acceleration"]),
        ("simple_sine", &[], &["distance", "time", "speed", "acceleration"]),
        ("inclined_sine", &[], &["distance", "time", "speed", "acceleration"]),
        ("parabola", &[], &["distance", "time", "speed", "acceleration"]),
        ("constant", &["speed"], &["time", "distance"]),
        ("dwell", &["time"], &["hold"]),
        ("recorded", &["file"], &["columns", "units", "from", "to", "smoothing", "standstill", "gaps"]),
    ],
    shared: &["payload", "payload_inertia", "process_force", "process_torque", "bearing"],
};

#[rustfmt::skip] // one line per law
const LAWS: &[&str] = &[
    "manual", "trapezoid", "triangle", "jerk", "polynomial_5", "modified_sine", "modified_trapezoid", "simple_sine",
    "inclined_sine", "parabola", "constant", "dwell", "recorded",
];

#[rustfmt::skip] // one line per key
const MOTION: &[Key] = &[
    key("law", Kind::OneOf(LAWS), true, About::MotionLaw),
    along("speed", [Dimension::AngularVelocity, Dimension::Velocity], Range::Any, About::MotionSpeed),
    quantity("accelerate", Dimension::Time, Range::NotNegative, About::MotionAccelerate),
    quantity("run", Dimension::Time, Range::NotNegative, About::MotionRun),
    quantity("brake", Dimension::Time, Range::NotNegative, About::MotionBrake),
    quantity("pause", Dimension::Time, Range::NotNegative, About::MotionPause),
    along("distance", [Dimension::Angle, Dimension::Length], Range::Any, About::MotionDistance),
    quantity("time", Dimension::Time, Range::NotNegative, About::MotionTime),
    along("acceleration", [Dimension::AngularAcceleration, Dimension::Acceleration], Range::Positive, About::MotionAcceleration),
    along("jerk", [Dimension::AngularJerk, Dimension::Jerk], Range::Positive, About::MotionJerk),
    along("end_speed", [Dimension::AngularVelocity, Dimension::Velocity], Range::Any, About::MotionEndSpeed),
    key("hold", Kind::OneOf(&["motor", "brake", "free"]), false, About::MotionHold),
    key("file", Kind::Text, false, About::MotionFile),
    key("columns", Kind::Table(COLUMNS), false, About::MotionColumns),
    key("units", Kind::Table(UNITS), false, About::MotionUnits),
    quantity("from", Dimension::Time, Range::Any, About::MotionFrom),
    quantity("to", Dimension::Time, Range::Any, About::MotionTo),
    quantity("smoothing", Dimension::Time, Range::Positive, About::MotionSmoothing),
    along("standstill", [Dimension::AngularVelocity, Dimension::Velocity], Range::Positive, About::MotionStandstill),
    key("gaps", Kind::OneOf(&["allow"]), false, About::MotionGaps),
    quantity("payload", Dimension::Mass, Range::NotNegative, About::MotionPayload),
    quantity("payload_inertia", Dimension::MomentOfInertia, Range::NotNegative, About::MotionPayloadInertia),
    quantity("process_force", Dimension::Force, Range::Any, About::MotionProcessForce),
    quantity("process_torque", Dimension::Torque, Range::Any, About::MotionProcessTorque),
    key("bearing", Kind::Table(SEGMENT_BEARING), false, About::MotionBearing),
];

#[rustfmt::skip] // one line per key
const SEGMENT_BEARING: &[Key] = &[RADIAL_FORCE, RADIAL_DISTANCE, AXIAL_FORCE, AXIAL_DISTANCE];
#[rustfmt::skip] // one line per key
const RADIAL_FORCE: Key = quantity("radial_force", Dimension::Force, Range::NotNegative, About::RadialForce);
#[rustfmt::skip] // one line per key
const RADIAL_DISTANCE: Key = quantity("radial_distance", Dimension::Length, Range::NotNegative, About::RadialDistance);
#[rustfmt::skip] // one line per key
const AXIAL_FORCE: Key = quantity("axial_force", Dimension::Force, Range::NotNegative, About::AxialForce);
#[rustfmt::skip] // one line per key
const AXIAL_DISTANCE: Key = quantity("axial_distance", Dimension::Length, Range::NotNegative, About::AxialDistance);

#[rustfmt::skip] // one line per key
const BEARING: &[Key] = &[
    RADIAL_FORCE, RADIAL_DISTANCE, AXIAL_FORCE, AXIAL_DISTANCE,
    key("load_factor", Kind::Number(1.0, 3.0), false, About::BearingLoadFactor),
    key("operating_condition", Kind::OneOf(&["normal", "shock", "high_accuracy"]), false, About::BearingOperatingCondition),
    key("mechanism", Kind::OneOf(&["add", "replace", "ignore"]), false, About::BearingMechanism),
    quantity("overhang", Dimension::Length, Range::Any, About::BearingOverhang),
    quantity("payload_overhang", Dimension::Length, Range::Any, About::BearingPayloadOverhang),
    key("flange_share", Kind::Number(0.0, 1.0), false, About::BearingFlangeShare),
    quantity("belt_tension", Dimension::Force, Range::NotNegative, About::BearingBeltTension),
    quantity("pressure_angle", Dimension::Angle, Range::Positive, About::BearingPressureAngle),
    quantity("helix_angle", Dimension::Angle, Range::NotNegative, About::BearingHelixAngle),
    quantity("wheel_mass", Dimension::Mass, Range::NotNegative, About::BearingWheelMass),
    quantity("axis_tilt", Dimension::Angle, Range::Any, About::BearingAxisTilt),
];

#[rustfmt::skip] // one line per key
const REQUIREMENTS: &[Key] = &[
    key("feedback", Kind::ListOf(FEEDBACKS), false, About::RequirementsFeedback),
    key("brake", Kind::Bool, false, About::RequirementsBrake),
    quantity("hollow_shaft_min", Dimension::Length, Range::NotNegative, About::RequirementsHollowShaftMin),
    quantity("length_max", Dimension::Length, Range::Positive, About::RequirementsLengthMax),
    quantity("mass_max", Dimension::Mass, Range::Positive, About::RequirementsMassMax),
    quantity("supply", Dimension::Voltage, Range::Positive, About::RequirementsSupply),
    key("modulation_reserve", Kind::Number(0.5, 1.0), false, About::RequirementsModulationReserve),
    quantity("ambient", Dimension::Temperature, Range::Any, About::RequirementsAmbient),
    quantity("bearing_life_min", Dimension::Time, Range::Positive, About::RequirementsBearingLifeMin),
    quantity("gear_life_min", Dimension::Time, Range::Positive, About::RequirementsGearLifeMin),
    quantity("torsion_max", Dimension::Angle, Range::Positive, About::RequirementsTorsionMax),
    quantity("natural_frequency_min", Dimension::Frequency, Range::Positive, About::RequirementsNaturalFrequencyMin),
    quantity("tilt_angle_max", Dimension::Angle, Range::Positive, About::RequirementsTiltAngleMax),
    quantity("angle_error_max", Dimension::Angle, Range::Positive, About::RequirementsAngleErrorMax),
    quantity("lever_arm", Dimension::Length, Range::Positive, About::RequirementsLeverArm),
    quantity("deviation_max", Dimension::Length, Range::Positive, About::RequirementsDeviationMax),
    quantity("resolution_max", Dimension::Angle, Range::Positive, About::RequirementsResolutionMax),
    key("absolute", Kind::Bool, false, About::RequirementsAbsolute),
    quantity("stop_angle_max", Dimension::Angle, Range::Positive, About::RequirementsStopAngleMax),
    key("emergency_stops", Kind::Integer(0, 1_000_000), false, About::RequirementsEmergencyStops),
    key("holding_safety", Kind::Number(1.0, 100.0), false, About::RequirementsHoldingSafety),
    quantity("service_life", Dimension::Time, Range::Positive, About::RequirementsServiceLife),
    quantity("regeneration_power_max", Dimension::Power, Range::Positive, About::RequirementsRegenerationPowerMax),
    quantity("operation_per_day", Dimension::Time, Range::NotNegative, About::RequirementsOperationPerDay),
    quantity("storage", Dimension::Time, Range::NotNegative, About::RequirementsStorage),
    quantity("battery_life_min", Dimension::Time, Range::Positive, About::RequirementsBatteryLifeMin),
    quantity("collision_torque", Dimension::Torque, Range::Positive, About::RequirementsCollisionTorque),
    quantity("collision_time", Dimension::Time, Range::Positive, About::RequirementsCollisionTime),
    key("collisions", Kind::Integer(0, 1_000_000), false, About::RequirementsCollisions),
    key("position_loop", Kind::OneOf(&["motor", "output"]), false, About::RequirementsPositionLoop),
    quantity("dc_link_rise", Dimension::Voltage, Range::Positive, About::RequirementsDcLinkRise),
    key("special_application", Kind::OneOf(APPLICATIONS), false, About::RequirementsSpecialApplication),
    key("option_1", Kind::OneOf(&["EC"]), false, About::RequirementsOption1),
    key("option_2", Kind::OneOf(&["K", "R", "S"]), false, About::RequirementsOption2),
];

#[rustfmt::skip] // one line per key
const ACTUATOR: &[Key] = &[
    key("name", Kind::Text, true, About::ActuatorName),
    key("ratio", Kind::Number(1.0, 10_000.0), false, About::ActuatorRatio),
    quantity("torque_max", Dimension::Torque, Range::Positive, About::ActuatorTorqueMax),
    quantity("speed_max", Dimension::AngularVelocity, Range::Positive, About::ActuatorSpeedMax),
    quantity("speed_motor_max", Dimension::AngularVelocity, Range::Positive, About::ActuatorSpeedMotorMax),
    quantity("speed_motor_rated", Dimension::AngularVelocity, Range::Positive, About::ActuatorSpeedMotorRated),
    quantity("inertia_out", Dimension::MomentOfInertia, Range::NotNegative, About::ActuatorInertiaOut),
    quantity("stall_torque", Dimension::Torque, Range::Positive, About::ActuatorStallTorque),
    quantity("stall_current", Dimension::Current, Range::Positive, About::ActuatorStallCurrent),
    quantity("current_max", Dimension::Current, Range::Positive, About::ActuatorCurrentMax),
    quantity("current_demagnetisation", Dimension::Current, Range::Positive, About::ActuatorCurrentDemagnetisation),
    quantity("no_load_starting_current", Dimension::Current, Range::NotNegative, About::ActuatorNoLoadStartingCurrent),
    quantity("no_load_current_constant_30", Dimension::NoLoadCurrentConstant, Range::NotNegative, About::ActuatorNoLoadCurrentConstant30),
    quantity("no_load_current_constant_80", Dimension::NoLoadCurrentConstant, Range::NotNegative, About::ActuatorNoLoadCurrentConstant80),
    quantity("torque_constant_out", Dimension::TorqueConstant, Range::Positive, About::ActuatorTorqueConstantOut),
    quantity("torque_constant_motor", Dimension::TorqueConstant, Range::Positive, About::ActuatorTorqueConstantMotor),
    quantity("voltage_constant_motor", Dimension::VoltageConstant, Range::Positive, About::ActuatorVoltageConstantMotor),
    quantity("resistance_ll", Dimension::Resistance, Range::Positive, About::ActuatorResistanceLl),
    quantity("winding_temperature_max", Dimension::Temperature, Range::Any, About::ActuatorWindingTemperatureMax),
    quantity("inductance_ll", Dimension::Inductance, Range::Positive, About::ActuatorInductanceLl),
    key("pole_pairs", Kind::Integer(1, 100), false, About::ActuatorPolePairs),
    quantity("mass", Dimension::Mass, Range::Positive, About::ActuatorMass),
    quantity("length", Dimension::Length, Range::Positive, About::ActuatorLength),
    quantity("hollow_shaft", Dimension::Length, Range::NotNegative, About::ActuatorHollowShaft),
    quantity("dc_link_max", Dimension::Voltage, Range::Positive, About::ActuatorDcLinkMax),
    quantity("terminal_voltage_min", Dimension::Voltage, Range::Positive, About::ActuatorTerminalVoltageMin),
    key("short_time_curve", Kind::Rows(&[Dimension::AngularVelocity, Dimension::Torque]), false, About::ActuatorShortTimeCurve),
    key("continuous_curve", Kind::Rows(&[Dimension::AngularVelocity, Dimension::Torque]), false, About::ActuatorContinuousCurve),
];

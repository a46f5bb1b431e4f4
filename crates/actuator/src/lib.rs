//! Physics of one actuator, computed from parameter structs: the same code serves catalogue, user-defined and measured
//! actuators. All quantities refer to the output unless a name includes `motor`.

mod accuracy;
mod agreement;
mod battery;
mod brake;
mod copper;
mod curve;
mod environment;
mod error_budget;
mod feedback;
mod friction;
mod gear;
mod heat;
mod heat_model;
mod instant;
mod link;
mod motor;
mod output_bearing;
mod overload;
mod parameters;
mod plane;
mod screw_joint;
mod temperature;
mod voltage;

pub use accuracy::Accuracy;
pub use agreement::{PublishedDuty, published_duty};
pub use battery::{Battery, BatteryFault, BatteryLife};
pub use brake::{Brake, EmergencyStop, StopOutcome, coil_power, emergency_stop, sag_angle};
pub use copper::copper_resistance;
pub use curve::{Curve, CurveFault, CurvePoint};
pub use environment::{Environment, Protection};
pub use error_budget::{BudgetCase, Contribution, ErrorBudget, ErrorKind, PositionLoop, deviation_at, error_budget};
pub use feedback::{Feedback, FeedbackSide};
pub use friction::{FrictionAt, NoLoadFriction};
pub use gear::{
    Gear, LifeLaw, Torsion, collision_count_max, cubic_mean_torque, driven_share, natural_frequency,
    natural_frequency_free, resonance_speed,
};
pub use heat::Heat;
pub use heat_model::{HeatModel, LossMeans, Settled};
pub use instant::{LossLaw, MotorCurrent, OperatingPoint, TerminalPower};
pub use link::chopper_thresholds;
pub use motor::{
    ContinuousLimit, continuous_torque, continuous_torque_with, estimated_continuous_torque, explain_friction,
    explain_stall_loss, speed_max, speed_max_with, speed_rated_out, speed_rated_out_with,
};
pub use output_bearing::{
    BearingType, FlangeLoad, OutputBearing, bearing_life, dynamic_equivalent_load, dynamic_load_factors, mean_load,
    static_equivalent_moment, static_safety, tilt_angle, tilting_moment,
};
pub use overload::{overload_course, overload_slope};
pub use parameters::{Drivetrain, Parameters};
pub use plane::{CurveKind, PerformanceCurve, ShortTime, intermittent_torque, performance_curves};
pub use screw_joint::{JointLoad, LoadedJoint, ScrewJoint, clamp_force, joint_utilisation, loaded_joint};
pub use temperature::{Gains, HeatFlows, Losses, Network, Temperatures};
pub use voltage::MotorVoltage;

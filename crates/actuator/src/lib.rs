//! The physics of one actuator, from parameter structs: a printed actuator, a user's own and a measured one run
//! the same code. Everything is referred to the output unless a name says `motor`.

mod curve;
mod gear;
mod motor;
mod output_bearing;
mod parameters;
mod voltage;

pub use curve::{Curve, CurveFault, CurvePoint};
pub use gear::{Gear, Torsion, cubic_mean_torque, natural_frequency, wave_generator_life};
pub use motor::{
    ContinuousLimit, FRICTION_LOSS_SHARE, WINDING_TEMPERATURE_CONTINUOUS, WINDING_TIME_CONSTANT, continuous_torque,
    copper_resistance, current, estimated_continuous_torque, friction_current, speed_max, speed_rated_out,
};
pub use output_bearing::{
    BearingType, FlangeLoad, OutputBearing, bearing_life, dynamic_equivalent_load, mean_load, static_safety,
    tilt_angle, tilting_moment,
};
pub use parameters::Parameters;
pub use voltage::MotorVoltage;

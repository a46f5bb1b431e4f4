//! Requirements on the actuator that a project states beside its load.

use actuator::Protection;
use quantities::{Acceleration, Angle, ElectricCurrent, ElectricPotential, Frequency, Length, Power, Time, Torque};

/// Requirements of the project on the actuator in addition to the load; without a limit a value is shown and not
/// judged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AxisRequirements {
    /// Required life of the gear.
    pub gear_life_min: Option<Time>,
    /// Permissible torsion of the gear.
    pub torsion_max: Option<Angle>,
    /// Required first natural frequency.
    pub natural_frequency_min: Option<Frequency>,
    /// Permissible sum of all angular errors at the output.
    pub angle_error_max: Option<Angle>,
    /// Distance from the axis at which an error is evaluated.
    pub lever_arm: Option<Length>,
    /// Permissible deviation at that distance.
    pub deviation_max: Option<Length>,
    /// Permissible angle of a stop by the brake alone.
    pub stop_angle_max: Option<Angle>,
    /// Number of stops by the brake alone over the life of the axis.
    pub emergency_stops: Option<f64>,
    /// Factor between the required holding torque of the brake and the load.
    pub holding_safety: Option<f64>,
    /// Operating time of the axis over its life.
    pub service_life: Option<Time>,
    /// Mean power that the supply or a braking resistor can take.
    pub regeneration_power_max: Option<Power>,
    /// The position must be absolute over the whole travel.
    pub absolute: Option<bool>,
    /// Largest step of the position at the output.
    pub resolution_max: Option<Angle>,
    /// Operation per day, for the battery.
    pub operation_per_day: Option<Time>,
    /// Storage before operation, for the battery.
    pub storage: Option<Time>,
    /// Required life of the battery.
    pub battery_life_min: Option<Time>,
    /// Largest torque of a collision.
    pub collision_torque: Option<Torque>,
    /// Duration of a collision.
    pub collision_time: Option<Time>,
    /// Number of collisions over the life of the axis.
    pub collisions: Option<f64>,
    /// The position loop is closed over the encoder at the output.
    pub loop_at_output: bool,
    /// Permissible rise of the DC link voltage at a capacitor bank.
    pub dc_link_rise: Option<ElectricPotential>,
    /// Altitude of the place of installation above sea level.
    pub altitude: Option<Length>,
    /// Share of the continuous torque that is left at that altitude, as its user states it.
    pub altitude_derating: Option<f64>,
    /// Degree of protection required.
    pub protection: Option<Protection>,
    /// Least relative humidity of the place.
    pub humidity_min: Option<f64>,
    /// Largest relative humidity of the place.
    pub humidity_max: Option<f64>,
    /// Vibration at the place.
    pub vibration: Option<Acceleration>,
    /// Largest shock at the place.
    pub shock: Option<Acceleration>,
    /// Mounting position.
    pub mounting: Option<MountingPosition>,
    /// Field of application that needs the manufacturer's approval.
    pub special_application: Option<SpecialApplication>,
    /// Continuous current of the drive, rms of a phase.
    pub drive_current_continuous: Option<ElectricCurrent>,
    /// Peak current of the drive, rms of a phase.
    pub drive_current_peak: Option<ElectricCurrent>,
    /// Time for which the drive can exceed its continuous current.
    pub drive_peak_time: Option<Time>,
}

/// Fields of application that need a risk assessment and the manufacturer's approval.
///
/// # Source
/// cha-manual section 2.4
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum SpecialApplication {
    Aerospace,
    ExplosiveAtmosphere,
    Nuclear,
    Vacuum,
    Household,
    Medical,
    HumanContact,
    LiftingOfPersons,
    Amusement,
}

/// Position in which an actuator is mounted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MountingPosition {
    /// The axis of rotation is horizontal.
    Horizontal,
    /// The axis of rotation is vertical, the output flange on top.
    FlangeUp,
    /// The axis of rotation is vertical, the output flange at the bottom.
    FlangeDown,
    /// The position changes in operation, as in a robot.
    Changing,
}

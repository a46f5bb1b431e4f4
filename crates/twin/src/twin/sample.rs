//! Samples of a run: setpoint, state and supervised quantities at one instant.

use super::Twin;
use crate::control::Demand;
use crate::drive::Phase;
use crate::plant::Variables;
use quantities::Measure;

/// One instant of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Time \[s\].
    pub time_s: f64,
    /// Position setpoint \[rad\].
    pub wanted_rad: f64,
    /// Speed of the setpoint [rad/s].
    pub wanted_rad_s: f64,
    /// Position of the load \[rad\].
    pub position_rad: f64,
    /// Speed of the load [rad/s].
    pub speed_rad_s: f64,
    /// Acceleration of the load [rad/s²].
    pub acceleration_rad_s2: f64,
    /// Position read by the drive \[rad\], equal to that of the load at the start.
    pub measured_rad: f64,
    /// Motor angle over i \[rad\].
    pub motor_rad: f64,
    /// Motor speed over i [rad/s].
    pub motor_rad_s: f64,
    /// Torque through the gear \[Nm\].
    pub torque_nm: f64,
    /// i_q \[A\], peak of a phase.
    pub current_q_a: f64,
    /// i_d \[A\].
    pub current_d_a: f64,
    /// u_q \[V\], peak of a phase.
    pub voltage_q_v: f64,
    /// u_d \[V\].
    pub voltage_d_v: f64,
    /// DC link voltage at the lowest voltage of the supply \[V\].
    pub link_v: f64,
    /// DC link voltage at the highest voltage of the supply \[V\].
    pub link_high_v: f64,
    /// Winding temperature \[K\].
    pub winding_k: f64,
    /// Housing temperature \[K\].
    pub housing_k: f64,
    /// Temperature of the winding's KTY \[K\]; `None` if no connector has contacts for it.
    pub sensor_k: Option<f64>,
    /// State of the overload supervision \[1\]; it trips above one.
    pub overload: f64,
    /// Following error at the load \[rad\].
    pub following_rad: f64,
    /// The brake is closed.
    pub braked: bool,
}

impl Twin<'_> {
    /// Returns the setpoint at this instant, which may be between two periods of the position loop.
    fn wanted(&self) -> [f64; 3] {
        match self.phase {
            Phase::Running | Phase::Resting => self.course.at(self.time_s()).state,
            Phase::Commanded(Demand::Speed(speed)) => [self.state.x.load_rad, speed, 0.0],
            // Commands of a caller, and the setpoint after a stop, hold until they are changed.
            Phase::Commanded(Demand::Position(_)) | Phase::Ramp(_) | Phase::Holding(_) | Phase::Off => self.point.state,
        }
    }

    /// Returns the temperature of the winding that a drive can read \[K\].
    pub(super) fn sensor_seen_k(&self) -> Option<f64> {
        (!self.setup.parameters.actuator.without_kty).then_some(self.sensor_k)
    }

    /// Returns the present state.
    #[must_use]
    pub fn sample(&self) -> Sample {
        let Variables { current_d, current_q, motor_rad, motor_rad_s, load_rad, load_rad_s } = self.state.x;
        let [wanted, wanted_speed, _] = self.wanted();
        let [u_d, u_q] = self.voltage;
        Sample {
            time_s: self.time_s(),
            wanted_rad: wanted,
            wanted_rad_s: wanted_speed,
            position_rad: load_rad,
            speed_rad_s: load_rad_s,
            acceleration_rad_s2: self.state.acceleration_rad_s2,
            measured_rad: self.measured_rad(),
            motor_rad,
            motor_rad_s,
            torque_nm: self.state.gear_nm,
            current_q_a: current_q,
            current_d_a: current_d,
            voltage_q_v: u_q,
            voltage_d_v: u_d,
            link_v: self.link.voltage_v,
            link_high_v: self.highest_link().voltage_v,
            winding_k: self.temperatures.winding.si(),
            housing_k: self.temperatures.housing.si(),
            sensor_k: self.sensor_seen_k(),
            overload: self.overload,
            following_rad: wanted - load_rad,
            braked: self.brake.closed,
        }
    }
}

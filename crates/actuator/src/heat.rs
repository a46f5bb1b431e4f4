//! Calibration of the heat model.

use provenance::Datum;
use quantities::{ThermodynamicTemperature, Time};

/// Calibration of the family's heat model; another manufacturer's actuator has none unless the user states it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Heat {
    /// w = R_ha/(R_wh + R_ha): share of the thermal resistance between housing and air \[1\].
    pub housing_share: Datum<f64>,
    /// F: permitted loss of the winding at standstill, relative to that at the largest I_0 of the drive \[1\]; above
    /// one if the gear limits T_0 at every ratio.
    pub stall_loss_factor: Datum<f64>,
    /// Edges of the band of the permitted loss, as multiples of it \[1\].
    pub loss_band: Datum<(f64, f64)>,
    /// Cycle of the intermittent duty to which the S3 curves apply.
    pub intermittent_cycle: Datum<Time>,
    /// Upper edge of the band in intermittent duty \[1\].
    pub intermittent_band_high: Datum<f64>,
    /// Half width of the band about the gear's limit in intermittent duty, relative to it \[1\].
    pub gear_band: Datum<f64>,
    /// Ambient temperature up to which the data of the actuator apply, including the stall torque.
    pub ambient_reference: Datum<ThermodynamicTemperature>,
    /// Winding temperature of continuous duty, at which the supervision warns.
    pub winding_warning: Datum<ThermodynamicTemperature>,
    /// Winding temperature at which the supervision shuts down: the highest in operation.
    pub winding_shutdown: Datum<ThermodynamicTemperature>,
    /// τ_w = R_wh C_w: time constant of the winding.
    pub winding_time_constant: Datum<Time>,
    /// τ_h = R_ha C_h: time constant of the housing.
    pub housing_time_constant: Datum<Time>,
}

//! Parameters of the motor: current as a function of torque, friction and rotor acceleration.

use super::regression::{Prior, Row, fit};
use super::windows::{Window, Windows};
use super::{Estimate, Identification, Identified, Open};
use crate::gear::Spring;
use crate::machine::Machine;
use crate::{Parameters, Switches};
use std::f64::consts::SQRT_2;

/// Constants of the actuator at the output, from the tables.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tabulated {
    /// J_M: inertia of the rotor \[kgm²\].
    pub(super) rotor_kgm2: f64,
    /// i k_TM: torque constant of the motor [Nm/A].
    pub(super) motor_nm_a: f64,
    /// k_Tout without the no-load friction [Nm/A].
    pub(super) output_nm_a: f64,
    /// i: reduction ratio \[1\].
    pub(super) ratio: f64,
    /// Torsion of the gear.
    spring: Spring,
}

impl Tabulated {
    /// Returns the constants, if the tables have all of them.
    pub(super) fn of(parameters: &Parameters) -> Option<Self> {
        let machine = Machine::of(parameters, Switches::default(), 0).ok()?;
        let motor_nm_a = SQRT_2 * machine.plant.torque_constant;
        Some(Self {
            rotor_kgm2: machine.plant.inertia_kgm2,
            motor_nm_a,
            output_nm_a: motor_nm_a / (1.0 + machine.plant.mesh),
            ratio: machine.ratio,
            spring: machine.plant.spring,
        })
    }
}

/// Relative standard deviation of J_M from the tables: rounding and the share of the flange. A guess.
const ROTOR_SPREAD: f64 = 0.02;

/// Standard deviation of c relative to that of J_M if the current may be sampled in step with the control \[1\].
///
/// The setpoint of the current changes with each period of the speed loop by a part of J_M α; samples at a fixed phase
/// of this period differ from the mean current. Rows every 0.5 ms or 1 ms of the twin yield c smaller by 10.5 %, rows
/// every 62.5 µs or 312.5 µs by less than 0.1 %.
const SAMPLED_SPREAD: f64 = 0.1;

/// Sampling interval below which a period of the speed loop has several samples \[s\].
const RESOLVED_S: f64 = 2e-4;

/// Smallest relative half interval: over a run of some seconds the temperature changes friction by as much. A choice;
/// the friction of the twin changes by 0.4 % within a run of ten seconds.
const CONSTANT: f64 = 0.005;

/// Smallest number of equations of the motor.
const LEAST: usize = 12;

/// Share of the squares of the driven torque above which its own coefficient is estimated.
const DRIVEN: f64 = 0.05;

/// Share of the sampling interval above which a lag of the motor speed counts, and the smallest lag that does \[s\].
const LAG: f64 = 0.25;
const LAG_LEAST_S: f64 = 1e-4;

/// Returns the lag of the motor speed behind the position of the load \[s\]: the difference of two samples lags by half
/// their distance, the filter of a drive by its time constant.
///
/// τ = −Σ (Ω − ω − T'/K) α/Σ α²
///
/// # Symbols
/// T' rate of the torque through the gear \[Nm/s\], K its stiffness from the tables [Nm/rad]
fn lag_s(windows: &Windows, spring: Option<&Spring>) -> f64 {
    let [product, square] = windows.all.iter().fold([0.0; 2], |[product, square], window| {
        let compliance = spring.map_or(0.0, |spring| spring.stiffness_at(spring.angle(window.torque)).recip());
        let behind = window.speed + window.torque_rate * compliance - window.motor_speed;
        [product + behind * window.acceleration, square + window.acceleration * window.acceleration]
    });
    let lag = product / square;
    if lag.abs() > (LAG * windows.step_s).max(LAG_LEAST_S) { lag } else { 0.0 }
}

/// Estimates the parameters of the motor.
///
/// I = a T₊ + d T₋ + I_NLS σ + K Ω + c Ω', k_Tout = 1/a, c = J_M (a + d)/2
///
/// # Symbols
/// T₊ torque while it drives the load, T₋ while the load drives, c coefficient of the rotor acceleration
/// # Source
/// docs/theory/twin.md, *Identification*: the losses of the teeth are equal in both directions, so that (a + d)/2 =
/// 1/(i k_TM)
/// # Valid
/// J_M from the tables with a standard deviation of [`ROTOR_SPREAD`], or of [`SAMPLED_SPREAD`]: for a flywheel T is
/// proportional to Ω' except for friction, and the run alone does not separate k_Tout from J_M
pub(super) fn estimate(windows: &Windows, parameters: &Parameters, found: &mut Identification) {
    let of = [Identified::TorqueConstant, Identified::StartingCurrent, Identified::CurrentConstant];
    let free: Vec<&Window> = windows.all.iter().filter(|window| !window.limited).collect();
    let tabulated = Tabulated::of(parameters);
    found.tabulated_nm_a = tabulated.map(|tabulated| tabulated.output_nm_a);
    if free.len() < LEAST {
        found.open.extend(of.map(|of| (of, Open::AtLimit)));
        return;
    }
    let squares = |part: fn(&Window) -> f64| free.iter().map(|window| part(window).powi(2)).sum::<f64>();
    let (driving, driven) = (squares(|window| window.driving), squares(|window| window.torque - window.driving));
    let is_driven = driven > DRIVEN * driving;
    let lag = lag_s(windows, tabulated.as_ref().map(|tabulated| &tabulated.spring));
    found.motor_lag_s = lag;
    let row = |window: &&Window| {
        let speed = window.motor_speed + lag * window.motor_acceleration;
        let acceleration = window.motor_acceleration + lag * window.motor_jerk;
        let mut regressors = vec![window.driving, window.sign, speed, acceleration];
        let mut value = window.current;
        let rest = window.torque - window.driving;
        if is_driven {
            regressors.push(rest);
        } else if let Some(tabulated) = tabulated {
            // Insufficient for an estimate: the losses of the tables are used.
            value -= rest * (2.0 / tabulated.motor_nm_a - 1.0 / tabulated.output_nm_a);
        }
        Row { regressors, value, stroke: window.stroke }
    };
    let rows: Vec<Row> = free.iter().map(row).collect();
    let width = rows.first().map_or(0, |row| row.regressors.len());
    let spread = if windows.step_s < RESOLVED_S { ROTOR_SPREAD } else { ROTOR_SPREAD.hypot(SAMPLED_SPREAD) };
    let prior = tabulated.map(|tabulated| {
        let Tabulated { rotor_kgm2, motor_nm_a, output_nm_a, .. } = tabulated;
        found.rotor = Some([rotor_kgm2, spread]);
        let mut factors = vec![0.0; width];
        if let Some(cell) = factors.get_mut(3) {
            *cell = -1.0;
        }
        let shares = if is_driven { [0.5, 0.5] } else { [output_nm_a / motor_nm_a, 0.0] };
        for (place, share) in [0, 4].into_iter().zip(shares) {
            if let Some(cell) = factors.get_mut(place) {
                *cell = rotor_kgm2 * share;
            }
        }
        Prior { factors, spread: spread * rotor_kgm2 / motor_nm_a }
    });
    let Some(fit) = fit(&rows, &[], prior.as_ref()) else {
        found.open.extend(of.map(|of| (of, Open::NotSeparated)));
        return;
    };
    let [of_torque, of_start, of_speed] = of;
    match fit.estimate(0) {
        Some((slope, half)) if half < super::SHARE_MOST * slope.abs() => {
            let value = 1.0 / slope;
            let half_width = (half / (slope * slope)).max(CONSTANT * value.abs());
            found.estimates.push(Estimate { of: of_torque, value, half_width });
        }
        _ => found.open.push((of_torque, Open::Wide)),
    }
    for (of, place) in [(of_start, 1), (of_speed, 2)] {
        match fit.estimate(place) {
            Some((value, half_width)) if fit.separates(place) => {
                found.estimates.push(Estimate { of, value, half_width: half_width.max(CONSTANT * value.abs()) });
            }
            _ => found.open.push((of, Open::NotSeparated)),
        }
    }
}

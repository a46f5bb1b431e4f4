//! Initial conditions of a run, and the instant of its event.

use super::{PERIOD_S, SLOW_EVERY, Slow, Twin};
use crate::control::{Control, Steady};
use crate::drive::Phase;
use crate::gear::{Anchor, ELEMENTS};
use crate::plant::{Energies, Sliding, State, Variables};
use crate::scenario::{EventKind, ScenarioId};
use crate::setpoint::{Course, SetPoint};
use crate::setup::{Fault, Setup};
use crate::summary::Gathered;
use quantities::{ElectricPotential, Measure};

/// Returns the ambient temperature of a scenario \[K\].
pub(super) fn ambient(setup: &Setup<'_>) -> f64 {
    let range = setup.parameters.actuator.ambient_range.known().map(|known| known.value);
    match (setup.scenario.id, range) {
        (ScenarioId::HotAmbient, Some((_, warmest))) => warmest.si().max(setup.ambient_k),
        (ScenarioId::ColdGrease, Some((coldest, _))) => coldest.si().min(setup.ambient_k),
        _ => setup.ambient_k,
    }
}

/// Returns the DC link voltage at which the drive switches off \[V\]: U_DCmax if a braking resistor can keep the link
/// below it.
///
/// Otherwise U_DCmax is exceeded while braking, which the manual permits for a short time (glossary), and the drive
/// protects only itself: at a quarter above its supply, chosen by antrieb.
pub(super) fn link_most(setup: &Setup<'_>) -> f64 {
    let most = ElectricPotential::from_si(setup.supply.most_v);
    let limit = setup.parameters.actuator.dc_link_max.known().map(|known| known.value);
    match (limit, actuator::chopper_thresholds(most, limit)) {
        (Some(limit), Some(_)) => limit.si(),
        _ => 1.25 * setup.supply.most_v,
    }
}

/// Returns the instant of the scenario's event \[s\]; if none is stated, the one that needs no run: the highest speed, or
/// the first standstill. A run takes that of [`worst_instant`](super::worst_instant).
pub(super) fn happens(setup: &Setup<'_>, course: &Course<'_>) -> Result<Option<f64>, Fault> {
    let standard = match setup.scenario.id {
        ScenarioId::Cycle
        | ScenarioId::BrakeStuck
        | ScenarioId::BatteryLoss
        | ScenarioId::HotAmbient
        | ScenarioId::ColdGrease => return Ok(None),
        ScenarioId::HangingLoad => course.rest_s(),
        ScenarioId::EmergencyStop
        | ScenarioId::PowerFailure
        | ScenarioId::BlockedLoad
        | ScenarioId::EncoderFailure
        | ScenarioId::LinkSag
        | ScenarioId::Collision => course.fastest_s(),
    };
    let at = setup.scenario.at_s.unwrap_or(standard);
    if !at.is_finite() || at < 0.0 {
        return Err(Fault::OutOfRange("at"));
    }
    let end_s = course.duration_s();
    if at >= end_s {
        return Err(Fault::AfterTheEnd { end_s });
    }
    let speed = course.at(at).state[1].abs();
    match setup.scenario.id {
        ScenarioId::HangingLoad if speed > 1e-9 => Err(Fault::NotAtRest),
        ScenarioId::Collision if speed < 1e-9 => Err(Fault::AtRest),
        _ => Ok(Some(at)),
    }
}

/// Duration of the run-up over the sum of the time constants of load and control \[1\], and its limits \[s\]. A choice:
/// transients of the first state decay to e⁻⁶, with heavy loads on soft gears to less.
const RUN_UP: f64 = 6.0;
const RUN_UP_S: [f64; 2] = [0.1, RUN_UP_MOST_S];
pub(super) const RUN_UP_MOST_S: f64 = 2.0;

impl Twin<'_> {
    /// Brings an axis whose cycle begins in motion into the state of its first instant: a run-up before the time 0 that
    /// counts nowhere.
    ///
    /// The run-up begins in the quasi-steady state of its setpoint and lasts 6 (2 J_L/D + 1/K_v + T_n), so that
    /// oscillation and hysteresis of the gear, integrals, current and DC link are those of the motion. Temperatures and
    /// overload supervision remain as at the start. If the drive faults during the run-up, the run begins in the
    /// quasi-steady state at the time 0 and shows the fault.
    pub(super) fn run_up(&mut self) {
        let rested = self.clone();
        let gains = self.control.gains;
        let slowest =
            2.0 * self.local.inertia_kgm2 / self.plant.damping_nms + 1.0 / gains.position_p + gains.speed_time_s;
        let [least, most] = RUN_UP_S;
        let wanted_s = if slowest.is_finite() { (RUN_UP * slowest).clamp(least, most) } else { most };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most two seconds")]
        let periods = (wanted_s / PERIOD_S) as u64 / SLOW_EVERY * SLOW_EVERY;
        self.run_up = periods;
        self.end_tick = periods;
        self.heat_trips = false;
        self.set_in_motion(&self.course.at(self.time_s()));
        self.advance(periods);
        let runs = self.phase == Phase::Running && self.state.pulses && !self.has(EventKind::Diverged);
        if !runs {
            *self = rested;
            self.set_in_motion(&self.course.at(0.0));
        } else {
            (self.tick, self.run_up, self.end_tick) = (0, 0, rested.end_tick);
            self.heat_trips = rested.heat_trips;
            (self.temperatures, self.sensor_k, self.ptc_k) = (rested.temperatures, rested.sensor_k, rested.ptc_k);
            (self.overload, self.slow, self.coil_j) = (0.0, Slow::default(), 0.0);
            self.machine.warm(&mut self.plant, self.temperatures.winding.si(), self.temperatures.housing.si());
            self.gathered = Gathered::new(self.setup.settled_rad);
            self.events.clear();
            self.brake.closings = [0; 2];
            self.state.energies = Energies::default();
            self.state.slipped_rad = 0.0;
            self.control.limited = false;
            let high = self.link_high.as_mut().map(|(_, link)| link);
            for link in std::iter::once(&mut self.link).chain(high) {
                link.forget();
            }
            self.point = self.course.at(0.0);
        }
        self.stored_at_start_j = self.plant.stored(&self.state);
    }

    /// Sets the state of a setpoint in motion: load and motor at its speed, gear, current and integrals in balance with
    /// load, friction and acceleration.
    fn set_in_motion(&mut self, point: &SetPoint) {
        let [wanted, speed, acceleration] = point.state;
        let Some(local) = self.load.linearised(point.segment, wanted, speed, acceleration) else { return };
        let gains = self.control.gains;
        let direction = if speed == 0.0 { 0.0 } else { speed.signum() };
        let gear_nm = local.inertia_kgm2 * acceleration + local.torque(wanted, speed) + local.coulomb_nm * direction;
        let twist = self.plant.spring.angle(gear_nm);
        // Without a complete feedforward of the speed the axis lags.
        let lag = if gains.position_p > 0.0 { (1.0 - gains.feed_speed) * speed / gains.position_p } else { 0.0 };
        let error = |theta: f64| self.plant.kinematic.map_or(0.0, |error| error.at(theta));
        let controlled = wanted + self.offset_rad - lag;
        let (theta, position) = if self.setup.loop_at_output {
            // e depends weakly on the angle itself: a few iterations suffice.
            let theta = (0..6).fold(controlled + twist, |theta, _| controlled + twist + error(theta));
            (theta, controlled)
        } else {
            (controlled, controlled - twist - error(controlled))
        };
        let plant = &self.plant;
        let rubbed = plant.friction_nm + plant.viscous_nms * speed.abs() + plant.mesh * gear_nm.abs();
        let torque_nm = plant.inertia_kgm2 * acceleration + gear_nm + rubbed * direction;
        let free = |held: f64| if held > 0.0 { direction } else { 1.0 };
        self.state = State {
            x: Variables {
                current_d: 0.0,
                current_q: torque_nm / plant.torque_constant,
                motor_rad: theta,
                motor_rad_s: speed,
                load_rad: position,
                load_rad_s: speed,
            },
            force: [0.0; ELEMENTS],
            sliding: Sliding { motor: free(plant.friction_nm + plant.mesh), load: free(local.coulomb_nm) },
            energies: Energies::default(),
            slipped_rad: 0.0,
            turning: 0.0,
            pull: 0.0,
            gear_nm,
            twist_rad: 0.0,
            acceleration_rad_s2: acceleration,
            pulses: true,
        };
        self.plant.place(&mut self.state);
        self.anchor = self.plant.kinematic.map_or(Anchor::none(), |error| error.anchor(theta));
        self.local = local;
        self.point = *point;
        self.phase = Phase::Running;
        let feed_nm = gains.feed_inertia * acceleration;
        let steady = Steady { angle_rad: self.angle(), speed, torque_nm, feed_nm };
        self.control = Control::steady(gains, &self.plant, self.setup.switches.delay, &steady);
    }
}

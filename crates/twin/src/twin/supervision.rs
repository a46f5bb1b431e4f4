//! Temperatures and supervision of the drive, once a millisecond.

use super::{PERIOD_S, SAG, SLOW_EVERY, Twin};
use crate::drive::Phase;
use crate::plant::Variables;
use crate::scenario::{EventKind, Reaction, ScenarioId};
use actuator::{Losses, Temperatures, overload_slope};
use numeric::{at_least, at_most};
use provenance::Datum;
use quantities::{ElectricCurrent, Measure, Ratio, ThermodynamicTemperature, Time};

impl Twin<'_> {
    /// Updates temperatures, temperature-dependent constants and supervision, once a millisecond.
    pub(super) fn supervise(&mut self) {
        #[allow(clippy::cast_precision_loss, reason = "sixteen")]
        let step = SLOW_EVERY as f64 * PERIOD_S;
        let mut slow = std::mem::take(&mut self.slow);
        let coil = self.machine.brake.filter(|_| !self.brake.closed).map_or(0.0, |brake| brake.coil_w * step);
        slow.heat_j += coil;
        self.coil_j += coil;
        if let Some(heat) = self.machine.heat {
            self.temperatures =
                warmed(&self.temperatures, &heat, slow.copper_j / step, slow.heat_j / step, self.ambient_k, step);
            let (winding, housing) = (self.temperatures.winding.si(), self.temperatures.housing.si());
            self.machine.warm(&mut self.plant, winding, housing);
            let model = &self.setup.parameters.model;
            self.sensor_k += (winding - self.sensor_k) * step / model.sensor_lag.value.max(step);
            self.ptc_k += (winding - self.ptc_k) * step / model.ptc_lag.value.max(step);
            if let Some(stall) = self.machine.stall_current_a {
                let current = ElectricCurrent::from_si((slow.square_a2_s / step).sqrt());
                let slope = |state: f64| {
                    let time_constant: Time = heat.winding_time_constant();
                    overload_slope(Ratio::from_si(state), current, ElectricCurrent::from_si(stall), time_constant)
                };
                // Heun's method, as for the temperatures.
                let first = slope(self.overload);
                self.overload += 0.5 * step * (first + slope(self.overload + step * first));
            }
            self.gathered.warm(winding, housing, self.overload);
        }
        if self.highest_link().chopping {
            self.note(EventKind::BrakeResistor);
        }
        let Variables { current_d, current_q, .. } = self.state.x;
        let current = (0.5 * (current_d * current_d + current_q * current_q)).sqrt();
        if self.machine.demagnetisation_a.is_some_and(|limit| !at_most(current, limit))
            && !self.has(EventKind::Demagnetisation)
        {
            self.note(EventKind::Demagnetisation);
        }
        let collision = self.setup.parameters.actuator.gear.collision_torque_max.known();
        if collision.is_some_and(|limit| !at_most(self.gathered.torque_nm(), limit.value.si()))
            && !self.has(EventKind::CollisionTorque)
        {
            self.note(EventKind::CollisionTorque);
        }
        if !self.state.x.are_finite()
            || self.state.x.motor_rad_s.abs() > 20.0 * self.machine.speed_max
            || self.state.twist_rad.abs() > 1.0
        {
            self.note(EventKind::Diverged);
            self.end_tick = self.tick;
        }
        self.notice();
    }

    /// Evaluates the limits that the drive itself supervises.
    pub(super) fn notice(&mut self) {
        let time = self.time_s();
        if let Some(commanded) = &mut self.commanded {
            commanded.present.clear();
        }
        if self.setup.scenario.id == ScenarioId::LinkSag && self.happens_s.is_some_and(|at| time > at + SAG.1) {
            self.supply_share = 1.0;
        }
        let actuator = &self.setup.parameters.actuator;
        let (heat, is_read) = (&actuator.heat, !actuator.without_kty);
        let passed = |limit: &Datum<ThermodynamicTemperature>, sensor_k: f64| {
            limit.known().is_some_and(|limit| !at_most(sensor_k, limit.value.si()))
        };
        let warns = is_read && passed(&heat.winding_warning, self.sensor_k);
        let shuts_down = is_read && passed(&heat.winding_shutdown, self.sensor_k);
        let responds = passed(&actuator.ptc_response, self.ptc_k);
        if warns {
            self.note(EventKind::WindingWarning);
        }
        self.no_position();
        if !self.setup.switches.limits {
            return;
        }
        let reaction = self.limits.reaction;
        if shuts_down && self.heat_trips {
            self.fault(EventKind::WindingShutdown, reaction);
        }
        if responds && self.heat_trips {
            self.fault(EventKind::PtcResponse, reaction);
        }
        if !at_most(self.overload, 1.0) && self.heat_trips {
            self.fault(EventKind::Overload, reaction);
        }
        if self.phase == Phase::Running
            && self.limits.following_rad.is_some_and(|limit| !at_most(self.control.following_rad.abs(), limit))
        {
            self.fault(EventKind::FollowingError, reaction);
        }
        let [low, high] = self.limits.link_v;
        let without_drive = if self.brake.exists() { Reaction::Brake } else { Reaction::Coast };
        if !at_least(self.link.voltage_v, low) && self.state.pulses {
            self.fault(EventKind::LinkLow, without_drive);
        }
        if !at_most(self.highest_link().voltage_v, high) {
            self.fault(EventKind::LinkHigh, without_drive);
        }
        if self.state.x.motor_rad_s.abs() > 1.1 * self.machine.speed_max {
            self.fault(EventKind::Overspeed, without_drive);
        }
    }
}

/// Returns the temperatures after one step under constant losses, by Heun's method.
pub(crate) fn warmed(
    from: &Temperatures,
    heat: &actuator::HeatModel,
    copper_w: f64,
    friction_w: f64,
    ambient_k: f64,
    step: f64,
) -> Temperatures {
    let (network, losses) = (heat.network(), Losses { copper_w, friction_w });
    let ambient = ThermodynamicTemperature::from_si(ambient_k);
    let moved = |winding: f64, housing: f64| Temperatures {
        winding: ThermodynamicTemperature::from_si(from.winding.si() + winding),
        housing: ThermodynamicTemperature::from_si(from.housing.si() + housing),
    };
    let first = network.flows(from, losses, ambient);
    let second = network.flows(&moved(step * first.winding_k_per_s, step * first.housing_k_per_s), losses, ambient);
    moved(
        0.5 * step * (first.winding_k_per_s + second.winding_k_per_s),
        0.5 * step * (first.housing_k_per_s + second.housing_k_per_s),
    )
}

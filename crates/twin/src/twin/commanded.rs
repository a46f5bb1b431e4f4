//! A run commanded by a caller: a drive outside of the twin provides setpoints, switches pulses and brake, and reacts
//! to the supervision.

use super::Twin;
use crate::control::Demand;
use crate::drive::{BrakeState, Phase};
use crate::plant::Variables;
use crate::scenario::{EventKind, ScenarioId};
use crate::setup::{Fault, SUBSTEPS_MOST, Setup};
use std::f64::consts::SQRT_2;

/// Commands of a caller, and the present findings of the supervision.
#[derive(Clone, Debug, Default)]
pub(crate) struct Commanded {
    /// Largest current, rms \[A\]; `None` for that of the actuator.
    pub(crate) current_most_a: Option<f64>,
    /// Limits exceeded, or signals missing, at present.
    pub(crate) present: Vec<EventKind>,
}

/// Measured values of a drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Time of the reading \[s\].
    pub time_s: f64,
    /// Position measured for the position loop, with the offset that makes it the load position at the start \[rad\].
    pub position_rad: f64,
    /// Measured speed [rad/s].
    pub speed_rad_s: f64,
    /// Torque-producing current, rms \[A\].
    pub current_a: f64,
    /// DC link voltage \[V\].
    pub link_v: f64,
    /// The DC link voltage suffices for pulses.
    pub link_ready: bool,
    /// Temperature of the winding's KTY \[K\]; `None` if no connector has contacts for it.
    pub sensor_k: Option<f64>,
    /// State of the overload supervision \[1\]; it trips above one.
    pub overload: f64,
    /// The brake is closed.
    pub braked: bool,
    /// The inverter is switching.
    pub pulses: bool,
    /// Current or voltage are at a limit.
    pub limited: bool,
}

impl<'a> Twin<'a> {
    /// Creates a run without end for commands of a caller: pulses off, brake closed, the load at the start of the
    /// motion. The step is shortened if the load or a stop are too stiff for the default one.
    ///
    /// # Errors
    /// See [`Twin::new`].
    pub fn commanded(setup: &Setup<'a>) -> Result<Self, Fault> {
        let mut setup = *setup;
        setup.scenario.id = ScenarioId::Cycle;
        let built = match Self::build(setup, Some(Commanded::default())) {
            Err(Fault::StepTooLong { substeps }) if substeps <= SUBSTEPS_MOST => {
                setup.substeps = substeps;
                Self::build(setup, Some(Commanded::default()))
            }
            other => other,
        };
        let mut twin = built?;
        twin.end_tick = u64::MAX;
        twin.phase = Phase::Off;
        twin.brake = BrakeState::new(twin.machine.brake, true, false);
        twin.plant.brake_nm = twin.brake.torque_nm();
        twin.plant.block(&mut twin.state);
        if twin.brake.exists() {
            twin.state.sliding.motor = 0.0;
        }
        Ok(twin)
    }

    /// Switches the pulses on if they are off, and holds the position.
    pub fn switch_on(&mut self) {
        if !self.state.pulses {
            self.restart();
        }
        let [position, ..] = self.point.state;
        self.point.state = [position, 0.0, 0.0];
        self.phase = Phase::Commanded(Demand::Position([self.measured_rad(), 0.0, 0.0]));
    }

    /// Commands the brake, if there is one.
    pub fn command_brake(&mut self, open: bool) {
        let time = self.time_s();
        self.brake.command(open, time);
    }

    /// Sets the setpoint; ignored without pulses.
    pub fn demand(&mut self, demand: Demand) {
        if let Phase::Commanded(_) = self.phase {
            self.phase = Phase::Commanded(demand);
        }
    }

    /// Sets the largest current, rms \[A\].
    pub fn limit_current(&mut self, most_a: f64) {
        if let Some(commanded) = &mut self.commanded {
            commanded.current_most_a = Some(most_a.max(0.0));
        }
    }

    /// Returns the limits exceeded, or signals missing, within the last millisecond.
    #[must_use]
    pub fn present(&self) -> &[EventKind] {
        self.commanded.as_ref().map_or(&[], |commanded| &commanded.present)
    }

    /// Replaces the disturbance of the axis. A scenario that is no disturbance ends the present one.
    pub fn disturb(&mut self, what: ScenarioId) {
        self.stop = None;
        self.supply_share = 1.0;
        self.encoder.failing = None;
        self.brake.stuck = false;
        match what {
            ScenarioId::BlockedLoad => self.stop = Some(self.stop_here(0.0)),
            ScenarioId::Collision => self.stop = Some(self.stop_here(self.state.x.load_rad_s.signum())),
            ScenarioId::EncoderFailure => self.fail(),
            ScenarioId::PowerFailure => self.supply_share = 0.0,
            ScenarioId::LinkSag => self.supply_share = super::SAG.0,
            ScenarioId::BrakeStuck => self.brake.stuck = true,
            ScenarioId::Cycle
            | ScenarioId::EmergencyStop
            | ScenarioId::HangingLoad
            | ScenarioId::BatteryLoss
            | ScenarioId::HotAmbient
            | ScenarioId::ColdGrease => {}
        }
        self.notice();
    }

    /// Returns the present measured values of a drive.
    #[must_use]
    pub fn reading(&self) -> Reading {
        let Variables { current_q, motor_rad_s, .. } = self.state.x;
        let pulses = self.state.pulses;
        Reading {
            time_s: self.time_s(),
            position_rad: self.measured_rad(),
            speed_rad_s: if pulses { self.control.speed } else { motor_rad_s },
            current_a: current_q / SQRT_2,
            link_v: self.link.voltage_v,
            link_ready: self.link.voltage_v >= self.limits.link_v[0],
            sensor_k: self.sensor_seen_k(),
            overload: self.overload,
            braked: self.brake.closed,
            pulses,
            limited: pulses && self.control.limited,
        }
    }

    pub(super) fn measured_rad(&self) -> f64 {
        self.position_seen(self.angle()) - self.offset_rad
    }

    /// Returns the largest output speed [rad/s] and the largest current, rms \[A\].
    #[must_use]
    pub const fn most(&self) -> [f64; 2] {
        [self.machine.speed_max, self.machine.current_max_a]
    }

    /// Returns `true` if the axis has a brake.
    #[must_use]
    pub const fn has_brake(&self) -> bool {
        self.brake.exists()
    }
}

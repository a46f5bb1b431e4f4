//! A run that a caller commands: a drive outside of the twin gives set-points, switches pulses and brake, and reacts to what is
//! supervised.

use super::Twin;
use crate::control::Demand;
use crate::drive::{BrakeState, Phase};
use crate::scenario::{EventKind, ScenarioId};
use crate::setup::{Fault, SUBSTEPS_MOST, Setup};
use std::f64::consts::SQRT_2;

/// What a caller commands, and what the supervision finds at the moment.
#[derive(Clone, Debug, Default)]
pub(crate) struct Commanded {
    /// Largest current \[A\], rms; without it that of the actuator.
    pub(crate) current_most_a: Option<f64>,
    /// What is exceeded or missing now.
    pub(crate) present: Vec<EventKind>,
}

/// What a drive measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// \[s\]
    pub time_s: f64,
    /// What the position loop looks at, from that of the start \[rad\], so that it is the position of the load there.
    pub position_rad: f64,
    /// Its speed [rad/s].
    pub speed_rad_s: f64,
    /// Current that makes torque \[A\], rms.
    pub current_a: f64,
    /// DC link \[V\].
    pub link_v: f64,
    /// Whether the DC link is high enough for pulses.
    pub link_ready: bool,
    /// Temperature that the KTY of the winding shows \[K\]; `None` where no connector leads it out.
    pub sensor_k: Option<f64>,
    /// State of the overload supervision; it trips above one.
    pub overload: f64,
    /// Whether the brake is closed.
    pub braked: bool,
    /// Whether the inverter switches.
    pub pulses: bool,
    /// Whether current or voltage are at a limit.
    pub limited: bool,
}

impl<'a> Twin<'a> {
    /// A run without an end that a caller commands: pulses off, brake closed, the load where the motion starts. Where the load or a
    /// stop are too stiff for the usual step, a shorter one is taken.
    ///
    /// # Errors
    /// As [`Twin::new`].
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
            twin.state.sliding[0] = 0.0;
        }
        Ok(twin)
    }

    /// Switches the pulses on and holds the position, where they are off.
    pub fn switch_on(&mut self) {
        if !self.state.pulses {
            self.restart();
        }
        let [position, ..] = self.point.state;
        self.point.state = [position, 0.0, 0.0];
        self.phase = Phase::Commanded(Demand::Position([self.measured_rad(), 0.0, 0.0]));
    }

    /// Commands the brake, where there is one.
    pub fn command_brake(&mut self, open: bool) {
        let time = self.time_s();
        self.brake.command(open, time);
    }

    /// What the motor shall do from now on; without pulses nothing.
    pub fn demand(&mut self, demand: Demand) {
        if let Phase::Commanded(_) = self.phase {
            self.phase = Phase::Commanded(demand);
        }
    }

    /// Largest current from now on \[A\], rms.
    pub fn limit_current(&mut self, most_a: f64) {
        if let Some(commanded) = &mut self.commanded {
            commanded.current_most_a = Some(most_a.max(0.0));
        }
    }

    /// What is exceeded or missing now, as the supervision saw it within the last millisecond.
    #[must_use]
    pub fn present(&self) -> &[EventKind] {
        self.commanded.as_ref().map_or(&[], |commanded| &commanded.present)
    }

    /// What happens to the axis from now on, in the place of what happened before. A scenario that is no disturbance ends it.
    pub fn disturb(&mut self, what: ScenarioId) {
        self.stop = None;
        self.supply_share = 1.0;
        self.encoder.failing = None;
        self.brake.stuck = false;
        match what {
            ScenarioId::BlockedLoad => self.stop = Some(self.stop_here(0.0)),
            ScenarioId::Collision => self.stop = Some(self.stop_here(self.state.x[5].signum())),
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

    /// What a drive measures now.
    #[must_use]
    pub fn reading(&self) -> Reading {
        let [_, i_q, _, omega, ..] = self.state.x;
        let pulses = self.state.pulses;
        Reading {
            time_s: self.time_s(),
            position_rad: self.measured_rad(),
            speed_rad_s: if pulses { self.control.speed } else { omega },
            current_a: i_q / SQRT_2,
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

    /// Largest speed of the output [rad/s], largest current \[A\], rms.
    #[must_use]
    pub const fn most(&self) -> [f64; 2] {
        [self.machine.speed_max, self.machine.current_max_a]
    }

    /// Whether the axis has a brake.
    #[must_use]
    pub const fn has_brake(&self) -> bool {
        self.brake.exists()
    }
}

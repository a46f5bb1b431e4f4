//! The drive in motion: brake, scenario, states.

use super::{PERIOD_S, SAG, Twin};
use crate::control::{Control, POSITION_PERIOD_S};
use crate::drive::Phase;
use crate::plant::Stop;
use crate::scenario::{EventKind, Reaction, ScenarioId};

impl Twin<'_> {
    /// Updates scenario, brake and states of the drive, at the rate of the position loop.
    pub(super) fn manage(&mut self, time: f64) {
        if !self.happened && self.happens_s.is_some_and(|at| time >= at) {
            self.happened = true;
            self.happen();
        }
        if self.brake.follow(time) {
            self.plant.brake_nm = self.brake.torque_nm();
            let moving = self.state.x.motor_rad_s.abs() > 1e-3 * self.machine.speed_max;
            let kind = match (self.brake.closed, moving) {
                (true, true) => EventKind::BrakeClosedMoving,
                (true, false) => EventKind::BrakeClosed,
                (false, _) => EventKind::BrakeOpen,
            };
            if self.brake.closed {
                let [rest, moved] = &mut self.brake.closings;
                *(if moving { moved } else { rest }) += 1;
                self.state.slipped_rad = 0.0;
                // An axis held at rest sticks.
                if !moving && self.state.x.motor_rad_s == 0.0 {
                    self.state.sliding.motor = 0.0;
                }
            }
            self.note(kind);
        }
        if self.brake.closed && self.state.slipped_rad > 1e-6 && !self.has(EventKind::BrakeSlips) {
            self.note(EventKind::BrakeSlips);
        }
        match self.phase {
            Phase::Running => self.run(time),
            Phase::Resting => {
                let [opening, _] = self.brake.delays();
                let goes_on = self.point.braked.is_none_or(|[_, left]| left <= opening + 2.0 * PERIOD_S);
                if goes_on {
                    self.brake.command(true, time);
                    self.restart();
                    self.phase = Phase::Running;
                }
            }
            Phase::Ramp(speed) => {
                let least = self.limits.ramp_rad_s2 * POSITION_PERIOD_S;
                let next = if speed.abs() <= least { 0.0 } else { speed - least.copysign(speed) };
                let stands = next == 0.0 && self.control.speed.abs() < 5e-3 * self.machine.speed_max;
                self.phase = if stands { Phase::Holding(time) } else { Phase::Ramp(next) };
                if stands {
                    self.note(EventKind::AtRest);
                    if self.brake.command(false, time) {
                        self.note(EventKind::BrakeCloses);
                    }
                }
            }
            Phase::Holding(since) => {
                let held = if self.brake.exists() { self.brake.closed } else { time - since > 0.1 };
                if held {
                    self.switch_pulses_off();
                }
            }
            Phase::Off | Phase::Commanded(_) => {}
        }
        let rests = self.state.x.motor_rad_s.abs() < 1e-4 * self.machine.speed_max
            && self.state.x.load_rad_s.abs() < 1e-3 * self.machine.speed_max;
        let stands = self.gathered.stop(time, self.happened, rests, self.state.x.load_rad);
        let is_noted = self.has(EventKind::AtRest);
        if self.phase == Phase::Off && stands && !is_noted {
            self.note(EventKind::AtRest);
        } else if self.phase == Phase::Off && !rests && is_noted {
            // The load was at rest for a moment only, or slips again.
            self.events.retain(|event| event.kind != EventKind::AtRest);
        }
    }

    /// Operates the brake within the cycle.
    pub(super) fn run(&mut self, time: f64) {
        let [opening, closing] = self.brake.delays();
        if let Some([since, left]) = self.point.braked
            && self.brake.exists()
            && since + left > opening + closing
            && left > opening
        {
            if self.brake.command(false, time) {
                self.note(EventKind::BrakeCloses);
            }
            if self.brake.closed {
                self.phase = Phase::Resting;
                self.plant.block(&mut self.state);
            }
        } else if !self.brake.stuck {
            self.brake.command(true, time);
        }
    }

    pub(super) fn restart(&mut self) {
        let holding = self.control.integral_nm;
        let gains = self.control.gains;
        let angle = self.angle();
        self.control = Control::at_rest(gains, &self.plant, self.setup.switches.delay, angle, holding);
        self.state.pulses = true;
    }

    /// Switches the pulses off.
    pub fn switch_pulses_off(&mut self) {
        if self.state.pulses {
            self.plant.block(&mut self.state);
            self.note(EventKind::PulsesOff);
        }
        self.phase = Phase::Off;
    }

    pub(super) fn has(&self, kind: EventKind) -> bool {
        self.events.iter().any(|event| event.kind == kind)
    }

    /// Ends the motion with a reaction.
    pub(super) fn react(&mut self, reaction: Reaction) {
        let time = self.time_s();
        match reaction {
            Reaction::Ramp if self.state.pulses => {
                self.note(EventKind::Ramp);
                self.phase = Phase::Ramp(self.control.speed);
            }
            Reaction::Ramp | Reaction::Brake => {
                self.switch_pulses_off();
                if self.brake.command(false, time) {
                    self.note(EventKind::BrakeCloses);
                }
            }
            Reaction::Coast => self.switch_pulses_off(),
        }
    }

    /// Raises a fault detected by the drive.
    pub(super) fn fault(&mut self, kind: EventKind, reaction: Reaction) {
        if !self.has(kind) {
            self.note(kind);
        }
        if let Some(commanded) = &mut self.commanded {
            commanded.present.push(kind);
        }
        if matches!(self.phase, Phase::Running | Phase::Resting) {
            self.react(reaction);
        }
    }

    /// Returns a stop at the position of the load.
    pub(super) fn stop_here(&self, side: f64) -> Stop {
        let stiffness_nm = self.setup.parameters.model.stop_stiffness.value;
        let damping_nms = 0.1 * (stiffness_nm * self.local.inertia_kgm2).sqrt();
        Stop { at_rad: self.state.x.load_rad, side, stiffness_nm, damping_nms }
    }

    pub(super) fn happen(&mut self) {
        self.note(EventKind::Scenario);
        let reaction = self.setup.scenario.reaction;
        match self.setup.scenario.id {
            ScenarioId::EmergencyStop => self.react(reaction),
            ScenarioId::PowerFailure => {
                self.supply_share = 0.0;
                self.react(Reaction::Brake);
            }
            ScenarioId::HangingLoad => self.react(Reaction::Brake),
            ScenarioId::BlockedLoad => self.stop = Some(self.stop_here(0.0)),
            ScenarioId::Collision => self.stop = Some(self.stop_here(self.state.x.load_rad_s.signum())),
            ScenarioId::EncoderFailure => self.fail(),
            ScenarioId::LinkSag => self.supply_share = SAG.0,
            ScenarioId::Cycle
            | ScenarioId::BrakeStuck
            | ScenarioId::BatteryLoss
            | ScenarioId::HotAmbient
            | ScenarioId::ColdGrease => {}
        }
    }
}

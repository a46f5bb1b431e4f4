//! Readings of the feedback by the drive, including a failed feedback.

use super::Twin;
use crate::scenario::{EventKind, Failed, Reaction, ScenarioId};
use crate::setup::{Fault, Setup};
use feedback::{Failure, Finding, Interface, Reader};
use quantities::{Angle, AngularVelocity, Measure};
use std::f64::consts::TAU;

/// Failure of the feedback if none is stated.
const FAILURE_USUAL: Failure = Failure::Cable;

/// State of the feedback.
#[derive(Clone, Debug)]
pub(super) struct Encoder {
    pub(super) accuracy_rad: f64,
    pub(super) step_rad: f64,
    pub(super) phases: [f64; 2],
    /// Failure of the feedback, if it has failed.
    pub(super) failing: Option<Failing>,
    /// Angle missing from the reading after the loss of the turns, over i \[rad\].
    pub(super) lost_rad: f64,
}

/// A failed feedback.
#[derive(Clone, Debug)]
pub(super) struct Failing {
    failure: Failure,
    since_s: f64,
    reader: Reader,
    /// Check that detected the failure, the time until then \[s\], and the error of the angle then \[rad\].
    noticed: Option<(Finding, f64, f64)>,
}

/// Checks that the feedback can have the failure of the scenario.
pub(super) fn can_fail(setup: &Setup<'_>) -> Result<(), Fault> {
    let encoder = setup.encoder.ok_or(Fault::NoEncoder)?;
    let failure = setup.scenario.failure.unwrap_or(FAILURE_USUAL);
    if setup.scenario.id == ScenarioId::EncoderFailure && !encoder.failures().any(|each| each == failure) {
        let mut possible = [None; Failure::ALL.len()];
        possible.iter_mut().zip(encoder.failures()).for_each(|(place, each)| *place = Some(each));
        return Err(Fault::NotOfThisEncoder { failure, possible });
    }
    Ok(())
}

impl Twin<'_> {
    /// Returns the angle measured by the encoder, over i \[rad\].
    fn seen(&self) -> f64 {
        let theta = self.state.x.motor_rad;
        if !self.setup.switches.noise {
            return theta;
        }
        let [a, b] = self.encoder.phases;
        let alpha = self.machine.ratio * theta;
        // Two lines per turn of the motor whose sum stays within the stated accuracy.
        theta + self.encoder.accuracy_rad * (0.6 * (alpha + a).sin() + 0.4 * (2.0 * alpha + b).sin())
    }

    /// Returns the measured angle of the motor, over i \[rad\].
    pub(super) fn angle(&self) -> f64 {
        if let Some(failing) = &self.encoder.failing {
            return failing.reader.read_rad() / self.machine.ratio;
        }
        let seen = self.seen() - self.encoder.lost_rad;
        if self.setup.switches.noise && self.encoder.step_rad > 0.0 {
            (seen / self.encoder.step_rad).round() * self.encoder.step_rad
        } else {
            seen
        }
    }

    /// Returns `true` if the signals of the feedback are known, so that it can fail.
    #[must_use]
    pub fn can_fail(&self) -> bool {
        can_fail(&self.setup).is_ok()
    }

    /// Returns `true` if the motor feedback is a resolver.
    #[must_use]
    pub fn has_resolver(&self) -> bool {
        self.setup.encoder.is_some_and(|encoder| matches!(encoder.interface, Interface::Resolver(_)))
    }

    /// Makes the feedback fail.
    pub(super) fn fail(&mut self) {
        let failure = self.setup.scenario.failure.unwrap_or(FAILURE_USUAL);
        let (since_s, ratio) = (self.time_s(), self.machine.ratio);
        let seen = Angle::from_si(ratio * self.seen());
        let speed = AngularVelocity::from_si(ratio * self.state.x.motor_rad_s);
        let reader = self.setup.encoder.and_then(|encoder| Reader::new(encoder, failure, seen, speed, since_s));
        self.encoder.failing = reader.map(|reader| Failing { failure, since_s, reader, noticed: None });
    }

    /// Makes battery and supply of the feedback fail together: its turns restart at zero.
    pub(super) fn lose_turns(&mut self) {
        let seen = Angle::from_si(self.machine.ratio * self.seen());
        let absolute = self.setup.encoder.and_then(feedback::Encoder::absolute);
        #[allow(clippy::cast_precision_loss, reason = "thousands")]
        if let Some(turns) = absolute.and_then(|absolute| absolute.turns_lost(seen)) {
            self.encoder.lost_rad = turns as f64 * TAU / self.machine.ratio;
            self.note(EventKind::TurnsLost);
        }
    }

    /// Reads a failed feedback in each period of the current loop until the failure is detected.
    pub(super) fn read(&mut self, time: f64) {
        let (ratio, seen, theta) = (self.machine.ratio, self.seen(), self.state.x.motor_rad);
        // A failure within a period is sampled in the next.
        let is_open = |failing: &&mut Failing| failing.noticed.is_none() && time > failing.since_s;
        let Some(failing) = self.encoder.failing.as_mut().filter(is_open) else { return };
        let found = failing.reader.take(Angle::from_si(ratio * seen), time);
        let error = failing.reader.read_rad() / ratio - theta;
        if let Err(finding) = found {
            failing.noticed = Some((finding, time - failing.since_s, error));
            self.no_position();
        }
    }

    /// Reacts to a detected failure of the feedback.
    pub(super) fn no_position(&mut self) {
        if self.encoder.failing.as_ref().is_some_and(|failing| failing.noticed.is_some()) {
            let reaction = if self.brake.exists() { Reaction::Brake } else { Reaction::Coast };
            self.fault(EventKind::NoPosition, reaction);
        }
    }

    /// Returns the failure of the feedback and its detection; `None` if it has not failed.
    #[must_use]
    pub fn failed(&self) -> Option<Failed> {
        if self.encoder.lost_rad != 0.0 {
            return Some(Failed { failure: None, noticed: None, error_rad: -self.encoder.lost_rad });
        }
        let failing = self.encoder.failing.as_ref()?;
        let (noticed, error_rad) = match failing.noticed {
            Some((finding, after_s, error_rad)) => (Some((finding, after_s)), error_rad),
            None => (None, self.angle() - self.state.x.motor_rad),
        };
        Some(Failed { failure: Some(failing.failure), noticed, error_rad })
    }

    /// Returns the electrical angle by which the field of the drive leads the rotor \[rad\], for a failed feedback
    /// only, because the deviation of an intact one is small.
    fn ahead(&self) -> Option<f64> {
        let failing = self.encoder.failing.as_ref()?;
        Some(self.plant.electrical * (failing.reader.read_rad() / self.machine.ratio - self.state.x.motor_rad))
    }

    /// Returns the currents [i_d, i_q] in the frame of the drive, whose d axis follows the angle read.
    #[inline]
    pub(super) fn seen_by_the_drive(&self, current: [f64; 2]) -> [f64; 2] {
        self.ahead().map_or(current, |ahead| turned(current, -ahead))
    }

    /// Returns the voltages [u_d, u_q] of the drive in the frame of the rotor.
    #[inline]
    pub(super) fn given_by_the_drive(&self, voltage: [f64; 2]) -> [f64; 2] {
        self.ahead().map_or(voltage, |ahead| turned(voltage, ahead))
    }
}

/// Returns a vector rotated by an angle.
fn turned([d, q]: [f64; 2], by: f64) -> [f64; 2] {
    let (sine, cosine) = by.sin_cos();
    [cosine * d - sine * q, sine * d + cosine * q]
}

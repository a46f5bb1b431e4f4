//! What the drive reads of the feedback, also of one that has failed.

use super::Twin;
use crate::scenario::{EventKind, Failed, Reaction, ScenarioId};
use crate::setup::{Fault, Setup};
use feedback::{Failure, Finding, Interface, Reader};
use quantities::{Angle, AngularVelocity, Measure};
use std::f64::consts::TAU;

/// What fails where nothing else is stated.
const FAILURE_USUAL: Failure = Failure::Cable;

/// The state of the feedback.
#[derive(Clone, Debug)]
pub(super) struct Encoder {
    pub(super) accuracy_rad: f64,
    pub(super) step_rad: f64,
    pub(super) phases: [f64; 2],
    /// It has failed.
    pub(super) failing: Option<Failing>,
    /// The angle that it shows too little since it has lost its turns, over i \[rad\].
    pub(super) lost_rad: f64,
}

/// A feedback that has failed.
#[derive(Clone, Debug)]
pub(super) struct Failing {
    failure: Failure,
    since_s: f64,
    reader: Reader,
    /// What was noticed, after which time \[s\], and the error of the angle then \[rad\].
    noticed: Option<(Finding, f64, f64)>,
}

/// Whether the feedback can fail as the scenario says.
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
    /// The angle that the encoder sees, over i \[rad\].
    fn seen(&self) -> f64 {
        let theta = self.state.x[2];
        if !self.setup.switches.noise {
            return theta;
        }
        let [a, b] = self.encoder.phases;
        let alpha = self.machine.ratio * theta;
        // Two lines a turn of the motor whose sum stays within the printed accuracy.
        theta + self.encoder.accuracy_rad * (0.6 * (alpha + a).sin() + 0.4 * (2.0 * alpha + b).sin())
    }

    /// The measured angle of the motor, over i \[rad\].
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

    /// Whether the signals of the feedback are known, so that it can fail.
    #[must_use]
    pub fn can_fail(&self) -> bool {
        can_fail(&self.setup).is_ok()
    }

    /// Whether the feedback on the motor is a resolver.
    #[must_use]
    pub fn has_resolver(&self) -> bool {
        self.setup.encoder.is_some_and(|encoder| matches!(encoder.interface, Interface::Resolver(_)))
    }

    /// The feedback fails now.
    pub(super) fn fail(&mut self) {
        let failure = self.setup.scenario.failure.unwrap_or(FAILURE_USUAL);
        let (since_s, ratio) = (self.time_s(), self.machine.ratio);
        let seen = Angle::from_si(ratio * self.seen());
        let speed = AngularVelocity::from_si(ratio * self.state.x[3]);
        let reader = self.setup.encoder.and_then(|encoder| Reader::new(encoder, failure, seen, speed, since_s));
        self.encoder.failing = reader.map(|reader| Failing { failure, since_s, reader, noticed: None });
    }

    /// Battery and supply of the feedback have failed together: its turns begin at zero.
    pub(super) fn lose_turns(&mut self) {
        let seen = Angle::from_si(self.machine.ratio * self.seen());
        let absolute = self.setup.encoder.and_then(feedback::Encoder::absolute);
        #[allow(clippy::cast_precision_loss, reason = "thousands")]
        if let Some(turns) = absolute.and_then(|absolute| absolute.turns_lost(seen)) {
            self.encoder.lost_rad = turns as f64 * TAU / self.machine.ratio;
            self.note(EventKind::TurnsLost);
        }
    }

    /// Reads a feedback that has failed, every period of the current loop until it is noticed.
    pub(super) fn read(&mut self, time: f64) {
        let (ratio, seen, theta) = (self.machine.ratio, self.seen(), self.state.x[2]);
        // What fails in a period is sampled in the next.
        let is_open = |failing: &&mut Failing| failing.noticed.is_none() && time > failing.since_s;
        let Some(failing) = self.encoder.failing.as_mut().filter(is_open) else { return };
        let found = failing.reader.take(Angle::from_si(ratio * seen), time);
        let error = failing.reader.read_rad() / ratio - theta;
        if let Err(finding) = found {
            failing.noticed = Some((finding, time - failing.since_s, error));
            self.no_position();
        }
    }

    /// The drive has noticed that it has no valid position.
    pub(super) fn no_position(&mut self) {
        if self.encoder.failing.as_ref().is_some_and(|failing| failing.noticed.is_some()) {
            let reaction = if self.brake.exists() { Reaction::Brake } else { Reaction::Coast };
            self.fault(EventKind::NoPosition, reaction);
        }
    }

    /// How the feedback failed, and what the drive noticed; `None`: it has not failed.
    #[must_use]
    pub fn failed(&self) -> Option<Failed> {
        if self.encoder.lost_rad != 0.0 {
            return Some(Failed { failure: None, noticed: None, error_rad: -self.encoder.lost_rad });
        }
        let failing = self.encoder.failing.as_ref()?;
        let (noticed, error_rad) = match failing.noticed {
            Some((finding, after_s, error_rad)) => (Some((finding, after_s)), error_rad),
            None => (None, self.angle() - self.state.x[2]),
        };
        Some(Failed { failure: Some(failing.failure), noticed, error_rad })
    }

    /// The electrical angle by which the field of the drive lies ahead of the rotor's \[rad\]: of a failed feedback alone, since the
    /// deviation of a sound one is small.
    fn ahead(&self) -> Option<f64> {
        let failing = self.encoder.failing.as_ref()?;
        Some(self.plant.electrical * (failing.reader.read_rad() / self.machine.ratio - self.state.x[2]))
    }

    /// The currents [i_d, i_q] as the drive sees them, whose d axis follows the angle that it reads.
    #[inline]
    pub(super) fn seen_by_the_drive(&self, current: [f64; 2]) -> [f64; 2] {
        self.ahead().map_or(current, |ahead| turned(current, -ahead))
    }

    /// The voltages [u_d, u_q] of the drive at the rotor.
    #[inline]
    pub(super) fn given_by_the_drive(&self, voltage: [f64; 2]) -> [f64; 2] {
        self.ahead().map_or(voltage, |ahead| turned(voltage, ahead))
    }
}

/// A vector turned by an angle.
fn turned([d, q]: [f64; 2], by: f64) -> [f64; 2] {
    let (sine, cosine) = by.sin_cos();
    [cosine * d - sine * q, sine * d + cosine * q]
}

//! A recording under another load and at another pace than its survey.

use super::loads::Piece;
use crate::{Extent, Form, Gram, Node};
use motion::Interval;

/// Transformation from the signals of the survey to those of a strip.
///
/// α = α_0/f², ω = ω_0/f, T_L = w R + J α + T_c σ + b ω, t = t_0 + f t'
///
/// # Symbols
/// f stretch of the time; R recorded torque, constant torque, and torque of the weight at
/// each position \[Nm\]; w factor on R, other than one only where it is the weight alone
/// # Source
/// docs/theory/moments.md
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct View {
    pub(super) weight: f64,
    pub(super) inertia: f64,
    pub(super) coulomb: f64,
    pub(super) viscous: f64,
    pub(super) stretch: f64,
    pub(super) start: f64,
}

impl View {
    /// The identity: the signals of the survey.
    pub(super) const NONE: Self =
        Self { weight: 1.0, inertia: 0.0, coulomb: 0.0, viscous: 0.0, stretch: 1.0, start: 0.0 };

    #[inline]
    pub(super) fn node(&self, raw: &Node) -> Node {
        let (acceleration, speed) =
            (raw.acceleration_rad_s2 / (self.stretch * self.stretch), raw.speed_rad_s / self.stretch);
        Node {
            time_s: self.start + self.stretch * raw.time_s,
            weight_s: self.stretch * raw.weight_s,
            acceleration_rad_s2: acceleration,
            speed_rad_s: speed,
            direction: raw.direction,
            load_nm: self.weight * raw.load_nm
                + self.inertia * acceleration
                + self.coulomb * raw.direction
                + self.viscous * speed,
        }
    }

    /// Converts a piece of an interval to the load of the view; `interval` is placed and has one direction.
    #[inline]
    pub(super) fn piece(&self, raw: &Piece, interval: &Interval, direction: f64) -> Piece {
        let [begin, end] = interval.speed_rad_s;
        let unchanging = self.inertia * interval.acceleration_rad_s2() + self.coulomb * direction;
        let at = |u: f64, load: f64| self.weight * load + unchanging + self.viscous * (begin + u * (end - begin));
        let [first, middle, last] = raw.loads;
        let loads = [at(raw.from, first), at(0.5 * (raw.from + raw.to), middle), at(raw.to, last)];
        Piece { loads, ..*raw }
    }

    /// Scales the deviations from the chord; only R is curved.
    #[inline]
    pub(super) fn curvature(&self, [acceleration, load, direction, speed]: [f64; 4]) -> [f64; 4] {
        [acceleration, self.weight.abs() * load, direction, speed]
    }

    /// Returns the matrix A; row i gives signal i from those of the survey.
    #[inline]
    pub(super) fn rows(&self) -> [[f64; 4]; 4] {
        let slow = 1.0 / self.stretch;
        let slower = slow * slow;
        [
            [slower, 0.0, 0.0, 0.0],
            [self.inertia * slower, self.weight, self.coulomb, self.viscous * slow],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, slow],
        ]
    }

    /// Returns A G Aᵀ with the matrix above, over a time longer by the stretch.
    pub(super) fn gram(&self, raw: &Gram) -> Gram {
        let slow = 1.0 / self.stretch;
        let (a, j, c, b) = (slow * slow, self.inertia * slow * slow, self.coulomb, self.viscous * slow);
        let r = self.weight;
        let [ga, gt, gs, gw] = raw.0;
        let torque = |[ga, gt, gs, gw]: [f64; 4]| j * ga + r * gt + c * gs + b * gw;
        let (ta, tt, ts, tw) = (torque(ga), torque(gt), torque(gs), torque(gw));
        let f = self.stretch;
        let [aa, at, as_, aw] = [f * a * a * ga[0], f * a * ta, f * a * ga[2], f * a * slow * ga[3]];
        let [ttt, tts, ttw] = [f * (j * ta + r * tt + c * ts + b * tw), f * ts, f * slow * tw];
        let [ss, sw, ww] = [f * gs[2], f * slow * gs[3], f * slow * slow * gw[3]];
        Gram([[aa, at, as_, aw], [at, ttt, tts, ttw], [as_, tts, ss, sw], [aw, ttw, sw, ww]])
    }

    /// Converts the weights of a sum of signals under the load to weights of the signals of the survey: Aᵀ c.
    #[inline]
    pub(super) fn weights(&self, c: [f64; 4]) -> [f64; 4] {
        let mut raw = [0.0; 4];
        for (row, c) in self.rows().iter().zip(c) {
            raw.iter_mut().zip(row).for_each(|(raw, a)| *raw += c * a);
        }
        raw
    }

    #[inline]
    pub(super) fn extent(&self, raw: &Extent) -> Extent {
        let times = |(low, high): (f64, f64), factor: f64| (low * factor, high * factor);
        let slow = 1.0 / self.stretch;
        let (acceleration, speeds) = (times(raw.acceleration_rad_s2, slow * slow), times(raw.speeds_rad_s, slow));
        let parts = [
            times(raw.load_nm, self.weight),
            times(acceleration, self.inertia),
            times(raw.direction, self.coulomb),
            times(speeds, self.viscous),
        ];
        let load = parts.iter().fold((0.0, 0.0), |(low, high), part| (low + part.0, high + part.1));
        // The nodes are rounded differently from these sums; the bounds must hold for them too.
        let room = 8.0 * f64::EPSILON * parts.iter().map(|part| part.0.abs().max(part.1.abs())).sum::<f64>();
        let load = (load.0 - room, load.1 + room);
        Extent {
            acceleration_rad_s2: acceleration,
            load_nm: load,
            speeds_rad_s: speeds,
            speed_rad_s: raw.speed_rad_s * slow,
            direction: raw.direction,
        }
    }

    /// Converts a form to the signals of the survey: Qʹ = Aᵀ Q A.
    pub(crate) fn form(&self, form: &Form) -> Form {
        let rows = self.rows();
        let mut raw = Form::default();
        for (q, a) in form.0.iter().zip(&rows) {
            for (q, b) in q.iter().zip(&rows) {
                raw = raw.plus(&Form::product(*a, *b).scale(*q));
            }
        }
        raw
    }

    #[inline]
    pub(crate) const fn stretch(&self) -> f64 {
        self.stretch
    }
}

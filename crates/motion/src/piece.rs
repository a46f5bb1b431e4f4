//! Pieces of motion: acceleration as a polynomial and a harmonic of time, integrated in closed form.

use numeric::{root, roots};
use std::f64::consts::{FRAC_PI_2, PI};

/// Position, speed and acceleration at one instant; by default at rest at zero.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// q \[rad\]
    pub position_rad: f64,
    /// ω [rad/s]
    pub speed_rad_s: f64,
    /// α [rad/s²]
    pub acceleration_rad_s2: f64,
}

/// A piece of motion.
///
/// α(t) = c_0 + c_1 t + c_2 t² + c_3 t³ + A sin(Ω t + φ) for 0 ≤ t ≤ τ; ω and q by integration from the initial state.
///
/// # Source
/// own derivation; the laws of VDI 2143 in this crate are chains of such pieces (docs/theory/motion-laws.md)
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Start of the piece, from the start of the cycle \[s\].
    pub start_s: f64,
    /// τ: duration, greater than zero \[s\].
    pub duration_s: f64,
    /// Initial position \[rad\].
    pub position_rad: f64,
    /// Initial speed [rad/s].
    pub speed_rad_s: f64,
    /// Final speed [rad/s], if the law states it: exactly zero at rest, without the rounding error of the integral.
    pub end_speed_rad_s: Option<f64>,
    /// c_0 … c_3 [rad/s², rad/s³, …].
    pub polynomial: [f64; 4],
    /// A, Ω, φ of the harmonic [rad/s², rad/s, rad]; A = 0 for none.
    pub harmonic: [f64; 3],
    /// Index of the segment.
    pub segment: usize,
}

impl Piece {
    /// Creates a piece of constant acceleration; start, state and segment are set when it is chained.
    pub(crate) const fn ramp(duration_s: f64, acceleration: f64) -> Self {
        Self::polynomial(duration_s, [acceleration, 0.0, 0.0, 0.0])
    }

    pub(crate) const fn polynomial(duration_s: f64, polynomial: [f64; 4]) -> Self {
        Self {
            start_s: 0.0,
            duration_s,
            position_rad: 0.0,
            speed_rad_s: 0.0,
            end_speed_rad_s: None,
            polynomial,
            harmonic: [0.0, 1.0, 0.0],
            segment: 0,
        }
    }

    pub(crate) const fn harmonic(duration_s: f64, amplitude: f64, frequency: f64, phase: f64) -> Self {
        let mut piece = Self::polynomial(duration_s, [0.0; 4]);
        piece.harmonic = [amplitude, frequency, phase];
        piece
    }

    /// Returns the piece with the end speed stated by its law.
    pub(crate) const fn ending_with(self, speed: f64) -> Self {
        Self { end_speed_rad_s: Some(speed), ..self }
    }

    /// Returns the piece with its duration multiplied by `factor`.
    #[must_use]
    pub(crate) fn stretched(&self, factor: f64) -> Self {
        let [c0, c1, c2, c3] = self.polynomial;
        let [amplitude, frequency, phase] = self.harmonic;
        let square = factor * factor;
        Self {
            start_s: self.start_s * factor,
            duration_s: self.duration_s * factor,
            speed_rad_s: self.speed_rad_s / factor,
            end_speed_rad_s: self.end_speed_rad_s.map(|speed| speed / factor),
            polynomial: [c0 / square, c1 / (square * factor), c2 / (square * square), c3 / (square * square * factor)],
            harmonic: [amplitude / square, frequency / factor, phase],
            ..*self
        }
    }

    /// Returns the piece with positions, speeds and accelerations multiplied by `ratio`.
    #[must_use]
    pub(crate) fn geared(&self, ratio: f64) -> Self {
        let [amplitude, frequency, phase] = self.harmonic;
        Self {
            position_rad: self.position_rad * ratio,
            speed_rad_s: self.speed_rad_s * ratio,
            polynomial: self.polynomial.map(|c| c * ratio),
            harmonic: [amplitude * ratio, frequency, phase],
            ..*self
        }
    }

    /// Returns the state at a time from the start of the piece \[s\].
    #[must_use]
    pub fn at(&self, t: f64) -> State {
        self.states()(t)
    }

    /// Returns a function of the time from the start of the piece that yields the state; faster than [`Piece::at`] for
    /// many times.
    pub fn states(&self) -> impl Fn(f64) -> State + '_ {
        let [_, _, phase] = self.harmonic;
        let of_phase = phase.sin_cos();
        move |t| self.with_phase(t, of_phase)
    }

    fn with_phase(&self, t: f64, (sin_phase, cos_phase): (f64, f64)) -> State {
        let [c0, c1, c2, c3] = self.polynomial;
        let mut acceleration = c0 + t * (c1 + t * (c2 + t * c3));
        let mut speed = self.speed_rad_s + t * (c0 + t * (c1 / 2.0 + t * (c2 / 3.0 + t * c3 / 4.0)));
        let mut position = self.position_rad
            + t * (self.speed_rad_s + t * (c0 / 2.0 + t * (c1 / 6.0 + t * (c2 / 12.0 + t * c3 / 20.0))));
        let [amplitude, frequency, phase] = self.harmonic;
        if amplitude != 0.0 {
            let (sin, cos) = (frequency * t + phase).sin_cos();
            acceleration += amplitude * sin;
            speed += amplitude / frequency * (cos_phase - cos);
            position += amplitude / frequency * (t * cos_phase - (sin - sin_phase) / frequency);
        }
        State { position_rad: position, speed_rad_s: speed, acceleration_rad_s2: acceleration }
    }

    /// Returns dα/dt at a time from the start of the piece [rad/s³].
    #[must_use]
    pub fn jerk(&self, t: f64) -> f64 {
        let [_, c1, c2, c3] = self.polynomial;
        let [amplitude, frequency, phase] = self.harmonic;
        c1 + t * (2.0 * c2 + t * 3.0 * c3) + amplitude * frequency * (frequency * t + phase).cos()
    }

    /// Returns the times strictly inside the piece at which the acceleration changes sign \[s\].
    #[must_use]
    pub fn acceleration_roots(&self) -> Vec<f64> {
        let ([c0, c1, c2, c3], [amplitude, frequency, phase]) = (self.polynomial, self.harmonic);
        if amplitude == 0.0 && c3 == 0.0 {
            return self.inside(quadratic(c0, c1, c2));
        }
        if amplitude != 0.0 && self.polynomial == [0.0; 4] {
            return self.inside(zeros_of_sine(frequency, phase, self.duration_s));
        }
        let state = self.states();
        roots(|t| state(t).acceleration_rad_s2, self.duration_s)
    }

    /// Returns the times strictly inside the piece at which the jerk changes sign \[s\]: extremes of the acceleration.
    #[must_use]
    pub fn jerk_roots(&self) -> Vec<f64> {
        let ([_, c1, c2, c3], [amplitude, frequency, phase]) = (self.polynomial, self.harmonic);
        if amplitude == 0.0 {
            return self.inside(quadratic(c1, 2.0 * c2, 3.0 * c3));
        }
        if [c1, c2, c3] == [0.0; 3] {
            return self.inside(zeros_of_sine(frequency, phase + FRAC_PI_2, self.duration_s));
        }
        roots(|t| self.jerk(t), self.duration_s)
    }

    /// Returns the largest |α| of the piece [rad/s²]: at an end, or where the jerk changes sign.
    #[must_use]
    pub fn acceleration_peak_rad_s2(&self) -> f64 {
        let state = self.states();
        let instants = self.jerk_roots().into_iter().chain([0.0, self.duration_s]);
        instants.map(|t| state(t).acceleration_rad_s2.abs()).fold(0.0, f64::max)
    }

    /// Returns the times strictly inside the piece; those that differ from an end by rounding only are dropped.
    fn inside(&self, times: Vec<f64>) -> Vec<f64> {
        let beside = 1e-13 * self.duration_s;
        times.into_iter().filter(|t| *t > beside && *t < self.duration_s - beside).collect()
    }

    /// Returns the state at the end of the piece, with the speed stated by the law.
    #[must_use]
    pub fn end(&self) -> State {
        let end = self.at(self.duration_s);
        State { speed_rad_s: self.end_speed_rad_s.unwrap_or(end.speed_rad_s), ..end }
    }

    /// Returns `true` if the piece is at rest.
    #[must_use]
    pub fn is_rest(&self) -> bool {
        self.speed_rad_s == 0.0 && self.harmonic[0] == 0.0 && self.polynomial == [0.0; 4]
    }

    /// Returns the degree of the speed as a polynomial of time; `None` with a harmonic.
    #[must_use]
    pub fn speed_degree(&self) -> Option<usize> {
        if self.harmonic[0] != 0.0 {
            return None;
        }
        Some(self.polynomial.iter().rposition(|c| *c != 0.0).map_or(0, |index| index + 1))
    }

    /// Returns the times inside the piece at which the direction reverses \[s\].
    #[must_use]
    pub fn reversals(&self) -> Vec<f64> {
        self.runs().reversals()
    }

    /// Returns the directions of the piece with the times at which they end.
    ///
    /// The speed is monotone between the roots of the acceleration, so that its signs there and at both ends decide:
    /// one reversal between two speeds of opposite sign, no other. The speeds at the ends are those stated by the law;
    /// a speed in between within the rounding error of zero counts as zero.
    ///
    /// # Source
    /// docs/theory/motion-laws.md
    #[must_use]
    pub fn runs(&self) -> Runs {
        let (end, last) = (self.duration_s, self.end().speed_rad_s);
        let mut marks = vec![(0.0, self.speed_rad_s)];
        if self.speed_degree().is_none_or(|degree| degree > 1) {
            let rounding = self.rounding();
            let inner = self.acceleration_roots();
            marks.extend(inner.into_iter().map(|t| {
                let speed = self.at(t).speed_rad_s;
                (t, if speed.abs() <= rounding { 0.0 } else { speed })
            }));
        }
        marks.push((end, last));
        let mut runs: Vec<(f64, f64)> = Vec::new();
        let sign = |speed: f64| if speed == 0.0 { 0.0 } else { speed.signum() };
        let mut go = |until: f64, direction: f64| match runs.last_mut() {
            Some((end, before)) if *before == direction || direction == 0.0 || *before == 0.0 => {
                *end = until;
                *before = if direction == 0.0 { *before } else { direction };
            }
            _ => runs.push((until, direction)),
        };
        for ((from, before), (to, after)) in marks.iter().zip(marks.iter().skip(1)) {
            let (first, second) = (sign(*before), sign(*after));
            if first * second < 0.0 {
                go(self.reversal((*from, *before), (*to, *after)), first);
            }
            go(*to, if second == 0.0 { first } else { second });
        }
        Runs(runs)
    }

    /// Returns the time at which the speed, monotone between two instants, changes sign.
    fn reversal(&self, from: (f64, f64), to: (f64, f64)) -> f64 {
        if self.speed_degree() == Some(1) {
            let [c0, ..] = self.polynomial;
            return (-self.speed_rad_s / c0).clamp(from.0, to.0);
        }
        let state = self.states();
        root(|t| state(t).speed_rad_s, from, to, 0.0)
    }

    /// Returns the rounding error of a speed that should be zero [rad/s]: eight units in the last place of the sum of
    /// the magnitudes of its terms.
    fn rounding(&self) -> f64 {
        let ([c0, c1, c2, c3], t) = (self.polynomial.map(f64::abs), self.duration_s);
        let [amplitude, frequency, _] = self.harmonic;
        let terms = t * (c0 + t * (c1 / 2.0 + t * (c2 / 3.0 + t * c3 / 4.0)));
        let swing = if amplitude == 0.0 { 0.0 } else { 2.0 * (amplitude / frequency).abs() };
        8.0 * f64::EPSILON * (self.speed_rad_s.abs() + terms + swing)
    }
}

/// Directions of a piece, each with the time at which it ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Runs(Vec<(f64, f64)>);

impl Runs {
    /// Returns the times at which the direction changes \[s\].
    #[must_use]
    pub fn reversals(&self) -> Vec<f64> {
        self.0.iter().zip(self.0.iter().skip(1)).map(|((end, _), _)| *end).collect()
    }

    /// Returns the direction at a time from the start of the piece: +1, −1, or 0 at rest.
    #[must_use]
    pub fn direction(&self, t: f64) -> f64 {
        let here = self.0.iter().find(|(end, _)| t <= *end).or(self.0.last());
        here.map_or(0.0, |(_, direction)| *direction)
    }
}

/// Returns the times at which c_0 + c_1 t + c_2 t² changes sign, in order; a double root is none.
fn quadratic(c0: f64, c1: f64, c2: f64) -> Vec<f64> {
    if c2 == 0.0 {
        return if c1 == 0.0 { Vec::new() } else { vec![-c0 / c1] };
    }
    let root = c1 * c1 - 4.0 * c2 * c0;
    // Two equal roots, apart from rounding, are no change of sign.
    if root <= 8.0 * f64::EPSILON * c1 * c1 {
        return Vec::new();
    }
    let q = -0.5 * (c1 + root.sqrt().copysign(c1));
    let mut found = vec![q / c2, c0 / q];
    found.sort_by(f64::total_cmp);
    found
}

/// Limit of the half periods of a harmonic: a motion law has a few, and the roots of more cannot be resolved.
const HALF_TURNS_MOST: f64 = 1e4;

/// Returns the times up to `end` at which sin(Ω t + φ) changes sign.
fn zeros_of_sine(frequency: f64, phase: f64, end: f64) -> Vec<f64> {
    let (from, to) = (phase / PI, (frequency * end + phase) / PI);
    let (mut half_turn, last) = (from.min(to).floor(), from.max(to).ceil());
    let mut found = Vec::new();
    // Without roots if a bound is NaN.
    if (last - half_turn).is_nan() || last - half_turn > HALF_TURNS_MOST {
        return found;
    }
    while half_turn <= last {
        found.push((half_turn * PI - phase) / frequency);
        half_turn += 1.0;
    }
    found.sort_by(f64::total_cmp);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed forms agree with Simpson sums of the acceleration and of the speed.
    #[test]
    fn speed_and_position_are_the_integrals_of_the_acceleration() {
        let piece = Piece {
            position_rad: 0.3,
            speed_rad_s: -1.2,
            harmonic: [4.0, 7.0, 0.4],
            ..Piece::polynomial(1.3, [2.0, -3.0, 1.5, 0.7])
        };
        let n = 2000;
        let (mut speed, mut position) = (-1.2, 0.3);
        let h = 1.3 / f64::from(n);
        for k in 0..n {
            let t = f64::from(k) * h;
            let simpson = |f: &dyn Fn(State) -> f64| {
                (f(piece.at(t)) + 4.0 * f(piece.at(t + h / 2.0)) + f(piece.at(t + h))) * h / 6.0
            };
            speed += simpson(&|s| s.acceleration_rad_s2);
            position += simpson(&|s| s.speed_rad_s);
        }
        assert!((piece.end().speed_rad_s - speed).abs() < 1e-12);
        assert!((piece.end().position_rad - position).abs() < 1e-12);
    }

    #[test]
    fn a_stretched_piece_passes_the_same_places_later() {
        let piece = Piece {
            position_rad: 0.3,
            speed_rad_s: -1.2,
            harmonic: [4.0, 7.0, 0.4],
            ..Piece::polynomial(1.3, [2.0, -3.0, 1.5, 0.7])
        };
        let slow = piece.stretched(2.5);
        for step in 0..=20 {
            let t = 1.3 * f64::from(step) / 20.0;
            let (a, b) = (piece.at(t), slow.at(2.5 * t));
            assert!((a.position_rad - b.position_rad).abs() < 1e-12);
            assert!((a.speed_rad_s / 2.5 - b.speed_rad_s).abs() < 1e-12);
            assert!((a.acceleration_rad_s2 / 6.25 - b.acceleration_rad_s2).abs() < 1e-12);
        }
    }

    #[test]
    fn a_geared_piece_turns_as_much_further() {
        let piece = Piece {
            position_rad: 0.3,
            speed_rad_s: -1.2,
            harmonic: [4.0, 7.0, 0.4],
            ..Piece::polynomial(1.3, [2.0, -3.0, 1.5, 0.7])
        };
        let geared = piece.geared(2.5);
        for step in 0..=20 {
            let t = 1.3 * f64::from(step) / 20.0;
            let (a, b) = (piece.at(t), geared.at(t));
            assert!((2.5 * a.position_rad - b.position_rad).abs() < 1e-12);
            assert!((2.5 * a.speed_rad_s - b.speed_rad_s).abs() < 1e-12);
            assert!((2.5 * a.acceleration_rad_s2 - b.acceleration_rad_s2).abs() < 1e-12);
        }
    }

    #[test]
    fn a_ramp_through_rest_turns_there() {
        let ramp = Piece { speed_rad_s: -1.0, ..Piece::ramp(3.0, 1.0) };
        assert_eq!(ramp.reversals(), vec![1.0]);
        let runs = ramp.runs();
        assert_eq!([0.0, 0.5, 1.0, 1.5, 3.0].map(|t| runs.direction(t)), [-1.0, -1.0, -1.0, 1.0, 1.0]);
    }

    /// A polynomial move between two speeds reverses at most twice; where the speed only touches zero it does not
    /// reverse.
    #[test]
    fn a_touch_of_rest_is_no_reversal() {
        // ω = (t − 1)²
        let touching = Piece { speed_rad_s: 1.0, ..Piece::polynomial(2.0, [-2.0, 2.0, 0.0, 0.0]) };
        assert!(touching.reversals().is_empty());
        assert_eq!([0.0, 1.0, 2.0].map(|t| touching.runs().direction(t)), [1.0; 3]);
        let turning = Piece { speed_rad_s: 0.75, ..touching };
        let found = turning.reversals();
        assert!((found[0] - 0.5).abs() < 1e-15 && (found[1] - 1.5).abs() < 1e-15, "{found:?}");
        assert_eq!([0.2, 1.0, 1.8].map(|t| turning.runs().direction(t)), [1.0, -1.0, 1.0]);
        assert_eq!(Piece::ramp(1.0, 0.0).runs().direction(0.5), 0.0);
    }

    /// The closed forms of the roots agree with the search, for pieces of every kind.
    #[test]
    fn roots_in_closed_form_are_those_of_the_search() {
        let polynomials = [[1.0, -3.0, 0.0, 0.0], [0.4, -2.0, 1.5, 0.0], [1.0, -2.0, 1.0, 0.0], [0.2, 0.3, 0.4, 0.0]];
        let harmonics = [[2.0, 9.0, 0.3], [-1.5, 4.0, -2.0], [1.0, std::f64::consts::PI / 1.3, 0.0]];
        let plain = polynomials.map(|polynomial| Piece::polynomial(1.3, polynomial));
        let waves = harmonics.map(|[a, w, p]| Piece::harmonic(1.3, a, w, p));
        let both = Piece { harmonic: [2.0, 9.0, 0.3], ..Piece::polynomial(1.3, [0.7, 0.0, 0.0, 0.0]) };
        for piece in plain.into_iter().chain(waves).chain([both]) {
            for (found, searched) in [
                (piece.acceleration_roots(), roots(|t| piece.at(t).acceleration_rad_s2, 1.3)),
                (piece.jerk_roots(), roots(|t| piece.jerk(t), 1.3)),
            ] {
                assert_eq!(found.len(), searched.len(), "{piece:?}: {found:?} {searched:?}");
                for (a, b) in found.iter().zip(searched) {
                    assert!((a - b).abs() < 1e-12, "{piece:?}: {a} {b}");
                }
            }
        }
        assert_eq!(Piece::harmonic(1.0, 1.0, f64::MAX, 0.0).acceleration_roots(), Vec::<f64>::new());
    }
}

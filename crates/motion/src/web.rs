//! The web of a winder at a constant line speed: the roll turns the slower the larger it is.

use crate::points::{EndState, Points, StateInterval};
use quantities::{Angle, AngularAcceleration, AngularVelocity, Length, Measure, Time, Velocity};
use std::f64::consts::{PI, TAU};

/// A run of a web at a line speed, from one diameter of its roll to another, from rest to rest.
///
/// r² = r_0² ± s L/π, φ = 2 L/(r + r_0), ω = v/r, α = a/r ∓ s v²/(2π r³)
///
/// # Symbols
/// L length of the web that has passed, v its speed, a its acceleration, s its thickness, r radius of the roll, r_0 at
/// the start; upper sign for a growing roll
/// # Source
/// docs/theory/motion-laws.md: area of the wound web, s L = π |r² − r_0²|
/// # Valid
/// tightly wound web without slip and of constant thickness
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Web {
    /// Diameter of the roll at the start.
    pub from: Length,
    /// Diameter of the roll at the end.
    pub to: Length,
    /// s: thickness of the web.
    pub thickness: Length,
    /// Line speed between the ramps.
    pub speed: Velocity,
    /// Duration of the acceleration to the line speed.
    pub accelerate: Time,
    /// Duration of the deceleration from the line speed.
    pub brake: Time,
}

/// Fault that prevents a web from running.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WebFault {
    /// The line speed is not greater than zero.
    NoSpeed,
    /// A ramp has no duration.
    NoTimeToChangeSpeed {
        /// The ramp at the end.
        braking: bool,
    },
    /// The web ends before both ramps do.
    TooShort {
        /// Length of the web on the roll \[m\].
        length_m: f64,
        /// Length that passes during the ramps \[m\].
        ramps_m: f64,
    },
    /// A value is outside of what can be computed.
    OutOfRange,
}

/// Largest natural logarithm of the ratio of the radii at the ends of one piece: the line speed of a piece then deviates
/// from that of the web by less than 1e-6 of it.
const GROWTH: f64 = 0.008;

/// Largest number of pieces of one phase.
const PIECES_MOST: f64 = 4096.0;

/// Course of the web in one of the phases, from the start of the phase.
#[derive(Clone, Copy)]
struct Phase {
    /// Length that has passed at the start \[m\].
    passed_m: f64,
    /// Length that passes in the phase \[m\].
    length_m: f64,
    /// Speed at the start [m/s].
    speed_m_s: f64,
    /// Acceleration [m/s²].
    acceleration_m_s2: f64,
}

impl Phase {
    /// Returns the time at which a length has passed since the start of the phase \[s\].
    fn time_s(&self, length_m: f64) -> f64 {
        let reached = self.speed_at(length_m);
        let mean = 0.5 * (self.speed_m_s + reached);
        if mean > 0.0 { length_m / mean } else { 0.0 }
    }

    /// Returns the speed where a length has passed since the start of the phase [m/s].
    fn speed_at(&self, length_m: f64) -> f64 {
        (self.speed_m_s * self.speed_m_s + 2.0 * self.acceleration_m_s2 * length_m).max(0.0).sqrt()
    }
}

impl Web {
    /// Returns the length of the web that passes \[m\].
    #[must_use]
    pub fn length_m(&self) -> f64 {
        let (a, b) = (0.5 * self.from.si(), 0.5 * self.to.si());
        PI * ((b - a) * (b + a)).abs() / self.thickness.si()
    }

    /// Returns the fault of the data.
    fn fault(&self) -> Option<WebFault> {
        let (speed, ramps) = (self.speed.si(), [self.accelerate.si(), self.brake.si()]);
        let length_m = self.length_m();
        let ramps_m = 0.5 * speed * (ramps[0] + ramps[1]);
        if !(speed.is_finite() && length_m.is_finite() && ramps.iter().all(|time| time.is_finite())) {
            return Some(WebFault::OutOfRange);
        }
        if speed <= 0.0 {
            return Some(WebFault::NoSpeed);
        }
        if let Some(place) = ramps.iter().position(|time| *time <= 0.0) {
            return Some(WebFault::NoTimeToChangeSpeed { braking: place == 1 });
        }
        (ramps_m > length_m).then_some(WebFault::TooShort { length_m, ramps_m })
    }

    /// Returns +1 if the roll grows, −1 if it shrinks.
    fn sign(&self) -> f64 {
        if self.to.si() < self.from.si() { -1.0 } else { 1.0 }
    }

    /// Returns the radius of the roll where a length of the web has passed \[m\].
    fn radius_m(&self, passed_m: f64) -> f64 {
        let (first, last) = (0.5 * self.from.si(), 0.5 * self.to.si());
        let square = first * first + self.sign() * self.thickness.si() * passed_m / PI;
        square.max(first.min(last) * first.min(last)).sqrt().min(first.max(last))
    }

    /// Returns the angle of the roll where a length of the web has passed \[rad\].
    fn angle_rad(&self, passed_m: f64) -> f64 {
        2.0 * passed_m / (self.radius_m(passed_m) + 0.5 * self.from.si())
    }

    /// Returns ω and α of the roll at a radius, for speed and acceleration of the web.
    fn state(&self, radius_m: f64, speed_m_s: f64, acceleration_m_s2: f64) -> EndState {
        let growth = self.sign() * self.thickness.si() / TAU;
        let bend = growth * speed_m_s * speed_m_s / (radius_m * radius_m * radius_m);
        EndState {
            speed: AngularVelocity::from_si(speed_m_s / radius_m),
            acceleration: AngularAcceleration::from_si(acceleration_m_s2 / radius_m - bend),
        }
    }

    /// Returns the motion of the roll: pieces that meet angle, speed and acceleration of the closed form at their ends.
    ///
    /// # Errors
    /// The fault of the data.
    pub fn points(&self) -> Result<Points, WebFault> {
        if let Some(fault) = self.fault() {
            return Err(fault);
        }
        let (speed, [up, down]) = (self.speed.si(), [self.accelerate.si(), self.brake.si()]);
        let (first, last) = (0.5 * speed * up, 0.5 * speed * down);
        let whole = self.length_m();
        let phase = |passed_m: f64, length_m: f64, speed_m_s: f64, acceleration_m_s2: f64| Phase {
            passed_m,
            length_m,
            speed_m_s,
            acceleration_m_s2,
        };
        let phases = [
            phase(0.0, first, 0.0, speed / up),
            phase(first, whole - first - last, speed, 0.0),
            phase(whole - last, last, speed, -speed / down),
        ];
        let mut intervals = Vec::new();
        for phase in phases.into_iter().filter(|phase| phase.length_m > 0.0) {
            self.add(&phase, &mut intervals);
        }
        Points::through_states(Angle::from_si(0.0), &intervals).ok_or(WebFault::OutOfRange)
    }

    /// Adds the intervals of a phase: equal ratios of the radii at their ends.
    fn add(&self, phase: &Phase, intervals: &mut Vec<StateInterval>) {
        let [a, b] = [phase.passed_m, phase.passed_m + phase.length_m].map(|passed| self.radius_m(passed));
        let count = ((b / a).ln().abs() / GROWTH).ceil().clamp(2.0, PIECES_MOST);
        // The radius at the share k/n of the phase; the length follows from it, as does the time.
        let passed_at = |k: f64| {
            let radius = a * (b / a).powf(k / count);
            let share = (radius - a) * (radius + a) / ((b - a) * (b + a));
            if share.is_finite() { phase.length_m * share } else { phase.length_m * k / count }
        };
        let mut before = (0.0, 0.0, self.state(a, phase.speed_m_s, phase.acceleration_m_s2));
        let mut k = 1.0;
        while k <= count {
            let length = if k < count { passed_at(k) } else { phase.length_m };
            let is_end_of_brake = k >= count && phase.acceleration_m_s2 < 0.0;
            let speed = if is_end_of_brake { 0.0 } else { phase.speed_at(length) };
            let (time, passed) = (phase.time_s(length), phase.passed_m + length);
            let state = self.state(self.radius_m(passed), speed, phase.acceleration_m_s2);
            intervals.push(StateInterval {
                duration: Time::from_si(time - before.1),
                step: Angle::from_si(self.angle_rad(passed) - self.angle_rad(phase.passed_m + before.0)),
                ends: [before.2, state],
            });
            before = (length, time, state);
            k += 1.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Closing, Motion, SegmentSpec};

    fn web(from_mm: f64, to_mm: f64, thickness_mm: f64, speed_m_min: f64, ramps_s: [f64; 2]) -> Web {
        Web {
            from: Length::from_si(from_mm * 1e-3),
            to: Length::from_si(to_mm * 1e-3),
            thickness: Length::from_si(thickness_mm * 1e-3),
            speed: Velocity::from_si(speed_m_min / 60.0),
            accelerate: Time::from_si(ramps_s[0]),
            brake: Time::from_si(ramps_s[1]),
        }
    }

    /// The line speed that the roll has in the pieces is that of the web at every instant, and the angle is that of a
    /// direct integral of v/r over the time with the radius that the turns give.
    #[test]
    fn the_line_speed_is_constant_and_the_angle_is_that_of_a_direct_integral() {
        for (from, to, thickness, speed, ramps) in [
            (90.0, 330.0, 2.0, 60.0, [5.0, 8.0]),
            (90.0, 330.0, 0.1, 120.0, [10.0, 10.0]),
            (330.0, 90.0, 0.1, 120.0, [10.0, 4.0]),
            (76.0, 1200.0, 0.05, 400.0, [30.0, 30.0]),
            (76.0, 76.5, 0.05, 10.0, [0.2, 0.3]),
        ] {
            let web = web(from, to, thickness, speed, ramps);
            let points = web.points().unwrap();
            let motion =
                Motion::new(&[SegmentSpec::Points(points.into())], Some(Angle::from_si(0.0)), Closing::SingleMove)
                    .unwrap();
            let v = speed / 60.0;
            let expected = web.length_m() / v + 0.5 * (ramps[0] + ramps[1]);
            let duration = motion.duration().si();
            assert!((duration / expected - 1.0).abs() < 1e-9, "{duration} {expected}");
            let grow = if to > from { 1.0 } else { -1.0 };
            let course = |t: f64| {
                let end = duration - t;
                if t < ramps[0] {
                    v * t / ramps[0]
                } else if end < ramps[1] {
                    v * end / ramps[1]
                } else {
                    v
                }
            };
            // Direct integral by the rule of Runge and Kutta: the rate of the angle follows from angle and time alone.
            let radius = |q: f64| 0.5e-3 * from + grow * thickness * 1e-3 * q / TAU;
            let rate = |t: f64, q: f64| course(t) / radius(q);
            let whole_rad = (to - from).abs() / (2.0 * thickness) * TAU;
            let (mut q, mut t) = (0.0, 0.0);
            let corners = [ramps[0], duration - ramps[1], duration];
            for corner in corners {
                let steps = 4000.0;
                let h = (corner - t) / steps;
                let start = t;
                let mut k = 0.0;
                while k < steps {
                    let at = start + k * h;
                    let a = rate(at, q);
                    let b = rate(at + 0.5 * h, q + 0.5 * h * a);
                    let c = rate(at + 0.5 * h, q + 0.5 * h * b);
                    let d = rate(at + h, q + h * c);
                    q += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
                    k += 1.0;
                    t = at + h;
                    if k % 40.0 == 0.0 {
                        let piece = motion.pieces().iter().rfind(|piece| piece.start_s <= t).unwrap();
                        let state = piece.at((t - piece.start_s).min(piece.duration_s));
                        assert!(
                            (state.position_rad - q).abs() <= 4e-9 * whole_rad,
                            "{from} {t}: {} {q}",
                            state.position_rad
                        );
                        let line = state.speed_rad_s * radius(state.position_rad);
                        assert!((line - course(t)).abs() <= 1e-6 * v, "{from} {t}: {line} {}", course(t));
                    }
                }
            }
            let turns = (to - from).abs() / (2.0 * thickness);
            assert!((q / TAU / turns - 1.0).abs() < 1e-7, "{q} {turns}");
        }
    }

    #[test]
    fn a_web_that_is_shorter_than_its_ramps_is_refused() {
        let short = web(90.0, 100.0, 1.0, 600.0, [5.0, 5.0]);
        let Err(WebFault::TooShort { length_m, ramps_m }) = short.points() else { panic!("{short:?}") };
        assert!((length_m - PI * (0.05_f64.powi(2) - 0.045_f64.powi(2)) / 1e-3).abs() < 1e-9 && ramps_m == 50.0);
        assert_eq!(web(90.0, 330.0, 1.0, 0.0, [1.0, 1.0]).points(), Err(WebFault::NoSpeed));
        let fault = WebFault::NoTimeToChangeSpeed { braking: true };
        assert_eq!(web(90.0, 330.0, 1.0, 9.0, [1.0, 0.0]).points(), Err(fault));
    }
}

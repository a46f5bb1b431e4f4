//! The gear as a spring: torsion of three parts, hysteresis by Maxwell-slip elements, kinematic error.

use actuator::Torsion;
use quantities::Measure;
use std::f64::consts::TAU;

/// Elements of the hysteresis.
pub(crate) const ELEMENTS: usize = 3;

/// Slip distances of the elements over half the lost motion. A guess of ours: the transition is spread evenly about it.
const SLIP: [f64; ELEMENTS] = [0.5, 1.0, 1.5];

/// The torsion curve as plain numbers.
///
/// T(φ) of [`Torsion`], and V(φ) = ∫ T dφ, the energy that it stores
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spring {
    stiffness: [f64; 3],
    corner_rad: [f64; 2],
    /// T = offset + K φ beyond the corners.
    offset_nm: [f64; 2],
}

impl Spring {
    pub(crate) fn of(torsion: &Torsion) -> Self {
        let stiffness = torsion.stiffness.map(Measure::si);
        let torque = [torsion.torque_1.si(), torsion.torque_2.si()];
        let corner_rad = [torsion.angle(torsion.torque_1).si(), torsion.angle(torsion.torque_2).si()];
        let [_, k2, k3] = stiffness;
        let offset_nm = [torque[0] - k2 * corner_rad[0], torque[1] - k3 * corner_rad[1]];
        Self { stiffness, corner_rad, offset_nm }
    }

    /// T(φ) \[Nm\].
    #[inline]
    pub(crate) fn torque(&self, phi: f64) -> f64 {
        let size = phi.abs();
        let [k1, k2, k3] = self.stiffness;
        let torque = if size <= self.corner_rad[0] {
            return k1 * phi;
        } else if size <= self.corner_rad[1] {
            self.offset_nm[0] + k2 * size
        } else {
            self.offset_nm[1] + k3 * size
        };
        torque.copysign(phi)
    }

    /// φ(T) \[rad\], the inverse.
    pub(crate) fn angle(&self, torque: f64) -> f64 {
        let [k1, k2, k3] = self.stiffness;
        let [t1, t2] = [k1 * self.corner_rad[0], self.offset_nm[0] + k2 * self.corner_rad[1]];
        let size = torque.abs();
        let angle = if size <= t1 {
            size / k1
        } else if size <= t2 {
            (size - self.offset_nm[0]) / k2
        } else {
            (size - self.offset_nm[1]) / k3
        };
        angle.copysign(torque)
    }

    /// V(φ) \[J\].
    pub(crate) fn energy(&self, phi: f64) -> f64 {
        let [k1, k2, k3] = self.stiffness;
        let ([c1, c2], [o1, o2]) = (self.corner_rad, self.offset_nm);
        let size = phi.abs();
        let part = |from: f64, to: f64, offset: f64, k: f64| (to - from) * (offset + 0.5 * k * (to + from));
        let first = part(0.0, size.min(c1), 0.0, k1);
        let second = if size > c1 { part(c1, size.min(c2), o1, k2) } else { 0.0 };
        let third = if size > c2 { part(c2, size, o2, k3) } else { 0.0 };
        first + second + third
    }

    /// The largest of the three stiffnesses.
    pub(crate) fn stiffest(&self) -> f64 {
        self.stiffness.into_iter().fold(0.0, f64::max)
    }

    /// The stiffness at an angle.
    pub(crate) fn stiffness_at(&self, phi: f64) -> f64 {
        let [k1, k2, k3] = self.stiffness;
        if phi.abs() <= self.corner_rad[0] {
            k1
        } else if phi.abs() <= self.corner_rad[1] {
            k2
        } else {
            k3
        }
    }
}

/// Hysteresis as Maxwell-slip: springs in parallel to the torsion curve, each of which slips at its force.
///
/// F_j = clamp(F_j0 + k_j (φ − φ_0), ±W_j), Σ W = K_1 H/2, k_j = W_j/(s_j L/2)
///
/// # Symbols
/// H hysteresis loss \[rad\]: width of the torsion curve at no torque after full torque to both sides, L lost motion \[rad\],
/// K_1 stiffness of the first region [Nm/rad], s_j spread of the slip
/// # Source
/// Maxwell-slip model (Iwan 1966; for strain-wave gears Tjahjowidodo, Al-Bender, Van Brussel, Mechatronics 23, 2013); H and L
/// of tables 54.1 and 54.2
/// # Valid
/// rate-independent; printed are upper bounds of H and L
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hysteresis {
    pub(crate) stiffness: [f64; ELEMENTS],
    pub(crate) slip_nm: [f64; ELEMENTS],
}

impl Hysteresis {
    pub(crate) fn of(spring: &Spring, loss_rad: f64, lost_motion_rad: f64) -> Self {
        #[allow(clippy::cast_precision_loss, reason = "three")]
        let each = 0.5 * spring.stiffness[0] * loss_rad / ELEMENTS as f64;
        Self {
            stiffness: SLIP.map(|slip| if each > 0.0 { each / (slip * 0.5 * lost_motion_rad) } else { 0.0 }),
            slip_nm: [each; ELEMENTS],
        }
    }

    pub(crate) fn none() -> Self {
        Self { stiffness: [0.0; ELEMENTS], slip_nm: [0.0; ELEMENTS] }
    }

    /// Σ F after a twist by Δφ from the forces of its start \[Nm\].
    #[inline]
    pub(crate) fn torque(&self, force: &[f64; ELEMENTS], twist: f64) -> f64 {
        let mut sum = 0.0;
        for ((f, k), w) in force.iter().zip(&self.stiffness).zip(&self.slip_nm) {
            // Not `clamp`, whose check of its bounds costs more than it does.
            sum += (f + k * twist).max(-w).min(*w);
        }
        sum
    }

    /// Takes a twist over into the forces; returns the energy that slipping has turned into heat \[J\].
    #[inline]
    pub(crate) fn advance(&self, force: &mut [f64; ELEMENTS], twist: f64) -> f64 {
        let mut lost = 0.0;
        for ((f, k), w) in force.iter_mut().zip(&self.stiffness).zip(&self.slip_nm) {
            let tried = *f + k * twist;
            let held = tried.max(-w).min(*w);
            if held != tried {
                lost += w * (tried - held).abs() / k;
            }
            *f = held;
        }
        lost
    }

    /// Σ F²/2k: what the elements store \[J\].
    pub(crate) fn energy(&self, force: &[f64; ELEMENTS]) -> f64 {
        let each = force.iter().zip(&self.stiffness);
        each.map(|(f, k)| if *k > 0.0 { 0.5 * f * f / k } else { 0.0 }).sum()
    }
}

/// Kinematic error of the gear: how far the output leads the ideal transmission at an angle of the input.
///
/// e(θ) = a_1 sin(α + φ_1) + a_2 sin(2α + φ_2) + a_4 sin(4α + φ_4) + a_o sin(θ + φ_o), α = i θ; max e − min e over one turn of the
/// output is the transmission accuracy
///
/// # Symbols
/// θ angle of the motor over i \[rad\], α angle of the wave generator \[rad\], a amplitudes in the ratio of the stated shares
/// # Source
/// lines: Tuttle, MIT 1992; Ghorbel, Gandhi, Alpeter, ASME J. Mech. Des. 123 (2001); main line twice per turn of the wave
/// generator. Shares and phases are ours.
/// # Valid
/// unloaded gear
#[derive(Clone, Copy, Debug)]
pub(crate) struct KinematicError {
    ratio: f64,
    /// Amplitude times sine and cosine of the phase, of the lines 1, 2 and 4.
    lines: [[f64; 2]; 3],
    /// Of the line of the output.
    out: [f64; 2],
}

/// Taylor's series of a kinematic error about one angle, in the angle of the wave generator.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Anchor {
    theta: f64,
    ratio: f64,
    value: [f64; 8],
    slope: [f64; 7],
}

impl Anchor {
    /// e and de/dθ at an angle within 0.07 rad of the wave generator: below 1e-9 of the error.
    #[inline]
    pub(crate) fn at(&self, theta: f64) -> (f64, f64) {
        let x = self.ratio * (theta - self.theta);
        let (y, [a, b, c, d, e, f, g, h]) = (x * x, self.value);
        let value = (a + b * x) + y * ((c + d * x) + y * ((e + f * x) + y * (g + h * x)));
        let [b, c, d, e, f, g, h] = self.slope;
        let slope = (b + c * x) + y * ((d + e * x) + y * ((f + g * x) + y * h));
        (value, slope)
    }
}

impl KinematicError {
    /// The error that spans an accuracy, with lines in the ratio of these shares and phases [rad].
    pub(crate) fn spanning(accuracy_rad: f64, ratio: f64, shares: [f64; 4], phases: [f64; 4]) -> Option<Self> {
        if accuracy_rad <= 0.0 || shares.iter().all(|share| *share == 0.0) {
            return None;
        }
        let line = |place: usize| {
            let share = shares.get(place).copied().unwrap_or(0.0);
            let (sin, cos) = phases.get(place).copied().unwrap_or(0.0).sin_cos();
            [share * sin, share * cos]
        };
        let unit = Self { ratio, lines: [line(0), line(1), line(2)], out: line(3) };
        // Sixty-four samples a turn of the wave generator: the span is found to a thousandth.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most some ten thousand")]
        let samples = (64.0 * ratio).clamp(64.0, 65_536.0) as u32;
        let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
        for k in 0..samples {
            let (error, _) = unit.at(TAU * f64::from(k) / f64::from(samples));
            ends = (ends.0.min(error), ends.1.max(error));
        }
        let factor = accuracy_rad / (ends.1 - ends.0);
        let scaled = |line: [f64; 2]| line.map(|part| factor * part);
        Some(Self { lines: unit.lines.map(scaled), out: scaled(unit.out), ..unit })
    }

    pub(crate) fn anchor(&self, theta: f64) -> Anchor {
        let [one, out] = [self.ratio * theta, theta].map(f64::sin_cos);
        let double = |(s, c): (f64, f64)| (2.0 * s * c, 1.0 - 2.0 * s * s);
        let two = double(one);
        let [l1, l2, l4] = self.lines;
        let lines = [(l1, one, 1.0), (l2, two, 2.0), (l4, double(two), 4.0), (self.out, out, 1.0 / self.ratio)];
        let mut value = [0.0; 8];
        for ([a, b], (s, c), times) in lines {
            // a sin(x + φ) = (a cos φ) sin x + (a sin φ) cos x; each derivative turns it by a quarter.
            let (mut now, mut next) = (b * s + a * c, b * c - a * s);
            for (coefficient, over) in value.iter_mut().zip(FACTORIALS) {
                *coefficient += now * over;
                (now, next) = (times * next, -times * now);
            }
        }
        let mut slope = [0.0; 7];
        for ((slope, value), power) in
            slope.iter_mut().zip(value.iter().skip(1)).zip([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0])
        {
            *slope = self.ratio * power * value;
        }
        Anchor { theta, ratio: self.ratio, value, slope }
    }

    /// e and de/dθ at an angle.
    pub(crate) fn at(&self, theta: f64) -> (f64, f64) {
        self.anchor(theta).at(theta)
    }
}

/// 1/n!
const FACTORIALS: [f64; 8] = [1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0, 1.0 / 5040.0];

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::{Torque, TorsionalStiffness};

    /// CHA-20A-100, tables 54.1 and 54.3.
    fn spring() -> Spring {
        Spring::of(&torsion())
    }

    fn torsion() -> Torsion {
        Torsion {
            torque_1: Torque::from_si(7.0),
            torque_2: Torque::from_si(25.0),
            stiffness: [16e3, 25e3, 29e3].map(TorsionalStiffness::from_si),
        }
    }

    const MINUTE: f64 = TAU / 21_600.0;

    #[test]
    fn the_spring_is_the_torsion_of_the_actuator() {
        for step in -120..=120 {
            let torque = 0.5 * f64::from(step);
            let angle = torsion().angle(Torque::from_si(torque)).si();
            assert!((spring().torque(angle) - torque).abs() < 1e-10);
            assert!((spring().angle(torque) - angle).abs() < 1e-16);
            // The energy is the integral of the torque: by Simpson's rule over small steps.
            let n = 2000;
            let h = angle / f64::from(n);
            let sum: f64 = (0..n).map(|k| h * spring().torque(h * (f64::from(k) + 0.5))).sum();
            assert!((spring().energy(angle) - sum).abs() < 1e-6 * sum.abs() + 1e-15, "{torque}");
        }
    }

    /// After ±60 Nm the curve is as wide at no torque as the table prints: 1 arcmin; a loop of a twentieth of the rated torque
    /// stays within the printed lost motion of 1 arcmin, and means of both branches are the printed torsion.
    #[test]
    fn hysteresis_and_lost_motion_span_the_table() {
        let (spring, hysteresis) = (spring(), Hysteresis::of(&spring(), MINUTE, MINUTE));
        let mut force = [0.0; ELEMENTS];
        let (mut phi, lost) = (0.0, std::cell::Cell::new(0.0));
        let mut turn_to = |torque: f64, force: &mut [f64; ELEMENTS]| {
            let step = 1e-8_f64.copysign(torque - (spring.torque(phi) + hysteresis.torque(force, 0.0)));
            while (torque - (spring.torque(phi) + hysteresis.torque(force, 0.0))) * step > 0.0 {
                lost.set(lost.get() + hysteresis.advance(force, step));
                phi += step;
            }
            phi
        };
        turn_to(60.0, &mut force);
        let unloading = [40.0, 0.0].map(|torque| turn_to(torque, &mut force));
        turn_to(-60.0, &mut force);
        let loading = [0.0, 40.0].map(|torque| turn_to(torque, &mut force));
        assert!(((unloading[1] - loading[0]) / MINUTE - 1.0).abs() < 1e-3, "{}", (unloading[1] - loading[0]) / MINUTE);
        let mean = 0.5 * (unloading[0] + loading[1]);
        assert!((mean / torsion().angle(Torque::from_si(40.0)).si() - 1.0).abs() < 1e-3);
        // Area of the loop: the loss. W times the way of each element, to both sides, within the slip of each.
        turn_to(60.0, &mut force);
        let way = 2.0 * (spring.angle(60.0) - spring.angle(-60.0));
        let most = 0.5 * 16e3 * MINUTE * way;
        let lost = lost.get();
        assert!(lost < most * 1.3 && lost > most * 0.5, "{lost} {most}");
        let small = 0.04 * 40.0;
        let ends = [small, -small].map(|torque| turn_to(torque, &mut force));
        assert!((ends[0] - ends[1]).abs() < 1.5 * MINUTE, "{}", (ends[0] - ends[1]) / MINUTE);
        let ends = [small, -small, small].map(|torque| turn_to(torque, &mut force));
        assert!((ends[2] - ends[1]).abs() < MINUTE, "{}", (ends[2] - ends[1]) / MINUTE);
    }

    #[test]
    fn the_kinematic_error_spans_the_accuracy_and_its_slope_is_its_derivative() {
        let error =
            KinematicError::spanning(0.8 * MINUTE, 100.0, [0.15, 0.5, 0.1, 0.25], [0.3, 1.9, 4.0, 5.5]).unwrap();
        let all: Vec<f64> = (0..100_000).map(|k| error.at(TAU * f64::from(k) / 1e5).0).collect();
        let (low, high) = all.iter().fold((0.0_f64, 0.0_f64), |(a, b), e| (a.min(*e), b.max(*e)));
        assert!(((high - low) / (0.8 * MINUTE) - 1.0).abs() < 2e-3);
        for theta in [0.0, 0.7, -3.1, 40.0] {
            let anchor = error.anchor(theta);
            for step in [0.0, 1e-4, -7e-4] {
                let ((near, slope), (own, _)) = (anchor.at(theta + step), error.at(theta + step));
                assert!((near - own).abs() < 1e-13, "{near} {own}");
                let h = 1e-6;
                let difference = (error.at(theta + step + h).0 - error.at(theta + step - h).0) / (2.0 * h);
                assert!((slope - difference).abs() < 1e-7 * slope.abs() + 1e-9, "{slope} {difference}");
            }
        }
        // The main line: half the shares at twice the wave generator.
        let of = |periods: f64| {
            let n = 40_000;
            let (mut s, mut c) = (0.0, 0.0);
            for k in 0..n {
                let theta = TAU * f64::from(k) / f64::from(n);
                s += error.at(theta).0 * (periods * theta).sin();
                c += error.at(theta).0 * (periods * theta).cos();
            }
            s.hypot(c)
        };
        assert!((of(200.0) / of(100.0) - 0.5 / 0.15).abs() < 1e-6 && (of(200.0) / of(1.0) - 2.0).abs() < 1e-6);
        assert!(KinematicError::spanning(0.0, 100.0, [1.0; 4], [0.0; 4]).is_none());
    }
}

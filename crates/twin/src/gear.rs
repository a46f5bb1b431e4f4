//! The gear as a spring: torsion with three regions, hysteresis by Maxwell-slip elements, kinematic error.

use actuator::Torsion;
use quantities::Measure;
use std::f64::consts::TAU;

/// Number of hysteresis elements.
pub(crate) const ELEMENTS: usize = 3;

/// Slip distances of the elements over half the lost motion \[1\]. A guess: the transition is spread evenly about it.
const SLIP: [f64; ELEMENTS] = [0.5, 1.0, 1.5];

/// The torsion curve as plain numbers.
///
/// T(φ) of [`Torsion`], and V(φ) = ∫ T dφ, the stored energy
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spring {
    stiffness: [f64; 3],
    corner_rad: [f64; 2],
    /// Intercepts of the outer regions: T = offset + K φ beyond the corners \[Nm\].
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

    /// Returns T(φ) \[Nm\], the stiffness at φ, and the range of twist in which it is constant.
    #[inline]
    pub(crate) fn part(&self, phi: f64) -> (f64, f64, [f64; 2]) {
        let ([k1, k2, k3], [c1, c2]) = (self.stiffness, self.corner_rad);
        let size = phi.abs();
        if size <= c1 {
            return (k1 * phi, k1, [-c1, c1]);
        }
        let ([o1, o2], side) = (self.offset_nm, 1.0_f64.copysign(phi));
        let (torque, k, [near, far]) =
            if size <= c2 { (o1 + k2 * size, k2, [c1, c2]) } else { (o2 + k3 * size, k3, [c2, f64::INFINITY]) };
        (torque * side, k, if side > 0.0 { [near, far] } else { [-far, -near] })
    }

    /// Returns φ(T) \[rad\], the inverse.
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

    /// Returns V(φ), the stored energy \[J\].
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

    /// Returns the largest of the three stiffnesses.
    pub(crate) fn stiffest(&self) -> f64 {
        self.stiffness.into_iter().fold(0.0, f64::max)
    }

    /// Returns the stiffness at an angle.
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

/// Maxwell-slip model of the hysteresis: springs in parallel to the torsion curve, each slipping at its force limit.
///
/// F_j = clamp(F_j0 + k_j (φ − φ_0), ±W_j), Σ W = K_1 H/2, k_j = W_j/(s_j L/2)
///
/// # Symbols
/// H hysteresis loss \[rad\]: width of the torsion curve at zero torque after full torque in both directions, L lost
/// motion \[rad\], K_1 stiffness of the first region [Nm/rad], s_j spread of the slip
/// # Source
/// Maxwell-slip model (Iwan 1966; for strain-wave gears Tjahjowidodo, Al-Bender, Van Brussel, Mechatronics 23, 2013); H and L
/// of tables 54.1 and 54.2
/// # Valid
/// rate-independent; the tables state upper bounds of H and L
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hysteresis {
    pub(crate) stiffness: [f64; ELEMENTS],
    pub(crate) slip_nm: [f64; ELEMENTS],
    /// 1/k of each element; infinite if it is absent.
    pub(crate) compliance: [f64; ELEMENTS],
}

impl Hysteresis {
    pub(crate) fn of(spring: &Spring, loss_rad: f64, lost_motion_rad: f64) -> Self {
        #[allow(clippy::cast_precision_loss, reason = "three")]
        let each = 0.5 * spring.stiffness[0] * loss_rad / ELEMENTS as f64;
        let stiffness = SLIP.map(|slip| if each > 0.0 { each / (slip * 0.5 * lost_motion_rad) } else { 0.0 });
        Self { stiffness, slip_nm: [each; ELEMENTS], compliance: stiffness.map(f64::recip) }
    }

    pub(crate) fn none() -> Self {
        Self { stiffness: [0.0; ELEMENTS], slip_nm: [0.0; ELEMENTS], compliance: [f64::INFINITY; ELEMENTS] }
    }

    /// Applies a change of twist to the forces; returns the energy dissipated by slipping \[J\].
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

    /// Returns Σ F²/2k, the energy stored in the elements \[J\].
    pub(crate) fn energy(&self, force: &[f64; ELEMENTS]) -> f64 {
        let each = force.iter().zip(&self.stiffness);
        each.map(|(f, k)| if *k > 0.0 { 0.5 * f * f / k } else { 0.0 }).sum()
    }
}

/// Kinematic error of the gear: lead of the output over the ideal transmission at an angle of the input.
///
/// e(θ) = a_1 sin(α + φ_1) + a_2 sin(2α + φ_2) + a_4 sin(4α + φ_4) + a_o sin(θ + φ_o), α = i θ; max e − min e over one
/// turn of the output is the transmission accuracy
///
/// # Symbols
/// θ angle of the motor over i \[rad\], α angle of the wave generator \[rad\], a amplitudes in the ratio of the stated
/// shares
/// # Source
/// lines: Tuttle, MIT 1992; Ghorbel, Gandhi, Alpeter, ASME J. Mech. Des. 123 (2001); main line twice per turn of the
/// wave generator. Shares and phases are chosen by antrieb.
/// # Valid
/// unloaded gear
#[derive(Clone, Copy, Debug)]
pub(crate) struct KinematicError {
    ratio: f64,
    /// Amplitude times sine and cosine of the phase, for the lines 1, 2 and 4.
    lines: [[f64; 2]; 3],
    /// Amplitude times sine and cosine of the phase, for the line of the output.
    out: [f64; 2],
}

/// Taylor series of a kinematic error and its derivatives about one angle, in the angle of the wave generator.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Anchor {
    theta: f64,
    ratio: f64,
    value: [f64; 6],
    slope: [f64; 5],
    bend: [f64; 4],
    third: [f64; 3],
}

/// Range of validity of an anchor in the angle of the wave generator \[rad\]: error below 1e-9 of the kinematic error.
const NEAR_RAD: f64 = 0.022;

/// Largest distance of a new anchor ahead of the angle \[rad\].
const AHEAD_RAD: f64 = 0.02;

impl Anchor {
    /// Returns the anchor of a gear without kinematic error.
    pub(crate) const fn none() -> Self {
        Self { theta: 0.0, ratio: 0.0, value: [0.0; 6], slope: [0.0; 5], bend: [0.0; 4], third: [0.0; 3] }
    }

    /// Returns `true` if the anchor is valid at an angle.
    #[inline]
    pub(crate) fn is_near(&self, theta: f64) -> bool {
        (self.ratio * (theta - self.theta)).abs() <= NEAR_RAD
    }

    /// Returns e and its first three derivatives with respect to θ.
    #[inline(always)]
    pub(crate) fn at(&self, theta: f64) -> (f64, f64, f64, f64) {
        let x = self.ratio * (theta - self.theta);
        let (y, [a, b, c, d, e, f]) = (x * x, self.value);
        let value = (a + b * x) + y * ((c + d * x) + y * (e + f * x));
        let [b, c, d, e, f] = self.slope;
        let slope = (b + c * x) + y * ((d + e * x) + y * f);
        let [c, d, e, f] = self.bend;
        let bend = (c + d * x) + y * (e + f * x);
        let [d, e, f] = self.third;
        let third = (d + e * x) + y * f;
        (value, slope, bend, third)
    }
}

impl KinematicError {
    /// Creates the error whose range is an accuracy, with lines in the ratio of these shares and phases [rad].
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
        // Sixty-four samples per turn of the wave generator determine the range to a thousandth.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most some ten thousand")]
        let samples = (64.0 * ratio).clamp(64.0, 65_536.0) as u32;
        let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
        for k in 0..samples {
            let error = unit.at(TAU * f64::from(k) / f64::from(samples));
            ends = (ends.0.min(error), ends.1.max(error));
        }
        let factor = accuracy_rad / (ends.1 - ends.0);
        let scaled = |line: [f64; 2]| line.map(|part| factor * part);
        Some(Self { lines: unit.lines.map(scaled), out: scaled(unit.out), ..unit })
    }

    /// Returns the series about an angle.
    pub(crate) fn anchor(&self, theta: f64) -> Anchor {
        let [one, out] = [self.ratio * theta, theta].map(f64::sin_cos);
        let double = |(s, c): (f64, f64)| (2.0 * s * c, 1.0 - 2.0 * s * s);
        let two = double(one);
        let [l1, l2, l4] = self.lines;
        let lines = [(l1, one, 1.0), (l2, two, 2.0), (l4, double(two), 4.0), (self.out, out, 1.0 / self.ratio)];
        let mut value = [0.0; 6];
        for ([a, b], (s, c), times) in lines {
            // a sin(x + φ) = (a cos φ) sin x + (a sin φ) cos x; each derivative rotates it by a quarter turn.
            let (mut now, mut next) = (b * s + a * c, b * c - a * s);
            for (coefficient, over) in value.iter_mut().zip(FACTORIALS) {
                *coefficient += now * over;
                (now, next) = (times * next, -times * now);
            }
        }
        let slope: [f64; 5] = derived(&value, self.ratio);
        let bend: [f64; 4] = derived(&slope, self.ratio);
        Anchor { theta, ratio: self.ratio, value, slope, bend, third: derived(&bend, self.ratio) }
    }

    /// Returns the series ahead of an angle moving at a speed [rad/s].
    pub(crate) fn anchor_ahead(&self, theta: f64, speed_rad_s: f64, time_s: f64) -> Anchor {
        let most = AHEAD_RAD / self.ratio;
        self.anchor(theta + (speed_rad_s * time_s).max(-most).min(most))
    }

    /// Returns e at an angle.
    pub(crate) fn at(&self, theta: f64) -> f64 {
        self.anchor(theta).at(theta).0
    }
}

/// Returns the coefficients of the derivative of a polynomial in x with respect to θ = x/ratio.
fn derived<const N: usize>(of: &[f64], ratio: f64) -> [f64; N] {
    let mut slope = [0.0; N];
    for ((slope, value), power) in slope.iter_mut().zip(of.iter().skip(1)).zip(1_u8..) {
        *slope = ratio * f64::from(power) * value;
    }
    slope
}

/// 1/n! for n = 0…5.
const FACTORIALS: [f64; 6] = [1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0];

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::{Torque, TorsionalStiffness};

    /// CHA-20A-100, tables 54.1 and 54.3.
    fn spring() -> Spring {
        Spring::of(&torsion())
    }

    impl Spring {
        fn torque(&self, phi: f64) -> f64 {
            self.part(phi).0
        }
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
            // The energy is the integral of the torque, by Simpson's rule over small steps.
            let n = 2000;
            let h = angle / f64::from(n);
            let sum: f64 = (0..n).map(|k| h * spring().torque(h * (f64::from(k) + 0.5))).sum();
            assert!((spring().energy(angle) - sum).abs() < 1e-6 * sum.abs() + 1e-15, "{torque}");
        }
    }

    /// After ±60 Nm the width of the curve at zero torque is that of the tables, 1 arcmin; a loop of a twentieth of the
    /// rated torque stays within the lost motion of the tables, 1 arcmin, and the means of both branches are the
    /// torsion of the manual.
    #[test]
    fn hysteresis_and_lost_motion_span_the_table() {
        let (spring, hysteresis) = (spring(), Hysteresis::of(&spring(), MINUTE, MINUTE));
        let mut force = [0.0; ELEMENTS];
        let (mut phi, lost) = (0.0, std::cell::Cell::new(0.0));
        let mut turn_to = |torque: f64, force: &mut [f64; ELEMENTS]| {
            let step = 1e-8_f64.copysign(torque - (spring.torque(phi) + force.iter().sum::<f64>()));
            while (torque - (spring.torque(phi) + force.iter().sum::<f64>())) * step > 0.0 {
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
        // The area of the loop is the loss: W times the travel of each element in both directions, less its slip
        // distance.
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
        let all: Vec<f64> = (0..100_000).map(|k| error.at(TAU * f64::from(k) / 1e5)).collect();
        let (low, high) = all.iter().fold((0.0_f64, 0.0_f64), |(a, b), e| (a.min(*e), b.max(*e)));
        assert!(((high - low) / (0.8 * MINUTE) - 1.0).abs() < 2e-3);
        for theta in [0.0, 0.7, -3.1, 40.0] {
            let anchor = error.anchor(theta);
            for step in [0.0, 1e-4, -2e-4] {
                let ((near, slope, bend, third), own) = (anchor.at(theta + step), error.at(theta + step));
                assert!((near - own).abs() < 1e-13, "{near} {own}");
                let h = 1e-6;
                let difference = (error.at(theta + step + h) - error.at(theta + step - h)) / (2.0 * h);
                assert!((slope - difference).abs() < 1e-7 * slope.abs() + 1e-9, "{slope} {difference}");
                let [ahead, back] = [h, -h].map(|h| anchor.at(theta + step + h));
                assert!((bend - (ahead.1 - back.1) / (2.0 * h)).abs() < 1e-6 * bend.abs() + 1e-7, "{bend}");
                assert!((third - (ahead.2 - back.2) / (2.0 * h)).abs() < 1e-6 * third.abs() + 1e-5, "{third}");
            }
        }
        // The main line: half the shares at twice the wave generator.
        let of = |periods: f64| {
            let n = 40_000;
            let (mut s, mut c) = (0.0, 0.0);
            for k in 0..n {
                let theta = TAU * f64::from(k) / f64::from(n);
                s += error.at(theta) * (periods * theta).sin();
                c += error.at(theta) * (periods * theta).cos();
            }
            s.hypot(c)
        };
        assert!((of(200.0) / of(100.0) - 0.5 / 0.15).abs() < 1e-6 && (of(200.0) / of(1.0) - 2.0).abs() < 1e-6);
        assert!(KinematicError::spanning(0.0, 100.0, [1.0; 4], [0.0; 4]).is_none());
    }
}

//! Deviation of an encoder from the true angle: a bounded sum of harmonics.

use numeric::Random;
use quantities::{Angle, Measure};
use std::f64::consts::{PI, TAU};

/// Orders of the long-period part \[1/turn\].
const ORDERS: [f64; 6] = [1.0, 2.0, 3.0, 4.0, 6.0, 8.0];

/// Share of the accuracy taken by deviations within a signal period, for encoders with sine tracks: assumed.
const SHARE_WITHIN_PERIOD: f64 = 0.1;

/// Samples of the long-period part per turn: 64 for each period of its highest order.
const SAMPLES: u32 = 512;

/// Deviation of one encoder over a turn, determined by a seed.
///
/// δ(φ) = a_0 + Σ a_k sin(kφ + α_k) + b sin(Nφ + β)
///
/// # Symbols
/// φ true angle \[rad\], δ deviation of the measured angle \[rad\], k orders 1 2 3 4 6 8, N periods of the sine tracks
/// per turn
/// # Source
/// Estimated: a sum of harmonics as caused by eccentricity (k = 1) and ovality (k = 2); the manual states only its
/// bound, the accuracy
/// # Valid
/// |δ| never exceeds the accuracy and comes within 0.2 % of it on both sides for every seed. The deviation curve of a
/// real encoder differs.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    constant_rad: f64,
    slow: [(f64, f64); ORDERS.len()],
    within: Option<(f64, f64, f64)>,
}

impl Deviation {
    /// Creates a deviation bounded by ± `accuracy`; `periods` of the sine tracks per turn, if there are any.
    #[must_use]
    pub fn new(accuracy: Angle, periods: Option<u32>, seed: u64) -> Self {
        let mut chance = Random::new(seed);
        let bound = accuracy.si().abs();
        let share = if periods.is_some() { SHARE_WITHIN_PERIOD } else { 0.0 };
        // Low orders dominate: the amplitude decreases with the order.
        let mut slow = ORDERS.map(|order| ((0.5 + 0.5 * chance.uniform()) / order, TAU * chance.uniform()));
        let sample = |slow: &[(f64, f64)], at: u32| sum(slow, TAU * f64::from(at) / f64::from(SAMPLES));
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for at in 0..SAMPLES {
            let value = sample(&slow, at);
            (low, high) = (low.min(value), high.max(value));
        }
        // Between m samples, a sum of orders up to n deviates from its mean c by at most 1/cos(πn/m) times the largest
        // sampled deviation (Ehlich and Zeller 1964).
        let highest = ORDERS.iter().fold(0.0, |a: f64, b| a.max(*b));
        let reach = (high - low) / 2.0 / (PI * highest / f64::from(SAMPLES)).cos();
        let scale = bound * (1.0 - share) / reach;
        for (amplitude, _) in &mut slow {
            *amplitude *= scale;
        }
        let within = periods.map(|periods| (f64::from(periods), bound * share, TAU * chance.uniform()));
        Self { constant_rad: -(high + low) / 2.0 * scale, slow, within }
    }

    /// Returns the deviation at a true angle.
    #[must_use]
    pub fn at(&self, angle: Angle) -> Angle {
        let phi = angle.si();
        let within = self.within.map_or(0.0, |(order, amplitude, phase)| amplitude * (order * phi + phase).sin());
        Angle::from_si(self.constant_rad + sum(&self.slow, phi) + within)
    }

    /// Returns the true angle of a measured one: six steps of the iteration φ = φ_seen − δ(φ), in which the slope of δ
    /// is far below one.
    #[must_use]
    pub fn true_angle(&self, seen: Angle) -> Angle {
        let step = |angle: f64| seen.si() - self.at(Angle::from_si(angle)).si();
        Angle::from_si((0..6).fold(seen.si(), |angle, _| step(angle)))
    }
}

fn sum(slow: &[(f64, f64)], phi: f64) -> f64 {
    slow.iter().zip(ORDERS).map(|((amplitude, phase), order)| amplitude * (order * phi + phase).sin()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use quantities::unit::ARCSECOND;

    #[test]
    fn every_seed_stays_within_the_accuracy_and_reaches_it_on_both_sides() {
        for (accuracy, periods) in [(12.0, Some(1024)), (60.0, Some(512)), (360.0, Some(128)), (600.0, None)] {
            let accuracy = Angle::new_in(accuracy, &ARCSECOND);
            for seed in 0..10 {
                let deviation = Deviation::new(accuracy, periods, seed);
                let (mut low, mut high) = (0.0_f64, 0.0_f64);
                for at in 0..20_011 {
                    let found = deviation.at(Angle::from_si(TAU * f64::from(at) / 20_011.0)).si();
                    (low, high) = (low.min(found), high.max(found));
                }
                assert!(high <= accuracy.si() && -low <= accuracy.si(), "seed {seed}");
                assert!(high > 0.99 * accuracy.si() && -low > 0.99 * accuracy.si(), "seed {seed}: {low} {high}");
            }
        }
    }

    #[test]
    fn an_angle_is_found_from_what_is_seen_of_it() {
        let deviation = Deviation::new(Angle::new_in(360.0, &ARCSECOND), Some(128), 7);
        for at in 0..1000 {
            let angle = Angle::from_si(f64::from(at) * 0.01);
            let seen = angle + deviation.at(angle);
            assert!((deviation.true_angle(seen).si() - angle.si()).abs() < 1e-9);
        }
        assert_ne!(deviation, Deviation::new(Angle::new_in(360.0, &ARCSECOND), Some(128), 8));
    }
}

//! Sine and cosine tracks: generation, correction and interpolation.

use quantities::{Angle, ElectricPotential, Measure};
use std::f64::consts::{PI, TAU};

/// A peak-to-peak level with its tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Nominal level.
    pub nominal: ElectricPotential,
    /// Lowest and highest level; `None` if the manual states no tolerance.
    pub bounds: Option<[ElectricPotential; 2]>,
}

/// Two sinusoidal tracks; the first leads by a quarter period while the angle increases.
///
/// u_1 = û cos(Nφ),  u_2 = û sin(Nφ),  û = u_pp/2
///
/// # Symbols
/// N periods per turn, φ angle measured by the encoder \[rad\], u_pp level peak to peak \[V\]
/// # Source
/// Levels and periods: cha-manual tables 57.1, 58.1, 59.1, 68.1. Table 66.6 names A COS and B SIN; for the other
/// encoders the same order of the tracks is assumed
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SinePair {
    /// Periods per turn.
    pub periods: u32,
    /// Peak-to-peak level; `None` if the manual states none.
    pub level: Option<Span>,
}

impl SinePair {
    /// Returns both tracks at an angle, relative to their amplitude.
    #[must_use]
    pub fn unit(&self, seen: Angle) -> [f64; 2] {
        let (sine, cosine) = (f64::from(self.periods) * seen.si()).sin_cos();
        [cosine, sine]
    }

    /// Returns the amplitude, half of the nominal level.
    #[must_use]
    pub fn amplitude(&self) -> Option<ElectricPotential> {
        self.level.map(|level| ElectricPotential::from_si(level.nominal.si() / 2.0))
    }
}

/// Correction of offset, gain and phase of two tracks that should be cosine and sine.
///
/// x = (u_1 − p)/a,  y = ((u_2 − q)/b − x sin α)/cos α
///
/// # Symbols
/// p, q offsets, a, b amplitudes, α phase lead of the second track \[rad\]
/// # Source
/// Heydemann, Determination and correction of quadrature fringe measurement errors in interferometers, Applied Optics 20 (1981) 3382
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correction {
    offset: [f64; 2],
    gain: [f64; 2],
    phase_rad: f64,
}

impl Correction {
    /// Identity: no correction.
    pub const NONE: Self = Self { offset: [0.0; 2], gain: [1.0; 2], phase_rad: 0.0 };

    /// Returns the correction that maps samples of both tracks to a circle, from the ellipse fitted by least squares.
    ///
    /// A u² + 2 B u v + C v² + 2 D u + 2 E v = 1
    ///
    /// # Source
    /// Heydemann 1981, as above
    /// # Valid
    /// Samples spread over one period or more; `None` if they lie on no ellipse
    #[must_use]
    pub fn fitted(samples: &[[f64; 2]]) -> Option<Self> {
        // Centred and scaled, so that the equations are well conditioned for any unit.
        let extreme =
            |of: fn(&[f64; 2]) -> f64, start: f64, pick: fn(f64, f64) -> f64| samples.iter().map(of).fold(start, pick);
        let [first, second]: [fn(&[f64; 2]) -> f64; 2] = [|s| s[0], |s| s[1]];
        let (low, high) = (extreme(first, f64::INFINITY, f64::min), extreme(first, f64::NEG_INFINITY, f64::max));
        let (below, above) = (extreme(second, f64::INFINITY, f64::min), extreme(second, f64::NEG_INFINITY, f64::max));
        let (middle, half) = ([(low + high) / 2.0, (below + above) / 2.0], [(high - low) / 2.0, (above - below) / 2.0]);
        if !(half[0] > 0.0 && half[1] > 0.0 && half[0].is_finite() && half[1].is_finite()) {
            return None;
        }
        let mut normal = numeric::Symmetric::zero([0; 5].into_iter());
        let mut right = vec![0.0; 5];
        for [u, v] in samples {
            let (u, v) = ((u - middle[0]) / half[0], (v - middle[1]) / half[1]);
            let row = [u * u, 2.0 * u * v, v * v, 2.0 * u, 2.0 * v];
            for (i, (a, sum)) in row.iter().zip(&mut right).enumerate() {
                *sum += a;
                for (j, b) in row.iter().enumerate().take(i + 1) {
                    normal.add(i, j, a * b);
                }
            }
        }
        let found = normal.solve(right)?;
        let [a, b, c, d, e] = *found.first_chunk::<5>()?;
        let det = a * c - b * b;
        if !(det > 0.0 && a > 0.0) {
            return None;
        }
        let (p, q) = ((b * e - c * d) / det, (b * d - a * e) / det);
        let reach = 1.0 + a * p * p + 2.0 * b * p * q + c * q * q;
        let gain = [(c * reach / det).sqrt(), (a * reach / det).sqrt()];
        let sine = -b / (a * c).sqrt();
        let found = Self {
            offset: [middle[0] + p * half[0], middle[1] + q * half[1]],
            gain: [gain[0] * half[0], gain[1] * half[1]],
            phase_rad: sine.asin(),
        };
        let all = [found.offset[0], found.offset[1], found.gain[0], found.gain[1], found.phase_rad];
        all.iter().all(|value| value.is_finite()).then_some(found)
    }

    /// Returns the sample mapped to the circle.
    #[must_use]
    pub fn apply(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = self.phase_rad.sin_cos();
        let (x, y) = ((u - self.offset[0]) / self.gain[0], (v - self.offset[1]) / self.gain[1]);
        [x, (y - x * sine) / cosine]
    }
}

/// Error: two samples are half a period apart or more, so that the direction of rotation is unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MissedPeriod;

/// Decoder of sine tracks: counts periods and interpolates within them.
///
/// φ = (n + atan2(y, x)/2π)/N · 2π, n counted where the arctangent passes ±π
#[derive(Clone, Debug)]
pub struct SineDecoder {
    pair: SinePair,
    steps: u32,
    correction: Correction,
    periods: i64,
    phase_rad: Option<f64>,
}

impl SineDecoder {
    /// Creates a decoder with `steps` interpolation steps per period.
    #[must_use]
    pub const fn new(pair: SinePair, steps: u32, correction: Correction) -> Self {
        Self { pair, steps, correction, periods: 0, phase_rad: None }
    }

    /// Evaluates a sample of both tracks.
    ///
    /// # Errors
    /// The sample is half a period or more from the last one.
    pub fn take(&mut self, sample: [f64; 2]) -> Result<(), MissedPeriod> {
        let [x, y] = self.correction.apply(sample);
        let phase = y.atan2(x);
        if let Some(last) = self.phase_rad.replace(phase) {
            let jump = phase - last;
            if ((jump.abs() - PI).abs()) < 1e-9 {
                return Err(MissedPeriod);
            }
            if jump > PI {
                self.periods -= 1;
            } else if jump < -PI {
                self.periods += 1;
            }
        }
        Ok(())
    }

    /// Returns the angle since the period of the first sample.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "periods of a shaft are far below 2^52")]
    pub fn angle(&self) -> Angle {
        let phase = self.phase_rad.unwrap_or(0.0);
        Angle::from_si((self.periods as f64 * TAU + phase) / f64::from(self.pair.periods))
    }

    /// Returns the steps since the period of the first sample.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, reason = "steps of a period are few")]
    pub fn increments(&self) -> i64 {
        let within = (self.phase_rad.unwrap_or(0.0) / TAU * f64::from(self.steps)).floor() as i64;
        self.periods.saturating_mul(i64::from(self.steps)).saturating_add(within)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAIR: SinePair = SinePair { periods: 128, level: None };

    /// 256 steps in 128 periods are the 32768 steps of table 59.1.
    #[test]
    fn a_turn_has_the_printed_steps_both_ways() {
        for (direction, steps) in [(1.0, 32_768), (-1.0, -32_768)] {
            let mut decoder = SineDecoder::new(PAIR, 256, Correction::NONE);
            for at in 0..=4000 {
                let angle = Angle::from_si(direction * TAU * f64::from(at) / 4000.0 + 1e-6);
                decoder.take(PAIR.unit(angle)).unwrap();
                assert!((decoder.angle().si() - angle.si()).abs() < 1e-9);
            }
            assert_eq!(decoder.increments(), steps);
        }
    }

    #[test]
    fn half_a_period_is_missed() {
        let mut decoder = SineDecoder::new(PAIR, 256, Correction::NONE);
        decoder.take([1.0, 0.0]).unwrap();
        assert_eq!(decoder.take([-1.0, 0.0]), Err(MissedPeriod));
    }

    /// Offset 40 mV and −30 mV, gain 0.6 and 0.45 V, phase 5° are found from six samples and more, in any unit.
    #[test]
    fn offset_gain_and_phase_are_found_and_removed() {
        let phase = 5_f64.to_radians();
        let bent = |phi: f64| [0.04 + 0.6 * phi.cos(), -0.03 + 0.45 * (phi + phase).sin()];
        for count in [6, 7, 100] {
            let samples: Vec<[f64; 2]> = (0..count).map(|at| bent(TAU * f64::from(at) / f64::from(count))).collect();
            let correction = Correction::fitted(&samples).unwrap();
            for at in 0..360 {
                let phi = f64::from(at).to_radians() - 3.1;
                let [x, y] = correction.apply(bent(phi));
                assert!((x - phi.cos()).abs() < 1e-9 && (y - phi.sin()).abs() < 1e-9, "{count}: {x} {y}");
            }
        }
        assert_eq!(Correction::fitted(&[[1.0, 0.0]; 9]), None);
        assert_eq!(Correction::fitted(&[[f64::NAN, 0.0], [1.0, 2.0]]), None);
        assert_eq!(Correction::fitted(&[]), None);
    }
}

//! Recordings computed for tests.

use crate::{Recorded, Samples, Treatment};

/// Pseudorandom numbers, uniform from −1 to 1 and normal.
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    /// Returns the next number, uniform from −1 to 1.
    pub(crate) fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Returns the sum of twelve uniform numbers, with standard deviation 1.
    pub(crate) fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.next()).sum::<f64>() / 2.0
    }
}

/// Returns position and speed of the polynomial 10τ³ − 15τ⁴ + 6τ⁵ from rest to rest.
pub(crate) fn poly(way: f64, duration: f64, t: f64) -> (f64, f64) {
    let x = (t / duration).clamp(0.0, 1.0);
    let q = way * x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
    (q, way / duration * 30.0 * x * x * (1.0 - x) * (1.0 - x))
}

/// A law of motion of which position, speed and acceleration are known in closed form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Law {
    /// Seven phases: eighths with jerk and with constant acceleration, two eighths at constant speed.
    SevenPhase,
    /// Inclined sine.
    Sine,
    /// Trapezoid of thirds.
    Trapezoid,
}

impl Law {
    pub(crate) const ALL: [Self; 3] = [Self::SevenPhase, Self::Sine, Self::Trapezoid];

    /// Returns position, speed and acceleration of a move by one unit in one unit of time.
    pub(crate) fn at(self, x: f64) -> [f64; 3] {
        let x = x.clamp(0.0, 1.0);
        if self == Self::Sine {
            let turn = std::f64::consts::TAU;
            let (sin, cos) = (turn * x).sin_cos();
            return [x - sin / turn, 1.0 - cos, turn * sin];
        }
        if x > 0.5 {
            let [q, w, a] = self.at(1.0 - x);
            return [1.0 - q, w, -a];
        }
        // Duration and jerk of each phase, with a jump of the acceleration before it.
        let phases: [[f64; 3]; 4] = match self {
            Self::Trapezoid => [[1.0 / 3.0, 0.0, 4.5], [1.0, 0.0, -4.5], [0.0; 3], [0.0; 3]],
            _ => [[0.125, 51.2, 0.0], [0.125, 0.0, 0.0], [0.125, -51.2, 0.0], [1.0, 0.0, 0.0]],
        };
        let (mut left, [mut q, mut w, mut a]) = (x, [0.0; 3]);
        for [duration, jerk, jump] in phases {
            let t = duration.min(left);
            a += if left > 0.0 { jump } else { 0.0 };
            q += t * (w + t * (0.5 * a + t * jerk / 6.0));
            w += t * (a + 0.5 * t * jerk);
            a += t * jerk;
            left -= t;
        }
        [q, w, a]
    }

    /// Returns the largest acceleration of [`Self::at`].
    pub(crate) const fn peak(self) -> f64 {
        match self {
            Self::SevenPhase => 6.4,
            Self::Sine => std::f64::consts::TAU,
            Self::Trapezoid => 4.5,
        }
    }

    /// Returns the largest speed of [`Self::at`].
    pub(crate) const fn fastest(self) -> f64 {
        match self {
            Self::SevenPhase => 1.6,
            Self::Sine => 2.0,
            Self::Trapezoid => 1.5,
        }
    }
}

/// A move forth in one second and back in 1.2 s, each after a rest, and a rest.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cycle {
    pub(crate) law: Law,
    /// Distance of both moves \[rad\].
    pub(crate) way: f64,
    /// Duration of each rest \[s\].
    pub(crate) rest: f64,
}

impl Cycle {
    /// Returns the duration \[s\].
    pub(crate) fn duration(self) -> f64 {
        2.2 + 3.0 * self.rest
    }

    /// Returns position, speed and acceleration.
    pub(crate) fn at(self, t: f64) -> [f64; 3] {
        let x = t - self.rest;
        let y = (x - 1.0 - self.rest) / 1.2;
        let inside = |x: f64| if (0.0..=1.0).contains(&x) { 1.0 } else { 0.0 };
        let ([q0, w0, a0], [q1, w1, a1]) = (self.law.at(x), self.law.at(y));
        let (w0, a0, w1, a1) = (w0 * inside(x), a0 * inside(x), w1 * inside(y), a1 * inside(y));
        [self.way * (q0 - q1), self.way * (w0 - w1 / 1.2), self.way * (a0 - a1 / 1.44)]
    }

    /// Returns the largest acceleration.
    pub(crate) fn peak(self) -> f64 {
        self.way * self.law.peak()
    }

    /// Returns the largest speed.
    pub(crate) fn fastest(self) -> f64 {
        self.way * self.law.fastest()
    }

    /// Returns the rms of the acceleration, by a fine sum.
    pub(crate) fn rms(self) -> f64 {
        let count = 20_000_u32;
        let squares = (0..count).map(|k| self.at((f64::from(k) + 0.5) / f64::from(count) * self.duration())[2].powi(2));
        (squares.sum::<f64>() / f64::from(count)).sqrt()
    }

    /// Returns the instants of evenly spaced rows.
    pub(crate) fn rows(self, h: f64) -> Vec<f64> {
        (0..=(self.duration() / h).round() as u32).map(|k| f64::from(k) * h).collect()
    }
}

/// Returns the largest and the rms acceleration of a recorded motion.
pub(crate) fn accelerations(recorded: &Recorded) -> (f64, f64) {
    let pairs = recorded.time_s().windows(2).zip(recorded.speed_rad_s().windows(2));
    let (most, sum) = pairs.fold((0.0_f64, 0.0), |(most, sum), (t, w)| {
        let h = t[1] - t[0];
        let alpha = ((w[1] - w[0]) / h).abs();
        (most.max(alpha), sum + h * alpha * alpha)
    });
    (most, (sum / recorded.duration_s()).sqrt())
}

/// Returns instants, positions and speeds of a move of one second, a rest, the move back and a rest.
pub(crate) fn forth_and_back(h: f64, rest: f64, way: f64) -> [Vec<f64>; 3] {
    let count = ((2.0 + 2.0 * rest) / h).round() as usize + 1;
    let time: Vec<f64> = (0..count).map(|k| k as f64 * h).collect();
    let state = |t: f64| {
        let (forth, back) = (poly(way, 1.0, t), poly(way, 1.0, t - 1.0 - rest));
        (forth.0 - back.0, forth.1 - back.1)
    };
    let position = time.iter().map(|t| state(*t).0).collect();
    let speed = time.iter().map(|t| if state(*t).1.abs() < 1e-15 { 0.0 } else { state(*t).1 }).collect();
    [time, position, speed]
}

/// Returns samples with the columns that are given.
pub(crate) fn samples(time: &[f64], position: Option<&[f64]>, speed: Option<&[f64]>) -> Samples {
    let shared = |values: &[f64]| std::sync::Arc::new(values.to_vec());
    Samples {
        time_s: shared(time),
        position_rad: position.map(shared),
        speed_rad_s: speed.map(shared),
        torque_nm: None,
    }
}

/// Returns the motion of samples without any treatment.
pub(crate) fn recorded(samples: Samples) -> Recorded {
    Recorded::new(samples, Treatment::default()).unwrap()
}

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

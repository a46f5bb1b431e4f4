//! Motion laws: the quantities stated for a move, and the resulting pieces.

use crate::piece::Piece;
use quantities::{Angle, AngularAcceleration, AngularJerk, AngularVelocity, Measure, Time, identified};
use std::f64::consts::PI;

identified! {
    /// Law of motion.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Law {
        /// Constant acceleration, constant speed, constant deceleration.
        Trapezoid = "trapezoid",
        /// Constant acceleration, constant deceleration; quadratic parabola in VDI 2143.
        Triangle = "triangle",
        /// Seven phases of constant jerk; the shortest move within the limits.
        Jerk = "jerk",
        /// Polynomial of the fifth degree (3-4-5), VDI 2143.
        Polynomial5 = "polynomial_5",
        /// Modified sine (Neklutin), VDI 2143.
        ModifiedSine = "modified_sine",
        /// Modified acceleration trapezoid, VDI 2143.
        ModifiedTrapezoid = "modified_trapezoid",
        /// Simple sine (simple harmonic), VDI 2143.
        SimpleSine = "simple_sine",
        /// Inclined sine (cycloid, Bestehorn), VDI 2143.
        InclinedSine = "inclined_sine",
        /// Constant speed.
        Constant = "constant",
    }
}

/// Quantities stated for a move. The sign of distance or speed is the direction; acceleration and jerk are magnitudes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Given {
    /// Angle travelled, signed.
    pub distance: Option<Angle>,
    /// Duration.
    pub time: Option<Time>,
    /// Peak speed; with a distance only its magnitude is used.
    pub speed: Option<AngularVelocity>,
    /// Peak acceleration.
    pub acceleration: Option<AngularAcceleration>,
    /// Peak jerk.
    pub jerk: Option<AngularJerk>,
    /// Speed at the end of the move; `None` for rest.
    pub end_speed: Option<AngularVelocity>,
}

/// A move with all its quantities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solved {
    /// Angle travelled, signed.
    pub distance: Angle,
    /// Duration.
    pub time: Time,
    /// Largest |ω|.
    pub speed: AngularVelocity,
    /// Largest |α|.
    pub acceleration: AngularAcceleration,
}

/// Largest rounding of a distance relative to the positions it is computed from \[1\].
const ROUNDING: f64 = 1e-13;

/// Returns a distance, 0 if it is the rounding of positions up to the farthest: a return to the start.
pub(crate) fn without_rounding(distance: f64, farthest: f64) -> f64 {
    if distance.abs() < ROUNDING * farthest { 0.0 } else { distance }
}

impl Solved {
    /// Returns distance, time, peak speed and peak acceleration of a move.
    pub(crate) fn of(pieces: &[Piece]) -> Self {
        let (mut speed, mut acceleration, mut time) = (0.0_f64, 0.0_f64, 0.0);
        for piece in pieces {
            time += piece.duration_s;
            // The extremes are at the ends or where the acceleration or its derivative vanishes.
            let mut instants = vec![0.0, piece.duration_s];
            if piece.speed_degree().is_none_or(|degree| degree > 1) {
                instants.extend(piece.acceleration_roots());
                instants.extend(piece.jerk_roots());
            }
            for state in instants.into_iter().map(|t| piece.at(t)) {
                speed = speed.max(state.speed_rad_s.abs());
                acceleration = acceleration.max(state.acceleration_rad_s2.abs());
            }
        }
        let start = pieces.first().map_or(0.0, |piece| piece.position_rad);
        let (mut travelled, mut farthest) = (0.0, 0.0_f64);
        for piece in pieces {
            travelled = piece.end().position_rad - start;
            farthest = farthest.max(travelled.abs()).max(start.abs());
        }
        Self {
            distance: Angle::from_si(without_rounding(travelled, farthest)),
            time: Time::from_si(time),
            speed: AngularVelocity::from_si(speed),
            acceleration: AngularAcceleration::from_si(acceleration),
        }
    }
}

impl Law {
    /// Returns C_v = v_max T/s and C_a = a_max T²/s of the normalised law from rest to rest; trapezoid with equal
    /// thirds.
    ///
    /// # Source
    /// VDI 2143-1, characteristic values; derived in docs/theory/motion-laws.md
    #[must_use]
    pub fn characteristics(self) -> (f64, f64) {
        match self {
            Self::Trapezoid => (1.5, 4.5),
            Self::Triangle => (2.0, 4.0),
            // The seven phases have no fixed shape.
            Self::Jerk | Self::Constant => (1.0, 0.0),
            Self::Polynomial5 => (1.875, 10.0 / 3.0_f64.sqrt()),
            Self::ModifiedSine => (4.0 * PI / (4.0 + PI), 4.0 * PI * PI / (4.0 + PI)),
            Self::ModifiedTrapezoid => (2.0, 8.0 * PI / (2.0 + PI)),
            Self::SimpleSine => (PI / 2.0, PI * PI / 2.0),
            Self::InclinedSine => (2.0, 2.0 * PI),
        }
    }

    /// Returns the normalised pieces over a distance s in a time T, from rest to rest.
    pub(crate) fn normalised(self, s: f64, t: f64) -> Vec<Piece> {
        let (_, c_a) = self.characteristics();
        let a = c_a * s / (t * t);
        match self {
            Self::Trapezoid => {
                vec![Piece::ramp(t / 3.0, a), Piece::ramp(t / 3.0, 0.0), Piece::ramp(t / 3.0, -a)]
            }
            Self::Triangle | Self::Jerk | Self::Constant => {
                vec![Piece::ramp(t / 2.0, a), Piece::ramp(t / 2.0, -a)]
            }
            Self::Polynomial5 => vec![Self::quintic(s, t, 0.0, 0.0)],
            Self::SimpleSine => vec![Piece::harmonic(t, a, PI / t, PI / 2.0)],
            Self::InclinedSine => vec![Piece::harmonic(t, a, 2.0 * PI / t, 0.0)],
            Self::ModifiedSine => vec![
                Piece::harmonic(t / 8.0, a, 4.0 * PI / t, 0.0),
                Piece::harmonic(0.75 * t, a, 4.0 * PI / (3.0 * t), PI / 2.0),
                Piece::harmonic(t / 8.0, a, 4.0 * PI / t, 1.5 * PI),
            ],
            Self::ModifiedTrapezoid => vec![
                Piece::harmonic(t / 8.0, a, 4.0 * PI / t, 0.0),
                Piece::ramp(t / 4.0, a),
                Piece::harmonic(t / 4.0, a, 4.0 * PI / t, PI / 2.0),
                Piece::ramp(t / 4.0, -a),
                Piece::harmonic(t / 8.0, a, 4.0 * PI / t, 1.5 * PI),
            ],
        }
    }

    /// Returns the polynomial of the fifth degree with given end speeds and zero acceleration at both ends.
    ///
    /// s(τ) = v_0 T τ + c_3 τ³ + c_4 τ⁴ + c_5 τ⁵, c_3 = 10 s − (6 v_0 + 4 v_1) T, c_4 = −15 s + (8 v_0 + 7 v_1) T,
    /// c_5 = 6 s − 3 (v_0 + v_1) T
    pub(crate) fn quintic(s: f64, t: f64, first: f64, last: f64) -> Piece {
        let c3 = 10.0 * s - (6.0 * first + 4.0 * last) * t;
        let c4 = -15.0 * s + (8.0 * first + 7.0 * last) * t;
        let c5 = 6.0 * s - 3.0 * (first + last) * t;
        let t3 = t * t * t;
        Piece::polynomial(t, [0.0, 6.0 * c3 / t3, 12.0 * c4 / (t3 * t), 20.0 * c5 / (t3 * t * t)])
    }
}

#[cfg(test)]
#[path = "law_tests.rs"]
mod tests;

//! Losses of four actuators as means over a cycle.

use super::catalogue::Four;
use super::figures::{Figures, all};
use wide::f64x4;

/// Means over the cycle from which the losses follow for any friction.
pub(super) struct Means {
    /// Means of I_T², I_T σ and I_T ω.
    square: f64x4,
    direction: f64x4,
    speed: f64x4,
    /// Means of σ², |ω| and ω².
    moving: f64x4,
    travelled: f64x4,
    speed_square: f64x4,
}

impl Means {
    pub(super) fn of(figures: &Figures, four: &Four, square: f64x4) -> Self {
        let [[_, _, a_s, a_w], [_, _, t_s, t_w], [_, _, moving, travelled], [.., w_w]] =
            figures.means.map(|row| row.map(all));
        Self {
            square: square * four.per_torque * four.per_torque,
            direction: (four.inertia * a_s + t_s) * four.per_torque,
            speed: (four.inertia * a_w + t_w) * four.per_torque,
            moving,
            travelled,
            speed_square: w_w,
        }
    }

    /// Returns the mean of I² = (I_T + I_s σ + K ω)², a convex parabola in I_s and in K.
    pub(super) fn square(&self, counted: f64x4, constant: f64x4) -> f64x4 {
        let two = all(2.0);
        self.square
            + counted * (counted * self.moving + two * (self.direction + constant * self.travelled))
            + constant * (constant * self.speed_square + two * self.speed)
    }

    /// Returns the K at the minimum of the mean.
    pub(super) fn vertex(&self, counted: f64x4) -> f64x4 {
        let at_rest = self.speed_square.simd_eq(f64x4::ZERO);
        at_rest.select(f64x4::ZERO, -(self.speed + counted * self.travelled) / self.speed_square)
    }

    /// Returns the friction loss \[W\].
    pub(super) fn friction(&self, four: &Four, starting: f64x4, constant: f64x4) -> f64x4 {
        four.friction_v_s * (starting * self.travelled + constant * self.speed_square)
    }

    /// Returns the derivative of both losses with respect to K; it rises with K.
    pub(super) fn by_constant(&self, four: &Four, counted: f64x4, constant: f64x4) -> f64x4 {
        let of_square = self.speed + counted * self.travelled + constant * self.speed_square;
        all(2.0) * four.copper_ohm * of_square + four.friction_v_s * self.speed_square
    }
}

/// Returns a lower bound of e^(−x): the eighth power of 1 − y + y²/2 − y³/6, y = x/8.
pub(super) fn decay_below(x: f64x4) -> f64x4 {
    let y = x * all(0.125);
    let root = f64x4::ONE - y * (f64x4::ONE - y * (all(0.5) - y * all(1.0 / 6.0)));
    eighth_power(root.fast_max(f64x4::ZERO))
}

/// Returns an upper bound of e^(−x): the polynomial of [`decay_below`] with y⁴/24.
pub(super) fn decay_above(x: f64x4) -> f64x4 {
    let y = x * all(0.125);
    let root = f64x4::ONE - y * (f64x4::ONE - y * (all(0.5) - y * (all(1.0 / 6.0) - y * all(1.0 / 24.0))));
    eighth_power(root.fast_min(f64x4::ONE))
}

fn eighth_power(root: f64x4) -> f64x4 {
    let square = root * root;
    let fourth = square * square;
    fourth * fourth
}

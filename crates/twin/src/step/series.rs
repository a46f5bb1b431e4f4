//! Terms of the Taylor series of the plant's equations over one step.

use super::{Node, Piece};
use crate::plant::{Given, Variables};

/// Number of terms of the series after the value.
const ORDER: usize = 4;

/// Constants of a piece in units of a step: speeds are angles per step.
#[derive(Clone, Copy)]
pub(super) struct Pace {
    pub(super) h: f64,
    pub(super) per: f64,
    pub(super) voltage: [f64; 2],
    pub(super) decay: f64,
    pub(super) constant: f64,
    pub(super) viscous: f64,
    pub(super) over_rotor: f64,
    pub(super) dry: f64,
    pub(super) damping: f64,
    pub(super) over_load: f64,
    pub(super) load_viscous: f64,
}

/// Terms of the series over one step.
pub(super) struct Series {
    pub(super) x: Variables<[f64; ORDER]>,
    /// Terms of φ and T.
    pub(super) phi: [f64; ORDER],
    pub(super) gear: [f64; ORDER - 1],
}

/// Returns c_1 x + c_2 x² + …
#[inline(always)]
pub(super) fn sum(terms: &[f64], x: f64) -> f64 {
    terms.iter().rev().fold(0.0, |sum, term| (sum + term) * x)
}

impl Pace {
    #[inline(always)]
    pub(super) fn of(piece: &Piece, h: f64) -> Self {
        let square = h * h;
        Self {
            h,
            per: 1.0 / h,
            voltage: piece.voltage.map(|voltage| h * voltage),
            decay: h * piece.decay,
            constant: square * piece.constant,
            viscous: h * piece.viscous,
            over_rotor: square * piece.over_rotor,
            dry: square * piece.dry,
            damping: piece.damping_nms / h,
            over_load: square * piece.over_load,
            load_viscous: h * piece.over_load,
        }
    }
}

/// Returns the torque of the load at a node \[Nm\], its linear and quadratic dependence on the position, and its
/// dependence on the speed.
#[inline(always)]
fn load(piece: &Piece, node: &Node, given: &Given<'_>) -> [f64; 4] {
    let Variables { load_rad: q, load_rad_s: speed, .. } = node.x;
    let load = given.load;
    let torque = load.torque(q, speed) + piece.load_dry_nm;
    let slope = load.slope_nm + 2.0 * load.bend_nm * (q - load.position_rad);
    match given.stop.filter(|_| piece.touches) {
        Some(stop) => [
            torque + stop.torque(q, speed),
            slope + stop.stiffness_nm,
            load.bend_nm,
            load.viscous_nms + stop.damping_nms,
        ],
        None => [torque, slope, load.bend_nm, load.viscous_nms],
    }
}

impl Series {
    /// Returns the state after a part of the step.
    #[inline(always)]
    pub(super) fn after(&self, start: &Variables, part: f64) -> Variables {
        start.increased(&self.x, |terms| sum(terms, part))
    }

    /// Returns the state after the step.
    #[inline(always)]
    pub(super) fn end(&self, start: &Variables) -> Variables {
        start.increased(&self.x, |[a, b, c, d]| ((a + b) + c) + d)
    }

    /// Computes the terms of the series of the equations.
    ///
    /// L i_d' = u_d − R i_d + ω_e L i_q, L i_q' = u_q − R i_q − ω_e (L i_d + ψ), ω_e = p i Ω;
    /// J_M Ω' = k i_q − (1 − e') T − b Ω − σ (T_s + T_Br + (1/η − 1)|T|); J_L ω' = T − T_L;
    /// T = T_K(φ) + Σ F_j + D φ', φ = θ − q − e(θ)
    ///
    /// # Source
    /// docs/theory/twin.md
    #[inline(always)]
    pub(super) fn of(piece: &Piece, pace: &Pace, node: &Node, given: &Given<'_>) -> Self {
        let Variables { current_d: d0, current_q: q0, motor_rad_s: omega, load_rad_s: speed, .. } = node.x;
        let [slope, bend, third] = node.error;
        let [torque, stiff, square, viscous] = load(piece, node, given);
        let [half, third_part, quarter] = [1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0];
        // The unit of time is the step: speeds are angles per step. The slowest dependency comes last in each term.
        let Pace { h, per, decay, constant, viscous: rub, over_rotor, damping, over_load, .. } = *pace;
        let (k, e, flux, load_rub) = (piece.stiffness, piece.electrical, piece.flux, pace.load_viscous * viscous);
        let (w0, v0, t0) = (h * omega, h * speed, node.gear);
        // Share of the torque acting on the motor: (1 − e') and the friction of the teeth.
        let p0 = 1.0 - slope;
        let felt = over_rotor * (p0 + piece.mesh);
        let damped = damping * p0;

        // e Ω and the currents form products, whose terms are sums of products of terms.
        let ew0 = e * w0;
        let d1 = pace.voltage[0] - decay * d0 + ew0 * q0;
        let q1 = pace.voltage[1] - decay * q0 - ew0 * d0 - flux * w0;
        let w1 = (constant * q0 - rub * w0 - pace.dry) - felt * t0;
        let v1 = over_load * (t0 - torque);
        let phi1 = h * node.rate;
        let p1 = -bend * w0;
        let pushed = p1 * w0;
        let t1 = (k * phi1 + damping * pushed) + (damped * w1 - damping * v1);
        let phi2 = half * (pushed + (p0 * w1 - v1));

        let ew1 = e * w1;
        let d2 = half * (ew1 * q0 + ew0 * q1 - decay * d1);
        let q2 = -half * (ew1 * d0 + ew0 * d1 + decay * q1 + flux * w1);
        let w2 = half * (constant * q1 - rub * w1 - over_rotor * (p1 * t0)) - half * felt * t1;
        let v2 = half * over_load * t1 - half * (over_load * stiff * v0 + load_rub * v1);
        let (a2, y2) = (half * w1, half * v1);
        let p2 = -(bend * a2 + half * third * (w0 * w0));
        let pushed = p2 * w0 + p1 * w1;
        let t2 = (k * phi2 + damping * pushed) + (damped * w2 - damping * v2);
        let phi3 = third_part * (pushed + (p0 * w2 - v2));

        let ew2 = e * w2;
        let d3 = third_part * (ew2 * q0 + ew1 * q1 + ew0 * q2 - decay * d2);
        let q3 = -third_part * (ew2 * d0 + ew1 * d1 + ew0 * d2 + decay * q2 + flux * w2);
        let w3 = third_part * (constant * q2 - rub * w2 - over_rotor * (p2 * t0 + p1 * t1)) - third_part * felt * t2;
        let v3 =
            third_part * over_load * t2 - third_part * (over_load * (stiff * y2 + square * (v0 * v0)) + load_rub * v2);
        let (a3, y3) = (third_part * w2, third_part * v2);
        let p3 = -(bend * a3 + third * (w0 * a2));
        let pushed = p3 * w0 + p2 * w1 + p1 * w2;
        let t3 = (k * phi3 + damping * pushed) + (damped * w3 - damping * v3);
        let phi4 = quarter * (pushed + (p0 * w3 - v3));

        let ew3 = e * w3;
        let d4 = quarter * (ew3 * q0 + ew2 * q1 + ew1 * q2 + ew0 * q3 - decay * d3);
        let q4 = -quarter * (ew3 * d0 + ew2 * d1 + ew1 * d2 + ew0 * d3 + decay * q3 + flux * w3);
        let w4 =
            quarter * (constant * q3 - rub * w3 - over_rotor * (p3 * t0 + p2 * t1 + p1 * t2)) - quarter * felt * t3;
        let v4 =
            quarter * over_load * t3 - quarter * (over_load * (stiff * y3 + 2.0 * square * (v0 * y2)) + load_rub * v3);
        let (a4, y4) = (quarter * w3, quarter * v3);
        Self {
            x: Variables {
                current_d: [d1, d2, d3, d4],
                current_q: [q1, q2, q3, q4],
                motor_rad: [w0, a2, a3, a4],
                motor_rad_s: [per * w1, per * w2, per * w3, per * w4],
                load_rad: [v0, y2, y3, y4],
                load_rad_s: [per * v1, per * v2, per * v3, per * v4],
            },
            phi: [phi1, phi2, phi3, phi4],
            gear: [t1, t2, t3],
        }
    }
}

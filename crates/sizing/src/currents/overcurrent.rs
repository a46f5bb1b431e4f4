//! Permissible motor current over the speed, and the ratio of the current to it.

use super::Currents;
use actuator::{CurvePoint, FrictionAt, MotorCurrent};
use quantities::{AngularVelocity, Measure};
use trace::{Extent, Node, Sought};

/// Number of corners above which a bound uses only the least permissible current.
const FEW: usize = 8;

/// Limit of the manufacturer's short-time curve, which may permit more than the stated I_max.
#[derive(Clone, Copy)]
pub(super) struct OfCurve<'a> {
    pub(super) curve: &'a actuator::Curve,
    /// T_max \[Nm\], which caps the curve; infinite if unknown.
    pub(super) torque_max: f64,
    /// I_E \[A\], which caps the current; infinite if unknown.
    pub(super) current_most: f64,
}

impl OfCurve<'_> {
    /// Returns the current of a torque of the curve with that of the friction \[A\].
    fn current(&self, motor: &MotorCurrent, torque: f64, friction: f64) -> f64 {
        (motor.of_torque(torque.min(self.torque_max)) + friction).min(self.current_most)
    }
}

/// Ratio of |I| to the permissible current at an instant: the limit of the manual or, with a published curve, the
/// current of its torque at that speed if that is larger.
///
/// While the direction is constant, |I| is convex along a straight line and the current of a straight piece of the
/// curve is linear: the ratio is largest at an end of the piece.
pub(super) struct Overcurrent<'a> {
    currents: &'a Currents<'a>,
    printed: f64,
    curve: Option<OfCurve<'a>>,
    /// States to be checked.
    states: &'a [&'a FrictionAt],
    /// Speeds at which the limit has a corner.
    corners: Vec<f64>,
}

impl<'a> Overcurrent<'a> {
    pub(super) fn of(
        currents: &'a Currents<'a>,
        printed: f64,
        curve: Option<OfCurve<'a>>,
        states: &'a [&'a FrictionAt],
    ) -> Self {
        let mut corners = Vec::new();
        let points = curve.map_or(&[][..], |of| of.curve.points());
        for (a, b) in points.iter().zip(points.iter().skip(1)) {
            corners.extend([a.speed.si(), b.speed.si()]);
            let Some(of) = curve else { continue };
            let mut cross = |[from, to]: [f64; 2]| {
                if from * to < 0.0 {
                    corners.push(a.speed.si() + from / (from - to) * (b.speed.si() - a.speed.si()));
                }
            };
            cross([a, b].map(|point| point.torque.si() - of.torque_max));
            // Speeds at which the curve's current, of its torque or of T_max, crosses the limit of the manual or I_E.
            for friction in states {
                for most in [f64::INFINITY, of.torque_max] {
                    let at = |point: &CurvePoint, limit: f64| {
                        let torque = point.torque.si().min(most);
                        currents.motor.of_torque(torque) + friction.current(point.speed).si() - limit
                    };
                    for limit in [printed, of.current_most] {
                        cross([a, b].map(|point| at(point, limit)));
                    }
                }
            }
        }
        // Beyond its end the curve permits no current.
        corners.extend(points.last().map(|end| end.speed.si().next_up()));
        corners.sort_by(f64::total_cmp);
        corners.dedup();
        Self { currents, printed, curve, states, corners }
    }

    /// Returns the permissible current at the speed of an instant \[A\].
    pub(super) fn permitted(&self, node: &Node, friction: &FrictionAt) -> f64 {
        self.permitted_at(node.speed_rad_s, friction)
    }

    fn permitted_at(&self, speed: f64, friction: &FrictionAt) -> f64 {
        let Some(of) = &self.curve else { return self.printed };
        let speed = AngularVelocity::from_si(speed);
        let (torque, running) = (of.curve.at(speed).si(), friction.current(speed).si());
        self.printed.max(of.current(self.currents.motor, torque, running))
    }

    /// Returns the least permissible current at any speed between two, in either state \[A\].
    fn least(&self, of: &OfCurve<'_>, slower: f64, faster: f64) -> f64 {
        let [slower, faster] = [slower, faster].map(AngularVelocity::from_si);
        let torque = of.curve.least_between(slower, faster).si();
        let running = |friction: &&FrictionAt| friction.current(slower).si().min(friction.current(faster).si());
        let running = self.states.iter().map(running).fold(f64::INFINITY, f64::min);
        self.printed.max(of.current(self.currents.motor, torque, running))
    }

    /// Returns the state with the larger value at an instant.
    fn state(&self, node: &Node) -> &'a FrictionAt {
        match *self.states {
            [only] => only,
            _ => self.currents.larger(node),
        }
    }

    pub(super) fn ratio(&self, node: &Node, friction: &FrictionAt) -> f64 {
        self.currents.in_state(node, friction).abs() / self.permitted(node, friction)
    }
}

impl Sought for Overcurrent<'_> {
    /// Returns the current of the largest torque over the permissible one, both linear in |ω| between the corners:
    /// largest at a corner or at the slowest or the fastest instant.
    fn bound(&self, extent: &Extent) -> f64 {
        let (back, forth) = extent.speeds_rad_s;
        let slowest = back.max(-forth).max(0.0);
        let fastest = extent.speed_rad_s;
        let first = self.corners.partition_point(|corner| *corner <= slowest);
        let end = self.corners.partition_point(|corner| *corner < fastest).max(first);
        let within = self.corners.get(first..end).unwrap_or_default();
        // Of many corners the least permissible current at any of them is used.
        let (within, least) = match &self.curve {
            Some(curve) if within.len() > FEW => (&[][..], Some(self.least(curve, slowest, fastest))),
            _ => (within, None),
        };
        let speeds = || within.iter().copied().chain([slowest, fastest]);
        let of = |friction: &&FrictionAt| {
            let [acceleration, load, direction, speed] = self.currents.weights(friction);
            let (low, high) = extent.range([acceleration, load, direction, 0.0]);
            let ratio = |n: f64| {
                let forwards = if forth > 0.0 { (high + speed * n).max(-low - speed * n) } else { 0.0 };
                let backwards = if back < 0.0 { (high - speed * n).max(speed * n - low) } else { 0.0 };
                let still = if slowest == 0.0 { high.max(-low) } else { 0.0 };
                forwards.max(backwards).max(still) / least.unwrap_or_else(|| self.permitted_at(n, friction))
            };
            speeds().map(ratio).fold(0.0, f64::max)
        };
        self.states.iter().map(of).fold(0.0, f64::max)
    }

    fn value(&self, node: &Node) -> f64 {
        self.ratio(node, self.state(node))
    }

    fn on_line(&self, a: &Node, b: &Node) -> f64 {
        let ends = |friction: &&FrictionAt| self.ratio(a, friction).max(self.ratio(b, friction));
        self.states.iter().map(ends).fold(0.0, f64::max)
    }

    fn corners(&self) -> &[f64] {
        &self.corners
    }
}

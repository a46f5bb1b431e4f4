//! Current that the manufacturer's short-time curve permits.

use actuator::{CurvePoint, FrictionAt, MotorCurrent};
use quantities::Measure;

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
    pub(super) fn current(&self, motor: &MotorCurrent, torque: f64, friction: f64) -> f64 {
        (motor.of_torque(torque.min(self.torque_max)) + friction).min(self.current_most)
    }

    /// Returns the speeds at which the permissible current has a corner, in ascending order: those of the curve, those at which
    /// it crosses T_max, and those at which its current, of its torque or of T_max, crosses the limit of the manual or I_E.
    pub(super) fn corners(&self, motor: &MotorCurrent, printed: f64, states: &[&FrictionAt]) -> Vec<f64> {
        let mut corners = Vec::new();
        let points = self.curve.points();
        for (a, b) in points.iter().zip(points.iter().skip(1)) {
            corners.extend([a.speed.si(), b.speed.si()]);
            let mut cross = |[from, to]: [f64; 2]| {
                if from * to < 0.0 {
                    corners.push(a.speed.si() + from / (from - to) * (b.speed.si() - a.speed.si()));
                }
            };
            cross([a, b].map(|point| point.torque.si() - self.torque_max));
            for friction in states {
                for most in [f64::INFINITY, self.torque_max] {
                    let at = |point: &CurvePoint, limit: f64| {
                        let torque = point.torque.si().min(most);
                        motor.of_torque(torque) + friction.current(point.speed).si() - limit
                    };
                    for limit in [printed, self.current_most] {
                        cross([a, b].map(|point| at(point, limit)));
                    }
                }
            }
        }
        // Beyond its end the curve permits no current.
        corners.extend(points.last().map(|end| end.speed.si().next_up()));
        corners.sort_by(f64::total_cmp);
        corners.dedup();
        corners
    }
}

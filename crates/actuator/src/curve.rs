//! Limit curves of the torque-speed plane, given by corner points.

use quantities::{AngularVelocity, Measure, Torque};

/// A corner point of a limit curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Speed at the output.
    pub speed: AngularVelocity,
    /// Torque limit at that speed.
    pub torque: Torque,
}

/// A limit curve: linear between its corner points, with a vertical drop to zero at its last speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    points: Vec<CurvePoint>,
    /// Smallest torque of each run of points \[Nm\]; a measured curve may have thousands of points.
    least: Vec<f64>,
}

/// Number of points in a run.
const RUN: usize = 64;

/// Fault that prevents a list of points from being a limit curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveFault {
    /// The list has fewer than two points.
    TooFewPoints,
    /// The curve does not start at standstill.
    DoesNotStartAtZero,
    /// The speeds do not increase from point to point.
    SpeedsNotAscending,
    /// A torque is negative or not finite.
    TorqueOutOfRange,
}

impl Curve {
    /// Creates a curve from its corner points.
    ///
    /// # Errors
    /// [`CurveFault`] if the points do not describe a limit over speed.
    pub fn new(points: Vec<CurvePoint>) -> Result<Self, CurveFault> {
        if points.len() < 2 {
            return Err(CurveFault::TooFewPoints);
        }
        if points.first().is_none_or(|point| point.speed.si() != 0.0) {
            return Err(CurveFault::DoesNotStartAtZero);
        }
        if !points.iter().zip(points.iter().skip(1)).all(|(a, b)| b.speed.si() > a.speed.si()) {
            return Err(CurveFault::SpeedsNotAscending);
        }
        if !points.iter().all(|point| point.torque.si().is_finite() && point.torque.si() >= 0.0) {
            return Err(CurveFault::TorqueOutOfRange);
        }
        let least = |run: &[CurvePoint]| run.iter().fold(f64::INFINITY, |least, point| least.min(point.torque.si()));
        let least = points.chunks(RUN).map(least).collect();
        Ok(Self { points, least })
    }

    /// Returns the corner points in order of speed.
    #[must_use]
    pub fn points(&self) -> &[CurvePoint] {
        &self.points
    }

    /// Returns the limit at a speed; zero beyond the last speed.
    #[must_use]
    pub fn at(&self, speed: AngularVelocity) -> Torque {
        let speed = speed.si().abs();
        let high = self.points.partition_point(|point| point.speed.si() < speed).max(1);
        let (Some(low), Some(high)) = (self.points.get(high - 1), self.points.get(high)) else {
            return Torque::from_si(0.0);
        };
        let (a, b) = (low.speed.si(), high.speed.si());
        let share = (speed - a) / (b - a);
        Torque::from_si(low.torque.si() + share * (high.torque.si() - low.torque.si()))
    }

    /// Returns the smallest limit between two speeds, the slower first; zero beyond the last speed.
    #[must_use]
    pub fn least_between(&self, slower: AngularVelocity, faster: AngularVelocity) -> Torque {
        let ends = self.at(slower).si().min(self.at(faster).si());
        let place = |speed: AngularVelocity| self.points.partition_point(|point| point.speed.si() < speed.si());
        let (from, to) = (place(slower), place(faster));
        // Whole runs by their smallest torque, the remaining points individually.
        let (first, last) = (from.div_ceil(RUN), to / RUN);
        let torques = |from: usize, to: usize| {
            let points = self.points.get(from..to).unwrap_or_default();
            points.iter().fold(f64::INFINITY, |least, point| least.min(point.torque.si()))
        };
        let inside = if first < last {
            let runs = self.least.get(first..last).unwrap_or_default();
            let runs = runs.iter().fold(f64::INFINITY, |least, torque| least.min(*torque));
            runs.min(torques(from, first * RUN)).min(torques(last * RUN, to))
        } else {
            torques(from, to)
        };
        Torque::from_si(ends.min(inside))
    }

    /// Returns the limit at a speed; beyond the last speed, the limit at the last speed.
    #[must_use]
    pub fn at_most_to_its_end(&self, speed: AngularVelocity) -> Torque {
        let end = self.points.last().map_or(0.0, |point| point.speed.si());
        self.at(AngularVelocity::from_si(speed.si().abs().min(end)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(speed: f64, torque: f64) -> CurvePoint {
        CurvePoint { speed: AngularVelocity::from_si(speed), torque: Torque::from_si(torque) }
    }

    #[test]
    fn straight_between_the_corners_and_zero_beyond() {
        let curve = Curve::new(vec![point(0.0, 32.0), point(25.0, 31.0), point(70.0, 20.0)]).unwrap();
        let at = |speed| curve.at(AngularVelocity::from_si(speed)).si();
        assert_eq!(at(0.0), 32.0);
        assert_eq!(at(25.0), 31.0);
        assert!((at(47.5) - 25.5).abs() < 1e-12);
        assert_eq!(at(-70.0), 20.0);
        assert_eq!(at(70.1), 0.0);
        assert_eq!(curve.at_most_to_its_end(AngularVelocity::from_si(70.1)).si(), 20.0);
    }

    #[test]
    fn the_least_between_two_speeds_is_that_of_a_plain_look() {
        for count in [2, 5, 63, 64, 65, 128, 200, 1000_u32] {
            let torque = |k: u32| f64::from(20 + (k * 7919) % 1013);
            let curve = Curve::new((0..count).map(|k| point(f64::from(k), torque(k))).collect()).unwrap();
            let at = |speed: f64| curve.at(AngularVelocity::from_si(speed)).si();
            for (slower, faster) in
                [(0.0, 0.4), (0.3, 1.0), (0.0, 64.0), (0.5, 63.5), (63.0, 129.2), (0.7, 900.1), (64.0, 64.0)]
            {
                let inside = (0..count).filter(|k| (slower..=faster).contains(&f64::from(*k))).map(torque);
                let plain = inside.fold(at(slower).min(at(faster)), f64::min);
                let [slower, faster] = [slower, faster].map(AngularVelocity::from_si);
                assert_eq!(curve.least_between(slower, faster).si(), plain, "{count}");
            }
        }
    }

    #[test]
    fn what_is_no_curve_is_refused() {
        assert_eq!(Curve::new(vec![point(0.0, 1.0)]), Err(CurveFault::TooFewPoints));
        assert_eq!(Curve::new(vec![point(1.0, 1.0), point(2.0, 1.0)]), Err(CurveFault::DoesNotStartAtZero));
        assert_eq!(Curve::new(vec![point(0.0, 1.0), point(0.0, 1.0)]), Err(CurveFault::SpeedsNotAscending));
        assert_eq!(Curve::new(vec![point(0.0, 1.0), point(1.0, f64::NAN)]), Err(CurveFault::TorqueOutOfRange));
    }
}

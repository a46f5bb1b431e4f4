//! A limit curve of the torque-speed plane, given by its corner points.

use quantities::{AngularVelocity, Measure, Torque};

/// One corner point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Speed at the output.
    pub speed: AngularVelocity,
    /// Torque limit at that speed.
    pub torque: Torque,
}

/// A limit curve: straight between its corner points, dropping vertically to zero at its last speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    points: Vec<CurvePoint>,
}

/// Why a list of points is no limit curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveFault {
    /// Fewer than two points.
    TooFewPoints,
    /// The curve must start at standstill.
    DoesNotStartAtZero,
    /// Speeds must grow from point to point.
    SpeedsNotAscending,
    /// A torque is negative or not finite.
    TorqueOutOfRange,
}

impl Curve {
    /// A curve from its corner points.
    ///
    /// # Errors
    /// [`CurveFault`] where the points do not describe a limit over speed.
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
        Ok(Self { points })
    }

    /// The corner points, by ascending speed.
    #[must_use]
    pub fn points(&self) -> &[CurvePoint] {
        &self.points
    }

    /// The limit at a speed; zero beyond the last speed.
    #[must_use]
    pub fn at(&self, speed: AngularVelocity) -> Torque {
        let speed = speed.si().abs();
        // A measured curve may have thousands of points.
        let high = self.points.partition_point(|point| point.speed.si() < speed).max(1);
        let (Some(low), Some(high)) = (self.points.get(high - 1), self.points.get(high)) else {
            return Torque::from_si(0.0);
        };
        let (a, b) = (low.speed.si(), high.speed.si());
        let share = (speed - a) / (b - a);
        Torque::from_si(low.torque.si() + share * (high.torque.si() - low.torque.si()))
    }

    /// Whether the limit nowhere rises with the speed.
    #[must_use]
    pub fn is_falling(&self) -> bool {
        self.points.iter().zip(self.points.iter().skip(1)).all(|(a, b)| b.torque.si() <= a.torque.si())
    }

    /// A limit that falls with the speed and is nowhere above this one: through the least torque up to each corner.
    #[must_use]
    pub fn falling(&self) -> Self {
        let mut least = f64::INFINITY;
        let points = self.points.iter().map(|point| {
            least = least.min(point.torque.si());
            CurvePoint { torque: Torque::from_si(least), ..*point }
        });
        Self { points: points.collect() }
    }

    /// The limit at a speed; beyond the last speed that of the last one.
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
    fn what_falls_lies_below_all_slower_speeds() {
        let curve = Curve::new(vec![
            point(0.0, 30.0),
            point(10.0, 12.0),
            point(20.0, 25.0),
            point(30.0, 5.0),
            point(40.0, 9.0),
        ]);
        let curve = curve.unwrap();
        let falling = curve.falling();
        assert!(!curve.is_falling() && falling.is_falling());
        for step in 0..=400_u32 {
            let speed = f64::from(step) / 10.0;
            let least = (0..=step).map(|k| curve.at(AngularVelocity::from_si(f64::from(k) / 10.0)).si());
            let least = least.fold(f64::INFINITY, f64::min);
            assert!(falling.at(AngularVelocity::from_si(speed)).si() <= least, "{speed}");
        }
        assert_eq!(falling.at(AngularVelocity::from_si(5.0)).si(), 21.0);
    }

    #[test]
    fn what_is_no_curve_is_refused() {
        assert_eq!(Curve::new(vec![point(0.0, 1.0)]), Err(CurveFault::TooFewPoints));
        assert_eq!(Curve::new(vec![point(1.0, 1.0), point(2.0, 1.0)]), Err(CurveFault::DoesNotStartAtZero));
        assert_eq!(Curve::new(vec![point(0.0, 1.0), point(0.0, 1.0)]), Err(CurveFault::SpeedsNotAscending));
        assert_eq!(Curve::new(vec![point(0.0, 1.0), point(1.0, f64::NAN)]), Err(CurveFault::TorqueOutOfRange));
    }
}

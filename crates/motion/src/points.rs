//! A move through given points, such as those of a cam table: the spline through them, as pieces.

use crate::piece::Piece;
use numeric::Symmetric;
use quantities::{Angle, AngularAcceleration, AngularVelocity, Measure, Time, identified};

identified! {
    /// Kind of the spline through the points.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Spline {
        /// Third degree: position, speed and acceleration are continuous (C²), the jerk steps at the points.
        Cubic = "cubic",
        /// Fifth degree: jerk and its derivative are continuous too (C⁴).
        Quintic = "quintic",
    }
}

impl Spline {
    /// Returns the number of unknowns per point: speed and, for the fifth degree, acceleration.
    const fn unknowns(self) -> usize {
        match self {
            Self::Cubic => 1,
            Self::Quintic => 2,
        }
    }
}

/// Speed and acceleration at an end; the cubic spline uses the speed only.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EndState {
    /// Angular speed ω.
    pub speed: AngularVelocity,
    /// Angular acceleration α.
    pub acceleration: AngularAcceleration,
}

/// Boundary condition at the first and the last point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends {
    /// Rest: zero speed and, for the quintic, zero acceleration.
    Rest,
    /// Free: zero acceleration for the cubic, zero jerk and zero derivative of it for the quintic. The curve with the
    /// least ∫α² dt, or ∫j² dt, of all through the points.
    Natural,
    /// The last point joins the first: as many derivatives agree as at any other point. The positions may differ.
    Periodic,
    /// Stated speed and, for the quintic, acceleration at the first and the last point.
    Stated(EndState, EndState),
}

impl Ends {
    /// Returns the states fixed at both ends; `None` if they follow from the points.
    fn fixed(self) -> Option<[EndState; 2]> {
        match self {
            Self::Rest => Some([EndState::default(); 2]),
            Self::Stated(first, last) => Some([first, last]),
            Self::Natural | Self::Periodic => None,
        }
    }
}

/// Fault that prevents points from being a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointsFault {
    /// Too few points for the spline and its ends.
    TooFew {
        /// Number of points.
        points: usize,
        /// Number of points required.
        least: usize,
    },
    /// A value of a point is not a finite number.
    NotFinite {
        /// Index of the point.
        index: usize,
    },
    /// A point is not later than the one before it.
    NotIncreasing {
        /// Index of the later point.
        index: usize,
    },
    /// The points are spaced so unevenly that the equations of the spline have no solution in double precision.
    Uneven,
}

/// An interval of a motion whose states at both ends are known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StateInterval {
    /// Duration, greater than zero.
    pub(crate) duration: Time,
    /// Angle that is covered.
    pub(crate) step: Angle,
    /// States at both ends.
    pub(crate) ends: [EndState; 2],
}

/// A move through points.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    pieces: Vec<Piece>,
    /// Positions relative to the first point \[rad\] and speeds [rad/s] at the points.
    states: Vec<(f64, f64)>,
    first: Angle,
}

impl Points {
    /// Creates the spline through positions at increasing instants.
    ///
    /// Speeds m_k and, for the quintic, accelerations M_k at the points determine a polynomial in each interval. They
    /// follow from ∫α² dt → min (cubic) or ∫j² dt → min (quintic), which holds exactly if the next derivatives are
    /// continuous.
    ///
    /// # Source
    /// Ahlberg, Nilson and Walsh, The Theory of Splines and Their Applications (1967), the minimum norm property;
    /// docs/theory/motion-laws.md
    /// # Errors
    /// Returns the [`PointsFault`]s of all points.
    pub fn new(points: &[(Time, Angle)], spline: Spline, ends: Ends) -> Result<Self, Vec<PointsFault>> {
        let points: Vec<(f64, f64)> = points.iter().map(|(time, position)| (time.si(), position.si())).collect();
        let least = if spline == Spline::Quintic && ends == Ends::Natural { 3 } else { 2 };
        let mut faults = Vec::new();
        if points.len() < least {
            faults.push(PointsFault::TooFew { points: points.len(), least });
        }
        let finite = |(t, q): &(f64, f64)| t.is_finite() && q.is_finite();
        let not_finite = points.iter().enumerate().filter(|(_, point)| !finite(point));
        faults.extend(not_finite.map(|(index, _)| PointsFault::NotFinite { index }));
        let pairs = points.iter().zip(points.iter().skip(1)).zip(1..);
        let back = pairs.filter(|((before, here), _)| finite(before) && finite(here) && here.0 <= before.0);
        faults.extend(back.map(|(_, index)| PointsFault::NotIncreasing { index }));
        if !faults.is_empty() {
            return Err(faults);
        }
        let (knots, pieces) = solved(&points, spline, ends).ok_or_else(|| vec![PointsFault::Uneven])?;
        let first = points.first().map_or(0.0, |(_, position)| *position);
        let states = points.iter().zip(&knots).map(|((_, q), [speed, _])| (q - first, *speed)).collect();
        Ok(Self { pieces, states, first: Angle::from_si(first) })
    }

    /// Creates the motion from the states at the ends of its intervals; `None` for values that are not finite or
    /// intervals without duration.
    pub(crate) fn through_states(first: Angle, intervals: &[StateInterval]) -> Option<Self> {
        let mut position = 0.0;
        let mut states = vec![(0.0, intervals.first()?.ends[0].speed.si())];
        let mut pieces = Vec::with_capacity(intervals.len());
        for StateInterval { duration, step, ends } in intervals {
            let (h, step, [a, b]) = (duration.si(), step.si(), ends.map(|end| [end.speed.si(), end.acceleration.si()]));
            if !(h > 0.0 && [h, step].into_iter().chain(a).chain(b).all(f64::is_finite)) {
                return None;
            }
            position += step;
            states.push((position, b[0]));
            pieces.push(piece(Spline::Quintic, (h, step), a, b));
        }
        Some(Self { pieces, states, first })
    }

    /// Returns the position of the first point.
    #[must_use]
    pub const fn first(&self) -> Angle {
        self.first
    }

    /// Returns the speed at the first point.
    #[must_use]
    pub fn first_speed(&self) -> AngularVelocity {
        AngularVelocity::from_si(self.states.first().map_or(0.0, |(_, speed)| *speed))
    }

    /// Iterates over the pieces, each with its end position relative to the first point and its end speed.
    pub(crate) fn pieces(&self) -> impl Iterator<Item = (Piece, (f64, f64))> + '_ {
        self.pieces.iter().copied().zip(self.states.iter().skip(1).copied())
    }
}

/// Speed and acceleration at a point [rad/s, rad/s²]; the acceleration is used by the quintic only.
type Knot = [f64; 2];

/// Returns the knots and the pieces between them.
fn solved(points: &[(f64, f64)], spline: Spline, ends: Ends) -> Option<(Vec<Knot>, Vec<Piece>)> {
    let size = spline.unknowns();
    let intervals = points.len() - 1;
    // Unknowns of a point; those of a fixed end are known, those of periodic ends are equal.
    let fixed = ends.fixed().map(|ends| ends.map(|end| [end.speed.si(), end.acceleration.si()]));
    let unknowns = match ends {
        Ends::Rest | Ends::Stated(..) => intervals - 1,
        Ends::Natural => intervals + 1,
        Ends::Periodic => intervals,
    };
    let place = |knot: usize| match (ends, knot) {
        (Ends::Rest | Ends::Stated(..), 0) => Err(fixed.map_or([0.0; 2], |[first, _]| first)),
        (Ends::Rest | Ends::Stated(..), knot) if knot == intervals => Err(fixed.map_or([0.0; 2], |[_, last]| last)),
        (Ends::Rest | Ends::Stated(..), knot) => Ok(knot - 1),
        (Ends::Natural, knot) => Ok(knot),
        (Ends::Periodic, knot) => Ok(if knot == intervals { 0 } else { knot }),
    };
    let closes = |knot: usize| ends == Ends::Periodic && knot + 1 == unknowns;
    let begins = (0..unknowns).flat_map(|knot| {
        let first = if closes(knot) { 0 } else { knot.saturating_sub(1) };
        std::iter::repeat_n(first * size, size)
    });
    let mut matrix = Symmetric::zero(begins);
    let mut right = vec![0.0; unknowns * size];
    let spans = || points.iter().zip(points.iter().skip(1)).map(|((from, a), (to, b))| (to - from, b - a));
    for ((h, step), knot) in spans().zip(0..) {
        let (rows, load) = element(spline, h);
        let of_interval = [knot, knot + 1].map(place);
        // Index or value of each unknown of both ends.
        let numbers = of_interval.iter().flat_map(|end| {
            (0..size).map(move |which| match end {
                Ok(unknown) => Ok(unknown * size + which),
                Err(known) => Err(known.get(which).copied().unwrap_or(0.0)),
            })
        });
        for ((row, number), load) in rows.iter().zip(numbers.clone()).zip(load) {
            let Ok(number) = number else { continue };
            let mut known = load * step;
            for (entry, other) in row.iter().zip(numbers.clone()) {
                match other {
                    // Both halves of the symmetric matrix are visited, and one is stored.
                    Ok(other) if other <= number => matrix.add(number, other, *entry),
                    Ok(_) => {}
                    Err(value) => known -= entry * value,
                }
            }
            if let Some(right) = right.get_mut(number) {
                *right += known;
            }
        }
    }
    let solution = matrix.solve(right)?;
    let knots: Vec<Knot> = (0..=intervals)
        .map(|knot| match place(knot) {
            Ok(unknown) => {
                let mut found = solution.get(unknown * size..).unwrap_or_default().iter().take(size).copied();
                [found.next().unwrap_or(0.0), found.next().unwrap_or(0.0)]
            }
            Err(known) => known,
        })
        .collect();
    if knots.iter().flatten().any(|value| !value.is_finite()) {
        return None;
    }
    let pairs = knots.iter().zip(knots.iter().skip(1));
    let pieces = spans().zip(pairs).map(|(span, (a, b))| piece(spline, span, *a, *b)).collect();
    Some((knots, pieces))
}

/// Returns the contribution of an interval of duration h to the equations of the unknowns at its ends (m_0, M_0, m_1,
/// M_1; for the cubic m_0, m_1): rows of the matrix, and the right-hand side for a unit step.
///
/// Derivatives of ½∫α² dt, or ½∫j² dt, of the polynomial through the states at both ends.
fn element(spline: Spline, h: f64) -> (Vec<Vec<f64>>, Vec<f64>) {
    let (h2, h3) = (h * h, h * h * h);
    match spline {
        Spline::Cubic => (vec![vec![4.0 / h, 2.0 / h], vec![2.0 / h, 4.0 / h]], vec![6.0 / h2; 2]),
        Spline::Quintic => (
            vec![
                vec![192.0 / h3, 36.0 / h2, 168.0 / h3, -24.0 / h2],
                vec![36.0 / h2, 9.0 / h, 24.0 / h2, -3.0 / h],
                vec![168.0 / h3, 24.0 / h2, 192.0 / h3, -36.0 / h2],
                vec![-24.0 / h2, -3.0 / h, -36.0 / h2, 9.0 / h],
            ],
            vec![360.0 / (h2 * h2), 60.0 / h3, 360.0 / (h2 * h2), -60.0 / h3],
        ),
    }
}

/// Returns the polynomial between two knots for a duration and a step of position.
fn piece(spline: Spline, (h, step): (f64, f64), [m0, a0]: Knot, [m1, a1]: Knot) -> Piece {
    let made = match spline {
        Spline::Cubic => {
            let slope = step / h;
            let first = (6.0 * slope - 4.0 * m0 - 2.0 * m1) / h;
            Piece::polynomial(h, [first, (6.0 * (m0 + m1) - 12.0 * slope) / (h * h), 0.0, 0.0])
        }
        Spline::Quintic => {
            let (p0, p1, r0, r1) = (m0 * h, m1 * h, a0 * h * h, a1 * h * h);
            let c3 = 10.0 * step - 6.0 * p0 - 4.0 * p1 - 1.5 * r0 + 0.5 * r1;
            let c4 = -15.0 * step + 8.0 * p0 + 7.0 * p1 + 1.5 * r0 - r1;
            let c5 = 6.0 * step - 3.0 * (p0 + p1) - 0.5 * (r0 - r1);
            let (h2, h3) = (h * h, h * h * h);
            Piece::polynomial(h, [a0, 6.0 * c3 / h3, 12.0 * c4 / (h2 * h2), 20.0 * c5 / (h2 * h3)])
        }
    };
    made.ending_with(m1)
}

#[cfg(test)]
#[path = "points_tests.rs"]
mod tests;

//! Moving groups of a drawing and their placement at an angle of the mechanism.

use super::SheetPoint;
use quantities::identified;
use std::f64::consts::TAU;

/// Placement of a group relative to the still drawing: stretched and turned about its point, then shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Counter-clockwise rotation \[rad\].
    pub turn_rad: f64,
    /// Shift in units of the sheet.
    pub shift: SheetPoint,
    /// Stretch factors along x and y.
    pub stretch: SheetPoint,
}

impl Placement {
    /// Placement in the still drawing.
    pub const STILL: Self = Self { turn_rad: 0.0, shift: [0.0, 0.0], stretch: [1.0, 1.0] };

    pub(crate) const fn turned(turn_rad: f64) -> Self {
        Self { turn_rad, ..Self::STILL }
    }

    pub(crate) const fn shifted(shift: SheetPoint) -> Self {
        Self { shift, ..Self::STILL }
    }

    pub(crate) const fn stretched(stretch: SheetPoint) -> Self {
        Self { stretch, ..Self::STILL }
    }

    /// Returns rotation \[rad\], shift and stretch as numbers.
    fn numbers(self) -> [f64; 5] {
        let ([dx, dy], [sx, sy]) = (self.shift, self.stretch);
        [self.turn_rad, dx, dy, sx, sy]
    }

    const fn of([turn_rad, dx, dy, sx, sy]: [f64; 5]) -> Self {
        Self { turn_rad, shift: [dx, dy], stretch: [sx, sy] }
    }
}

identified! {
    /// Continuation of a group beyond its table.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Beyond {
        /// Continued from its end as from its beginning, by revolutions or linearly.
        On = "on",
        /// Held at the end.
        Stay = "stay",
        /// Restarted from the beginning.
        Anew = "anew",
    }
}

/// Angles at which the placement of a group is computed.
pub(crate) struct GroupAngles {
    beyond: Beyond,
    angles: Vec<f64>,
}

impl GroupAngles {
    /// Creates the angles of a group moving in proportion to the angle, for which two points suffice.
    pub(crate) fn even(from_rad: f64) -> Self {
        Self { beyond: Beyond::On, angles: vec![from_rad, from_rad + TAU] }
    }

    /// Creates the angles of a group that repeats with each revolution, every 2°.
    pub(crate) fn round(from_rad: f64) -> Self {
        let angles = (0..=180).map(|step| from_rad + f64::from(step) * TAU / 180.0);
        Self { beyond: Beyond::On, angles: angles.collect() }
    }

    /// Creates the angles of a group that moves in proportion to the angle and restarts after a period.
    pub(crate) fn anew(from_rad: f64, period_rad: f64) -> Self {
        Self { beyond: Beyond::Anew, angles: vec![from_rad, from_rad + period_rad] }
    }

    /// Creates the angles of a limited motion.
    pub(crate) const fn bounded(angles: Vec<f64>) -> Self {
        Self { beyond: Beyond::Stay, angles }
    }
}

/// A moving group, as a table of placements over the angle of the mechanism, linear between its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving {
    /// Centre of rotation and stretch in the still drawing.
    pub about: SheetPoint,
    /// Continuation beyond the table.
    pub beyond: Beyond,
    /// Angles of the mechanism \[rad\] in ascending order, with their placements.
    pub rows: Vec<(f64, Placement)>,
}

/// Largest invisible deviations of rotation, shift and stretch, for parts at the edge of the sheet.
const UNSEEN: [f64; 5] = [0.0007, 0.1, 0.1, 0.0007, 0.0007];

impl Moving {
    pub(crate) fn of(course: &GroupAngles, about: SheetPoint, place: impl Fn(f64) -> Placement) -> Self {
        let mut rows: Vec<_> = course.angles.iter().map(|angle| (*angle, place(*angle))).collect();
        // Angles from an arctangent are continued across ±π.
        let mut before = rows.first().map_or(0.0, |(_, placement)| placement.turn_rad);
        let is_sampled = rows.len() > 2;
        for (_, placement) in rows.iter_mut().filter(|_| is_sampled) {
            placement.turn_rad -= ((placement.turn_rad - before) / TAU).round() * TAU;
            before = placement.turn_rad;
        }
        Self { about, beyond: course.beyond, rows: thinned(&rows) }
    }

    /// Returns the placement at an angle of the mechanism.
    #[must_use]
    pub fn at(&self, angle_rad: f64) -> Placement {
        let (Some(first), Some(last)) = (self.rows.first(), self.rows.last()) else { return Placement::STILL };
        let span = last.0 - first.0;
        if span <= 0.0 {
            return first.1;
        }
        let rounds = match self.beyond {
            Beyond::On | Beyond::Anew => ((angle_rad - first.0) / span).floor(),
            Beyond::Stay => 0.0,
        };
        let angle = (angle_rad - rounds * span).clamp(first.0, last.0);
        let after = self.rows.partition_point(|(known, _)| *known <= angle).clamp(1, self.rows.len() - 1);
        let (Some(low), Some(high)) = (self.rows.get(after - 1), self.rows.get(after)) else { return first.1 };
        let share = (angle - low.0) / (high.0 - low.0);
        let advance = if self.beyond == Beyond::On { rounds } else { 0.0 };
        let mut found = [0.0; 5];
        let sides = low.1.numbers().into_iter().zip(high.1.numbers());
        let ends = first.1.numbers().into_iter().zip(last.1.numbers());
        for ((value, (a, b)), (begin, end)) in found.iter_mut().zip(sides).zip(ends) {
            *value = a + share * (b - a) + advance * (end - begin);
        }
        Placement::of(found)
    }

    /// Returns the position of a point of the still drawing in a placement.
    #[must_use]
    pub fn point(&self, placement: Placement, [x, y]: SheetPoint) -> SheetPoint {
        let ([ax, ay], [dx, dy], [sx, sy]) = (self.about, placement.shift, placement.stretch);
        let (sine, cosine) = placement.turn_rad.sin_cos();
        let (x, y) = (sx * (x - ax), sy * (y - ay));
        [ax + dx + cosine * x + sine * y, ay + dy - sine * x + cosine * y]
    }
}

/// Returns the rows without those that linear interpolation reproduces within the visible resolution.
fn thinned(rows: &[(f64, Placement)]) -> Vec<(f64, Placement)> {
    let mut kept: Vec<(f64, Placement)> = rows.first().copied().into_iter().collect();
    let mut from = 0;
    while from + 1 < rows.len() {
        let mut to = from + 1;
        while to + 1 < rows.len() && is_straight(rows.get(from..=to + 1).unwrap_or_default()) {
            to += 1;
        }
        kept.extend(rows.get(to));
        from = to;
    }
    kept
}

fn is_straight(rows: &[(f64, Placement)]) -> bool {
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else { return true };
    rows.iter().all(|(angle, placement)| {
        let share = (angle - first.0) / (last.0 - first.0);
        let ends = first.1.numbers().into_iter().zip(last.1.numbers());
        let mut all = ends.zip(placement.numbers()).zip(UNSEEN);
        all.all(|(((a, b), value), unseen)| (a + share * (b - a) - value).abs() <= unseen)
    })
}

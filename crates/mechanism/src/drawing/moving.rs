//! What of a drawing moves: where each group stands at an angle of the mechanism.

use super::Point;
use quantities::identified;
use std::f64::consts::TAU;

/// Where a group stands beside its place in the still drawing: stretched and turned about its point, then shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Turn to the left \[rad\].
    pub turn_rad: f64,
    /// Shift, in the lengths of the sheet.
    pub shift: Point,
    /// Stretch along x and y.
    pub stretch: Point,
}

impl Placement {
    /// As in the still drawing.
    pub const STILL: Self = Self { turn_rad: 0.0, shift: [0.0, 0.0], stretch: [1.0, 1.0] };

    pub(crate) const fn turned(turn_rad: f64) -> Self {
        Self { turn_rad, ..Self::STILL }
    }

    pub(crate) const fn shifted(shift: Point) -> Self {
        Self { shift, ..Self::STILL }
    }

    pub(crate) const fn stretched(stretch: Point) -> Self {
        Self { stretch, ..Self::STILL }
    }

    /// Turn \[rad\], shift and stretch in a row.
    fn numbers(self) -> [f64; 5] {
        let ([dx, dy], [sx, sy]) = (self.shift, self.stretch);
        [self.turn_rad, dx, dy, sx, sy]
    }

    const fn of([turn_rad, dx, dy, sx, sy]: [f64; 5]) -> Self {
        Self { turn_rad, shift: [dx, dy], stretch: [sx, sy] }
    }
}

identified! {
    /// How a group goes on beyond its table.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Beyond {
        /// From its end as from its beginning: a revolution after the other, or straight on.
        On = "on",
        /// It stays.
        Stay = "stay",
        /// It begins anew where it began.
        Anew = "anew",
    }
}

/// The angles at which the placement of a group is worked out.
pub(crate) struct Course {
    beyond: Beyond,
    angles: Vec<f64>,
}

impl Course {
    /// What is proportional to the angle: two points are enough.
    pub(crate) fn even(from_rad: f64) -> Self {
        Self { beyond: Beyond::On, angles: vec![from_rad, from_rad + TAU] }
    }

    /// What repeats with each revolution, every 2°.
    pub(crate) fn round(from_rad: f64) -> Self {
        let angles = (0..=180).map(|step| from_rad + f64::from(step) * TAU / 180.0);
        Self { beyond: Beyond::On, angles: angles.collect() }
    }

    /// What is proportional to the angle and begins anew after one.
    pub(crate) fn anew(from_rad: f64, period_rad: f64) -> Self {
        Self { beyond: Beyond::Anew, angles: vec![from_rad, from_rad + period_rad] }
    }

    /// A bounded way, by its angles.
    pub(crate) const fn bounded(angles: Vec<f64>) -> Self {
        Self { beyond: Beyond::Stay, angles }
    }
}

/// A group that moves, as a table of placements over the angle of the mechanism, straight between its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving {
    /// The point that it is turned and stretched about, in the still drawing.
    pub about: Point,
    /// How it goes on beyond its table.
    pub beyond: Beyond,
    /// Angle of the mechanism \[rad\], ascending, and the placement there.
    pub rows: Vec<(f64, Placement)>,
}

/// What of a shift, in the lengths of the sheet, and of a turn or stretch at the edge of the sheet is not seen.
const UNSEEN: [f64; 5] = [0.0007, 0.1, 0.1, 0.0007, 0.0007];

impl Moving {
    pub(crate) fn of(course: &Course, about: Point, place: impl Fn(f64) -> Placement) -> Self {
        let mut rows: Vec<_> = course.angles.iter().map(|angle| (*angle, place(*angle))).collect();
        // An angle that was found by its tangent goes on where it comes round.
        let mut before = rows.first().map_or(0.0, |(_, placement)| placement.turn_rad);
        let is_sampled = rows.len() > 2;
        for (_, placement) in rows.iter_mut().filter(|_| is_sampled) {
            placement.turn_rad -= ((placement.turn_rad - before) / TAU).round() * TAU;
            before = placement.turn_rad;
        }
        Self { about, beyond: course.beyond, rows: thinned(&rows) }
    }

    /// The placement at an angle of the mechanism.
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

    /// Where a point of the still drawing stands.
    #[must_use]
    pub fn point(&self, placement: Placement, [x, y]: Point) -> Point {
        let ([ax, ay], [dx, dy], [sx, sy]) = (self.about, placement.shift, placement.stretch);
        let (sine, cosine) = placement.turn_rad.sin_cos();
        let (x, y) = (sx * (x - ax), sy * (y - ay));
        [ax + dx + cosine * x + sine * y, ay + dy - sine * x + cosine * y]
    }
}

/// Without the rows that the ones beside them give to what can be seen.
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

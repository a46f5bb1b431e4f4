//! `[mechanism.table]`: inertia and torque as a function of position, point by point.

use crate::drawing::{Drawing, GroupAngles, Look, MechanismValues, Placement, Step, polyline};
use crate::equations::{Equations, Reduced, TWELFTH_RAD};
use crate::flange::OnFlange;
use crate::{Endless, Extra, MechanismId};
use quantities::{Angle, Measure, MomentOfInertia, Torque};

/// A point of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TablePoint {
    /// q: position of the output.
    pub position: Angle,
    /// J(q): inertia at the position.
    pub inertia: MomentOfInertia,
    /// T_h(q): torque that holds the load at the position.
    pub torque: Torque,
}

/// Fault that prevents points from being a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableFault {
    /// The table has fewer than two points.
    TooFewPoints,
    /// The positions do not increase from point to point.
    PositionsNotAscending,
    /// An inertia is negative.
    NegativeInertia,
}

/// A table of inertia and torque, linear between its points.
///
/// Beyond the ends, the end values hold. A table that spans one revolution with equal end values is periodic.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    points: Vec<TablePoint>,
    periodic: bool,
}

impl Table {
    /// Creates a table from its points.
    ///
    /// # Errors
    /// [`TableFault`] if the points do not describe a function of the position.
    pub fn new(points: Vec<TablePoint>) -> Result<Self, TableFault> {
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return Err(TableFault::TooFewPoints) };
        if points.len() < 2 {
            return Err(TableFault::TooFewPoints);
        }
        if !points.iter().zip(points.iter().skip(1)).all(|(a, b)| b.position.si() > a.position.si()) {
            return Err(TableFault::PositionsNotAscending);
        }
        if points.iter().any(|point| point.inertia.si() < 0.0) {
            return Err(TableFault::NegativeInertia);
        }
        let span = last.position.si() - first.position.si();
        let periodic = (span - std::f64::consts::TAU).abs() < 1e-9
            && first.inertia.si() == last.inertia.si()
            && first.torque.si() == last.torque.si();
        Ok(Self { points, periodic })
    }

    /// Returns the points.
    pub(crate) fn points(&self) -> &[TablePoint] {
        &self.points
    }

    /// Returns a position within the table \[rad\], and the indices of the points around it: beyond the ends twice the last one.
    pub(crate) fn between(&self, position_rad: f64) -> (f64, [usize; 2]) {
        let at = |index: usize| self.points.get(index).map_or(0.0, |point| point.position.si());
        let (first, last) = (at(0), self.points.len() - 1);
        let q =
            if self.periodic { first + (position_rad - first).rem_euclid(std::f64::consts::TAU) } else { position_rad };
        let high = self.points.partition_point(|point| point.position.si() <= q).clamp(1, last);
        let ends = match (q < at(high - 1), q > at(high)) {
            (true, _) => [high - 1; 2],
            (_, true) => [high; 2],
            _ => [high - 1, high],
        };
        (q, ends)
    }
}

impl Equations for Table {
    fn id(&self) -> MechanismId {
        MechanismId::Table
    }

    fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
        let (q, ends) = self.between(position_rad);
        let [Some(low), Some(high)] = ends.map(|index| self.points.get(index)) else {
            return Reduced { inertia: 0.0, slope: 0.0, holding: 0.0, coulomb: 0.0 };
        };
        let span = high.position.si() - low.position.si();
        // Beyond the ends both points are the same.
        let share = if span > 0.0 { (q - low.position.si()) / span } else { 0.0 };
        let rise = high.inertia.si() - low.inertia.si();
        Reduced {
            inertia: low.inertia.si() + share * rise + extra.inertia.si(),
            slope: if span > 0.0 { rise / span } else { 0.0 },
            holding: low.torque.si() + share * (high.torque.si() - low.torque.si()) + extra.torque.si(),
            coulomb: 0.0,
        }
    }

    fn with_masses(&self, factor: f64) -> Self {
        let points = self.points.iter().map(|point| TablePoint {
            inertia: point.inertia * factor,
            torque: point.torque * factor,
            ..*point
        });
        Self { points: points.collect(), periodic: self.periodic }
    }

    fn smooth_over(&self, _from_rad: f64, _to_rad: f64) -> Option<f64> {
        Some(TWELFTH_RAD)
    }

    fn endless(&self) -> Endless {
        if self.periodic { Endless::EachRevolution } else { Endless::Never }
    }

    fn kinks(&self) -> Vec<f64> {
        self.points.iter().map(|point| point.position.si()).collect()
    }

    fn on_flange(&self) -> Option<OnFlange> {
        None
    }
}

pub(crate) fn drawing(figures: &MechanismValues) -> Drawing {
    let start = figures.start_rad();
    let points = [[56.0, 132.0], [104.0, 77.0], [158.0, 70.0], [212.0, 108.0], [270.0, 112.0], [330.0, 62.0]];
    let mut drawing = Drawing::new()
        .arrow([40.0, 160.0], [350.0, 160.0])
        .arrow([48.0, 170.0], [48.0, 20.0])
        .path(Look::Line, polyline(&points))
        .path(
            Look::Hidden,
            [
                Step::Move([56.0, 104.0]),
                Step::Curve([110.0, 120.0], [160.0, 132.0], [210.0, 108.0]),
                Step::Curve([260.0, 84.0], [290.0, 80.0], [330.0, 112.0]),
            ],
        );
    for at in points {
        drawing = drawing.circle(Look::Hole, at, 4.0);
    }
    // One revolution is the width of the table.
    drawing
        .moves(
            &GroupAngles::anew(start, std::f64::consts::TAU),
            [56.0, 160.0],
            |angle| Placement::shifted([274.0 * (angle - start) / std::f64::consts::TAU, 0.0]),
            |it| it.line(Look::Axis, [56.0, 166.0], [56.0, 24.0]),
        )
        .calls("points", "J", [158.0, 70.0], [180.0, 34.0])
        .calls("start_angle", "φ_0", [56.0, 160.0], [84.0, 180.0])
        .calls("friction_torque", "T_L", [330.0, 112.0], [356.0, 134.0])
}

//! Points of a cam table and the conditions at its ends.

use crate::key::Column;
use crate::value::{Cell, Row, choices};
use quantities::Dimension;

/// Conditions at both ends of a cam table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CamEnds {
    Rest,
    Natural,
    Periodic,
    Stated,
}

/// A point of a cam table: a time or an angle of the master, and the position there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CamPoint([Cell; 2]);

impl Row for CamPoint {
    const COLUMNS: &'static [Column] = &[&[Dimension::Time, Dimension::Angle], &[Dimension::Angle, Dimension::Length]];

    fn of(cells: &[Cell]) -> Option<Self> {
        cells.try_into().ok().map(Self)
    }

    fn cells(&self) -> Vec<Cell> {
        self.0.to_vec()
    }

    fn is_of_a_line(&self) -> bool {
        self.measures()[1] == Dimension::Length
    }
}

impl CamPoint {
    /// Returns the dimensions of its columns.
    pub(crate) fn measures(&self) -> [Dimension; 2] {
        self.0.map(|(dimension, _)| dimension)
    }

    /// Returns time or angle of the master, and the position [SI].
    pub(crate) fn values(&self) -> [f64; 2] {
        self.0.map(|(_, value)| value)
    }
}

choices! {
    CamEnds { Rest = "rest", Natural = "natural", Periodic = "periodic", Stated = "stated" }
}

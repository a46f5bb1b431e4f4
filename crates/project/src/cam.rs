//! Points of a cam table and the conditions at its ends.

use crate::key::ColumnDimensions;
use crate::value::{QuantityRow, ValueCell, choices};
use quantities::Dimension;

/// Conditions at both ends of a cam table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CamEnds {
    /// Rest.
    Rest,
    /// No acceleration.
    Natural,
    /// Motion continues without a step from the end to the start.
    Periodic,
    /// Stated speed and acceleration.
    Stated,
}

/// A point of a cam table: a time or an angle of the master, and the position there.
#[derive(Clone, Copy, Debug)]
pub struct CamPoint([ValueCell; 2]);

impl QuantityRow for CamPoint {
    const COLUMNS: &'static [ColumnDimensions] =
        &[&[Dimension::Time, Dimension::Angle], &[Dimension::Angle, Dimension::Length]];

    fn of(cells: &[ValueCell]) -> Option<Self> {
        cells.try_into().ok().map(Self)
    }

    fn cells(&self) -> Vec<ValueCell> {
        self.0.to_vec()
    }

    fn is_of_a_line(&self) -> bool {
        self.measures()[1] == Dimension::Length
    }
}

impl CamPoint {
    /// Returns the dimensions of its columns.
    #[must_use]
    pub fn measures(&self) -> [Dimension; 2] {
        self.0.map(|(dimension, _)| dimension)
    }

    /// Returns time or angle of the master, and the position \[SI\].
    #[must_use]
    pub fn values(&self) -> [f64; 2] {
        self.0.map(|(_, value)| value)
    }
}

choices! {
    CamEnds { Rest = "rest", Natural = "natural", Periodic = "periodic", Stated = "stated" }
}

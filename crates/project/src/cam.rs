//! Points of a cam table and the conditions at its ends.

use crate::Fault;
use crate::flange::needs;
use crate::key::ColumnDimensions;
use crate::motion::Segment;
use crate::read::Reader;
use crate::stated::StatedField;
use crate::value::{QuantityRow, ValueCell, Written, choices};
use ::motion::Spline;
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
pub(crate) struct CamPoint([ValueCell; 2]);

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

impl Segment {
    /// Reports speeds and accelerations at the ends that are missing or that spline and ends do not use.
    pub(crate) fn end_keys(&self, spline: Option<Spline>, ends: Option<CamEnds>, reader: &mut Reader<'_>) {
        let Some(ends) = ends else { return };
        let fields: [(&dyn StatedField, bool); 4] = [
            (&self.start_speed, true),
            (&self.end_speed, true),
            (&self.start_acceleration, spline != Some(Spline::Cubic)),
            (&self.end_acceleration, spline != Some(Spline::Cubic)),
        ];
        for (field, of_spline) in fields {
            let other = if ends != CamEnds::Stated {
                Some((self.ends.name(), ends.written()))
            } else {
                (!of_spline).then(|| (self.spline.name(), Spline::Cubic.written()))
            };
            match other {
                Some((by, kind)) if field.is_given() => {
                    let fault = Fault::KeyOfAnotherKind { path: field.path(), by, kind };
                    reader.fault(field.span(), fault, None);
                }
                None if spline.is_some() => needs(&self.ends, field, reader),
                Some(_) | None => {}
            }
        }
    }
}

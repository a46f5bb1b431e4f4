//! Quantities with a tolerance: their paths and bands.

use quantities::Unit;
use std::ops::Range as Span;

/// Largest number of quantities of a file with a tolerance.
pub(crate) const TOLERANCES_MOST: usize = 64;

/// A quantity of a project with values in nominal ± half-width.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Key: `load.inertia`, `motion[2].speed`, `mechanism.table.points[1][3]`, `mechanism.turntable.bodies[1].mass`.
    pub path: String,
    /// Nominal value in SI.
    pub nominal: f64,
    /// Half-width of the band, in SI, greater than zero.
    pub half_width: f64,
    /// Unit in which the value is written.
    pub unit: &'static Unit,
    /// Place of the half-width in the file, in bytes.
    pub span: Span<usize>,
}

impl Tolerance {
    /// Returns the value at a share of the half-width from nominal, −1 to 1; in SI.
    #[must_use]
    pub fn at(&self, share: f64) -> f64 {
        self.nominal + share * self.half_width
    }
}

/// Returns the tolerances of one of several axes, counted from zero, under their keys within the axis.
pub(crate) fn of_axis(all: &[Tolerance], index: usize) -> Vec<Tolerance> {
    let prefix = format!("axis[{}].", index + 1);
    let inside = |each: &Tolerance| {
        let path = each.path.strip_prefix(&prefix)?.to_owned();
        Some(Tolerance { path, ..each.clone() })
    };
    all.iter().filter_map(inside).collect()
}

//! Loads on the flange.

use super::page::{FORCE, LENGTH, Page};
use arbitrary::Result;

/// Kind of load on the flange, as needed by the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LoadKind {
    /// Rotates without a limit.
    Free,
    /// Rotates within a range and returns.
    Bound,
    /// Moves along a line and returns.
    Line,
    /// Moves along a line without an end.
    Belt,
    /// The roll of a web: rotates between core and full roll.
    Winder,
}

/// Writes forces at the flange, for the whole cycle or a segment.
pub(super) fn forces(page: &mut Page<'_, '_>) -> Result<()> {
    page.key("radial_force", 1.0, 2000.0, FORCE)?;
    page.key("radial_distance", 1.0, 300.0, LENGTH)?;
    page.key("axial_force", 1.0, 2000.0, FORCE)?;
    page.key("axial_distance", 1.0, 200.0, LENGTH)
}

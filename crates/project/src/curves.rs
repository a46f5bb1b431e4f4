//! Curves that the user measured or digitised, for actuators of the catalogue.

use crate::about::About;
use crate::key::Variants;
use crate::section::{OfKinds, Section, names, section};
use crate::value::{CurveRow, Rows, WordChoice, choices};

/// Example of a curve.
pub(crate) const CURVE: &str = "[[\"0 1/min\", \"32 N m\"], [\"40 1/min\", \"25 N m\"]]";

section! {
    /// A curve of the user for actuators of the catalogue.
    CurveSection, CurveName of About::Curve {
        kind: CurveLimit => needed;
        code: String => example("CHA-25A-100-*");
        points: Rows<CurveRow> => example(CURVE);
        source: String;
    }
}

impl OfKinds for CurveSection {
    const VARIANTS: &'static Variants =
        &Variants { keys: Self::KEYS, by: "kind", kinds: &[of(0), of(1), of(2), of(3)], shared: &[] };
}

/// Returns the required and the optional keys of a curve.
#[allow(clippy::indexing_slicing, reason = "read while compiling: an index out of bounds does not compile")]
const fn of(kind: usize) -> (&'static str, &'static [&'static str], &'static [&'static str]) {
    (CurveLimit::WORDS[kind], names!(CurveSection: code points source), &[])
}

/// Limit that a curve states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveLimit {
    /// Continuous operation.
    Continuous,
    /// Operation for half of the time.
    Half,
    /// Operation for a quarter of the time.
    Quarter,
    /// Short-time operation.
    ShortTime,
}

choices! {
    CurveLimit { Continuous = "continuous", Half = "s3_50", Quarter = "s3_25", ShortTime = "short_time" }
}

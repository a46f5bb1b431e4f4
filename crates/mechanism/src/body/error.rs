//! Faults in the description of a body.

use quantities::{Length, Mass, MassDensity};

/// Fault in the description of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BodyError {
    /// A dimension is zero, negative or not finite.
    DimensionOutOfRange {
        /// Name of the dimension: `diameter`, `length`, `outer`, `inner`, `a`, `b`, `height`.
        field: &'static str,
        /// Value of the dimension.
        value: Length,
    },
    /// A dimension that the volume, or a lying body, needs is not stated.
    DimensionMissing {
        /// Name of the dimension: `length`, `height`.
        field: &'static str,
    },
    /// The inner diameter of a tube is not smaller than the outer one.
    InnerNotBelowOuter {
        /// Inner diameter.
        inner: Length,
        /// Outer diameter.
        outer: Length,
    },
    /// Neither mass nor density is stated.
    NoMass,
    /// Both mass and density are stated.
    MassAndDensity {
        /// Stated mass.
        mass: Mass,
        /// Stated density.
        density: MassDensity,
    },
    /// A point or a slender rod has no volume, so that a density does not determine its mass.
    NoVolume,
    /// The mass is zero, negative or not finite.
    MassOutOfRange {
        /// Stated mass.
        mass: Mass,
    },
    /// The density is zero, negative or not finite.
    DensityOutOfRange {
        /// Stated density.
        density: MassDensity,
    },
    /// The distance is negative or not finite.
    DistanceOutOfRange {
        /// Stated distance.
        distance: Length,
    },
    /// The angle is not finite.
    AngleNotFinite,
    /// The number of pieces is zero.
    NoPiece,
    /// The inertia of the bodies exceeds the range of floating-point numbers.
    BeyondNumbers,
}

/// A fault of one of several bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyFault {
    /// Index of the body, from zero.
    pub body: usize,
    /// Kind of fault.
    pub error: BodyError,
}

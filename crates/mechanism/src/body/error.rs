//! Why a body cannot be.

use quantities::{Length, Mass, MassDensity};

/// Why a body cannot be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BodyError {
    /// A dimension is zero, negative or not finite.
    DimensionOutOfRange {
        /// Which one: `diameter`, `length`, `outer`, `inner`, `a`, `b`, `height`.
        field: &'static str,
        /// Its value.
        value: Length,
    },
    /// The bore of a tube is not smaller than the tube.
    InnerNotBelowOuter {
        /// Inner diameter.
        inner: Length,
        /// Outer diameter.
        outer: Length,
    },
    /// Neither mass nor density is given.
    NoMass,
    /// Mass and density are both given.
    MassAndDensity {
        /// The mass.
        mass: Mass,
        /// The density.
        density: MassDensity,
    },
    /// A point or a slender rod has no volume, so a density gives no mass.
    NoVolume,
    /// The mass is zero, negative or not finite.
    MassOutOfRange {
        /// The mass.
        mass: Mass,
    },
    /// The density is zero, negative or not finite.
    DensityOutOfRange {
        /// The density.
        density: MassDensity,
    },
    /// The distance is negative or not finite.
    DistanceOutOfRange {
        /// The distance.
        distance: Length,
    },
    /// The angle is not finite.
    AngleNotFinite,
    /// There is no piece.
    NoPiece,
    /// The inertia of these bodies is beyond the range of numbers.
    BeyondNumbers,
}

/// What is wrong with one of several bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyFault {
    /// Index of the body, from zero.
    pub body: usize,
    /// What is wrong.
    pub error: BodyError,
}

//! Why a body cannot be.

use quantities::{Length, Mass, MassDensity, Measure};
use std::fmt;

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

impl fmt::Display for BodyError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DimensionOutOfRange { field, value } => {
                write!(formatter, "{field} of {} m is not greater than zero", value.si())
            }
            Self::InnerNotBelowOuter { inner, outer } => {
                write!(formatter, "inner diameter of {} m is not below the outer one of {} m", inner.si(), outer.si())
            }
            Self::NoMass => formatter.write_str("neither mass nor density is given"),
            Self::MassAndDensity { mass, density } => {
                write!(formatter, "mass of {} kg and density of {} kg/m³ are both given", mass.si(), density.si())
            }
            Self::NoVolume => formatter.write_str("a point or slender rod has no volume, so a density gives no mass"),
            Self::MassOutOfRange { mass } => write!(formatter, "mass of {} kg is not greater than zero", mass.si()),
            Self::DensityOutOfRange { density } => {
                write!(formatter, "density of {} kg/m³ is not greater than zero", density.si())
            }
            Self::DistanceOutOfRange { distance } => write!(formatter, "distance of {} m is negative", distance.si()),
            Self::AngleNotFinite => formatter.write_str("the angle is not finite"),
            Self::NoPiece => formatter.write_str("count is zero, there must be at least one piece"),
            Self::BeyondNumbers => formatter.write_str("the inertia is beyond the range of numbers"),
        }
    }
}

impl std::error::Error for BodyError {}

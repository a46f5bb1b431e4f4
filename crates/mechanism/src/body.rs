//! Solid bodies on the axis of rotation: their moments of inertia, mass and centre of mass.

use quantities::unit::STANDARD_GRAVITY;
use quantities::{Acceleration, Angle, Length, Mass, MassDensity, Measure, MomentOfInertia, Torque};
use std::f64::consts::PI;

mod error;

pub use error::{BodyError, BodyFault};

/// Orientation of a cylinder or tube relative to the axis of rotation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Orientation {
    /// Body axis parallel to the axis of rotation.
    #[default]
    Parallel,
    /// Body axis perpendicular to the axis of rotation: a lying cylinder.
    Perpendicular,
}

/// Shape of a homogeneous body. The moments of inertia refer to the axis through the centre of mass parallel to the
/// axis of rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolidShape {
    /// Solid cylinder; a disc is a short one.
    Cylinder {
        /// d: diameter.
        diameter: Length,
        /// L: length along the body axis; only the volume and a lying body need it.
        length: Option<Length>,
        /// Orientation of the body axis.
        orientation: Orientation,
    },
    /// Hollow cylinder.
    Tube {
        /// d_o: outer diameter.
        outer: Length,
        /// d_i: inner diameter, less than the outer one; zero makes it a cylinder.
        inner: Length,
        /// L: length along the body axis; only the volume and a lying body need it.
        length: Option<Length>,
        /// Orientation of the body axis.
        orientation: Orientation,
    },
    /// Cuboid.
    Box {
        /// a: one side of the footprint.
        a: Length,
        /// b: the other side of the footprint.
        b: Length,
        /// h: height, parallel to the axis of rotation; only the volume needs it.
        height: Option<Length>,
    },
    /// Solid circular cone with its axis parallel to the axis of rotation.
    Cone {
        /// d: diameter of the base.
        diameter: Length,
        /// h: height; only the volume needs it.
        height: Option<Length>,
    },
    /// Solid sphere.
    Sphere {
        /// d: diameter.
        diameter: Length,
    },
    /// A mass without extent.
    PointMass,
    /// Slender rod perpendicular to the axis of rotation.
    Rod {
        /// L: length.
        length: Length,
    },
}

/// A body, or several equal ones evenly spaced around the axis of rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Shape of the body.
    pub shape: SolidShape,
    /// m: mass of one piece; either this or the density is stated.
    pub mass: Option<Mass>,
    /// ρ: density; either this or the mass is stated.
    pub density: Option<MassDensity>,
    /// r: distance of the centre of mass from the axis of rotation.
    pub distance: Length,
    /// φ: direction of the centre of mass in the plane of rotation; with several pieces, that of the first.
    pub angle: Angle,
    /// z: number of equal pieces, evenly spaced on the circle of radius r.
    pub count: u32,
}

/// Contributions to the inertia of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyInertia {
    /// m: mass of one piece.
    pub mass: Mass,
    /// J_own: inertia of one piece about the parallel axis through its centre of mass.
    pub own: MomentOfInertia,
    /// m r² of one piece.
    pub steiner: MomentOfInertia,
    /// J = z (J_own + m r²) of all pieces.
    pub total: MomentOfInertia,
}

/// Inertia of several bodies in total.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// J: moment of inertia about the axis of rotation.
    pub inertia: MomentOfInertia,
    /// m: mass of all bodies.
    pub mass: Mass,
    /// r_c: distance of the common centre of mass from the axis of rotation; zero if balanced.
    pub centre_radius: Length,
    /// φ_c: direction of the common centre of mass, from −180° to 180°; zero if balanced.
    pub centre_angle: Angle,
}

/// Computes moment of inertia, mass and centre of mass of bodies on one axis of rotation.
///
/// J = Σ z (J_own + m r²), m = Σ z m, m r_c e^(jφ_c) = Σ z m r e^(jφ)
///
/// # Symbols
/// z number of pieces, J_own inertia about the body's own parallel axis \[kgm²\], m mass \[kg\], r distance \[m\], φ
/// direction \[rad\]
/// # Source
/// textbook mechanics: parallel axis theorem (Huygens-Steiner), centre of mass
/// # Valid
/// rigid homogeneous bodies; overlapping volumes count twice. Several evenly spaced pieces have their common centre on
/// the axis. A centre closer than 10⁻¹² of Σ z m r / m counts as balanced
/// # Errors
/// the faults of all bodies
pub fn inertia(bodies: &[Body]) -> Result<Inertia, Vec<BodyFault>> {
    let mut faults = Vec::new();
    let (mut total, mut mass, mut moment, mut x, mut y) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (index, body) in bodies.iter().enumerate() {
        match body.inertia() {
            Ok(parts) => {
                let pieces = f64::from(body.count);
                let one = parts.mass.si() * body.distance.si();
                total += parts.total.si();
                mass += pieces * parts.mass.si();
                moment += pieces * one;
                if body.count == 1 {
                    let (sin, cos) = body.angle.si().sin_cos();
                    x += one * cos;
                    y += one * sin;
                }
            }
            Err(errors) => faults.extend(errors.into_iter().map(|error| BodyFault { body: index, error })),
        }
    }
    if faults.is_empty() && ![total, mass, moment].into_iter().all(f64::is_finite) {
        faults.push(BodyFault { body: bodies.len().saturating_sub(1), error: BodyError::BeyondNumbers });
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let unbalance = x.hypot(y);
    let balanced = unbalance <= 1e-12 * moment || mass <= 0.0;
    Ok(Inertia {
        inertia: MomentOfInertia::from_si(total),
        mass: Mass::from_si(mass),
        centre_radius: Length::from_si(if balanced { 0.0 } else { unbalance / mass }),
        centre_angle: Angle::from_si(if balanced { 0.0 } else { y.atan2(x) }),
    })
}

impl Inertia {
    /// Returns the largest gravity torque about a horizontal axis of rotation.
    ///
    /// T_g = m g r_c
    ///
    /// # Symbols
    /// m mass \[kg\], g standard gravity [m/s²], r_c distance of the centre of mass \[m\]
    /// # Source
    /// textbook mechanics; g = 9.80665 m/s² (CGPM 1901)
    /// # Valid
    /// horizontal axis, centre of mass at the same height; zero if balanced
    #[must_use]
    pub fn gravity_torque_max(&self) -> Torque {
        (self.mass * Acceleration::new_in(1.0, &STANDARD_GRAVITY) * self.centre_radius).into()
    }
}

impl Body {
    /// Computes the mass of one piece and the contributions to the moment of inertia about the axis of rotation.
    ///
    /// J = z (J_own + m r²), m = ρ V if the density is stated
    ///
    /// # Symbols
    /// see [`inertia()`]; ρ density [kg/m³], V volume \[m³\]
    /// # Source
    /// textbook mechanics: parallel axis theorem
    /// # Valid
    /// homogeneous bodies
    /// # Errors
    /// the faults of the body
    pub fn inertia(&self) -> Result<BodyInertia, Vec<BodyError>> {
        let faults = self.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
        let mass = match (self.mass, self.density, self.shape.volume_m3()) {
            (Some(mass), ..) => mass.si(),
            (None, Some(density), Some(volume)) => density.si() * volume,
            _ => return Err(vec![BodyError::NoMass]),
        };
        let Some(own_per_mass) = self.shape.own_inertia_per_mass_m2() else {
            return Err(vec![BodyError::DimensionMissing { field: "length" }]);
        };
        let own = mass * own_per_mass;
        let steiner = mass * self.distance.si() * self.distance.si();
        let total = f64::from(self.count) * (own + steiner);
        if !total.is_finite() || !mass.is_finite() {
            return Err(vec![BodyError::BeyondNumbers]);
        }
        Ok(BodyInertia {
            mass: Mass::from_si(mass),
            own: MomentOfInertia::from_si(own),
            steiner: MomentOfInertia::from_si(steiner),
            total: MomentOfInertia::from_si(total),
        })
    }

    /// Returns the faults of the body; empty if it is valid.
    #[must_use]
    pub fn faults(&self) -> Vec<BodyError> {
        let above_zero = |si: f64| si.is_finite() && si > 0.0;
        let mut faults: Vec<BodyError> = self
            .shape
            .dimensions()
            .into_iter()
            .flatten()
            .filter(|(field, value)| !(above_zero(value.si()) || *field == "inner" && value.si() == 0.0))
            .map(|(field, value)| BodyError::DimensionOutOfRange { field, value })
            .collect();
        if let SolidShape::Tube { outer, inner, .. } = self.shape
            && above_zero(outer.si())
            && above_zero(inner.si())
            && inner.si() >= outer.si()
        {
            faults.push(BodyError::InnerNotBelowOuter { inner, outer });
        }
        let needed = self.shape.unstated().filter(|_| self.density.is_some() || self.shape.is_lying());
        faults.extend(needed.map(|field| BodyError::DimensionMissing { field }));
        match (self.mass, self.density) {
            (None, None) => faults.push(BodyError::NoMass),
            (Some(mass), Some(density)) => faults.push(BodyError::MassAndDensity { mass, density }),
            (None, Some(_)) if matches!(self.shape, SolidShape::PointMass | SolidShape::Rod { .. }) => {
                faults.push(BodyError::NoVolume);
            }
            _ => {}
        }
        faults.extend(self.mass.filter(|mass| !above_zero(mass.si())).map(|mass| BodyError::MassOutOfRange { mass }));
        let density = self.density.filter(|density| !above_zero(density.si()));
        faults.extend(density.map(|density| BodyError::DensityOutOfRange { density }));
        if !(self.distance.si().is_finite() && self.distance.si() >= 0.0) {
            faults.push(BodyError::DistanceOutOfRange { distance: self.distance });
        }
        if !self.angle.si().is_finite() {
            faults.push(BodyError::AngleNotFinite);
        }
        if self.count == 0 {
            faults.push(BodyError::NoPiece);
        }
        faults
    }
}

impl SolidShape {
    /// Returns the stated dimensions of the shape with their names.
    fn dimensions(&self) -> [Option<(&'static str, Length)>; 3] {
        let stated = |name, value: Option<Length>| value.map(|value| (name, value));
        match *self {
            Self::Cylinder { diameter, length, .. } => [Some(("diameter", diameter)), stated("length", length), None],
            Self::Tube { outer, inner, length, .. } => {
                [Some(("outer", outer)), Some(("inner", inner)), stated("length", length)]
            }
            Self::Box { a, b, height } => [Some(("a", a)), Some(("b", b)), stated("height", height)],
            Self::Cone { diameter, height } => [Some(("diameter", diameter)), stated("height", height), None],
            Self::Sphere { diameter } => [Some(("diameter", diameter)), None, None],
            Self::PointMass => [None; 3],
            Self::Rod { length } => [Some(("length", length)), None, None],
        }
    }

    /// Returns the name of a dimension that is not stated and that the volume, or a lying body, needs.
    const fn unstated(&self) -> Option<&'static str> {
        match self {
            Self::Cylinder { length: None, .. } | Self::Tube { length: None, .. } => Some("length"),
            Self::Box { height: None, .. } | Self::Cone { height: None, .. } => Some("height"),
            Self::Cylinder { .. }
            | Self::Tube { .. }
            | Self::Box { .. }
            | Self::Cone { .. }
            | Self::Sphere { .. }
            | Self::PointMass
            | Self::Rod { .. } => None,
        }
    }

    /// Returns `true` if the body axis is perpendicular to the axis of rotation.
    const fn is_lying(&self) -> bool {
        matches!(
            self,
            Self::Cylinder { orientation: Orientation::Perpendicular, .. }
                | Self::Tube { orientation: Orientation::Perpendicular, .. }
        )
    }

    /// Returns the volume \[m³\]; `None` for a point and a slender rod, which have none, and without a dimension.
    ///
    /// cylinder π/4 d² L · tube π/4 (d_o² − d_i²) L · box a b h · cone π/12 d² h · sphere π/6 d³
    ///
    /// # Source
    /// textbook geometry
    fn volume_m3(&self) -> Option<f64> {
        let square = |length: Length| length.si() * length.si();
        match *self {
            Self::Cylinder { diameter, length, .. } => Some(PI / 4.0 * square(diameter) * length?.si()),
            // The difference of the squares as a product is exact for thin walls too.
            Self::Tube { outer, inner, length, .. } => {
                Some(PI / 4.0 * (outer.si() - inner.si()) * (outer.si() + inner.si()) * length?.si())
            }
            Self::Box { a, b, height } => Some(a.si() * b.si() * height?.si()),
            Self::Cone { diameter, height } => Some(PI / 12.0 * square(diameter) * height?.si()),
            Self::Sphere { diameter } => Some(PI / 6.0 * square(diameter) * diameter.si()),
            Self::PointMass | Self::Rod { .. } => None,
        }
    }

    /// Returns the square of the radius of gyration, J_own/m \[m²\]; `None` for a lying body without a length.
    ///
    /// cylinder d²/8, lying d²/16 + L²/12 · tube (d_o² + d_i²)/8, lying (d_o² + d_i²)/16 + L²/12 ·
    /// box (a² + b²)/12 · cone 3/40 d² · sphere d²/10 · point 0 · rod L²/12
    ///
    /// # Source
    /// textbook mechanics: moments of inertia of homogeneous bodies
    /// # Valid
    /// about the axis through the centre of mass, parallel to the axis of rotation
    fn own_inertia_per_mass_m2(&self) -> Option<f64> {
        let square = |length: Length| length.si() * length.si();
        let round = |squares: f64, length: Option<Length>, orientation: Orientation| match orientation {
            Orientation::Parallel => Some(squares / 8.0),
            Orientation::Perpendicular => Some(squares / 16.0 + square(length?) / 12.0),
        };
        Some(match *self {
            Self::Cylinder { diameter, length, orientation } => round(square(diameter), length, orientation)?,
            Self::Tube { outer, inner, length, orientation } => {
                round(square(outer) + square(inner), length, orientation)?
            }
            Self::Box { a, b, .. } => (square(a) + square(b)) / 12.0,
            Self::Cone { diameter, .. } => 0.075 * square(diameter),
            Self::Sphere { diameter } => square(diameter) / 10.0,
            Self::PointMass => 0.0,
            Self::Rod { length } => square(length) / 12.0,
        })
    }
}

#[cfg(test)]
#[path = "body_tests.rs"]
mod tests;

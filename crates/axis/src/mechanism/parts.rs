//! Parts that several mechanisms have.

use mechanism::{Linear, LinearKind, MechanismKind};
use project::sections::{Counterweight, Fields, Friction, Guide, Slide, Stated, StatedField, group};
use quantities::{Angle, Mass, Measure};

/// Builds friction and constant torque at the output.
pub(super) fn friction(stated: &Friction) -> mechanism::Friction {
    mechanism::Friction {
        coulomb: stated.friction_torque.or_zero(),
        viscous: stated.viscous_friction.or_zero(),
        external: stated.external_torque.or_zero(),
    }
}

/// Returns the tilt of an axis of rotation: horizontal if none is stated; `None` if it was refused.
pub(super) fn level(tilt: &Stated<Angle>) -> Option<Angle> {
    if tilt.is_written() { tilt.value() } else { Some(Angle::from_si(std::f64::consts::FRAC_PI_2)) }
}

/// Builds a drive that moves a slide in proportion to the angle.
pub(super) fn linear(section: &impl Fields, kind: LinearKind, travel_m_per_rad: f64) -> Option<MechanismKind> {
    let (slide, guide): (&Slide, &Guide) = (group(section)?, group(section)?);
    let counterweight: Option<&Counterweight> = group(section);
    Some(MechanismKind::Linear(Linear {
        kind,
        travel_m_per_rad,
        inertia: slide.inertia.or_zero(),
        mass: slide.mass.value()?,
        counterweight: counterweight.map_or_else(|| Mass::from_si(0.0), |it| it.counterweight.or_zero()),
        inclination: slide.inclination.or_zero(),
        friction_force: guide.friction_force.or_zero(),
        friction_coefficient: guide.friction_coefficient(),
    }))
}

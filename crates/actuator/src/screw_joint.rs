//! The screw joints of load and housing.

use provenance::Datum;
use quantities::{Force, Length, Measure, Ratio, Torque};
use std::borrow::Cow;

/// What is known of one circle of screws.
#[derive(Clone, Debug, PartialEq)]
pub struct ScrewJoint {
    /// Number of screws.
    pub count: Datum<f64>,
    /// Thread: `M4`.
    pub size: Datum<Cow<'static, str>>,
    /// Property class: `12.9`.
    pub grade: Datum<Cow<'static, str>>,
    /// Diameter of the circle of screws.
    pub bolt_circle: Datum<Length>,
    /// Tightening torque of one screw.
    pub tightening_torque: Datum<Torque>,
    /// Torque that the joint transmits by friction; printed for completely degreased faces and a coefficient of 0.15.
    pub transmissible_torque: Datum<Torque>,
}

impl ScrewJoint {
    /// A joint of which nothing is known.
    #[must_use]
    pub const fn unknown() -> Self {
        Self {
            count: Datum::NotPrinted,
            size: Datum::NotPrinted,
            grade: Datum::NotPrinted,
            bolt_circle: Datum::NotPrinted,
            tightening_torque: Datum::NotPrinted,
            transmissible_torque: Datum::NotPrinted,
        }
    }
}

/// Share of the transmissible torque that a peak torque takes; above one the joint slips.
///
/// u = |T_peak| / T_transmissible
///
/// # Symbols  T_peak largest torque through the joint \[Nm\], T_transmissible torque at which it slips \[Nm\]
/// # Source   cha-manual table 79.1
/// # Valid    T_transmissible > 0; screws tightened as printed, faces completely degreased
#[must_use]
pub fn joint_utilisation(torque_peak: Torque, torque_transmissible: Torque) -> Ratio {
    Ratio::from_si(torque_peak.si().abs() / torque_transmissible.si())
}

/// Friction force of a joint on its circle of screws: what the printed torque amounts to for a transverse load.
///
/// F = 2 T / d
///
/// # Symbols  T transmissible torque \[Nm\], d bolt circle \[m\]
/// # Source   moment of a force on a circle
/// # Valid    d > 0
#[must_use]
pub fn joint_friction_force(torque_transmissible: Torque, bolt_circle: Length) -> Force {
    Force::from_si(2.0 * torque_transmissible.si() / bolt_circle.si())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Load side of CHA-40A and housing side of CHA-50A, both M8: 2774 N and 2766 N per screw.
    #[test]
    fn the_same_screw_gives_the_same_force() {
        let force = |torque, circle| joint_friction_force(Torque::from_si(torque), Length::from_si(circle)).si() / 12.0;
        assert!((force(1964.0, 0.118) - 2774.0).abs() < 0.5);
        assert!((force(3419.0, 0.206) - 2766.0).abs() < 0.5);
    }

    #[test]
    fn the_share_has_no_sign() {
        let share = |peak| joint_utilisation(Torque::from_si(peak), Torque::from_si(228.0)).si();
        assert!((share(57.0) - 0.25).abs() < 1e-15);
        assert!((share(-456.0) - 2.0).abs() < 1e-15);
    }
}

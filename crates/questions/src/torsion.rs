//! The torsion of a gear under a torque as a separate answer.

use crate::sizing_use::Candidate;
use actuator::{Parameters, Torsion};
use axis::AxisProject;
use provenance::{Datum, Source, Sourced};
use quantities::{Angle, Measure, Torque};

/// The known quantity of a twisted gear; the other one is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Twist {
    /// Torque on the gear.
    Torque(Torque),
    /// Angle of torsion.
    Angle(Angle),
}

/// The torsion of one code's gear under a torque.
#[derive(Clone, Debug)]
pub struct TorsionAnswer {
    /// The curve: T_1, T_2, K_1, K_2, K_3.
    pub curve: Torsion,
    /// Number of the table that states the curve; empty if it is of no table.
    pub table: &'static str,
    /// The torque.
    pub torque: Torque,
    /// The angle.
    pub angle: Angle,
    /// Stiffness region of the torque: 1, 2 or 3.
    pub region: u8,
    /// Width of the curve at zero torque after full torque in both directions: an upper bound.
    pub hysteresis_loss: Datum<Angle>,
    /// Width of the curve under a few per cent of the rated torque: an upper bound.
    pub lost_motion: Datum<Angle>,
    /// T_max of the actuator, then T_M of the gear.
    pub limits: [(&'static str, Datum<Torque>); 2],
}

impl TorsionAnswer {
    /// Iterates over the limits that the torque exceeds, by their symbols.
    pub fn exceeded(&self) -> impl Iterator<Item = (&'static str, &Sourced<Torque>)> {
        let known = self.limits.iter().filter_map(|(symbol, limit)| Some((*symbol, limit.known()?)));
        known.filter(|(_, limit)| self.torque.si().abs() > limit.value.si())
    }

    /// Returns the curve with the requested point.
    #[must_use]
    pub const fn at(&self) -> TorsionCurve {
        TorsionCurve { curve: self.curve, torque: self.torque, angle: self.angle }
    }
}

impl Twist {
    /// Returns the known quantity; `None` for none or both.
    pub(crate) fn of(torque: Option<Torque>, angle: Option<Angle>) -> Option<Self> {
        match (torque, angle) {
            (Some(torque), None) => Some(Self::Torque(torque)),
            (None, Some(angle)) => Some(Self::Angle(angle)),
            _ => None,
        }
    }
}

/// Computes the torsion of a code's gear under a torque, or the torque that twists it by an angle; `None` if the manual
/// does not state the stiffness.
///
/// # Source
/// cha-manual eq. 73.1 to 73.4, tables 54.1 to 54.4
#[must_use]
pub(crate) fn torsion(parameters: &Parameters, twist: Twist) -> Option<TorsionAnswer> {
    let curve = parameters.gear.torsion()?;
    let (torque, angle) = match twist {
        Twist::Torque(torque) => (torque, curve.angle(torque)),
        Twist::Angle(angle) => (curve.torque(angle), angle),
    };
    let size = torque.si().abs();
    let region = if size <= curve.torque_1.si() {
        1
    } else if size <= curve.torque_2.si() {
        2
    } else {
        3
    };
    let (hysteresis_loss, lost_motion) =
        (parameters.accuracy.hysteresis_loss.clone(), parameters.accuracy.lost_motion.clone());
    let limits = [("T_max", parameters.torque_max.clone()), ("T_M", parameters.gear.collision_torque_max.clone())];
    let table = match parameters.gear.stiffness.first().and_then(Datum::known).map(|known| &known.source) {
        Some(Source::Cell(cell)) => cell.table,
        _ => "",
    };
    Some(TorsionAnswer { curve, table, torque, angle, region, hysteresis_loss, lost_motion, limits })
}

/// Torsion curve of a gear with the operating point of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorsionCurve {
    /// The curve: T_1, T_2, K_1, K_2, K_3.
    pub curve: Torsion,
    /// Largest torque on the gear.
    pub torque: Torque,
    /// Torsion under this torque.
    pub angle: Angle,
}

impl TorsionCurve {
    /// Returns the corners of the curve from `−end` to `end`.
    #[must_use]
    pub fn points(&self, end: Torque) -> Vec<(Torque, Angle)> {
        let (one, two, end) = (self.curve.torque_1.si(), self.curve.torque_2.si(), end.si().abs());
        let corners = [-end, -two, -one, 0.0, one, two, end];
        let inside = corners.into_iter().filter(|torque| torque.abs() <= end).map(Torque::from_si);
        inside.map(|torque| (torque, self.curve.angle(torque))).collect()
    }
}

/// Returns the torsion curve of a candidate's gear and its operating point; `None` if the stiffness is not known.
///
/// # Source
/// cha-manual eq. 73.1 to 73.3; the torque is that of the torsion check, without the actuator's own inertia
#[must_use]
pub fn torsion_of(project: &AxisProject, candidate: &Candidate<'_>) -> Option<TorsionCurve> {
    let curve = candidate.parameters.gear.torsion()?;
    let torque = project.axis.moments().load_peak;
    Some(TorsionCurve { curve, torque, angle: curve.angle(torque) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use configurator::{Catalogue, Product};

    #[test]
    fn an_angle_leads_back_to_its_torque_in_every_region() {
        let code = configurator::parameters(&order_code::parse("CHA-20A-100-H-C1024").unwrap().code).unwrap();
        for (torque, region) in [(3.0, 1), (-20.0, 2), (60.0, 3)] {
            let there = torsion(&code, Twist::Torque(Torque::from_si(torque))).unwrap();
            let back = torsion(&code, Twist::Angle(there.angle)).unwrap();
            assert!((back.torque.si() - torque).abs() < 1e-9 && back.region == region, "{back:?}");
            assert_eq!(there.region, region);
        }
        // Table 54.1: size 20, ratio 100.
        let play = torsion(&code, Twist::Torque(Torque::from_si(1.0))).unwrap().hysteresis_loss;
        let minutes = play.known().unwrap().value.in_unit(&quantities::unit::ARCMINUTE);
        assert!((minutes - 1.0).abs() < 1e-9, "{minutes}");
    }

    #[test]
    fn torque_and_angle_exclude_each_other_and_one_is_needed() {
        let (torque, angle) = (Torque::from_si(60.0), Angle::from_si(1e-3));
        assert_eq!(Twist::of(Some(torque), None), Some(Twist::Torque(torque)));
        assert_eq!(Twist::of(None, Some(angle)), Some(Twist::Angle(angle)));
        assert_eq!(Twist::of(Some(torque), Some(angle)), None);
        assert_eq!(Twist::of(None, None), None);
    }

    /// A torque or an angle beyond T_max of the actuator is reported with the limit, in either direction; one below is not.
    #[test]
    fn a_torque_beyond_the_limits_is_reported() {
        for Product { id: code, parameters, .. } in Catalogue::cha().products(false) {
            let Some(largest) = parameters.torque_max.known().map(|known| known.value.si()) else { continue };
            let exceeded =
                |twist| torsion(parameters, twist).unwrap().exceeded().map(|(symbol, _)| symbol).collect::<Vec<_>>();
            let under = |torque: f64| exceeded(Twist::Torque(Torque::from_si(torque)));
            assert!(under(largest).is_empty() && under(-largest).is_empty(), "{code}");
            assert_eq!(under(1.001 * largest), ["T_max"], "{code}");
            assert!(under(-1e308).contains(&"T_max"), "{code}");
            assert!(exceeded(Twist::Angle(Angle::from_si(1.0))).contains(&"T_max"), "{code}");
        }
    }
}

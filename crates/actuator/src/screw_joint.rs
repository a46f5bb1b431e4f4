//! Bolted joints of load and housing.

use provenance::Datum;
use quantities::{Force, Length, Measure, Ratio, Torque};
use std::borrow::Cow;

/// Data of a bolt circle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ScrewJoint {
    /// Number of screws.
    pub count: Datum<f64>,
    /// Thread: `M4`.
    pub size: Datum<Cow<'static, str>>,
    /// Property class: `12.9`.
    pub grade: Datum<Cow<'static, str>>,
    /// Diameter of the bolt circle.
    pub bolt_circle: Datum<Length>,
    /// Tightening torque of one screw.
    pub tightening_torque: Datum<Torque>,
    /// Torque transmitted by friction; stated for completely degreased faces and a coefficient of friction of 0.15.
    pub transmissible_torque: Datum<Torque>,
}

/// Returns a peak torque relative to the transmissible torque \[1\]; above one the joint slips.
///
/// u = |T_peak| / T_transmissible
///
/// # Symbols
/// T_peak largest torque through the joint \[Nm\], T_transmissible torque at which it slips \[Nm\]
/// # Source
/// cha-manual table 79.1
/// # Valid
/// T_transmissible > 0; screws tightened as specified, faces completely degreased
#[must_use]
pub fn joint_utilisation(torque_peak: Torque, torque_transmissible: Torque) -> Ratio {
    Ratio::from_si(torque_peak.si().abs() / torque_transmissible.si())
}

/// Simultaneous loads on a bolt circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointLoad {
    /// Torque about the axis.
    pub torque: Torque,
    /// Tilting moment, about an axis in the joint face.
    pub tilting_moment: Torque,
    /// Axial force, assumed to separate the joint.
    pub axial: Force,
    /// Radial force, transmitted by friction.
    pub radial: Force,
}

/// Result for a bolt circle under a load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedJoint {
    /// Share of the clamp force removed by the load at the most relieved screw \[1\]; at one the joint opens there.
    pub relieved: Ratio,
    /// Share of the remaining friction used by torque and radial force \[1\]; `None` if the joint opens.
    pub slip: Option<Ratio>,
}

/// Returns the clamp force of one screw implied by a stated transmissible torque.
///
/// F_V = 2 T_trans/(µ n d)
///
/// # Symbols
/// T_trans transmissible torque \[Nm\], µ coefficient of friction, n number of screws, d bolt circle \[m\]
/// # Source
/// cha-manual table 79.1, inverted; docs/theory/screw-joint.md
/// # Valid
/// torque transmitted by friction alone, on the bolt circle; µ, n, d > 0
#[must_use]
pub fn clamp_force(torque_transmissible: Torque, friction: Ratio, count: f64, bolt_circle: Length) -> Force {
    Force::from_si(2.0 * torque_transmissible.si() / (friction.si() * count * bolt_circle.si()))
}

/// Computes a bolt circle under torque, tilting moment, axial and radial force.
///
/// F_B = 4 |M|/(n d) + |F_A|/n, r = F_B/F_V, u = (2 |T|/(n d) + |F_R|/n)/(µ (F_V − F_B))
///
/// The moment is distributed linearly over a rigid flange (Σ cos² φ = n/2). All screws are assumed to clamp like the
/// most relieved one, and the radial force to act along the torque everywhere: on the safe side, because clamp forces,
/// friction and centring are not known better. With torque alone u is [`joint_utilisation`].
///
/// # Symbols
/// M tilting moment \[Nm\], T torque \[Nm\], F_A, F_R axial and radial force \[N\], F_V clamp force of one screw \[N\],
/// F_B reduction of the clamp force by the load \[N\], n number of screws, d bolt circle \[m\], µ coefficient of
/// friction
/// # Source
/// docs/theory/screw-joint.md
/// # Valid
/// n ≥ 3, all screws tightened equally; u only while no screw is relieved completely
#[must_use]
pub fn loaded_joint(
    load: &JointLoad,
    clamp_force: Force,
    friction: Ratio,
    count: f64,
    bolt_circle: Length,
) -> LoadedJoint {
    let circle = count * bolt_circle.si();
    let pull = 4.0 * load.tilting_moment.si().abs() / circle + load.axial.si().abs() / count;
    let across = 2.0 * load.torque.si().abs() / circle + load.radial.si().abs() / count;
    let left = clamp_force.si() - pull;
    LoadedJoint {
        relieved: Ratio::from_si(pull / clamp_force.si()),
        slip: (left > 0.0).then(|| Ratio::from_si(across / (friction.si() * left))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_share_has_no_sign() {
        let share = |peak| joint_utilisation(Torque::from_si(peak), Torque::from_si(228.0)).si();
        assert!((share(57.0) - 0.25).abs() < 1e-15);
        assert!((share(-456.0) - 2.0).abs() < 1e-15);
    }

    /// M3 12.9 at the load side of CHA-14A: 85 Nm on 43 mm and twelve screws at µ = 0.15.
    fn clamp() -> (Force, Ratio, f64, Length) {
        let (friction, count, circle) = (Ratio::from_si(0.15), 12.0, Length::from_si(0.043));
        (clamp_force(Torque::from_si(85.0), friction, count, circle), friction, count, circle)
    }

    fn load(torque: f64, moment: f64, axial: f64, radial: f64) -> JointLoad {
        JointLoad {
            torque: Torque::from_si(torque),
            tilting_moment: Torque::from_si(moment),
            axial: Force::from_si(axial),
            radial: Force::from_si(radial),
        }
    }

    #[test]
    fn torque_alone_gives_the_plain_share() {
        let (clamp, friction, count, circle) = clamp();
        // 2 · 85/(0.15 · 12 · 0.043) = 2196 N.
        assert!((clamp.si() - 2196.4).abs() < 0.1, "{}", clamp.si());
        let joint = loaded_joint(&load(-28.0, 0.0, 0.0, 0.0), clamp, friction, count, circle);
        let plain = joint_utilisation(Torque::from_si(28.0), Torque::from_si(85.0));
        assert!((joint.slip.unwrap().si() - plain.si()).abs() < 1e-12);
        assert!(joint.relieved.si().abs() < 1e-15);
    }

    /// The largest force on a screw of a rigid flange is 4 M/(n d): the sum of force times lever over twelve screws is
    /// M.
    #[test]
    fn the_moment_is_carried_by_all_screws() {
        let (clamp, friction, count, circle) = clamp();
        let joint = loaded_joint(&load(0.0, 73.0, 0.0, 0.0), clamp, friction, count, circle);
        let largest = joint.relieved.si() * clamp.si();
        let moment: f64 = (0..12)
            .map(|screw| (f64::from(screw) * std::f64::consts::TAU / 12.0).cos())
            .map(|lever| largest * lever * lever * circle.si() / 2.0)
            .sum();
        assert!((moment - 73.0).abs() < 1e-9, "{moment}");
        // 2 µ M/T_trans, independent of the number of screws.
        assert!((joint.relieved.si() - 2.0 * 0.15 * 73.0 / 85.0).abs() < 1e-12);
    }

    #[test]
    fn forces_add_and_an_open_joint_carries_nothing() {
        let (clamp, friction, count, circle) = clamp();
        let all = loaded_joint(&load(28.0, 73.0, 1200.0, 240.0), clamp, friction, count, circle);
        // F_B = 565.9 + 100 N, F_left = 1530.5 N; across 108.5 + 20 N; 128.5/229.6.
        assert!((all.relieved.si() - 0.3032).abs() < 1e-4, "{:?}", all.relieved);
        assert!((all.slip.unwrap().si() - 0.5598).abs() < 2e-4, "{:?}", all.slip);
        let open = loaded_joint(&load(1.0, 300.0, 0.0, 0.0), clamp, friction, count, circle);
        assert!(open.relieved.si() > 1.0 && open.slip.is_none());
    }
}

//! The screw joints of load and housing.

use provenance::Datum;
use quantities::{Force, Length, Measure, Ratio, Torque};
use std::borrow::Cow;

/// What is known of one circle of screws.
#[derive(Clone, Debug, Default, PartialEq)]
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

/// Share of the transmissible torque that a peak torque takes; above one the joint slips.
///
/// u = |T_peak| / T_transmissible
///
/// # Symbols
/// T_peak largest torque through the joint \[Nm\], T_transmissible torque at which it slips \[Nm\]
/// # Source
/// cha-manual table 79.1
/// # Valid
/// T_transmissible > 0; screws tightened as printed, faces completely degreased
#[must_use]
pub fn joint_utilisation(torque_peak: Torque, torque_transmissible: Torque) -> Ratio {
    Ratio::from_si(torque_peak.si().abs() / torque_transmissible.si())
}

/// What loads a circle of screws at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointLoad {
    /// Torque about the axis.
    pub torque: Torque,
    /// Tilting moment, about an axis in the joint face.
    pub tilting_moment: Torque,
    /// Axial force; it counts as one that pulls the joint apart.
    pub axial: Force,
    /// Radial force, which the joint carries by friction.
    pub radial: Force,
}

/// A circle of screws under a load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedJoint {
    /// Share of the clamp force that the load takes from the screw which it relieves most; at one the joint opens there.
    pub relieved: Ratio,
    /// Share of the friction that is left which torque and radial force take; `None` where the joint opens.
    pub slip: Option<Ratio>,
}

/// Clamp force of one screw that a printed transmissible torque implies.
///
/// F_V = 2 T_trans/(µ n d)
///
/// # Symbols
/// T_trans transmissible torque \[Nm\], µ coefficient of friction, n number of screws, d bolt circle \[m\]
/// # Source
/// cha-manual table 79.1 read backwards; docs/theory/screw-joint.md
/// # Valid
/// friction alone transmits the torque, on the bolt circle; µ, n, d > 0
#[must_use]
pub fn clamp_force(torque_transmissible: Torque, friction: Ratio, count: f64, bolt_circle: Length) -> Force {
    Force::from_si(2.0 * torque_transmissible.si() / (friction.si() * count * bolt_circle.si()))
}

/// A circle of screws under torque, tilting moment, axial and radial force.
///
/// F_B = 4 |M|/(n d) + |F_A|/n, r = F_B/F_V, u = (2 |T|/(n d) + |F_R|/n)/(µ (F_V − F_B))
///
/// The moment is shared linearly over a rigid flange (Σ cos² φ = n/2). Every screw counts as if it clamped no better than the
/// one that is relieved most, and the radial force as if it acted along the torque everywhere: the safe side of a joint whose
/// clamping, friction and pilot are not known better. With torque alone u is [`joint_utilisation`].
///
/// # Symbols
/// M tilting moment \[Nm\], T torque \[Nm\], F_A, F_R axial and radial force \[N\], F_V clamp force of one screw \[N\],
/// F_B what the load takes from it \[N\], n number of screws, d bolt circle \[m\], µ coefficient of friction
/// # Source
/// docs/theory/screw-joint.md
/// # Valid
/// n ≥ 3, all screws tightened alike; u only while no screw is relieved wholly
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

    /// M3 12.9 at the load of CHA-14A: 85 Nm on 43 mm and twelve screws at µ = 0.15.
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
        // By hand: 2 · 85/(0.15 · 12 · 0.043) = 2196 N.
        assert!((clamp.si() - 2196.4).abs() < 0.1, "{}", clamp.si());
        let joint = loaded_joint(&load(-28.0, 0.0, 0.0, 0.0), clamp, friction, count, circle);
        let plain = joint_utilisation(Torque::from_si(28.0), Torque::from_si(85.0));
        assert!((joint.slip.unwrap().si() - plain.si()).abs() < 1e-12);
        assert!(joint.relieved.si().abs() < 1e-15);
    }

    /// The largest force on a screw of a rigid flange is 4 M/(n d): the sum of force times lever over twelve screws is M.
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
        // 2 µ M/T_trans, whatever the number of screws.
        assert!((joint.relieved.si() - 2.0 * 0.15 * 73.0 / 85.0).abs() < 1e-12);
    }

    #[test]
    fn forces_add_and_an_open_joint_carries_nothing() {
        let (clamp, friction, count, circle) = clamp();
        let all = loaded_joint(&load(28.0, 73.0, 1200.0, 240.0), clamp, friction, count, circle);
        // By hand: F_B = 565.9 + 100 N, F_left = 1530.5 N; across 108.5 + 20 N; 128.5/229.6.
        assert!((all.relieved.si() - 0.3032).abs() < 1e-4, "{:?}", all.relieved);
        assert!((all.slip.unwrap().si() - 0.5598).abs() < 2e-4, "{:?}", all.slip);
        let open = loaded_joint(&load(1.0, 300.0, 0.0, 0.0), clamp, friction, count, circle);
        assert!(open.relieved.si() > 1.0 && open.slip.is_none());
    }
}

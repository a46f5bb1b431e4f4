//! Loads on the flange compared with closed forms by hand, with the path of the centre of mass, limits and balances.

use super::*;
use crate::{FourBar, Hoist, Linear, LinearKind, MechanismKind, Rotor, RotorKind, SliderCrank, Winder, Winding};
use quantities::unit::DEGREE;
use quantities::{Force, MomentOfInertia, Torque};

const G: f64 = 9.806_65;

fn deg(angle: f64) -> Angle {
    Angle::new_in(angle, &DEGREE)
}

fn metres_of(length: f64) -> Length {
    Length::from_si(length)
}

fn out(q: f64, w: f64, a: f64) -> Output {
    Output {
        position_rad: q,
        speed_rad_s: w,
        acceleration_rad_s2: a,
        direction: if w == 0.0 { 0.0 } else { w.signum() },
    }
}

fn of(kind: MechanismKind) -> Mechanism {
    Mechanism { kind, ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0)) }
}

fn arm(mass: f64, tilt: f64) -> Mechanism {
    of(MechanismKind::Rotor(Rotor {
        kind: RotorKind::Arm,
        inertia: MomentOfInertia::from_si(0.8),
        mass: Mass::from_si(mass),
        radius: metres_of(0.35),
        payload_radius: metres_of(0.7),
        angle: deg(0.0),
        tilt: deg(tilt),
    }))
}

fn at(overhang: f64) -> Mounting {
    Mounting { overhang: Some(metres_of(overhang)), payload_overhang: Some(metres_of(0.12)), ..Mounting::default() }
}

fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-12 * (1.0 + expected.abs())
}

/// Constant speed about a horizontal axis: 6 kg at 0.35 m, 4 rad/s. Below, weight and centrifugal force add: 6 (g +
/// 16·0.35) = 92.4399 N; above they oppose: 6 (g − 5.6) = 25.2399 N; horizontal, √((6·5.6)² + (6 g)²) = 67.7576 N.
#[test]
fn an_arm_at_constant_speed_by_hand() {
    let radial =
        |angle: f64| arm(6.0, 90.0).flange_forces(&out(deg(angle).si(), 4.0, 0.0), &Extra::none(), 0.0, &at(0.05));
    assert!(close(radial(-90.0).radial(), 6.0 * (G + 5.6)));
    assert!(close(radial(90.0).radial(), 6.0 * (G - 5.6)));
    assert!((radial(0.0).radial() - 67.7576).abs() < 5e-5, "{}", radial(0.0).radial());
    // All forces act in the plane of the centre of mass: M = F_r (L + R).
    for angle in [-90.0, 0.0, 33.0, 90.0] {
        let forces = radial(angle);
        assert!(close(forces.moment(metres_of(0.018)), forces.radial() * 0.068));
        assert_eq!(forces.axial(), 0.0, "a level axis carries no weight along itself");
    }
}

/// A vertical axis, flange up, 3 rad/s and 20 rad/s²: radial 6·9·0.35 = 18.9 N, tangential 6·20·0.35 = 42 N, axial 6 g.
/// The moment about the face: weight at the radius 0.35·6 g = 20.594 Nm and z F_r = 0.05·18.9 tilt to the same side, z
/// F_t = 2.1 Nm at right angles.
#[test]
fn a_vertical_axis_by_hand() {
    let forces = arm(6.0, 0.0).flange_forces(&out(0.7, 3.0, 20.0), &Extra::none(), 0.0, &at(0.05));
    assert!(close(forces.radial(), (18.9_f64.powi(2) + 42.0_f64.powi(2)).sqrt()));
    assert!(close(forces.axial(), 6.0 * G));
    let expected = ((0.35 * 6.0 * G + 0.05 * 18.9).powi(2) + 2.1_f64.powi(2)).sqrt();
    assert!(close(forces.moment(metres_of(0.0)), expected), "{}", forces.moment(metres_of(0.0)));
    // With the flange downwards the weight tilts in the opposite direction.
    let below = arm(6.0, 180.0).flange_forces(&out(0.7, 3.0, 20.0), &Extra::none(), 0.0, &at(0.05));
    let expected = ((0.35 * 6.0 * G - 0.05 * 18.9).powi(2) + 2.1_f64.powi(2)).sqrt();
    assert!(close(below.moment(metres_of(0.0)), expected));
}

/// Returns a fixed pseudorandom sequence in 0…1 (linear congruential), so that every run tests the same states.
fn draws(count: usize) -> Vec<[f64; 6]> {
    let mut state = 12_345_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(state >> 32).unwrap()) / f64::from(u32::MAX)
    };
    (0..count).map(|_| [next(), next(), next(), next(), next(), next()]).collect()
}

/// F = m (g − a), with a from finite differences of the path of the centre of mass in the fixed frame: two masses, any
/// tilt.
#[test]
fn forces_are_those_of_the_path_of_the_centre_of_mass() {
    for [q0, w, a, tilt, m, p] in draws(200) {
        let (q0, w, a, tilt) = (6.0 * q0, 16.0 * w - 8.0, 80.0 * a - 40.0, std::f64::consts::PI * tilt);
        let rotor = Rotor {
            kind: RotorKind::Arm,
            tilt: Angle::from_si(tilt),
            ..match arm(1.0 + 9.0 * m, 0.0).kind {
                MechanismKind::Rotor(r) => r,
                _ => unreachable!(),
            }
        };
        let mass = [rotor.mass.si(), 5.0 * p];
        let extra = Extra { mass: Mass::from_si(mass[1]), ..Extra::none() };
        let found = of(MechanismKind::Rotor(rotor)).flange_forces(&out(q0, w, a), &extra, 0.0, &at(0.05));
        // The flange in the fixed frame: x horizontal, y steepest upwards, z out of the flange; up is sin β y + cos β
        // z.
        let up = [0.0, tilt.sin(), tilt.cos()];
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        for (m, r, z) in [(mass[0], 0.35, 0.05), (mass[1], 0.7, 0.12)] {
            let path = |t: f64| {
                let q = q0 + w * t + 0.5 * a * t * t;
                [r * q.cos(), r * q.sin(), z]
            };
            let h = 1e-4;
            let here = path(0.0);
            let acceleration: Vec<f64> = (0..3)
                .map(|i| {
                    (-path(2.0 * h)[i] + 16.0 * path(h)[i] - 30.0 * here[i] + 16.0 * path(-h)[i] - path(-2.0 * h)[i])
                        / (12.0 * h * h)
                })
                .collect();
            let f: Vec<f64> = (0..3).map(|i| m * (-G * up[i] - acceleration[i])).collect();
            for i in 0..3 {
                force[i] += f[i];
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                moment[i] += here[j] * f[k] - here[k] * f[j];
            }
        }
        let scale = 1.0 + force.iter().map(|f| f.abs()).sum::<f64>();
        assert!((found.radial() - force[0].hypot(force[1])).abs() < 2e-6 * scale);
        assert!((found.axial() - force[2].abs()).abs() < 2e-6 * scale);
        assert!((found.moment(metres_of(0.0)) - moment[0].hypot(moment[1])).abs() < 2e-6 * scale);
        // About the axis the same forces yield the torque of the mechanism, except for the inertia about the centres of
        // mass.
        let own = rotor.inertia.si() - mass[0] * 0.35 * 0.35;
        let asked = of(MechanismKind::Rotor(rotor)).torque(&out(q0, w, a), &extra);
        assert!((asked - own * a + moment[2]).abs() < 2e-6 * scale, "{asked} {}", moment[2]);
    }
}

/// Over a closed cycle the momentum returns to its initial value, so that the impulse of the force is that of the
/// weight: about a horizontal axis ∫F dt = −m g τ upwards and zero horizontally. q = sin(2πt/τ).
#[test]
fn over_a_closed_cycle_the_impulse_is_that_of_the_weight() {
    let (tau, n) = (0.8_f64, 4000);
    let w = std::f64::consts::TAU / tau;
    let (mut level, mut upwards) = (0.0, 0.0);
    for step in 0..n {
        let t = tau * (f64::from(step) + 0.5) / f64::from(n);
        let state = out((w * t).sin(), w * (w * t).cos(), -w * w * (w * t).sin());
        let [x, y] = arm(6.0, 90.0).flange_forces(&state, &Extra::none(), 0.0, &at(0.0)).radial_n;
        level += x * tau / f64::from(n);
        upwards += y * tau / f64::from(n);
    }
    assert!(level.abs() < 1e-9 && (upwards + 6.0 * G * tau).abs() < 1e-9, "{level} {upwards}");
}

#[test]
fn no_mass_no_load_and_a_share_is_a_share() {
    let state = out(0.4, 5.0, 30.0);
    assert_eq!(arm(0.0, 60.0).flange_forces(&state, &Extra::none(), 0.0, &at(0.05)), FlangeForces::default());
    let whole = arm(6.0, 60.0).flange_forces(&state, &Extra::none(), 0.0, &at(0.05));
    let third =
        arm(6.0, 60.0).flange_forces(&state, &Extra::none(), 0.0, &Mounting { share: Some(1.0 / 3.0), ..at(0.05) });
    assert!(close(third.moment(metres_of(0.02)) * 3.0, whole.moment(metres_of(0.02))));
    assert!(close(third.axial() * 3.0, whole.axial()));
}

fn linear(kind: LinearKind) -> Linear {
    Linear {
        kind,
        travel_m_per_rad: 0.06,
        inertia: MomentOfInertia::from_si(0.004),
        mass: Mass::from_si(18.0),
        counterweight: Mass::from_si(0.0),
        inclination: deg(0.0),
        friction_force: Force::from_si(35.0),
        friction_coefficient: 0.02,
    }
}

/// A belt by hand: 18 kg, friction 35 N + 0.02·18 g = 38.530 N; at 2.5 m/s² the slide needs 83.530 N, with both pulleys
/// beyond the belt 0.004/0.06² · 2.5 = 2.778 N more; η = 0.95: 90.851 N. With 150 N in each span the pulley bears
/// 390.851 N.
#[test]
fn a_belt_by_hand() {
    let belt = Mechanism { efficiency_driving: 0.95, ..of(MechanismKind::Linear(linear(LinearKind::Belt))) };
    let mounting = Mounting { contact: Some(Contact::Belt { tension: Force::from_si(150.0) }), ..at(0.03) };
    let forces = belt.flange_forces(&out(0.0, 1.0, 2.5 / 0.06), &Extra::none(), 0.0, &mounting);
    assert!((forces.radial() - 390.851).abs() < 1e-3, "{}", forces.radial());
    assert!(close(forces.moment(metres_of(0.014)), forces.radial() * 0.044));
    // At the same deceleration the slide pushes with 45 − 38.530 N against the belt; the losses may occur anywhere.
    let braking = belt.flange_forces(&out(0.0, 1.0, -2.5 / 0.06), &Extra::none(), 0.0, &mounting);
    assert!((braking.radial() - 300.0 - (45.0 - 38.530_394 + 2.777_778)).abs() < 1e-5, "{}", braking.radial());
    assert_eq!(belt.missing_for_forces(&at(0.03)), Some("bearing.belt_tension"));
    assert_eq!(belt.missing_for_moment(&Mounting { overhang: None, ..mounting }, false), Some("bearing.overhang"));
}

/// A pinion of 20°, spur and with a helix of 30°: F_t = 83.530 N; the resultant of a spur pinion is F_t/cos 20°.
#[test]
fn a_rack_by_hand() {
    let rack = of(MechanismKind::Linear(Linear { inertia: MomentOfInertia::from_si(0.0), ..linear(LinearKind::Belt) }));
    let mesh = |helix: f64| Mounting {
        contact: Some(Contact::Mesh { pressure_angle: deg(20.0), helix_angle: deg(helix) }),
        ..at(0.03)
    };
    let state = out(0.0, 1.0, 2.5 / 0.06);
    let tangential = 18.0 * 2.5 + 35.0 + 0.02 * 18.0 * G;
    let spur = rack.flange_forces(&state, &Extra::none(), 0.0, &mesh(0.0));
    assert!(close(spur.radial(), tangential / 20.0_f64.to_radians().cos()) && spur.axial() == 0.0);
    let helical = rack.flange_forces(&state, &Extra::none(), 0.0, &mesh(30.0));
    assert!(close(helical.axial(), tangential * 30.0_f64.to_radians().tan()));
    let radial = tangential * 1.0_f64.hypot(20.0_f64.to_radians().tan() / 30.0_f64.to_radians().cos());
    assert!(close(helical.moment(metres_of(0.014)), radial * 0.044 + helical.axial() * 0.06));
}

#[test]
fn a_screw_pushes_along_the_axis() {
    let screw = of(MechanismKind::Linear(Linear { inclination: deg(90.0), ..linear(LinearKind::Screw) }));
    let mounting = Mounting { share: Some(1.0), ..Mounting::default() };
    let up = screw.flange_forces(&out(0.0, 1.0, 2.0 / 0.06), &Extra::none(), 0.0, &mounting);
    assert!(close(up.axial(), 18.0 * (2.0 + G) + 35.0) && up.radial() == 0.0 && up.moment(metres_of(0.02)) == 0.0);
    assert_eq!(screw.missing_for_forces(&at(0.0)), Some("bearing.flange_share"));
    assert_eq!(screw.missing_for_moment(&mounting, true), None);
}

/// The pin force turns the crank with the torque of the mechanism, T = −(r × F)_z, in every state; its resultant is the
/// slider's force over cos ψ.
#[test]
fn the_force_at_the_crank_pin_makes_the_torque() {
    let crank = SliderCrank {
        crank: metres_of(0.1),
        rod: metres_of(0.32),
        inertia: MomentOfInertia::from_si(0.0),
        mass: Mass::from_si(5.0),
        inclination: deg(35.0),
        angle: deg(0.0),
    };
    for [q, w, a, ..] in draws(100) {
        let state = out(6.2 * q, 20.0 * w - 10.0, 60.0 * a - 30.0);
        let load = of(MechanismKind::SliderCrank(crank));
        let forces = load.flange_forces(&state, &Extra::none(), 0.0, &at(0.0));
        let torque = load.torque(&state, &Extra::none());
        let [fx, fy] = forces.radial_n;
        let (sin, cos) = state.position_rad.sin_cos();
        // The vector is known except for its sign.
        let couple = 0.1 * (cos * fy - sin * fx);
        assert!((couple.abs() - torque.abs()).abs() < 1e-9 * (1.0 + torque.abs()), "{couple} {torque}");
        let sin_psi = 0.1 / 0.32 * sin;
        assert!(close(forces.radial(), fx.abs() / (1.0 - sin_psi * sin_psi).sqrt()));
    }
}

/// A pulley of 2 kg adds its weight to the belt pull on a horizontal axis, and presses along a vertical one.
#[test]
fn the_weight_of_a_wheel_follows_the_axis() {
    let belt = of(MechanismKind::Linear(linear(LinearKind::Belt)));
    let with = |tilt: f64| Mounting {
        contact: Some(Contact::Belt { tension: Force::from_si(100.0) }),
        wheel_mass: Some(Mass::from_si(2.0)),
        axis_tilt: Some(deg(tilt)),
        ..at(0.03)
    };
    let still = |tilt: f64| belt.flange_forces(&out(0.0, 0.0, 0.0), &Extra::none(), 0.0, &with(tilt));
    assert!(close(still(90.0).radial(), 200.0 + 2.0 * G) && still(90.0).axial() == 0.0);
    assert!(close(still(0.0).radial(), 200.0) && close(still(0.0).axial(), 2.0 * G));
    assert!(close(still(90.0).moment(metres_of(0.014)), (200.0 + 2.0 * G) * 0.044));
}

/// The weight of the roll turns with the axis: m g sin β across it, m g cos β along it, beside the tension; without a
/// stated tilt the axis is horizontal.
#[test]
fn the_weight_of_a_roll_turns_with_the_axis() {
    let winder = of(MechanismKind::Winder(Winder {
        winding: Winding::Up,
        core_diameter: metres_of(0.09),
        full_diameter: metres_of(0.6),
        start_diameter: metres_of(0.6),
        thickness: metres_of(0.0005),
        width: metres_of(0.4),
        density: quantities::MassDensity::from_si(900.0),
        tension: Force::from_si(50.0),
        inertia: MomentOfInertia::from_si(0.02),
    }));
    let weight = std::f64::consts::PI * 900.0 * 0.4 * (0.3 * 0.3 - 0.045 * 0.045) * G;
    for (tilt, across, along) in [
        (None, 1.0, 0.0),
        (Some(90.0), 1.0, 0.0),
        (Some(0.0), 0.0, 1.0),
        (Some(180.0), 0.0, 1.0),
        (Some(30.0), 0.5, 0.75_f64.sqrt()),
    ] {
        let mounting = Mounting { axis_tilt: tilt.map(deg), ..at(0.2) };
        let forces = winder.flange_forces(&out(0.0, 0.0, 0.0), &Extra::none(), 0.0, &mounting);
        assert!(close(forces.radial(), 50.0 + across * weight), "{tilt:?} {forces:?}");
        assert!((forces.axial() - along * weight).abs() < 1e-9 * weight, "{tilt:?} {forces:?}");
        assert!(close(forces.moment(metres_of(0.02)), 0.22 * (50.0 + across * weight)), "{tilt:?} {forces:?}");
        // A core of 5 kg weighs in both directions too.
        let with_core =
            Mounting { wheel_mass: Some(Mass::from_si(5.0)), axis_tilt: Some(deg(tilt.unwrap_or(90.0))), ..at(0.2) };
        let forces = winder.flange_forces(&out(0.0, 0.0, 0.0), &Extra::none(), 0.0, &with_core);
        assert!(close(forces.radial(), 50.0 + across * (weight + 5.0 * G)), "{tilt:?} {forces:?}");
        assert!((forces.axial() - along * (weight + 5.0 * G)).abs() < 1e-9 * weight, "{tilt:?} {forces:?}");
    }
}

/// A force behind the bearing centre has the lever |L + R|: winder and wheel agree with the hoist, whose force has a
/// direction.
#[test]
fn a_negative_overhang_turns_the_lever_round() {
    let winder = of(MechanismKind::Winder(Winder {
        winding: Winding::Up,
        core_diameter: metres_of(0.09),
        full_diameter: metres_of(0.33),
        start_diameter: metres_of(0.2),
        thickness: metres_of(0.002),
        width: metres_of(0.4),
        density: quantities::MassDensity::from_si(900.0),
        tension: Force::from_si(80.0),
        inertia: MomentOfInertia::from_si(0.02),
    }));
    let hoist = of(MechanismKind::Hoist(Hoist {
        drum_diameter: metres_of(0.12),
        falls: 1,
        inertia: MomentOfInertia::from_si(0.0),
        mass: Mass::from_si(45.0),
        counterweight: Mass::from_si(0.0),
        rope_mass: Mass::from_si(0.0),
        hanging: metres_of(0.0),
        reeving: 1.0,
    }));
    let belt = of(MechanismKind::Linear(linear(LinearKind::Belt)));
    for overhang in [-0.08, -0.02, -0.005, 0.0, 0.03] {
        let still = out(0.0, 0.0, 0.0);
        let lever = (overhang + 0.018_f64).abs();
        for mechanism in [&winder, &hoist] {
            let forces = mechanism.flange_forces(&still, &Extra::none(), 0.0, &at(overhang));
            assert!(close(forces.moment(metres_of(0.018)), forces.radial() * lever), "{overhang} {forces:?}");
        }
        // Belt pull and pulley weight at the same place.
        let mounting = Mounting {
            contact: Some(Contact::Belt { tension: Force::from_si(100.0) }),
            wheel_mass: Some(Mass::from_si(2.0)),
            axis_tilt: Some(deg(90.0)),
            ..at(overhang)
        };
        let forces = belt.flange_forces(&still, &Extra::none(), 0.0, &mounting);
        assert!(close(forces.moment(metres_of(0.018)), (200.0 + 2.0 * G) * lever), "{overhang} {forces:?}");
    }
}

/// The pin of a four-bar linkage bears F/η while the crank drives, F while the linkage does.
#[test]
fn a_linkage_that_drives_loads_the_pin_in_full() {
    let linkage = |efficiency: f64| Mechanism {
        efficiency_driving: efficiency,
        ..of(MechanismKind::FourBar(FourBar {
            ground: metres_of(0.4),
            crank: metres_of(0.1),
            coupler: metres_of(0.35),
            rocker: metres_of(0.25),
            coupler_mass: Mass::from_si(2.0),
            coupler_centre: metres_of(0.17),
            rocker_mass: Mass::from_si(4.0),
            rocker_centre: metres_of(0.15),
            rocker_inertia: MomentOfInertia::from_si(0.25),
            tilt: deg(90.0),
            ..FourBar::default()
        }))
    };
    let mut seen = [0, 0];
    for [q, w, a, ..] in draws(200) {
        let state = out(6.2 * q, 20.0 * w - 10.0, 60.0 * a - 30.0);
        let radial =
            |efficiency: f64| linkage(efficiency).flange_forces(&state, &Extra::none(), 0.0, &at(0.0)).radial();
        let drives = linkage(1.0).torque(&state, &Extra::none()) * state.direction > 0.0;
        let expected = radial(1.0) / if drives { 0.8 } else { 1.0 };
        assert!(close(radial(0.8), expected), "{drives} {} {expected}", radial(0.8));
        seen[usize::from(drives)] += 1;
    }
    assert!(seen[0] > 20 && seen[1] > 20, "{seen:?}");
}

/// The inertia of a payload may be beyond the belt like that of the mechanism: the loads are the same wherever it is
/// stated.
#[test]
fn an_inertia_pulls_the_belt_wherever_it_is_stated() {
    for kind in [LinearKind::Belt, LinearKind::Conveyor] {
        let bare = linear(kind);
        let heavy = Linear { inertia: bare.inertia + MomentOfInertia::from_si(0.2), ..bare };
        let payload = Extra { inertia: MomentOfInertia::from_si(0.2), ..Extra::none() };
        let mounting = Mounting { contact: Some(Contact::Belt { tension: Force::from_si(150.0) }), ..at(0.03) };
        for acceleration in [-80.0, -5.0, 0.0, 5.0, 80.0] {
            let out = out(0.0, 1.0, acceleration);
            let stated = of(MechanismKind::Linear(heavy)).flange_forces(&out, &Extra::none(), 0.0, &mounting);
            let carried = of(MechanismKind::Linear(bare)).flange_forces(&out, &payload, 0.0, &mounting);
            assert!((stated.radial() - carried.radial()).abs() < 1e-9, "{kind:?} {acceleration}");
        }
    }
}

/// Forces in the plane of the bearing centre have no moment about it, whatever the digits of distance and force.
#[test]
fn forces_at_the_centre_have_no_moment() {
    for tenth in 1..400_u32 {
        let distance = f64::from(tenth) * 1e-4;
        for force in [0.3, 45.7, 9.81 * 37.0, 12_345.678] {
            let mut forces = FlangeForces::default();
            for share in [1.0, 0.7, 0.1] {
                forces.act([0.031, -0.02, -distance], [share * force, -0.7 * share * force, 0.0]);
                forces.aligned.radial_n += share * force;
                forces.aligned.moment_nm -= distance * share * force;
            }
            assert_eq!(forces.moment(metres_of(distance)), 0.0, "{distance} {force}");
            assert!(forces.moment(metres_of(distance * (1.0 + 1e-12))) > 0.0);
        }
    }
}

//! The stage compared with the equations of both its sides, its limits and the power balance.

use super::*;
use crate::{Contact, Linear, LinearKind, MechanismKind, Mounting, Rotor, RotorKind};
use quantities::unit::DEGREE;
use quantities::{Force, Mass};

fn stage(ratio: f64) -> Stage {
    Stage {
        kind: StageKind::Belt,
        ratio,
        efficiency_driving: 1.0,
        efficiency_driven: 1.0,
        inertia_driving: MomentOfInertia::from_si(0.0),
        inertia_driven: MomentOfInertia::from_si(0.0),
        stiffness: None,
        backlash: None,
        pitch_diameter: None,
    }
}

fn out(q: f64, w: f64, a: f64, direction: f64) -> Output {
    Output { position_rad: q, speed_rad_s: w, acceleration_rad_s2: a, direction }
}

fn arm() -> Mechanism {
    let rotor = Rotor {
        kind: RotorKind::Arm,
        inertia: MomentOfInertia::from_si(0.8),
        mass: Mass::from_si(6.0),
        radius: Length::from_si(0.35),
        payload_radius: Length::from_si(0.7),
        angle: Angle::new_in(0.0, &DEGREE),
        tilt: Angle::new_in(90.0, &DEGREE),
    };
    let mut arm = Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(2.0));
    arm.kind = MechanismKind::Rotor(rotor);
    arm
}

fn with(mechanism: Mechanism, stage: Stage) -> Mechanism {
    Mechanism { stage: Some(stage), ..mechanism }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * (1.0 + b.abs())
}

/// 0.8 kgm² beyond n = 4: 0.05 kgm², friction 2 Nm: 0.5 Nm, a quarter of the gravity torque at a quarter of the angle.
#[test]
fn a_ratio_by_hand() {
    let (plain, geared) = (arm(), with(arm(), stage(4.0)));
    let none = Extra::none();
    for (q, w, a) in [(0.0, 2.0, 10.0), (1.2, -3.0, 4.0), (0.4, 0.0, 0.0)] {
        let sense = if w == 0.0 { 0.0 } else { f64::signum(w) };
        let at_load = plain.torque(&out(q, w, a, sense), &none);
        assert!(close(geared.torque(&out(4.0 * q, 4.0 * w, 4.0 * a, sense), &none), at_load / 4.0));
        assert!(close(geared.holding_torque(4.0 * q, &none).si(), plain.holding_torque(q, &none).si() / 4.0));
    }
    assert!(close(geared.inertia(0.3, &none).si(), 0.05));
    assert!(close(geared.coulomb_torque().si(), 0.5));
}

/// Pure inertia: J/n² with J_1 and J_2 in addition, in torque and in inertia.
#[test]
fn a_pure_inertia_is_referred_with_the_square() {
    let load = Mechanism::direct(MomentOfInertia::from_si(1.8), Torque::from_si(0.0));
    for n in [0.5, 1.0, 3.0, 7.5] {
        let both = Stage {
            inertia_driving: MomentOfInertia::from_si(0.02),
            inertia_driven: MomentOfInertia::from_si(0.3),
            ..stage(n)
        };
        let geared = with(load.clone(), both);
        let expected = (1.8 + 0.3) / (n * n) + 0.02;
        assert!(close(geared.inertia(0.0, &Extra::none()).si(), expected));
        assert!(close(geared.torque(&out(0.0, 5.0, 11.0, 1.0), &Extra::none()), expected * 11.0));
    }
}

#[test]
fn a_stage_that_changes_nothing_is_not_there() {
    let plain = arm();
    let through = with(arm(), Stage { stiffness: Some(TorsionalStiffness::from_si(9e3)), ..stage(1.0) });
    for (q, w, a) in [(0.1, 2.0, 10.0), (1.2, -3.0, 4.0)] {
        let state = out(q, w, a, f64::signum(w));
        assert_eq!(through.torque(&state, &Extra::none()), plain.torque(&state, &Extra::none()));
    }
    assert_eq!(through.plain(&Extra::none()), plain.plain(&Extra::none()));
}

/// Input power times efficiency is output power while driving, and vice versa while driven.
#[test]
fn losses_take_their_share_of_the_power() {
    let lossy = Stage { efficiency_driving: 0.9, efficiency_driven: 0.7, ..stage(3.0) };
    let (plain, geared) = (arm(), with(arm(), lossy));
    let mut seen = [false; 2];
    for step in 0..40 {
        let q = 0.16 * f64::from(step);
        let (at_load, state) = (plain.torque(&out(q, 2.0, 3.0, 1.0), &Extra::none()), out(3.0 * q, 6.0, 9.0, 1.0));
        let (before, behind) = (geared.torque(&state, &Extra::none()) * 6.0, at_load * 2.0);
        let driving = behind > 0.0;
        seen[usize::from(driving)] = true;
        assert!(close(before, if driving { behind / 0.9 } else { behind * 0.7 }), "{before} {behind}");
    }
    assert_eq!(seen, [true, true]);
    // At rest the losses are no relief.
    let still = geared.torque(&out(0.0, 0.0, 0.0, 0.0), &Extra::none());
    assert!(close(still, plain.torque(&out(0.0, 0.0, 0.0, 0.0), &Extra::none()) / 3.0));
}

/// Springs in series: under a torque T the angle is T/K + n (n T/K_s) at the output of the actuator.
#[test]
fn stiffness_in_series() {
    let springy = with(arm(), Stage { stiffness: Some(TorsionalStiffness::from_si(50e3)), ..stage(3.0) });
    let (gear, torque) = (TorsionalStiffness::from_si(20e3), 17.0);
    let angle = torque / gear.si() + 3.0 * (3.0 * torque / 50e3);
    assert!(close(torque / springy.in_series(gear).si(), angle));
    assert_eq!(arm().in_series(gear), gear);
    assert_eq!(with(arm(), stage(3.0)).in_series(gear), gear);
}

/// A slide with a stage: the travel is k/n per angle of the output.
#[test]
fn the_line_behind_a_stage() {
    let linear = Linear {
        kind: LinearKind::Belt,
        travel_m_per_rad: 0.06,
        inertia: MomentOfInertia::from_si(0.0),
        mass: Mass::from_si(18.0),
        counterweight: Mass::from_si(0.0),
        inclination: Angle::from_si(0.0),
        friction_force: Force::from_si(0.0),
        friction_coefficient: 0.0,
    };
    let mut slide = Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0));
    slide.kind = MechanismKind::Linear(linear);
    let geared = with(slide, stage(2.0));
    assert_eq!(geared.travel_m_per_rad(), Some(0.03));
    assert!(close(geared.inertia(0.0, &Extra::none()).si(), 18.0 * 0.03 * 0.03));
}

/// A belt stage pulls with 2 F_v + 2 T/d: 0.8 kgm² · 5 rad/s² + 2 Nm beyond n = 2 are 3 Nm, at d = 60 mm 100 N.
#[test]
fn a_belt_stage_pulls_on_the_flange() {
    let mut load = Mechanism::direct(MomentOfInertia::from_si(0.8), Torque::from_si(2.0));
    load.stage = Some(Stage { pitch_diameter: Some(Length::from_si(0.06)), ..stage(2.0) });
    let mounting = Mounting {
        overhang: Some(Length::from_si(0.025)),
        contact: Some(Contact::Belt { tension: Force::from_si(80.0) }),
        ..Mounting::default()
    };
    let forces = load.flange_forces(&out(0.0, 4.0, 10.0, 1.0), &Extra::none(), 0.0, &mounting);
    assert!(close(forces.radial(), 260.0), "{forces:?}");
    assert!(close(forces.moment(Length::from_si(0.015)), 260.0 * 0.04));
    assert_eq!(load.missing_for_forces(&mounting), None);
    assert_eq!(load.missing_for_forces(&Mounting::default()), Some("bearing.belt_tension"));
    load.stage = Some(stage(2.0));
    assert_eq!(load.missing_for_forces(&mounting), Some("stage.pitch_diameter"));
    load.stage = Some(Stage { kind: StageKind::Coupling, ..stage(1.0) });
    let coupled = load.flange_forces(&out(0.0, 4.0, 10.0, 1.0), &Extra::none(), 0.0, &mounting);
    assert_eq!((coupled.radial(), load.missing_for_moment(&Mounting::default(), true)), (0.0, None));
}

use super::*;
use quantities::unit::DEGREE;
use quantities::{Angle, Length, ViscousFriction};

fn out(q: f64, w: f64, a: f64, direction: f64) -> Output {
    Output { position_rad: q, speed_rad_s: w, acceleration_rad_s2: a, direction }
}

fn deg(angle: f64) -> Angle {
    Angle::new_in(angle, &DEGREE)
}

#[test]
fn friction_helps_braking_and_is_gone_at_rest() {
    let load = Mechanism::direct(MomentOfInertia::from_si(1.3), Torque::from_si(5.0));
    let alpha = 40.0 * std::f64::consts::TAU / 60.0 / 0.1;
    let at =
        |alpha: f64, direction| load.torque(&out(0.0, direction, alpha, direction), &Extra::none()) + 1.063 * alpha;
    assert!((at(alpha, 1.0) - 103.98).abs() < 0.005, "T_1 of the worked example");
    assert!((at(-alpha, 1.0) - -93.98).abs() < 0.005, "T_3 of the worked example");
    assert!((at(-alpha, -1.0) - -103.98).abs() < 0.005, "the mirror image");
    assert_eq!(load.torque(&out(0.0, 0.0, 0.0, 0.0), &Extra::none()), 0.0);
}

fn arm(angle: f64, tilt: f64) -> Mechanism {
    let rotor = Rotor {
        kind: RotorKind::Arm,
        inertia: MomentOfInertia::from_si(0.8),
        mass: Mass::from_si(6.0),
        radius: Length::from_si(0.35),
        payload_radius: Length::from_si(0.7),
        angle: deg(angle),
        tilt: deg(tilt),
    };
    Mechanism {
        kind: MechanismKind::Rotor(rotor),
        ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
    }
}

/// An arm by hand: 6 kg at 0.35 m, horizontal: 6·9.80665·0.35 = 20.594 Nm; 2 kg payload at 0.7 m adds 13.729 Nm and
/// 0.98 kgm².
#[test]
fn an_arm_by_hand() {
    let still = out(0.0, 0.0, 0.0, 0.0);
    let torque = |angle, tilt| arm(angle, tilt).torque(&still, &Extra::none());
    assert!((torque(0.0, 90.0) - 20.593_965).abs() < 1e-6);
    assert!((torque(60.0, 90.0) - 10.296_983).abs() < 1e-6);
    assert!(torque(90.0, 90.0).abs() < 1e-12, "upright needs nothing");
    assert!(torque(0.0, 0.0).abs() < 1e-12, "a vertical axis feels no gravity");
    assert!((torque(0.0, 30.0) - 10.296_983).abs() < 1e-6, "half of it at 30° of tilt");
    let extra = Extra { mass: Mass::from_si(2.0), ..Extra::none() };
    let loaded = arm(0.0, 90.0);
    assert!((loaded.torque(&still, &extra) - (20.593_965 + 13.729_31)).abs() < 1e-6);
    assert!((loaded.inertia(0.0, &extra).si() - 1.78).abs() < 1e-12);
}

fn linear(kind: LinearKind, travel: f64, inclination: f64) -> Mechanism {
    let linear = Linear {
        kind,
        travel_m_per_rad: travel,
        inertia: MomentOfInertia::from_si(2e-4),
        mass: Mass::from_si(80.0),
        counterweight: Mass::from_si(0.0),
        inclination: deg(inclination),
        friction_force: Force::from_si(30.0),
        friction_coefficient: 0.05,
    };
    Mechanism {
        kind: MechanismKind::Linear(linear),
        ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
    }
}

/// Eq. 70.3 by hand: J = m (P/2π)² = 80·(0.02/2π)² = 8.1057e-4 kgm², T = P/2π (F + μ m g) = 3.1831e-3·(30 + 39.2266).
#[test]
fn a_horizontal_screw_by_hand() {
    let k = 0.02 / std::f64::consts::TAU;
    let screw = linear(LinearKind::Screw, k, 0.0);
    assert!((screw.inertia(0.0, &Extra::none()).si() - (2e-4 + 8.105_695e-4)).abs() < 1e-9);
    let torque = screw.torque(&out(0.0, 10.0, 0.0, 1.0), &Extra::none());
    assert!((torque - 3.183_099e-3 * 69.2266).abs() < 1e-6, "{torque}");
    assert_eq!(screw.holding_torque(0.0, &Extra::none()).si(), 0.0);
}

#[test]
fn a_vertical_screw_carries_the_weight_both_ways() {
    let k = 0.02 / std::f64::consts::TAU;
    let mut screw = linear(LinearKind::Screw, k, 90.0);
    screw.efficiency_driving = 0.9;
    screw.efficiency_driven = 0.8;
    let weight = k * 80.0 * gravity_m_s2();
    let up = screw.torque(&out(0.0, 10.0, 0.0, 1.0), &Extra::none());
    let down = screw.torque(&out(0.0, -10.0, 0.0, -1.0), &Extra::none());
    // A vertical guide bears no normal force; the friction of the wipers passes through the screw too.
    assert!((up - (weight + k * 30.0) / 0.9).abs() < 1e-12);
    assert!((down - (weight - k * 30.0) * 0.8).abs() < 1e-12);
    let still = screw.torque(&out(0.0, 0.0, 0.0, 0.0), &Extra::none());
    assert!((still - weight).abs() < 1e-12, "at rest neither friction nor efficiency helps");
}

/// A belt axis has the values of a screw whose lead is 2π times the pulley radius.
#[test]
fn a_belt_is_a_screw_of_another_lead() {
    let (belt, screw) = (linear(LinearKind::Belt, 0.04, 20.0), linear(LinearKind::Screw, 0.04, 20.0));
    let state = out(1.0, 3.0, 12.0, 1.0);
    assert_eq!(belt.torque(&state, &Extra::none()), screw.torque(&state, &Extra::none()));
    assert_eq!(linear(LinearKind::Conveyor, 0.04, 0.0).endless(), Endless::Everywhere);
    assert_eq!(belt.endless(), Endless::Never);
}

/// The power of the torque equals the change of the slider's kinetic and potential energy by finite differences.
#[test]
fn a_slider_crank_conserves_energy() {
    let crank = SliderCrank {
        crank: Length::from_si(0.1),
        rod: Length::from_si(0.32),
        inertia: MomentOfInertia::from_si(0.02),
        mass: Mass::from_si(5.0),
        inclination: deg(35.0),
        angle: deg(10.0),
    };
    let load = Mechanism {
        kind: MechanismKind::SliderCrank(crank),
        ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
    };
    let x = |q: f64| {
        let q = q + deg(10.0).si();
        0.1 * q.cos() + (0.32_f64.powi(2) - (0.1 * q.sin()).powi(2)).sqrt()
    };
    let energy = |q: f64, w: f64| {
        let h = 1e-5;
        let v = (x(q + h) - x(q - h)) / (2.0 * h) * w;
        0.5 * 0.02 * w * w + 0.5 * 5.0 * v * v + 5.0 * gravity_m_s2() * deg(35.0).si().sin() * x(q)
    };
    for step in 0..36 {
        let (q, w, a) = (f64::from(step) * 0.1745, 7.0, 11.0);
        let h = 1e-4;
        let at = |t: f64| energy(q + w * t + 0.5 * a * t * t, w + a * t);
        let power = (at(h) - at(-h)) / (2.0 * h);
        let torque = load.torque(&out(q, w, a, 1.0), &Extra::none());
        assert!((power / w - torque).abs() < 1e-4 * (1.0 + torque.abs()), "{q}: {} {torque}", power / w);
    }
}

#[test]
fn a_table_repeats_or_ends() {
    let point = |q: f64, j: f64, t: f64| TablePoint {
        position: deg(q),
        inertia: MomentOfInertia::from_si(j),
        torque: Torque::from_si(t),
    };
    let load = |points| Mechanism {
        kind: MechanismKind::Table(Table::new(points).unwrap()),
        ..Mechanism::direct(MomentOfInertia::from_si(0.0), Torque::from_si(0.0))
    };
    let round = load(vec![point(0.0, 1.0, 0.0), point(90.0, 2.0, 10.0), point(360.0, 1.0, 0.0)]);
    assert_eq!(round.endless(), Endless::EachRevolution);
    let torque = |m: &Mechanism, q: f64| m.torque(&out(deg(q).si(), 0.0, 0.0, 0.0), &Extra::none());
    assert!((torque(&round, 45.0) - 5.0).abs() < 1e-9 && (torque(&round, 405.0) - 5.0).abs() < 1e-9);
    // ½ J' ω² with J' = 1/(π/2) on the first span.
    let moving = round.useful_torque(&out(deg(45.0).si(), 3.0, 0.0, 1.0), &Extra::none());
    assert!((moving - (5.0 + 0.5 * 9.0 / std::f64::consts::FRAC_PI_2)).abs() < 1e-9);
    let bounded = load(vec![point(0.0, 1.0, 0.0), point(90.0, 2.0, 10.0)]);
    assert_eq!(bounded.endless(), Endless::Never);
    assert!((torque(&bounded, 120.0) - 10.0).abs() < 1e-12);
    assert_eq!(Table::new(vec![point(0.0, 1.0, 0.0)]), Err(TableFault::TooFewPoints));
    assert_eq!(Table::new(vec![point(1.0, 1.0, 0.0), point(1.0, 1.0, 0.0)]), Err(TableFault::PositionsNotAscending));
    assert_eq!(Table::new(vec![point(0.0, -1.0, 0.0), point(1.0, 1.0, 0.0)]), Err(TableFault::NegativeInertia));
}

#[test]
fn the_limits_are_ideal() {
    let mut load = linear(LinearKind::Belt, 0.04, 20.0);
    let state = out(0.0, 2.0, 5.0, 1.0);
    let ideal = load.useful_torque(&state, &Extra::none());
    load.efficiency_driving = 0.5;
    assert!((load.torque(&state, &Extra::none()) - 2.0 * ideal).abs() < 1e-12);
    let mut free = Mechanism::direct(MomentOfInertia::from_si(1.0), Torque::from_si(0.0));
    assert_eq!(free.torque(&state, &Extra::none()), 5.0, "perfect efficiency and no friction leave J α");
    free.friction.viscous = ViscousFriction::from_si(3.0);
    free.friction.external = Torque::from_si(1.0);
    assert_eq!(free.torque(&state, &Extra::none()), 12.0);
    assert_eq!(free.torque(&out(0.0, -2.0, 5.0, -1.0), &Extra::none()), 0.0, "external torque does not reverse");
}

/// Without friction and process the torque is proportional to all masses and inertias, behind a stage too.
#[test]
fn all_masses_and_inertias_scale_the_torque_behind_a_stage_too() {
    let inertia = MomentOfInertia::from_si;
    let stage = Stage {
        kind: StageKind::Belt,
        ratio: 2.5,
        efficiency_driving: 0.95,
        efficiency_driven: 0.9,
        inertia_driving: inertia(0.004),
        inertia_driven: inertia(0.03),
        stiffness: None,
        backlash: None,
        pitch_diameter: None,
    };
    let load = Mechanism { stage: Some(stage), ..Mechanism::direct(inertia(0.2), Torque::from_si(0.0)) };
    for factor in [0.25, 0.5, 1.0, 1.7, 8.0] {
        for alpha in [-30.0, -2.0, 0.5, 12.0] {
            for speed in [-4.0, 3.0_f64] {
                let state = out(0.3, speed, alpha, speed.signum());
                let torque = load.torque(&state, &Extra::none());
                let scaled = load.with_masses(factor).torque(&state, &Extra::none());
                assert!((scaled - factor * torque).abs() < 1e-12 * torque.abs().max(1.0), "{factor} {alpha} {speed}");
            }
        }
    }
}

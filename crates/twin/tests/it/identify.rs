//! What is planted is recovered: simulate, add noise, identify.

use super::parameters;
use mechanism::{Extra, Friction, Mechanism, MechanismKind, Rotor, RotorKind};
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia, Time, Torque, ViscousFriction};
use twin::{Estimate, Identified, IdentifyFault, Observed, Setup, Switches, Twin, identify};

/// Numbers that look normal, the same on every run.
fn noise(state: &mut u64) -> f64 {
    let mut uniform = || {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((*state >> 33) as u32) / f64::from(u32::MAX >> 1)
    };
    (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

fn there_and_back() -> Motion {
    let of = |angle: f64, time: f64| {
        let given =
            Given { distance: Some(Angle::from_si(angle)), time: Some(Time::from_si(time)), ..Given::default() };
        SegmentSpec::Move(Law::ModifiedSine, given)
    };
    Motion::new(&[of(1.6, 0.9), of(-1.6, 1.3), of(1.0, 0.6), of(-1.0, 0.9)], None, Closing::Position).unwrap()
}

/// A recorded run of a load, a row each millisecond, the torque with noise.
fn recorded(mechanism: &Mechanism, deviation_nm: f64, seed: u64) -> Observed {
    let (parameters, motion, extras) = (parameters("CHA-20A-100-H-C1024"), there_and_back(), [Extra::none()]);
    let switches = Switches { noise: false, ..Switches::default() };
    let setup = Setup { switches, ..Setup::of(&parameters, mechanism, &motion, &extras) };
    let mut twin = Twin::new(&setup).unwrap();
    let (mut run, mut state) = (Observed::default(), seed);
    while !twin.is_over() {
        twin.advance(16);
        let now = twin.sample();
        run.time_s.push(now.time_s);
        run.position_rad.push(now.position_rad);
        run.speed_rad_s.push(now.speed_rad_s);
        run.acceleration_rad_s2.push(now.acceleration_rad_s2);
        run.motor_rad_s.push(now.motor_rad_s);
        run.torque_nm.push(now.torque_nm + deviation_nm * noise(&mut state));
        run.current_q_a.push(now.current_q_a);
    }
    run
}

fn found(all: &[Estimate], of: Identified) -> Estimate {
    *all.iter().find(|each| each.of == of).unwrap_or_else(|| panic!("{of:?} of {all:?}"))
}

/// Inertia, Coulomb and viscous friction, gravity and external torque of the load lie within their intervals, which are narrow,
/// and the torque constant is that of the table.
#[test]
fn planted_values_are_recovered_within_their_intervals() {
    let (inertia, coulomb, viscous, weight) = (0.9, 3.0, 1.5, 6.0);
    // A mass on a lever of a metre: m g = W.
    let rotor = Rotor {
        kind: RotorKind::Arm,
        mass: Mass::from_si(weight / mechanism::gravity_m_s2()),
        radius: Length::from_si(1.0),
        tilt: Angle::from_si(std::f64::consts::FRAC_PI_2),
        ..Rotor::balanced(MomentOfInertia::from_si(inertia))
    };
    let friction = Friction {
        coulomb: Torque::from_si(coulomb),
        viscous: ViscousFriction::from_si(viscous),
        external: Torque::from_si(2.0),
    };
    let mechanism = Mechanism { kind: MechanismKind::Rotor(rotor), friction, ..super::load(inertia, coulomb) };
    let flange = 0.02 * parameters("CHA-20A-100-H-C1024").actuator.inertia_out.known().unwrap().value.si();
    for seed in [1, 2, 3] {
        let all = identify(&recorded(&mechanism, 0.3, seed)).unwrap();
        let wanted = [
            (Identified::LoadInertia, inertia + flange, 0.03),
            (Identified::Coulomb, coulomb, 0.5),
            (Identified::Viscous, viscous, 0.5),
            (Identified::Gravity, weight, 0.6),
            (Identified::External, 2.0, 0.6),
        ];
        for (of, value, narrow) in wanted {
            let estimate = found(&all, of);
            // An interval of 95 % fails in one run of twenty: half as much again.
            let error = (estimate.value - value).abs();
            assert!(error <= 1.5 * estimate.half_width, "{seed} {estimate:?} {value}");
            assert!(estimate.half_width < narrow, "{seed} {estimate:?}");
        }
        let constant = found(&all, Identified::TorqueConstant);
        assert!((constant.value / 33.4 - 1.0).abs() < 0.03, "{constant:?}");
    }
}

/// A run without motion, and columns of different lengths, are refused.
#[test]
fn what_says_nothing_is_refused() {
    let rest = Observed { time_s: vec![0.0; 100], ..Observed::default() };
    assert_eq!(identify(&rest), Err(IdentifyFault::Uneven));
    let still = || vec![0.0; 100];
    let rest = Observed {
        time_s: still(),
        position_rad: still(),
        speed_rad_s: still(),
        acceleration_rad_s2: still(),
        motor_rad_s: still(),
        torque_nm: still(),
        current_q_a: still(),
    };
    assert_eq!(identify(&rest), Err(IdentifyFault::TooFew));
}

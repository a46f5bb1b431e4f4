//! What is planted is recovered: simulate, add noise, identify.

use super::parameters;
use mechanism::{Extra, Friction, Linear, LinearKind, Mechanism, MechanismKind, Rotor, RotorKind};
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use quantities::{
    Angle, Force, Length, Mass, Measure, MomentOfInertia, ThermodynamicTemperature, Time, Torque, ViscousFriction,
};
use twin::{Estimate, Identified, IdentifyFault, Observed, Setup, Switches, Twin, identify};

const CODE: &str = "CHA-20A-100-H-C1024";

/// Numbers that look normal, the same on every run: twelve of SplitMix64.
fn noise(state: &mut u64) -> f64 {
    let mut uniform = || {
        *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        f64::from(((z ^ (z >> 31)) >> 32) as u32) / f64::from(u32::MAX)
    };
    (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

fn moves(all: &[(f64, f64)]) -> Motion {
    let of = |(angle, time): &(f64, f64)| {
        let given =
            Given { distance: Some(Angle::from_si(*angle)), time: Some(Time::from_si(*time)), ..Given::default() };
        SegmentSpec::Move(Law::ModifiedSine, given)
    };
    Motion::new(&all.iter().map(of).collect::<Vec<_>>(), None, Closing::Position).unwrap()
}

/// Moves of several sizes and durations, none at the limit of the current.
const EXCITING: [(f64, f64); 8] =
    [(1.6, 0.9), (-1.6, 1.3), (1.0, 0.6), (-1.0, 0.9), (2.2, 1.1), (-2.2, 0.95), (0.8, 0.7), (-0.8, 0.5)];

/// A recorded run of a load, a row each millisecond.
fn recorded(mechanism: &Mechanism, motion: &Motion, seed: u64) -> Observed {
    let (parameters, extras) = (parameters(CODE), [Extra::none()]);
    let setup = Setup { switches: Switches::default(), seed, ..Setup::of(&parameters, mechanism, motion, &extras) };
    let mut twin = Twin::new(&setup).unwrap();
    let mut run = Observed::default();
    while !twin.is_over() {
        twin.advance(16);
        let now = twin.sample();
        run.time_s.push(now.time_s);
        run.position_rad.push(now.position_rad);
        run.speed_rad_s.push(now.speed_rad_s);
        run.acceleration_rad_s2.push(now.acceleration_rad_s2);
        run.motor_rad_s.push(now.motor_rad_s);
        run.torque_nm.push(now.torque_nm);
        run.current_q_a.push(now.current_q_a);
    }
    run
}

/// The run as an instrument shows it: noise of 0.3 Nm on the torque, 0.05 A on the current.
fn measured(run: &Observed, seed: u64) -> Observed {
    let (mut run, mut state) = (run.clone(), seed.wrapping_mul(0xd134_2543_de82_ef95) ^ 0x5eed);
    for torque in &mut run.torque_nm {
        *torque += 0.3 * noise(&mut state);
    }
    for current in &mut run.current_q_a {
        *current += 0.05 * noise(&mut state);
    }
    run
}

fn found(all: &[Estimate], of: Identified) -> Option<Estimate> {
    all.iter().find(|each| each.of == of).copied()
}

/// Largest i_q of the drive, peak of a phase.
fn limit_a() -> f64 {
    std::f64::consts::SQRT_2 * parameters(CODE).actuator.current_max.known().unwrap().value.si()
}

/// A flywheel, an arm under gravity and an inclined belt axis, each with friction and a constant torque.
fn loads() -> [Mechanism; 3] {
    let friction = Friction {
        coulomb: Torque::from_si(3.0),
        viscous: ViscousFriction::from_si(1.5),
        external: Torque::from_si(2.0),
    };
    let of = |kind| Mechanism { kind, friction, ..super::load(0.9, 3.0) };
    let inertia = MomentOfInertia::from_si(0.9);
    let arm = Rotor {
        kind: RotorKind::Arm,
        mass: Mass::from_si(6.0 / mechanism::gravity_m_s2()),
        radius: Length::from_si(1.0),
        tilt: Angle::from_si(std::f64::consts::FRAC_PI_2),
        ..Rotor::balanced(inertia)
    };
    let belt = Linear {
        kind: LinearKind::Belt,
        travel_m_per_rad: 0.04,
        inertia: MomentOfInertia::from_si(0.02),
        mass: Mass::from_si(400.0),
        counterweight: Mass::from_si(0.0),
        inclination: Angle::from_si(0.1),
        friction_force: Force::from_si(20.0),
        friction_coefficient: 0.01,
    };
    [of(MechanismKind::Rotor(Rotor::balanced(inertia))), of(MechanismKind::Rotor(arm)), of(MechanismKind::Linear(belt))]
}

/// Planted values: of the load, and of the motor with the friction of 20 °C.
fn planted(mechanism: &Mechanism) -> Vec<(Identified, f64)> {
    let actuator = parameters(CODE).actuator;
    let flange = 0.02 * actuator.inertia_out.known().unwrap().value.si();
    let plain = mechanism.plain(&Extra::none()).unwrap();
    let cold = actuator::NoLoadFriction::of(&actuator).unwrap().at(ThermodynamicTemperature::from_si(293.15));
    vec![
        (Identified::LoadInertia, plain.inertia_kgm2 + flange),
        (Identified::Coulomb, plain.coulomb_nm),
        (Identified::Viscous, plain.viscous_nms),
        (Identified::Gravity, plain.weight_nm),
        (Identified::External, plain.constant_nm),
        (Identified::TorqueConstant, actuator.torque_constant_out.known().unwrap().value.si()),
        (Identified::StartingCurrent, cold.starting.si()),
        (Identified::CurrentConstant, cold.constant.si()),
    ]
}

/// How many of forty runs, each with its own phases and noise, have each planted value in its interval.
fn covered(mechanism: &Mechanism, motion: &Motion) -> Vec<(Identified, usize)> {
    let planted = planted(mechanism);
    let mut inside: Vec<_> = planted.iter().map(|(of, _)| (*of, 0)).collect();
    for seed in 0..40 {
        let run = measured(&recorded(mechanism, motion, seed), seed);
        let all = identify(&run, Some(limit_a())).unwrap().estimates;
        for ((of, value), (_, count)) in planted.iter().zip(&mut inside) {
            let estimate = found(&all, *of).unwrap_or_else(|| panic!("{of:?}"));
            *count += usize::from((estimate.value - value).abs() <= estimate.half_width);
        }
    }
    inside
}

/// Of forty runs at least nine in ten intervals of 95 % contain the planted value: of each parameter, with each load.
#[test]
fn intervals_contain_the_planted_values() {
    for (place, mechanism) in loads().iter().enumerate() {
        for (of, inside) in covered(mechanism, &moves(&EXCITING)) {
            assert!(inside >= 36, "load {place}, {of:?}: {inside} of 40");
        }
    }
}

/// Of a run that is partly at the limit of the current, what remains gives the motor's values; of one that always is, none.
#[test]
fn samples_at_the_limit_of_the_current_say_nothing_of_the_motor() {
    let motor = [Identified::TorqueConstant, Identified::StartingCurrent, Identified::CurrentConstant];
    let some = moves(&[&EXCITING[..], &[(1.6, 0.4), (-1.6, 0.4)]].concat());
    let [_, arm, _] = loads();
    let at_limit = identify(&recorded(&arm, &some, 0), Some(limit_a())).unwrap().at_limit;
    assert!(at_limit > 100, "{at_limit}");
    for (of, inside) in covered(&arm, &some).into_iter().filter(|(of, _)| motor.contains(of)) {
        assert!(inside >= 36, "{of:?}: {inside} of 40");
    }
    let run = recorded(&loads()[0], &moves(&[(1.6, 0.25), (-1.6, 0.25)]), 0);
    let all = identify(&run, Some(limit_a())).unwrap();
    assert!(all.at_limit > 50 && motor.iter().all(|of| found(&all.estimates, *of).is_none()), "{all:?}");
    assert!(found(&all.estimates, Identified::LoadInertia).is_some());
}

/// The intervals are narrow, and the angle of the weight is found with it.
#[test]
fn intervals_are_narrow() {
    let [_, arm, _] = loads();
    let run = measured(&recorded(&arm, &moves(&EXCITING), 1), 1);
    let all = identify(&run, Some(limit_a())).unwrap().estimates;
    let narrow = [
        (Identified::LoadInertia, 0.002),
        (Identified::Coulomb, 0.03),
        (Identified::Viscous, 0.02),
        (Identified::Gravity, 0.05),
        (Identified::External, 0.06),
        (Identified::TorqueConstant, 0.4),
        (Identified::StartingCurrent, 0.005),
        (Identified::CurrentConstant, 0.002),
    ];
    for (of, most) in narrow {
        let estimate = found(&all, of).unwrap();
        assert!(estimate.half_width < most, "{estimate:?}");
    }
    let plain = arm.plain(&Extra::none()).unwrap();
    let angle = found(&all, Identified::GravityAngle).unwrap();
    assert!((angle.value - plain.angle_rad).abs() < 1.5 * angle.half_width && angle.half_width < 0.02, "{angle:?}");
}

/// A run without motion, and columns of different lengths, are refused.
#[test]
fn what_says_nothing_is_refused() {
    let rest = Observed { time_s: vec![0.0; 100], ..Observed::default() };
    assert_eq!(identify(&rest, None), Err(IdentifyFault::Uneven));
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
    assert_eq!(identify(&rest, None), Err(IdentifyFault::TooFew));
}

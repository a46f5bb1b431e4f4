//! Identification recovers planted values: simulate, add noise, identify.

mod behind_stage;
mod noisy_speed;
mod zero_and_pace;

use super::parameters;
use mechanism::{Extra, Friction, Linear, LinearKind, Mechanism, MechanismKind, Rotor, RotorKind};
use motion::{Closing, Given, Law, Motion, SegmentSpec};
use quantities::{
    Angle, Force, Length, Mass, Measure, MomentOfInertia, ThermodynamicTemperature, Time, Torque, ViscousFriction,
};
use twin::{
    Column, Estimate, Identification, Identified, IdentifyFault, Misread, Observed, Open, Parameters, Setup, Stated,
    Switches, Twin, identify,
};

pub(crate) const CODE: &str = "CHA-20A-100-H-C1024";

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

pub(crate) fn moves(all: &[(f64, f64)]) -> Motion {
    chained(all, Closing::Position)
}

fn chained(all: &[(f64, f64)], closing: Closing) -> Motion {
    let of = |(angle, time): &(f64, f64)| {
        let given =
            Given { distance: Some(Angle::from_si(*angle)), time: Some(Time::from_si(*time)), ..Given::default() };
        SegmentSpec::Move(Law::ModifiedSine, given)
    };
    Motion::new(&all.iter().map(of).collect::<Vec<_>>(), None, closing).unwrap()
}

/// Moves of several sizes and durations, none at the limit of the current.
pub(crate) const EXCITING: [(f64, f64); 8] =
    [(1.6, 0.9), (-1.6, 1.3), (1.0, 0.6), (-1.0, 0.9), (2.2, 1.1), (-2.2, 0.95), (0.8, 0.7), (-0.8, 0.5)];

/// Returns a recorded run of a load, a row each millisecond.
fn recorded(mechanism: &Mechanism, motion: &Motion, extras: &[Extra], seed: u64) -> Observed {
    recorded_by(&parameters(CODE), 16, mechanism, motion, extras, seed)
}

/// Returns a recorded run of a load on an actuator, a row after a number of periods of the current loop.
pub(crate) fn recorded_by(
    parameters: &Parameters,
    periods: u64,
    mechanism: &Mechanism,
    motion: &Motion,
    extras: &[Extra],
    seed: u64,
) -> Observed {
    let setup = Setup { switches: Switches::default(), seed, ..Setup::of(parameters, mechanism, motion, extras) };
    let mut twin = Twin::new(&setup).unwrap();
    let (mut run, mut speeds) = (Observed::default(), Vec::new());
    while !twin.is_over() {
        twin.advance(periods);
        let now = twin.sample();
        run.time_s.push(now.time_s);
        run.position_rad.push(now.position_rad);
        speeds.push(now.speed_rad_s);
        run.motor_rad_s.push(now.motor_rad_s);
        run.torque_nm.push(now.torque_nm);
        run.current_q_a.push(now.current_q_a);
    }
    run.speed_rad_s = Some(speeds);
    run
}

/// Returns the identification of a load that the project states correctly.
fn said(run: &Observed, mechanism: &Mechanism, motion: &Motion, extras: &[Extra]) -> Identification {
    let parameters = parameters(CODE);
    identify(run, &Stated { parameters: &parameters, mechanism, motion, extras }).unwrap()
}

/// Returns the run as an instrument shows it: noise of 0.3 Nm on the torque, 0.05 A on the current.
pub(crate) fn measured(run: &Observed, seed: u64) -> Observed {
    let (mut run, mut state) = (run.clone(), seed.wrapping_mul(0xd134_2543_de82_ef95) ^ 0x5eed);
    for torque in &mut run.torque_nm {
        *torque += 0.3 * noise(&mut state);
    }
    for current in &mut run.current_q_a {
        *current += 0.05 * noise(&mut state);
    }
    run
}

pub(crate) fn found(all: &[Estimate], of: Identified) -> Option<Estimate> {
    all.iter().find(|each| each.of == of).copied()
}

/// Segments that add nothing.
fn none() -> [Extra; 1] {
    [Extra::none()]
}

/// Returns a flywheel, an arm under gravity and an inclined belt axis, each with friction and a constant torque.
pub(crate) fn loads() -> [Mechanism; 3] {
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

/// Returns, for each planted value, the number of forty runs whose interval contains it; each run has phases and noise
/// of its own.
fn covered(mechanism: &Mechanism, motion: &Motion) -> Vec<(Identified, usize)> {
    let planted = planted(mechanism);
    let mut inside: Vec<_> = planted.iter().map(|(of, _)| (*of, 0)).collect();
    for seed in 0..40 {
        let run = measured(&recorded(mechanism, motion, &none(), seed), seed);
        let all = said(&run, mechanism, motion, &none()).estimates;
        for ((of, value), (_, count)) in planted.iter().zip(&mut inside) {
            let estimate = found(&all, *of).unwrap_or_else(|| panic!("{of:?}"));
            *count += usize::from((estimate.value - value).abs() <= estimate.half_width);
        }
    }
    inside
}

/// At least 34 of forty 95 % intervals contain the planted value, for each parameter and each load.
#[test]
fn intervals_contain_the_planted_values() {
    for (place, mechanism) in loads().iter().enumerate() {
        for (of, inside) in covered(mechanism, &moves(&EXCITING)) {
            assert!(inside >= 34, "load {place}, {of:?}: {inside} of 40");
        }
    }
}

/// A run partly at the current limit yields the motor values from the remaining windows; a run always at the limit
/// yields none.
#[test]
fn windows_at_the_limit_of_the_current_say_nothing_of_the_motor() {
    let motor = [Identified::TorqueConstant, Identified::StartingCurrent, Identified::CurrentConstant];
    let some = moves(&[&EXCITING[..], &[(1.6, 0.4), (-1.6, 0.4)]].concat());
    let [_, arm, _] = loads();
    let at_limit = said(&recorded(&arm, &some, &none(), 0), &arm, &some, &none()).at_limit;
    assert!(at_limit > 5, "{at_limit}");
    for (of, inside) in covered(&arm, &some).into_iter().filter(|(of, _)| motor.contains(of)) {
        assert!(inside >= 34, "{of:?}: {inside} of 40");
    }
    let [wheel, ..] = loads();
    let short = moves(&[(1.6, 0.25), (-1.6, 0.25)].repeat(4));
    let all = said(&recorded(&wheel, &short, &none(), 0), &wheel, &short, &none());
    assert!(all.at_limit > 10 && motor.iter().all(|of| found(&all.estimates, *of).is_none()), "{all:?}");
    assert!(motor.iter().all(|of| all.open.contains(&(*of, Open::AtLimit))), "{all:?}");
    assert!(found(&all.estimates, Identified::LoadInertia).is_some());
}

/// The intervals are narrow, and the angle of the weight is found with it.
#[test]
fn intervals_are_narrow() {
    let [_, arm, _] = loads();
    let motion = moves(&EXCITING);
    let run = measured(&recorded(&arm, &motion, &none(), 1), 1);
    let all = said(&run, &arm, &motion, &none()).estimates;
    let narrow = [
        (Identified::LoadInertia, 0.006),
        (Identified::Coulomb, 0.1),
        (Identified::Viscous, 0.06),
        (Identified::Gravity, 0.15),
        // Contains the zero that the torque may have.
        (Identified::External, 0.3),
        (Identified::TorqueConstant, 1.5),
        (Identified::StartingCurrent, 0.02),
        (Identified::CurrentConstant, 0.01),
    ];
    for (of, most) in narrow {
        let estimate = found(&all, of).unwrap();
        assert!(estimate.half_width < most, "{estimate:?}");
    }
    let plain = arm.plain(&Extra::none()).unwrap();
    let angle = found(&all, Identified::GravityAngle).unwrap();
    assert!((angle.value - plain.angle_rad).abs() < 1.5 * angle.half_width && angle.half_width < 0.04, "{angle:?}");
}

/// The twin's own run without noise, with payloads and process torques that differ from move to move, gives the planted values of the
/// first move; without what the moves add every value of the load is off.
#[test]
fn payloads_that_differ_from_move_to_move_are_taken_into_account() {
    let [_, arm, belt] = loads();
    let motion = moves(&EXCITING);
    let extra = |mass: f64, inertia: f64, torque: f64| Extra {
        mass: Mass::from_si(mass),
        inertia: MomentOfInertia::from_si(inertia),
        torque: Torque::from_si(torque),
        ..Extra::none()
    };
    let of_arm = [extra(2.0, 0.0, 0.0), extra(0.0, 0.1, 3.0), extra(1.0, 0.0, -2.0), extra(0.0, 0.0, 0.0)].repeat(2);
    let of_belt = [extra(60.0, 0.0, 4.0), extra(0.0, 0.0, 0.0)].repeat(4);
    let MechanismKind::Rotor(rotor) = arm.kind else { panic!("an arm") };
    let kind = MechanismKind::Rotor(Rotor { payload_radius: Length::from_si(0.5), ..rotor });
    let arm = Mechanism { kind, ..arm };
    for (mechanism, extras) in [(&arm, &of_arm), (&belt, &of_belt)] {
        let run = recorded(mechanism, &motion, extras, 5);
        let all = said(&run, mechanism, &motion, extras);
        assert!(all.doubts.is_empty() && all.shift_s == Some(0.0), "{all:?}");
        let plain = mechanism.plain(&extras[0]).unwrap();
        let flange = 0.02 * parameters(CODE).actuator.inertia_out.known().unwrap().value.si();
        let planted = [
            (Identified::LoadInertia, plain.inertia_kgm2 + flange),
            (Identified::Coulomb, plain.coulomb_nm),
            (Identified::Viscous, plain.viscous_nms),
            (Identified::Gravity, plain.weight_nm),
            (Identified::External, plain.constant_nm),
            (Identified::TorqueConstant, parameters(CODE).actuator.torque_constant_out.known().unwrap().value.si()),
        ];
        for (of, value) in planted {
            let estimate = found(&all.estimates, of).unwrap();
            assert!((estimate.value - value).abs() <= estimate.half_width, "{value} {estimate:?}");
            // The load of the belt does not tell the torque constant from a zero of the current, nor the external torque from
            // one of the torque.
            let share = match of {
                Identified::TorqueConstant => 0.1,
                Identified::External => 0.12,
                _ => 0.02,
            };
            assert!(estimate.half_width < share * value.abs() + 0.02, "{estimate:?}");
        }
        // The same run from the middle of a cycle, its clock beginning at another instant.
        let from = 2345;
        let cut = |column: &[f64]| column[from..].iter().chain(&column[..from]).copied().collect::<Vec<f64>>();
        let late = Observed {
            time_s: run.time_s.iter().map(|time| time + 77.7).collect(),
            position_rad: cut(&run.position_rad),
            speed_rad_s: None,
            motor_rad_s: cut(&run.motor_rad_s),
            torque_nm: cut(&run.torque_nm),
            current_q_a: cut(&run.current_q_a),
        };
        let late = said(&late, mechanism, &motion, extras);
        let inertia = found(&late.estimates, Identified::LoadInertia).unwrap();
        assert!((inertia.value - planted[0].1).abs() < 2e-3 * planted[0].1, "{late:?}");
        // A run of another motion has no payloads that can be assigned.
        let other = moves(&[(1.0, 0.7), (1.2, 0.9), (-2.2, 1.4)]);
        let parameters = parameters(CODE);
        let stated = Stated { parameters: &parameters, mechanism, motion: &other, extras };
        assert_eq!(identify(&run, &stated), Err(IdentifyFault::OtherMotion));
    }
}

/// For equal moves with alternating payloads, a run whose clock is not that of the cycle does not reveal the payload of
/// each move.
#[test]
fn payloads_of_moves_alike_are_not_guessed() {
    let [wheel, ..] = loads();
    let motion = moves(&[(1.6, 0.9), (-1.6, 0.9), (1.6, 0.9), (-1.6, 0.9)]);
    let laden = Extra { inertia: MomentOfInertia::from_si(0.3), ..Extra::none() };
    let extras = [laden, laden, Extra::none(), Extra::none()];
    let mut run = recorded(&wheel, &motion, &extras, 1);
    let inertia = found(&said(&run, &wheel, &motion, &extras).estimates, Identified::LoadInertia).unwrap();
    assert!((inertia.value - 1.2224).abs() < inertia.half_width, "{inertia:?}");
    run.time_s.iter_mut().for_each(|time| *time += 50.0);
    let parameters = parameters(CODE);
    let stated = Stated { parameters: &parameters, mechanism: &wheel, motion: &motion, extras: &extras };
    assert_eq!(identify(&run, &stated), Err(IdentifyFault::AmbiguousMotion));
}

/// Measured values of a first segment with a payload, put into the model, run as the stated load does: also in segments with another.
#[test]
fn measured_values_of_the_first_segment_keep_what_the_others_add() {
    let [_, arm, _] = loads();
    let MechanismKind::Rotor(rotor) = arm.kind else { panic!("an arm") };
    let kind = MechanismKind::Rotor(Rotor { payload_radius: Length::from_si(0.5), ..rotor });
    let arm = Mechanism { kind, ..arm };
    let motion = moves(&[(1.6, 0.9), (-1.6, 1.3)]);
    let laden = Extra { mass: Mass::from_si(2.0), ..Extra::none() };
    for extras in [[laden, Extra::none()], [Extra::none(), laden]] {
        let plain = arm.plain(&extras[0]).unwrap();
        let mut measured = parameters(CODE);
        let flange = 0.02 * measured.actuator.inertia_out.known().unwrap().value.si();
        let load = &mut measured.load;
        for (place, value) in [
            (&mut load.inertia, plain.inertia_kgm2 + flange),
            (&mut load.coulomb, plain.coulomb_nm),
            (&mut load.gravity, plain.weight_nm),
            (&mut load.gravity_angle, plain.angle_rad),
            (&mut load.external, plain.constant_nm),
        ] {
            let source = provenance::Source::Model { name: "twin" };
            *place = Some(provenance::Sourced { value, source, grade: provenance::Grade::Assumed, errata: &[] });
        }
        let own = parameters(CODE);
        let end = |parameters: &twin::Parameters| {
            let mut twin = Twin::new(&Setup::of(parameters, &arm, &motion, &extras)).unwrap();
            twin.advance(16_000);
            let now = twin.sample();
            [now.position_rad, now.torque_nm, now.current_q_a]
        };
        for (a, b) in end(&own).iter().zip(end(&measured)) {
            assert!((a - b).abs() < 1e-6 * a.abs().max(1.0), "{a} {b}");
        }
    }
}

/// A run without motion, columns of different lengths and times that do not rise are refused.
#[test]
fn what_says_nothing_is_refused() {
    let [wheel, ..] = loads();
    let motion = moves(&EXCITING);
    let parameters = parameters(CODE);
    let stated = Stated { parameters: &parameters, mechanism: &wheel, motion: &motion, extras: &none() };
    let rest = Observed { time_s: vec![0.0; 100], ..Observed::default() };
    assert_eq!(identify(&rest, &stated), Err(IdentifyFault::Uneven));
    let still = || vec![0.0; 100];
    let rest = Observed {
        time_s: (0..100).map(|k| f64::from(k) * 1e-3).collect(),
        position_rad: still(),
        speed_rad_s: None,
        motor_rad_s: still(),
        torque_nm: still(),
        current_q_a: still(),
    };
    assert_eq!(identify(&rest, &stated), Err(IdentifyFault::TooFew));
    let mut run = recorded(&wheel, &motion, &none(), 0);
    run.time_s[70] = run.time_s[69];
    assert_eq!(identify(&run, &stated), Err(IdentifyFault::TimeNotRising(70)));
}

/// A change of a run, and the doubt that it is to raise.
type Case<'a> = (&'a str, &'a dyn Fn(&mut Observed), Column, Misread);

/// Every wrong convention of a signal is named.
#[test]
fn signals_of_another_convention_are_named() {
    let [wheel, arm, _] = loads();
    let motion = moves(&EXCITING);
    let named_of = |periods: u64, mechanism: &Mechanism, change: &dyn Fn(&mut Observed)| {
        let mut run = recorded_by(&parameters(CODE), periods, mechanism, &motion, &none(), 2);
        change(&mut run);
        let found = said(&run, mechanism, &motion, &none()).doubts;
        found.iter().map(|doubt| (doubt.column, doubt.misread)).collect::<Vec<_>>()
    };
    let named = |mechanism: &Mechanism, change: &dyn Fn(&mut Observed)| named_of(16, mechanism, change);
    let times = |column: &mut Vec<f64>, factor: f64| column.iter_mut().for_each(|value| *value *= factor);
    let sized = |column: &mut Vec<f64>| column.iter_mut().for_each(|value| *value = value.abs());
    let degrees = 180.0 / std::f64::consts::PI;
    let root = std::f64::consts::SQRT_2;
    let speed = move |run: &mut Observed, factor: f64| times(run.speed_rad_s.as_mut().unwrap(), factor);
    let cases: [Case<'_>; 30] = [
        ("torque", &|run| times(&mut run.torque_nm, -1.0), Column::Torque, Misread::Reversed),
        ("motor speed", &|run| times(&mut run.motor_rad_s, 100.0), Column::MotorSpeed, Misread::MotorShaft),
        ("motor, gear's sign", &|run| times(&mut run.motor_rad_s, -100.0), Column::MotorSpeed, Misread::MotorShaft),
        ("motor sign", &|run| times(&mut run.motor_rad_s, -1.0), Column::MotorSpeed, Misread::Reversed),
        ("motor 1/min", &|run| times(&mut run.motor_rad_s, 954.93), Column::MotorSpeed, Misread::MotorShaftPerMinute),
        ("speed 1/min", &|run| speed(run, 9.5493), Column::Speed, Misread::PerMinute),
        ("speed deg/s", &|run| speed(run, degrees), Column::Speed, Misread::Degrees),
        ("speed sign", &|run| speed(run, -1.0), Column::Speed, Misread::Reversed),
        ("time ms", &|run| times(&mut run.time_s, 1e3), Column::Speed, Misread::Milliseconds),
        ("time min", &|run| times(&mut run.time_s, 1.0 / 60.0), Column::Speed, Misread::Minutes),
        ("torque's size", &|run| sized(&mut run.torque_nm), Column::Torque, Misread::Magnitude),
        ("current's size", &|run| sized(&mut run.current_q_a), Column::Current, Misread::Magnitude),
        ("position deg", &|run| times(&mut run.position_rad, degrees), Column::Position, Misread::Degrees),
        ("current rms", &|run| times(&mut run.current_q_a, 1.0 / root), Column::Current, Misread::Rms),
        ("current twice", &|run| times(&mut run.current_q_a, root), Column::Current, Misread::PeakTwice),
        (
            "power invariant",
            &|run| times(&mut run.current_q_a, 1.5_f64.sqrt()),
            Column::Current,
            Misread::PowerInvariant,
        ),
        ("current sign", &|run| times(&mut run.current_q_a, -1.0), Column::Current, Misread::Reversed),
        ("torque of the motor", &|run| times(&mut run.torque_nm, 0.01), Column::Torque, Misread::MotorShaft),
        ("torque of a tenth", &|run| times(&mut run.torque_nm, 0.1), Column::Torque, Misread::KilogramForceMetres),
        ("torque in mN m", &|run| times(&mut run.torque_nm, 1e3), Column::Torque, Misread::NewtonMillimetres),
        ("torque in N cm", &|run| times(&mut run.torque_nm, 1e2), Column::Torque, Misread::NewtonCentimetres),
        ("torque in kN m", &|run| times(&mut run.torque_nm, 1e-3), Column::Torque, Misread::KilonewtonMetres),
        ("torque in lbf ft", &|run| times(&mut run.torque_nm, 0.737_562), Column::Torque, Misread::PoundForceFeet),
        ("torque in lbf in", &|run| times(&mut run.torque_nm, 8.850_75), Column::Torque, Misread::PoundForceInches),
        ("torque in ozf in", &|run| times(&mut run.torque_nm, 141.612), Column::Torque, Misread::OunceForceInches),
        ("half the torque", &|run| times(&mut run.torque_nm, 0.5), Column::Torque, Misread::Other),
        ("current in mA", &|run| times(&mut run.current_q_a, 1e3), Column::Current, Misread::Milliamperes),
        ("position's sign", &|run| times(&mut run.position_rad, -1.0), Column::Position, Misread::Reversed),
        (
            "signs of position and speed",
            &|run| {
                times(&mut run.position_rad, -1.0);
                speed(run, -1.0);
            },
            Column::Position,
            Misread::Reversed,
        ),
        (
            "all angles in degrees",
            &|run| {
                times(&mut run.position_rad, degrees);
                speed(run, degrees);
                times(&mut run.motor_rad_s, degrees);
            },
            Column::Position,
            Misread::Degrees,
        ),
    ];
    for mechanism in [&wheel, &arm] {
        for (name, change, column, misread) in &cases {
            // Near one, a factor of the current is like a zero; the rotor separates both if a period of the control has
            // several rows.
            let periods = if *misread == Misread::PowerInvariant { 2 } else { 16 };
            let all = named_of(periods, mechanism, change);
            assert!(all.contains(&(*column, *misread)), "{name}: {all:?}");
            // One wrong signal is named alone, but for what differs from it as well.
            let most = if matches!(misread, Misread::Milliseconds | Misread::Minutes) || name.starts_with("signs") {
                2
            } else {
                1
            };
            assert!(all.len() <= most, "{name}: {all:?}");
        }
        assert_eq!(named(mechanism, &|_| {}), []);
    }
    // Half a turn beside, and an axis that counts the other way.
    let beside: [&dyn Fn(&mut Observed); 2] =
        [&|run| run.position_rad.iter_mut().for_each(|position| *position += std::f64::consts::PI), &|run| {
            times(&mut run.position_rad, -1.0);
            speed(run, -1.0);
            for column in [&mut run.motor_rad_s, &mut run.torque_nm, &mut run.current_q_a] {
                times(column, -1.0);
            }
        }];
    for change in beside {
        assert_eq!(named(&arm, change), [(Column::Position, Misread::GravityOpposite)]);
    }
}

/// A wrong scale is named with payloads that differ from move to move too, and payloads that the run lacks are named.
#[test]
fn a_wrong_scale_is_named_with_payloads_too() {
    let motion = moves(&EXCITING);
    let times = |column: &mut Vec<f64>, factor: f64| column.iter_mut().for_each(|value| *value *= factor);
    for mechanism in loads() {
        let extras: Vec<Extra> = (0..EXCITING.len())
            .map(|place| match place % 3 {
                0 => Extra { torque: Torque::from_si(2.0), ..Extra::none() },
                1 => Extra { inertia: MomentOfInertia::from_si(0.3), ..Extra::none() },
                _ => Extra::none(),
            })
            .collect();
        let run = measured(&recorded(&mechanism, &motion, &extras, 5), 5);
        let named = |run: &Observed| {
            let all = said(run, &mechanism, &motion, &extras).doubts;
            all.iter().map(|doubt| (doubt.column, doubt.misread)).collect::<Vec<_>>()
        };
        assert_eq!(named(&run), []);
        // What is stated an eighth too large, and a torque a tenth too large, is no doubt, but measured.
        let larger = |extra: &Extra| Extra {
            torque: Torque::from_si(1.125 * extra.torque.si()),
            inertia: MomentOfInertia::from_si(1.125 * extra.inertia.si()),
            ..*extra
        };
        let larger: Vec<Extra> = extras.iter().map(larger).collect();
        let mut scaled = run.clone();
        times(&mut scaled.torque_nm, 1.1);
        for (run, extras, share) in [(&run, &extras, 1.0), (&run, &larger, 1.0 / 1.125), (&scaled, &extras, 1.1)] {
            let all = said(run, &mechanism, &motion, extras);
            let [value, half] = all.payload.unwrap();
            assert!(all.doubts.is_empty() && (value - share).abs() < half && half < 0.08, "{share}: {value} {half}");
        }
        for (factor, misread) in [
            (0.01, Misread::MotorShaft),
            (0.1, Misread::KilogramForceMetres),
            (1e3, Misread::NewtonMillimetres),
            (0.737_562, Misread::PoundForceFeet),
        ] {
            let mut other = run.clone();
            times(&mut other.torque_nm, factor);
            assert_eq!(named(&other), [(Column::Torque, misread)], "{factor}");
        }
        for (factor, misread) in [(1e3, Misread::Milliamperes), (1.5_f64.sqrt(), Misread::PowerInvariant)] {
            let mut other = run.clone();
            times(&mut other.current_q_a, factor);
            assert_eq!(named(&other), [(Column::Current, misread)], "{factor}");
        }
        let mut other = run.clone();
        times(&mut other.position_rad, -1.0);
        assert_eq!(named(&other), [(Column::Position, Misread::Reversed)]);
        let without = measured(&recorded(&mechanism, &motion, &none(), 6), 6);
        assert_eq!(named(&without), [(Column::Torque, Misread::PayloadMissing)]);
    }
}

/// A run in one direction leaves open what it cannot separate, and gives what it can.
#[test]
fn one_direction_leaves_friction_and_constant_torques_open() {
    let [wheel, arm, _] = loads();
    let motion = chained(&[(1.6, 0.9), (2.0, 1.3), (1.0, 0.6), (2.2, 1.1), (0.8, 0.7)], Closing::SingleMove);
    for mechanism in [&wheel, &arm] {
        let run = measured(&recorded(mechanism, &motion, &none(), 4), 4);
        let all = said(&run, mechanism, &motion, &none());
        assert!(!all.both_ways && all.doubts.is_empty(), "{all:?}");
        for of in [Identified::Coulomb, Identified::External] {
            assert!(all.open.contains(&(of, Open::OneDirection)), "{all:?}");
        }
        let inertia = found(&all.estimates, Identified::LoadInertia).unwrap();
        assert!((inertia.value - 0.9224).abs() < inertia.half_width && inertia.half_width < 0.01, "{inertia:?}");
    }
}

/// Steps of the position that hide the acceleration are refused with the largest that would do.
#[test]
fn a_position_in_coarse_steps_is_refused() {
    let [wheel, ..] = loads();
    let motion = moves(&[(0.3, 2.0), (-0.3, 2.0)]);
    let run = recorded(&wheel, &motion, &none(), 0);
    let parameters = parameters(CODE);
    let stated = Stated { parameters: &parameters, mechanism: &wheel, motion: &motion, extras: &none() };
    let stepped = |step: f64| {
        let position_rad = run.position_rad.iter().map(|position| (position / step).round() * step).collect();
        identify(&Observed { position_rad, speed_rad_s: None, ..run.clone() }, &stated)
    };
    assert!(stepped(1e-4).is_ok());
    match stepped(0.02) {
        Err(IdentifyFault::TooCoarse { step_rad, most_rad }) => {
            assert!((step_rad - 0.02).abs() < 1e-12 && most_rad > 1e-4 && most_rad < 0.02, "{step_rad} {most_rad}");
        }
        other => panic!("{other:?}"),
    }
}

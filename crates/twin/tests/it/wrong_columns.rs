//! Columns that are not what their heading states, in runs of another simulator: each is named, or what rests on it stays open.

use super::coverage::{off, planted, tables_of, transmission};
use super::foreign::{EACH_MS, Instrument, Plant};
use super::identify::{CODE, EXCITING, measured, moves, recorded_by};
use super::parameters;
use mechanism::{Extra, Friction, Mechanism, MechanismKind, Rotor, RotorKind};
use numeric::Random;
use quantities::{Angle, Length, Mass, Measure, MomentOfInertia, Torque, ViscousFriction};
use std::f64::consts::SQRT_2;
use twin::{Column, Identification, Identified, IdentifyFault, Misread, Observed, Stated, identify};

/// Kinds of loads.
const KINDS: [&str; 6] = ["flywheel", "light", "arm", "belt", "lossy belt", "lossy screw"];

/// Draws a load of a kind.
fn drawn(kind: &str, tables: &Plant, random: &mut Random) -> Plant {
    let plant = Plant::drawn(if kind == "light" { "flywheel" } else { kind }, tables, random);
    if kind != "light" {
        return plant;
    }
    Plant { load_kgm2: 0.1 * plant.load_kgm2, coulomb_nm: 0.3 * plant.coulomb_nm, ..plant }
}

/// Returns the load as a project states it: the weight is right, the rest is off by up to a third.
fn stated_load(kind: &str, plant: &Plant, random: &mut Random) -> Mechanism {
    let mut about = |value: f64| value * (0.75 + 0.55 * random.uniform());
    if kind.starts_with("lossy") {
        return transmission(plant, plant.losses[1]);
    }
    let is_arm = kind == "arm";
    let inertia = about(plant.load_kgm2 + plant.flange_kgm2);
    let rotor = Rotor {
        kind: if is_arm { RotorKind::Arm } else { RotorKind::Load },
        mass: Mass::from_si(if is_arm { plant.weight_nm / mechanism::gravity_m_s2() } else { 0.0 }),
        radius: Length::from_si(1.0),
        angle: Angle::from_si(plant.angle_rad),
        tilt: Angle::from_si(std::f64::consts::FRAC_PI_2),
        ..Rotor::balanced(MomentOfInertia::from_si(inertia))
    };
    let friction = Friction {
        coulomb: Torque::from_si(about(plant.coulomb_nm)),
        viscous: ViscousFriction::from_si(about(plant.viscous_nms)),
        external: Torque::from_si(plant.external_nm),
    };
    let direct = Mechanism::direct(MomentOfInertia::from_si(inertia), Torque::from_si(0.0));
    Mechanism { kind: MechanismKind::Rotor(rotor), friction, ..direct }
}

fn times(column: &mut [f64], factor: f64) {
    column.iter_mut().for_each(|value| *value *= factor);
}

fn sizes(column: &mut [f64]) {
    column.iter_mut().for_each(|value| *value = value.abs());
}

fn later(column: &mut Vec<f64>, rows: usize) {
    let count = column.len();
    column.splice(..0, vec![column[0]; rows]);
    column.truncate(count);
}

fn speeds(run: &mut Observed) -> &mut Vec<f64> {
    run.speed_rad_s.as_mut().unwrap()
}

/// A wrong column, and the doubts that name it.
struct Wrong {
    name: &'static str,
    change: fn(&mut Observed),
    named: &'static [(Column, Misread)],
}

/// Columns that are no signal of the axis, or have lost their sign.
const NO_SIGNALS: &[Wrong] = &[
    Wrong { name: "none", change: |_| {}, named: &[] },
    Wrong { name: "|T|", change: |run| sizes(&mut run.torque_nm), named: &[(Column::Torque, Misread::Magnitude)] },
    Wrong { name: "|I|", change: |run| sizes(&mut run.current_q_a), named: &[(Column::Current, Misread::Magnitude)] },
    Wrong {
        name: "|T|, |I|",
        change: |run| {
            sizes(&mut run.torque_nm);
            sizes(&mut run.current_q_a);
        },
        named: &[(Column::Torque, Misread::Magnitude), (Column::Current, Misread::Magnitude)],
    },
    Wrong { name: "|speed|", change: |run| sizes(speeds(run)), named: &[(Column::Speed, Misread::Magnitude)] },
    Wrong {
        name: "|motor|",
        change: |run| sizes(&mut run.motor_rad_s),
        named: &[(Column::MotorSpeed, Misread::Magnitude)],
    },
    Wrong {
        name: "|position|",
        change: |run| run.position_rad.iter_mut().for_each(|q| *q = (*q - 0.4).abs()),
        named: &[(Column::Position, Misread::Magnitude)],
    },
    Wrong {
        name: "T alike I",
        change: |run| run.torque_nm = run.current_q_a.clone(),
        named: &[(Column::Torque, Misread::Doubled), (Column::Current, Misread::Doubled)],
    },
    Wrong {
        name: "speed alike q",
        change: |run| run.speed_rad_s = Some(run.position_rad.clone()),
        named: &[(Column::Speed, Misread::Doubled), (Column::Position, Misread::Doubled)],
    },
    Wrong {
        name: "motor alike q",
        change: |run| run.motor_rad_s = run.position_rad.clone(),
        named: &[(Column::MotorSpeed, Misread::Doubled), (Column::Position, Misread::Doubled)],
    },
    Wrong { name: "T dead", change: |run| run.torque_nm.fill(0.7), named: &[(Column::Torque, Misread::Frozen)] },
    Wrong { name: "I dead", change: |run| run.current_q_a.fill(0.0), named: &[(Column::Current, Misread::Frozen)] },
    Wrong {
        name: "motor dead",
        change: |run| run.motor_rad_s.fill(0.0),
        named: &[(Column::MotorSpeed, Misread::Frozen)],
    },
    Wrong { name: "speed dead", change: |run| speeds(run).fill(0.0), named: &[(Column::Speed, Misread::Frozen)] },
    Wrong {
        name: "T frozen",
        change: |run| {
            let (from, to) = (run.time_s.len() / 3, run.time_s.len() * 2 / 3);
            let value = run.torque_nm[from];
            run.torque_nm[from..to].fill(value);
        },
        named: &[(Column::Torque, Misread::Frozen)],
    },
    Wrong {
        name: "I frozen",
        change: |run| {
            let (from, to) = (run.time_s.len() / 3, run.time_s.len() * 2 / 3);
            let value = run.current_q_a[from];
            run.current_q_a[from..to].fill(value);
        },
        named: &[(Column::Current, Misread::Frozen)],
    },
    Wrong {
        name: "T wild",
        change: |run| {
            let count = run.time_s.len();
            (1..4).for_each(|k| run.torque_nm[k * count / 4 + 37] = 5e3);
        },
        named: &[(Column::Torque, Misread::Outlier)],
    },
    Wrong {
        name: "I wild",
        change: |run| {
            let count = run.time_s.len();
            (1..4).for_each(|k| run.current_q_a[k * count / 4 + 37] = -300.0);
        },
        named: &[(Column::Current, Misread::Outlier)],
    },
    Wrong {
        name: "q wild",
        change: |run| {
            let count = run.time_s.len();
            (1..4).for_each(|k| run.position_rad[k * count / 4 + 37] = 60.0);
        },
        named: &[(Column::Position, Misread::Outlier)],
    },
    Wrong {
        name: "motor wild",
        change: |run| {
            let count = run.time_s.len();
            (1..4).for_each(|k| run.motor_rad_s[k * count / 4 + 37] = 900.0);
        },
        named: &[(Column::MotorSpeed, Misread::Outlier)],
    },
    Wrong {
        name: "q jumps",
        change: |run| {
            let count = run.time_s.len();
            run.position_rad[count / 2..].iter_mut().for_each(|q| *q += 0.5);
        },
        named: &[(Column::Position, Misread::Jump)],
    },
];

/// Signals with another scale or sign.
const SCALES: &[Wrong] = &[
    Wrong {
        name: "T/i",
        change: |run| times(&mut run.torque_nm, 0.01),
        named: &[(Column::Torque, Misread::MotorShaft)],
    },
    Wrong {
        name: "I/√2",
        change: |run| times(&mut run.current_q_a, 1.0 / SQRT_2),
        named: &[(Column::Current, Misread::Rms)],
    },
    Wrong {
        name: "I √2",
        change: |run| times(&mut run.current_q_a, SQRT_2),
        named: &[(Column::Current, Misread::PeakTwice), (Column::Current, Misread::PowerInvariant)],
    },
    Wrong {
        name: "−T", change: |run| times(&mut run.torque_nm, -1.0), named: &[(Column::Torque, Misread::Reversed)]
    },
    Wrong {
        name: "−I",
        change: |run| times(&mut run.current_q_a, -1.0),
        named: &[(Column::Current, Misread::Reversed)],
    },
    Wrong {
        name: "all signs",
        change: |run| {
            times(&mut run.position_rad, -1.0);
            times(speeds(run), -1.0);
            times(&mut run.motor_rad_s, -1.0);
            times(&mut run.torque_nm, -1.0);
            times(&mut run.current_q_a, -1.0);
        },
        named: &[(Column::Position, Misread::GravityOpposite), (Column::Position, Misread::Reversed)],
    },
];

/// Signals that are late, which the estimates take into account.
const LATE: &[Wrong] = &[
    Wrong { name: "none", change: |_| {}, named: &[] },
    Wrong { name: "q 12 ms late", change: |run| later(&mut run.position_rad, 12), named: &[] },
    Wrong { name: "q 25 ms late", change: |run| later(&mut run.position_rad, 25), named: &[] },
    Wrong { name: "q 40 ms late", change: |run| later(&mut run.position_rad, 40), named: &[] },
    Wrong { name: "T 8 ms late", change: |run| later(&mut run.torque_nm, 8), named: &[] },
    Wrong {
        name: "T 8, I 5 ms late",
        change: |run| {
            later(&mut run.torque_nm, 8);
            later(&mut run.current_q_a, 5);
        },
        named: &[],
    },
];

/// Outcome of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    Named,
    NamedOtherwise,
    Refused,
    /// Without a doubt; a value that is known is off by more than its interval.
    WrongValues,
    Right,
}

/// Returns the outcome of a run, and of the values that are known those inside their intervals.
fn outcome(
    kind: &str,
    plant: &Plant,
    wrong: &Wrong,
    found: &Result<Identification, IdentifyFault>,
) -> (Outcome, Vec<(Identified, bool)>) {
    let Ok(found) = found else { return (Outcome::Refused, Vec::new()) };
    if !found.doubts.is_empty() {
        let is_named = |doubt: &twin::Doubt| wrong.named.contains(&(doubt.column, doubt.misread));
        let named = if found.doubts.iter().all(is_named) { Outcome::Named } else { Outcome::NamedOtherwise };
        return (named, Vec::new());
    }
    let lossy = kind.starts_with("lossy");
    let inertia = plant.load_kgm2 + plant.flange_kgm2;
    let planted = planted(kind, plant).into_iter().filter(|(of, _)| *of != Identified::LoadInertia);
    let mut inside = Vec::new();
    let mut is_wrong = false;
    for (of, value) in planted.chain([(Identified::LoadInertia, inertia)]) {
        if lossy && matches!(of, Identified::External | Identified::Gravity) {
            continue;
        }
        let Some(estimate) = found.estimates.iter().find(|each| each.of == of && each.is_known()) else { continue };
        let off = off(estimate, value).abs();
        inside.push((of, off <= estimate.half_width));
        is_wrong |= off > 2.0 * estimate.half_width + 0.02 * value.abs();
    }
    (if is_wrong { Outcome::WrongValues } else { Outcome::Right }, inside)
}

/// Number of runs by outcome, of the values that are known those inside, and what was neither named nor right.
struct Counts {
    outcomes: [usize; 5],
    inside: Vec<(Identified, usize, usize)>,
    others: Vec<String>,
}

/// Identifies runs of all kinds of loads with each wrong column.
#[allow(clippy::print_stdout, reason = "the table of outcomes")]
fn campaign(all: &[Wrong], seeds: std::ops::Range<u64>) -> Vec<Counts> {
    let parameters = parameters(CODE);
    let tables = tables_of(CODE);
    let motion = moves(&[(1.0, 1.0), (-1.0, 1.0)]);
    let none = || Counts { outcomes: [0; 5], inside: Vec::new(), others: Vec::new() };
    let mut counts: Vec<Counts> = all.iter().map(|_| none()).collect();
    for (kind, seed) in KINDS.iter().flat_map(|kind| seeds.clone().map(move |seed| (kind, seed))) {
        let mut random = Random::new(seed);
        let plant = drawn(kind, &tables, &mut random);
        let course = plant.run(&mut random, EACH_MS);
        let mechanism = stated_load(kind, &plant, &mut random);
        let instrument = match seed % 3 {
            0 => Instrument { torque_nm: 1e-3, current_a: 1e-4, ..Instrument::NOISE },
            1 => Instrument::NOISE,
            _ => Instrument { steps_rad: Some([1.9e-4, 1.5e-5]), ..Instrument::NOISE },
        };
        let seen = instrument.seen(&course, &mut random);
        let extras = [Extra::none()];
        let stated = Stated { parameters: &parameters, mechanism: &mechanism, motion: &motion, extras: &extras };
        for (wrong, counts) in all.iter().zip(&mut counts) {
            let mut run = seen.clone();
            (wrong.change)(&mut run);
            let found = identify(&run, &stated);
            let (outcome, inside) = outcome(kind, &plant, wrong, &found);
            counts.outcomes[outcome as usize] += 1;
            if outcome != Outcome::Named && outcome != Outcome::Right {
                counts.others.push(format!(
                    "{kind} {seed} {}: {outcome:?} {}",
                    wrong.name,
                    shown(kind, &plant, &found)
                ));
            }
            for (of, is_inside) in inside {
                match counts.inside.iter_mut().find(|row| row.0 == of) {
                    Some(row) => (row.1, row.2) = (row.1 + 1, row.2 + usize::from(is_inside)),
                    None => counts.inside.push((of, 1, usize::from(is_inside))),
                }
            }
        }
    }
    for (wrong, Counts { outcomes, inside, .. }) in all.iter().zip(&counts) {
        let inside: Vec<String> =
            inside.iter().map(|(of, all, inside)| format!("{} {inside}/{all}", of.id())).collect();
        println!("| {} | {outcomes:?} | {} |", wrong.name, inside.join(", "));
    }
    counts
}

/// Returns the doubts of a result, or the values that are known with the planted ones.
fn shown(kind: &str, plant: &Plant, found: &Result<Identification, IdentifyFault>) -> String {
    let Ok(found) = found else { return format!("{found:?}") };
    if !found.doubts.is_empty() {
        let shown =
            found.doubts.iter().map(|doubt| format!("{}:{} {:.3}", doubt.column.id(), doubt.misread.id(), doubt.value));
        return shown.collect::<Vec<String>>().join(", ");
    }
    let lags = format!("{:?} {:?} {}", found.torque_delay, found.current_delay, found.motor_lag_s);
    let shown = planted(kind, plant).into_iter().filter_map(|(of, value)| {
        let estimate = found.estimates.iter().find(|estimate| estimate.of == of && estimate.is_known())?;
        Some(format!("{} {:.4} ± {:.4} ({value:.4})", of.id(), estimate.value, estimate.half_width))
    });
    std::iter::once(lags).chain(shown).collect::<Vec<String>>().join(", ")
}

/// First seed, and runs of each kind of load.
const SEEDS: std::ops::Range<u64> = 30_000..30_003;

/// Columns that are no signal are named in all runs, and right runs give no wrong values.
#[test]
fn columns_that_are_no_signal_are_named() {
    let wrong: Vec<String> = campaign(NO_SIGNALS, SEEDS).into_iter().flat_map(|counts| counts.others).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Another scale or sign is named, at times as another one of nearly its factor; without a doubt, no value that is known is wrong.
#[test]
fn scales_and_signs_are_named_or_what_rests_on_them_stays_open() {
    for counts in campaign(SCALES, SEEDS) {
        let [.., wrong, _] = counts.outcomes;
        let [named, otherwise, refused, ..] = counts.outcomes;
        assert!(wrong == 0 && refused == 0 && otherwise <= 1 + named / 5, "{:#?}", counts.others);
    }
}

/// Late signals raise no doubt, and the intervals hold the planted values.
#[test]
fn late_positions_are_delays() {
    for counts in campaign(LATE, SEEDS) {
        let others: Vec<&String> = counts.others.iter().filter(|other| !other.starts_with("lossy")).collect();
        assert!(others.is_empty(), "{others:#?}");
        for (of, all, inside) in counts.inside {
            assert!(inside * 5 + 5 >= all * 4, "{of:?}: {inside} of {all}");
        }
    }
}

/// Runs of drives with the constants of the tables as they are stated raise no doubt, for the windings whose k_Tout includes the
/// no-load friction too.
#[test]
fn drives_with_the_stated_torque_constant_raise_no_doubt() {
    let motion = moves(&[(1.0, 1.0), (-1.0, 1.0)]);
    let extras = [Extra::none()];
    let mut wrong = Vec::new();
    for code in [
        "CHA-14A-50-E-M128S",
        "CHA-14A-30-E-RES",
        "CHA-17A-80-E-D2048",
        "CHA-17A-100-E-M128S",
        "CHA-14A-80-H-RES",
        CODE,
    ] {
        let (parameters, tables) = (parameters(code), tables_of(code));
        let most: f64 = parameters.actuator.current_max.known().unwrap().value.si();
        let size = tables.output_nm_a * most / 100.0;
        for (kind, seed) in KINDS.iter().flat_map(|kind| SEEDS.map(move |seed| (kind, seed))) {
            let mut random = Random::new(seed);
            let plant = drawn(kind, &tables, &mut random);
            let plant = Plant {
                load_kgm2: size * plant.load_kgm2,
                coulomb_nm: size * plant.coulomb_nm,
                viscous_nms: size * plant.viscous_nms,
                external_nm: size * plant.external_nm,
                weight_nm: size * plant.weight_nm,
                motor_nm_a: tables.motor_nm_a,
                output_nm_a: tables.output_nm_a,
                ..plant
            };
            let course = plant.run(&mut random, EACH_MS);
            let mechanism = stated_load(kind, &plant, &mut random);
            let noise = 0.003 * most;
            let instrument =
                Instrument { torque_nm: 2.0 * noise * tables.output_nm_a, current_a: noise, ..Instrument::NOISE };
            let run = instrument.seen(&course, &mut random);
            let found = identify(
                &run,
                &Stated { parameters: &parameters, mechanism: &mechanism, motion: &motion, extras: &extras },
            );
            if found.as_ref().is_ok_and(|found| found.at_limit > 10 || found.doubts.is_empty()) {
                continue;
            }
            wrong.push(format!("{code} {kind} {seed}: {}", shown(kind, &plant, &found)));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Runs of the twin with moves up to the limit of the current raise no doubt: a current at its limit has no other scale.
#[test]
fn runs_at_the_limit_of_the_current_raise_no_doubt() {
    let mut limited = 0;
    for code in ["CHA-14A-80-H-RES", "CHA-14A-100-H-RES", "CHA-17A-100-E-M128S"] {
        let parameters = parameters(code);
        let tables = tables_of(code);
        let most: f64 = parameters.actuator.current_max.known().unwrap().value.si();
        let torque = 0.35 * most * tables.output_nm_a;
        let inertia = tables.rotor_kgm2 + tables.flange_kgm2;
        for (stretch, seed) in [0.6, 0.8, 1.0, 1.3].into_iter().flat_map(|stretch| [(stretch, 0), (stretch, 1)]) {
            let plan: Vec<(f64, f64)> = EXCITING.iter().map(|(way, time)| (*way, time * stretch)).collect();
            let motion = moves(&plan);
            let plant = Plant {
                load_kgm2: inertia,
                coulomb_nm: 0.1 * torque,
                viscous_nms: 0.03 * torque,
                weight_nm: 0.25 * torque,
                ..tables
            };
            let mechanism = stated_load("arm", &plant, &mut Random::new(seed));
            let extras = [Extra::none()];
            let run = measured(&recorded_by(&parameters, 16, &mechanism, &motion, &extras, seed), seed);
            let stated = Stated { parameters: &parameters, mechanism: &mechanism, motion: &motion, extras: &extras };
            let found = identify(&run, &stated).unwrap();
            assert!(found.doubts.is_empty(), "{code} {stretch} {seed}: {:?}", found.doubts);
            limited += found.at_limit;
        }
    }
    assert!(limited > 100, "{limited}");
}

//! Runs as a bench records them: payloads that the project does not state, rest before and behind the motion, a torque sensor with a zero.

use super::coverage::{identified, off, planted, tables};
use super::foreign::{EACH_MS, EIGHT_PER_MS, Instrument, Plant};
use super::identify::{CODE, EXCITING, found, loads, measured, moves, recorded_by};
use super::parameters;
use mechanism::{Extra, Mechanism};
use motion::Motion;
use numeric::Random;
use quantities::{Measure, MomentOfInertia, Torque};
use twin::{Column, Estimate, Identification, Identified, Misread, Observed, Stated, identify};

fn torque(nm: f64) -> Extra {
    Extra { torque: Torque::from_si(nm), ..Extra::none() }
}

fn inertia(kgm2: f64) -> Extra {
    Extra { inertia: MomentOfInertia::from_si(kgm2), ..Extra::none() }
}

fn run_of(mechanism: &Mechanism, motion: &Motion, extras: &[Extra], seed: u64) -> Observed {
    measured(&recorded_by(&parameters(CODE), 16, mechanism, motion, extras, seed), seed)
}

fn said(run: &Observed, mechanism: &Mechanism, motion: &Motion, extras: &[Extra]) -> Identification {
    let parameters = parameters(CODE);
    identify(run, &Stated { parameters: &parameters, mechanism, motion, extras }).unwrap()
}

/// Payloads and process torques that single moves carry and the project does not state, or states of other moves, are a doubt;
/// stated rightly they are none, nor are losses of a tenth of the torque that the project does not state.
#[test]
fn payloads_that_the_project_does_not_state_are_a_doubt() {
    let motion = moves(&EXCITING);
    let mut random = Random::new(31);
    for (place, mechanism) in loads().iter().enumerate() {
        for case in 0..9_u64 {
            let drawn = |random: &mut Random| {
                let (laden, of_torque) = (random.uniform() > 0.4, 1.5 + 3.0 * random.uniform());
                match (laden, case % 3) {
                    (false, _) => Extra::none(),
                    (true, 0) => torque(of_torque),
                    (true, 1) => inertia(0.1 * of_torque),
                    (true, _) => Extra { torque: Torque::from_si(of_torque), ..inertia(0.1 * of_torque) },
                }
            };
            let mut extras: Vec<Extra> = EXCITING.iter().map(|_| drawn(&mut random)).collect();
            // At least one move laden and one not.
            (extras[2], extras[5]) = (Extra { torque: Torque::from_si(2.0), ..inertia(0.3) }, Extra::none());
            let run = run_of(mechanism, &motion, &extras, case);
            let unstated = said(&run, mechanism, &motion, &[Extra::none()]).doubts;
            let named: Vec<Misread> = unstated.iter().map(|doubt| doubt.misread).collect();
            assert_eq!(named, [Misread::PayloadUnstated], "load {place}, case {case}");
            assert!(unstated[0].value > 0.5 && unstated[0].value < 20.0, "{unstated:?}");
            assert_eq!(said(&run, mechanism, &motion, &extras).doubts, [], "load {place}, case {case}");
            let mut others = extras.clone();
            others.rotate_left(3);
            let named: Vec<Misread> =
                said(&run, mechanism, &motion, &others).doubts.iter().map(|doubt| doubt.misread).collect();
            assert!(
                matches!(named[..], [Misread::PayloadUnstated | Misread::PayloadMissing]),
                "load {place}, case {case}: {named:?}"
            );
        }
        let mut run = run_of(mechanism, &motion, &[Extra::none()], 40);
        for (torque, speed) in run.torque_nm.iter_mut().zip(&run.motor_rad_s) {
            *torque += 0.1 * torque.abs() * (speed / 0.02).tanh();
        }
        let of_losses = said(&run, mechanism, &motion, &[Extra::none()]).doubts;
        // The current is without these losses, so that its scale may be doubted.
        assert!(of_losses.iter().all(|doubt| doubt.column == Column::Current), "load {place}: {of_losses:?}");
    }
}

/// Returns a run that rests at its ends for a time longer, at the torque and current of its first and last sample.
fn resting(run: &Observed, before_s: f64, behind_s: f64) -> Observed {
    let step = run.time_s[1] - run.time_s[0];
    let [before, behind] = [before_s, behind_s].map(|time| (time / step).round() as usize);
    let longer = |column: &[f64]| {
        let ends = (column[0], *column.last().unwrap());
        let first = std::iter::repeat_n(ends.0, before).chain(column.iter().copied());
        first.chain(std::iter::repeat_n(ends.1, behind)).collect::<Vec<f64>>()
    };
    Observed {
        time_s: (0..run.time_s.len() + before + behind).map(|k| k as f64 * step).collect(),
        position_rad: longer(&run.position_rad),
        speed_rad_s: None,
        motor_rad_s: longer(&run.motor_rad_s),
        torque_nm: longer(&run.torque_nm),
        current_q_a: longer(&run.current_q_a),
    }
}

/// A recorder that starts before the first move, or ends after the last, changes no estimate, also where moves carry payloads.
#[test]
fn rest_before_and_behind_the_motion_changes_nothing() {
    let motion = moves(&EXCITING);
    let extras: Vec<Extra> =
        (0..EXCITING.len()).map(|place| [torque(2.0), inertia(0.3), Extra::none()][place % 3]).collect();
    for (place, mechanism) in loads().iter().enumerate() {
        let run = run_of(mechanism, &motion, &extras, 3);
        let alone = said(&run, mechanism, &motion, &extras);
        assert!(alone.doubts.is_empty(), "{alone:?}");
        for (before, behind) in [(0.6, 0.0), (1.0, 0.3), (5.0, 0.0), (0.0, 3.0), (40.0, 25.0)] {
            let name = format!("load {place}, {before} s before, {behind} s behind");
            let all = said(&resting(&run, before, behind), mechanism, &motion, &extras);
            assert_eq!(all.doubts, [], "{name}");
            assert!((all.shift_s.unwrap() + before).abs() < 0.02, "{name}: {:?}", all.shift_s);
            assert_eq!(all.estimates.len(), alone.estimates.len(), "{name}");
            for estimate in &alone.estimates {
                let other = found(&all.estimates, estimate.of).unwrap();
                let near = 0.2 * estimate.half_width + 1e-9;
                assert!((other.value - estimate.value).abs() < near, "{name}: {estimate:?}, {other:?}");
            }
        }
    }
}

/// A zero of the torque on loads whose torque does not change its sign, of either size: the intervals of the external torque and of
/// the friction hold the planted values, and an external torque with a large zero is not known.
#[test]
fn a_zero_of_the_torque_is_never_a_known_external_torque() {
    let tables = tables();
    let mut wrong = Vec::new();
    for (rows, runs) in [(EACH_MS, 6), (EIGHT_PER_MS, 2)] {
        for kind in ["flywheel", "belt", "arm"] {
            for seed in 0..runs {
                let mut random = Random::new(6000 + seed);
                let hanging = (18.0 + 15.0 * random.uniform()) * if seed % 2 == 0 { 1.0 } else { -1.0 };
                let plant = Plant { external_nm: hanging, ..Plant::drawn(kind, &tables, &mut random) };
                let course = plant.run(&mut random, rows);
                for zero in [0.0, 1.0, -2.0, 3.0, 5.0, -5.0] {
                    let run = Instrument { zeros: [zero, 0.0], ..Instrument::NOISE }.seen(&course, &mut random);
                    let result = identified(kind, &plant, &run);
                    let name = format!("{kind} {seed}, {hanging} Nm and {zero} Nm, rows of {rows:?}");
                    assert_eq!(result.doubts, [], "{name}");
                    let held = [Identified::External, Identified::LoadInertia, Identified::StartingCurrent];
                    for (of, value) in planted(kind, &plant).into_iter().filter(|(of, _)| held.contains(of)) {
                        let Some(estimate) = found(&result.estimates, of) else { continue };
                        let deviation = off(&estimate, value).abs() / estimate.half_width;
                        // Of 95 % intervals some miss; a zero that is not contained misses by many times.
                        if deviation > 1.5 {
                            wrong.push(format!("{name}: {estimate:?} of {value}"));
                        }
                    }
                    let is_significant = result.zero.is_some_and(|zero| zero.is_significant());
                    let external = found(&result.estimates, Identified::External);
                    let is_known = external.as_ref().is_some_and(Estimate::is_known) && !is_significant;
                    if is_known && zero.abs() > 0.1 * hanging.abs() {
                        wrong.push(format!("{name}: {external:?} is known"));
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

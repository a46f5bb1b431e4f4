//! Zeros and delays of torque and current, planted in runs of another simulator.

use super::coverage::{identified, off, planted, tables};
use super::foreign::{EACH_MS, EIGHT_PER_MS, Instrument, Plant};
use super::identify::found;
use numeric::Random;
use twin::{Identification, Identified};

const KINDS: [&str; 3] = ["flywheel", "arm", "belt"];

/// Returns `true` if enough 95 % intervals contain the planted value: 29 of 36, which one in 700 campaigns misses; 9 of 12.
fn is_enough(inside: usize, all: usize) -> bool {
    (inside + 2) as f64 >= 0.85 * all as f64
}

/// Runs of each kind of load as instruments show them, identified, and passed with the place of the instrument and what is planted.
fn each(
    instruments: &[Instrument],
    rows: (f64, usize),
    runs: u64,
    mut put: impl FnMut(usize, &str, &Plant, &Identification),
) {
    let tables = tables();
    for kind in KINDS {
        for seed in 0..runs {
            let mut random = Random::new(2000 + seed);
            let plant = Plant::drawn(kind, &tables, &mut random);
            let course = plant.run(&mut random, rows);
            for (place, instrument) in instruments.iter().enumerate() {
                let run = instrument.seen(&course, &mut random);
                put(place, kind, &plant, &identified(kind, &plant, &run));
            }
        }
    }
}

/// Number of planted values in their intervals, by parameter.
#[derive(Default)]
struct Inside(Vec<(Identified, usize, usize)>);

impl Inside {
    fn count(&mut self, kind: &str, plant: &Plant, result: &Identification) {
        for (of, value) in planted(kind, plant) {
            let Some(estimate) = found(&result.estimates, of) else { continue };
            let is_inside = usize::from(off(&estimate, value).abs() <= estimate.half_width);
            match self.0.iter_mut().find(|row| row.0 == of) {
                Some(row) => (row.1, row.2) = (row.1 + is_inside, row.2 + 1),
                None => self.0.push((of, is_inside, 1)),
            }
        }
    }

    /// Returns the parameters with too few values inside.
    #[allow(clippy::print_stdout, reason = "figures of the campaign")]
    fn wrong(&self, name: &str) -> Vec<String> {
        let row = |(of, inside, all): &(Identified, usize, usize)| format!("{} {inside}/{all}", of.id());
        println!("{name}: {}", self.0.iter().map(row).collect::<Vec<_>>().join(", "));
        let few = |(_, inside, all): &&(Identified, usize, usize)| !is_enough(*inside, *all);
        self.0.iter().filter(few).map(|row| format!("{name}: {row:?}")).collect()
    }
}

/// Zeros of the current and of the torque are measured, raise no doubt, and the intervals hold the planted values.
#[test]
fn zeros_of_current_and_torque_are_measured() {
    let zeros = [[0.0, 0.02], [0.0, -0.05], [2.0, 0.0], [-0.5, 0.05]];
    let mut all: [(Inside, [usize; 4]); 4] = Default::default();
    let instruments = zeros.map(|zeros| Instrument { zeros, ..Instrument::NOISE });
    each(&instruments, EACH_MS, 12, |place, kind, plant, result| {
        let [torque, current] = zeros[place];
        assert_eq!(result.doubts, [], "zeros of {torque} Nm, {current} A, {kind}");
        let (inside, counts) = &mut all[place];
        inside.count(kind, plant, result);
        let zero = result.zero.unwrap();
        let right = current - std::f64::consts::SQRT_2 * torque / plant.output_nm_a;
        counts[0] += usize::from((zero.current_q_a - right).abs() <= zero.half_width_a);
        counts[1] += usize::from(zero.is_significant());
        counts[2] += usize::from(zero.is_of_torque);
        counts[3] += usize::from(result.torque_delay.is_some() || result.current_delay.is_some());
    });
    let mut wrong = Vec::new();
    for ([torque, current], (inside, counts)) in zeros.into_iter().zip(&all) {
        let name = format!("zeros of {torque} Nm, {current} A {counts:?}");
        wrong.extend(inside.wrong(&name));
        let [held, seen, of_torque, late] = *counts;
        // Twice the largest zero that the rotor alone leaves open is seen, and 2 Nm are ascribed to the torque.
        let is_large = torque.abs() > 1.0;
        let is_seen = seen >= if current.abs() > 0.03 || is_large { 30 } else { 18 };
        let is_ascribed = if is_large { of_torque >= 30 } else { of_torque == 0 };
        if !is_enough(held, 36) || !is_seen || !is_ascribed || late > 2 {
            wrong.push(name);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Delays of torque, of current and of both are measured and removed, raise no doubt, and the intervals hold the planted
/// values.
fn delays_are_removed<const N: usize>(late_s: [[f64; 2]; N], rows: (f64, usize), runs: u64) {
    let mut all: [(Inside, [[usize; 3]; 2]); N] = std::array::from_fn(|_| Default::default());
    let instruments = late_s.map(|late_s| Instrument { late_s, ..Instrument::NOISE });
    each(&instruments, rows, runs, |place, kind, plant, result| {
        let late = late_s[place];
        assert_eq!(result.doubts, [], "delays {late:?} s, {kind}");
        let (inside, counts) = &mut all[place];
        inside.count(kind, plant, result);
        for ((delay, late), counts) in [result.torque_delay, result.current_delay].into_iter().zip(late).zip(counts) {
            let off = (delay.map_or(0.0, |delay| delay.s) - late).abs();
            counts[0] += usize::from(off <= delay.map_or(1e-4, |delay| delay.half_width_s));
            counts[1] += usize::from(off <= 1e-3);
            counts[2] += usize::from(delay.is_some());
        }
    });
    let mut wrong = Vec::new();
    for (late, (inside, counts)) in late_s.into_iter().zip(&all) {
        let name = format!("delays {late:?} s, {counts:?}");
        wrong.extend(inside.wrong(&name));
        let all = KINDS.len() * usize::try_from(runs).unwrap();
        for ([held, near, seen], late) in counts.iter().zip(late) {
            let is_right = if late > 0.0 { *seen == all } else { seen * 12 <= all };
            if !is_enough(*held, all) || near * 36 < 34 * all || !is_right {
                wrong.push(name.clone());
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Delays of 5 to 10 ms in rows each millisecond.
#[test]
fn delays_of_some_rows_are_removed() {
    delays_are_removed([[0.005, 0.005], [0.010, 0.010], [0.008, 0.0], [0.0, 0.006]], EACH_MS, 12);
}

/// Delays of 5 to 10 ms in rows each eighth of a millisecond.
#[test]
fn delays_of_many_rows_are_removed() {
    delays_are_removed([[0.005, 0.005], [0.0, 0.010]], EIGHT_PER_MS, 4);
}

/// A torque that never changes its sign is no absolute value: loads that hang, with the size and the sign of the torque drawn.
#[test]
fn a_torque_of_one_sign_is_no_absolute_value() {
    let tables = tables();
    for kind in KINDS {
        for seed in 0..12 {
            let mut random = Random::new(4000 + seed);
            let hanging = (15.0 + 45.0 * random.uniform()) * if seed % 2 == 0 { 1.0 } else { -1.0 };
            let plant = Plant { external_nm: hanging, ..Plant::drawn(kind, &tables, &mut random) };
            let run = Instrument::NOISE.seen(&plant.run(&mut random, EACH_MS), &mut random);
            let result = identified(kind, &plant, &run);
            assert_eq!(result.doubts, [], "{kind}, {hanging} Nm");
        }
    }
}

/// The caller can end the work at each window.
#[test]
fn the_work_ends_when_the_caller_wants() {
    use super::parameters;
    use std::cell::Cell;
    let tables = tables();
    let mut random = Random::new(7);
    let plant = Plant::drawn("flywheel", &tables, &mut random);
    let late = Instrument { late_s: [0.005, 0.005], ..Instrument::NOISE };
    let run = late.seen(&plant.run(&mut random, EACH_MS), &mut random);
    let (all, motion) = (parameters(super::identify::CODE), super::identify::moves(&[(1.0, 1.0), (-1.0, 1.0)]));
    let mechanism = mechanism::Mechanism::direct(
        quantities::Measure::from_si(plant.load_kgm2),
        quantities::Measure::from_si(plant.coulomb_nm),
    );
    let extras = [mechanism::Extra::none()];
    let stated = twin::Stated { parameters: &all, mechanism: &mechanism, motion: &motion, extras: &extras };
    let calls = Cell::new(0_usize);
    let counted = |most: usize| {
        calls.set(0);
        twin::identify_while(run.clone(), &stated, &|| {
            calls.set(calls.get() + 1);
            calls.get() <= most
        })
    };
    let whole = counted(usize::MAX).unwrap();
    assert_eq!(twin::identify(&run, &stated).unwrap(), whole);
    // The search for delays repeats the windows.
    let all = calls.get();
    assert!(all > 3 * whole.windows, "{all} of {}", whole.windows);
    for most in (0..all).step_by(all / 60) {
        assert_eq!(counted(most), Err(twin::IdentifyFault::Stopped), "{most} of {all}");
        // What notices the end are the windows of one more length at most.
        assert!(calls.get() <= most + 4, "{most}: {}", calls.get());
    }
}

//! Filters of torque and current: runs with short ramps of a simulator of this file and of the other one.

use super::coverage::{identified, off, planted, tables};
use super::foreign::{EACH_MS, EIGHT_PER_MS, Instrument, Plant};
use super::identify::found;
use numeric::Random;
use twin::{Identification, Identified, Observed};

/// Returns a column behind a filter of first order: steps of a tenth of a row, with the values straight in between.
fn filtered(column: &mut [f64], row_s: f64, constant_s: f64) {
    if constant_s == 0.0 {
        return;
    }
    let (h, mut y, mut last) = (0.1 * row_s, column[0], column[0]);
    for value in column.iter_mut() {
        for k in 1..=10 {
            let x = last + (*value - last) * (f64::from(k) - 0.5) / 10.0;
            y += (x - y) * h / (constant_s + 0.5 * h);
        }
        last = *value;
        *value = y;
    }
}

/// Speed of a motion with constant acceleration, in ramps with short beginnings and ends: times and accelerations drawn.
fn ramps(random: &mut Random) -> Vec<[f64; 2]> {
    let mut pieces = vec![[0.1, 0.0]];
    for place in 0..16 {
        let sign = if place % 2 == 0 { 1.0 } else { -1.0 };
        let (ramp, run) = (0.06 + 0.1 * random.uniform(), 0.05 + 0.2 * random.uniform());
        let alpha = sign * (15.0 + 20.0 * random.uniform());
        pieces.extend([[ramp, alpha], [run, 0.0], [ramp, -alpha], [0.08, 0.0]]);
    }
    pieces
}

/// Returns a run of a stiff axis from the equations of load and motor, with ramps that begin over `corner` seconds.
pub(crate) fn stiff(plant: &Plant, random: &mut Random, row_s: f64, corner_s: f64) -> Observed {
    let pieces = ramps(random);
    let end: f64 = pieces.iter().map(|[time, _]| time).sum();
    let h = row_s / 8.0;
    let (mut run, mut q, mut omega, mut alpha) = (Observed::default(), 0.0, 0.0, 0.0_f64);
    let (mut place, mut until) = (0, pieces[0][0]);
    let mut step = 0_u32;
    while f64::from(step) * h < end - row_s {
        let time = f64::from(step) * h;
        if time > until {
            place += 1;
            until += pieces[place][0];
        }
        // A jerk that leads to the wanted acceleration.
        let wanted = pieces[place][1];
        let most = 35.0 * h / corner_s;
        let before = alpha;
        alpha += (wanted - alpha).clamp(-most, most);
        if step.is_multiple_of(8) {
            let sign = (omega / 0.002_f64).tanh();
            let mean = 0.5 * (before + alpha);
            let torque = plant.load_kgm2 * mean
                + plant.coulomb_nm * sign
                + plant.viscous_nms * omega
                + plant.external_nm
                + plant.weight_nm * (q + plant.angle_rad).cos();
            let teeth = (plant.motor_nm_a / plant.output_nm_a - 1.0) * torque.abs();
            let own =
                (plant.motor_nm_a * plant.starting_a + teeth) * sign + plant.motor_nm_a * plant.with_speed_as * omega;
            run.time_s.push(time);
            run.position_rad.push(q);
            run.motor_rad_s.push(omega);
            run.torque_nm.push(torque);
            run.current_q_a
                .push((plant.rotor_kgm2 * mean + torque + own) / plant.motor_nm_a * std::f64::consts::SQRT_2);
        }
        q += h * (omega + 0.5 * h * alpha);
        omega += h * alpha;
        step += 1;
    }
    run
}

const KINDS: [&str; 3] = ["flywheel", "arm", "belt"];

/// Counts of the runs of one instrument.
#[derive(Default)]
struct Count {
    inside: Vec<(Identified, usize, usize, f64)>,
    /// Filters and delays of torque and current, and those whose interval holds the planted value.
    filters: [usize; 2],
    delays: [usize; 2],
    held: [usize; 2],
    doubts: usize,
    all: usize,
}

impl Count {
    fn count(&mut self, kind: &str, plant: &Plant, result: &Identification, constant_s: [f64; 2]) {
        for (of, value) in planted(kind, plant) {
            let Some(estimate) = found(&result.estimates, of) else { continue };
            let is_inside = usize::from(off(&estimate, value).abs() <= estimate.half_width);
            match self.inside.iter_mut().find(|row| row.0 == of) {
                Some(row) => (row.1, row.2, row.3) = (row.1 + is_inside, row.2 + 1, row.3 + estimate.half_width),
                None => self.inside.push((of, is_inside, 1, estimate.half_width)),
            }
        }
        let both = [(result.torque_filter, result.torque_delay), (result.current_filter, result.current_delay)];
        for (place, (filter, delay)) in both.into_iter().enumerate() {
            self.filters[place] += usize::from(filter.is_some());
            self.delays[place] += usize::from(delay.is_some());
            let near = |found: twin::Delay| (found.s - constant_s[place]).abs() <= found.half_width_s;
            self.held[place] += usize::from(filter.or(delay).is_some_and(near));
        }
        self.doubts += result.doubts.len();
        self.all += 1;
    }

    /// Returns the parameters with too few values inside: below 33 of 40, or three quarters of few.
    #[allow(clippy::print_stdout, reason = "the figures of docs/theory/twin.md")]
    fn wrong(&self, name: &str) -> Vec<String> {
        let row = |(of, inside, all, half): &(Identified, usize, usize, f64)| {
            format!("{} {inside}/{all} ±{:.4}", of.id(), half / *all as f64)
        };
        println!(
            "{name}: of {} filters {:?}, delays {:?}, inside {:?}, doubts {}: {}",
            self.all,
            self.filters,
            self.delays,
            self.held,
            self.doubts,
            self.inside.iter().map(row).collect::<Vec<_>>().join(", ")
        );
        let few = |(_, inside, all, _): &&(Identified, usize, usize, f64)| ((inside + 2) as f64) < 0.85 * *all as f64;
        self.inside.iter().filter(few).map(|row| format!("{name}: {row:?}")).collect()
    }
}

/// Identifies runs of each kind of load that a recorder of signals passes on, with noise.
fn campaign(runs: u64, constant_s: [f64; 2], run_of: impl Fn(&Plant, &mut Random) -> Observed) -> Count {
    let (tables, mut count) = (tables(), Count::default());
    for kind in KINDS {
        for seed in 0..runs {
            let mut random = Random::new(8000 + seed);
            let plant = Plant::drawn(kind, &tables, &mut random);
            let mut run = run_of(&plant, &mut random);
            run.torque_nm.iter_mut().for_each(|torque| *torque += 0.3 * random.normal());
            run.current_q_a.iter_mut().for_each(|current| *current += 0.05 * random.normal());
            count.count(kind, &plant, &identified(kind, &plant, &run), constant_s);
        }
    }
    count
}

/// Returns a run behind a filter of torque and current.
fn behind(mut run: Observed, row_s: f64, [of_torque, of_current]: [f64; 2]) -> Observed {
    filtered(&mut run.torque_nm, row_s, of_torque);
    filtered(&mut run.current_q_a, row_s, of_current);
    run
}

/// Filters of runs with short ramps are found and not taken for delays, and the intervals hold the planted values.
#[test]
fn filters_are_found_where_the_ramps_are_short() {
    let mut wrong = Vec::new();
    for (row_s, corner_s, runs) in [(1e-3, 0.004, 12), (1e-3, 0.02, 12), (2.5e-4, 0.004, 12)] {
        for constant_s in [[0.002, 0.0], [0.0, 0.002], [0.005, 0.005], [0.0005, 0.001]] {
            let name = format!("rows {row_s}, corners {corner_s}, filters {constant_s:?}");
            let count = campaign(runs, constant_s, |plant, random| {
                behind(stiff(plant, random, row_s, corner_s), row_s, constant_s)
            });
            wrong.extend(count.wrong(&name));
            for (place, constant) in constant_s.into_iter().enumerate() {
                let (seen, filters) = (count.filters[place] + count.delays[place], count.filters[place]);
                let is_right = match constant {
                    0.0 => seen <= 3,
                    constant => {
                        seen == count.all
                            && count.held[place] * 10 >= 8 * count.all
                            && (constant < 0.0015 || 3 * filters >= count.all)
                    }
                };
                if !is_right || count.doubts > 1 {
                    wrong.push(name.clone());
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Delays of runs with short ramps are no filters.
#[test]
fn delays_are_no_filters_where_the_ramps_are_short() {
    let mut wrong = Vec::new();
    for (row_s, corner_s) in [(1e-3, 0.004), (1e-3, 0.02), (2.5e-4, 0.004)] {
        for late_s in [[0.002, 0.0], [0.0, 0.003], [0.005, 0.005], [0.0, 0.0]] {
            let name = format!("rows {row_s}, corners {corner_s}, delays {late_s:?}");
            let count = campaign(8, late_s, |plant, random| {
                let mut run = stiff(plant, random, row_s, corner_s);
                for (column, late_s) in [&mut run.torque_nm, &mut run.current_q_a].into_iter().zip(late_s) {
                    let rows = (late_s / row_s).round() as usize;
                    column.splice(..0, vec![column[0]; rows]);
                    column.truncate(run.time_s.len());
                }
                run
            });
            wrong.extend(count.wrong(&name));
            if count.filters != [0, 0] || count.doubts > 0 {
                wrong.push(name);
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Smooth runs do not distinguish a filter from a delay: the intervals hold the planted values with both.
#[test]
fn a_filter_that_smooth_runs_do_not_show_is_within_the_intervals() {
    let mut wrong = Vec::new();
    for (rows, runs, row_s) in [(EACH_MS, 12, 1e-3), (EIGHT_PER_MS, 4, 1.25e-4)] {
        for constant_s in [[0.002, 0.0], [0.0, 0.002], [0.005, 0.005], [0.0005, 0.001]] {
            let name = format!("smooth, rows {row_s}, filters {constant_s:?}");
            let exact = Instrument { torque_nm: 0.0, current_a: 0.0, ..Instrument::NOISE };
            let count = campaign(runs, constant_s, |plant, random| {
                behind(exact.seen(&plant.run(random, rows), random), row_s, constant_s)
            });
            wrong.extend(count.wrong(&name));
            if count.doubts > 0 {
                wrong.push(name);
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

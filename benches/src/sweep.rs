//! Many axes with the whole catalogue: rows of one move each with different inertia, friction, time and distance.
//!
//! Baselines: the NumPy script with vectors over the catalogue, which makes no checks of instants, heat and energy; for
//! two threads, their gain over one with independent work in the same run.
#![allow(
    clippy::print_stdout,
    clippy::expect_used,
    clippy::panic,
    reason = "a bench fails loudly and prints what it measured"
)]

use axis::NoFiles;
use benches::{Gates, least_processor_s, numpy, processor_s, sort, timed};
use questions::Progress;
use questions::sweep::{Cells, Judged, Options, Sweep};
use rayon::ThreadPool;
use std::hint::black_box;
use std::process::ExitCode;

const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

const HEADINGS: [&str; 4] =
    ["load.inertia [kg m^2]", "load.friction_torque [N m]", "motion[1].time [s]", "motion[1].distance [deg]"];

/// Lower and upper end of each column; the inertia in equal ratios.
type Ranges = [(f64, f64); 4];

/// Some two thirds of the catalogue fit on average.
const MIXED: Ranges = [(0.05, 5.0), (0.0, 20.0), (0.3, 2.0), (20.0, 180.0)];

/// No actuator is rejected, so that every check of every actuator is computed.
const HARD: Ranges = [(1e-3, 1e-2), (0.0, 0.3), (2.0, 5.0), (10.0, 90.0)];

/// Returns the number of rows of a measurement, from the environment variable if it is set.
fn rows() -> usize {
    std::env::var("ROWS").ok().and_then(|rows| rows.parse().ok()).unwrap_or(2_000)
}

#[allow(clippy::cast_precision_loss, reason = "53 bits")]
fn table(ranges: &Ranges, rows: usize) -> Vec<Cells<'static>> {
    let mut state = 7_u64;
    let mut share = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut columns = vec![Vec::with_capacity(rows); ranges.len()];
    for _ in 0..rows {
        for (place, (column, (low, high))) in columns.iter_mut().zip(ranges).enumerate() {
            let share = share();
            column.push(Some(if place == 0 { low * (high / low).powf(share) } else { low + share * (high - low) }));
        }
    }
    columns.into_iter().map(Cells::Numbers).collect()
}

/// Smallest factor by which the baseline is slower.
const NUMPY: f64 = 5.0;

/// Smallest gain of two threads with rows, as a share of their gain with independent work: 1.8 of 2.
const TOGETHER: f64 = 0.9;

/// Smallest gain of two threads with independent work if both cores are free.
const TWO_FREE: f64 = 1.6;

/// Largest ratio of the processor time of a row with two threads to that with one, in proportion to independent work.
const HINDRANCE: f64 = 1.25;

/// Number of sorted numbers that measures the mutual cost of two threads: about the time of two thousand rows.
const SORTED: usize = 500_000;

/// Two threads compared with one: gain of time, and ratio of the processor times of the same work.
#[derive(Clone, Copy)]
struct Two {
    gain: f64,
    cost: f64,
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Returns the elapsed time and the processor time of the threads of a pool; the latter is NaN if the system does not
/// report it.
fn spent(pool: &ThreadPool, work: &(dyn Fn() + Sync)) -> [f64; 2] {
    let used = || pool.broadcast(|_| processor_s().unwrap_or(f64::NAN)).into_iter().sum::<f64>();
    let before = used();
    let time = timed(|| pool.install(work));
    [time.as_secs_f64(), used() - before]
}

/// Measures rows and independent work in turn, so that a disturbance of the machine affects both.
fn two_to_one(one: &ThreadPool, two: &ThreadPool, judge: &(dyn Fn() + Sync)) -> [Two; 2] {
    let of = |[alone, alone_cpu]: [f64; 2], [both, both_cpu]: [f64; 2]| Two {
        gain: alone / both,
        cost: both_cpu / alone_cpu,
    };
    let twice = || {
        sort(SORTED);
        sort(SORTED);
    };
    let each = || {
        rayon::join(|| sort(SORTED), || sort(SORTED));
    };
    let rounds: Vec<[Two; 2]> =
        (0..9).map(|_| [of(spent(one, judge), spent(two, judge)), of(spent(one, &twice), spent(two, &each))]).collect();
    [0, 1].map(|place| {
        let of =
            |figure: fn(&Two) -> f64| median(rounds.iter().filter_map(|round| round.get(place)).map(figure).collect());
        Two { gain: of(|two| two.gain), cost: of(|two| two.cost) }
    })
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let rows = rows();
    let sweep = Sweep::new(("axis.toml", MOVE), Box::new(NoFiles), &HEADINGS, Options::default());
    let sweep = sweep.unwrap_or_else(|why| panic!("the table is valid: {why:?}"));
    let pool = |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let (one, two) = (pool(1), pool(2));
    let baseline = numpy(&[]);
    if baseline.is_none() {
        println!("no Python with NumPy here: the ratio to it is not measured");
    }
    for (name, ranges) in [("mixed rows", MIXED), ("rows that reject no actuator", HARD)] {
        let cells = table(&ranges, rows);
        let judge = || sweep.judge(&cells, &Progress::endless()).expect("nothing cancels it");
        let fit = |answer: &questions::sweep::Answer| match answer {
            Ok(Judged::Best(best)) => f64::from(best.fit),
            other => panic!("{other:?}"),
        };
        let fitting: f64 = one.install(judge).iter().map(fit).sum();
        let judge = || drop(black_box(judge()));
        // On the thread of the pool, whose time is counted.
        let row_s = one.install(|| least_processor_s(7, 1, judge)) / rows as f64;
        println!("{name}: {:.1} of the catalogue fit on average", fitting / rows as f64);
        println!("  {:.1} µs of processor time a row, {:.0} rows a second", 1e6 * row_s, 1.0 / row_s);
        if let Some((time, _)) = baseline {
            gates.times_faster_s(
                &format!("{name}, against NumPy over the catalogue"),
                row_s,
                time.as_secs_f64(),
                NUMPY,
            );
        }
        let [rows, independent] = two_to_one(&one, &two, &judge);
        println!("  two threads: {:.2} × as quick as one, with independent work {:.2} ×", rows.gain, independent.gain);
        if rows.cost.is_finite() {
            gates.share_at_most(
                &format!("{name}, processor time of two threads over that of one"),
                rows.cost / independent.cost,
                ("that with independent work", HINDRANCE),
            );
        }
        if independent.gain >= TWO_FREE {
            gates.share_at_most(
                &format!("{name}, what two threads gain with independent work"),
                independent.gain / rows.gain,
                ("the gain with rows", 1.0 / TOGETHER),
            );
        } else {
            println!("  no two cores are free: the gain of two threads is not judged");
        }
    }
    gates.close()
}

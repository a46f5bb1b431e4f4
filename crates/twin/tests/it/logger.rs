//! Loggers: time stamps that scatter, missing rows, and values held over rows because their source is slower.

use super::coverage::{identified, off, planted, tables};
use super::foreign::{EACH_MS, EIGHT_PER_MS, Instrument, Plant};
use super::identify::found;
use numeric::Random;
use twin::{Column, Identification, Identified, Misread, Observed};

const RUNS: u64 = 40;

/// Smallest number of forty 95 % intervals that must contain the planted value; one in 330 campaigns has fewer.
const INSIDE_LEAST: usize = 34;

/// Recording of rows.
#[derive(Clone, Copy, Debug)]
struct Logger {
    /// Largest scatter of the stamps, relative to the interval.
    scatter: f64,
    /// Share of missing rows.
    lost: f64,
    /// The rows are sampled at their stamps.
    is_true: bool,
    /// Rows over which position, motor speed, torque and current are held.
    held: [usize; 4],
    /// Rows by which the updates of one signal are later than those of the signal before.
    apart: usize,
    /// Steps of the position and of the motor \[rad\].
    steps_rad: Option<[f64; 2]>,
}

const CLEAN: Logger = Logger { scatter: 0.0, lost: 0.0, is_true: false, held: [1; 4], apart: 0, steps_rad: None };

impl Logger {
    /// Returns a run as the logger writes it.
    fn written(&self, run: &Observed, random: &mut Random) -> Observed {
        let count = run.time_s.len();
        let step = run.time_s[1] - run.time_s[0];
        let mut columns = [&run.position_rad, &run.motor_rad_s, &run.torque_nm, &run.current_q_a].map(Clone::clone);
        for (place, (column, rows)) in columns.iter_mut().zip(self.held).enumerate() {
            let shift = place * self.apart % rows;
            let exact = column.clone();
            column
                .iter_mut()
                .enumerate()
                .for_each(|(k, value)| *value = exact[((k + shift) / rows * rows).saturating_sub(shift)]);
        }
        let mut written = Observed::default();
        for k in 0..count {
            let stamp = (k as f64 + self.scatter * (2.0 * random.uniform() - 1.0)) * step;
            let is_lost = (20..count - 20).contains(&k) && random.uniform() < self.lost;
            if is_lost {
                continue;
            }
            let at = |column: &[f64]| {
                let x = if self.is_true { (stamp / step).clamp(0.0, (count - 2) as f64) } else { k as f64 };
                let (a, b) = (x as usize, (x as usize + 1).min(count - 1));
                column[a] + (column[b] - column[a]) * (x - a as f64)
            };
            written.time_s.push(7.0 + stamp);
            written.position_rad.push(at(&columns[0]));
            written.motor_rad_s.push(at(&columns[1]));
            written.torque_nm.push(at(&columns[2]));
            written.current_q_a.push(at(&columns[3]));
        }
        written
    }
}

/// Runs of each kind of load as a logger writes them, identified: checks their intervals, and passes each result.
#[allow(clippy::print_stdout, reason = "the figures of docs/theory/twin.md")]
fn campaign(name: &str, logger: Logger, rows: (f64, usize), runs: u64, check: impl Fn(&Identification)) {
    let tables = tables();
    let mut wrong = Vec::new();
    for kind in ["flywheel", "arm", "belt"] {
        let mut all: Vec<(Identified, usize, f64)> = Vec::new();
        for seed in 0..runs {
            let mut random = Random::new(6000 + seed);
            let plant = Plant::drawn(kind, &tables, &mut random);
            let course = plant.run(&mut random, rows);
            let instrument = Instrument { steps_rad: logger.steps_rad, ..Instrument::NOISE };
            let run = logger.written(&instrument.seen(&course, &mut random), &mut random);
            let result = identified(kind, &plant, &run);
            check(&result);
            assert_eq!(result.doubts, [], "{name} {kind} {seed}");
            for (of, value) in planted(kind, &plant) {
                let estimate = found(&result.estimates, of)
                    .unwrap_or_else(|| panic!("{name} {kind} {seed}: {of:?} is open: {:?}", result.open));
                let is_inside = usize::from(off(&estimate, value).abs() <= estimate.half_width);
                match all.iter_mut().find(|row| row.0 == of) {
                    Some(row) => (row.1, row.2) = (row.1 + is_inside, row.2 + estimate.half_width),
                    None => all.push((of, is_inside, estimate.half_width)),
                }
            }
        }
        let least = if runs == RUNS { INSIDE_LEAST } else { (runs * 3 / 4) as usize };
        let row =
            |(of, inside, half): &(Identified, usize, f64)| format!("{} {inside} ±{:.4}", of.id(), half / runs as f64);
        println!("{name} {kind}: {}", all.iter().map(row).collect::<Vec<_>>().join(", "));
        let few = all.iter().filter(|(_, inside, _)| *inside < least);
        wrong.extend(few.map(|(of, inside, _)| format!("{name} {kind} {}: {inside} of {runs}", of.id())));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn has_no_notes(result: &Identification) {
    assert!(result.scatter.is_none() && result.held.is_empty(), "{:?} {:?}", result.scatter, result.held);
}

/// Stamps that scatter about evenly spaced rows, with missing rows too, are replaced: the intervals of forty runs hold the planted values.
#[test]
fn scattered_stamps_are_replaced_by_even_instants() {
    for lost in [0.0, 0.01] {
        let logger = Logger { scatter: 0.3, lost, ..CLEAN };
        campaign(&format!("scatter, lost {lost}"), logger, EACH_MS, RUNS, |result| {
            let scatter = result.scatter.unwrap();
            assert!((scatter.scatter_s / (0.3e-3 / 3.0_f64.sqrt()) - 1.0).abs() < 0.1, "{scatter:?}");
            assert!((scatter.interval_s / 1e-3 - 1.0).abs() < 1e-3, "{scatter:?}");
            assert!(result.held.is_empty(), "{:?}", result.held);
        });
    }
}

/// Steps of a tenth of a degree, above the motion within the scatter, hide no scatter.
#[test]
fn scattered_stamps_of_coarse_positions_are_replaced() {
    let logger = Logger { scatter: 0.3, lost: 0.005, steps_rad: Some([1.745e-3, 1.5e-5]), ..CLEAN };
    campaign("scatter, coarse", logger, EACH_MS, 12, |result| assert!(result.scatter.is_some(), "{result:?}"));
}

/// Rows sampled at instants that scatter keep their stamps, without a remark.
#[test]
fn instants_that_scatter_are_kept() {
    let logger = Logger { scatter: 0.3, is_true: true, ..CLEAN };
    campaign("true", logger, EACH_MS, 12, has_no_notes);
}

/// Missing rows of even stamps are neither a scatter nor an end of a stroke.
#[test]
fn missing_rows_are_no_scatter() {
    let logger = Logger { lost: 0.02, ..CLEAN };
    campaign("lost", logger, EACH_MS, 12, has_no_notes);
}

/// Values held over rows, of all signals or of one, are found, and the intervals hold the planted values.
#[test]
fn held_values_count_once_for_each_update() {
    let all = |name: &str, logger: Logger, rows, runs| {
        campaign(name, logger, rows, runs, |result| {
            let columns = [Column::Position, Column::MotorSpeed, Column::Torque, Column::Current];
            let meant: Vec<Column> =
                columns.into_iter().zip(logger.held).filter(|(_, rows)| *rows > 1).map(|(column, _)| column).collect();
            assert_eq!(result.held.iter().map(|held| held.column).collect::<Vec<_>>(), meant, "{name}");
        });
    };
    all("held 4", Logger { held: [4; 4], ..CLEAN }, EACH_MS, RUNS);
    all("held 4 apart", Logger { held: [4; 4], apart: 1, ..CLEAN }, EACH_MS, 12);
    all("position held 4", Logger { held: [4, 1, 1, 1], ..CLEAN }, EACH_MS, 12);
    all("torque held 8", Logger { held: [1, 1, 8, 1], ..CLEAN }, EACH_MS, 12);
    all("current held 8", Logger { held: [1, 1, 1, 8], ..CLEAN }, EACH_MS, 12);
    all("motor held 8", Logger { held: [1, 8, 1, 1], ..CLEAN }, EACH_MS, 12);
    all("mixed", Logger { held: [2, 4, 8, 8], ..CLEAN }, EACH_MS, 12);
    all("held 16 of 0.125 ms", Logger { held: [16; 4], ..CLEAN }, EIGHT_PER_MS, 4);
}

/// Held values and scattered stamps of one run are both found.
#[test]
fn held_values_of_scattered_rows() {
    let logger = Logger { scatter: 0.3, held: [4; 4], ..CLEAN };
    campaign("held 4, scatter", logger, EACH_MS, RUNS, |result| {
        assert!(result.scatter.is_some() && result.held.len() == 4, "{:?} {:?}", result.scatter, result.held);
    });
}

/// Rows sampled at instants that scatter, with stamps of another scatter, are a doubt with the scatter of the stamps.
#[test]
fn stamps_of_unknown_instants_are_a_doubt() {
    let tables = tables();
    for seed in 0..12 {
        let mut random = Random::new(6100 + seed);
        let plant = Plant::drawn("flywheel", &tables, &mut random);
        let course = plant.run(&mut random, EACH_MS);
        let logger = Logger { scatter: 0.2, is_true: true, ..CLEAN };
        let mut run = logger.written(&Instrument::NOISE.seen(&course, &mut random), &mut random);
        run.time_s.iter_mut().for_each(|time| *time += 0.2e-3 * (2.0 * random.uniform() - 1.0));
        let doubts = identified("flywheel", &plant, &run).doubts;
        let named: Vec<(Column, Misread)> = doubts.iter().map(|doubt| (doubt.column, doubt.misread)).collect();
        assert_eq!(named, [(Column::Time, Misread::TimeStamps)], "{seed}");
        assert!((doubts[0].value / 0.163e-3 - 1.0).abs() < 0.1, "{doubts:?}");
    }
}

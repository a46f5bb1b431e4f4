//! Columns that are no signal of the axis: constant over a motion, values of another column, single wild values, a position that
//! jumps, absolute values of a position or a speed.

use super::Observed;
use super::doubts::{Column, Doubt, Misread};
use motion::{Outliers, SignalKind, jumps};
use std::f64::consts::TAU;

/// Returns the doubts that columns raise before any equation, each with the value of its sentence.
pub(super) fn doubts(run: &Observed) -> Vec<Doubt> {
    let columns = Columns::of(run);
    let mut doubts: Vec<Doubt> =
        columns.all().filter_map(|(column, values)| outlier(column, values, &run.time_s)).collect();
    let is_wild = |column: Column| doubts.iter().any(|doubt| doubt.column == column);
    // A wild value of a witness is no motion.
    let is_seen = !is_wild(Column::Position) && !is_wild(Column::MotorSpeed);
    let frozen = columns.all().filter_map(|(column, values)| columns.frozen(column, values).filter(|_| is_seen));
    let frozen: Vec<Doubt> = frozen.filter(|doubt| !is_wild(doubt.column)).collect();
    let jump = jump(run).filter(|_| !is_wild(Column::Position));
    let is_frozen = |column: Column| frozen.iter().any(|doubt| doubt.column == column);
    let rest: Vec<(Column, &[f64])> = columns.all().filter(|(column, _)| !is_frozen(*column)).collect();
    doubts.extend(frozen);
    doubts.extend(jump);
    doubts.extend(doubled(&rest));
    if doubts.is_empty() {
        doubts.extend(columns.sizes());
    }
    doubts
}

/// Smallest distance moved each way over a constant value, relative to the range of the motion. A choice.
const MOVED: f64 = 0.1;

/// Largest part of the variance of a column that another does not explain if it has the same values. A choice: four digits of
/// both leave 10⁻⁷, the friction of the motor leaves 10⁻³ of a current behind a torque.
const DOUBLED: f64 = 1e-5;

/// Part of the samples with the largest speed that shows a sign, relative to that speed, and the least share of these on each
/// side. A choice.
const FAST: f64 = 0.2;
const SIDES: f64 = 0.05;

/// Smallest correlation coefficient of the sizes of two speeds of one motion. A choice.
const ALIKE: f64 = 0.95;

/// Columns of a run with the motion that they show.
struct Columns<'a> {
    run: &'a Observed,
    /// Position by the motor alone, in an unknown unit.
    motor: Vec<f64>,
}

impl<'a> Columns<'a> {
    fn of(run: &'a Observed) -> Self {
        let mut sum = 0.0;
        let steps = run.time_s.windows(2).zip(run.motor_rad_s.windows(2)).map(|(time, speed)| match (time, speed) {
            ([ta, tb], [a, b]) => 0.5 * (a + b) * (tb - ta),
            _ => 0.0,
        });
        let rest = steps.map(|step| {
            sum += step;
            sum
        });
        Self { run, motor: std::iter::once(0.0).chain(rest).collect() }
    }

    fn all(&self) -> impl Iterator<Item = (Column, &'a [f64])> + use<'a> {
        let run = self.run;
        let speed = run.speed_rad_s.as_deref().map(|values| (Column::Speed, values));
        [(Column::Position, run.position_rad.as_slice())].into_iter().chain(speed).chain([
            (Column::MotorSpeed, run.motor_rad_s.as_slice()),
            (Column::Torque, run.torque_nm.as_slice()),
            (Column::Current, run.current_q_a.as_slice()),
        ])
    }

    /// Returns the doubt of a column whose value stays over motion in both directions, or of a position over motion of the motor.
    fn frozen(&self, column: Column, values: &[f64]) -> Option<Doubt> {
        let witness = if column == Column::Position { &self.motor } else { &self.run.position_rad };
        let [low, high] = ends(witness);
        let least = MOVED * (high - low);
        let mut first = 0;
        for stretch in values.chunk_by(|one, other| one == other) {
            let range = first..first + stretch.len();
            first = range.end;
            let moved = witness.get(range.clone()).unwrap_or_default();
            let [forth, back] = moved.windows(2).fold([0.0_f64; 2], |[forth, back], pair| match pair {
                [a, b] => [forth + (b - a).max(0.0), back + (a - b).max(0.0)],
                _ => [forth, back],
            });
            let [low, high] = ends(moved);
            let least_way = if column == Column::Position { high - low } else { forth.min(back).min(high - low) };
            if stretch.len() > 2 && least > 0.0 && least_way > least {
                let time = |place: usize| self.run.time_s.get(place).copied().unwrap_or_default();
                return Some(Doubt::new(column, Misread::Frozen, time(range.end - 1) - time(range.start)));
            }
        }
        None
    }

    /// Returns the doubt of a position or speed without its sign: its size agrees with another speed that has both signs.
    fn sizes(&self) -> Option<Doubt> {
        let run = self.run;
        let of_position = rates(&run.time_s, &run.position_rad);
        let motor = &run.motor_rad_s;
        let unsigned = |own: &[f64]| {
            let [low, high] = ends(own);
            high > 0.0 && low > -SIDES * high
        };
        for (column, own) in [(Column::Speed, run.speed_rad_s.as_ref()), (Column::MotorSpeed, Some(motor))] {
            if own.is_some_and(|own| unsigned(own) && is_size_of(own, &of_position)) {
                return Some(Doubt::new(column, Misread::Magnitude, 1.0));
            }
        }
        // Beside a motor with both signs the position falls where it should rise, from a zero on.
        let [low, high] = ends(&run.position_rad);
        let is_from_zero = low >= 0.0 && low < SIDES * high;
        (is_from_zero && !unsigned(motor) && is_size_of(&of_position, motor)).then_some(Doubt::new(
            Column::Position,
            Misread::Magnitude,
            1.0,
        ))
    }
}

/// Returns least and largest value.
fn ends(values: &[f64]) -> [f64; 2] {
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(*value), high.max(*value)])
}

/// Returns the rates of a column over five rows to both sides.
fn rates(time: &[f64], values: &[f64]) -> Vec<f64> {
    let last = time.len().saturating_sub(1);
    let rate = |k: usize| {
        let (a, b) = (k.saturating_sub(5), (k + 5).min(last));
        Some((values.get(b)? - values.get(a)?) / (time.get(b)? - time.get(a)?))
    };
    (0..time.len()).map(|k| rate(k).filter(|rate| rate.is_finite()).unwrap_or(0.0)).collect()
}

/// Returns `true` if the sizes of both agree and their signs do so in one part of the fast samples only.
fn is_size_of(own: &[f64], signed: &[f64]) -> bool {
    let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    // The second largest part excludes what is wild about the ends of the rates.
    let fastest = most(signed);
    let pairs: Vec<[f64; 2]> = own.iter().copied().zip(signed.iter().copied()).map(<[f64; 2]>::from).collect();
    let fast = || pairs.iter().filter(|[_, signed]| signed.abs() > FAST * fastest);
    let [all, against] = fast().fold([0.0_f64; 2], |[all, against], [own, signed]| {
        [all + 1.0, against + f64::from(u8::from(own * signed < 0.0))]
    });
    let sizes: Vec<[f64; 2]> = pairs.iter().map(|[own, signed]| [own.abs(), signed.abs()]).collect();
    let share = against / all;
    share > SIDES && share < 1.0 - SIDES && correlation(&sizes) > ALIKE
}

/// Returns the correlation coefficient of pairs.
fn correlation(pairs: &[[f64; 2]]) -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
    let count = pairs.len() as f64;
    let [x, y] = pairs.iter().fold([0.0; 2], |[x, y], [a, b]| [x + a / count, y + b / count]);
    let [xx, xy, yy] = pairs.iter().fold([0.0; 3], |[xx, xy, yy], [a, b]| {
        [xx + (a - x) * (a - x), xy + (a - x) * (b - y), yy + (b - y) * (b - y)]
    });
    if xx > 0.0 && yy > 0.0 { xy / (xx * yy).sqrt() } else { 0.0 }
}

/// Returns the doubt of single values far beside those around them, with the instant of the first.
fn outlier(column: Column, values: &[f64], time: &[f64]) -> Option<Doubt> {
    let is_force = matches!(column, Column::Torque | Column::Current);
    let found = Outliers::of(values, if is_force { SignalKind::Force } else { SignalKind::Motion })?;
    Some(Doubt::new(column, Misread::Outlier, time.get(found.first).copied().unwrap_or_default()))
}

/// Returns the doubt of a position that jumps by no whole number of revolutions from row to row, with the instant.
fn jump(run: &Observed) -> Option<Doubt> {
    let is_of_turns = |way: f64| {
        let turns = (way / TAU).round();
        turns != 0.0 && (way - turns * TAU).abs() < 0.1 * TAU
    };
    let (row, _) = jumps(&run.time_s, &run.position_rad).into_iter().find(|(_, way)| !is_of_turns(*way))?;
    Some(Doubt::new(Column::Position, Misread::Jump, run.time_s.get(row).copied().unwrap_or_default()))
}

/// Returns the doubts of both columns of a pair in which one is a multiple of the other, with that factor.
///
/// # Valid
/// The speed of the load may be computed from that of the motor, which is no signal of its own but none that is wrong.
fn doubled(columns: &[(Column, &[f64])]) -> Vec<Doubt> {
    for (place, (column, values)) in columns.iter().enumerate() {
        for (other, others) in columns.iter().skip(place + 1) {
            let pairs: Vec<[f64; 2]> =
                values.iter().copied().zip(others.iter().copied()).map(<[f64; 2]>::from).collect();
            let r = correlation(&pairs);
            if [*column, *other] != [Column::Speed, Column::MotorSpeed] && 1.0 - r * r < DOUBLED {
                let [[a, b], [c, d]] = [ends(values), ends(others)];
                let factor = (b - a) / (d - c) * r.signum();
                return vec![
                    Doubt::new(*column, Misread::Doubled, factor),
                    Doubt::new(*other, Misread::Doubled, factor.recip()),
                ];
            }
        }
    }
    Vec::new()
}

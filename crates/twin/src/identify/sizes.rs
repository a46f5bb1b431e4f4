//! Torque and current without their sign: the equations of motion, solved with the signs free.

use super::Observed;
use super::doubts::{Column, Doubt, Misread};
use super::motor::Tabulated;
use super::windows::Strokes;
use numeric::Symmetric;

/// Share of the largest value below zero, and standard deviations of the noise, up to which a signal has no negative values. Choices.
const NEGATIVE: f64 = 0.02;
const NOISE: f64 = 5.0;

/// Largest number of samples compared, and of rounds in which signs and coefficients approach each other.
const SAMPLES: usize = 3000;
const ROUNDS: usize = 12;

/// Sum of the squares of the residuals with free signs relative to that of the signal as it is, below which the signal has lost its
/// sign. A choice: a signal that has it is explained as well.
const EXPLAINED: f64 = 0.5;

/// Smallest share of the squares of a signal whose sign is another, and of the residuals in those of the signal as it is. A choice.
const OTHER: f64 = 0.02;
const LEFT: f64 = 1e-3;

/// Returns the doubts of torque and current without their sign.
///
/// |y| = s (X c), s = sign(X c)
///
/// # Symbols
/// X columns of the load (α, σ, ω, cos q, sin q, 1) or of the motor (T, σ, Ω, α, 1), c coefficients without a table or a project
/// # Valid
/// signs and coefficients are found in turn, from the signs of acceleration, motion, the other signal, and the torque of the current
pub(super) fn doubts(run: &Observed, strokes: &Strokes, tabulated: Option<&Tabulated>) -> Vec<Doubt> {
    let samples = Samples::of(run, strokes);
    if samples.all.len() < 100 {
        return Vec::new();
    }
    let [torque, current] = [&run.torque_nm, &run.current_q_a].map(|column| is_unsigned(column));
    let mut doubts = Vec::new();
    let mut all = samples.all;
    if torque {
        let load = |each: &Sample| {
            vec![each.acceleration, each.sign, each.speed, each.position.cos(), each.position.sin(), 1.0]
        };
        let of_current = tabulated.map(|tabulated| {
            all.iter()
                .map(|each| {
                    tabulated.motor_nm_a * each.current / std::f64::consts::SQRT_2
                        - tabulated.rotor_kgm2 * each.acceleration
                })
                .collect()
        });
        let starts = starts(&all, of_current, |each| each.current);
        let values: Vec<f64> = all.iter().map(|each| each.torque).collect();
        let rows: Vec<Vec<f64>> = all.iter().map(load).collect();
        if let Some(signs) = signs(&rows, &values, &starts) {
            all.iter_mut().zip(signs).for_each(|(each, sign)| each.torque *= sign);
            doubts.push(Doubt::new(Column::Torque, Misread::Magnitude, 1.0));
        }
    }
    if current {
        let motor = |each: &Sample| vec![each.torque, each.sign, each.motor, each.acceleration, 1.0];
        let of_torque = tabulated
            .map(|tabulated| all.iter().map(|each| each.torque + tabulated.rotor_kgm2 * each.acceleration).collect());
        let starts = starts(&all, of_torque, |each| each.torque);
        let values: Vec<f64> = all.iter().map(|each| each.current).collect();
        let rows: Vec<Vec<f64>> = all.iter().map(motor).collect();
        if signs(&rows, &values, &starts).is_some() {
            doubts.push(Doubt::new(Column::Current, Misread::Magnitude, 1.0));
        }
    }
    doubts
}

/// Signals at an instant in motion.
struct Sample {
    position: f64,
    speed: f64,
    acceleration: f64,
    motor: f64,
    sign: f64,
    torque: f64,
    current: f64,
}

struct Samples {
    all: Vec<Sample>,
}

impl Samples {
    /// Returns samples in motion; accelerations are differences of the speed over a tenth of a stroke.
    fn of(run: &Observed, strokes: &Strokes) -> Self {
        let count: usize = strokes.ranges.iter().map(|(range, _)| range.len()).sum();
        let each = count.div_ceil(SAMPLES).max(1);
        let mut all = Vec::new();
        for (range, sign) in &strokes.ranges {
            let half = (range.len() / 20).max(2);
            let inner = (range.start + half).min(range.end)..range.end.saturating_sub(half);
            for k in inner.step_by(each) {
                let rate = || {
                    let way = strokes.speed.get(k + half)? - strokes.speed.get(k - half)?;
                    Some(way / (run.time_s.get(k + half)? - run.time_s.get(k - half)?))
                };
                let sample = || {
                    Some(Sample {
                        position: *run.position_rad.get(k)?,
                        speed: *strokes.speed.get(k)?,
                        acceleration: rate()?,
                        motor: *run.motor_rad_s.get(k)?,
                        sign: *sign,
                        torque: *run.torque_nm.get(k)?,
                        current: *run.current_q_a.get(k)?,
                    })
                };
                all.extend(sample());
            }
        }
        Self { all }
    }
}

/// Returns `true` if a signal has no negative values beyond its noise.
fn is_unsigned(values: &[f64]) -> bool {
    let [low, high] = values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(*value), high.max(*value)]);
    high > 0.0 && low > -(NEGATIVE * high).max(NOISE * super::windows::noise_of(values))
}

/// Returns courses whose signs the signal may have had.
fn starts(all: &[Sample], of_other: Option<Vec<f64>>, other: fn(&Sample) -> f64) -> Vec<Vec<f64>> {
    let of = |value: &dyn Fn(&Sample) -> f64| all.iter().map(value).collect::<Vec<f64>>();
    let mut starts = vec![of(&|each| each.acceleration), of(&|each| each.sign), of(&other)];
    starts.extend(of_other);
    starts
}

/// Returns the signs with which the equations explain the sizes of a signal, if they do so far better than those of the signal as it is.
fn signs(rows: &[Vec<f64>], values: &[f64], starts: &[Vec<f64>]) -> Option<Vec<f64>> {
    let (_, plain) = solved(rows, values)?;
    let total: f64 = values.iter().map(|value| value * value).sum();
    if plain < LEFT * total {
        return None;
    }
    let mut best: Option<(Vec<f64>, f64)> = None;
    for start in starts {
        let mut signs: Vec<f64> = start.iter().map(|value| if *value < 0.0 { -1.0 } else { 1.0 }).collect();
        for _ in 0..ROUNDS {
            let signed: Vec<f64> = values.iter().zip(&signs).map(|(value, sign)| value * sign).collect();
            let Some((explained, square)) = solved(rows, &signed) else { break };
            if best.as_ref().is_none_or(|(_, least)| square < *least) {
                best = Some((signs.clone(), square));
            }
            let next: Vec<f64> = explained.iter().map(|value| if *value < 0.0 { -1.0 } else { 1.0 }).collect();
            if next == signs {
                break;
            }
            signs = next;
        }
    }
    let (signs, square) = best?;
    let with = |sign: f64| {
        values.iter().zip(&signs).filter(|(_, own)| **own == sign).map(|(value, _)| value * value).sum::<f64>()
    };
    let other = with(1.0).min(with(-1.0));
    (square < EXPLAINED * plain && other > OTHER * total).then_some(signs)
}

/// Returns what the equations explain, and the sum of the squares of the residuals.
fn solved(rows: &[Vec<f64>], values: &[f64]) -> Option<(Vec<f64>, f64)> {
    let width = rows.first()?.len();
    let mut scale = vec![0.0; width];
    rows.iter().for_each(|row| scale.iter_mut().zip(row).for_each(|(sum, a)| *sum += a * a));
    scale.iter_mut().for_each(|sum: &mut f64| *sum = sum.sqrt().max(f64::MIN_POSITIVE));
    let mut matrix = Symmetric::zero(std::iter::repeat_n(0, width));
    let mut right = vec![0.0; width];
    for (row, value) in rows.iter().zip(values) {
        for ((place, a), (of_a, right)) in row.iter().enumerate().zip(scale.iter().zip(&mut right)) {
            *right += a / of_a * value;
            for ((column, b), of_b) in row.iter().enumerate().zip(&scale).take(place + 1) {
                matrix.add(place, column, a / of_a * b / of_b);
            }
        }
    }
    // Columns that depend on each other explain the same.
    (0..width).for_each(|place| matrix.add(place, place, 1e-9));
    let found = matrix.solve(right)?;
    let explained: Vec<f64> = rows
        .iter()
        .map(|row| row.iter().zip(found.iter().zip(&scale)).map(|(a, (c, scale))| a * c / scale).sum())
        .collect();
    let square = explained.iter().zip(values).map(|(own, value)| (own - value).powi(2)).sum();
    Some((explained, square))
}

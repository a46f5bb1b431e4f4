//! Delays of torque and current against the position: filters, other bus cycles, other loggers.

use super::motor::Equations;
use super::regression::{Fit, Row, fit};
use super::windows::Windows;
use super::{Delay, Observed};

/// Smallest delay that counts \[s\], and the smallest relative to half its 95 % interval. A choice: four standard
/// deviations.
const LEAST_S: f64 = 1e-4;
const BEYOND: f64 = 2.0;

/// Largest delay that is sought \[s\]. A choice.
const MOST_S: f64 = 0.1;

/// Largest number of steps towards a delay; each reduces its error by a factor of ten or more.
const STEPS: usize = 8;

/// Sum of the squares of the residuals relative to that without a delay, above which the delay explains too little, and that of
/// loads without constant factors, whose deviation from the stated load a small delay may seem to explain. A choice.
const EXPLAINED: f64 = 1.0;
const EXPLAINED_BESIDE: f64 = 0.5;

/// Delays removed from the signals of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Delays {
    pub(super) torque: Option<Delay>,
    pub(super) current: Option<Delay>,
}

/// Equations of the load of windows, whose last column is the rate of the torque, and the variances of the noise of the
/// columns; `true` if all parameters of the load are estimated.
pub(super) type LoadRows<'a> = &'a dyn Fn(&Observed, &Windows) -> (Vec<Row>, Vec<f64>, bool);

/// Signal of a run.
type Signal = fn(&mut Observed) -> &mut Vec<f64>;

/// Seeks and removes the delays of torque and current.
///
/// T + τ T' = J_L α + …, I + τ I' = a T + … + c Ω'
///
/// # Source
/// docs/theory/twin.md, *Identification*
/// # Valid
/// no scale of torque or current is assumed. The torque is shifted until its own rate no longer explains its residual,
/// then the current.
pub(super) fn removed(
    run: Observed,
    windows: Windows,
    made: &dyn Fn(&Observed) -> Option<Windows>,
    of_load: LoadRows<'_>,
) -> (Observed, Windows, Delays) {
    let mut all = Delays::default();
    let mut now = (run, windows);
    let load = |run: &Observed, windows: &Windows| {
        let (rows, noise, is_whole) = of_load(run, windows);
        Trial::of(rows, &noise, if is_whole { EXPLAINED } else { EXPLAINED_BESIDE })
    };
    if let Some((run, windows, delay)) = sought(&now, |run| &mut run.torque_nm, made, &load) {
        (now, all.torque) = ((run, windows), Some(delay));
    }
    let motor = |_: &Observed, windows: &Windows| {
        let rows = Equations::of(windows, None, false).rows_of_delay();
        Trial::of(rows, &[], EXPLAINED)
    };
    if let Some((run, windows, delay)) = sought(&now, |run| &mut run.current_q_a, made, &motor) {
        (now, all.current) = ((run, windows), Some(delay));
    }
    (now.0, now.1, all)
}

/// Equations with the rate of the signal as their last column, solved.
struct Trial {
    rows: Vec<Row>,
    noise: Vec<f64>,
    most: f64,
    fit: Fit,
}

impl Trial {
    fn of(rows: Vec<Row>, noise: &[f64], most: f64) -> Option<Self> {
        let fit = fit(&rows, noise, &[])?;
        Some(Self { rows, noise: noise.to_vec(), most, fit })
    }

    /// Returns the delay that remains.
    fn left(&self) -> Option<Delay> {
        let last = self.rows.first()?.regressors.len() - 1;
        let (value, half_width_s) = self.fit.estimate(last).filter(|_| self.fit.separates(last))?;
        Some(Delay { s: -value, half_width_s })
    }

    /// Returns the sum of the squares of the residuals without a delay, over the largest share that may be left.
    fn bound(&self) -> Option<f64> {
        let mut rows = self.rows.clone();
        rows.iter_mut().for_each(|row| row.regressors.truncate(row.regressors.len().saturating_sub(1)));
        let noise = self.noise.get(..rows.first()?.regressors.len().min(self.noise.len()))?;
        Some(fit(&rows, noise, &[])?.square * self.most)
    }
}

fn sought(
    (run, windows): &(Observed, Windows),
    signal: Signal,
    made: &dyn Fn(&Observed) -> Option<Windows>,
    trial: &dyn Fn(&Observed, &Windows) -> Option<Trial>,
) -> Option<(Observed, Windows, Delay)> {
    let first = trial(run, windows)?;
    let counts = |delay: &Delay| delay.s.abs() > LEAST_S.max(BEYOND * delay.half_width_s);
    let mut left = first.left().filter(counts)?;
    let mut run = run.clone();
    let original = signal(&mut run).clone();
    let mut total = 0.0;
    for _ in 0..STEPS {
        total += left.s;
        if total.abs() > MOST_S {
            return None;
        }
        *signal(&mut run) = shifted(&run.time_s, &original, total);
        let windows = made(&run)?;
        let now = trial(&run, &windows)?;
        left = now.left()?;
        if left.s.abs() < 0.1 * left.half_width_s {
            let delay = Delay { s: total + left.s, half_width_s: left.half_width_s };
            let is_better = now.fit.square < first.bound()?;
            return (counts(&delay) && is_better).then_some((run, windows, delay));
        }
    }
    None
}

/// Returns the values of a signal a time later, interpolated linearly; beyond the run those of its ends.
fn shifted(time_s: &[f64], column: &[f64], by_s: f64) -> Vec<f64> {
    let mut place = 0_usize;
    let value = |time: &f64| {
        let wanted = time + by_s;
        while time_s.get(place + 1).is_some_and(|next| *next <= wanted) {
            place += 1;
        }
        let (a, b) = (column.get(place).copied()?, column.get(place + 1).or(column.get(place)).copied()?);
        let (ta, tb) = (time_s.get(place).copied()?, time_s.get(place + 1).copied().unwrap_or(f64::INFINITY));
        Some(a + (b - a) * ((wanted - ta) / (tb - ta)).clamp(0.0, 1.0))
    };
    time_s.iter().map(value).map(Option::unwrap_or_default).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_interpolates_and_keeps_the_ends() {
        let (time, column) = ([0.0, 1.0, 2.0, 4.0], [0.0, 10.0, 20.0, 0.0]);
        assert_eq!(shifted(&time, &column, 0.5), [5.0, 15.0, 15.0, 0.0]);
        assert_eq!(shifted(&time, &column, -1.5), [0.0, 0.0, 5.0, 15.0]);
    }
}

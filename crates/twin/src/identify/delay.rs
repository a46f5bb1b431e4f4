//! Delays of torque and current against the position (other bus cycles, other loggers), and filters of these signals.

use super::motor::{Equations, Scale};
use super::regression::{Fit, Row, compared, fit};
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

/// Smallest logarithm of the ratio of likelihoods with which a filter counts instead of a delay. A choice.
const DISTINCT: f64 = 8.0;

/// Smallest lag relative to half its 95 % interval that the equations estimate although it does not count. A choice: one
/// standard deviation.
const BEYOND_SEEN: f64 = 0.5;

/// Smallest half interval of a time constant relative to its value. A choice: losses of the teeth change where the torque
/// does its sign, which a filter mixes.
const SHAPE: f64 = 0.025;

/// Time constants behind a reversal after which a filter is settled: 0.7 % of the step is left.
const SETTLED: f64 = 5.0;

/// Lags removed from the signals of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Delays {
    pub(super) torque: Option<Lag>,
    pub(super) current: Option<Lag>,
    /// Lag of the torque that the equation of the load admits beside the removed one, where that equation has an error of its own \[s\].
    pub(super) torque_error_s: f64,
    /// Run and windows with a filter of the torque instead of its delay, if the run does not distinguish them.
    pub(super) torque_or: Option<(Observed, Windows)>,
    /// Run and windows with a filter of the current instead of its delay.
    pub(super) current_or: Option<(Observed, Windows)>,
}

/// A lag that the signals of the run no longer have against each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Lag {
    /// The signal has been shifted by a delay.
    Delay(Delay),
    /// The other signals have the filter, whose time constant is the delay.
    Filter(Delay),
    /// The signal may lag by less than what counts.
    Unclear,
}

impl Lag {
    /// Returns the lag with a further error.
    fn within(self, error_s: f64) -> Self {
        let wider = |delay: Delay| Delay { half_width_s: delay.half_width_s.hypot(error_s), ..delay };
        match self {
            Self::Delay(delay) => Self::Delay(wider(delay)),
            Self::Filter(delay) => Self::Filter(wider(delay)),
            Self::Unclear => Self::Unclear,
        }
    }

    /// Returns the delay, if it is one.
    pub(super) const fn delay(self) -> Option<Delay> {
        if let Self::Delay(delay) = self { Some(delay) } else { None }
    }

    /// Returns the time constant of the filter, if it is one.
    pub(super) const fn filter(self) -> Option<Delay> {
        if let Self::Filter(delay) = self { Some(delay) } else { None }
    }
}

/// Equations of the load of windows, whose last column is the rate of the torque, and the variances of the noise of the
/// columns; the norm of their error that is no noise, zero if all parameters of the load are estimated.
pub(super) type LoadRows<'a> = &'a dyn Fn(&Observed, &Windows) -> (Vec<Row>, Vec<f64>, f64);

/// Windows of a run without a time at the begin of each stroke.
pub(super) type Made<'a> = &'a dyn Fn(&Observed, f64) -> Option<Windows>;

/// Signal of a run, and those that are given its filter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Signal {
    Torque,
    Current,
}

impl Signal {
    const fn own(self, run: &mut Observed) -> &mut Vec<f64> {
        match self {
            Self::Torque => &mut run.torque_nm,
            Self::Current => &mut run.current_q_a,
        }
    }

    /// Returns the run with the filter of the signal on the other signals.
    fn filtered(self, run: &Observed, constant_s: f64) -> Observed {
        let of = |column: &[f64]| low_pass(&run.time_s, column, constant_s, f64::INFINITY);
        let mut filtered = run.clone();
        filtered.position_rad = low_pass(&run.time_s, &run.position_rad, constant_s, std::f64::consts::PI);
        filtered.motor_rad_s = of(&run.motor_rad_s);
        match self {
            Self::Torque => filtered.current_q_a = of(&run.current_q_a),
            Self::Current => filtered.torque_nm = of(&run.torque_nm),
        }
        filtered
    }
}

/// Smallest lag of the motor speed behind the position that is removed by a shift, in s and in rows; the equations have a smaller one
/// to first order. A choice.
const SHIFTED_S: f64 = 2e-3;
const SHIFTED_ROWS: f64 = 2.0;

/// Shifts the motor speed until it no longer lags the position, and returns the lag; a late position lets it lead.
///
/// # Valid
/// the lag approaches that of [`Equations::lag_s`]; beyond 0.1 s the run stays as it is
pub(super) fn aligned(run: Observed, windows: Windows, made: Made<'_>) -> (Observed, Windows, f64) {
    // Without the torsion of the gear, whose rate has the scale of the torque.
    let lag_s = |windows: &Windows| Equations::of(windows, false, None, false).lag_s(Scale::NONE);
    let mut left_s = lag_s(&windows);
    if left_s.abs() < SHIFTED_S.max(SHIFTED_ROWS * windows.step_s) {
        return (run, windows, 0.0);
    }
    let mut total_s = 0.0;
    let mut now = None;
    for _ in 0..STEPS {
        total_s += left_s;
        let motor_rad_s = shifted(&run.time_s, &run.motor_rad_s, total_s);
        let next = Observed { motor_rad_s, ..run.clone() };
        let Some(windows) = made(&next, 0.0).filter(|_| total_s.abs() < MOST_S) else { return (run, windows, 0.0) };
        left_s = lag_s(&windows);
        now = Some((next, windows));
        if left_s == 0.0 {
            break;
        }
    }
    now.map_or((run, windows, 0.0), |(run, windows)| (run, windows, total_s))
}

/// Seeks and removes the delays or filters of torque and current.
///
/// delay: T + τ T' = J_L α + …, I + τ I' = a T + … + c Ω'; filter: T = F(J_L α + …), I = F(a T + …)
///
/// # Symbols
/// F low-pass filter of first order, applied to all signals but the one that has it
/// # Source
/// docs/theory/twin.md, *Identification*
/// # Valid
/// no scale of torque or current is assumed. The torque is shifted until its own rate no longer explains its residual,
/// then the current. A filter counts if its residuals are smaller by far than those of the delay.
pub(super) fn removed(
    run: Observed,
    windows: Windows,
    made: Made<'_>,
    of_load: LoadRows<'_>,
) -> (Observed, Windows, Delays) {
    let mut all = Delays::default();
    let mut now = (run, windows);
    let load = |run: &Observed, windows: &Windows| {
        let (rows, noise, error) = of_load(run, windows);
        Trial::of(rows, &noise, error)
    };
    let mut settle_s = 0.0;
    let (_, _, error) = of_load(&now.0, &now.1);
    let seen = load(&now.0, &now.1).and_then(|trial| trial.left());
    if let Some(found) = sought(&now, settle_s, Signal::Torque, made, &load) {
        all.torque = Some(found.lag);
        all.torque_or = found.or;
        settle_s += SETTLED * found.lag.filter().map_or(0.0, |delay| delay.s);
        now = found.removed.unwrap_or(now);
    }
    all.torque_error_s = match (all.torque, seen) {
        _ if error == 0.0 => 0.0,
        (Some(Lag::Delay(delay) | Lag::Filter(delay)), _) => delay.half_width_s,
        (_, Some(seen)) => seen.s.abs() + seen.half_width_s,
        _ => MOST_S,
    };
    let motor = |_: &Observed, windows: &Windows| {
        let rows = Equations::of(windows, false, None, false).rows_of_delay();
        Trial::of(rows, &[], 0.0)
    };
    if let Some(found) = sought(&now, settle_s, Signal::Current, made, &motor) {
        // The current has the filter of the torque, with the error of its time constant.
        let of_torque = all.torque.and_then(Lag::filter).map_or(0.0, |delay| delay.half_width_s);
        all.current = Some(found.lag.within(of_torque.max(all.torque_error_s)));
        all.current_or = found.or;
        now = found.removed.unwrap_or(now);
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
    fn of(rows: Vec<Row>, noise: &[f64], error: f64) -> Option<Self> {
        let fit = compared(&rows, noise, &[])?.with_error(error);
        let most = if error > 0.0 { EXPLAINED_BESIDE } else { EXPLAINED };
        Some(Self { rows, noise: noise.to_vec(), most, fit })
    }

    /// Returns the delay that remains.
    fn left(&self) -> Option<Delay> {
        let last = self.rows.first()?.regressors.len() - 1;
        let (value, half_width_s) = self.fit.estimate(last).filter(|_| self.fit.separates(last))?;
        Some(Delay { s: -value, half_width_s })
    }

    /// Returns `true` if the residuals are so much smaller than others that these are unlikely.
    ///
    /// n ln(S_o/S)/2 is the logarithm of the ratio of likelihoods of n independent normal residuals.
    fn is_likelier_than(&self, other: &Self) -> bool {
        let count = self.fit.independent.min(other.fit.independent);
        0.5 * count * (other.fit.square / self.fit.square).ln() > DISTINCT
    }

    /// Returns the sum of the squares of the residuals without a delay, over the largest share that may be left.
    fn bound(&self) -> Option<f64> {
        let mut rows = self.rows.clone();
        rows.iter_mut().for_each(|row| row.regressors.truncate(row.regressors.len().saturating_sub(1)));
        let noise = self.noise.get(..rows.first()?.regressors.len().min(self.noise.len()))?;
        Some(fit(&rows, noise, &[])?.square * self.most)
    }
}

/// A run without a lag, its windows and equations.
struct Removed {
    run: Observed,
    windows: Windows,
    trial: Trial,
    delay: Delay,
}

/// A lag, the run without it, and another run that fits as well.
struct Sought {
    lag: Lag,
    removed: Option<(Observed, Windows)>,
    or: Option<(Observed, Windows)>,
}

fn sought(
    (run, windows): &(Observed, Windows),
    settle_s: f64,
    signal: Signal,
    made: Made<'_>,
    trial: &dyn Fn(&Observed, &Windows) -> Option<Trial>,
) -> Option<Sought> {
    let first = trial(run, windows)?;
    let exceeds = |delay: &Delay, beyond: f64| delay.s.abs() > LEAST_S.max(beyond * delay.half_width_s);
    let counts = |delay: &Delay| exceeds(delay, BEYOND);
    let left = first.left().filter(|delay| exceeds(delay, BEYOND_SEEN))?;
    let unclear = Some(Sought { lag: Lag::Unclear, removed: None, or: None });
    if !counts(&left) {
        return unclear;
    }
    let mut shifting = run.clone();
    let original = signal.own(&mut shifting).clone();
    let mut shifted_run = |by_s: f64| {
        *signal.own(&mut shifting) = shifted(&run.time_s, &original, by_s);
        shifting.clone()
    };
    let delayed = approached(left.s, &mut shifted_run, &|run, _| made(run, settle_s), trial)
        .filter(|delayed| counts(&delayed.delay));
    let delayed = delayed.filter(|delayed| first.bound().is_some_and(|bound| delayed.trial.fit.square < bound))?;
    let start_s = delayed.delay.s;
    let filtered = (start_s > 0.0).then(|| Filtered::of(run, &delayed, signal, made, settle_s, trial)).flatten();
    let mut lag = Lag::Delay(delayed.delay);
    let mut removed = (delayed.run, delayed.windows);
    let mut or = None;
    if let Some(filtered) = filtered {
        if filtered.is_likelier {
            let mut filtered_run = |constant_s: f64| signal.filtered(run, constant_s);
            let made_settled = |run: &Observed, total_s: f64| made(run, settle_s + SETTLED * total_s);
            let exact = approached(filtered.constant_s, &mut filtered_run, &made_settled, trial);
            if let Some(exact) = exact.filter(|exact| counts(&exact.delay)) {
                let half_width_s = exact.delay.half_width_s.max(SHAPE * exact.delay.s);
                lag = Lag::Filter(Delay { half_width_s, ..exact.delay });
                removed = (exact.run, exact.windows);
            }
        } else if filtered.is_open {
            let apart = (filtered.constant_s - start_s).abs();
            lag = Lag::Delay(Delay { half_width_s: delayed.delay.half_width_s + apart, ..delayed.delay });
            or = Some((filtered.run, filtered.windows));
        }
    }
    Some(Sought { lag, removed: Some(removed), or })
}

/// A filter beside a delay with the same lag.
struct Filtered {
    run: Observed,
    windows: Windows,
    /// Time constant \[s\].
    constant_s: f64,
    /// The filter is likelier than the delay, so that this one is unlikely.
    is_likelier: bool,
    /// Neither is unlikely.
    is_open: bool,
}

impl Filtered {
    /// Compares a filter with a delay in the windows in which the filter is settled; the rate of the signal contains the small
    /// difference of their lags.
    fn of(
        run: &Observed,
        delayed: &Removed,
        signal: Signal,
        made: Made<'_>,
        settle_s: f64,
        trial: &dyn Fn(&Observed, &Windows) -> Option<Trial>,
    ) -> Option<Self> {
        let constant_s = delayed.delay.s;
        let run = signal.filtered(run, constant_s);
        let settled = |windows: &Windows| windows.behind(&run.time_s, SETTLED * constant_s);
        let windows = settled(&made(&run, settle_s)?);
        let [of_filter, of_delay] = [trial(&run, &windows)?, trial(&delayed.run, &settled(&delayed.windows))?];
        let constant_s = constant_s + of_filter.left()?.s;
        let is_likelier = of_filter.is_likelier_than(&of_delay);
        let is_open = !is_likelier && !of_delay.is_likelier_than(&of_filter);
        (constant_s > LEAST_S).then_some(Self { run, windows, constant_s, is_likelier, is_open })
    }
}

/// Approaches the lag with which the rate of the signal explains nothing more; `of` returns the run without a lag.
fn approached(
    start_s: f64,
    of: &mut dyn FnMut(f64) -> Observed,
    made: Made<'_>,
    trial: &dyn Fn(&Observed, &Windows) -> Option<Trial>,
) -> Option<Removed> {
    let mut total = start_s;
    for _ in 0..STEPS {
        if total.abs() > MOST_S {
            return None;
        }
        let run = of(total);
        let windows = made(&run, total)?;
        let trial = trial(&run, &windows)?;
        let left = trial.left()?;
        if left.s.abs() < 0.1 * left.half_width_s {
            let delay = Delay { s: total + left.s, half_width_s: left.half_width_s };
            return Some(Removed { run, windows, trial, delay });
        }
        total += left.s;
    }
    None
}

/// Returns a signal behind a low-pass filter of first order.
///
/// τ y' + y = x, x straight between the rows
///
/// # Valid
/// The filter starts settled, and anew behind a jump, as of a position that is set anew.
fn low_pass(time_s: &[f64], column: &[f64], constant_s: f64, jump: f64) -> Vec<f64> {
    if constant_s <= 0.0 {
        return column.to_vec();
    }
    let mut filtered: Vec<f64> = Vec::with_capacity(column.len());
    let (mut behind, mut decay): (Option<f64>, _) = (None, (0.0, 1.0));
    filtered.extend(column.first());
    for (time, pair) in time_s.windows(2).zip(column.windows(2)) {
        let ([before, now], [old, new]) = (time, pair) else { continue };
        let (h, way) = (now - before, new - old);
        if way.abs() < jump {
            if h != decay.0 {
                decay = (h, (-h / constant_s).exp());
            }
            // y − x decays towards −τ x'.
            let settled = -constant_s * way / h;
            if let (None, Some(last)) = (behind, filtered.last_mut()) {
                *last += settled;
            }
            behind = Some(settled + (behind.unwrap_or(settled) - settled) * decay.1);
        } else {
            behind = None;
        }
        filtered.push(new + behind.unwrap_or(0.0));
    }
    filtered
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

    /// The filter of a straight line is the line a time constant later, and that of a step its exponential.
    #[test]
    fn a_low_pass_is_that_of_its_equation() {
        let time: Vec<f64> = (0..400_u32).map(|k| 0.001 * f64::from(k) + if k % 3 == 0 { 2e-4 } else { 0.0 }).collect();
        let line: Vec<f64> = time.iter().map(|t| 5.0 + 3.0 * t).collect();
        let sine: Vec<f64> = time.iter().map(|t| (20.0 * t).sin()).collect();
        for constant in [1e-4, 0.002, 0.02] {
            for (t, y) in time.iter().zip(low_pass(&time, &line, constant, 3.0)) {
                assert!((y - (5.0 + 3.0 * (t - constant))).abs() < 1e-12, "{constant} {t} {y}");
            }
            let angle = (20.0 * constant).atan();
            for (t, y) in time.iter().zip(low_pass(&time, &sine, constant, 3.0)).filter(|(t, _)| **t > 0.25) {
                assert!((y - angle.cos() * (20.0 * t - angle).sin()).abs() < 2e-4, "{constant} {t} {y}");
            }
        }
        assert_eq!(low_pass(&time, &line, 0.0, 3.0), line);
        // A position set anew starts anew.
        assert_eq!(low_pass(&[0.0, 1.0, 2.0, 3.0], &[1.0, 1.0, 9.0, 9.0], 10.0, 3.0), [1.0, 1.0, 9.0, 9.0]);
    }

    #[test]
    fn a_shift_interpolates_and_keeps_the_ends() {
        let (time, column) = ([0.0, 1.0, 2.0, 4.0], [0.0, 10.0, 20.0, 0.0]);
        assert_eq!(shifted(&time, &column, 0.5), [5.0, 15.0, 15.0, 0.0]);
        assert_eq!(shifted(&time, &column, -1.5), [0.0, 0.0, 5.0, 15.0]);
    }
}

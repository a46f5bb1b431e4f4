//! Resolution of recorded samples: the step of a column and the spurious acceleration that it causes.

use numeric::upper_median;

/// Rounding error of a value, relative to the largest: 64 units in the last place.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Smallest step relative to the rounding error.
const STEP_LEAST: f64 = 16.0;

/// Permitted deviation of a difference from a multiple of the step, relative to the step.
const STEP_SLACK: f64 = 0.05;

/// Smallest difference that counts as rough, relative to the step; values are rounded if a quarter of the samples are
/// rough.
const ROUGH: f64 = 0.5;

/// Smallest spurious acceleration that is reported, relative to that of the motion.
pub(crate) const NOTABLE: f64 = 0.05;

/// Excess of the largest acceleration over that of the motion from which irregular updates are reported, relative to it.
const EXCESS: f64 = 0.15;

/// Column that causes a spurious acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SteppedColumn {
    /// Positions, differentiated twice \[rad\].
    Position,
    /// Speeds, differentiated once [rad/s].
    Speed,
}

/// Cause of a spurious acceleration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spurious {
    /// The values have steps.
    Steps {
        /// Step of the column \[rad\] or [rad/s].
        step: f64,
        /// Width of a smoothing window that reduces the spurious acceleration to a twentieth of the motion's, if there
        /// is one \[s\].
        smoothing_s: Option<f64>,
    },
    /// The values are held over several rows: the source is slower than the logger.
    Held {
        /// Period at which the values are updated \[s\].
        period_s: f64,
    },
    /// Held values are updated at irregular instants, which are known to within a row.
    Updates {
        /// Width of a smoothing window that reduces the spurious acceleration to a twentieth of the motion's, if there
        /// is one \[s\].
        smoothing_s: Option<f64>,
    },
    /// The time stamps scatter, the rows are evenly spaced.
    Stamps {
        /// Standard deviation of the stamps from evenly spaced instants \[s\].
        scatter_s: f64,
    },
}

/// A spurious acceleration caused by the resolution of a column in value or time.
///
/// Steps of a column are judged by the formulas below; held values and scattered stamps by the largest difference of
/// the acceleration from that with one value for each update, or with evenly spaced rows.
///
/// # Symbols
/// s step of the column, h time step; positions: the second difference of rounded values reaches s/h², with smoothing
/// over n samples four standard deviations, 4 · 8.5 s/(√12 n² h²); speeds: s/h, with smoothing 4 · 2.1 s/(√12 n h)
/// # Source
/// docs/theory/recorded-motion.md
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MadeUp {
    /// Column from which the acceleration follows.
    pub column: SteppedColumn,
    /// Cause.
    pub cause: Spurious,
    /// Median time step of the samples \[s\].
    pub interval_s: f64,
    /// Largest spurious acceleration \[rad/s²\].
    pub acceleration_rad_s2: f64,
    /// Largest acceleration of the motion, from samples far enough apart for the steps not to matter, or without the
    /// cause \[rad/s²\].
    pub motion_rad_s2: f64,
}

/// Returns the step of a column: the largest number of which all differences of adjacent values are multiples; zero if
/// there is none.
pub(crate) fn step(values: &[f64]) -> f64 {
    let most = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let least = ROUNDING * most;
    let mut step = 0.0_f64;
    for (one, other) in values.iter().zip(values.iter().skip(1)) {
        let difference = (other - one).abs();
        if difference <= least {
            continue;
        }
        if step == 0.0 {
            step = difference;
            continue;
        }
        let rest = (difference - step * (difference / step).round()).abs();
        if rest > STEP_SLACK * step.min(difference) {
            // Euclid's algorithm down to the rounding error.
            let (mut larger, mut smaller) = (difference.max(step), difference.min(step));
            while smaller > least && smaller > STEP_SLACK * larger.min(step) {
                (larger, smaller) = (smaller, (larger - smaller * (larger / smaller).round()).abs());
            }
            step = larger;
            if step < STEP_LEAST * least {
                return 0.0;
            }
        }
    }
    if step < STEP_LEAST * least { 0.0 } else { step }
}

/// Returns `true` if the values are rounded to the step: their differences of this order are as large as the step,
/// while those of a densely sampled motion vanish.
fn is_rough(values: &[f64], step: f64, order: usize) -> bool {
    let (mut rough, mut moving) = (0_usize, 0_usize);
    let (second, third) = (order == 2, order == 3);
    for window in values.windows(order + 1) {
        let difference = match window {
            [a, b, c] if second => a - 2.0 * b + c,
            [a, b, c, d] if third => d - 3.0 * c + 3.0 * b - a,
            _ => 0.0,
        };
        let is_rough = difference.abs() >= ROUGH * step;
        moving += usize::from(is_rough || window.first() != window.last());
        rough += usize::from(is_rough);
    }
    moving >= 8 && 4 * rough >= moving
}

/// Returns the median time step \[s\].
pub(crate) fn median_interval(time: &[f64]) -> f64 {
    upper_median(time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one)).unwrap_or(0.0)
}

/// Returns the mean time step \[s\], without gaps: steps up to one and a half of the ninth decile. The mean over all rows
/// does not depend on the rounding of the time stamps, unlike the median.
pub(crate) fn mean_interval(time: &[f64]) -> f64 {
    let steps = || time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one);
    let mut all: Vec<f64> = steps().collect();
    let place = all.len() * 9 / 10;
    if place >= all.len() {
        return 0.0;
    }
    let most = 1.5 * *all.select_nth_unstable_by(place, f64::total_cmp).1;
    let (sum, count) =
        steps().filter(|step| *step <= most).fold((0.0, 0_u32), |(sum, count), step| (sum + step, count + 1));
    sum / f64::from(count.max(1))
}

/// Returns the spurious acceleration caused by the steps of a column, if it is significant compared with that of the
/// motion.
pub(crate) fn made_up(time: &[f64], values: &[f64], column: SteppedColumn, window_s: Option<f64>) -> Option<MadeUp> {
    let step = step(values);
    let order = match column {
        SteppedColumn::Position => 3,
        SteppedColumn::Speed => 2,
    };
    if step == 0.0 || !is_rough(values, step, order) {
        return None;
    }
    let rounded = Rounded { time, values, column, step, window_s };
    let h = median_interval(time);
    let plain = rounded.plain(h);
    let acceleration = window_s.map_or(plain, |window| rounded.smoothed(window).min(plain));
    let motion = rounded.motion();
    let cause = |smoothing_s| Spurious::Steps { step, smoothing_s };
    (acceleration > NOTABLE * motion).then(|| rounded.made_up(acceleration, motion, cause))
}

/// Returns the spurious acceleration of held values that are updated at irregular instants, each known to within a row:
/// the excess of the largest acceleration over that of the motion.
pub(crate) fn made_up_by_updates(
    (time, values): (&[f64], &[f64]),
    column: SteppedColumn,
    window_s: Option<f64>,
    (row_s, largest): (f64, f64),
) -> Option<MadeUp> {
    let pairs = time.iter().zip(values).zip(time.iter().zip(values).skip(1));
    let rate = pairs.fold(0.0_f64, |most, ((t0, y0), (t1, y1))| most.max(((y1 - y0) / (t1 - t0)).abs()));
    let rounded = Rounded { time, values, column, step: rate * row_s, window_s };
    let motion = rounded.motion();
    let excess = largest - motion;
    (excess > EXCESS * motion).then(|| rounded.made_up(excess, motion, |smoothing_s| Spurious::Updates { smoothing_s }))
}

/// A column with errors of up to half a step.
struct Rounded<'s> {
    time: &'s [f64],
    values: &'s [f64],
    column: SteppedColumn,
    step: f64,
    window_s: Option<f64>,
}

impl Rounded<'_> {
    /// Returns the spurious acceleration of samples at a distance \[s\].
    fn plain(&self, apart: f64) -> f64 {
        match self.column {
            SteppedColumn::Position => self.step / (apart * apart),
            SteppedColumn::Speed => self.step / apart,
        }
    }

    /// Returns the spurious acceleration with a smoothing window \[s\].
    fn smoothed(&self, window: f64) -> f64 {
        let deviation = self.step / 12.0_f64.sqrt();
        match self.column {
            SteppedColumn::Position => 4.0 * 8.5 * deviation / (window * window),
            SteppedColumn::Speed => 4.0 * 2.1 * deviation / window,
        }
    }

    /// Returns the largest acceleration of the motion: the distance of the samples is doubled until the steps are a tenth
    /// of the motion between them.
    fn motion(&self) -> f64 {
        let h = median_interval(self.time);
        let mut apart = 1;
        loop {
            let found = largest_acceleration(self.time, self.values, self.column, apart);
            if 2.0 * self.plain(apart as f64 * h) <= 0.1 * found || 6 * apart >= self.values.len() {
                break found;
            }
            apart *= 2;
        }
    }

    /// Returns the spurious acceleration with the window that reduces it.
    fn made_up(&self, acceleration: f64, motion: f64, cause: impl Fn(Option<f64>) -> Spurious) -> MadeUp {
        let h = median_interval(self.time);
        let ratio = self.smoothed(1.0) / (NOTABLE * motion);
        let wanted = match self.column {
            SteppedColumn::Position => ratio.sqrt(),
            SteppedColumn::Speed => ratio,
        };
        let duration = self.time.first().zip(self.time.last()).map_or(0.0, |(first, last)| last - first);
        // Slightly more than an even multiple of the time step, so that the window contains the same number of samples
        // everywhere; at least seven.
        let half = (0.5 * wanted / h).ceil().max(3.0);
        let window = (2.0 * half + 0.5) * h;
        let is_short = window <= 0.1 * duration && half <= 5000.0 && self.window_s.is_none_or(|given| given < window);
        MadeUp {
            column: self.column,
            cause: cause(is_short.then_some(window)),
            interval_s: h,
            acceleration_rad_s2: acceleration,
            motion_rad_s2: motion,
        }
    }
}

/// Returns the largest acceleration between samples at a distance of `apart` \[rad/s²\].
fn largest_acceleration(time: &[f64], values: &[f64], column: SteppedColumn, apart: usize) -> f64 {
    let points = || time.iter().zip(values);
    let slopes = points().zip(points().skip(apart)).map(|((t0, y0), (t1, y1))| (t0, t1, (y1 - y0) / (t1 - t0)));
    match column {
        SteppedColumn::Speed => slopes.fold(0.0, |most, (.., slope)| most.max(slope.abs())),
        SteppedColumn::Position => {
            let later = slopes.clone().skip(apart);
            let second = |((t0, _, before), (_, t2, behind)): ((&f64, &f64, f64), (&f64, &f64, f64))| {
                2.0 * (behind - before) / (t2 - t0)
            };
            slopes.zip(later).map(second).fold(0.0, |most, alpha| most.max(alpha.abs()))
        }
    }
}

#[cfg(test)]
#[path = "resolution_tests.rs"]
mod tests;

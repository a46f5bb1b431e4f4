//! Resolution of recorded samples: the step of a column and the spurious acceleration that it causes.

use crate::grid::Grid;
use crate::white::{deviation, deviation_at};
use numeric::{nth_smallest, upper_median};

/// Smallest difference that counts as rough, relative to the step; values are rounded if a quarter of the samples are
/// rough.
const ROUGH: f64 = 0.5;

/// Smallest median of the deviations, relative to that of the steps of the source, with which they are its steps.
const OF_SOURCE: f64 = 0.85;

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
    /// White noise of the values.
    Noise {
        /// Standard deviation of a value \[rad\] or [rad/s].
        deviation: f64,
        /// Effective value of the spurious acceleration over the recording \[rad/s²\].
        rms_rad_s2: f64,
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
/// s step of the column, h time step; positions: the second difference of rounded values reaches s/h² (of unequal time
/// steps the sum of half a step times each coefficient of its formula), with smoothing over n samples four standard
/// deviations, 4 · 8.5 s/(√12 n² h²); speeds: s/h, with smoothing 4 · 2.1 s/(√12 n h)
/// # Source
/// docs/theory/recorded-motion.md
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MadeUp {
    /// Column from which the acceleration follows.
    pub column: SteppedColumn,
    /// Cause.
    pub cause: Spurious,
    /// Usual time step of the samples \[s\]; of steps the one where the largest spurious acceleration occurs.
    pub interval_s: f64,
    /// Largest spurious acceleration \[rad/s²\].
    pub acceleration_rad_s2: f64,
    /// Largest acceleration of the motion, from samples far enough apart for the steps not to matter, or without the
    /// cause \[rad/s²\].
    pub motion_rad_s2: f64,
}

impl MadeUp {
    /// Returns the spurious acceleration with the effective value of noise over the whole recording, where it acts only while the axis
    /// moves.
    pub(crate) fn while_moving(self, speed: &[f64]) -> Self {
        let Spurious::Noise { deviation, rms_rad_s2, smoothing_s } = self.cause else { return self };
        let moving = speed.windows(2).filter(|ends| *ends != [0.0; 2]).count() as f64;
        let rms_rad_s2 = rms_rad_s2 * (moving / (speed.len() as f64 - 1.0).max(1.0)).sqrt();
        Self { cause: Spurious::Noise { deviation, rms_rad_s2, smoothing_s }, ..self }
    }
}

/// Returns the median of the deviations from the polynomial through the neighbours if the values are rounded to the
/// step: they deviate by shares of the step, while those of a densely sampled motion follow the polynomial.
///
/// At equal time steps the deviation is that of the difference of this order: a half of the second, a third of the third.
fn roughness(time: &[f64], values: &[f64], step: f64, order: usize) -> Option<f64> {
    let (mut rough, mut moving) = (0_usize, Vec::new());
    for (time, values) in time.windows(order + 1).zip(values.windows(order + 1)) {
        let deviation = match (time, values) {
            ([t0, t1, t2], [a, b, c]) => {
                let u = (t1 - t0) / (t2 - t0);
                2.0 * (b - a - u * (c - a))
            }
            ([t0, t1, t2, t3], [a, b, c, d]) => {
                // Newton's form of the parabola through the first, the second and the last value.
                let slope = (b - a) / (t1 - t0);
                let bow = ((d - b) / (t3 - t1) - slope) / (t3 - t0);
                3.0 * (c - a - (t2 - t0) * (slope + (t2 - t1) * bow))
            }
            _ => 0.0,
        };
        let is_rough = deviation.abs() >= ROUGH * step;
        if is_rough || values.first() != values.last() {
            moving.push(deviation.abs());
        }
        rough += usize::from(is_rough);
    }
    let is_rounded = moving.len() >= 8 && 4 * rough >= moving.len();
    if is_rounded { upper_median(moving.into_iter()) } else { None }
}

/// Returns the grid to which the values are rounded: that of the source, or that of the file where they deviate too little from
/// each other for the steps of the source; a constant speed has equal steps too.
///
/// Uniform errors of a width s cause a median of 0.67 √(20/12) s in the third difference and 0.67 √(6/12) s in the second, single
/// steps of slow motions one of s.
fn rough_grid(time: &[f64], values: &[f64], order: usize) -> Option<Grid> {
    let grid = Grid::of(values);
    let share = 0.6745 * if order == 3 { (20.0_f64 / 12.0).sqrt() } else { 0.5_f64.sqrt() };
    let both = grid.step.hypot(grid.rounded);
    let is_of_source = |roughness: f64| grid.rounded == 0.0 || roughness >= OF_SOURCE * share * both;
    let is_rough = |step: f64| if step > 0.0 { roughness(time, values, step, order) } else { None };
    if is_rough(grid.step).is_some_and(is_of_source) {
        return Some(grid);
    }
    is_rough(grid.rounded).map(|_| Grid { step: grid.rounded, rounded: 0.0 })
}

/// Returns the median time step \[s\].
pub(crate) fn median_interval(time: &[f64]) -> f64 {
    upper_median(intervals(time)).unwrap_or(0.0)
}

/// Returns the mean time step \[s\], without gaps: steps up to one and a half of the ninth decile. The mean over all rows
/// does not depend on the rounding of the time stamps, unlike the median.
pub(crate) fn mean_interval(time: &[f64]) -> f64 {
    let steps = || intervals(time);
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

impl SteppedColumn {
    /// Returns the order of the differences that show steps.
    const fn order(self) -> usize {
        match self {
            Self::Position => 3,
            Self::Speed => 2,
        }
    }
}

/// Returns the spurious acceleration caused by the steps of a column, if it is significant compared with that of the
/// motion.
pub(crate) fn made_up(time: &[f64], values: &[f64], column: SteppedColumn, window_s: Option<f64>) -> Option<MadeUp> {
    let grid = rough_grid(time, values, column.order())?;
    let step = grid.step;
    let rounded = Rounded { time, values, column, step: grid.error(), window_s };
    let motion = rounded.motion();
    let (plain, interval_s) = rounded.between_rows(motion);
    let acceleration = window_s.map_or(plain, |window| rounded.smoothed(window).min(plain));
    let cause = |smoothing_s| Spurious::Steps { step, smoothing_s };
    (acceleration > NOTABLE * motion).then(|| rounded.made_up((acceleration, interval_s), motion, cause))
}

/// Returns the spurious acceleration of the white noise of a column, if it is significant compared with that of the motion.
///
/// σ_α² = Σ c_i² σ² as mean over time, with the factors c_i of the samples in the acceleration between two of them: evenly spaced
/// σ/h² of positions, √2 σ/h of speeds; with a window W 8.5 σ/W² and 2.1 σ/W
pub(crate) fn made_up_by_noise(
    time: &[f64],
    values: &[f64],
    column: SteppedColumn,
    window_s: Option<f64>,
) -> Option<MadeUp> {
    let interval_s = median_interval(time);
    let is_even = is_even(time, interval_s);
    // The noise of rounded values is that of their steps, which [`made_up`] judges.
    if !is_even && rough_grid(time, values, column.order()).is_some() {
        return None;
    }
    let deviation = noise(time, values, is_even);
    if deviation <= 0.0 {
        return None;
    }
    let rounded = Rounded { time, values, column, step: deviation * 12.0_f64.sqrt(), window_s };
    let (plain, peak) = if is_even {
        let of_one = match column {
            SteppedColumn::Position => 1.0 / (interval_s * interval_s),
            SteppedColumn::Speed => std::f64::consts::SQRT_2 / interval_s,
        };
        (deviation * of_one, LARGEST * deviation * of_one)
    } else {
        let variances = variances(time, column);
        let sizes: Vec<f64> = variances.iter().map(|(variance, _)| deviation * variance.sqrt()).collect();
        (deviation * mean_over_time(variances.into_iter()), usual_largest(&sizes))
    };
    // Within a window the instants count as even.
    let [rms_rad_s2, largest] = match window_s.map(|window| 0.25 * rounded.smoothed(window)) {
        Some(smoothed) if smoothed < plain => [smoothed, LARGEST * smoothed],
        _ => [plain, peak],
    };
    let motion = rounded.motion();
    (largest > NOTABLE * motion).then(|| {
        rounded.made_up((largest, interval_s), motion, |smoothing_s| Spurious::Noise {
            deviation,
            rms_rad_s2,
            smoothing_s,
        })
    })
}

/// Returns the standard deviation of the white noise of a column that enters the torque itself; zero unless its largest values exceed
/// 5 % of the largest value.
pub(crate) fn noise_beside(time: &[f64], values: &[f64]) -> f64 {
    let deviation = noise(time, values, is_even(time, median_interval(time)));
    let most = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    if LARGEST * deviation > NOTABLE * most { deviation } else { 0.0 }
}

fn is_even(time: &[f64], interval_s: f64) -> bool {
    !intervals(time).any(|step| (step - interval_s).abs() > EVEN * interval_s)
}

fn noise(time: &[f64], values: &[f64], is_even: bool) -> f64 {
    if is_even { deviation(values) } else { deviation_at(time, values) }
}

/// Returns the variance of the acceleration between two rows for a unit variance of the values, and the time between the rows.
fn variances(time: &[f64], column: SteppedColumn) -> Vec<(f64, f64)> {
    match column {
        SteppedColumn::Position => time
            .windows(4)
            .filter_map(|near| {
                let [t0, t1, t2, t3] = <[f64; 4]>::try_from(near).ok()?;
                let factors = factors_of_positions(factors_of_differences([t1 - t0, t2 - t1, t3 - t2]));
                Some((factors.iter().map(|factor| factor * factor).sum(), t2 - t1))
            })
            .collect(),
        SteppedColumn::Speed => intervals(time).map(|step| (2.0 / (step * step), step)).collect(),
    }
}

/// Returns the amount that one of some normally distributed values of given standard deviations exceeds on average: of different
/// deviations the largest ones decide, however rare.
///
/// Σ P(|N(0, σ_i)| > x) = 1
///
/// # Source
/// Birnbaum's and Sampford's bound of the tail, P(|N(0, 1)| > z) ≤ 8 φ(z)/(3 z + √(z² + 8)), above it by 0.3 % at most from z = 1 on
fn usual_largest(deviations: &[f64]) -> f64 {
    let tail = |z: f64| {
        let density = (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt();
        8.0 * density / (3.0 * z + z.hypot(8.0_f64.sqrt()))
    };
    let exceeding = |level: f64| {
        deviations.iter().filter(|deviation| **deviation > 0.0).map(|deviation| tail(level / deviation)).sum::<f64>()
    };
    let most = deviations.iter().fold(0.0_f64, |most, deviation| most.max(*deviation));
    // Ten deviations are exceeded once in 10²³ values.
    let (mut low, mut high) = (0.0, 10.0 * most);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        *(if exceeding(middle) > 1.0 { &mut low } else { &mut high }) = middle;
    }
    high
}

/// Returns the root of the mean of squares over their times.
fn mean_over_time(squares: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (sum, whole) = squares.fold((0.0, 0.0), |(sum, whole), (square, step)| (sum + square * step, whole + step));
    if whole > 0.0 { (sum / whole).sqrt() } else { 0.0 }
}

/// Returns the factors of the differences y_0 − y_1, y_2 − y_1 and y_3 − y_2 of four positions in the acceleration between the
/// middle two, (ω_2 − ω_1)/b with the slopes of the parabolas through three rows, by the three time steps a, b, c.
fn factors_of_differences([a, b, c]: [f64; 3]) -> [f64; 3] {
    let (first, last) = (1.0 / (a * (a + b)), 1.0 / (c * (b + c)));
    [first, (c / (b + c) - a / (a + b)) / (b * b), last]
}

/// Returns the factors of the four positions.
fn factors_of_positions([first, turned, last]: [f64; 3]) -> [f64; 4] {
    [first, -turned - first, turned - last, last]
}

/// Largest deviation of a time step from the usual one of evenly spaced samples, relative to it.
const EVEN: f64 = 0.01;

/// Largest of some thousand normally distributed values, in standard deviations.
const LARGEST: f64 = 3.5;

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
    let found = (excess, median_interval(time));
    (excess > EXCESS * motion).then(|| rounded.made_up(found, motion, |smoothing_s| Spurious::Updates { smoothing_s }))
}

/// A column with errors of up to half a step.
struct Rounded<'s> {
    time: &'s [f64],
    values: &'s [f64],
    column: SteppedColumn,
    /// Twice the largest error of a value.
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

    /// Returns the largest spurious acceleration between two rows, for a motion with a largest acceleration of its own, and
    /// the usual time step where it occurs \[s\].
    ///
    /// At each row it is at most the effect of half a step on each sample in the formula of the acceleration, and at most
    /// the acceleration found there plus that of the motion: rows that are close to each other by chance mostly have the
    /// same rounding error.
    fn between_rows(&self, motion: f64) -> (f64, f64) {
        let (mut most, mut there) = (0.0_f64, 0.0);
        let mut see = |bound: f64, found: f64, interval: f64| {
            let spurious = bound.min(found.abs() + motion);
            if spurious > most * (1.0 + numeric::EQUAL) {
                (most, there) = (spurious, interval);
            }
        };
        match self.column {
            SteppedColumn::Speed => {
                for (time, values) in self.time.windows(2).zip(self.values.windows(2)) {
                    if let ([t0, t1], [y0, y1]) = (time, values) {
                        see(self.plain(t1 - t0), (y1 - y0) / (t1 - t0), t1 - t0);
                    }
                }
            }
            SteppedColumn::Position => {
                for (time, values) in self.time.windows(4).zip(self.values.windows(4)) {
                    let ([t0, t1, t2, t3], [y0, y1, y2, y3]) = (time, values) else { continue };
                    let differences = factors_of_differences([t1 - t0, t2 - t1, t3 - t2]);
                    let [first, turned, last] = differences;
                    let sum = factors_of_positions(differences).iter().map(|factor| factor.abs()).sum::<f64>();
                    let found = first * (y0 - y1) + turned * (y2 - y1) + last * (y3 - y2);
                    see(0.5 * self.step * sum, found, t2 - t1);
                }
            }
        }
        let near = |interval: &f64| *interval <= ALIKE * there && ALIKE * *interval >= there;
        (most, upper_median(intervals(self.time).filter(near)).unwrap_or(there))
    }

    /// Returns the largest acceleration of the motion: the distance of the samples in time is doubled, from the shortest
    /// usual time step on, until the steps are a tenth of the motion between them.
    fn motion(&self) -> f64 {
        let shortest = nth_smallest(intervals(self.time), self.time.len() / RARE).unwrap_or(0.0);
        let duration = self.time.first().zip(self.time.last()).map_or(0.0, |(first, last)| last - first);
        let mut apart = shortest;
        loop {
            let found = largest_acceleration(self.time, self.values, self.column, apart);
            if 2.0 * self.plain(apart) <= 0.1 * found || 6.0 * apart >= duration {
                break found;
            }
            apart *= 2.0;
        }
    }

    /// Returns the spurious acceleration at a time step with the window that reduces it.
    fn made_up(
        &self,
        (acceleration, interval_s): (f64, f64),
        motion: f64,
        cause: impl Fn(Option<f64>) -> Spurious,
    ) -> MadeUp {
        let ratio = self.smoothed(1.0) / (NOTABLE * motion);
        let wanted = match self.column {
            SteppedColumn::Position => ratio.sqrt(),
            SteppedColumn::Speed => ratio,
        };
        let duration = self.time.first().zip(self.time.last()).map_or(0.0, |(first, last)| last - first);
        // Slightly more than an even multiple of the usual time step, so that the window contains the same number of
        // samples almost everywhere: at least seven, and at sparse rows four, which smoothing requires.
        let h = median_interval(self.time);
        let half = (0.5 * wanted).max(fourth(self.time));
        let half = (half / h).ceil().max(3.0);
        let window = (2.0 * half + 0.5) * h;
        let shortest = nth_smallest(intervals(self.time), self.time.len() / RARE).unwrap_or(h);
        let is_short = window <= 0.1 * duration
            && 0.5 * window <= 5000.0 * shortest
            && self.window_s.is_none_or(|given| given < window);
        MadeUp {
            column: self.column,
            cause: cause(is_short.then_some(window)),
            interval_s,
            acceleration_rad_s2: acceleration,
            motion_rad_s2: motion,
        }
    }
}

/// Returns the largest distance of a row from the third nearest one beside it \[s\]: half a window that contains four
/// samples everywhere.
fn fourth(time: &[f64]) -> f64 {
    let row = |index: usize| time.get(index).copied();
    let nearest = |(index, t): (usize, &f64)| {
        let firsts = index.saturating_sub(3)..=index;
        let ends = firsts.filter_map(|first| Some((row(first)?, row(first + 3)?)));
        ends.map(|(first, last)| (t - first).max(last - t)).fold(f64::INFINITY, f64::min)
    };
    time.iter().enumerate().map(nearest).fold(0.0, f64::max)
}

/// Share of the time steps, as its inverse, that may be shorter than the shortest usual one.
const RARE: usize = 100;

/// Ratio up to which two time steps are of one kind.
const ALIKE: f64 = 1.5;

/// Returns the time steps \[s\].
fn intervals(time: &[f64]) -> impl Iterator<Item = f64> + Clone {
    time.iter().zip(time.iter().skip(1)).map(|(one, other)| other - one)
}

/// Returns the largest acceleration between samples, each with the first one that is later by `apart` \[s\]: of equally
/// spaced ones every so many rows [rad/s²].
fn largest_acceleration(time: &[f64], values: &[f64], column: SteppedColumn, apart: f64) -> f64 {
    let apart = apart * (1.0 - LATER);
    let (mut first, mut second) = (0_usize, 0_usize);
    let mut most = 0.0_f64;
    let point = |index: usize| time.get(index).copied().zip(values.get(index).copied());
    for (t0, y0) in time.iter().copied().zip(values.iter().copied()) {
        while time.get(first).is_some_and(|t| t - t0 < apart) {
            first += 1;
        }
        let Some((t1, y1)) = point(first) else { break };
        let alpha = match column {
            SteppedColumn::Speed => (y1 - y0) / (t1 - t0),
            SteppedColumn::Position => {
                while time.get(second).is_some_and(|t| t - t1 < apart) {
                    second += 1;
                }
                let Some((t2, y2)) = point(second) else { break };
                2.0 * ((y2 - y1) / (t2 - t1) - (y1 - y0) / (t1 - t0)) / (t2 - t0)
            }
        };
        most = most.max(alpha.abs());
    }
    most
}

/// Share of a distance of samples by which they may be closer: the rounding of their instants.
const LATER: f64 = 1e-6;

#[cfg(test)]
#[path = "resolution_tests.rs"]
mod tests;

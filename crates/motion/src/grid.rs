//! Grid of recorded values: the step of an encoder or a converter behind the rounding of the file.

/// Rounding error of a value, relative to the largest: 64 units in the last place.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Rounding error of a value with single precision, relative to the largest: two units in the last place.
const SINGLE: f64 = 2.0 * f32::EPSILON as f64;

/// Error of the difference of two values, relative to the largest.
const DIFFERENCE: f64 = 8.0 * f64::EPSILON;

/// Smallest step relative to the rounding error.
pub(crate) const STEP_LEAST: f64 = 16.0;

/// Permitted deviation of a difference from a multiple of the step, relative to the step.
const STEP_SLACK: f64 = 0.05;

/// Smallest ratio of the step to the rounding of the values; below it both are one.
const RATIO_LEAST: f64 = 1.25;

/// Ratio of two steps above which the larger one is another step.
const CLEARLY: f64 = 1.01;

/// Number of changes of the values that show whether they have a grid.
const LEVELS_FEW: usize = 256;

/// Smallest divisor of values that are rounded to it, relative to the largest value.
const FINEST: f64 = 1e-10;

/// Smallest number of levels on which a step is sought.
const LEVELS_LEAST: usize = 8;

/// Largest number of levels that are compared.
const LEVELS_MOST: usize = 20_000;

/// Number of levels on which a step is sought; further ones confirm it.
const SOUGHT_ON: usize = 24;

/// Mean distance of levels in units of the rounding above which a step below twice the rounding is not sought.
const SPARSE: f64 = 8.0;

/// Largest number of steps between the two levels with the smallest distance.
const APART_MOST: f64 = 32.0;

/// Largest number of steps that are tried.
const TRIED_MOST: f64 = 20_000.0;

/// Largest deviation of a level from the fitted grid in units of the rounding while the stretch grows.
const OFF_WHILE_GROWING: f64 = 0.9;

/// Returns the largest deviation of levels from the fitted grid in units of the rounding: a half by the rounding itself, and
/// the uncertainty of the fit.
fn off_most(levels: f64) -> f64 {
    0.5 + 1.5 / levels.sqrt()
}

/// Natural logarithm of the probability, negative, with which levels lie on a grid by chance.
const CHANCE: f64 = 16.0;

/// Grid of the values of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    /// Step; zero if there is none.
    pub(crate) step: f64,
    /// Step to which the multiples of the step are rounded in the file, if it is known, otherwise zero.
    pub(crate) rounded: f64,
}

impl Grid {
    /// Finds the grid of a column: multiples of a step, rounded to a smaller one, or else the largest number of which all
    /// differences of adjacent values are multiples.
    pub(crate) fn of(values: &[f64]) -> Self {
        let most = values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let common = || Self { step: common_step(values, most), rounded: 0.0 };
        let (least, single) = (ROUNDING * most, SINGLE * most);
        let divisor = |levels: &Levels| levels.divisor(DIFFERENCE * most).filter(|exact| *exact >= FINEST * most);
        let pairs = values.iter().zip(values.iter().skip(1));
        let changes = pairs.filter(|(one, other)| one != other).map(|(_, other)| *other);
        // Values of noise and of smooth courses have no grid, which a few of them show.
        let spread = changes.clone().count().div_ceil(LEVELS_FEW).max(1);
        let few = Levels::of(changes.clone().step_by(spread), least);
        if divisor(&few).is_none() && few.step(least).or_else(|| few.step(single)).is_none() {
            return common();
        }
        let levels = Levels::of(values.first().copied().into_iter().chain(changes).take(LEVELS_MOST), least);
        let exact = divisor(&levels);
        let found = exact.map(|step| Self { step, rounded: 0.0 });
        let found = [exact.unwrap_or(least), single].into_iter().fold(found, |found, rounded| {
            let step = levels.step(rounded).filter(|step| found.is_none_or(|found| *step > CLEARLY * found.step));
            step.map(|step| Self { step, rounded }).or(found)
        });
        found.unwrap_or_else(common)
    }

    /// Returns twice the largest error of a value.
    pub(crate) fn error(&self) -> f64 {
        self.step + self.rounded
    }
}

/// Returns the largest number of which all differences of adjacent values are multiples; zero if there is none.
fn common_step(values: &[f64], most: f64) -> f64 {
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

/// Number with a bound of its error.
#[derive(Clone, Copy)]
struct Inexact {
    value: f64,
    error: f64,
}

impl Inexact {
    /// Returns the distance to the nearest multiple of another number, and which multiple it is.
    fn modulo(self, other: Self) -> (Self, f64) {
        let times = (self.value / other.value).round();
        let value = (self.value - times * other.value).abs();
        (Self { value, error: self.error + times * other.error }, times)
    }

    fn is_zero(self) -> bool {
        self.value <= 3.0 * self.error
    }
}

/// Different values of a column, in ascending order.
struct Levels(Vec<f64>);

impl Levels {
    /// Collects the values that differ by more than a rounding error.
    fn of(values: impl Iterator<Item = f64>, least: f64) -> Self {
        let mut levels: Vec<f64> = values.collect();
        levels.sort_unstable_by(f64::total_cmp);
        levels.dedup_by(|later, kept| *later - *kept <= least);
        Self(levels)
    }

    fn gaps(&self) -> impl Iterator<Item = f64> + Clone {
        self.0.iter().zip(self.0.iter().skip(1)).map(|(one, other)| other - one)
    }

    /// Returns the largest number of which all levels are multiples up to their rounding error, by Euclid's algorithm
    /// with its error.
    fn divisor(&self, error: f64) -> Option<f64> {
        let mut gaps: Vec<f64> = self.gaps().collect();
        gaps.sort_unstable_by(f64::total_cmp);
        let mut divisor = Inexact { value: *gaps.first()?, error };
        let (count, mut unclear) = (gaps.len(), 0_usize);
        for gap in gaps {
            let (rest, times) = Inexact { value: gap, error }.modulo(divisor);
            if rest.error > STEP_SLACK * divisor.value {
                unclear += 1;
                continue;
            }
            if rest.is_zero() {
                if error < times * divisor.error {
                    divisor = Inexact { value: gap / times, error: error / times };
                }
                continue;
            }
            let (mut larger, mut smaller) = (divisor, rest);
            while !smaller.is_zero() {
                (larger, smaller) = (smaller, larger.modulo(smaller).0);
            }
            divisor = larger;
            if divisor.error > STEP_SLACK * divisor.value {
                return None;
            }
        }
        (2 * unclear <= count).then_some(divisor.value)
    }

    /// Returns the step of which all levels are multiples, each rounded by up to half of `rounded`; `None` if there is no
    /// such step that is clearly larger than the rounding.
    ///
    /// Levels that differ lie at least (n − 1) q − p apart, so that q ≤ (span + p)/(n − 1). The smallest distance is g = m q ± p
    /// with a whole number m, so that only q = (g ± p)/m are tried, closely enough for the levels of the densest stretch.
    ///
    /// # Symbols
    /// n number of levels, q step, p rounding
    /// # Source
    /// docs/theory/recorded-motion.md
    fn step(&self, rounded: f64) -> Option<f64> {
        let levels = &self.0;
        if levels.len() < LEVELS_LEAST || rounded <= 0.0 {
            return None;
        }
        let smallest = self.gaps().fold(f64::INFINITY, f64::min);
        let densest = |count: usize| {
            let spans = levels.windows(count).enumerate().filter_map(|(index, window)| {
                let (first, last) = window.first().zip(window.last())?;
                Some((index, last - first))
            });
            spans.min_by(|one, other| one.1.total_cmp(&other.1))
        };
        let most = [2, 4, 8, 16, SOUGHT_ON, levels.len()]
            .into_iter()
            .filter_map(|count| Some((densest(count)?.1 + rounded) / (count.checked_sub(1).filter(|n| *n > 0)? as f64)))
            .fold(f64::INFINITY, f64::min);
        let least = RATIO_LEAST * rounded;
        if most < least {
            return None;
        }
        let (start, span) = densest(SOUGHT_ON.min(levels.len()))?;
        let window = start..start + SOUGHT_ON.min(levels.len());
        let gaps: Vec<f64> = self.gaps().skip(start).take(window.len().saturating_sub(1)).collect();
        // Of a step below twice the rounding only levels next to each other are evidence.
        let is_dense = span <= SPARSE * rounded * window.len() as f64;
        let least = if is_dense { least } else { least.max(2.0 * rounded) };
        let mut tried = 0.0;
        let mut times = 1.0;
        while times <= APART_MOST && (smallest + rounded) / times >= least {
            let (low, high) = (((smallest - rounded) / times).max(least), ((smallest + rounded) / times).min(most));
            times += 1.0;
            if low > high {
                continue;
            }
            // A step that is off by this is off by a twentieth of itself at the end of the stretch.
            let close = 0.05 * low * low / span;
            let count = ((high - low) / close).ceil().max(1.0);
            tried += count;
            if tried > TRIED_MOST {
                return None;
            }
            let mut index = 0.0;
            while index <= count {
                let step = high - (high - low) * index / count;
                index += 1.0;
                if is_near(&gaps, step, rounded)
                    && let Some(step) = self.confirmed(window.clone(), step, rounded)
                {
                    return Some(step);
                }
            }
        }
        None
    }

    /// Returns the step by least squares through all levels if they lie on its grid and not by chance; the stretch grows by
    /// a quarter on either side until it contains all.
    fn confirmed(&self, window: std::ops::Range<usize>, step: f64, rounded: f64) -> Option<f64> {
        let levels = &self.0;
        let origin = *levels.get(window.start)?;
        let (mut window, mut step, mut offset) = (window, step, 0.0);
        let mut is_first = true;
        loop {
            let (mut place, mut last) = (0.0, origin);
            let mut places = Vec::with_capacity(window.len());
            for level in levels.get(window.clone())? {
                let next = if is_first {
                    // Next to each other the levels follow from their distance, whatever the offset.
                    let by = ((level - last) / step).round();
                    place + if level > &last { by.max(1.0) } else { 0.0 }
                } else {
                    ((level - origin - offset) / step).round()
                };
                if places.last().is_some_and(|before: &f64| next <= *before) {
                    return None;
                }
                (place, last) = (next, *level);
                places.push(next);
            }
            let points = || places.iter().zip(levels.get(window.clone()).unwrap_or_default());
            let n = places.len() as f64;
            let [mean_k, mean_y] =
                points().fold([0.0; 2], |[k, y], (place, level)| [k + place / n, y + (level - origin) / n]);
            let about = || points().map(|(place, level)| (place - mean_k, level - origin - mean_y));
            let fitted = about().map(|(k, y)| k * y).sum::<f64>() / about().map(|(k, _)| k * k).sum::<f64>();
            if fitted.is_nan() || fitted <= 0.0 {
                return None;
            }
            step = fitted;
            offset = mean_y - step * mean_k;
            let off = about().fold(0.0_f64, |most, (k, y)| most.max((y - step * k).abs()));
            let is_whole = window.len() == levels.len();
            if off > rounded * if is_whole { off_most(n) } else { OFF_WHILE_GROWING } {
                return None;
            }
            if is_whole {
                let is_no_chance = n * (step / (2.0 * off_most(n) * rounded)).ln() >= CHANCE;
                return (is_no_chance && step >= RATIO_LEAST * rounded).then_some(step);
            }
            let by = (window.len() / 4).max(1);
            window = window.start.saturating_sub(by)..(window.end + by).min(levels.len());
            is_first = false;
        }
    }
}

/// Returns `true` if levels at these distances lie near a grid.
fn is_near(gaps: &[f64], step: f64, rounded: f64) -> bool {
    let (mut low, mut high, mut at) = (0.0_f64, 0.0_f64, 0.0_f64);
    let most = rounded / step + 0.15;
    for gap in gaps {
        let steps = gap / step;
        at += steps - steps.round().max(1.0);
        (low, high) = (low.min(at), high.max(at));
        if high - low > most {
            return false;
        }
    }
    true
}

#[cfg(test)]
#[path = "grid_tests.rs"]
mod tests;

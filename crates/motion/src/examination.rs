//! Examination of recorded columns: time stamps that scatter although the rows are evenly spaced, and values held over
//! several rows.

use crate::held::{held, interpolated_position};
use crate::timing::{Even, scattered};

/// Time stamps of a recording, judged by signals sampled with them.
#[derive(Clone, Debug, PartialEq)]
pub enum Stamps {
    /// The stamps are the instants of the samples: they are even, or the signals follow them.
    Kept,
    /// The stamps scatter about evenly spaced instants, which the signals follow.
    Scattered(EvenRows),
    /// The stamps scatter, and the signals do not show which instants they follow.
    Undecided {
        /// Standard deviation of the stamps from evenly spaced instants \[s\].
        scatter_s: f64,
        /// Interval of these instants \[s\].
        interval_s: f64,
    },
}

/// Evenly spaced instants of rows whose stamps scatter.
#[derive(Clone, Debug, PartialEq)]
pub struct EvenRows {
    /// Instants in the time of the stamps \[s\].
    pub time_s: Vec<f64>,
    /// Interval of the rows \[s\].
    pub interval_s: f64,
    /// Standard deviation of the stamps from these instants \[s\].
    pub scatter_s: f64,
}

/// Largest deviation of the share, with twice its standard deviation, from that of even or of stamped instants. A choice.
const DECIDED: f64 = 0.3;

/// Number of rows on each side over which the rate of a signal is taken.
const RATE: usize = 4;

/// Number of rows of a block, and smallest number of blocks, whose scatter gives the standard deviation of the share.
const BLOCK: usize = 16;
const BLOCKS_LEAST: usize = 8;

/// Weights of a fourth difference.
const FOURTH: [f64; 5] = [1.0, -4.0, 6.0, -4.0, 1.0];

impl Stamps {
    /// Judges stamps by the first of several signals that shows which instants the samples follow.
    ///
    /// Δ⁴y = s Δ⁴(ẏ e) by least squares: s = 0 for even instants, 1 for those of the stamps
    ///
    /// # Symbols
    /// y signal, ẏ its rate over eight rows, e deviation of a stamp from the even instant \[s\], Δ⁴ fourth difference
    /// over adjacent rows
    /// # Source
    /// docs/theory/recorded-motion.md
    /// # Valid
    /// the deviations are independent of the motion
    #[must_use]
    pub fn of(time_s: &[f64], signals: &[&[f64]]) -> Self {
        let Some(even) = scattered(time_s) else { return Self::Kept };
        let (scatter_s, interval_s) = (even.scatter_s, even.interval_s);
        for [share, deviation] in signals.iter().filter_map(|signal| share(time_s, &even, signal)) {
            let is_near = |at: f64| (share - at).abs() + 2.0 * deviation < DECIDED;
            if is_near(1.0) {
                return Self::Kept;
            }
            if is_near(0.0) {
                let time_s = even.time_s.iter().map(|t| even.start_s + t).collect();
                return Self::Scattered(EvenRows { time_s, interval_s, scatter_s });
            }
        }
        Self::Undecided { scatter_s, interval_s }
    }
}

/// Returns the share of the deviations of the stamps that a signal follows, and its standard deviation; of values held over
/// rows only those of their changes.
fn share(time_s: &[f64], even: &Even, signal: &[f64]) -> Option<[f64; 2]> {
    let period = held(time_s, signal);
    let rows: Vec<[f64; 3]> =
        even.time_s.iter().zip(time_s).zip(signal).map(|((t, stamp), y)| [*t, *stamp, *y]).collect();
    let changes = || {
        rows.windows(2)
            .filter_map(|pair| if let [[.., a], now @ [.., b]] = pair { (a != b).then_some(*now) } else { None })
    };
    let (rows, adjacent) = match period {
        Some(period) => (changes().collect(), 4.5 * period),
        None => (rows, 4.5 * even.interval_s),
    };
    let shifted = |k: usize| {
        let [t, stamp, _] = rows.get(k)?;
        let [[ta, _, a], [tb, _, b]] =
            [k.saturating_sub(RATE), (k + RATE).min(rows.len() - 1)].map(|k| rows.get(k).copied().unwrap_or_default());
        Some((b - a) / (tb - ta) * (stamp - even.start_s - t))
    };
    let shifted: Vec<f64> = (0..rows.len()).map(shifted).collect::<Option<_>>()?;
    let fourth =
        |five: &mut dyn Iterator<Item = f64>| five.zip(FOURTH).map(|(value, weight)| weight * value).sum::<f64>();
    let pairs: Vec<[f64; 2]> = rows
        .windows(5)
        .zip(shifted.windows(5))
        .filter(|(rows, _)| matches!(rows, [[first, ..], .., [last, ..]] if last - first < adjacent))
        .map(|(rows, shifted)| [fourth(&mut rows.iter().map(|[.., y]| *y)), fourth(&mut shifted.iter().copied())])
        .collect();
    let sums =
        |pairs: &[[f64; 2]]| pairs.iter().fold([0.0; 2], |[product, square], [y, x]| [product + x * y, square + x * x]);
    let [product, square] = sums(&pairs);
    let share = product / square;
    // Fourth differences overlap, and steps correlate: blocks are independent.
    let blocks = pairs.chunks(BLOCK).map(sums);
    let moving = blocks.clone().filter(|[_, square]| *square > 0.0).count();
    let variance = blocks.map(|[product, square]| (product - share * square).powi(2)).sum::<f64>() / (square * square);
    (share.is_finite() && moving >= BLOCKS_LEAST).then(|| [share, variance.sqrt()])
}

/// Smallest period of updates in rows: one value for each row is none that is held, although a dead stretch repeats it. A choice.
const HELD_LEAST: f64 = 1.25;

/// A column whose values are held over several rows, with one value for each update.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldSignal {
    /// Period at which the values are updated \[s\].
    pub period_s: f64,
    /// Values at the rows; between two updates their slope is straight.
    pub values: Vec<f64>,
    /// Values at the updates.
    pub updated: Vec<f64>,
}

impl HeldSignal {
    /// Returns the updates of a column; `None` if its values are not held over rows.
    #[must_use]
    pub fn of(time_s: &[f64], values: &[f64]) -> Option<Self> {
        let period_s = held(time_s, values)?;
        let row_s = (time_s.last()? - time_s.first()?) / (time_s.len() as f64 - 1.0);
        if period_s < HELD_LEAST * row_s {
            return None;
        }
        let found = interpolated_position(time_s, values)?;
        Some(Self { period_s, values: found.position, updated: found.updated })
    }
}

#[cfg(test)]
#[path = "examination_tests.rs"]
mod tests;

//! Ticks at 1, 2 and 5 times a power of ten.

use quantities::{Language, format_number, grouped};

/// Largest magnitude of data on an axis; differences of larger values would overflow.
pub(crate) const LARGEST: f64 = 1e290;
/// Smallest range; a smaller one is empty.
const SMALLEST: f64 = 1e-280;
/// Ratio of range to values below which the digits no longer show the range.
const RESOLUTION: f64 = 1e-9;

/// Ticks of one axis.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    pub(crate) values: Vec<f64>,
    pub(crate) minor: Vec<f64>,
    /// Power of ten taken out of the labels.
    pub(crate) exponent: i32,
    decimals: usize,
}

impl Ticks {
    /// Creates the ticks of a range, with at most `most` steps. `widen` moves the ends of the range out to the next
    /// tick.
    pub(crate) fn new(lo: f64, hi: f64, most: usize, widen: bool) -> Self {
        let (lo, hi) = spread(lo, hi);
        let most = most.clamp(1, 100);
        let (mantissa, power) = step((hi - lo) / count(most));
        let at = |index: f64| multiple(index * mantissa, power);
        let (first, last) = (place(lo, mantissa, power), place(hi, mantissa, power));
        let (first, last) = if widen {
            ((first + 1e-6).floor(), (last - 1e-6).ceil())
        } else {
            ((first - 1e-6).ceil(), (last + 1e-6).floor())
        };
        let steps = (last - first).clamp(0.0, 200.0);
        let values: Vec<f64> = (0..=200_u8)
            .map(f64::from)
            .take_while(|i| *i <= steps)
            .map(|i| at(first + i))
            .filter(|_| last >= first)
            .collect();
        let (lo, hi) = if widen { (at(first), at(last)) } else { (lo, hi) };
        let exponent = taken_out(lo.abs().max(hi.abs()));
        let parts = if mantissa > 1.5 && mantissa < 3.0 { 4.0 } else { 5.0 };
        let minor = (-1..=200_i16)
            .map(f64::from)
            .take_while(|i| *i <= steps)
            .flat_map(|i| (1..5_u8).map(move |k| i + f64::from(k) / parts))
            .filter(|i| i.fract() != 0.0)
            .map(|i| at(first + i))
            .filter(|value| (lo..=hi).contains(value))
            .collect();
        let decimals = usize::try_from(exponent - power).unwrap_or(0).min(17);
        Self { lo, hi, values, minor, exponent, decimals }
    }

    pub(crate) fn label(&self, value: f64, language: Language) -> String {
        let decimals = if value == 0.0 { 0 } else { self.decimals };
        grouped(&format_number(multiple(value, -self.exponent), decimals, language))
    }
}

/// Returns a range that is not empty: equal ends are moved apart, with zero included.
fn spread(lo: f64, hi: f64) -> (f64, f64) {
    let (lo, hi) = (lo.clamp(-LARGEST, LARGEST), hi.clamp(-LARGEST, LARGEST));
    let (lo, hi) = if lo <= hi { (lo, hi) } else { (hi, lo) };
    let largest = lo.abs().max(hi.abs());
    if largest < SMALLEST {
        return (0.0, 1.0);
    }
    if hi - lo > largest * RESOLUTION {
        return (lo, hi);
    }
    (0.1_f64.mul_add(-largest, lo), 0.1_f64.mul_add(largest, hi))
}

/// Returns 1, 2 or 5 and a power of ten, whose product is at least `least`.
fn step(least: f64) -> (f64, i32) {
    let power = exponent_of(least);
    let relative = multiple(least, -power);
    let limit = relative * (1.0 - 1e-9);
    [1.0, 2.0, 5.0].into_iter().find(|m| *m >= limit).map_or((1.0, power + 1), |m| (m, power))
}

/// Returns the exponent in scientific notation.
fn exponent_of(value: f64) -> i32 {
    let text = format!("{:e}", value.abs());
    text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// Returns `value`·10^`power`; divides for negative powers, because 10⁻¹ is not exact and 10 is.
fn multiple(value: f64, power: i32) -> f64 {
    if power < -300 {
        value / 10_f64.powi(300) / 10_f64.powi(-(power + 300))
    } else if power < 0 {
        value / 10_f64.powi(-power)
    } else {
        value * 10_f64.powi(power)
    }
}

fn place(value: f64, mantissa: f64, power: i32) -> f64 {
    multiple(value, -power) / mantissa
}

/// Returns the power of ten that an axis writes next to its unit, a multiple of three; zero between 0.01 and 100 000.
fn taken_out(largest: f64) -> i32 {
    if largest == 0.0 || (0.01..1e5).contains(&largest) { 0 } else { exponent_of(largest).div_euclid(3) * 3 }
}

#[expect(clippy::cast_precision_loss, reason = "a count of ticks is small")]
const fn count(number: usize) -> f64 {
    number as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &Ticks, language: Language) -> Vec<String> {
        ticks.values.iter().map(|value| ticks.label(*value, language)).collect()
    }

    #[test]
    fn plain_ranges() {
        let ticks = Ticks::new(0.0, 9.3, 5, true);
        assert_eq!(labels(&ticks, Language::En), ["0", "2", "4", "6", "8", "10"]);
        let ticks = Ticks::new(-0.13, 0.27, 5, true);
        assert_eq!(labels(&ticks, Language::De), ["−0,2", "−0,1", "0", "0,1", "0,2", "0,3"]);
        let ticks = Ticks::new(0.0, 3.2, 4, false);
        assert_eq!((ticks.lo, ticks.hi), (0.0, 3.2));
        assert_eq!(labels(&ticks, Language::En), ["0", "1", "2", "3"]);
    }

    #[test]
    fn large_and_small_values_take_out_a_power() {
        let ticks = Ticks::new(0.0, 2.4e9, 5, true);
        assert_eq!((ticks.exponent, labels(&ticks, Language::De).join(" ")), (9, "0 0,5 1,0 1,5 2,0 2,5".to_owned()));
        let ticks = Ticks::new(0.0, 4.2e-5, 5, true);
        assert_eq!((ticks.exponent, labels(&ticks, Language::En).join(" ")), (-6, "0 10 20 30 40 50".to_owned()));
    }

    #[test]
    fn no_span_still_gives_an_axis() {
        assert_eq!(labels(&Ticks::new(0.0, 0.0, 4, true), Language::En), ["0", "0.5", "1.0"]);
        let ticks = Ticks::new(7.0, 7.0, 4, true);
        assert!(ticks.lo < 7.0 && ticks.hi > 7.0);
    }

    #[test]
    fn ticks_are_few_ordered_and_nice_whatever_the_range() {
        arbtest::arbtest(|u| {
            let of = |mantissa: i32, power: i8| f64::from(mantissa) * 10_f64.powi(i32::from(power));
            let (a, b) = (of(u.arbitrary()?, u.arbitrary()?), of(u.arbitrary()?, u.arbitrary()?));
            let most = u.int_in_range(1..=20)?;
            let widen = u.arbitrary()?;
            let ticks = Ticks::new(a, b, most, widen);
            assert!(ticks.lo.is_finite() && ticks.hi.is_finite() && ticks.lo < ticks.hi, "{ticks:?}");
            assert!(ticks.values.len() <= most + 3, "{a} {b} {most} {ticks:?}");
            assert!(ticks.values.windows(2).all(|pair| pair[0] < pair[1]), "{ticks:?}");
            if widen {
                let (lo, hi) = (a.min(b), a.max(b));
                let slack = (ticks.hi - ticks.lo) * 1e-5;
                assert!(ticks.values.len() >= 2, "{ticks:?}");
                assert!(ticks.lo <= lo + slack && ticks.hi >= hi - slack, "{lo} {hi} {ticks:?}");
            }
            let labels = labels(&ticks, Language::En);
            assert!(labels.iter().all(|label| label.len() < 20), "{labels:?}");
            let mut distinct = labels.clone();
            distinct.dedup();
            assert_eq!(distinct, labels);
            Ok(())
        });
    }
}

//! Values of a range at a stated step: 30, 35 … 60.

/// Largest number of rows of a table.
pub const SAMPLES_MOST: u64 = 1_000_000;

/// Reason why a step does not divide a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unstepped {
    /// An end or the step is no decimal number, or the step is zero.
    NoNumber,
    /// Steps from the one end do not meet the other; the nearest steps that do, smaller and larger.
    Missed(Vec<String>),
    /// More values than a table has rows.
    TooMany,
}

/// Largest number of decimals of an end or a step.
const DECIMALS_MOST: usize = 12;

/// Digits of a number before its point.
const DIGITS_MOST: usize = 15;

/// Largest number of equal parts among which the nearest step is searched, in multiples of those of the stated one.
const SEARCH: i128 = 10;

/// A decimal number, exactly: digits × 10^−decimals.
#[derive(Clone, Copy, Debug)]
struct Decimal {
    digits: i128,
    decimals: usize,
}

impl Decimal {
    fn read(text: &str) -> Option<Self> {
        let text = text.trim();
        let (is_negative, plain) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.strip_prefix('+').unwrap_or(text)),
        };
        let (whole, part) = plain.split_once('.').unwrap_or((plain, ""));
        let all = format!("{whole}{part}");
        let is_number = !all.is_empty() && all.chars().all(|sign| sign.is_ascii_digit());
        if !is_number || whole.len() > DIGITS_MOST || part.len() > DECIMALS_MOST {
            return None;
        }
        let digits: i128 = all.parse().ok()?;
        Some(Self { digits: if is_negative { -digits } else { digits }, decimals: part.len() })
    }

    /// Returns the digits with at least so many decimals.
    fn with_decimals(self, decimals: usize) -> i128 {
        self.digits * 10_i128.pow(u32::try_from(decimals.saturating_sub(self.decimals)).unwrap_or(0))
    }
}

/// Returns a number without needless zeros.
fn written(digits: i128, decimals: usize) -> String {
    let sign = if digits < 0 { "-" } else { "" };
    let plain = format!("{:0>width$}", digits.unsigned_abs(), width = decimals + 1);
    let (whole, part) = plain.split_at(plain.len() - decimals);
    let part = part.trim_end_matches('0');
    if part.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
}

/// Returns the values of a range at a step, its ends included: exact decimal numbers. A range may fall; the sign of the step does not
/// matter.
///
/// # Errors
/// A step that does not divide the range.
pub fn stepped(low: &str, high: &str, step: &str) -> Result<Vec<String>, Unstepped> {
    let read = |text: &str| Decimal::read(text).ok_or(Unstepped::NoNumber);
    let (low, high, step) = (read(low)?, read(high)?, read(step)?);
    let decimals = low.decimals.max(high.decimals).max(step.decimals);
    let [first, last, step] = [low, high, step].map(|number| number.with_decimals(decimals));
    if step == 0 {
        return Err(Unstepped::NoNumber);
    }
    let (range, step) = (last - first, step.abs());
    if range % step != 0 {
        return Err(Unstepped::Missed(nearest(range.abs(), step, decimals)));
    }
    let parts = range.abs() / step;
    if parts >= i128::from(SAMPLES_MOST) {
        return Err(Unstepped::TooMany);
    }
    let towards = step * range.signum();
    Ok((0..=parts).map(|part| written(first + part * towards, decimals)).collect())
}

/// Returns the nearest smaller and the nearest larger step that divide a range and have few decimals.
fn nearest(range: i128, step: i128, decimals: usize) -> Vec<String> {
    // Steps with one decimal more are as legible.
    let (range, step, decimals) = (range * 100, step * 100, decimals + 2);
    let below = range / step;
    let divides = |parts: &i128| *parts > 0 && range % *parts == 0;
    let smaller = (below + 1..=(below + 1) * SEARCH).find(divides);
    let larger = (1..=below).rev().find(divides);
    smaller.into_iter().chain(larger).map(|parts| written(range / parts, decimals)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_exact_and_contain_both_ends() {
        assert_eq!(stepped("30", "60", "5").unwrap(), ["30", "35", "40", "45", "50", "55", "60"]);
        assert_eq!(stepped("0.1", "0.5", "0.1").unwrap(), ["0.1", "0.2", "0.3", "0.4", "0.5"]);
        assert_eq!(stepped("-0.2", "0.1", "0.1").unwrap(), ["-0.2", "-0.1", "0", "0.1"]);
        assert_eq!(stepped("3", "1", "1").unwrap(), ["3", "2", "1"]);
        assert_eq!(stepped("2", "2", "1").unwrap(), ["2"]);
    }

    #[test]
    fn a_step_that_misses_the_end_has_the_nearest_that_meet_it() {
        let missed = |low, high, step| match stepped(low, high, step) {
            Err(Unstepped::Missed(steps)) => steps,
            other => panic!("{other:?}"),
        };
        assert_eq!(missed("30", "60", "7"), ["6", "7.5"]);
        assert_eq!(missed("0", "10", "3"), ["2.5", "5"]);
        assert_eq!(missed("0", "0.5", "0.3"), ["0.25", "0.5"]);
        assert_eq!(missed("30", "60", "45"), ["30"]);
        for (low, high) in [("0", "7"), ("1.5", "9"), ("-3", "4.25")] {
            for step in ["0.7", "0.9", "1.3", "2.2", "5", "100"] {
                let Err(Unstepped::Missed(steps)) = stepped(low, high, step) else { continue };
                assert!(!steps.is_empty(), "{low} {high} {step}");
                for found in steps {
                    let values = stepped(low, high, &found).unwrap();
                    assert_eq!((values.first().unwrap().as_str(), values.last().unwrap().as_str()), (low, high));
                }
            }
        }
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for (low, high, step) in [("a", "1", "1"), ("0", "1", "0"), ("", "1", "1"), ("0", "1e3", "1"), ("0", "1", "-")]
        {
            assert_eq!(stepped(low, high, step), Err(Unstepped::NoNumber), "{low} {high} {step}");
        }
        assert_eq!(stepped("0", "1000000", "1"), Err(Unstepped::TooMany));
    }
}

//! Clock times in the notations of loggers: `2025-04-17T17:00:08.005`, `17.04.2025 17:00:08,005`, `17:00:08.005`.

use crate::number::Tick;

/// Seconds of a day.
const DAY_S: i64 = 86_400;

/// Reader of a column of clock times; times are counted from the first one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Clock {
    first: Option<Stamp>,
    last: Option<i64>,
    /// Days elapsed, counted at midnight if no date is written.
    days: i64,
}

/// An instant of a clock.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stamp {
    /// Seconds since 1970, or since midnight if no date is written.
    seconds: i64,
    /// Fraction of a second.
    part: f64,
    has_date: bool,
}

/// Returns `true` if a text is the time of a clock.
pub(crate) fn is_clock(text: &str) -> bool {
    read(text).is_some()
}

impl Clock {
    /// Returns the time of a cell; `None` if the text is no clock time.
    pub(crate) fn tick(&mut self, text: &str) -> Option<Tick> {
        let stamp = read(text)?;
        if let Some(last) = self.last
            && !stamp.has_date
            && stamp.seconds < last - DAY_S / 2
        {
            self.days += 1;
        }
        self.last = Some(stamp.seconds);
        let first = *self.first.get_or_insert(stamp);
        let seconds = stamp.seconds.checked_add(self.days * DAY_S)?.checked_sub(first.seconds)?;
        Some(Tick::of_parts(seconds, stamp.part - first.part))
    }
}

fn read(text: &str) -> Option<Stamp> {
    let text = text.trim();
    // Every clock time has a colon and no number has one, so most cells are decided here.
    let colon = text.find(':')?;
    let begin = text.get(..colon)?.rfind(|sign: char| !sign.is_ascii_digit()).map_or(0, |at| at + 1);
    let (date, time) = text.split_at_checked(begin)?;
    let date = date.trim_end_matches(['T', ' ', '_', '\u{a0}']);
    let days = if date.is_empty() { None } else { Some(days(date)?) };
    let (time, offset) = offset(time)?;
    let (time, afternoon) = match time.trim_end().to_ascii_uppercase() {
        time if time.ends_with("PM") => (time.trim_end_matches("PM").trim_end().to_owned(), Some(true)),
        time if time.ends_with("AM") => (time.trim_end_matches("AM").trim_end().to_owned(), Some(false)),
        time => (time, None),
    };
    let mut parts = time.splitn(3, ':');
    let (hour, minute, second) = (number(parts.next()?, 2)?, number(parts.next()?, 2)?, parts.next()?);
    let (whole, part) = match second.find(['.', ',']) {
        Some(at) => {
            let digits = second.get(at + 1..).filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()))?;
            (second.get(..at)?, format!("0.{digits}0").parse().ok()?)
        }
        None => (second, 0.0),
    };
    let whole = number(whole, 2)?;
    let hour = match afternoon {
        Some(_) if !(1..=12).contains(&hour) => return None,
        Some(true) => hour % 12 + 12,
        Some(false) => hour % 12,
        None => hour,
    };
    // A leap second counts as the first second of the next minute.
    if hour > 23 || minute > 59 || whole > 60 {
        return None;
    }
    let seconds = days.unwrap_or(0) * DAY_S + 3600 * hour + 60 * minute + whole - offset;
    Some(Stamp { seconds, part, has_date: days.is_some() })
}

/// Splits the offset from UTC off a time and returns it in seconds.
fn offset(time: &str) -> Option<(&str, i64)> {
    if let Some(time) = time.strip_suffix(['Z', 'z']) {
        return Some((time, 0));
    }
    let Some(at) = time.rfind(['+', '-', '−']) else { return Some((time, 0)) };
    let (time, offset) = time.split_at_checked(at)?;
    let digits = offset.trim_start_matches(['+', '-', '−']).replace(':', "");
    let sign = if offset.starts_with('+') { 1 } else { -1 };
    let (hours, minutes) = match digits.len() {
        2 => (number(&digits, 2)?, 0),
        4 => (number(digits.get(..2)?, 2)?, number(digits.get(2..)?, 2)?),
        _ => return None,
    };
    (hours <= 14 && minutes <= 59).then_some((time.trim_end(), sign * (3600 * hours + 60 * minutes)))
}

/// Returns the days since 1970 of a date: `2025-04-17`, `2025/04/17`, `17.04.2025`, `4/17/2025`.
fn days(date: &str) -> Option<i64> {
    let sign = ['-', '/', '.'].into_iter().find(|sign| date.contains(*sign))?;
    let mut parts = date.split(sign);
    let (first, second, third) = (parts.next()?, parts.next()?, parts.next()?);
    if parts.next().is_some() {
        return None;
    }
    let (year, month, day) = match (first.len(), sign) {
        (4, _) => (number(first, 4)?, number(second, 2)?, number(third, 2)?),
        (_, '/') => {
            // The month comes first unless the number is too large for one.
            let (one, other) = (number(first, 2)?, number(second, 2)?);
            let (month, day) = if one > 12 { (other, one) } else { (one, other) };
            (number(third, 4)?, month, day)
        }
        _ => (number(third, 4)?, number(second, 2)?, number(first, 2)?),
    };
    let is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let lengths = [31, if is_leap { 29 } else { 28 }, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let month = usize::try_from(month).ok()?.checked_sub(1)?;
    let length = *lengths.get(month)?;
    if year < 1900 || !(1..=length).contains(&day) {
        return None;
    }
    let before = |year: i64| 365 * year + year / 4 - year / 100 + year / 400;
    let in_year: i64 = lengths.iter().take(month).sum();
    Some(before(year - 1) - before(1969) + in_year + day - 1)
}

/// Parses a number of at most `most` digits.
fn number(digits: &str, most: usize) -> Option<i64> {
    let is_number = !digits.is_empty() && digits.len() <= most && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then(|| digits.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn since(first: &str, second: &str) -> f64 {
        let mut clock = Clock::default();
        assert_eq!(clock.tick(first).unwrap().value(), 0.0, "{first}");
        clock.tick(second).unwrap().value()
    }

    #[test]
    fn times_count_from_the_first() {
        for (first, second, expected) in [
            ("2025-04-17T17:00:08.000", "2025-04-17T17:00:08.005", 0.005),
            ("2025-04-17 17:00:08", "2025-04-17 18:00:08", 3600.0),
            ("2025-04-17T23:59:59.995Z", "2025-04-18T00:00:00.000Z", 0.005),
            ("2025-04-17T17:00:00+02:00", "2025-04-17T16:00:00+0000", 3600.0),
            ("17.04.2025 17:00:08,005", "17.04.2025 17:00:08,010", 0.005),
            ("4/17/2025 11:59:59.5 AM", "4/17/2025 12:00:00.5 PM", 1.0),
            ("17/04/2025 00:00:01", "18/04/2025 00:00:01", 86_400.0),
            ("2024/02/28 12:00:00", "2024/03/01 12:00:00", 2.0 * 86_400.0),
            ("1999-12-31 00:00:00", "2000-01-01 00:00:00", 86_400.0),
            ("10:30:20.000", "10:30:20.005", 0.005),
            ("23:59:59.9", "00:00:00.1", 0.2),
            ("9:00:00", "10:00:00", 3600.0),
        ] {
            assert!((since(first, second) - expected).abs() < 1e-9, "{first} {second}: {}", since(first, second));
        }
        // Nanoseconds are preserved for present-day times.
        assert!((since("2025-04-17T17:00:08.000000001", "2025-04-17T17:00:08.000000003") - 2e-9).abs() < 1e-16);
        assert_eq!(read("1970-01-01T00:00:00Z").unwrap().seconds, 0);
        assert_eq!(read("2000-03-01T00:00:00Z").unwrap().seconds, 951_868_800);
    }

    #[test]
    fn what_is_no_clock_time_is_none() {
        for text in [
            "",
            "12",
            "1.5",
            "12:30",
            "25:00:00",
            "10:61:00",
            "10:00:61",
            "2025-02-29 10:00:00",
            "2025-13-01 10:00:00",
            "a:b:c",
            "10:00:00.x",
            "2025-04-17",
            "x 10:00:00",
            "10:00:00 PM x",
            "13:00:00 PM",
            "::",
            "1:2:3:4",
            "10:00:00+99:00",
        ] {
            assert!(!is_clock(text), "{text}");
        }
    }
}

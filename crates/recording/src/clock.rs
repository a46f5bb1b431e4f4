//! Clock times in the notations of loggers: `2025-04-17T17:00:08.005`, `17.04.2025 17:00:08,005`, `17:00:08.005`,
//! `0 days 00:00:00.002`.

use crate::number::{Decimals, Tick, with_unit};
use chrono::NaiveDate;

/// Seconds of a day.
const DAY_S: i64 = 86_400;

/// Seconds of an hour.
const HOUR_S: i64 = 3600;

/// Reader of a column of clock times; times are counted from the first one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Clock {
    first: Option<Stamp>,
    last: Option<i64>,
    /// Seconds that the clock has started anew: at midnight if no date is written, at the full hour if no hour is.
    turned: i64,
    /// Order of day and month, one for the column, once a date shows it.
    order: Option<Order>,
    /// A date differs from the first one.
    has_turned: bool,
}

/// An instant of a clock.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stamp {
    /// Seconds since midnight.
    seconds: i64,
    /// Fraction of a second.
    part: f64,
    date: Option<Date>,
    /// Seconds after which the clock starts anew without a date: a day, or an hour for `mm:ss,0`.
    turn: i64,
}

/// A date.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Date {
    /// Days since 1970, or of a duration.
    Days(i64),
    /// Two numbers of which one is the month, and the year: `4/17/2025`.
    Slashed(i64, i64, i64),
}

/// Order of day and month in a date with slashes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    MonthFirst,
    DayFirst,
}

impl Date {
    /// Returns the order that the date shows: a number above 12 is no month.
    const fn order(self) -> Option<Order> {
        match self {
            Self::Slashed(13.., _, _) => Some(Order::DayFirst),
            Self::Slashed(_, 13.., _) => Some(Order::MonthFirst),
            _ => None,
        }
    }

    /// Returns the days since 1970; `None` for a date that does not exist.
    fn days(self, order: Order) -> Option<i64> {
        match (self, order) {
            (Self::Days(days), _) => Some(days),
            (Self::Slashed(month, day, year), Order::MonthFirst)
            | (Self::Slashed(day, month, year), Order::DayFirst) => days_of(year, month, day),
        }
    }
}

impl Stamp {
    /// Returns the seconds since 1970, or since midnight without a date.
    fn since(self, order: Order) -> Option<i64> {
        let days = self.date.map_or(Some(0), |date| date.days(order))?;
        days.checked_mul(DAY_S)?.checked_add(self.seconds)
    }
}

/// Returns `true` if a text is the time of a clock.
pub(crate) fn is_clock(text: &str) -> bool {
    let exists =
        |stamp: Stamp| [Order::MonthFirst, Order::DayFirst].into_iter().any(|order| stamp.since(order).is_some());
    read(text).is_some_and(exists)
}

/// Returns `true` if a text looks like the time of a clock in a form that is not known: `T#12ms`, `02:59`,
/// `2025-10-26_02-59-58`, `Oct 26, 2025 02:59:58`, `2025-10-26 02:59:58 CET`.
pub(crate) fn is_clock_of_unknown_form(text: &str) -> bool {
    /// Longest text of a time.
    const LONGEST: usize = 48;
    /// Number of digits of a date.
    const DIGITS_LEAST: usize = 8;
    let text = text.trim();
    let may_stand = |sign: char| sign.is_alphanumeric() || " :.,-_/#+[]()\u{a0}".contains(sign);
    let count = |is: fn(&char) -> bool| text.chars().filter(is).count();
    let (digits, letters) = (count(char::is_ascii_digit), count(|sign| sign.is_alphabetic()));
    if text.chars().count() > LONGEST || !text.chars().all(may_stand) || digits == 0 || letters > digits + 12 {
        return false;
    }
    // Literals of IEC 61131-3.
    const LITERALS: [&str; 9] = ["t#", "lt#", "time#", "ltime#", "tod#", "ltod#", "dt#", "ldt#", "d#"];
    let is_literal =
        || LITERALS.iter().any(|word| text.get(..word.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(word)));
    let is_digit = |sign: Option<&u8>| sign.is_some_and(u8::is_ascii_digit);
    let bytes = text.as_bytes();
    let has_colon = || {
        let colons = (1..bytes.len()).filter(|at| bytes.get(*at) == Some(&b':'));
        colons.into_iter().any(|at| is_digit(bytes.get(at - 1)) && is_digit(bytes.get(at + 1)))
    };
    let begins = |digits: usize, signs: &[u8]| {
        let date = bytes.get(..digits).is_some_and(|date| date.iter().all(u8::is_ascii_digit));
        date && bytes.get(digits).is_some_and(|sign| signs.contains(sign)) && is_digit(bytes.get(digits + 1))
    };
    let is_stamp = || {
        begins(8, b" _-T") || begins(4, b"-/.") && digits >= DIGITS_LEAST && text.matches(['-', '/', '.']).count() > 1
    };
    !is_clock(text)
        && !Decimals::is_number(text)
        && with_unit(text).is_none()
        && (is_literal() || has_colon() || is_stamp())
}

impl Clock {
    /// Returns the time of a cell; `None` if the text is no clock time, or if its date has another order of day and
    /// month than those before.
    pub(crate) fn tick(&mut self, text: &str) -> Option<Tick> {
        let stamp = read(text)?;
        let first = *self.first.get_or_insert(stamp);
        if let Some(shown) = stamp.date.and_then(Date::order) {
            // Dates read with the month first so far are those of one day, or their distance was wrong.
            let was_wrong = self.has_turned && self.order.is_none() && shown == Order::DayFirst;
            if was_wrong || *self.order.get_or_insert(shown) != shown {
                return None;
            }
        }
        self.has_turned |= stamp.date != first.date;
        let order = self.order.unwrap_or(Order::MonthFirst);
        let seconds = stamp.since(order)?;
        if let Some(last) = self.last
            && stamp.date.is_none()
            && seconds < last - stamp.turn / 2
        {
            self.turned += stamp.turn;
        }
        self.last = Some(seconds);
        let seconds = seconds.checked_add(self.turned)?.checked_sub(first.since(order)?)?;
        Some(Tick::of_parts(seconds, stamp.part - first.part))
    }
}

fn read(text: &str) -> Option<Stamp> {
    let text = text.trim();
    // Every clock time has a colon and no number has one, so most cells are decided here.
    let colon = text.find(':')?;
    let begin = text.get(..colon)?.rfind(|sign: char| !sign.is_ascii_digit()).map_or(0, |at| at + 1);
    let (date, time) = text.split_at_checked(begin)?;
    let date = date.trim_end_matches(['T', 't', ' ', '_', '\u{a0}', '+', ',']);
    let date = if date.is_empty() { None } else { Some(date_of(date)?) };
    let (time, offset) = offset(time)?;
    let (time, afternoon) = match time.trim_end().to_ascii_uppercase() {
        time if time.ends_with("PM") => (time.trim_end_matches("PM").trim_end().to_owned(), Some(true)),
        time if time.ends_with("AM") => (time.trim_end_matches("AM").trim_end().to_owned(), Some(false)),
        time => (time, None),
    };
    let parts: Vec<&str> = time.splitn(3, ':').collect();
    let (hour, minute, second) = match parts.as_slice() {
        [hour, minute, second] => (number(hour, 2)?, number(minute, 2)?, *second),
        // Spreadsheets show times as `mm:ss,0`; without a fraction it may be hours and minutes.
        [minute, second] if date.is_none() && afternoon.is_none() && second.contains(['.', ',']) => {
            // A stopwatch counts the minutes beyond an hour.
            (0, number(minute, 4)?, *second)
        }
        _ => return None,
    };
    let (whole, part) = match second.find(['.', ',', ';', ':']) {
        Some(at) => {
            let (whole, rest) = second.split_at_checked(at)?;
            let digits = rest.get(1..).filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()))?;
            let part = match rest.as_bytes().first()? {
                // Trends of Rockwell count milliseconds there, `10:11:12;2`.
                b';' => number(digits, 3)? as f64 * 1e-3,
                b':' if digits.len() != 3 => return None,
                _ => format!("0.{digits}0").parse().ok()?,
            };
            (whole, part)
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
    if hour > 23 || minute > 59 && parts.len() > 2 || whole > 60 {
        return None;
    }
    let seconds = 3600 * hour + 60 * minute + whole - offset;
    let turn = if parts.len() == 2 { HOUR_S } else { DAY_S };
    Some(Stamp { seconds, part, date, turn })
}

/// Splits the offset from UTC off a time and returns it in seconds.
fn offset(time: &str) -> Option<(&str, i64)> {
    if let Some(time) = time.strip_suffix(['Z', 'z']) {
        return Some((time, 0));
    }
    if let Some(time) = [" UTC", " GMT"].into_iter().find_map(|zone| time.strip_suffix(zone)) {
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

/// Months in the abbreviations of English and German.
const MONTHS: [&[&str]; 12] = [
    &["jan"],
    &["feb"],
    &["mar", "m\u{e4}r", "mrz"],
    &["apr"],
    &["may", "mai"],
    &["jun"],
    &["jul"],
    &["aug"],
    &["sep"],
    &["oct", "okt"],
    &["nov"],
    &["dec", "dez"],
];

/// Returns a date: `2025-04-17`, `2025/04/17`, `17.04.2025`, `17.04.25`, `17-Apr-2025`, `4/17/2025`, `17/4/25`, or the
/// days of a duration, `0 days`.
fn date_of(date: &str) -> Option<Date> {
    if let Some(days) = ["days", "day"].into_iter().find_map(|word| date.strip_suffix(word)) {
        let days = days.trim_end();
        let (sign, digits) = days.strip_prefix('-').map_or((1, days), |digits| (-1, digits));
        return number(digits, 6).map(|days| Date::Days(sign * days));
    }
    let sign = ['-', '/', '.'].into_iter().find(|sign| date.contains(*sign))?;
    let parts: Vec<&str> = date.split(sign).collect();
    let [first, second, third] = parts.as_slice() else { return None };
    // Two digits are a year of this century.
    let year = || match third.len() {
        2 => number(third, 2).map(|year| 2000 + year),
        4 => number(third, 4),
        _ => None,
    };
    let of = |year, month, day| days_of(year, month, day).map(Date::Days);
    match (first.len(), sign) {
        (4, _) => of(number(first, 4)?, number(second, 2)?, number(third, 2)?),
        (_, '/') => {
            let (one, other) = (number(first, 2)?, number(second, 2)?);
            Some(Date::Slashed(one, other, year()?))
        }
        (_, '.') => of(year()?, number(second, 2)?, number(first, 2)?),
        _ => {
            let name = second.to_lowercase();
            let named = MONTHS.iter().position(|names| names.contains(&name.trim_end_matches('.')));
            let month = match named {
                Some(month) => i64::try_from(month).ok()? + 1,
                None => number(second, 2)?,
            };
            let year = if named.is_some() { year()? } else { number(third, 4)? };
            of(year, month, number(first, 2)?)
        }
    }
}

/// Returns the days since 1970 of a day of the calendar.
fn days_of(year: i64, month: i64, day: i64) -> Option<i64> {
    let [month, day] = [month, day].map(u32::try_from);
    let date = NaiveDate::from_ymd_opt(i32::try_from(year).ok().filter(|year| *year >= 1900)?, month.ok()?, day.ok()?)?;
    Some(date.signed_duration_since(NaiveDate::default()).num_days())
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
            ("59:59.995", "60:00.000", 0.005),
            ("99:59.5", "100:00,5", 1.0),
            ("9:00:00", "10:00:00", 3600.0),
            ("0 days 00:00:00.002000", "1 days 00:00:00.004000", 86_400.002),
            ("-1 days +23:59:59.998", "0 days 00:00:00", 0.002),
            ("00:01,5", "00:02,0", 0.5),
            ("10:11:12;2", "10:11:12;402", 0.4),
            ("10:11:12:005", "10:11:12:010", 0.005),
            ("2025-03-14 23:59:58.000 UTC", "2025-03-15 00:00:00 UTC", 2.0),
            ("14.03.25 23:59:58,000", "15.03.25 00:00:00,000", 2.0),
            ("14-Mar-2025 23:59:58.000", "15-Mar-2025 00:00:00", 2.0),
            ("14-Mrz-2025 23:59:58.000", "1-Mai-2025 23:59:58", 48.0 * 86_400.0),
            ("3/14/25 11:59:59 PM", "3/15/25 12:00:00 AM", 1.0),
            // Day and month have one order in a column.
            ("31/03/2025 23:59:58", "01/04/2025 00:00:00", 2.0),
            ("12/04/2025 23:59:58", "13/04/2025 00:00:00", 2.0),
            ("03/31/2025 23:59:58", "04/01/2025 00:00:00", 2.0),
        ] {
            assert!((since(first, second) - expected).abs() < 1e-9, "{first} {second}: {}", since(first, second));
        }
        // Nanoseconds are preserved for present-day times.
        assert!((since("2025-04-17T17:00:08.000000001", "2025-04-17T17:00:08.000000003") - 2e-9).abs() < 1e-16);
        assert_eq!(read("1970-01-01T00:00:00Z").unwrap().since(Order::DayFirst), Some(0));
        assert_eq!(read("2000-03-01T00:00:00Z").unwrap().since(Order::DayFirst), Some(951_868_800));
    }

    /// A recording over midnight, at every day of a year, in both orders.
    #[test]
    fn a_midnight_is_a_midnight_in_both_orders() {
        let lengths = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
        let days: Vec<(i64, i64)> =
            (1..).zip(lengths).flat_map(|(month, length)| (1..=length).map(move |day| (month, day))).collect();
        for pair in days.windows(2) {
            let [(month, day), (next, then)] = pair else { continue };
            let late =
                since(&format!("{month:02}/{day:02}/2025 23:59:59.5"), &format!("{next:02}/{then:02}/2025 00:00:00.5"));
            assert_eq!(late, 1.0, "{month}/{day}");
            let mut clock = Clock::default();
            let late = ["23:59:59.5", "00:00:00.5"]
                .into_iter()
                .zip(pair)
                .map(|(time, (month, day))| clock.tick(&format!("{day:02}/{month:02}/2025 {time}")).map(Tick::value));
            let late: Vec<Option<f64>> = late.collect();
            // Without a number above 12 the order cannot be known: the month comes first.
            if *day > 12 || *then > 12 {
                assert_eq!(late, [Some(0.0), Some(1.0)], "{day}.{month}.");
            }
        }
        let mut clock = Clock::default();
        assert!(clock.tick("31/03/2025 10:00:00").is_some());
        assert!(clock.tick("03/31/2025 10:00:01").is_none(), "two orders");
    }

    /// Times without a date go on at midnight, those without an hour at the full hour, as often as they come.
    #[test]
    fn a_clock_without_date_or_hour_goes_on_when_it_starts_anew() {
        for (turn, of) in [
            (
                DAY_S,
                (|at: i64| format!("{:02}:{:02}:{:02}.500", at / 3600, at / 60 % 60, at % 60)) as fn(i64) -> String,
            ),
            (HOUR_S, |at| format!("{:02}:{:02},500", at / 60, at % 60)),
        ] {
            for first in [0, 1, turn / 2, turn - 1] {
                for step in [1, 59, turn / 2 - 1] {
                    let mut clock = Clock::default();
                    for row in 0..12 {
                        let at = first + row * step;
                        let found = clock.tick(&of(at % turn)).map(Tick::value);
                        assert_eq!(found, Some((row * step) as f64), "{turn} {first} {step}: row {row}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_time_of_unknown_form_is_told_from_other_texts() {
        for text in [
            "T#12ms",
            "LT#1s2ms",
            "DT#2025-10-26-02:59:58.000",
            "TOD#02:59:58",
            "2025-10-26 02:59:58 CET",
            "2025-10-26 02:59:58.000 EST",
            "2025-10-26T02:59:58[Europe/Berlin]",
            "2025-10-26_02-59-58",
            "20251026 025958",
            "Oct 26, 2025 02:59:58",
            "26. August 2025 02:59:58",
            "Sun Oct 26 02:59:58 2025",
            "02:59",
        ] {
            assert!(is_clock_of_unknown_form(text), "{text}");
        }
        for text in [
            "",
            "12",
            "-1.5e-3",
            "1,5",
            "12345678901",
            "1.234.567,89",
            "12 ms",
            "0.5 s",
            "RUN",
            "state 3",
            "key: 17",
            "2025-04-17T17:00:08.005",
            "2025-04-17t17:00:08.005z",
            "17:00:08",
            "1 234 567.5",
        ] {
            assert!(!is_clock_of_unknown_form(text), "{text}");
        }
        assert!((since("2025-04-17t17:00:08.000z", "2025-04-17t17:00:08.005z") - 0.005).abs() < 1e-9);
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
            "10:11:12;4020",
            "10:11:12:05",
            "x days 10:00:00",
            "14-Foo-2025 10:00:00",
            "14-03-25 10:00:00",
            "45/45/2025 10:00:00",
            "10:00:00+99:00",
        ] {
            assert!(!is_clock(text), "{text}");
        }
    }
}

//! Dates and intervals of a maintenance plan, in calendar years and calendar months.

use chrono::{Datelike, Days, Months, NaiveDate};

/// Permitted years of a date; dates outside are assumed to be slips.
pub const YEARS: (i32, i32) = (1990, 2199);

/// A whole number of months or of days.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interval {
    /// Calendar months; twelve are a year.
    Months(u32),
    /// Days; seven are a week.
    Days(u32),
}

/// Fault of a date.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DateFault {
    /// The text is no calendar date, or not written as `2026-03-01`.
    NoDate {
        /// Text of the date.
        written: String,
    },
    /// The date is outside [`YEARS`].
    OutOfRange {
        /// Date read.
        date: NaiveDate,
    },
}

/// Fault of an interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum IntervalFault {
    /// The interval does not begin with a positive whole number.
    NoWholeNumber {
        /// Text of the interval.
        written: String,
    },
    /// The number has no unit.
    UnitMissing {
        /// Text of the interval.
        written: String,
    },
    /// The unit is no unit of time, or too short for a plan.
    UnitUnknown {
        /// Text of the unit.
        unit: String,
    },
    /// The interval exceeds [`INTERVAL_MOST_YEARS`].
    TooLong {
        /// Text of the interval.
        written: String,
    },
}

/// Longest interval of a plan \[a\].
pub const INTERVAL_MOST_YEARS: u32 = 20;

/// Units of an interval in both languages, with their lengths.
const UNITS: [(&[&str], Interval); 4] = [
    (&["a", "year", "years", "jahr", "jahre", "jahren"], Interval::Months(12)),
    (&["month", "months", "monat", "monate", "monaten"], Interval::Months(1)),
    (&["week", "weeks", "woche", "wochen"], Interval::Days(7)),
    (&["d", "day", "days", "tag", "tage", "tagen"], Interval::Days(1)),
];

impl Interval {
    /// Returns the date `times` intervals after another. A day missing in its month becomes the last day of the month.
    #[must_use]
    pub fn after(self, start: NaiveDate, times: u32) -> Option<NaiveDate> {
        match self {
            Self::Months(months) => start.checked_add_months(Months::new(months.checked_mul(times)?)),
            Self::Days(days) => start.checked_add_days(Days::new(u64::from(days) * u64::from(times))),
        }
    }

    /// Returns the first date of a series after `start` that is not before `from`.
    #[must_use]
    pub fn next(self, start: NaiveDate, from: NaiveDate) -> Option<NaiveDate> {
        (1..).map_while(|times| self.after(start, times)).find(|date| *date >= from)
    }

    /// Returns the shorter of two intervals, by their dates after `start`.
    #[must_use]
    pub fn shorter(self, other: Self, start: NaiveDate) -> Self {
        if other.after(start, 1) < self.after(start, 1) { other } else { self }
    }
}

/// Parses a date: `2026-03-01`, `2026-3-1`, or day, month and year with points, `1.3.2026`. With slashes it is none, since their
/// order differs between countries.
///
/// # Errors
/// [`DateFault`] if the text is no date, or a date outside [`YEARS`].
pub fn read_date(text: &str) -> Result<NaiveDate, DateFault> {
    let text = text.trim();
    let no_date = || DateFault::NoDate { written: text.to_owned() };
    let parts = |sign: char| -> Option<[&str; 3]> {
        let parts: Vec<&str> = text.split(sign).collect();
        let parts: [&str; 3] = parts.try_into().ok()?;
        parts.iter().all(|part| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit())).then_some(parts)
    };
    let [year, month, day] = match (parts('-'), parts('.')) {
        (Some(parts), _) => parts,
        (None, Some([day, month, year])) => [year, month, day],
        (None, None) => return Err(no_date()),
    };
    if year.len() != 4 || month.len() > 2 || day.len() > 2 {
        return Err(no_date());
    }
    let date =
        NaiveDate::parse_from_str(&format!("{year}-{month:0>2}-{day:0>2}"), "%Y-%m-%d").map_err(|_| no_date())?;
    if (YEARS.0..=YEARS.1).contains(&date.year()) { Ok(date) } else { Err(DateFault::OutOfRange { date }) }
}

/// Parses an interval such as `6 months`, `1 a`, `26 weeks`, `90 d`.
///
/// # Errors
/// [`IntervalFault`] if the text is no interval.
pub fn read_interval(text: &str) -> Result<Interval, IntervalFault> {
    let text = text.trim();
    let written = || text.to_owned();
    let end = text.bytes().take_while(u8::is_ascii_digit).count();
    let (number, unit) = text.split_at_checked(end).unwrap_or((text, ""));
    let unit = unit.trim();
    if number.is_empty() || unit.starts_with(['.', ',']) {
        return Err(IntervalFault::NoWholeNumber { written: written() });
    }
    if unit.is_empty() {
        return Err(IntervalFault::UnitMissing { written: written() });
    }
    let known = UNITS.iter().find(|(names, _)| names.contains(&unit.to_lowercase().as_str()));
    let Some((_, one)) = known else { return Err(IntervalFault::UnitUnknown { unit: unit.to_owned() }) };
    let too_long = || IntervalFault::TooLong { written: written() };
    let count: u32 = number.parse().map_err(|_| too_long())?;
    if count == 0 {
        return Err(IntervalFault::NoWholeNumber { written: written() });
    }
    let interval = match *one {
        Interval::Months(months) => count.checked_mul(months).map(Interval::Months),
        Interval::Days(days) => count.checked_mul(days).map(Interval::Days),
    };
    interval
        .filter(|interval| match interval {
            Interval::Months(months) => *months <= 12 * INTERVAL_MOST_YEARS,
            Interval::Days(days) => *days <= 366 * INTERVAL_MOST_YEARS,
        })
        .ok_or_else(too_long)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn date(text: &str) -> NaiveDate {
        read_date(text).unwrap()
    }

    #[test]
    fn a_year_is_one_of_the_calendar() {
        let year = read_interval("1 a").unwrap();
        assert_eq!(year.after(date("2026-03-01"), 6), Some(date("2032-03-01")));
        assert_eq!(year.after(date("2024-02-29"), 1), Some(date("2025-02-28")));
        assert_eq!(year.after(date("2024-02-29"), 4), Some(date("2028-02-29")));
        assert_eq!(Interval::Months(1).after(date("2026-01-31"), 1), Some(date("2026-02-28")));
    }

    #[test]
    fn the_next_of_a_series_is_not_before_a_day() {
        let half = read_interval("6 months").unwrap();
        assert_eq!(half.next(date("2026-03-01"), date("2026-03-01")), Some(date("2026-09-01")));
        assert_eq!(half.next(date("2026-03-01"), date("2027-03-01")), Some(date("2027-03-01")));
        assert_eq!(half.next(date("2026-03-01"), date("2027-03-02")), Some(date("2027-09-01")));
    }

    #[test]
    fn intervals_are_read_in_both_languages() {
        for (text, expected) in [
            ("6 months", Interval::Months(6)),
            ("6 Monate", Interval::Months(6)),
            ("2a", Interval::Months(24)),
            ("2 Jahre", Interval::Months(24)),
            ("26 weeks", Interval::Days(182)),
            (" 90 d ", Interval::Days(90)),
        ] {
            assert_eq!(read_interval(text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn what_is_no_interval_is_reported() {
        let fault = |text: &str| read_interval(text).unwrap_err();
        assert!(matches!(fault("months"), IntervalFault::NoWholeNumber { .. }));
        assert!(matches!(fault("-6 months"), IntervalFault::NoWholeNumber { .. }));
        assert!(matches!(fault("0 months"), IntervalFault::NoWholeNumber { .. }));
        assert!(matches!(fault("1.5 a"), IntervalFault::NoWholeNumber { .. }));
        assert!(matches!(fault("6"), IntervalFault::UnitMissing { .. }));
        assert!(matches!(fault("6 mm"), IntervalFault::UnitUnknown { .. }));
        assert!(matches!(fault("99999999999 a"), IntervalFault::TooLong { .. }));
        assert!(matches!(fault("4000000000 a"), IntervalFault::TooLong { .. }));
        assert!(matches!(fault("21 a"), IntervalFault::TooLong { .. }));
        assert!(matches!(fault(""), IntervalFault::NoWholeNumber { .. }));
    }

    #[test]
    fn what_is_no_date_is_reported() {
        let fault = |text: &str| read_date(text).unwrap_err();
        for text in [
            "",
            "2026-02-30",
            "30.02.2026",
            "1.3.26",
            "1/3/2026",
            "+026-03-01",
            "2026/03/01",
            "2026-03-01T00",
            "２０２６-03",
        ] {
            assert!(matches!(fault(text), DateFault::NoDate { .. }), "{text}");
        }
        assert!(matches!(fault("0202-03-01"), DateFault::OutOfRange { .. }));
        for text in ["2026-03-01", "2026-3-1", "1.3.2026", "01.03.2026"] {
            assert_eq!(read_date(text).map(|date| date.to_string()).ok().as_deref(), Some("2026-03-01"), "{text}");
        }
    }
}

//! Number parsing in the notations of files.

use crate::thousands::Commas;
use quantities::Unit;
use std::borrow::Cow;

/// Reason why a cell is not usable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bad {
    Missing,
    Unreadable,
    NotFinite,
    /// Larger than any measurement.
    Implausible,
    /// The other decimal sign was determined in this line.
    Mixed(u64),
    /// The cells of the column state this unit, this one another or none.
    OtherUnit(&'static Unit),
}

/// Decimal sign of a file. Decimal commas are possible if commas do not separate cells; the first number with either
/// sign decides, because `1.234` next to `5,6` may be a thousand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Decimals {
    /// Commas separate cells.
    PointAlways,
    Undecided,
    Point(u64),
    Comma(u64),
}

impl Decimals {
    /// Returns the number in a cell with a decimal point.
    pub(crate) fn plain<'a>(&mut self, cell: &'a [u8], line: u64) -> Result<Cow<'a, str>, Bad> {
        let cell = cell.trim_ascii();
        if cell.is_empty() {
            return Err(Bad::Missing);
        }
        let text = with_hyphen(std::str::from_utf8(cell).map_err(|_| Bad::Unreadable)?);
        if *self == Self::PointAlways {
            return Ok(text);
        }
        let sign = match (text.contains('.'), text.contains(',')) {
            (false, false) => return Ok(text),
            (true, true) => return Err(Bad::Unreadable),
            (true, false) => Self::Point(line),
            (false, true) => Self::Comma(line),
        };
        if *self == Self::Undecided {
            let point = text.replacen(',', ".", 1);
            if point.parse::<f64>().is_ok() {
                *self = sign;
            }
        }
        match (*self, sign) {
            (Self::Comma(decided), Self::Point(_)) | (Self::Point(decided), Self::Comma(_)) => Err(Bad::Mixed(decided)),
            (_, Self::Comma(_)) => Ok(Cow::Owned(text.replacen(',', ".", 1))),
            _ => Ok(text),
        }
    }

    /// Returns the decimal sign, once it is determined.
    pub(crate) const fn sign(self) -> Option<u8> {
        match self {
            Self::PointAlways | Self::Point(_) => Some(b'.'),
            Self::Comma(_) => Some(b','),
            Self::Undecided => None,
        }
    }

    /// Returns `true` if a point is the decimal sign of a table with such commas.
    pub(crate) const fn is_point_for(self, commas: Commas) -> bool {
        matches!((self, commas), (Self::PointAlways, _) | (Self::Point(_), Commas::Quoted))
    }

    /// Returns `true` if a cell looks like a number with either decimal sign.
    pub(crate) fn is_number(cell: &str) -> bool {
        let cell = with_hyphen(cell.trim());
        cell.replacen(',', ".", 1).parse::<f64>().is_ok() || is_grouped(&cell)
    }
}

/// Splits a text into a number and the unit behind it: `0.5 kg m^2`, `12rpm`, `-0,002 s`.
///
/// Signs between thousands are no part of the number, and what follows them no unit: `1 234 N`.
#[must_use]
pub fn with_unit(text: &str) -> Option<(&str, &str)> {
    let text = text.trim();
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes.iter().skip(from).take_while(|byte| byte.is_ascii_digit()).count();
    let sign = ["-", "+", "\u{2212}"].into_iter().find(|sign| text.starts_with(sign)).map_or(0, str::len);
    let mut end = sign + digits(sign);
    let whole = end - sign;
    let mut fraction = 0;
    if bytes.get(end).is_some_and(|byte| b".,".contains(byte)) {
        fraction = digits(end + 1);
        end += 1 + fraction;
    }
    if whole + fraction == 0 {
        return None;
    }
    if bytes.get(end).is_some_and(|byte| b"eE".contains(byte)) {
        let signed = end + 1 + usize::from(bytes.get(end + 1).is_some_and(|byte| b"+-".contains(byte)));
        let exponent = digits(signed);
        if exponent > 0 {
            end = signed + exponent;
        }
    }
    let (number, unit) = text.split_at_checked(end)?;
    let unit = unit.trim_start();
    (!unit.is_empty() && Unit::of(unit).is_some()).then_some((number, unit))
}

/// Returns `true` if a cell is a number, with or without a unit behind it.
pub(crate) fn is_value(cell: &str) -> bool {
    Decimals::is_number(cell) || with_unit(cell).is_some()
}

/// Returns a number with either decimal sign, or with a point alone.
#[must_use]
pub fn number(text: &str, may_have_comma: bool) -> Option<f64> {
    let text = with_hyphen(text.trim());
    if may_have_comma && text.contains(',') {
        let has_point = text.contains('.');
        return text.replacen(',', ".", 1).parse().ok().filter(|_| !has_point);
    }
    text.parse().ok()
}

/// Returns a number with a hyphen for each minus sign `−` (U+2212), which spreadsheets of some countries write.
fn with_hyphen(text: &str) -> Cow<'_, str> {
    if text.contains('−') { Cow::Owned(text.replace('−', "-")) } else { Cow::Borrowed(text) }
}

/// Returns `true` if a text that is no number has unambiguous separators of thousands: `1.234,5`, `1,234.5`, `1'234`,
/// `1.234.567`. `1.234` is ambiguous.
#[must_use]
pub fn is_grouped(text: &str) -> bool {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    ['.', ',', '\'', '’', ' ', '\u{a0}', '\u{202f}'].into_iter().any(|sign| {
        let mut groups = unsigned.split(sign);
        let leading = groups.next().unwrap_or_default();
        let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        if !digits(leading) || leading.len() > 3 {
            return false;
        }
        let rest: Vec<&str> = groups.collect();
        let Some((last, between)) = rest.split_last() else { return false };
        let (whole, fraction) = last.split_at(last.len() - last.trim_start_matches(|c: char| c.is_ascii_digit()).len());
        let decimal = fraction.strip_prefix(['.', ',']).filter(|part| digits(part) && !fraction.starts_with(sign));
        let sound = between.iter().chain([&whole]).all(|group| group.len() == 3 && digits(group));
        let certain = decimal.is_some() || !between.is_empty() || !['.', ','].contains(&sign);
        sound && certain && (fraction.is_empty() || decimal.is_some())
    })
}

/// Powers of ten that a double represents exactly.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Parses a plain number, digits with at most one decimal sign: `-12.345`. Returns `None` for anything else, which a
/// slower reader handles: an exponent, a space, more digits than a double holds, no number.
///
/// m/10^k with m < 2⁵³ and k ≤ 22 is one division of two exact doubles, hence correctly rounded (Clinger, How to read floating
/// point numbers accurately, PLDI 1990).
#[inline]
pub(crate) fn plain(cell: &[u8], between: u8) -> Option<f64> {
    let (is_negative, digits) = match cell {
        [b'-', rest @ ..] => (true, rest),
        rest => (false, rest),
    };
    // Nineteen digits fit into 64 bits; one sign may stand among them.
    if digits.is_empty() || digits.len() > 20 {
        return None;
    }
    let (mut whole, mut sign) = (0_u64, None);
    for (place, byte) in digits.iter().enumerate() {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            whole = whole.wrapping_mul(10).wrapping_add(u64::from(digit));
        } else if *byte == between && sign.is_none() {
            sign = Some(place);
        } else {
            return None;
        }
    }
    let count = digits.len() - usize::from(sign.is_some());
    let fraction = sign.map_or(0, |place| digits.len() - 1 - place);
    if count == 0 || count > 19 || whole >= 1 << 53 {
        return None;
    }
    let value = whole as f64 / TENS.get(fraction)?;
    Some(if is_negative { -value } else { value })
}

/// Parses a finite number.
pub(crate) fn finite(text: &str) -> Result<f64, Bad> {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(Bad::NotFinite),
        Err(_) => Err(Bad::Unreadable),
    }
}

/// A time as written, in two parts: an f64 resolves the seconds since 1970 to a quarter of a microsecond only, and
/// differences of times matter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tick {
    whole: i64,
    part: f64,
}

impl Tick {
    /// Minimum number of digits before the point that are kept apart; with fewer, an f64 is precise enough.
    const DIGITS_MIN: usize = 8;
    /// Maximum number of digits of an i64, needed for nanoseconds since 1970.
    const DIGITS_MAX: usize = 19;

    pub(crate) fn read(text: &str) -> Result<Self, Bad> {
        let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
        let digits = unsigned.bytes().take_while(u8::is_ascii_digit).count();
        let (whole, fraction) = unsigned.split_at(digits);
        if (Self::DIGITS_MIN..=Self::DIGITS_MAX).contains(&digits)
            && let Ok(whole) = whole.parse::<i64>()
            && let Some(part) = part(fraction)
        {
            let negative = text.starts_with('-');
            return Ok(if negative { Self { whole: -whole, part: -part } } else { Self { whole, part } });
        }
        finite(text).map(Self::of_float)
    }

    pub(crate) const fn of_integer(whole: i64) -> Self {
        Self { whole, part: 0.0 }
    }

    /// Creates a time from a whole number and a part, each with its own sign.
    pub(crate) const fn of_parts(whole: i64, part: f64) -> Self {
        Self { whole, part }
    }

    /// Returns the time increased by `part`.
    pub(crate) const fn later(self, part: f64) -> Self {
        Self { whole: self.whole, part: self.part + part }
    }

    /// Returns a time in millionths of a day, 0.0864 s, in seconds.
    pub(crate) const fn of_millionths_of_day(self) -> Self {
        let scaled = self.whole.saturating_mul(864);
        Self { whole: scaled / 10_000, part: (scaled % 10_000) as f64 / 1e4 + 0.0864 * self.part }
    }

    /// Returns a time in hundreds of nanoseconds in seconds.
    pub(crate) const fn of_hundreds_of_nanoseconds(self) -> Self {
        const PER_SECOND: i64 = 10_000_000;
        Self { whole: self.whole / PER_SECOND, part: (self.whole % PER_SECOND) as f64 / 1e7 + 1e-7 * self.part }
    }

    pub(crate) const fn of_float(part: f64) -> Self {
        Self { whole: 0, part }
    }

    pub(crate) const fn value(self) -> f64 {
        self.whole as f64 + self.part
    }

    /// Returns the time elapsed since another one.
    pub(crate) fn since(self, other: Self) -> f64 {
        let whole = match self.whole.checked_sub(other.whole) {
            Some(near) => near as f64,
            None => (i128::from(self.whole) - i128::from(other.whole)) as f64,
        };
        whole + (self.part - other.part)
    }
}

/// Parses the digits after the point, if nothing else follows.
fn part(fraction: &str) -> Option<f64> {
    if fraction.is_empty() {
        return Some(0.0);
    }
    let digits = fraction.strip_prefix('.')?;
    if digits.is_empty() {
        return Some(0.0);
    }
    digits.bytes().all(|c| c.is_ascii_digit()).then(|| fraction.parse().ok()).flatten()
}

/// Rounds a time to fifteen digits, for a line to write.
pub(crate) fn short(value: f64) -> f64 {
    format!("{value:.14e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_times_keep_their_last_digits() {
        let since = |a: &str, b: &str| Tick::read(a).unwrap().since(Tick::read(b).unwrap());
        assert_eq!(since("1699999999123456790", "1699999999123456789"), 1.0);
        assert_eq!(since("9999999999999999999", "9999999999999999998"), 0.0, "beyond an i64 it is a plain f64");
        assert!((since("1699999999.000123", "1699999998.999999") - 124e-6).abs() < 1e-15);
        assert!((since("-1699999999.5", "-1699999999.75") - 0.25).abs() < 1e-15);
        assert_eq!(since("10000000.5", "9999999.5"), 1.0);
        assert_eq!(Tick::read("1.7e9").unwrap().value(), 1.7e9);
        assert_eq!(Tick::read("123456789.").unwrap().value(), 123_456_789.0);
    }

    /// The fast parser returns the same bits as the library, or nothing.
    #[test]
    fn a_plain_number_is_that_of_the_library() {
        for text in
            ["0", "-0", "12.345", "-0.001", "9007199254740991", "0.1", "123456.789012", ".5", "5.", "1.7976931348"]
        {
            assert_eq!(plain(text.as_bytes(), b'.').map(f64::to_bits), text.parse().ok().map(f64::to_bits), "{text}");
        }
        arbtest::arbtest(|u| {
            let (whole, fraction) = (u.int_in_range(0..=999_999_999_u64)?, u.int_in_range(0..=999_999_u64)?);
            let width = u.int_in_range(0..=9_usize)?;
            let text = format!("{}{whole}.{fraction:0width$}", if u.arbitrary()? { "-" } else { "" });
            if let Some(found) = plain(text.as_bytes(), b'.') {
                assert_eq!(found.to_bits(), text.parse::<f64>().unwrap().to_bits(), "{text}");
            }
            Ok(())
        });
        for text in
            ["", "-", ".", "1e5", "1.2.3", "+1", " 1", "nan", "12345678901234567890123", "9007199254740993", "1,5"]
        {
            assert_eq!(plain(text.as_bytes(), b'.'), None, "{text}");
        }
        assert_eq!(plain(b"1,5", b','), Some(1.5));
    }

    #[test]
    fn a_unit_stands_behind_a_number() {
        for (text, expected) in [
            ("0.5 kg m^2", Some(("0.5", "kg m^2"))),
            (" -0,002 s ", Some(("-0,002", "s"))),
            ("12rpm", Some(("12", "rpm"))),
            ("1e-3 kg m^2", Some(("1e-3", "kg m^2"))),
            ("5 1/min", Some(("5", "1/min"))),
            ("\u{2212}.5 °", Some(("\u{2212}.5", "°"))),
            ("3 m", Some(("3", "m"))),
            ("5", None),
            ("1 234 N", None),
            ("51/min", None),
            ("N m", None),
            ("- s", None),
            ("1.5.2 s", None),
            ("1e5", None),
        ] {
            assert_eq!(with_unit(text), expected, "{text}");
        }
    }

    #[test]
    fn what_is_no_time_is_refused() {
        assert_eq!(Tick::read("12:30"), Err(Bad::Unreadable));
        assert_eq!(Tick::read("123456789.5.5"), Err(Bad::Unreadable));
        assert_eq!(Tick::read("NaN"), Err(Bad::NotFinite));
        assert_eq!(Tick::read("1e999"), Err(Bad::NotFinite));
    }

    #[test]
    fn thousands_are_known_where_nothing_else_can_be_meant() {
        for text in ["1.234,5", "-1,234.5", "12'345", "1 234 567,25", "1.234.567", "123\u{202f}456"] {
            assert!(is_grouped(text), "{text}");
        }
        for text in ["1.234", "1,234", "1234,5", "12.34,5", "1.2345,6", "1.234,", ",5", "1.234e5", "2024 12", "a.123,4"]
        {
            assert!(!is_grouped(text), "{text}");
        }
    }

    #[test]
    fn the_first_decimal_sign_decides() {
        let mut decimals = Decimals::Undecided;
        assert_eq!(decimals.plain(b" 5 ", 3).as_deref(), Ok("5"));
        assert_eq!(decimals, Decimals::Undecided);
        assert_eq!(decimals.plain(b"1,5", 4).as_deref(), Ok("1.5"));
        assert_eq!(decimals.plain(b"1.5", 5), Err(Bad::Mixed(4)));
        assert_eq!(decimals.plain(b"1.500,5", 5), Err(Bad::Unreadable));
        let mut decimals = Decimals::Undecided;
        assert_eq!(decimals.plain(b"1.5", 4).as_deref(), Ok("1.5"));
        assert_eq!(decimals.plain(b"1,5", 5), Err(Bad::Mixed(4)));
        assert_eq!(Decimals::PointAlways.plain(b"", 1), Err(Bad::Missing));
    }
}

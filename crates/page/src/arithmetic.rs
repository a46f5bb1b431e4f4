//! Arithmetic in the number fields of the page: `2*0.3 m`, `1/2`, `(80+20) mm`.
//!
//! The project file keeps the result. An entry that is one number, with or without its unit, is none of arithmetic.

use quantities::{Language, Unit};
use words::page;

/// Fault of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ArithmeticFault {
    /// An operator without a number behind it.
    NumberMissing,
    /// A parenthesis that is not closed, or not opened.
    Parenthesis,
    /// A division by zero.
    DivisionByZero,
    /// A result outside of what a number can be.
    OutOfRange,
    /// More characters or parentheses than an entry may have.
    TooLong,
    /// Behind the expression there is no unit.
    NoUnit,
    /// A unit inside the expression instead of behind it.
    UnitInside,
    /// A number with separators between its digits, or with the decimal mark of another language.
    Separators,
}

impl ArithmeticFault {
    /// Returns the fault as text; `unit` is one of the field, empty for a plain number.
    pub(crate) fn text(self, unit: &str, language: Language) -> String {
        let text = match self {
            Self::NumberMissing => page::arithmetic_number_missing(language),
            Self::Parenthesis => page::arithmetic_parenthesis(language),
            Self::DivisionByZero => page::arithmetic_division_by_zero(language),
            Self::OutOfRange => page::arithmetic_out_of_range(language),
            Self::TooLong => page::arithmetic_too_long(language),
            Self::NoUnit => page::arithmetic_no_unit(language),
            Self::UnitInside => {
                return page::arithmetic_unit_inside(&unit, language).trim_end().to_owned();
            }
            Self::Separators => page::arithmetic_separators(language),
        };
        text.to_owned()
    }
}

/// Longest expression, in bytes.
const LENGTH_MOST: usize = 200;

/// Largest number of open parentheses and signs.
const DEPTH_MOST: usize = 20;

/// Computes an entry; `None` if it contains no arithmetic.
///
/// The numbers may have the decimal mark of the language, or a point; the result has a point, and its unit behind it if the
/// entry states one.
///
/// # Errors
/// The fault of an entry that begins as arithmetic.
pub(crate) fn computed(typed: &str, language: Language) -> Result<Option<String>, ArithmeticFault> {
    let typed = typed.trim();
    let mut reader = Expression { rest: typed, mark: language.decimal_mark(), operators: 0, depth: 0 };
    let is_arithmetic = |reader: &Expression<'_>| reader.operators > 0;
    let value = match reader.sum() {
        Ok(value) => value,
        Err(None) => return Ok(None),
        // A unit may begin with a slash, a name with a parenthesis.
        Err(Some(fault)) => return if is_arithmetic(&reader) { Err(fault) } else { Ok(None) },
    };
    let has_separators = separates(reader.rest, language);
    if !is_arithmetic(&reader) {
        return match () {
            () if value.is_nan() => Err(ArithmeticFault::OutOfRange),
            // The fault of a single comma in place of the point says both of its meanings.
            () if has_separators && language.decimal_mark() == ',' => Err(ArithmeticFault::Separators),
            () if goes_on_behind_a_unit(reader.rest) => Err(ArithmeticFault::UnitInside),
            () => Ok(None),
        };
    }
    if typed.len() > LENGTH_MOST {
        return Err(ArithmeticFault::TooLong);
    }
    let unit = reader.rest.trim();
    if unit.starts_with(')') {
        return Err(ArithmeticFault::Parenthesis);
    }
    if !unit.is_empty() && Unit::of(unit).is_none() {
        return Err(match () {
            () if has_separators => ArithmeticFault::Separators,
            () if goes_on_behind_a_unit(unit) => ArithmeticFault::UnitInside,
            () => ArithmeticFault::NoUnit,
        });
    }
    if !value.is_finite() || value != 0.0 && !(1e-300..=1e300).contains(&value.abs()) {
        return Err(ArithmeticFault::OutOfRange);
    }
    // Rounding of the operations adds no digits.
    let short = format!("{value:.11e}").parse::<f64>().unwrap_or(value);
    Ok(Some(if unit.is_empty() { short.to_string() } else { format!("{short} {unit}") }))
}

/// Returns `true` if further digits follow behind a separator: a point, a comma, or a blank between groups of three where the
/// comma is the decimal mark. `rest` begins behind a number.
fn separates(rest: &str, language: Language) -> bool {
    let is_digit = |sign: char| sign.is_ascii_digit();
    if let Some(behind) = rest.strip_prefix(['.', ',']) {
        return behind.starts_with(is_digit);
    }
    let Some(behind) = rest.strip_prefix(' ').filter(|behind| Unit::of(behind.trim()).is_none()) else { return false };
    let end = behind.find(|sign: char| !is_digit(sign) && sign != ' ').unwrap_or(behind.len());
    let mut groups = behind.get(..end).unwrap_or_default().split_whitespace().peekable();
    // A unit may begin with a number: `1/min`.
    let ends = behind.get(end..).is_none_or(|unit| !unit.starts_with(['/', '*', '^', '.', ',']));
    language.decimal_mark() == ',' && ends && groups.peek().is_some() && groups.all(|group| group.len() == 3)
}

/// Returns `true` if a unit is followed by an operator and a number: `kg*2`. `rest` begins behind a number.
fn goes_on_behind_a_unit(rest: &str) -> bool {
    let rest = rest.trim();
    let operators = rest.char_indices().filter(|(_, sign)| ['*', '×', '·', '/', '÷', '+', '-', '−'].contains(sign));
    let goes_on = |(place, sign): (usize, char)| {
        let (unit, behind) = rest.split_at(place);
        let behind = behind.get(sign.len_utf8()..).unwrap_or_default().trim_start();
        Unit::of(unit.trim()).is_some() && behind.starts_with(|sign: char| sign.is_ascii_digit() || sign == '(')
    };
    Unit::of(rest).is_none() && operators.into_iter().any(goes_on)
}

/// An expression while it is read.
struct Expression<'t> {
    rest: &'t str,
    mark: char,
    operators: usize,
    depth: usize,
}

/// Fault, or `None` if what follows does not belong to an expression.
type NoNumber = Option<ArithmeticFault>;

impl Expression<'_> {
    /// Reads one of these signs, if it is next.
    fn sign(&mut self, signs: &[char]) -> Option<char> {
        let rest = self.rest.trim_start();
        let sign = rest.chars().next().filter(|sign| signs.contains(sign))?;
        self.rest = rest.get(sign.len_utf8()..).unwrap_or_default();
        Some(sign)
    }

    fn sum(&mut self) -> Result<f64, NoNumber> {
        let mut sum = self.product()?;
        while let Some(sign) = self.sign(&['+', '-', '−']) {
            let term = self.operand(Self::product)?;
            sum = if sign == '+' { sum + term } else { sum - term };
        }
        Ok(sum)
    }

    fn product(&mut self) -> Result<f64, NoNumber> {
        let mut product = self.factor()?;
        while let Some(sign) = self.sign(&['*', '×', '·', '/', '÷', ':']) {
            let factor = self.operand(Self::factor)?;
            if matches!(sign, '*' | '×' | '·') {
                product *= factor;
            } else if factor == 0.0 {
                return Err(Some(ArithmeticFault::DivisionByZero));
            } else {
                product /= factor;
            }
        }
        Ok(product)
    }

    /// Reads the number behind an operator.
    fn operand(&mut self, read: fn(&mut Self) -> Result<f64, NoNumber>) -> Result<f64, NoNumber> {
        self.operators += 1;
        read(self).map_err(|fault| fault.or(Some(ArithmeticFault::NumberMissing)))
    }

    fn factor(&mut self) -> Result<f64, NoNumber> {
        if let Some(sign) = self.sign(&['-', '−', '+']) {
            self.deeper()?;
            let value = self.factor()?;
            self.depth -= 1;
            return Ok(if sign == '+' { value } else { -value });
        }
        if self.sign(&['(']).is_some() {
            self.deeper()?;
            self.operators += 1;
            let value = self.sum().map_err(|fault| fault.or(Some(ArithmeticFault::NumberMissing)))?;
            self.depth -= 1;
            return self.sign(&[')']).map(|_| value).ok_or(Some(ArithmeticFault::Parenthesis));
        }
        self.number().ok_or(None)
    }

    fn deeper(&mut self) -> Result<(), NoNumber> {
        self.depth += 1;
        if self.depth > DEPTH_MOST { Err(Some(ArithmeticFault::TooLong)) } else { Ok(()) }
    }

    /// Reads a number: digits with at most one decimal mark, and an exponent.
    fn number(&mut self) -> Option<f64> {
        let rest = self.rest.trim_start();
        let mark = |sign: char| sign == '.' || sign == self.mark;
        let mut has_mark = false;
        let digits = rest.char_indices().find(|(_, sign)| {
            let is_mark = mark(*sign) && !has_mark;
            has_mark |= is_mark;
            !(sign.is_ascii_digit() || is_mark)
        });
        let mut end = digits.map_or(rest.len(), |(place, _)| place);
        // The letter of an exponent has digits behind it; that of a unit has none.
        let tail = rest.get(end..).unwrap_or_default();
        if let Some(power) = tail.strip_prefix(['e', 'E']) {
            let signed = power.strip_prefix(['+', '-']).unwrap_or(power);
            let count = signed.chars().take_while(char::is_ascii_digit).count();
            if count > 0 {
                end += 1 + (power.len() - signed.len()) + count;
            }
        }
        let written = rest.get(..end)?;
        let number: f64 = written.replace(self.mark, ".").parse().ok()?;
        self.rest = rest.get(end..).unwrap_or_default();
        // A number below the smallest one would be zero.
        let mantissa = written.split(['e', 'E']).next().unwrap_or(written);
        let is_lost = number == 0.0 && mantissa.bytes().any(|digit| (b'1'..=b'9').contains(&digit));
        Some(if is_lost { f64::NAN } else { number })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(typed: &str) -> Option<String> {
        computed(typed, Language::De).unwrap_or_else(|fault| panic!("{typed}: {fault:?}"))
    }

    #[test]
    fn a_sum_is_computed_and_keeps_its_unit() {
        for (typed, value) in [
            ("2*0,3", "0.6"),
            ("1/2", "0.5"),
            ("3*0.1", "0.3"),
            ("1/3", "0.333333333333"),
            ("2 * 0,3 m", "0.6 m"),
            ("(80+20) mm", "100 mm"),
            ("2·(3−1)÷4", "1"),
            ("60/2 1/min", "30 1/min"),
            ("1/2 m/s", "0.5 m/s"),
            ("3*1e-3 kg m^2", "0.003 kg m^2"),
            ("-(2+3)", "-5"),
            ("2*-3", "-6"),
            ("10-4-3", "3"),
            ("8/2/2", "2"),
        ] {
            assert_eq!(of(typed).as_deref(), Some(value), "{typed}");
        }
        assert_eq!(computed("2*0.3", Language::En), Ok(Some("0.6".to_owned())));
    }

    #[test]
    fn what_is_one_number_or_none_is_left_as_it_is() {
        for typed in [
            "",
            "60",
            "0,5",
            "-3 mm",
            "+4",
            "40 1/min",
            "20 m/s",
            "1,300",
            "3 kg m^2",
            "fast",
            "1e-3 m",
            "up",
            "5 N m/(1/min)",
            "5 kg*m^2",
            "3 N·m",
            "2 1/s",
        ] {
            assert_eq!(of(typed), None, "{typed}");
        }
        assert_eq!(computed("1,300", Language::En), Ok(None));
    }

    #[test]
    fn a_faulty_expression_says_its_fault() {
        for (typed, fault) in [
            ("2*", ArithmeticFault::NumberMissing),
            ("2**3", ArithmeticFault::NumberMissing),
            ("2*m", ArithmeticFault::NumberMissing),
            ("(2+3", ArithmeticFault::Parenthesis),
            ("2*3)", ArithmeticFault::Parenthesis),
            ("1/0", ArithmeticFault::DivisionByZero),
            ("1/(2-2) m", ArithmeticFault::DivisionByZero),
            ("1e200*1e200", ArithmeticFault::OutOfRange),
            ("2*3 furlongs", ArithmeticFault::NoUnit),
            ("1+1.2.3", ArithmeticFault::Separators),
            ("1.000,5", ArithmeticFault::Separators),
            ("1,000.5", ArithmeticFault::Separators),
            ("1 000", ArithmeticFault::Separators),
            ("12 500 kg", ArithmeticFault::Separators),
            ("1 000 000", ArithmeticFault::Separators),
            ("2*1.000,5 kg", ArithmeticFault::Separators),
            ("5kg*2", ArithmeticFault::UnitInside),
            ("5 kg + 2 kg", ArithmeticFault::UnitInside),
            ("2*3 mm*4", ArithmeticFault::UnitInside),
            ("1e-400", ArithmeticFault::OutOfRange),
            ("2*1e-400", ArithmeticFault::OutOfRange),
        ] {
            assert_eq!(computed(typed, Language::De), Err(fault), "{typed}");
        }
        for (typed, fault) in [
            ("2*0,3", ArithmeticFault::Separators),
            ("2*1,000.5 mm", ArithmeticFault::Separators),
            ("5kg*2", ArithmeticFault::UnitInside),
            ("1e-400", ArithmeticFault::OutOfRange),
        ] {
            assert_eq!(computed(typed, Language::En), Err(fault), "{typed}");
        }
        let deep = format!("1+{}1{}", "(".repeat(30), ")".repeat(30));
        let long = format!("1{}", "+1".repeat(200));
        assert_eq!(computed(&deep, Language::En), Err(ArithmeticFault::TooLong));
        assert_eq!(computed(&long, Language::En), Err(ArithmeticFault::TooLong));
        assert_eq!(computed(&"(".repeat(100_000), Language::En), Err(ArithmeticFault::TooLong));
        assert_eq!(computed(&format!("1{}", "-".repeat(100_000)), Language::En), Err(ArithmeticFault::TooLong));
    }

    /// Sums of random numbers and operators are those of the language of this program.
    #[test]
    fn generated_sums_are_computed_by_the_rules_of_precedence() {
        let mut state = 7_u32;
        let mut next = |most: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % most
        };
        for _ in 0..2000 {
            let (a, b, c) = (f64::from(next(90) + 1), f64::from(next(90) + 1) / 8.0, f64::from(next(9) + 1));
            let cases = [
                (format!("{a}+{b}*{c}"), b.mul_add(c, a)),
                (format!("({a}+{b})*{c}"), (a + b) * c),
                (format!("{a}-{b}-{c}"), a - b - c),
                (format!("{a}/{b}/{c}"), a / b / c),
                (format!("{a}-({b}-{c})"), a - (b - c)),
                (format!("-{a}*-{b}"), a * b),
            ];
            for (typed, value) in cases {
                let found: f64 = computed(&typed, Language::En).unwrap().unwrap().parse().unwrap();
                assert!((found - value).abs() <= 1e-11 * value.abs().max(1e-3), "{typed}: {found} {value}");
            }
        }
    }
}

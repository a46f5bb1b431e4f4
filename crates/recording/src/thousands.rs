//! Separators of thousands that look like decimal signs: `998`, `1.002`.

use crate::faults::excerpt;

/// Evidence about the only sign between the digits of a table, which may be decimal or separate thousands.
///
/// A column of whole numbers with separators of thousands holds numbers up to 999 without a sign and larger ones with
/// exactly three digits behind it. Read as decimals the larger ones would count a thousandth. A cell that no separator of
/// thousands can produce, such as `0.5` or `1.25`, shows for the whole table that the sign is decimal; a whole number of
/// more than three digits shows it for its column.
#[derive(Clone, Debug, Default)]
pub struct Thousands {
    is_decimal: bool,
    columns: Vec<Column>,
}

#[derive(Clone, Debug, Default)]
struct Column {
    is_plain: bool,
    has_small: bool,
    first: Option<Possible>,
}

/// The first number of a column whose sign may separate thousands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Possible {
    /// Index of the column.
    pub column: usize,
    /// Line or row of the number.
    pub place: u64,
    /// Number as written.
    pub text: String,
}

/// Notation of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// At most three digits: `998`.
    Small,
    /// More digits than stand between separators of thousands: `1002`.
    Large,
    /// One sign, exactly three digits behind it and one to three before it, the first of them not zero: `1.002`.
    Grouped,
    /// A sign that is decimal in any case: `0.998`, `1.02`.
    Decimal,
}

impl Form {
    fn of(cell: &str) -> Option<Self> {
        let unsigned = cell.strip_prefix(['-', '+', '\u{2212}']).unwrap_or(cell);
        let is_digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        let Some((whole, part)) = unsigned.split_once(['.', ',']) else {
            return is_digits(unsigned).then_some(if unsigned.len() > 3 { Self::Large } else { Self::Small });
        };
        if is_digits(whole) && is_digits(part) {
            let is_grouped = part.len() == 3 && whole.len() <= 3 && !whole.starts_with('0');
            return Some(if is_grouped { Self::Grouped } else { Self::Decimal });
        }
        unsigned.replacen(',', ".", 1).parse::<f64>().is_ok().then_some(Self::Decimal)
    }
}

/// Returns `true` if the sign of a number may separate thousands: `1.002`.
pub(crate) fn may_be_grouped(cell: &str) -> bool {
    Form::of(cell.trim()) == Some(Form::Grouped)
}

impl Thousands {
    /// Adds a cell of a column; text that is no number states nothing.
    pub fn note(&mut self, column: usize, cell: &str, place: u64) {
        if self.is_decimal {
            return;
        }
        let cell = cell.trim();
        let Some(form) = Form::of(cell) else { return };
        if form == Form::Decimal {
            self.is_decimal = true;
            return;
        }
        if column >= self.columns.len() {
            self.columns.resize_with(column + 1, Column::default);
        }
        let Some(of_column) = self.columns.get_mut(column) else { return };
        match form {
            Form::Small => of_column.has_small = true,
            Form::Large => of_column.is_plain = true,
            Form::Grouped if of_column.first.is_none() => {
                of_column.first = Some(Possible { column, place, text: excerpt(cell) });
            }
            Form::Grouped | Form::Decimal => {}
        }
    }

    /// Returns `true` if the sign is decimal in any case.
    #[must_use]
    pub const fn is_decimal(&self) -> bool {
        self.is_decimal
    }

    /// Returns the columns that mix numbers up to 999 without a sign and numbers with three digits behind it, unless
    /// other cells show that the sign is decimal.
    pub fn mixed(&self) -> impl Iterator<Item = &Possible> {
        self.found(|column| column.has_small)
    }

    /// Returns those columns, and the ones in which a point stands before three digits in every number: where commas do
    /// not separate cells, spreadsheets write thousands so.
    pub fn possible(&self) -> impl Iterator<Item = &Possible> {
        self.found(|column| column.has_small || column.first.as_ref().is_some_and(|first| first.text.contains('.')))
    }

    fn found(&self, is_meant: impl Fn(&Column) -> bool) -> impl Iterator<Item = &Possible> {
        let open = self.columns.iter().filter(|column| !self.is_decimal && !column.is_plain);
        open.filter(move |column| is_meant(column)).filter_map(|column| column.first.as_ref())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whole numbers written with separators of thousands are found in any order, and no decimals of a fixed or of the
    /// shortest notation are.
    #[test]
    fn grouped_whole_numbers_are_found_and_decimals_are_not() {
        let grouped = |value: i64, sign: char| {
            let (minus, size) = (if value < 0 { "-" } else { "" }, value.unsigned_abs());
            if size < 1000 {
                format!("{minus}{size}")
            } else {
                format!("{minus}{}{sign}{:03}", size / 1000, size % 1000)
            }
        };
        arbtest::arbtest(|u| {
            let sign = if u.arbitrary()? { '.' } else { ',' };
            let mut values = vec![u.int_in_range(-999..=999_i64)?, u.int_in_range(1000..=999_999_i64)?];
            for _ in 0..u.int_in_range(0..=20_usize)? {
                values.push(u.int_in_range(-999_999..=999_999_i64)?);
            }
            if u.arbitrary()? {
                values.reverse();
            }
            let mut thousands = Thousands::default();
            for (row, value) in values.iter().enumerate() {
                thousands.note(2, &grouped(*value, sign), row as u64);
            }
            assert_eq!(thousands.mixed().map(|found| found.column).collect::<Vec<_>>(), [2], "{values:?}");
            // The same numbers beside a decimal, or without separators.
            thousands.note(0, "0.125", 99);
            assert_eq!(thousands.mixed().count(), 0);
            let mut plain = Thousands::default();
            values.iter().for_each(|value| plain.note(0, &value.to_string(), 0));
            assert_eq!(plain.possible().count(), 0);
            let mut fixed = Thousands::default();
            values.iter().for_each(|value| fixed.note(0, &format!("{value}.000"), 0));
            assert_eq!(fixed.mixed().count(), 0);
            Ok(())
        });
    }
}

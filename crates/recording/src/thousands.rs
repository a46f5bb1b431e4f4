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
    commas: Commas,
    is_decimal: bool,
    columns: Vec<Column>,
}

/// Commas in the numbers of a table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Commas {
    /// Commas separate the cells, and no number is quoted: a point is decimal.
    #[default]
    None,
    /// Commas stand in quoted numbers only. Spreadsheets quote a number there because of its separators of thousands, others because
    /// of its decimal comma; a point is decimal.
    Quoted,
    /// Other signs separate the cells: a comma or a point may be decimal.
    Any,
}

impl Commas {
    /// Returns the commas that a first row of numbers shows, `is_quoted` if one of them is quoted.
    pub(crate) const fn of(delimiter: u8, is_quoted: bool) -> Self {
        match (delimiter, is_quoted) {
            (b',', false) => Self::None,
            (b',', true) => Self::Quoted,
            _ => Self::Any,
        }
    }

    /// Returns `true` if numbers may have decimal commas.
    #[must_use]
    pub const fn may_be_decimal(self) -> bool {
        !matches!(self, Self::None)
    }
}

/// Kind of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowKind {
    /// Samples in the order of time, mostly with a fixed number of decimals.
    Samples,
    /// Rows of a spreadsheet, independent of one another.
    Entries,
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
#[must_use]
pub fn may_be_grouped(cell: &str) -> bool {
    Form::of(cell.trim()) == Some(Form::Grouped)
}

impl Thousands {
    /// Creates the evidence of a table without cells.
    #[must_use]
    pub fn of(commas: Commas) -> Self {
        Self { commas, ..Self::default() }
    }

    /// Adds a cell of a column; text that is no number states nothing.
    pub fn note(&mut self, column: usize, cell: &str, place: u64) {
        if self.is_decimal {
            return;
        }
        let cell = cell.trim();
        let Some(form) = Form::of(cell) else { return };
        // Where commas separate the cells a point is decimal, and says nothing about a quoted comma.
        if self.commas != Commas::Any && cell.contains('.') {
            return;
        }
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

    /// Returns the commas of the table.
    pub(crate) const fn commas(&self) -> Commas {
        self.commas
    }

    /// Returns `true` if the sign is decimal in any case.
    #[must_use]
    pub const fn is_decimal(&self) -> bool {
        self.is_decimal
    }

    /// Returns the first number of each column whose sign may separate thousands, unless other cells show that it is decimal: where the
    /// column has numbers up to 999 without a sign too; where the number is quoted because of a comma; and in the rows of a
    /// spreadsheet, which writes thousands so, where a point stands before three digits in every number.
    pub fn possible(&self, rows: RowKind) -> impl Iterator<Item = &Possible> {
        let open = self.columns.iter().filter(|column| !self.is_decimal && !column.is_plain);
        let is_meant = move |column: &Column, first: &Possible| {
            let is_point = || rows == RowKind::Entries && first.text.contains('.');
            column.has_small || self.commas == Commas::Quoted || is_point()
        };
        open.filter_map(move |column| column.first.as_ref().filter(|first| is_meant(column, first)))
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
            let mut thousands = Thousands::of(Commas::Any);
            for (row, value) in values.iter().enumerate() {
                thousands.note(2, &grouped(*value, sign), row as u64);
            }
            assert_eq!(
                thousands.possible(RowKind::Samples).map(|found| found.column).collect::<Vec<_>>(),
                [2],
                "{values:?}"
            );
            // The same numbers beside a decimal, or without separators.
            thousands.note(0, "0.125", 99);
            assert_eq!(thousands.possible(RowKind::Samples).count(), 0);
            let mut plain = Thousands::of(Commas::Any);
            values.iter().for_each(|value| plain.note(0, &value.to_string(), 0));
            assert_eq!(plain.possible(RowKind::Entries).count(), 0);
            let mut fixed = Thousands::of(Commas::Any);
            values.iter().for_each(|value| fixed.note(0, &format!("{value}.000"), 0));
            assert_eq!(fixed.possible(RowKind::Samples).count(), 0);
            Ok(())
        });
    }
}

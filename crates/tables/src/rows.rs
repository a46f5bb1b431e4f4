//! Rows of a table, stored so that a long series of numbers takes no more memory than its numbers.

use crate::cell::{Cell, rounded};
use std::borrow::Cow;

/// Rows of a table, each with a cell for every column.
#[derive(Clone, Debug)]
pub struct Rows(Held);

#[derive(Clone, Debug)]
enum Held {
    /// Rows of any cells.
    Listed(Vec<Vec<Cell>>),
    /// Rows of numbers, row after row; NaN is an empty cell.
    Series { columns: usize, values: Vec<f64> },
    /// Number of rows that are not computed.
    LeftOut(usize),
}

impl Rows {
    /// Creates rows of numbers, rounded like [`Cell::number`]. Of equal adjacent rows, one is kept.
    #[must_use]
    pub fn series<const COLUMNS: usize>(rows: impl ExactSizeIterator<Item = [Option<f64>; COLUMNS]>) -> Self {
        let mut values: Vec<f64> = Vec::with_capacity(rows.len() * COLUMNS);
        let mut before = None;
        for row in rows {
            let row = row.map(|value| value.and_then(rounded).unwrap_or(f64::NAN));
            let said = Some(row.map(f64::to_bits));
            if said != before {
                values.extend(row);
                before = said;
            }
        }
        Self(Held::Series { columns: COLUMNS, values })
    }

    /// Creates the count of rows that are left out because they would exceed the sheet.
    #[must_use]
    pub const fn left_out(count: usize) -> Self {
        Self(Held::LeftOut(count))
    }

    /// Creates rows of `columns` numbers, without rounding or merging.
    #[must_use]
    pub fn numbered(columns: usize, values: impl Iterator<Item = f64>) -> Self {
        Self(Held::Series { columns, values: values.map(|value| rounded(value).unwrap_or(f64::NAN)).collect() })
    }

    /// Returns the number of rows, including those that are not computed.
    #[must_use]
    pub const fn len(&self) -> usize {
        match &self.0 {
            Held::Listed(rows) => rows.len(),
            Held::Series { columns: 0, .. } => 0,
            Held::Series { columns, values } => values.len() / *columns,
            Held::LeftOut(count) => *count,
        }
    }

    /// Returns `true` if there are no rows.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Iterates over the rows; without those that are not computed.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Cow<'_, [Cell]>> {
        let made = if matches!(self.0, Held::LeftOut(_)) { 0 } else { self.len() };
        (0..made).map(|row| self.get(row).unwrap_or_default())
    }

    /// Returns the row at an index.
    #[must_use]
    pub fn get(&self, row: usize) -> Option<Cow<'_, [Cell]>> {
        match &self.0 {
            Held::Listed(rows) => rows.get(row).map(|row| Cow::Borrowed(row.as_slice())),
            Held::Series { columns, values } => {
                let row = values.chunks_exact((*columns).max(1)).nth(row)?;
                Some(row.iter().map(|value| held(*value)).collect())
            }
            Held::LeftOut(_) => None,
        }
    }

    /// Returns the numbers of a column.
    pub fn numbers(&self, column: usize) -> impl ExactSizeIterator<Item = Option<f64>> {
        let made = if matches!(self.0, Held::LeftOut(_)) { 0 } else { self.len() };
        (0..made).map(move |row| match &self.0 {
            Held::Listed(rows) => rows.get(row)?.get(column)?.as_number(),
            Held::Series { columns, values } => {
                let inside = column < *columns;
                values.get(row * columns + column).copied().filter(|value| inside && !value.is_nan())
            }
            Held::LeftOut(_) => None,
        })
    }
}

/// Returns a value of a series as a cell.
fn held(value: f64) -> Cell {
    if value.is_nan() { Cell::Empty } else { Cell::Number(value) }
}

impl FromIterator<Vec<Cell>> for Rows {
    fn from_iter<I: IntoIterator<Item = Vec<Cell>>>(rows: I) -> Self {
        Self(Held::Listed(rows.into_iter().collect()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_series_says_what_the_same_cells_would() {
        let rows = [[Some(0.1 + 0.2), None], [Some(0.3), Some(f64::INFINITY)], [Some(-0.0), Some(2.0)]];
        let series = Rows::series(rows.into_iter());
        let listed = [[Cell::number(0.3), Cell::Empty], [Cell::number(0.0), Cell::number(2.0)]];
        let listed: Rows = listed.into_iter().map(Vec::from).collect();
        assert_eq!(series.len(), 2, "of the two that say the same there is one");
        assert!(series.iter().eq(listed.iter()));
        for column in 0..3 {
            assert!(series.numbers(column).eq(listed.numbers(column)), "{column}");
        }
        assert_eq!((series.get(1), series.get(2)), (listed.get(1), None));
    }

    #[test]
    fn what_is_left_out_is_counted_alone() {
        let rows = Rows::left_out(7);
        assert_eq!((rows.len(), rows.is_empty(), rows.iter().len(), rows.numbers(0).len()), (7, false, 0, 0));
        assert_eq!(rows.get(0), None);
    }
}

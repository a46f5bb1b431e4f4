//! A table as plain data.

use crate::rows::Rows;
use quantities::Unit;
use quantities::unit::ONE;

/// Content of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnContent {
    /// Text.
    Text,
    /// An identifier for data exchange; hidden in a workbook, whose readers have the words beside it.
    Id,
    /// A number in the unit of the column.
    Number,
    /// A whole number.
    Count,
    /// A ratio of which 1 is the whole: a utilisation, a margin. Marked and coloured close to 1 and above.
    Share,
    /// A ratio to a recommendation or a class, which is no margin; neither marked nor coloured.
    Ratio,
    /// A word of a fixed set, also shown by colour.
    Verdict,
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name in data exchange.
    pub name: String,
    /// Heading for readers.
    pub title: String,
    /// Unit of its numbers; `None` for texts, and if another column names the unit of each row.
    pub unit: Option<&'static Unit>,
    /// Meaning and origin.
    pub about: String,
    /// Content.
    pub kind: ColumnContent,
}

/// Simple formula by which a column follows from others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Derived {
    /// |value| / |limit|, or the other way round where the value must not be less.
    Utilisation {
        /// Column of the ratio.
        column: usize,
        /// Column of the values.
        value: usize,
        /// Column of the limits.
        limit: usize,
        /// Column of the directions: `at_most` or `at_least`.
        direction: usize,
    },
    /// One minus the utilisation.
    Margin {
        /// Column of the margin.
        column: usize,
        /// Column of the utilisation.
        utilisation: usize,
    },
}

/// A table.
#[derive(Clone, Debug)]
pub struct Table {
    /// Name in data exchange.
    pub name: &'static str,
    /// Title for readers; short enough for a sheet.
    pub title: String,
    /// Content of the table.
    pub about: String,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, each with a cell for every column.
    pub rows: Rows,
    /// Columns that follow from others.
    pub derived: Vec<Derived>,
}

impl Table {
    /// Returns the index of a column.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name == name)
    }

    /// Returns the numbers of a column, in the order of the rows.
    pub fn numbers(&self, column: usize) -> impl Iterator<Item = Option<f64>> {
        self.rows.numbers(column)
    }
}

impl Column {
    /// Returns the unit in data exchange, if there is one.
    #[must_use]
    pub fn unit_json(&self) -> Option<&'static str> {
        self.unit.map(|unit| unit.json)
    }

    /// Returns the name with its unit as in a header: `time [s]`.
    #[must_use]
    pub fn header(&self) -> String {
        match self.unit {
            Some(unit) if *unit != ONE => format!("{} [{}]", self.name, unit.json),
            _ => self.name.clone(),
        }
    }

    /// Returns `true` if it contains numbers.
    #[must_use]
    pub const fn is_numeric(&self) -> bool {
        matches!(self.kind, ColumnContent::Number | ColumnContent::Count | ColumnContent::Share | ColumnContent::Ratio)
    }
}

//! Faults of a table whose columns are keys of a project.

use quantities::Unit;

/// One fault of a table whose columns are keys.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TabularFault {
    /// A heading of a table whose values cannot differ from row to row.
    NoColumn {
        /// Path of the key.
        path: String,
    },
    /// A heading with a unit for a key without one.
    UnitOfNoQuantity {
        /// Path of the key.
        path: String,
        /// Unit.
        unit: String,
    },
    /// A heading that counts the entries of a list, in a table of which one heading counts from zero.
    CountsFromZero {
        /// Key as written.
        path: String,
    },
    /// A column without a heading.
    NoHeading {
        /// Number of the column, from one.
        number: usize,
    },
    /// Two headings of a table with the same key.
    ColumnTwice {
        /// Path of the key.
        path: String,
    },
    /// A heading with an entry of a list that the project lacks.
    NoEntry {
        /// Path of the key.
        path: String,
        /// Number of entries of the list.
        count: usize,
    },
    /// A heading for the cycle of a motion of which no dwell states the cycle.
    NoCycle {
        /// Heading as written, without its unit.
        path: String,
    },
    /// A cell of a table without a value.
    NoValue {
        /// Path of the key.
        path: String,
    },
    /// A column of a table in which every separator may be decimal or separate thousands.
    ThousandsPossible {
        /// Path of the key.
        path: String,
        /// First such value as written.
        written: String,
    },
    /// A cell of a table whose value is not a number.
    NotANumber {
        /// Path of the key.
        path: String,
        /// Value as written, shortened.
        written: String,
    },
    /// A cell of a table whose number has another unit than its column.
    UnitOfCell {
        /// Path of the key.
        path: String,
        /// Value as written, shortened.
        written: String,
        /// Unit of the column.
        unit: &'static Unit,
    },
    /// A cell of a table with a number for a key that needs a text.
    NoText {
        /// Path of the key.
        path: String,
        /// Value as written.
        written: String,
    },
    /// A column of a table whose cells are neither numbers nor texts.
    CellType {
        /// Path of the key.
        path: String,
        /// Type found.
        found: String,
    },
    /// A line of a table whose number of cells differs from that of the headings.
    Ragged {
        /// Line number, from one.
        line: u64,
        /// Number of cells.
        found: usize,
        /// Number of headings.
        expected: usize,
    },
    /// A line of whole numbers with more cells than headings: commas that separate cells are decimal signs as well.
    CommasTwice {
        /// Line number, from one.
        line: u64,
        /// Number of cells.
        found: usize,
        /// Number of headings.
        expected: usize,
    },
    /// A line of a table with an unterminated quoted cell.
    OpenQuote {
        /// Line number, from one.
        line: u64,
    },
    /// A number of a table with another decimal mark than numbers before it.
    DecimalMixed {
        /// Path of the key.
        path: String,
        /// Value as written, shortened.
        written: String,
        /// The value has a comma.
        has_comma: bool,
    },
    /// A line of a table that is too long.
    LongLine {
        /// Line number, from one.
        line: u64,
        /// Largest number of bytes of a line.
        most: usize,
    },
    /// A table without rows.
    NoRows,
    /// A table without columns.
    NoColumns,
}

impl TabularFault {
    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(&self) -> &'static str {
        match self {
            Self::NoColumn { .. } => "no_column",
            Self::UnitOfNoQuantity { .. } => "unit_of_no_quantity",
            Self::CountsFromZero { .. } => "counts_from_zero",
            Self::NoHeading { .. } => "no_heading",
            Self::ColumnTwice { .. } => "column_twice",
            Self::NoEntry { .. } => "no_entry",
            Self::NoCycle { .. } => "no_cycle",
            Self::NoValue { .. } => "no_value",
            Self::NotANumber { .. } => "not_a_number",
            Self::UnitOfCell { .. } => "unit_of_cell",
            Self::NoText { .. } => "no_text",
            Self::CellType { .. } => "cell_type",
            Self::Ragged { .. } => "ragged",
            Self::CommasTwice { .. } => "commas_twice",
            Self::OpenQuote { .. } => "open_quote",
            Self::DecimalMixed { .. } => "decimal_mixed",
            Self::ThousandsPossible { .. } => "thousands_possible",
            Self::LongLine { .. } => "long_line",
            Self::NoRows => "no_rows",
            Self::NoColumns => "no_columns",
        }
    }
}

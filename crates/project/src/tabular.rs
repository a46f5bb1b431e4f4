//! What can be wrong with a table whose columns are keys of a project.

/// One fault of a table whose columns are keys.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TabularFault {
    /// A heading of a table whose values cannot differ from row to row.
    NoColumn {
        /// Path of the key.
        path: String,
    },
    /// A heading that states a unit of what is measured in none.
    UnitOfNoQuantity {
        /// Path of the key.
        path: String,
        /// The unit.
        unit: String,
    },
    /// A heading that counts the entries of a list, in a table of which one heading counts from zero.
    CountsFromZero {
        /// The key as it is written.
        path: String,
    },
    /// Two headings of a table with the same key.
    ColumnTwice {
        /// Path of the key.
        path: String,
    },
    /// A heading with an entry of a list that the project does not have.
    NoEntry {
        /// Path of the key.
        path: String,
        /// How many entries it has.
        count: usize,
    },
    /// A cell of a table without a value.
    NoValue {
        /// Path of the key.
        path: String,
    },
    /// A cell of a table with something else than a number.
    NotANumber {
        /// Path of the key.
        path: String,
        /// As written, shortened.
        written: String,
    },
    /// A cell of a table with a number where a text belongs.
    NoText {
        /// Path of the key.
        path: String,
        /// As written.
        written: String,
    },
    /// A column of a table whose cells are neither numbers nor texts.
    CellType {
        /// Path of the key.
        path: String,
        /// What stands there.
        found: String,
    },
    /// A line of a table with another number of cells than there are headings.
    Ragged {
        /// The line, counted from one.
        line: u64,
        /// How many cells it has.
        found: usize,
        /// How many headings there are.
        expected: usize,
    },
    /// A line of a table in which a quoted cell does not end.
    OpenQuote {
        /// The line, counted from one.
        line: u64,
    },
    /// A number of a table with the other decimal sign than numbers before it.
    DecimalMixed {
        /// Path of the key.
        path: String,
        /// As written, shortened.
        written: String,
        /// Whether this one has a comma.
        has_comma: bool,
    },
    /// A line of a table that is too long.
    LongLine {
        /// The line, counted from one.
        line: u64,
        /// Bytes of the longest.
        most: usize,
    },
    /// A table without a row.
    NoRows,
    /// A table without a column.
    NoColumns,
}

impl TabularFault {
    /// The identifier used in data exchange.
    #[must_use]
    pub const fn id(&self) -> &'static str {
        match self {
            Self::NoColumn { .. } => "no_column",
            Self::UnitOfNoQuantity { .. } => "unit_of_no_quantity",
            Self::CountsFromZero { .. } => "counts_from_zero",
            Self::ColumnTwice { .. } => "column_twice",
            Self::NoEntry { .. } => "no_entry",
            Self::NoValue { .. } => "no_value",
            Self::NotANumber { .. } => "not_a_number",
            Self::NoText { .. } => "no_text",
            Self::CellType { .. } => "cell_type",
            Self::Ragged { .. } => "ragged",
            Self::OpenQuote { .. } => "open_quote",
            Self::DecimalMixed { .. } => "decimal_mixed",
            Self::LongLine { .. } => "long_line",
            Self::NoRows => "no_rows",
            Self::NoColumns => "no_columns",
        }
    }
}

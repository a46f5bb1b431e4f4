//! Records of commands that write files.

use crate::{Fit, Number, Units};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// `report`: the file that was written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ReportWritten {
    /// Its path as given.
    pub file: String,
    /// Ordering code, or name of the project's own actuator; left out where the report is about several axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// Whether nothing speaks against it, or against any of several.
    pub verdict: Fit,
    /// With several axes only: each with its actuator.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub axes: Vec<AxisWritten>,
    /// Size of the file.
    pub bytes: usize,
}

/// An axis in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct AxisWritten {
    /// Its name.
    pub axis: String,
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// Whether nothing speaks against it.
    pub verdict: Fit,
}

/// `export --out`: the file that was written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ExportWritten {
    /// Its path as given.
    pub file: String,
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// Whether nothing speaks against it.
    pub verdict: Fit,
    /// The tables in it.
    pub tables: Vec<TableWritten>,
    /// Tables that it does not have, because they are too long for a sheet of a workbook.
    pub left_out: Vec<TableWritten>,
}

/// A table in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct TableWritten {
    /// Its name.
    pub name: String,
    /// How many rows it has.
    pub rows: usize,
}

/// `new --out`: the files that were written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct FilesWritten {
    /// Their paths.
    pub files: Vec<String>,
}

/// `plot`: the picture that was written.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PlotWritten {
    /// Id of the figure.
    pub figure: &'static str,
    /// The first of the files; `null` where it went to standard output.
    pub file: Option<String>,
    /// All files.
    pub files: Vec<String>,
    /// Width of the picture.
    pub width: Number,
    /// Height of the picture.
    pub height: Number,
    /// Units of both.
    pub units: Units,
    /// Its title.
    pub title: String,
    /// The line below it.
    pub caption: String,
    /// Description of the picture, for screen readers.
    pub description: String,
}

/// `export --table`: one table of the results.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "Table", bound = "")]
pub struct Table<Rows = Vec<TableRow<'static>>> {
    /// Its name.
    pub table: &'static str,
    /// Its title.
    pub title: String,
    /// What it holds.
    pub about: String,
    /// What each column means.
    pub columns: Vec<TableColumn>,
    /// A record for each row, by the names of the columns.
    #[schemars(with = "Vec<TableRow<'static>>")]
    pub rows: Rows,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct TableColumn {
    /// Its name in the rows.
    pub name: String,
    /// Its heading.
    pub title: String,
    /// What it holds.
    pub kind: ColumnKind,
    /// Unit of its numbers; `null` for words, and where another column names the unit of each row.
    pub unit: Option<&'static str>,
    /// What it means and where it comes from.
    pub about: String,
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ColumnKind {
    /// Text.
    Text,
    /// Numbers.
    Number,
    /// Whole numbers.
    Count,
    /// A word of a fixed set.
    Word,
}

/// A row: a value for each column.
#[derive(Clone, Debug, PartialEq, JsonSchema)]
#[schemars(with = "std::collections::BTreeMap<String, TableCell>")]
pub struct TableRow<'a>(pub Vec<(&'a str, TableCell)>);

impl Serialize for TableRow<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, cell)| (name, cell)))
    }
}

/// A value of a table.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum TableCell {
    /// There is none.
    Empty,
    /// A number.
    Number(Number),
    /// Words.
    Text(String),
}

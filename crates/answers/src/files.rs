//! Records of commands that write files.

use crate::{Fit, Number, Units};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// `report`: the file written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ReportWritten {
    /// Path as given.
    pub file: String,
    /// Ordering code, or name of the project's own actuator; omitted for several axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// Verdict on the actuator, or the worst verdict of several.
    pub verdict: Fit,
    /// Axes with their actuators; only with several axes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub axes: Vec<AxisWritten>,
    /// Size of the file in bytes.
    pub bytes: usize,
}

/// An axis in a report.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct AxisWritten {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// Verdict on the actuator.
    pub verdict: Fit,
}

/// `export --out`: the file written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ExportWritten {
    /// Path as given.
    pub file: String,
    /// Ordering code, or name of the project's own actuator; absent for several axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub code: Option<String>,
    /// Verdict on the actuator; of several axes the worst.
    pub verdict: Fit,
    /// Tables in the file; empty for several axes.
    pub tables: Vec<TableWritten>,
    /// Tables left out because they are too long for a sheet of a workbook; empty for several axes.
    pub left_out: Vec<TableWritten>,
    /// Several axes, in the order of the sheets; absent for one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub axes: Vec<AxisExported>,
}

/// One of several axes of a workbook.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct AxisExported {
    /// Name of the axis.
    pub axis: String,
    /// Ordering code, or name of the project's own actuator.
    pub code: String,
    /// Verdict on the actuator.
    pub verdict: Fit,
    /// Tables in the file.
    pub tables: Vec<TableWritten>,
    /// Tables left out because they are too long for a sheet.
    pub left_out: Vec<TableWritten>,
}

/// A table in a file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct TableWritten {
    /// Name of the table.
    pub name: String,
    /// Number of rows.
    pub rows: usize,
}

/// `new --out`: the files written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct FilesWritten {
    /// Paths of the files.
    pub files: Vec<String>,
}

/// `plot`: the picture written.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PlotWritten {
    /// Id of the figure.
    pub figure: &'static str,
    /// Path of the first file; `null` for standard output.
    pub file: Option<String>,
    /// Paths of the files.
    pub files: Vec<String>,
    /// Width of the picture.
    pub width: Number,
    /// Height of the picture.
    pub height: Number,
    /// Units of width and height.
    pub units: Units,
    /// Title of the picture.
    pub title: String,
    /// Caption below the picture.
    pub caption: String,
    /// Description of the picture, for screen readers.
    pub description: String,
}

/// `export --table`: one table of the results.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "Table", bound = "")]
pub struct Table<Rows = Vec<TableRow<'static>>> {
    /// Name of the table.
    pub table: &'static str,
    /// Title of the table.
    pub title: String,
    /// Content of the table.
    pub about: String,
    /// Descriptions of the columns.
    pub columns: Vec<TableColumn>,
    /// One record per row, by the names of the columns.
    #[schemars(with = "Vec<TableRow<'static>>")]
    pub rows: Rows,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct TableColumn {
    /// Name of the column in the rows.
    pub name: String,
    /// Heading of the column.
    pub title: String,
    /// Type of the values.
    pub kind: ColumnKind,
    /// Unit of the numbers; `null` for text, and if another column has the unit of each row.
    pub unit: Option<&'static str>,
    /// Meaning and source of the values.
    pub about: String,
}

/// Type of the values of a column.
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

/// A row with a value for each column.
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
    /// No value.
    Empty,
    /// A number.
    Number(Number),
    /// Text.
    Text(String),
}

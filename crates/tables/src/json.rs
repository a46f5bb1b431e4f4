//! A table as a record.

use crate::cell::Cell;
use crate::table::{Column, ColumnContent, Table};
use answers::{ColumnKind, Number, TableCell, TableColumn, TableRow};
use serde::{Serialize, Serializer};

/// Returns the table as one record: the meaning of each column, and a record for each row.
#[must_use]
pub fn record(table: &Table) -> answers::Table<Records<'_>> {
    answers::Table {
        table: table.name,
        title: table.title.clone(),
        about: table.about.clone(),
        columns: table.columns.iter().map(column).collect(),
        rows: Records(table),
    }
}

/// Records of the rows of a table, created while they are written.
#[derive(Clone, Copy, Debug)]
pub struct Records<'t>(&'t Table);

impl Serialize for Records<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let names = || self.0.columns.iter().map(|column| column.name.as_str());
        serializer.collect_seq(self.0.rows.iter().map(|row| TableRow(names().zip(row.iter().map(cell)).collect())))
    }
}

fn column(column: &Column) -> TableColumn {
    TableColumn {
        name: column.name.clone(),
        title: column.title.clone(),
        kind: match column.kind {
            ColumnContent::Text | ColumnContent::Id => ColumnKind::Text,
            ColumnContent::Number | ColumnContent::Share | ColumnContent::Ratio => ColumnKind::Number,
            ColumnContent::Count => ColumnKind::Count,
            ColumnContent::Verdict => ColumnKind::Word,
        },
        unit: column.unit_json(),
        about: column.about.clone(),
    }
}

fn cell(cell: &Cell) -> TableCell {
    match cell {
        Cell::Empty => TableCell::Empty,
        Cell::Number(number) => TableCell::Number(Number(*number)),
        Cell::Text(text) => TableCell::Text(text.clone()),
        Cell::Word(id, _) => TableCell::Text((*id).to_owned()),
        Cell::Ids(ids, _) => TableCell::Text(ids.clone()),
    }
}

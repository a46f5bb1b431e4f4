//! A table as JSON.

use crate::table::{Cell, Column, Kind, Table};
use serde_json::{Map, Value, json};

/// A table as one JSON object: what each column means, and a record for each row.
#[must_use]
pub fn json(table: &Table) -> Value {
    let rows: Vec<Value> = table
        .rows
        .iter()
        .map(|row| {
            let names = table.columns.iter().map(|column| column.name.clone());
            Value::Object(names.zip(row.iter().map(value)).collect::<Map<String, Value>>())
        })
        .collect();
    json!({
        "table": table.name,
        "title": table.title,
        "about": table.about,
        "columns": table.columns.iter().map(column).collect::<Vec<_>>(),
        "rows": rows,
    })
}

fn column(column: &Column) -> Value {
    let kind = match column.kind {
        Kind::Text => "text",
        Kind::Number | Kind::Share => "number",
        Kind::Count => "count",
        Kind::Verdict => "word",
    };
    json!({
        "name": column.name,
        "title": column.title,
        "kind": kind,
        "unit": column.unit_json(),
        "about": column.about,
    })
}

fn value(cell: &Cell) -> Value {
    match cell {
        Cell::Empty => Value::Null,
        Cell::Number(number) => json!(number),
        Cell::Text(text) => json!(text),
        Cell::Word(id, _) => json!(id),
    }
}

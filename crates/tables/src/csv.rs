//! A table as CSV.

use crate::table::{Cell, Table};

/// A table as CSV (RFC 4180): UTF-8, a header `name [unit]`, commas, decimal points, lines ended by CR LF.
#[must_use]
pub fn csv(table: &Table) -> String {
    let mut out = String::new();
    let heads: Vec<String> = table.columns.iter().map(|column| quoted(&column.header())).collect();
    line(&mut out, &heads);
    for row in &table.rows {
        let fields: Vec<String> = row.iter().map(field).collect();
        line(&mut out, &fields);
    }
    out
}

fn line(out: &mut String, fields: &[String]) {
    // A line with nothing in it would be no record.
    if let [only] = fields
        && only.is_empty()
    {
        out.push_str("\"\"");
    }
    out.push_str(&fields.join(","));
    out.push_str("\r\n");
}

fn field(cell: &Cell) -> String {
    match cell {
        Cell::Empty => String::new(),
        Cell::Number(number) => number.to_string(),
        Cell::Text(text) => quoted(text),
        Cell::Word(id, _) => quoted(id),
    }
}

fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

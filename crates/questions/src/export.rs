//! The catalogue in long form: one row per cell of the manual.

use crate::sweep::csv::quoted;
use catalogue::Cell;

/// Columns of the long form, part of the contract with scripts.
pub(crate) const EXPORT_COLUMNS: [&str; 10] =
    ["drive", "feedback", "ratio", "symbol", "condition", "printed", "value", "unit", "table", "erratum"];

/// Iterates over the cells, in the order of [`EXPORT_COLUMNS`]; several errata of one cell are joined by `;`.
pub(crate) fn export_rows() -> impl Iterator<Item = (&'static Cell, [String; 10])> {
    catalogue::cells().map(|cell| {
        let row = [
            cell.place.drive.to_owned(),
            cell.feedback.to_owned(),
            cell.place.ratio.to_owned(),
            cell.place.symbol.to_owned(),
            cell.place.condition.to_owned(),
            cell.printed.to_owned(),
            cell.value_text(),
            cell.unit.to_owned(),
            cell.place.table.to_owned(),
            cell.errata.join(";"),
        ];
        (cell, row)
    })
}

/// Returns the long form as CSV (RFC 4180), with a header line.
#[must_use]
pub fn export_csv() -> String {
    let mut out = EXPORT_COLUMNS.join(",");
    out.push('\n');
    for (_, row) in export_rows() {
        let fields: Vec<_> = row.iter().map(|field| quoted(field)).collect();
        out.push_str(&fields.join(","));
        out.push('\n');
    }
    out
}

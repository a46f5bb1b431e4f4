//! A table as CSV.

use crate::cell::Cell;
use crate::table::Table;
use questions::sweep::csv::quoted;
use std::fmt::Write as _;

/// Writes a table as CSV (RFC 4180): UTF-8, a header `name [unit]`, commas, decimal points, lines ended by CR LF. A
/// text that a spreadsheet would evaluate is preceded by an apostrophe, which marks it as text; numbers are unchanged.
#[must_use]
pub fn csv(table: &Table) -> String {
    // Estimated for a series of numbers; texts extend it.
    let mut out = String::with_capacity(table.rows.iter().len() * table.columns.len() * NUMBER_BYTES);
    for (place, column) in table.columns.iter().enumerate() {
        begin(&mut out, place);
        out.push_str(&quoted(&column.header()));
    }
    out.push_str("\r\n");
    for row in table.rows.iter() {
        let begun = out.len();
        for (place, cell) in row.iter().enumerate() {
            begin(&mut out, place);
            field(&mut out, cell);
        }
        // An empty line would be no record.
        if out.len() == begun {
            out.push_str("\"\"");
        }
        out.push_str("\r\n");
    }
    out
}

/// Typical bytes of a number with its comma in a series.
const NUMBER_BYTES: usize = 13;

fn begin(out: &mut String, place: usize) {
    if place > 0 {
        out.push(',');
    }
}

fn field(out: &mut String, cell: &Cell) {
    match cell {
        Cell::Empty => {}
        // Writing to a string cannot fail.
        Cell::Number(number) => drop(write!(out, "{number}")),
        Cell::Text(text) if is_formula(text) => out.push_str(&quoted(&format!("'{text}"))),
        Cell::Text(text) => out.push_str(&quoted(text)),
        Cell::Word(id, _) => out.push_str(&quoted(id)),
        Cell::Ids(ids, _) => out.push_str(&quoted(ids)),
    }
}

/// Returns `true` if a spreadsheet would evaluate a text as a formula, by its first character, unless it is a number
/// with its unit.
fn is_formula(text: &str) -> bool {
    let begins = text.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']);
    let is_quantity = || {
        let is_unit = |unit: &str| {
            unit.starts_with("1/") || unit.starts_with(|sign: char| sign.is_alphabetic() || "°%".contains(sign))
        };
        let number = text.split_once(' ').filter(|(_, unit)| is_unit(unit));
        let unit = |sign: char| sign.is_alphanumeric() || " /^·°²³µ%±.".contains(sign);
        number.is_some_and(|(number, rest)| number.parse::<f64>().is_ok() && rest.chars().all(unit))
    };
    begins && !is_quantity()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn field(cell: &Cell) -> String {
        let mut out = String::new();
        super::field(&mut out, cell);
        out
    }

    #[test]
    fn a_text_that_would_be_calculated_stands_behind_an_apostrophe() {
        for text in
            ["=cmd|' /C calc'!A0", "@SUM(1+1)", "+1+1", "-1+1", "-1 m+cmd|x", "\t=1", "\r=1", "-", "=", "-2 (x)"]
        {
            assert!(field(&Cell::Text(text.to_owned())).trim_start_matches('"').starts_with('\''), "{text}");
        }
        for text in ["-20 degC", "+5 N m", "-1e3 1/min", "axis", "1+1", "'=1", ""] {
            let written = field(&Cell::Text(text.to_owned()));
            assert_eq!(written, text);
        }
        assert_eq!(field(&Cell::Number(-1.5)), "-1.5");
        assert_eq!(field(&Cell::Text("=A1,\"x\"".to_owned())), "\"'=A1,\"\"x\"\"\"");
    }
}

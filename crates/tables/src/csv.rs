//! A table as CSV.

use crate::table::{Cell, Table};

/// A table as CSV (RFC 4180): UTF-8, a header `name [unit]`, commas, decimal points, lines ended by CR LF. A text that a
/// spreadsheet would calculate stands behind an apostrophe, which tells it that this is text; numbers stay as they are.
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
        Cell::Text(text) if is_formula(text) => quoted(&format!("'{text}")),
        Cell::Text(text) => quoted(text),
        Cell::Word(id, _) => quoted(id),
    }
}

/// Whether a spreadsheet would take a text for a formula: by its first sign, unless it is a number with its unit.
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

fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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

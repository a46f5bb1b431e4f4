//! Rows of a CSV that hold units, and rows that hold values.

use crate::columns::Picks;
use crate::encoding;
use crate::number::is_value;
use quantities::Unit;

/// Returns the row as units if no cell in use is a number. A dash beside a unit is none.
pub(crate) fn unit_row(row: &[Vec<u8>], picks: &Picks) -> Option<Vec<String>> {
    let mut texts: Vec<String> = row.iter().map(|cell| unbracketed(&encoding::text(cell))).collect();
    let used: Vec<&String> =
        picks.iter().flatten().filter_map(|pick| texts.get(pick.index)).filter(|text| !text.is_empty()).collect();
    // A missing value in the first sample is no unit.
    let is_missing = |text: &str| ["na", "n/a", "null", "none", "-"].contains(&text.to_lowercase().as_str());
    let has_unit = used.iter().any(|text| !is_value(text) && Unit::of(text).is_some());
    let are_texts = used.iter().all(|text| !is_value(text) && (has_unit || !is_missing(text)));
    if used.is_empty() || !are_texts {
        return None;
    }
    texts.iter_mut().filter(|text| is_missing(text)).for_each(String::clear);
    Some(texts)
}

/// Returns `true` if a cell of the row is a number, with or without a unit.
pub(crate) fn holds_number(row: &[Vec<u8>]) -> bool {
    row.iter().any(|cell| is_value(&encoding::text(cell)))
}

/// Returns `true` if a cell of the row is a number other than `1`, the unit of a ratio.
pub(crate) fn is_row_of_values(row: &[Vec<u8>]) -> bool {
    row.iter().map(|cell| encoding::text(cell)).any(|cell| is_value(&cell) && unbracketed(&cell) != "1")
}

/// Returns a text without the brackets around it.
pub(crate) fn unbracketed(text: &str) -> String {
    let text = text.trim();
    let inner =
        [('[', ']'), ('(', ')')].iter().find_map(|(open, close)| text.strip_prefix(*open)?.strip_suffix(*close));
    inner.unwrap_or(text).trim().to_owned()
}

//! Faults of the rows and cells of a CSV.

use crate::encoding;
use crate::faults::{Fault, FileRow, excerpt};
use crate::number::{Bad, is_grouped, is_value};
use crate::thousands::may_be_grouped;

/// Returns the fault of a row with more or fewer cells than the header; commas that separate cells `may_be_twice` decimal signs
/// as well, where the cells are whole numbers.
pub(crate) fn ragged(line: &[u8], (number, found, expected): (u64, usize, usize), may_be_twice: bool) -> Fault {
    let is_whole = |cell: &[u8]| cell.iter().all(|sign| sign.is_ascii_digit() || b"+- ".contains(sign));
    let are_decimal =
        may_be_twice && (expected..=2 * expected).contains(&found) && line.split(|sign| *sign == b',').all(is_whole);
    match are_decimal {
        true => Fault::CommasTwice { line: number, found, expected },
        false => Fault::Ragged { line: number, found, expected },
    }
}

/// Returns the fault of a cell.
pub(crate) fn cell_fault(bad: Bad, line: u64, column: &str, cell: &[u8]) -> Fault {
    let (at, column) = (FileRow::Line(line), column.to_owned());
    if let Bad::OtherUnit(unit) = bad {
        let text = encoding::text(cell);
        let is_quotable = is_value(&text);
        return Fault::UnitOfCell { at, column, text: Some(excerpt(text.trim())).filter(|_| is_quotable), unit };
    }
    let Some(text) = shown(String::from_utf8_lossy(cell).trim()) else {
        let is_empty = matches!(bad, Bad::Missing);
        return if is_empty {
            Fault::ValueMissing { at, column }
        } else {
            Fault::ValueUnreadable { at, column, text: None }
        };
    };
    match bad {
        // Where commas do not separate the cells, a single number with the other sign is one of two decimal signs.
        Bad::Unreadable if may_be_grouped(&text) => Fault::ThousandsGrouped { at, column, text },
        Bad::Unreadable | Bad::Mixed(_) if is_grouped(&text) => Fault::ThousandsGrouped { at, column, text },
        Bad::Missing => Fault::ValueMissing { at, column },
        Bad::Unreadable | Bad::OtherUnit(_) => Fault::ValueUnreadable { at, column, text: Some(text) },
        Bad::NotFinite => Fault::ValueNotFinite { at, column, text },
        Bad::Implausible => Fault::ValueImplausible { at, column, text },
        Bad::Mixed(decided) => Fault::DecimalMixed { line, column, text, decided },
    }
}

/// Returns the fault of a cell of time. Where the other sign is decimal, one before three digits separates thousands.
pub(crate) fn time_fault(bad: Bad, line: u64, column: &str, cell: &[u8]) -> Fault {
    match cell_fault(bad, line, column, cell) {
        Fault::DecimalMixed { column, text, .. } if may_be_grouped(&text) => {
            Fault::ThousandsGrouped { at: FileRow::Line(line), column, text }
        }
        fault => fault,
    }
}

/// Words that loggers write instead of a number.
const NO_VALUES: [&str; 24] = [
    "nan",
    "inf",
    "infinity",
    "ovl",
    "ovr",
    "ovfl",
    "ol",
    "o.l",
    "over",
    "overflow",
    "overrange",
    "under",
    "underflow",
    "na",
    "n/a",
    "#n/a",
    "#nv",
    "null",
    "none",
    "bad",
    "invalid",
    "error",
    "off",
    "open",
];

/// Returns the text of a cell for a fault if it is written like a number or a time of day, or stands for a missing one; other text
/// of a file is not quoted.
fn shown(cell: &str) -> Option<String> {
    let may_stand = |sign: char| sign.is_ascii_digit() || "#+-.,:/'’ eE\u{a0}\u{202f}".contains(sign);
    let is_number = cell.chars().all(may_stand) && cell.contains(|sign: char| sign.is_ascii_digit());
    let word = cell.trim_start_matches(['+', '-']).to_lowercase();
    let is_word = NO_VALUES.contains(&word.as_str()) || !cell.is_empty() && cell.chars().all(|sign| sign == '-');
    (is_number || is_word).then(|| excerpt(cell))
}

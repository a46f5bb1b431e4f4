//! Beginning of a CSV for display.

use crate::ahead::Ahead;
use crate::cells::CellSplitter;
use crate::collected::FaultCollector;
use crate::csv::advance;
use crate::encoding;
use crate::faults::excerpt;
use crate::number::Decimals;
use std::io::Read;

/// Beginning of a file as written, even if it cannot be read as a recording.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Preview {
    /// Names of the columns.
    pub headings: Vec<String>,
    /// First rows; one of them may hold the units.
    pub rows: Vec<Vec<String>>,
}

/// Maximum number of columns shown.
const SHOWN_MOST: usize = 32;

/// Returns the header of a CSV and up to `rows` rows below it; `None` if there is no number below its first line.
pub fn preview_csv(source: impl Read, rows: usize) -> Option<Preview> {
    let mut lines = Ahead::new(source);
    let mut faults = FaultCollector::default();
    let found = lines.heading(&[]).ok()??;
    if !advance(&mut lines, &mut faults)? {
        return None;
    }
    let mut cells = CellSplitter::new(found.delimiter);
    let mut shown = |lines: &Ahead<_>| {
        let row = cells.all(lines.line(), lines.number(), &mut faults)?;
        Some(row.iter().take(SHOWN_MOST).map(|cell| excerpt(encoding::text(cell).trim())).collect::<Vec<_>>())
    };
    let headings = shown(&lines)?;
    let mut preview = Preview { headings, rows: Vec::new() };
    while preview.rows.len() < rows.max(2) && lines.advance().unwrap_or(false) {
        let Some(row) = shown(&lines) else { break };
        preview.rows.push(row);
    }
    let is_table = preview.rows.iter().take(2).flatten().any(|cell| Decimals::is_number(cell));
    preview.rows.truncate(rows);
    is_table.then_some(preview)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_preview_shows_what_stands_there_and_no_more() {
        let text = "# logged\nt;q [deg];mode;M\ns;;;Nm\n0,0;1,5;auto;2\n0,1;x;auto\n";
        let found = preview_csv(text.as_bytes(), 3).unwrap();
        assert_eq!(found.headings, ["t", "q [deg]", "mode", "M"]);
        assert_eq!(found.rows.len(), 3);
        assert_eq!(found.rows[1], ["0,0", "1,5", "auto", "2"]);
        assert_eq!(found.rows[2], ["0,1", "x", "auto"], "a row that is no row is shown as it is");
        assert_eq!(preview_csv(&b""[..], 3), None);
        assert_eq!(preview_csv(text.as_bytes(), 0).unwrap().rows, Vec::<Vec<String>>::new());
    }
}

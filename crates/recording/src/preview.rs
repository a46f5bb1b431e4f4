//! Beginning of a recording for display, with the roles that its columns are recognised for.

use crate::ahead::Ahead;
use crate::cells::CellSplitter;
use crate::clock::is_clock;
use crate::collected::FaultCollector;
use crate::columns::{Heading, Pick, pick, several_axes, writable};
use crate::csv::advance;
use crate::encoding;
use crate::faults::{Fault, excerpt};
use crate::layout::{Layout, Role};
use crate::limits::COLUMNS_MAX;
use crate::number::Decimals;
use crate::parquet::column_names;
use bytes::Bytes;
use quantities::Unit;
use std::io::Read;

/// Beginning of a file as written, even if it cannot be read as a recording.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Preview {
    /// Columns in their order, at most [`PREVIEW_COLUMNS_MAX`].
    pub columns: Vec<PreviewColumn>,
    /// Number of columns of the file.
    pub count: usize,
    /// First rows; one of them may hold the units.
    pub rows: Vec<Vec<String>>,
}

/// Column of a preview.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PreviewColumn {
    /// Heading as written; shortened if it is long.
    pub heading: String,
    /// Name in a layout: the heading if it names this column alone, else its number, `#3`.
    pub name: String,
    /// Role that the column is recognised for.
    pub role: Option<Role>,
    /// Unit stated in the heading or in the row below it, as written.
    pub unit: Option<String>,
    /// The first rows hold times of a clock, which need no unit.
    pub is_clock: bool,
}

/// Maximum number of columns shown.
pub const PREVIEW_COLUMNS_MAX: usize = 32;

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
        Some(row.iter().map(|cell| encoding::text(cell).trim().to_owned()).take(COLUMNS_MAX).collect::<Vec<_>>())
    };
    let first = shown(&lines)?;
    let mut headings: Vec<Heading> =
        first.iter().map(|cell| Heading::new(if found.is_missing { "" } else { cell })).collect();
    let mut rows_read = if found.is_missing { vec![first] } else { Vec::new() };
    while rows_read.len() < rows.max(2) && lines.advance().unwrap_or(false) {
        let Some(row) = shown(&lines) else { break };
        rows_read.push(row);
    }
    if !rows_read.iter().take(2).flatten().any(|cell| Decimals::is_number(cell)) {
        return None;
    }
    // A row without a number may be that of the units.
    if let Some(below) = rows_read.first().filter(|row| !row.iter().any(|cell| Decimals::is_number(cell))) {
        for (heading, cell) in headings.iter_mut().zip(below) {
            heading.below = Some(cell.clone());
        }
    }
    // Below a row of units the second one is the first of the values.
    for (index, heading) in headings.iter_mut().enumerate() {
        heading.is_clock = rows_read.iter().take(2).any(|row| row.get(index).is_some_and(|cell| is_clock(cell)));
    }
    rows_read.truncate(rows);
    let short = |row: Vec<String>| row.iter().take(PREVIEW_COLUMNS_MAX).map(|cell| excerpt(cell)).collect();
    Some(Preview { rows: rows_read.into_iter().map(short).collect(), ..of_headings(&headings) })
}

/// Returns the columns of a Parquet file.
///
/// # Errors
/// The fault of the file.
pub fn preview_parquet(file: &Bytes) -> Result<Preview, Fault> {
    let names = column_names(file)?;
    Ok(of_headings(&names.iter().map(|name| Heading::new(name)).collect::<Vec<_>>()))
}

fn of_headings(headings: &[Heading]) -> Preview {
    let (mut picks, _) = pick(headings, &Layout::default(), &mut FaultCollector::default());
    // Of the columns of several axes none is recognised but the time.
    if several_axes(headings, &picks, &[]).is_some() {
        picks.iter_mut().skip(1).for_each(|pick| *pick = None);
    }
    let picked = |index: usize| -> Option<(Role, &Pick)> {
        let mut found = Role::ALL.into_iter().zip(&picks).filter_map(|(role, pick)| Some((role, pick.as_ref()?)));
        found.find(|(_, pick)| pick.index == index)
    };
    let is_unit = |text: &&String| Unit::of(text.trim_matches(['[', ']', '(', ')'])).is_some();
    let column = |(index, heading): (usize, &Heading)| {
        let (role, pick) = picked(index).unzip();
        let stated = [pick.and_then(|pick| pick.unit.as_ref()), heading.named.unit.as_ref(), heading.below.as_ref()];
        PreviewColumn {
            heading: excerpt(&heading.written),
            name: writable(headings, heading).unwrap_or_else(|| format!("#{}", index + 1)),
            role,
            unit: stated.into_iter().flatten().find(is_unit).cloned(),
            is_clock: heading.is_clock,
        }
    };
    let columns = headings.iter().enumerate().take(PREVIEW_COLUMNS_MAX).map(column).collect();
    Preview { columns, count: headings.len(), rows: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn headings(preview: &Preview) -> Vec<&str> {
        preview.columns.iter().map(|column| column.heading.as_str()).collect()
    }

    #[test]
    fn a_preview_shows_what_stands_there_and_no_more() {
        let text = "# logged\nt;q [deg];mode;M\ns;;;Nm\n0,0;1,5;auto;2\n0,1;x;auto\n";
        let found = preview_csv(text.as_bytes(), 3).unwrap();
        assert_eq!(headings(&found), ["t", "q [deg]", "mode", "M"]);
        assert_eq!(found.rows.len(), 3);
        assert_eq!(found.rows[1], ["0,0", "1,5", "auto", "2"]);
        assert_eq!(found.rows[2], ["0,1", "x", "auto"], "a row that is no row is shown as it is");
        assert_eq!(preview_csv(&b""[..], 3), None);
        assert_eq!(preview_csv(text.as_bytes(), 0).unwrap().rows, Vec::<Vec<String>>::new());
    }

    #[test]
    fn a_preview_names_role_and_unit_of_each_column() {
        let of = |text: &str| {
            let found = preview_csv(text.as_bytes(), 2).unwrap();
            found.columns.into_iter().map(|column| (column.name, column.role, column.unit)).collect::<Vec<_>>()
        };
        let some = |text: &str| Some(text.to_owned());
        let text = "t;q [deg];mode;M\ns;;;Nm\n0,0;1,5;auto;2\n0,1;1,6;auto;2\n";
        assert_eq!(
            of(text),
            [
                ("t".to_owned(), Some(Role::Time), some("s")),
                ("q [deg]".to_owned(), Some(Role::Position), some("deg")),
                ("mode".to_owned(), None, None),
                ("M".to_owned(), Some(Role::Torque), some("Nm")),
            ]
        );
        // Of two equal candidates neither is recognised; equal headings have numbers.
        let text = "time_s,q1 [deg],q2 [deg],x,x\n0,1,2,3,4\n1,1,2,3,4\n";
        let found = of(text);
        assert_eq!(found[0], ("time_s".to_owned(), Some(Role::Time), some("s")));
        assert!(found[1..].iter().all(|(_, role, _)| role.is_none()), "{found:?}");
        assert_eq!([found[3].0.as_str(), found[4].0.as_str()], ["#4", "#5"]);
        // Without a heading the numbers are the names, and the first line is a row.
        let found = preview_csv(&b"0;1\n1;2\n2;3\n"[..], 2).unwrap();
        let names: Vec<&str> = found.columns.iter().map(|column| column.name.as_str()).collect();
        assert_eq!((names, found.rows[0].as_slice()), (vec!["#1", "#2"], ["0".to_owned(), "1".to_owned()].as_slice()));
    }
}

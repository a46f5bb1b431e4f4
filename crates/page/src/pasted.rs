//! Rows of a spreadsheet as segments of the motion.

use crate::laws;
use crate::markup::tolerance_of;
use crate::value::{stated, unit_of};
use project::{Edit, SegmentLaw, edit, key_at, written};
use quantities::{Language, Unit};

/// Columns of the rows in their order: the law, then the cells of a line, then the other values of a move.
const COLUMNS: [&str; 5] = ["law", "distance", "time", "speed", "acceleration"];

/// Other words of a heading, in lower case.
const HEADINGS: [(&str, &[&str]); 5] = [
    ("law", &["motion law", "bewegungsgesetz", "gesetz"]),
    ("distance", &["way", "travel", "stroke", "angle", "weg", "winkel", "strecke", "hub", "s", "x", "φ", "phi"]),
    ("time", &["duration", "zeit", "dauer", "t"]),
    ("speed", &["velocity", "geschwindigkeit", "drehzahl", "v", "n", "ω"]),
    ("acceleration", &["beschleunigung", "a", "α"]),
];

/// Keys that decide a move, of which a new row states its own.
const OF_A_MOVE: [&str; 12] = [
    "cycle",
    "distance",
    "time",
    "speed",
    "acceleration",
    "jerk",
    "end_speed",
    "accelerate",
    "run",
    "brake",
    "pause",
    "hold",
];

/// Largest number of pasted rows.
const ROWS_MOST: usize = 2000;

/// A column of the rows: its key, and the unit of its heading.
struct PastedColumn {
    key: &'static str,
    unit: String,
}

/// Place of the cell in which rows are pasted.
pub(crate) struct Cell<'c> {
    /// Path of the list: `motion`, or `axis[2].motion`.
    pub(crate) list: &'c str,
    /// Row, from one.
    pub(crate) row: usize,
    /// Column, from zero for the law.
    pub(crate) column: usize,
}

/// Returns the text with the pasted rows. Rows with headings replace the motion; others are written from the cell on,
/// and further segments are added. A number takes the unit of its heading, else that of the cell, else that of its
/// column; what is no value of its key is written as it is, so that all faults are reported together.
pub(crate) fn pasted(text: &str, cell: &Cell<'_>, clip: &str, language: Language) -> Option<String> {
    let rows: Vec<Vec<&str>> = clip
        .lines()
        .filter(|row| !row.trim().is_empty())
        .map(|row| row.split(if row.contains('\t') { '\t' } else { ';' }).map(str::trim).collect())
        .take(ROWS_MOST)
        .collect();
    let first = rows.first()?;
    let (columns, rows, replaces) = match headings(first) {
        Some(columns) => (columns, rows.get(1..).unwrap_or_default(), true),
        None => {
            let columns = COLUMNS.into_iter().skip(cell.column);
            (columns.map(|key| Some(PastedColumn { key, unit: String::new() })).collect(), rows.as_slice(), false)
        }
    };
    if rows.is_empty() {
        return None;
    }
    let list = cell.list;
    let before = written(text)?;
    let value = |path: &str| before.iter().find(|key| key.path == path).and_then(|key| key.value.as_deref());
    let count = (1..).take_while(|place| before.iter().any(|key| key.path == format!("{list}[{place}]"))).count();
    // The unit that the column has so far.
    let usual = |key: &str| {
        let known = key_at(&format!("{list}[1].{key}"))?;
        (1..=count).find_map(|place| {
            let (nominal, _) = tolerance_of(value(&format!("{list}[{place}].{key}"))?);
            Some(unit_of(known, nominal)).filter(|unit| !unit.is_empty())
        })
    };
    let mut out = text.to_owned();
    if replaces {
        for _ in 0..count {
            out = edit(&out, &format!("{list}[1]"), Edit::Gone).ok()?;
        }
    }
    // A new move has the law of those before it; where there is none, the law is open.
    let move_law = (1..=count)
        .rev()
        .filter_map(|place| value(&format!("{list}[{place}].law")))
        .find(|law| !matches!(*law, "dwell" | "recorded" | "points" | "manual" | "web"))
        .unwrap_or("open");
    let (start, kept) = if replaces { (1, 0) } else { (cell.row.max(1), count) };
    for (place, row) in (start..).zip(rows) {
        let path = format!("{list}[{place}]");
        let is_new = place > kept;
        if is_new {
            out = edit(&out, &path, Edit::Table).ok()?;
        }
        let cells: Vec<(&PastedColumn, &&str)> =
            columns.iter().zip(row).filter_map(|(column, cell)| Some((column.as_ref()?, cell))).collect();
        let has_law = cells.iter().any(|(column, cell)| column.key == "law" && !cell.is_empty());
        if has_law {
            for key in OF_A_MOVE {
                out = edit(&out, &format!("{path}.{key}"), Edit::Value("")).ok()?;
            }
        } else if is_new {
            let goes = cells.iter().any(|(column, cell)| column.key == "distance" && goes(cell));
            out = edit(&out, &format!("{path}.law"), Edit::Value(if goes { move_law } else { "dwell" })).ok()?;
        }
        let rests = value_of(&out, &format!("{path}.law")).as_deref() == Some("dwell")
            || cells.iter().any(|(column, cell)| column.key == "law" && law(cell) == Some("dwell"));
        for (column, cell) in cells {
            // A cell without a law leaves that of the row.
            if column.key == "law" && cell.is_empty() {
                continue;
            }
            // A rest has no distance; a nought in its column states the same.
            if rests && column.key != "time" && column.key != "law" && !goes(cell) {
                continue;
            }
            let typed = match column.key {
                "law" => law(cell).map_or_else(|| (*cell).to_owned(), str::to_owned),
                key => {
                    let at = format!("{path}.{key}");
                    let own = value(&at).filter(|_| !replaces).zip(key_at(&at));
                    let own = own.map_or("", |(value, key)| unit_of(key, tolerance_of(value).0));
                    let known = [column.unit.as_str(), own].into_iter().find(|unit| !unit.is_empty());
                    stated(cell, known.or_else(|| usual(key)).unwrap_or_default(), language)
                }
            };
            out = edit(&out, &format!("{path}.{}", column.key), Edit::Value(&typed)).ok()?;
        }
    }
    Some(out)
}

/// Returns `true` if a cell states a distance other than nought.
fn goes(cell: &str) -> bool {
    let number: String = cell.chars().take_while(|sign| sign.is_ascii_digit() || ".,+-".contains(*sign)).collect();
    !cell.is_empty() && number.replace(',', ".").parse::<f64>().is_ok_and(|number| number != 0.0)
        || number.is_empty() && !cell.is_empty() && cell != "–"
}

fn value_of(text: &str, path: &str) -> Option<String> {
    written(text)?.into_iter().find(|key| key.path == path)?.value
}

/// Returns the columns of a row of headings, `None` for a column that is no value of a segment; `None` for a row of values.
///
/// A row of headings has no number outside of its units, and names at least a distance, a time or a speed.
fn headings(row: &[&str]) -> Option<Vec<Option<PastedColumn>>> {
    let is_number = |cell: &&str| {
        cell.split(['[', '(']).next().is_some_and(|name| name.contains(|sign: char| sign.is_ascii_digit()))
    };
    if row.iter().any(is_number) {
        return None;
    }
    let columns: Vec<Option<PastedColumn>> = row.iter().map(|heading| of_heading(heading)).collect();
    columns.iter().flatten().any(|column| column.key != "law").then_some(columns)
}

/// Returns the column of a heading such as `Weg [mm]` or `time`.
fn of_heading(heading: &str) -> Option<PastedColumn> {
    let heading = heading.trim();
    let (name, unit) = match heading.split_once(['[', '(']) {
        Some((name, unit)) => (name.trim(), unit.trim_end_matches([']', ')']).trim()),
        None => heading.split_once(" in ").map_or((heading, ""), |(name, unit)| (name.trim(), unit.trim())),
    };
    let name = name.to_lowercase();
    let key = HEADINGS.iter().find(|(key, others)| *key == name || others.contains(&name.as_str()))?.0;
    Some(PastedColumn { key, unit: Unit::of(unit).map_or(unit, |unit| unit.ascii).to_owned() })
}

/// Returns the law of a cell, by its word in the project file or its name in either language.
fn law(cell: &str) -> Option<&'static str> {
    let cell = cell.trim().to_lowercase();
    let is_it = |law: &SegmentLaw| {
        law.id() == cell || Language::ALL.into_iter().any(|language| laws::name(*law, language).to_lowercase() == cell)
    };
    SegmentLaw::all().find(is_it).map(SegmentLaw::id)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\npayload = \"2 kg\"\n\
        [[motion]]\nlaw = \"dwell\"\ntime = \"500 ms\"\n";

    fn of(text: &str, (row, column): (usize, usize), clip: &str) -> Vec<(String, String)> {
        let found = pasted(text, &Cell { list: "motion", row, column }, clip, Language::De).unwrap();
        let keys = written(&found).unwrap().into_iter();
        keys.filter_map(|key| Some((key.path.strip_prefix("motion")?.to_owned(), key.value?))).collect()
    }

    fn is(found: &[(String, String)], path: &str, value: &str) -> bool {
        found.iter().any(|(at, held)| at == path && held == value)
    }

    #[test]
    fn rows_from_a_cell_take_the_units_of_their_columns_and_add_segments() {
        let found = of(TEXT, (1, 1), "120\t0,8\n0\t0,3\n-120\t1,25\n");
        assert!(is(&found, "[1].distance", "120 deg") && is(&found, "[1].time", "0.8 s"), "{found:?}");
        assert!(is(&found, "[1].payload", "2 kg") && is(&found, "[2].time", "0.3 ms"), "{found:?}");
        assert!(is(&found, "[3].law", "trapezoid") && is(&found, "[3].distance", "-120 deg"), "{found:?}");
        assert!(is(&found, "[3].time", "1.25 s") && !found.iter().any(|(at, _)| at == "[2].distance"), "{found:?}");
    }

    #[test]
    fn rows_with_headings_replace_the_motion() {
        let clip = "Bewegungsgesetz\tWeg [mm]\tZeit [ms]\nTrapez\t300\t800\nRast\t\t200\npolynomial_5\t-300\t900\n";
        let found = of(TEXT, (2, 2), clip);
        for (path, value) in [
            ("[1].law", "trapezoid"),
            ("[1].distance", "300 mm"),
            ("[2].law", "dwell"),
            ("[2].time", "200 ms"),
            ("[3].law", "polynomial_5"),
            ("[3].distance", "-300 mm"),
            ("[3].time", "900 ms"),
        ] {
            assert!(is(&found, path, value), "{path} {value}: {found:?}");
        }
        assert!(!found.iter().any(|(at, _)| at.ends_with("payload") || at.starts_with("[4]")), "{found:?}");
    }

    /// The headings of the page itself, symbols with units, and a column of numbers; without a law the moves keep that of the
    /// motion before.
    #[test]
    fn a_column_that_is_no_value_of_a_segment_is_passed_over() {
        let open = TEXT.replace("\"trapezoid\"", "\"open\"");
        for clip in [
            "#\tLaw\tDistance [deg]\tTime [s]\n1\t\t150\t1,5\n2\tdwell\t\t0,5\n",
            "s [deg]\tt [s]\n150\t1,5\n0\t0,5\n",
            "Segment\tWeg [deg]\tZeit [s]\n1\t150\t1,5\n2\t0\t0,5\n",
        ] {
            let found = of(&open, (1, 1), clip);
            for (path, value) in
                [("[1].law", "open"), ("[1].distance", "150 deg"), ("[1].time", "1.5 s"), ("[2].law", "dwell")]
            {
                assert!(is(&found, path, value), "{clip}: {path} {value}: {found:?}");
            }
            assert!(is(&found, "[2].time", "0.5 s") && !found.iter().any(|(at, _)| at.starts_with("[3]")), "{found:?}");
        }
    }

    #[test]
    fn what_is_no_value_stays_so_that_every_fault_is_reported() {
        let found = of(TEXT, (1, 0), "fast\tfar\t1 h\ntrapezoid\t1 kg\tsoon\n");
        for (path, value) in
            [("[1].law", "fast"), ("[1].distance", "far"), ("[2].distance", "1 kg"), ("[2].time", "soon")]
        {
            assert!(is(&found, path, value), "{path}: {found:?}");
        }
    }

    #[test]
    fn hostile_rows_change_nothing_or_stay_text() {
        for clip in ["", "\n\n", "\t", ";;;;;;;", "law\tlaw", "Weg [mm]", "\"]\n[x]"] {
            let _ = pasted(TEXT, &Cell { list: "motion", row: 1, column: 1 }, clip, Language::En);
        }
        assert_eq!(pasted("a = = b", &Cell { list: "motion", row: 1, column: 1 }, "1\t2", Language::En), None);
    }
}

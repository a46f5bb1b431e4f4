//! Ordering codes against data tables, and the tables that must exist.

use super::bearing::SIZES;
use super::tally::Tally;
use super::view::CellView;
use std::collections::BTreeSet;

/// Every table of the manual that holds values, by its number after errata: counted once in the recovered text.
const TABLES: [&str; 112] = [
    "11.1", "11.2", "11.3", "11.4", "11.5", "11.6", "12.1", "13.1", "13.2", "13.3", "14.1", "15.1", "15.2", "17.1",
    "18.1", "18.2", "20.1", "21.1", "21.2", "23.1", "24.1", "24.2", "26.1", "26.2", "26.3", "28.1", "28.2", "28.3",
    "30.1", "30.2", "30.3", "32.1", "32.2", "32.3", "34.1", "34.2", "34.3", "36.1", "36.2", "36.3", "38.1", "38.2",
    "38.3", "40.1", "40.2", "40.3", "42.1", "42.2", "42.3", "44.1", "44.2", "44.3", "46.1", "46.2", "46.3", "48.1",
    "48.2", "48.3", "50.3", "50.6", "51.3", "51.6", "52.3", "52.6", "53.3", "53.6", "54.1", "54.2", "54.3", "54.4",
    "55.1", "55.3", "57.1", "58.1", "58.2", "59.1", "61.1", "62.1", "62.3", "63.1", "63.3", "63.4", "63.6", "64.1",
    "64.2", "64.3", "65.1", "65.3", "65.4", "65.6", "65.7", "66.1", "66.3", "66.4", "66.6", "67.1", "67.3", "67.4",
    "67.6", "67.7", "68.1", "68.2", "68.4", "70.1", "71.1", "71.3", "74.2", "74.5", "75.4", "76.3", "77.1", "79.1",
];

/// Ratios of the ordering key.
const RATIOS: [&str; 6] = ["30", "50", "80", "100", "120", "160"];

/// The ratios of tables 11.1 and 12.1 are the columns of the data tables
///
/// Source: chapters 4 and 5 of the manual.
/// Tolerance: none. Blamed: the cell of table 11.1 or 12.1.
pub(super) fn ratios(view: &CellView, tally: &mut Tally) {
    for size in SIZES {
        for ratio in RATIOS {
            let condition = format!("ratio={ratio}");
            let find = |table: &str| {
                view.find(|c| c.place.table == table && c.place.drive == size && c.place.condition == condition)
            };
            let Some(matrix) = find("12.1") else {
                tally.absent(format_args!("{size}, {condition} in table 12.1"));
                continue;
            };
            let orderable = matrix.text.starts_with('●');
            // An empty field of the key is no cell.
            let key = find("11.1").filter(|entry| !entry.text.is_empty());
            let same_text = key.is_none_or(|entry| entry.text == ratio);
            tally.compare(key.is_some() == orderable && same_text, &[matrix], || {
                let key = key.map_or("nothing", |entry| &entry.text);
                format!("{size}, i = {ratio}: table 11.1 has {key}, table 12.1 {}", matrix.text)
            });
            for drive in catalogue::drives().iter().filter(|drive| drive.name.starts_with(size)) {
                for symbol in ["T_max", "J_out", "T_Br"] {
                    let mut cells = view.drive(drive.name).entries.into_iter();
                    let printed =
                        cells.any(|entry| entry.cell.place.symbol == symbol && entry.cell.place.ratio == ratio);
                    tally.compare(printed == orderable, &[matrix], || {
                        let name = drive.name;
                        format!("{name}, i = {ratio}: table 12.1 has {}, a column of {symbol}: {printed}", matrix.text)
                    });
                }
            }
        }
    }
}

/// Every pair of table 11.3 that a size can have (table 12.1) has a drive with data, and every drive is listed in both
///
/// Also: U_DCmax of table 11.2 is that of the data tables.
///
/// Source: chapters 4 and 5 of the manual. On request only (○) needs no data.
/// Tolerance: none.
pub(super) fn combinations(view: &CellView, tally: &mut Tally) {
    let listed: BTreeSet<(&str, &str)> = view
        .row("11.3", "motor_connector")
        .filter_map(|entry| Some((entry.cell.place.condition.strip_prefix("winding=")?, entry.cell.feedback)))
        .collect();
    let mark = |size: &str, condition: String| {
        view.find(|c| c.place.table == "12.1" && c.place.drive == size && c.place.condition == condition)
            .map(|entry| entry.text.clone())
    };
    for size in SIZES {
        for winding in order_code::Winding::all(order_code::Series::default()) {
            for feedback in order_code::Feedback::all(order_code::Series::default()) {
                let (w, f) = (winding.as_str(), feedback.as_str());
                let marks = (mark(size, format!("winding={w}")), mark(size, format!("feedback={f}")));
                let available = marks == (Some("●".to_owned()), Some("●".to_owned())) && listed.contains(&(w, f));
                let head = catalogue::drives().iter().find(|drive| {
                    drive.name.starts_with(size)
                        && drive.windings.contains(&winding)
                        && drive.feedbacks.contains(&feedback)
                });
                // Tables 17.1 to 24.2 print H and N in one, with all feedback systems; 11.3 lists fewer pairs for H.
                let shared = head.is_some_and(|drive| drive.name.ends_with("-H/N"));
                let fits = if available { head.is_some() } else { head.is_none() || shared };
                tally.compare(fits, &[], || {
                    let name = head.map_or("no drive", |drive| drive.name);
                    format!("{size}-{w}-{f}: orderable: {available} (tables 11.3, 12.1), data: {name}")
                });
            }
        }
    }
    for drive in view.drives() {
        let winding = if drive.is_48_v() { "winding=E" } else { "winding=H" };
        let key = view
            .find(|c| c.place.table == "11.2" && c.place.condition == winding && c.place.drive.contains(drive.size()));
        let key = key.or_else(|| view.row("11.2", "U_DCmax").find(|entry| entry.cell.place.condition == winding));
        match (key, drive.once("U_DCmax")) {
            (Some(key), Some(cell)) => tally.compare(key.text == cell.text, &[cell], || {
                format!("{} is {}, table 11.2 has {}", cell.place(), cell.text, key.text)
            }),
            _ => tally.absent(format_args!("U_DCmax of {}", drive.name)),
        }
    }
}

/// Every code that can be ordered without asking has its parameters
///
/// Source: chapters 4 to 6 of the manual.
/// Tolerance: none.
pub(super) fn codes(_: &CellView, tally: &mut Tally) {
    for (code, availability) in configurator::all() {
        if !availability.is_available() {
            continue;
        }
        tally.compare(configurator::parameters(code).is_some(), &[], || format!("{code:?} has no parameters"));
    }
    if tally.comparisons == 0 {
        tally.absent("no code can be ordered");
    }
}

/// Every table of the manual exists and has cells, no other one claims to be of the manual, and every drive has its three
///
/// Source: the table numbers of the manual from 11.1 to 79.1, written down in code.
/// Tolerance: none. Two lists without a number of their own have a name: `glossary-n_N`, and `equation-76.1`, the symbols below that equation.
pub(super) fn tables(view: &CellView, tally: &mut Tally) {
    for id in TABLES {
        tally.compare(view.table(id).next().is_some(), &[], || format!("table {id} of the manual has no cells"));
    }
    for table in catalogue::tables() {
        let known = !table.is_of_the_manual()
            || TABLES.contains(&table.id)
            || ["glossary-n_N", "equation-76.1"].contains(&table.id);
        tally.compare(known, &[], || format!("table {} is not in the list of the manual's tables", table.id));
        tally.compare(view.table(table.id).next().is_some(), &[], || format!("table {} has no cells", table.id));
    }
    for drive in view.drives() {
        for (symbol, what) in [("T_max", "technical data"), ("J_out", "moments of inertia"), ("T_Br", "motor brake")] {
            let of: BTreeSet<&str> = drive
                .entries
                .iter()
                .filter(|entry| entry.cell.place.symbol == symbol)
                .map(|entry| entry.cell.place.table)
                .collect();
            tally.compare(of.len() == 1, &[], || format!("{what} of {} stand in tables {of:?}", drive.name));
        }
    }
}

mod tests {
    use super::super::findings_of;
    use super::*;

    #[test]
    fn a_ratio_taken_from_the_matrix_or_given_to_it_is_found() {
        let altered = |size: &'static str, ratio: &'static str, text| {
            CellView::with("12.1", text, |cell| {
                cell.place.drive == size && cell.place.condition == format!("ratio={ratio}")
            })
        };
        assert!(!findings_of(ratios, &altered("CHA-20A", "80", "-")).is_empty());
        assert!(!findings_of(ratios, &altered("CHA-50A", "30", "●")).is_empty());
        let view =
            CellView::with("11.1", "60", |cell| cell.place.drive == "CHA-20A" && cell.place.condition == "ratio=80");
        assert_eq!(findings_of(ratios, &view).len(), 1);
    }

    #[test]
    fn a_feedback_without_data_is_found() {
        let view = CellView::with("12.1", "●", |cell| {
            cell.place.drive == "CHA-20A" && cell.place.condition == "feedback=RES"
        });
        assert_eq!(findings_of(combinations, &view).len(), 1);
        let view = CellView::with("36.1", "560", |cell| cell.place.symbol == "U_DCmax");
        assert_eq!(findings_of(combinations, &view).len(), 1);
    }

    #[test]
    fn the_list_of_tables_ascends_without_a_repetition() {
        let numbers: Vec<f64> = TABLES.iter().map(|id| id.parse().unwrap()).collect();
        assert!(numbers.is_sorted_by(|a, b| a < b));
    }
}

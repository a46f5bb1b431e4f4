//! Output bearing, stiffness and accuracy of the gear, screw joints (tables 54.1 to 55.1 and 79.1).

use super::output::step;
use super::tally::Tally;
use super::view::{AuditedCell, CellView, Span, brief, median};
use std::collections::BTreeMap;

/// Heads of the sizes in the tables that print one column for each.
pub(super) const SIZES: [&str; 8] =
    ["CHA-14A", "CHA-17A", "CHA-20A", "CHA-25A", "CHA-32A", "CHA-40A", "CHA-50A", "CHA-58A"];

/// M_0 = d_p C_0 / (2 f_s)
///
/// f_s is 1.8 for sizes 14 to 20 and 1.5 for 25 to 58 (footnote 3 of table 55.1).
///
/// Source: chapter 7.4.3 of the manual, P_0 = 2 M_0 / d_p and f_s = C_0 / P_0.
/// Tolerance: the rounding of all values. Blamed: M_0.
pub(super) fn static_moment(view: &CellView, tally: &mut Tally) {
    for size in SIZES {
        let safety = if ["CHA-14A", "CHA-17A", "CHA-20A"].contains(&size) { 1.8 } else { 1.5 };
        let span = |symbol| view.of_size("55.1", symbol, size).and_then(AuditedCell::span);
        let moment = view.of_size("55.1", "M_0_max", size);
        let (Some(cell), Some(diameter), Some(rating)) = (moment, span("d_p"), span("C_0")) else {
            tally.absent(format_args!("M_0_max of {size}"));
            continue;
        };
        let expected = diameter * rating * (0.5 / safety);
        let fits = cell.span().is_some_and(|printed| printed.meets(expected));
        tally.compare(fits, &[cell], || format!("{} is {}, d_p C_0/(2 f_s) gives {expected}", cell.place(), cell.text));
    }
}

/// F_R ≤ C / (60 n L10 / 10⁶)^(1/B) and F_A ≤ the same over y, at n = 15 1/min and L10 = 15000 h
///
/// With a radial force alone P_C = x F_R and x = 1; with an axial force alone P_C = y F_A and y = 0.67.
///
/// Source: life equation of chapter 7.4 of the manual, tables 74.5 (B) and 75.4 (x, y), footnote 4 of table 55.1.
/// Tolerance: half the last digit of the force; a smaller force is another limit and passes. Blamed: the force.
pub(super) fn life(view: &CellView, tally: &mut Tally) {
    const MILLION_TURNS: f64 = 15_000.0 * 60.0 * 15.0 / 1e6;
    let y =
        view.row("75.4", "y").find_map(|entry| entry.number().filter(|_| entry.cell.place.condition.contains("> 1,5")));
    for size in SIZES {
        let kind = view.of_size("55.1", "bearing_type", size).map(|entry| format!("bearing_type={}", entry.text));
        let exponent = kind.and_then(|kind| view.row("74.5", "B").find(|entry| entry.cell.place.condition == kind));
        let exponent = exponent.and_then(|entry| quotient(&entry.text));
        let rating = view.of_size("55.1", "C", size).and_then(AuditedCell::number);
        let (Some(b), Some(c), Some(y)) = (exponent, rating, y) else {
            tally.absent(format_args!("C, bearing_type, B or y of {size}"));
            continue;
        };
        let radial = c / MILLION_TURNS.powf(1.0 / b);
        for (symbol, limit) in [("F_R_dyn_max", radial), ("F_A_dyn_max", radial / y)] {
            let cell = view.of_size("55.1", symbol, size);
            let Some((cell, span)) = cell.and_then(|cell| Some((cell, cell.span()?))) else {
                tally.absent(format_args!("{symbol} of {size}"));
                continue;
            };
            tally.compare(span.low <= limit, &[cell], || {
                format!("{} is {}, a life of 15000 h allows {}", cell.place(), cell.text, brief(limit))
            });
        }
    }
}

/// `10/3`, `3`
fn quotient(text: &str) -> Option<f64> {
    match text.split_once('/') {
        Some((above, below)) => Some(above.parse::<f64>().ok()? / below.parse::<f64>().ok()?),
        None => text.parse().ok(),
    }
}

/// Stiffness and bearing grow: K_1 < K_2 < K_3, T_1 < T_2, and each of them, K_B, C and C_0 with the size; accuracy figures
/// do not get worse with the ratio
///
/// Source: chapter 6.20 of the manual (regions of the stiffness curve); a misplaced column breaks it.
/// Tolerance: none, the printed numbers are compared. Blamed: both values.
pub(super) fn growth(view: &CellView, tally: &mut Tally) {
    let stiffness = |symbol: &'static str| {
        ["54.3", "54.4"].iter().flat_map(move |table| view.row(table, symbol)).filter(|entry| entry.text != "-")
    };
    for (small, large) in [("K_1", "K_2"), ("K_2", "K_3"), ("T_1", "T_2")] {
        for first in stiffness(small) {
            let head = (first.cell.place.drive, first.cell.place.ratio);
            let second = stiffness(large).find(|entry| (entry.cell.place.drive, entry.cell.place.ratio) == head);
            step(tally, Some(first), second, |a, b| a < b, "not below the next region");
        }
    }
    for symbol in ["K_1", "K_2", "K_3", "T_1", "T_2"] {
        let cells: Vec<&AuditedCell> = stiffness(symbol).collect();
        for ratio in ["30", "50", "> 50", ""] {
            let row: Vec<&AuditedCell> =
                cells.iter().copied().filter(|entry| entry.cell.place.ratio == ratio).collect();
            ascending(tally, &row);
        }
        for size in SIZES {
            let row: Vec<&AuditedCell> = cells.iter().copied().filter(|entry| entry.cell.place.drive == size).collect();
            ascending(tally, &row);
        }
    }
    for symbol in ["d_p", "C", "C_0", "K_B", "M_dyn_max", "F_R_dyn_max", "F_A_dyn_max"] {
        ascending(tally, &view.row("55.1", symbol).collect::<Vec<_>>());
    }
    for symbol in ["transmission_accuracy", "hysteresis_loss"] {
        for size in SIZES {
            let row: Vec<&AuditedCell> = ["54.1", "54.2"]
                .iter()
                .flat_map(|table| view.row(table, symbol))
                .filter(|entry| entry.cell.place.drive == size)
                .collect();
            for pair in row.windows(2) {
                if let [first, second] = pair {
                    step(tally, Some(first), Some(second), |a, b| a >= b, "less accurate at the larger ratio");
                }
            }
        }
    }
}

fn ascending(tally: &mut Tally, row: &[&AuditedCell]) {
    for pair in row.windows(2) {
        if let [first, second] = pair {
            step(tally, Some(first), Some(second), |a, b| a < b, "not below its neighbour");
        }
    }
}

/// One friction force and one tightening torque per thread: F = 2 T / (n d); and T above T_max of the size
///
/// Source: chapter 9.3 of the manual; completely degreased faces, n screws on the bolt circle d, the same preload for the same thread.
/// Tolerance: 3 % of the median force of a thread (the bolt circles are printed to full millimetres); the tightening torque
/// is one value per thread. Blamed: transmissible torque, tightening torque.
pub(super) fn screws(view: &CellView, tally: &mut Tally) {
    let mut forces: BTreeMap<&str, Vec<(&AuditedCell, f64)>> = BTreeMap::new();
    let mut torques: BTreeMap<&str, Vec<&AuditedCell>> = BTreeMap::new();
    for size in SIZES {
        let strongest = catalogue::drives().iter().filter(|drive| drive.name.starts_with(size));
        let strongest = strongest
            .flat_map(|drive| view.drive(drive.name).entries)
            .filter(|entry| entry.cell.place.symbol == "T_max")
            .filter_map(AuditedCell::number)
            .fold(0.0, f64::max);
        for side in ["load", "housing"] {
            let get = |what: &str| {
                view.find(|c| {
                    c.place.table == "79.1" && c.place.drive == size && c.place.symbol == format!("{what}_{side}")
                })
            };
            let number = |what: &str| get(what).and_then(AuditedCell::number);
            let cells = (get("screw_size"), get("transmissible_torque"), get("tightening_torque"));
            let (Some(thread), Some(torque), Some(tightening)) = cells else {
                tally.absent(format_args!("screws of {size}, {side}"));
                continue;
            };
            let figures = (torque.number(), number("screw_count"), number("bolt_circle"));
            let (Some(moment), Some(count), Some(circle)) = figures else {
                tally.absent(torque.place());
                continue;
            };
            forces.entry(&thread.text).or_default().push((torque, 2.0 * moment / (count * circle * 1e-3)));
            torques.entry(&thread.text).or_default().push(tightening);
            tally.compare(moment > strongest && strongest > 0.0, &[torque], || {
                format!("{} is {}, below T_max = {strongest} of the size", torque.place(), torque.text)
            });
        }
    }
    for (thread, joints) in forces {
        let usual = median(joints.iter().map(|(_, force)| *force).collect());
        for (cell, force) in joints {
            tally.compare((force / usual - 1.0).abs() <= 0.03, &[cell], || {
                let (force, usual) = (brief(force), brief(usual));
                format!("{} is {}, {force} N per {thread} screw against {usual} N elsewhere", cell.place(), cell.text)
            });
        }
    }
    for (thread, cells) in torques {
        let usual = cells.iter().map(|cell| cell.text.as_str()).max_by_key(|text| {
            // The shorter text wins a draw: an added digit is the odd one.
            (cells.iter().filter(|cell| cell.text == *text).count(), std::cmp::Reverse(text.len()))
        });
        let usual = usual.unwrap_or_default();
        for cell in &cells {
            let same = cell.number().zip(Span::of(usual)).is_some_and(|(a, b)| (a - b.mid).abs() < 1e-9);
            tally.compare(same, &[*cell], || {
                format!("{} is {}, {usual} for other {thread} screws", cell.place(), cell.text)
            });
        }
    }
}

mod tests {
    use super::super::findings_of;
    use super::*;

    fn altered(table: &str, symbol: &'static str, drive: &'static str, text: &str) -> CellView {
        CellView::with(table, text, |cell| cell.place.symbol == symbol && cell.place.drive == drive)
    }

    #[test]
    fn a_changed_static_moment_is_found() {
        assert_eq!(findings_of(static_moment, &altered("55.1", "M_0_max", "CHA-32A", "2142")).len(), 1);
    }

    #[test]
    fn a_force_beyond_the_life_is_found() {
        assert_eq!(findings_of(life, &altered("55.1", "F_R_dyn_max", "CHA-32A", "16400")).len(), 1);
        assert_eq!(findings_of(life, &altered("55.1", "F_A_dyn_max", "CHA-25A", "21900")).len(), 1);
    }

    #[test]
    fn a_stiffness_or_accuracy_out_of_order_is_found() {
        let view = CellView::with("54.3", "4,8", |c| {
            c.place.symbol == "K_2" && c.place.drive == "CHA-17A" && c.place.ratio == "30"
        });
        assert!(findings_of(growth, &view).is_empty(), "still in order");
        let view = CellView::with("54.3", "44", |c| {
            c.place.symbol == "K_2" && c.place.drive == "CHA-17A" && c.place.ratio == "30"
        });
        assert!(!findings_of(growth, &view).is_empty());
        let view = CellView::with("54.1", "< 1,6", |c| {
            c.place.symbol == "transmission_accuracy" && c.place.drive == "CHA-20A" && c.place.ratio == "> 50"
        });
        assert_eq!(findings_of(growth, &view).len(), 1);
    }

    #[test]
    fn a_changed_joint_is_found() {
        assert_eq!(findings_of(screws, &altered("79.1", "transmissible_torque_load", "CHA-20A", "282")).len(), 1);
        assert_eq!(findings_of(screws, &altered("79.1", "tightening_torque_load", "CHA-25A", "11")).len(), 1);
        assert!(!findings_of(screws, &altered("79.1", "transmissible_torque_load", "CHA-14A", "25")).is_empty());
    }
}

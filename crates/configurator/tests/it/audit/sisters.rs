//! Values that sister drives share: C1024 and M512P of one size, E and H/N of one size.

use super::tally::{Excuse, Tally};
use super::view::{AuditedCell, CellView, DriveView, Span, brief};

/// C1024 and M512P of a size have the same motor, gear and brake
///
/// Every value of the three tables is the same text, except inertias, masses and tau_m, which the encoder changes (tau_m
/// is checked against the inertia elsewhere).
///
/// Source: the model code; only the feedback differs.
/// Tolerance: none. Blamed: both cells.
pub(super) fn same_motor(view: &CellView, tally: &mut Tally) {
    for (coded, absolute) in pairs(view, "-C1024", "-M512P") {
        let shared = |entry: &&&AuditedCell| {
            let symbol = entry.cell.place.symbol;
            !symbol.starts_with("J") && !["m", "m_brake", "tau_m", "L", "L_brake"].contains(&symbol)
        };
        let count = absolute.entries.iter().filter(shared).count();
        tally.compare(coded.entries.iter().filter(shared).count() == count, &[], || {
            format!("{} and {} differ in the number of cells", coded.name, absolute.name)
        });
        for cell in coded.entries.iter().filter(shared) {
            let twin = absolute.entries.iter().copied().find(|entry| {
                (entry.cell.place.symbol, entry.cell.place.condition, entry.cell.place.ratio)
                    == (cell.cell.place.symbol, cell.cell.place.condition, cell.cell.place.ratio)
            });
            same_text(tally, cell, twin);
        }
    }
}

/// Contribution of the encoder M512P compared with C1024: one mass, one inertia, no change of the brake's share
///
/// m and m_brake grow by 1,0 kg, J and J_brake by 1,2·10⁻⁴ kgm² at every size; L_brake − L stays.
///
/// Source: found in the tables; the EQN 1125 is the same part at every size.
/// Tolerance: 1,0 kg exactly in the printed digits; the rounding of J and J_brake; none for the lengths.
/// Blamed: the value of M512P; for lengths an erratum of the table.
pub(super) fn encoder_share(view: &CellView, tally: &mut Tally) {
    for (coded, absolute) in pairs(view, "-C1024", "-M512P") {
        for (symbol, share, unit) in [
            ("m", Span::exact(1.0), "kg"),
            ("m_brake", Span::exact(1.0), "kg"),
            ("J", Span::exact(1.2), "10^-4 kgm^2"),
            ("J_brake", Span::exact(1.2), "10^-4 kgm^2"),
        ] {
            let (Some(light), Some(heavy)) = (coded.once(symbol), absolute.once(symbol)) else {
                tally.absent(format_args!("{symbol} of {}", absolute.name));
                continue;
            };
            let (Some(from), Some(to)) = (light.span(), heavy.span()) else {
                tally.absent(heavy.place());
                continue;
            };
            let added = to - from;
            let fits = if unit == "kg" { (added.mid - share.mid).abs() < 1e-9 } else { added.meets(share) };
            tally.compare(fits, &[heavy], || {
                let added = brief(added.mid);
                format!("{} is {}, {added} above {} {}", heavy.place(), heavy.text, coded.name, light.text)
            });
        }
        let brake = |drive: &DriveView<'_>| {
            Some(drive.once("L_brake").and_then(AuditedCell::number)? - drive.once("L").and_then(AuditedCell::number)?)
        };
        let Some((c, m)) = brake(&coded).zip(brake(&absolute)) else {
            tally.absent(format_args!("L and L_brake of {}", absolute.name));
            continue;
        };
        let size = absolute.name.get(4..7).unwrap_or_default();
        let words = match size {
            "20A" => Some(("52.6", "20A lengths")),
            _ => None,
        };
        tally.compare_or((c - m).abs() < 1e-9, &[], Excuse { table_erratum: words, rule: None }, || {
            format!("the brake of {} adds {c} mm, that of {} {m} mm", coded.name, absolute.name)
        });
    }
}

/// E and H/N of 14A and 17A share gear, inertias, brake torque, masses and lengths
///
/// Source: the model code; only winding and connector differ.
/// Tolerance: none. Blamed: both cells.
pub(super) fn same_gear(view: &CellView, tally: &mut Tally) {
    const SHARED: [&str; 14] = [
        "T_max",
        "T_0",
        "J",
        "J_brake",
        "J_out",
        "J_out_brake",
        "T_Br",
        "m",
        "m_brake",
        "d_H",
        "L",
        "L_brake",
        "p",
        "n_N",
    ];
    for (low, high) in pairs(view, "-E", "-H/N") {
        let shared = low.entries.iter().filter(|entry| SHARED.contains(&entry.cell.place.symbol));
        for cell in shared {
            let twin = high.entries.iter().copied().find(|entry| {
                (entry.cell.place.symbol, entry.cell.place.condition, entry.cell.place.ratio, entry.cell.feedback)
                    == (cell.cell.place.symbol, cell.cell.place.condition, cell.cell.place.ratio, cell.cell.feedback)
            });
            same_text(tally, cell, twin);
        }
    }
}

fn pairs<'a>(view: &'a CellView, first: &str, second: &str) -> Vec<(DriveView<'a>, DriveView<'a>)> {
    let ends = |end: &str| view.drives().into_iter().filter(|drive| drive.name.ends_with(end)).collect::<Vec<_>>();
    ends(first).into_iter().zip(ends(second)).filter(|(a, b)| a.size() == b.size()).collect()
}

/// Compares two texts without regard to spaces (`24 ±10 %` and `24 ± 10 %`); an empty cell must be matched by an empty
/// one.
fn same_text(tally: &mut Tally, cell: &AuditedCell, twin: Option<&AuditedCell>) {
    match twin {
        Some(twin) => tally.compare(cell.text.replace(' ', "") == twin.text.replace(' ', ""), &[cell, twin], || {
            format!("{} is {}, but {} is {}", cell.place(), cell.text, twin.place(), twin.text)
        }),
        None => tally.absent(format_args!("no sister of {}", cell.place())),
    }
}

mod tests {
    use super::super::findings_of;
    use super::*;

    #[test]
    fn a_motor_value_changed_in_one_sister_is_found() {
        let view = CellView::with("38.1", "57", |cell| cell.place.symbol == "T_max" && cell.place.ratio == "50");
        assert_eq!(findings_of(same_motor, &view).len(), 1);
    }

    #[test]
    fn another_mass_length_or_inertia_of_the_encoder_is_found() {
        let altered =
            |table, symbol: &'static str, text| CellView::with(table, text, |cell| cell.place.symbol == symbol);
        assert_eq!(findings_of(encoder_share, &altered("42.1", "m", "7,8")).len(), 1);
        assert_eq!(findings_of(encoder_share, &altered("42.2", "J", "6,3")).len(), 1);
        let view =
            CellView::with("53.3", "177", |cell| cell.place.symbol == "L_brake" && cell.place.drive == "CHA-40A-M512P");
        assert_eq!(findings_of(encoder_share, &view).len(), 1);
    }

    #[test]
    fn a_gear_value_changed_in_one_winding_is_found() {
        let view = CellView::with("18.2", "17", |cell| cell.place.symbol == "T_Br" && cell.place.ratio == "50");
        assert_eq!(findings_of(same_gear, &view).len(), 1);
    }
}

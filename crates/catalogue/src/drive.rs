//! The sixteen drives of sections 6.2 to 6.17, and typed access to what is printed about them.

use crate::record::{Cell, Table};
use order_code::{Feedback, Ratio, Size, Winding};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::{Measure, Unit};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// One drive of the catalogue: a motor with its windings and feedback systems in all its ratios, as headed in 6.2-6.17.
pub struct Drive {
    /// Head of its section: `CHA-14A-H/N`, `CHA-20A-C1024`.
    pub name: &'static str,
    /// Frame size.
    pub size: Size,
    /// Motor windings and connector configurations that its tables hold for.
    pub windings: &'static [Winding],
    /// Motor feedback systems that its tables hold for.
    pub feedbacks: &'static [Feedback],
    /// Reduction ratios, ascending.
    pub ratios: Vec<Ratio>,
    by_symbol: BTreeMap<&'static str, Vec<&'static Cell>>,
}

/// Heads of the sections with size, windings and feedback systems (tables 14.1 to 48.3).
const HEADS: [(&str, Size, &[Winding], &[Feedback]); 16] = {
    use Feedback::{C1024, D2048, M128S, M512P, RES};
    use Size::{S14A, S17A, S20A, S25A, S32A, S40A, S50A, S58A};
    use Winding::{E, H, N};
    [
        ("CHA-14A-E", S14A, &[E], &[RES, D2048, M128S]),
        ("CHA-14A-H/N", S14A, &[H, N], &[RES, D2048, M128S]),
        ("CHA-17A-E", S17A, &[E], &[RES, D2048, M128S]),
        ("CHA-17A-H/N", S17A, &[H, N], &[RES, D2048, M128S]),
        ("CHA-20A-C1024", S20A, &[H], &[C1024]),
        ("CHA-25A-C1024", S25A, &[H], &[C1024]),
        ("CHA-32A-C1024", S32A, &[H], &[C1024]),
        ("CHA-40A-C1024", S40A, &[H], &[C1024]),
        ("CHA-50A-C1024", S50A, &[H], &[C1024]),
        ("CHA-58A-C1024", S58A, &[H], &[C1024]),
        ("CHA-20A-M512P", S20A, &[H], &[M512P]),
        ("CHA-25A-M512P", S25A, &[H], &[M512P]),
        ("CHA-32A-M512P", S32A, &[H], &[M512P]),
        ("CHA-40A-M512P", S40A, &[H], &[M512P]),
        ("CHA-50A-M512P", S50A, &[H], &[M512P]),
        ("CHA-58A-M512P", S58A, &[H], &[M512P]),
    ]
};

static DRIVES: LazyLock<Vec<Drive>> = LazyLock::new(|| {
    HEADS
        .iter()
        .map(|&(name, size, windings, feedbacks)| {
            let mut by_symbol: BTreeMap<&'static str, Vec<&'static Cell>> = BTreeMap::new();
            for cell in crate::cells().iter().filter(|cell| cell.place.drive == name) {
                by_symbol.entry(cell.place.symbol).or_default().push(cell);
            }
            let printed = by_symbol.get("T_max").map(Vec::as_slice).unwrap_or_default();
            let ratios = Ratio::ALL
                .iter()
                .copied()
                .filter(|ratio| printed.iter().any(|cell| cell.place.ratio == ratio.to_string()))
                .collect();
            Drive { name, size, windings, feedbacks, ratios, by_symbol }
        })
        .collect()
});

/// All drives, in the order of the manual.
#[must_use]
pub fn drives() -> &'static [Drive] {
    &DRIVES
}

/// The drive whose tables hold for this size, winding and feedback; `None` where the manual prints no data
/// (for example the resolver on 20A to 58A, which is available on request only).
#[must_use]
pub fn drive(size: Size, winding: Winding, feedback: Feedback) -> Option<&'static Drive> {
    DRIVES
        .iter()
        .find(|drive| drive.size == size && drive.windings.contains(&winding) && drive.feedbacks.contains(&feedback))
}

/// Whether a feedback entry of a table (`RES / M128S`, or empty for all) covers this feedback.
pub(crate) fn covers(entry: &str, feedback: Feedback) -> bool {
    entry.is_empty() || entry.split(" / ").any(|name| name == feedback.as_str())
}

/// Whether a ratio entry of a table (`30`, `> 50`, or empty for all) covers this ratio.
pub(crate) fn covers_ratio(entry: &str, ratio: Ratio) -> bool {
    let value = ratio.value();
    match entry.strip_prefix('>') {
        Some(bound) => bound.trim().parse::<u16>().is_ok_and(|bound| value > bound),
        None => entry.is_empty() || entry.parse::<u16>().is_ok_and(|entry| entry == value),
    }
}

impl Drive {
    /// Every cell of this drive's own tables (technical data, inertias, brake, lengths).
    pub fn cells(&self) -> impl Iterator<Item = &'static Cell> + '_ {
        let mut cells: Vec<&'static Cell> = self.by_symbol.values().flatten().copied().collect();
        cells.sort_by_key(|cell| std::ptr::from_ref::<Cell>(cell).addr());
        cells.into_iter()
    }

    /// The cell of a symbol for this feedback and ratio. `condition` must match exactly.
    #[must_use]
    pub fn cell(&self, symbol: &str, condition: &str, feedback: Feedback, ratio: Ratio) -> Option<&'static Cell> {
        self.by_symbol.get(symbol)?.iter().copied().find(|cell| {
            cell.place.condition == condition
                && covers(cell.feedback, feedback)
                && covers_ratio(cell.place.ratio, ratio)
        })
    }

    /// The value that checks use, in SI, with its source, grade and errata.
    ///
    /// Where an open contradiction names a safe value, that value is returned with grade `computed`;
    /// a printed dash, and a row that does not exist, are [`Datum::NotPrinted`].
    #[must_use]
    pub fn datum<Q: Measure>(&self, symbol: &str, condition: &str, feedback: Feedback, ratio: Ratio) -> Datum<Q> {
        self.cell(symbol, condition, feedback, ratio).map_or(Datum::NotPrinted, datum_of)
    }
}

/// The cell of a symbol in the tables that are headed by size only (accuracy, stiffness, output bearing, fits, screws).
#[must_use]
pub fn size_cell(size: Size, ratio: Ratio, symbol: &str) -> Option<&'static Cell> {
    let head = SIZE_HEADS.iter().find(|(known, _)| *known == size).map_or("", |(_, head)| head);
    SIZE_CELLS
        .get(symbol)?
        .iter()
        .copied()
        .find(|cell| cell.place.drive.split(" / ").any(|drive| drive == head) && covers_ratio(cell.place.ratio, ratio))
}

/// How the tables head a size.
const SIZE_HEADS: [(Size, &str); 8] = [
    (Size::S14A, "CHA-14A"),
    (Size::S17A, "CHA-17A"),
    (Size::S20A, "CHA-20A"),
    (Size::S25A, "CHA-25A"),
    (Size::S32A, "CHA-32A"),
    (Size::S40A, "CHA-40A"),
    (Size::S50A, "CHA-50A"),
    (Size::S58A, "CHA-58A"),
];

/// The cells of the tables of sections 6.19 to 6.21, 8.1 and 9.3, by symbol.
static SIZE_CELLS: LazyLock<BTreeMap<&'static str, Vec<&'static Cell>>> = LazyLock::new(|| {
    let mut by_symbol: BTreeMap<&'static str, Vec<&'static Cell>> = BTreeMap::new();
    let sections = ["6.19", "6.20", "6.21", "8.1", "9.3"];
    let tables =
        crate::tables().iter().filter(|table| sections.iter().any(|section| table.section.starts_with(section)));
    for cell in tables.flat_map(Table::cells) {
        by_symbol.entry(cell.place.symbol).or_default().push(cell);
    }
    by_symbol
});

/// The value of a cell in SI, as checks use it.
#[must_use]
pub fn datum_of<Q: Measure>(cell: &'static Cell) -> Datum<Q> {
    let unit = Unit::of_dimension(Q::DIMENSION, cell.unit);
    match (cell.limit().number(), unit) {
        (Some(value), Some(unit)) => Datum::Known(Sourced {
            value: Q::from_si(unit.to_si(value)),
            source: Source::Cell(&cell.place),
            grade: if cell.checks_use.is_some() { Grade::Computed } else { Grade::Printed },
            errata: cell.errata,
        }),
        _ => Datum::NotPrinted,
    }
}

/// Every printed value of one actuator, in the order of the manual: the general data of its winding, its drive's
/// tables, the tables by size, the tables of its feedback, and what is printed once for all. Ordering tables, pin-outs and
/// the tables of the selection procedure are left out.
#[must_use]
pub fn cells_about(size: Size, winding: Winding, feedback: Feedback, ratio: Ratio) -> Vec<&'static Cell> {
    let Some(drive) = drive(size, winding, feedback) else { return Vec::new() };
    let size_head = format!("CHA-{size}");
    // Heads of tables 13.1 and 13.2.
    let general_head = if winding == Winding::E { "CHA-xxA-E" } else { "CHA-xxA-H/N" };
    crate::tables()
        .iter()
        .filter(|table| table.is_of_the_manual() && !is_ordering_or_wiring(table))
        .flat_map(crate::Table::cells)
        .filter(|cell| {
            let by_drive =
                cell.place.drive.split(" / ").any(|head| [drive.name, &size_head, general_head].contains(&head));
            let by_feedback = cell.place.drive.is_empty() && !cell.feedback.is_empty() && is_feedback_table(cell);
            let of_all = cell.place.drive.is_empty() && cell.feedback.is_empty() && is_of_every_actuator(cell);
            (by_drive || by_feedback || of_all)
                && covers(cell.feedback, feedback)
                && covers_ratio(cell.place.ratio, ratio)
        })
        .collect()
}

/// Chapters 4 and 5 say what can be ordered, section 6.24 how it is wired.
fn is_ordering_or_wiring(table: &Table) -> bool {
    table.section == "4" || table.section == "5" || table.section.starts_with("6.24")
}

/// The tables of section 6.22 hold for a feedback on every drive.
fn is_feedback_table(cell: &Cell) -> bool {
    crate::table(cell.place.table).is_some_and(|table| table.section.starts_with("6.22"))
}

/// A cell without a drive in the tables of temperature sensors (6.23), fits (8) and installation (9) holds for all.
fn is_of_every_actuator(cell: &Cell) -> bool {
    let of = |section: &str| ["6.23", "8.", "9."].iter().any(|chapter| section.starts_with(chapter));
    crate::table(cell.place.table).is_some_and(|table| of(table.section))
}

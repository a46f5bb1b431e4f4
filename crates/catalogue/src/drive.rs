//! Drives that head tables of the manual, and typed access to their values.

use crate::record::{Cell, ManualTable};
use crate::series::{DriveHead, SeriesData, winding_data};
use order_code::{Feedback, Ratio, Size, Winding};
use provenance::Datum;
use quantities::{Measure, Unit};
use std::collections::BTreeMap;
use std::sync::{LazyLock, OnceLock};

/// One drive of the catalogue: a motor with its windings and feedback systems in all its ratios, as it heads its
/// tables.
pub struct Drive {
    /// Heading of its section: `CHA-14A-H/N`, `CHA-20A-C1024`.
    pub name: &'static str,
    /// Frame size.
    pub size: Size,
    /// Motor windings and connector configurations that its tables hold for.
    pub windings: &'static [Winding],
    /// Motor feedback systems that its tables hold for.
    pub feedbacks: &'static [Feedback],
    printed: OnceLock<Printed>,
}

/// Tables of a drive.
struct Printed {
    ratios: Vec<Ratio>,
    cells: Vec<&'static Cell>,
    by_symbol: BTreeMap<&'static str, Vec<&'static Cell>>,
}

static DRIVES: LazyLock<Vec<Drive>> = LazyLock::new(|| {
    let heads = crate::series().iter().flat_map(|series| series.drives);
    let drive = |head: &DriveHead| Drive {
        name: head.name,
        size: head.size,
        windings: head.windings,
        feedbacks: head.feedbacks,
        printed: OnceLock::new(),
    };
    heads.map(drive).collect()
});

/// Cells that name a drive, by its name.
static BY_DRIVE: LazyLock<BTreeMap<&'static str, Vec<&'static Cell>>> = LazyLock::new(|| {
    let mut by_drive: BTreeMap<&'static str, Vec<&'static Cell>> = BTreeMap::new();
    for cell in crate::cells() {
        by_drive.entry(cell.place.drive).or_default().push(cell);
    }
    by_drive
});

impl Printed {
    fn of(drive: &Drive) -> Self {
        let cells = BY_DRIVE.get(drive.name).cloned().unwrap_or_default();
        let mut by_symbol: BTreeMap<&'static str, Vec<&'static Cell>> = BTreeMap::new();
        for cell in &cells {
            by_symbol.entry(cell.place.symbol).or_default().push(cell);
        }
        let printed = by_symbol.get("T_max").map(Vec::as_slice).unwrap_or_default();
        let ratios = Ratio::all(drive.size.series())
            .filter(|ratio| printed.iter().any(|cell| cell.place.ratio == ratio.as_str()))
            .collect();
        Self { ratios, cells, by_symbol }
    }
}

/// Returns all drives in the order of the manual.
#[must_use]
pub fn drives() -> &'static [Drive] {
    &DRIVES
}

/// Returns the drive whose tables hold for this size, winding and feedback; `None` if the manual states no data (for
/// example the resolver on 20A to 58A, which is available on request only).
#[must_use]
pub fn drive(size: Size, winding: Winding, feedback: Feedback) -> Option<&'static Drive> {
    DRIVES
        .iter()
        .find(|drive| drive.size == size && drive.windings.contains(&winding) && drive.feedbacks.contains(&feedback))
}

/// Returns `true` if a feedback entry of a table (`RES / M128S`, or empty for all) covers this feedback.
pub(crate) fn covers(entry: &str, feedback: Feedback) -> bool {
    entry.is_empty() || entry.split(" / ").any(|name| name == feedback.as_str())
}

/// Returns `true` if a ratio entry of a table (`30`, `> 50`, or empty for all) covers this ratio.
pub(crate) fn covers_ratio(entry: &str, ratio: Ratio) -> bool {
    let value = ratio.value();
    match entry.strip_prefix('>') {
        Some(bound) => bound.trim().parse::<u16>().is_ok_and(|bound| value > bound),
        None => entry.is_empty() || entry.parse::<u16>().is_ok_and(|entry| entry == value),
    }
}

impl Drive {
    fn printed(&self) -> &Printed {
        self.printed.get_or_init(|| Printed::of(self))
    }

    /// Returns the reduction ratios, ascending.
    #[must_use]
    pub fn ratios(&self) -> &[Ratio] {
        &self.printed().ratios
    }

    /// Returns every cell of this drive's own tables (technical data, inertias, brake, lengths).
    #[must_use]
    pub fn cells(&self) -> &[&'static Cell] {
        &self.printed().cells
    }

    /// Returns the cell of a symbol for this feedback and ratio. `condition` must match exactly.
    #[must_use]
    pub fn cell(&self, symbol: &str, condition: &str, feedback: Feedback, ratio: Ratio) -> Option<&'static Cell> {
        self.cells_of(symbol, feedback, ratio).find(|cell| cell.place.condition == condition)
    }

    /// Returns the cells of a symbol for this feedback and ratio, with any condition.
    pub fn cells_of(&self, symbol: &str, feedback: Feedback, ratio: Ratio) -> impl Iterator<Item = &'static Cell> {
        let cells = self.printed().by_symbol.get(symbol).map(Vec::as_slice).unwrap_or_default().iter().copied();
        cells.filter(move |cell| covers(cell.feedback, feedback) && covers_ratio(cell.place.ratio, ratio))
    }

    /// Returns the value that checks use, in SI, with its source, grade and errata.
    ///
    /// If an open contradiction names a safe value, that value is returned with grade `computed`; a dash in the manual,
    /// and a row that does not exist, are [`Datum::NotPrinted`].
    #[must_use]
    pub fn datum<Q: Measure>(&self, symbol: &str, condition: &str, feedback: Feedback, ratio: Ratio) -> Datum<Q> {
        self.cell(symbol, condition, feedback, ratio).map_or(Datum::NotPrinted, datum_of)
    }
}

/// Returns the cell of a symbol in the tables that are headed by size only (accuracy, stiffness, output bearing, fits,
/// screws).
#[must_use]
pub fn size_cell(size: Size, ratio: Ratio, symbol: &str) -> Option<&'static Cell> {
    let names = [size.series().as_str(), size.as_str()];
    let is_headed = |cell: &Cell| cell.place.drive.split(" / ").any(|head| is_head_of(head, names));
    SIZE_CELLS.get(symbol)?.iter().copied().find(|cell| is_headed(cell) && covers_ratio(cell.place.ratio, ratio))
}

/// Returns `true` if the heading of a table is that of a size of a series: `CHA-20A`.
fn is_head_of(head: &str, [series, size]: [&str; 2]) -> bool {
    head.strip_prefix(series).and_then(|rest| rest.strip_prefix('-')) == Some(size)
}

/// Cells of the tables that are headed by size, by symbol.
static SIZE_CELLS: LazyLock<BTreeMap<&'static str, Vec<&'static Cell>>> = LazyLock::new(|| {
    let mut by_symbol: BTreeMap<&'static str, Vec<&'static Cell>> = BTreeMap::new();
    for series in crate::series() {
        let of_series =
            |table: &&ManualTable| table.source == series.manual && SeriesData::begins(series.by_size, table.section);
        for cell in crate::tables().iter().filter(of_series).flat_map(ManualTable::cells) {
            by_symbol.entry(cell.place.symbol).or_default().push(cell);
        }
    }
    by_symbol
});

/// Returns the value of a cell in SI, as checks use it.
#[must_use]
pub fn datum_of<Q: Measure>(cell: &'static Cell) -> Datum<Q> {
    let unit = Unit::of_dimension(Q::DIMENSION, cell.unit);
    match (cell.limit().number(), unit) {
        (Some(value), Some(unit)) => Datum::Known(cell.sourced(Q::from_si(unit.to_si(value)))),
        _ => Datum::NotPrinted,
    }
}

/// Returns every stated value of one actuator, in the order of the manual: the general data of its winding, its drive's
/// tables, the tables by size, the tables of its feedback, and the tables for all actuators. Ordering tables, pin-outs
/// and the tables of the selection procedure are left out.
#[must_use]
pub fn cells_about(size: Size, winding: Winding, feedback: Feedback, ratio: Ratio) -> Vec<&'static Cell> {
    let Some(drive) = drive(size, winding, feedback) else { return Vec::new() };
    let series = SeriesData::of(size.series());
    let names = [size.series().as_str(), size.as_str()];
    let general_head = winding_data(winding).map_or("", |data| data.general_head);
    crate::tables()
        .iter()
        .filter(|table| table.source == series.manual && !is_ordering_or_wiring(table, series))
        .flat_map(|table| table.cells().iter().map(move |cell| (table.section, cell)))
        .filter(|(section, cell)| {
            let is_head = |head: &str| head == drive.name || head == general_head || is_head_of(head, names);
            let by_drive = cell.place.drive.split(" / ").any(is_head);
            let of_none = cell.place.drive.is_empty();
            let by_feedback = of_none && !cell.feedback.is_empty() && SeriesData::begins(series.feedback, section);
            let of_all = of_none && cell.feedback.is_empty() && SeriesData::begins(series.of_all, section);
            (by_drive || by_feedback || of_all)
                && covers(cell.feedback, feedback)
                && covers_ratio(cell.place.ratio, ratio)
        })
        .map(|(_, cell)| cell)
        .collect()
}

/// Sections of ordering are named in full, those of wiring by their beginning: the number of a chapter is a prefix of
/// others.
fn is_ordering_or_wiring(table: &ManualTable, series: &SeriesData) -> bool {
    series.ordering.iter().any(|section| match section.contains('.') {
        true => table.section.starts_with(section),
        false => table.section == *section,
    })
}

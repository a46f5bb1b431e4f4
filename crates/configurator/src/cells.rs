//! Cells of the catalogue as data that may be missing.

use catalogue::{Cell, ManualTable, SeriesData};
use order_code::{OrderCode, Series};
use provenance::Datum;
use quantities::Measure;

/// Returns the pure number of a cell \[1\].
pub(crate) fn number_of(cell: Option<&'static Cell>) -> Datum<f64> {
    Datum::of(cell.and_then(|cell| Some(cell.sourced(cell.limit().number()?))))
}

/// Returns the quantity of a cell that may be missing.
pub(crate) fn quantity_of<Q: Measure>(cell: Option<&'static Cell>) -> Datum<Q> {
    cell.map_or(Datum::NotPrinted, catalogue::datum_of)
}

/// Returns a value from the tables that list data by size.
pub(crate) fn by_size<Q: Measure>(code: &OrderCode, symbol: &str) -> Datum<Q> {
    quantity_of(catalogue::size_cell(code.size, code.ratio, symbol))
}

/// Returns a cell that holds at every ratio, from the tables of a feedback or of the encoder at the output.
pub(crate) fn feedback_cell(series: Series, name: &str, symbol: &str) -> Option<&'static Cell> {
    let data = SeriesData::of(series);
    let is_of_feedback = |table: &&ManualTable| {
        table.id == data.output_encoder
            || (table.source == data.manual && SeriesData::begins(data.feedback, table.section))
    };
    catalogue::tables()
        .iter()
        .filter(is_of_feedback)
        .flat_map(ManualTable::cells)
        .find(|cell| cell.feedback == name && cell.place.symbol == symbol && cell.place.ratio.is_empty())
}

//! Cells of the manual for the data sheet of a code.

use catalogue::{Cell, ManualTable, SeriesData, drive};
use order_code::{Brake, OrderCode};

/// Returns the cells that hold for a code in the order of the manual, those of the encoder at the output last; `None` if
/// the manual states no data for the code.
///
/// Cells for the other brake variant and the sections of other feedback systems are left out.
#[must_use]
pub fn sheet_cells(code: &OrderCode) -> Option<Vec<&'static Cell>> {
    drive(code.size, code.winding, code.feedback)?;
    let mut cells = catalogue::cells_about(code.size, code.winding, code.feedback, code.ratio);
    cells.retain(|cell| concerns(cell, code));
    if code.has_output_encoder() {
        let series = SeriesData::of(code.series());
        let tables = [series.output_encoder].into_iter().chain(series.output_wiring.first().copied());
        cells.extend(tables.filter_map(catalogue::table).flat_map(ManualTable::cells));
    }
    Some(cells)
}

/// Returns `true` if a cell is valid for the brake variant of this code.
fn concerns(cell: &Cell, code: &OrderCode) -> bool {
    let symbol = cell.place.symbol;
    let of_the_other_variant = match code.brake {
        Brake::With => ["J_out", "J", "m", "L"].contains(&symbol),
        Brake::Without => {
            symbol.ends_with("_brake")
                || ["U_Br", "T_Br", "I_OBr", "I_HBr", "N_brakings", "N_emergency", "t_o", "t_c"].contains(&symbol)
        }
    };
    !of_the_other_variant
}

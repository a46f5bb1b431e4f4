//! The data sheet of one ordering code: every printed value that concerns it, with its table.

use catalogue::Cell;
use order_code::{Brake, Option1, OrderCode};

/// One printed value.
#[derive(Clone, Copy, Debug)]
pub struct SheetRow {
    /// The cell.
    pub cell: &'static Cell,
}

/// The values of one printed table.
#[derive(Clone, Debug)]
pub struct SheetSection {
    /// The table.
    pub table: &'static catalogue::Table,
    /// Its values for this code.
    pub rows: Vec<SheetRow>,
}

/// The data sheet of one ordering code.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The code.
    pub code: OrderCode,
    /// Its values by table, in the order of the manual.
    pub sections: Vec<SheetSection>,
}

/// The data sheet of a code; `None` where the manual prints no data for it.
///
/// Values that hold for the other brake variant only are left out, and so are the sections of other feedback systems.
#[must_use]
pub fn sheet(code: &OrderCode) -> Option<Sheet> {
    catalogue::drive(code.size, code.winding, code.feedback)?;
    let mut sections: Vec<SheetSection> = Vec::new();
    for cell in catalogue::cells_about(code.size, code.winding, code.feedback, code.ratio) {
        if !concerns(cell, code) {
            continue;
        }
        match sections.last_mut().filter(|section| section.table.id == cell.place.table) {
            Some(section) => section.rows.push(SheetRow { cell }),
            None => {
                if let Some(table) = catalogue::table(cell.place.table) {
                    sections.push(SheetSection { table, rows: vec![SheetRow { cell }] });
                }
            }
        }
    }
    if code.option_1 == Some(Option1::EC)
        && let Some(table) = catalogue::table("68.1")
    {
        let rows = table.cells().iter().map(|cell| SheetRow { cell }).collect();
        sections.push(SheetSection { table, rows });
    }
    Some(Sheet { code: *code, sections })
}

/// Whether a cell holds for this code's brake variant.
fn concerns(cell: &Cell, code: &OrderCode) -> bool {
    let of_the_other_variant = match code.brake {
        Brake::With => ["J_out", "J", "m", "L"].contains(&cell.place.symbol),
        Brake::Without => {
            cell.place.symbol.ends_with("_brake")
                || ["U_Br", "T_Br", "I_OBr", "I_HBr", "N_brakings", "N_emergency", "t_o", "t_c"]
                    .contains(&cell.place.symbol)
        }
    };
    !of_the_other_variant
}

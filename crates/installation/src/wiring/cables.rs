//! Cables listed in sections 6.24 and 6.25.

use super::role::{Role, holds};
use catalogue::{Cell, ManualTable, SeriesData};
use order_code::{Brake, OrderCode};
use quantities::identified;

/// A cable with its material number.
#[derive(Clone, Copy, Debug)]
pub struct Cable {
    /// Connector of the cable.
    pub role: CableRole,
    /// Material number of the cable.
    pub number: &'static Cell,
    /// Length of the cable.
    pub length: CableLength,
    /// Device at the other end of the cable.
    pub goal: CableFor,
}

identified! {
    /// Connector of a cable.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum CableRole {
        /// Motor connector.
        Motor = "motor",
        /// Connector of the motor feedback.
        Feedback = "feedback",
        /// Connector of the encoder at the output.
        OutputEncoder = "output_encoder",
        /// A set with one number, whose content the manual does not state.
        Set = "set",
    }
}

/// Length of a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CableLength {
    /// Length stated in the manual \[m\].
    Metres(f64),
    /// Letters of the material number that stand for the length, explained by the manufacturer of the drive: `xx`.
    InNumber(&'static str),
}

identified! {
    /// Device at the other end of a cable.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum CableFor {
        /// SINAMICS S120 with a sensor module SMC.
        SinamicsSmc = "sinamics_s120_smc",
        /// SINAMICS S120 with the sensor module SMC20.
        SinamicsSmc20 = "sinamics_s120_smc20",
        /// SIMODRIVE.
        Simodrive = "simodrive",
        /// `YukonDrive`.
        YukonDrive = "yukondrive",
        /// Any device: open end.
        OpenEnd = "open_end",
    }
}

/// Letters of a material number that stand for a length.
const LENGTH_CODE: &str = "xx";

/// Returns the cables of a code in the order of the manual.
pub(super) fn cables(code: &OrderCode) -> Vec<Cable> {
    let winding = format!("winding={}", code.winding);
    let cells = SeriesData::of(code.series())
        .cables
        .iter()
        .filter_map(|table| catalogue::table(table))
        .flat_map(ManualTable::cells);
    cells.filter_map(|cell| cable(cell, code, &winding)).collect()
}

fn cable(cell: &'static Cell, code: &OrderCode, winding: &str) -> Option<Cable> {
    let condition = cell.place.condition;
    let of_output = SeriesData::of(code.series()).output_wiring.contains(&cell.place.table);
    let role = if of_output { Role::OutputEncoder } else { Role::Feedback };
    if of_output && !code.has_output_encoder() || !holds(cell, role, code) {
        return None;
    }
    if !of_output && condition.split(", ").next() != Some(winding) {
        return None;
    }
    let brake = match condition {
        text if text.ends_with("without brake") => Some(Brake::Without),
        text if text.ends_with("with brake") => Some(Brake::With),
        _ => None,
    };
    if brake.is_some_and(|brake| brake != code.brake) {
        return None;
    }
    let role = match cell.place.symbol {
        "power_cable" => CableRole::Motor,
        "feedback_cable" | "mat_no" if of_output => CableRole::OutputEncoder,
        "feedback_cable" => CableRole::Feedback,
        "mat_no" => CableRole::Set,
        _ => return None,
    };
    let goal = match condition {
        text if text.contains("SMC20") => CableFor::SinamicsSmc20,
        text if text.contains("SIMODRIVE") => CableFor::Simodrive,
        text if text.contains("YukonDrive") => CableFor::YukonDrive,
        text if text.contains("open end") => CableFor::OpenEnd,
        _ => CableFor::SinamicsSmc,
    };
    let length = if cell.corrected.contains(LENGTH_CODE) {
        CableLength::InNumber(LENGTH_CODE)
    } else {
        let metres = condition.rsplit(", ").next()?.strip_suffix(" m")?;
        CableLength::Metres(metres.parse().ok()?)
    };
    Some(Cable { role, number: cell, length, goal })
}

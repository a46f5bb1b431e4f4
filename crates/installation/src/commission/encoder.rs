//! Data of the manual on the encoders of a code: lines, protocol, supply, turns.

use catalogue::{Cell, Footnote, ManualTable, SeriesData};
use order_code::OrderCode;

/// Side of an encoder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EncoderSide {
    /// Motor shaft: commutation, speed, position.
    Motor,
    /// Output flange, option EC.
    Output,
}

/// A value of the manual on an encoder, with its notes.
#[derive(Clone, Debug, PartialEq)]
pub struct EncoderRow {
    /// Side of the encoder.
    pub side: EncoderSide,
    /// Cell of the value.
    pub cell: &'static Cell,
    /// Notes on the cell.
    pub notes: Vec<&'static Footnote>,
}

/// Returns the cells on the encoders of a code in the order of the manual: section 6.22 for the motor, table 68.1 for
/// option EC.
#[must_use]
pub fn rows(code: &OrderCode) -> Vec<EncoderRow> {
    let ratio = code.ratio.to_string();
    let of = |table: &'static ManualTable, name: &'static str, side: EncoderSide| {
        let ratio = ratio.clone();
        let concerns = move |cell: &&'static Cell| {
            cell.feedback == name && (cell.place.ratio.is_empty() || cell.place.ratio == ratio)
        };
        table.cells().iter().filter(concerns).map(move |cell| EncoderRow {
            side,
            cell,
            notes: table.notes_on(cell).collect(),
        })
    };
    let mut rows = Vec::new();
    let series = SeriesData::of(code.series());
    for table in catalogue::tables().iter().filter(|table| table.source == series.manual) {
        if SeriesData::begins(series.feedback, table.section) {
            rows.extend(of(table, code.feedback.as_str(), EncoderSide::Motor));
        }
    }
    if let Some(option) = code.option_1 {
        let table = catalogue::table(series.output_encoder);
        rows.extend(table.into_iter().flat_map(|table| of(table, option.as_str(), EncoderSide::Output)));
    }
    rows
}

/// Returns the increments of the motor feedback per turn, with the interpolation stated in its table.
#[must_use]
pub fn increments(code: &OrderCode) -> Option<&'static Cell> {
    rows(code).into_iter().map(|row| row.cell).find(|cell| cell.place.symbol == "resolution_motor_inc")
}

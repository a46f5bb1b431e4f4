//! What is printed about the encoders of a code: lines, protocol, supply, turns.

use catalogue::{Cell, Footnote, Table};
use order_code::{Option1, OrderCode};

/// On which side an encoder sits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EncoderSide {
    /// On the motor shaft: commutation, speed, position.
    Motor,
    /// On the output flange, option EC.
    Output,
}

/// A printed value of an encoder, with the notes on it.
#[derive(Clone, Debug, PartialEq)]
pub struct EncoderRow {
    /// Which encoder.
    pub side: EncoderSide,
    /// The cell.
    pub cell: &'static Cell,
    /// Notes on the cell.
    pub notes: Vec<&'static Footnote>,
}

/// The cells about the encoders of a code, in the order of the manual: section 6.22 for the motor, table 68.1 for option EC.
#[must_use]
pub fn rows(code: &OrderCode) -> Vec<EncoderRow> {
    let ratio = code.ratio.to_string();
    let of = |table: &'static Table, name: &'static str, side: EncoderSide| {
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
    for table in catalogue::tables() {
        if table.section.starts_with("6.22") {
            rows.extend(of(table, code.feedback.as_str(), EncoderSide::Motor));
        }
    }
    if code.option_1 == Some(Option1::EC) {
        rows.extend(catalogue::table("68.1").into_iter().flat_map(|table| of(table, "EC", EncoderSide::Output)));
    }
    rows
}

/// The increments of the motor's feedback in one turn, as printed with the interpolation that its table names.
#[must_use]
pub fn increments(code: &OrderCode) -> Option<&'static Cell> {
    rows(code).into_iter().map(|row| row.cell).find(|cell| cell.place.symbol == "resolution_motor_inc")
}

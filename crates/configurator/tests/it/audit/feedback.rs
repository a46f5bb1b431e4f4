//! Steps, turns and words of the feedback systems (tables 57.1 to 61.1 and 68.1).

use super::tally::Tally;
use super::view::{AuditedCell, CellView, Span, brief};

/// Tables of the feedback systems, with the number of interpolation steps per period of the incremental signal.
///
/// Sine and cosine with 8 bit: 2^8; square waves: 4 edges; resolver with 11 bit: 2^11 (the notes of the tables).
const SYSTEMS: [(&str, f64); 6] =
    [("57.1", 256.0), ("58.1", 256.0), ("58.2", 2048.0), ("59.1", 256.0), ("61.1", 4.0), ("68.1", 256.0)];

const ARCSEC_PER_TURN: f64 = 360.0 * 3600.0;

/// Incremental steps = lines times interpolation, resolution at the output = 360° / (steps i)
///
/// Source: notes of tables 57.1 to 61.1 and 68.1.
/// Tolerance: steps exact; half of the last printed digit of the resolutions. Blamed: the resolution.
pub(super) fn resolution(view: &CellView, tally: &mut Tally) {
    for (table, interpolation) in SYSTEMS {
        let lines = only(view, table, "n_1_lines").or_else(|| only(view, table, "pole_pairs_resolver"));
        let Some((cell, periods)) = lines.and_then(|cell| Some((cell, cell.number()?))) else {
            tally.absent(format_args!("lines of table {table}"));
            continue;
        };
        let steps = periods * interpolation;
        if let Some(printed) = only(view, table, "resolution_motor_inc") {
            exact(tally, printed, steps, &[printed, cell], "lines times interpolation");
        } else if table != "68.1" {
            tally.absent(format_args!("resolution_motor_inc of table {table}"));
        }
        resolutions(view, tally, table, "resolution_out", steps);
        if let Some(positions) = only(view, table, "positions_per_turn").and_then(AuditedCell::number) {
            resolutions(view, tally, table, "resolution_out_absolute", positions);
        }
    }
}

fn resolutions(view: &CellView, tally: &mut Tally, table: &str, symbol: &str, steps: f64) {
    let mut seen = 0;
    for cell in view.row(table, symbol) {
        seen += 1;
        let ratio = if cell.cell.place.ratio.is_empty() { Some(1.0) } else { cell.cell.place.ratio.parse().ok() };
        let Some((span, ratio)) = cell.span().zip(ratio) else {
            tally.absent(cell.place());
            continue;
        };
        let expected = ARCSEC_PER_TURN / steps / ratio;
        tally.compare(span.meets(Span::exact(expected)), &[cell], || {
            format!("{} is {}, 360° / (steps i) gives {}", cell.place(), cell.text, brief(expected))
        });
    }
    if seen == 0 {
        tally.absent(format_args!("{symbol} of table {table}"));
    }
}

/// turns_out = ⌊turns / i⌋, turns = 2^turns_bits, positions = 2^positions_bits, SSI word = sum of both bits
///
/// Source: tables 58.1 and 59.1; a whole turn of the output takes i turns of the motor.
/// Tolerance: none, all are counts. Blamed: the turns at the output, the numbers of bits.
pub(super) fn turns(view: &CellView, tally: &mut Tally) {
    for table in ["58.1", "59.1"] {
        let Some(turns) = only(view, table, "turns").and_then(AuditedCell::number) else {
            tally.absent(format_args!("turns of table {table}"));
            continue;
        };
        for cell in view.row(table, "turns_out") {
            match cell.cell.place.ratio.parse::<f64>() {
                Ok(ratio) => exact(tally, cell, (turns / ratio).floor(), &[cell], "whole turns of the motor over i"),
                Err(_) => tally.absent(cell.place()),
            }
        }
    }
    let get = |symbol| only(view, "59.1", symbol);
    for (count, bits) in [("turns", "turns_bits"), ("positions_per_turn", "positions_per_turn_bits")] {
        let Some((bits, count)) = get(bits).zip(get(count).and_then(AuditedCell::number)) else {
            tally.absent(format_args!("{count} or {bits} of table 59.1"));
            continue;
        };
        exact(tally, bits, count.log2(), &[bits], "the binary logarithm of the count");
    }
    let bits = get("turns_bits").zip(get("positions_per_turn_bits"));
    let Some((word, (turn_bits, position_bits))) = get("ssi_word_length").zip(bits) else {
        tally.absent("ssi_word_length of table 59.1");
        return;
    };
    let Some((a, b)) = turn_bits.number().zip(position_bits.number()) else {
        tally.absent(word.place());
        return;
    };
    exact(tally, word, a + b, &[word, turn_bits, position_bits], "bits of turns and positions together");
}

fn exact(tally: &mut Tally, cell: &AuditedCell, expected: f64, blamed: &[&AuditedCell], how: &str) {
    let Some(number) = cell.number() else {
        tally.absent(cell.place());
        return;
    };
    tally.compare((number - expected).abs() < 1e-9, blamed, || {
        format!("{} is {}, {how} gives {expected}", cell.place(), cell.text)
    });
}

/// Returns the cell of a symbol that a table states once.
fn only<'a>(view: &'a CellView, table: &'a str, symbol: &'a str) -> Option<&'a AuditedCell> {
    view.row(table, symbol).next()
}

mod tests {
    use super::super::findings_of;
    use super::*;

    fn altered(table: &str, symbol: &'static str, ratio: &'static str, text: &str) -> CellView {
        CellView::with(table, text, |cell| cell.place.symbol == symbol && cell.place.ratio == ratio)
    }

    #[test]
    fn a_changed_resolution_or_step_count_is_found() {
        assert_eq!(findings_of(resolution, &altered("57.1", "resolution_motor_inc", "", "262143")).len(), 1);
        assert_eq!(findings_of(resolution, &altered("57.1", "resolution_out", "50", "0,11")).len(), 1);
        assert_eq!(findings_of(resolution, &altered("58.2", "resolution_out", "50", "14")).len(), 1);
        assert_eq!(findings_of(resolution, &altered("61.1", "resolution_out", "100", "1,7")).len(), 1);
    }

    #[test]
    fn changed_turns_or_bits_are_found() {
        assert_eq!(findings_of(turns, &altered("58.1", "turns_out", "30", "137")).len(), 1);
        assert_eq!(findings_of(turns, &altered("59.1", "positions_per_turn_bits", "", "18")).len(), 1);
    }
}

//! Counts of answers.

use arrow_array::cast::AsArray;
use arrow_array::types::UInt32Type;
use arrow_array::{Array, RecordBatch, UInt32Array};
use questions::Fit;
use questions::sweep::Tally;

/// Adds the answers of a batch to a tally; each of several lines of a row counts.
pub fn count(batch: &RecordBatch, tally: &mut Tally) {
    let text = |name: &str| batch.column_by_name(name).and_then(|column| column.as_string_opt::<i32>().cloned());
    let (tightest, error) = (text("tightest"), text("error"));
    let number = |name: &str| batch.column_by_name(name)?.as_primitive_opt::<UInt32Type>().cloned();
    let (fit, fit_if_estimate) = (number("fit"), number("fit_if_estimate"));
    let verdict = text("verdict");
    let counts = |column: &Option<UInt32Array>, row: usize| {
        column.as_ref().is_some_and(|column| column.is_valid(row) && column.value(row) > 0)
    };
    for row in 0..batch.num_rows() {
        if let Some(error) = error.as_ref().filter(|error| error.is_valid(row)) {
            tally.refused(error.value(row));
            continue;
        }
        let found = match (&fit, &verdict) {
            (Some(_), _) if counts(&fit, row) => Fit::Fits,
            (Some(_), _) if counts(&fit_if_estimate, row) => Fit::FitsIfEstimate,
            (None, Some(verdict)) if verdict.is_valid(row) => {
                let id = verdict.value(row);
                Fit::ALL.into_iter().find(|fit| fit.id() == id).unwrap_or(Fit::DoesNotFit)
            }
            _ => Fit::DoesNotFit,
        };
        let tightest = tightest.as_ref().filter(|tightest| tightest.is_valid(row)).map(|tightest| tightest.value(row));
        tally.judged(found, tightest);
    }
}

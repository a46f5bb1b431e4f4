//! Answers counted.

use arrow_array::cast::AsArray;
use arrow_array::types::UInt32Type;
use arrow_array::{Array, RecordBatch};
use questions::sweep::Tally;

/// Adds the answers of a batch to a tally; of several lines of a row each counts.
pub fn count(batch: &RecordBatch, tally: &mut Tally) {
    let text = |name: &str| batch.column_by_name(name).and_then(|column| column.as_string_opt::<i32>().cloned());
    let (code, tightest, error) = (text("code"), text("tightest"), text("error"));
    let fit = batch.column_by_name("fit").and_then(|column| column.as_primitive_opt::<UInt32Type>().cloned());
    let fits = batch.column_by_name("fits").and_then(|column| column.as_boolean_opt().cloned());
    for row in 0..batch.num_rows() {
        if let Some(error) = error.as_ref().filter(|error| error.is_valid(row)) {
            tally.refused(error.value(row));
            continue;
        }
        let fits = match (&fit, &fits) {
            (Some(fit), _) => fit.is_valid(row) && fit.value(row) > 0,
            (None, Some(fits)) => fits.is_valid(row) && fits.value(row),
            (None, None) => code.as_ref().is_some_and(|code| code.is_valid(row)),
        };
        let tightest = tightest.as_ref().filter(|tightest| tightest.is_valid(row)).map(|tightest| tightest.value(row));
        tally.judged(fits, tightest);
    }
}

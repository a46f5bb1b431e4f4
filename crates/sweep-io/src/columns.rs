//! Columns of a record batch as cells.

use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_array::{Array, ArrayRef, RecordBatch};
use arrow_cast::cast;
use arrow_schema::DataType;
use questions::sweep::Cells;
use std::borrow::Cow;

/// Returns the cells of some columns of a batch, column by column.
pub(crate) fn cells(batch: &RecordBatch, places: &[usize]) -> Vec<Cells<'static>> {
    places.iter().filter_map(|place| batch.columns().get(*place)).map(of_column).collect()
}

/// Returns the cells of a column: every numeric type as numbers, texts and booleans as texts.
fn of_column(column: &ArrayRef) -> Cells<'static> {
    let found = column.data_type();
    let other = || Cells::Other(found.to_string(), column.len());
    match found {
        DataType::Null => Cells::Numbers(vec![None; column.len()]),
        found if found.is_numeric() => cast(column, &DataType::Float64).map_or_else(
            |_| other(),
            |numbers| Cells::Numbers(numbers.as_primitive::<Float64Type>().iter().map(known).collect()),
        ),
        DataType::Boolean => {
            let text = |flag: bool| Cow::Borrowed(if flag { "true" } else { "false" });
            Cells::Texts(column.as_boolean().iter().map(|flag| flag.map(text)).collect())
        }
        DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View => texts(column).unwrap_or_else(other),
        DataType::Dictionary(_, values) if values.is_string() => texts(column).unwrap_or_else(other),
        DataType::Dictionary(_, values) if values.is_numeric() => {
            cast(column, values).map_or_else(|_| other(), |plain| of_column(&plain))
        }
        _ => other(),
    }
}

/// Returns a number; one that is none is an empty cell, as libraries of tables write it.
fn known(number: Option<f64>) -> Option<f64> {
    number.filter(|number| !number.is_nan())
}

fn texts(column: &ArrayRef) -> Option<Cells<'static>> {
    let texts = cast(column, &DataType::Utf8).ok()?;
    Some(Cells::Texts(
        texts.as_string::<i32>().iter().map(|text| text.map(|text| Cow::Owned(text.to_owned()))).collect(),
    ))
}

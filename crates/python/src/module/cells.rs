//! Cells of Arrow as values of Python.

use super::call::Conversion;
use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int64Type, UInt32Type, UInt64Type};
use arrow_array::{Array, ArrayRef};
use arrow_schema::{ArrowError, DataType, TimeUnit};
use pyo3::exceptions::PyTypeError;
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyFloat, PyList, PyString, PyTuple};

/// Appends the values of a column to a list, each as the type of Python that holds it without loss.
///
/// # Errors
/// A type that no value of Python holds; an interrupt.
pub(super) fn append(
    values: &Bound<'_, PyList>,
    array: &ArrayRef,
    heading: &str,
    conversion: &mut Conversion,
) -> PyResult<()> {
    let py = values.py();
    let nulls = array.logical_nulls();
    for row in 0..array.len() {
        conversion.count(py)?;
        if nulls.as_ref().is_some_and(|nulls| nulls.is_null(row)) {
            values.append(py.None())?;
            continue;
        }
        match array.data_type() {
            DataType::Utf8 => values.append(PyString::new(py, array.as_string::<i32>().value(row)))?,
            DataType::Float64 => values.append(PyFloat::new(py, array.as_primitive::<Float64Type>().value(row)))?,
            DataType::UInt64 => values.append(array.as_primitive::<UInt64Type>().value(row))?,
            DataType::UInt32 => values.append(array.as_primitive::<UInt32Type>().value(row))?,
            DataType::Int64 => values.append(array.as_primitive::<Int64Type>().value(row))?,
            DataType::Boolean => values.append(array.as_boolean().value(row))?,
            _ => values.append(repeated(&array.slice(row, 1), heading, py, conversion)?)?,
        }
    }
    Ok(())
}

/// Returns the only value of a column that the table repeats.
fn repeated<'py>(
    one: &ArrayRef,
    heading: &str,
    py: Python<'py>,
    conversion: &mut Conversion,
) -> PyResult<Bound<'py, PyAny>> {
    let cast = |of: &DataType| arrow_cast::cast(one, of).map_err(|error| unread(heading, one.data_type(), &error));
    let mut list = |inner: &ArrayRef| {
        let values = PyList::empty(py);
        append(&values, inner, heading, conversion)?;
        Ok::<_, PyErr>(values)
    };
    Ok(match one.data_type() {
        kind if kind.is_integer() => whole(&cast(&DataType::Int64)?, py)?,
        kind if kind.is_floating() => {
            PyFloat::new(py, cast(&DataType::Float64)?.as_primitive::<Float64Type>().value(0)).into_any()
        }
        DataType::Binary | DataType::LargeBinary | DataType::BinaryView | DataType::FixedSizeBinary(_) => {
            PyBytes::new(py, cast(&DataType::LargeBinary)?.as_binary::<i64>().value(0)).into_any()
        }
        DataType::Date32 => made(py, "day", (whole(&cast(&DataType::Int32)?, py)?,))?,
        DataType::Date64 => made(py, "day", (whole(&cast(&DataType::Date32)?, py)?,))?,
        DataType::Time32(unit) | DataType::Time64(unit) => {
            let ticks = if matches!(one.data_type(), DataType::Time32(_)) { DataType::Int32 } else { DataType::Int64 };
            made(py, "time", (whole(&cast(&ticks)?, py)?, ticks_of(*unit)))?
        }
        DataType::Duration(unit) => made(py, "duration", (whole(&cast(&DataType::Int64)?, py)?, ticks_of(*unit)))?,
        DataType::Timestamp(unit, zone) => {
            made(py, "instant", (whole(&cast(&DataType::Int64)?, py)?, ticks_of(*unit), zone.as_deref()))?
        }
        kind if kind.is_numeric() => {
            made(py, "decimal_of", (PyString::new(py, cast(&DataType::Utf8)?.as_string::<i32>().value(0)),))?
        }
        DataType::Dictionary(_, values) => first(&list(&cast(values)?)?)?,
        DataType::LargeList(_) => list(&one.as_list::<i64>().value(0))?.into_any(),
        DataType::List(_) => list(&one.as_list::<i32>().value(0))?.into_any(),
        DataType::FixedSizeList(..) => list(&one.as_fixed_size_list().value(0))?.into_any(),
        DataType::Map(..) => {
            let pairs = one.as_map().value(0);
            let [keys, values] = [list(pairs.column(0))?, list(pairs.column(1))?];
            let found = PyList::empty(py);
            for (key, value) in keys.iter().zip(values.iter()) {
                found.append((key, value))?;
            }
            found.into_any()
        }
        DataType::Struct(fields) => {
            let found = PyDict::new(py);
            for (field, column) in fields.iter().zip(one.as_struct().columns()) {
                found.set_item(field.name(), first(&list(column)?)?)?;
            }
            found.into_any()
        }
        _ => PyString::new(py, cast(&DataType::Utf8)?.as_string::<i32>().value(0)).into_any(),
    })
}

fn first<'py>(values: &Bound<'py, PyList>) -> PyResult<Bound<'py, PyAny>> {
    values.get_item(0)
}

/// Returns the whole number of a column of one.
fn whole<'py>(one: &ArrayRef, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
    let value = arrow_cast::cast(one, &DataType::Int64).map_err(|error| PyTypeError::new_err(error.to_string()))?;
    Ok(value.as_primitive::<Int64Type>().value(0).into_pyobject(py)?.into_any())
}

/// Returns a value of a class of Python's standard library.
fn made<'py>(
    py: Python<'py>,
    of: &str,
    of_what: impl IntoPyObject<'py, Target = PyTuple, Output = Bound<'py, PyTuple>, Error = PyErr>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import(intern!(py, "antrieb._cells"))?.getattr(of)?.call1(of_what.into_pyobject(py)?)
}

/// Returns how many ticks a second has.
const fn ticks_of(unit: TimeUnit) -> i64 {
    match unit {
        TimeUnit::Second => 1,
        TimeUnit::Millisecond => 1_000,
        TimeUnit::Microsecond => 1_000_000,
        TimeUnit::Nanosecond => 1_000_000_000,
    }
}

fn unread(heading: &str, kind: &DataType, error: &ArrowError) -> PyErr {
    PyTypeError::new_err(format!(
        "column '{heading}' is of type {kind}, which is not read as values of Python: {error}"
    ))
}

//! Tables as capsules of Arrow's PyCapsule interface, in and out: pointers to structures of its C interface.
//!
//! The only file of the crate that dereferences pointers. Its assumptions: a capsule of the right name holds the
//! structure of that name, filled as the C interface specifies, and its producer keeps it until the structure is moved
//! out or the capsule is destroyed.
#![allow(unsafe_code, reason = "the structures of Arrow's C interface: docs/decisions/0028-python-on-arrow.md")]

use arrow_array::ffi::{FFI_ArrowArray, FFI_ArrowSchema, from_ffi};
use arrow_array::ffi_stream::{ArrowArrayStreamReader, FFI_ArrowArrayStream};
use arrow_array::{RecordBatch, RecordBatchIterator, RecordBatchReader, StructArray};
use arrow_schema::{ArrowError, DataType, Schema, SchemaRef};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyTuple};
use std::ffi::CStr;

const STREAM: &CStr = c"arrow_array_stream";
const SCHEMA: &CStr = c"arrow_schema";
const ARRAY: &CStr = c"arrow_array";

fn trouble(error: ArrowError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// Returns the columns and the batches of any object that provides a stream or an array of Arrow.
pub(crate) fn table(from: &Bound<'_, PyAny>) -> PyResult<(SchemaRef, Vec<RecordBatch>)> {
    if from.hasattr("__arrow_c_stream__")? {
        let capsule = from.call_method0("__arrow_c_stream__")?.cast_into::<PyCapsule>()?;
        let pointer = capsule.pointer_checked(Some(STREAM))?.cast::<FFI_ArrowArrayStream>();
        // SAFETY: the capsule is alive and of this name, so it points to a stream; it is moved out, and an empty one left.
        let reader = unsafe { ArrowArrayStreamReader::from_raw(pointer.as_ptr()) }.map_err(trouble)?;
        let schema = reader.schema();
        // Reading may call back into the producer, which acquires the interpreter lock when it needs it.
        let batches = reader.collect::<Result<Vec<_>, _>>().map_err(trouble)?;
        return Ok((schema, batches));
    }
    if from.hasattr("__arrow_c_array__")? {
        let both = from.call_method0("__arrow_c_array__")?.cast_into::<PyTuple>()?;
        let schema = both.get_item(0)?.cast_into::<PyCapsule>()?;
        let array = both.get_item(1)?.cast_into::<PyCapsule>()?;
        let schema = schema.pointer_checked(Some(SCHEMA))?.cast::<FFI_ArrowSchema>();
        let array = array.pointer_checked(Some(ARRAY))?.cast::<FFI_ArrowArray>();
        // SAFETY: both capsules are alive and of these names; the array is moved out and its release left to what it became,
        // the schema is only read while its capsule lives.
        let data = unsafe { from_ffi(FFI_ArrowArray::from_raw(array.as_ptr()), schema.as_ref()) }.map_err(trouble)?;
        if !matches!(data.data_type(), DataType::Struct(_)) {
            return Err(PyTypeError::new_err("an array of structs is expected: a record batch"));
        }
        let batch = RecordBatch::from(StructArray::from(data));
        return Ok((batch.schema(), vec![batch]));
    }
    Err(PyTypeError::new_err(format!(
        "an Arrow table is expected (`__arrow_c_stream__` or `__arrow_c_array__`), not {}",
        from.get_type().name()?
    )))
}

/// Returns the columns of a schema, or of any object that has one.
pub(crate) fn schema(from: &Bound<'_, PyAny>) -> PyResult<SchemaRef> {
    if !from.hasattr("__arrow_c_schema__")? {
        return table(from).map(|(schema, _)| schema);
    }
    let capsule = from.call_method0("__arrow_c_schema__")?.cast_into::<PyCapsule>()?;
    let pointer = capsule.pointer_checked(Some(SCHEMA))?.cast::<FFI_ArrowSchema>();
    // SAFETY: the capsule is alive and of this name, so it points to a schema, which is only read.
    Schema::try_from(unsafe { pointer.as_ref() }).map(Into::into).map_err(trouble)
}

/// Returns batches as a stream.
pub(crate) fn stream<'py>(
    py: Python<'py>,
    schema: SchemaRef,
    batches: Vec<RecordBatch>,
) -> PyResult<Bound<'py, PyCapsule>> {
    let reader = RecordBatchIterator::new(batches.into_iter().map(Ok), schema);
    PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(reader)), STREAM)
}

/// Returns columns as a schema.
pub(crate) fn schema_capsule<'py>(py: Python<'py>, schema: &Schema) -> PyResult<Bound<'py, PyCapsule>> {
    PyCapsule::new_with_value(py, FFI_ArrowSchema::try_from(schema).map_err(trouble)?, SCHEMA)
}

//! Tables and sweeps as Python objects.

use super::call::{Handed, interruptible, refused, text};
use crate::SweepCall;
use crate::module::capsules;
use crate::sweep::checked;
use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int64Type, UInt32Type, UInt64Type};
use arrow_array::{Array, ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_ipc::reader::StreamReader;
use arrow_ipc::writer::StreamWriter;
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyCapsule, PyDict, PyFloat, PyInt, PyList, PyString};
use quantities::Language;
use questions::list::Unanswered;
use questions::{Progress, Refusal};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A table of Arrow: what reads Arrow takes it as it is.
#[pyclass(frozen, module = "antrieb")]
pub(crate) struct Table {
    schema: SchemaRef,
    batches: Vec<RecordBatch>,
}

#[pymethods]
impl Table {
    /// A table of lists by the headings of their columns: numbers, texts or truth values, `None` where there is none.
    #[staticmethod]
    fn from_pydict(columns: &Bound<'_, PyDict>) -> PyResult<Self> {
        let mut fields = Vec::new();
        let mut arrays: Vec<ArrayRef> = Vec::new();
        for (heading, values) in columns {
            let array = column(&values.cast_into::<PyList>()?)?;
            fields.push(Field::new(heading.extract::<String>()?, array.data_type().clone(), true));
            arrays.push(array);
        }
        let schema: SchemaRef = Arc::new(Schema::new(fields));
        let options = arrow_array::RecordBatchOptions::new().with_row_count(arrays.first().map(Array::len).or(Some(0)));
        let batch = RecordBatch::try_new_with_options(Arc::clone(&schema), arrays, &options);
        let batch = batch.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(Self { schema, batches: vec![batch] })
    }

    /// The headings of the columns.
    #[getter]
    fn column_names(&self) -> Vec<String> {
        self.schema.fields().iter().map(|field| field.name().clone()).collect()
    }

    /// Lists by the headings of their columns.
    fn to_pydict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        for (index, field) in self.schema.fields().iter().enumerate() {
            let values = PyList::empty(py);
            for array in self.batches.iter().filter_map(|batch| batch.columns().get(index)) {
                append(&values, array)?;
            }
            columns.set_item(field.name(), values)?;
        }
        Ok(columns)
    }

    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }

    fn __repr__(&self) -> String {
        format!("<Table of {} rows: {}>", self.__len__(), self.column_names().join(", "))
    }

    /// A table out of the bytes that `__reduce__` hands over.
    #[staticmethod]
    fn unpacked(bytes: &[u8]) -> PyResult<Self> {
        let reader = StreamReader::try_new(bytes, None).map_err(broken)?;
        let schema = reader.schema();
        Ok(Self { schema, batches: reader.collect::<Result<_, _>>().map_err(broken)? })
    }

    /// Returns the state for `pickle`: a stream of Arrow as bytes.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let mut bytes = Vec::new();
        let mut writer = StreamWriter::try_new(&mut bytes, &self.schema).map_err(broken)?;
        self.batches.iter().try_for_each(|batch| writer.write(batch)).map_err(broken)?;
        writer.finish().map_err(broken)?;
        drop(writer);
        let again = py.import(intern!(py, "antrieb._table"))?.getattr("unpacked")?;
        Ok((again, (PyBytes::new(py, &bytes),)))
    }

    /// The table itself: it cannot be changed.
    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    /// The table itself: it cannot be changed.
    fn __deepcopy__(slf: Py<Self>, memo: &Bound<'_, PyAny>) -> Py<Self> {
        let _ = memo;
        slf
    }

    /// The table as a stream of Arrow.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // A producer may leave a request unanswered; the reader casts.
        drop(requested_schema);
        capsules::stream(py, Arc::clone(&self.schema), self.batches.clone())
    }

    /// The columns as a schema of Arrow.
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyCapsule>> {
        capsules::schema_capsule(py, &self.schema)
    }
}

fn broken(error: arrow_schema::ArrowError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// Converts a Python list to a column.
fn column(values: &Bound<'_, PyList>) -> PyResult<ArrayRef> {
    let first = values.iter().find(|value| !value.is_none());
    let is = |of: fn(&Bound<'_, PyAny>) -> bool| values.iter().all(|value| value.is_none() || of(&value));
    Ok(match first {
        Some(first) if first.is_instance_of::<PyString>() => Arc::new(StringArray::from(each::<String>(values)?)),
        Some(first) if first.is_instance_of::<PyBool>() => Arc::new(BooleanArray::from(each::<bool>(values)?)),
        Some(_) if is(|value| value.is_instance_of::<PyInt>()) => Arc::new(Int64Array::from(each::<i64>(values)?)),
        Some(_) | None => Arc::new(Float64Array::from(each::<f64>(values)?)),
    })
}

fn each<'py, T>(values: &Bound<'py, PyList>) -> PyResult<Vec<Option<T>>>
where
    Option<T>: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    values.iter().map(|value| value.extract::<Option<T>>()).collect()
}

/// Appends the values of a column to a list.
fn append(values: &Bound<'_, PyList>, array: &ArrayRef) -> PyResult<()> {
    let py = values.py();
    for row in 0..array.len() {
        if array.is_null(row) {
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
            other => return Err(PyTypeError::new_err(format!("a column of {other} is read by a library of Arrow"))),
        }
    }
    Ok(())
}

/// A sweep over tables of the same columns: the project is read once.
#[pyclass(frozen, module = "antrieb._antrieb")]
pub(crate) struct Sweep {
    sweep: sweep_io::BatchSweep,
    /// Limit of the memory for recordings and answers \[byte\].
    memory: u64,
    language: Language,
    made_of: MadeOf,
}

/// Arguments of a sweep, without the text of its project.
struct MadeOf {
    name: String,
    folder: PathBuf,
    recordings: BTreeMap<String, Vec<u8>>,
    schema: SchemaRef,
    pairs: Vec<(String, String)>,
    lang: String,
    memory: Option<String>,
}

#[pymethods]
impl Sweep {
    #[new]
    fn new(
        handed: Handed,
        schema: &Bound<'_, PyAny>,
        pairs: Vec<(String, String)>,
        lang: &str,
        memory: Option<String>,
    ) -> PyResult<Self> {
        Self::of(schema.py(), handed, (&*capsules::schema(schema)?, &[]), pairs, lang, memory)
    }

    /// The answers of the rows of a table, in their order, by a sweep of its own: the table is read once.
    #[staticmethod]
    fn whole(
        handed: Handed,
        table: &Bound<'_, PyAny>,
        pairs: Vec<(String, String)>,
        lang: &str,
        memory: Option<String>,
        deadline: Option<&str>,
    ) -> PyResult<Table> {
        let py = table.py();
        let (schema, batches) = capsules::table(table)?;
        Self::of(py, handed, (&schema, &batches), pairs, lang, memory)?.judged(py, &batches, deadline, false)
    }

    /// The keys of the columns, entries of lists counted from one.
    #[getter]
    fn keys(&self) -> Vec<String> {
        self.sweep.keys().map(str::to_owned).collect()
    }

    /// The recordings that the project names.
    #[getter]
    fn recordings(&self) -> Vec<String> {
        self.sweep.recordings().iter().cloned().collect()
    }

    /// Arguments that make the same sweep anew, in another process too: the text of the project in place of its path.
    #[getter]
    fn made_of(&self) -> (Handed, Table, Vec<(String, String)>, String, Option<String>) {
        let MadeOf { name, folder, recordings, schema, pairs, lang, memory } = &self.made_of;
        let handed = (Some(self.sweep.text().to_owned()), name.clone(), folder.clone(), recordings.clone());
        let table = Table { schema: Arc::clone(schema), batches: Vec::new() };
        (handed, table, pairs.clone(), lang.clone(), memory.clone())
    }

    /// The largest number of rows whose answers a call returns.
    #[getter]
    fn rows_most(&self) -> u64 {
        self.sweep.rows_held(self.memory)
    }

    /// The columns of the answers, as an empty table.
    #[getter]
    fn answers(&self) -> Table {
        Table { schema: self.sweep.schema(), batches: Vec::new() }
    }

    /// The answers of the rows of a table, in their order.
    #[pyo3(signature = (table, deadline))]
    fn table(&self, table: &Bound<'_, PyAny>, deadline: Option<&str>) -> PyResult<Table> {
        let py = table.py();
        let (schema, batches) = capsules::table(table)?;
        self.is_of(py, &schema)?;
        self.judged(py, &batches, deadline, true)
    }

    /// The answers of one batch whose first row has this number; a fault of a cell is in the column `error`.
    fn batch(&self, batch: &Bound<'_, PyAny>, first_row: u64) -> PyResult<Table> {
        let py = batch.py();
        let (schema, batches) = capsules::table(batch)?;
        self.is_of(py, &schema)?;
        let progress = Progress::endless();
        let found =
            interruptible(py, &progress, None, || self.sweep.whole(&batches, first_row, self.memory, &progress))?;
        let batches = found.map_err(|why| refused(py, &why.record(None, self.language)))?;
        Ok(Table { schema: self.sweep.schema(), batches })
    }
}

impl Sweep {
    fn of(
        py: Python<'_>,
        handed: Handed,
        (schema, batches): (&Schema, &[RecordBatch]),
        pairs: Vec<(String, String)>,
        lang: &str,
        memory: Option<String>,
    ) -> PyResult<Self> {
        let language = Language::of_id(lang).unwrap_or_default();
        let (of_text, name, folder, recordings) = &handed;
        // The folder of a file stays valid in a process with another working folder.
        let folder = if of_text.is_some() {
            folder.clone()
        } else {
            Path::new(name).parent().unwrap_or(Path::new("")).to_owned()
        };
        let made_of = MadeOf {
            name: name.clone(),
            folder: std::path::absolute(&folder).unwrap_or(folder),
            recordings: recordings.clone(),
            schema: Arc::new(schema.clone()),
            pairs: pairs.clone(),
            lang: lang.to_owned(),
            memory: memory.clone(),
        };
        let call = SweepCall { text: text(handed), pairs, memory, language };
        let ready = || Ok((call.prepared(schema, batches)?, call.memory_allowed()?));
        let ready = interruptible(py, &Progress::endless(), None, ready)?;
        let (sweep, memory) = ready.map_err(|why: Unanswered| refused(py, &why.record(None, language)))?;
        Ok(Self { sweep, memory, language, made_of })
    }

    /// Returns the answers; checks the cells first if required.
    fn judged(&self, py: Python<'_>, batches: &[RecordBatch], deadline: Option<&str>, checks: bool) -> PyResult<Table> {
        let deadline = deadline.map(|text| antrieb::deadline_of(text, self.language)).transpose();
        let deadline = deadline.map_err(|why| refused(py, &why.record(None, self.language)))?;
        let progress = if deadline.is_some() { Progress::limited() } else { Progress::endless() };
        let found = interruptible(py, &progress, deadline, || {
            if checks {
                checked(&self.sweep, batches)?;
            }
            self.sweep.whole(batches, 0, self.memory, &progress)
        })?;
        let waited_s = deadline.map(|most| most.as_secs_f64());
        let batches = found.map_err(|why| refused(py, &why.record(waited_s, self.language)))?;
        Ok(Table { schema: self.sweep.schema(), batches })
    }

    /// Checks that a table has the columns for which the sweep was prepared.
    fn is_of(&self, py: Python<'_>, schema: &Schema) -> PyResult<()> {
        if self.sweep.keys().count() == schema.fields().len() {
            return Ok(());
        }
        let why = Unanswered::Refused(Refusal::NoData, None);
        Err(refused(py, &why.record(None, self.language)))
    }
}

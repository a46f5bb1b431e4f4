//! Tables and sweeps as Python objects.

use super::call::{Conversion, Handed, Watch, interruptible, refused, text};
use crate::SweepCall;
use crate::module::{capsules, cells};
use crate::sweep::checked;
use arrow_array::{Array, ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_ipc::reader::StreamReader;
use arrow_ipc::writer::StreamWriter;
use arrow_schema::{Field, Schema, SchemaRef};
use pyo3::exceptions::{PyException, PyTypeError, PyUserWarning, PyValueError};
use pyo3::intern;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyCapsule, PyDict, PyInt, PyList, PyString};
use quantities::Language;
use questions::list::Unanswered;
use questions::{Progress, Refusal};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use sweep_io::Repeats;

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
            let heading = heading.extract::<String>()?;
            let array = listed(&values).and_then(|values| column(&values));
            let array = array.map_err(|error| {
                // An interrupt stays one.
                let py = columns.py();
                if error.is_instance_of::<PyException>(py) {
                    PyTypeError::new_err(format!("column '{heading}': {}", error.value(py)))
                } else {
                    error
                }
            })?;
            fields.push(Field::new(heading, array.data_type().clone(), true));
            arrays.push(array);
        }
        let schema: SchemaRef = Arc::new(Schema::new(fields));
        of_one_length(&schema, &arrays)?;
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
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.to_pydict(py)
    }

    /// Rows from `begin` on, as lists by the headings of their columns.
    fn rows<'py>(&self, py: Python<'py>, begin: usize, count: usize) -> PyResult<Bound<'py, PyDict>> {
        let (mut passed, mut left) = (begin, count);
        let batches = self.batches.iter().filter_map(|batch| {
            let from = passed.min(batch.num_rows());
            let part = batch.slice(from, left.min(batch.num_rows() - from));
            passed -= from;
            left -= part.num_rows();
            (part.num_rows() > 0).then_some(part)
        });
        Self { schema: Arc::clone(&self.schema), batches: batches.collect() }.to_pydict(py)
    }

    /// The values of a column, `None` if there is no such column.
    fn column<'py>(&self, py: Python<'py>, heading: &str) -> PyResult<Option<Bound<'py, PyList>>> {
        let place = self.schema.fields().iter().rposition(|field| field.name() == heading);
        place.map(|index| self.values(py, index, &mut Conversion::default())).transpose()
    }

    /// A dictionary for each row.
    fn to_dicts<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        frames(slf, "to_dicts")
    }

    /// A column of the answers over two columns of the table that was swept, as arrays with labels.
    #[pyo3(signature = (value="utilisation", *, x=None, y=None))]
    fn arrays<'py>(
        slf: &Bound<'py, Self>,
        value: &str,
        x: Option<&str>,
        y: Option<&str>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let frames = slf.py().import(intern!(slf.py(), "antrieb._frames"))?;
        frames.getattr("arrays")?.call1((slf, value, x, y))
    }

    /// The table as a data frame of pandas.
    fn to_pandas<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        frames(slf, "to_pandas")
    }

    /// The table as a data frame of polars.
    fn to_polars<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        frames(slf, "to_polars")
    }

    /// A column by its heading, a row by its place.
    fn __getitem__<'py>(slf: &Bound<'py, Self>, key: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import(intern!(slf.py(), "antrieb._frames"))?.getattr("item")?.call1((slf, key))
    }

    /// Returns true for the heading of a column.
    fn __contains__(&self, key: &Bound<'_, PyAny>) -> bool {
        key.extract::<String>().is_ok_and(|key| self.schema.fields().iter().any(|field| *field.name() == key))
    }

    /// The rows as dictionaries.
    fn __iter__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Ok(frames(slf, "to_dicts")?.try_iter()?.into_any())
    }

    /// Tables are equal if their columns and values are.
    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.is_equal(other.get()))
    }

    fn _repr_html_<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        frames(slf, "html")
    }

    /// Lists by the headings of their columns.
    fn to_pydict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = PyDict::new(py);
        let mut conversion = Conversion::default();
        for (index, field) in self.schema.fields().iter().enumerate() {
            columns.set_item(field.name(), self.values(py, index, &mut conversion)?)?;
        }
        Ok(columns)
    }

    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }

    fn __repr__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        frames(slf, "text")
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

impl Table {
    /// Returns the values of a column.
    fn values<'py>(&self, py: Python<'py>, index: usize, conversion: &mut Conversion) -> PyResult<Bound<'py, PyList>> {
        let values = PyList::empty(py);
        for batch in &self.batches {
            cells::append(&values, batch.column(index), self.schema.field(index).name(), conversion)?;
        }
        Ok(values)
    }

    fn is_equal(&self, other: &Self) -> bool {
        let whole = |table: &Self| arrow_select::concat::concat_batches(&table.schema, &table.batches);
        self.schema == other.schema && whole(self).ok() == whole(other).ok()
    }
}

/// Calls a function of the package for a table.
fn frames<'py>(table: &Bound<'py, Table>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    table.py().import(intern!(table.py(), "antrieb._frames"))?.getattr(name)?.call1((table,))
}

/// Refuses columns of different lengths, with the length of each.
fn of_one_length(schema: &Schema, arrays: &[ArrayRef]) -> PyResult<()> {
    /// Columns that a message states.
    const SHOWN: usize = 6;
    let Some(rows) = arrays.first().map(Array::len) else { return Ok(()) };
    if arrays.iter().all(|array| array.len() == rows) {
        return Ok(());
    }
    // The first column, and those that differ from it.
    let lengths = schema.fields().iter().zip(arrays).map(|(field, array)| (field.name(), array.len()));
    let (first, others): (Vec<_>, Vec<_>) = lengths.partition(|(_, length)| *length == rows);
    let shown: Vec<String> = first
        .iter()
        .take(1)
        .chain(&others)
        .take(SHOWN)
        .map(|(name, length)| format!("'{name}' has {length}"))
        .collect();
    Err(PyValueError::new_err(format!("the columns have different lengths: {}", shown.join(", "))))
}

/// Returns the values of a column as a list.
fn listed<'py>(values: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyList>> {
    if let Ok(list) = values.cast::<PyList>() {
        return Ok(list.clone());
    }
    if values.is_instance_of::<PyString>() || values.is_instance_of::<PyBytes>() || values.try_iter().is_err() {
        let found = values.get_type().name()?;
        return Err(PyTypeError::new_err(format!("a list with a value for each row is expected, not {found}")));
    }
    if is_of_times(values)? {
        return Err(PyTypeError::new_err("times are no numbers; hand over a table of pyarrow or polars, or texts"));
    }
    if values.hasattr("tolist")? {
        return Ok(values.call_method0("tolist")?.cast_into::<PyList>()?);
    }
    let list = PyList::empty(values.py());
    let mut conversion = Conversion::default();
    for value in values.try_iter()? {
        conversion.count(values.py())?;
        list.append(value?)?;
    }
    Ok(list)
}

/// Returns `true` for an array of times or of intervals: as a list it may be one of bare numbers.
fn is_of_times(values: &Bound<'_, PyAny>) -> PyResult<bool> {
    let Ok(kind) = values.getattr("dtype").and_then(|kind| kind.getattr("kind")) else { return Ok(false) };
    Ok(kind.extract::<String>().is_ok_and(|kind| kind == "m" || kind == "M"))
}

fn broken(error: arrow_schema::ArrowError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// Converts a Python list to a column.
fn column(values: &Bound<'_, PyList>) -> PyResult<ArrayRef> {
    let first = values.iter().find(|value| !value.is_none());
    Ok(match first {
        Some(first) if first.is_instance_of::<PyString>() => Arc::new(StringArray::from(each::<String>(values)?)),
        Some(first) if first.is_instance_of::<PyBool>() => Arc::new(BooleanArray::from(each::<bool>(values)?)),
        Some(_) if is_whole(values)? => Arc::new(Int64Array::from(each::<i64>(values)?)),
        Some(_) | None => Arc::new(Float64Array::from(each::<f64>(values)?)),
    })
}

/// Returns `true` if every value is a whole number or `None`.
fn is_whole(values: &Bound<'_, PyList>) -> PyResult<bool> {
    let mut conversion = Conversion::default();
    for value in values {
        conversion.count(values.py())?;
        if !value.is_none() && !value.is_instance_of::<PyInt>() {
            return Ok(false);
        }
    }
    Ok(true)
}

fn each<'py, T>(values: &Bound<'py, PyList>) -> PyResult<Vec<Option<T>>>
where
    Option<T>: for<'a> FromPyObject<'a, 'py, Error = PyErr>,
{
    let mut conversion = Conversion::default();
    let value = |value: Bound<'py, PyAny>| {
        conversion.count(value.py())?;
        value.extract::<Option<T>>()
    };
    values.iter().map(value).collect()
}

/// A sweep over tables of the same columns: the project is read once.
#[pyclass(frozen, module = "antrieb._antrieb")]
pub(crate) struct Sweep {
    sweep: Arc<sweep_io::BatchSweep>,
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
    inputs: bool,
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
        inputs: bool,
    ) -> PyResult<Self> {
        Self::of(schema.py(), handed, (&capsules::schema(schema)?, &[]), pairs, lang, (memory, inputs))
    }

    /// The answers of the rows of a table, in their order, by a sweep of its own: the table is read once.
    #[staticmethod]
    #[allow(clippy::too_many_arguments, reason = "those of the function of the package")]
    fn whole<'py>(
        handed: Handed,
        table: &Bound<'py, PyAny>,
        pairs: Vec<(String, String)>,
        lang: &str,
        memory: Option<String>,
        inputs: bool,
        deadline: Option<&str>,
        progress: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Table> {
        let py = table.py();
        let (schema, batches) = capsules::table(table)?;
        let sweep = Self::of(py, handed, (&schema, &batches), pairs, lang, (memory, inputs))?;
        sweep.judged(py, batches, deadline, progress.as_ref(), false)
    }

    /// The keys of the columns, entries of lists counted from one.
    #[getter]
    fn keys(&self) -> Vec<String> {
        self.sweep.keys().map(str::to_owned).collect()
    }

    /// The columns of the table that the answers repeat.
    #[getter]
    fn carried(&self) -> Vec<String> {
        self.sweep.carried().map(str::to_owned).collect()
    }

    /// The recordings that the project names.
    #[getter]
    fn recordings(&self) -> Vec<String> {
        self.sweep.recordings().iter().cloned().collect()
    }

    /// Arguments that make the same sweep anew, in another process too: the text of the project in place of its path.
    #[getter]
    #[allow(clippy::type_complexity, reason = "the arguments of the constructor")]
    fn made_of(&self) -> (Handed, Table, Vec<(String, String)>, String, Option<String>, bool) {
        let MadeOf { name, folder, recordings, schema, pairs, lang, memory, inputs } = &self.made_of;
        let handed = (Some(self.sweep.text().to_owned()), name.clone(), folder.clone(), recordings.clone());
        let table = Table { schema: Arc::clone(schema), batches: Vec::new() };
        (handed, table, pairs.clone(), lang.clone(), memory.clone(), *inputs)
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
    #[pyo3(signature = (table, deadline, progress))]
    fn table<'py>(
        &self,
        table: &Bound<'py, PyAny>,
        deadline: Option<&str>,
        progress: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Table> {
        let py = table.py();
        let (schema, batches) = capsules::table(table)?;
        self.is_of(py, &schema)?;
        self.judged(py, batches, deadline, progress.as_ref(), true)
    }

    /// The answers of one batch whose first row has this number; a fault of a cell is in the column `error`.
    fn batch(&self, batch: &Bound<'_, PyAny>, first_row: u64) -> PyResult<Table> {
        let py = batch.py();
        let (schema, batches) = capsules::table(batch)?;
        self.is_of(py, &schema)?;
        let (sweep, memory) = (Arc::clone(&self.sweep), self.memory);
        let watch = Watch::of(Arc::new(Progress::endless()), None);
        let found = interruptible(py, &watch, move |progress| sweep.whole(&batches, first_row, memory, progress))?;
        let batches = found.map_err(|why| refused(py, &why.record(None, self.language)))?;
        Ok(Table { schema: self.sweep.schema(), batches })
    }
}

/// Warns of columns that state values of keys under another name: `time [s]` is the time of every move. The index of a data
/// frame, or a column that was meant as a label, may have such a name.
fn warn_of_meant(py: Python<'_>, sweep: &sweep_io::BatchSweep, schema: &Schema, language: Language) -> PyResult<()> {
    let bare = |heading: &str| heading.split(" [").next().unwrap_or(heading).trim().to_owned();
    let is_other = |heading: &&String| {
        let name = bare(heading);
        !sweep.carried().any(|carried| carried == heading.as_str())
            && !sweep.keys().any(|key| key == name)
            && !name.contains(['.', '['])
    };
    let headings: Vec<&String> = schema.fields().iter().map(|field| field.name()).filter(is_other).collect();
    let stated: Vec<&str> =
        sweep.keys().filter(|key| !schema.fields().iter().any(|field| bare(field.name()) == *key)).collect();
    if headings.is_empty() || stated.is_empty() {
        return Ok(());
    }
    let columns = headings.iter().map(|heading| format!("{heading:?}")).collect::<Vec<_>>().join(", ");
    let message = words::sweeps::columns_meant(&columns, &stated.join(", "), language);
    let message = std::ffi::CString::new(message).map_err(|error| PyValueError::new_err(error.to_string()))?;
    PyErr::warn(py, &py.get_type::<PyUserWarning>(), &message, 1)
}

impl Sweep {
    fn of(
        py: Python<'_>,
        handed: Handed,
        (schema, batches): (&SchemaRef, &[RecordBatch]),
        pairs: Vec<(String, String)>,
        lang: &str,
        (memory, inputs): (Option<String>, bool),
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
            schema: Arc::clone(schema),
            pairs: pairs.clone(),
            lang: lang.to_owned(),
            memory: memory.clone(),
            inputs,
        };
        let repeats = if inputs { Repeats::Inputs } else { Repeats::Labels };
        let call = SweepCall { text: text(handed), pairs, memory, repeats, language };
        let (schema, batches) = (Arc::clone(schema), batches.to_vec());
        let ready = move |_: &Progress| Ok((call.prepared(&schema, &batches)?, call.memory_allowed()?));
        let ready = interruptible(py, &Watch::of(Arc::new(Progress::endless()), None), ready)?;
        let (sweep, memory) = ready.map_err(|why: Unanswered| refused(py, &why.record(None, language)))?;
        warn_of_meant(py, &sweep, &made_of.schema, language)?;
        Ok(Self { sweep: Arc::new(sweep), memory, language, made_of })
    }

    /// Returns the answers; checks the cells first if required.
    fn judged(
        &self,
        py: Python<'_>,
        batches: Vec<RecordBatch>,
        deadline: Option<&str>,
        observer: Option<&Bound<'_, PyAny>>,
        checks: bool,
    ) -> PyResult<Table> {
        let deadline = deadline.map(|text| antrieb::deadline_of(text, self.language)).transpose();
        let deadline = deadline.map_err(|why| refused(py, &why.record(None, self.language)))?;
        let progress = if deadline.is_some() { Progress::limited() } else { Progress::endless() };
        let (sweep, memory) = (Arc::clone(&self.sweep), self.memory);
        let work = move |progress: &Progress| {
            if checks {
                checked(&sweep, &batches)?;
            }
            progress.expect_steps(batches.iter().map(RecordBatch::num_rows).sum());
            sweep.whole(&batches, 0, memory, progress)
        };
        let found = interruptible(py, &Watch { progress: Arc::new(progress), deadline, observer }, work)?;
        let waited_s = deadline.map(|most| most.as_secs_f64());
        let batches = found.map_err(|why| refused(py, &why.record(waited_s, self.language)))?;
        Ok(Table { schema: self.sweep.schema(), batches })
    }

    /// Checks that a table has the columns for which the sweep was prepared.
    fn is_of(&self, py: Python<'_>, schema: &Schema) -> PyResult<()> {
        if self.sweep.width() == schema.fields().len() {
            return Ok(());
        }
        let why = Unanswered::Refused(Refusal::NoData, None);
        Err(refused(py, &why.record(None, self.language)))
    }
}

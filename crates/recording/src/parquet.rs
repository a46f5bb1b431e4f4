//! Reading Parquet.

use crate::SAMPLES_MAX;
use crate::columns::{Heading, Said, decide, pick};
use crate::faults::{Fault, Faults, Place, excerpt};
use crate::gather::{Gather, Sample, check_window};
use crate::layout::{Layout, Role};
use crate::number::Tick;
use crate::pages::CheckedPages;
use crate::series::{KnownBy, Recording};
use ::parquet::basic::{ConvertedType, LogicalType, TimeUnit, Type};
use ::parquet::column::reader::{ColumnReader, ColumnReaderImpl, get_column_reader};
use ::parquet::data_type::{DataType, DoubleType, FloatType, Int32Type, Int64Type};
use ::parquet::errors::ParquetError;
use ::parquet::file::metadata::{FileMetaData, RowGroupMetaData};
use ::parquet::file::reader::{ChunkReader, FileReader, RowGroupReader};
use ::parquet::file::serialized_reader::SerializedFileReader;
use ::parquet::schema::types::ColumnDescriptor;
use quantities::Unit;
use quantities::unit::{MICROSECOND, MILLISECOND, NANOSECOND};

/// Rows that are read at a time.
const BATCH: usize = 8192;

/// Reads a recording from Parquet.
///
/// Columns are recognised as in CSV. They hold floats, doubles or integers without a scale. A unit stands in the name
/// (`q [deg]`), in the metadata of the file under `q.unit` or `unit:q`, or in the layout; a timestamp type says its
/// unit itself. Row groups are read one after another, a few thousand rows at a time.
///
/// # Errors
/// All faults of the file.
pub fn read_parquet<R: ChunkReader + 'static>(source: R, layout: &Layout) -> Result<Recording, Vec<Fault>> {
    let mut faults = Faults::default();
    let recording = read(source, layout, &mut faults);
    faults.outcome(recording)
}

fn unreadable(error: &ParquetError) -> Fault {
    // Messages of the library may quote the file; the bound keeps them readable.
    const LONGEST: usize = 200;
    Fault::ParquetUnreadable { reason: error.to_string().chars().take(LONGEST).collect() }
}

fn read<R: ChunkReader + 'static>(source: R, layout: &Layout, faults: &mut Faults) -> Option<Recording> {
    check_window(layout, faults);
    let file = SerializedFileReader::new(source).map_err(|error| faults.push(unreadable(&error))).ok()?;
    let about = file.metadata().file_metadata();
    let schema = about.schema_descr();
    let headings: Vec<Heading> = schema.columns().iter().map(|column| Heading::new(&column.path().string())).collect();
    let picks = pick(&headings, layout, faults);

    let mut columns = Vec::new();
    let mut used: Vec<Used> = Vec::new();
    for (role, index) in Role::ALL.into_iter().zip(picks) {
        let Some((index, heading)) = index.and_then(|index| Some((index, headings.get(index)?))) else { continue };
        let Some(kind) = schema.columns().get(index).and_then(|column| kind(column)) else {
            let found = schema.columns().get(index).map_or_else(String::new, |column| type_name(column));
            faults.push(Fault::ColumnType { column: excerpt(&heading.written), found });
            continue;
        };
        let said = [
            heading.unit.clone().map(|text| (KnownBy::Header, Said::Text(text))),
            kind.time.map(|unit| (KnownBy::Metadata, Said::Unit(unit))),
            metadata_unit(about, heading).map(|text| (KnownBy::Metadata, Said::Text(text))),
            layout.column(role).unit.map(|unit| (KnownBy::Layout, Said::Unit(unit))),
        ];
        columns.extend(decide(role, heading, said.into_iter().flatten().collect(), faults));
        used.push(Used { index, name: excerpt(&heading.written), kind });
    }
    if !faults.none() {
        return None;
    }
    let mut gather = Gather::new(columns, layout, true, faults)?;
    if !gather.has_window() && usize::try_from(about.num_rows()).is_ok_and(|rows| rows > SAMPLES_MAX) {
        faults.push(Fault::too_many_samples());
        return None;
    }
    let mut number = 0;
    for group in 0..file.num_row_groups() {
        if !used.iter().all(|column| is_placed(file.metadata().row_group(group), column.index)) {
            faults.push(Fault::ParquetUnreadable { reason: String::from("a column lies at a negative offset") });
            return None;
        }
        let read = file.get_row_group(group).and_then(|group| rows(&*group, &used, &mut number, &mut gather, faults));
        match read {
            Ok(true) => {}
            Ok(false) => return None,
            Err(error) => {
                faults.push(unreadable(&error));
                return None;
            }
        }
    }
    gather.finish(faults)
}

/// Whether offset and size of a column are possible. The library asserts it instead of refusing the file.
fn is_placed(group: &RowGroupMetaData, index: usize) -> bool {
    group.columns().get(index).is_some_and(|column| {
        let start = column.dictionary_page_offset().unwrap_or(0).min(column.data_page_offset());
        start >= 0 && column.compressed_size() >= 0
    })
}

/// The unit that the metadata of the file state for a column.
fn metadata_unit(about: &FileMetaData, heading: &Heading) -> Option<String> {
    let keys = [&heading.written, &heading.bare].map(|name| [format!("{name}.unit"), format!("unit:{name}")]);
    let mut pairs = about.key_value_metadata()?.iter();
    pairs.find(|pair| keys.as_flattened().contains(&pair.key))?.value.as_ref().map(|unit| unit.trim().to_owned())
}

/// What a column of numbers holds.
#[derive(Clone, Copy)]
struct Holds {
    unsigned: bool,
    /// The unit that its type states.
    time: Option<&'static Unit>,
}

/// What a column holds; `None` if it holds no plain numbers.
fn kind(column: &ColumnDescriptor) -> Option<Holds> {
    if column.max_rep_level() > 0 {
        return None;
    }
    let plain = Holds { unsigned: false, time: None };
    let time = |unit| Some(Holds { time: Some(unit), ..plain });
    match (column.physical_type(), column.logical_type_ref(), column.converted_type()) {
        (Type::FLOAT | Type::DOUBLE, None, ConvertedType::NONE) => Some(plain),
        (Type::INT32 | Type::INT64, Some(LogicalType::Integer(integer)), _) => {
            Some(Holds { unsigned: !integer.is_signed, ..plain })
        }
        (Type::INT64, Some(LogicalType::Timestamp(stamp)), _) => time(match stamp.unit {
            TimeUnit::MILLIS => &MILLISECOND,
            TimeUnit::MICROS => &MICROSECOND,
            TimeUnit::NANOS => &NANOSECOND,
        }),
        (Type::INT64, None, ConvertedType::TIMESTAMP_MILLIS) => time(&MILLISECOND),
        (Type::INT64, None, ConvertedType::TIMESTAMP_MICROS) => time(&MICROSECOND),
        (Type::INT32 | Type::INT64, None, converted) => match converted {
            ConvertedType::NONE
            | ConvertedType::INT_8
            | ConvertedType::INT_16
            | ConvertedType::INT_32
            | ConvertedType::INT_64 => Some(plain),
            ConvertedType::UINT_8 | ConvertedType::UINT_16 | ConvertedType::UINT_32 | ConvertedType::UINT_64 => {
                Some(Holds { unsigned: true, ..plain })
            }
            _ => None,
        },
        _ => None,
    }
}

fn type_name(column: &ColumnDescriptor) -> String {
    let repeated = if column.max_rep_level() > 0 { "LIST of " } else { "" };
    match column.converted_type() {
        ConvertedType::NONE => format!("{repeated}{}", column.physical_type()),
        converted => format!("{repeated}{} ({converted})", column.physical_type()),
    }
}

/// A column in use, time first.
struct Used {
    index: usize,
    name: String,
    kind: Holds,
}

/// Reads the rows of a group; false if no further row can be kept.
fn rows(
    group: &dyn RowGroupReader,
    used: &[Used],
    number: &mut u64,
    gather: &mut Gather,
    faults: &mut Faults,
) -> Result<bool, ParquetError> {
    let mut streams =
        used.iter().map(|column| Stream::open(group, column)).collect::<Result<Vec<_>, ParquetError>>()?;
    loop {
        let mut counts = streams.iter_mut().map(Stream::fill).collect::<Result<Vec<_>, ParquetError>>()?.into_iter();
        let count = counts.next().unwrap_or(0);
        if counts.any(|other| other != count) {
            return Err(ParquetError::General(String::from("the columns of a row group differ in length")));
        }
        if count == 0 {
            return Ok(true);
        }
        let Some((time, values)) = streams.split_first() else { return Ok(true) };
        for (row, cell) in time.cells.iter().enumerate() {
            *number += 1;
            let at = Place::Row(*number);
            let tick = match *cell {
                Cell::Null => Err(Fault::ValueMissing { at, column: time.name.to_owned() }),
                Cell::Float(value) if !value.is_finite() => Err(not_finite(at, time.name, value)),
                Cell::Float(value) => Ok(Tick::of_float(value)),
                Cell::Integer(value) => Ok(Tick::of_integer(value)),
            };
            let sample = tick.map(|tick| gather.sample(*number, tick, faults)).unwrap_or_else(|fault| {
                gather.time_failed();
                faults.push(fault);
                Sample::Dropped
            });
            match sample {
                Sample::Dropped => continue,
                Sample::Full => return Ok(false),
                Sample::Kept => {}
            }
            for (channel, stream) in values.iter().enumerate() {
                let value = match stream.cells.get(row) {
                    None | Some(Cell::Null) => {
                        faults.push(Fault::ValueMissing { at, column: stream.name.to_owned() });
                        continue;
                    }
                    Some(Cell::Float(value)) => *value,
                    Some(Cell::Integer(value)) => *value as f64,
                };
                if !gather.value(channel, value) {
                    faults.push(not_finite(at, stream.name, value));
                }
            }
        }
        if faults.enough() {
            return Ok(false);
        }
    }
}

fn not_finite(at: Place, column: &str, value: f64) -> Fault {
    Fault::ValueNotFinite { at, column: column.to_owned(), text: format!("{value:e}") }
}

#[derive(Clone, Copy)]
enum Cell {
    Null,
    Float(f64),
    Integer(i64),
}

/// One column of a row group, a batch at a time.
struct Stream<'a> {
    name: &'a str,
    source: Source,
    unsigned: bool,
    level_max: i16,
    levels: Vec<i16>,
    cells: Vec<Cell>,
}

enum Source {
    Float(ColumnReaderImpl<FloatType>, Vec<f32>),
    Double(ColumnReaderImpl<DoubleType>, Vec<f64>),
    Int32(ColumnReaderImpl<Int32Type>, Vec<i32>),
    Int64(ColumnReaderImpl<Int64Type>, Vec<i64>),
}

impl<'a> Stream<'a> {
    fn open(group: &dyn RowGroupReader, column: &'a Used) -> Result<Self, ParquetError> {
        let descriptor = group.metadata().column(column.index).column_descr_ptr();
        let level_max = descriptor.max_def_level();
        let pages = CheckedPages::new(group.get_column_page_reader(column.index)?, descriptor.clone());
        let source = match get_column_reader(descriptor, Box::new(pages)) {
            ColumnReader::FloatColumnReader(reader) => Source::Float(reader, Vec::new()),
            ColumnReader::DoubleColumnReader(reader) => Source::Double(reader, Vec::new()),
            ColumnReader::Int32ColumnReader(reader) => Source::Int32(reader, Vec::new()),
            ColumnReader::Int64ColumnReader(reader) => Source::Int64(reader, Vec::new()),
            _ => return Err(ParquetError::General(String::from("a column changes its type"))),
        };
        let (name, unsigned) = (column.name.as_str(), column.kind.unsigned);
        Ok(Self { name, source, unsigned, level_max, levels: Vec::new(), cells: Vec::new() })
    }

    /// Reads the next batch and tells its length; zero at the end.
    fn fill(&mut self) -> Result<usize, ParquetError> {
        self.cells.clear();
        self.levels.clear();
        let (levels, most) = (&mut self.levels, self.level_max);
        let unsigned = self.unsigned;
        match &mut self.source {
            Source::Float(reader, values) => {
                let count = batch(reader, values, levels, most)?;
                spread(values, levels, most, count, &mut self.cells, |value| Cell::Float(f64::from(value)));
            }
            Source::Double(reader, values) => {
                let count = batch(reader, values, levels, most)?;
                spread(values, levels, most, count, &mut self.cells, Cell::Float);
            }
            Source::Int32(reader, values) => {
                let count = batch(reader, values, levels, most)?;
                spread(values, levels, most, count, &mut self.cells, |value| {
                    Cell::Integer(if unsigned { i64::from(value.cast_unsigned()) } else { i64::from(value) })
                });
            }
            Source::Int64(reader, values) => {
                let count = batch(reader, values, levels, most)?;
                spread(values, levels, most, count, &mut self.cells, |value| match unsigned {
                    true if value < 0 => Cell::Float(value.cast_unsigned() as f64),
                    _ => Cell::Integer(value),
                });
            }
        }
        Ok(self.cells.len())
    }
}

/// Reads up to a batch of values that are there, and the levels that say where nulls are.
fn batch<T: DataType>(
    reader: &mut ColumnReaderImpl<T>,
    values: &mut Vec<T::T>,
    levels: &mut Vec<i16>,
    level_max: i16,
) -> Result<usize, ParquetError> {
    values.clear();
    let mut count = 0;
    while count < BATCH {
        let (rows, ..) = reader.read_records(BATCH - count, (level_max > 0).then_some(&mut *levels), None, values)?;
        if rows == 0 {
            break;
        }
        count += rows;
    }
    Ok(count)
}

/// Puts values and nulls in the order of the rows.
fn spread<T: Copy>(
    values: &[T],
    levels: &[i16],
    level_max: i16,
    count: usize,
    cells: &mut Vec<Cell>,
    cell: impl Fn(T) -> Cell,
) {
    let mut values = values.iter().copied();
    if level_max == 0 {
        cells.extend(values.take(count).map(cell));
    } else {
        let next = |level: &i16| if *level == level_max { values.next().map(&cell) } else { None };
        let mut next = next;
        cells.extend(levels.iter().map(|level| next(level).unwrap_or(Cell::Null)));
    }
}

//! Parquet reader for recordings.
//!
//! Footer and page headers are read here, within fixed bounds; the library receives pages that are unpacked and
//! checked, and decodes the values.

mod arrow;
mod footer;
mod pages;
mod streams;
mod table;
mod thrift;
mod unpack;

use crate::collected::FaultCollector;
use crate::columns::{Heading, Pick, Said, decide, pick, unused};
use crate::faults::{Damage, Fault, FileRow, Remedy, excerpt};
use crate::gather::{Gather, SampleUse, check_window};
use crate::lacking::is_spare;
use crate::layout::{Layout, Role};
use crate::limits::{Limit, ROWS_MAX, SAMPLES_MAX};
use crate::memory::Memory;
use crate::names::Named;
use crate::number::{Bad, Tick};
use crate::series::{KnownBy, Recording};
use ::parquet::basic::{ConvertedType, Type};
use ::parquet::errors::ParquetError;
use bytes::Bytes;
use footer::{Chunk, Footer, Logical, ParquetColumn};
use pages::Pages;
use quantities::unit::{MICROSECOND, MILLISECOND, NANOSECOND, SECOND};
use quantities::{Dimension, Unit};
use std::sync::Arc;
use std::sync::atomic::AtomicU64;
use streams::{ParquetCell, Stream};
pub use table::{Ranges, Table, TableColumn, TableValues, ValueKind};

/// Number of rows read at a time.
pub(crate) const BATCH: usize = 8192;

/// Reads a recording from Parquet with the default memory limit.
///
/// # Errors
/// All faults of the file.
pub fn read_parquet(file: Bytes, layout: &Layout) -> Result<Recording, Vec<Fault>> {
    read_parquet_within(file, layout, &mut Memory::default())
}

/// Reads a recording from Parquet.
///
/// Columns are recognised as in CSV. They hold floats, doubles, integers or decimals. A unit stands in the name
/// (`q [deg]`), in the metadata of the file under `q.unit` or `unit:q`, in that of the field under `unit`, or in the layout;
/// a timestamp or a duration of Arrow states its unit itself. Row groups are read one after another, a few thousand rows at a time. The memory of the recording is taken
/// from `memory`; the bytes of the file belong to the caller.
///
/// # Errors
/// All faults of the file.
pub fn read_parquet_within(file: Bytes, layout: &Layout, memory: &mut Memory) -> Result<Recording, Vec<Fault>> {
    let mut faults = FaultCollector::default();
    let recording = read(&file, layout, memory, &mut faults);
    faults.outcome(recording)
}

/// Returns the names of the columns of a Parquet file.
///
/// # Errors
/// The fault of the file.
pub fn column_names(file: &Bytes) -> Result<Vec<String>, Fault> {
    Ok(Footer::read(file)?.columns.into_iter().map(|column| column.path).collect())
}

/// Returns the number of rows that a Parquet file claims.
///
/// # Errors
/// The fault of the file.
pub fn row_count(file: &Bytes) -> Result<u64, Fault> {
    Ok(Footer::read(file)?.rows)
}

/// Reads columns of numbers by their names as written, without units or conversion; `None` stands for a column that the
/// file does not have. Only values of a type of time are converted, from the unit of the type to that of the name. Their memory is taken from `memory`.
///
/// # Errors
/// All faults of the file: columns that hold no numbers, values that are missing or not finite.
pub fn read_columns(file: &Bytes, names: &[&str], memory: &mut Memory) -> Result<Vec<Option<Vec<f64>>>, Vec<Fault>> {
    let mut faults = FaultCollector::default();
    let found = columns_of(file, names, memory, &mut faults);
    faults.outcome(found)
}

fn columns_of(
    file: &Bytes,
    names: &[&str],
    memory: &mut Memory,
    faults: &mut FaultCollector,
) -> Option<Vec<Option<Vec<f64>>>> {
    let footer = Footer::read(file).map_err(|fault| faults.push(fault)).ok()?;
    let mut used: Vec<Used<'_>> = Vec::new();
    let mut places = Vec::new();
    for name in names {
        let found = footer.columns.iter().enumerate().find(|(_, column)| column.path == *name);
        places.push(found.map(|_| used.len()));
        let Some((index, column)) = found else { continue };
        match kind(column) {
            // Only a time has a type of time.
            Some(Holds { time: Some(_), .. }) if unit_of_name(name).is_none() => {
                faults.push(Fault::ColumnType { column: excerpt(name), found: type_name(column) });
            }
            Some(kind) => used.push(Used { index, name: excerpt(name), kind, column }),
            None => faults.push(Fault::ColumnType { column: excerpt(name), found: type_name(column) }),
        }
    }
    let bytes = footer.rows.saturating_mul(8 * used.len() as u64);
    if !faults.none() || memory.take(bytes).map_err(|fault| faults.push(fault)).is_err() {
        return None;
    }
    let mut values = vec![Vec::new(); used.len()];
    let wanted: Vec<usize> = used.iter().map(|column| column.index).collect();
    let (spent, mut number) = (Arc::default(), 0_u64);
    let walked = footer.groups(&wanted, |chunks| {
        let mut streams = opened(file, &used, chunks, memory, &spent)?;
        while let count @ 1.. = filled(&mut streams)? {
            for ((stream, values), used) in streams.iter().zip(&mut values).zip(&used) {
                let units = used.kind.time.and_then(|unit| Some((unit, unit_of_name(&used.column.path)?)));
                let converted = |value: f64| units.map_or(value, |(unit, named)| named.from_si(unit.to_si(value)));
                for (row, cell) in (number + 1..).zip(&stream.cells) {
                    let (at, column) = (FileRow::Row(row), stream.name.as_str());
                    match *cell {
                        ParquetCell::Null => faults.push(Fault::ValueMissing { at, column: column.to_owned() }),
                        ParquetCell::Float(value) if !value.is_finite() => faults.push(not_finite(at, column, value)),
                        ParquetCell::Float(value) => values.push(converted(value)),
                        ParquetCell::Integer(value) => values.push(converted(value as f64)),
                        ParquetCell::Text(_) | ParquetCell::Truth(_) => {}
                    }
                }
            }
            number += count as u64;
            // Memory was reserved for the number of rows in the footer.
            if number > footer.rows {
                return Err(damaged(Damage::Lengths));
            }
        }
        Ok(())
    });
    if let Err(fault) = walked {
        faults.push(fault);
        return None;
    }
    let mut values = values.into_iter();
    Some(places.into_iter().map(|place| place.and_then(|_| values.next())).collect())
}

/// Returns the unit of time that a name states, `s` of `time_s`.
fn unit_of_name(name: &str) -> Option<&'static Unit> {
    let named = Named::marked(name);
    let unit = named.unit.clone().or_else(|| named.for_role(Role::Time, |_| true)?.unit)?;
    Unit::of_dimension(Dimension::Time, &unit)
}

/// Opens the columns of a row group.
fn opened(
    file: &Bytes,
    used: &[Used<'_>],
    chunks: Vec<Chunk>,
    memory: &Memory,
    spent: &Arc<AtomicU64>,
) -> Result<Vec<Stream>, Fault> {
    let open = |(column, chunk): (&Used<'_>, Chunk)| {
        let memory = (memory.clone(), used.len());
        let pages = Pages::new(file.clone(), chunk, column.column, memory, Arc::clone(spent))?;
        Stream::open(&column.name, column.kind, column.column, pages)
    };
    used.iter().zip(chunks).map(open).collect()
}

/// Reads the next rows of all columns and returns their number; zero at the end.
fn filled(streams: &mut [Stream]) -> Result<usize, Fault> {
    let counts = streams.iter_mut().map(Stream::fill).collect::<Result<Vec<_>, ParquetError>>();
    let mut counts = counts.map_err(unreadable)?.into_iter();
    let count = counts.next().unwrap_or(0);
    if counts.any(|other| other != count) {
        return Err(damaged(Damage::Lengths));
    }
    Ok(count)
}

/// Converts an error of the library to a fault; faults of pages pass through unchanged.
fn unreadable(error: ParquetError) -> Fault {
    // Messages of the library may quote the file; the bound keeps them readable.
    const LONGEST: usize = 200;
    let error = match error {
        ParquetError::External(source) => match source.downcast::<Fault>() {
            Ok(fault) => return *fault,
            Err(other) => ParquetError::External(other),
        },
        other => other,
    };
    let text = error.to_string().chars().take(LONGEST).collect();
    damaged(Damage::Values { text })
}

fn damaged(reason: Damage) -> Fault {
    Fault::ParquetUnreadable { reason }
}

fn read(file: &Bytes, layout: &Layout, memory: &mut Memory, faults: &mut FaultCollector) -> Option<Recording> {
    check_window(layout, faults);
    let footer = Footer::read(file).map_err(|fault| faults.push(fault)).ok()?;
    let headings: Vec<Heading> = footer.columns.iter().map(|column| Heading::new(&column.path)).collect();
    let (picks, more_time) = pick(&headings, layout, faults);

    if !more_time.twins.is_empty() {
        // A time next to each channel: the user must choose one by its number.
        let [Some(time), ..] = &picks else { return None };
        let all: Vec<usize> = std::iter::once(time.index).collect();
        let columns = all.iter().filter_map(|index| Some(excerpt(&headings.get(*index)?.written))).collect();
        let numbers = all.iter().map(|index| index + 1).collect();
        faults.push(Fault::Ambiguous { role: Role::Time, columns, numbers });
        return None;
    }
    let has_numbers = |pick: &Pick| footer.columns.get(pick.index).is_some_and(|column| kind(column).is_some());
    let picked_roles: Vec<Role> = Role::ALL
        .into_iter()
        .zip(&picks)
        .filter(|(_, picked)| picked.as_ref().is_some_and(has_numbers))
        .map(|(role, _)| role)
        .collect();
    let mut columns = Vec::new();
    let mut used: Vec<Used<'_>> = Vec::new();
    for (role, picked) in Role::ALL.into_iter().zip(picks) {
        let Some(picked) = picked else { continue };
        let index = picked.index;
        let Some((heading, column)) = headings.get(index).zip(footer.columns.get(index)) else { continue };
        let Some(kind) = kind(column) else {
            let fault = Fault::ColumnType { column: excerpt(&heading.written), found: type_name(column) };
            faults.push(match is_spare(role, &picked_roles) {
                true => Fault::Advised { fault: Box::new(fault), remedy: Remedy::Without(role) },
                false => fault,
            });
            continue;
        };
        let nanoseconds = more_time.nanoseconds.filter(|_| role == Role::Time).and_then(|index| headings.get(index));
        if let Some(more) = nanoseconds {
            let both = Heading { written: format!("{} + {}", heading.written, more.written), ..heading.clone() };
            columns.extend(decide(role, &both, [(KnownBy::Header, Said::Unit(&SECOND))], faults));
            used.push(Used { index, name: excerpt(&heading.written), kind, column });
            continue;
        }
        // A type of times says what its numbers are, also below a name such as `t [s]`.
        let is_time = |text: &String| Unit::of_dimension(Dimension::Time, text).is_some();
        let in_name = picked.unit.clone().filter(|text| kind.time.is_none() || !is_time(text));
        let said = [
            in_name.map(|text| (KnownBy::Header, Said::Text(text))),
            kind.time.map(|unit| (KnownBy::Metadata, Said::Unit(unit))),
            metadata_unit(&footer, heading).map(|text| (KnownBy::Metadata, Said::Text(text))),
            column.unit.clone().map(|text| (KnownBy::Metadata, Said::Text(text))),
            layout.column(role).unit.map(|unit| (KnownBy::Layout, Said::Unit(unit))),
        ];
        columns.extend(decide(role, heading, said.into_iter().flatten(), faults));
        used.push(Used { index, name: excerpt(&heading.written), kind, column });
    }
    if let Some((index, column)) = more_time.nanoseconds.and_then(|index| Some((index, footer.columns.get(index)?))) {
        match kind(column) {
            Some(kind) => used.push(Used { index, name: excerpt(&column.path), kind, column }),
            None => faults.push(Fault::ColumnType { column: excerpt(&column.path), found: type_name(column) }),
        }
    }
    if !faults.none() {
        return None;
    }
    let channels = columns.len().saturating_sub(1);
    let mut gather = Gather::new(columns, layout, true, memory, faults)?;
    if !gather.has_window() && footer.rows > SAMPLES_MAX as u64 {
        faults.push(Fault::too_many_samples());
        return None;
    }
    let wanted: Vec<usize> = used.iter().map(|column| column.index).collect();
    // Rows read, and a flag for further ones.
    let (spent, mut number, mut more) = (Arc::default(), 0_u64, true);
    let walked = footer.groups(&wanted, |chunks| {
        if !more {
            return Ok(());
        }
        let mut streams = opened(file, &used, chunks, &gather.memory(), &spent)?;
        while let count @ 1.. = filled(&mut streams)? {
            Limit::Rows.hold(number + count as u64, ROWS_MAX)?;
            gather.go_on()?;
            more = hand_on(&streams, channels, &mut number, &mut gather, faults) && !faults.enough();
            if !more {
                break;
            }
        }
        Ok(())
    });
    if let Err(fault) = walked {
        faults.push(fault);
        return None;
    }
    faults.advise(gather.remedies(more));
    gather.advise_order(faults);
    let indices: Vec<usize> = used.iter().map(|column| column.index).collect();
    let unused = unused(&headings, layout, &indices);
    if more { gather.finish(faults).map(|recording| Recording { unused, ..recording }) } else { None }
}

/// Returns the unit stated for a column in the metadata of the file.
fn metadata_unit(footer: &Footer<'_>, heading: &Heading) -> Option<String> {
    let keys = [&heading.written, &heading.named.bare].map(|name| [format!("{name}.unit"), format!("unit:{name}")]);
    let (_, unit) = footer.units.iter().find(|(key, _)| keys.as_flattened().contains(key))?;
    Some(unit.trim().to_owned())
}

/// Type of the values of a column of numbers.
#[derive(Clone, Copy)]
pub(crate) struct Holds {
    unsigned: bool,
    /// Number of decimal places of a decimal.
    scale: Option<i32>,
    /// Unit stated by a time type.
    time: Option<&'static Unit>,
}

/// Maximum number of digits of a decimal.
const DIGITS_MAX: i32 = 76;

/// Returns the type of the values of a column; `None` if it holds no numbers.
fn kind(column: &ParquetColumn) -> Option<Holds> {
    if column.repeated {
        return None;
    }
    let plain = Holds { unsigned: false, scale: None, time: None };
    let time = |unit| Some(Holds { time: Some(unit), ..plain });
    let is_decimal = column.logical == Logical::Decimal || column.converted == ConvertedType::DECIMAL;
    if is_decimal {
        let scale = i32::try_from(column.scale).ok().filter(|scale| (0..=DIGITS_MAX).contains(scale))?;
        let is_read = match column.physical {
            Type::INT32 | Type::INT64 => true,
            Type::FIXED_LEN_BYTE_ARRAY => (1..=32).contains(&column.width),
            _ => false,
        };
        return is_read.then_some(Holds { scale: Some(scale), ..plain });
    }
    match (column.physical, column.logical, column.converted) {
        (Type::FLOAT | Type::DOUBLE, Logical::Plain, ConvertedType::NONE) => Some(plain),
        (Type::FIXED_LEN_BYTE_ARRAY, Logical::Half, _) if column.width == 2 => Some(plain),
        (Type::INT32 | Type::INT64, Logical::Integer { signed }, _) => Some(Holds { unsigned: !signed, ..plain }),
        (Type::INT32 | Type::INT64, Logical::Timestamp(unit) | Logical::Duration(unit), _) => time(unit),
        // Days and nanoseconds, as Spark and Impala write timestamps.
        (Type::INT96, Logical::Plain, _) => time(&NANOSECOND),
        (Type::INT32, Logical::Plain, ConvertedType::TIME_MILLIS) => time(&MILLISECOND),
        (Type::INT64, Logical::Plain, ConvertedType::TIME_MICROS) => time(&MICROSECOND),
        (Type::INT64, Logical::Plain, ConvertedType::TIMESTAMP_MILLIS) => time(&MILLISECOND),
        (Type::INT64, Logical::Plain, ConvertedType::TIMESTAMP_MICROS) => time(&MICROSECOND),
        (Type::INT32 | Type::INT64, Logical::Plain, converted) => match converted {
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

fn type_name(column: &ParquetColumn) -> String {
    let repeated = if column.repeated { "LIST of " } else { "" };
    match (column.converted, column.logical) {
        (ConvertedType::NONE, Logical::Duration(unit)) => format!("{repeated}DURATION ({})", unit.ascii),
        (ConvertedType::NONE, Logical::Timestamp(unit)) => format!("{repeated}TIMESTAMP ({})", unit.ascii),
        (ConvertedType::NONE, Logical::Other(name)) => format!("{repeated}{name}"),
        (ConvertedType::NONE, Logical::Decimal) => format!("{repeated}DECIMAL"),
        (ConvertedType::NONE, _) if column.physical == Type::FIXED_LEN_BYTE_ARRAY => {
            format!("{repeated}{} ({})", column.physical, column.width)
        }
        (ConvertedType::NONE, _) => format!("{repeated}{}", column.physical),
        (converted, _) => format!("{repeated}{} ({converted})", column.physical),
    }
}

/// A column in use, time first.
struct Used<'f> {
    index: usize,
    name: String,
    kind: Holds,
    column: &'f ParquetColumn,
}

/// Passes the rows read on to the collector: a time, `channels` values, and nanoseconds of the time if a column
/// follows. Returns `false` if no further row can be kept.
fn hand_on(
    streams: &[Stream],
    channels: usize,
    number: &mut u64,
    gather: &mut Gather<'_>,
    faults: &mut FaultCollector,
) -> bool {
    let Some((time, rest)) = streams.split_first() else { return true };
    let (values, nanoseconds) = rest.split_at_checked(channels).unwrap_or((rest, &[]));
    for (row, cell) in time.cells.iter().enumerate() {
        *number += 1;
        let at = FileRow::Row(*number);
        let tick = match *cell {
            ParquetCell::Null | ParquetCell::Text(_) | ParquetCell::Truth(_) => {
                Err(Fault::ValueMissing { at, column: time.name.to_owned() })
            }
            ParquetCell::Float(value) if !value.is_finite() => Err(not_finite(at, &time.name, value)),
            ParquetCell::Float(value) => Ok(Tick::of_float(value)),
            ParquetCell::Integer(value) => Ok(Tick::of_integer(value)),
        };
        let tick = nanoseconds.iter().fold(tick, |tick, more| {
            let missing = || Fault::ValueMissing { at, column: more.name.to_owned() };
            let part = match more.cells.get(row) {
                None | Some(ParquetCell::Null | ParquetCell::Text(_) | ParquetCell::Truth(_)) => Err(missing()),
                Some(ParquetCell::Float(value)) => Ok(*value),
                Some(ParquetCell::Integer(value)) => Ok(*value as f64),
            };
            let part = part.and_then(|part| {
                if (0.0..1e9).contains(&part) { Ok(part) } else { Err(not_finite(at, &more.name, part)) }
            });
            tick.and_then(|tick| part.map(|part| tick.later(1e-9 * part)))
        });
        let sample = tick.map(|tick| gather.sample(*number, tick, faults)).unwrap_or_else(|fault| {
            gather.time_failed();
            faults.push(fault);
            SampleUse::Dropped
        });
        match sample {
            SampleUse::Dropped => continue,
            SampleUse::Full => return false,
            SampleUse::Kept => {}
        }
        for (channel, stream) in values.iter().enumerate() {
            let value = match stream.cells.get(row) {
                None | Some(ParquetCell::Null | ParquetCell::Text(_) | ParquetCell::Truth(_)) => {
                    faults.push(Fault::ValueMissing { at, column: stream.name.to_owned() });
                    gather.lacks(channel);
                    continue;
                }
                Some(ParquetCell::Float(value)) => *value,
                Some(ParquetCell::Integer(value)) => *value as f64,
            };
            match gather.value(channel, value) {
                Ok(()) => {}
                Err(Bad::Implausible) => {
                    let (column, text) = (stream.name.to_owned(), format!("{value:e}"));
                    faults.push(Fault::ValueImplausible { at, column, text });
                }
                Err(_) => {
                    faults.push(not_finite(at, &stream.name, value));
                    gather.lacks(channel);
                }
            }
        }
    }
    true
}

fn not_finite(at: FileRow, column: &str, value: f64) -> Fault {
    Fault::ValueNotFinite { at, column: column.to_owned(), text: format!("{value:e}") }
}

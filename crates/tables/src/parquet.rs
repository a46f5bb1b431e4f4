//! A table as Parquet.

use crate::error::WriteError;
use crate::table::{Column, Table};
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArrayType, DataType, DoubleType};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::Type;
use std::sync::Arc;

/// Number of rows in one row group.
const GROUP: usize = 1 << 20;

/// Writes a table as Parquet: numbers as DOUBLE, texts as UTF-8, all optional; the metadata of the file holds the unit
/// of a column under `<column>.unit`, its meaning under `<column>.about`.
///
/// # Errors
/// [`WriteError::Parquet`] if the library refuses.
pub fn parquet(table: &Table) -> Result<Vec<u8>, WriteError> {
    let fields = table.columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
    let schema = Arc::new(Type::group_type_builder(table.name).with_fields(fields).build()?);
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by("antrieb".to_owned())
        .set_key_value_metadata(Some(metadata(table)))
        .build();
    let mut out = Vec::new();
    let mut writer = SerializedFileWriter::new(&mut out, schema, Arc::new(properties))?;
    let count = table.rows.iter().len();
    for from in (0..count).step_by(GROUP) {
        let mut group = writer.next_row_group()?;
        for (index, column) in table.columns.iter().enumerate() {
            let Some(mut into) = group.next_column()? else { continue };
            if column.is_numeric() {
                write_column::<DoubleType>(&mut into, table.numbers(index).skip(from).take(GROUP))?;
            } else {
                let rows = table.rows.iter().skip(from).take(GROUP);
                write_column::<ByteArrayType>(&mut into, rows.map(|row| Some(row.get(index)?.as_text()?.into())))?;
            }
            into.close()?;
        }
        group.close()?;
    }
    writer.close()?;
    Ok(out)
}

/// Writes the cells of a column.
fn write_column<T: DataType>(
    into: &mut SerializedColumnWriter<'_>,
    cells: impl Iterator<Item = Option<T::T>>,
) -> Result<(), WriteError> {
    let cells: Vec<Option<T::T>> = cells.collect();
    let levels: Vec<i16> = cells.iter().map(|cell| i16::from(cell.is_some())).collect();
    let values: Vec<T::T> = cells.into_iter().flatten().collect();
    into.typed::<T>().write_batch(&values, Some(&levels), None)?;
    Ok(())
}

fn field(column: &Column) -> Result<Arc<Type>, WriteError> {
    let (physical, logical) =
        if column.is_numeric() { (Physical::DOUBLE, None) } else { (Physical::BYTE_ARRAY, Some(LogicalType::String)) };
    let built = Type::primitive_type_builder(&column.name, physical)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(logical)
        .build()?;
    Ok(Arc::new(built))
}

fn metadata(table: &Table) -> Vec<KeyValue> {
    let pair = |key: String, value: &str| KeyValue::new(key, value.to_owned());
    let mut pairs = vec![pair("antrieb.table".to_owned(), table.name), pair("antrieb.about".to_owned(), &table.about)];
    for column in &table.columns {
        pairs.extend(column.unit_json().map(|unit| pair(format!("{}.unit", column.name), unit)));
        pairs.push(pair(format!("{}.about", column.name), &column.about));
    }
    pairs
}

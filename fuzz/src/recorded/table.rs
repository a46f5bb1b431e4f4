//! Files of columns: Parquet in every encoding supported by its writer, CSV in other character encodings.

use super::columns::{Columns, GeneratedColumn};
use arbitrary::{Result, Unstructured};
use parquet::basic::{Compression, Encoding, LogicalType, Repetition, TimeUnit, Type as Physical, ZstdLevel};
use parquet::column::writer::ColumnWriter;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterVersion};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, Type, TypePtr};
use std::sync::Arc;

/// Storage type of a column.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Store {
    Double,
    Float,
    Int32,
    Int64,
    Timestamp,
    Text,
    Bool,
}

const STORES: [Store; 10] = [
    Store::Double,
    Store::Double,
    Store::Double,
    Store::Double,
    Store::Float,
    Store::Int32,
    Store::Int64,
    Store::Timestamp,
    Store::Text,
    Store::Bool,
];

impl Store {
    /// Returns the encodings supported by the writer.
    const fn encodings(self) -> &'static [Encoding] {
        match self {
            Self::Double | Self::Float => &[Encoding::PLAIN, Encoding::BYTE_STREAM_SPLIT],
            Self::Int32 | Self::Int64 | Self::Timestamp => {
                &[Encoding::PLAIN, Encoding::DELTA_BINARY_PACKED, Encoding::BYTE_STREAM_SPLIT]
            }
            Self::Text => &[Encoding::PLAIN, Encoding::DELTA_LENGTH_BYTE_ARRAY, Encoding::DELTA_BYTE_ARRAY],
            Self::Bool => &[Encoding::PLAIN, Encoding::RLE],
        }
    }
}

impl Stored<'_> {
    fn path(&self) -> ColumnPath {
        let group = self.nested.then(|| self.column.name.to_owned());
        ColumnPath::new(group.into_iter().chain([self.name.clone()]).collect())
    }
}

/// Properties of a single column.
struct Stored<'c> {
    column: &'c GeneratedColumn,
    store: Store,
    repetition: Repetition,
    /// The column is in a group and thus has a longer path.
    nested: bool,
    name: String,
}

impl Columns {
    /// Writes Parquet; returns an empty file if the writer refuses the columns.
    pub(crate) fn parquet(&self, u: &mut Unstructured<'_>) -> Result<Vec<u8>> {
        let mut stored = Vec::new();
        let in_names = u.ratio(2, 3)?;
        for column in &self.columns {
            stored.push(Stored {
                column,
                store: if u.ratio(1, 2)? { Store::Double } else { *u.choose(&STORES)? },
                repetition: *u.choose(&[
                    Repetition::REQUIRED,
                    Repetition::REQUIRED,
                    Repetition::OPTIONAL,
                    Repetition::REPEATED,
                ])?,
                nested: u.ratio(1, 12)?,
                name: if in_names && !column.unit.is_empty() {
                    format!("{} [{}]", column.name, column.unit)
                } else {
                    column.name.to_owned()
                },
            });
        }
        let key = *u.choose(&["unit:", "unit_"])?;
        let stated =
            stored.iter().map(|each| KeyValue::new(format!("{key}{}", each.column.name), each.column.unit.to_owned()));
        let stated = if in_names { None } else { Some(stated.collect::<Vec<_>>()) };
        let groups = u.int_in_range(1..=3)?;
        let properties = properties(u, &stored, stated)?;
        let gaps = u.ratio(1, 8)?;
        Ok(write(&stored, properties, groups, gaps).unwrap_or_default())
    }
}

fn properties(
    u: &mut Unstructured<'_>,
    stored: &[Stored<'_>],
    stated: Option<Vec<KeyValue>>,
) -> Result<WriterProperties> {
    let compressions = [
        Compression::UNCOMPRESSED,
        Compression::SNAPPY,
        Compression::LZ4_RAW,
        Compression::LZ4,
        Compression::GZIP(parquet::basic::GzipLevel::default()),
        Compression::ZSTD(ZstdLevel::default()),
    ];
    let version = if u.ratio(1, 2)? { WriterVersion::PARQUET_1_0 } else { WriterVersion::PARQUET_2_0 };
    let statistics = *u.choose(&[EnabledStatistics::None, EnabledStatistics::Chunk, EnabledStatistics::Page])?;
    let mut builder = WriterProperties::builder()
        .set_compression(*u.choose(&compressions)?)
        .set_writer_version(version)
        .set_dictionary_enabled(u.ratio(1, 2)?)
        .set_statistics_enabled(statistics)
        .set_data_page_row_count_limit(u.int_in_range(1..=64)?)
        .set_write_batch_size(u.int_in_range(1..=32)?)
        .set_key_value_metadata(stated);
    for of in stored {
        let own = of.store.encodings();
        if u.ratio(1, 3)? {
            let encoding = *u.choose(own)?;
            // Columns of one name have one encoding, and the writer has not each for each type.
            if stored.iter().filter(|other| other.path() == of.path()).count() == 1 {
                builder = builder.set_column_encoding(of.path(), encoding);
            }
        }
    }
    Ok(builder.build())
}

fn field(of: &Stored<'_>) -> std::result::Result<TypePtr, ParquetError> {
    let (physical, logical) = match of.store {
        Store::Double => (Physical::DOUBLE, None),
        Store::Float => (Physical::FLOAT, None),
        Store::Int32 => (Physical::INT32, None),
        Store::Int64 => (Physical::INT64, None),
        Store::Timestamp => (Physical::INT64, Some(LogicalType::timestamp(true, TimeUnit::MICROS))),
        Store::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        Store::Bool => (Physical::BOOLEAN, None),
    };
    let leaf = Type::primitive_type_builder(&of.name, physical)
        .with_repetition(of.repetition)
        .with_logical_type(logical)
        .build()?;
    if !of.nested {
        return Ok(Arc::new(leaf));
    }
    let group = Type::group_type_builder(of.column.name)
        .with_repetition(Repetition::REQUIRED)
        .with_fields(vec![Arc::new(leaf)])
        .build()?;
    Ok(Arc::new(group))
}

fn write(
    stored: &[Stored<'_>],
    properties: WriterProperties,
    groups: usize,
    gaps: bool,
) -> std::result::Result<Vec<u8>, ParquetError> {
    let fields = stored.iter().map(field).collect::<std::result::Result<Vec<_>, _>>()?;
    let schema = Arc::new(Type::group_type_builder("schema").with_fields(fields).build()?);
    let mut bytes = Vec::new();
    let mut writer = SerializedFileWriter::new(&mut bytes, schema, Arc::new(properties))?;
    let rows = stored.first().map_or(0, |each| each.column.values.len());
    let size = rows.div_ceil(groups.max(1)).max(1);
    for begin in (0..rows).step_by(size) {
        let mut group = writer.next_row_group()?;
        let mut columns = stored.iter();
        while let Some(mut column) = group.next_column()? {
            if let Some(of) = columns.next() {
                let values = of.column.values.get(begin..(begin + size).min(rows)).unwrap_or_default();
                fill(column.untyped(), of, values, gaps)?;
            }
            column.close()?;
        }
        group.close()?;
    }
    writer.close()?;
    Ok(bytes)
}

#[allow(clippy::cast_possible_truncation, reason = "a logger that stores whole numbers cuts them off too")]
fn fill(
    column: &mut ColumnWriter<'_>,
    of: &Stored<'_>,
    values: &[f64],
    gaps: bool,
) -> std::result::Result<(), ParquetError> {
    // In an optional column with gaps every fifth value is missing.
    let there = |index: usize| !(gaps && index % 5 == 4);
    let optional = of.repetition != Repetition::REQUIRED;
    let definitions: Vec<i16> = (0..values.len()).map(|index| i16::from(there(index))).collect();
    let kept: Vec<f64> =
        values.iter().enumerate().filter(|(index, _)| !optional || there(*index)).map(|(_, value)| *value).collect();
    let repetitions = vec![0_i16; values.len()];
    let definitions = optional.then_some(definitions.as_slice());
    let repetitions = (of.repetition == Repetition::REPEATED).then_some(repetitions.as_slice());
    match column {
        ColumnWriter::DoubleColumnWriter(to) => to.write_batch(&kept, definitions, repetitions),
        ColumnWriter::FloatColumnWriter(to) => {
            to.write_batch(&kept.iter().map(|value| *value as f32).collect::<Vec<_>>(), definitions, repetitions)
        }
        ColumnWriter::Int32ColumnWriter(to) => {
            to.write_batch(&kept.iter().map(|value| *value as i32).collect::<Vec<_>>(), definitions, repetitions)
        }
        ColumnWriter::Int64ColumnWriter(to) => {
            to.write_batch(&kept.iter().map(|value| *value as i64).collect::<Vec<_>>(), definitions, repetitions)
        }
        ColumnWriter::ByteArrayColumnWriter(to) => {
            let texts: Vec<parquet::data_type::ByteArray> =
                kept.iter().map(|value| value.to_string().into_bytes().into()).collect();
            to.write_batch(&texts, definitions, repetitions)
        }
        ColumnWriter::BoolColumnWriter(to) => {
            to.write_batch(&kept.iter().map(|value| *value > 0.0).collect::<Vec<_>>(), definitions, repetitions)
        }
        _ => Ok(0),
    }
    .map(drop)
}

/// Creates a file with these bytes as footer, their correct length, and some data before it to refer to.
pub(crate) fn with_footer(footer: &[u8]) -> Vec<u8> {
    let mut bytes = b"PAR1".to_vec();
    bytes.extend((0..64).map(|byte| byte * 3));
    bytes.extend_from_slice(footer);
    bytes.extend(u32::try_from(footer.len()).unwrap_or(0).to_le_bytes());
    bytes.extend_from_slice(b"PAR1");
    bytes
}

/// Encodes a text differently from UTF-8, as in old loggers.
pub(crate) fn encoded(text: &str, u: &mut Unstructured<'_>) -> Result<Vec<u8>> {
    let text = text.replace("deg", "°");
    Ok(match u.int_in_range(0..=3)? {
        0 => text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        1 => [0xFF, 0xFE].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect(),
        2 => [0xFE, 0xFF].into_iter().chain(text.encode_utf16().flat_map(u16::to_be_bytes)).collect(),
        // Latin 1: one byte for each character that has one.
        _ => text.chars().map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')).collect(),
    })
}

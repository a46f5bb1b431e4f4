//! Batch reader for the values of a column.

use super::footer::ParquetColumn;
use super::pages::Pages;
use super::{BATCH, Holds, damaged, unreadable};
use crate::faults::{Damage, Fault};
use ::parquet::basic::{Repetition, Type};
use ::parquet::column::reader::{ColumnReader, ColumnReaderImpl, get_column_reader};
use ::parquet::data_type::{
    BoolType, ByteArray, ByteArrayType, DataType, DoubleType, FixedLenByteArray, FixedLenByteArrayType, FloatType,
    Int32Type, Int64Type, Int96, Int96Type,
};
use ::parquet::errors::ParquetError;
use ::parquet::schema::types::{ColumnDescriptor, ColumnPath};
use std::sync::Arc;

/// Julian day of 1 January 1970.
const DAY_OF_1970: i64 = 2_440_588;

/// Nanoseconds of a day.
const DAY_NS: i64 = 86_400_000_000_000;

/// Returns the whole number of a decimal of at most 32 bytes in two's complement, the highest byte first.
fn whole(bytes: &[u8]) -> f64 {
    let (high, low) = bytes.split_at(bytes.len().saturating_sub(16));
    let sign = if bytes.first().is_some_and(|byte| *byte >= 0x80) { -1_i128 } else { 0 };
    let signed = |bytes: &[u8]| bytes.iter().fold(sign, |whole, byte| whole << 8 | i128::from(*byte));
    let low = signed(low);
    match signed(high) {
        0 => low.cast_unsigned() as f64,
        // Of a number in 16 bytes no bit stands above: its negative has the digits of the magnitude.
        -1 if low != 0 => -(low.wrapping_neg().cast_unsigned() as f64),
        high => high as f64 * 2_f64.powi(128) + low.cast_unsigned() as f64,
    }
}

/// Returns the value of a float of two bytes: a sign, five bits of exponent and ten of fraction.
fn half(bits: u16) -> f64 {
    let (exponent, fraction) = (i32::from(bits >> 10 & 0x1f), f64::from(bits & 0x3ff));
    let size = match exponent {
        0 => fraction * 2_f64.powi(-24),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1024.0 + fraction) * 2_f64.powi(exponent - 25),
    };
    if bits >> 15 == 1 { -size } else { size }
}

/// A value of a column.
#[derive(Clone, Copy)]
pub(super) enum ParquetCell {
    Null,
    Float(f64),
    Integer(i64),
    Truth(bool),
    /// Index of the text in the batch.
    Text(usize),
}

/// One column of a row group, read batch by batch.
pub(super) struct Stream {
    pub(super) name: String,
    source: Source,
    unsigned: bool,
    scale: Option<i32>,
    level_max: i16,
    levels: Vec<i16>,
    pub(super) cells: Vec<ParquetCell>,
    /// Text values of the batch.
    pub(super) texts: Vec<ByteArray>,
}

enum Source {
    Float(ColumnReaderImpl<FloatType>, Vec<f32>),
    Double(ColumnReaderImpl<DoubleType>, Vec<f64>),
    Int32(ColumnReaderImpl<Int32Type>, Vec<i32>),
    Int64(ColumnReaderImpl<Int64Type>, Vec<i64>),
    Int96(ColumnReaderImpl<Int96Type>, Vec<Int96>),
    Fixed(ColumnReaderImpl<FixedLenByteArrayType>, Vec<FixedLenByteArray>),
    Truth(ColumnReaderImpl<BoolType>, Vec<bool>),
    Text(ColumnReaderImpl<ByteArrayType>),
}

impl Stream {
    pub(super) fn open(name: &str, kind: Holds, column: &ParquetColumn, pages: Pages) -> Result<Self, Fault> {
        // The library needs the levels and the type; the path is known to the reader.
        let repetition = if column.defined > 0 { Repetition::OPTIONAL } else { Repetition::REQUIRED };
        let mut primitive = ::parquet::schema::types::Type::primitive_type_builder("values", column.physical)
            .with_repetition(repetition);
        if column.physical == Type::FIXED_LEN_BYTE_ARRAY {
            primitive = primitive.with_length(i32::try_from(column.width).map_err(|_| damaged(Damage::Footer))?);
        }
        let primitive = primitive.build().map_err(unreadable)?;
        let path = ColumnPath::from("values");
        let descriptor = Arc::new(ColumnDescriptor::new(Arc::new(primitive), column.defined, 0, path));
        let source = match get_column_reader(descriptor, Box::new(pages)) {
            ColumnReader::FloatColumnReader(reader) => Source::Float(reader, Vec::new()),
            ColumnReader::DoubleColumnReader(reader) => Source::Double(reader, Vec::new()),
            ColumnReader::Int32ColumnReader(reader) => Source::Int32(reader, Vec::new()),
            ColumnReader::Int64ColumnReader(reader) => Source::Int64(reader, Vec::new()),
            ColumnReader::Int96ColumnReader(reader) => Source::Int96(reader, Vec::new()),
            ColumnReader::FixedLenByteArrayColumnReader(reader) => Source::Fixed(reader, Vec::new()),
            ColumnReader::BoolColumnReader(reader) => Source::Truth(reader, Vec::new()),
            ColumnReader::ByteArrayColumnReader(reader) => Source::Text(reader),
        };
        Ok(Self {
            name: name.to_owned(),
            source,
            unsigned: kind.unsigned,
            scale: kind.scale,
            level_max: column.defined,
            levels: Vec::new(),
            cells: Vec::new(),
            texts: Vec::new(),
        })
    }

    /// Reads up to a batch and returns its length; zero at the end.
    pub(super) fn fill(&mut self) -> Result<usize, ParquetError> {
        self.fill_up_to(BATCH)
    }

    /// Reads up to `most` values and returns their number; zero at the end.
    pub(super) fn fill_up_to(&mut self, most: usize) -> Result<usize, ParquetError> {
        self.cells.clear();
        self.levels.clear();
        self.texts.clear();
        let (levels, cells, max) = (&mut self.levels, &mut self.cells, self.level_max);
        let (unsigned, scale) = (self.unsigned, self.scale);
        let scaled = |value: i128| scale.map(|scale| ParquetCell::Float(value as f64 / 10_f64.powi(scale)));
        match &mut self.source {
            Source::Float(reader, values) => {
                let count = batch(reader, values, levels, max, most)?;
                spread(values, levels, max, count, cells, |value| ParquetCell::Float(f64::from(*value)));
            }
            Source::Double(reader, values) => {
                let count = batch(reader, values, levels, max, most)?;
                spread(values, levels, max, count, cells, |value| ParquetCell::Float(*value));
            }
            Source::Int32(reader, values) => {
                let count = batch(reader, values, levels, max, most)?;
                spread(values, levels, max, count, cells, |value| {
                    let whole = if unsigned { i64::from(value.cast_unsigned()) } else { i64::from(*value) };
                    scaled(whole.into()).unwrap_or(ParquetCell::Integer(whole))
                });
            }
            Source::Int64(reader, values) => {
                let count = batch(reader, values, levels, max, most)?;
                spread(values, levels, max, count, cells, |value| match unsigned {
                    true if *value < 0 => ParquetCell::Float(value.cast_unsigned() as f64),
                    _ => scaled((*value).into()).unwrap_or(ParquetCell::Integer(*value)),
                });
            }
            Source::Int96(reader, values) => {
                let count = batch(reader, values, levels, max, most)?;
                spread(values, levels, max, count, cells, |value| {
                    // Nanoseconds of the day in two words, the lower one first, and the Julian day.
                    let [low, high, day] = [0, 1, 2].map(|word| value.data().get(word).copied().unwrap_or(0));
                    let of_day = (u64::from(high) << 32 | u64::from(low)).cast_signed();
                    let days = (i64::from(day) - DAY_OF_1970).checked_mul(DAY_NS);
                    days.and_then(|days| days.checked_add(of_day)).map_or(ParquetCell::Null, ParquetCell::Integer)
                });
            }
            Source::Fixed(reader, values) => {
                let count = batch(reader, values, levels, max, most)?;
                spread(values, levels, max, count, cells, |value| {
                    ParquetCell::Float(match (scale, value.data()) {
                        (None, [low, high]) => half(u16::from_le_bytes([*low, *high])),
                        (None, _) => return ParquetCell::Null,
                        (Some(scale), bytes) => whole(bytes) / 10_f64.powi(scale),
                    })
                });
            }
            Source::Truth(reader, values) => {
                let count = batch(reader, values, levels, max, most)?;
                spread(values, levels, max, count, cells, |value| ParquetCell::Truth(*value));
            }
            Source::Text(reader) => {
                let count = batch(reader, &mut self.texts, levels, max, most)?;
                let numbers: Vec<usize> = (0..self.texts.len()).collect();
                spread(&numbers, levels, max, count, cells, |number| ParquetCell::Text(*number));
            }
        }
        Ok(self.cells.len())
    }
}

/// Reads up to `most` non-null values, and the levels that mark nulls.
fn batch<T: DataType>(
    reader: &mut ColumnReaderImpl<T>,
    values: &mut Vec<T::T>,
    levels: &mut Vec<i16>,
    level_max: i16,
    most: usize,
) -> Result<usize, ParquetError> {
    values.clear();
    let mut count = 0;
    while count < most {
        let (rows, ..) = reader.read_records(most - count, (level_max > 0).then_some(&mut *levels), None, values)?;
        if rows == 0 {
            break;
        }
        count += rows;
    }
    Ok(count)
}

/// Arranges values and nulls in the order of the rows.
fn spread<T>(
    values: &[T],
    levels: &[i16],
    level_max: i16,
    count: usize,
    cells: &mut Vec<ParquetCell>,
    cell: impl Fn(&T) -> ParquetCell,
) {
    let mut values = values.iter();
    if level_max == 0 {
        cells.extend(values.take(count).map(cell));
    } else {
        let mut next = |level: &i16| if *level == level_max { values.next().map(&cell) } else { None };
        cells.extend(levels.iter().map(|level| next(level).unwrap_or(ParquetCell::Null)));
    }
}

#[cfg(test)]
mod tests {
    use super::{half, whole};

    /// Values of IEEE 754-2008, binary16: its limits, and all whole numbers that it holds exactly.
    #[test]
    fn a_half_float_has_its_value() {
        for (bits, value) in [
            (0x0000, 0.0),
            (0x0001, 5.960_464_477_539_063e-8),
            (0x03ff, 6.097_555_160_522_461e-5),
            (0x0400, 6.103_515_625e-5),
            (0x3555, 0.333_251_953_125),
            (0x3c00, 1.0),
            (0xc000, -2.0),
            (0x7bff, 65_504.0),
            (0x7c00, f64::INFINITY),
            (0xfc00, f64::NEG_INFINITY),
        ] {
            assert_eq!(half(bits), value, "{bits:#x}");
        }
        assert!(half(0x7e00).is_nan());
        assert!((0x0000..0x7bff).all(|bits| half(bits) < half(bits + 1)));
    }

    /// Decimals of all widths: sign-extended bytes have the value of the shorter ones.
    #[test]
    fn a_decimal_has_its_value_in_every_width() {
        for value in [0_i128, 1, -1, 255, -256, 123_456_789_012, -123_456_789_012, i128::MAX, i128::MIN] {
            let bytes = value.to_be_bytes();
            assert_eq!(whole(&bytes), value as f64, "{value}");
            for width in 17..=32 {
                let fill = if value < 0 { 0xff } else { 0 };
                let wide: Vec<u8> = std::iter::repeat_n(fill, width - 16).chain(bytes).collect();
                assert_eq!(whole(&wide), value as f64, "{value} {width}");
            }
            if i64::try_from(value).is_ok() {
                assert_eq!(whole(&bytes[8..]), value as f64, "{value}");
            }
        }
        let [mut high, mut low] = [[0_u8; 32]; 2];
        (high[15], low[15]) = (1, 0xff);
        low[..15].fill(0xff);
        assert_eq!((whole(&high), whole(&low)), (2_f64.powi(128), -(2_f64.powi(128))));
    }
}

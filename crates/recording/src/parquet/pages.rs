//! Pages of a Parquet column, checked before they are unpacked and before they are decoded.
//!
//! The library decodes the values. Properties of a page that its decoders assume are checked here, so that a damaged
//! file is refused with a reason; a page that claims more bytes than its values can need is not unpacked.

use super::damaged;
use super::footer::{Chunk, ParquetColumn};
use super::thrift::{Broken, Stop, Thrift, ThriftType};
use super::unpack::Codec;
use crate::faults::{Damage, Fault};
use crate::limits::{DELTA_BLOCK_MAX, Limit, PAGE_BYTES_FREE, PAGE_RATIO_MAX, UNPACKED_BYTES_MAX};
use crate::memory::Memory;
use ::parquet::basic::{Encoding, Type};
use ::parquet::column::page::{Page, PageMetadata, PageReader};
use ::parquet::errors::ParquetError;
use bytes::Bytes;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Maximum number of bytes of a value with its level in any encoding.
const BYTES_PER_VALUE: u64 = 32;

/// Maximum number of bytes of a text.
const BYTES_PER_TEXT: u64 = 4096;

/// Additional bytes permitted per page, for headers and partly filled blocks.
const BYTES_PER_PAGE: u64 = 4096;

/// Work per page besides unpacking, in bytes.
const WORK_PER_PAGE: u64 = 1024;

/// Maximum number of bits of an index, which must fit into 32 bits.
const INDEX_BITS_MAX: u8 = 32;

/// The pages of a column in a row group.
pub(super) struct Pages {
    file: Bytes,
    chunk: Chunk,
    codec: Codec,
    physical: Type,
    /// Number of bytes of a value: a lower bound if lengths differ, zero if several share a byte.
    width: u64,
    defined: i16,
    has_dictionary: bool,
    /// Number of values that the remaining pages may have.
    values_left: u64,
    /// Memory left, and the number of parts it is divided into: pages of all columns, each with its decoded values.
    memory: Memory,
    share: u64,
    /// Unpacked size of all pages of the file so far.
    spent: Arc<AtomicU64>,
}

/// Header of a page.
#[derive(Default)]
struct Head {
    kind: i64,
    unpacked: u64,
    packed: usize,
    values: u64,
    encoding: i64,
    level_encoding: i64,
    /// Fields of pages of the second version follow.
    nulls: u64,
    rows: u64,
    defined_bytes: u64,
    repeated_bytes: u64,
    is_packed: bool,
}

fn known(holds: bool) -> Result<(), Fault> {
    if holds { Ok(()) } else { Err(damaged(Damage::Page)) }
}

impl Pages {
    /// Opens the pages of a chunk, one of `columns` that are read in parallel; an unpacked page may not take more than
    /// its share of the remaining memory.
    pub(super) fn new(
        file: Bytes,
        chunk: Chunk,
        column: &ParquetColumn,
        (memory, columns): (Memory, usize),
        spent: Arc<AtomicU64>,
    ) -> Result<Self, Fault> {
        let codec = Codec::of(chunk.codec)?;
        let (values_left, physical, defined) = (chunk.values, column.physical, column.defined);
        let share = 2 * columns as u64;
        let width = match physical {
            Type::BOOLEAN => 0,
            Type::INT32 | Type::FLOAT | Type::BYTE_ARRAY => 4,
            Type::INT64 | Type::DOUBLE => 8,
            Type::INT96 => 12,
            Type::FIXED_LEN_BYTE_ARRAY => column.width,
        };
        Ok(Self {
            file,
            chunk,
            codec,
            physical,
            width,
            defined,
            has_dictionary: false,
            values_left,
            memory,
            share,
            spent,
        })
    }

    /// Returns the next page; `None` at the end.
    fn page(&mut self) -> Result<Option<Page>, Fault> {
        // The dictionary and every page with values; data after the last value is not read.
        while self.values_left > 0 && !self.chunk.bytes.is_empty() {
            let here = self.file.get(self.chunk.bytes.clone()).ok_or_else(|| damaged(Damage::Page))?;
            let mut thrift = Thrift::new(here);
            let head = head(&mut thrift).map_err(|stop| stop.or(Damage::Page))?;
            let start = self.chunk.bytes.end - thrift.left();
            let end = start.checked_add(head.packed).filter(|end| *end <= self.chunk.bytes.end);
            let end = end.ok_or_else(|| damaged(Damage::Page))?;
            self.chunk.bytes.start = end;
            let packed = self.file.slice(start..end);
            match head.kind {
                INDEX_PAGE => self.spend(0)?,
                DICTIONARY_PAGE => return self.dictionary(&head, packed).map(Some),
                DATA_PAGE => return self.first_version(&head, packed).map(Some),
                DATA_PAGE_V2 => return self.second_version(&head, packed).map(Some),
                _ => return Err(damaged(Damage::Page)),
            }
        }
        if self.values_left > 0 { Err(damaged(Damage::Lengths)) } else { Ok(None) }
    }

    fn dictionary(&mut self, head: &Head, packed: Bytes) -> Result<Page, Fault> {
        known(!self.has_dictionary)?;
        self.has_dictionary = true;
        let buf = self.unpacked(head, packed, 0)?;
        let encoding = encoding(head.encoding)?;
        known(matches!(encoding, Encoding::PLAIN | Encoding::PLAIN_DICTIONARY))?;
        known(head.values.saturating_mul(self.width) <= buf.len() as u64)?;
        Ok(Page::DictionaryPage { buf, num_values: count(head.values)?, encoding, is_sorted: false })
    }

    fn first_version(&mut self, head: &Head, packed: Bytes) -> Result<Page, Fault> {
        self.count_values(head)?;
        let buf = self.unpacked(head, packed, 0)?;
        let def_level_encoding = encoding(head.level_encoding)?;
        let levels = self.level_bytes(&buf, head.values, def_level_encoding)?;
        if def_level_encoding == Encoding::RLE {
            self.check_levels(buf.get(4..levels).unwrap_or_default(), head)?;
        }
        let (encoding, buf) = self.checked(head, buf, levels)?;
        Ok(Page::DataPage {
            buf,
            num_values: count(head.values)?,
            encoding,
            def_level_encoding,
            rep_level_encoding: Encoding::RLE,
            statistics: None,
        })
    }

    fn second_version(&mut self, head: &Head, packed: Bytes) -> Result<Page, Fault> {
        self.count_values(head)?;
        let levels = head.defined_bytes.saturating_add(head.repeated_bytes);
        known(head.repeated_bytes == 0 && levels <= packed.len() as u64 && levels <= head.unpacked)?;
        let levels = usize::try_from(levels).map_err(|_| damaged(Damage::Page))?;
        let buf = self.unpacked(head, packed, levels)?;
        self.check_levels(buf.get(..levels).unwrap_or_default(), head)?;
        let (encoding, buf) = self.checked(head, buf, levels)?;
        Ok(Page::DataPageV2 {
            buf,
            num_values: count(head.values)?,
            encoding,
            num_nulls: count(head.nulls)?,
            num_rows: count(head.rows)?,
            def_levels_byte_len: count(head.defined_bytes)?,
            rep_levels_byte_len: 0,
            is_compressed: false,
            statistics: None,
        })
    }

    fn count_values(&mut self, head: &Head) -> Result<(), Fault> {
        let left = self.values_left.checked_sub(head.values);
        self.values_left = left.ok_or_else(|| damaged(Damage::Lengths))?;
        Ok(())
    }

    /// Adds to the work done; returns an error if the file requires more than its share.
    fn spend(&self, bytes: u64) -> Result<(), Fault> {
        let bytes = bytes.saturating_add(WORK_PER_PAGE);
        let spent = self.spent.fetch_add(bytes, Ordering::Relaxed).saturating_add(bytes);
        Limit::UnpackedBytes.hold(spent, UNPACKED_BYTES_MAX)
    }

    /// Returns the bytes of a page, of which the first `plain` are not packed.
    fn unpacked(&self, head: &Head, packed: Bytes, plain: usize) -> Result<Bytes, Fault> {
        if self.codec == Codec::None || !head.is_packed {
            self.spend(0)?;
            return Ok(packed);
        }
        let per_value = if self.physical == Type::BYTE_ARRAY { BYTES_PER_TEXT } else { BYTES_PER_VALUE };
        known(head.unpacked <= head.values.saturating_mul(per_value).saturating_add(BYTES_PER_PAGE))?;
        if head.unpacked > PAGE_BYTES_FREE {
            Limit::PageRatio.hold(head.unpacked / (packed.len() as u64).max(1), PAGE_RATIO_MAX)?;
        }
        self.memory.clone().take(head.unpacked.saturating_mul(self.share))?;
        self.spend(head.unpacked)?;
        let size = usize::try_from(head.unpacked).map_err(|_| damaged(Damage::Page))?;
        let (plain, packed) = packed.split_at_checked(plain).ok_or_else(|| damaged(Damage::Page))?;
        let rest = size.checked_sub(plain.len()).ok_or_else(|| damaged(Damage::Page))?;
        let mut bytes = plain.to_vec();
        // A page of nulls has nothing to unpack.
        if rest > 0 {
            self.codec.unpack(packed, rest, &mut bytes)?;
        }
        Ok(Bytes::from(bytes))
    }

    /// Returns the length of the levels at the beginning of a page of the first version.
    fn level_bytes(&self, buf: &[u8], count: u64, encoding: Encoding) -> Result<usize, Fault> {
        if self.defined == 0 {
            return Ok(0);
        }
        let length = match encoding {
            Encoding::RLE => buf.first_chunk().map(|length| u64::from(u32::from_le_bytes(*length)).saturating_add(4)),
            #[expect(deprecated, reason = "old files have it")]
            Encoding::BIT_PACKED => {
                Some(u64::from(16 - self.defined.leading_zeros()).saturating_mul(count).div_ceil(8))
            }
            _ => None,
        };
        let length = length.filter(|length| *length <= buf.len() as u64);
        length.and_then(|length| usize::try_from(length).ok()).ok_or_else(|| damaged(Damage::Page))
    }

    /// Checks the levels of a page, which are runs of one or two bits.
    fn check_levels(&self, levels: &[u8], head: &Head) -> Result<(), Fault> {
        known(are_runs(levels, u64::from(16 - self.defined.leading_zeros()), head.values))
    }

    /// Returns the encoding of the values after the levels, and the page in the form passed to the library.
    fn checked(&self, head: &Head, buf: Bytes, levels: usize) -> Result<(Encoding, Bytes), Fault> {
        let values = buf.get(levels..).ok_or_else(|| damaged(Damage::Page))?;
        let encoding = encoding(head.encoding)?;
        match encoding {
            Encoding::RLE_DICTIONARY | Encoding::PLAIN_DICTIONARY => {
                let (bits, indices) = values.split_first().ok_or_else(|| damaged(Damage::Page))?;
                known(self.has_dictionary && *bits <= INDEX_BITS_MAX)?;
                known(are_runs(indices, u64::from(*bits), head.values))?;
            }
            Encoding::BYTE_STREAM_SPLIT => {
                known(self.width > 0 && self.physical != Type::BYTE_ARRAY)?;
                // The decoder of split values reads beyond the end if there are fewer values than levels; the decoder
                // of plain values checks the remaining length.
                self.memory.clone().take((buf.len() as u64).saturating_mul(self.share))?;
                return Ok((Encoding::PLAIN, joined(&buf, levels, self.width)?));
            }
            Encoding::PLAIN => {}
            Encoding::DELTA_BINARY_PACKED => {
                known(matches!(self.physical, Type::INT32 | Type::INT64))?;
                let deltas = deltas(values).map_err(|stop| stop.or(Damage::Page))?;
                known(deltas <= head.values)?;
                if deltas == 0 {
                    // A page of nulls: the decoder of deltas needs at least one value, the plain one none.
                    return Ok((Encoding::PLAIN, buf.slice(..levels)));
                }
            }
            other => {
                let name = other.to_string();
                return Err(damaged(Damage::Encoding { name }));
            }
        }
        Ok((encoding, buf))
    }
}

/// Converts a page of split values (all first bytes before all second ones) to one of plain values after the same
/// levels.
fn joined(page: &[u8], levels: usize, size: u64) -> Result<Bytes, Fault> {
    let (levels, split) = page.split_at_checked(levels).ok_or_else(|| damaged(Damage::Page))?;
    let size = usize::try_from(size).map_err(|_| damaged(Damage::Page))?;
    known(split.len().is_multiple_of(size))?;
    let count = split.len() / size;
    let values = (0..count).flat_map(|value| split.iter().skip(value).step_by(count).copied());
    Ok(levels.iter().copied().chain(values).collect())
}

/// Maximum number of bytes of the length of a run.
const RUN_LENGTH_BYTES_MAX: usize = 10;

/// Returns `true` if the bytes are runs of equal values and packed groups of eight, of so many bits, up to a number of values; the
/// decoder of the library panics at a length of more than ten bytes. Runs that are cut are left to it.
fn are_runs(mut bytes: &[u8], bits: u64, values: u64) -> bool {
    let mut seen = 0_u64;
    while seen < values && !bytes.is_empty() {
        let Some(end) = bytes.iter().take(RUN_LENGTH_BYTES_MAX).position(|byte| byte & 0x80 == 0) else {
            return bytes.len() < RUN_LENGTH_BYTES_MAX;
        };
        let (length, rest) = bytes.split_at(end + 1);
        let Ok(run) = Thrift::new(length).varint() else { return false };
        let is_packed = run & 1 == 1;
        let (count, size) = match is_packed {
            true => ((run >> 1).saturating_mul(8), (run >> 1).saturating_mul(bits)),
            false => (run >> 1, bits.div_ceil(8)),
        };
        // A run of none is possible, but a file of them is none.
        seen = seen.saturating_add(count.max(1));
        bytes = usize::try_from(size).ok().and_then(|size| rest.get(size..)).unwrap_or_default();
    }
    true
}

/// Checks the header of delta-coded values and returns their number.
fn deltas(values: &[u8]) -> Result<u64, Stop> {
    let mut thrift = Thrift::new(values);
    let (block, parts, count) = (thrift.varint()?, thrift.varint()?, thrift.varint()?);
    Limit::DeltaBlock.hold(block, DELTA_BLOCK_MAX)?;
    let part = block.checked_div(parts).ok_or(Broken)?;
    if block.is_multiple_of(128) && part > 0 && part.is_multiple_of(32) && part * parts == block {
        Ok(count)
    } else {
        Err(Stop::Broken)
    }
}

const DATA_PAGE: i64 = 0;
const INDEX_PAGE: i64 = 1;
const DICTIONARY_PAGE: i64 = 2;
const DATA_PAGE_V2: i64 = 3;

fn head(thrift: &mut Thrift<'_>) -> Result<Head, Stop> {
    let mut read = Head { is_packed: true, level_encoding: 3, ..Head::default() };
    thrift.structure(|thrift, id, kind| {
        match (id, kind) {
            (1, ThriftType::Integer) => read.kind = thrift.integer()?,
            (2, ThriftType::Integer) => read.unpacked = thrift.natural()?,
            (3, ThriftType::Integer) => read.packed = usize::try_from(thrift.natural()?).map_err(|_| Broken)?,
            (5 | 7, ThriftType::Struct) => thrift.structure(|thrift, id, kind| {
                match (id, kind) {
                    (1, ThriftType::Integer) => read.values = thrift.natural()?,
                    (2, ThriftType::Integer) => read.encoding = thrift.integer()?,
                    (3, ThriftType::Integer) => read.level_encoding = thrift.integer()?,
                    _ => thrift.skip(kind)?,
                }
                Ok(())
            })?,
            (8, ThriftType::Struct) => thrift.structure(|thrift, id, kind| {
                match (id, kind) {
                    (1, ThriftType::Integer) => read.values = thrift.natural()?,
                    (2, ThriftType::Integer) => read.nulls = thrift.natural()?,
                    (3, ThriftType::Integer) => read.rows = thrift.natural()?,
                    (4, ThriftType::Integer) => read.encoding = thrift.integer()?,
                    (5, ThriftType::Integer) => read.defined_bytes = thrift.natural()?,
                    (6, ThriftType::Integer) => read.repeated_bytes = thrift.natural()?,
                    (7, ThriftType::Bool(is_packed)) => read.is_packed = is_packed,
                    _ => thrift.skip(kind)?,
                }
                Ok(())
            })?,
            _ => thrift.skip(kind)?,
        }
        Ok(())
    })?;
    Ok(read)
}

fn encoding(code: i64) -> Result<Encoding, Fault> {
    #[expect(deprecated, reason = "old files have it")]
    Ok(match code {
        0 => Encoding::PLAIN,
        2 => Encoding::PLAIN_DICTIONARY,
        3 => Encoding::RLE,
        4 => Encoding::BIT_PACKED,
        5 => Encoding::DELTA_BINARY_PACKED,
        6 => Encoding::DELTA_LENGTH_BYTE_ARRAY,
        7 => Encoding::DELTA_BYTE_ARRAY,
        8 => Encoding::RLE_DICTIONARY,
        9 => Encoding::BYTE_STREAM_SPLIT,
        other => return Err(damaged(Damage::Encoding { name: other.to_string() })),
    })
}

fn count(number: u64) -> Result<u32, Fault> {
    u32::try_from(number).map_err(|_| damaged(Damage::Page))
}

impl Iterator for Pages {
    type Item = Result<Page, ParquetError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Pages {
    fn get_next_page(&mut self) -> Result<Option<Page>, ParquetError> {
        self.page().map_err(|fault| ParquetError::External(Box::new(fault)))
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>, ParquetError> {
        Err(ParquetError::NYI(String::from("pages are read one after another")))
    }

    fn skip_next_page(&mut self) -> Result<(), ParquetError> {
        Err(ParquetError::NYI(String::from("pages are read one after another")))
    }
}

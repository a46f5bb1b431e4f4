//! Pages of a Parquet column, checked before they are decoded.
//!
//! The decoders of the library take some of what a page says for granted and panic where it does not hold. What they
//! rely on is checked here, so that a damaged file is refused with a reason.

use ::parquet::basic::{Encoding, Type};
use ::parquet::column::page::{Page, PageMetadata, PageReader};
use ::parquet::errors::{ParquetError, Result};
use ::parquet::schema::types::ColumnDescPtr;

/// Passes on the pages that can be decoded.
pub(crate) struct CheckedPages {
    inner: Box<dyn PageReader>,
    column: ColumnDescPtr,
    has_dictionary: bool,
}

impl CheckedPages {
    pub(crate) fn new(inner: Box<dyn PageReader>, column: ColumnDescPtr) -> Self {
        Self { inner, column, has_dictionary: false }
    }

    fn check(&mut self, page: &Page) -> Result<()> {
        match page {
            Page::DictionaryPage { buf, num_values, .. } => {
                self.has_dictionary = true;
                let size = size_of_value(self.column.physical_type());
                known((*num_values as usize).saturating_mul(size) <= buf.len(), "a dictionary is shorter than it says")
            }
            Page::DataPage { buf, num_values, encoding, def_level_encoding, .. } => {
                let levels = self.level_bytes(buf, *num_values, *def_level_encoding)?;
                self.check_values(*encoding, buf.get(levels..))
            }
            Page::DataPageV2 { buf, encoding, def_levels_byte_len, rep_levels_byte_len, .. } => {
                let levels = u64::from(*def_levels_byte_len) + u64::from(*rep_levels_byte_len);
                let values = usize::try_from(levels).ok().and_then(|levels| buf.get(levels..));
                self.check_values(*encoding, values)
            }
        }
    }

    /// Length of the levels at the beginning of a page of the first version.
    fn level_bytes(&self, buf: &[u8], count: u32, encoding: Encoding) -> Result<usize> {
        let most = self.column.max_def_level();
        if most == 0 {
            return Ok(0);
        }
        match encoding {
            Encoding::RLE => {
                let length = buf.first_chunk().map(|length| i64::from(i32::from_le_bytes(*length)));
                let bytes = length.filter(|length| *length >= 0).and_then(|length| usize::try_from(length + 4).ok());
                bytes.ok_or_else(|| damaged("the length of levels is damaged"))
            }
            #[expect(deprecated, reason = "old files have it")]
            Encoding::BIT_PACKED => {
                let bits = u64::from(16 - most.leading_zeros()) * u64::from(count);
                usize::try_from(bits.div_ceil(8)).map_err(|_| damaged("the length of levels is damaged"))
            }
            _ => Err(damaged("levels have an encoding that is none for levels")),
        }
    }

    fn check_values(&self, encoding: Encoding, values: Option<&[u8]>) -> Result<()> {
        // Bits of an index; more do not fit into the 32 bits of an index.
        const INDEX_BITS_MAX: u8 = 32;
        let values = values.ok_or_else(|| damaged("a page is shorter than its levels"))?;
        match encoding {
            Encoding::RLE_DICTIONARY | Encoding::PLAIN_DICTIONARY => {
                known(self.has_dictionary, "a page refers to a dictionary that is not there")?;
                let bits = values.first().ok_or_else(|| damaged("a page of indices is empty"))?;
                known(*bits <= INDEX_BITS_MAX, "the indices of a page are too wide")
            }
            Encoding::BYTE_STREAM_SPLIT => {
                let size = size_of_value(self.column.physical_type());
                known(values.len() % size == 0, "the length of a page is no multiple of its values")
            }
            Encoding::PLAIN | Encoding::DELTA_BINARY_PACKED => Ok(()),
            other => Err(ParquetError::NYI(format!("encoding {other} of numbers"))),
        }
    }
}

fn damaged(reason: &str) -> ParquetError {
    ParquetError::General(reason.to_owned())
}

fn known(holds: bool, otherwise: &str) -> Result<()> {
    if holds { Ok(()) } else { Err(damaged(otherwise)) }
}

/// Bytes of a number.
const fn size_of_value(physical: Type) -> usize {
    match physical {
        Type::INT32 | Type::FLOAT => 4,
        _ => 8,
    }
}

impl Iterator for CheckedPages {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for CheckedPages {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let page = self.inner.get_next_page()?;
        if let Some(page) = &page {
            self.check(page)?;
        }
        Ok(page)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.inner.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.inner.skip_next_page()
    }
}

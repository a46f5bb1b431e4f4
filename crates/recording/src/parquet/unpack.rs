//! Decompression of a page to exactly its stated size.

use crate::faults::{Damage, Fault};
use crate::packed::Frames;
use std::io::Read;

/// Compression of the pages of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Codec {
    None,
    Snappy,
    Gzip,
    Brotli,
    /// Blocks preceded by their lengths; older files have frames or a bare block under the same number.
    Lz4,
    Zstd,
    Lz4Block,
}

impl Codec {
    /// Returns the codec with the given number in the format.
    pub(super) fn of(number: i64) -> Result<Self, Fault> {
        Ok(match number {
            0 => Self::None,
            1 => Self::Snappy,
            2 => Self::Gzip,
            4 => Self::Brotli,
            5 => Self::Lz4,
            6 => Self::Zstd,
            7 => Self::Lz4Block,
            other => {
                let name = if other == 3 { "LZO".to_owned() } else { other.to_string() };
                return Err(super::damaged(Damage::Compression { name }));
            }
        })
    }

    /// Appends the unpacked page to `into`. At most `size` bytes are produced, for any input.
    ///
    /// # Errors
    /// [`Damage::Packed`] if the page does not unpack to exactly `size` bytes.
    pub(super) fn unpack(self, packed: &[u8], size: usize, into: &mut Vec<u8>) -> Result<(), Fault> {
        let before = into.len();
        let whole = match self {
            Self::None => {
                into.extend_from_slice(packed.get(..size).unwrap_or_default());
                true
            }
            Self::Snappy => {
                snap::raw::decompress_len(packed).is_ok_and(|length| length == size)
                    && in_place(into, size, |room| snap::raw::Decoder::new().decompress(packed, room).ok())
            }
            Self::Gzip => streamed(flate2::read::MultiGzDecoder::new(packed), size, into),
            Self::Brotli => streamed(brotli_decompressor::Decompressor::new(packed, BROTLI_BUFFER), size, into),
            // A reader in Rust, so that a damaged file from outside reaches no C library.
            Self::Zstd => streamed(Frames::of(packed), size, into),
            Self::Lz4Block => lz4_block(packed, size, into),
            Self::Lz4 => {
                let mut ways = [hadoop, lz4_frame, lz4_block].into_iter();
                ways.any(|way| {
                    into.truncate(before);
                    way(packed, size, into)
                })
            }
        };
        if whole && into.len() - before == size { Ok(()) } else { Err(super::damaged(Damage::Packed)) }
    }
}

/// Buffer size of the brotli reader, in bytes.
const BROTLI_BUFFER: usize = 4096;

/// Unpacks into newly allocated room and returns `true` if it is filled.
fn in_place(into: &mut Vec<u8>, size: usize, unpack: impl FnOnce(&mut [u8]) -> Option<usize>) -> bool {
    let before = into.len();
    into.resize(before + size, 0);
    into.get_mut(before..).and_then(unpack) == Some(size)
}

/// Reads at most one byte beyond the size.
fn streamed(source: impl Read, size: usize, into: &mut Vec<u8>) -> bool {
    source.take(size as u64 + 1).read_to_end(into).is_ok()
}

fn lz4_block(packed: &[u8], size: usize, into: &mut Vec<u8>) -> bool {
    in_place(into, size, |room| lz4_flex::block::decompress_into(packed, room).ok())
}

fn lz4_frame(packed: &[u8], size: usize, into: &mut Vec<u8>) -> bool {
    streamed(lz4_flex::frame::FrameDecoder::new(packed), size, into)
}

/// Unpacks blocks, each preceded by its unpacked and its packed length as four bytes, the highest first.
fn hadoop(packed: &[u8], size: usize, into: &mut Vec<u8>) -> bool {
    let (mut rest, mut left) = (packed, size);
    while !rest.is_empty() {
        let Some((unpacked, behind)) = rest.split_first_chunk::<4>() else { return false };
        let Some((length, behind)) = behind.split_first_chunk::<4>() else { return false };
        let (unpacked, length) = (u32::from_be_bytes(*unpacked) as usize, u32::from_be_bytes(*length) as usize);
        let Some((block, behind)) = behind.split_at_checked(length) else { return false };
        if unpacked > left || !lz4_block(block, unpacked, into) {
            return false;
        }
        left -= unpacked;
        rest = behind;
    }
    left == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unpacked(codec: Codec, packed: &[u8], size: usize) -> Option<Vec<u8>> {
        let mut into = b"levels".to_vec();
        codec.unpack(packed, size, &mut into).ok()?;
        Some(into.split_off(6))
    }

    #[test]
    fn every_form_of_lz4_is_unpacked_and_no_byte_more() {
        let text = b"the same the same the same the same".repeat(9);
        let block = lz4_flex::block::compress(&text);
        let lengths = [text.len(), block.len()].map(|length| u32::try_from(length).unwrap().to_be_bytes());
        let hadoop = [lengths.as_flattened(), &block].concat();
        let mut frame = lz4_flex::frame::FrameEncoder::new(Vec::new());
        std::io::Write::write_all(&mut frame, &text).unwrap();
        let frame = frame.finish().unwrap();
        for packed in [&hadoop, &frame, &block] {
            assert_eq!(unpacked(Codec::Lz4, packed, text.len()).as_deref(), Some(text.as_slice()));
            assert_eq!(unpacked(Codec::Lz4, packed, text.len() - 1), None);
            assert_eq!(unpacked(Codec::Lz4, packed, text.len() + 1), None);
        }
        assert_eq!(unpacked(Codec::Lz4Block, &block, text.len()).as_deref(), Some(text.as_slice()));
    }

    #[test]
    fn what_unpacks_to_more_than_it_says_is_refused() {
        let zeros = vec![0; 1 << 20];
        let zstd = zstd::bulk::compress(&zeros, 3).unwrap();
        let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::best());
        std::io::Write::write_all(&mut gzip, &zeros).unwrap();
        let gzip = gzip.finish().unwrap();
        let snappy = snap::raw::Encoder::new().compress_vec(&zeros).unwrap();
        for (codec, packed) in [(Codec::Zstd, &zstd), (Codec::Gzip, &gzip), (Codec::Snappy, &snappy)] {
            assert_eq!(unpacked(codec, packed, zeros.len()), Some(zeros.clone()), "{codec:?}");
            assert_eq!(unpacked(codec, packed, 1000), None, "{codec:?}");
            assert_eq!(unpacked(codec, packed, zeros.len() + 1), None, "{codec:?}");
        }
    }

    /// The reader in Rust accepts the same input as the C library: several frames, one cut short, one damaged, one
    /// without end.
    #[test]
    fn both_readers_of_zstd_agree() {
        fn ours(packed: &[u8], size: usize, into: &mut Vec<u8>) -> bool {
            streamed(Frames::of(packed), size, into)
        }
        fn in_c(packed: &[u8], size: usize, into: &mut Vec<u8>) -> bool {
            let before = into.len();
            into.reserve_exact(size);
            let mut room = std::io::Cursor::new(&mut *into);
            room.set_position(before as u64);
            zstd::bulk::Decompressor::new().and_then(|mut with| with.decompress_to_buffer(packed, &mut room)).is_ok()
        }
        let text: Vec<u8> = (0..90_000_u32).flat_map(|number| (number / 7 * 13).to_le_bytes()).collect();
        for level in [-5, 1, 3, 9, 19] {
            let frame = zstd::bulk::compress(&text, level).unwrap();
            let frames = [&frame[..], &zstd::bulk::compress(b"and more", level).unwrap()].concat();
            let mut damaged = frame.clone();
            damaged[frame.len() / 2] ^= 0xff;
            for packed in [&frame[..], &frames, &frame[..frame.len() - 1], &damaged, b"", b"nothing"] {
                for size in [text.len(), text.len() + 8, text.len() - 1, text.len() + 1] {
                    let read = |with: fn(&[u8], usize, &mut Vec<u8>) -> bool| {
                        let mut into = b"levels".to_vec();
                        (with(packed, size, &mut into) && into.len() == size + 6).then_some(into)
                    };
                    let (ours, theirs) = (read(ours), read(in_c));
                    if packed == damaged && theirs.is_some() {
                        continue;
                    }
                    assert!(ours == theirs, "level {level}, {} of {size} bytes", packed.len());
                }
            }
        }
    }
}

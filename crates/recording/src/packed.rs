//! Texts that are packed as a whole: `run.csv.gz`, `run.csv.zst`.

use std::io::{Read, Result};

/// How a file is packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// gzip (RFC 1952), of one member or several.
    Gzip,
    /// Zstandard (RFC 8878).
    Zstd,
}

/// What a packed file holds, unpacked while it is read: its reader bounds how much that is.
///
/// # Errors
/// What the source says at the beginning.
pub fn unpacked(source: Box<dyn Read>, packing: Packing) -> Result<Box<dyn Read>> {
    match packing {
        Packing::Gzip => Ok(Box::new(flate2::read::MultiGzDecoder::new(source))),
        Packing::Zstd => zstd_frames(source),
    }
}

/// Larger windows of a frame are refused, as 2 to this power: memory is bounded however the file is packed.
#[cfg(not(target_family = "wasm"))]
const WINDOW_LOG_MAX: u32 = 25;

#[cfg(not(target_family = "wasm"))]
fn zstd_frames(source: Box<dyn Read>) -> Result<Box<dyn Read>> {
    let mut frames = zstd::stream::read::Decoder::new(source)?;
    frames.window_log_max(WINDOW_LOG_MAX)?;
    Ok(Box::new(frames))
}

#[cfg(target_family = "wasm")]
fn zstd_frames(source: Box<dyn Read>) -> Result<Box<dyn Read>> {
    let frames = ruzstd::decoding::StreamingDecoder::new(source);
    frames.map(|frames| Box::new(frames) as Box<dyn Read>).map_err(std::io::Error::other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    #[test]
    fn a_packed_text_is_the_text() {
        let text = "t [s],q [deg]\n0,0\n1,1\n2,2\n".repeat(1000);
        let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        gzip.write_all(text.as_bytes()).unwrap();
        let zstd = zstd::bulk::compress(text.as_bytes(), 3).unwrap();
        for (packed, packing) in [(gzip.finish().unwrap(), Packing::Gzip), (zstd, Packing::Zstd)] {
            let mut found = String::new();
            let source = Box::new(std::io::Cursor::new(packed.clone()));
            unpacked(source, packing).unwrap().read_to_string(&mut found).unwrap();
            assert_eq!(found, text);
            let half = Box::new(std::io::Cursor::new(packed[..packed.len() / 2].to_vec()));
            assert!(unpacked(half, packing).unwrap().read_to_end(&mut Vec::new()).is_err(), "a damaged file");
        }
    }
}

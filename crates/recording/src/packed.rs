//! Content detection by the first bytes, and text packed as a whole: `run.csv.gz`, `run.csv.zst`.

use flate2::bufread::GzDecoder;
use ruzstd::decoding::errors::{FrameDecoderError, ReadFrameHeaderError};
use ruzstd::decoding::{BlockDecodingStrategy, FrameDecoder};
use std::io::{BufRead, BufReader, Chain, Cursor, ErrorKind, Read, Result};

/// Packing of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// gzip (RFC 1952), of one member or several.
    Gzip,
    /// Zstandard (RFC 8878).
    Zstd,
}

/// Content of a file by its first bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Parquet.
    Parquet,
    /// Packed.
    Packed(Packing),
    /// Another format.
    Foreign(Foreign),
    /// Anything else, read as text.
    Text,
}

/// A format that is no recording but may contain one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Foreign {
    /// A workbook of a spreadsheet (`.xlsx`, `.ods`) or another zip archive.
    Zip,
    /// A workbook of an old spreadsheet (`.xls`).
    Xls,
    /// A MAT file of MATLAB up to version 7.
    Mat,
    /// HDF5, which MAT files of version 7.3 are too.
    Hdf5,
    /// TDMS of LabVIEW.
    Tdms,
    /// MDF of measuring systems (`.mf4`, `.mdf`).
    Mdf,
    /// Arrow or Feather.
    Arrow,
    /// A bag of ROS or MCAP.
    Bag,
    /// SQLite, which bags of ROS 2 are too.
    Sqlite,
    /// PDF.
    Pdf,
    /// Text or data packed with bzip2, xz or 7-Zip.
    Packed,
    /// An array of NumPy.
    Npy,
    /// JSON, also one value a line.
    Json,
    /// XML or HTML, as some programs write it for a workbook.
    Markup,
    /// ORC.
    Orc,
    /// Avro.
    Avro,
    /// Text in UTF-32.
    Utf32,
}

impl Foreign {
    /// The formats, in the order of their detection.
    pub const ALL: [Self; 17] = [
        Self::Zip,
        Self::Xls,
        Self::Mat,
        Self::Hdf5,
        Self::Tdms,
        Self::Mdf,
        Self::Arrow,
        Self::Bag,
        Self::Sqlite,
        Self::Pdf,
        Self::Packed,
        Self::Npy,
        Self::Json,
        Self::Markup,
        Self::Orc,
        Self::Avro,
        Self::Utf32,
    ];
}

/// First bytes of a file and the content they indicate.
const MARKS: [(&[u8], Content); 25] = [
    (b"PAR1", Content::Parquet),
    (b"\x1f\x8b", Content::Packed(Packing::Gzip)),
    (b"\x28\xb5\x2f\xfd", Content::Packed(Packing::Zstd)),
    (b"PK\x03\x04", Content::Foreign(Foreign::Zip)),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", Content::Foreign(Foreign::Xls)),
    (b"MATLAB 5.0 MAT", Content::Foreign(Foreign::Mat)),
    (b"MATLAB 7.3 MAT", Content::Foreign(Foreign::Hdf5)),
    (b"\x89HDF\r\n\x1a\n", Content::Foreign(Foreign::Hdf5)),
    (b"TDSm", Content::Foreign(Foreign::Tdms)),
    (b"MDF     ", Content::Foreign(Foreign::Mdf)),
    (b"ARROW1", Content::Foreign(Foreign::Arrow)),
    (b"FEA1", Content::Foreign(Foreign::Arrow)),
    (b"#ROSBAG", Content::Foreign(Foreign::Bag)),
    (b"\x89MCAP0", Content::Foreign(Foreign::Bag)),
    (b"SQLite format 3", Content::Foreign(Foreign::Sqlite)),
    (b"%PDF-", Content::Foreign(Foreign::Pdf)),
    (b"BZh", Content::Foreign(Foreign::Packed)),
    (b"\xfd7zXZ\0", Content::Foreign(Foreign::Packed)),
    (b"7z\xbc\xaf\x27\x1c", Content::Foreign(Foreign::Packed)),
    (b"\x93NUMPY", Content::Foreign(Foreign::Npy)),
    (b"ORC", Content::Foreign(Foreign::Orc)),
    (b"Obj\x01", Content::Foreign(Foreign::Avro)),
    (b"\xff\xfe\0\0", Content::Foreign(Foreign::Utf32)),
    (b"\0\0\xfe\xff", Content::Foreign(Foreign::Utf32)),
    (b"<?xml", Content::Foreign(Foreign::Markup)),
];

/// Returns the format of a text that begins like JSON, XML or HTML: a bracket before a quote or another bracket, a tag.
fn marked_up(head: &[u8]) -> Option<Foreign> {
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head).trim_ascii_start();
    let (first, rest) = text.split_first()?;
    let next = rest.trim_ascii_start().first();
    match first {
        b'{' if next == Some(&b'"') => Some(Foreign::Json),
        b'[' if next.is_some_and(|next| b"[{".contains(next)) => Some(Foreign::Json),
        b'<' if rest.first().is_some_and(|sign| sign.is_ascii_alphabetic() || b"?!".contains(sign)) => {
            Some(Foreign::Markup)
        }
        _ => None,
    }
}

/// Number of bytes examined.
const HEAD: u64 = 16;

/// A source after examination of its first bytes; reads from its beginning.
pub type Sniffed = Chain<Cursor<Vec<u8>>, Box<dyn Read>>;

/// Determines the content of a file from its first bytes, behind gzip or Zstandard; the source returned reads from the beginning and
/// unpacks while it reads, so that its reader bounds the size. A file packed twice remains [`Content::Packed`].
///
/// # Errors
/// Errors of the source at its beginning.
pub fn opened(source: Box<dyn Read>) -> Result<(Content, Sniffed)> {
    match sniffed(source)? {
        (Content::Packed(packing), source) => sniffed(unpacked(Box::new(source), packing)),
        found => Ok(found),
    }
}

/// Determines the content of a source from its first bytes; the source returned reads from its beginning.
fn sniffed(mut source: Box<dyn Read>) -> Result<(Content, Sniffed)> {
    let mut head = Vec::new();
    let _ = source.by_ref().take(HEAD).read_to_end(&mut head)?;
    let found = MARKS.iter().find(|(mark, _)| head.starts_with(mark));
    let text = || marked_up(&head).map_or(Content::Text, Content::Foreign);
    let content = found.map_or_else(text, |(_, content)| *content);
    Ok((content, Cursor::new(head).chain(source)))
}

/// Unpacks a packed file while it is read; the reader bounds the size.
fn unpacked(source: Box<dyn Read>, packing: Packing) -> Box<dyn Read> {
    match packing {
        Packing::Gzip => Box::new(Members::of(source)),
        Packing::Zstd => Box::new(Frames::of(source)),
    }
}

/// Reader of consecutive gzip members. Zeros after the last one fill a block of a tape; anything else there is damage.
struct Members<R> {
    /// Current member; `None` after the last one.
    member: Option<GzDecoder<BufReader<R>>>,
}

impl<R: Read> Members<R> {
    fn of(source: R) -> Self {
        Self { member: Some(GzDecoder::new(BufReader::new(source))) }
    }

    /// Begins the next member; returns `false` at the end.
    fn begin(&mut self) -> Result<bool> {
        let Some(mut source) = self.member.take().map(GzDecoder::into_inner) else { return Ok(false) };
        loop {
            let found = source.fill_buf()?;
            let zeros = found.iter().take_while(|byte| **byte == 0).count();
            match found.get(zeros) {
                None if zeros == 0 => return Ok(false),
                None => source.consume(zeros),
                Some(0x1f) if zeros == 0 => {
                    self.member = Some(GzDecoder::new(source));
                    return Ok(true);
                }
                Some(_) => return Err(ErrorKind::InvalidData.into()),
            }
        }
    }
}

impl<R: Read> Read for Members<R> {
    fn read(&mut self, room: &mut [u8]) -> Result<usize> {
        while let Some(member) = self.member.as_mut().filter(|_| !room.is_empty()) {
            match member.read(room) {
                Ok(0) => {
                    let _ = self.begin()?;
                }
                Ok(count) => return Ok(count),
                // A wrong checksum, a damaged header.
                Err(error) if error.kind() == ErrorKind::InvalidInput => return Err(ErrorKind::InvalidData.into()),
                Err(error) => return Err(error),
            }
        }
        Ok(0)
    }
}

/// Maximum window of a frame, in bytes, which bounds the memory for any file.
const WINDOW_MAX: u64 = 32 << 20;

/// Reader of consecutive Zstandard frames.
pub(crate) struct Frames<R> {
    source: Pushed<R>,
    frames: FrameDecoder,
    is_open: bool,
    /// Bytes of the current frame that were read.
    read: u64,
}

/// A source with a byte put back in front.
struct Pushed<R> {
    byte: Option<u8>,
    source: R,
}

impl<R: Read> Read for Pushed<R> {
    fn read(&mut self, room: &mut [u8]) -> Result<usize> {
        match (self.byte, room.first_mut()) {
            (Some(byte), Some(first)) => {
                (*first, self.byte) = (byte, None);
                Ok(1)
            }
            (Some(_), None) => Ok(0),
            (None, _) => self.source.read(room),
        }
    }
}

impl<R: Read> Frames<R> {
    pub(crate) fn of(source: R) -> Self {
        Self { source: Pushed { byte: None, source }, frames: FrameDecoder::new(), is_open: false, read: 0 }
    }

    /// Begins the next frame with content; returns `false` at the end.
    fn begin(&mut self) -> Result<bool> {
        let mut first = [0];
        while self.source.read(&mut first)? > 0 {
            self.source.byte = first.first().copied();
            self.frames.set_max_window_size(WINDOW_MAX);
            match self.frames.reset(&mut self.source) {
                Ok(()) => return Ok(true),
                Err(FrameDecoderError::ReadFrameHeaderError(ReadFrameHeaderError::SkipFrame { length, .. })) => {
                    let _ = std::io::copy(&mut self.source.by_ref().take(length.into()), &mut std::io::sink())?;
                }
                Err(error) => return Err(damage(&error)),
            }
        }
        Ok(false)
    }

    /// Compares the finished frame with the checksum and the size that it states.
    fn check(&self) -> Result<()> {
        let stated = self.frames.get_checksum_from_data();
        let is_whole = stated.is_none() || stated == self.frames.get_calculated_checksum();
        let size = self.frames.content_size();
        if is_whole && (size == 0 || size == self.read) { Ok(()) } else { Err(ErrorKind::InvalidData.into()) }
    }
}

/// Returns the kind of a fault of a packed file, without the words of the library: the file ends too early, or its data
/// are damaged. Errors of the source stay as they are.
fn damage(error: &(dyn std::error::Error + 'static)) -> std::io::Error {
    let mut causes = std::iter::successors(Some(error), |error| error.source());
    match causes.find_map(|cause| cause.downcast_ref::<std::io::Error>()) {
        Some(cause) => cause.kind().into(),
        None => ErrorKind::InvalidData.into(),
    }
}

impl<R: Read> Read for Frames<R> {
    fn read(&mut self, room: &mut [u8]) -> Result<usize> {
        while !room.is_empty() {
            if !self.is_open {
                self.is_open = self.begin()?;
                self.read = 0;
                if !self.is_open {
                    return Ok(0);
                }
            }
            while self.frames.can_collect() < room.len() && !self.frames.is_finished() {
                let wanted = BlockDecodingStrategy::UptoBytes(room.len() - self.frames.can_collect());
                let _ = self.frames.decode_blocks(&mut self.source, wanted).map_err(|error| damage(&error))?;
            }
            let count = self.frames.read(room)?;
            if count > 0 {
                self.read += count as u64;
                return Ok(count);
            }
            self.check()?;
            self.is_open = false;
        }
        Ok(0)
    }
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
        // A skippable frame stands in between.
        let skipped: &[u8] = b"\x50\x2a\x4d\x18\x03\x00\x00\x00abc";
        let two = [
            zstd::bulk::compress(&text.as_bytes()[..100], 3).unwrap(),
            skipped.to_vec(),
            zstd::bulk::compress(&text.as_bytes()[100..], 9).unwrap(),
        ]
        .concat();
        for (packed, packing) in [(gzip.finish().unwrap(), Packing::Gzip), (zstd, Packing::Zstd), (two, Packing::Zstd)]
        {
            let mut found = String::new();
            let source: Box<dyn Read> = Box::new(Cursor::new(packed.clone()));
            let (content, source) = sniffed(source).unwrap();
            assert_eq!(content, Content::Packed(packing));
            unpacked(Box::new(source), packing).read_to_string(&mut found).unwrap();
            assert_eq!(found, text);
            let (content, mut source) = opened(Box::new(Cursor::new(packed.clone()))).unwrap();
            found.clear();
            source.read_to_string(&mut found).unwrap();
            assert_eq!((content, &found), (Content::Text, &text));
            let half = Box::new(Cursor::new(packed[..packed.len() / 2].to_vec()));
            assert!(unpacked(half, packing).read_to_end(&mut Vec::new()).is_err(), "a damaged file");
        }
    }

    /// Members of gzip and zeros after them are read; anything else after them, and a wrong checksum, are damage and no early
    /// end.
    #[test]
    fn bytes_after_the_last_member_are_damage() {
        let packed = |text: &str| {
            let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
            gzip.write_all(text.as_bytes()).unwrap();
            gzip.finish().unwrap()
        };
        let read = |bytes: Vec<u8>| {
            let mut text = String::new();
            opened(Box::new(Cursor::new(bytes)))
                .and_then(|(_, mut source)| source.read_to_string(&mut text))
                .map(|_| text)
                .map_err(|error| error.kind())
        };
        let whole = packed("0,1\n");
        let with = |more: &[u8]| [&whole[..], more].concat();
        assert_eq!(read(with(&packed("2,3\n"))).as_deref(), Ok("0,1\n2,3\n"));
        assert_eq!(read(with(&[0; 10_000])).as_deref(), Ok("0,1\n"));
        for more in [&b"x"[..], b"\0\0x", b"more text than a header", b"\x1fno member at all"] {
            assert_eq!(read(with(more)), Err(ErrorKind::InvalidData), "{more:?}");
        }
        let mut wrong = whole.clone();
        let checksum = wrong.len() - 8;
        wrong[checksum] ^= 1;
        assert_eq!(read(wrong), Err(ErrorKind::InvalidData));
        assert_eq!(read(whole[..whole.len() - 3].to_vec()), Err(ErrorKind::UnexpectedEof));
    }

    /// A bit that flips anywhere in a frame with a checksum is damage, never another text; so is a frame that ends early.
    #[test]
    fn no_flipped_bit_gives_another_text() {
        let rows: String = (0..400).map(|row| format!("{row},{}\n", (row * 37) % 101)).collect();
        let mut packer = zstd::bulk::Compressor::new(3).unwrap();
        packer.set_parameter(zstd::zstd_safe::CParameter::ChecksumFlag(true)).unwrap();
        let whole = packer.compress(rows.as_bytes()).unwrap();
        let read = |bytes: Vec<u8>| {
            let mut text = Vec::new();
            Frames::of(Cursor::new(bytes)).read_to_end(&mut text).map(|_| text).map_err(|error| error.kind())
        };
        assert_eq!(read(whole.clone()).as_deref(), Ok(rows.as_bytes()));
        // The first bytes say what the file is; a frame that may be skipped is none with content.
        for place in 4..whole.len() {
            for bit in 0..8 {
                let mut wrong = whole.clone();
                wrong[place] ^= 1 << bit;
                let found = read(wrong);
                assert!(found.is_err() || found.as_deref() == Ok(rows.as_bytes()), "byte {place}, bit {bit}");
            }
        }
        for end in 5..whole.len() {
            let found = read(whole[..end].to_vec());
            assert!(matches!(found, Err(ErrorKind::UnexpectedEof | ErrorKind::InvalidData)), "{end}: {found:?}");
        }
    }

    #[test]
    fn other_formats_are_known_by_their_beginning() {
        for (text, format) in [
            (&b"BZh91AY&SY"[..], Foreign::Packed),
            (b"\xfd7zXZ\0\0\x04", Foreign::Packed),
            (b"7z\xbc\xaf\x27\x1c\0\x04", Foreign::Packed),
            (b"\x93NUMPY\x01\0v\0{", Foreign::Npy),
            (b"{\"t\": [0, 1]}", Foreign::Json),
            (b"{ \"t\":0}\n{\"t\":1}", Foreign::Json),
            (b"[\n  {\"t\": 0}]", Foreign::Json),
            (b"[[0, 1], [0, 2]]", Foreign::Json),
            (b"<?xml version=\"1.0\"?>", Foreign::Markup),
            (b"\xef\xbb\xbf<html>", Foreign::Markup),
            (b"<!DOCTYPE html>", Foreign::Markup),
            (b"\n<table>", Foreign::Markup),
            (b"ORC\x08\x01", Foreign::Orc),
            (b"Obj\x01\x04", Foreign::Avro),
            (b"\xff\xfe\0\0t\0\0\0", Foreign::Utf32),
        ] {
            let (content, _) = sniffed(Box::new(Cursor::new(text.to_vec()))).unwrap();
            assert_eq!(content, Content::Foreign(format), "{text:?}");
        }
    }

    #[test]
    fn a_text_is_a_text_however_short() {
        for text in ["", "t", "t;q\n", "PA", "Zeit", "[s];[deg]\n", "{t};{q}\n", "<1;2\n", "OR", "B"] {
            let (content, mut source) = sniffed(Box::new(Cursor::new(text.as_bytes().to_vec()))).unwrap();
            let mut found = String::new();
            source.read_to_string(&mut found).unwrap();
            assert_eq!((content, found.as_str()), (Content::Text, text));
        }
    }
}

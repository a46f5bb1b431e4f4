//! Text encodings of controllers: UTF-8, UTF-16 with or without byte order mark, and Windows-1252 for text that is no
//! UTF-8.

use crate::series::Encoding;
use std::borrow::Cow;
use std::io::Read;

/// Buffer size for UTF-16 input, in bytes.
const RAW_BYTES: usize = 1 << 14;

/// Adapter that converts UTF-16 to UTF-8 and passes all other bytes through.
pub(crate) struct Utf8<R> {
    source: R,
    form: Form,
    /// Converted bytes not yet delivered.
    ready: Vec<u8>,
    given: usize,
    encoding: Encoding,
}

enum Form {
    /// The bytes read so far, before the encoding is known.
    Unknown(Vec<u8>),
    Bytes,
    Utf16 {
        little: bool,
        raw: Vec<u8>,
        /// First byte of an incomplete code unit, and first unit of an incomplete surrogate pair.
        half: Option<u8>,
        high: Option<u16>,
    },
}

impl<R: Read> Utf8<R> {
    pub(crate) const fn new(source: R) -> Self {
        Self { source, form: Form::Unknown(Vec::new()), ready: Vec::new(), given: 0, encoding: Encoding::Utf8 }
    }

    /// Returns the encoding; valid once the first bytes were read.
    pub(crate) const fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// Determines the encoding from the first two bytes.
    fn decide(&mut self) -> std::io::Result<()> {
        while let Form::Unknown(head) = &mut self.form {
            let mut byte = [0];
            let ended = head.len() < 2 && self.source.read(&mut byte)? == 0;
            if head.len() < 2 && !ended {
                head.extend(byte);
                continue;
            }
            let head = std::mem::take(head);
            // Text in UTF-8 contains no zero byte, and a header begins with a letter whose UTF-16 code contains one.
            let (little, encoding) = match *head.as_slice() {
                [0xff, 0xfe] => (true, Encoding::Utf16),
                [0xfe, 0xff] => (false, Encoding::Utf16),
                [1..=u8::MAX, 0] => (true, Encoding::Utf16Guessed),
                [0, 1..=u8::MAX] => (false, Encoding::Utf16Guessed),
                _ => {
                    self.ready = head;
                    self.form = Form::Bytes;
                    continue;
                }
            };
            if encoding == Encoding::Utf16Guessed
                && let [first, second] = *head.as_slice()
            {
                // Without a byte order mark the first two bytes are a letter.
                let unit = if little { [first, second] } else { [second, first] };
                self.ready = String::from_utf16_lossy(&[u16::from_le_bytes(unit)]).into_bytes();
            }
            self.encoding = encoding;
            self.form = Form::Utf16 { little, raw: vec![0; RAW_BYTES], half: None, high: None };
        }
        Ok(())
    }

    /// Converts the next part; returns `false` at the end.
    fn translate(&mut self) -> std::io::Result<bool> {
        let Form::Utf16 { little, raw, half, high } = &mut self.form else { return Ok(false) };
        let count = self.source.read(raw)?;
        self.ready.clear();
        self.given = 0;
        let mut put = |text: char| {
            let mut bytes = [0; 4];
            self.ready.extend(text.encode_utf8(&mut bytes).as_bytes());
        };
        if count == 0 {
            // The file ends in the middle of a character.
            let (half, high) = (half.take(), high.take());
            if half.is_some() || high.is_some() {
                put(char::REPLACEMENT_CHARACTER);
            }
            return Ok(!self.ready.is_empty());
        }
        for byte in raw.iter().take(count).copied() {
            let Some(first) = half.take() else {
                *half = Some(byte);
                continue;
            };
            let pair = [first, byte];
            let unit = if *little { u16::from_le_bytes(pair) } else { u16::from_be_bytes(pair) };
            match (high.take(), unit) {
                (None, 0xd800..=0xdbff) => *high = Some(unit),
                (None, _) => put(char::from_u32(unit.into()).unwrap_or(char::REPLACEMENT_CHARACTER)),
                (Some(first), _) => {
                    for each in char::decode_utf16([first, unit]) {
                        put(each.unwrap_or(char::REPLACEMENT_CHARACTER));
                    }
                }
            }
        }
        Ok(true)
    }
}

impl<R: Read> Read for Utf8<R> {
    fn read(&mut self, room: &mut [u8]) -> std::io::Result<usize> {
        self.decide()?;
        loop {
            let rest = self.ready.get(self.given..).unwrap_or_default();
            if !rest.is_empty() {
                let count = rest.len().min(room.len());
                room.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
                self.given += count;
                return Ok(count);
            }
            if matches!(self.form, Form::Bytes) {
                return self.source.read(room);
            }
            if !self.translate()? {
                return Ok(0);
            }
        }
    }
}

/// Reads a whole text without its byte order mark and returns it with its encoding.
///
/// # Errors
/// Errors of the source.
pub fn read_text(source: impl Read) -> std::io::Result<(String, Encoding)> {
    let (mut utf8, mut bytes) = (Utf8::new(source), Vec::new());
    utf8.read_to_end(&mut bytes)?;
    let encoding = if std::str::from_utf8(&bytes).is_ok() { utf8.encoding() } else { Encoding::Windows1252Guessed };
    let whole = text(&bytes);
    Ok((whole.strip_prefix('\u{feff}').unwrap_or(&whole).to_owned(), encoding))
}

/// Characters of Windows-1252 at 0x80 to 0x9f, control characters in Latin-1; gaps are returned as such.
const WINDOWS: [char; 32] = [
    '€', '\u{fffd}', '‚', 'ƒ', '\u{201e}', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{fffd}', 'Ž', '\u{fffd}',
    '\u{fffd}', '‘', '’', '\u{201c}', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{fffd}', 'ž', 'Ÿ',
];

/// Decodes bytes as UTF-8, or as Windows-1252 if they are no UTF-8; in the latter each byte is one character, such as
/// `°` and `²`.
pub(crate) fn text(bytes: &[u8]) -> Cow<'_, str> {
    let windows = |byte: &u8| match byte {
        0x80..=0x9f => WINDOWS.get(usize::from(byte - 0x80)).copied().unwrap_or(char::REPLACEMENT_CHARACTER),
        byte => char::from(*byte),
    };
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(windows).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Source that delivers its bytes one by one.
    struct Slow<'b>(&'b [u8]);

    impl Read for Slow<'_> {
        fn read(&mut self, room: &mut [u8]) -> std::io::Result<usize> {
            match (self.0.split_first(), room.first_mut()) {
                (Some((first, rest)), Some(to)) => {
                    *to = *first;
                    self.0 = rest;
                    Ok(1)
                }
                _ => Ok(0),
            }
        }
    }

    fn all(bytes: &[u8]) -> String {
        let mut text = String::new();
        Utf8::new(Slow(bytes)).read_to_string(&mut text).unwrap();
        let mut whole = String::new();
        Utf8::new(bytes).read_to_string(&mut whole).unwrap();
        assert_eq!(text, whole);
        text
    }

    #[test]
    fn utf16_of_both_orders_is_translated() {
        let text = "Zeit [s];φ [°]\n0;1,5\n🛠";
        let units: Vec<u16> = [0xfeff].into_iter().chain(text.encode_utf16()).collect();
        let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
        let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
        assert_eq!((all(&little), all(&big)), (text.to_owned(), text.to_owned()));
        assert_eq!(all(&little[..little.len() - 1]), text.replace('🛠', "\u{fffd}"));
        // Without byte order mark.
        assert_eq!((all(&little[2..]), all(&big[2..])), (text.to_owned(), text.to_owned()));
    }

    #[test]
    fn other_bytes_go_through_as_they_are() {
        for bytes in ["", "a", "ab", "t;q\n", "\u{feff}t"] {
            assert_eq!(all(bytes.as_bytes()), bytes);
        }
        assert_eq!(text(b"q [\xb0]"), "q [°]");
        assert_eq!(text(b"5 \x80, \x8a\x9d"), "5 €, Š\u{fffd}");
        assert_eq!(text("q [°]".as_bytes()), "q [°]");
    }
}

//! Texts as controllers write them: UTF-8, UTF-16 with its mark at the beginning, and Latin-1 in what is no UTF-8.

use std::borrow::Cow;
use std::io::Read;

/// Most bytes of UTF-16 that are held at a time.
const RAW_BYTES: usize = 1 << 14;

/// A source as UTF-8: UTF-16 with a mark is translated, everything else goes through as it is.
pub(crate) struct Utf8<R> {
    source: R,
    form: Form,
    /// Translated and not yet given.
    ready: Vec<u8>,
    given: usize,
}

enum Form {
    /// Nothing is known yet; the bytes read so far.
    Unknown(Vec<u8>),
    Bytes,
    Utf16 {
        little: bool,
        raw: Vec<u8>,
        /// The first half of a byte pair, and the first of a pair of units.
        half: Option<u8>,
        high: Option<u16>,
    },
}

impl<R: Read> Utf8<R> {
    pub(crate) const fn new(source: R) -> Self {
        Self { source, form: Form::Unknown(Vec::new()), ready: Vec::new(), given: 0 }
    }

    /// Looks at the first two bytes.
    fn decide(&mut self) -> std::io::Result<()> {
        while let Form::Unknown(head) = &mut self.form {
            let mut byte = [0];
            let ended = head.len() < 2 && self.source.read(&mut byte)? == 0;
            if head.len() < 2 && !ended {
                head.extend(byte);
                continue;
            }
            let head = std::mem::take(head);
            let little = head == [0xff, 0xfe];
            if little || head == [0xfe, 0xff] {
                self.form = Form::Utf16 { little, raw: vec![0; RAW_BYTES], half: None, high: None };
            } else {
                self.ready = head;
                self.form = Form::Bytes;
            }
        }
        Ok(())
    }

    /// Translates the next part; false at the end.
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
            // A file that ends in the middle of a character.
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

/// A text that is UTF-8, or else Latin-1: in that each byte is a character, `°` and `²` among them.
pub(crate) fn text(bytes: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().copied().map(char::from).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives its bytes one by one.
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
    }

    #[test]
    fn other_bytes_go_through_as_they_are() {
        for bytes in ["", "a", "ab", "t;q\n", "\u{feff}t"] {
            assert_eq!(all(bytes.as_bytes()), bytes);
        }
        assert_eq!(text(b"q [\xb0]"), "q [°]");
        assert_eq!(text("q [°]".as_bytes()), "q [°]");
    }
}

//! Text of a file in another encoding than UTF-8, as far as it can be read.

use crate::{Diagnostic, Fault};
use std::borrow::Cow;

/// Number of bytes at the start of a file by which UTF-16 without a mark is recognised.
const PROBED: usize = 64;

/// Returns the text of a file; one that is no UTF-8 is read as UTF-16, or its faulty bytes as Latin-1, and the fault is
/// reported with its place.
#[must_use]
pub fn decoded(bytes: &[u8]) -> (Cow<'_, str>, Option<Diagnostic>) {
    if let Some(text) = utf_16(bytes) {
        let fault = Diagnostic::at(&text, 0..0, Fault::NotUtf8 { byte: None }, None);
        return (Cow::Owned(text), Some(fault));
    }
    let error = match std::str::from_utf8(bytes) {
        Ok(text) => return (Cow::Borrowed(text), None),
        Err(error) => error,
    };
    let start = error.valid_up_to();
    let byte = bytes.get(start).copied();
    let mut text = String::with_capacity(bytes.len() + 16);
    for chunk in bytes.utf8_chunks() {
        text.push_str(chunk.valid());
        text.extend(chunk.invalid().iter().map(|byte| latin_1(*byte)));
    }
    let end = start + byte.map_or(0, |byte| latin_1(byte).len_utf8());
    let fault = Diagnostic::at(&text, start..end, Fault::NotUtf8 { byte }, None);
    (Cow::Owned(text), Some(fault))
}

/// Returns the character of a byte in Latin-1; the control characters of the second half are none of a text.
const fn latin_1(byte: u8) -> char {
    if matches!(byte, 0x80..=0x9f) { char::REPLACEMENT_CHARACTER } else { byte as char }
}

/// Returns a text in UTF-16, with a mark or with a zero in every second byte.
fn utf_16(bytes: &[u8]) -> Option<String> {
    let zeros = |first: usize| {
        let probed = bytes.iter().take(PROBED).skip(first).step_by(2);
        probed.clone().count() > 1 && probed.clone().filter(|byte| **byte == 0).count() * 2 > probed.count()
    };
    let (is_big, skipped) = match bytes {
        [0xff, 0xfe, ..] => (false, 2),
        [0xfe, 0xff, ..] => (true, 2),
        _ if zeros(1) => (false, 0),
        _ if zeros(0) => (true, 0),
        _ => return None,
    };
    let units = bytes.get(skipped..).unwrap_or_default().chunks(2).map(|pair| match pair {
        [a, b] if is_big => u16::from_be_bytes([*a, *b]),
        [a, b] => u16::from_le_bytes([*a, *b]),
        _ => u16::from(b'\n'),
    });
    Some(char::decode_utf16(units).map(|unit| unit.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "format = 1\n# für die Achse\n[load]\ninertia = \"1 kg m²\"\n";

    /// A text in UTF-16, of either order, with or without a mark, is read completely and has one fault.
    #[test]
    fn utf_16_is_read_with_one_fault() {
        for is_big in [false, true] {
            for mark in ["", "\u{feff}"] {
                let units = mark.encode_utf16().chain(TEXT.encode_utf16());
                let bytes: Vec<u8> =
                    units.flat_map(|unit| if is_big { unit.to_be_bytes() } else { unit.to_le_bytes() }).collect();
                let (text, fault) = decoded(&bytes);
                assert_eq!(text, TEXT, "{is_big} {mark:?}");
                assert_eq!(fault.unwrap().fault, Fault::NotUtf8 { byte: None });
            }
        }
    }

    /// The bytes of Latin-1 are read, and the first is reported at its place.
    #[test]
    fn latin_1_is_read_with_one_fault() {
        let bytes: Vec<u8> = TEXT.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
        let (text, fault) = decoded(&bytes);
        assert_eq!(text, TEXT);
        let fault = fault.unwrap();
        assert_eq!((fault.line, fault.column, fault.fault), (2, 4, Fault::NotUtf8 { byte: Some(0xfc) }));
        assert_eq!(text.get(fault.span), Some("ü"));
        assert_eq!(decoded(TEXT.as_bytes()), (Cow::Borrowed(TEXT), None));
        let (text, fault) = decoded(b"a\x96\x80\xc3");
        assert_eq!((text.as_ref(), fault.map(|each| each.span)), ("a\u{fffd}\u{fffd}\u{c3}", Some(1..4)));
        assert_eq!(decoded(b"").1, None);
    }
}

//! Texts from bytes: any text, and edits that turn a valid text into an invalid one.

use arbitrary::{Result, Unstructured};

/// Text fragments that random bytes seldom produce.
const PIECES: [&str; 56] = [
    "NaN",
    "inf",
    "-inf",
    "1e999",
    "-5",
    "0",
    "1e-320",
    "\"",
    "'",
    "\"\"\"",
    "=",
    "[",
    "]",
    "[[motion]]",
    "[load]",
    "[actuator]",
    "[bearing]",
    "\n",
    "\r\n",
    "\t",
    "#",
    "\u{0}",
    "\u{feff}",
    "ß",
    "µ",
    "²",
    "⁻¹",
    "°",
    "–",
    ",",
    ".",
    " N m",
    " 1/min",
    " kg m^2",
    "true",
    "{",
    "}",
    "[[[[[[[[[[[[[[[[",
    "speed = \"1 1/min\"\n",
    "9999999999999999999999",
    "'''",
    "{a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a={a=",
    ".a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a",
    "\\u00DF",
    "\\",
    "1979-05-27T07:32:00Z",
    "\u{1F9ED}",
    "e\u{301}",
    "±",
    " ± 5 %",
    " ± 100 %",
    "−",
    "\u{202e}",
    "\u{7f}",
    "\u{a0}",
    ";",
];

/// Returns the remaining bytes as text, with invalid UTF-8 replaced.
#[must_use]
pub fn rest(u: &mut Unstructured<'_>) -> String {
    let length = u.len();
    String::from_utf8_lossy(u.bytes(length).unwrap_or_default()).into_owned()
}

/// Returns `true` if a case belongs to the share of one in `many`, by a hash of its text or bytes (FNV-1a): for checks
/// too expensive for every case. Shares without a common divisor are independent.
#[must_use]
pub fn one_in(many: u64, case: impl AsRef<[u8]>) -> bool {
    let mixed = case
        .as_ref()
        .iter()
        .fold(0xCBF2_9CE4_8422_2325_u64, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01B3));
    (mixed >> 7).is_multiple_of(many)
}

/// Chooses one to `most` edits for [`mutate`].
///
/// # Errors
/// The case has too few bytes.
pub fn any_edits(u: &mut Unstructured<'_>, most: usize) -> Result<Vec<(u16, u8)>> {
    (0..u.int_in_range(1..=most)?).map(|_| u.arbitrary()).collect()
}

/// Checks that a text for a person is not empty. Quotations are unchanged: each face makes invisible characters
/// harmless in its own way.
pub fn tells(text: &str) {
    assert!(!text.trim().is_empty(), "{text:?}");
}

/// Applies edits to a text: each edit is a place and an operation.
#[must_use]
pub fn mutate(text: &str, edits: &[(u16, u8)]) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    for (place, choice) in edits {
        if choice % 16 == 7 {
            characters = edit_line(&characters, usize::from(*place), choice / 16);
            continue;
        }
        let at = if characters.is_empty() { 0 } else { usize::from(*place) % (characters.len() + 1) };
        match choice % 8 {
            0 if at < characters.len() => {
                characters.remove(at);
            }
            1 => {
                let end = (at + usize::from(*choice)).min(characters.len());
                characters.drain(at..end);
            }
            2 if at < characters.len() => {
                if let (Some(slot), Some(new)) = (characters.get_mut(at), char::from_u32(u32::from(*choice))) {
                    *slot = new;
                }
            }
            3 => {
                let end = (at + 40).min(characters.len());
                let copy: Vec<char> = characters.get(at..end).unwrap_or_default().to_vec();
                characters.splice(at..at, copy);
            }
            _ => {
                let piece = PIECES.get(usize::from(*choice) / 5 % PIECES.len()).copied().unwrap_or_default();
                characters.splice(at..at, piece.chars());
            }
        }
    }
    characters.into_iter().collect()
}

/// Doubles a line, drops it, or exchanges it with the next one.
fn edit_line(characters: &[char], place: usize, choice: u8) -> Vec<char> {
    let mut lines: Vec<&[char]> = characters.split_inclusive(|c| *c == '\n').collect();
    if lines.is_empty() {
        return Vec::new();
    }
    let at = place % lines.len();
    match choice % 3 {
        0 => lines.insert(at, lines.get(at).copied().unwrap_or_default()),
        1 => {
            lines.remove(at);
        }
        _ => {
            let next = (at + 1) % lines.len();
            lines.swap(at, next);
        }
    }
    lines.concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_as_large_as_it_says() {
        for many in [2, 3, 7] {
            let chosen = (0..7000).filter(|number| one_in(many, format!("CHA-{number}"))).count();
            let expected = 7000 / usize::try_from(many).unwrap_or(1);
            assert!(chosen.abs_diff(expected) < expected / 5, "{chosen} of 7000, one in {many}");
        }
    }

    #[test]
    fn lines_are_doubled_dropped_and_swapped() {
        let edited = |choice| mutate("a\nb\nc\n", &[(1, choice)]);
        assert_eq!(edited(7), "a\nb\nb\nc\n");
        assert_eq!(edited(7 + 16), "a\nc\n");
        assert_eq!(edited(7 + 32), "a\nc\nb\n");
        assert_eq!(mutate("", &[(3, 7)]), "");
    }
}

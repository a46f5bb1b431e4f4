//! What the fuzz targets share: a small language of edits that turns a valid text into a broken one.
//!
//! The targets stand in `tests/`. They run as plain tests for a bounded time.

use arbtest::arbitrary::{Result, Unstructured};
use arbtest::arbtest;
use std::time::{Duration, Instant};

/// How long a target runs in milliseconds: a share of `ANTRIEB_FUZZ_SECONDS`, five seconds without it.
#[must_use]
pub fn budget_ms(share: u64) -> u64 {
    let seconds: u64 = std::env::var("ANTRIEB_FUZZ_SECONDS").ok().and_then(|text| text.parse().ok()).unwrap_or(5);
    seconds * 1000 / share.max(1)
}

/// Runs a property for its share of the time, each time with other bytes to choose from.
///
/// The sequence of cases is the same on every run; `ANTRIEB_FUZZ_SEED`, a number, starts another one. A failure prints
/// the seed of its case, and `ARBTEST_SEED` repeats that case alone.
pub fn explore(share: u64, mut property: impl FnMut(&mut Unstructured<'_>) -> Result<()>) {
    if std::env::var_os("ARBTEST_SEED").is_some() {
        arbtest(property).run();
        return;
    }
    let begin = Instant::now();
    let budget = Duration::from_millis(budget_ms(share));
    let series: u64 = std::env::var("ANTRIEB_FUZZ_SEED").ok().and_then(|text| text.parse().ok()).unwrap_or(0);
    for seed in seeds(series) {
        // A case that asks for more bytes than it was given is no failure, and arbtest would make it one.
        arbtest(|u| property(u).or(Ok(()))).seed(seed).run();
        if begin.elapsed() > budget {
            return;
        }
    }
}

/// Seeds as arbtest writes them: the upper half is random, the lower is the number of bytes.
fn seeds(series: u64) -> impl Iterator<Item = u64> {
    // Fibonacci hashing: neighbouring cases get seeds that have nothing in common.
    let random = move |case: u64| (series << 32).wrapping_add(case).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (1..).zip(SIZES.iter().cycle()).map(move |(case, size)| random(case) & !0xFFFF_FFFF | size)
}

/// Bytes that a case may choose from: a short case is a simple one.
const SIZES: [u64; 6] = [32, 64, 128, 512, 64, 4096];

/// Pieces that break texts in ways that random bytes seldom find.
const PIECES: [&str; 48] = [
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
];

/// Up to `most` bytes as text, what is no UTF-8 replaced. `Vec`'s own way stops after one byte on average.
///
/// # Errors
/// When the case is out of bytes.
pub fn any_text(u: &mut Unstructured<'_>, most: usize) -> Result<String> {
    let length = u.int_in_range(0..=most)?.min(u.len());
    Ok(String::from_utf8_lossy(u.bytes(length)?).into_owned())
}

/// One to `most` edits for [`mutate`].
///
/// # Errors
/// When the case is out of bytes.
pub fn any_edits(u: &mut Unstructured<'_>, most: usize) -> Result<Vec<(u16, u8)>> {
    (0..u.int_in_range(1..=most)?).map(|_| u.arbitrary()).collect()
}

/// Applies edits to a text: each edit is a place and a choice of what to do there.
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

/// Writes a line twice, leaves it out, or exchanges it with the next one.
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
    fn lines_are_doubled_dropped_and_swapped() {
        let edited = |choice| mutate("a\nb\nc\n", &[(1, choice)]);
        assert_eq!(edited(7), "a\nb\nb\nc\n");
        assert_eq!(edited(7 + 16), "a\nc\n");
        assert_eq!(edited(7 + 32), "a\nc\nb\n");
        assert_eq!(mutate("", &[(3, 7)]), "");
    }

    #[test]
    fn the_cases_are_the_same_on_every_run_and_differ_between_series() {
        let first = |series| seeds(series).take(1000).collect::<Vec<u64>>();
        assert_eq!(first(0), first(0));
        assert!(first(0).iter().zip(first(1)).all(|(a, b)| *a != b));
        let mut sorted = first(0);
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(sorted.len(), 1000);
    }
}

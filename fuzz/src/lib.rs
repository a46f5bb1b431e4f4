//! What the fuzz targets share: a small language of edits that turns a valid text into a broken one.
//!
//! The targets stand in `tests/`. They run as plain tests for a bounded time.

/// How long a target runs in milliseconds: a share of `ANTRIEB_FUZZ_SECONDS`, five seconds without it.
#[must_use]
pub fn budget_ms(share: u64) -> u64 {
    let seconds: u64 = std::env::var("ANTRIEB_FUZZ_SECONDS").ok().and_then(|text| text.parse().ok()).unwrap_or(5);
    seconds * 1000 / share.max(1)
}

/// Pieces that break texts in ways that random bytes seldom find.
const PIECES: [&str; 40] = [
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
];

/// Applies edits to a text: each edit is a place and a choice of what to do there.
#[must_use]
pub fn mutate(text: &str, edits: &[(u16, u8)]) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    for (place, choice) in edits {
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

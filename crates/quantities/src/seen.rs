//! External text made safe for display: the only definition of the characters that a reader cannot see.

use std::borrow::Cow;

/// Returns `true` if a character is invisible but changes the display: control characters (C0, delete, C1) control a
/// terminal, line and paragraph separators break a line, directional marks change the order of the following text, and
/// noncharacters are no text at all.
///
/// # Source
/// Unicode: general category Cc; UAX #9, table of explicit formatting characters; section 23.7, noncharacters
#[must_use]
pub const fn is_unseen(sign: char) -> bool {
    matches!(
        sign,
        '\0'..='\u{1f}'
            | '\u{7f}'..='\u{9f}'
            | '\u{61c}'
            | '\u{200e}'
            | '\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2066}'..='\u{2069}'
            | '\u{fdd0}'..='\u{fdef}'
    ) || (sign as u32) & 0xfffe == 0xfffe
}

/// Returns the text with every invisible character written as `\u{9b}`.
///
/// ```
/// assert_eq!(quantities::seen("axis\u{9b}31m\u{202e}"), "axis\\u{9b}31m\\u{202e}");
/// assert_eq!(quantities::seen("Achse φ, 軸"), "Achse φ, 軸");
/// ```
#[must_use]
pub fn seen(text: &str) -> Cow<'_, str> {
    if text.chars().any(is_unseen) {
        let escape = |sign: char| if is_unseen(sign) { sign.escape_unicode().to_string() } else { sign.to_string() };
        Cow::Owned(text.chars().map(escape).collect())
    } else {
        Cow::Borrowed(text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_a_terminal_or_turns_a_line_is_not_seen() {
        for sign in "\0\t\n\r\u{1b}\u{7f}\u{80}\u{9b}\u{9f}\u{61c}\u{200e}\u{200f}\u{2028}\u{202a}\u{202e}\u{2066}\u{2069}\u{fdd0}\u{fffe}\u{ffff}\u{1fffe}\u{10ffff}".chars() {
            assert!(is_unseen(sign), "{sign:?}");
            assert_eq!(seen(&sign.to_string()), format!("\\u{{{:x}}}", u32::from(sign)));
        }
        for sign in " ~\u{a0}°²ß–\u{200b}\u{200d}\u{202f}א軸🛠\u{fffd}\u{e000}".chars() {
            assert!(!is_unseen(sign), "{sign:?}");
        }
    }
}

//! A record as bytes.

use quantities::is_unseen;
use serde::Serialize;

/// A record as a file, standard output or an answer over HTTP has it: JSON, indented, with a line feed at its end. Signs that
/// are not seen stand in its texts as JSON escapes them, so that the record is the same and a terminal stays as it is.
pub fn written(record: &impl Serialize) -> String {
    // A record has string keys and finite numbers only: nothing in it can fail.
    let mut text = serde_json::to_string_pretty(record).unwrap_or_default();
    text.push('\n');
    if text.chars().any(|sign| sign != '\n' && is_unseen(sign)) {
        let escape = |sign: char| match sign {
            // Between texts there is no other sign that is not seen than the end of a line, and in them it is escaped.
            '\n' => sign.to_string(),
            sign if is_unseen(sign) => {
                let mut units = [0; 2];
                sign.encode_utf16(&mut units).iter().map(|unit| format!("\\u{unit:04x}")).collect()
            }
            sign => sign.to_string(),
        };
        text = text.chars().map(escape).collect();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_record_holds_what_is_not_seen_as_escapes_that_mean_the_same() {
        let text = "a\u{9b}\u{202e}\u{1}\n\u{1fffe}b";
        let json = written(&text);
        assert!(!json.trim_end().chars().any(is_unseen), "{json}");
        assert_eq!(serde_json::from_str::<String>(&json).unwrap(), text);
    }
}

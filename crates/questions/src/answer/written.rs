//! A record as bytes.

use quantities::is_unseen;
use serde::Serialize;

/// Returns a record in the form of a file, of standard output or of an answer over HTTP: JSON, indented, with a line
/// feed at its end. Invisible characters in its texts are written as JSON escapes, so that the record is unchanged and
/// a terminal unaffected.
pub fn written(record: &impl Serialize) -> String {
    // A record has string keys and finite numbers only, so nothing can fail.
    let mut text = serde_json::to_string_pretty(record).unwrap_or_default();
    text.push('\n');
    if text.chars().any(|sign| sign != '\n' && is_unseen(sign)) {
        let escape = |sign: char| match sign {
            // The only invisible character between texts is the line feed; within texts it is escaped.
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

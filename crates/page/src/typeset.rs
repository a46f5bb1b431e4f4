//! Symbols and keys in the texts of a page, as a reader of a manual expects them: `T_rms` has a subscript, and a key of the project file
//! appears as the label of its field.
//!
//! The texts come from several crates, whose other readers (terminal, JSON) need the plain forms. They are set here once, when a page is
//! complete. Program text (`code`, the text of the file) is quoted and stays.

use crate::file_lines::in_words;
use crate::markup::label_of;
use project::key_at;
use quantities::Language;
use words::{page, row_sign};

/// Elements whose content is a quotation or no text.
const QUOTED: [&str; 6] = ["script", "style", "code", "textarea", "symbol", "template"];

/// Elements whose content has no markup.
const PLAIN: [&str; 4] = ["title", "option", "text", "tspan"];

/// Attributes with a text.
const SPOKEN: [&str; 6] = ["title", "aria-label", "alt", "alttext", "placeholder", "aria-valuetext"];

/// Form of a symbol.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// With a subscript.
    Set,
    /// The index behind its letter, where there is no markup.
    Plain,
}

/// Returns a page with its symbols and keys set.
pub(crate) fn typeset(html: &str, language: Language) -> String {
    let mut out = String::with_capacity(html.len() + html.len() / 64);
    let mut quoted: Option<&str> = None;
    let mut form = Form::Set;
    let mut rest = html;
    while let Some(at) = rest.find('<') {
        let (text, tag) = rest.split_at(at);
        if quoted.is_some() {
            out.push_str(text)
        } else {
            words_of(text, form, language, &mut out)
        }
        let end = tag.find('>').map_or(tag.len(), |end| end + 1);
        let (tag, behind) = tag.split_at(end);
        rest = behind;
        let inside = tag.trim_start_matches(['<', '/']);
        let name = inside.split([' ', '/', '>', '\n']).next().unwrap_or_default();
        if tag.starts_with("</") {
            if quoted == Some(name) {
                quoted = None;
            }
            form = Form::Set;
        } else if quoted.is_none() && !tag.ends_with("/>") {
            quoted = QUOTED.into_iter().find(|quoted| *quoted == name);
            form = if PLAIN.contains(&name) { Form::Plain } else { Form::Set };
        }
        if quoted.is_none_or(|quoted| quoted == name) && tag.contains(['_', '.']) {
            attributes(tag, language, &mut out);
        } else {
            out.push_str(tag);
        }
    }
    words_of(rest, form, language, &mut out);
    out
}

/// Writes a tag with the texts of its attributes set.
fn attributes(tag: &str, language: Language, out: &mut String) {
    let mut rest = tag;
    while let Some((before, value)) = rest.split_once("=\"") {
        let (value, behind) = value.split_once('"').unwrap_or((value, ""));
        let name = before.rsplit([' ', '\n']).next().unwrap_or_default();
        out.push_str(before);
        out.push_str("=\"");
        if SPOKEN.contains(&name) {
            words_of(value, Form::Plain, language, out)
        } else {
            out.push_str(value)
        }
        out.push('"');
        rest = behind;
    }
    out.push_str(rest);
}

/// Writes a text with its symbols and keys set.
fn words_of(text: &str, form: Form, language: Language, out: &mut String) {
    let text = words::typeset(text);
    let text = &*in_words(&text, language);
    if !text.contains(['_', '.', '[']) {
        out.push_str(text);
        return;
    }
    // An exponent belongs to the symbol, not to its index.
    let is_exponent = |sign: char| matches!(sign, '²' | '³' | '¹' | '⁰' | '⁴'..='⁹');
    let is_part = |sign: char| sign.is_alphanumeric() && !is_exponent(sign) || matches!(sign, '_' | '.' | '[' | ']');
    let mut rest = text;
    while let Some(from) = rest.find(is_part) {
        let (before, tail) = rest.split_at(from);
        let end = tail.find(|sign| !is_part(sign)).unwrap_or(tail.len());
        let word = tail[..end].trim_end_matches(['.', '[', ']']);
        let word = if tail[..end].len() > word.len() && tail[word.len()..].starts_with(']') && word.contains('[') {
            &tail[..word.len() + 1]
        } else {
            word
        };
        if word.is_empty() {
            out.push_str(&rest[..from + end]);
            rest = &rest[from + end..];
            continue;
        }
        let after = &tail[word.len()..];
        let segment = segment_of(word);
        let is_key = word.contains(['_', '.']) || segment.is_some();
        if is_key && before.ends_with('(') && in_parentheses(word, after, language) {
            // The sentence says it in words.
            let end = after.find(')').map_or(after.len(), |end| end + 1);
            out.push_str(before.trim_end_matches('(').trim_end());
            rest = &after[end..];
            continue;
        }
        out.push_str(before);
        rest = after;
        if before.ends_with('-') || !is_key {
            out.push_str(word);
        } else if let Some(number) = segment {
            out.push_str(&page::segment(&number, language));
        } else if let Some(label) = word.contains('.').then(|| label_of(word, language)).flatten() {
            out.push_str(&escaped(&label, form));
        } else if !word.contains('.')
            && let Some((head, index)) = row_sign(word).as_deref().and_then(|sign| sign.split_once('_'))
        {
            let more = continued(after);
            let index = index.replace('_', ",");
            rest = &after[more..];
            out.push_str(&set((head, &index, &after[..more]), form));
        } else {
            out.push_str(word);
        }
    }
    out.push_str(rest);
}

/// Returns the number of the segment that a path names: `motion[2]`.
fn segment_of(word: &str) -> Option<&str> {
    let path = word.strip_prefix("axis[").and_then(|rest| rest.split_once("].")).map_or(word, |(_, inside)| inside);
    let number = path.strip_prefix("motion[")?.strip_suffix(']')?;
    number.bytes().all(|byte| byte.is_ascii_digit()).then_some(number)
}

/// Returns `true` if a word in parentheses is a key that the sentence before it describes: alone, or with a value.
fn in_parentheses(word: &str, after: &str, language: Language) -> bool {
    let is_plain = || word.bytes().all(|byte| matches!(byte, b'_' | b'.' | b'0'..=b'9') || byte.is_ascii_lowercase());
    let is_known = match word.split_once('.') {
        // A default of the program stands under the table of its kind and is no key.
        Some((table, _)) => label_of(word, language).is_some() || key_at(table).is_some() && is_plain(),
        None => word.contains('_') && row_sign(word).is_none() && is_plain(),
    };
    is_known && (after.starts_with(')') || after.starts_with(" = ") && after.contains(')'))
}

/// Returns the number of bytes behind a symbol that belong to its index: `,dyn(max)`.
fn continued(after: &str) -> usize {
    let letters = |text: &str| text.find(|sign: char| !sign.is_ascii_alphanumeric()).unwrap_or(text.len());
    let mut at = 0;
    if let Some(more) = after.strip_prefix(',') {
        let end = letters(more);
        let is_index =
            end > 0 && !more[end..].starts_with('_') && more.starts_with(|sign: char| sign.is_ascii_lowercase());
        at = if is_index { end + 1 } else { 0 };
    }
    // In other parentheses stands what a function depends on.
    let extremes = ["(max)", "(min)"];
    at + extremes.iter().find(|extreme| after[at..].starts_with(**extreme)).map_or(0, |extreme| extreme.len())
}

fn set((head, index, more): (&str, &str, &str), form: Form) -> String {
    match form {
        Form::Set => format!("{head}<sub>{index}{more}</sub>"),
        Form::Plain => format!("{head}\u{202f}{index}{more}"),
    }
}

/// Returns a label in HTML; its leading symbol set.
fn escaped(label: &str, form: Form) -> String {
    let mut out = String::new();
    words_of(&label.replace('&', "&amp;").replace('<', "&lt;"), form, Language::default(), &mut out);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(html: &str) -> String {
        typeset(html, Language::En)
    }

    #[test]
    fn symbols_have_subscripts_and_other_words_stay() {
        for (html, expected) in [
            ("<p>T_rms of 3.5 Nm.</p>", "<p>T<sub>rms</sub> of 3.5 Nm.</p>"),
            ("<p>J_out_brake, F_A,dyn(max)</p>", "<p>J<sub>out,brake</sub>, F<sub>A,dyn(max)</sub></p>"),
            ("<p>P_cu(K)</p>", "<p>P<sub>cu</sub>(K)</p>"),
            ("<p>ω_1²/2, T_rms², r_k⁴</p>", "<p>ω<sub>1</sub>²/2, T<sub>rms</sub>², r<sub>k</sub>⁴</p>"),
            ("<p>K_1,K_2 tau_m</p>", "<p>K<sub>1</sub>,K<sub>2</sub> τ<sub>m</sub></p>"),
            ("<p>14A-E-I_max-100 lift_80.toml v_1.csv</p>", "<p>14A-E-I_max-100 lift_80.toml v_1.csv</p>"),
            ("<code>T_rms</code><p title=\"T_rms\">x</p>", "<code>T_rms</code><p title=\"T\u{202f}rms\">x</p>"),
            ("<option value=\"T_rms\">T_rms</option>", "<option value=\"T_rms\">T\u{202f}rms</option>"),
            ("<textarea title=\"T_L\">T_L</textarea>", "<textarea title=\"T\u{202f}L\">T_L</textarea>"),
        ] {
            assert_eq!(shown(html), expected);
        }
    }

    #[test]
    fn signs_are_those_of_typesetting() {
        for (html, expected) in [
            ("<td>200 x 200 x 6</td>", "<td>200 × 200 × 6</td>"),
            ("<td>1 x KTY 84-130 / M17 x 1</td>", "<td>1 × KTY 84-130 / M17 × 1</td>"),
            ("<td>-20 ... 60 (-5)</td>", "<td>−20 … 60 (−5)</td>"),
            ("<p>CHA-14A-100, part 2-6, - and an x here</p>", "<p>CHA-14A-100, part 2-6, - and an x here</p>"),
            ("<code>2 x -3 ...</code>", "<code>2 x -3 ...</code>"),
        ] {
            assert_eq!(shown(html), expected);
        }
    }

    #[test]
    fn keys_appear_as_the_labels_of_their_fields() {
        let label = label_of("bearing.flange_share", Language::En).unwrap_or_default();
        assert_eq!(shown("<td>not stated: bearing.flange_share</td>"), format!("<td>not stated: {label}</td>"));
        assert_eq!(shown("<li>none given (bearing.flange_share): full loads</li>"), "<li>none given: full loads</li>");
        assert_eq!(shown("<li>vertical (axis_tilt), e.g. (T_L)</li>"), "<li>vertical, e.g. (T<sub>L</sub>)</li>");
        assert_eq!(shown("<li>left out (bearing.mechanism = &quot;ignore&quot;).</li>"), "<li>left out.</li>");
        assert_eq!(shown("<p>axis.toml, www.example.org.</p>"), "<p>axis.toml, www.example.org.</p>");
        assert_eq!(
            shown("<li>motion[2]: at rest, axis[2].motion[13].</li>"),
            "<li>Segment 2: at rest, Segment 13.</li>"
        );
        assert_eq!(
            shown("<li>state gaps = &quot;allow&quot; to permit them</li>"),
            "<li>state “gaps: permitted” to permit them</li>"
        );
        assert_eq!(shown("<code>gaps = &quot;allow&quot;</code>"), "<code>gaps = &quot;allow&quot;</code>");
    }
}

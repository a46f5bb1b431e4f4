//! Markup that several parts of the page have: names of fields, labels, values of requests, faults, drawer.

use axis::{AxisDiagnostic, AxisFault};
use maud::{Markup, PreEscaped, html};
use project::{Fault, Hint, key_at};
use quantities::Language;
use words::{Worded, about_text, capitalised, hyphenated, incoming, page, short_label};

/// Sign of the program, that of the report.
pub(crate) const LOGO: &str = include_str!("../../plot/logo.svg");

/// Returns the sign of the program as a drawing in the colours of the theme.
pub(crate) fn logo() -> Markup {
    let inside = LOGO.find('>').and_then(|end| LOGO.get(end + 1..)).and_then(|rest| rest.rsplit_once('<'));
    html! { svg.logo viewBox="0 0 100 100" aria-hidden="true" { (PreEscaped(inside.map_or("", |(inside, _)| inside))) } }
}

/// Returns the identifier of the row of a path.
pub(crate) fn id(path: &str) -> String {
    let sign = |sign: char| if sign.is_ascii_alphanumeric() || sign == '_' { sign } else { '-' };
    format!("f-{}", path.chars().map(sign).collect::<String>())
}

/// Returns the part of an identifier that stands for a product: its ordering code, or its name with other signs than letters,
/// digits and hyphens as their numbers, so that different names have different identifiers.
pub(crate) fn id_of_product(name: &str) -> String {
    let mut id = String::with_capacity(name.len());
    for sign in name.chars() {
        if sign.is_ascii_alphanumeric() || sign == '-' {
            id.push(sign);
        } else {
            id.push_str(&format!("_{:x}_", u32::from(sign)));
        }
    }
    id
}

/// Returns a fault as the page states it: the place of a missing load is a choice there, and no table of the file.
pub(crate) fn in_words(worded: Worded, fault: &AxisDiagnostic, language: Language) -> Worded {
    if !matches!(fault.fault, AxisFault::Stated(Fault::NoMechanism)) {
        return worded;
    }
    let is_line = matches!(&fault.hint, Some(Hint::Example(example)) if example.starts_with("[mechanism"));
    let hint = is_line.then(|| incoming::line_missing(language).to_owned());
    Worded { message: incoming::load_missing(language).to_owned(), hint, ..worded }
}

/// Returns a label that may begin with a symbol, set with its subscript: `T_L, friction torque`.
pub(crate) fn label(text: &str) -> Markup {
    let symbol = text.split_once(", ").filter(|(head, _)| head.contains('_') && !head.contains(' '));
    html! { @match symbol {
        Some((symbol, rest)) => { (crate::chapters::symbol(symbol)) ", " (hyphenated(rest)) },
        None => (hyphenated(text)),
    } }
}

/// Returns a text as the content of a field; HTML drops a first line feed, so that one is added.
pub(crate) fn kept(text: &str) -> Markup {
    // Quotation marks, of which a project is full, need no escape in content.
    let escaped = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    html! { @if text.starts_with('\n') { "\n" } (PreEscaped(escaped)) }
}

/// Splits a typed quantity into the value and its tolerance.
pub(crate) fn tolerance_of(typed: &str) -> (&str, &str) {
    let parts = ["±", "+/-", "+-"].iter().find_map(|sign| typed.split_once(sign));
    parts.map_or((typed.trim(), ""), |(value, band)| (value.trim(), band.trim()))
}

/// Writes the values of a request as JSON.
pub(crate) fn vals(values: &[(&str, &str)]) -> String {
    let map: serde_json::Map<String, serde_json::Value> =
        values.iter().map(|(key, value)| ((*key).to_owned(), (*value).into())).collect();
    serde_json::Value::Object(map).to_string()
}

/// Returns the label of a key as the left pane shows it; `None` if the path names no key.
pub(crate) fn label_of(path: &str, language: Language) -> Option<String> {
    label_within(path, language).map(|label| capitalised(&label))
}

/// Returns the label of a key as it stands within a sentence; `None` if the path names no key.
pub(crate) fn label_within(path: &str, language: Language) -> Option<String> {
    // The keys of a file with several axes stand under `axis[N]`.
    let inside = path.strip_prefix("axis[").and_then(|rest| rest.split_once("].")).map_or(path, |(_, inside)| inside);
    Some(short_label(about_text(key_at(inside)?.about, language)))
}

/// Returns the place of the message that the last work was stopped; empty if it was not.
pub(crate) fn stopped(what: &Markup) -> Markup {
    html! { p.advice id="stopped" role="status" { (what) } }
}

/// Returns a heading with a button that closes the content below it.
pub(crate) fn drawer(title: &str, inside: &Markup, language: Language) -> Markup {
    html! {
        section aria-labelledby="detail-title" {
            div.bar-head {
                button.icon type="button" id="detail-back" data-back="" hidden aria-label=(page::back(language)) title=(page::back(language)) { "←" }
                h2 id="detail-title" tabindex="-1" { (title) }
                button type="button" data-close="detail" { (page::close(language)) }
            }
            (inside)
        }
    }
}

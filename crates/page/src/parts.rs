//! Parts of the page that a browser has already: they are sent by their names alone.
//!
//! A shell keeps nothing of a page. Each part carries the digest of its text, a request carries the digests of the parts
//! that the browser shows, and where a part has not changed an empty element with its identifier stands in its place. The
//! script leaves such an element as it is (`htmx:before:morph:node` in `page.js`).

use maud::{Markup, PreEscaped};
use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

/// So many parts are read of a request at most; a page has a few dozen.
const MOST: usize = 400;

/// The digests of the parts that a browser shows, by their identifiers.
#[derive(Default)]
pub(crate) struct Parts(HashMap<String, u64>);

impl Parts {
    /// As a request carries them: `id=digest` separated by blanks, the digest in hexadecimal digits.
    pub(crate) fn read(text: &str) -> Self {
        let one = |word: &str| {
            let (id, digest) = word.rsplit_once('=')?;
            Some((id.to_owned(), u64::from_str_radix(digest, 16).ok()?))
        };
        Self(text.split_whitespace().take(MOST).filter_map(one).collect())
    }

    /// An element with an identifier, which may be left out as long as its text stays the same. An element without
    /// identifier, or with parts inside, is sent as it is.
    pub(crate) fn part(&self, element: Markup) -> Markup {
        let text = element.0;
        let Some((tag, id)) = head(&text) else { return PreEscaped(text) };
        // A quotation mark of a text is escaped: these are attributes.
        if text.contains(" data-part=\"") || text.contains("\" data-same>") {
            return PreEscaped(text);
        }
        let mut hasher = DefaultHasher::new();
        text.hash(&mut hasher);
        let digest = hasher.finish();
        if self.0.get(id) == Some(&digest) {
            return PreEscaped(format!("<{tag} id=\"{id}\" data-same></{tag}>"));
        }
        let (begin, rest) = text.split_at(tag.len() + 1);
        PreEscaped(format!("{begin} data-part=\"{digest:x}\"{rest}"))
    }
}

/// The name of the first element and its identifier.
fn head(text: &str) -> Option<(&str, &str)> {
    let inside = text.strip_prefix('<')?.split_once('>')?.0;
    let (tag, attributes) = inside.split_once(' ')?;
    let id = attributes.strip_prefix("id=\"").or_else(|| Some(attributes.split_once(" id=\"")?.1))?;
    Some((tag, id.split_once('"')?.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use maud::html;

    fn element(value: &str) -> Markup {
        html! { li.entry id="f-1" title="a > b" { (value) } }
    }

    /// The digests as the script collects them.
    fn kept(sent: &Markup) -> Parts {
        let digest =
            sent.0.split_once("data-part=\"").and_then(|(_, rest)| rest.split_once('"')).map(|(digest, _)| digest);
        Parts::read(&format!("f-1={} other=zz", digest.unwrap_or_default()))
    }

    #[test]
    fn what_the_browser_has_is_sent_by_its_name_alone() {
        let first = Parts::default().part(element("7"));
        assert!(first.0.starts_with("<li data-part=\""), "{}", first.0);
        assert!(first.0.ends_with(">7</li>"), "{}", first.0);
        let held = kept(&first);
        assert_eq!(held.part(element("7")).0, "<li id=\"f-1\" data-same></li>");
        assert_eq!(
            held.part(element("8")).0.replace(char::is_alphanumeric, ""),
            first.0.replace(char::is_alphanumeric, "")
        );
    }

    #[test]
    fn an_element_without_an_identifier_is_sent_as_it_is() {
        let held = Parts::read("=1 x= a=g");
        let inside = Parts::default().part(element("7"));
        for plain in [html! { p title="no id" { "a" } }, html! { "text" }, html! {}, html! { ol id="a" { (inside) } }] {
            assert_eq!(held.part(plain.clone()).0, plain.0);
        }
    }
}

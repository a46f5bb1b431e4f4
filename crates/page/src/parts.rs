//! Parts of the page that the browser already has: only their names are sent.
//!
//! A shell stores nothing of a page. Each part carries the digest of its text, a request carries the digests of the
//! parts that the browser shows, and an unchanged part is replaced by an empty element with its identifier. The script
//! leaves such an element unchanged (`htmx_before_morph_node` in `page.js`). Parts may be nested.

use crate::call::Call;
use maud::{Markup, PreEscaped};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};

/// Largest number of parts read from a request; a page has some hundred.
const MOST: usize = 2_000;

/// Text before the digest of a part. In texts and attribute values the quotation mark is escaped.
const MARK: &str = " data-part=\"";

/// Adds the digest of its text to an element that has an identifier.
pub(crate) fn part(element: Markup) -> Markup {
    let text = element.0;
    let Some((tag, _)) = head(&text) else { return PreEscaped(text) };
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    let (begin, rest) = text.split_at(tag.len() + 1);
    PreEscaped(format!("{begin}{MARK}{:x}\"{rest}", hasher.finish()))
}

/// Returns the tag of the first element and its identifier.
fn head(text: &str) -> Option<(&str, &str)> {
    let inside = text.strip_prefix('<')?.split_once('>')?.0;
    let (tag, attributes) = inside.split_once(' ')?;
    let id = attributes.strip_prefix("id=\"").or_else(|| Some(attributes.split_once(" id=\"")?.1))?;
    Some((tag, id.split_once('"')?.0))
}

/// Digests of the parts that a browser shows, by identifier.
pub(crate) struct ShownParts(BTreeMap<String, String>);

impl ShownParts {
    /// Reads the digests of a request: `id=digest` separated by blanks.
    pub(crate) fn of(call: &Call<'_>) -> Self {
        Self::read(&call.field("parts").unwrap_or_default())
    }

    fn read(text: &str) -> Self {
        let one = |word: &str| word.rsplit_once('=').map(|(id, digest)| (id.to_owned(), digest.to_owned()));
        Self(text.split_whitespace().take(MOST).filter_map(one).collect())
    }

    /// Returns a page without the parts that the browser shows.
    pub(crate) fn left_out(&self, page: &str) -> String {
        let mut out = String::with_capacity(page.len());
        let mut rest = page;
        while let Some(mark) = rest.find(MARK) {
            let (before, _) = rest.split_at(mark);
            let (before, part) = rest.split_at(before.rfind('<').unwrap_or(mark));
            out.push_str(before);
            let known = head(part).and_then(|(tag, id)| {
                let digest = part.split_once(MARK)?.1.split_once('"')?.0;
                (self.0.get(id).map(String::as_str) == Some(digest)).then_some((tag, id))
            });
            let ended = known.and_then(|(tag, id)| Some((tag, id, part.get(end(part, tag)?..)?)));
            rest = match ended {
                Some((tag, id, behind)) => {
                    out.push_str(&format!("<{tag} id=\"{id}\" data-same></{tag}>"));
                    behind
                }
                None => {
                    let (head, behind) = part.split_at((mark - before.len()) + MARK.len());
                    out.push_str(head);
                    behind
                }
            };
        }
        out.push_str(rest);
        out
    }
}

/// Returns the end of the first element of a text.
fn end(text: &str, tag: &str) -> Option<usize> {
    let (open, close) = (format!("<{tag}"), format!("</{tag}>"));
    let opens = |part: &str| {
        let signs = part.match_indices(&open).filter_map(|(place, _)| part.as_bytes().get(place + open.len()));
        signs.filter(|sign| matches!(sign, b' ' | b'>')).count()
    };
    let (mut at, mut deep) = (0, 0_usize);
    loop {
        let to = at + text.get(at..)?.find(&close)? + close.len();
        deep = (deep + opens(text.get(at..to)?)).checked_sub(1)?;
        at = to;
        if deep == 0 {
            return Some(at);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use maud::html;

    fn element(value: &str) -> Markup {
        part(
            html! { div.entry id="f-1" title="a > b" { div { (value) } details {} (part(html! { div id="f-2" { "in" } })) } },
        )
    }

    /// Collects the digests as the script does.
    fn shown(page: &Markup) -> ShownParts {
        let of = |rest: &str| {
            let digest = rest.split('"').next().unwrap_or_default();
            let id = rest.split("id=\"").nth(1).and_then(|id| id.split('"').next()).unwrap_or_default();
            format!("{id}={digest} ")
        };
        ShownParts::read(&page.0.split(MARK).skip(1).map(of).collect::<String>())
    }

    #[test]
    fn what_the_browser_shows_is_sent_by_its_name_alone() {
        let page = |value: &str| html! { p { "before" } (element(value)) p { "behind" } };
        let parts = shown(&page("7"));
        assert_eq!(parts.0.len(), 2);
        assert_eq!(parts.left_out(&page("7").0), "<p>before</p><div id=\"f-1\" data-same></div><p>behind</p>");
        // Of a changed part, only the unchanged parts within it are left out.
        let other = parts.left_out(&page("8").0);
        assert!(other.contains(">8<") && other.contains("<div id=\"f-2\" data-same></div></div><p>behind"), "{other}");
        assert_eq!(ShownParts::read("").left_out(&page("8").0), page("8").0);
    }

    #[test]
    fn an_element_without_an_identifier_is_sent_as_it_is() {
        for plain in [html! { p title="no id" { "a" } }, html! { "text" }, html! {}] {
            assert_eq!(part(plain.clone()).0, plain.0);
        }
    }

    #[test]
    fn what_is_no_whole_element_stays() {
        let parts = ShownParts::read("a=1 = x");
        for page in [
            "<p data-part=\"1\" id=\"a\">",
            "x data-part=\"1\"",
            "<p data-part=\"1",
            "<div data-part=\"1\" id=\"a\"><div></div>",
        ] {
            assert_eq!(parts.left_out(page), page);
        }
    }
}

//! Texts that a person reads on a page: the content of its elements, and the attributes that a browser shows or reads aloud.

/// Elements whose content is no text of the page: program text, quotations of a file, and what a script copies.
const QUIET: [&str; 6] = ["script", "style", "code", "textarea", "pre", "symbol"];

/// Attributes with a text.
const SPOKEN: [&str; 5] = ["title", "aria-label", "placeholder", "alt", "aria-valuetext"];

/// Elements without an end tag.
const VOID: [&str; 6] = ["input", "meta", "link", "br", "hr", "img"];

/// Elements that belong to the line of the text around them.
const INLINE: [&str; 14] =
    ["sub", "sup", "b", "i", "em", "strong", "span", "tspan", "a", "mi", "mo", "mn", "mtext", "mspace"];

/// A text on a page: where it stands, and its words.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct VisibleText {
    /// The attribute, or the element that contains the text.
    pub place: String,
    /// The words, without references to characters.
    pub words: String,
}

/// Returns the texts of a page. An element with a class of `quiet` is left out with its content.
#[must_use]
pub fn visible_texts(html: &str, quiet: &[&str]) -> Vec<VisibleText> {
    let mut found = Vec::new();
    let mut open: Vec<(&str, bool)> = Vec::new();
    let mut line = String::new();
    let close = |line: &mut String, place: &str, found: &mut Vec<VisibleText>| {
        let words = line.split_whitespace().collect::<Vec<_>>().join(" ");
        line.clear();
        if !words.is_empty() {
            found.push(VisibleText { place: place.to_owned(), words });
        }
    };
    let mut rest = html;
    while let Some((text, tag)) = rest.split_once('<') {
        let is_quiet = open.last().is_some_and(|(_, is_quiet)| *is_quiet);
        if !is_quiet {
            line.push_str(&plain(text));
        }
        let Some((inside, behind)) = tag.split_once('>') else { break };
        rest = behind;
        let name = inside.trim_start_matches('/').split([' ', '/', '\n']).next().unwrap_or_default();
        let place = open.last().map_or("", |(name, _)| *name).to_owned();
        if inside.starts_with('!') {
            continue;
        }
        if !INLINE.contains(&name) {
            close(&mut line, &place, &mut found);
        }
        if inside.starts_with('/') {
            let _ = open.pop();
            continue;
        }
        let class = attribute(inside, "class").unwrap_or_default();
        let is_quiet = is_quiet || QUIET.contains(&name) || class.split(' ').any(|class| quiet.contains(&class));
        if !is_quiet {
            for attribute_name in SPOKEN {
                if let Some(words) = attribute(inside, attribute_name) {
                    found.push(VisibleText { place: format!("{name}[{attribute_name}]"), words: plain(words) });
                }
            }
        } else if name == "textarea" {
            // The content is a file; the hint in the empty field is a text of the page.
            if let Some(words) = attribute(inside, "placeholder") {
                found.push(VisibleText { place: "textarea[placeholder]".into(), words: plain(words) });
            }
        }
        if !VOID.contains(&name) && !inside.ends_with('/') {
            open.push((name, is_quiet));
        }
    }
    close(&mut line, "", &mut found);
    found
}

/// Returns the value of an attribute of a tag.
fn attribute<'t>(tag: &'t str, name: &str) -> Option<&'t str> {
    tag.split(&format!(" {name}=\"")).nth(1)?.split('"').next()
}

/// Returns a text with the characters that references stand for; places for a line break are left out.
fn plain(text: &str) -> String {
    let signs = [
        ("&lt;", "<"),
        ("&gt;", ">"),
        ("&quot;", "\""),
        ("&nbsp;", " "),
        ("\u{ad}", ""),
        ("\u{200b}", ""),
        ("&amp;", "&"),
    ];
    signs.iter().fold(text.to_owned(), |text, (reference, sign)| text.replace(reference, sign))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_and_spoken_attributes_are_found_and_quotations_left_out() {
        let html = "<p title=\"a &amp; b\">x<sub>1</sub> y<code>k_v</code></p><input placeholder=\"z\" value=\"v_w\"><p class=\"file a\">axis.toml</p><textarea placeholder=\"h\">a.b</textarea>";
        let found: Vec<String> = visible_texts(html, &["file"]).into_iter().map(|text| text.words).collect();
        assert_eq!(found, ["a & b", "x1 y", "z", "h"]);
    }
}

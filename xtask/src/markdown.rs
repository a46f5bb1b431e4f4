//! Parser for Markdown documents: links, code blocks, and sections with their headings.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

/// A document.
#[derive(Debug, Default)]
pub(crate) struct MarkdownText {
    pub(crate) links: Vec<Link>,
    pub(crate) code: Vec<Code>,
    /// Parts between two headings, each with its heading; the first one holds the text before any heading.
    pub(crate) sections: Vec<Section>,
}

/// A link, or a picture.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Link {
    pub(crate) line: usize,
    /// Target as written, with its fragment.
    pub(crate) target: String,
    pub(crate) is_picture: bool,
}

/// A block of code.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Code {
    pub(crate) line: usize,
    /// Word after the fence.
    pub(crate) info: String,
    pub(crate) text: String,
}

/// A heading and the text that follows it up to the next one.
#[derive(Debug, Default)]
pub(crate) struct Section {
    pub(crate) line: usize,
    /// Level of the heading; 0 before the first one.
    pub(crate) level: usize,
    /// Running text without code, piece by piece with its line.
    pub(crate) prose: Vec<(usize, String)>,
    /// Inline code.
    pub(crate) spans: Vec<String>,
}

impl MarkdownText {
    pub(crate) fn read(text: &str) -> Self {
        let begins: Vec<usize> = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        let line = |place: &Range<usize>| begins.partition_point(|begin| *begin <= place.start);
        let mut document = Self { sections: vec![Section { line: 1, ..Section::default() }], ..Self::default() };
        let mut open: Option<Code> = None;
        for (event, place) in Parser::new_ext(text, Options::ENABLE_TABLES).into_offset_iter() {
            let line = line(&place);
            match event {
                Event::Start(Tag::Heading { level, .. }) => {
                    document.sections.push(Section { line, level: level as usize, ..Section::default() });
                }
                Event::Start(Tag::Link { dest_url, .. }) => {
                    document.links.push(Link { line, target: dest_url.into_string(), is_picture: false });
                }
                Event::Start(Tag::Image { dest_url, .. }) => {
                    document.links.push(Link { line, target: dest_url.into_string(), is_picture: true });
                }
                Event::Start(Tag::CodeBlock(kind)) => {
                    let info = match kind {
                        CodeBlockKind::Fenced(info) => info.into_string(),
                        CodeBlockKind::Indented => String::new(),
                    };
                    open = Some(Code { line, info, text: String::new() });
                }
                Event::End(TagEnd::CodeBlock) => document.code.extend(open.take()),
                Event::Text(piece) => match (&mut open, document.sections.last_mut()) {
                    (Some(code), _) => code.text.push_str(&piece),
                    (None, Some(section)) => section.prose.push((line, piece.into_string())),
                    (None, None) => {}
                },
                Event::Code(span) => {
                    if let Some(section) = document.sections.last_mut() {
                        section.spans.push(span.into_string());
                    }
                }
                _ => {}
            }
        }
        document
    }
}

/// Returns the file that a link of a document refers to, from the root of the tree and without its fragment; `None` for
/// an external address or a place in the document itself.
pub(crate) fn leads_to(document: &str, target: &str) -> Option<String> {
    let path = target.split('#').next().unwrap_or_default();
    if path.is_empty() || target.contains("://") || target.starts_with("mailto:") {
        return None;
    }
    let folder = document.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    for part in path.split('/') {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()),
            name => parts.push(name),
        }
    }
    Some(parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "before\n# Head\nSay `x = 1` and [go](../a.md#b).\n\n```console\n$ run\nout\n```\n\n## Next\n| a |\n|---|\n| 7 ![p](p.svg) |\n";

    #[test]
    fn a_document_is_reported_by_its_parts() {
        let page = MarkdownText::read(PAGE);
        let links: Vec<(usize, &str)> = page.links.iter().map(|link| (link.line, link.target.as_str())).collect();
        assert_eq!(links, [(3, "../a.md#b"), (13, "p.svg")]);
        assert_eq!(page.links.iter().filter(|link| link.is_picture).count(), 1);
        assert_eq!(page.code, [Code { line: 5, info: "console".into(), text: "$ run\nout\n".into() }]);
        let levels: Vec<(usize, usize)> = page.sections.iter().map(|section| (section.line, section.level)).collect();
        assert_eq!(levels, [(1, 0), (2, 1), (10, 2)]);
        assert_eq!(page.sections[1].spans, ["x = 1"]);
        assert!(page.sections[2].prose.contains(&(13, "7 ".into())), "{:?}", page.sections[2]);
    }

    #[test]
    fn a_link_leads_to_a_file_of_the_tree() {
        assert_eq!(leads_to("docs/guide/a.md", "../../data/README.md#x").as_deref(), Some("data/README.md"));
        assert_eq!(leads_to("README.md", "docs/b.md").as_deref(), Some("docs/b.md"));
        assert_eq!(leads_to("docs/a.md", "#here"), None);
        assert_eq!(leads_to("docs/a.md", "https://example.org/x"), None);
    }
}

//! Links between the documents lead somewhere.

use std::path::Path;

use super::Finding;
use super::tree::Tree;

pub(super) fn rule(root: &Path) -> Vec<Finding> {
    let tree = Tree::read(root);
    let mut findings = Vec::new();
    for file in tree.files().filter(|file| is_document(file)) {
        let text = tree.text(file).unwrap_or_default();
        for (line, target) in targets(&text) {
            let there = resolve(file, &target).is_some_and(|path| tree.has(&path));
            if !there {
                let message = format!("link to `{target}` leads nowhere");
                findings.push(Finding { path: file.to_owned(), line, rule: "links", message });
            }
        }
    }
    findings
}

/// Documents at the root and in the folders that people read.
fn is_document(file: &str) -> bool {
    let folder = file.split_once('/').map(|(folder, _)| folder);
    file.ends_with(".md") && matches!(folder, None | Some("docs" | "data" | "examples"))
}

/// The text of every inline code span with its line, fenced blocks left out.
pub(super) fn code_spans(markdown: &str) -> Vec<(usize, String)> {
    let odd = |(number, line): (usize, &str)| {
        let spans: Vec<_> = line.split('`').skip(1).step_by(2).map(String::from).collect();
        spans.into_iter().map(move |span| (number, span))
    };
    prose(markdown).flat_map(odd).collect()
}

/// Local link targets with their line, the fragment cut off: `[…](target)` and `[name]: target`.
fn targets(markdown: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (number, line) in prose(markdown) {
        let visible: String = line.split('`').step_by(2).collect::<Vec<_>>().join(" ");
        let inline = visible.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        let definition =
            visible.trim_start().strip_prefix('[').and_then(|rest| rest.split_once("]: ")).map(|(_, target)| target);
        for target in inline.chain(definition) {
            let target = target.split_whitespace().next().unwrap_or_default();
            let target = target.trim_start_matches('<').trim_end_matches('>');
            let path = target.split('#').next().unwrap_or_default();
            let local = !target.starts_with('#') && !target.contains("://") && !target.starts_with("mailto:");
            if local {
                found.push((number, path.to_owned()));
            }
        }
    }
    found
}

/// The lines outside fenced blocks, numbered from 1.
fn prose(markdown: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut fenced = false;
    (1..).zip(markdown.lines()).filter(move |(_, line)| {
        let fence = line.trim_start().starts_with("```");
        fenced ^= fence;
        !fenced && !fence
    })
}

/// The path from the root that a target in `file` means; nothing if it is empty, absolute or outside.
fn resolve(file: &str, target: &str) -> Option<String> {
    if target.is_empty() || target.starts_with('/') {
        return None;
    }
    let mut parts: Vec<&str> = file.split('/').collect();
    parts.pop();
    for part in target.split('/') {
        match part {
            "." | "" => {}
            ".." => {
                parts.pop()?;
            }
            name => parts.push(name),
        }
    }
    Some(parts.join("/"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    #[test]
    fn links_that_lead_somewhere_are_fine() {
        let scratch = Scratch::new(&[
            (
                "README.md",
                "[a](docs/guide/first.md#start) [b](#here) [c](https://example.org) `[d](gone)`\n```\n[e](gone)\n```\n",
            ),
            ("docs/guide/first.md", "[up](../../README.md \"title\") [folder](../guide)\n[ref]: ../guide/first.md\n"),
        ]);
        assert_eq!(rule(scratch.root()), []);
    }

    #[test]
    fn links_that_lead_nowhere_are_found() {
        let scratch = Scratch::new(&[
            ("README.md", "\n[a](docs/gone.md) [b](/README.md)\n[c]: gone.md\n"),
            ("docs/here.md", "[out](../../README.md)"),
            ("crates/motion/notes.md", "[not a document](gone.md)"),
        ]);
        let told: Vec<String> = rule(scratch.root()).iter().map(Finding::to_string).collect();
        assert_eq!(
            told,
            [
                "README.md:2: links: link to `docs/gone.md` leads nowhere",
                "README.md:2: links: link to `/README.md` leads nowhere",
                "README.md:3: links: link to `gone.md` leads nowhere",
                "docs/here.md:1: links: link to `../../README.md` leads nowhere",
            ]
        );
    }
}

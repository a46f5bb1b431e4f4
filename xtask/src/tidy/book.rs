//! Rule: every document of `docs/` is a page of the book, and is listed in the README of the folder.

use std::path::Path;

use super::Violation;
use super::tree::Tree;
use crate::book::SUMMARY;
use crate::markdown::{MarkdownText, leads_to};

/// Lists that name every page.
const LISTS: [&str; 2] = [SUMMARY, "docs/README.md"];

pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let mut findings = Vec::new();
    for list in LISTS {
        let tell = |line, message| Violation { path: list.to_owned(), line, rule: "book", message };
        let Some(text) = tree.text(list) else {
            findings.push(tell(1, String::from("no such file")));
            continue;
        };
        let links = MarkdownText::read(&text).links;
        let named: Vec<(usize, String)> =
            links.iter().filter_map(|link| Some((link.line, leads_to(list, &link.target)?))).collect();
        for page in tree.under("docs", ".md").filter(|page| !LISTS.contains(page)) {
            if !named.iter().any(|(_, name)| name == page) {
                findings.push(tell(1, format!("`{page}` is not named: no reader finds it")));
            }
        }
        for (at, (line, name)) in named.iter().enumerate() {
            if !tree.has(name) {
                findings.push(tell(*line, format!("`{name}` is not in the tree")));
            }
            if list == SUMMARY && named.iter().take(at).any(|(_, before)| before == name) {
                findings.push(tell(*line, format!("`{name}` is named twice: a page has one place")));
            }
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    fn findings_of(summary: &str, list: &str) -> Vec<String> {
        let scratch = Scratch::new(&[(SUMMARY, summary), ("docs/README.md", list), ("docs/guide/a.md", "# A\n")]);
        rule(scratch.root()).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_page_is_named_in_both_lists() {
        let whole = "[a](guide/a.md)\n";
        assert_eq!(findings_of(whole, whole), Vec::<String>::new());
        assert_eq!(
            findings_of("# Summary\n", whole),
            ["docs/SUMMARY.md:1: book: `docs/guide/a.md` is not named: no reader finds it"]
        );
        assert_eq!(findings_of(whole, "# Documents\n").len(), 1);
    }

    #[test]
    fn a_page_that_is_gone_or_named_twice_is_reported() {
        let found = findings_of("[a](guide/a.md)\n[b](guide/b.md)\n[a](guide/a.md)\n", "[a](guide/a.md)\n");
        assert_eq!(
            found,
            [
                "docs/SUMMARY.md:2: book: `docs/guide/b.md` is not in the tree",
                "docs/SUMMARY.md:3: book: `docs/guide/a.md` is named twice: a page has one place",
            ]
        );
    }
}

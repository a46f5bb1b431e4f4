//! Rule: a doc comment opens with a noun phrase or a verb, not with a word listed in STYLE.md.

use std::path::Path;

use super::Violation;
use super::tree::Tree;

const STYLE: &str = "STYLE.md";
/// Section of STYLE.md with the openings as code.
const SECTION: &str = "### Openings that are not used";

/// Checks the first words of the doc comments.
pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let style = tree.text(STYLE).unwrap_or_default();
    let openings = openings(&style);
    let mut findings = Vec::new();
    for file in tree.under("", ".rs") {
        for (line, text) in first_lines(&tree.text(file).unwrap_or_default()) {
            let Some(opening) = openings.iter().find(|opening| opens(text, opening)) else { continue };
            let message = format!("a doc comment opens with `{opening}` ({STYLE}, {SECTION})");
            findings.push(Violation { path: file.to_owned(), line, rule: "openings", message });
        }
    }
    findings
}

/// Returns the code spans of the section.
fn openings(style: &str) -> Vec<&str> {
    let section = style.split_once(SECTION).map_or("", |(_, rest)| rest);
    let section = section.split("\n#").next().unwrap_or_default();
    section.split('`').skip(1).step_by(2).collect()
}

/// Returns the first line of each doc comment with its number.
fn first_lines(source: &str) -> Vec<(usize, &str)> {
    let mut before = "";
    let mut found = Vec::new();
    for (number, line) in (1..).zip(source.lines().map(str::trim_start)) {
        let mark = ["///", "//!"].into_iter().find(|mark| line.starts_with(mark));
        match mark {
            Some(mark) => {
                if before != mark {
                    found.push((number, line.trim_start_matches(mark).trim_start()));
                }
                before = mark;
            }
            // An attribute may stand between the lines of a comment.
            None if line.starts_with("#[") => {}
            None => before = "",
        }
    }
    found
}

/// Returns `true` if a text opens with whole words.
fn opens(text: &str, opening: &str) -> bool {
    text.strip_prefix(opening).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const LIST: &str =
        "# Style\n\n### Openings that are not used\n\nNot `What`, `So many`.\n\n## Errors\n\n`Returns`\n";

    #[test]
    fn an_opening_of_the_list_is_found_at_the_beginning_of_a_comment() {
        let source = "//! What it is.\n\n/// Returns it.\n/// What follows is no opening.\nfn a() {}\n\n    /// So many\n    /// rows.\n#[test]\nfn b() {}\n/// Whatever, so many.\n// What\n";
        let scratch = Scratch::new(&[(STYLE, LIST), ("crates/a/src/lib.rs", source)]);
        let found: Vec<(usize, String)> =
            rule(scratch.root()).into_iter().map(|finding| (finding.line, finding.message)).collect();
        assert_eq!(found.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [1, 7], "{found:#?}");
        assert!(found.iter().any(|(_, message)| message.contains("`So many`")));
    }

    #[test]
    fn the_list_of_the_house_is_read() {
        let found = openings(include_str!("../../../STYLE.md"));
        assert!(found.contains(&"Whether") && found.contains(&"The same") && found.len() > 20, "{found:?}");
    }
}

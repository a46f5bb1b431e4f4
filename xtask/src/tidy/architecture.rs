//! Rule: ARCHITECTURE.md names every crate, and every path it names exists.

use std::path::Path;

use super::Violation;
use super::manifest::Members;
use super::tree::Tree;

const FILE: &str = "ARCHITECTURE.md";

pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let tell = |line, message| Violation { path: FILE.to_owned(), line, rule: "architecture", message };
    let Some(text) = tree.text(FILE) else {
        return vec![tell(1, String::from("no such file"))];
    };
    let spans = code_spans(&text);
    let mut findings = Vec::new();
    for member in Members::read(root).list {
        let name = member.package.name.as_str();
        if !spans.iter().any(|(_, span)| span == name) {
            findings.push(tell(1, format!("crate `{name}` is not named")));
        }
    }
    for (line, span) in spans.iter().filter(|(_, span)| is_path(span)) {
        if !tree.has(span) {
            findings.push(tell(*line, format!("`{span}` is not in the tree")));
        }
    }
    findings
}

/// Returns the inline code spans with their lines, without fenced blocks.
fn code_spans(markdown: &str) -> Vec<(usize, String)> {
    let mut fenced = false;
    let mut found = Vec::new();
    for (number, line) in (1..).zip(markdown.lines()) {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            found.extend(line.split('`').skip(1).step_by(2).map(|span| (number, span.to_owned())));
        }
    }
    found
}

/// Returns `true` for a path: a slash and no sign of a placeholder.
fn is_path(span: &str) -> bool {
    span.contains('/') && !span.contains("://") && !span.contains([' ', '*', '<', '>', '{', '}', '…', '?'])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    fn findings_of(architecture: &str) -> Vec<String> {
        let scratch = Scratch::new(&[
            ("Cargo.toml", "[workspace]\nmembers = [\"crates/*\"]\n"),
            ("crates/motion/Cargo.toml", "[package]\nname = \"motion\"\n"),
            ("crates/motion/src/lib.rs", ""),
            (FILE, architecture),
        ]);
        rule(scratch.root()).iter().map(Violation::to_string).collect()
    }

    #[test]
    fn a_crate_in_backticks_and_a_path_that_exists_are_fine() {
        assert!(
            findings_of(
                "`motion` lives in `crates/motion/`; `crates/*` and `a / b` are no paths\n```text\n`no/span`\n```\n"
            )
            .is_empty()
        );
    }

    #[test]
    fn a_crate_left_out_is_found() {
        assert_eq!(
            findings_of("motion is only mentioned"),
            ["ARCHITECTURE.md:1: architecture: crate `motion` is not named"]
        );
    }

    #[test]
    fn a_path_that_is_gone_is_found() {
        assert_eq!(
            findings_of("# Rooms\n`motion` was in `crates/move`"),
            ["ARCHITECTURE.md:2: architecture: `crates/move` is not in the tree"]
        );
    }

    #[test]
    fn the_document_itself_must_be_there() {
        assert_eq!(rule(Scratch::new(&[]).root()).len(), 1);
    }
}

//! Rules for files as text: length of a source, and no markers for later work.

use std::path::Path;

use super::Violation;
use super::tree::Tree;

const LINES_MAX: usize = 600;

/// Marker of a known flaw, in two parts, so that this file satisfies the rule too.
const MARK: &str = concat!("FIX", "ME");

/// Checks the length of the sources; a file too long to be read in one sitting holds two subjects.
pub(super) fn length(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let long = |file: &str| {
        let lines = tree.text(file).unwrap_or_default().lines().count();
        let message = format!("{lines} lines, at most {LINES_MAX}: split it by subject");
        (lines > LINES_MAX).then(|| Violation { path: file.to_owned(), line: LINES_MAX + 1, rule: "length", message })
    };
    tree.under("", ".rs").filter_map(long).collect()
}

/// Checks that the tree has no marker for later work. Unfinished code is found by clippy (`todo`, `unimplemented`).
pub(super) fn markers(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let mut findings = Vec::new();
    for file in tree.files() {
        let text = tree.text(file).unwrap_or_default();
        for (line, _) in (1..).zip(text.lines()).filter(|(_, line)| line.contains(MARK)) {
            let message = format!("`{MARK}`: mend it or open an issue");
            findings.push(Violation { path: file.to_owned(), line, rule: "marker", message });
        }
    }
    findings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    fn places(findings: &[Violation]) -> Vec<(&str, usize)> {
        findings.iter().map(|finding| (finding.path.as_str(), finding.line)).collect()
    }

    #[test]
    fn a_long_file_is_found() {
        let (fits, long) = ("\n".repeat(600), "\n".repeat(601));
        let scratch = Scratch::new(&[("a.rs", &fits), ("b.rs", &long), ("c.txt", &long)]);
        assert_eq!(places(&length(scratch.root())), [("b.rs", 601)]);
    }

    #[test]
    fn a_mark_is_found_in_any_text() {
        let (source, data) = (format!("fn f() {{}}\n// {MARK}\n"), format!("# {MARK}: digit\n"));
        let scratch = Scratch::new(&[("a.rs", &source), ("data/b.toml", &data)]);
        assert_eq!(places(&markers(scratch.root())), [("a.rs", 2), ("data/b.toml", 1)]);
    }
}

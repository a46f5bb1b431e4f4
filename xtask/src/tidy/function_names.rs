//! Rule: a function is named by what it does or returns, not by a word listed in STYLE.md.

use std::collections::BTreeSet;
use std::path::Path;

use super::Violation;
use super::tree::Tree;

const STYLE: &str = "STYLE.md";
/// Section of STYLE.md with the names as code.
const SECTION: &str = "### Names of functions that are not used";

/// Checks the names of functions in the sources, without the files of tests.
pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let style = tree.text(STYLE).unwrap_or_default();
    let listed = listed(&style);
    let mut findings = Vec::new();
    for file in tree.under("", ".rs") {
        if file.ends_with("tests.rs") || file.split('/').any(|folder| folder == "tests") {
            continue;
        }
        for (line, name) in functions(&tree.text(file).unwrap_or_default()) {
            if listed.contains(name.as_str()) {
                let message = format!("`{name}` does not say what the function does ({STYLE}, {SECTION})");
                findings.push(Violation { path: file.to_owned(), line, rule: "function-names", message });
            }
        }
    }
    findings
}

/// Returns the names among the code spans of the section.
fn listed(style: &str) -> BTreeSet<&str> {
    let section = style.split_once(SECTION).map_or("", |(_, rest)| rest);
    let section = section.split("\n#").next().unwrap_or_default();
    section.split('`').skip(1).step_by(2).filter(|span| span.starts_with(char::is_lowercase)).collect()
}

/// Returns the names of the functions, with their lines.
fn functions(source: &str) -> Vec<(usize, String)> {
    let of = |line: &str| {
        let line = line.trim_start();
        let (before, rest) = line.split_once("fn ")?;
        let is_head = before.split_whitespace().all(|word| {
            word.starts_with("pub") || ["const", "async", "unsafe", "extern", "super)", "crate)"].contains(&word)
        });
        let name: String = rest.chars().take_while(|letter| letter.is_alphanumeric() || *letter == '_').collect();
        (is_head && !name.is_empty()).then_some(name)
    };
    (1..).zip(source.lines()).filter_map(|(number, line)| Some((number, of(line)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    #[test]
    fn a_listed_name_is_found_in_the_sources_alone() {
        let style = "# Style\n\n### Names of functions that are not used\n\n`cargo xtask tidy`: `put`, `near`.\n\n## Errors\n\n`talk`\n";
        let scratch = Scratch::new(&[
            (STYLE, style),
            (
                "crates/a/src/lib.rs",
                "fn input() {}\n    pub(super) const fn put(a: u8) {}\nfn talk() {}\n// a fn near it\n",
            ),
            ("crates/a/src/lib_tests.rs", "fn near() {}\n"),
            ("crates/a/tests/it.rs", "fn near() {}\n"),
            ("xtask/src/lib.rs", "pub fn near<T>() {}\nlet near = |fn near| 1;\n"),
        ]);
        let found: Vec<String> =
            rule(scratch.root()).iter().map(|each| format!("{}:{}", each.path, each.line)).collect();
        assert_eq!(found, ["crates/a/src/lib.rs:2", "xtask/src/lib.rs:1"]);
    }
}

//! Rule: a type that other modules see has a name that no two other crates use, unless STYLE.md lists the name.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::Violation;
use super::tree::Tree;

const STYLE: &str = "STYLE.md";
/// Section of STYLE.md with the permitted names as code.
const SECTION: &str = "### Names in several crates";
/// Number of crates that may use a name without an entry in the list.
const CRATES_MOST: usize = 2;
/// Number of entries that the list may have.
const ENTRIES_MOST: usize = 25;

/// Checks the names of types in the sources of all crates.
pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let style = tree.text(STYLE).unwrap_or_default();
    let listed = listed(&style);
    let mut places: BTreeMap<String, BTreeMap<String, (String, usize)>> = BTreeMap::new();
    for file in tree.under("", ".rs") {
        let is_test = file.ends_with("_tests.rs") || file.split('/').any(|folder| folder == "tests");
        let Some(home) = home(file).filter(|_| !is_test) else { continue };
        for (line, name) in types(&tree.text(file).unwrap_or_default()) {
            places.entry(name).or_default().entry(home.clone()).or_insert((file.to_owned(), line));
        }
    }
    let violation = |path: &str, line, message| Violation { path: path.to_owned(), line, rule: "type-names", message };
    let mut findings = Vec::new();
    for (name, crates) in &places {
        if crates.len() > CRATES_MOST && !listed.contains(name.as_str()) {
            let all: Vec<&str> = crates.keys().map(String::as_str).collect();
            let message = format!("the type name `{name}` stands in {} crates ({})", all.len(), all.join(", "));
            findings.extend(crates.values().next().map(|(path, line)| violation(path, *line, message)));
        }
    }
    for name in &listed {
        if places.get(*name).is_none_or(|crates| crates.len() <= CRATES_MOST) {
            findings.push(violation(
                STYLE,
                0,
                format!("`{name}` is listed, but no name in several crates ({SECTION})"),
            ));
        }
    }
    if listed.len() > ENTRIES_MOST {
        findings.push(violation(
            STYLE,
            0,
            format!("{} names are listed, at most {ENTRIES_MOST} ({SECTION})", listed.len()),
        ));
    }
    findings
}

/// Returns the names of types among the code spans of the section.
fn listed(style: &str) -> BTreeSet<&str> {
    let section = style.split_once(SECTION).map_or("", |(_, rest)| rest);
    let section = section.split("\n#").next().unwrap_or_default();
    section.split('`').skip(1).step_by(2).filter(|span| span.starts_with(char::is_uppercase)).collect()
}

/// Returns the crate of a source; a folder beside `crates` counts as one.
fn home(file: &str) -> Option<String> {
    let (first, rest) = file.split_once('/')?;
    Some(if first == "crates" { rest.split('/').next()? } else { first }.to_owned())
}

/// Returns the names of the types that other modules see, with their lines.
fn types(source: &str) -> Vec<(usize, String)> {
    let of = |line: &str| {
        let rest = line.trim_start().strip_prefix("pub")?;
        let rest = if let Some(scope) = rest.strip_prefix('(') { scope.split_once(')')?.1 } else { rest };
        let (kind, name) = rest.trim_start().split_once(' ')?;
        let name: String = name.chars().take_while(|letter| letter.is_alphanumeric()).collect();
        (["struct", "enum", "trait", "type"].contains(&kind) && !name.is_empty()).then_some(name)
    };
    (1..).zip(source.lines()).filter_map(|(number, line)| Some((number, of(line)?))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const LIST: &str = "# Style\n\n### Names in several crates\n\nThese: `Fault`, `Lone`.\n\n## Errors\n\n`Table`\n";

    #[test]
    fn a_name_in_three_crates_is_found_unless_it_is_listed() {
        let scratch = Scratch::new(&[
            (STYLE, LIST),
            ("crates/a/src/lib.rs", "pub struct Table {\n}\npub enum Fault {}\nstruct Row;\npub struct Cell;"),
            ("crates/b/src/lib.rs", "pub(crate) enum Table {}\npub struct Fault;\npub struct Row;"),
            ("crates/b/src/it_tests.rs", "pub struct Cell;"),
            ("crates/b/tests/it.rs", "pub struct Row;"),
            (
                "xtask/src/lib.rs",
                "\n    pub(super) trait Table: Copy {}\n pub type Fault = ();\npub struct Row;\npub struct Cell;",
            ),
        ]);
        let found: Vec<String> = rule(scratch.root()).iter().map(ToString::to_string).collect();
        assert_eq!(found.len(), 2, "{found:#?}");
        assert!(found.iter().any(|each| {
            each.contains("crates/a/src/lib.rs:1: type-names: the type name `Table` stands in 3 crates (a, b, xtask)")
        }));
        assert!(found.iter().any(|each| each.contains("`Lone` is listed")));
    }

    #[test]
    fn the_list_is_short() {
        let names: Vec<String> = (0..=ENTRIES_MOST).map(|number| format!("`N{number}`")).collect();
        let list = format!("{SECTION}\n\n{}\n", names.join(" "));
        let scratch = Scratch::new(&[(STYLE, list.as_str())]);
        assert!(rule(scratch.root()).iter().any(|finding| finding.message.starts_with("26 names")));
    }
}

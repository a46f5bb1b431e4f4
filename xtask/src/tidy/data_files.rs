//! Rule: every hand-written TOML file is valid, and a table file is named after its table.

use std::path::Path;

use super::Violation;
use super::tree::Tree;

pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let mut findings = Vec::new();
    for file in tree.under("data", ".toml").chain(tree.under("examples", ".toml")) {
        let text = tree.text(file).unwrap_or_default();
        if let Some((line, message)) = objection(file, &text) {
            findings.push(Violation { path: file.to_owned(), line, rule: "data", message });
        }
    }
    findings
}

fn objection(file: &str, text: &str) -> Option<(usize, String)> {
    let document: toml::Table = match text.parse() {
        Ok(document) => document,
        Err(error) => {
            let error: toml::de::Error = error;
            let before = error.span().and_then(|span| text.get(..span.start)).unwrap_or_default();
            return Some((before.matches('\n').count() + 1, error.message().to_owned()));
        }
    };
    let name = file.rsplit('/').next().and_then(|name| name.strip_suffix(".toml"))?;
    let line = 1 + text.lines().position(|line| line.starts_with("table")).unwrap_or(0);
    match document.get("table") {
        Some(toml::Value::String(table)) if table == name => None,
        Some(table) => Some((line, format!("table {table} in a file named `{name}`"))),
        None if file.starts_with("data/") && file.contains("/tables/") => {
            Some((1, String::from("a table file without `table`")))
        }
        None => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    #[test]
    fn tables_under_their_own_name_and_other_files_are_fine() {
        let scratch = Scratch::new(&[
            ("data/cha/tables/26.2.toml", "table = \"26.2\"\n"),
            ("data/sources.toml", "[[source]]\nid = \"cha-manual\"\n"),
            ("examples/table.toml", "format = 1\n"),
        ]);
        assert_eq!(rule(scratch.root()), []);
    }

    #[test]
    fn broken_misnamed_and_nameless_files_are_found() {
        let scratch = Scratch::new(&[
            ("data/cha/tables/26.2.toml", "# moved\ntable = \"26.3\"\n"),
            ("data/cha/tables/26.3.toml", "page = 26\n"),
            ("data/published/x.toml", "table = 7\n"),
            ("examples/table.toml", "format = 1\nname = \n"),
        ]);
        let listed: Vec<String> = rule(scratch.root()).iter().map(Violation::to_string).collect();
        assert_eq!(listed.len(), 4, "{listed:?}");
        assert_eq!(listed[0], "data/cha/tables/26.2.toml:2: data: table \"26.3\" in a file named `26.2`");
        assert_eq!(listed[1], "data/cha/tables/26.3.toml:1: data: a table file without `table`");
        assert!(listed[2].starts_with("data/published/x.toml:1: "), "{}", listed[2]);
        assert!(listed[3].starts_with("examples/table.toml:2: "), "{}", listed[3]);
    }
}

//! The members of the workspace and what their manifests say.

use std::path::Path;

use super::Finding;
use super::tree::Tree;

pub(super) struct Member {
    /// Folder from the root.
    pub(super) folder: String,
    /// Name of the package.
    pub(super) name: String,
    text: String,
    table: toml::Table,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Normal,
    Build,
    Dev,
}

pub(super) struct Dependency {
    pub(super) kind: Kind,
    pub(super) name: String,
    /// Line in the member's manifest.
    pub(super) line: usize,
}

pub(super) struct Members {
    pub(super) list: Vec<Member>,
    pub(super) findings: Vec<Finding>,
    renamed: Vec<(String, String)>,
}

impl Members {
    /// Reads the root manifest and those of all members; what cannot be read is a finding.
    pub(super) fn read(tree: &Tree) -> Self {
        let mut members = Self { list: Vec::new(), findings: Vec::new(), renamed: Vec::new() };
        let Some((_, top)) = members.manifest(tree, "Cargo.toml") else { return members };
        let workspace = top.get("workspace");
        let globs = workspace.and_then(|table| table.get("members")).and_then(|list| list.as_array());
        let shared = workspace.and_then(|table| table.get("dependencies"));
        members.renamed = shared.map(renames).unwrap_or_default();
        for glob in globs.into_iter().flatten().filter_map(|glob| glob.as_str()) {
            for folder in folders(tree, glob) {
                let path = format!("{folder}/Cargo.toml");
                let Some((text, table)) = members.manifest(tree, &path) else { continue };
                let name = table.get("package").and_then(|package| package.get("name"));
                match name.and_then(|name| name.as_str()).map(String::from) {
                    Some(name) => members.list.push(Member { folder, name, text, table }),
                    None => members.broken(&path, "no package name"),
                }
            }
        }
        if members.list.is_empty() {
            members.broken("Cargo.toml", "the workspace has no members");
        }
        members
    }

    fn manifest(&mut self, tree: &Tree, path: &str) -> Option<(String, toml::Table)> {
        let text = tree.text(path).or_else(|| {
            self.broken(path, "no such file");
            None
        })?;
        match text.parse() {
            Ok(table) => Some((text, table)),
            Err(_) => {
                self.broken(path, "is no TOML");
                None
            }
        }
    }

    fn broken(&mut self, path: &str, message: &str) {
        let (path, message) = (path.to_owned(), message.to_owned());
        self.findings.push(Finding { path, line: 1, rule: "manifest", message });
    }

    /// Every dependency of a member under the package's real name.
    pub(super) fn dependencies(&self, member: &Member) -> Vec<Dependency> {
        let mut found = Vec::new();
        let targets = member.table.get("target").and_then(|targets| targets.as_table());
        let conditional = targets.into_iter().flatten().filter_map(|(_, table)| table.as_table());
        for table in std::iter::once(&member.table).chain(conditional) {
            for (key, kind) in
                [("dependencies", Kind::Normal), ("build-dependencies", Kind::Build), ("dev-dependencies", Kind::Dev)]
            {
                let entries = table.get(key).and_then(|entries| entries.as_table());
                for (name, how) in entries.into_iter().flatten() {
                    let name = self.real_name(name, how);
                    let line = member.line_of(key, &name);
                    found.push(Dependency { kind, name, line });
                }
            }
        }
        found
    }

    fn real_name(&self, key: &str, how: &toml::Value) -> String {
        let own = how.get("package").and_then(|name| name.as_str());
        let shared = || self.renamed.iter().find(|(from, _)| from == key).map(|(_, to)| to.as_str());
        own.or_else(shared).unwrap_or(key).to_owned()
    }
}

impl Member {
    pub(super) fn manifest(&self) -> String {
        format!("{}/Cargo.toml", self.folder)
    }

    /// Line where a dependency stands; the first line if it hides in a form not looked for.
    fn line_of(&self, section: &str, name: &str) -> usize {
        let mut inside = false;
        for (number, line) in (1..).zip(self.text.lines()) {
            let line = line.trim();
            if line.starts_with('[') {
                inside = line.trim_matches(['[', ']']).ends_with(section);
            } else if inside && line.contains(name) {
                return number;
            }
        }
        1
    }
}

/// Every member takes the lints of the workspace.
pub(super) fn lints(root: &Path) -> Vec<Finding> {
    let members = Members::read(&Tree::read(root));
    let inherits = |member: &Member| {
        let lints = member.table.get("lints").and_then(|lints| lints.get("workspace"));
        lints.and_then(|flag| flag.as_bool()) == Some(true)
    };
    let mut findings = members.findings.clone();
    findings.extend(members.list.iter().filter(|member| !inherits(member)).map(|member| Finding {
        path: member.manifest(),
        line: 1,
        rule: "lints",
        message: String::from("`[lints] workspace = true` is missing"),
    }));
    findings
}

/// `crates/*` is every folder in `crates` with a manifest; anything else is a folder itself.
fn folders(tree: &Tree, glob: &str) -> Vec<String> {
    let Some(parent) = glob.strip_suffix("/*") else { return vec![glob.to_owned()] };
    tree.under(parent, "/Cargo.toml")
        .filter_map(|file| file.strip_suffix("/Cargo.toml"))
        .filter(|folder| folder.strip_prefix(parent).is_some_and(|rest| rest.matches('/').count() == 1))
        .map(String::from)
        .collect()
}

fn renames(shared: &toml::Value) -> Vec<(String, String)> {
    let entries = shared.as_table().into_iter().flatten();
    let renamed = |(key, how): (&String, &toml::Value)| {
        let package = how.get("package").and_then(|name| name.as_str());
        package.map(|package| (key.clone(), package.to_owned()))
    };
    entries.filter_map(renamed).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const TOP: (&str, &str) = ("Cargo.toml", "[workspace]\nmembers = [\"crates/*\", \"xtask\"]\n");

    #[test]
    fn a_member_without_the_lints_is_found() {
        let scratch = Scratch::new(&[
            TOP,
            ("crates/motion/Cargo.toml", "[package]\nname = \"motion\"\n[lints]\nworkspace = true\n"),
            ("crates/sizing/Cargo.toml", "[package]\nname = \"sizing\"\n"),
            ("xtask/Cargo.toml", "[package]\nname = \"xtask\"\n[lints]\nworkspace = false\n"),
        ]);
        let paths: Vec<String> = lints(scratch.root()).into_iter().map(|found| found.path).collect();
        assert_eq!(paths, ["crates/sizing/Cargo.toml", "xtask/Cargo.toml"]);
    }

    #[test]
    fn a_listed_member_that_is_gone_is_found() {
        let scratch = Scratch::new(&[TOP]);
        let messages: Vec<String> = lints(scratch.root()).iter().map(Finding::to_string).collect();
        assert_eq!(
            messages,
            ["xtask/Cargo.toml:1: manifest: no such file", "Cargo.toml:1: manifest: the workspace has no members"]
        );
    }
}

//! Members of the workspace, with their manifests as read by cargo.

use std::path::Path;

use cargo_metadata::{Dependency, Package};

use super::Violation;
use super::tree::Tree;
use crate::cargo::metadata;

pub(super) struct Members {
    pub(super) list: Vec<Member>,
    /// Reason for a missing list.
    pub(super) findings: Vec<Violation>,
}

pub(super) struct Member {
    pub(super) package: Package,
    /// Path of the manifest, relative to the root of the tree.
    pub(super) manifest: String,
}

impl Members {
    pub(super) fn read(root: &Path) -> Self {
        let listing = match metadata(root, |command| command.no_deps()) {
            Ok(listing) => listing,
            Err(error) => {
                let (path, message) = (String::from("Cargo.toml"), error.to_string());
                return Self {
                    list: Vec::new(),
                    findings: vec![Violation { path, line: 1, rule: "manifest", message }],
                };
            }
        };
        let top = &listing.workspace_root;
        let member = |package: Package| {
            let manifest = package.manifest_path.strip_prefix(top).unwrap_or(&package.manifest_path);
            let manifest = manifest.as_str().replace('\\', "/");
            Member { package, manifest }
        };
        Self { list: listing.packages.into_iter().map(member).collect(), findings: Vec::new() }
    }
}

impl Member {
    /// Returns the line of the manifest with a dependency; the first line if it is not found.
    pub(super) fn line_of(&self, dependency: &Dependency) -> usize {
        let text = std::fs::read_to_string(&self.package.manifest_path).unwrap_or_default();
        let key = dependency.rename.as_ref().unwrap_or(&dependency.name);
        let stands =
            |line: &str| line.trim_start().strip_prefix(key.as_str()).is_some_and(|rest| !rest.starts_with('-'));
        1 + text.lines().position(stands).unwrap_or(0)
    }
}

/// Members with their own lint table: that of the workspace, except that one of their files may permit unsafe code.
const OWN_LINTS: [&str; 2] = ["python", "site"];

/// Checks that every member uses the lints of the workspace, which cargo does not report.
pub(super) fn lints(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let members = Members::read(root);
    let table = |path: &str| -> toml::Table { tree.text(path).unwrap_or_default().parse().unwrap_or_default() };
    let top = table("Cargo.toml");
    let mut liftable = top.get("workspace").and_then(|workspace| workspace.get("lints")).cloned();
    if let Some(lint) = liftable.as_mut().and_then(|lints| lints.get_mut("rust")?.get_mut("unsafe_code")) {
        *lint = toml::Value::from("deny");
    }
    let inherits = |member: &Member| {
        let table = table(&member.manifest);
        let lints = table.get("lints");
        let is_own = OWN_LINTS.contains(&member.package.name.as_str()) && lints == liftable.as_ref();
        is_own || lints.and_then(|lints| lints.get("workspace")).and_then(|flag| flag.as_bool()) == Some(true)
    };
    let mut findings = members.findings;
    findings.extend(members.list.iter().filter(|member| !inherits(member)).map(|member| Violation {
        path: member.manifest.clone(),
        line: 1,
        rule: "lints",
        message: String::from("`[lints] workspace = true` is missing"),
    }));
    findings
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const TOP: (&str, &str) = (
        "Cargo.toml",
        "[workspace]\nmembers = [\"crates/*\", \"xtask\"]\n[workspace.lints.rust]\nunsafe_code = \"forbid\"\n",
    );

    #[test]
    fn a_member_without_the_lints_is_found() {
        let scratch = Scratch::new(&[
            TOP,
            ("crates/motion/Cargo.toml", "[package]\nname = \"motion\"\n[lints]\nworkspace = true\n"),
            ("crates/motion/src/lib.rs", ""),
            ("crates/sizing/Cargo.toml", "[package]\nname = \"sizing\"\n"),
            ("crates/sizing/src/lib.rs", ""),
            ("xtask/Cargo.toml", "[package]\nname = \"xtask\"\n[lints.clippy]\nall = \"warn\"\n"),
            ("xtask/src/lib.rs", ""),
            ("crates/site/Cargo.toml", "[package]\nname = \"site\"\n[lints.rust]\nunsafe_code = \"deny\"\n"),
            ("crates/site/src/lib.rs", ""),
            ("crates/plot/Cargo.toml", "[package]\nname = \"plot\"\n[lints.rust]\nunsafe_code = \"deny\"\n"),
            ("crates/plot/src/lib.rs", ""),
        ]);
        let paths: Vec<String> = lints(scratch.root()).into_iter().map(|found| found.path).collect();
        assert_eq!(paths, ["crates/plot/Cargo.toml", "crates/sizing/Cargo.toml", "xtask/Cargo.toml"]);
    }

    #[test]
    fn a_workspace_that_cargo_refuses_is_found() {
        let listing: Vec<String> = lints(Scratch::new(&[TOP]).root()).iter().map(Violation::to_string).collect();
        assert_eq!(listing.len(), 1, "{listing:?}");
        assert!(listing[0].starts_with("Cargo.toml:1: manifest: `cargo metadata` has no answer: "), "{listing:?}");
    }
}

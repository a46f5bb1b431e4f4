//! Files of the tree: those that git tracks or would track.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::Violation;

pub(crate) struct Tree {
    root: PathBuf,
    files: Vec<String>,
}

impl Tree {
    /// Reads the list of files from git; a tree without git (a source archive) is walked instead.
    pub(crate) fn read(root: &Path) -> Self {
        let mut files = tracked(root).unwrap_or_else(|| walked(root));
        files.retain(|file| root.join(file).is_file());
        files.sort();
        files.dedup();
        Self { root: root.to_path_buf(), files }
    }

    pub(crate) fn files(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(String::as_str)
    }

    /// Iterates over the files under one folder (`""` is the root) with one ending.
    pub(crate) fn under(&self, folder: &str, ending: &str) -> impl Iterator<Item = &str> {
        self.files().filter(move |file| {
            file.ends_with(ending)
                && (folder.is_empty() || file.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/')))
        })
    }

    /// Returns the text of a file; `None` if it is no text.
    pub(crate) fn text(&self, file: &str) -> Option<String> {
        fs::read(self.root.join(file)).ok().and_then(|bytes| String::from_utf8(bytes).ok())
    }

    /// Returns `true` if a file of the tree has this path or lies under it. Empty folders do not exist: a clone has
    /// none.
    pub(crate) fn has(&self, path: &str) -> bool {
        let path = path.trim_end_matches('/');
        path.is_empty()
            || self
                .files()
                .any(|file| file.strip_prefix(path).is_some_and(|rest| rest.is_empty() || rest.starts_with('/')))
    }
}

/// Reports a tree without files, which would pass every rule.
pub(super) fn not_empty(root: &Path) -> Vec<Violation> {
    if Tree::read(root).files.is_empty() {
        let message = format!("no files in {}", root.display());
        return vec![Violation { path: String::from("."), line: 1, rule: "tree", message }];
    }
    Vec::new()
}

fn tracked(root: &Path) -> Option<Vec<String>> {
    if !root.join(".git").exists() {
        return None;
    }
    let output = Command::new("git")
        .args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"])
        .current_dir(root)
        .stderr(Stdio::null())
        .output()
        .ok()
        .filter(|output| output.status.success())?;
    let names = String::from_utf8(output.stdout).ok()?;
    Some(names.split('\0').filter(|name| !name.is_empty()).map(String::from).collect())
}

fn walked(root: &Path) -> Vec<String> {
    let mut files = Vec::new();
    let mut folders = vec![String::new()];
    while let Some(folder) = folders.pop() {
        let Ok(entries) = fs::read_dir(root.join(&folder)) else { continue };
        for entry in entries.flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = if folder.is_empty() { name.clone() } else { format!("{folder}/{name}") };
            match entry.file_type() {
                Ok(kind) if kind.is_dir() && name != ".git" && name != "target" => folders.push(path),
                Ok(kind) if kind.is_file() => files.push(path),
                _ => {}
            }
        }
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    #[test]
    fn an_empty_tree_is_a_finding() {
        assert_eq!(not_empty(Scratch::new(&[]).root()).len(), 1);
    }

    #[test]
    fn a_folder_is_there_by_its_files() {
        let scratch = Scratch::new(&[("docs/guide/first.md", ""), ("target/x.rs", "")]);
        let tree = Tree::read(scratch.root());
        assert_eq!(tree.files().collect::<Vec<_>>(), ["docs/guide/first.md"]);
        assert!(tree.has("docs/guide/") && tree.has("docs") && !tree.has("doc"));
        assert_eq!(tree.under("docs", ".md").count(), 1);
        assert_eq!(tree.under("doc", ".md").count(), 0);
    }
}

//! Rule: no shared file contains a path of a personal machine.

use std::path::Path;

use super::Violation;
use super::tree::Tree;

/// Folders that exist on personal machines only, without their first slash, so that this file satisfies the rule too.
const FOLDERS: [&str; 4] = ["home/", "root/", "tmp/", "work/"];

pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let mut findings = Vec::new();
    for file in tree.files() {
        let text = tree.text(file).unwrap_or_default();
        for (line, content) in (1..).zip(text.lines()) {
            if let Some(folder) = FOLDERS.iter().find(|folder| holds(content, folder)) {
                let message = format!("path of one machine: /{folder}…");
                findings.push(Violation { path: file.to_owned(), line, rule: "machine-path", message });
            }
        }
    }
    findings
}

/// Returns `true` if an absolute path into `folder` begins in the line, not in the middle of a relative path or an
/// address.
fn holds(line: &str, folder: &str) -> bool {
    line.match_indices('/').any(|(at, _)| {
        let (before, after) = (line.get(..at).unwrap_or_default(), line.get(at + 1..).unwrap_or_default());
        let inside = before.ends_with(|last: char| last.is_alphanumeric() || "._-~}*)".contains(last));
        after.starts_with(folder) && !inside
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    #[test]
    fn a_path_of_one_machine_is_found_in_any_text() {
        let lines: Vec<String> = FOLDERS.iter().map(|folder| format!("x = \"/{folder}a\"\n")).collect();
        let text = format!("fine\n{}see file:///{}b\n", lines.concat(), FOLDERS[0]);
        let scratch = Scratch::new(&[("notes.txt", &text)]);
        let found: Vec<usize> = rule(scratch.root()).iter().map(|finding| finding.line).collect();
        assert_eq!(found, [2, 3, 4, 5, 6]);
    }

    #[test]
    fn relative_paths_and_addresses_are_fine() {
        let text = "docs/home/index.md https://example.org/work/ ./tmp/x ${DIR}/tmp/ network/ /target\n";
        assert_eq!(rule(Scratch::new(&[("a.md", text)]).root()), []);
    }
}

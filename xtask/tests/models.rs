//! Every model that a result refers to has its page under `docs/theory`.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use std::path::{Path, PathBuf};

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn every_cited_model_has_a_page() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    sources(&root.join("crates"), &mut files);
    let mut cited = Vec::new();
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        for part in text.split("Model { name: \"").skip(1) {
            cited.push(part.split('"').next().unwrap_or_default().to_owned());
        }
    }
    cited.sort();
    cited.dedup();
    assert!(cited.len() >= 5, "{cited:?}");
    for name in cited {
        let page = root.join("docs/theory").join(format!("{name}.md"));
        assert!(page.is_file(), "docs/theory/{name}.md is missing");
    }
}

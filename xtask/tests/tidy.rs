//! The rules of the house hold in the tree as it is, so `cargo test` holds them too.

#[test]
fn the_tree_is_tidy() {
    let findings = xtask::tidy::findings(&xtask::root());
    let listed: Vec<String> = findings.iter().map(ToString::to_string).collect();
    assert!(listed.is_empty(), "{} findings:\n{}", listed.len(), listed.join("\n"));
}

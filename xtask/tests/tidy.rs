//! The tree satisfies the house rules, so `cargo test` checks them too.

#[test]
fn the_tree_is_tidy() {
    let findings = xtask::tidy::findings(&xtask::root());
    let listed: Vec<String> = findings.iter().map(ToString::to_string).collect();
    assert!(listed.is_empty(), "{} findings:\n{}", listed.len(), listed.join("\n"));
}

//! The data are consistent, so `cargo test` checks them too.

#[test]
fn every_deviation_is_explained_and_every_erratum_explains_one() {
    let findings = xtask::audit::run().findings();
    assert!(findings.is_empty(), "{} findings:\n{}", findings.len(), findings.join("\n"));
}

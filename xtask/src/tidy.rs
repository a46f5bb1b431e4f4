//! House rules that no compiler and no standard tool checks; all findings are reported together.
//!
//! A rule is a function from the root of a tree to its findings, so each is tested on small trees that violate it.

use std::fmt;
use std::path::Path;

use crate::Error;

mod architecture;
mod book;
mod circles;
mod data_files;
mod function_names;
mod guides;
pub(crate) mod layers;
mod machine_paths;
mod manifest;
mod one_voice;
mod openings;
mod plain_words;
mod source;
pub(crate) mod tree;
mod type_names;

#[cfg(test)]
mod scratch;

/// A violation of a house rule.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Violation {
    /// File, relative to the root of the tree, with `/` on every system.
    pub path: String,
    /// Line, counted from 1.
    pub line: usize,
    /// Name of the rule.
    pub rule: &'static str,
    /// Description of the violation and its remedy.
    pub message: String,
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}: {}", self.path, self.line, self.rule, self.message)
    }
}

type Rule = fn(&Path) -> Vec<Violation>;

const RULES: [Rule; 18] = [
    tree::not_empty,
    layers::rule,
    layers::document,
    architecture::rule,
    book::rule,
    circles::rule,
    guides::rule,
    source::length,
    source::markers,
    data_files::rule,
    manifest::lints,
    machine_paths::rule,
    one_voice::choices,
    one_voice::unused,
    openings::rule,
    function_names::rule,
    plain_words::rule,
    type_names::rule,
];

/// Applies every rule to the tree at `root` and prints the findings on stdout.
///
/// # Errors
/// There is a finding.
pub fn run(root: &Path) -> Result<(), Error> {
    let findings = findings(root);
    for finding in &findings {
        println!("{finding}");
    }
    if findings.is_empty() {
        return Ok(());
    }
    Err(Error::Untidy { count: findings.len() })
}

/// Returns the findings in the tree at `root`, by file and line.
#[must_use]
pub fn findings(root: &Path) -> Vec<Violation> {
    let mut findings: Vec<Violation> = RULES.iter().flat_map(|rule| rule(root)).collect();
    findings.sort();
    findings.dedup();
    findings
}

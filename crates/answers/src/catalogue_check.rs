//! Plausibility of catalogue files.

use crate::Number;
use schemars::JsonSchema;
use serde::Serialize;

/// `catalogue check`: plausibility of catalogue files.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CatalogueCheck {
    /// `true` without a finding.
    pub plausible: bool,
    /// Files in the order of the call.
    pub files: Vec<CheckedCatalogue>,
}

/// Plausibility of one catalogue file.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CheckedCatalogue {
    /// Name of the file.
    pub file: String,
    /// Number of products.
    pub products: usize,
    /// Implausible values, in the order of the file.
    pub findings: Vec<CatalogueFinding>,
    /// Proposed cells, in the order of the file; empty unless requested.
    pub proposals: Vec<CatalogueProposal>,
}

/// An implausible value, or several that contradict each other.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CatalogueFinding {
    /// Id of the rule.
    pub id: &'static str,
    /// Name of the product.
    pub product: String,
    /// Line of the first value, from 1.
    pub line: usize,
    /// Column of the first value in characters, from 1.
    pub column: usize,
    /// Compared ratio in symbols, or the key that is compared with other products; empty for names.
    pub formula: &'static str,
    /// Value of the ratio; `null` for names.
    pub value: Option<Number>,
    /// Smallest plausible ratio; `null` for names.
    pub low: Option<Number>,
    /// Largest plausible ratio; `null` for names.
    pub high: Option<Number>,
    /// Unit of the ratio; empty for a pure number.
    pub unit: &'static str,
    /// Compared values.
    pub figures: Vec<CatalogueFigure>,
    /// Other product concerned; `null` if there is none.
    pub other: Option<OtherProduct>,
    /// Description of the finding.
    pub message: String,
    /// Reason why the values contradict each other, and the usual cause.
    pub reason: &'static str,
}

/// A value that a rule compares.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CatalogueFigure {
    /// Symbol in the formula; empty for a rule without a formula.
    pub symbol: &'static str,
    /// Name of the key.
    pub key: &'static str,
    /// Value as written, with its unit.
    pub written: String,
    /// Line of the value, from 1.
    pub line: usize,
    /// Column of the value in characters, from 1.
    pub column: usize,
}

/// Another product of the file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct OtherProduct {
    /// Name of the product.
    pub product: String,
    /// Line of the product, from 1.
    pub line: usize,
}

/// A proposed cell: with this one change, no rule that reads the value has a finding. Nothing is written to the file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CatalogueProposal {
    /// Name of the product; `null` for the heading of a column.
    pub product: Option<String>,
    /// Name of the key.
    pub key: &'static str,
    /// Line of the cell, from 1.
    pub line: usize,
    /// Column of the cell in characters, from 1.
    pub column: usize,
    /// Cell as written.
    pub old: String,
    /// Proposed cell.
    pub new: String,
    /// Value that the proposed cell means, with its unit; for a heading the unit.
    pub meant: String,
    /// Ids of the rules that the value breaks as written.
    pub resolves: Vec<&'static str>,
    /// `true` if another proposal for the product resolves the same findings: one of them is wrong.
    pub alternative: bool,
}

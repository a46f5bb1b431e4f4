//! Findings: implausible values with their places.

use super::rules::PlausibilityRuleId;

/// An implausible value, or several that contradict each other.
#[derive(Clone, Debug, PartialEq)]
pub struct PlausibilityFinding {
    /// Rule that is broken.
    pub rule: PlausibilityRuleId,
    /// Name of the product.
    pub product: String,
    /// Line of the first value, from one.
    pub line: usize,
    /// Column of the first value in characters, from one.
    pub column: usize,
    /// Compared ratio in symbols, or the key that is compared with other products.
    pub formula: &'static str,
    /// The ratio; `None` for a rule about names.
    pub ratio: Option<f64>,
    /// Smallest and largest plausible ratio.
    pub window: Option<(f64, f64)>,
    /// Unit of the ratio; empty for a pure number.
    pub unit: &'static str,
    /// Values that the rule compares.
    pub figures: Vec<ComparedFigure>,
    /// Other product concerned, with its line.
    pub other: Option<(String, usize)>,
}

/// A value that a rule compares.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparedFigure {
    /// Symbol in the formula; empty for a rule without a formula.
    pub symbol: &'static str,
    /// Name of the key.
    pub key: &'static str,
    /// Value as written, with its unit.
    pub written: String,
    /// Line of the value, from one.
    pub line: usize,
    /// Column of the value in characters, from one.
    pub column: usize,
}

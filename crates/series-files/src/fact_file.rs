//! Form of the files of facts.

use serde::Deserialize;

/// One fact, as described in `data/README.md`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FactEntry {
    pub(crate) id: String,
    pub(crate) section: String,
    pub(crate) source: String,
    pub(crate) kind: Option<String>,
    pub(crate) topics: Vec<String>,
    pub(crate) signal: Option<String>,
    pub(crate) step: Option<String>,
    #[serde(default)]
    pub(crate) holds_for: HoldsFor,
    pub(crate) value: Option<Value>,
    #[serde(default)]
    pub(crate) values: Vec<Value>,
    pub(crate) en: String,
    pub(crate) de: String,
    /// File with the fact, for error messages.
    #[serde(skip)]
    pub file: String,
    /// Index of its series among the codes of the data.
    #[serde(skip)]
    pub series: usize,
}

/// Codes that a fact holds for; an absent key leaves the field open.
#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(crate) struct HoldsFor {
    #[serde(default)]
    pub(crate) feedback: Vec<String>,
    #[serde(default)]
    pub(crate) winding: Vec<String>,
    #[serde(default)]
    pub(crate) size: Vec<String>,
    pub(crate) brake: Option<bool>,
    pub(crate) ec: Option<bool>,
    pub(crate) kty: Option<bool>,
}

/// A number of the sentence in machine-readable form.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Value {
    pub(crate) id: Option<String>,
    pub(crate) number: f64,
    pub(crate) unit: Option<String>,
    pub(crate) bound: String,
}

/// One file of facts.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FactsFile {
    /// Facts of the file.
    pub fact: Vec<FactEntry>,
}

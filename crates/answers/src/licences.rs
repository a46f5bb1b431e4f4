//! Records of `licences`.

use schemars::JsonSchema;
use serde::Serialize;

/// Licence of the program and of the third-party work in it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Licences {
    /// Licence texts, the program's own first.
    pub texts: Vec<LicenceText>,
}

/// A licence text as in the repository.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LicenceText {
    /// File in the repository.
    pub name: String,
    /// Complete text, in Markdown if the name ends in `.md`.
    pub text: String,
}

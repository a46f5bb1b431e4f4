//! Records of `licences`.

use schemars::JsonSchema;
use serde::Serialize;

/// The licence of the program and those of the work of others in it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Licences {
    /// The program's own first.
    pub texts: Vec<LicenceText>,
}

/// A text as it stands in the repository.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LicenceText {
    /// Its file in the repository.
    pub name: String,
    /// The whole of it, in Markdown where the name ends so.
    pub text: String,
}

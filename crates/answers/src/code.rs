//! Ordering codes: read, refused, listed, completed.

use crate::{Availability, Id};
use order_code::Field;
use schemars::JsonSchema;
use serde::Serialize;

/// `code parse`: a code with every field explained.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeReading {
    /// Always `true`.
    pub valid: bool,
    /// The canonical spelling.
    pub code: String,
    /// Whether the text was written so.
    pub canonical: bool,
    /// Whether it can be had without asking.
    pub availability: Availability,
    /// Names of the fields that are on request only.
    pub on_request: Vec<String>,
    /// All nine fields, in their order.
    pub fields: Vec<CodeField>,
    /// What the manual's tables do not cover of it.
    pub notes: Vec<String>,
}

/// A field of a code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeField {
    /// Which field.
    pub field: Id<Field>,
    /// Its name.
    pub name: String,
    /// What stands there; empty where it is left out.
    pub token: String,
    /// What that means.
    pub meaning: String,
    /// Its place in the text given, in bytes: begin, and end without it; `null` where it is left out.
    pub span: Option<[usize; 2]>,
}

/// A code, or a partial code, that cannot be: written instead of the answer.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeFaults {
    /// Always `false`.
    pub valid: bool,
    /// The text given.
    pub text: String,
    /// Every fault, in the order of the text.
    pub errors: Vec<CodeFault>,
    /// The nearest valid codes that the manual prints data for.
    pub nearest: Vec<String>,
    /// The same with their availability.
    pub nearest_codes: Vec<ListedCode>,
}

/// A fault of a code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeFault {
    /// Stable id of its kind: `code_rule` for a rule of a table, `code_spelling` for anything else.
    pub id: &'static str,
    /// Its place in characters, from 1.
    pub position: usize,
    /// Its place in bytes: begin, and end without it.
    pub span: [usize; 2],
    /// What stands there.
    pub text: Option<String>,
    /// What is wrong, one sentence.
    pub message: String,
    /// What would be valid here; `null` where nothing is near.
    pub hint: Option<String>,
    /// The ordering table whose rule is broken; `null` for a fault of the spelling.
    pub table: Option<&'static str>,
}

/// `code list`: a valid code.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ListedCode {
    /// The code.
    pub code: String,
    /// Whether it can be had without asking.
    pub availability: Availability,
    /// Names of the fields that are on request only.
    pub on_request: Vec<String>,
}

/// `code complete`: what a partial code leaves open.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Completion {
    /// Each field but series and special design.
    pub fields: Vec<OpenField>,
    /// The codes that result.
    pub codes: Vec<ListedCode>,
}

/// A field of a partial code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OpenField {
    /// Which field.
    pub field: Id<Field>,
    /// Its name.
    pub name: String,
    /// What may stand there.
    pub choices: Vec<Choice>,
}

/// What may stand at a field.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Choice {
    /// The word; empty where the field may be left out.
    pub token: &'static str,
    /// Whether at least one code with it has this field without asking.
    pub availability: Availability,
}

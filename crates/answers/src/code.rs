//! Ordering codes: read, refused, listed, completed.

use crate::{Availability, Id};
use order_code::Field;
use schemars::JsonSchema;
use serde::Serialize;

/// `code parse`: a code with every field explained.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeReading {
    /// `true` in every such answer.
    pub valid: bool,
    /// The canonical spelling.
    pub code: String,
    /// `true` if the text was already in canonical spelling.
    pub canonical: bool,
    /// Availability of the code.
    pub availability: Availability,
    /// Names of the fields that are on request only.
    pub on_request: Vec<String>,
    /// The nine fields, in their order.
    pub fields: Vec<CodeField>,
    /// Remarks on data that the tables of the manual do not cover.
    pub notes: Vec<String>,
}

/// A field of a code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeField {
    /// Id of the field.
    pub field: Id<Field>,
    /// Name of the field.
    pub name: String,
    /// Word of the field; empty if it is left out.
    pub token: String,
    /// Meaning of the word.
    pub meaning: String,
    /// Place in the given text, in bytes: start and exclusive end; `null` if the field is left out.
    pub span: Option<[usize; 2]>,
}

/// An invalid code or partial code: written instead of the answer.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeFaults {
    /// `false` in every such answer.
    pub valid: bool,
    /// Text as given.
    pub text: String,
    /// Faults in the order of the text.
    pub errors: Vec<CodeFault>,
    /// Nearest valid codes with data in the manual.
    pub nearest: Vec<String>,
    /// Nearest valid codes with their availability.
    pub nearest_codes: Vec<ListedCode>,
}

/// A fault of a code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeFault {
    /// Stable id of the kind of fault: `code_rule` for a rule of a table, `code_spelling` for anything else.
    pub id: &'static str,
    /// Place in characters, from 1.
    pub position: usize,
    /// Place in bytes: start and exclusive end.
    pub span: [usize; 2],
    /// Text at this place.
    pub text: Option<String>,
    /// Description of the fault, one sentence.
    pub message: String,
    /// Valid text at this place; `null` if nothing is similar.
    pub hint: Option<String>,
    /// Ordering table with the violated rule; `null` for a fault of the spelling.
    pub table: Option<&'static str>,
}

/// `code list`: a valid code.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ListedCode {
    /// Ordering code.
    pub code: String,
    /// Availability of the code.
    pub availability: Availability,
    /// Names of the fields that are on request only.
    pub on_request: Vec<String>,
}

/// `code complete`: open fields of a partial code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Completion {
    /// The fields except series and special design.
    pub fields: Vec<OpenField>,
    /// Resulting codes.
    pub codes: Vec<ListedCode>,
}

/// A field of a partial code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OpenField {
    /// Id of the field.
    pub field: Id<Field>,
    /// Name of the field.
    pub name: String,
    /// Permitted words.
    pub choices: Vec<Choice>,
}

/// A permitted word of a field.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Choice {
    /// Word; empty if the field may be left out.
    pub token: &'static str,
    /// Availability of the field in at least one code with this word.
    pub availability: Availability,
}

//! Faults that prevent an answer.

use crate::ListedCode;
use schemars::JsonSchema;
use serde::Serialize;

/// Faults of a request; a command that cannot answer writes this record instead of its answer, and exits with 2.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Faults {
    /// Faults in the order of the file.
    pub errors: Vec<Fault>,
    /// Nearest valid codes, if one of the faults is a wrong ordering code.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub nearest_codes: Vec<ListedCode>,
}

/// One fault; id, option, file and place are omitted if there is none.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Fault {
    /// Stable id of the kind of fault.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<&'static str>,
    /// Option of the command line concerned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub option: Option<String>,
    /// File concerned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Place in the file.
    #[serde(flatten)]
    pub place: Option<Place>,
    /// Heading of the table column concerned.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<String>,
    /// Row of the table, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub row: Option<u64>,
    /// Description of the fault, one sentence.
    pub message: String,
    /// Expected text, or the nearest valid choice; `null` if nothing is similar.
    pub hint: Option<String>,
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Place {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Offending part in bytes: start and exclusive end.
    pub span: [usize; 2],
}

impl Faults {
    /// Combines the faults of several questions without duplicates.
    #[must_use]
    pub fn combined(all: impl IntoIterator<Item = Self>) -> Self {
        let mut found = Self::default();
        for faults in all {
            for error in faults.errors {
                if !found.errors.contains(&error) {
                    found.errors.push(error);
                }
            }
            for code in faults.nearest_codes {
                if !found.nearest_codes.contains(&code) {
                    found.nearest_codes.push(code);
                }
            }
        }
        found
    }

    /// Creates a single fault from one sentence.
    #[must_use]
    pub fn of(message: impl Into<String>) -> Self {
        Self::from(vec![Fault { message: message.into(), ..Fault::default() }])
    }
}

impl From<Vec<Fault>> for Faults {
    fn from(errors: Vec<Fault>) -> Self {
        Self { errors, nearest_codes: Vec::new() }
    }
}

//! Faults that prevent an answer.

use crate::ListedCode;
use schemars::JsonSchema;
use serde::Serialize;

/// Every fault that was found; a command that cannot answer writes this instead of its answer, and exits with 2.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Faults {
    /// The faults, in the order of the file.
    pub errors: Vec<Fault>,
    /// The nearest valid codes, where a wrong ordering code is among the faults.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub nearest_codes: Vec<ListedCode>,
}

/// One fault; id, option, file and place are left out where there is none.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Fault {
    /// Stable id of its kind.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub id: Option<&'static str>,
    /// The option of the command line that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub option: Option<String>,
    /// The file that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Its place in the file.
    #[serde(flatten)]
    pub place: Option<Place>,
    /// The heading of the column of a table that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heading: Option<String>,
    /// The row of the table, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub row: Option<u64>,
    /// What is wrong, one sentence.
    pub message: String,
    /// What was expected, or the nearest valid choice; `null` where nothing is near.
    pub hint: Option<String>,
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Place {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// The offending part in bytes: begin, and end without it.
    pub span: [usize; 2],
}

impl Faults {
    /// Combines the faults of several questions without duplicates.
    #[must_use]
    pub fn together(all: impl IntoIterator<Item = Self>) -> Self {
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

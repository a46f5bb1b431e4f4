//! What keeps a question from being answered.

use schemars::JsonSchema;
use serde::Serialize;

/// Every fault that was found; a command that cannot answer writes this instead of its answer, and exits with 2.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Faults {
    /// The faults, in the order of the file.
    pub errors: Vec<Fault>,
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
    /// Those of several questions as one, each once.
    #[must_use]
    pub fn together(all: impl IntoIterator<Item = Self>) -> Self {
        let mut errors: Vec<Fault> = Vec::new();
        for error in all.into_iter().flat_map(|faults| faults.errors) {
            if !errors.contains(&error) {
                errors.push(error);
            }
        }
        Self { errors }
    }

    /// One fault in one sentence.
    #[must_use]
    pub fn of(message: impl Into<String>) -> Self {
        Self { errors: vec![Fault { message: message.into(), ..Fault::default() }] }
    }
}

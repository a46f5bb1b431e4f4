//! Errors and doubts in the manual.

use schemars::JsonSchema;
use serde::Serialize;

/// `errata`: the requested errata.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Errata {
    /// Subject of the query: a code, a table, an id; `null` for all errata.
    pub about: Option<String>,
    /// Errata in the order of the data.
    pub errata: Vec<Erratum>,
}

/// One erratum.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Erratum {
    /// Id of the erratum.
    pub id: &'static str,
    /// Table concerned; `null` for an erratum of the text.
    pub table: Option<&'static str>,
    /// Cell concerned; `null` if it concerns the table or the text.
    pub cell: Option<ErratumCell>,
    /// Place as text.
    #[serde(rename = "where")]
    pub place: String,
    /// Kind of the error.
    pub kind: ErratumKind,
    /// Status of the correction.
    pub status: ErratumStatus,
    /// Text in the damaged file, for kind `recovery`; else `null`.
    pub recovered: Option<&'static str>,
    /// Value in the manual.
    pub printed: &'static str,
    /// Correct value; equal to `printed` if the matter is open.
    pub corrected: &'static str,
    /// Value used by checks if the safe side is not `corrected`; else `null`.
    pub checks_use: Option<&'static str>,
    /// Unit of the three values; empty for texts.
    pub unit: &'static str,
    /// Evidence with figures.
    pub evidence: &'static str,
}

/// The cell concerned by an erratum.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ErratumCell {
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// Drive as headed in the manual; empty for all drives.
    pub drive: &'static str,
    /// Feedback system; empty for all systems.
    pub feedback: &'static str,
    /// Reduction ratio; empty for all ratios.
    pub ratio: &'static str,
    /// Further condition of the row.
    pub condition: &'static str,
}

/// Kind of an erratum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ErratumKind {
    /// The recovered text differs from the manual.
    Recovery,
    /// The manual is wrong, as proven by neighbouring values.
    PrintError,
    /// Two statements of the manual exclude each other, and nothing decides between them.
    Contradiction,
    /// Rounded to the unsafe side or with false digits.
    Rounding,
    /// Another edition states a different value.
    Edition,
}

/// Status of an erratum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ErratumStatus {
    /// The correct value is proven and used.
    Corrected,
    /// The value of the manual stays and is flagged.
    Flagged,
}

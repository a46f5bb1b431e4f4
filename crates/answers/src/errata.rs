//! Errors and doubts in the manual.

use schemars::JsonSchema;
use serde::Serialize;

/// `errata`: the requested errata.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Errata {
    /// What was asked about: a code, a table, an id; `null`: all.
    pub about: Option<String>,
    /// The errata, in the order of the data.
    pub errata: Vec<Erratum>,
}

/// One erratum.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Erratum {
    /// Its id.
    pub id: &'static str,
    /// The table concerned; `null` for one of the text.
    pub table: Option<&'static str>,
    /// The cell that it names; `null` where it is about the table or the text.
    pub cell: Option<ErratumCell>,
    /// The place in words.
    #[serde(rename = "where")]
    pub place: String,
    /// What is wrong, and with what.
    pub kind: ErratumKind,
    /// Whether the right value is proven.
    pub status: ErratumStatus,
    /// What the damaged text has, for kind `recovery`; else `null`.
    pub recovered: Option<&'static str>,
    /// What stands printed.
    pub printed: &'static str,
    /// What is right; equal to `printed` where the matter is open.
    pub corrected: &'static str,
    /// What checks use where the safe side is not `corrected`; else `null`.
    pub checks_use: Option<&'static str>,
    /// Unit of the three; empty for texts.
    pub unit: &'static str,
    /// Why, with the figures.
    pub evidence: &'static str,
}

/// The cell that an erratum names.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ErratumCell {
    /// Symbol in ASCII.
    pub symbol: &'static str,
    /// The drive as the manual heads it; empty: all.
    pub drive: &'static str,
    /// Feedback system; empty: all.
    pub feedback: &'static str,
    /// Reduction ratio; empty: all.
    pub ratio: &'static str,
    /// Further distinction of the row.
    pub condition: &'static str,
}

/// What is wrong, and with what.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ErratumKind {
    /// The recovered text differs from the print.
    Recovery,
    /// The print itself is wrong and its neighbours prove it.
    PrintError,
    /// Two printed facts exclude each other and nothing decides.
    Contradiction,
    /// Rounded to the unsafe side or with false digits.
    Rounding,
    /// Another edition prints otherwise.
    Edition,
}

/// Whether an erratum is settled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ErratumStatus {
    /// The right value is proven and used.
    Corrected,
    /// The print stays and is flagged.
    Flagged,
}

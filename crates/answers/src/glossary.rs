//! Records of `glossary`.

use schemars::JsonSchema;
use serde::Serialize;

/// Words and symbols, all or the requested ones.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Glossary {
    /// Terms of the product, one per thing.
    pub words: Vec<GlossaryWord>,
    /// Symbols of the tables.
    pub terms: Vec<GlossaryTerm>,
    /// Symbols of the derivations and of the values for a servo drive. A symbol with several meanings has several
    /// entries.
    pub symbols: Vec<GlossarySymbol>,
    /// Checks with the requested title; only where there are some.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schemars(default)]
    pub checks: Vec<GlossaryCheck>,
}

impl Glossary {
    /// Returns `true` if nothing was found.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.words.is_empty() && self.terms.is_empty() && self.symbols.is_empty() && self.checks.is_empty()
    }
}

/// A check of an actuator, which `explain` states with formula, inputs and sources.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct GlossaryCheck {
    /// Identifier.
    pub id: String,
    /// English title.
    pub en: String,
    /// German title.
    pub de: String,
    /// Value and limit that the check compares, in English.
    pub meaning_en: &'static str,
    /// Value and limit that the check compares, in German.
    pub meaning_de: &'static str,
}

/// A word of the product.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct GlossaryWord {
    /// Identifier.
    pub id: String,
    /// English word.
    pub en: String,
    /// German word.
    pub de: String,
    /// Meaning, in the requested language.
    pub meaning: String,
}

/// A symbol of the tables.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct GlossaryTerm {
    /// Symbol in ASCII, as in the catalogue's export: `T_max`.
    pub symbol: String,
    /// Long name, as in project files.
    pub identifier: String,
    /// Unit in the manual; empty for a pure number or a text.
    pub unit: String,
    /// English term.
    pub en: String,
    /// German term.
    pub de: String,
    /// Remark in the requested language; may be empty.
    pub remark: String,
}

/// A symbol of the derivations of `explain`, or of the values of `commission`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct GlossarySymbol {
    /// Symbol in ASCII.
    pub symbol: String,
    /// Symbol as displayed in formulas.
    pub shown: String,
    /// English meaning.
    pub en: String,
    /// German meaning.
    pub de: String,
}

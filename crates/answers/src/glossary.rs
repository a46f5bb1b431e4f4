//! Records of `glossary`.

use schemars::JsonSchema;
use serde::Serialize;

/// Words and symbols, all or the requested ones.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Glossary {
    /// Words of the product: one for one thing.
    pub words: Vec<GlossaryWord>,
    /// Symbols of the tables.
    pub terms: Vec<GlossaryTerm>,
    /// Symbols of the derivations and of the values for a drive. One that means several things stands several times.
    pub symbols: Vec<GlossarySymbol>,
}

impl Glossary {
    /// Returns `true` if nothing was found.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.words.is_empty() && self.terms.is_empty() && self.symbols.is_empty()
    }
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
    /// Unit of the print; empty for a bare number or a text.
    pub unit: String,
    /// English term.
    pub en: String,
    /// German term.
    pub de: String,
    /// Remark in the requested language; may be empty.
    pub remark: String,
}

/// A symbol of the derivations that `explain` gives, or of the values that `commission` gives.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct GlossarySymbol {
    /// Symbol in ASCII.
    pub symbol: String,
    /// Symbol as formulas show it.
    pub shown: String,
    /// English meaning.
    pub en: String,
    /// German meaning.
    pub de: String,
}

//! Words for the schema of the project file.

use super::key_text;
use crate::texts::said;
use project::SchemaText;
use quantities::{Dimension, Language};

/// Returns a text of the schema of the project file.
#[must_use]
pub fn schema_text(text: SchemaText, language: Language) -> String {
    match text {
        SchemaText::Key(key) => key_text(&key, language),
        SchemaText::Quantity(dimension) => quantity(dimension, language),
    }
}

/// Returns the syntax of a quantity, for an editor.
fn quantity(dimension: Dimension, language: Language) -> String {
    let (name, example) = (dimension.name(language), dimension.example());
    let half = if dimension == Dimension::Temperature { "5 K" } else { "10 %" };
    said!(language =>
        "{name} with its unit, optionally with a tolerance: \"{example}\", \"{example} ± {half}\""
        | "{name} mit Einheit, wahlweise mit Toleranz: \"{example}\", \"{example} ± {half}\""
    )
}

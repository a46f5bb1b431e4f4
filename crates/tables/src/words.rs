//! Words of the tables that no result has, in English and German side by side.

use crate::table::{Column, Kind};
use workbench::Language;
use workbench::quantities::Unit;

/// A word in both languages.
pub(crate) type Both = [&'static str; 2];

/// Chooses between the two languages.
pub(crate) const fn t(language: Language, [en, de]: Both) -> &'static str {
    match language {
        Language::En => en,
        Language::De => de,
    }
}

/// A column of a definition.
pub(crate) fn column(
    name: &str,
    title: Both,
    kind: Kind,
    unit: Option<&'static Unit>,
    about: Both,
    language: Language,
) -> Column {
    Column {
        name: name.to_owned(),
        title: t(language, title).to_owned(),
        unit,
        about: t(language, about).to_owned(),
        kind,
    }
}

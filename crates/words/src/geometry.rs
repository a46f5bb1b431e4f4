//! Words of what is wrong with the lengths and angles of a mechanism.

use mechanism::Geometry;
use quantities::Language;

/// What is wrong, with the keys it is about.
pub(crate) const fn geometry(fault: Geometry, language: Language) -> &'static str {
    let (en, de) = match fault {
    };
    match language {
        Language::En => en,
        Language::De => de,
    }
}

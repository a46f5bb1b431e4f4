//! Titles in both languages at once, for answers that are looked up in either.

use crate::check_title;
use quantities::Language;
use sizing::CheckId;

/// Returns the English and the German title of a check.
#[must_use]
pub fn check_titles(id: CheckId) -> [String; 2] {
    [Language::En, Language::De].map(|language| check_title(id, language))
}

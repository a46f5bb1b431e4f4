//! Factor on the load of a project: on everything that an axis moves.

use super::value::Fault;
use project::{Written, edit_values, loads};
use quantities::Language;
use words::terminal;

/// Returns the text with everything that an axis moves multiplied by a factor: its load, each of its bodies, its payloads.
///
/// # Errors
/// A sentence for an axis without any load that a factor could change.
pub(super) fn scaled(
    text: &str,
    (all, prefix): (&[Written], &str),
    factor: f64,
    language: Language,
) -> Result<String, Fault> {
    let none = || (terminal::no_load_to_scale(language).to_owned(), None);
    let mut values: Vec<(String, String)> = Vec::new();
    for load in &loads(all, prefix) {
        let scaled = load.scaled(factor).ok_or_else(none)?;
        for (path, value) in scaled {
            if values.iter().all(|(known, _)| *known != path) {
                values.push((path, value));
            }
        }
    }
    if values.is_empty() {
        return Err(none());
    }
    edit_values(text, &values).map_err(|fault| (fault.to_string(), None))
}

//! Factor on the load of a project: one load is scaled, of several each has its own call.

use super::value::{Fault, NAMED_KEYS_MOST};
use crate::command::typed::typed;
use project::{Load, Written, edit_values, loads};
use quantities::Language;
use words::{UsageHint, terminal, usage_hint};

/// Returns the text with the load of an axis multiplied by a factor.
///
/// # Errors
/// The sentence and the calls of a project with several loads; a sentence for one without any.
pub(super) fn scaled(
    text: &str,
    (all, prefix): (&[Written], &str),
    factor: f64,
    language: Language,
) -> Result<String, Fault> {
    let found = loads(all, prefix);
    let [load] = &found[..] else {
        let calls = calls(&found, factor);
        return Err(match calls.is_empty() {
            true => (terminal::no_load_to_scale(language).to_owned(), None),
            false => {
                let hint = usage_hint(&UsageHint::Calls(calls), language);
                (terminal::several_loads(&names(&found), language), Some(hint))
            }
        });
    };
    let values = load.scaled(factor).ok_or_else(|| (terminal::no_load_to_scale(language).to_owned(), None))?;
    edit_values(text, &values).map_err(|fault| (fault.to_string(), None))
}

/// Returns the first key of each load.
fn names(loads: &[Load]) -> String {
    let first = loads.iter().filter_map(|load| load.stated.first());
    let mut names: Vec<&str> = first.map(|(path, _)| path.as_str()).collect();
    names.dedup();
    names.truncate(NAMED_KEYS_MOST);
    names.join(", ")
}

/// Returns the options that multiply each of several loads; bodies in one list of texts have none.
pub(super) fn calls(loads: &[Load], factor: f64) -> Vec<String> {
    let options = |load: &Load| {
        if load.is_payload {
            return Some(typed(["--scale", &format!("payload={}", (factor * 1e9).round() / 1e9)]));
        }
        if load.stated.iter().any(|(path, _)| path.ends_with(".bodies")) {
            return None;
        }
        let sets =
            load.scaled(factor)?.into_iter().flat_map(|(path, value)| ["--set".to_owned(), format!("{path}={value}")]);
        let sets: Vec<String> = sets.collect();
        Some(typed(sets.iter().map(String::as_str)))
    };
    loads.iter().take(NAMED_KEYS_MOST).filter_map(options).collect()
}

//! Faults of a project's text at the places of the page that show them.

use crate::places::Places;
use crate::value::arithmetic_fault;
use axis::{AxisDiagnostic, AxisFault};
use project::{Fault, Key, Written};
use quantities::Language;
use std::collections::BTreeMap;
use words::{Worded, worded};

/// Returns every fault with its path: the one that it names, else that of the smallest enclosing value, else that of
/// the key at its position. A number with faulty arithmetic has the fault of the arithmetic. A path that the file does
/// not have belongs to the enclosing table.
pub(crate) fn placed(
    faults: &[AxisDiagnostic],
    (text, written): (&str, &[Written]),
    key_at: fn(&str) -> Option<&'static Key>,
    language: Language,
) -> Vec<(Option<String>, Worded)> {
    let places = Places::of(written);
    let path = |fault: &AxisDiagnostic| -> Option<String> {
        if let AxisFault::Stated(Fault::MissingKey { path, .. }) = &fault.fault {
            return Some(path.clone());
        }
        // A key stands on the line of its value, before it.
        let found = places.around(&fault.span).or_else(|| places.behind_on_line(fault.span.end, text));
        let found = found.map(|key| known(&key.path, key_at));
        if !matches!(fault.fault, AxisFault::Stated(Fault::NoMechanism)) {
            return found;
        }
        // The value is not in the text: the fault belongs to its future place, in its axis.
        let axis = found.filter(|path| path.starts_with("axis["));
        let axis = axis.and_then(|path| Some(path.split_once(']')?.0.to_owned()));
        Some(axis.map_or_else(|| String::from("mechanism"), |axis| format!("{axis}].mechanism")))
    };
    let values: BTreeMap<&str, &str> =
        written.iter().filter_map(|key| Some((key.path.as_str(), key.value.as_deref()?))).collect();
    let said = worded(faults, language).into_iter().zip(faults);
    let in_words = |(worded, fault): (Worded, &AxisDiagnostic)| {
        let path = path(fault);
        let value = path.as_deref().and_then(|path| Some((key_at(path)?, *values.get(path)?)));
        let arithmetic = value.and_then(|(key, value)| arithmetic_fault(key, value, language));
        let worded = match arithmetic {
            Some(message) => Worded { message, hint: None, ..worded },
            None => crate::markup::in_words(worded, fault, language),
        };
        (path, worded)
    };
    said.map(in_words).collect()
}

/// Returns the path, or that of the nearest enclosing table that a file has.
fn known(path: &str, key_at: fn(&str) -> Option<&'static Key>) -> String {
    let mut path = path;
    while key_at(path).is_none()
        && let Some((above, _)) = path.rsplit_once('.')
    {
        path = above;
    }
    path.to_owned()
}

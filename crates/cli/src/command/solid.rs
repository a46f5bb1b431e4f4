//! Bodies of `inertia` as people write them: shapes and dimensions by other words, materials in place of densities.

use super::meant::Called;
use clap::Command;
use project::BODY_SHAPES;
use quantities::Language;
use std::ffi::OsString;
use words::spoken::{body_word, density};

/// Units of the values of a body that have none, by the key; other keys are lengths.
const UNITS: [(&str, &str); 4] = [("mass", "kg"), ("density", "kg/m^3"), ("angle", "deg"), ("count", "")];

/// Unit of a length.
const LENGTH: &str = "mm";

/// Returns a word of a body by the program's own; `None` if it is one, or none that is known.
fn own(word: &str) -> Option<String> {
    if let Some((key, value)) = word.split_once('=') {
        return Some(format!("{}={value}", body_word(key)?));
    }
    let is_shape = |name: &str| BODY_SHAPES.iter().any(|shape| shape.name == name);
    let shape = body_word(word).filter(|name| is_shape(name)).map(str::to_owned);
    shape.or_else(|| Some(format!("density={}", density(word)?)))
}

/// Returns a call with every body in the program's own words, and `true` if one was written otherwise.
pub(super) fn with_own_words(arguments: Vec<OsString>, whole: &Command, language: Language) -> (Vec<OsString>, bool) {
    let Some(begin) = Called::of(&arguments, whole, language).filter(is_of_bodies).map(|called| called.begin) else {
        return (arguments, false);
    };
    let mut is_changed = false;
    let meant = arguments.into_iter().enumerate().map(|(place, argument)| {
        let text = argument.to_str().filter(|text| place >= begin && !text.starts_with('-'));
        let Some(text) = text else { return argument };
        let words: Vec<String> =
            text.split_whitespace().map(|word| own(word).unwrap_or_else(|| word.to_owned())).collect();
        let joined = words.join(" ");
        if joined == text.split_whitespace().collect::<Vec<_>>().join(" ") {
            return argument;
        }
        is_changed = true;
        joined.into()
    });
    (meant.collect(), is_changed)
}

fn is_of_bodies(called: &Called<'_>) -> bool {
    called.entry.is_some_and(|entry| entry.command == "inertia")
}

/// Returns the words of a call with a unit behind each number of a body that lacks one; `None` if none does.
pub(super) fn with_units(arguments: &[OsString], called: &Called<'_>) -> Option<Vec<OsString>> {
    if !is_of_bodies(called) {
        return None;
    }
    let with_unit = |word: &str| {
        let (key, value) = word.split_once('=')?;
        let number = value.replace(',', ".").parse::<f64>().ok()?;
        let unit = UNITS.iter().find(|(of, _)| *of == key).map_or(LENGTH, |(_, unit)| *unit);
        (!unit.is_empty()).then(|| format!("{key}={number}{unit}"))
    };
    let mut is_changed = false;
    let meant: Vec<OsString> = arguments
        .iter()
        .enumerate()
        .map(|(place, argument)| {
            let Some(text) = argument.to_str().filter(|_| place >= called.begin) else { return argument.clone() };
            let words: Vec<String> = text
                .split_whitespace()
                .map(|word| {
                    let found = with_unit(word);
                    is_changed |= found.is_some();
                    found.unwrap_or_else(|| word.to_owned())
                })
                .collect();
            words.join(" ").into()
        })
        .collect();
    is_changed.then_some(meant)
}

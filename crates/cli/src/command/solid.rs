//! Bodies of `inertia` as people write them: shapes and dimensions by other words, materials in place of densities.

use super::meant::Called;
use clap::Command;
use project::{BODY_SHAPES, BodyShape};
use quantities::{Dimension, Language, parse};
use std::ffi::OsString;
use words::spoken::{body_word, density};

/// Units of the values of a body that have none, by the key; other keys are lengths.
const UNITS: [(&str, &str); 4] = [("mass", "kg"), ("density", "kg/m^3"), ("angle", "deg"), ("count", "")];

/// Unit of a length.
const LENGTH: &str = "mm";

/// Signs between the dimensions of a body.
const TIMES: [&str; 3] = ["x", "\u{d7}", "*"];

/// Reader of the words of bodies, one behind the other.
#[derive(Default)]
struct Bodies {
    shape: Option<&'static BodyShape>,
    /// Keys that the body has already.
    given: Vec<String>,
}

impl Bodies {
    /// Returns a word of a body by the program's own; `None` for a sign between two dimensions.
    fn own(&mut self, word: &str) -> Option<String> {
        if TIMES.contains(&word) {
            return None;
        }
        if let Some((key, value)) = word.split_once('=') {
            let key = body_word(key).unwrap_or(key);
            self.given.push(key.to_owned());
            return Some(format!("{key}={value}"));
        }
        let name = body_word(word).unwrap_or(word);
        if let Some(shape) = BODY_SHAPES.iter().find(|shape| shape.name == name) {
            *self = Self { shape: Some(shape), given: Vec::new() };
            return Some(name.to_owned());
        }
        if let Some(density) = density(word) {
            return Some(format!("density={density}"));
        }
        Some(self.dimension(word).unwrap_or_else(|| word.to_owned()))
    }

    /// Returns the next dimension of the shape with a length as its value, or the mass.
    fn dimension(&mut self, word: &str) -> Option<String> {
        let shape = self.shape?;
        let key = if parse(Dimension::Mass, word).is_ok() {
            "mass"
        } else {
            let _ = parse(Dimension::Length, word).ok()?;
            let mut keys = shape.dimensions.iter().copied().chain(shape.extent);
            keys.find(|key| !self.given.iter().any(|given| given == key))?
        };
        self.given.push(key.to_owned());
        Some(format!("{key}={word}"))
    }
}

/// Returns a call with every body in the program's own words, and `true` if one was written otherwise.
pub(super) fn with_own_words(arguments: Vec<OsString>, whole: &Command, language: Language) -> (Vec<OsString>, bool) {
    let Some(begin) = Called::of(&arguments, whole, language).filter(is_of_bodies).map(|called| called.begin) else {
        return (arguments, false);
    };
    let (mut is_changed, mut bodies) = (false, Bodies::default());
    let meant = arguments.into_iter().enumerate().map(|(place, argument)| {
        let text = argument.to_str().filter(|text| place >= begin && !text.starts_with('-'));
        let Some(text) = text else { return argument };
        let words: Vec<String> = text.split_whitespace().filter_map(|word| bodies.own(word)).collect();
        let joined = words.join(" ");
        if joined == text.split_whitespace().collect::<Vec<_>>().join(" ") {
            return argument;
        }
        is_changed = true;
        joined.into()
    });
    // A sign between two dimensions is no body.
    let meant: Vec<OsString> = meant.collect();
    (meant.into_iter().filter(|word| !is_changed || !word.is_empty()).collect(), is_changed)
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

//! Bodies of `inertia` as people write them: shapes and dimensions by other words, materials in place of densities.

use super::meant::Called;
use super::typed::number_and_unit;
use clap::Command;
use project::{BODY_SHAPES, BodyShape};
use quantities::{Dimension, Language, parse};
use std::borrow::Cow;
use std::collections::VecDeque;
use std::ffi::OsString;
use words::spoken::{body_word, density};

/// Units of the values of a body that have none, by the key; other keys are lengths.
const UNITS: [(&str, &str); 4] = [("mass", "kg"), ("density", "kg/m^3"), ("angle", "deg"), ("count", "")];

/// Unit of a length.
const LENGTH: &str = "mm";

/// Signs between the dimensions of a body.
const TIMES: [&str; 3] = ["x", "\u{d7}", "*"];

/// Keys of one dimension of which each shape has one: what it lacks is meant by the other.
const EXCHANGED: [[&str; 2]; 6] = [
    ["thickness", "length"],
    ["thickness", "height"],
    ["height", "length"],
    ["length", "height"],
    ["outer", "diameter"],
    ["diameter", "outer"],
];

/// Name of the key of a bore, which only a tube has.
const INNER: &str = "inner";

/// Reader of the words of bodies, one behind the other.
#[derive(Default)]
struct Bodies {
    shape: Option<&'static BodyShape>,
    /// Keys that the body has already.
    given: Vec<String>,
    /// Words before the first shape: a material, dimensions.
    before: Vec<String>,
    /// A shape, or a word in its place, was read.
    is_begun: bool,
    /// For each shape of the call, `true` if it has a bore.
    bores: VecDeque<bool>,
}

/// Returns the shape that a word names.
fn shape_of(word: &str) -> Option<&'static BodyShape> {
    let name = body_word(word).unwrap_or(word);
    BODY_SHAPES.iter().find(|shape| shape.name.eq_ignore_ascii_case(name))
}

impl Bodies {
    /// Creates the reader of the words of a call.
    fn of(words: &[&str]) -> Self {
        let places: Vec<usize> =
            (0..words.len()).filter(|at| words.get(*at).copied().and_then(shape_of).is_some()).collect();
        let is_bore = |word: &&str| {
            let key = word.trim_start_matches("--").split('=').next().unwrap_or_default();
            body_word(key).unwrap_or(key) == INNER
        };
        let has_bore = |(number, from): (usize, &usize)| {
            let to = places.get(number + 1).copied().unwrap_or(words.len());
            words.get(*from..to).is_some_and(|words| words.iter().any(&is_bore))
        };
        Self { bores: places.iter().enumerate().map(has_bore).collect(), ..Self::default() }
    }

    /// Returns the program's own words for one of a call; none for a sign between two dimensions.
    fn own(&mut self, word: &str) -> Vec<String> {
        if TIMES.contains(&word) {
            return Vec::new();
        }
        if let Some(shape) = shape_of(word) {
            let has_bore = self.bores.pop_front().unwrap_or_default();
            let is_round = ["disc", "cylinder"].contains(&shape.name);
            let shape = if has_bore && is_round { shape_of("tube").unwrap_or(shape) } else { shape };
            let before = std::mem::take(&mut self.before);
            (self.shape, self.is_begun) = (Some(shape), true);
            self.given.clear();
            let own: Vec<String> = before.iter().flat_map(|word| self.own(word)).collect();
            return std::iter::once(shape.name.to_owned()).chain(own).collect();
        }
        if !self.is_begun
            && (density(word).is_some() || word.starts_with(|sign: char| sign.is_ascii_digit()) || word.contains('='))
        {
            self.before.push(word.to_owned());
            return Vec::new();
        }
        if let Some((key, value)) = word.split_once('=') {
            let key = self.key(body_word(key).unwrap_or(key));
            self.given.push(key.clone());
            return vec![format!("{key}={}", with_point(value))];
        }
        if let Some(density) = density(word) {
            return vec![format!("density={density}")];
        }
        if let Some(dimension) = self.dimension(word) {
            return vec![dimension];
        }
        // An unknown shape has dimensions of its own.
        if word.starts_with(char::is_alphabetic) {
            (self.shape, self.is_begun) = (None, true);
        }
        vec![word.to_owned()]
    }

    /// Returns the key of the shape for one that it may call otherwise.
    fn key(&self, key: &str) -> String {
        let Some(shape) = self.shape else { return key.to_owned() };
        let has = |key: &str| shape.dimensions.contains(&key) || shape.extent == Some(key);
        let other = || EXCHANGED.iter().find(|[own, other]| *own == key && has(other)).map(|[_, other]| *other);
        if has(key) { key } else { other().unwrap_or(key) }.to_owned()
    }

    /// Returns the next dimension of the shape with a length as its value, or the mass or density.
    fn dimension(&mut self, word: &str) -> Option<String> {
        let shape = self.shape?;
        let word = &*with_point(word);
        let key = if parse(Dimension::Mass, word).is_ok() {
            "mass"
        } else if parse(Dimension::MassDensity, word).is_ok() {
            "density"
        } else {
            let _ = parse(Dimension::Length, word).ok()?;
            let mut keys = shape.dimensions.iter().copied().chain(shape.extent);
            keys.find(|key| !self.given.iter().any(|given| given == key))?
        };
        self.given.push(key.to_owned());
        Some(format!("{key}={word}"))
    }
}

/// Returns a value with a decimal point in place of a comma that cannot separate thousands.
fn with_point(value: &str) -> Cow<'_, str> {
    let (number, _) = number_and_unit(value);
    match number.split_once(',') {
        Some((whole, rest)) if !rest.contains([',', '.']) && !whole.contains('.') && rest.len() != 3 => {
            Cow::Owned(value.replacen(',', ".", 1))
        }
        _ => Cow::Borrowed(value),
    }
}

/// Returns a call with every body in the program's own words, and `true` if one was written otherwise.
pub(super) fn with_own_words(arguments: Vec<OsString>, whole: &Command, language: Language) -> (Vec<OsString>, bool) {
    let Some(called) = Called::of(&arguments, whole, language).filter(is_of_bodies) else {
        return (arguments, false);
    };
    let Some(texts) = arguments.iter().map(|word| word.to_str()).collect::<Option<Vec<&str>>>() else {
        return (arguments, false);
    };
    let (head, tail) = texts.split_at(called.begin.min(texts.len()));
    let words: Vec<&str> = tail.iter().flat_map(|text| text.split_whitespace()).collect();
    let mut bodies = Bodies::of(&words);
    let mut meant: Vec<OsString> = head.iter().map(OsString::from).collect();
    let mut is_changed = false;
    let mut rest = tail.iter().copied();
    while let Some(text) = rest.next() {
        let key = text.strip_prefix("--").filter(|key| !called.has(key.split('=').next().unwrap_or_default()));
        let as_key = key.filter(|key| is_key(key.split('=').next().unwrap_or_default()));
        let text = match as_key {
            // `--outer 200mm` is a dimension of the body.
            Some(key) if key.contains('=') => key.to_owned(),
            Some(key) => format!("{key}={}", rest.next().unwrap_or_default()),
            None => text.to_owned(),
        };
        is_changed |= as_key.is_some();
        if text.starts_with('-') {
            meant.push(text.into());
            continue;
        }
        let own: Vec<String> = text.split_whitespace().flat_map(|word| bodies.own(word)).collect();
        if own.join(" ") != text.split_whitespace().collect::<Vec<_>>().join(" ") {
            is_changed = true;
        }
        // A body in quotes stays one argument.
        if text.contains(char::is_whitespace) && !own.is_empty() {
            meant.push(own.join(" ").into());
        } else {
            meant.extend(own.into_iter().map(OsString::from));
        }
    }
    meant.extend(bodies.before.drain(..).map(OsString::from));
    (if is_changed { meant } else { arguments }, is_changed)
}

/// Returns `true` if a word names a dimension of a body, its mass or its density.
fn is_key(word: &str) -> bool {
    let word = word.to_lowercase();
    let key = body_word(&word).unwrap_or(&word);
    ["mass", "density", "thickness", "distance", "angle", "count"].contains(&key)
        || BODY_SHAPES.iter().any(|shape| shape.dimensions.contains(&key) || shape.extent == Some(key))
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

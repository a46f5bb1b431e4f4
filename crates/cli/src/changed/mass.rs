//! A mass for an axis whose load is a moment of inertia or a torque: it has no lever arm there.

use super::keys;
use super::motion::{self, MotionWord};
use super::places;
use super::value::{Fault, NAMED_KEYS_MOST};
use crate::command::typed::typed;
use project::{Kind, Written, key_at, loads, takes_payload};
use quantities::{Dimension, Language, parse, seen};
use words::{UsageHint, spoken, terminal, usage_hint};

/// Radius of an example \[m\].
const RADIUS_M: f64 = 0.1;

/// Returns `true` if a value is a mass, with or without a sign, and a word without a table is one for the load.
pub(crate) fn is_mass_of_load(word: &str, value: &str) -> bool {
    let is_load = spoken::scaled(word).is_some_and(|what| ["load", "payload"].contains(&what))
        || keys::is_mass(word)
        || motion::meaning(word) == Some(MotionWord::Moves("payload"));
    is_load && mass_kg(value).is_some()
}

fn mass_kg(value: &str) -> Option<f64> {
    Some(parse(Dimension::Mass, value.trim_start_matches(['+', '-']).trim()).ok()?.si)
}

/// Returns the refusal of a mass where nothing of the axis takes one, with calls that state its moment of inertia at a radius;
/// `None` for an axis that takes it.
pub(crate) fn without_radius(
    all: &[Written],
    prefix: &str,
    (word, value): (&str, &str),
    language: Language,
) -> Option<Fault> {
    let mass_kg = mass_kg(value).filter(|_| is_mass_of_load(word, value))?;
    // Each of several axes has a load of its own; the key of one of them names it.
    if prefix.is_empty() && !places::axes(all).is_empty() {
        return None;
    }
    let found = loads(all, prefix);
    if takes_payload(all, prefix) || found.iter().any(|load| load.masses().next().is_some()) {
        return None;
    }
    let own = || found.iter().filter(|load| !load.is_payload).flat_map(|load| &load.stated).map(|(path, _)| path);
    let inertia = format!("{:.6}", mass_kg * RADIUS_M * RADIUS_M);
    let inertia = inertia.trim_end_matches('0').trim_end_matches('.');
    let is_inertia = |path: &&String| {
        key_at(path).is_some_and(|key| matches!(key.kind, Kind::Quantity(Dimension::MomentOfInertia, _)))
    };
    let sign = if value.starts_with('-') { '-' } else { '+' };
    let set = |path: &String| typed(["--set", &format!("{path}={sign}{inertia} kg m^2")]);
    let mut calls: Vec<String> = own().filter(is_inertia).take(NAMED_KEYS_MOST).map(set).collect();
    if calls.is_empty() && !all.iter().any(|each| each.path == format!("{prefix}mechanism.joint")) {
        calls.push(typed(["--set", &format!("payload_inertia={inertia} kg m^2")]));
    }
    let keys: Vec<&str> = own().take(NAMED_KEYS_MOST).map(String::as_str).collect();
    let mass = seen(value.trim_start_matches(['+', '-']).trim());
    let message = match &keys[..] {
        [] => terminal::mass_of_no_load(&seen(word), language),
        _ => terminal::mass_without_radius(&seen(word), &keys.join(", "), &mass, &inertia, language),
    };
    let hint = (!calls.is_empty()).then(|| usage_hint(&UsageHint::Calls(calls), language));
    Some((message, hint))
}

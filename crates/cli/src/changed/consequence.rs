//! Values that follow from the changes of a call without being named in it: the cycle, and the moved mass with a new payload.

use super::{Statements, motion, places};
use project::{Written, loads, takes_payload, written};
use quantities::unit::{KILOGRAM, SECOND};
use quantities::{Dimension, Language, Measure, Unit, parse, without_tolerance};
use questions::embedded_catalogue;
use questions::list::ReferencedText;
use words::{terminal, unpadded};

/// Digits of a cycle and a mass.
const DIGITS: usize = 6;

/// Least relative difference of two durations that are not equal.
const LEAST: f64 = 1e-9;

/// Returns what the changes of a call alter beside the named values, one sentence each.
pub(crate) fn consequences(
    before: &ReferencedText<'_>,
    after: &ReferencedText<'_>,
    stated: &Statements,
    language: Language,
) -> Vec<String> {
    let all = |text: &ReferencedText<'_>| text.text(language).ok().and_then(written).unwrap_or_default();
    let (old, new) = (all(before), all(after));
    let is_cycle = |set: &String| {
        let key = set.split('=').next().unwrap_or_default().trim();
        motion::meaning(key) == Some(motion::MotionWord::Cycle) || key.ends_with(".cycle")
    };
    let mut found = Vec::new();
    if !stated.sets.iter().any(is_cycle) && motion_values(&old) != motion_values(&new) {
        found.extend(cycles(before, after, language));
    }
    let mut axes = places::axes(&new);
    if axes.is_empty() {
        axes.push(String::new());
    }
    found.extend(axes.iter().filter_map(|prefix| {
        let mass = moved_mass(&old, &new, prefix, language)?;
        Some(of_axis(places::name(&new, prefix).as_deref(), &mass))
    }));
    found
}

/// Returns a sentence about one of several axes.
fn of_axis(name: Option<&str>, sentence: &str) -> String {
    name.map_or_else(|| sentence.to_owned(), |name| format!("{name}: {sentence}"))
}

/// Returns the stated values of every motion.
fn motion_values(all: &[Written]) -> Vec<(&str, Option<&str>)> {
    let of_motion = all.iter().filter(|each| each.path.contains("motion["));
    of_motion.map(|each| (each.path.as_str(), each.value.as_deref())).collect()
}

/// Returns the duration of the cycle of each axis that has another one. A recording is not read for it.
fn cycles(before: &ReferencedText<'_>, after: &ReferencedText<'_>, language: Language) -> Vec<String> {
    let is_recorded = |text: &ReferencedText<'_>| text.text(language).is_ok_and(|text| text.contains("recorded"));
    if is_recorded(before) || is_recorded(after) {
        return Vec::new();
    }
    let read = |text: &ReferencedText<'_>| text.projects(embedded_catalogue(), crate::waiting::progress(), language);
    let (Ok(before), Ok(after)) = (read(before), read(after)) else { return Vec::new() };
    let is_several = after.len() > 1;
    let changed = before.iter().zip(&after).filter_map(|(old, new)| {
        let [was, is] = [old, new].map(|project| project.axis.motion.duration().si());
        let sentence =
            terminal::cycle_changed(&figure(was, &SECOND, language), &figure(is, &SECOND, language), language);
        let name = Some(new.name.as_str()).filter(|_| is_several);
        ((was - is).abs() > LEAST * was.max(is)).then(|| of_axis(name, &sentence))
    });
    changed.collect()
}

/// Returns the sum of the mass of a mechanism and its payload, if an axis without a payload now has one.
fn moved_mass(old: &[Written], new: &[Written], prefix: &str, language: Language) -> Option<String> {
    let mass_kg = |value: &str| Some(parse(Dimension::Mass, without_tolerance(value)).ok()?.si);
    let payload_kg = |all: &[Written]| {
        let of_moves = all.iter().filter(|each| {
            let own = each.path.strip_prefix(prefix).is_some_and(|path| path.starts_with("motion["));
            own && each.path.ends_with("].payload")
        });
        of_moves.filter_map(|each| mass_kg(each.value.as_deref()?)).fold(0.0, f64::max)
    };
    let payload = payload_kg(new);
    if payload_kg(old) > 0.0 || payload == 0.0 || !takes_payload(new, prefix) {
        return None;
    }
    let own_loads = loads(new, prefix).into_iter().filter(|load| !load.is_payload);
    let masses = own_loads.flat_map(|load| {
        let paths: Vec<String> = load.masses().map(str::to_owned).collect();
        load.stated.into_iter().filter(move |(path, _)| paths.contains(path))
    });
    let own: f64 = masses.filter_map(|(_, value)| mass_kg(&value)).sum();
    let of = |si: f64| figure(si, &KILOGRAM, language);
    (own > 0.0).then(|| terminal::moved_mass_with_payload(&of(own), &of(payload), &of(own + payload), language))
}

fn figure(si: f64, unit: &'static Unit, language: Language) -> String {
    format!("{} {}", unpadded(unit.from_si(si), DIGITS, language), unit.symbol_in(language))
}

//! Keys that a word or a value of a call may mean, in the project of the call.

use super::accepted::{is_quantity, is_table, permits, takes};
use super::places;
use project::{Hint, KEYS, Kind, Written, key_at, loads, nearest_heading, nearest_name, other_names, written};
use quantities::{Dimension, parse};

/// Units of which a number may lack one: one of each quantity that a project often states.
pub(crate) const UNITS: [&str; 12] =
    ["mm", "s", "deg", "N m", "N", "kg", "kg m^2", "V", "degC", "1/min", "m/s", "rad/s^2"];

/// Beginning of the paths of an axis of several.
const AXIS: &str = "axis[";

/// Table whose keys every project may have.
const REQUIREMENTS: &str = "requirements";

/// Returns the paths of the keys with a name, `prefix` being that of the wanted axis: those that the project states, else
/// those that one of its tables may have with this value; else the same by the other names that people have for keys.
pub(crate) fn named(all: &[Written], prefix: &str, name: &str, value: &str) -> Vec<String> {
    let found = places::spellings(name).into_iter().map(|name| as_spelt(all, prefix, &name, value));
    found.into_iter().find(|found| !found.is_empty()).unwrap_or_default()
}

/// Returns the paths of the keys with a name as it is spelt.
fn as_spelt(all: &[Written], prefix: &str, name: &str, value: &str) -> Vec<String> {
    if name.contains('.') && !name.starts_with(AXIS) {
        let of_axis = places::at_entries(all, &format!("{prefix}{name}"));
        if !of_axis.is_empty() {
            return of_axis;
        }
        // `lift.mass` is the mass of an axis of this name.
        if let Some((axis, rest)) = name.split_once('.')
            && let Some(prefix) = places::axis_named(all, axis)
        {
            return as_spelt(all, &prefix, rest, value);
        }
    }
    let mut found = of_name(all, prefix, name, value);
    if found.is_empty() && name.contains('.') && !name.contains('[') {
        found = places::ending_with(all, prefix, name);
    }
    // A mass may be that of the mechanism's load or what it carries at times.
    if is_mass(name) {
        let is_meant = |path: &&str| takes(path, value) || value.trim().ends_with('%');
        for load in loads(all, prefix).iter().filter(|load| load.is_payload) {
            found.extend(load.masses().filter(is_meant).map(str::to_owned));
        }
        let mut known = Vec::new();
        found.retain(|path| {
            !known.contains(path) && {
                known.push(path.clone());
                true
            }
        });
    }
    found
}

/// Returns `true` if a word without a table is one for a mass.
pub(super) fn is_mass(name: &str) -> bool {
    let name = name.to_lowercase();
    name == MASS || other_names(&name).contains(&MASS)
}

/// Name of the key of a mass.
const MASS: &str = "mass";

fn of_name(all: &[Written], prefix: &str, name: &str, value: &str) -> Vec<String> {
    let found = by_name(all, prefix, name, value);
    if !found.is_empty() {
        return found;
    }
    let (above, last) = name.rsplit_once('.').map_or(("", name), |(above, last)| (above, last));
    let others = other_names(&last.to_lowercase()).iter().map(|other| match above {
        "" => (*other).to_owned(),
        above => format!("{above}.{other}"),
    });
    let others: Vec<String> = others.collect();
    let of = |other: &String| by_name(all, prefix, other, value);
    let is_fitting = |found: &Vec<String>| found.iter().any(|path| takes(path, value));
    let usual = others.iter().map(of).find(is_fitting);
    let found = usual.unwrap_or_else(|| others.iter().flat_map(of).collect());
    let fitting: Vec<String> = found.iter().filter(|path| takes(path, value)).cloned().collect();
    match (found.is_empty(), fitting.is_empty()) {
        // The key exists, the fault is that of its value.
        (true, _) => permitted(all, prefix, name),
        (false, true) => found,
        (false, false) => fitting,
    }
}

/// Returns the paths of the keys with a name, or with one that it stands for, that the tables of the project may have.
fn permitted(all: &[Written], prefix: &str, name: &str) -> Vec<String> {
    let other_names = other_names(&name.to_lowercase()).iter().copied();
    let names = std::iter::once(name).chain(other_names);
    let of = |name: &str| -> Vec<String> {
        let tables = tables(all, prefix).into_iter().filter(|table| permits(all, table, name));
        let paths = tables.map(|table| format!("{table}.{name}"));
        paths.filter(|path| key_at(path).is_some_and(|key| !is_table(key.kind))).collect()
    };
    names.map(of).find(|found| !found.is_empty()).unwrap_or_default()
}

/// Returns the first entry on a path that its list does not have, and the number of entries of the list.
pub(crate) fn no_entry(all: &[Written], path: &str) -> Option<(String, usize)> {
    let end = |place: usize| path.get(..=place);
    path.match_indices(']').filter_map(|(place, _)| end(place)).find_map(|entry| {
        let is_there = all.iter().any(|each| each.path == entry);
        let (list, _) = entry.rsplit_once('[')?;
        let is_entry = |each: &&Written| {
            each.path.strip_prefix(list).is_some_and(|rest| {
                rest.starts_with('[') && rest.ends_with(']') && rest.matches('[').count() == 1 && !rest.contains('.')
            })
        };
        (!is_there).then(|| (entry.to_owned(), all.iter().filter(is_entry).count()))
    })
}

/// Returns the paths of the keys with exactly a name: those that the project states, else those that one of its tables may have.
pub(super) fn named_exactly(all: &[Written], prefix: &str, name: &str, value: &str) -> Vec<String> {
    by_name(all, prefix, name, value)
}

/// Returns `true` if the value of a key is a quantity.
pub(crate) const fn is_measured(kind: Kind) -> bool {
    matches!(kind, Kind::Quantity(..) | Kind::Along(..))
}

fn by_name(all: &[Written], prefix: &str, name: &str, value: &str) -> Vec<String> {
    let is_own = |path: &str| path.strip_prefix(prefix).is_some_and(|inside| has_name(inside, name));
    let stated = all.iter().filter(|each| each.value.is_some() && is_own(&each.path));
    let stated: Vec<String> = stated.map(|each| each.path.clone()).collect();
    if !stated.is_empty() {
        return stated;
    }
    let path = |table: String| format!("{table}.{name}");
    tables(all, prefix)
        .into_iter()
        .filter(|table| permits(all, table, name))
        .map(path)
        .filter(|path| takes(path, value))
        .collect()
}

/// Returns the paths of the keys that a quantity may be the value of: those that the project states, and those of its
/// requirements.
pub(crate) fn of_quantity(text: &str, prefix: &str, value: &str) -> Vec<String> {
    let all = written(text).unwrap_or_default();
    let stated = all.iter().filter(|each| each.value.is_some() && each.path.starts_with(prefix));
    let mut found: Vec<String> = stated.map(|each| each.path.clone()).filter(|path| is_quantity(path, value)).collect();
    let keys = KEYS.iter().find(|key| key.name == REQUIREMENTS).map(|key| key.kind.keys(false)).unwrap_or_default();
    for key in keys {
        let path = format!("{prefix}{REQUIREMENTS}.{}", key.name);
        if is_quantity(&path, value) && !found.contains(&path) {
            found.push(path);
        }
    }
    found
}

/// Returns the key that is nearest to an unknown one, else those that the project states.
pub(crate) fn nearest(all: &[Written], key: &str, stated: &[&str]) -> Hint {
    let last = |path: &str| path.rsplit('.').next().unwrap_or_default().to_owned();
    let own =
        || all.iter().filter(|each| each.value.is_some() && each.path.contains('.')).map(|each| each.path.clone());
    let names: Vec<String> = own().map(|path| last(&path)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let by_name = || match nearest_name(&last(key), &names) {
        Hint::DidYouMean(name) => own().find(|path| last(path) == name).map(Hint::DidYouMean),
        _ => None,
    };
    let all_of_project = || Hint::ValidAre(own().take(LISTED_MOST).collect());
    nearest_heading(key, stated).or_else(by_name).unwrap_or_else(all_of_project)
}

/// Largest number of keys that are listed where none is near.
const LISTED_MOST: usize = 12;

/// Returns `true` if a value is an angle.
pub(crate) fn is_angle(value: &str) -> bool {
    parse(Dimension::Angle, value).is_ok()
}

fn has_name(path: &str, name: &str) -> bool {
    path.strip_suffix(name).is_some_and(|above| above.ends_with('.'))
}

/// Returns the tables of an axis, without the root.
fn tables(all: &[Written], prefix: &str) -> Vec<String> {
    let own = all.iter().filter(|each| each.value.is_none()).filter_map(|each| {
        let inside = each.path.strip_prefix(prefix)?;
        (!inside.is_empty()).then(|| each.path.clone())
    });
    let mut found: Vec<String> = own.collect();
    let requirements = format!("{prefix}{REQUIREMENTS}");
    if !found.contains(&requirements) {
        found.push(requirements);
    }
    found
}

//! Places of a project that the spelling of a key may mean: an entry of a list without its number, a table that the project does
//! not have yet, an axis by its name.

use super::accepted::{is_table, permits, takes};
use project::{KEYS, Key, Kind, LOADS, Written, key_at, with_brackets};

/// Returns the spellings of a key that a call may mean, the written one first: small letters and the underscores of the file.
pub(super) fn spellings(name: &str) -> Vec<String> {
    let written = with_brackets(name.trim());
    let plain = written.to_lowercase().replace(['-', ' '], "_");
    if plain == written { vec![written] } else { vec![written, plain] }
}

/// Returns the name of the axis with a prefix; `None` for the only one of a project.
pub(super) fn name(all: &[Written], prefix: &str) -> Option<String> {
    let path = format!("{}name", Some(prefix).filter(|prefix| !prefix.is_empty())?);
    all.iter().find(|each| each.path == path)?.value.clone()
}

/// Returns the number of entries of a list; `None` if the project has no list at a path.
fn entries(all: &[Written], list: &str) -> Option<usize> {
    let is_there = |place: &usize| all.iter().any(|each| each.path == format!("{list}[{place}]"));
    let count = (1..).take_while(is_there).count();
    (count > 0).then_some(count)
}

/// Returns the paths of a key with each list on the way at each of its entries that permits the key, those that the project
/// states before those that it may have; the path itself if it names every entry; none if there is no such key.
pub(super) fn at_entries(all: &[Written], path: &str) -> Vec<String> {
    let mut found: Vec<String> = vec![String::new()];
    for part in path.split('.') {
        let ways = found.iter().flat_map(|above| {
            let way = if above.is_empty() { part.to_owned() } else { format!("{above}.{part}") };
            match entries(all, &way) {
                Some(count) => (1..=count).map(|place| format!("{way}[{place}]")).collect(),
                None => vec![way],
            }
        });
        found = ways.collect();
    }
    let is_key = |path: &String| key_at(path).is_some_and(|key| !is_table(key.kind));
    found.retain(is_key);
    // The path as it is may be one that its segment does not permit: the reader says which ones it does.
    if found.len() < 2 {
        return found;
    }
    let is_permitted = |path: &String| path.rsplit_once('.').is_none_or(|(table, last)| permits(all, table, last));
    let is_stated = |path: &String| all.iter().any(|each| each.path == *path && each.value.is_some());
    let permitted: Vec<String> = found.iter().filter(|path| is_permitted(path)).cloned().collect();
    let stated: Vec<String> = found.iter().filter(|path| is_stated(path)).cloned().collect();
    [stated, permitted, found].into_iter().find(|paths| !paths.is_empty()).unwrap_or_default()
}

/// Returns a path without the numbers of its entries.
fn without_entries(path: &str) -> String {
    path.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest)).collect()
}

/// Returns the stated keys of an axis whose path ends with the names of another path, which lacks the numbers of its entries.
pub(super) fn ending_with(all: &[Written], prefix: &str, name: &str) -> Vec<String> {
    let end = format!(".{}", without_entries(name));
    let is_it = |each: &&Written| {
        each.value.is_some() && each.path.starts_with(prefix) && without_entries(&each.path).ends_with(&end)
    };
    all.iter().filter(is_it).map(|each| each.path.clone()).collect()
}

/// Returns the paths of the keys with a name in the tables that a project may have, also in those that it does not state: a load
/// and a mechanism are those of the project. Keys that take the value come first.
pub(crate) fn anywhere(all: &[Written], prefix: &str, name: &str, value: &str) -> Vec<String> {
    let mut keys: Vec<String> = Vec::new();
    let root = match prefix.trim_end_matches('.') {
        "" => KEYS,
        axis => key_at(axis).map(|key| key.kind.keys(true)).unwrap_or_default(),
    };
    collect(all, (root, prefix), prefix, &mut keys);
    let of = |name: &String| -> Vec<String> {
        let end = format!(".{name}");
        let is_it =
            |path: &&String| path.ends_with(&end) || name.contains('.') && without_entries(path).ends_with(&end);
        keys.iter().filter(is_it).cloned().collect()
    };
    let found = spellings(name).iter().map(of).find(|found| !found.is_empty()).unwrap_or_default();
    let fitting: Vec<String> = found.iter().filter(|path| takes(path, value)).cloned().collect();
    if fitting.is_empty() { found } else { fitting }
}

/// Collects the keys of some tables and of those below them.
fn collect(all: &[Written], (keys, above): (&'static [Key], &str), prefix: &str, found: &mut Vec<String>) {
    let is_written = |path: &str| all.iter().any(|each| each.path == path);
    for key in keys {
        let path = format!("{above}{}", key.name);
        let inside = path.strip_prefix(prefix).unwrap_or(&path);
        let is_of_one_kind = LOADS.iter().any(|(table, _)| *table == inside) || inside.starts_with("mechanism.");
        let is_near = above.matches('.').count() <= prefix.matches('.').count() + 1;
        if is_of_one_kind && is_table(key.kind) && is_near && !is_written(&path) {
            continue;
        }
        // The end of a path is no reason to describe an actuator of one's own.
        if inside == "actuator" && !is_written(&path) {
            continue;
        }
        match key.kind {
            Kind::Table(below) => collect(all, (below, &format!("{path}.")), prefix, found),
            Kind::OneOrMany(one, _) if entries(all, &path).is_none() => {
                collect(all, (one, &format!("{path}.")), prefix, found);
            }
            Kind::OneOrMany(..) => {}
            Kind::Variants(variants) => {
                for place in 1..=entries(all, &path).unwrap_or(0) {
                    let entry = format!("{path}[{place}]");
                    let mut own = Vec::new();
                    collect(all, (variants.keys, &format!("{entry}.")), prefix, &mut own);
                    let first = |path: &String| {
                        let rest = path.strip_prefix(&format!("{entry}.")).unwrap_or_default();
                        rest.split(['.', '[']).next().unwrap_or_default().to_owned()
                    };
                    found.extend(own.into_iter().filter(|path| permits(all, &entry, &first(path))));
                }
            }
            _ => found.push(path),
        }
    }
}

/// Returns the prefix of the keys of each axis of a project with several; empty for a project with one.
pub(crate) fn axes(all: &[Written]) -> Vec<String> {
    (1..=entries(all, "axis").unwrap_or(0)).map(|place| format!("axis[{place}].")).collect()
}

/// Returns the prefix of the keys of the axis that a word names, by its name in any case or by its number from one.
pub(crate) fn axis_named(all: &[Written], word: &str) -> Option<String> {
    let name = |prefix: &String| {
        let path = format!("{prefix}name");
        all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref())
    };
    let axes = axes(all);
    let exact = axes.iter().find(|prefix| name(prefix) == Some(word));
    let any_case =
        || axes.iter().filter(|prefix| name(prefix).is_some_and(|name| name.to_lowercase() == word.to_lowercase()));
    let only = || Some(any_case()).filter(|found| found.clone().count() == 1).and_then(|mut found| found.next());
    let numbered = || axes.iter().find(|prefix| **prefix == format!("axis[{word}]."));
    exact.or_else(only).or_else(numbered).cloned()
}

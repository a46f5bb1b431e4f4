//! Keys that a word or a value of a call may mean, in the project of the call.

use project::{KEYS, Kind, Written, key_at, written};
use quantities::{Dimension, parse};

/// Table whose keys every project may have.
const REQUIREMENTS: &str = "requirements";

/// Returns a path with its entries in brackets: `motion.1.time` is `motion[1].time`.
pub(crate) fn with_brackets(path: &str) -> String {
    let is_entry = |part: &str| !part.is_empty() && part.chars().all(|sign| sign.is_ascii_digit());
    path.split('.').fold(String::new(), |path, part| match part {
        _ if path.is_empty() => part.to_owned(),
        _ if is_entry(part) => format!("{path}[{part}]"),
        _ => format!("{path}.{part}"),
    })
}

/// Returns the paths of the keys with a name, `prefix` being that of the wanted axis: those that the project states, else
/// those that one of its tables may have with this value.
pub(crate) fn named(all: &[Written], prefix: &str, name: &str, value: &str) -> Vec<String> {
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

/// Returns `true` if a table may have a key: a segment only those of its law.
fn permits(all: &[Written], table: &str, name: &str) -> bool {
    let Some(Kind::Variants(variants)) = key_at(table).map(|key| key.kind) else { return true };
    let by = format!("{table}.{}", variants.by);
    let kind = all.iter().find(|each| each.path == by).and_then(|each| each.value.as_deref());
    let of_kind = variants.kinds.iter().find(|(of, ..)| Some(*of) == kind);
    variants.shared.contains(&name)
        || of_kind.is_some_and(|(_, needed, optional)| needed.contains(&name) || optional.contains(&name))
}

/// Returns the dimensions that the value of a key may have; empty if it is no quantity.
fn dimensions(kind: Kind) -> Vec<Dimension> {
    match kind {
        Kind::Quantity(dimension, _) => vec![dimension],
        Kind::Along(turning, line, _) => vec![turning, line],
        _ => Vec::new(),
    }
}

fn is_quantity(path: &str, value: &str) -> bool {
    let dimensions = key_at(path).map(|key| dimensions(key.kind)).unwrap_or_default();
    dimensions.into_iter().any(|dimension| parse(dimension, value).is_ok())
}

/// Returns `true` if a key at a path may have a value.
fn takes(path: &str, value: &str) -> bool {
    match key_at(path).map(|key| key.kind) {
        None => false,
        Some(Kind::Quantity(..) | Kind::Along(..)) => is_quantity(path, value),
        Some(Kind::Number(..)) => value.parse::<f64>().is_ok(),
        Some(Kind::Integer(..)) => value.parse::<i64>().is_ok(),
        Some(Kind::Bool) => matches!(value, "true" | "false"),
        Some(Kind::OneOf(words)) => words.contains(&value),
        Some(kind) => matches!(kind, Kind::Text | Kind::Texts | Kind::ListOf(_)),
    }
}

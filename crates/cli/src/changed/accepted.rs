//! Keys that a table accepts, and values that a key accepts.

use project::{Kind, Written, key_at, truth};
use quantities::{Dimension, parse};

/// Returns `true` if a key is a table or a list of tables, and has no value of its own.
pub(crate) fn is_table(kind: Kind) -> bool {
    matches!(kind, Kind::Variants(_)) || !kind.keys(false).is_empty() || !kind.keys(true).is_empty()
}

/// Returns `true` if a table may have a key: a segment only those of its law.
pub(crate) fn permits(all: &[Written], table: &str, name: &str) -> bool {
    let Some(Kind::Variants(variants)) = key_at(table).map(|key| key.kind) else { return true };
    let by = format!("{table}.{}", variants.by);
    let kind = all.iter().find(|each| each.path == by).and_then(|each| each.value.as_deref());
    let of_kind = variants.kinds.iter().find(|(of, ..)| Some(*of) == kind);
    variants.shared.contains(&name)
        || of_kind.is_some_and(|(_, needed, optional)| needed.contains(&name) || optional.contains(&name))
}

/// Returns `true` if a key at a path may have a quantity as its value.
pub(crate) fn is_quantity(path: &str, value: &str) -> bool {
    let dimensions = key_at(path).map(|key| key.kind.dimensions()).unwrap_or_default();
    dimensions.into_iter().any(|dimension| parse(dimension, value).is_ok())
}

/// Returns `true` if a key at a path may have a value.
pub(crate) fn takes(path: &str, value: &str) -> bool {
    match key_at(path).map(|key| key.kind) {
        None => false,
        Some(Kind::Quantity(..) | Kind::Along(..)) => is_quantity(path, value),
        Some(kind @ Kind::Number(..)) => {
            let is_percent = || kind.is_ratio() && value.trim_end().ends_with('%');
            value.parse::<f64>().is_ok() || is_percent() && parse(Dimension::Ratio, value).is_ok()
        }
        Some(Kind::Integer(..)) => value.parse::<i64>().is_ok(),
        Some(Kind::Bool) => truth(value).is_some(),
        Some(Kind::OneOf(words)) => words.contains(&value),
        Some(kind) => matches!(kind, Kind::Text | Kind::Texts | Kind::ListOf(_)),
    }
}

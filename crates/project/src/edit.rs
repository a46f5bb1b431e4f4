//! Edits of a project file at one place: order, comments and spelling of the rest are kept.

use crate::key::{Key, Kind};
use crate::read::joined;
use crate::root::KEYS;
use std::fmt;
use std::ops::Range as Span;
use toml_edit::{Array, ArrayOfTables, Document, DocumentMut, InlineTable, Item, Table, TableLike, Value};

/// An edit at a path: `load.inertia`, `motion[2].speed`, `axis[1].requirements.supply`; lists count from one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edit<'e> {
    /// Sets a value as typed into a field; an empty one removes the key.
    Value(&'e str),
    /// Inserts an empty table; in a list, before the entry at this index.
    Table,
    /// Removes a table, an entry of a list or a key.
    Gone,
    /// Keeps this table as the only one among its siblings, as for `mechanism.belt`.
    Instead,
    /// Swaps an entry of a list with the next one.
    Down,
    /// Duplicates an entry of a list behind itself.
    Twice,
}

/// Reason why a text was not changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EditFault {
    /// The text is no TOML, so that paths have no places in it.
    Syntax,
    /// The path does not belong to a key, or leads through a value that is no table.
    Path,
}

impl fmt::Display for EditFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Syntax => "the text is no TOML",
            Self::Path => "no key of a project file",
        })
    }
}

impl std::error::Error for EditFault {}

/// One part of a path: a key, and an index in its list from zero.
type Step<'p> = (&'p str, Option<usize>);

/// Largest number of entries of a list in an edit.
const ENTRIES_MOST: usize = 10_000;

fn steps(path: &str) -> Option<Vec<Step<'_>>> {
    let step = |part| -> Option<Step<'_>> {
        let part: &str = part;
        let Some((name, index)) = part.split_once('[') else { return Some((part, None)) };
        let index: usize = index.strip_suffix(']')?.parse().ok()?;
        (1..=ENTRIES_MOST).contains(&index).then(|| (name, Some(index - 1)))
    };
    path.split('.').map(step).collect()
}

/// Returns the description of the key at a path; `None` if the project file has no such key.
#[must_use]
pub fn key_at(path: &str) -> Option<&'static Key> {
    key_of(KEYS, path)
}

/// Returns the description of the key at a path of a record of measured values.
#[must_use]
pub fn measured_key_at(path: &str) -> Option<&'static Key> {
    key_of(crate::measured::MEASURED_KEYS, path)
}

/// Returns the description of the key at a path of a file with these keys at its root. Only a list has entries, and each key of
/// its tables belongs to one of them.
fn key_of(root: &'static [Key], path: &str) -> Option<&'static Key> {
    let names: Vec<(&str, bool)> = steps(path)?.into_iter().map(|(name, place)| (name, place.is_some())).collect();
    for count in 1..=names.len() {
        let kind = key_along(root, names.iter().take(count).copied())?.kind;
        let (_, is_entry) = *names.get(count - 1)?;
        let is_fitting = match kind {
            Kind::Variants(_) => is_entry || count == names.len(),
            Kind::OneOrMany(..) => true,
            _ => !is_entry,
        };
        if !is_fitting {
            return None;
        }
    }
    key_along(root, names)
}

/// Returns the key to which names lead from the root, each with `true` for an entry of a list.
pub(crate) fn key_along<'p>(
    root: &'static [Key],
    names: impl IntoIterator<Item = (&'p str, bool)>,
) -> Option<&'static Key> {
    let (mut keys, mut found) = (root, None);
    for (name, is_entry) in names {
        let key = keys.iter().find(|key| key.name == name)?;
        keys = key.kind.keys(is_entry);
        found = Some(key);
    }
    found
}

/// Returns the text with one edit.
///
/// # Errors
/// [`EditFault`].
pub fn edit(text: &str, path: &str, change: Edit<'_>) -> Result<String, EditFault> {
    edit_as(KEYS, text, path, change)
}

/// Returns the text of a record of measured values with one edit.
///
/// # Errors
/// [`EditFault`].
pub fn edit_measured(text: &str, path: &str, change: Edit<'_>) -> Result<String, EditFault> {
    edit_as(crate::measured::MEASURED_KEYS, text, path, change)
}

/// Returns the text with several values set: the text is read once, so that the time grows with its length.
///
/// # Errors
/// [`EditFault`].
pub fn edit_values(text: &str, values: &[(String, String)]) -> Result<String, EditFault> {
    let mut document: DocumentMut = text.parse().map_err(|_| EditFault::Syntax)?;
    for (path, value) in values {
        let _ = apply(KEYS, &mut document, path, Edit::Value(value))?;
    }
    Ok(document.to_string())
}

fn edit_as(root: &'static [Key], text: &str, path: &str, change: Edit<'_>) -> Result<String, EditFault> {
    let mut document: DocumentMut = text.parse().map_err(|_| EditFault::Syntax)?;
    Ok(if apply(root, &mut document, path, change)? { document.to_string() } else { text.to_owned() })
}

/// Applies an edit; returns `false` if the document does not have what it removes.
fn apply(root: &'static [Key], document: &mut DocumentMut, path: &str, change: Edit<'_>) -> Result<bool, EditFault> {
    let steps = steps(path).ok_or(EditFault::Path)?;
    let key = key_of(root, path).ok_or(EditFault::Path)?;
    let (last, above) = steps.split_last().ok_or(EditFault::Path)?;
    let mut reported = false;
    let comments = document.trailing().as_str().unwrap_or_default().to_owned();
    let make = match change {
        Edit::Table | Edit::Instead => Make::ForTable,
        Edit::Value(value) if !value.trim().is_empty() => Make::ForValue,
        Edit::Value(_) | Edit::Gone | Edit::Down | Edit::Twice => Make::Nothing,
    };
    let Some(parent) = down(document.as_table_mut(), above, make, &mut reported) else {
        // A missing value need not be removed.
        return if matches!(change, Edit::Down | Edit::Twice) { Err(EditFault::Path) } else { Ok(false) };
    };
    let reordered = match change {
        Edit::Value(value) => {
            set_value(parent, last, key, value.trim());
            false
        }
        Edit::Table => insert(parent, last).ok_or(EditFault::Path)?,
        Edit::Gone => {
            take(parent, last);
            false
        }
        Edit::Instead => {
            let others: Vec<String> =
                parent.iter().map(|(name, _)| name.to_owned()).filter(|name| name != last.0).collect();
            for other in others {
                let _ = parent.remove(&other);
            }
            if !parent.contains_key(last.0) {
                let _ = insert(parent, last);
            }
            true
        }
        Edit::Down => swap(parent, last).ok_or(EditFault::Path)?,
        Edit::Twice => double(parent, last).ok_or(EditFault::Path)?,
    };
    if reordered || reported {
        let mut place = 0;
        renumber(root, document.as_table_mut(), &mut place);
    }
    if reported {
        comments_before_the_last(document, &comments);
    }
    Ok(true)
}

/// Keeps comments at the end of a file below the table to which they belong: a table that was made behind it follows them.
/// In a plain project the switches of its last table are such comments.
fn comments_before_the_last(document: &mut DocumentMut, comments: &str) {
    /// Returns the last table by its position.
    fn last(table: &mut Table) -> Option<&mut Table> {
        fn position(item: &Item) -> Option<isize> {
            let of = |table: &Table| {
                let own = if table.is_implicit() { None } else { table.position() };
                own.into_iter().chain(table.iter().filter_map(|(_, item)| position(item))).max()
            };
            match item {
                Item::Table(table) => of(table),
                Item::ArrayOfTables(tables) => tables.iter().filter_map(of).max(),
                _ => None,
            }
        }
        let own = if table.is_implicit() { None } else { table.position() };
        let (name, below) = table
            .iter()
            .filter_map(|(name, item)| Some((name.to_owned(), position(item)?)))
            .max_by_key(|(_, position)| *position)
            .map_or((None, None), |(name, position)| (Some(name), Some(position)));
        if below <= own {
            return Some(table);
        }
        match table.get_mut(&name?)? {
            Item::Table(inner) => last(inner),
            Item::ArrayOfTables(tables) => {
                let place = tables.len().checked_sub(1)?;
                last(tables.get_mut(place)?)
            }
            _ => None,
        }
    }
    if !comments.contains('#') {
        return;
    }
    let Some(table) = last(document.as_table_mut()) else { return };
    // A table of the file has a prefix, though it may be empty; one that was made has none.
    if table.decor().prefix().is_some() {
        return;
    }
    let end = if comments.ends_with('\n') { "" } else { "\n" };
    table.decor_mut().set_prefix(format!("{comments}{end}\n"));
    document.set_trailing("");
}

/// Tables that are created on the way to a place.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Make {
    Nothing,
    /// Tables above a value.
    ForValue,
    /// Tables above a table, without a heading of their own.
    ForTable,
}

/// Returns the table at a path; missing tables on the way are created as `make` requires, and `made` is set.
fn down<'t>(
    root: &'t mut dyn TableLike,
    path: &[Step<'_>],
    make: Make,
    made: &mut bool,
) -> Option<&'t mut dyn TableLike> {
    let Some(((name, place), rest)) = path.split_first() else { return Some(root) };
    if !root.contains_key(name) {
        if make == Make::Nothing || place.is_some_and(|place| place > 0) {
            return None;
        }
        *made = true;
        let mut table = Table::new();
        // A table that contains only tables needs no heading.
        table.set_implicit(place.is_none() && (!rest.is_empty() || make == Make::ForTable));
        let item = match place {
            Some(_) => Item::ArrayOfTables(ArrayOfTables::from_iter([table])),
            None => Item::Table(table),
        };
        let _ = root.insert(name, item);
    }
    let next = match (root.get_mut(name)?, place) {
        (Item::ArrayOfTables(tables), Some(place)) => tables.get_mut(*place)? as &mut dyn TableLike,
        (Item::Value(Value::Array(array)), Some(place)) => array.get_mut(*place)?.as_inline_table_mut()?,
        (item, None) => item.as_table_like_mut()?,
        _ => return None,
    };
    down(next, rest, make, made)
}

/// Sets the typed value of a key, in the type of the key; a value of another type stays a text, and the reader of the
/// project reports the expected type.
fn set_value(table: &mut dyn TableLike, (name, place): &Step<'_>, key: &Key, typed: &str) {
    if place.is_some() {
        return;
    }
    if typed.is_empty() {
        let _ = table.remove(name);
        return;
    }
    let mut value = typed_as(key.kind, typed);
    match table.get_mut(name).and_then(Item::as_value_mut) {
        Some(old) => {
            // The comment behind the value is kept.
            *value.decor_mut() = old.decor().clone();
            if old.as_str().is_none_or(|old| Some(old) != value.as_str()) {
                *old = value;
            }
        }
        None => {
            let _ = table.insert(name, Item::Value(value));
        }
    }
}

fn typed_as(kind: Kind, typed: &str) -> Value {
    let parts = |text: &str| -> Vec<String> {
        text.split([',', ';', '\n']).map(|part| part.trim().to_owned()).filter(|part| !part.is_empty()).collect()
    };
    let lines = || typed.lines().map(str::trim).filter(|line| !line.is_empty());
    let number = |text: &str| -> Value {
        match (text.parse::<i64>(), text.parse::<f64>()) {
            (Ok(whole), _) => whole.into(),
            (_, Ok(number)) if number.is_finite() => number.into(),
            _ => text.into(),
        }
    };
    // A list may be typed as the file writes it, `["C1024", "M512P"]`.
    let is_list = matches!(kind, Kind::Numbers(..) | Kind::ListOf(_) | Kind::Texts | Kind::Bodies | Kind::Rows(_));
    if let Some(Value::Array(list)) = is_list.then(|| typed.trim().parse::<Value>().ok()).flatten() {
        return Value::Array(list);
    }
    match kind {
        Kind::Number(..) | Kind::Integer(..) => number(typed),
        Kind::Bool => typed.parse::<bool>().map_or_else(|_| typed.into(), Value::from),
        Kind::Numbers(..) => parts(typed).iter().map(|part| number(part)).collect::<Array>().into(),
        Kind::ListOf(_) | Kind::Texts => parts(typed).into_iter().collect::<Array>().into(),
        Kind::Bodies => spread(lines().map(Value::from).collect()),
        Kind::Rows(_) => {
            let row = |line: &str| line.split(';').map(str::trim).filter(|part| !part.is_empty()).collect::<Array>();
            spread(lines().map(|line| row(line).into()).collect())
        }
        _ => typed.into(),
    }
}

/// Returns a list with a line for each entry.
fn spread(entries: Vec<Value>) -> Value {
    let mut array: Array = entries.into_iter().collect();
    for entry in array.iter_mut() {
        entry.decor_mut().set_prefix("\n  ");
    }
    array.set_trailing("\n");
    array.set_trailing_comma(true);
    array.into()
}

/// Inserts an empty table, or an empty entry of a list before the one at its index; returns `true` if the order
/// changed.
fn insert(parent: &mut dyn TableLike, (name, place): &Step<'_>) -> Option<bool> {
    let Some(place) = *place else {
        if parent.contains_key(name) {
            return Some(false);
        }
        let _ = parent.insert(name, Item::Table(Table::new()));
        return Some(true);
    };
    match parent.get_mut(name) {
        None => {
            let _ = parent.insert(name, Item::ArrayOfTables(ArrayOfTables::from_iter([Table::new()])));
        }
        Some(Item::ArrayOfTables(tables)) => {
            reorder(tables, |all| all.insert(place.min(all.len()), Table::new()));
        }
        Some(Item::Value(Value::Array(array))) => array.insert(place.min(array.len()), InlineTable::new()),
        Some(_) => return None,
    }
    Some(true)
}

fn take(parent: &mut dyn TableLike, (name, place): &Step<'_>) {
    let Some(place) = *place else {
        let _ = parent.remove(name);
        return;
    };
    let empty = match parent.get_mut(name) {
        Some(Item::ArrayOfTables(tables)) if place < tables.len() => {
            tables.remove(place);
            tables.is_empty()
        }
        Some(Item::Value(Value::Array(array))) if place < array.len() => {
            let _ = array.remove(place);
            array.is_empty()
        }
        _ => false,
    };
    if empty {
        let _ = parent.remove(name);
    }
}

fn reorder(tables: &mut ArrayOfTables, change: impl FnOnce(&mut Vec<Table>)) {
    let mut all = std::mem::take(tables).into_iter().collect();
    change(&mut all);
    *tables = all.into_iter().collect();
}

/// Swaps an entry of a list with the next one, if there is one.
fn swap(parent: &mut dyn TableLike, (name, place): &Step<'_>) -> Option<bool> {
    let place = (*place)?;
    match parent.get_mut(name)? {
        Item::ArrayOfTables(tables) => {
            reorder(tables, |all| {
                if place + 1 < all.len() {
                    all.swap(place, place + 1);
                }
            });
        }
        Item::Value(Value::Array(array)) if place + 1 < array.len() => {
            let moved = array.remove(place);
            array.insert_formatted(place + 1, moved);
        }
        _ => {}
    }
    Some(true)
}

/// Duplicates an entry of a list behind itself.
fn double(parent: &mut dyn TableLike, (name, place): &Step<'_>) -> Option<bool> {
    let place = (*place)?;
    match parent.get_mut(name)? {
        Item::ArrayOfTables(tables) => {
            reorder(tables, |all| {
                if let Some(mut again) = all.get(place).cloned() {
                    // The text above the entry, e.g. a comment, belongs to the original alone.
                    again.decor_mut().set_prefix("\n");
                    all.insert(place + 1, again);
                }
            });
        }
        Item::Value(Value::Array(array)) => {
            if let Some(again) = array.get(place).cloned() {
                array.insert_formatted(place + 1, again);
            }
        }
        _ => return None,
    }
    Some(true)
}

/// Assigns new positions to the tables: the existing ones keep their order, and each precedes its own subtables.
fn renumber(root: &[Key], table: &mut Table, place: &mut isize) {
    /// Returns the position of the first table below an item; new ones come last.
    fn stood(item: &Item) -> isize {
        let of = |table: &Table| {
            let own = if table.is_implicit() { None } else { table.position() };
            own.into_iter().chain(table.iter().map(|(_, item)| stood(item))).min().unwrap_or(isize::MAX)
        };
        match item {
            Item::Table(table) => of(table),
            Item::ArrayOfTables(tables) => tables.iter().map(of).min().unwrap_or(isize::MAX),
            _ => isize::MAX,
        }
    }
    if !table.is_implicit() {
        table.set_position(Some(*place));
        *place += 1;
    }
    let places: Vec<(isize, String)> = table.iter().map(|(name, item)| (stood(item), name.to_owned())).collect();
    let described = |name: &str| root.iter().position(|key| key.name == name);
    let is_root = *place <= 1;
    // At the root a new table precedes those that follow it in the description.
    let wanted = |stood: isize, name: &str| {
        if stood < isize::MAX || !is_root {
            return (stood, true);
        }
        let behind = places.iter().filter(|(_, other)| described(other) > described(name));
        (behind.map(|(stood, _)| *stood).min().unwrap_or(isize::MAX), false)
    };
    let mut names = places.clone();
    names.sort_by_key(|(stood, name)| wanted(*stood, name));
    for (_, name) in names {
        match table.get_mut(&name) {
            Some(Item::Table(below)) if !below.is_dotted() => renumber(root, below, place),
            Some(Item::ArrayOfTables(tables)) => tables.iter_mut().for_each(|below| renumber(root, below, place)),
            _ => {}
        }
    }
}

/// A key of a text with its value, independent of its validity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// Path, as in [`crate::Input`].
    pub path: String,
    /// Value as typed into a field; `None` for a table.
    pub value: Option<String>,
    /// Place of its value in the text, in bytes; for a table, that of its heading.
    pub span: Span<usize>,
}

/// Returns every key and table of a text in the order of the tables; `None` if the text is no TOML.
#[must_use]
pub fn written(text: &str) -> Option<Vec<Written>> {
    let document = Document::parse(text).ok()?;
    let mut found = Vec::new();
    of_table(document.as_table(), "", &mut found);
    Some(found)
}

/// Returns the names of the files that a project names, recordings and catalogue files, independent of the validity of its values.
#[must_use]
pub fn files_named(text: &str) -> Vec<String> {
    fn of(table: &dyn TableLike, found: &mut Vec<String>) {
        for (name, item) in table.iter() {
            match item {
                Item::Value(value) if matches!(name, "file" | "files") => {
                    let entries = value.as_array().into_iter().flat_map(|array| array.iter());
                    found.extend(entries.chain([value]).filter_map(Value::as_str).map(str::to_owned));
                }
                Item::Value(Value::Array(array)) => {
                    array.iter().filter_map(Value::as_inline_table).for_each(|entry| of(entry, found));
                }
                Item::Value(Value::InlineTable(inside)) => of(inside, found),
                Item::Table(inside) => of(inside, found),
                Item::ArrayOfTables(tables) => tables.iter().for_each(|entry| of(entry, found)),
                Item::Value(_) | Item::None => {}
            }
        }
    }
    let mut found = Vec::new();
    if let Ok(document) = Document::parse(text) {
        of(document.as_table(), &mut found);
    }
    found
}

fn of_table(table: &dyn TableLike, path: &str, found: &mut Vec<Written>) {
    fn add(table: &dyn TableLike, path: String, span: Option<Span<usize>>, found: &mut Vec<Written>) {
        found.push(Written { path: path.clone(), value: None, span: span.unwrap_or_default() });
        of_table(table, &path, found);
    }
    for (name, item) in table.iter() {
        let path = joined(path, name);
        match item {
            Item::Value(Value::Array(array)) if array.iter().any(Value::is_inline_table) => {
                for (place, entry) in array.iter().enumerate() {
                    let Some(entry_table) = entry.as_inline_table() else { continue };
                    add(entry_table, format!("{path}[{}]", place + 1), entry.span(), found);
                }
            }
            Item::Value(Value::InlineTable(inside)) => add(inside, path, item.span(), found),
            Item::Value(value) => {
                found.push(Written { path, value: Some(typed(value)), span: item.span().unwrap_or_default() });
            }
            Item::Table(inside) => add(inside, path, item.span(), found),
            Item::ArrayOfTables(tables) => {
                for (place, inside) in tables.iter().enumerate() {
                    add(inside, format!("{path}[{}]", place + 1), inside.span(), found);
                }
            }
            Item::None => {}
        }
    }
}

/// Returns a value as typed into a field.
fn typed(value: &Value) -> String {
    let plain = |value: &Value| match value {
        Value::String(text) => text.value().clone(),
        other => {
            let mut other = other.clone();
            other.decor_mut().clear();
            other.to_string()
        }
    };
    match value {
        Value::Array(rows) if rows.iter().any(Value::is_array) => {
            let row = |row: &Value| match row {
                Value::Array(parts) => parts.iter().map(plain).collect::<Vec<_>>().join("; "),
                other => plain(other),
            };
            rows.iter().map(row).collect::<Vec<_>>().join("\n")
        }
        Value::Array(parts) if parts.iter().any(|part| part.as_str().is_some_and(|text| text.contains('='))) => {
            parts.iter().map(plain).collect::<Vec<_>>().join("\n")
        }
        Value::Array(parts) => parts.iter().map(plain).collect::<Vec<_>>().join(", "),
        other => plain(other),
    }
}

#[cfg(test)]
mod tests;

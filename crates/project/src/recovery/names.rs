//! Headings and keys of damaged lines as they are meant, by the description of the file.

use super::statements::is_of_key;

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KeyName {
    pub(crate) name: &'static str,
    /// The table that it names; `None` for a value.
    pub(crate) table: Option<TableKind>,
}

/// Brackets of the heading of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TableKind {
    One,
    Many,
    OneOrMany,
}

/// Returns the keys of the table at a path; none if there is no such table.
pub(crate) type KeysAt<'k> = &'k dyn Fn(&[String]) -> Vec<KeyName>;

/// Returns the key of a table that is nearest to a name, if it is near.
fn nearest_key(keys: &[KeyName], name: &str) -> Option<KeyName> {
    let name = name.to_lowercase();
    let distance = |key: &KeyName| strsim::damerau_levenshtein(&name, key.name);
    let near = keys.iter().copied().min_by_key(distance)?;
    (name.len() <= 2 * near.name.len() && distance(&near) * 2 <= near.name.len()).then_some(near)
}

/// A heading: its names, and its brackets.
#[derive(Debug)]
pub(super) struct Heading {
    pub(super) path: Vec<String>,
    is_list: bool,
}

impl Heading {
    /// Returns the heading as it is written without damage.
    pub(super) fn written(&self) -> String {
        let path = self.path.join(".");
        if self.is_list { format!("[[{path}]]") } else { format!("[{path}]") }
    }

    /// Returns the heading with these names, each the nearest of its table; `None` without one.
    fn nearest(keys: KeysAt<'_>, names: &[String], brackets: usize) -> Option<Self> {
        let (mut path, mut is_list) = (Vec::new(), false);
        for name in names {
            let tables: Vec<KeyName> = keys(&path).into_iter().filter(|key| key.table.is_some()).collect();
            let key = nearest_key(&tables, name)?;
            path.push(key.name.to_owned());
            is_list = match key.table {
                Some(TableKind::Many) => true,
                Some(TableKind::OneOrMany) => brackets > 1,
                Some(TableKind::One) | None => false,
            };
        }
        (!path.is_empty()).then_some(Self { path, is_list })
    }

    fn exact(keys: KeysAt<'_>, names: &[String], brackets: usize) -> Option<Self> {
        Self::nearest(keys, names, brackets).filter(|heading| heading.path == names)
    }

    /// Returns the heading that a damaged line stands for: the names without the damage, or the nearest ones.
    pub(super) fn meant(keys: KeysAt<'_>, line: &str) -> Option<Self> {
        let line = line.split('#').next().unwrap_or_default();
        let count = |bracket: char| line.chars().filter(|sign| *sign == bracket).count();
        let brackets = count('[').max(count(']'));
        let candidates = Self::candidates(line);
        let exact = candidates.iter().find_map(|names| Self::exact(keys, names, brackets));
        exact.or_else(|| candidates.iter().find_map(|names| Self::nearest(keys, names, brackets)))
    }

    /// Returns the heading that a line without brackets stands for, if its name is exact.
    pub(super) fn without_brackets(keys: KeysAt<'_>, line: &str) -> Option<Self> {
        let line = line.split('#').next().unwrap_or_default();
        if line.contains(['=', '"', '\'', ',']) {
            return None;
        }
        let brackets = line.chars().filter(|sign| matches!(sign, '[' | ']')).count();
        Self::candidates(line).iter().find_map(|names| Self::exact(keys, names, brackets))
    }

    /// Returns the names of a damaged heading: without spaces, and with a point or an underscore in their place.
    fn candidates(line: &str) -> Vec<Vec<String>> {
        let start = line.find(|sign: char| is_of_key(sign)).unwrap_or(line.len());
        let inner = line.get(start..).unwrap_or_default();
        let inner = inner.get(..inner.find(']').unwrap_or(inner.len())).unwrap_or_default();
        let names = |inner: &str| -> Vec<String> {
            let names = inner.split('.').map(|name| name.chars().filter(|sign| is_of_key(*sign)).collect::<String>());
            names.filter(|name| !name.is_empty()).collect()
        };
        let spaced = inner.split_whitespace();
        let with = |joint: &str| names(&spaced.clone().collect::<Vec<_>>().join(joint));
        let mut all = vec![with(""), with("."), with("_")];
        all.dedup();
        all
    }
}

/// Returns the key that a damaged line of a table states: the one as written if the table has it, or the nearest one; a
/// key that the table does not have is returned as written.
pub(super) fn key_of(keys: &[KeyName], line: &str) -> Option<String> {
    let line = line.trim_start_matches(|sign: char| !is_of_key(sign));
    let run = |text: &str| -> String {
        let end = text.find(|sign: char| !is_of_key(sign) && sign != '.').unwrap_or(text.len());
        text.get(..end).unwrap_or_default().trim_matches('.').to_owned()
    };
    let has = |name: &str| keys.iter().any(|key| key.name == name);
    let before = line.split(['=', ':', '#']).next().unwrap_or_default();
    let squeezed: String = before.chars().filter(|sign| is_of_key(*sign) || *sign == '.').collect();
    let first = run(line);
    if first.is_empty() {
        return None;
    }
    let candidates = [squeezed.trim_matches('.'), first.as_str()];
    if let Some(exact) = candidates.iter().find(|name| has(name)) {
        return Some((*exact).to_owned());
    }
    if first.contains('.') {
        let names: Vec<&str> = first.split('.').filter(|name| !name.is_empty()).collect();
        return Some(names.join("."));
    }
    let near = candidates.iter().find_map(|name| nearest_key(keys, name));
    Some(near.map_or(first, |key| key.name.to_owned()))
}

//! A project file as it was written: every key with its value.

use crate::Fault;
use serde::Deserialize;

/// One line of a project file, as written.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, serde::Serialize)]
#[serde(default)]
pub struct Input {
    /// Path of the key, `motion[1].speed`.
    pub key: String,
    /// The value as written, without quotes.
    pub text: String,
    /// The key in words.
    pub label: String,
    /// The unit, where it is not part of the text.
    pub unit: String,
    /// How exact it is, where the project says so.
    pub tolerance: String,
}

/// Every key of a project file with its written value, in the order of the file.
///
/// # Errors
/// [`Fault::Project`] when the text is no TOML.
pub fn inputs(project: &str) -> Result<Vec<Input>, Fault> {
    let table = toml::de::DeTable::parse(project).map_err(|fault| Fault::Project { message: fault.to_string() })?;
    let mut found = Vec::new();
    walk_table("", table.get_ref(), project, &mut found);
    found.sort_by_key(|(place, _)| *place);
    Ok(found.into_iter().map(|(_, input)| input).collect())
}

fn walk_table(path: &str, table: &toml::de::DeTable<'_>, text: &str, found: &mut Vec<(usize, Input)>) {
    for (key, value) in table {
        let key = key.get_ref();
        let path = if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
        walk(&path, value, text, found);
    }
}

fn walk(path: &str, value: &toml::Spanned<toml::de::DeValue<'_>>, text: &str, found: &mut Vec<(usize, Input)>) {
    use toml::de::DeValue;
    match value.get_ref() {
        DeValue::Table(table) => walk_table(path, table, text, found),
        DeValue::Array(items) if items.iter().any(|item| matches!(item.get_ref(), DeValue::Table(_))) => {
            for (index, item) in items.iter().enumerate() {
                walk(&format!("{path}[{}]", index + 1), item, text, found);
            }
        }
        other => {
            let written = match other {
                DeValue::String(written) => written.to_string(),
                _ => text.get(value.span()).unwrap_or_default().to_owned(),
            };
            found.push((value.span().start, Input { key: path.to_owned(), text: written, ..Input::default() }));
        }
    }
}

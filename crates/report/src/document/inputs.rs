//! The project as it was written, and what of it the sketch calls out.

use super::shown::Shown;
use crate::project::Input;
use serde::Serialize;

/// One table of the project file.
#[derive(Serialize)]
pub(super) struct Group {
    name: String,
    rows: Vec<Row>,
}

#[derive(Serialize)]
pub(super) struct Row {
    key: String,
    label: String,
    text: String,
    tolerance: String,
}

fn row(input: &Input, key: &str, shown: &Shown) -> Row {
    let text = if input.unit.is_empty() { input.text.clone() } else { format!("{} {}", input.text, input.unit) };
    Row {
        key: key.to_owned(),
        label: input.label.clone(),
        text: shown.written(&text),
        tolerance: shown.written(&input.tolerance),
    }
}

/// The inputs by table, in the order of the file.
pub(super) fn groups(inputs: &[Input], shown: &Shown) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for input in inputs {
        let (name, key) = input.key.rsplit_once('.').unwrap_or(("", &input.key));
        let row = row(input, key, shown);
        match groups.iter_mut().find(|group| group.name == name) {
            Some(group) => group.rows.push(row),
            None => groups.push(Group { name: name.to_owned(), rows: vec![row] }),
        }
    }
    groups
}

/// Kind of the mechanism and its data.
#[derive(Serialize)]
pub(super) struct Mechanism {
    /// Key below `mechanism`, `load` for a load without mechanism, empty where the project is not given.
    kind: String,
    rows: Vec<Row>,
}

/// What turns on the flange.
pub(super) fn mechanism(inputs: &[Input], shown: &Shown) -> Mechanism {
    let kind = inputs
        .iter()
        .find_map(|input| input.key.strip_prefix("mechanism."))
        .and_then(|rest| rest.split(['.', '[']).next())
        .map(str::to_owned);
    let kind = kind.or_else(|| inputs.iter().any(|input| input.key.starts_with("load.")).then(|| "load".to_owned()));
    let Some(kind) = kind else { return Mechanism { kind: String::new(), rows: Vec::new() } };
    let prefix = format!("mechanism.{kind}");
    let rows = inputs
        .iter()
        .filter_map(|input| {
            let rest = input.key.strip_prefix(&prefix).or_else(|| input.key.strip_prefix("load"))?;
            Some(row(input, rest.strip_prefix('.').unwrap_or(rest), shown))
        })
        .collect();
    Mechanism { kind, rows }
}

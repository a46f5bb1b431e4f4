//! Factors of the load as rows of a table: everything that an axis moves, multiplied by each of them.

use crate::command::typed::number_and_unit;
use project::{Written, loads};
use quantities::Language;
use words::{Usage, terminal, usage_text};

type Fault = (String, Option<String>);

/// Heading of the column of the factors, which is a label.
const FACTOR: &str = "load ×";

/// Returns the keys of the load with their values multiplied by a factor, each as a heading with its unit and a number; `None`
/// without a load whose values are plain quantities.
pub(super) fn of_load(all: &[Written], prefix: &str, factor: &str) -> Option<Vec<(String, String)>> {
    let factor: f64 = factor.trim().parse().ok()?;
    let mut found: Vec<(String, String)> = Vec::new();
    for load in &loads(all, prefix) {
        for (path, value) in load.scaled(factor)? {
            let (number, unit) = number_and_unit(&value);
            number.parse::<f64>().ok()?;
            let path = path.strip_prefix(prefix).unwrap_or(&path);
            let heading = if unit.is_empty() { path.to_owned() } else { format!("{path} [{unit}]") };
            if found.iter().all(|(known, _)| *known != heading) {
                found.push((heading, number.to_owned()));
            }
        }
    }
    (!found.is_empty()).then_some(found)
}

/// Returns the table with the values of the load in place of the column of the factors, which becomes a label. `own` returns the
/// keys of the load with their values for a factor.
///
/// # Errors
/// A factor that is none, and a key of the load that another column states.
pub(super) fn with_loads(
    rows: &str,
    heading: &str,
    own: impl Fn(&str) -> Option<Vec<(String, String)>>,
    language: Language,
) -> Result<String, Fault> {
    let none = || (terminal::no_load_to_scale(language).to_owned(), None);
    let mut lines = rows.lines();
    let head: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let place = head.iter().position(|each| *each == heading).ok_or_else(none)?;
    let keys = own("1").ok_or_else(none)?;
    let bare = |heading: &str| heading.split(" [").next().unwrap_or_default().to_owned();
    let others = head.iter().enumerate().filter(|(at, _)| *at != place).map(|(_, each)| bare(each));
    if let Some(twice) = others.into_iter().find(|other| keys.iter().any(|(key, _)| bare(key) == *other)) {
        return Err((usage_text(&Usage::Twice { name: twice }, language), None));
    }
    let mut table: Vec<String> = Vec::new();
    let of_row = |cells: &[&str], own: &str, more: Vec<String>| {
        let cells = cells.iter().enumerate().map(|(at, cell)| if at == place { own } else { *cell }.to_owned());
        cells.chain(more).collect::<Vec<String>>().join(",")
    };
    table.push(of_row(&head, FACTOR, keys.into_iter().map(|(key, _)| key).collect()));
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let factor = cells.get(place).copied().unwrap_or_default();
        let values = own(factor).ok_or_else(none)?;
        table.push(of_row(&cells, factor, values.into_iter().map(|(_, value)| value).collect()));
    }
    table.push(String::new());
    Ok(table.join("\n"))
}

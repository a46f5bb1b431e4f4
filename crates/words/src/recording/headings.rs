//! Names of columns, units, and lines to write.

use super::{quoted, role_key, role_text};
use crate::pick;
use crate::texts::said;
use quantities::{Dimension, Language, Unit};
use recording::{NearColumn, Role};

/// The column with the usual unit behind its name.
pub(super) fn header(column: &str, role: Role) -> String {
    let unit = role.dimensions().first().and_then(|dimension| dimension.units().first());
    format!("{column} [{}]", unit.map_or("", |unit: &Unit| unit.ascii))
}

pub(super) fn valid_units(role: Role, language: Language) -> String {
    let units = |dimension: &Dimension| {
        let names: Vec<&str> = dimension.units().iter().map(|unit| unit.ascii).collect();
        format!("{} ({})", dimension.name_with_article(language), names.join(", "))
    };
    let expected: Vec<String> = role.dimensions().iter().map(units).collect();
    let expected = expected.join(pick(language, " or ", " oder "));
    said!(language => "expected {expected}" | "erwartet wird {expected}")
}

/// Names of columns that are listed.
pub(super) const LIST_MOST: usize = 20;

/// The names of columns; more would only fill the screen.
pub(super) fn list(names: &[String], language: Language) -> String {
    let mut list = names.iter().take(LIST_MOST).map(|name| quoted(name, language)).collect::<Vec<_>>().join(", ");
    if names.len() > LIST_MOST {
        list.push_str(", …");
    }
    list
}

pub(super) fn columns(headers: &[String], language: Language) -> String {
    let list = list(headers, language);
    said!(language => "the columns are {list}" | "die Spalten sind {list}")
}

/// The lines that name the columns which were probably meant, or the columns and the names that are recognised.
pub(super) fn columns_and_names(headers: &[String], near: &[NearColumn], roles: &[Role], language: Language) -> String {
    if !near.is_empty() {
        let table = |pairs: Vec<String>| format!("{{ {} }}", pairs.join(", "));
        let pair = |near: &NearColumn, value: &str| format!("{} = {}", role_key(near.role), toml_text(value));
        let names = table(near.iter().map(|near| pair(near, &near.column)).collect());
        // The unit is left open: nothing in the file says it.
        let units: Vec<String> = near.iter().filter(|near| !near.has_unit).map(|near| pair(near, "…")).collect();
        let units = if units.is_empty() { String::new() } else { format!("; units = {}", table(units)) };
        let columns = columns(headers, language);
        return said!(language =>
            "{columns}; if these are the intended ones, state in the project: columns = {names}{units}"
            | "{columns}; wenn diese gemeint sind, im Projekt angeben: columns = {names}{units}"
        );
    }
    let names: Vec<&str> = roles.iter().flat_map(|role| role.names()).copied().collect();
    let (columns, names) = (columns(headers, language), names.join(", "));
    let lines: Vec<String> = roles.iter().map(|role| format!("columns = {{ {} = \"…\" }}", role_key(*role))).collect();
    let lines = lines.join(&said!(language => " or " | " oder "));
    said!(language =>
        "{columns}; recognised names: {names}; state any other name: {lines}"
        | "{columns}; erkannte Namen: {names}; andere Namen angeben: {lines}"
    )
}

/// A text as TOML writes it.
pub(super) fn toml_text(text: &str) -> String {
    if text.contains(['"', '\\']) && !text.contains('\'') {
        format!("'{text}'")
    } else {
        format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
    }
}

/// Returns the fault of a file whose first line holds numbers.
pub(super) fn heading_missing(columns: usize, language: Language) -> (String, Option<String>) {
    (
        said!(language =>
            "the file has no heading: its first line contains {columns} numbers whose meaning is not stated"
            | "die Datei hat keine Kopfzeile: in der ersten Zeile stehen {columns} Zahlen, deren Bedeutung nicht angegeben ist"
        ),
        Some(said!(language =>
            "write one, for example time [s];q [deg], or state the numbers of the columns and their units in the project: columns = {{ time = \"#1\", position = \"#2\" }} and units = {{ time = \"s\", position = \"deg\" }}"
            | "eine Kopfzeile schreiben, zum Beispiel time [s];q [deg], oder im Projekt die Nummern der Spalten und ihre Einheiten angeben: columns = {{ time = \"#1\", position = \"#2\" }} und units = {{ time = \"s\", position = \"deg\" }}"
        )),
    )
}

/// Returns the fault of a file whose first line holds units alone, with the first column of each role.
pub(super) fn heading_of_units(
    columns: &[(Role, usize, &'static Unit)],
    language: Language,
) -> (String, Option<String>) {
    let first = || {
        Role::ALL.into_iter().filter_map(|role| columns.iter().find(|(of, ..)| *of == role)).map(
            |(role, number, unit)| {
                (format!("{} = \"#{number}\"", role_key(*role)), format!("{} = \"{}\"", role_key(*role), unit.ascii))
            },
        )
    };
    let (numbers, units): (Vec<String>, Vec<String>) = first().unzip();
    let (numbers, units) = (numbers.join(", "), units.join(", "));
    (
        said!(language =>
            "the first line of the file contains units, no names of columns"
            | "in der ersten Zeile der Datei stehen Einheiten, keine Namen der Spalten"
        ),
        Some(said!(language =>
            "write the names above it, or state the columns in the project; by their units: columns = {{ {numbers} }}, units = {{ {units} }}"
            | "die Namen darüber schreiben oder die Spalten im Projekt angeben; nach den Einheiten: columns = {{ {numbers} }}, units = {{ {units} }}"
        )),
    )
}

/// Returns the fault of a unit that is stated for a role without a column, and its hint.
pub(super) fn unit_without_column(
    role: Role,
    headers: &[String],
    near: &[NearColumn],
    language: Language,
) -> (String, Option<String>) {
    let (name, key) = (role_text(role, language), role_key(role));
    (
        said!(language =>
            "a unit is stated for {name}, but no such column found"
            | "für {name} ist eine Einheit angegeben, aber keine Spalte gefunden"
        ),
        Some(said!(language =>
            "{}; columns = {{ {key} = \"none\" }} reads the file without one"
            | "{}; columns = {{ {key} = \"none\" }} liest die Datei ohne eine solche",
            columns_and_names(headers, near, &[role], language)
        )),
    )
}

/// Returns the fault of a heading with a factor beside the unit.
pub(super) fn scaled(column: &str, text: &str, language: Language) -> (String, Option<String>) {
    let fault = said!(language =>
        "{column}: {text} is more than a unit, and the stated unit would drop the rest"
        | "{column}: {text} ist mehr als eine Einheit, die angegebene Einheit ließe den Rest weg"
    );
    let hint = said!(language =>
        "multiply the values of the column and name the unit alone in the heading"
        | "die Werte der Spalte umrechnen und in der Überschrift nur die Einheit nennen"
    );
    (fault, Some(hint))
}

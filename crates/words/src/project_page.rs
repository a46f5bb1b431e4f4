//! The reference page of the project file, in Markdown: every key, from the description that the reader uses.

use super::key_text;
use crate::pages;
use crate::quantity::unpadded;
use project::{ColumnDimensions, KEYS, Key, Kind, Range, Variants};
use quantities::{Dimension, Language};

/// Returns the page in a language.
#[must_use]
pub fn project_page(language: Language) -> String {
    let mut page = format!("# {}\n\n{}\n", pages::title(language), pages::introduction(language));
    section(&mut page, pages::root(language), KEYS, language);
    for key in KEYS {
        below(&mut page, "", key, language);
    }
    let example = format!("`\"{} ± 10 %\"`", Dimension::MomentOfInertia.example());
    page.push_str(&format!(
        "\n## {}\n\n{}\n\n",
        pages::quantities_title(language),
        pages::quantities_about(&example, language)
    ));
    page.push_str(&format!("{}\n|---|---|\n", pages::columns_of_quantities(language)));
    for dimension in Dimension::ALL {
        let units: Vec<String> = dimension.units().iter().map(|unit| format!("`{}`", unit.ascii)).collect();
        page.push_str(&format!("| {} | {} |\n", dimension.name(language), units.join(" ")));
    }
    page
}

/// Appends the tables below a key, each with its heading.
fn below(page: &mut String, path: &str, key: &Key, language: Language) {
    let path = if path.is_empty() { key.name.to_owned() } else { format!("{path}.{}", key.name) };
    match key.kind {
        Kind::Table(keys) => {
            section(page, &format!("`[{path}]`"), keys, language);
            keys.iter().for_each(|key| below(page, &path, key, language));
        }
        Kind::OneOrMany(one, many) => {
            section(page, &format!("`[{path}]`"), one, language);
            let inside = many.iter().filter(|key| KEYS.iter().any(|root| root.name == key.name)).map(|key| key.name);
            page.push_str(&format!("\n{}\n", pages::several_axes(&names(inside), language)));
        }
        Kind::Variants(variants) => {
            section(page, &format!("`[[{path}]]`"), variants.keys, language);
            kinds(page, variants, language);
            variants.keys.iter().for_each(|key| below(page, &path, key, language));
        }
        _ => {}
    }
}

fn section(page: &mut String, heading: &str, keys: &[Key], language: Language) {
    page.push_str(&format!("\n## {heading}\n\n{}\n|---|---|---|---|\n", pages::columns_of_keys(language)));
    for key in keys {
        let name = if key.required { format!("**`{}`**", key.name) } else { format!("`{}`", key.name) };
        let about = key_text(key, language).replace('|', "\\|");
        page.push_str(&format!("| {name} | {} | {} | {about} |\n", value(key, language), sample(key)));
    }
}

/// Appends the keys that each kind of a table requires and may have.
fn kinds(page: &mut String, variants: &Variants, language: Language) {
    page.push_str(&format!("\n{}\n|---|---|---|\n", pages::columns_of_kinds(&variants.by, language)));
    for (name, needed, allowed) in variants.kinds {
        let (needed, allowed) = (names(needed.iter().copied()), names(allowed.iter().copied()));
        page.push_str(&format!("| `{name}` | {needed} | {allowed} |\n"));
    }
    if !variants.shared.is_empty() {
        let shared = names(variants.shared.iter().copied());
        page.push_str(&format!("\n{}\n", pages::every_kind_may_have(&shared, language)));
    }
}

fn names<'k>(keys: impl Iterator<Item = &'k str>) -> String {
    keys.map(|key| format!("`{key}`")).collect::<Vec<_>>().join(" ")
}

/// Returns a valid value of a key, without the key.
fn sample(key: &Key) -> String {
    match key.kind {
        Kind::Table(_) | Kind::OneOrMany(..) | Kind::Variants(_) | Kind::Text => String::new(),
        _ => {
            let line = project::example(key).unwrap_or_default();
            line.split_once("= ").map_or(String::new(), |(_, value)| format!("`{value}`"))
        }
    }
}

/// Returns the valid values of a key.
fn value(key: &Key, language: Language) -> String {
    // The large bounds are powers of ten.
    let shown = |number: f64| unpadded(number, if number.abs() < 1e7 { 7 } else { 1 }, language);
    let between = |low: f64, high: f64| pages::from_to(&shown(low), &shown(high), language);
    let name = |dimension: Dimension| dimension.name(language);
    match key.kind {
        Kind::Quantity(dimension, range) => format!("{}{}", name(dimension), bound(range)),
        Kind::Along(turning, line, range) => {
            format!("{} {} {}{}", name(turning), pages::or(language), name(line), bound(range))
        }
        Kind::Number(low, high) if key.kind.is_ratio() => {
            let example = format!("`\"{} %\"`", shown(100.0 * high.min(1.0)));
            format!("{} {} {} {example}", pages::number(language), between(low, high), pages::or(language))
        }
        Kind::Number(low, high) => format!("{} {}", pages::number(language), between(low, high)),
        Kind::Numbers(low, high, most) => {
            format!("{} {}{}", pages::numbers(language), between(low, high), pages::at_most(&most, language))
        }
        Kind::Integer(low, high) if low == high => format!("`{low}`"),
        Kind::Integer(low, high) => format!("{} {}", pages::integer(language), pages::from_to(&low, &high, language)),
        Kind::Bool => format!("`true` {} `false`", pages::or(language)),
        Kind::Text => pages::text(language).to_owned(),
        Kind::OneOf(words) => names(words.iter().copied()),
        Kind::ListOf(words) => format!("{} {}", pages::list_of(language), names(words.iter().copied())),
        Kind::Rows(columns) => {
            let or = format!(" {} ", pages::or(language));
            let of = |column: &ColumnDimensions| column.iter().map(|each| name(*each)).collect::<Vec<_>>().join(&or);
            format!("{} {}", pages::rows_of(language), columns.iter().map(of).collect::<Vec<_>>().join(", "))
        }
        Kind::Table(_) => pages::table(language).to_owned(),
        Kind::OneOrMany(..) => pages::table_or_tables(language).to_owned(),
        Kind::Texts => pages::texts(language).to_owned(),
        Kind::Bodies => pages::bodies(language).to_owned(),
        Kind::Variants(_) => pages::tables(language).to_owned(),
    }
}

const fn bound(range: Range) -> &'static str {
    match range {
        Range::Any => "",
        Range::NotNegative => " ≥ 0",
        Range::Positive => " > 0",
    }
}

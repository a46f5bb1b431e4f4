//! Reference page of the answers, generated from their schema.

use crate::schema::VERSION;
use serde_json::Value;
use std::fmt::Write as _;

/// Generates the page in Markdown from the schema of the answers: each command with its record, then every record with
/// its fields, and every set of words.
#[must_use]
pub fn reference(schema: &Value) -> String {
    let mut page = format!(
        "# Answers\n\n\
         What `--json` writes, field by field, version {VERSION}. This page is made from the records of the program, as is the\n\
         JSON Schema that `antrieb schema --answers` writes; [json.md](json.md) explains how to read them.\n\n\
         | command | answer |\n|---|---|\n"
    );
    for (command, answer) in schema.get("properties").and_then(Value::as_object).into_iter().flatten() {
        let _ = writeln!(page, "| `{command}` | {} |", shape(answer));
    }
    page.push_str("\nA command that cannot answer writes the record of `faults` instead and exits with 2.\n");
    for (name, record) in schema.get("$defs").and_then(Value::as_object).into_iter().flatten() {
        // The table of the commands lists the answers for one axis and for several.
        if name.starts_with("Answered_") || name.starts_with("Axes_") {
            continue;
        }
        let _ = writeln!(page, "\n## {name}\n");
        if let Some(about) = about(record) {
            let _ = writeln!(page, "{about}\n");
        }
        body(record, &mut page);
    }
    page
}

/// Iterates over the values of a list; empty if there is none.
fn list<'v>(schema: &'v Value, name: &str) -> impl Iterator<Item = &'v Value> {
    schema.get(name).and_then(Value::as_array).into_iter().flatten()
}

fn about(schema: &Value) -> Option<String> {
    Some(schema.get("description")?.as_str()?.split_whitespace().collect::<Vec<_>>().join(" "))
}

fn body(record: &Value, page: &mut String) {
    let words = words(record);
    if !words.is_empty() {
        let described = words.iter().any(|(_, about)| about.is_some());
        if described {
            page.push_str("| word | meaning |\n|---|---|\n");
            for (word, about) in words {
                let _ = writeln!(page, "| `{word}` | {} |", about.unwrap_or_default());
            }
        } else {
            let words: Vec<String> = words.into_iter().map(|(word, _)| format!("`{word}`")).collect();
            let _ = writeln!(page, "{}", words.join(" "));
        }
        return;
    }
    let Some(fields) = record.get("properties").and_then(Value::as_object) else {
        let _ = writeln!(page, "{}", shape(record));
        return;
    };
    let required: Vec<&str> = list(record, "required").filter_map(Value::as_str).collect();
    page.push_str("| field | value | meaning |\n|---|---|---|\n");
    for (name, field) in fields {
        let left_out = if required.contains(&name.as_str()) || is_nullable(field) { "" } else { ", may be left out" };
        let _ = writeln!(page, "| `{name}` | {}{left_out} | {} |", shape(field), about(field).unwrap_or_default());
    }
    for part in parts(record) {
        let _ = writeln!(page, "\nand the fields of {}", shape(part));
    }
}

/// Returns the records whose fields are merged into a record.
fn parts(record: &Value) -> Vec<&Value> {
    record.get("$ref").map(|_| record).into_iter().chain(list(record, "allOf")).collect()
}

/// Returns the words of a fixed set with their meanings.
fn words(schema: &Value) -> Vec<(String, Option<String>)> {
    let plain = list(schema, "enum").filter_map(|word| Some((word.as_str()?.to_owned(), None)));
    let stated = list(schema, "oneOf").filter_map(|each| {
        let word = each.get("const").or_else(|| each.get("enum")?.as_array()?.first())?.as_str()?;
        Some((word.to_owned(), about(each)))
    });
    plain.chain(stated).collect()
}

fn is_nullable(schema: &Value) -> bool {
    let is_null = |kind: &Value| kind == "null";
    list(schema, "type").any(is_null) || list(schema, "anyOf").any(|each| each.get("type").is_some_and(is_null))
}

/// Describes the form of a value in a few words.
fn shape(schema: &Value) -> String {
    if let Some(path) = schema.get("$ref").and_then(Value::as_str) {
        let name = path.rsplit('/').next().unwrap_or(path);
        return match name.strip_prefix("Answered_for_") {
            Some(of) => format!("{} or, of several axes, `{{\"verdict\", \"axes\": […]}}`", link(of)),
            None if name == "Number" => "number".to_owned(),
            None => link(name),
        };
    }
    if let Some(any) = schema.get("anyOf").and_then(Value::as_array) {
        return any.iter().map(shape).collect::<Vec<_>>().join(" or ");
    }
    let one = |kind: &str| match kind {
        "array" => format!("list of {}", items(schema)),
        "string" => "text".to_owned(),
        "integer" => "count".to_owned(),
        "boolean" => "true or false".to_owned(),
        "object" => match schema.get("additionalProperties") {
            Some(values) if values.is_object() => format!("fields of {}", shape(values)),
            _ => "fields".to_owned(),
        },
        other => other.to_owned(),
    };
    match schema.get("type") {
        Some(Value::String(kind)) => one(kind),
        Some(Value::Array(kinds)) => kinds.iter().filter_map(Value::as_str).map(one).collect::<Vec<_>>().join(" or "),
        _ => schema.get("const").map_or_else(|| "value".to_owned(), |word| format!("`{word}`")),
    }
}

fn items(schema: &Value) -> String {
    match schema.get("items").or_else(|| schema.get("prefixItems")?.get(0)) {
        Some(items) => shape(items),
        None => "values".to_owned(),
    }
}

fn link(name: &str) -> String {
    format!("[{name}](#{})", name.to_lowercase())
}

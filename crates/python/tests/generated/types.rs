//! The records of the answers as dataclasses.

use super::Schema;
use super::names::{class, doc, literal, name, sentence};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fmt::Write as _;

const HEAD: &str = r#""""The answers of antrieb as typed objects.

This file is written from the schema of the answers by `cargo xtask snapshots`; do not edit it. A number is `None` where it is
not finite, a field that an answer leaves out is `None`. The unit of a figure ends its name (`mass_kg`), stands in the field
`unit` beside it, or in the `units` of its record by the name of the field.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

"#;

/// Returns the module.
pub(super) fn module(schema: &Schema) -> String {
    let mut out = HEAD.to_owned();
    let mut all: Vec<String> = Vec::new();
    let named = || schema.definitions.iter().filter(|(definition, _)| !is_inlined(definition));
    for (definition, shape) in named().filter(|(_, shape)| is_record(shape)) {
        out.push_str(&record(definition, shape, schema));
    }
    out.push('\n');
    // Unlike the fields of a class a name is evaluated where it stands: behind the classes, and behind those it is made of.
    let mut waiting: Vec<(&str, String)> = named()
        .filter(|(_, shape)| !is_record(shape))
        .map(|(definition, shape)| (definition.as_str(), alias(definition, shape, schema)))
        .collect();
    while !waiting.is_empty() {
        let open: Vec<String> = waiting.iter().map(|(definition, _)| class(definition)).collect();
        let needs = |text: &str, own: &str| {
            let line = text.lines().find(|line| line.contains(" = ")).unwrap_or_default();
            let mut names = line.split(|sign: char| !sign.is_ascii_alphanumeric());
            names.any(|name| name != own && open.iter().any(|open| open == name))
        };
        let (later, now): (Vec<_>, Vec<_>) =
            waiting.into_iter().partition(|(definition, text)| needs(text, &class(definition)));
        if now.is_empty() {
            break;
        }
        out.extend(now.into_iter().map(|(_, text)| text));
        waiting = later;
    }
    all.extend(named().map(|(definition, _)| class(definition)));
    all.sort();
    let _ = write!(out, "\n__all__ = [\n");
    for known in &all {
        let _ = writeln!(out, "    \"{known}\",");
    }
    out.push_str("]\n");
    out
}

/// Returns `true` for a definition that needs no name of its own: a number, and the answer of one axis or several.
fn is_inlined(definition: &str) -> bool {
    definition == "Number" || definition.starts_with("Answered_for_")
}

fn is_record(shape: &Value) -> bool {
    shape.get("properties").is_some()
}

fn described(shape: &Value) -> Option<&str> {
    shape.get("description").and_then(Value::as_str)
}

/// Returns a name for a set of words, a map or a choice.
fn alias(definition: &str, shape: &Value, schema: &Schema) -> String {
    let mut out = format!("\n{} = {}\n", class(definition), of_shape(shape, schema, false));
    let mut about = described(shape).map(|text| vec![sentence(text)]).unwrap_or_default();
    for each in shape.get("oneOf").and_then(Value::as_array).into_iter().flatten() {
        if let (Some(word), Some(text)) = (each.get("const").and_then(Value::as_str), described(each)) {
            about.push(format!("`{word}`: {}", text.trim_end_matches('.')));
        }
    }
    if !about.is_empty() {
        let _ = writeln!(out, "\"\"\"{}\"\"\"", doc(&about.join("\n\n")));
    }
    out
}

/// Returns a record as a class.
fn record(definition: &str, shape: &Value, schema: &Schema) -> String {
    let empty = Map::new();
    let fields = shape.get("properties").and_then(Value::as_object).unwrap_or(&empty);
    let required: BTreeSet<&str> =
        shape.get("required").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str).collect();
    let own = class(definition);
    let mut out = format!("\n\n@dataclass(frozen=True, slots=True, kw_only=True)\nclass {own}:\n");
    let about = described(shape).map_or_else(|| format!("{own}."), sentence);
    let _ = writeln!(out, "    \"\"\"{}\"\"\"\n", doc(&about));
    for (field, shape) in fields {
        let of = of_shape(shape, schema, false);
        let is_open = !required.contains(field.as_str());
        let of = if is_open && !of.ends_with("None") { format!("{of} | None") } else { of };
        let usual = if is_open { " = None" } else { "" };
        let _ = writeln!(out, "    {}: {of}{usual}", name(field));
        if let Some(about) = described(shape) {
            let _ = writeln!(out, "    \"\"\"{}\"\"\"", doc(&sentence(about)));
        }
    }
    if let Some(axis) = one_axis(definition, schema) {
        let _ = write!(
            out,
            "\n    @property\n    def axes(self) -> list[{axis}]:\n        \"\"\"It as the answer of its only axis, as \
             `AxesOf{axis}` has those of several.\"\"\"\n        return [self]\n"
        );
    }
    out
}

/// Returns the class of a record that answers about one axis and has no field of this name itself.
fn one_axis(definition: &str, schema: &Schema) -> Option<String> {
    let has_several = schema.definitions.contains_key(&format!("Axes_of_{definition}"));
    let fields = schema.definitions.get(definition)?.get("properties")?;
    (has_several && fields.get("axes").is_none()).then(|| class(definition))
}

/// Returns the type of a shape; `of_module` for use outside of the module of the answers.
pub(super) fn of_shape(shape: &Value, schema: &Schema, of_module: bool) -> String {
    let within = |shape: &Value| of_shape(shape, schema, of_module);
    let several = |shapes: &Value| {
        let mut types: Vec<String> = Vec::new();
        for each in shapes.as_array().into_iter().flatten().map(within) {
            for part in each.split(" | ").map(str::to_owned) {
                if !types.contains(&part) {
                    types.push(part);
                }
            }
        }
        // `None` comes last.
        types.sort_by_key(|each| each == "None");
        types.join(" | ")
    };
    if let Some(path) = shape.get("$ref").and_then(Value::as_str) {
        let definition = path.trim_start_matches("#/$defs/");
        return match schema.definitions.get(definition) {
            Some(found) if is_inlined(definition) => within(found),
            _ if of_module => format!("answers.{}", class(definition)),
            _ => class(definition),
        };
    }
    if let Some(shapes) = shape.get("anyOf") {
        return several(shapes);
    }
    if let Some(shapes) = shape.get("oneOf").and_then(Value::as_array) {
        let words: Vec<&str> = shapes.iter().filter_map(|each| each.get("const").and_then(Value::as_str)).collect();
        return if words.len() == shapes.len() { literal(words) } else { several(&Value::Array(shapes.clone())) };
    }
    if let Some(words) = shape.get("enum").and_then(Value::as_array) {
        return literal(words.iter().filter_map(Value::as_str));
    }
    if let Some(word) = shape.get("const").and_then(Value::as_str) {
        return literal([word]);
    }
    match shape.get("type") {
        Some(Value::Array(kinds)) => {
            let each: Vec<Value> = kinds
                .iter()
                .map(|kind| {
                    let mut one = shape.clone();
                    if let Some(fields) = one.as_object_mut() {
                        fields.insert("type".to_owned(), kind.clone());
                    }
                    one
                })
                .collect();
            several(&Value::Array(each))
        }
        Some(Value::String(kind)) => match kind.as_str() {
            "string" => "str".to_owned(),
            "integer" => "int".to_owned(),
            "number" => "float".to_owned(),
            "boolean" => "bool".to_owned(),
            "null" => "None".to_owned(),
            "array" => format!("list[{}]", shape.get("items").map_or_else(|| "object".to_owned(), within)),
            "object" => {
                let values = shape.get("additionalProperties").filter(|values| values.is_object());
                format!("dict[str, {}]", values.map_or_else(|| "object".to_owned(), within))
            }
            _ => "object".to_owned(),
        },
        _ => "object".to_owned(),
    }
}

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

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from antrieb._nearest import NothingFits, judged, of_key
from antrieb._record import Explainable, Record, Rows, Tabular

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
    let base = match own.as_str() {
        "Check" => "Explainable",
        "Table" => "Tabular",
        _ => "Record",
    };
    let mut out = format!("\n\n@dataclass(frozen=True, slots=True, kw_only=True, repr=False)\nclass {own}({base}):\n");
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
            "\n    @property\n    def axes(self) -> Rows[{axis}]:\n        \"\"\"It as the answer of its only axis, as \
             `AxesOf{axis}` has those of several.\"\"\"\n        return Rows([self])\n"
        );
    }
    match own.as_str() {
        "Sizing" => out.push_str(CANDIDATES),
        "Glossary" => out.push_str(ENTRIES),
        "Rejection" => out.push_str(REJECTED),
        _ => {}
    }
    if let Some((field, of)) = entries(&own, fields, &required, schema) {
        let item = if own == "Sizing" { "of_key(self, key)".to_owned() } else { format!("self.{field}[key]") };
        let _ = write!(
            out,
            "\n    def __iter__(self) -> Iterator[{of}]:\n        return iter(self.{field})\n\n    def __len__(self) -> \
             int:\n        return len(self.{field})\n\n    def __contains__(self, item: object, /) -> bool:\n        return item \
             in self.{field}\n\n    def __getitem__(self, key: int | str, /) -> {of}:\n        return {item}\n"
        );
    }
    out
}

/// Properties of the answer of `size`.
const CANDIDATES: &str = r#"
    @property
    def best(self) -> Ranked | NothingFits:
        """The best fitting actuator; where none fits `NothingFits`, which is false and has no code."""
        return self.ranking[0] if self.ranking else NothingFits.of(self)

    @property
    def candidates(self) -> Rows[Ranked | Rejection]:
        """Every actuator that was judged: those that fit by rank, then those that do not fit by their excess.

        Beyond the `top` of the call the ranking is asked anew, once.

        Raises:
            ValueError: The project has changed since.
        """
        return judged(self)
"#;

/// Properties of a rejected actuator, so that a loop reads all entries of `candidates` alike.
const REJECTED: &str = r#"
    @property
    def verdict(self) -> Fit:
        """Verdict on the actuator: it does not fit."""
        return "does_not_fit"

    @property
    def tightest(self) -> CheckId | None:
        """Id of the governing check, as `check`."""
        return self.check
"#;

/// Property of the answer of `glossary`.
const ENTRIES: &str = r#"
    @property
    def entries(self) -> Rows[GlossaryWord | GlossaryTerm | GlossarySymbol]:
        """The words, the terms and the symbols."""
        return Rows([*self.words, *self.terms, *self.symbols])
"#;

/// Lists over which records with several of them iterate, by class.
const PRINCIPAL: &[(&str, &str)] = &[
    ("CodeFaults", "errors"),
    ("Commissioning", "parameters"),
    ("Connector", "pins"),
    ("Encoder", "words"),
    ("ExportWritten", "tables"),
    ("Identification", "estimates"),
    ("Recorded", "measurements"),
    ("SheetSection", "values"),
    ("Simulation", "verdicts"),
    ("SweepSummary", "answers"),
    ("Upkeep", "plan"),
    ("Wiring", "connectors"),
];

/// Returns the list of records over which a record iterates, and its type: its axes, checks or candidates, else the
/// principal one of several, else its only list of records; `None` for a table, which iterates over its rows.
fn entries(
    own: &str,
    fields: &Map<String, Value>,
    required: &BTreeSet<&str>,
    schema: &Schema,
) -> Option<(String, String)> {
    match own {
        "Sizing" => return Some(("candidates".to_owned(), "Ranked | Rejection".to_owned())),
        "Glossary" => return Some(("entries".to_owned(), "GlossaryWord | GlossaryTerm | GlossarySymbol".to_owned())),
        "Table" => return None,
        _ => {}
    }
    let lists: Vec<(String, String)> = fields
        .iter()
        .filter(|(field, _)| required.contains(field.as_str()))
        .filter_map(|(field, shape)| {
            let of = of_shape(shape, schema, false);
            let inside = of.strip_prefix("Rows[")?.strip_suffix(']')?;
            Some((name(field), inside.to_owned()))
        })
        .collect();
    let named = |wanted: &str| lists.iter().find(|(field, _)| field == wanted).cloned();
    let only = (lists.len() == 1).then(|| lists.first().cloned()).flatten();
    let principal = || PRINCIPAL.iter().find(|(class, _)| *class == own).and_then(|(_, field)| named(field));
    named("axes").or_else(|| named("checks")).or_else(|| named("candidates")).or_else(principal).or(only)
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
            "array" => {
                let of = shape.get("items").map_or_else(|| "object".to_owned(), within);
                let name = of.strip_prefix("answers.").unwrap_or(&of);
                let is_of_records = schema.definitions.iter().any(|(definition, shape)| {
                    !is_inlined(definition) && is_record(shape) && class(definition) == name
                });
                if is_of_records && !of_module { format!("Rows[{of}]") } else { format!("list[{of}]") }
            }
            "object" => {
                let values = shape.get("additionalProperties").filter(|values| values.is_object());
                format!("dict[str, {}]", values.map_or_else(|| "object".to_owned(), within))
            }
            _ => "object".to_owned(),
        },
        _ => "object".to_owned(),
    }
}

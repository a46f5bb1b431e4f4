//! JSON Schema of the project file, from the same description that the reader uses.

use super::read::example;
use super::spec::{Key, Kind, ROOT};
use quantities::{Dimension, Language};
use serde_json::{Map, Value, json};

/// The JSON Schema of the project file (draft 2020-12).
#[must_use]
pub fn schema(language: Language) -> Value {
    let mut root = table(ROOT, language);
    if let Value::Object(map) = &mut root {
        map.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
        map.insert("title".into(), json!("antrieb project"));
    }
    root
}

fn table(keys: &[Key], language: Language) -> Value {
    let mut properties = Map::new();
    for key in keys {
        let mut schema = kind(key, language);
        if let Value::Object(map) = &mut schema {
            map.insert("description".into(), json!(if language == Language::De { key.de } else { key.en }));
            if let Some(line) = example(key).filter(|_| matches!(key.kind, Kind::Quantity(..))) {
                let value = line.split_once("= ").map_or("", |(_, value)| value).trim_matches('"').to_owned();
                map.insert("examples".into(), json!([value]));
            }
        }
        properties.insert(key.name.to_owned(), schema);
    }
    let required: Vec<&str> = keys.iter().filter(|key| key.required).map(|key| key.name).collect();
    json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false })
}

fn kind(key: &Key, language: Language) -> Value {
    match key.kind {
        Kind::Quantity(dimension, _) => json!({ "type": "string", "pattern": pattern(dimension) }),
        Kind::Number(low, high) => json!({ "type": "number", "minimum": low, "maximum": high }),
        Kind::Integer(low, high) if low == high => json!({ "const": low }),
        Kind::Integer(low, high) => json!({ "type": "integer", "minimum": low, "maximum": high }),
        Kind::Bool => json!({ "type": "boolean" }),
        Kind::Text => json!({ "type": "string" }),
        Kind::OneOf(words) => json!({ "type": "string", "enum": words }),
        Kind::ListOf(words) => json!({ "type": "array", "items": { "type": "string", "enum": words } }),
        Kind::Curve => json!({
            "type": "array",
            "minItems": 2,
            "items": {
                "type": "array",
                "prefixItems": [
                    { "type": "string", "pattern": pattern(Dimension::AngularVelocity) },
                    { "type": "string", "pattern": pattern(Dimension::Torque) },
                ],
                "minItems": 2,
                "maxItems": 2,
            },
        }),
        Kind::Table(keys) => table(keys, language),
        Kind::Tables(keys) => json!({ "type": "array", "minItems": 1, "items": table(keys, language) }),
    }
}

/// Number and unit in the spellings that the reader knows; it also forgives spaces inside a unit.
fn pattern(dimension: Dimension) -> String {
    let mut units: Vec<String> = Vec::new();
    for spelling in dimension.units().iter().flat_map(quantities::Unit::spellings).map(escape) {
        if !units.contains(&spelling) {
            units.push(spelling);
        }
    }
    format!(r"^\s*[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?\s*({})\s*$", units.join("|"))
}

/// A text as a regular expression for itself.
fn escape(text: &str) -> String {
    text.chars().flat_map(|c| if r"^.*+?()[]{}|\$".contains(c) { vec!['\\', c] } else { vec![c] }).collect()
}

//! JSON Schema of the project file, from the same description that the reader uses.

use crate::key::{Key, Kind, Variants, example};
use crate::root::KEYS;
use quantities::Dimension;
use serde_json::{Map, Value, json};

/// A text of the schema.
#[derive(Clone, Copy, Debug)]
pub enum SchemaText {
    /// Purpose of a key.
    Key(Key),
    /// Notation of a quantity.
    Quantity(Dimension),
}

/// Texts of the schema.
type Words<'w> = &'w dyn Fn(SchemaText) -> String;

/// Returns the JSON Schema of the project file (draft 2020-12), with the texts of `text`.
#[must_use]
pub fn schema(text: &dyn Fn(SchemaText) -> String) -> Value {
    let mut root = table(KEYS, text);
    if let Value::Object(map) = &mut root {
        map.insert("$schema".into(), json!("https://json-schema.org/draft/2020-12/schema"));
        map.insert("title".into(), json!("antrieb project"));
        // Each quantity is described once.
        let quantities = Dimension::ALL
            .iter()
            .map(|dimension| {
                let words = text(SchemaText::Quantity(*dimension));
                let spelling = json!({ "type": "string", "description": words, "pattern": pattern(*dimension) });
                (format!("{dimension:?}"), spelling)
            })
            .collect::<Map<String, Value>>();
        map.insert("$defs".into(), Value::Object(quantities));
        // A single axis is at the root with its load and motion, several are in [[axis]].
        let single = json!({ "required": ["motion"], "properties": { "axis": { "type": "object" } } });
        let several = json!({ "required": ["axis"], "properties": { "axis": { "type": "array" } } });
        map.insert("oneOf".into(), json!([one_load(single), several]));
        one_mechanism(map);
    }
    root
}

/// Returns a table that refers to the root for the keys described there.
fn as_at_the_root(keys: &[Key], text: Words<'_>) -> Value {
    let mut whole = table(keys, text);
    if let Some(Value::Object(properties)) = whole.get_mut("properties") {
        for (name, schema) in properties.iter_mut().filter(|(name, _)| KEYS.iter().any(|key| key.name == *name)) {
            *schema = json!({ "$ref": format!("#/properties/{name}") });
        }
    }
    whole
}

/// Requires one load: at the output, or through one mechanism.
fn one_load(mut schema: Value) -> Value {
    if let Value::Object(map) = &mut schema {
        map.insert("oneOf".into(), json!([{ "required": ["load"] }, { "required": ["mechanism"] }]));
        if let Some(Value::Array(required)) = map.get_mut("required")
            && !required.contains(&json!("motion"))
        {
            required.push(json!("motion"));
        }
        one_mechanism(map);
    }
    schema
}

fn one_mechanism(map: &mut Map<String, Value>) {
    if let Some(Value::Object(mechanism)) = map.get_mut("properties").and_then(|all| all.get_mut("mechanism")) {
        mechanism.insert("minProperties".into(), json!(1));
        mechanism.insert("maxProperties".into(), json!(1));
    }
}

/// Pairs of keys of which a table may have both but must have exactly one.
const ONE_OF_TWO: [[&str; 2]; 2] = [["body", "bodies"], ["mass", "density"]];

fn table(keys: &[Key], text: Words<'_>) -> Value {
    let mut properties = Map::new();
    for key in keys {
        let mut schema = kind(key, text);
        if let Value::Object(map) = &mut schema {
            map.insert("description".into(), json!(text(SchemaText::Key(*key))));
            if let Some(line) = example(key).filter(|_| matches!(key.kind, Kind::Quantity(..))) {
                let value = line.split_once("= ").map_or("", |(_, value)| value).trim_matches('"').to_owned();
                map.insert("examples".into(), json!([value]));
            }
        }
        properties.insert(key.name.to_owned(), schema);
    }
    let required: Vec<&str> = keys.iter().filter(|key| key.required).map(|key| key.name).collect();
    let mut whole =
        json!({ "type": "object", "properties": properties, "required": required, "additionalProperties": false });
    let has = |name: &str| keys.iter().any(|key| key.name == name && !key.required);
    for pair in ONE_OF_TWO.iter().filter(|pair| pair.iter().all(|name| has(name))) {
        let either: Vec<Value> = pair.iter().map(|name| json!({ "required": [name] })).collect();
        if let Value::Object(map) = &mut whole {
            map.insert("oneOf".into(), json!(either));
        }
    }
    whole
}

fn kind(key: &Key, text: Words<'_>) -> Value {
    match key.kind {
        Kind::Quantity(dimension, _) => reference(dimension),
        Kind::Number(low, high) if key.kind.is_ratio() => json!({
            "anyOf": [
                { "type": "number", "minimum": low, "maximum": high },
                { "type": "string", "pattern": "^\\s*[0-9.,]+\\s*%\\s*$" },
            ],
        }),
        Kind::Number(low, high) => json!({ "type": "number", "minimum": low, "maximum": high }),
        Kind::Numbers(low, high, most) => json!({
            "type": "array", "minItems": 1, "maxItems": most,
            "items": { "type": "number", "minimum": low, "maximum": high },
        }),
        Kind::Integer(low, high) if low == high => json!({ "const": low }),
        Kind::Integer(low, high) => json!({ "type": "integer", "minimum": low, "maximum": high }),
        Kind::Bool => json!({ "type": "boolean" }),
        Kind::Text => json!({ "type": "string" }),
        Kind::OneOf(words) => json!({ "type": "string", "enum": words }),
        Kind::Texts => json!({ "type": "array", "minItems": 1, "items": { "type": "string" } }),
        Kind::ListOf(words) => json!({ "type": "array", "items": { "type": "string", "enum": words } }),
        Kind::Along(turning, line, _) => json!({
            "anyOf": [reference(turning), reference(line)],
        }),
        Kind::Rows(columns) => {
            let parts: Vec<Value> = columns
                .iter()
                .map(|column| match column {
                    [only] => reference(*only),
                    several => json!({ "anyOf": several.iter().map(|each| reference(*each)).collect::<Vec<_>>() }),
                })
                .collect();
            json!({
                "type": "array",
                "minItems": 2,
                "items": {
                    "type": "array",
                    "prefixItems": parts,
                    "minItems": columns.len(),
                    "maxItems": columns.len(),
                },
            })
        }
        Kind::Table(keys) => table(keys, text),
        Kind::OneOrMany(one, many) => json!({
            "oneOf": [
                table(one, text),
                { "type": "array", "minItems": 1, "items": one_load(as_at_the_root(many, text)) },
            ],
        }),
        Kind::Bodies => json!({ "type": "array", "minItems": 1, "items": { "type": "string" } }),
        Kind::Variants(variants) => {
            let mut items = table(variants.keys, text);
            if let Value::Object(map) = &mut items {
                map.insert("allOf".into(), variants.kinds.iter().map(|kind| condition(variants, *kind)).collect());
            }
            json!({ "type": "array", "minItems": 1, "items": items })
        }
    }
}

/// Returns the condition "if it is of this kind, it needs these keys and has no others".
fn condition(variants: &Variants, (name, needed, allowed): (&str, &[&str], &[&str])) -> Value {
    let foreign: Vec<Value> = variants
        .keys
        .iter()
        .map(|key| key.name)
        .filter(|key| *key != variants.by && ![needed, allowed, variants.shared].iter().any(|keys| keys.contains(key)))
        .map(|key| json!({ "required": [key] }))
        .collect();
    let mut then = Map::new();
    then.insert("required".into(), json!(needed));
    if !foreign.is_empty() {
        then.insert("not".into(), json!({ "anyOf": foreign }));
    }
    json!({
        "if": { "properties": { variants.by: { "const": name } }, "required": [variants.by] },
        "then": then,
    })
}

/// Returns a reference to the description of a quantity.
fn reference(dimension: Dimension) -> Value {
    json!({ "$ref": format!("#/$defs/{dimension:?}") })
}

/// Returns the pattern of number and unit in the accepted spellings, and a tolerance; the reader also accepts spaces
/// inside a unit.
fn pattern(dimension: Dimension) -> String {
    const NUMBER: &str = r"([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?";
    let (units, signs) = (spellings(dimension), quantities::PLUS_MINUS.map(escape).join("|"));
    format!(r"^\s*[+-]?{NUMBER}\s*({units})\s*(({signs})\s*{NUMBER}\s*(%|{units})\s*)?$")
}

/// Returns the units of a quantity as alternatives of a regular expression.
fn spellings(dimension: Dimension) -> String {
    let mut units: Vec<String> = Vec::new();
    for spelling in dimension.units().iter().flat_map(quantities::Unit::spellings).map(escape) {
        if !units.contains(&spelling) {
            units.push(spelling);
        }
    }
    units.join("|")
}

/// Escapes a text for a regular expression.
fn escape(text: &str) -> String {
    text.chars().flat_map(|c| if r"^.*+?()[]{}|\$".contains(c) { vec!['\\', c] } else { vec![c] }).collect()
}

//! The list of endpoints as OpenAPI 3.1, with the schemas of the answers.

use super::{ROOT, entries, method, parameters};
use quantities::Language;
use questions::list::media::JSON;
use questions::list::{Argument, ArgumentKind, Entry, Gives, LANG, Reads, records};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use words::requests;

/// Path of the records that answers share.
const PLACE: &str = "#/components/schemas/";

/// Returns the description of the whole interface in a language.
pub(super) fn document(language: Language) -> Value {
    let answers = moved(answers::schema(&records()));
    let mut paths: Map<String, Value> = Map::new();
    for entry in entries() {
        let operations = paths.entry(format!("{ROOT}{}", entry.path)).or_insert_with(|| json!({}));
        if let Some(operations) = operations.as_object_mut() {
            operations.insert(method(entry).id().to_ascii_lowercase(), operation(entry, &answers, language));
        }
    }
    json!({
        "openapi": "3.1.0",
        "info": {
            "title": requests::title(language),
            "version": env!("CARGO_PKG_VERSION"),
            "description": requests::about(language),
        },
        "paths": paths,
        "components": { "schemas": answers.get("$defs").cloned().unwrap_or_default() },
    })
}

/// Returns a schema with its shared records moved to their place in OpenAPI.
fn moved(schema: Value) -> Value {
    match schema {
        Value::String(text) => Value::String(match text.strip_prefix("#/$defs/") {
            Some(name) => format!("{PLACE}{name}"),
            None => text,
        }),
        Value::Array(items) => Value::Array(items.into_iter().map(moved).collect()),
        Value::Object(fields) => Value::Object(fields.into_iter().map(|(name, value)| (name, moved(value))).collect()),
        other => other,
    }
}

fn operation(entry: &Entry, answers: &Value, language: Language) -> Value {
    let faults = json!({ "$ref": format!("{PLACE}Faults") });
    let lang = Argument { repeated: false, ..LANG };
    let mut responses = Map::new();
    responses.insert(
        "200".to_owned(),
        json!({ "description": requests::answered(language), "content": answer(entry, answers) }),
    );
    let of_code = entry.arguments.iter().any(|parameter| parameter.name == "code");
    let statuses: &[&str] = if entry.reads == Reads::Nothing { &["422", "503"] } else { &["413", "415", "422", "503"] };
    for status in statuses {
        let schema = match property(answers, "faults of a code") {
            // Faults of a code may be a record of their own.
            Some(codes) if of_code && *status == "422" => json!({ "anyOf": [faults, codes] }),
            _ => faults.clone(),
        };
        let response = json!({ "description": requests::not_answered(language), "content": content(JSON, &schema) });
        responses.insert((*status).to_owned(), response);
    }
    let parameters: Vec<Value> =
        parameters(entry).iter().chain([&lang]).map(|parameter| named(parameter, language)).collect();
    let mut operation = json!({
        "operationId": format!("{}_{}", method(entry).id().to_ascii_lowercase(), entry.path.replace(['/', '.'], "_")),
        "summary": (entry.about)(language),
        "parameters": parameters,
    });
    if let Some(operation) = operation.as_object_mut() {
        operation.extend(sent(entry.reads, language).map(|body| ("requestBody".to_owned(), body)));
        operation.insert("responses".to_owned(), responses.into());
    }
    operation
}

/// Returns a schema under its media type.
fn content(media: &str, schema: &Value) -> Value {
    json!({ media: { "schema": schema } })
}

fn property<'a>(answers: &'a Value, name: &str) -> Option<&'a Value> {
    answers.get("properties")?.get(name)
}

fn answer(entry: &Entry, answers: &Value) -> Value {
    let record = |command: &str| property(answers, command).cloned().unwrap_or_else(|| json!({}));
    let any = |types: &[&'static str]| types.iter().map(|media| (*media, json!({}))).collect();
    let schemas: BTreeMap<&'static str, Value> = match entry.gives {
        Gives::Record(its) => BTreeMap::from([(JSON, record(its.command))]),
        Gives::RecordOr(its, types) => {
            let mut both: BTreeMap<_, _> = any(types);
            both.insert(JSON, record(its.command));
            both
        }
        Gives::Json => any(&[JSON]),
        Gives::Media(types) => any(types),
    };
    schemas.into_iter().map(|(media, schema)| (media.to_owned(), json!({ "schema": schema }))).collect()
}

fn named(parameter: &Argument, language: Language) -> Value {
    let schema = match parameter.kind {
        ArgumentKind::Text | ArgumentKind::Code | ArgumentKind::File => json!({ "type": "string" }),
        ArgumentKind::Date => json!({ "type": "string", "format": "date" }),
        // A boolean, a number, or the text of either; a name without a value is true.
        ArgumentKind::Flag => json!({ "enum": [true, false, 1, 0, "true", "false", "1", "0", ""] }),
        ArgumentKind::Whole(least, most) => json!({ "type": "integer", "minimum": least, "maximum": most }),
        ArgumentKind::Word(words) => json!({ "type": "string", "enum": words() }),
    };
    json!({
        "name": parameter.name,
        "in": "query",
        "description": (parameter.about)(language),
        "required": parameter.required,
        "schema": if parameter.repeated { json!({ "type": "array", "items": schema }) } else { schema },
    })
}

fn sent(reads: Reads, language: Language) -> Option<Value> {
    let text = json!({ "type": "string" });
    let (description, media, schema) = match reads {
        Reads::Nothing => return None,
        Reads::Project => (requests::project_body(language), "application/toml", text),
        Reads::Measured => (requests::measured_body(language), "application/toml", text),
        Reads::Pins => (requests::pins_body(language), "text/csv", text),
        Reads::TwoProjects => {
            let both = json!({
                "type": "object",
                "properties": { "new": text, "old": text },
                "required": ["old", "new"],
                "additionalProperties": false,
            });
            (requests::two_projects_body(language), JSON, both)
        }
    };
    Some(json!({ "description": description, "required": true, "content": content(media, &schema) }))
}

//! The list of endpoints as OpenAPI 3.1, whose schemas are those of the answers.

use super::{ROOT, entries, method, parameters};
use quantities::Language;
use questions::list::media::JSON;
use questions::list::{Argument, ArgumentKind, Entry, Gives, LANG, Reads, records};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use words::requests;

/// A description of the interface.
#[derive(Serialize)]
pub(super) struct Document {
    openapi: &'static str,
    info: Info,
    paths: Map<String, Value>,
    components: Components,
}

#[derive(Serialize)]
struct Info {
    title: &'static str,
    version: &'static str,
    description: &'static str,
}

#[derive(Serialize)]
struct Components {
    schemas: Value,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Operation {
    operation_id: String,
    summary: &'static str,
    parameters: Vec<Named>,
    #[serde(skip_serializing_if = "Option::is_none")]
    request_body: Option<Sent>,
    responses: BTreeMap<&'static str, Response>,
}

/// A value of the query.
#[derive(Serialize)]
struct Named {
    name: &'static str,
    #[serde(rename = "in")]
    place: &'static str,
    description: &'static str,
    required: bool,
    schema: Schema,
}

/// The body of a request.
#[derive(Serialize)]
struct Sent {
    description: &'static str,
    required: bool,
    content: BTreeMap<&'static str, Content>,
}

#[derive(Serialize)]
struct Response {
    description: &'static str,
    content: BTreeMap<&'static str, Content>,
}

#[derive(Serialize)]
struct Content {
    schema: Schema,
}

/// A form, as JSON Schema has it.
#[derive(Serialize)]
#[serde(untagged)]
enum Schema {
    /// One that is described elsewhere.
    Ref {
        #[serde(rename = "$ref")]
        path: String,
    },
    /// One that is taken as it is.
    Whole(Value),
    /// A plain value.
    Plain {
        #[serde(rename = "type")]
        kind: &'static str,
        #[serde(rename = "enum", skip_serializing_if = "Option::is_none")]
        words: Option<Vec<&'static str>>,
        #[serde(skip_serializing_if = "Option::is_none")]
        minimum: Option<u64>,
        #[serde(skip_serializing_if = "Option::is_none")]
        maximum: Option<u64>,
    },
    /// True or false, in every way in which it is taken.
    Flag {
        #[serde(rename = "enum")]
        values: Vec<Value>,
    },
    /// A day.
    Day {
        #[serde(rename = "type")]
        kind: &'static str,
        format: &'static str,
    },
    /// Several of a plain value.
    Several {
        #[serde(rename = "type")]
        kind: &'static str,
        items: Box<Schema>,
    },
    /// Fields that are texts.
    Texts {
        #[serde(rename = "type")]
        kind: &'static str,
        properties: BTreeMap<&'static str, Schema>,
        required: [&'static str; 2],
        #[serde(rename = "additionalProperties")]
        others: bool,
    },
    /// Anything.
    Any {},
}

impl Schema {
    const fn plain(kind: &'static str) -> Self {
        Self::Plain { kind, words: None, minimum: None, maximum: None }
    }

    fn shared(name: &str) -> Self {
        Self::Ref { path: format!("{PLACE}{name}") }
    }
}

/// Where the records stand that the answers share.
const PLACE: &str = "#/components/schemas/";

/// The whole interface, described in a language.
pub(super) fn document(language: Language) -> Document {
    let answers = moved(answers::schema(&records()));
    let mut paths: Map<String, Value> = Map::new();
    for entry in entries() {
        let operations = paths.entry(format!("{ROOT}{}", entry.path)).or_insert_with(|| Value::Object(Map::new()));
        // An operation has string keys only: nothing in it can fail.
        let operation = serde_json::to_value(operation(entry, &answers, language)).unwrap_or_default();
        if let Some(operations) = operations.as_object_mut() {
            operations.insert(method(entry).id().to_ascii_lowercase(), operation);
        }
    }
    Document {
        openapi: "3.1.0",
        info: Info {
            title: requests::title(language),
            version: env!("CARGO_PKG_VERSION"),
            description: requests::about(language),
        },
        paths,
        components: Components { schemas: answers.get("$defs").cloned().unwrap_or_default() },
    }
}

/// A schema whose shared records stand where OpenAPI has them.
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

fn operation(entry: &Entry, answers: &Value, language: Language) -> Operation {
    let lang = Argument { repeated: false, ..LANG };
    let mut responses = BTreeMap::new();
    responses.insert("200", Response { description: requests::answered(language), content: answer(entry, answers) });
    let of_code = entry.arguments.iter().any(|parameter| parameter.name == "code");
    for status in ["422", "503"]
        .into_iter()
        .chain((entry.reads != Reads::Nothing).then_some(["413", "415"]).into_iter().flatten())
    {
        let schema = match answers.get("properties").and_then(|all| all.get("faults of a code")) {
            // What is wrong with a code may be reported as a record of its own.
            Some(codes) if of_code && status == "422" => {
                let both = [serde_json::to_value(Schema::shared("Faults")).unwrap_or_default(), codes.clone()];
                Schema::Whole(Value::Object(Map::from_iter([("anyOf".to_owned(), Value::Array(both.into()))])))
            }
            _ => Schema::shared("Faults"),
        };
        let content = BTreeMap::from([(JSON, Content { schema })]);
        responses.insert(status, Response { description: requests::not_answered(language), content });
    }
    Operation {
        operation_id: format!("{}_{}", method(entry).id().to_ascii_lowercase(), entry.path.replace(['/', '.'], "_")),
        summary: (entry.about)(language),
        parameters: parameters(entry).iter().chain([&lang]).map(|parameter| named(parameter, language)).collect(),
        request_body: sent(entry.reads, language),
        responses,
    }
}

fn answer(entry: &Entry, answers: &Value) -> BTreeMap<&'static str, Content> {
    let one = |schema| BTreeMap::from([(JSON, Content { schema })]);
    let record = |name| {
        let schema = answers.get("properties").and_then(|all| all.get(name)).cloned();
        schema.map_or(Schema::Any {}, Schema::Whole)
    };
    let bytes =
        |types: &[&'static str]| types.iter().map(|media| (*media, Content { schema: Schema::Any {} })).collect();
    match entry.gives {
        Gives::Record(its) => one(record(its.command)),
        Gives::RecordOr(its, types) => {
            let mut both: BTreeMap<&'static str, Content> = bytes(types);
            both.extend(one(record(its.command)));
            both
        }
        Gives::Json => one(Schema::Any {}),
        Gives::Media(types) => bytes(types),
    }
}

fn named(parameter: &Argument, language: Language) -> Named {
    let schema = match parameter.kind {
        ArgumentKind::Text | ArgumentKind::Code | ArgumentKind::File => Schema::plain("string"),
        ArgumentKind::Date => Schema::Day { kind: "string", format: "date" },
        ArgumentKind::Flag => Schema::Flag { values: flag_values() },
        ArgumentKind::Whole(least, most) => {
            Schema::Plain { kind: "integer", words: None, minimum: Some(least), maximum: Some(most) }
        }
        ArgumentKind::Word(words) => {
            Schema::Plain { kind: "string", words: Some(words()), minimum: None, maximum: None }
        }
    };
    Named {
        name: parameter.name,
        place: "query",
        description: (parameter.about)(language),
        required: parameter.required,
        schema: if parameter.repeated { Schema::Several { kind: "array", items: Box::new(schema) } } else { schema },
    }
}

/// As a boolean, as a number, as the text of either; a name without a value is true.
fn flag_values() -> Vec<Value> {
    let texts = ["true", "false", "1", "0", ""].map(Value::from);
    [true.into(), false.into(), 1.into(), 0.into()].into_iter().chain(texts).collect()
}

fn sent(reads: Reads, language: Language) -> Option<Sent> {
    let of = |description, media, schema| Sent {
        description,
        required: true,
        content: BTreeMap::from([(media, Content { schema })]),
    };
    let text = || Schema::plain("string");
    match reads {
        Reads::Nothing => None,
        Reads::Project => Some(of(requests::project_body(language), "application/toml", text())),
        Reads::Measured => Some(of(requests::measured_body(language), "application/toml", text())),
        Reads::Pins => Some(of(requests::pins_body(language), "text/csv", text())),
        Reads::TwoProjects => {
            let required = ["old", "new"];
            let properties = required.map(|name| (name, text())).into();
            let both = Schema::Texts { kind: "object", properties, required, others: false };
            Some(of(requests::two_projects_body(language), JSON, both))
        }
    }
}

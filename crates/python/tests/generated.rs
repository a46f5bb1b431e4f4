//! Generates `python/antrieb` from the list of questions, the schema of the answers and the
//! description of the keys: functions and classes.
//!
//! It is separate from the library and does not link it: the library is one that an interpreter loads.

#[path = "generated/functions.rs"]
mod functions;
#[path = "generated/names.rs"]
mod names;
#[path = "generated/sections.rs"]
mod sections;
#[path = "generated/types.rs"]
mod types;

use questions::list::records;
use serde_json::{Map, Value};

/// Names and descriptions of the schema of the answers.
struct Schema {
    properties: Map<String, Value>,
    definitions: Map<String, Value>,
}

impl Schema {
    fn of_the_answers() -> Self {
        let mut whole = answers::schema(&records());
        let mut part = |name: &str| match whole.get_mut(name).map(Value::take) {
            Some(Value::Object(fields)) => fields,
            _ => Map::new(),
        };
        Self { properties: part("properties"), definitions: part("$defs") }
    }
}

/// Returns the files with their content.
fn files() -> [(&'static str, String); 3] {
    let schema = Schema::of_the_answers();
    [
        ("answers.py", types::module(&schema)),
        ("questions.py", functions::module(&schema)),
        ("sections.py", sections::module()),
    ]
}

#[test]
fn the_package_is_that_of_the_list_and_the_schema() {
    for (file, text) in files() {
        testkit::generated::is_current(&format!("crates/python/python/antrieb/{file}"), &text);
    }
}

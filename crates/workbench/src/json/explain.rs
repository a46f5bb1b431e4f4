//! Derivations as JSON.

use super::{check, number};
use crate::explain::{Node, explanation};
use quantities::Language;
use serde_json::{Map, Value, json};
use sizing::Check;

/// A check with the derivation of its value and its limit.
#[must_use]
pub fn explain(found: &Check, language: Language) -> Value {
    let mut value = check(found, language);
    let explained = explanation(found, language);
    if let Value::Object(map) = &mut value {
        let tree = |root: &Option<Node>| root.as_ref().map_or(Value::Null, node);
        map.insert("derivation".into(), json!({ "value": tree(&explained.value), "limit": tree(&explained.limit) }));
    }
    value
}

fn node(found: &Node) -> Value {
    let mut map = Map::new();
    map.insert("symbol".into(), json!(found.symbol));
    if !found.term.is_empty() {
        map.insert("term".into(), json!(found.term));
    }
    if let Some(formula) = &found.formula {
        map.insert("formula".into(), json!(formula));
    }
    if let Some(figures) = &found.figures {
        map.insert("figures".into(), json!(figures));
    }
    map.insert("value".into(), number(found.value));
    map.insert("unit".into(), json!(found.unit_json));
    map.insert("grade".into(), json!(found.grade.map(provenance::Grade::id)));
    map.insert("source".into(), json!(found.source));
    if !found.errata.is_empty() {
        let errata: Vec<Value> =
            found.errata.iter().map(|(id, evidence)| json!({ "id": id, "evidence": evidence })).collect();
        map.insert("errata".into(), Value::Array(errata));
    }
    if found.is_repeated {
        map.insert("repeated".into(), json!(true));
    }
    if !found.operands.is_empty() {
        map.insert("operands".into(), found.operands.iter().map(node).collect());
    }
    Value::Object(map)
}

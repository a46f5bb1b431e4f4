//! The reference pages of the project file say what its description says.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use quantities::Language;

fn pages() -> [(&'static str, String); 2] {
    [("project.md", Language::En), ("projektdatei.md", Language::De)]
        .map(|(file, language)| (file, words::project_page(language)))
}

#[test]
fn the_pages_are_those_of_the_description() {
    for (file, page) in pages() {
        testkit::generated::is_current(&format!("docs/reference/{file}"), &page);
    }
}

/// The schema is made from the same description by another way: no key of it is missing on the pages.
#[test]
fn every_key_of_the_schema_is_reported() {
    fn keys(schema: &serde_json::Value, found: &mut Vec<String>) {
        match schema {
            serde_json::Value::Object(map) => {
                if let Some(properties) = map.get("properties").and_then(serde_json::Value::as_object) {
                    found.extend(properties.keys().cloned());
                }
                map.values().for_each(|value| keys(value, found));
            }
            serde_json::Value::Array(all) => all.iter().for_each(|value| keys(value, found)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    keys(&project::schema(&|_| String::new()), &mut found);
    assert!(found.len() > 150, "{}", found.len());
    for (file, page) in pages() {
        let missing: Vec<&String> = found.iter().filter(|key| !page.contains(&format!("`{key}`"))).collect();
        assert!(missing.is_empty(), "{file}: {missing:?}");
    }
}

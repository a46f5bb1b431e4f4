//! The reference page says what the records say.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test that cannot panic cannot fail")]

#[test]
fn the_page_is_that_of_the_records() {
    let page = answers::reference(&answers::schema(&questions::list::records()));
    testkit::generated::is_current("docs/reference/answers.md", &page);
}

/// Every field has a meaning.
#[test]
fn every_field_of_every_record_has_a_meaning() {
    let schema = answers::schema(&questions::list::records());
    let mut fields = 0;
    for (name, record) in schema["$defs"].as_object().unwrap() {
        for (field, about) in record.get("properties").and_then(|it| it.as_object()).into_iter().flatten() {
            assert!(about.get("description").is_some(), "{name}.{field}");
            fields += 1;
        }
    }
    assert!(fields > 150, "{fields}");
}

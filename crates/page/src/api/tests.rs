#![allow(clippy::indexing_slicing, reason = "JSON answers null for a missing key")]

use super::*;
use axis::{Catalogue, Files, NoFiles};
use project::PROJECT_MAX_BYTES;
use serde_json::Value;
use std::sync::Arc;

const PROJECT: &str = "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\n\
    accelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n";

struct Alone(Option<u64>);

impl Shell for Alone {
    fn files(&self) -> &dyn Files {
        &NoFiles
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn days_since_1970(&self) -> Option<u64> {
        self.0
    }

    fn version(&self, bytes: &[u8]) -> String {
        bytes.len().to_string()
    }
}

fn sent(method: Method, path: &str, query: &str, media: Option<&str>, body: &[u8]) -> Reply {
    let call = Call { method, path, query, media, body, language: Language::default() };
    crate::respond(&call, &Alone(None), &Progress::limited())
}

fn get(path: &str, query: &str) -> Reply {
    sent(Method::Get, path, query, None, b"")
}

fn post(path: &str, query: &str, body: &str) -> Reply {
    sent(Method::Post, path, query, Some("application/toml"), body.as_bytes())
}

fn json(reply: &Reply) -> Value {
    serde_json::from_slice(&reply.body).unwrap()
}

fn messages(reply: &Reply) -> Vec<String> {
    let faults = json(reply);
    faults["errors"].as_array().unwrap().iter().map(|fault| fault["message"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_path_that_is_none_and_a_method_that_is_not_answered_are_reported() {
    for path in ["/api", "/api/", "/api/v1", "/api/v1/", "/api/v2/size", "/api/v1/sizes", "/api/v1/size/"] {
        let reply = get(path, "");
        assert_eq!((reply.status, reply.media), (404, media::JSON), "{path}");
        assert!(messages(&reply)[0].contains(path), "{path}");
    }
    let reply = get("/api/v1/size", "");
    assert_eq!(reply.status, 405);
    assert!(reply.headers.contains(&("allow", "POST".to_owned())), "{:?}", reply.headers);
    let reply = post("/api/v1/data", "", "");
    assert!(reply.status == 405 && reply.headers.contains(&("allow", "GET, HEAD".to_owned())), "{:?}", reply.headers);
    assert_eq!(methods("/api/v1/wiring"), [Method::Get, Method::Post]);
    assert!(methods("/nowhere").is_empty());
}

#[test]
fn every_fault_of_a_query_is_told_at_once_with_what_is_near() {
    let reply = post("/api/v1/size", "tpo=3&top=0&samples=many&all=perhaps&lang=fr&seed=1&seed=2", PROJECT);
    assert_eq!(reply.status, 422);
    let faults = json(&reply);
    let found: Vec<(&str, &str)> = faults["errors"]
        .as_array()
        .unwrap()
        .iter()
        .map(|fault| (fault["option"].as_str().unwrap(), fault["hint"].as_str().unwrap_or_default()))
        .collect();
    let expected = [
        ("tpo", "did you mean `top`?"),
        ("top", "valid range: 1 to 65535"),
        ("samples", "a whole number is expected"),
        ("all", "valid here: true, false"),
        ("lang", "valid here: en, de"),
        ("seed", ""),
    ];
    assert_eq!(found, expected);
    let missing = post("/api/v1/plot", "by=length", PROJECT);
    assert_eq!((missing.status, messages(&missing)), (422, vec!["figure is missing".to_owned()]));
}

#[test]
fn a_project_comes_as_text_of_any_plain_type_and_as_no_other() {
    for media in [None, Some("application/toml"), Some("text/plain; charset=utf-8"), Some("Application/TOML"), Some("")]
    {
        assert_eq!(sent(Method::Post, "/api/v1/moves", "", media, PROJECT.as_bytes()).status, 200, "{media:?}");
    }
    // A form is read as plain text: its content has no effect on the settings.
    let form = sent(Method::Post, "/api/v1/moves", "", Some("application/x-www-form-urlencoded"), b"lang=de&axis=1");
    assert!(
        form.status == 422 && messages(&form).iter().any(|fault| fault.contains("expected")),
        "{:?}",
        messages(&form)
    );
    for media in ["application/json", "multipart/form-data; boundary=x", "image/png"] {
        assert_eq!(sent(Method::Post, "/api/v1/size", "", Some(media), PROJECT.as_bytes()).status, 415, "{media}");
    }
    let large = vec![b' '; PROJECT_MAX_BYTES + 1];
    assert_eq!(sent(Method::Post, "/api/v1/size", "", None, &large).status, 413);
    assert_eq!(sent(Method::Post, "/api/v1/size", "", None, b"format = 1\n\xff").status, 422);
}

#[test]
fn two_revisions_come_as_json() {
    let both = |old: &str, new: &str| serde_json::to_vec(&serde_json::json!({"old": old, "new": new})).unwrap();
    let asked = |body: &[u8]| sent(Method::Post, "/api/v1/diff", "", Some(media::JSON), body);
    let changed = PROJECT.replace("1.3", "1.4");
    let reply = asked(&both(PROJECT, &changed));
    assert_eq!(reply.status, 200, "{:?}", String::from_utf8_lossy(&reply.body));
    assert_eq!(json(&reply)["inputs"][0]["new"], "1.4 kg m^2");
    let reply = asked(&both(PROJECT, "format = 2"));
    assert!(reply.status == 422 && json(&reply)["errors"][0]["file"] == "new");
    for body in [&b"{}"[..], b"", b"{\"old\": 1, \"new\": \"\"}", PROJECT.as_bytes()] {
        assert_eq!(asked(body).status, 422);
    }
}

#[test]
fn tables_come_in_every_format() {
    for (query, begins, media) in [
        ("", &b"PK"[..], media::XLSX),
        ("format=xlsx", b"PK", media::XLSX),
        ("table=checks", b"{", media::JSON),
        ("table=checks&format=csv", b"code,", media::CSV),
        ("table=course&format=parquet", b"PAR1", media::PARQUET),
    ] {
        let reply = post("/api/v1/export", query, PROJECT);
        assert_eq!((reply.status, reply.media), (200, media), "{query}: {}", String::from_utf8_lossy(&reply.body));
        assert!(reply.body.starts_with(begins), "{query}: {:?}", reply.body.get(..20));
    }
    for query in ["format=csv", "format=xlsx&table=checks", "table=check", "format=pdf"] {
        assert_eq!(post("/api/v1/export", query, PROJECT).status, 422, "{query}");
    }
}

/// The course of a run: time and the named signals with their units, in the order of the call; without a format the record.
#[test]
fn the_course_of_a_run_comes_as_a_table() {
    let query = "code=CHA-25A-100-H-C1024&signals=speed,current_q&every=100+ms&format=csv";
    let reply = post("/api/v1/simulate", query, PROJECT);
    assert_eq!((reply.status, reply.media), (200, media::CSV), "{}", String::from_utf8_lossy(&reply.body));
    let text = String::from_utf8_lossy(&reply.body).into_owned();
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.next(), Some("time_s,speed_rad_s,current_q_a"));
    assert!(lines.next().is_some_and(|line| line.starts_with("0,")), "{text}");
    assert_eq!(lines.nth(1).map(|line| line.split(',').count()), Some(3));
    let whole = post("/api/v1/simulate", "code=CHA-25A-100-H-C1024&format=parquet&every=100+ms", PROJECT);
    assert!(whole.body.starts_with(b"PAR1"));
    let record = post("/api/v1/simulate", "code=CHA-25A-100-H-C1024", PROJECT);
    assert!(record.media == media::JSON && json(&record)["summary"].is_object());
    for (query, title) in [("", "Simulation"), ("&figure=control_loops&theme=dark&width=150+mm", "Control")] {
        let reply = post("/api/v1/simulate", &format!("code=CHA-25A-100-H-C1024&format=svg{query}"), PROJECT);
        let text = String::from_utf8_lossy(&reply.body);
        assert_eq!((reply.status, reply.media), (200, media::SVG), "{text}");
        assert!(text.starts_with("<svg") && text.contains(title), "{title}: {}", text.get(..600).unwrap_or_default());
    }
    for query in [
        "signals=speed",
        "signals=sped&format=csv",
        "format=xlsx",
        "figure=control_loops",
        "format=svg&signals=speed",
        "format=svg&width=1+mm",
    ] {
        assert_eq!(
            post("/api/v1/simulate", &format!("code=CHA-25A-100-H-C1024&{query}"), PROJECT).status,
            422,
            "{query}"
        );
    }
}

#[test]
fn a_picture_is_svg() {
    let reply = post("/api/v1/plot", "figure=torque_speed&theme=dark&width=100+mm", PROJECT);
    assert_eq!((reply.status, reply.media), (200, "image/svg+xml"));
    assert!(reply.body.starts_with(b"<svg"));
    assert_eq!(post("/api/v1/plot", "figure=torque_speed&width=1+mm", PROJECT).status, 422);
}

#[test]
fn whoever_does_not_wait_gets_no_answer() {
    let progress = Progress::limited();
    progress.cancel();
    let call = Call {
        method: Method::Post,
        path: "/api/v1/size",
        query: "",
        media: None,
        body: PROJECT.as_bytes(),
        language: Language::default(),
    };
    assert_eq!(crate::respond(&call, &Alone(None), &progress).status, 503);
}

#[test]
fn a_delivery_that_has_not_been_is_no_matter_of_a_shell_without_a_clock() {
    let query = "code=CHA-20A-100-H-C1024&delivered=2026-03-01";
    let asked = |days| {
        let call = Call {
            method: Method::Get,
            path: "/api/v1/upkeep",
            query,
            media: None,
            body: b"",
            language: Language::default(),
        };
        crate::respond(&call, &Alone(days), &Progress::limited()).status
    };
    assert_eq!([asked(None), asked(Some(20_514)), asked(Some(20_511))], [200, 200, 422]);
}

/// The description of the interface is complete: every endpoint with its parameters, and no missing schema.
#[test]
fn the_description_tells_every_endpoint_and_every_schema() {
    let document = json(&get("/api/v1/openapi.json", ""));
    assert_eq!(document["openapi"], "3.1.0");
    for entry in entries() {
        let operation = &document["paths"][format!("{ROOT}{}", entry.path)][method(entry).id().to_ascii_lowercase()];
        assert!(operation["summary"].as_str().is_some_and(|summary| summary.len() > 10), "{}", entry.path);
        assert_eq!(operation["parameters"].as_array().unwrap().len(), parameters(entry).len() + 1, "{}", entry.path);
        assert_eq!(operation["requestBody"].is_object(), method(entry) == Method::Post, "{}", entry.path);
        assert!(
            operation["responses"]["200"]["content"].as_object().is_some_and(|all| !all.is_empty()),
            "{}",
            entry.path
        );
        if let Gives::Record(_) | Gives::RecordOr(..) = entry.gives {
            let schema = &operation["responses"]["200"]["content"][media::JSON]["schema"];
            assert!(schema.as_object().is_some_and(|schema| !schema.is_empty()), "{}", entry.path);
        }
    }
    let mut looked = 0;
    resolve(&document, &document, &mut looked);
    assert!(looked > 100, "{looked}");
    let ids: Vec<&Value> = document["paths"]
        .as_object()
        .unwrap()
        .values()
        .flat_map(|operations| operations.as_object().unwrap().values())
        .map(|operation| &operation["operationId"])
        .collect();
    assert!(ids.iter().enumerate().all(|(index, id)| !ids[..index].contains(id)));
}

/// Every question has an answer here: its own, or one that is drawn, typeset or written as tables.
#[test]
fn every_question_is_answered() {
    for entry in entries() {
        assert!(entry.answer.is_some() || made::is_made(entry.command), "{}", entry.command);
    }
}

fn resolve(value: &Value, document: &Value, looked: &mut usize) {
    match value {
        Value::Object(fields) => {
            if let Some(path) = fields.get("$ref").and_then(Value::as_str) {
                let pointer = path.strip_prefix('#').unwrap_or_else(|| panic!("{path}"));
                assert!(document.pointer(pointer).is_some(), "{path}");
                *looked += 1;
            }
            fields.values().for_each(|value| resolve(value, document, looked));
        }
        Value::Array(items) => items.iter().for_each(|item| resolve(item, document, looked)),
        _ => {}
    }
}

/// A shell whose report is the request.
struct Asking;

impl Shell for Asking {
    fn files(&self) -> &dyn Files {
        &NoFiles
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn report(&self) -> Option<crate::WritesReport> {
        Some(|asked| Ok(format!("{:?}", asked.args).into_bytes()))
    }

    fn version(&self, bytes: &[u8]) -> String {
        bytes.len().to_string()
    }
}

#[test]
fn a_report_has_the_title_page_of_its_request() {
    let query =
        "lang=de&customer=Kunde%20AG&order=4711&change=B;2026-11-27;E;Hub&change=C;2026-11-28;Last&archive=1&full";
    let media = Some("application/toml");
    let (method, path, body) = (Method::Post, "/api/v1/report", PROJECT.as_bytes());
    let call = Call { method, path, query, media, body, language: Language::default() };
    let reply = crate::respond(&call, &Asking, &Progress::limited());
    let told = String::from_utf8(reply.body).unwrap();
    assert_eq!((reply.status, reply.media), (200, media::PDF), "{told}");
    for part in ["Kunde AG", "4711", "\"Hub\"", "\"Last\"", "archive: true", "full: true", "installation: false"] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let call = Call { query: "change=only%20a%20text", ..call };
    assert_eq!(crate::respond(&call, &Asking, &Progress::limited()).status, 422);
}

/// Every argument of the report but those that the page gives itself has a field in its menu.
#[test]
fn the_menu_has_a_field_for_every_argument_of_the_report() {
    let body = "text=format%20%3D%201";
    let media = Some("application/x-www-form-urlencoded");
    let (method, path, language) = (Method::Post, "/work", Language::default());
    let call = Call { method, path, query: "", media, body: body.as_bytes(), language };
    let reply = crate::respond(&call, &Asking, &Progress::limited());
    let html = String::from_utf8(reply.body).unwrap();
    for argument in questions::list::report::Args::ARGUMENTS {
        let is_given = ["axis", "code", "date"].contains(&argument.name);
        assert_eq!(html.contains(&format!("data-report=\"{}\"", argument.name)), !is_given, "{}", argument.name);
    }
}

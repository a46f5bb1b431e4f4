//! Requests: any request to the page or the interface gets a complete answer, and never a server error.

use crate::draft;
use crate::text::{any_edits, mutate};
use arbitrary::{Result, Unstructured};
use axis::{Catalogue, Files};
use page::{Call, FileEntry, Folder, Method, Reply, SaveFault, Shell, respond};
use quantities::Language;
use questions::Progress;
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io;
use std::sync::{Arc, LazyLock};
use std::time::Duration;
use testkit::html::whole;

/// A path of the page, and the names of its fields besides those of its state.
const PAGES: [(Method, &str, &[&str]); 17] = [
    (Method::Get, "/", &["new", "open", "kind"]),
    (Method::Post, "/", &["do"]),
    (Method::Get, "/begin", &["kind"]),
    (Method::Get, "/begin/drawing", &["begin", "motion[1].distance", "mechanism.screw.lead", "lang"]),
    (Method::Post, "/begin", &["kind", "value", "name"]),
    (Method::Post, "/work", &["do", "path", "value", "nominal", "pulled", "f_size", "f_voltage", "f_mass", "band"]),
    (Method::Post, "/tolerances", &["samples"]),
    (Method::Post, "/explain", &["check", "path"]),
    (Method::Post, "/compare", &["mark"]),
    (Method::Post, "/tools", &["tool", "about", "do", "code", "torque", "body", "file"]),
    (Method::Get, "/files", &["near"]),
    (Method::Get, "/watch", &["file", "known"]),
    (Method::Get, "/text", &["file"]),
    (Method::Post, "/example", &["kind", "name"]),
    (Method::Post, "/save", &["file", "known"]),
    (Method::Post, "/recording", &["name"]),
    (Method::Get, "/progress", &["work"]),
];

/// Names of the state of the page.
const STATE: [&str; 9] = ["lang", "theme", "axis", "code", "file", "from", "until", "known", "good"];

/// Values for fields, some with a meaning in one of them, some without any.
const WORDS: [&str; 44] = [
    "en",
    "de",
    "dark",
    "0",
    "1",
    "2",
    "-1",
    "1e999",
    "NaN",
    "10",
    "0.5",
    "table",
    "arm",
    "screw",
    "belt",
    "manual",
    "CHA-20A-100-H-C1024",
    "CHA-50A-100-H-M512P-B",
    "CHA-14A-30-N-D2048-EC",
    "CHA-25A-100-E",
    "CHA-*-100-*",
    "a.toml",
    "b.csv",
    "../a.toml",
    "/etc/passwd",
    "voltage",
    "copper_temperature",
    "life",
    "torsion",
    "record",
    "mount",
    "60 N m",
    "1.3 kg m^2",
    "24 V",
    "load.inertia",
    "motion[0].time",
    "motion[7]",
    "requirements.supply",
    "continuous",
    "json",
    "csv",
    MARK,
    "\u{202e}\u{0}",
    "",
];

/// Text that must never appear unescaped in a page.
const MARK: &str = "<b onload='x'>\"&";

/// A path of the interface: method, parameters, media types of its body.
struct Operation {
    method: Method,
    path: String,
    parameters: Vec<String>,
    media: Vec<String>,
}

/// The interface according to its own description.
static INTERFACE: LazyLock<Vec<Operation>> = LazyLock::new(|| {
    let reply = answered(&Asked { method: Method::Get, path: "/api/v1/openapi.json".to_owned(), ..Asked::default() });
    let described: Value = serde_json::from_slice(&reply.body).unwrap_or_default();
    let mut found = Vec::new();
    for (path, ways) in described.get("paths").and_then(Value::as_object).into_iter().flatten() {
        for (way, operation) in ways.as_object().into_iter().flatten() {
            let method = if way == "post" { Method::Post } else { Method::Get };
            let parameters = operation.get("parameters").and_then(Value::as_array).into_iter().flatten();
            let name = |each: &Value| each.get("name").and_then(Value::as_str).map(str::to_owned);
            let media = operation.pointer("/requestBody/content").and_then(Value::as_object).into_iter().flatten();
            found.push(Operation {
                method,
                path: path.clone(),
                parameters: parameters.filter_map(name).collect(),
                media: media.map(|(media, _)| media.clone()).collect(),
            });
        }
    }
    assert!(found.len() > 30, "the interface describes {} operations", found.len());
    found
});

/// A request with owned parts.
struct Asked {
    method: Method,
    path: String,
    query: String,
    media: Option<String>,
    body: Vec<u8>,
    language: Language,
}

impl Default for Asked {
    fn default() -> Self {
        Self {
            method: Method::Get,
            path: String::new(),
            query: String::new(),
            media: None,
            body: Vec::new(),
            language: Language::En,
        }
    }
}

/// Sends a request and checks the reply.
pub fn run(data: &[u8]) {
    let Ok(asked) = chosen(&mut Unstructured::new(data)) else { return };
    let reply = answered(&asked);
    let what = || format!("{} {}?{} -> {} {}", asked.method.id(), asked.path, asked.query, reply.status, reply.media);
    assert!((200..500).contains(&reply.status), "{}", what());
    if reply.media.contains("html") {
        let page = String::from_utf8_lossy(&reply.body);
        whole(&page);
        assert!(!page.contains(MARK), "{}: what was sent acts in the page", what());
    }
    if reply.media.contains("json") {
        let value: Value = serde_json::from_slice(&reply.body).unwrap_or_default();
        let errors = value.get("errors").and_then(Value::as_array).is_some_and(|errors| !errors.is_empty());
        assert!(value.is_object() || value.is_array(), "{}: no JSON", what());
        assert_eq!(reply.status >= 400, errors, "{}: errors without their status, or without being reported", what());
    } else if reply.status >= 400 {
        // The only information is whether a work exists.
        assert!(!reply.body.is_empty() || asked.path == "/progress", "{}", what());
    }
    for (name, value) in &reply.headers {
        assert!(!value.chars().any(char::is_control), "{}: {name}: {value:?}", what());
    }
}

/// Returns the request of a case.
pub fn shown(data: &[u8]) -> String {
    chosen(&mut Unstructured::new(data)).map_or_else(
        |_| String::new(),
        |asked| {
            let body = String::from_utf8_lossy(&asked.body);
            format!("{} {}?{}\n{:?}\n\n{body}", asked.method.id(), asked.path, asked.query, asked.media)
        },
    )
}

fn chosen(u: &mut Unstructured<'_>) -> Result<Asked> {
    let language = if u.ratio(1, 4)? { Language::De } else { Language::En };
    let mut asked = if u.ratio(1, 2)? { of_the_page(u)? } else { of_the_interface(u)? };
    asked.language = language;
    if u.ratio(1, 16)? {
        let edits = any_edits(u, 3)?;
        asked.path = mutate(&asked.path, &edits);
    }
    if u.ratio(1, 16)? {
        let edits = any_edits(u, 3)?;
        asked.query = mutate(&asked.query, &edits);
    }
    Ok(asked)
}

/// Generates a mostly valid project without tolerances: ten thousand samples take ten seconds, which is acceptable for
/// a user but not for a case.
fn project(u: &mut Unstructured<'_>) -> Result<String> {
    let edits = if u.ratio(1, 4)? { any_edits(u, 3)? } else { Vec::new() };
    let mut text = draft::project(u, false)?;
    while let Some(from) = text.find(" ± ") {
        let length = text.get(from..).and_then(|rest| rest.find('"')).unwrap_or(text.len() - from);
        text.replace_range(from..from + length, "");
    }
    Ok(mutate(&text, &edits))
}

fn word(u: &mut Unstructured<'_>) -> Result<&'static str> {
    u.choose(&WORDS).copied()
}

/// Encodes fields as sent by a form.
fn form(fields: &[(&str, &str)]) -> String {
    let mut text = String::new();
    for (name, value) in fields {
        let _ = write!(text, "{}{name}=", if text.is_empty() { "" } else { "&" });
        for byte in value.bytes() {
            let _ = write!(text, "%{byte:02x}");
        }
    }
    text
}

fn of_the_page(u: &mut Unstructured<'_>) -> Result<Asked> {
    let (method, path, own) = *u.choose(&PAGES)?;
    let mut fields = Vec::new();
    for _ in 0..u.int_in_range(0..=5)? {
        let name = if own.is_empty() || u.ratio(1, 2)? { *u.choose(&STATE)? } else { *u.choose(own)? };
        let mut value = word(u)?.to_owned();
        if name == "do" {
            let verb = *u.choose(&["value", "table", "gone", "up", "down", "twice", "none"])?;
            value = format!("{verb} {}={}", word(u)?, word(u)?);
        }
        fields.push((name, value));
    }
    if method == Method::Post || u.ratio(1, 2)? {
        fields.push(("text", project(u)?));
    }
    let fields: Vec<(&str, &str)> = fields.iter().map(|(name, value)| (*name, value.as_str())).collect();
    let (mut asked, fields) = (Asked { method, path: path.to_owned(), ..Asked::default() }, form(&fields));
    if path == "/recording" {
        asked.query = format!("name={}", word(u)?);
        asked.body = fields.into_bytes();
    } else if method == Method::Post {
        (asked.media, asked.body) = (Some("application/x-www-form-urlencoded".to_owned()), fields.into_bytes());
    } else {
        asked.query = fields;
    }
    Ok(asked)
}

fn of_the_interface(u: &mut Unstructured<'_>) -> Result<Asked> {
    let operation = u.choose(&INTERFACE)?;
    let mut fields = Vec::new();
    for _ in 0..u.int_in_range(0..=4)? {
        if !operation.parameters.is_empty() {
            fields.push((u.choose(&operation.parameters)?.as_str(), word(u)?));
        }
    }
    let mut path = operation.path.clone();
    while let (Some(from), Some(to)) = (path.find('{'), path.find('}')) {
        path.replace_range(from..=to.max(from), word(u)?);
    }
    let mut asked = Asked { method: operation.method, path, query: form(&fields), ..Asked::default() };
    if operation.method == Method::Post && !operation.media.is_empty() {
        let media = u.choose(&operation.media)?.clone();
        let text = project(u)?;
        asked.body = if media.contains("json") {
            let value = match u.int_in_range(0..=3)? {
                0 => serde_json::json!({ "project": text }),
                1 => serde_json::json!({ "old": text, "new": project(u)? }),
                2 => serde_json::json!({ "project": text, "code": word(u)?, "record": word(u)? }),
                _ => serde_json::json!([word(u)?, 1, null]),
            };
            value.to_string().into_bytes()
        } else {
            text.into_bytes()
        };
        asked.media = Some(if u.ratio(1, 8)? { word(u)?.to_owned() } else { media });
    }
    Ok(asked)
}

fn answered(asked: &Asked) -> Reply {
    let call = Call {
        method: asked.method,
        path: &asked.path,
        query: &asked.query,
        media: asked.media.as_deref(),
        body: &asked.body,
        language: asked.language,
    };
    let progress = Progress::limited();
    respond(&call, &Memory::new(), &progress)
}

/// A folder with two files, in memory.
struct Memory(RefCell<BTreeMap<String, Vec<u8>>>);

impl Memory {
    fn new() -> Self {
        let files = [("a.toml", "format = 1\n"), ("b.csv", "time_s,position_deg\n0,0\n1,5\n2,0\n")];
        Self(RefCell::new(files.map(|(name, text)| (name.to_owned(), text.as_bytes().to_vec())).into()))
    }
}

impl Folder for Memory {
    fn list(&self) -> io::Result<Vec<FileEntry>> {
        let named = |name: &&String| name.ends_with(".toml");
        let entry = |name: &String| FileEntry { name: name.clone(), modified_s: 0 };
        Ok(self.0.borrow().keys().filter(named).map(entry).collect())
    }

    fn read(&self, name: &str) -> io::Result<Vec<u8>> {
        self.0.borrow().get(name).cloned().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    fn save(&self, name: &str, text: &[u8], known: Option<&str>) -> std::result::Result<(), SaveFault> {
        if self.0.borrow().get(name).map(|bytes| self.version(bytes)).as_deref() != known {
            return Err(SaveFault::Changed);
        }
        drop(self.0.borrow_mut().insert(name.to_owned(), text.to_vec()));
        Ok(())
    }

    fn keep(&self, name: &str, bytes: &[u8]) -> std::result::Result<String, SaveFault> {
        drop(self.0.borrow_mut().insert(name.to_owned(), bytes.to_vec()));
        Ok(name.to_owned())
    }
}

impl Files for Memory {
    fn open(&self, name: &str) -> io::Result<Box<dyn io::Read>> {
        let bytes = self.0.borrow().get(name).cloned().ok_or(io::ErrorKind::NotFound)?;
        Ok(Box::new(io::Cursor::new(bytes)))
    }
}

impl Shell for Memory {
    fn files(&self) -> &dyn Files {
        self
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn time_limit(&self) -> Option<Duration> {
        Some(Duration::from_secs(3))
    }

    fn folder(&self) -> Option<&dyn Folder> {
        Some(self)
    }

    fn version(&self, bytes: &[u8]) -> String {
        bytes.len().to_string()
    }
}

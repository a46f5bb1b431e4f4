//! Comparison of the engine in the browser with the program: every word, and every number to twelve digits.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect};
use axis::{Catalogue, Files, NoFiles};
use page::{Call, FileEntry, Folder, Method, SaveFault, Shell, Storage, respond};
use quantities::Language;
use questions::Progress;
use questions::list::new::{example, template_kinds};
use serde_json::json;
use std::io::ErrorKind;
use std::sync::Arc;

/// Shell of an engine in a browser without stored data.
struct Empty;

impl Shell for Empty {
    fn files(&self) -> &dyn Files {
        &NoFiles
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn folder(&self) -> Option<&dyn Folder> {
        Some(self)
    }

    fn version(&self, _: &[u8]) -> String {
        String::new()
    }
}

impl Folder for Empty {
    fn place(&self) -> Storage {
        Storage::Browser
    }

    fn list(&self) -> std::io::Result<Vec<FileEntry>> {
        Ok(Vec::new())
    }

    fn read(&self, _: &str) -> std::io::Result<Vec<u8>> {
        Err(ErrorKind::NotFound.into())
    }

    fn save(&self, _: &str, _: &[u8], _: Option<&str>) -> Result<(), SaveFault> {
        Err(SaveFault::Name)
    }

    fn keep(&self, _: &str, _: &[u8]) -> Result<String, SaveFault> {
        Err(SaveFault::Name)
    }
}

/// Requests for the text of a project: the page, records, pictures, a table.
const ASKED: [(&str, &str); 9] = [
    ("/api/v1/size", ""),
    ("/api/v1/size", "top=300"),
    ("/api/v1/check", ""),
    ("/api/v1/explain", ""),
    ("/api/v1/bearing", ""),
    ("/api/v1/tolerance", "samples=200&seed=7"),
    ("/api/v1/plot", "figure=torque_speed"),
    ("/api/v1/plot", "figure=cycle"),
    ("/api/v1/export", "table=checks&format=csv"),
];

/// Requests without a project.
const ALONE: [&str; 8] = [
    "/?",
    "/api/v1/catalogue?format=csv",
    "/api/v1/errata?",
    "/api/v1/glossary?",
    "/api/v1/data?code=CHA-25A-50-H-C1024",
    "/api/v1/wiring?code=CHA-25A-50-H-C1024",
    "/api/v1/upkeep?code=CHA-25A-50-H-C1024&delivered=2026-03-01",
    "/nowhere?",
];

pub(crate) fn same_answers(stage: &OpenPage<'_>) -> Worded {
    stage.start("en")?;
    let mut asked = 0;
    for language in Language::ALL {
        let lang = language.id();
        let examples = template_kinds().filter(|kind| !matches!(*kind, "recording" | "joint"));
        for kind in examples {
            let text = example(kind, "axis.toml", language).map(|found| found.text).unwrap_or_default();
            same(stage, "/", &format!("new={kind}&lang={lang}"), None)?;
            for (path, query) in ASKED {
                same(stage, path, &format!("{query}&lang={lang}"), Some(&text))?;
                asked += 1;
            }
        }
        for question in ALONE {
            let (path, query) = question.split_once('?').unwrap_or((question, ""));
            same(stage, path, &format!("{query}&lang={lang}"), None)?;
            asked += 1;
        }
    }
    println!("       {asked} answers of the engine in the browser are those of the program");
    Ok(())
}

/// Sends a request to the engine and to the program, and compares the replies.
fn same(stage: &OpenPage<'_>, path: &str, query: &str, text: Option<&str>) -> Worded {
    let script = "const [path, query, text] = arguments_; \
        const reply = await fetch(path + '?' + query, text === null ? {} : { method: 'POST', headers: { 'content-type': 'application/toml' }, body: text }); \
        const bytes = new Uint8Array(await reply.arrayBuffer()); let packed = ''; \
        for (let at = 0; at < bytes.length; at += 8192) packed += String.fromCharCode(...bytes.subarray(at, at + 8192)); \
        return [reply.status, reply.headers.get('content-type'), packed];";
    let theirs = stage.tab.run(script, vec![json!(path), json!(query), json!(text)])?;
    let call = Call {
        method: if text.is_some() { Method::Post } else { Method::Get },
        path,
        query,
        media: text.map(|_| "application/toml"),
        body: text.unwrap_or_default().as_bytes(),
        language: Language::default(),
    };
    let ours = respond(&call, &Empty, &Progress::endless());
    let bytes: Vec<u8> = theirs[2]
        .as_str()
        .unwrap_or_default()
        .chars()
        .map(|sign| u8::try_from(u32::from(sign)).unwrap_or(b'?'))
        .collect();
    expect(theirs[0] == json!(ours.status) && theirs[1] == json!(ours.media), || {
        format!("{path}?{query}: {} {} instead of {} {}", theirs[0], theirs[1], ours.status, ours.media)
    })?;
    let (theirs, ours) = (String::from_utf8_lossy(&bytes), String::from_utf8_lossy(&ours.body));
    let (theirs, ours) = (without_digests(&theirs), without_digests(&ours));
    // A table of lines has its instants in a column, without a mark before them.
    let apart = match path {
        _ if query.contains("table=checks&format=csv") => INSTANTS_APART,
        "/api/v1/explain" => STEPS_APART,
        _ => APART,
    };
    match difference(&theirs, &ours, apart) {
        None => Ok(()),
        Some((theirs, ours)) => Err(format!("{path}?{query}: {theirs} | {ours}")),
    }
}

/// Returns the page without the digests of its parts, which change with the last digits of a number inside; their
/// content is compared itself.
fn without_digests(page: &str) -> String {
    const MARK: &str = "data-part=\"";
    let mut parts = page.split(MARK);
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |page, part| page + MARK + part.split_once('"').map_or(part, |(_, behind)| behind))
}

/// Relative tolerance for numbers: sine, root and power differ in the last digits between machines.
const APART: f64 = 1e-12;

/// Tolerance for instants at which a smooth value is largest \[s\]: near the maximum the value is flat, and its
/// rounding moves the instant by the square root of it, in a cycle of seconds.
const INSTANTS_APART: f64 = 1e-8;

/// Relative tolerance for the steps of a derivation: they hold at the instant of the largest value, and what is not itself
/// largest there changes with the rounding of that instant.
const STEPS_APART: f64 = 1e-9;

/// Marks before an instant, in an answer and in a page.
const BEFORE_INSTANTS: [&str; 2] = ["\"at\": ", "data-instant=\""];

/// Returns the first place where two texts differ by more than the last digits of a number, with its context.
fn difference<'t>(theirs: &'t str, ours: &'t str, apart: f64) -> Option<(&'t str, &'t str)> {
    let (mut a, mut b) = (theirs, ours);
    loop {
        let (first, second) = (number(a), number(b));
        let is_same = first == second || {
            let before = theirs.get(..theirs.len() - a.len()).unwrap_or_default();
            let is_instant = BEFORE_INSTANTS.iter().any(|words| before.ends_with(words));
            let apart = if is_instant { INSTANTS_APART } else { apart };
            let (first, second) = (first.parse::<f64>(), second.parse::<f64>());
            first.is_ok_and(|first| second.is_ok_and(|second| (first - second).abs() <= apart * first.abs().max(1.0)))
        };
        let (rest_a, rest_b) = (a.get(first.len()..)?, b.get(second.len()..)?);
        let (next_a, next_b) = (rest_a.chars().next(), rest_b.chars().next());
        if !is_same || next_a != next_b {
            let around = |text: &'t str| text.char_indices().nth(80).map_or(text, |(end, _)| &text[..end]);
            return Some((around(a), around(b)));
        }
        let step = next_a?.len_utf8();
        (a, b) = (rest_a.get(step..)?, rest_b.get(step..)?);
    }
}

/// Returns the number at the beginning of a text; empty if there is none.
fn number(text: &str) -> &str {
    if !text.starts_with(|sign: char| sign.is_ascii_digit()) {
        return "";
    }
    let is_part = |(at, sign): &(usize, char)| {
        let before = text[..*at].chars().next_back();
        sign.is_ascii_digit() || *sign == '.' || *sign == 'e' || (*sign == '-' && before == Some('e'))
    };
    let end = text.char_indices().find(|found| !is_part(found)).map_or(text.len(), |(at, _)| at);
    &text[..end]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn last_digits_may_differ_and_nothing_else() {
        assert_eq!(difference("a 9.74377580034956 b", "a 9.743775800349558 b", APART), None);
        assert_eq!(difference("1e-17 Nm", "0 Nm", APART), None);
        assert_eq!(difference("", "", APART), None);
        assert_eq!(difference("\"at\": 0.226600958278,", "\"at\": 0.226600958283,", APART), None);
        assert!(difference("\"at\": 0.2266009,", "\"at\": 0.2266008,", APART).is_some());
        assert!(difference("\"value\": 0.226600958278,", "\"value\": 0.226600958283,", APART).is_some());
        for (theirs, ours) in
            [("a 9.743 b", "a 9.744 b"), ("a 1 b", "a 1 c"), ("a", "ab"), ("x 1", "x 1.1"), ("1 a", "a 1")]
        {
            assert!(
                difference(theirs, ours, APART).is_some() && difference(ours, theirs, APART).is_some(),
                "{theirs} {ours}"
            );
        }
    }
}

//! Messages of the browser: a header as JSON, preceded by its length, and a body.

use crate::Store;
use page::{Call, IS_WHOLE, MISDIRECTED, Method, Reply, respond};
use quantities::Language;
use questions::Progress;
use serde::{Deserialize, Serialize};

/// A message of the browser.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Message {
    /// A request; the body follows the header.
    Ask(Question),
    /// A file stored in the browser; its bytes follow the header.
    Put { name: String, modified_s: u64 },
    /// A file no longer stored in the browser.
    Gone { name: String },
    /// A query for the bytes of a file.
    Take { name: String },
}

/// A request from the browser.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Question {
    post: bool,
    /// Decoded path.
    path: String,
    /// Query without the question mark.
    query: String,
    media: Option<String>,
    /// Language of the page.
    language: String,
    /// Seconds since 1970 by the clock of the browser.
    now_s: u64,
}

/// Header of an answer; the body follows it.
#[derive(Default, Serialize)]
struct Head<'a> {
    status: u16,
    media: &'a str,
    headers: &'a [(&'static str, String)],
    /// Name of the file written by the request, to be stored by the browser.
    kept: Option<String>,
}

/// Message handler with the files stored in the browser.
#[derive(Default)]
pub struct PageEngine {
    store: Store,
}

impl PageEngine {
    /// Answers a message. An invalid message gets the status 400 without a text, since only the script of the page
    /// sends messages.
    pub fn answer(&mut self, message: &[u8]) -> Vec<u8> {
        let Some((message, body)) = taken_apart(message) else {
            return put_together(&Head { status: 400, ..Head::default() }, &[]);
        };
        let done = || put_together(&Head { status: 204, ..Head::default() }, &[]);
        match message {
            Message::Ask(question) => {
                let reply = self.ask(&question, body);
                let kept = self.store.written();
                let head = Head { status: reply.status, media: reply.media, headers: &reply.headers, kept };
                put_together(&head, &reply.body)
            }
            Message::Put { name, modified_s } => {
                self.store.insert(&name, body, modified_s);
                done()
            }
            Message::Gone { name } => {
                self.store.remove(&name);
                done()
            }
            Message::Take { name } => match self.store.bytes(&name) {
                Some(bytes) => put_together(&Head { status: 200, ..Head::default() }, &bytes),
                None => put_together(&Head { status: 404, ..Head::default() }, &[]),
            },
        }
    }

    fn ask(&self, question: &Question, body: &[u8]) -> Reply {
        self.store.is_now(question.now_s);
        let call = Call {
            method: if question.post { Method::Post } else { Method::Get },
            path: &question.path,
            query: &question.query,
            media: question.media.as_deref(),
            body,
            language: Language::of_id(&question.language).unwrap_or_default(),
        };
        // The smaller engine reads no Parquet.
        if !IS_WHOLE && self.store.has_parquet() {
            return Reply::text(MISDIRECTED, "");
        }
        // A client that cancels stops the worker in which this runs.
        respond(&call, &self.store, &Progress::endless())
    }
}

fn taken_apart(bytes: &[u8]) -> Option<(Message, &[u8])> {
    let (length, rest) = bytes.split_first_chunk::<4>()?;
    let (head, body) = rest.split_at_checked(u32::from_le_bytes(*length) as usize)?;
    Some((serde_json::from_slice(head).ok()?, body))
}

fn put_together(head: &Head<'_>, body: &[u8]) -> Vec<u8> {
    let head = serde_json::to_vec(head).unwrap_or_default();
    let length = u32::try_from(head.len()).unwrap_or(0).to_le_bytes();
    [&length[..], &head, body].concat()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

    use super::*;
    use serde_json::{Value, json};

    fn message(head: &Value, body: &[u8]) -> Vec<u8> {
        let head = serde_json::to_vec(head).unwrap();
        [&u32::try_from(head.len()).unwrap().to_le_bytes()[..], &head, body].concat()
    }

    fn said(engine: &mut PageEngine, head: &Value, body: &[u8]) -> (Value, Vec<u8>) {
        let answer = engine.answer(&message(head, body));
        let (length, rest) = answer.split_first_chunk::<4>().unwrap();
        let (head, body) = rest.split_at(u32::from_le_bytes(*length) as usize);
        (serde_json::from_slice(head).unwrap(), body.to_vec())
    }

    fn ask(post: bool, path: &str, query: &str, media: Option<&str>) -> Value {
        json!({ "ask": { "post": post, "path": path, "query": query, "media": media, "language": "de", "now_s": 1_000 } })
    }

    const FORM: Option<&str> = Some("application/x-www-form-urlencoded");

    #[test]
    fn a_request_has_the_reply_of_the_page() {
        let mut engine = PageEngine::default();
        let (head, body) = said(&mut engine, &ask(false, "/", "", None), &[]);
        assert_eq!((head["status"].clone(), head["media"].clone()), (json!(200), json!("text/html; charset=utf-8")));
        assert!(String::from_utf8(body).unwrap().contains("Was möchten Sie bewegen?"));
        assert_eq!(said(&mut engine, &ask(true, "/nowhere", "", None), &[]).0["status"], 404);
    }

    /// The smaller engine has no reader of Parquet; the larger one has.
    #[test]
    fn a_recording_in_parquet_is_for_the_larger_engine() {
        let mut engine = PageEngine::default();
        let mut status = |put: Option<&[u8]>| {
            if let Some(bytes) = put {
                let head = json!({ "put": { "name": "run.parquet", "modified_s": 5 } });
                assert_eq!(said(&mut engine, &head, bytes).0["status"], 204);
            }
            said(&mut engine, &ask(false, "/", "", None), &[]).0["status"].clone()
        };
        assert_eq!(status(None), 200);
        assert_eq!(status(Some(b"t,q\n")), 200);
        assert_eq!(status(Some(b"PAR1\0\0\0\0PAR1")), if IS_WHOLE { 200 } else { MISDIRECTED });
        assert_eq!(status(Some(b"t,q\n")), 200);
    }

    #[test]
    fn what_is_saved_is_handed_back_to_be_kept_and_another_version_is_left() {
        let mut engine = PageEngine::default();
        let save = |known: &str, text: &str| format!("file=a.toml&text={text}&known={known}").into_bytes();
        let (head, _) = said(&mut engine, &ask(true, "/save", "", FORM), &save("", "format"));
        assert_eq!((head["status"].clone(), head["kept"].clone()), (json!(200), json!("a.toml")));
        let version = head["headers"][0][1].as_str().unwrap().to_owned();
        assert_eq!(said(&mut engine, &json!({ "take": { "name": "a.toml" } }), &[]).1, b"format");
        // Another tab has saved meanwhile.
        let _ = said(&mut engine, &json!({ "put": { "name": "a.toml", "modified_s": 5 } }), b"theirs");
        let (head, _) = said(&mut engine, &ask(true, "/save", "", FORM), &save(&format!("{version}+a.toml"), "mine"));
        assert_eq!((head["status"].clone(), head["kept"].clone()), (json!(409), json!(null)));
        assert_eq!(said(&mut engine, &json!({ "take": { "name": "a.toml" } }), &[]).1, b"theirs");
        let _ = said(&mut engine, &json!({ "gone": { "name": "a.toml" } }), &[]);
        assert_eq!(said(&mut engine, &json!({ "take": { "name": "a.toml" } }), &[]).0["status"], 404);
    }

    #[test]
    fn a_recording_that_is_brought_can_be_read_by_a_project() {
        let mut engine = PageEngine::default();
        let csv = "t in s;phi in deg\n0;0\n0.5;20\n1;0\n";
        let sent = format!("name=run.csv\n{csv}");
        let (head, _) = said(&mut engine, &ask(true, "/recording/preview", "", None), sent.as_bytes());
        assert_eq!((head["status"].clone(), head["kept"].clone()), (json!(200), json!(null)), "nothing is kept yet");
        let (head, body) = said(&mut engine, &ask(true, "/recording", "", None), sent.as_bytes());
        assert_eq!((head["status"].clone(), head["kept"].clone()), (json!(200), json!("run.csv")));
        let project = String::from_utf8(body).unwrap();
        assert_eq!(project, "format = 1\n\n[[motion]]\nlaw = \"recorded\"\nfile = \"run.csv\"\n");
        let (_, body) = said(&mut engine, &ask(true, "/api/v1/size", "", Some("application/toml")), project.as_bytes());
        let there = String::from_utf8(body).unwrap();
        let _ = said(&mut engine, &json!({ "gone": { "name": "run.csv" } }), &[]);
        let (_, body) = said(&mut engine, &ask(true, "/api/v1/size", "", Some("application/toml")), project.as_bytes());
        let gone = String::from_utf8(body).unwrap();
        assert!(gone.contains("run.csv") && gone != there, "{there}\n{gone}");
    }

    #[test]
    fn what_is_no_message_is_answered_too() {
        let mut engine = PageEngine::default();
        for bytes in [&b""[..], b"abc", &[255, 255, 255, 255, 1], &message(&json!({ "ask": 1 }), b"")] {
            let answer = engine.answer(bytes);
            assert!(String::from_utf8_lossy(&answer).contains("\"status\":400"));
        }
    }
}

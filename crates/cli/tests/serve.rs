//! `antrieb serve` as a user starts it: its first line, its answers, its end.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test fails loudly")]

mod run;

use run::{Started, root, run, run_with};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// A server that is started with arguments, and ended with the test.
struct Server {
    started: Started,
    address: String,
    token: String,
}

impl Server {
    fn new(arguments: &[&str]) -> Self {
        let started = Started::new(&[&["serve"], arguments].concat());
        let parts = started.line.strip_prefix("http://").and_then(|rest| rest.split_once("/?token="));
        let (address, token) = parts.unwrap_or_else(|| panic!("{:?}", started.line));
        let (address, token) = (address.to_owned(), token.to_owned());
        Self { started, address, token }
    }

    /// Head and body of an answer.
    fn ask(&self, line: &str, headers: &str, body: &[u8]) -> (String, Vec<u8>) {
        let mut stream = TcpStream::connect(&self.address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
        let (address, length) = (&self.address, body.len());
        let token = &self.token;
        let head = format!(
            "{line} HTTP/1.1\r\nhost: {address}\r\nauthorization: Bearer {token}\r\nconnection: close\r\ncontent-length: {length}\r\n"
        );
        stream.write_all(&[format!("{head}{headers}\r\n").as_bytes(), body].concat()).unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let end = answer.windows(4).position(|four| four == b"\r\n\r\n").unwrap();
        (String::from_utf8(answer[..end].to_vec()).unwrap(), answer[end + 4..].to_vec())
    }
}

#[test]
fn the_answers_of_a_server_are_those_of_the_commands() {
    let server = Server::new(&["examples", "--port", "0"]);
    assert!(server.address.starts_with("127.0.0.1:"), "{}", server.address);
    let (head, _) = server.ask("GET /health", "", b"");
    assert!(head.starts_with("HTTP/1.1 200 "), "{head}");
    for (name, query) in [("indexing-table", "top=3"), ("two-axes", "top=2&lang=de"), ("robot-joint", "top=1")] {
        let file = format!("examples/{name}.toml");
        let text = std::fs::read(root().join(&file)).unwrap();
        let line = format!("POST /api/v1/size?file={file}&{query}");
        // The interface ignores the language preference of the browser.
        let (head, body) = server.ask(&line, "content-type: application/toml\r\naccept-language: de\r\n", &text);
        let options: Vec<String> = query.split('&').map(|pair| format!("--{pair}")).collect();
        let mut arguments = vec!["size", &file, "--json"];
        arguments.extend(options.iter().map(String::as_str));
        assert_eq!(String::from_utf8(body).unwrap(), run(&arguments).out, "{head}");
        assert!(head.starts_with("HTTP/1.1 200 ") && head.contains("content-type: application/json"), "{head}");
    }
    let faulty = b"format = 1\n[load]\ninertia = \"1.3 kg\"\n";
    let (head, body) = server.ask("POST /api/v1/size", "", faulty);
    assert!(head.starts_with("HTTP/1.1 422 "), "{head}");
    assert_eq!(String::from_utf8(body).unwrap(), run_with(&["size", "-", "--json"], faulty).out);
}

#[cfg(unix)]
#[test]
fn a_server_ends_when_it_is_reported_to() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        let mut server = Server::new(&["--port", "0", "--lang", "de"]);
        let (head, _) = server.ask("GET /health", "", b"");
        assert!(head.starts_with("HTTP/1.1 200 "), "{head}");
        let said = server.started.ended_by(signal);
        assert_eq!(said, "Strg+C beendet es\n");
    }
}

#[test]
fn what_cannot_be_served_is_reported() {
    let taken = Server::new(&["--port", "0"]);
    let port = taken.address.rsplit(':').next().unwrap();
    for (arguments, word) in [
        (["serve", "--port", port].as_slice(), "taken by another program"),
        (&["serve", "examples/nowhere"], "cannot be worked in"),
        (&["serve", "examples/pins.csv"], "cannot be worked in"),
        (&["serve", "--listen", "here"], "is no address"),
        (&["serve", "--listen", "192.0.2.1", "--port", "0"], "cannot be listened on"),
        (&["serve", "--memory", "much"], "no amount of memory"),
        (&["serve", "--port", "70000"], "no value for"),
    ] {
        let found = run(&[arguments, &["--json"]].concat());
        assert!(found.code == 2 && found.out.contains(word), "{arguments:?}: {}{}", found.out, found.err);
        assert!(found.out.starts_with("{\n  \"errors\": ["), "{}", found.out);
    }
}

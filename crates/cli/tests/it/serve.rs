//! `antrieb serve` as a user starts it: its first line, its answers, its end.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test fails loudly")]

use crate::run;

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

/// A table beside the project, as the description of the interface has it: the answers are those that the command writes, and the
/// faults its faults.
#[test]
fn a_sweep_over_http_has_the_answers_of_the_command() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let project = std::fs::read(root().join("examples/two-axes.toml")).unwrap();
    std::fs::write(path("axis.toml"), &project).unwrap();
    let rows = "8,2\n-1,2\n900,2\n9,1\n8.5,0\n";
    std::fs::write(path("tasks.csv"), format!("mechanism.belt.mass [kg],motion[1].payload [kg]\n{rows}")).unwrap();
    let server = Server::new(&[&path(""), "--port", "0"]);
    let (_, described) = server.ask("GET /api/v1/openapi.json", "", b"");
    let described: serde_json::Value = serde_json::from_slice(&described).unwrap();
    let operation = &described["paths"]["/api/v1/sweep"]["post"];
    let names: Vec<&str> =
        operation["parameters"].as_array().unwrap().iter().filter_map(|each| each["name"].as_str()).collect();
    assert!(names.contains(&"table") && names.contains(&"axis"), "{operation}");
    assert!(operation["requestBody"]["content"]["application/toml"].is_object(), "{operation}");

    let ask = |table: &str| {
        let line = format!("POST /api/v1/sweep?file=axis.toml&table={table}&axis=lift");
        let (head, body) = server.ask(&line, "content-type: application/toml\r\n", &project);
        (head, serde_json::from_slice::<serde_json::Value>(&body).unwrap())
    };
    let command = |table: &str| {
        let (file, table, out) = (path("axis.toml"), path(table), path("best.csv"));
        run(&["sweep", &file, "--table", &table, "--axis", "lift", "--out", &out, "--force", "--json"])
    };
    let (head, answer) = ask("tasks.csv");
    assert!(head.starts_with("HTTP/1.1 200 "), "{head}: {answer}");
    let written = command("tasks.csv");
    let record: serde_json::Value = serde_json::from_str(&written.out).unwrap();
    for field in ["rows", "fitting", "none_fits", "not_judged", "further"] {
        assert_eq!(answer[field], record[field], "{field}");
    }
    assert_eq!((answer["rows"].as_u64(), answer["not_judged"][0]["rows"].as_u64()), (Some(5), Some(1)), "{answer}");
    let lines = std::fs::read_to_string(path("best.csv")).unwrap();
    let answers = answer["answers"].as_array().unwrap();
    assert_eq!(answers.len() + 1, lines.lines().count());
    for (found, line) in answers.iter().zip(lines.lines().skip(1)) {
        let (line, if_estimate) = line.rsplit_once(',').unwrap();
        assert_eq!(found["fit_if_estimate"].as_u64(), if_estimate.parse().ok(), "{line}");
        let cells: Vec<&str> = line.splitn(6, ',').collect();
        assert_eq!(found["row"].to_string(), cells[0], "{line}");
        assert_eq!(found["fit"].as_u64(), cells[1].parse().ok(), "{line}");
        assert_eq!(found["code"].as_str().unwrap_or_default(), cells[2], "{line}");
        let rounded = cells[3].parse::<f64>().ok().and_then(|share| format!("{share:.11e}").parse::<f64>().ok());
        assert_eq!(found["utilisation"].as_f64(), rounded, "{line}");
        assert_eq!(found["tightest"].as_str().unwrap_or_default(), cells[4], "{line}");
        let quoted = cells[5].strip_prefix('"').and_then(|cell| cell.strip_suffix('"'));
        let error = quoted.map_or(cells[5].to_owned(), |cell| cell.replace("\"\"", "\""));
        assert_eq!(found["error"].as_str().unwrap_or_default(), error, "{line}");
    }

    std::fs::write(path("wrong.csv"), "mechanism.belt.mas [kg],motion[1].payload [kg],code\n1,much,CHA-99\n1\n")
        .unwrap();
    let (head, faults) = ask("wrong.csv");
    assert!(head.starts_with("HTTP/1.1 422 "), "{head}");
    assert_eq!(faults["errors"].as_array().unwrap().len(), 4, "{faults}");
    let of_command = command("wrong.csv").out.replace(&path("wrong.csv"), "wrong.csv");
    assert_eq!(faults, serde_json::from_str::<serde_json::Value>(&of_command).unwrap());
}

#[cfg(unix)]
#[test]
fn a_server_ends_when_it_is_reported_to() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        let mut server = Server::new(&["--port", "0", "--lang", "de"]);
        let (head, _) = server.ask("GET /health", "", b"");
        assert!(head.starts_with("HTTP/1.1 200 "), "{head}");
        let said = server.started.ended_by(signal);
        assert_eq!(said, "Beenden mit Strg+C\n");
    }
}

#[test]
fn what_cannot_be_served_is_reported() {
    let taken = Server::new(&["--port", "0"]);
    let port = taken.address.rsplit(':').next().unwrap();
    for (arguments, word) in [
        (["serve", "--port", port].as_slice(), "in use by another program"),
        (&["serve", "examples/nowhere"], "cannot be used"),
        (&["serve", "examples/pins.csv"], "cannot be used"),
        (&["serve", "--listen", "here"], "is not a network address"),
        (&["serve", "--listen", "192.0.2.1", "--port", "0"], "cannot listen on"),
        (&["serve", "--memory", "much"], "not an amount of memory"),
        (&["serve", "--port", "70000"], "not a valid value for"),
    ] {
        let found = run(&[arguments, &["--json"]].concat());
        assert!(found.code == 2 && found.out.contains(word), "{arguments:?}: {}{}", found.out, found.err);
        assert!(found.out.starts_with("{\n  \"errors\": ["), "{}", found.out);
    }
}

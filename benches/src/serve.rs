//! A project sized over the loopback, on a connection that stays.
//!
//! Baseline: the same question put to the page without a server.
#![allow(clippy::expect_used, clippy::print_stdout, reason = "a bench fails loudly and tells what it found")]

use benches::{Gates, against, milliseconds, timed};
use page::{Call, Method, Shell};
use server::{Limits, Options, Server};
use std::hint::black_box;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::ExitCode;
use workbench::{Files, Language, NoFiles, Patience};

const PROJECT: &str = include_str!("../../examples/indexing-table.toml");
const ROUNDS: usize = 300;

struct Alone;

impl Shell for Alone {
    fn files(&self) -> &dyn Files {
        &NoFiles
    }
}

/// The answer without a server.
fn asked_directly() -> usize {
    let call = Call {
        method: Method::Post,
        path: "/api/v1/size",
        query: "",
        media: None,
        body: PROJECT.as_bytes(),
        language: Language::default(),
    };
    let reply = page::respond(&call, &Alone, &Patience::limited());
    assert_eq!(reply.status, 200, "no answer: nothing was measured");
    reply.body.len()
}

/// The answer over a connection that stays.
fn asked_over(connection: &mut BufReader<TcpStream>, address: SocketAddr) -> usize {
    let length = PROJECT.len();
    let request = format!("POST /api/v1/size HTTP/1.1\r\nhost: {address}\r\ncontent-length: {length}\r\n\r\n{PROJECT}");
    connection.get_mut().write_all(request.as_bytes()).expect("the server takes it");
    let (mut line, mut length) = (String::new(), 0);
    while line != "\r\n" {
        line.clear();
        connection.read_line(&mut line).expect("the server answers");
        if let Some(value) = line.strip_prefix("content-length:") {
            length = value.trim().parse().expect("a length");
        }
    }
    let mut body = vec![0; length];
    connection.read_exact(&mut body).expect("the whole answer");
    body.len()
}

fn main() -> ExitCode {
    let options = Options {
        folder: ".".into(),
        listen: None,
        port: 0,
        memory: 1 << 20,
        language: Language::default(),
        limits: Limits::default(),
    };
    let server = Server::bind(options).expect("a free port");
    let address = server.address();
    // It ends with the program.
    drop(std::thread::spawn(move || server.run_until(std::future::pending())));
    let stream = TcpStream::connect(address).expect("the server listens");
    stream.set_nodelay(true).expect("small pieces at once");
    let mut connection = BufReader::new(stream);
    assert_eq!(asked_over(&mut connection, address), asked_directly(), "another answer");
    let mut gates = Gates::default();
    let found =
        against(ROUNDS, || _ = black_box(asked_directly()), || _ = black_box(asked_over(&mut connection, address)));
    gates.at_most("size over the loopback", &found, ("without a server", 1.5));
    let mut times: Vec<_> =
        (0..ROUNDS).map(|_| timed(|| _ = black_box(asked_over(&mut connection, address)))).collect();
    times.sort();
    let within = |share: usize| times.get(ROUNDS * share / 100).copied().map_or(0.0, milliseconds);
    println!("  half within {:.3} ms, 99 of 100 within {:.3} ms", within(50), within(99));
    gates.close()
}

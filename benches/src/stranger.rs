//! The user of the page beside a stranger on the same machine who has no token: `GET /health` with the token while a hundred thousand
//! requests without it are turned away, while open files are sent, and while idle connections take every place.
//!
//! Baseline: the 50 ms that a stranger may cost the user. Other programs only add to a delay, so of three rounds the one with the
//! shortest longest delay counts.
#![allow(clippy::expect_used, clippy::print_stdout, reason = "a bench fails loudly and prints what it measured")]

use benches::{Gates, milliseconds, timed};
use quantities::Language;
use server::{Access, Options, RequestLimits, Server};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Longest delay that is promised, in milliseconds.
const DELAY_MOST_MS: f64 = 50.0;

/// Requests without the token in a round, sent by so many connections at the same time, so many in a row before their answers are read.
const REQUESTS: usize = 100_000;
const CONNECTIONS: usize = 4;
const TOGETHER: usize = 50;

/// Connections that send nothing: more than the server has places.
const IDLE: usize = 600;

const ROUNDS: usize = 3;

/// Files that are sent without the token: the largest script, and a page of the theory.
const OPEN: [&str; 2] = ["/assets/htmx.min.js", "/theory/moments.html"];

/// Requests of open files in a round: each is some 20 kB.
const FILES: usize = 10_000;

/// Sends requests without the token for a path and reads that each is answered with this status.
fn turned_away(address: SocketAddr, count: usize, (path, status): (&str, u16)) {
    let stream = TcpStream::connect(address).expect("the server listens");
    let mut answers = BufReader::new(stream.try_clone().expect("a handle"));
    let mut stream = stream;
    let request = format!("GET {path} HTTP/1.1\r\nhost: {address}\r\naccept-encoding: gzip\r\n\r\n").repeat(TOGETHER);
    for _ in 0..count / TOGETHER {
        stream.write_all(request.as_bytes()).expect("the server takes it");
        for _ in 0..TOGETHER {
            assert_eq!(answer(&mut answers), status);
        }
    }
}

/// Reads one answer; returns its status.
fn answer(connection: &mut BufReader<TcpStream>) -> u16 {
    let (mut line, mut length, mut status) = (String::new(), 0, None);
    while line != "\r\n" {
        line.clear();
        assert!(connection.read_line(&mut line).expect("the server answers") > 0, "the connection is closed");
        status = status.or_else(|| line.split(' ').nth(1)?.parse().ok());
        if let Some(value) = line.strip_prefix("content-length:") {
            length = value.trim().parse().expect("a length");
        }
    }
    let mut body = vec![0; length];
    connection.read_exact(&mut body).expect("the whole answer");
    status.expect("a status")
}

/// Time that the user waits for `/health` on a connection of its own.
fn health(address: SocketAddr, token: &str) -> Duration {
    timed(|| {
        let mut stream = TcpStream::connect(address).expect("the server listens");
        stream.set_nodelay(true).expect("small pieces at once");
        let request = format!("GET /health HTTP/1.1\r\nhost: {address}\r\nauthorization: Bearer {token}\r\n\r\n");
        stream.write_all(request.as_bytes()).expect("the server takes it");
        assert_eq!(answer(&mut BufReader::new(stream)), 200);
    })
}

/// Delays of the user, as long as something else goes on, sorted.
fn delays(address: SocketAddr, token: &str, beside: impl FnOnce() + Send) -> Vec<Duration> {
    let is_over = AtomicBool::new(false);
    let mut found = std::thread::scope(|scope| {
        let other = scope.spawn(|| {
            beside();
            is_over.store(true, Ordering::Relaxed);
        });
        let mut found = Vec::new();
        while !is_over.load(Ordering::Relaxed) {
            found.push(health(address, token));
            std::thread::sleep(Duration::from_millis(2));
        }
        other.join().expect("nothing fails beside it");
        found
    });
    found.sort();
    found
}

/// Prints the delays; returns the longest in milliseconds.
fn told(what: &str, found: &[Duration]) -> f64 {
    let within = |share: usize| found.get(found.len() * share / 100).copied().map_or(0.0, milliseconds);
    let most = found.last().copied().map_or(0.0, milliseconds);
    println!(
        "  {what}: {} times asked, half within {:.1} ms, 99 of 100 within {:.1} ms, longest {most:.1} ms",
        found.len(),
        within(50),
        within(99)
    );
    most
}

fn main() -> ExitCode {
    let options = Options {
        folder: ".".into(),
        listen: None,
        access: Access::WithToken,
        port: 0,
        memory: 1 << 20,
        language: Language::default(),
        limits: RequestLimits::default(),
        press: None,
    };
    let server = Server::bind(options).expect("a free port");
    let (address, url) = (server.address(), server.url());
    let (_, token) = url.split_once("/?token=").expect("an address with a token");
    // It ends with the program.
    drop(std::thread::spawn(move || server.run_until(std::future::pending())));
    let quiet = || std::thread::sleep(Duration::from_secs(1));
    let _ = told("alone", &delays(address, token, quiet));
    let flood = || {
        std::thread::scope(|scope| {
            for _ in 0..CONNECTIONS {
                let _ = scope.spawn(|| turned_away(address, REQUESTS / CONNECTIONS, ("/health", 401)));
            }
        });
    };
    let files = || {
        std::thread::scope(|scope| {
            for path in OPEN.iter().cycle().take(CONNECTIONS) {
                let _ = scope.spawn(|| turned_away(address, FILES / CONNECTIONS, (path, 200)));
            }
        });
    };
    let idle = || {
        let held: Vec<Option<TcpStream>> = (0..IDLE).map(|_| TcpStream::connect(address).ok()).collect();
        std::thread::sleep(Duration::from_secs(1));
        drop(held);
    };
    let least = |what: &str, beside: &(dyn Fn() + Sync)| {
        (0..ROUNDS).map(|_| told(what, &delays(address, token, beside))).fold(f64::INFINITY, f64::min)
    };
    let mut gates = Gates::default();
    for (what, beside) in [
        ("100 000 requests without the token", &flood as &(dyn Fn() + Sync)),
        ("10 000 requests for open files", &files),
        ("600 idle connections", &idle),
    ] {
        let most = least(what, beside);
        gates.share_at_most(&format!("longest delay of the user beside {what}"), most / DELAY_MOST_MS, ("50 ms", 1.0));
    }
    gates.close()
}

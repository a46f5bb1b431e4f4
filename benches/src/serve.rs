//! A project sized over the loopback, and the page after a keystroke, on a persistent connection.
//!
//! Baseline: the same question to the page without a server; for the page, the answer as a record. At the end many
//! clients at once.
#![allow(clippy::expect_used, clippy::print_stdout, reason = "a bench fails loudly and tells what it found")]

use axis::{Catalogue, Files, NoFiles};
use benches::{Gates, against, milliseconds, timed};
use page::{Call, FileEntry, Folder, Method, SaveFault, Shell};
use quantities::Language;
use questions::Progress;
use server::{Access, Options, RequestLimits, Server};
use std::hint::black_box;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

const PROJECT: &str = include_str!("../../examples/indexing-table.toml");
const ROUNDS: usize = 300;
const FORM: &str = "application/x-www-form-urlencoded";

struct Alone;

impl Shell for Alone {
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

/// An empty folder that stores nothing: the page shows the controls of a folder.
impl Folder for Alone {
    fn list(&self) -> std::io::Result<Vec<FileEntry>> {
        Ok(Vec::new())
    }

    fn read(&self, _: &str) -> std::io::Result<Vec<u8>> {
        Err(std::io::ErrorKind::NotFound.into())
    }

    fn save(&self, _: &str, _: &[u8], _: Option<&str>) -> Result<(), SaveFault> {
        Err(SaveFault::Name)
    }

    fn keep(&self, _: &str, _: &[u8]) -> Result<String, SaveFault> {
        Err(SaveFault::Name)
    }
}

/// A question: its path, the media type of its body, its body.
struct Question {
    path: &'static str,
    media: &'static str,
    body: String,
}

impl Question {
    /// Returns the question for the catalogue, with a record as the answer.
    fn size() -> Self {
        Self { path: "/api/v1/size", media: "application/toml", body: PROJECT.to_owned() }
    }

    /// Returns the question for the page after a change of the load.
    fn keystroke() -> Self {
        let text: String = PROJECT.bytes().map(|byte| format!("%{byte:02x}")).collect();
        let body = format!("text={text}&good={text}&path=load.inertia&value=1.31+kg+m%5E2");
        Self { path: "/work", media: FORM, body }
    }

    /// Returns the length of the answer without a server.
    fn asked_directly(&self) -> usize {
        let call = Call {
            method: Method::Post,
            path: self.path,
            query: "",
            media: Some(self.media),
            body: self.body.as_bytes(),
            language: Language::default(),
        };
        let reply = page::respond(&call, &Alone, &Progress::limited());
        assert_eq!(reply.status, 200, "no answer: nothing was measured");
        reply.body.len()
    }

    /// Returns the length of the answer over a persistent connection.
    fn asked_over(&self, connection: &mut BufReader<TcpStream>, address: SocketAddr) -> usize {
        let (status, length) = self.answered_over(connection, address);
        assert_eq!(status, 200, "no answer: nothing was measured");
        length
    }

    /// Returns status and length of the answer.
    fn answered_over(&self, connection: &mut BufReader<TcpStream>, address: SocketAddr) -> (u16, usize) {
        let Self { path, media, body } = self;
        let length = body.len();
        let request = format!(
            "POST {path} HTTP/1.1\r\nhost: {address}\r\ncontent-type: {media}\r\ncontent-length: {length}\r\n\r\n{body}"
        );
        connection.get_mut().write_all(request.as_bytes()).expect("the server takes it");
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
        (status.expect("a status"), body.len())
    }
}

/// Number of simultaneous clients.
const CLIENTS: usize = 200;
const CROWD: Duration = Duration::from_secs(30);

/// Permissible memory of the process above that of one client \[MB\]: a tenth of a megabyte for each, and the answers
/// being computed.
const CROWD_MEMORY_MB: f64 = 150.0;

/// Runs many clients, each with a persistent connection and a new question after each answer: no error, and bounded
/// memory. Clients and server share the process, so the memory is that of both.
fn crowd(question: &Question, address: SocketAddr) -> bool {
    let before = peak_memory_mb();
    let (answered, failed) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let begin = Instant::now();
    std::thread::scope(|scope| {
        for _ in 0..CLIENTS {
            scope.spawn(|| {
                let stream = TcpStream::connect(address).expect("the server listens");
                stream.set_nodelay(true).expect("small pieces at once");
                let mut connection = BufReader::new(stream);
                while begin.elapsed() < CROWD {
                    let (status, _) = question.answered_over(&mut connection, address);
                    let count = if status == 200 { &answered } else { &failed };
                    let _ = count.fetch_add(1, Ordering::Relaxed);
                }
            });
        }
    });
    let (answered, failed) = (answered.into_inner(), failed.into_inner());
    let seconds = begin.elapsed().as_secs_f64();
    #[allow(clippy::cast_precision_loss, reason = "a count of answers")]
    let rate = answered as f64 / seconds;
    let grown = peak_memory_mb().zip(before).map(|(after, before)| after - before);
    println!("{CLIENTS} clients for {seconds:.0} s: {answered} answers, {rate:.0} a second, {failed} errors");
    match grown {
        Some(grown) => println!("  {grown:.0} MB more at the most (at most {CROWD_MEMORY_MB:.0} MB)"),
        None => println!("  memory is known by Linux only"),
    }
    failed == 0 && answered > CLIENTS && grown.is_none_or(|grown| grown <= CROWD_MEMORY_MB)
}

/// Returns the peak memory of the process \[MB\].
fn peak_memory_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.split_whitespace().next()?.parse::<f64>().ok()? / 1000.0)
}

/// Prints the times within which half and 99 of 100 of several rounds are answered.
fn tell(mut ask: impl FnMut() -> usize) {
    let mut times: Vec<_> = (0..ROUNDS).map(|_| timed(|| _ = black_box(ask()))).collect();
    times.sort();
    let within = |share: usize| times.get(ROUNDS * share / 100).copied().map_or(0.0, milliseconds);
    println!("  half within {:.3} ms, 99 of 100 within {:.3} ms", within(50), within(99));
}

fn main() -> ExitCode {
    let options = Options {
        folder: ".".into(),
        listen: None,
        access: Access::Anyone,
        port: 0,
        memory: 1 << 20,
        language: Language::default(),
        limits: RequestLimits::default(),
        press: None,
    };
    let server = Server::bind(options).expect("a free port");
    let address = server.address();
    // The server ends with the program.
    drop(std::thread::spawn(move || server.run_until(std::future::pending())));
    let stream = TcpStream::connect(address).expect("the server listens");
    stream.set_nodelay(true).expect("small pieces at once");
    let mut connection = BufReader::new(stream);
    let (size, keystroke) = (Question::size(), Question::keystroke());
    for question in [&size, &keystroke] {
        assert_eq!(question.asked_over(&mut connection, address), question.asked_directly(), "another answer");
    }
    let mut gates = Gates::default();
    let found = against(
        ROUNDS,
        || _ = black_box(size.asked_directly()),
        || _ = black_box(size.asked_over(&mut connection, address)),
    );
    gates.at_most("size over the loopback", &found, ("without a server", 1.5));
    tell(|| size.asked_over(&mut connection, address));
    let found = against(
        ROUNDS,
        || _ = black_box(size.asked_directly()),
        || _ = black_box(keystroke.asked_over(&mut connection, address)),
    );
    gates.at_most("the page after a keystroke", &found, ("size as data", 12.0));
    println!("  {} kB of HTML", keystroke.asked_directly() / 1000);
    tell(|| keystroke.asked_over(&mut connection, address));
    let stands = crowd(&keystroke, address);
    let closed = gates.close();
    if stands { closed } else { ExitCode::FAILURE }
}

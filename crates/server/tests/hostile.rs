//! Hostile requests: the server stays up, answers others, and discloses nothing.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test fails loudly")]

use quantities::Language;
use server::{Access, Options, RequestLimits, Server};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::time::{Duration, Instant};
use tokio::sync::oneshot;

const PROJECT: &str = "format = 1\n[load]\ninertia = \"1.3 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"40 1/min\"\n\
    accelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n";

const RECORDED: &str = include_str!("../../../examples/robot-joint.toml");

/// A server in its own folder that lives as long as its test.
struct Up {
    address: SocketAddr,
    folder: tempfile::TempDir,
    end: Option<oneshot::Sender<()>>,
    thread: Option<std::thread::JoinHandle<()>>,
}

impl Up {
    fn new(limits: RequestLimits) -> Self {
        let outer = tempfile::tempdir().unwrap();
        let folder = outer.path().join("work");
        std::fs::create_dir(&folder).unwrap();
        let options = Options {
            folder,
            listen: None,
            access: Access::Anyone,
            port: 0,
            memory: 64 << 20,
            language: Language::default(),
            limits,
            press: None,
        };
        let server = Server::bind(options).unwrap();
        let address = server.address();
        let (end, ended) = oneshot::channel();
        let thread = std::thread::spawn(move || server.run_until(async { drop(ended.await) }).unwrap());
        Self { address, folder: outer, end: Some(end), thread: Some(thread) }
    }

    /// Returns the working folder.
    fn work(&self) -> std::path::PathBuf {
        self.folder.path().join("work")
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream.set_nodelay(true).unwrap();
        stream
    }

    /// Returns the reply to these bytes.
    fn raw(&self, bytes: &[u8]) -> String {
        let mut stream = self.connect();
        // A client that is rejected early need not read the whole reply.
        let _ = stream.write_all(bytes);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        String::from_utf8_lossy(&answer).into_owned()
    }

    fn ask(&self, line: &str, headers: &str, body: &[u8]) -> String {
        let head = format!("{line} HTTP/1.1\r\nhost: {}\r\nconnection: close\r\n{headers}", self.address);
        let head = if body.is_empty() {
            format!("{head}\r\n")
        } else {
            format!("{head}content-length: {}\r\n\r\n", body.len())
        };
        self.raw(&[head.as_bytes(), body].concat())
    }

    fn is_up(&self) {
        let answer = self.ask("GET /health", "", b"");
        assert_eq!(status(&answer), 200, "{answer}");
    }
}

impl Drop for Up {
    fn drop(&mut self) {
        drop(self.end.take());
        if let Some(thread) = self.thread.take() {
            thread.join().unwrap();
        }
    }
}

/// Returns the status; 0 if the connection was closed without one.
fn status(answer: &str) -> u16 {
    let mut words = answer.split(' ');
    if words.next() != Some("HTTP/1.1") && !answer.starts_with("HTTP/1.0") {
        return 0;
    }
    words.next().and_then(|status| status.parse().ok()).unwrap_or_else(|| panic!("{answer}"))
}

/// Requires a client error, or no answer.
fn turned_away(answer: &str, what: &str) {
    let status = status(answer);
    assert!(status == 0 || (400..500).contains(&status), "{what}: {answer}");
}

#[test]
fn no_path_leads_anywhere() {
    let up = Up::new(RequestLimits::default());
    std::fs::write(up.folder.path().join("secret.toml"), "the secret").unwrap();
    let long = format!("/{}", "a".repeat(20_000));
    for path in [
        "/../secret.toml",
        "/%2e%2e/secret.toml",
        "/..%2fsecret.toml",
        "/%2e%2e%5csecret.toml",
        "//etc/passwd",
        "/etc/passwd",
        "/api/v1/../../secret.toml",
        "/api/v1/size/../..",
        "/api/v1/%00",
        "/%ff%fe",
        "/\\..\\secret.toml",
        "/file:///etc/passwd",
        "/api/v1/new?kind=../../secret",
        "/api/v1/errata?about=../../../etc/passwd",
        "/api/v1/data?code=/dev/zero",
        &long,
        "*",
        "secret.toml",
        "/?file=../secret.toml",
    ] {
        let answer = up.ask(&format!("GET {path}"), "", b"");
        assert!(!answer.contains("the secret") && !answer.contains("root:"), "{path}: {answer}");
        assert!(status(&answer) < 500, "{path}: {answer}");
    }
    up.is_up();
}

#[test]
fn other_methods_are_named_and_not_answered() {
    let up = Up::new(RequestLimits::default());
    for method in ["PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "BREW", "PROPFIND", "get"] {
        let answer = up.ask(&format!("{method} /api/v1/size"), "", b"");
        assert_eq!(status(&answer), 405, "{method}: {answer}");
        assert!(answer.contains("allow: POST\r\n") && answer.contains("\"errors\""), "{method}: {answer}");
    }
    turned_away(
        &up.raw(format!("CONNECT evil.example:443 HTTP/1.1\r\nhost: {}\r\n\r\n", up.address).as_bytes()),
        "CONNECT",
    );
    let head = up.ask("HEAD /api/v1/code/list", "", b"");
    assert!(status(&head) == 200 && head.ends_with("\r\n\r\n"), "{head}");
    up.is_up();
}

#[test]
fn heads_that_are_none_are_turned_away() {
    let up = Up::new(RequestLimits::default());
    let host = up.address;
    let large = format!("GET / HTTP/1.1\r\nhost: {host}\r\nx: {}\r\n\r\n", "y".repeat(200_000));
    let many = format!("GET / HTTP/1.1\r\nhost: {host}\r\n{}\r\n", "a: b\r\n".repeat(5_000));
    let body = "transfer-encoding: chunked\r\ncontent-length: 4\r\n\r\n0\r\n\r\n";
    for bytes in [
        large.into_bytes(),
        many.into_bytes(),
        b"\0\0\0\0\r\n\r\n".to_vec(),
        b"GET / HTTP/9.9\r\n\r\n".to_vec(),
        b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03".repeat(40),
        format!("GET /\x07 HTTP/1.1\r\nhost: {host}\r\n\r\n").into_bytes(),
        format!("POST /api/v1/size HTTP/1.1\r\nhost: {host}\r\ncontent-length: 4\r\ncontent-length: 5\r\n\r\nabcde")
            .into_bytes(),
        format!("POST /api/v1/size HTTP/1.1\r\nhost: {host}\r\ncontent-length: -1\r\n\r\n").into_bytes(),
        format!("POST /api/v1/size HTTP/1.1\r\nhost: {host}\r\nconnection: close\r\n{body}").into_bytes(),
        format!("POST /api/v1/size HTTP/1.1\r\nhost: {host}\r\ntransfer-encoding: chunked\r\n\r\nZZ\r\n").into_bytes(),
        format!("GET / HTTP/1.1\r\nhost: {host}\r\nx: a\r\n\tb\r\n\r\n").into_bytes(),
        "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n".as_bytes().to_vec(),
    ] {
        turned_away(&up.raw(&bytes), &String::from_utf8_lossy(bytes.get(..60).unwrap_or(&bytes)));
    }
    up.is_up();
}

#[test]
fn another_host_and_another_site_get_nothing() {
    let up = Up::new(RequestLimits::default());
    for host in ["evil.example", "evil.example:80", "127.0.0.1.evil.example", "", "169.254.169.254"] {
        let answer = up.raw(format!("GET / HTTP/1.1\r\nhost: {host}\r\nconnection: close\r\n\r\n").as_bytes());
        assert!(matches!(status(&answer), 400 | 421), "{host}: {answer}");
    }
    assert_eq!(status(&up.raw(b"GET / HTTP/1.0\r\n\r\n")), 421);
    for header in ["origin: http://evil.example", "origin: null", "sec-fetch-site: cross-site"] {
        let answer = up.ask("POST /api/v1/size", &format!("{header}\r\n"), PROJECT.as_bytes());
        assert_eq!(status(&answer), 403, "{header}: {answer}");
        assert!(answer.contains("\"errors\""), "{answer}");
    }
    let own = format!("origin: http://{}\r\nsec-fetch-site: same-origin\r\n", up.address);
    let answer = up.ask("POST /api/v1/size?top=1", &own, PROJECT.as_bytes());
    assert_eq!(status(&answer), 200, "{answer}");
    let lower = answer.to_lowercase();
    for header in
        ["content-security-policy: default-src 'self'", "x-content-type-options: nosniff", "cache-control: no-store"]
    {
        assert!(lower.contains(header), "{header}: {answer}");
    }
    assert!(!lower.contains("access-control-allow"), "{answer}");
}

#[test]
fn bodies_that_are_too_large_are_not_read() {
    let up = Up::new(RequestLimits::default());
    let answer = up.ask("POST /api/v1/size", "", &vec![b' '; (1 << 20) + 1]);
    assert_eq!(status(&answer), 413, "{answer}");
    let head = format!("POST /api/v1/size HTTP/1.1\r\nhost: {}\r\ncontent-length: 99999999999\r\n\r\n", up.address);
    assert_eq!(status(&up.raw(head.as_bytes())), 413);
    let mut chunks =
        format!("POST /api/v1/size HTTP/1.1\r\nhost: {}\r\ntransfer-encoding: chunked\r\n\r\n", up.address)
            .into_bytes();
    for _ in 0..100 {
        chunks.extend(format!("{:x}\r\n", 1 << 16).bytes());
        chunks.extend(std::iter::repeat_n(b'#', 1 << 16));
        chunks.extend(b"\r\n");
    }
    assert!(matches!(status(&up.raw(&chunks)), 0 | 413));
    up.is_up();
}

/// Many idle clients do not block others, and are disconnected in time.
#[test]
fn slow_ones_keep_nobody_waiting() {
    let limits = RequestLimits {
        head_time: Duration::from_secs(4),
        body_time: Duration::from_secs(4),
        ..RequestLimits::default()
    };
    let up = Up::new(limits);
    let mut slow: Vec<TcpStream> = (0..200).map(|_| up.connect()).collect();
    for (index, stream) in slow.iter_mut().enumerate() {
        let head = format!("POST /api/v1/size HTTP/1.1\r\nhost: {}\r\n", up.address);
        // One half never ends its head, the other never its body.
        let rest = if index % 2 == 0 { "x: y" } else { "content-length: 500\r\n\r\nformat" };
        write!(stream, "{head}{rest}").unwrap();
    }
    let begun = Instant::now();
    up.is_up();
    assert!(begun.elapsed() < Duration::from_secs(3), "{:?}", begun.elapsed());
    for stream in &mut slow {
        let mut answer = String::new();
        let _ = stream.read_to_string(&mut answer);
        assert!(matches!(status(&answer), 0 | 408), "{answer}");
    }
    up.is_up();
}

/// More half-sent requests than there are connections: a new client takes the place of the one that has waited longest.
#[test]
fn half_sent_requests_hold_no_place() {
    let up = Up::new(RequestLimits { connections: 64, ..RequestLimits::default() });
    let head = format!("POST /api/v1/size HTTP/1.1\r\nhost: {}\r\n", up.address);
    let mut halves = Vec::new();
    for index in 0..200 {
        let mut stream = up.connect();
        let rest = ["x: y", "content-length: 500\r\n\r\nformat", ""][index % 3];
        // A place may be lost before the half is sent.
        let _ = write!(stream, "{head}{rest}");
        halves.push(stream);
    }
    // Well before the halves time out by themselves; a system that drops a first packet under load sends it again after a second.
    for _ in 0..3 {
        let begun = Instant::now();
        up.is_up();
        assert!(begun.elapsed() < RequestLimits::default().head_time / 2, "{:?}", begun.elapsed());
    }
}

/// Pseudo-random numbers, the same on every run.
struct Chance(u64);

impl Chance {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, most: usize) -> usize {
        usize::try_from(self.next()).unwrap() % most
    }
}

#[test]
fn bodies_of_any_bytes_are_answered_or_refused_what_is_wrong() {
    let up = Up::new(RequestLimits::default());
    let mut chance = Chance(22);
    let paths = [
        "size?samples=10",
        "check?code=CHA-20A-100-H-C1024",
        "explain?code=CHA-20A-100-H-C1024&check=thermal",
        "bearing",
        "moves",
        "diff",
        "plot?figure=cycle",
        "export?table=inputs",
        "wiring?code=CHA-20A-100-H-C1024",
        "commission?code=CHA-20A-100-H-C1024",
        "mount?code=CHA-20A-100-H-C1024",
    ];
    for round in 0..220 {
        let mut body = if round % 3 == 0 {
            let length = chance.below(3_000);
            (0..length).map(|_| chance.next().to_le_bytes()[0]).collect()
        } else {
            PROJECT.as_bytes().to_vec()
        };
        for _ in 0..chance.below(6) {
            let at = chance.below(body.len().max(1)).min(body.len().saturating_sub(1));
            match chance.below(3) {
                0 if !body.is_empty() => body[at] = chance.next().to_le_bytes()[0],
                1 if !body.is_empty() => drop(body.remove(at)),
                _ => body.insert(at, chance.next().to_le_bytes()[0]),
            }
        }
        let path = paths[chance.below(paths.len())];
        let answer = up.ask(&format!("POST /api/v1/{path}"), "", &body);
        assert!(
            matches!(status(&answer), 200 | 413 | 415 | 422),
            "{path}: {answer}\n{}",
            String::from_utf8_lossy(&body)
        );
    }
    up.is_up();
}

fn recorded_from(name: &str) -> String {
    RECORDED.replace("robot-joint.csv", name)
}

/// The recordings that a project names lie in the folder, whatever it says.
#[cfg(unix)]
#[test]
fn a_project_opens_nothing_outside_of_the_folder() {
    use std::os::unix::fs::symlink;
    let up = Up::new(RequestLimits::default());
    let csv = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/robot-joint.csv");
    let (inside, outside) = (up.work(), up.folder.path());
    std::fs::copy(&csv, inside.join("robot-joint.csv")).unwrap();
    std::fs::copy(&csv, outside.join("far.csv")).unwrap();
    symlink(outside.join("far.csv"), inside.join("link.csv")).unwrap();
    symlink(outside, inside.join("way")).unwrap();
    symlink("/dev/zero", inside.join("zero.csv")).unwrap();
    assert!(std::process::Command::new("mkfifo").arg(inside.join("pipe.csv")).status().unwrap().success());
    let moves = |name: &str| up.ask("POST /api/v1/moves", "", recorded_from(name).as_bytes());
    assert_eq!(status(&moves("robot-joint.csv")), 200);
    let far = outside.join("far.csv").display().to_string();
    // No recording, though the request has the token: the answer holds no word of the file.
    for name in [".env", ".env.csv", ".ssh/run.csv", "notes.md", "keys.pem", "id_rsa", "hidden.csv", "sub/.a/run.csv"] {
        let path = inside.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        if name == "hidden.csv" {
            symlink(inside.join(".env"), path).unwrap();
        } else {
            std::fs::write(path, "password,hunter2\nthe secret,42\n").unwrap();
        }
        let answer = moves(name);
        assert_eq!(status(&answer), 422, "{name}: {answer}");
        assert!(!answer.contains("hunter2") && !answer.contains("secret"), "{name}: {answer}");
    }
    for text in ["hunter2\n", "password hunter2\nthe secret 42\n", "user;secret\nme;hunter2\nyou;hunter2\n"] {
        std::fs::write(inside.join("notes.txt"), text).unwrap();
        let answer = moves("notes.txt");
        assert!(status(&answer) == 422 && answer.contains("notes.txt"), "{answer}");
        assert!(!answer.contains("hunter2") && !answer.contains("secret"), "{text}: {answer}");
    }
    for name in [
        "../far.csv",
        "link.csv",
        "way/far.csv",
        "zero.csv",
        "pipe.csv",
        "/dev/zero",
        "/dev/stdin",
        "/etc/passwd",
        &far,
        "none.csv",
        "way",
        ".",
        "robot-joint.csv/../../far.csv",
        "/proc/self/environ",
    ] {
        let begun = Instant::now();
        let answer = moves(name);
        assert_eq!(status(&answer), 422, "{name}: {answer}");
        assert!(begun.elapsed() < Duration::from_secs(10), "{name}");
    }
    up.is_up();
}

/// Returns the status of an answer on a persistent connection.
fn next_status(reader: &mut BufReader<TcpStream>) -> u16 {
    let (mut line, mut first, mut length) = (String::new(), String::new(), 0);
    loop {
        line.clear();
        assert!(reader.read_line(&mut line).unwrap() > 0, "closed after {first:?}");
        if first.is_empty() {
            first.clone_from(&line);
        }
        if let Some(value) = line.to_lowercase().strip_prefix("content-length:") {
            length = value.trim().parse().unwrap();
        }
        if line == "\r\n" {
            break;
        }
    }
    let mut body = vec![0; length];
    reader.read_exact(&mut body).unwrap();
    status(&first)
}

#[test]
fn ten_thousand_quick_requests_are_answered() {
    let up = Up::new(RequestLimits::default());
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                let mut reader = BufReader::new(up.connect());
                for round in 0..2_500 {
                    let path = if round % 2 == 0 {
                        "/health"
                    } else {
                        "/api/v1/torsion?code=CHA-20A-100-H-C1024&torque=60+N+m"
                    };
                    let request = format!("GET {path} HTTP/1.1\r\nhost: {}\r\n\r\n", up.address);
                    reader.get_mut().write_all(request.as_bytes()).unwrap();
                    assert_eq!(next_status(&mut reader), 200);
                }
            });
        }
    });
    up.is_up();
}

#[test]
fn two_hundred_clients_at_once_are_answered_or_refused_to_come_again() {
    let up = Up::new(RequestLimits::default());
    let answers: Vec<u16> = std::thread::scope(|scope| {
        let asked: Vec<_> =
            (0..200).map(|_| scope.spawn(|| status(&up.ask("POST /api/v1/moves", "", PROJECT.as_bytes())))).collect();
        asked.into_iter().map(|one| one.join().unwrap()).collect()
    });
    assert!(answers.iter().all(|status| matches!(status, 200 | 503)), "{answers:?}");
    assert!(answers.iter().filter(|status| **status == 200).count() >= 100, "{answers:?}");
    up.is_up();
}

/// A client that leaves while its project is worked on: the work ends, and its place is free for the next.
///
/// The limit is a share of the whole work, measured in the same run, since machines differ in speed.
#[test]
fn the_work_of_a_client_that_leaves_ends_soon() {
    /// Shares of the work after which the client leaves.
    const LEAVES: [f64; 3] = [0.05, 0.1, 0.2];
    /// Largest share of the work that may follow.
    const REST: f64 = 0.15;
    let segments = "[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"30 deg\"\ntime = \"0.3 s\"\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-30 deg\"\ntime = \"0.3 s\"\n";
    let text = format!("format = 1\n[load]\ninertia = \"0.3 kg m^2\"\n{}", segments.repeat(1500));
    let form: String = text.bytes().map(|byte| format!("%{byte:02x}")).collect();
    let body = format!("text={form}");
    let since = Instant::now();
    let used = || testkit::cost::processor_seconds(since);
    let computed_alone = || Up::new(RequestLimits { computed: 1, ..RequestLimits::default() });
    let sent = |up: &Up| {
        let mut stream = up.connect();
        let head = format!(
            "POST /work HTTP/1.1\r\nhost: {}\r\ncontent-type: application/x-www-form-urlencoded\r\ncontent-length: {}\r\nconnection: close\r\n\r\n",
            up.address,
            body.len()
        );
        stream.write_all(head.as_bytes()).unwrap();
        stream.write_all(body.as_bytes()).unwrap();
        stream
    };
    let whole = {
        let up = computed_alone();
        let begun = used();
        let mut answer = String::new();
        sent(&up).read_to_string(&mut answer).unwrap();
        assert_eq!(status(&answer), 200);
        used() - begun
    };
    for share in LEAVES {
        let up = computed_alone();
        let begun = used();
        let stream = sent(&up);
        while used() - begun < share * whole {
            std::thread::sleep(Duration::from_millis(5));
        }
        drop(stream);
        let left = used();
        // A short question is answered, and then nothing more is computed.
        assert!(up.ask("GET /api/v1/units", "", b"").contains("200 OK"));
        let (mut last, mut still) = (used(), Instant::now());
        while still.elapsed() < Duration::from_millis(500) {
            std::thread::sleep(Duration::from_millis(20));
            if used() > last + 0.015 {
                (last, still) = (used(), Instant::now());
            }
        }
        assert!(last - left < REST * whole, "{} s of {whole} s after the client had left at {share}", last - left);
    }
}

//! `antrieb drive` as a controller meets it: both protocols over TCP, what it refuses, its EDS. An outside client tries it in
//! `cargo xtask nightly canopen`.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test fails loudly")]

use crate::run;

use run::{Started, root, run};
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::{Duration, Instant};

const CODE: &str = "CHA-25A-100-H-M512P-B";

/// A drive that ends with the test.
struct Drive(Started);

impl Drive {
    fn new(arguments: &[&str]) -> Self {
        let started = Started::new(&[&["drive", CODE, "--port", "0"], arguments].concat());
        assert!(started.line.starts_with("127.0.0.1:"), "{}", started.line);
        Self(started)
    }

    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(&self.0.line).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream
    }
}

/// A client of the line protocol.
struct Lines(BufReader<TcpStream>);

impl Lines {
    fn ask(&mut self, line: &str) -> String {
        self.0.get_mut().write_all(format!("{line}\n").as_bytes()).unwrap();
        let mut answer = String::new();
        self.0.read_line(&mut answer).unwrap();
        answer.trim_end().to_owned()
    }

    fn number(&mut self, place: &str) -> i64 {
        let answer = self.ask(&format!("read {place}"));
        answer.strip_prefix("ok ").unwrap_or_else(|| panic!("{place}: {answer}")).parse().unwrap()
    }
}

/// Returns `true` if the other end has closed the connection.
fn is_closed(mut stream: TcpStream) -> bool {
    let mut rest = Vec::new();
    match stream.read_to_end(&mut rest) {
        Ok(_) => true,
        Err(error) => matches!(error.kind(), ErrorKind::ConnectionReset | ErrorKind::ConnectionAborted),
    }
}

/// The way of 402, a move of 10 degrees, and the same bits in a second drive.
#[test]
fn a_move_by_lines_is_the_same_in_every_run() {
    let moved = || {
        let drive = Drive::new(&["--time", "stepped", "--project", "examples/indexing-table.toml"]);
        let mut lines = Lines(BufReader::new(drive.connect()));
        assert_eq!(lines.number("6041"), 0x250);
        for (control, word) in [(0x06, 0x231), (0x07, 0x233), (0x0F, 0x237)] {
            assert_eq!(lines.ask(&format!("write 6040 {control}")), "ok");
            assert_eq!(lines.number("6041"), word);
        }
        for request in ["write 6060 1", "write 607A 364089", "step 200", "write 6040 0x1F"] {
            assert!(lines.ask(request).starts_with("ok"), "{request}");
        }
        let mut course = Vec::new();
        for _ in 0..60 {
            assert!(lines.ask("step 10").starts_with("ok"));
            course.push((lines.number("6062"), lines.number("6064")));
        }
        assert!(lines.ask("status").contains(" state=operation_enabled "));
        assert_eq!(lines.ask("bye"), "");
        course
    };
    let course = moved();
    let (demand, actual) = course[course.len() - 1];
    assert!(demand == 364_089 && (actual - demand).abs() < 1820, "{demand} {actual}");
    assert!(course.iter().all(|(demand, actual)| (demand - actual).abs() < 36_000), "{course:?}");
    assert_eq!(course, moved());
}

/// Requires that the clock moves the axis in real time while no client sends anything.
#[test]
fn real_time_goes_on_by_itself() {
    let drive = Drive::new(&[]);
    let mut lines = Lines(BufReader::new(drive.connect()));
    assert_eq!(lines.ask("step 1"), "error real_time");
    for request in ["write 6060 3", "write 60FF 1000000", "write 6040 6", "write 6040 15"] {
        assert_eq!(lines.ask(request), "ok", "{request}");
    }
    let (begin, mut last) = (Instant::now(), 0);
    while last < 200_000 {
        assert!(begin.elapsed() < Duration::from_secs(60), "it does not move");
        std::thread::sleep(Duration::from_millis(20));
        last = lines.number("6064");
    }
    assert!(lines.ask("time").ends_with(" real"));
}

/// Two clients on one bus: each hears the other and the drive.
#[test]
fn frames_reach_every_client_of_the_bus() {
    let drive = Drive::new(&["--protocol", "socketcand", "--time", "stepped", "--node", "7"]);
    let said = |stream: &mut TcpStream, text: &str| stream.write_all(text.as_bytes()).unwrap();
    let heard = |stream: &mut TcpStream| {
        let (mut message, mut byte) = (String::new(), [0]);
        while !message.ends_with('>') {
            stream.read_exact(&mut byte).unwrap();
            message.push(char::from(byte[0]));
        }
        message
    };
    let client = || {
        let mut stream = drive.connect();
        assert_eq!(heard(&mut stream), "< hi >");
        for request in ["< open vcan0 >", "< rawmode >"] {
            said(&mut stream, request);
            assert_eq!(heard(&mut stream), "< ok >");
        }
        stream
    };
    let (mut one, mut other) = (client(), client());
    // The boot-up message waits for no client; each request is answered to all.
    said(&mut one, "< send 607 8 40 41 60 0 0 0 0 0 >");
    let answer = |message: &str, id: &str, data: &str| {
        let words: Vec<&str> = message.split(' ').collect();
        assert_eq!((words[2], words[4]), (id, data), "{message}");
    };
    answer(&heard(&mut other), "607", "4041600000000000");
    for stream in [&mut one, &mut other] {
        let mut message = heard(stream);
        if message.contains(" 707 ") {
            message = heard(stream);
        }
        answer(&message, "587", "4B41600050020000");
    }
    said(&mut other, "< send 000 2 1 7 >");
    answer(&heard(&mut one), "000", "0107");
    answer(&heard(&mut one), "187", "5002");
    said(&mut other, "< send 207 2 6 0 >< send 080 0  >");
    answer(&heard(&mut one), "207", "0600");
    answer(&heard(&mut one), "080", "");
    answer(&heard(&mut one), "187", "3102");
    said(&mut one, "< echo >");
    assert_eq!(heard(&mut one), "< echo >");
}

/// A browser, a line without an end, a ninth client, noise: the connection ends, the drive goes on.
#[test]
fn what_is_no_client_is_turned_away() {
    let drive = Drive::new(&["--time", "stepped"]);
    for text in [
        "POST / HTTP/1.1\r\nHost: localhost\r\n\r\nwrite 6040 6\n".to_owned(),
        "x".repeat(5000),
        format!("read {}\n", "0".repeat(200)),
        "\u{0}\n".to_owned(),
        // A method of a browser that reads like a command.
        "write / HTTP/1.1\r\n\r\nwrite 6040 6\n".to_owned(),
    ] {
        let mut stream = drive.connect();
        let _ = stream.write_all(text.as_bytes());
        assert!(is_closed(stream), "{text:?}");
    }
    let mut stream = drive.connect();
    stream.write_all(b"\xff\xfe\n").unwrap();
    assert!(is_closed(stream));
    let mut clients: Vec<Lines> = (0..8).map(|_| Lines(BufReader::new(drive.connect()))).collect();
    for client in &mut clients {
        assert_eq!(client.ask("read 6041"), "ok 592", "no state was changed");
        assert_eq!(client.ask("hello"), "error command");
    }
    assert!(is_closed(drive.connect()));
    drop(clients.pop());
    // The place is free once the end is noticed.
    let begin = Instant::now();
    loop {
        let mut stream = drive.connect();
        let _ = stream.write_all(b"time\n");
        let mut answer = String::new();
        if BufReader::new(stream).read_line(&mut answer).is_ok() && answer.starts_with("ok ") {
            break;
        }
        assert!(begin.elapsed() < Duration::from_secs(20));
    }
    let noise = Drive::new(&["--protocol", "socketcand"]);
    for text in ["GET / HTTP/1.1\r\n\r\n", "< send 601 8 0 0 0 0 0 0 0 0 >", "< send 601 9 >", &"<".repeat(400)] {
        let mut stream = noise.connect();
        let _ = stream.write_all(text.as_bytes());
        assert!(is_closed(stream), "{text:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_drive_ends_in_good_order() {
    let mut drive = Drive::new(&["--lang", "de"]);
    // With the first answer it also watches for its end.
    assert!(Lines(BufReader::new(drive.connect())).ask("time").starts_with("ok "));
    let said = drive.0.ended_by("-TERM");
    assert!(
        said.starts_with("virtueller Servoregler unter 127.0.0.1:") && said.ends_with("Beenden mit Strg+C\n"),
        "{said}"
    );
}

/// A flood of one client, 500 steps of ten seconds or 5000 SYNC messages in one write, leaves the drive answering others and ending
/// within a second.
#[cfg(unix)]
#[test]
fn a_flood_keeps_no_one_waiting() {
    // The floods are 50 000 s and 12 750 s of the axis: minutes of work. Twice the second that is promised, for a slow machine.
    let soon = Duration::from_secs(2);
    let mut drive = Drive::new(&["--time", "stepped"]);
    let mut flood = drive.connect();
    flood.write_all(&b"step 10000\n".repeat(500)).unwrap();
    let mut other = Lines(BufReader::new(drive.connect()));
    let mut begin = Instant::now();
    for _ in 0..5 {
        assert!(other.ask("time").starts_with("ok "));
    }
    assert!(begin.elapsed() < soon, "{:?}", begin.elapsed());
    begin = Instant::now();
    drive.0.ended_by("-INT");
    assert!(begin.elapsed() < soon, "{:?}", begin.elapsed());

    let mut drive = Drive::new(&["--protocol", "socketcand", "--time", "stepped"]);
    let mut flood = drive.connect();
    flood.write_all(b"< open vcan0 >< rawmode >").unwrap();
    // Each SYNC message is 2.55 s of the axis: 60C2h sub 1 = 255, sub 2 = -2.
    flood.write_all(b"< send 601 8 2F C2 60 1 FF 0 0 0 >< send 601 8 2F C2 60 2 FE 0 0 0 >").unwrap();
    flood.write_all(&b"< send 080 0 >".repeat(5000)).unwrap();
    // Until the flood is at work.
    std::thread::sleep(Duration::from_millis(200));
    begin = Instant::now();
    drive.0.ended_by("-TERM");
    assert!(begin.elapsed() < soon, "{:?}", begin.elapsed());
}

/// Connections that say nothing, at once or one after the other, keep no client out, in either protocol; a client that has
/// made a request stays.
#[test]
fn silent_connections_keep_no_client_out() {
    for protocol in ["line", "socketcand"] {
        let drive = Drive::new(&["--time", "stepped", "--protocol", protocol]);
        let ask = |client: &mut TcpStream| {
            let (request, answer): (&[u8], &[u8]) = match protocol {
                "line" => (b"read 6041\n", b"ok 592\n"),
                _ => (b"< open vcan0 >< rawmode >", b"< ok >< ok >"),
            };
            client.write_all(request).unwrap();
            let mut said = vec![0; answer.len()];
            client.read_exact(&mut said).unwrap();
            assert_eq!(String::from_utf8_lossy(&said), String::from_utf8_lossy(answer), "{protocol}");
        };
        let connected = || {
            let mut client = drive.connect();
            if protocol == "socketcand" {
                client.read_exact(&mut [0; b"< hi >".len()]).unwrap();
            }
            client
        };
        let mut first = connected();
        ask(&mut first);
        let mut silent: Vec<TcpStream> = (0..200).map(|_| drive.connect()).collect();
        for _ in 0..5 {
            let mut client = connected();
            silent.extend((0..20).map(|_| drive.connect()));
            let begin = Instant::now();
            ask(&mut client);
            assert!(begin.elapsed() < Duration::from_secs(2), "{protocol}: {:?}", begin.elapsed());
        }
        if protocol == "line" {
            ask(&mut first);
        }
    }
}

/// Clients that have said one line and nothing more let another one in after a while, the longest idle one first; one that goes on asking
/// stays.
#[test]
fn an_idle_client_gives_its_place_to_another() {
    let drive = Drive::new(&["--time", "stepped"]);
    let mut clients: Vec<Lines> = (0..8).map(|_| Lines(BufReader::new(drive.connect()))).collect();
    for client in &mut clients {
        assert_eq!(client.ask("read 6041"), "ok 592");
    }
    assert!(is_closed(drive.connect()), "none is idle for long yet");
    std::thread::sleep(Duration::from_secs(6));
    // A line that is no request does not hold a place.
    assert!(clients[0].ask("speak up").starts_with("error"));
    std::thread::sleep(Duration::from_secs(5));
    for client in clients.iter_mut().skip(1) {
        assert_eq!(client.ask("read 6041"), "ok 592");
    }
    let mut ninth = Lines(BufReader::new(drive.connect()));
    assert_eq!(ninth.ask("read 6041"), "ok 592");
    let mut clients = clients.into_iter();
    assert!(is_closed(clients.next().unwrap().0.into_inner()), "the idle one is let go");
    for mut client in clients {
        assert_eq!(client.ask("read 6041"), "ok 592");
    }
}

#[test]
fn what_cannot_be_driven_is_reported() {
    let taken = Drive::new(&[]);
    let port = taken.0.line.rsplit(':').next().unwrap();
    for (arguments, word) in [
        (["drive", CODE, "--port", port].as_slice(), "in use by another program"),
        (&["drive", "CHA-25A-100-H-M512X"], "M512X"),
        (&["drive", CODE, "--node", "128"], "not a valid value for"),
        (&["drive", CODE, "--protocol", "modbus"], "not a valid value for"),
        (&["drive", CODE, "--inertia", "1 kg"], "moment of inertia"),
        (&["drive", CODE, "--project", "examples/nowhere.toml"], "nowhere.toml"),
        (&["drive", CODE, "--project", "examples/two-axes.toml"], "--axis"),
        (&["drive", CODE, "--project", "examples/robot-joint.toml"], "torque"),
    ] {
        let found = run(&[arguments, &["--json"]].concat());
        assert!(found.code == 2 && found.out.contains(word), "{arguments:?}: {}{}", found.out, found.err);
        assert!(found.out.contains("\"errors\": ["), "{}", found.out);
    }
}

/// The tables of both guides name every index that the drive has, and no other.
#[test]
fn the_guides_name_every_object() {
    let sheet = run(&["drive", CODE, "--eds"]).out;
    let mut indices: Vec<String> = sheet
        .lines()
        .filter_map(|line| line.strip_prefix('[')?.strip_suffix(']'))
        .filter(|section| section.len() == 4)
        .map(str::to_owned)
        .collect();
    indices.sort_unstable();
    for page in ["docs/guide/drive.md", "docs/anleitung/drive.md"] {
        let text = std::fs::read_to_string(root().join(page)).unwrap();
        let rows = text.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("` |"));
        let mut named: Vec<String> = Vec::new();
        for (place, _) in rows {
            let Some(place) = place.strip_suffix('h') else { continue };
            match place.split_once("h` to `").or_else(|| place.split_once("h` bis `")) {
                Some((from, to)) => {
                    let [from, to] = [from, to].map(|index| u16::from_str_radix(index, 16).unwrap());
                    named.extend((from..=to).map(|index| format!("{index:04X}")));
                }
                None => named.push(place.to_owned()),
            }
        }
        named.sort_unstable();
        assert_eq!(named, indices, "{page}");
    }
}

/// Every object has its section, the same in both languages but for the sentences.
#[test]
fn the_sheet_describes_every_object() {
    let sheet = run(&["drive", CODE, "--eds"]);
    assert_eq!((sheet.code, sheet.err.as_str()), (0, ""));
    for (section, lines) in [
        (
            "6041",
            "ParameterName=Statusword\nObjectType=0x7\nDataType=0x0006\nAccessType=ro\nDefaultValue=0\nPDOMapping=1\n",
        ),
        (
            "1400sub1",
            "ParameterName=COB-ID used by PDO\nObjectType=0x7\nDataType=0x0007\nAccessType=rw\nDefaultValue=$NODEID+0x200\nPDOMapping=0\n",
        ),
        (
            "605E",
            "ParameterName=Fault reaction option code\nObjectType=0x7\nDataType=0x0003\nAccessType=rw\nLowLimit=0\nHighLimit=2\nDefaultValue=2\nPDOMapping=0\n",
        ),
    ] {
        assert!(sheet.out.contains(&format!("\n[{section}]\n{lines}")), "{section}");
    }
    let other = run(&["drive", CODE, "--eds", "--node", "5"]);
    assert_eq!(other.out, sheet.out, "for any node");
}

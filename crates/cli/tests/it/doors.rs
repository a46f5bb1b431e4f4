//! Every way by which a file enters, with every kind of file that is none.
#![cfg(unix)]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Address space that a refusal may take, in KiB: a fraction of the files.
const SPACE_KIB: u32 = 400_000;

/// Processor time that a refusal may take unoptimised, in seconds.
const PROCESSOR_S: u32 = 10;

/// Ends a call that waits for a file after this time, by the clock.
const WAITING_MOST: Duration = Duration::from_secs(60);

fn recorded(file: &str) -> String {
    format!(
        "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = \"{file}\"\n"
    )
}

/// Returns the messages of a call that is refused, and does not wait.
fn refusal(folder: &Path, call: &[&str]) -> String {
    let script = format!("ulimit -v {SPACE_KIB}; ulimit -t {PROCESSOR_S}; exec \"$0\" \"$@\"");
    let mut child = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_antrieb")])
        .args(call)
        .current_dir(folder)
        .env("ANTRIEB_LANG", "en")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(fs::File::create(folder.join("talk")).unwrap())
        .spawn()
        .unwrap();
    let begun = Instant::now();
    let status = loop {
        match child.try_wait().unwrap() {
            Some(status) => break status,
            None if begun.elapsed() > WAITING_MOST => {
                child.kill().unwrap();
                panic!("{call:?} waits");
            }
            None => std::thread::sleep(Duration::from_millis(5)),
        }
    };
    let talk = String::from_utf8_lossy(&fs::read(folder.join("talk")).unwrap()).into_owned();
    assert_eq!(status.code(), Some(2), "{call:?}: {status}: {talk}");
    assert!(talk.len() < 20_000 && !talk.contains("memory"), "{call:?}: {talk}");
    talk
}

/// Whatever opens a file refuses what is no regular file with that reason and does not wait for it, and reads neither a line
/// without an end nor a file without one into the memory.
#[test]
fn no_door_waits_or_reads_without_an_end() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let axis = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\n\
                time = \"1 s\"\n";
    fs::write(here.join("axis.toml"), axis).unwrap();
    assert!(Command::new("mkfifo").arg(here.join("pipe")).status().unwrap().success());
    let _socket = std::os::unix::net::UnixListener::bind(here.join("socket")).unwrap();
    fs::create_dir(here.join("folder")).unwrap();
    fs::File::create(here.join("sparse")).unwrap().set_len(3 << 30).unwrap();
    fs::File::create(here.join("sparse.parquet")).unwrap().set_len(3 << 30).unwrap();
    fs::write(here.join("line"), vec![b'x'; 40 << 20]).unwrap();
    fs::write(here.join("words"), [&b"a;b\n"[..], &b"x;y\n".repeat(10 << 20)].concat()).unwrap();
    let none = "a pipe, a device or a socket";
    // A recording in place of a project.
    for name in ["sparse", "line", "words"] {
        fs::hard_link(here.join(name), here.join(format!("{name}.csv"))).unwrap();
    }
    let kinds = [
        ("pipe", none),
        ("socket", none),
        ("/dev/zero", none),
        ("folder", "this is a folder"),
        ("sparse", ""),
        ("sparse.parquet", ""),
        ("line", ""),
        ("words", ""),
        ("sparse.csv", ""),
        ("line.csv", ""),
        ("words.csv", ""),
    ];
    for (name, why) in kinds {
        fs::write(here.join("recorded.toml"), recorded(name)).unwrap();
        fs::write(here.join("stock.toml"), axis.replacen('[', &format!("[catalogue]\nfiles = [\"{name}\"]\n["), 1))
            .unwrap();
        let calls: [&[&str]; 14] = [
            &["size", name],
            &["size", "recorded.toml"],
            &["size", "stock.toml"],
            &["size", "axis.toml", "--catalogue", name],
            &["catalogue", "check", name],
            &["diff", "axis.toml", name],
            &["wiring", "CHA-25A-100-H-M512P", "--check", name],
            &["commission", "CHA-25A-100-H-M512P", "--record", name],
            &["identify", name, "axis.toml", "--code", "CHA-25A-100-H-M512P"],
            &["sweep", "axis.toml", "--table", name, "--out", "out.csv"],
            &["new", "recording", "--from", name],
            &["new", "belt", "--from", name],
            &["new", "joint", "--from", name, "--out", "new.toml"],
            &["moves", "recorded.toml"],
        ];
        for call in calls {
            let talk = refusal(here, call);
            assert!(talk.contains(why), "{call:?}: {talk}");
        }
        assert!(!here.join("out.csv").exists() && !here.join("new.toml").exists());
    }
    // A project file that the call does not name is no obstacle either.
    fs::rename(here.join("pipe"), here.join("pipe.toml")).unwrap();
    let _ = refusal(here, &["size", "of.toml"]);
    // The reason is that of a recording in a project.
    for call in [&["new", "recording", "--from", "line"][..], &["size", "line.csv"]] {
        assert!(refusal(here, call).contains("line 1: longer than 64 KiB"), "{call:?}");
    }
}

//! The files that are written: the same bytes from every process, and whole or not at all.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run;

use run::root;
use std::path::Path;
use std::process::{Command, Output};

const PROJECT: &str = "examples/tilting-arm.toml";

/// Every kind of file that the program writes, with the arguments before its name.
const FILES: [(&str, &[&str]); 5] = [
    ("cycle.svg", &["plot", PROJECT, "--figure", "cycle", "--svg"]),
    ("plane.png", &["plot", PROJECT, "--figure", "torque_speed", "--lang", "de", "--png"]),
    ("report.pdf", &["report", PROJECT, "--lang", "de", "--date", "2026-11-21", "--archive", "--out"]),
    ("result.xlsx", &["export", PROJECT, "--out"]),
    ("course.parquet", &["export", PROJECT, "--table", "course", "--out"]),
];

/// Writes one file into a folder in a process of its own.
fn write(folder: &Path, (name, arguments): (&str, &[&str]), threads: &str) -> Vec<u8> {
    let file = folder.join(name);
    let output = Command::new(env!("CARGO_BIN_EXE_antrieb"))
        .args(arguments)
        .arg(&file)
        .arg("--force")
        .env_remove("ANTRIEB_LANG")
        // The typesetting engine asks this how many threads it may use.
        .env("RAYON_NUM_THREADS", threads)
        .current_dir(root())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    std::fs::read(file).unwrap()
}

/// Hash maps are seeded anew in every process, so one process alone would not show their order.
#[test]
fn every_process_writes_the_same_bytes_with_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    for file in FILES {
        let [one, many] = ["1", "7"].map(|threads| blake3::hash(&write(folder.path(), file, threads)));
        assert_eq!(one, many, "{}", file.0);
    }
}

/// A disk that is full in the midst of a file, by a limit of its size: the old file stays, nothing else is left.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_file() {
    for (name, arguments) in FILES {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(name);
        std::fs::write(&file, "old").unwrap();
        // One block of 512 bytes; without the trap the signal would end the program.
        let script = "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"";
        let output: Output = Command::new("sh")
            .args(["-c", script, env!("CARGO_BIN_EXE_antrieb")])
            .args(arguments)
            .arg(&file)
            .args(["--force"])
            .current_dir(root())
            .output()
            .unwrap();
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{name}: {message}");
        assert!(message.contains(name) && !message.contains("panicked"), "{name}: {message}");
        assert_eq!(std::fs::read(&file).unwrap(), b"old", "{name}");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "{name}: something is left");
    }
}

//! The trace of `encoder --vcd` in the stock decoders of sigrok: SPI for words, Gray code for the tracks. What a receiver reads from
//! the levels is tested without sigrok in crates/feedback/tests/it/traces.rs.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::print_stderr, reason = "a test fails loudly")]

use crate::run;

use run::{run, shown};
use std::path::Path;
use std::process::Command;

/// Returns the output of a decoder for a trace; `None` without sigrok-cli, which CI has.
fn decoded(vcd: &Path, decoder: &str, annotation: &str) -> Option<Vec<String>> {
    let output =
        Command::new("sigrok-cli").args(["-I", "vcd", "-i"]).arg(vcd).args(["-P", decoder, "-A", annotation]).output();
    let Ok(output) = output else {
        assert!(std::env::var_os("CI").is_none(), "no sigrok-cli is here (Debian: apt-get install sigrok-cli)");
        eprintln!("no sigrok-cli is here: its decoders are not tried; Debian: apt-get install sigrok-cli");
        return None;
    };
    let text = String::from_utf8(output.stdout).unwrap();
    Some(text.lines().filter_map(|line| Some(line.split_once(": ")?.1.to_owned())).collect())
}

fn trace(folder: &Path, code: &str, further: &[&str]) -> std::path::PathBuf {
    let vcd = folder.join(format!("{code}.vcd"));
    let path = vcd.to_str().unwrap().to_owned();
    let mut arguments = vec!["encoder", code, "--angle", "12.5 deg", "--turn", "3", "--time", "20 ms", "--force"];
    arguments.extend(["--vcd", &path]);
    arguments.extend(further);
    let run = run(&arguments);
    assert_eq!(run.code, 0, "{}", run.err);
    vcd
}

/// Turn 3 and step 4551 of 131072 behind the clock period that latches; 20 ms at 3000 1/min are a turn of 512 edges. The decoder
/// prints a count when the next edge comes: the last edge is not printed.
#[test]
fn sigrok_reads_the_word_of_ssi_and_counts_the_edges() {
    let folder = tempfile::tempdir().unwrap();
    for (speed, last) in [("3000 1/min", "511"), ("-3000 1/min", "-511")] {
        let vcd = trace(folder.path(), "CHA-17A-100-H-M128S", &["--speed", speed]);
        let spi = "spi:clk=CLOCK:miso=DATA:cpol=0:cpha=1:wordsize=30";
        let Some(words) = decoded(&vcd, spi, "spi=miso-data") else { return };
        assert_eq!(words, [format!("{:X}", 1_u64 << 29 | 3 << 17 | 4551)]);
        let counts = decoded(&vcd, "graycode:d0=A:d1=B", "graycode=count").unwrap();
        assert_eq!(counts.last().map(String::as_str), Some(last));
    }
}

/// 2 periods, command 111000, low until the start bit, then 33 bits: position 3 · 8192 + 284, as the program prints the word.
#[test]
fn sigrok_reads_the_word_of_endat() {
    let folder = tempfile::tempdir().unwrap();
    for (set, size, command) in [("2.2", 48, 0b111_000_u64), ("2.1", 47, 0b000_111)] {
        let vcd = trace(folder.path(), "CHA-25A-100-H-M512P", &["--endat", set]);
        let spi = format!("spi:clk=CLOCK:miso=DATA:cpol=0:cpha=1:wordsize={size}");
        let Some(words) = decoded(&vcd, &spi, "spi=miso-data") else { return };
        let shown = shown(&["encoder", "CHA-25A-100-H-M512P", "--angle", "12.5 deg", "--turn", "3"]);
        let line = shown.lines().find(|line| line.starts_with(&format!("EnDat {set}"))).unwrap();
        let word = u64::from_str_radix(line.rsplit(' ').next().unwrap(), 2).unwrap();
        assert_eq!(words, [format!("{:X}", command << (size - 8) | word)], "{set}");
    }
}

/// Zero pulse and commutation beside the tracks: 8192 edges a turn, backwards.
#[test]
fn sigrok_counts_the_edges_of_a_square_wave() {
    let folder = tempfile::tempdir().unwrap();
    let vcd = trace(folder.path(), "CHA-14A-100-N-D2048", &["--speed", "-3000 1/min"]);
    let Some(counts) = decoded(&vcd, "graycode:d0=A:d1=B", "graycode=count") else { return };
    assert_eq!(counts.last().map(String::as_str), Some("-8191"));
}

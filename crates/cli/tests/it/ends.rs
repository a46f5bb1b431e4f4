//! A deadline and a signal end every command within a second, whatever it does at that moment.
#![cfg(unix)]
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a test fails loudly")]

use std::fmt::Write as _;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const CODE: &str = "CHA-25A-100-H-C1024";

/// An end is seen at most so much later: the machine may do other things besides.
const SLACK: Duration = Duration::from_secs(2);

/// A long recording under a load for which each interval is looked at closely, and a table of many tasks.
fn files(folder: &Path) {
    let rows: String = (0..=400_000_u32).fold(String::from("t [s],q [deg]\n"), |mut rows, k| {
        let t = f64::from(k) * 1e-3;
        let noise = f64::from(k.wrapping_mul(2_654_435_761) >> 20) * 1e-6;
        writeln!(rows, "{t:.3},{:.6}", 40.0 * (1.0 - (t * std::f64::consts::TAU / 4.0).cos()) + noise).unwrap();
        rows
    });
    std::fs::write(folder.join("run.csv"), rows).unwrap();
    let bar = "[mechanism.four_bar]\ncrank = \"60 mm\"\nground = \"200 mm\"\ncoupler = \"180 mm\"\nrocker = \"160 mm\"\n\
        coupler_mass = \"2 kg\"\nrocker_mass = \"2 kg\"\naxis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\n";
    let text = format!(
        "format = 1\n[axis]\nsingle_move = true\n{bar}efficiency = 0.9\n[[motion]]\nlaw = \"recorded\"\nfile = \"run.csv\"\n\
         smoothing = \"20 ms\"\n[bearing]\noverhang = \"60 mm\"\n"
    );
    std::fs::write(folder.join("axis.toml"), text).unwrap();
    let plain = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n";
    std::fs::write(folder.join("plain.toml"), plain).unwrap();
    let tasks = (0..200_000).fold(String::from("load.inertia [kg m^2]\n"), |mut tasks, k| {
        writeln!(tasks, "{}", 1.0 + 1e-6 * f64::from(k)).unwrap();
        tasks
    });
    std::fs::write(folder.join("tasks.csv"), tasks).unwrap();
    let head = String::from("time_s,position_rad,motor_speed_rad_s,torque_nm,current_q_a\n");
    let run = (0..400_000_u32).fold(head, |mut run, k| {
        let t = f64::from(k) * 1e-3;
        let (sine, cosine) = (t * std::f64::consts::TAU / 4.0).sin_cos();
        writeln!(
            run,
            "{t:.3},{:.6},{:.6},{:.5},{:.5}",
            0.7 * (1.0 - cosine),
            1.1 * sine,
            4.0 * cosine + sine.signum(),
            cosine
        )
        .unwrap();
        run
    });
    std::fs::write(folder.join("trace.csv"), run).unwrap();
}

/// One call of each command with long work.
const CALLS: [&[&str]; 14] = [
    &["size", "axis.toml"],
    &["check", "axis.toml", "--code", CODE],
    &["explain", "axis.toml", "--code", CODE],
    &["compare", "axis.toml", "--code", CODE, "--code", "CHA-32A-100-H-C1024"],
    &["diff", "axis.toml", "axis.toml", "--code", CODE],
    &["bearing", "axis.toml"],
    &["moves", "axis.toml"],
    &["plot", "axis.toml", "--figure", "cycle", "--code", CODE, "--svg", "out.svg"],
    &["export", "axis.toml", "--out", "out.xlsx"],
    &["export", "axis.toml", "--table", "course", "--out", "out.csv", "--memory", "4 GiB"],
    &["report", "axis.toml", "--out", "out.pdf"],
    &["simulate", "plain.toml", "--code", CODE, "--cycles", "2000", "--every", "4 ms", "--out", "out.csv"],
    &["identify", "trace.csv", "plain.toml", "--code", CODE],
    &["sweep", "plain.toml", "--table", "tasks.csv", "--out", "out.csv"],
];

fn start(folder: &Path, call: &[&str], deadline: &str) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
    command
        .args(call)
        .args(["--deadline", deadline])
        .current_dir(folder)
        .env_remove("CARGO")
        .env_remove("ANTRIEB_LANG");
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).stdin(Stdio::null()).spawn().unwrap()
}

/// No file that a call began to write outlives it. A sweep keeps its finished answers, from which it continues.
fn nothing_is_left(folder: &Path, call: &[&str]) {
    if call.first() == Some(&"sweep") {
        return;
    }
    let names = std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.file_name().into_string().unwrap());
    let left: Vec<String> = names.filter(|name| name.starts_with("out.") || name.starts_with(".antrieb")).collect();
    assert!(left.is_empty(), "{call:?}: {left:?}");
}

#[test]
fn a_deadline_ends_every_command() {
    let folder = tempfile::tempdir().unwrap();
    files(folder.path());
    for call in CALLS {
        for seconds in [0.4, 2.0] {
            let begun = Instant::now();
            let output = start(folder.path(), call, &format!("{seconds} s")).wait_with_output().unwrap();
            let late = begun.elapsed().saturating_sub(Duration::from_secs_f64(seconds));
            assert!(late < SLACK, "{call:?}: {late:?} late");
            let said = String::from_utf8(output.stderr).unwrap();
            if output.status.code() == Some(2) {
                assert!(said.contains(&format!("{seconds}")), "{call:?}: {said}");
                nothing_is_left(folder.path(), call);
            } else {
                // It was done before.
                for file in ["out.svg", "out.xlsx", "out.csv", "out.pdf"] {
                    let _ = std::fs::remove_file(folder.path().join(file));
                }
            }
        }
    }
}

#[test]
fn an_interrupt_ends_every_command() {
    let folder = tempfile::tempdir().unwrap();
    files(folder.path());
    for call in CALLS {
        let child = start(folder.path(), call, "600 s");
        std::thread::sleep(Duration::from_secs(2));
        let begun = Instant::now();
        let _ = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(begun.elapsed() < SLACK, "{call:?}: {:?}", begun.elapsed());
        let by_signal = output.status.signal() == Some(2) || output.status.code() == Some(130);
        assert!(by_signal || output.status.code().is_some_and(|code| code < 2), "{call:?}: {:?}", output.status);
        if by_signal {
            nothing_is_left(folder.path(), call);
        }
    }
}

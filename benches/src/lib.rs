//! What the benches share: a median that a noisy machine cannot move much, and gates.
#![allow(clippy::print_stdout, reason = "a bench prints what it measured")]

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// The top of the tree.
#[must_use]
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The release binary, built by the same cargo into the target folder that this bench runs from.
#[must_use]
pub fn binary() -> Option<PathBuf> {
    let bench = std::env::current_exe().ok()?;
    let release = bench.parent().and_then(Path::parent)?;
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--release", "--package", "antrieb", "--target-dir"])
        .arg(release.parent()?)
        .current_dir(root())
        .status();
    let binary = release.join(format!("antrieb{}", std::env::consts::EXE_SUFFIX));
    (built.is_ok_and(|status| status.success()) && binary.is_file()).then_some(binary)
}

/// What the NumPy baseline says for some options: seconds of one judgement of the catalogue, and how many fit.
/// `None` where there is no Python with NumPy.
#[must_use]
pub fn numpy(options: &[&str]) -> Option<(Duration, usize)> {
    let catalogue = Command::new(binary()?).args(["catalogue", "export", "--format", "json"]).output().ok()?;
    let mut python = Command::new("python3")
        .arg(root().join("benches/baseline/sizing_numpy.py"))
        .arg("-")
        .args(options)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    std::io::Write::write_all(&mut python.stdin.take()?, &catalogue.stdout).ok()?;
    let answer = python.wait_with_output().ok().filter(|answer| answer.status.success())?;
    let text = String::from_utf8(answer.stdout).ok()?;
    let figure = |name: &str| -> Option<f64> {
        let rest = text.split_once(&format!("\"{name}\": "))?.1;
        rest.split([',', '}']).next()?.trim().parse().ok()
    };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count")]
    Some((Duration::from_secs_f64(figure("seconds")?), figure("fit")? as usize))
}

/// How long one call takes.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// Shortest call of all.
    pub least: Duration,
    /// The smallest of five medians, so that a disturbance of one series does not count.
    pub median: Duration,
    /// Longest call of all.
    pub most: Duration,
}

/// Times a call in five series of `runs`.
pub fn measure(runs: usize, mut call: impl FnMut()) -> Times {
    let mut times = Times { least: Duration::MAX, median: Duration::MAX, most: Duration::ZERO };
    for _ in 0..5 {
        let mut series: Vec<Duration> = (0..runs.max(1))
            .map(|_| {
                let start = Instant::now();
                call();
                start.elapsed()
            })
            .collect();
        series.sort();
        let at = |index: usize| series.get(index).copied().unwrap_or_default();
        times.least = times.least.min(at(0));
        times.median = times.median.min(at(series.len() / 2));
        times.most = times.most.max(at(series.len() - 1));
    }
    times
}

/// Times a whole process of the binary in five series of `runs`.
///
/// # Panics
/// When it cannot be run or fails: then nothing was measured.
#[must_use]
pub fn process(binary: &Path, runs: usize, arguments: &[&str]) -> Times {
    measure(runs, || {
        let status = Command::new(binary)
            .args(arguments)
            .current_dir(root())
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .status();
        assert!(status.is_ok_and(|status| status.success()), "{arguments:?} failed");
    })
}

/// Milliseconds of a duration.
#[must_use]
pub const fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// A promise is for an idle machine: on a busy one a measurement may be so many times worse before the bench fails.
const ALLOWANCE: f64 = 2.0;

/// The gates of a bench: what was measured, what is promised. What misses its promise is told; what misses it by more than
/// that allowance fails.
#[derive(Debug, Default)]
pub struct Gates {
    missed: Vec<String>,
}

impl Gates {
    /// Prints a measurement against its promise and against a baseline of the same run.
    pub fn hold(&mut self, what: &str, measured: Times, promise: Duration, baseline: (&str, Times)) {
        let ratio = measured.median.as_secs_f64() / baseline.1.median.as_secs_f64().max(1e-12);
        let verdict = if measured.median <= promise { "kept" } else { "MISSED" };
        println!(
            "{what}: median {:.3} ms, promised {:.0} ms: {verdict}",
            milliseconds(measured.median),
            milliseconds(promise),
        );
        println!("  from {:.3} to {:.3} ms", milliseconds(measured.least), milliseconds(measured.most));
        println!("  {ratio:.2} × {} ({:.3} ms)", baseline.0, milliseconds(baseline.1.median));
        if measured.median.as_secs_f64() > ALLOWANCE * promise.as_secs_f64() {
            self.missed.push(what.to_owned());
        }
    }

    /// Prints how many times faster a measurement is than a baseline of the same run, against a promise.
    pub fn times_faster(&mut self, what: &str, measured: Times, baseline: Duration, promise: f64) {
        let ratio = baseline.as_secs_f64() / measured.median.as_secs_f64().max(1e-12);
        let verdict = if ratio >= promise { "kept" } else { "MISSED" };
        println!("{what}: {:.3} ms, {ratio:.1} × slower, promised {promise:.0}: {verdict}", milliseconds(baseline));
        if ratio * ALLOWANCE < promise {
            self.missed.push(what.to_owned());
        }
    }

    /// Prints a measurement as a multiple of a baseline of the same run, against a promise.
    pub fn at_most_times(&mut self, what: &str, measured: Times, baseline: Times, promise: f64) {
        let ratio = measured.median.as_secs_f64() / baseline.median.as_secs_f64().max(1e-12);
        let verdict = if ratio <= promise { "kept" } else { "MISSED" };
        println!("{what}: {ratio:.2} ×, promised at most {promise:.0}: {verdict}");
        if ratio > ALLOWANCE * promise {
            self.missed.push(what.to_owned());
        }
    }

    /// Success if every promise was kept.
    #[must_use]
    pub fn close(self) -> ExitCode {
        if self.missed.is_empty() {
            return ExitCode::SUCCESS;
        }
        println!("missed: {}", self.missed.join(", "));
        ExitCode::FAILURE
    }
}

//! What the benches share: a median that a noisy machine cannot move much, and gates.
#![allow(clippy::print_stdout, reason = "a bench prints what it measured")]

use std::process::ExitCode;
use std::time::{Duration, Instant};

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

/// Milliseconds of a duration.
#[must_use]
pub const fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// The gates of a bench: what was measured, what is promised.
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
        if measured.median > promise {
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

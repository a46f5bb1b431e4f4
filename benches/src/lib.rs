//! What the benches share: a median that a noisy machine cannot move much, and gates.
#![allow(clippy::print_stdout, reason = "a bench prints what it measured")]

use std::process::ExitCode;
use std::time::{Duration, Instant};

/// Median time of one call: the smallest of five medians, so that a disturbance of one series does not count.
pub fn median(runs: usize, mut call: impl FnMut()) -> Duration {
    (0..5)
        .map(|_| {
            let mut times: Vec<Duration> = (0..runs.max(1))
                .map(|_| {
                    let start = Instant::now();
                    call();
                    start.elapsed()
                })
                .collect();
            times.sort();
            times.get(times.len() / 2).copied().unwrap_or_default()
        })
        .min()
        .unwrap_or_default()
}

/// The gates of a bench: what was measured, what is promised.
#[derive(Debug, Default)]
pub struct Gates {
    missed: Vec<String>,
}

impl Gates {
    /// Prints a measurement against its promise and against a baseline of the same run.
    pub fn hold(&mut self, what: &str, measured: Duration, promise: Duration, baseline: (&str, Duration)) {
        let ratio = measured.as_secs_f64() / baseline.1.as_secs_f64().max(1e-12);
        let verdict = if measured <= promise { "kept" } else { "MISSED" };
        println!(
            "{what}: {:.3} ms, promised {:.0} ms: {verdict}; {ratio:.2} × {} ({:.3} ms)",
            measured.as_secs_f64() * 1e3,
            promise.as_secs_f64() * 1e3,
            baseline.0,
            baseline.1.as_secs_f64() * 1e3,
        );
        if measured > promise {
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

//! Tools of the benches: calls timed in turn with a baseline, and gates on their ratio. Times are reported, never
//! judged: a machine may be slow or shared.
#![allow(clippy::print_stdout, reason = "a bench prints what it measured")]

pub mod drawn;

use axis::AxisProject;
use questions::list::size::sized;
use questions::{Progress, Rejected, Sizing};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// Returns the root folder of the repository.
#[must_use]
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Judges the catalogue as the command does: the ten best with every check.
#[must_use]
pub fn size(project: &AxisProject) -> Sizing<'_> {
    sized(project, 10, Rejected::Nearest, &Progress::endless())
        .unwrap_or_else(|refusal| unreachable!("nothing cancels it: {refusal:?}"))
}

/// Returns the release binary, built by the running cargo into the target folder of this bench.
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

/// Runs the NumPy baseline with options; returns the time of one judgement of the catalogue, and the number of fitting
/// actuators. `None` without Python and NumPy.
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

/// Returns the time of `numpy.loadtxt`; `None` without Python and NumPy.
#[must_use]
pub fn loadtxt(file: &str) -> Option<Duration> {
    let script = "import sys, time, numpy\nt = time.perf_counter()\nnumpy.loadtxt(sys.argv[1], delimiter=',', skiprows=1)\nprint(time.perf_counter() - t)";
    let answer = Command::new("python3").args(["-c", script, file]).stderr(Stdio::null()).output().ok()?;
    let seconds = String::from_utf8(answer.stdout).ok()?.trim().parse().ok()?;
    Some(Duration::from_secs_f64(seconds))
}

/// Times of one call.
#[derive(Clone, Copy, Debug)]
pub struct Times {
    /// Shortest call.
    pub least: Duration,
    /// Median.
    pub median: Duration,
    /// Longest call.
    pub most: Duration,
}

impl Times {
    fn of(mut times: Vec<Duration>) -> Self {
        times.sort();
        let at = |index: usize| times.get(index).copied().unwrap_or_default();
        Self { least: at(0), median: at(times.len() / 2), most: at(times.len().saturating_sub(1)) }
    }
}

/// Times one call.
pub fn timed(call: impl FnOnce()) -> Duration {
    let start = Instant::now();
    call();
    start.elapsed()
}

/// Returns the processor time of this thread \[s\]; `None` if the system does not report it.
#[must_use]
pub fn processor_s() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split(' ').next()?.parse::<f64>().ok().map(|nanoseconds| nanoseconds * 1e-9)
}

/// Returns the processor time of one call \[s\], else its elapsed time: the least of `rounds` measurements, each of
/// `together` calls in a row, since the system counts in steps of some milliseconds.
pub fn least_processor_s(rounds: usize, together: u32, mut call: impl FnMut()) -> f64 {
    let least = (0..rounds.max(1)).fold(f64::INFINITY, |least, _| {
        let before = processor_s();
        let clock = timed(|| (0..together).for_each(|_| call())).as_secs_f64();
        least.min(before.zip(processor_s()).map_or(clock, |(before, after)| after - before))
    });
    least / f64::from(together.max(1))
}

/// Returns the seconds that a Python script of `benches/baseline` reports; `None` without Python and its packages.
#[must_use]
pub fn baseline_s(script: &str) -> Option<f64> {
    let script = root().join("benches/baseline").join(script);
    let answer = Command::new("python3").arg(script).output().ok().filter(|answer| answer.status.success())?;
    let text = String::from_utf8(answer.stdout).ok()?;
    let (_, rest) = text.split_once("\"seconds\": ")?;
    rest.split([',', '}']).next()?.trim().parse().ok()
}

/// A call and its baseline, timed in turn, so that a disturbance of the machine slows both.
#[derive(Clone, Copy, Debug)]
pub struct Against {
    /// The call.
    pub measured: Times,
    /// The baseline.
    pub baseline: Times,
    /// Median of the ratios of neighbouring runs.
    pub ratio: f64,
}

impl Against {
    /// Computes the statistics of pairs of times: the call, the baseline.
    #[must_use]
    pub fn of(pairs: &[(Duration, Duration)]) -> Self {
        let mut ratios: Vec<f64> =
            pairs.iter().map(|(call, baseline)| call.as_secs_f64() / baseline.as_secs_f64().max(1e-12)).collect();
        ratios.sort_by(f64::total_cmp);
        Self {
            measured: Times::of(pairs.iter().map(|(call, _)| *call).collect()),
            baseline: Times::of(pairs.iter().map(|(_, baseline)| *baseline).collect()),
            ratio: ratios.get(ratios.len() / 2).copied().unwrap_or(f64::INFINITY),
        }
    }
}

/// Times a call and its baseline in turn.
pub fn against(rounds: usize, mut baseline: impl FnMut(), mut call: impl FnMut()) -> Against {
    let pairs: Vec<_> = (0..rounds.max(1))
        .map(|_| {
            let before = timed(&mut baseline);
            (timed(&mut call), before)
        })
        .collect();
    Against::of(&pairs)
}

/// Sorts `count` numbers: work whose time scales with the speed of a machine, for comparison between machines.
pub fn sort(count: usize) {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut numbers: Vec<u64> = (0..count)
        .map(|_| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        })
        .collect();
    numbers.sort_unstable();
    std::hint::black_box(&numbers);
}

/// Runs the binary once and discards its output.
///
/// # Panics
/// If it cannot be run or fails, since nothing is measured then.
pub fn run(binary: &Path, arguments: &[&str]) {
    let status = Command::new(binary)
        .args(arguments)
        .current_dir(root())
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    assert!(status.is_ok_and(|status| status.success()), "{arguments:?} failed");
}

/// Converts a duration to milliseconds.
#[must_use]
pub const fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// Gates of a bench: measured ratios and their promises.
#[derive(Debug, Default)]
pub struct Gates {
    missed: Vec<String>,
}

impl Gates {
    /// Prints a measurement as a multiple of its baseline, against a promise.
    pub fn at_most(&mut self, what: &str, found: &Against, (baseline, promise): (&str, f64)) {
        let Times { least, median, most } = found.measured;
        let verdict = if found.ratio <= promise { "kept" } else { "MISSED" };
        println!("{what}: {:.2} × {baseline}, promised at most {promise}: {verdict}", found.ratio);
        println!(
            "  {:.3} ms, from {:.3} to {:.3} ms; {baseline}: {:.3} ms",
            milliseconds(median),
            milliseconds(least),
            milliseconds(most),
            milliseconds(found.baseline.median)
        );
        if found.ratio > promise {
            self.missed.push(what.to_owned());
        }
    }

    /// Prints a ratio independent of other processes, e.g. one of memory, against a promise.
    pub fn share_at_most(&mut self, what: &str, ratio: f64, (baseline, promise): (&str, f64)) {
        let verdict = if ratio <= promise { "kept" } else { "MISSED" };
        println!("{what}: {ratio:.2} × {baseline}, promised at most {promise}: {verdict}");
        if ratio > promise {
            self.missed.push(what.trim().to_owned());
        }
    }

    /// Prints by what factor a baseline timed in the same run is slower, against a promise.
    pub fn times_faster(&mut self, what: &str, measured: Times, baseline: Duration, promise: f64) {
        self.times_faster_s(what, measured.median.as_secs_f64(), baseline.as_secs_f64(), promise);
    }

    /// Prints by what factor a baseline is slower, from seconds, against a promise.
    pub fn times_faster_s(&mut self, what: &str, measured_s: f64, baseline_s: f64, promise: f64) {
        let ratio = baseline_s / measured_s.max(1e-12);
        let verdict = if ratio >= promise { "kept" } else { "MISSED" };
        println!("{what}: {:.3} ms, {ratio:.1} × slower, promised at least {promise}: {verdict}", 1e3 * baseline_s);
        if ratio < promise {
            self.missed.push(what.to_owned());
        }
    }

    /// Returns success if every promise was kept.
    #[must_use]
    pub fn close(self) -> ExitCode {
        if self.missed.is_empty() {
            return ExitCode::SUCCESS;
        }
        println!("missed: {}", self.missed.join(", "));
        ExitCode::FAILURE
    }
}

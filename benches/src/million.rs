//! The hard case of a recording: a million positions on a millisecond grid, rounded to 9 digits as a controller writes
//! them, of a load so light and slow that four fifths of the catalogue remain. The catalogue is judged on it, and the
//! reserves of the best actuator are searched. And the hardest known case: a joint whose recorded torque is white
//! noise, so that it changes its sign in every other interval and no bound over many intervals is tight.
//!
//! Baselines: reading the same file; for the whole process `numpy.loadtxt` of it.
#![allow(
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a bench fails loudly and prints what it measured"
)]

use axis::Files;
use benches::{Against, Gates, binary, loadtxt, run, size, timed};
use questions::{check, reserve_of};
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::sync::Arc;
use std::time::Duration;

const SAMPLES: usize = 1_000_000;

const PROJECT: &str = r#"
format = 1
[axis]
name = "slow sine"
[load]
inertia = "1 kg m^2"
friction_torque = "5 N m"
[[motion]]
law = "recorded"
file = "sine.csv"
units = { time = "s", position = "rad" }
[requirements]
supply = "560 V"
"#;

/// Returns ten swings of 1.5 rad in 1000 s.
fn recording() -> String {
    let last = (SAMPLES - 1) as f64;
    let mut text = String::from("time,position\n");
    for k in 0..SAMPLES {
        let position = 0.75 * (1.0 - (20.0 * PI * k as f64 / last).cos());
        writeln!(text, "{:.3},{position:.9}", k as f64 * 1e-3).expect("a string takes all");
    }
    text
}

const NOISE: &str = r#"
format = 1
[axis]
name = "white noise"
[mechanism.joint]
inertia = "1 kg m^2"
[[motion]]
law = "recorded"
file = "noise.csv"
units = { time = "s", position = "rad", torque = "Nm" }
"#;

/// Returns a slow swing under a torque of noise: the sum of twelve uniformly distributed numbers between −2 and 2 Nm.
fn noise() -> String {
    let mut text = String::from("time,position,torque\n");
    let mut state = 1_u64;
    let mut uniform = || {
        // Knuth's multiplier; the upper half of the bits is random enough.
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 32) as f64 / f64::from(u32::MAX)
    };
    for k in 0..SAMPLES {
        let position = 0.5 * (PI * k as f64 / 25_000.0).sin();
        let torque = 4.0 * (0..12).map(|_| uniform() - 0.5).sum::<f64>();
        writeln!(text, "{:.3},{position:.9},{torque:.6}", k as f64 * 1e-3).expect("a string takes all");
    }
    text
}

struct Given(Arc<String>);

impl Files for Given {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(Text(Arc::clone(&self.0), 0)))
    }
}

/// The recording, shared without a copy.
struct Text(Arc<String>, usize);

impl std::io::Read for Text {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let mut rest = self.0.as_bytes().get(self.1..).unwrap_or_default();
        let read = rest.read(buffer)?;
        self.1 += read;
        Ok(read)
    }
}

fn main() -> ExitCode {
    let mut gates = Gates::default();
    let text = Arc::new(recording());
    let files = Given(Arc::clone(&text));
    let read = || questions::read_all(PROJECT, &files).expect("the project is valid");
    // A new recording each time, since results of a recording are reused by later questions.
    let mut reserves = Vec::new();
    let sized: Vec<_> = (0..ROUNDS)
        .map(|_| {
            let mut projects = Vec::new();
            let reading = timed(|| projects = read());
            let project = projects.first().expect("one axis");
            let mut fitting = 0;
            let sizing = timed(|| {
                let sizing = size(project);
                fitting = sizing.candidates.iter().filter(|candidate| candidate.fits()).count();
                black_box(&sizing);
            });
            assert!(fitting > 200, "the hard case is one that most survive: {fitting}");
            (sizing, reading)
        })
        .collect();
    gates.at_most("size on a million positions", &Against::of(&sized), ("reading them", 5.0));
    let best = size(read().first().expect("one axis")).candidates.first().map(|best| best.id.clone());
    let Some(code) = best else { panic!("no code") };
    for _ in 0..ROUNDS {
        let mut projects = Vec::new();
        let reading = timed(|| projects = read());
        let project = projects.first().expect("one axis");
        let checking = timed(|| {
            let candidate = check(project, &code).expect("the code is in the catalogue");
            black_box(reserve_of(project, &candidate));
        });
        reserves.push((checking, reading));
    }
    gates.at_most("check of one code with its reserves", &Against::of(&reserves), ("reading them", 5.0));
    whole_process(&text, &mut gates);
    noisy(&mut gates);
    gates.close()
}

const ROUNDS: usize = 5;

/// Measures the catalogue on white noise.
fn noisy(gates: &mut Gates) {
    let files = Given(Arc::new(noise()));
    let mut found = Vec::new();
    for _ in 0..2 {
        let mut projects = Vec::new();
        let reading = timed(|| projects = questions::read_all(NOISE, &files).expect("the project is valid"));
        let project = projects.first().expect("one axis");
        let mut fitting = 0;
        let sizing = timed(|| fitting = size(project).candidates.iter().filter(|candidate| candidate.fits()).count());
        assert!(fitting > 200, "the hard case is one that most survive: {fitting}");
        found.push((sizing, reading));
    }
    gates.at_most("size on a million samples of white noise", &Against::of(&found), ("reading them", 30.0));
}

/// Measures the whole process against `numpy.loadtxt` of the same file, and its peak memory.
fn whole_process(text: &str, gates: &mut Gates) {
    let binary = binary().expect("the release binary is built");
    let folder = std::env::temp_dir().join(format!("antrieb-bench-{}", std::process::id()));
    let (project, file) = (folder.join("sine.toml"), folder.join("sine.csv"));
    std::fs::create_dir_all(&folder).expect("a folder for the recording");
    std::fs::write(&project, PROJECT).expect("the project is written");
    std::fs::write(&file, text).expect("the recording is written");
    let path = |path: &Path| path.to_str().expect("a folder with a name").to_owned();
    let (project, file) = (path(&project), path(&file));
    match loadtxt(&file) {
        Some(_) => {
            let pairs: Vec<_> = (0..ROUNDS)
                .filter_map(|_| Some((timed(|| run(&binary, &["size", &project])), loadtxt(&file)?)))
                .collect();
            gates.at_most("the whole process", &Against::of(&pairs), ("numpy.loadtxt of the same file", 3.0));
        }
        None => println!("  no Python with NumPy here: the ratio to numpy.loadtxt is not measured"),
    }
    match memory(&binary, &["size", &project]) {
        Some(bytes) => {
            let arrays = 3 * 8 * SAMPLES;
            let ratio = bytes as f64 / arrays as f64;
            println!("  memory: {} MB", bytes / 1_000_000);
            gates.share_at_most("  memory", ratio, ("the arrays of time, position and speed", 3.4));
        }
        None => println!("  this system does not tell how much memory a process held"),
    }
    let _ = std::fs::remove_dir_all(&folder);
}

/// Returns the peak memory of a process, if the system reports it while the process runs.
fn memory(binary: &Path, arguments: &[&str]) -> Option<usize> {
    let mut child = Command::new(binary).args(arguments).stdout(Stdio::null()).spawn().ok()?;
    let status = format!("/proc/{}/status", child.id());
    let mut most = None;
    while child.try_wait().ok()?.is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let kilobytes =
            text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
        most = kilobytes.map(|kilobytes: usize| kilobytes * 1024).max(most);
        std::thread::sleep(Duration::from_millis(1));
    }
    most
}

//! A recording of a million positions that most candidates survive: the catalogue judged on it, and the reserves of one
//! actuator searched.
//!
//! Baseline: `numpy.loadtxt` of the same samples from a file; without Python with NumPy the times stand alone.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use benches::{measure, milliseconds};
use std::fmt::Write;
use std::hint::black_box;
use std::io::Cursor;
use std::process::{Command, Stdio};
use workbench::{Files, Language, Project, reserve_of, size};

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

struct Only(String);

impl Files for Only {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(Cursor::new(self.0.clone())))
    }
}

/// Ten slow swings at 1 kHz, positions rounded to a nanoradian: their differences are noisy and take few values.
fn csv() -> String {
    let mut text = String::from("time,position\n");
    for k in 0..1_000_000_u32 {
        let t = f64::from(k) * 1e-3;
        let q = 0.75 * (1.0 - (std::f64::consts::TAU * t / 99.9999).cos());
        writeln!(text, "{t:.3},{q:.9}").expect("a text takes everything");
    }
    text
}

/// Seconds of `numpy.loadtxt`, the file on its standard input.
fn loadtxt(text: &str) -> Option<f64> {
    let script = "import io,sys,time,numpy;b=sys.stdin.read();s=time.perf_counter();\
                  numpy.loadtxt(io.StringIO(b),delimiter=',',skiprows=1);print(time.perf_counter()-s)";
    let mut python = Command::new("python3")
        .args(["-c", script])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .ok()?;
    std::io::Write::write_all(&mut python.stdin.take()?, text.as_bytes()).ok()?;
    String::from_utf8(python.wait_with_output().ok()?.stdout).ok()?.trim().parse().ok()
}

fn main() {
    let text = csv();
    let baseline = loadtxt(&text);
    let files = Only(text);
    let mut projects = Vec::new();
    let read =
        measure(1, || projects = Project::read_all(PROJECT, &files, Language::En).expect("the project is valid"));
    let project = projects.first().expect("one axis");
    let judged = measure(1, || _ = black_box(size(project)));
    let sizing = size(project);
    let fitting = sizing.candidates.iter().filter(|candidate| candidate.fits()).count();
    let answer = sizing.answer().expect("something fits");
    let reserves = measure(1, || _ = black_box(reserve_of(project, answer)));
    for (what, times) in [("read", read), ("judge the catalogue", judged), ("reserves of one", reserves)] {
        let ratio = baseline.map_or_else(String::new, |baseline| {
            format!(", {:.2} × numpy.loadtxt ({:.0} ms)", times.median.as_secs_f64() / baseline, baseline * 1e3)
        });
        println!("{what}: {:.1} ms{ratio}", milliseconds(times.median));
    }
    println!("  {fitting} actuators fit");
}

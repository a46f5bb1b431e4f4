//! The cost generator: it multiplies points of a table, moves, samples, tolerances, ratios and axes, and draws every
//! key of every mechanism at the extremes of its range ([`benches::drawn`]). Each product is given to commands that run
//! as a process. An answer keeps the promise of `docs/reference/limits.md`, some five seconds of one core and half a
//! gigabyte, or the work is refused before it begins. The prediction is printed next to the measurement. A promise or a
//! prediction that is exceeded by more than a factor of two fails.
//!
//! Baseline: sorting of numbers, which scales the seconds of another machine to ours.
#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::print_stdout,
    reason = "a bench fails loudly and prints what it measured"
)]

use axis::Files;
use benches::drawn::{Chance, RECORDING, drawn, repeated, toleranced};
use benches::{binary, sort, timed};
use mechanism::MechanismId;
use questions::Draw;
use questions::list::Cost;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

/// Promised limit of an answer: seconds of one core, and bytes; an answer other than a ranking or a check may take
/// twice as long.
const PROMISED: (f64, f64) = (5.0, 500e6);

/// Time to start a process and read its project \[s\].
const START_SECONDS: f64 = 0.5;

/// Permissible factor above a promise: processes that run in parallel share caches and memory.
const SLACK: f64 = 2.0;

/// Number of sorted numbers, and the time \[s\] for it on the machine of the promise.
const SORTED: (usize, f64) = (4_000_000, 0.16);

/// A project with the recording that it names, and the commands that are run on it.
struct Case {
    name: String,
    project: String,
    recording: Option<usize>,
    commands: Vec<&'static str>,
}

/// Returns the kind of cost that is predicted for a command.
fn cost(command: &str) -> Cost {
    let draw = Draw::default();
    match command {
        "size" => Cost::Ranking { complete: 10, draw },
        "check" => Cost::Check { draw },
        "report" => Cost::Report,
        "export" => Cost::Workbook,
        _ => Cost::Other,
    }
}

/// Returns the arguments of a command about a project.
fn arguments<'a>(command: &'a str, path: &'a str, out: &'a str) -> Vec<&'a str> {
    match command {
        "check" => vec![command, path, "--code", CODE],
        "diff" => vec![command, path, path],
        "simulate" => vec![command, path, "--code", CODE],
        "report" | "export" => vec![command, path, "--out", out, "--force"],
        _ => vec![command, path],
    }
}

impl Case {
    /// Returns the prediction for each of its commands \[s\], bytes; `None` if the project is refused on reading.
    fn predicted(&self) -> Option<Vec<(f64, f64)>> {
        let project = questions::read_all(&self.project, &Recorded(self.recording.map(recording))).ok()?;
        let project = project.first()?;
        // `diff` judges two projects, which this bench makes equal.
        let times = |command: &str| if command == "diff" { 2.0 } else { 1.0 };
        let predicted = |command: &&str| {
            let (seconds, bytes) = cost(command).predicted(project);
            (times(command) * seconds, bytes)
        };
        Some(self.commands.iter().map(predicted).collect())
    }
}

/// Recording of a case.
struct Recorded(Option<String>);

impl Files for Recorded {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        let text = self.0.clone().unwrap_or_else(|| RECORDING.1.to_owned());
        Ok(Box::new(std::io::Cursor::new(text.into_bytes())))
    }
}

/// Measured and predicted time and memory of a process.
struct Taken {
    seconds: f64,
    bytes: f64,
    code: i32,
    predicted: (f64, f64),
}

impl Taken {
    /// Returns the measured share of the prediction; zero for refused work.
    fn of_predicted(&self, slower: f64) -> f64 {
        let (seconds, bytes) = self.predicted;
        let time = self.seconds / slower / (seconds + START_SECONDS);
        if self.code == 2 { 0.0 } else { time.max(self.bytes / bytes) }
    }
}

const CODE: &str = "CHA-40A-50-H-C1024";
const SUPPLY: &str = "[requirements]\nsupply = \"560 V\"\n";

/// Returns a load whose inertia and torque are piecewise linear between `points` points of a revolution.
fn table(points: usize) -> String {
    let mut text = String::from("[mechanism.table]\nstart_angle = \"170 deg\"\npoints = [");
    for k in 0..=points {
        let angle = 360.0 * k as f64 / points as f64;
        let (inertia, torque) = (1.2 + 0.4 * (3.0 * angle).to_radians().sin(), 8.0 * (2.0 * angle).to_radians().cos());
        write!(text, "[\"{angle:.6} deg\", \"{inertia:.6} kg m^2\", \"{torque:.6} N m\"], ")
            .expect("a string takes all");
    }
    text + "]\n"
}

fn load(kind: &str, points: usize, tolerance: &str) -> String {
    match kind {
        "table" => table(points),
        "arm" => format!(
            "[mechanism.arm]\ninertia = \"1 kg m^2{tolerance}\"\nmass = \"6 kg\"\ncentre_distance = \"220 mm\"\n\
             axis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\nefficiency = 0.95\n"
        ),
        _ => format!("[load]\ninertia = \"1 kg m^2{tolerance}\"\nfriction_torque = \"5 N m\"\n"),
    }
}

/// Returns moves back and forth, each of another duration so that none repeats.
fn moves(count: usize) -> String {
    let one = |k: usize| {
        let distance = if k.is_multiple_of(2) { 150 } else { -150 };
        let time = 2.0 + 1e-3 * k as f64;
        format!("[[motion]]\nlaw = \"modified_sine\"\ndistance = \"{distance} deg\"\ntime = \"{time} s\"\n")
    };
    (0..count).map(one).collect()
}

const RECORDED: &str = "[[motion]]\nlaw = \"recorded\"\nfile = \"run.csv\"\nsmoothing = \"20 ms\"\n";

fn cases() -> Vec<Case> {
    let mut all = Vec::new();
    let mut add = |name: String, body: String, recording: Option<usize>| {
        let single = if recording.is_some() { "[axis]\nsingle_move = true\n" } else { "" };
        let project = format!("format = 1\n{single}{body}{SUPPLY}");
        all.push(Case { name, project, recording, commands: vec!["size", "check"] });
    };
    for points in [36, 360, 3600, 9900] {
        for count in [2, 20, 100, 1000] {
            add(format!("table of {points} points × {count} moves"), load("table", points, "") + &moves(count), None);
        }
        for samples in [10_000, 100_000, 1_000_000] {
            let body = load("table", points, "") + RECORDED;
            add(format!("table of {points} points × {samples} samples"), body, Some(samples));
        }
    }
    for kind in ["arm", "load"] {
        for count in [20, 200, 1000] {
            add(format!("{kind} × {count} moves"), load(kind, 0, "") + &moves(count), None);
            let toleranced = load(kind, 0, " ± 10 %") + &moves(count);
            add(format!("{kind} with a tolerance × {count} moves"), toleranced, None);
            if kind == "load" {
                let stage = "[stage]\nkind = \"gear\"\nratios = [1.5, 2, 3, 4]\nefficiency = 0.95\n";
                add(format!("{kind} × {count} moves × 4 ratios"), load(kind, 0, "") + stage + &moves(count), None);
            }
        }
        add(format!("{kind} × 1000000 samples"), load(kind, 0, "") + RECORDED, Some(1_000_000));
        add(format!("{kind} with a tolerance × 100000 samples"), load(kind, 0, " ± 10 %") + RECORDED, Some(100_000));
    }
    all
}

/// Number of projects of each mechanism.
const SEEDS: u64 = 3;

/// Commands of which one is run on each drawn project.
const OTHERS: [&str; 6] = ["report", "export", "diff", "simulate", "explain", "bearing"];

/// Returns every key of every mechanism at the extremes: alone, with many moves, with a tolerance and with the ratios
/// of a stage.
fn at_the_extremes(seeds: u64) -> Vec<Case> {
    const RATIOS: &str =
        "\n[stage]\nkind = \"belt\"\nratios = [0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 4, 5, 6]\n";
    let mut all = Vec::new();
    let mut chance = Chance::new(seeds);
    for id in MechanismId::ALL.iter().copied() {
        for seed in 0..seeds {
            let found = drawn(id, seed);
            let text = &found.text;
            let staged = (!text.contains("[stage]")).then(|| format!("{text}{RATIOS}"));
            let products = [
                ("", Some(text.clone())),
                (" × 300 times its moves", repeated(text, 300)),
                (" with a tolerance", toleranced(text)),
                (" × 16 ratios", staged),
            ];
            for (what, project) in products {
                let Some(project) = project else { continue };
                let other = OTHERS[chance.below(OTHERS.len())];
                let name = format!("{}{what}", found.name);
                all.push(Case { name, project, recording: None, commands: vec!["size", "check", other] });
            }
        }
    }
    all
}

/// Returns swings of 150° with the noise of an encoder.
fn recording(samples: usize) -> String {
    let mut text = String::from("t [s],q [deg]\n");
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for k in 0..samples {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let noise = 0.01 * ((state >> 33) as f64 / f64::from(u32::MAX >> 1) - 0.5);
        let time = k as f64 * 1e-3;
        let last = (samples - 1) as f64 * 1e-3;
        let turns = (last / 7.0).round().max(1.0);
        let angle = 75.0 * (1.0 - (std::f64::consts::TAU * turns * time / last).cos()) + noise;
        writeln!(text, "{time:.3},{angle:.6}").expect("a string takes all");
    }
    text
}

/// Runs a process and measures its time on all cores and its peak memory, as the system reports them while it runs.
fn taken(binary: &Path, arguments: &[&str], predicted: (f64, f64)) -> Option<Taken> {
    let began = Instant::now();
    let mut child = Command::new(binary).args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().ok()?;
    let at = |name: &str| format!("/proc/{}/{name}", child.id());
    let (status, stat) = (at("status"), at("stat"));
    let (mut bytes, mut ticks) = (0.0_f64, 0.0_f64);
    let code = loop {
        if let Some(status) = child.try_wait().ok()? {
            break status.code().unwrap_or(-1);
        }
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let held = text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
        bytes = held.map_or(bytes, |kilobytes: f64| bytes.max(kilobytes * 1024.0));
        let text = std::fs::read_to_string(&stat).unwrap_or_default();
        let fields =
            text.rsplit_once(')').map(|(_, rest)| rest.split_whitespace().collect::<Vec<_>>()).unwrap_or_default();
        let of = |place: usize| fields.get(place).and_then(|field| field.parse::<f64>().ok()).unwrap_or(0.0);
        ticks = ticks.max(of(11) + of(12));
        // A process that far exceeds its promise is ended.
        if began.elapsed() > Duration::from_secs(120) {
            let _ = child.kill();
            let _ = child.wait();
            break -1;
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    Some(Taken { seconds: ticks / 100.0, bytes, code, predicted })
}

/// Returns the larger share of the promised time and memory.
fn share(taken: &Taken, slower: f64) -> f64 {
    (taken.seconds / slower / PROMISED.0).max(taken.bytes / PROMISED.1)
}

/// Returns `true` if a promise or a prediction is exceeded, or the process broke down.
fn exceeds(taken: &Taken, slower: f64) -> bool {
    share(taken, slower) > SLACK || taken.of_predicted(slower) > SLACK || !(0..=2).contains(&taken.code)
}

/// Leaves the project of a case in `target/cost`, to run it again.
fn keep(case: &Case) {
    let folder = benches::root().join("target/cost");
    let name: String = case.name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    std::fs::create_dir_all(&folder).expect("a folder for the cases");
    std::fs::write(folder.join(RECORDING.0), RECORDING.1).expect("the recording is written");
    std::fs::write(folder.join(format!("{name}.toml")), &case.project).expect("the project is written");
}

fn main() -> ExitCode {
    // With a number: the drawn projects alone, of that many seeds; with a program behind it: that one instead of the
    // release binary. The projects that exceed a promise are left in `target/cost`.
    let mut words = std::env::args().skip(1).filter(|word| !word.starts_with('-'));
    let seeds = words.next().and_then(|word| word.parse().ok());
    let binary = words.next().map(PathBuf::from).or_else(binary).expect("the release binary is built");
    let cases = seeds.map_or_else(|| cases().into_iter().chain(at_the_extremes(SEEDS)).collect(), at_the_extremes);
    let folder = std::env::temp_dir().join(format!("antrieb-cost-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the cases");
    std::fs::write(folder.join(RECORDING.0), RECORDING.1).expect("the recording is written");
    sort(SORTED.0);
    let slower = (timed(|| sort(SORTED.0)).as_secs_f64() / SORTED.1).max(1.0);
    let (mut found, mut written) = (Vec::new(), None);
    for case in cases {
        let path = folder.join("case.toml");
        std::fs::write(&path, &case.project).expect("the project is written");
        if let Some(samples) = case.recording.filter(|samples| written != Some(*samples)) {
            std::fs::write(folder.join("run.csv"), recording(samples)).expect("the recording is written");
            written = Some(samples);
        }
        let path = path.to_str().expect("a folder with a name");
        // A project that cannot be read is refused.
        let predicted = case.predicted().unwrap_or_else(|| vec![(0.0, 0.0); case.commands.len()]);
        let out = folder.join("out");
        for (command, predicted) in case.commands.iter().zip(predicted) {
            let out = out.with_extension(if *command == "report" { "pdf" } else { "xlsx" });
            let arguments = arguments(command, path, out.to_str().expect("a folder with a name"));
            let Some(taken) = taken(&binary, &arguments, predicted) else { continue };
            if exceeds(&taken, slower) {
                keep(&case);
            }
            found.push((format!("{command} {}", case.name), taken));
        }
    }
    let _ = std::fs::remove_dir_all(&folder);
    found.sort_by(|a, b| share(&b.1, slower).total_cmp(&share(&a.1, slower)));
    println!("{} runs, seconds of a machine {slower:.1} times as fast;", found.len());
    println!("the ten that come nearest to what is promised, or beyond:");
    for (name, taken) in found.iter().take(10) {
        let (seconds, megabytes) = (taken.seconds / slower, taken.bytes / 1e6);
        let (awaited, room) = (taken.predicted.0, taken.predicted.1 / 1e6);
        println!("  {seconds:6.2} of {awaited:5.2} s {megabytes:6.0} of {room:4.0} MB  code {}  {name}", taken.code);
    }
    found.sort_by(|a, b| b.1.of_predicted(slower).total_cmp(&a.1.of_predicted(slower)));
    println!("the ten that take most of what is predicted:");
    for (name, taken) in found.iter().take(10) {
        println!("  {:4.2} ×  {name}", taken.of_predicted(slower));
    }
    let refused = found.iter().filter(|(_, taken)| taken.code == 2).count();
    println!("  {refused} refused before the work began");
    let broken: Vec<&str> =
        found.iter().filter(|(_, taken)| exceeds(taken, slower)).map(|(name, _)| name.as_str()).collect();
    if broken.is_empty() {
        return ExitCode::SUCCESS;
    }
    println!("  broken: {}", broken.join("; "));
    ExitCode::FAILURE
}

//! Files that `sweep` keeps next to its output: only its own are removed, and a continued run is the same run.
#![cfg(unix)]
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run;

use run::{Run, run};
use std::fmt::Write as _;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A recorded turn, so that a run reads a recording too.
const RECORDED: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\nlaw = \"recorded\"\n\
    file = \"turn.csv\"\n";

fn put(folder: &Path, name: &str, text: &str) -> String {
    fs::write(folder.join(name), text).unwrap();
    folder.join(name).display().to_string()
}

/// A turn and back within two seconds, of so many degrees.
fn turn(degrees: f64) -> String {
    let at = |t: f64| degrees / 2.0 * (1.0 - (std::f64::consts::PI * t).cos());
    let lines = (0..=100).map(|n| f64::from(n) * 0.02).map(|t| format!("{t:.2},{:.6}\n", at(t)));
    format!("time [s],position [deg]\n{}", lines.collect::<String>())
}

/// Rows most of which are refused at once: three parts and some.
fn table(more: f64) -> String {
    let mut text = String::from("load.inertia [kg m^2]\n");
    for row in 0..50_000 {
        let inertia = if row % 2048 == 0 { more + f64::from(row % 97) } else { -1.0 };
        writeln!(text, "{inertia}").unwrap();
    }
    text
}

struct Bench {
    folder: tempfile::TempDir,
}

impl Bench {
    fn new() -> Self {
        let bench = Self { folder: tempfile::tempdir().unwrap() };
        put(bench.here(), "axis.toml", RECORDED);
        put(bench.here(), "turn.csv", &turn(90.0));
        put(bench.here(), "tasks.csv", &table(0.1));
        bench
    }

    fn here(&self) -> &Path {
        self.folder.path()
    }

    fn call(&self, more: &[&str]) -> Vec<String> {
        let path = |name: &str| self.here().join(name).display().to_string();
        let call = ["sweep".to_owned(), path("axis.toml"), "--table".into(), path("tasks.csv"), "--out".into()];
        let more = more.iter().map(|word| (*word).to_owned());
        call.into_iter().chain([path("best.csv")]).chain(more).collect()
    }

    fn run(&self, more: &[&str]) -> Run {
        let call = self.call(more);
        run(&call.iter().map(String::as_str).collect::<Vec<_>>())
    }

    fn start(&self) -> Child {
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        command.args(self.call(&[])).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
    }

    /// Waits until a part is finished.
    fn wait_for(&self, part: &str) {
        let (path, begun) = (self.here().join("best.csv.parts").join(part), Instant::now());
        while !path.exists() {
            assert!(begun.elapsed() < Duration::from_secs(240), "{part} does not come");
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    /// A run that is killed behind its first part.
    fn interrupted(&self) {
        let mut child = self.start();
        self.wait_for("part-00000000.parquet");
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(!self.here().join("best.csv").exists(), "the run was too quick to be interrupted");
    }

    fn names(&self) -> Vec<String> {
        names(self.here())
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Returns every file of the parts with its bytes.
fn held(bench: &Bench) -> Vec<(String, Vec<u8>)> {
    let folder = bench.here().join("best.csv.parts");
    names(&folder).into_iter().map(|name| (name.clone(), fs::read(folder.join(name)).unwrap())).collect()
}

/// Rows before the interruption never answer another recording, table, project or request than those behind it: such a call is
/// refused with what differs, and the parts stay for the run that they belong to.
#[test]
fn a_run_that_continues_is_the_same_run() {
    type Change<'c> = &'c dyn Fn(&Bench);
    let nothing: Change<'_> = &|_| {};
    let changes: [(&str, Change<'_>, &[&str]); 9] = [
        ("recordings", &|bench| drop(put(bench.here(), "turn.csv", &turn(60.0))), &[]),
        ("table", &|bench| drop(put(bench.here(), "tasks.csv", &table(0.7))), &[]),
        ("project", &|bench| drop(put(bench.here(), "axis.toml", &RECORDED.replace("5 N m", "6 N m"))), &[]),
        ("project", nothing, &["--set", "load.friction_torque=6 N m"]),
        ("--lang", nothing, &["--lang", "de"]),
        ("--front", nothing, &["--front"]),
        ("--check", nothing, &["--check", "thermal"]),
        ("--inputs", nothing, &["--inputs", "table"]),
        ("--memory", nothing, &["--memory", "300 MiB"]),
    ];
    for (name, change, more) in changes {
        let bench = Bench::new();
        bench.interrupted();
        let before = held(&bench);
        change(&bench);
        let found = bench.run(more);
        assert_eq!(found.code, 2, "{name}: {}", found.err);
        let said = ["different: ", "abweichend: "].map(|word| format!("{word}{name}\n"));
        assert!(said.iter().any(|said| found.err.contains(said)), "{name}: {}", found.err);
        assert!(found.err.contains("--force"), "{name}: {}", found.err);
        assert!(held(&bench) == before && !bench.here().join("best.csv").exists(), "{name}");
        let anew = bench.run(&[more, &["--force"]].concat());
        let said = ["discarded", "verworfen"];
        assert!(anew.code < 2 && said.iter().any(|said| anew.err.contains(said)), "{name}: {}", anew.err);
        if name == "recordings" {
            let answered = fs::read(bench.here().join("best.csv")).unwrap();
            let again = bench.run(&[more, &["--force"]].concat());
            assert!(again.code < 2 && fs::read(bench.here().join("best.csv")).unwrap() == answered, "{name}");
        }
        assert_eq!(bench.names(), ["axis.toml", "best.csv", "tasks.csv", "turn.csv"], "{name}");
    }
    // Nothing changed: the parts are taken, also behind a refused call.
    let bench = Bench::new();
    bench.interrupted();
    assert_eq!(bench.run(&["--front"]).code, 2);
    let found = bench.run(&[]);
    assert!(found.code < 2 && found.err.contains("of an interrupted run"), "{}", found.err);
}

/// Products of a catalogue file belong to the run.
#[test]
fn a_catalogue_file_belongs_to_the_run() {
    let bench = Bench::new();
    let stock = run(&["new", "catalogue"]);
    assert_eq!(stock.code, 0, "{}", stock.err);
    let file = put(bench.here(), "stock.toml", &stock.out);
    bench.interrupted();
    let found = bench.run(&["--catalogue", &file]);
    assert!(found.code == 2 && found.err.contains("different: catalogue\n"), "{}", found.err);
}

/// A recording that the table names belongs to the run like one of the project.
#[test]
fn a_recording_named_in_a_cell_belongs_to_the_run() {
    let bench = Bench::new();
    let rows: String = (0..60_000).map(|row| if row == 7 { "1,turn.csv\n" } else { "-1,turn.csv\n" }).collect();
    put(bench.here(), "tasks.csv", &format!("load.inertia [kg m^2],motion[1].file\n{rows}"));
    put(bench.here(), "axis.toml", &RECORDED.replace("turn.csv", "other.csv"));
    put(bench.here(), "other.csv", &turn(90.0));
    bench.interrupted();
    put(bench.here(), "turn.csv", &turn(10.0));
    let found = bench.run(&[]);
    assert!(found.code == 2 && found.err.contains("different: recordings\n"), "{}", found.err);
    let found = bench.run(&["--force"]);
    assert!(found.code < 2 && found.err.contains("discarded"), "{}", found.err);
    // Nor is it written.
    let call = bench.call(&["--force"]);
    let mut call: Vec<&str> = call.iter().map(String::as_str).collect();
    let turn = bench.here().join("turn.csv");
    let place = call.iter().position(|word| word.ends_with("best.csv")).unwrap();
    call[place] = turn.to_str().unwrap();
    let refused = run(&call);
    assert!(refused.code == 2 && refused.err.contains("turn.csv: "), "{}", refused.err);
    assert!(fs::read_to_string(&turn).unwrap().starts_with("time [s]"));
}

/// A part that a power failure has cut off is computed again, as one with other content is.
#[test]
fn a_damaged_part_is_computed_again() {
    let bench = Bench::new();
    assert!(bench.run(&[]).code < 2);
    let whole = fs::read(bench.here().join("best.csv")).unwrap();
    fs::remove_file(bench.here().join("best.csv")).unwrap();
    let damages: [fn(Vec<u8>) -> Vec<u8>; 3] = [
        |mut bytes| {
            bytes.truncate(bytes.len() / 2);
            bytes
        },
        |_| Vec::new(),
        |mut bytes| {
            let middle = bytes.len() / 2;
            bytes[middle] ^= 1;
            bytes
        },
    ];
    for damage in damages {
        bench.interrupted();
        let part = bench.here().join("best.csv.parts/part-00000000.parquet");
        fs::write(&part, damage(fs::read(&part).unwrap())).unwrap();
        let found = bench.run(&[]);
        assert!(found.code < 2, "{}", found.err);
        assert!(fs::read(bench.here().join("best.csv")).unwrap() == whole);
        assert_eq!(bench.names(), ["axis.toml", "best.csv", "tasks.csv", "turn.csv"]);
        fs::remove_file(bench.here().join("best.csv")).unwrap();
    }
}

#[test]
fn what_changes_while_a_sweep_runs_ends_it() {
    let bench = Bench::new();
    let child = bench.start();
    bench.wait_for("part-00000000.parquet");
    put(bench.here(), "turn.csv", &turn(60.0));
    let ended = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&ended.stderr);
    assert!(ended.status.code() == Some(2) && said.contains("changed while the sweep ran"), "{said}");
    assert_eq!(bench.names(), ["axis.toml", "tasks.csv", "turn.csv"]);
}

#[test]
fn a_second_sweep_into_one_file_is_refused_while_the_first_runs() {
    let bench = Bench::new();
    let child = bench.start();
    bench.wait_for("part-00000000.parquet");
    put(bench.here(), "others.csv", "load.inertia [kg m^2]\n1\n");
    let call = bench.call(&[]);
    let call: Vec<String> = call[..2]
        .iter()
        .cloned()
        .chain(["--table".into(), bench.here().join("others.csv").display().to_string()])
        .chain(call[4..6].iter().cloned())
        .collect();
    let second = run(&call.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(second.code == 2 && second.err.contains("another sweep is writing to the same file"), "{}", second.err);
    let first = child.wait_with_output().unwrap();
    assert_eq!(first.status.code(), Some(0), "{}", String::from_utf8_lossy(&first.stderr));
    assert_eq!(fs::read_to_string(bench.here().join("best.csv")).unwrap().lines().count(), 50_001);
    assert_eq!(bench.names(), ["axis.toml", "best.csv", "others.csv", "tasks.csv", "turn.csv"]);
}

/// Whatever stands beside the answers under the name of the parts and is not of this program: it stays to the last byte, and nothing
/// is written.
#[test]
fn a_folder_of_the_user_is_never_touched() {
    type Lays = (&'static str, fn(&Path, &Path));
    let cases: [Lays; 6] = [
        ("own files", |parts, _| {
            fs::create_dir(parts).unwrap();
            fs::write(parts.join("thesis.txt"), "years").unwrap();
        }),
        ("a file named like the mark", |parts, _| {
            fs::create_dir(parts).unwrap();
            fs::write(parts.join("sweep"), "of a user\n").unwrap();
            fs::write(parts.join("part-00000000.parquet"), "years").unwrap();
        }),
        ("an empty folder", |parts, _| fs::create_dir(parts).unwrap()),
        ("a file", |parts, _| fs::write(parts, "years").unwrap()),
        ("a link to a folder", |parts, away| {
            fs::write(away.join("part-00000000.parquet"), "years").unwrap();
            fs::write(away.join("sweep"), "of a user\n").unwrap();
            symlink(away, parts).unwrap();
        }),
        ("a link to nothing", |parts, away| symlink(away.join("nothing"), parts).unwrap()),
    ];
    let bench = Bench::new();
    put(bench.here(), "tasks.csv", "load.inertia [kg m^2]\n1\n");
    for (name, lay) in cases {
        let away = tempfile::tempdir().unwrap();
        let parts = bench.here().join("best.csv.parts");
        lay(&parts, away.path());
        let look = |folder: &Path| -> Vec<(String, Vec<u8>)> {
            let listed = if folder.is_dir() { names(folder) } else { Vec::new() };
            listed.into_iter().map(|each| (each.clone(), fs::read(folder.join(each)).unwrap())).collect()
        };
        let before = (look(&parts), look(away.path()), parts.symlink_metadata().unwrap().file_type());
        let found = bench.run(&["--force"]);
        assert!(
            found.code == 2 && found.err.contains("was not made by antrieb"),
            "{name}: {} {}",
            found.code,
            found.err
        );
        assert_eq!((look(&parts), look(away.path()), parts.symlink_metadata().unwrap().file_type()), before, "{name}");
        assert!(!bench.here().join("best.csv").exists(), "{name}");
        if parts.is_dir() && !parts.is_symlink() {
            fs::remove_dir_all(&parts).unwrap()
        } else {
            fs::remove_file(&parts).unwrap()
        }
    }
    // Own files in a folder of ours outlive it too.
    put(bench.here(), "tasks.csv", &table(0.1));
    bench.interrupted();
    fs::write(bench.here().join("best.csv.parts/notes.txt"), "mine").unwrap();
    assert!(bench.run(&[]).code < 2);
    assert_eq!(names(&bench.here().join("best.csv.parts")), ["notes.txt"]);
}

/// A link that another hand lays into the folder where a part is about to be written.
#[test]
fn no_link_in_the_folder_is_written_through() {
    let bench = Bench::new();
    let precious = bench.here().join("precious.txt");
    for name in ["part-00000001.parquet", "part-00000001.parquet.unfinished", "part-00000000.parquet", "sweep"] {
        fs::write(&precious, "years").unwrap();
        bench.interrupted();
        let link = bench.here().join("best.csv.parts").join(name);
        drop(fs::remove_file(&link));
        symlink(&precious, &link).unwrap();
        let found = bench.run(&[]);
        assert!(found.code == 2 && found.err.contains(&format!("best.csv.parts/{name}")), "{name}: {}", found.err);
        assert!(link.is_symlink() && fs::read_to_string(&precious).unwrap() == "years", "{name}");
        fs::remove_dir_all(bench.here().join("best.csv.parts")).unwrap();
    }
}

/// A limit of the size of files (`ulimit -f`) is answered: without a finished part nothing is left, with some they are named.
#[test]
fn a_limit_of_the_size_is_answered() {
    let bench = Bench::new();
    for (blocks, is_kept) in [(1, false), (2000, true)] {
        let script = format!("ulimit -f {blocks}; exec \"$0\" \"$@\"");
        let mut shell = Command::new("sh");
        let ended = shell.args(["-c", &script, env!("CARGO_BIN_EXE_antrieb")]).args(bench.call(&[])).output().unwrap();
        let said = String::from_utf8_lossy(&ended.stderr);
        assert_eq!(ended.status.code(), Some(2), "{blocks}: {said}");
        assert!(!bench.here().join("best.csv").exists(), "{said}");
        assert_eq!(said.contains("parts are kept in"), is_kept, "{said}");
        let left: Vec<String> = bench.names().into_iter().filter(|name| name.contains("best")).collect();
        assert_eq!(left.len(), usize::from(is_kept), "{left:?}: {said}");
    }
    let found = bench.run(&[]);
    assert!(found.code < 2 && found.err.contains("of an interrupted run"), "{}", found.err);
}

/// Returns the largest resident memory of a run in MB.
#[cfg(target_os = "linux")]
fn peak_memory(mut child: Child) -> f64 {
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0.0_f64;
    while child.try_wait().unwrap().is_none() {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let held = text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
        most = held.map_or(most, |kilobytes: f64| most.max(kilobytes / 1024.0));
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(child.wait().unwrap().code().is_some_and(|code| code < 2));
    most
}

/// The inertias of [`the_groups_of_a_table_lose_no_row`] in row groups of five rows each, written with pyarrow 26:
/// `pq.write_table(pa.table({"load.inertia [kg m^2]": [1 + 1e-4 * row for row in range(43)]}), path, row_group_size=5)`.
const GROUPS: &[u8] = include_bytes!("../data/groups.parquet");

/// The groups of a Parquet table are shorter than a part, and every row is answered: as from the same table as text.
#[test]
fn the_groups_of_a_table_lose_no_row() {
    const ROWS: u32 = 43;
    let bench = Bench::new();
    put(bench.here(), "axis.toml", BRIEF);
    fs::write(bench.here().join("tasks.parquet"), GROUPS).unwrap();
    let inertia = |row: u32| format!("{}\n", 1.0 + f64::from(row) * 1e-4);
    put(bench.here(), "tasks.csv", &format!("load.inertia [kg m^2]\n{}", (0..ROWS).map(inertia).collect::<String>()));
    let each: Vec<&str> = EVERY_CHECK.split_whitespace().flat_map(|check| ["--check", check]).collect();
    let answers = ["tasks.csv", "tasks.parquet"].map(|table| {
        let out = bench.here().join(format!("{table}.csv"));
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        // Parts of some eight rows.
        command.args(["sweep", "axis.toml", "--table", table, "--memory", "32 MiB", "--out"]).arg(&out).args(&each);
        let ended = command.current_dir(bench.here()).output().unwrap();
        assert!(ended.status.code().is_some_and(|code| code < 2), "{}", String::from_utf8_lossy(&ended.stderr));
        fs::read_to_string(out).unwrap()
    });
    let last = answers[0].lines().last().unwrap();
    assert!(last.starts_with(&format!("{},", ROWS - 1)), "{last}");
    assert!(answers[0] == answers[1], "{} and {} lines", answers[0].lines().count(), answers[1].lines().count());
}

const BRIEF: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"manual\"\nspeed = \"20 1/min\"\n\
    accelerate = \"0.2 s\"\nrun = \"0.5 s\"\nbrake = \"0.2 s\"\npause = \"0.5 s\"\n";

const EVERY_CHECK: &str = "peak_torque peak_speed mean_speed continuous_torque torque_speed_trace peak_current demagnetisation voltage \
    thermal overload_i2t inertia_ratio gear_mean_torque gear_mean_input_speed gear_life collision_torque bearing_axial bearing_radial \
    bearing_tilting_moment bearing_life bearing_static tilt_angle torsion natural_frequency resonance_speed brake_holding ambient";

/// Every check of every code of every row: ten times as many rows need no more memory than the parts may take.
#[cfg(target_os = "linux")]
#[test]
fn the_checks_of_every_code_are_held_to_the_memory() {
    let bench = Bench::new();
    put(bench.here(), "axis.toml", BRIEF);
    let of = |rows: u32| {
        let inertia = |row: u32| format!("{}\n", 1.0 + f64::from(row) * 1e-4);
        put(
            bench.here(),
            "tasks.csv",
            &format!("load.inertia [kg m^2]\n{}", (0..rows).map(inertia).collect::<String>()),
        );
        let each = EVERY_CHECK.split_whitespace().flat_map(|check| ["--check", check]);
        let more: Vec<&str> = ["--memory", "32 MiB", "--force"].into_iter().chain(each).collect();
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        peak_memory(command.args(bench.call(&more)).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap())
    };
    let (few, many) = (of(24), of(240));
    assert!(many < few + 30.0, "{few:.0} MB for 24 rows, {many:.0} MB for 240");
}

/// An interrupt states the rows that are kept, and the same call continues with them.
#[cfg(unix)]
#[test]
fn an_interrupt_states_the_rows_that_are_kept() {
    let bench = Bench::new();
    let child = bench.start();
    bench.wait_for("part-00000000.blake3");
    bench.wait_for("part-00000000.parquet");
    let _ = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let done = child.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(130));
    let said = String::from_utf8(done.stderr).unwrap();
    let (_, kept) = said.split_once("interrupted").unwrap();
    let number = |text: &str, before: &str| -> Option<u64> {
        let (head, _) = text.split_once(before)?;
        head.rsplit(' ').next()?.parse().ok()
    };
    let found = bench.run(&[]);
    assert!(found.code < 2, "{}", found.err);
    let resumed = number(&found.err, " rows of an interrupted run");
    match number(kept, " of 50000 rows are kept") {
        // A part that is complete may not be counted yet.
        None => assert!(kept.contains("before the first part"), "{said}"),
        Some(rows) => assert!(rows > 0 && resumed.is_some_and(|resumed| resumed >= rows), "{said} {}", found.err),
    }
}

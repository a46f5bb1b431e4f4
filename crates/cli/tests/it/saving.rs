//! Files are written completely or not at all, and only at the given path.
#![cfg(unix)]
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run;

use run::root;
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
    command.args(arguments).current_dir(folder).env_remove("ANTRIEB_LANG").env("COLUMNS", "100");
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn antrieb(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments).output().unwrap()
}

/// Refused with exit 2 and one fault in JSON that has this word.
fn refused(folder: &Path, arguments: &[&str], word: &str) {
    let output = antrieb(folder, &[arguments, &["--json"]].concat());
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {out}{err}");
    let faults: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(faults.as_object().unwrap().keys().collect::<Vec<_>>(), ["errors"], "{faults}");
    let message = faults["errors"][0]["message"].as_str().unwrap();
    assert!(message.contains(word), "{arguments:?}: {message}");
    assert!(err.contains(message), "{err}");
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

const CURVE: [&str; 3] = ["curve", "CHA-20A-100-H-C1024", "--force"];

fn curve<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&CURVE, more].concat()
}

#[test]
fn only_regular_files_are_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    assert!(Command::new("mkfifo").arg(here.join("pipe.svg")).status().unwrap().success());
    fs::create_dir(here.join("folder.svg")).unwrap();
    refused(here, &curve(&["--svg", "pipe.svg"]), "only regular files");
    refused(here, &curve(&["--svg", "/dev/null"]), "only regular files");
    refused(here, &curve(&["--svg", "folder.svg"]), "folder");
    refused(here, &curve(&["--svg", "none/a.svg"]), "no such folder");
    refused(here, &["report", "x.toml", "--out", "-"], "standard output");
    refused(here, &curve(&["--png", "-"]), "standard output");
    assert_eq!(names(here), ["folder.svg", "pipe.svg"]);
}

#[test]
fn mode_and_write_protection_of_a_file_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg");
    let mode = |mode| fs::set_permissions(&file, fs::Permissions::from_mode(mode)).unwrap();
    fs::write(&file, "old").unwrap();
    mode(0o600);
    assert_eq!(antrieb(folder.path(), &curve(&["--svg", "a.svg"])).status.code(), Some(0));
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
    assert!(fs::read_to_string(&file).unwrap().starts_with("<svg"));
    fs::write(&file, "old").unwrap();
    mode(0o444);
    refused(folder.path(), &curve(&["--svg", "a.svg"]), "write-protected");
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
}

/// A link in the folder, out of it, to nothing and to a device: nothing is written through it, with `--force` or without, nor
/// is it replaced.
#[test]
fn nothing_is_written_through_a_link() {
    let (folder, away) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let here = folder.path();
    fs::write(here.join("target.svg"), "old").unwrap();
    fs::write(away.path().join("far.svg"), "old").unwrap();
    let targets = [
        ("near.svg", "target.svg".into()),
        ("far.svg", away.path().join("far.svg")),
        ("nowhere.svg", "nothing.svg".into()),
        ("device.svg", "/dev/null".into()),
    ];
    for (link, target) in &targets {
        symlink(target, here.join(link)).unwrap();
    }
    for (link, target) in &targets {
        let plain = ["curve", "CHA-25A-100-H-M512P", "--svg", link];
        for call in [&plain[..], &[&plain[..], &["--force"]].concat()] {
            refused(here, call, "files are not written through a link");
        }
        assert_eq!(&here.join(link).read_link().unwrap(), target);
    }
    let content = [here.join("target.svg"), away.path().join("far.svg")].map(|path| fs::read_to_string(path).unwrap());
    assert_eq!(content, ["old", "old"]);
    assert_eq!(names(here), ["device.svg", "far.svg", "near.svg", "nowhere.svg", "target.svg"]);
}

/// A picture that cannot be written is not drawn: faults of its path are reported before those of drawing.
#[test]
fn the_place_of_a_picture_is_asked_for_first() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(root().join("examples/indexing-table.toml"), folder.path().join("a.toml")).unwrap();
    let plot = ["plot", "a.toml", "--figure", "torque_speed", "--code", "CHA-99A"];
    refused(folder.path(), &[&plot[..], &["--svg", "none/a.svg"]].concat(), "no such folder");
    refused(folder.path(), &[&plot[..], &["--svg", "a.toml"]].concat(), "this call reads the file");
    refused(folder.path(), &curve(&["--voltage", "220 V", "--png", "none/a.png"]), "no such folder");
}

/// Known by the check in its name, its owner and its lock; a file that a user named alike stays.
#[test]
fn a_save_removes_what_a_kill_left_a_minute_before() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let named = |letters: &str| {
        let check = blake3::hash(format!("temporary file of antrieb: {letters}").as_bytes()).to_hex();
        format!(".antrieb-{letters}-{}", &check.as_str()[..8])
    };
    let (left, fresh, written) = (named("abc123"), named("abc124"), named("abc125"));
    let made = |name: &str, seconds: u64| {
        let file = fs::File::create(here.join(name)).unwrap();
        file.set_modified(std::time::SystemTime::now() - Duration::from_secs(seconds)).unwrap();
        file
    };
    for (name, seconds) in [(left.as_str(), 100), (".antrieb-abc123", 1_000_000), (&fresh, 1)] {
        drop(made(name, seconds));
    }
    let open = made(&written, 100);
    open.try_lock().unwrap();
    assert!(antrieb(here, &curve(&["--svg", "a.svg"])).status.success());
    let mut expected = [".antrieb-abc123", &fresh, &written, "a.svg"];
    expected.sort_unstable();
    assert_eq!(names(here), expected);
}

#[test]
fn two_files_are_never_one() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::write(here.join("a"), "old").unwrap();
    fs::hard_link(here.join("a"), here.join("b")).unwrap();
    symlink("a", here.join("c")).unwrap();
    symlink(".", here.join("d")).unwrap();
    for (svg, png) in [("a", "a"), ("a", "./a"), ("a", "b"), ("new", "new"), ("new", "d/new")] {
        refused(here, &curve(&["--svg", svg, "--png", png]), "the same file");
    }
    refused(here, &curve(&["--svg", "a", "--png", "c"]), "a link");
    assert_eq!(fs::read_to_string(here.join("a")).unwrap(), "old");
    assert_eq!(names(here), ["a", "b", "c", "d"]);
}

#[test]
fn what_is_read_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    for name in ["robot-joint.toml", "robot-joint.csv"] {
        fs::copy(root().join("examples").join(name), here.join(name)).unwrap();
    }
    symlink("robot-joint.csv", here.join("link.csv")).unwrap();
    let export = |out| ["export", "robot-joint.toml", "--table", "checks", "--force", "--out", out];
    for out in ["robot-joint.csv", "./robot-joint.csv"] {
        refused(here, &export(out), "this call reads the file");
    }
    refused(here, &export("link.csv"), "a link");
    let plot = ["plot", "robot-joint.toml", "--figure", "cycle", "--force", "--svg", "robot-joint.toml"];
    refused(here, &plot, "this call reads the file");
    assert!(fs::read_to_string(here.join("robot-joint.toml")).unwrap().starts_with("#"));
}

/// The kernel creates no files in this folder, not even for the superuser.
#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_files_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    for (language, word) in [("en", "permission denied"), ("de", "kein Zugriff")] {
        let output = antrieb(folder.path(), &curve(&["--svg", "/sys/a.svg", "--lang", language]));
        let notice = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{notice}");
        assert!(notice.contains("/sys/a.svg: ") && notice.contains(word) && !notice.contains(".antrieb-"), "{notice}");
    }
}

/// A disk without room, by a limit of the size of a file.
#[test]
fn a_full_disk_is_reported_in_our_words_with_the_name_given() {
    for (language, word) in [("en", "not enough space"), ("de", "nicht genügend Speicherplatz")] {
        let folder = tempfile::tempdir().unwrap();
        let script = "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"";
        let output = Command::new("sh")
            .args(["-c", script, env!("CARGO_BIN_EXE_antrieb")])
            .args(curve(&["--svg", "a.svg", "--lang", language]))
            .current_dir(folder.path())
            .output()
            .unwrap();
        let notice = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{notice}");
        assert!(notice.contains("a.svg: ") && notice.contains(word) && !notice.contains(".antrieb-"), "{notice}");
        assert_eq!(names(folder.path()), [""; 0]);
    }
}

#[test]
fn many_writers_of_one_file_leave_one_whole_file() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let write = |language: &'static str| ["new", "arm", "--force", "--out", "axis.toml", "--lang", language];
    let whole = ["en", "de"].map(|language| {
        assert_eq!(antrieb(here, &write(language)).status.code(), Some(0));
        fs::read_to_string(here.join("axis.toml")).unwrap()
    });
    let writers: Vec<Child> =
        (0..20).map(|index| command(here, &write(["en", "de"][index % 2])).spawn().unwrap()).collect();
    for writer in writers {
        assert_eq!(writer.wait_with_output().unwrap().status.code(), Some(0));
        assert!(whole.contains(&fs::read_to_string(here.join("axis.toml")).unwrap()));
    }
    assert_eq!(names(here), ["axis.toml"]);
}

/// Way in which a program is ended, and the state of its files.
struct Campaign {
    whole: [Vec<u8>; 2],
    folder: tempfile::TempDir,
    /// Duration of a run that is not interrupted.
    length: Duration,
}

impl Campaign {
    const WRITE: [&str; 5] = ["new", "recording", "--force", "--out", "axis.toml"];

    /// A folder in which the files stand once in each language, the last German.
    fn begin() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let mut length = Duration::ZERO;
        let whole = ["en", "de"].map(|language| {
            let begin = Instant::now();
            let output = antrieb(folder.path(), &[&Self::WRITE[..], &["--lang", language]].concat());
            assert_eq!(output.status.code(), Some(0));
            length = begin.elapsed();
            fs::read(folder.path().join("axis.toml")).unwrap()
        });
        Self { whole, folder, length }
    }

    /// Runs that are ended after ever another part of their time; gives how each ended.
    fn ended_by(&self, signal: &str, runs: usize) -> Vec<(Option<i32>, Option<i32>)> {
        let here = self.folder.path();
        (0..runs)
            .map(|run| {
                let language = ["en", "de"][run % 2];
                let mut child = command(here, &[&Self::WRITE[..], &["--lang", language]].concat()).spawn().unwrap();
                // The golden section spreads the instants evenly, however many there are.
                let part = (run as f64 * 0.618_033_988_75).fract();
                std::thread::sleep(self.length.mul_f64(1.2 * part));
                let _ = Command::new("kill").args([signal, &child.id().to_string()]).stderr(Stdio::null()).status();
                let status = child.wait().unwrap();
                let found = fs::read(here.join("axis.toml")).unwrap();
                assert!(self.whole.contains(&found), "run {run}: a part of a file");
                (status.code(), status.signal())
            })
            .collect()
    }

    fn left(&self) -> usize {
        names(self.folder.path()).iter().filter(|name| name.starts_with(".antrieb-")).count()
    }
}

/// Number of runs from the environment variable, for a campaign of hours; few by default.
fn runs(usual: usize) -> usize {
    std::env::var("ANTRIEB_SAVE_RUNS").ok().and_then(|runs| runs.parse().ok()).unwrap_or(usual)
}

#[test]
fn a_kill_at_any_instant_leaves_whole_files() {
    let campaign = Campaign::begin();
    let ends = campaign.ended_by("-KILL", runs(25));
    let killed = ends.iter().filter(|(_, signal)| *signal == Some(9)).count();
    eprintln!("{} runs, {killed} killed, {} hidden files left", ends.len(), campaign.left());
    assert!(ends.iter().all(|end| matches!(end, (Some(0), None) | (None, Some(9)))), "{ends:?}");
    assert!(killed > 0, "no run was killed: the campaign tries nothing");
}

#[test]
fn an_interrupt_at_any_instant_leaves_whole_files_and_nothing_else() {
    for (name, signal) in [("-INT", 2), ("-TERM", 15)] {
        let campaign = Campaign::begin();
        let ends = campaign.ended_by(name, runs(25));
        // Before anything is written the signal itself ends the program; a shell gives both the same number.
        let ours = |end: &(Option<i32>, Option<i32>)| *end == (Some(128 + signal), None);
        let sound = |end| matches!(end, (Some(0), None)) || end == (None, Some(signal)) || ours(&end);
        assert!(ends.iter().all(|end| sound(*end)), "{ends:?}");
        let answered = ends.iter().filter(|end| ours(end)).count();
        eprintln!("{} runs, {answered} interrupted while writing", ends.len());
        assert_eq!(campaign.left(), 0, "{name}");
    }
}

#[test]
fn a_plan_of_upkeep_is_written_once_and_replaced_with_force_only() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.ics");
    let file = path.to_str().unwrap();
    let call = ["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2026-03-01", "--ical", file];
    let first = run::run(&call);
    assert_eq!(first.code, 0, "{}", first.err);
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.starts_with("BEGIN:VCALENDAR") && text.trim_end().ends_with("END:VCALENDAR"), "{text}");
    assert_eq!(run::run(&call).code, 2);
    let again = run::run(&[&call[..], &["--force", "--json"]].concat());
    assert_eq!(again.code, 0, "{}", again.err);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
    let json: serde_json::Value = serde_json::from_str(&again.out).unwrap();
    assert_eq!(json.get("calendar").and_then(serde_json::Value::as_str), Some(file));
}

/// The plan of a delivery to come is that of its day, which is listed as assumed; a delivery in the past is answered alike on every day.
#[test]
fn the_clock_is_looked_at_for_a_delivery_in_the_future_only() {
    let ask = |day: &str| run::run(&["upkeep", "CHA-14A-50-E-M128S", "--delivered", day]);
    let future = ask("2199-12-31");
    assert_eq!(future.code, 0, "{}", future.err);
    assert!(future.err.contains("assumed: --today 2199-12-31"), "{}", future.err);
    let past = ask("2020-01-01");
    assert!(past.code == 0 && !past.err.contains("--today"), "{}", past.err);
    let ahead = run::run(&["upkeep", "CHA-14A-50-E-M128S", "--delivered", "2190-01-01", "--today", "2190-01-01"]);
    assert_eq!((ahead.code, ahead.out), (0, ask("2190-01-01").out), "{}", ahead.err);
}

/// A limit of the size of files ends no program by its signal: the write is refused, and no temporary file stays.
#[cfg(unix)]
#[test]
fn a_limit_of_the_size_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("ranking.xlsx");
    let program = env!("CARGO_BIN_EXE_antrieb");
    let line = format!("ulimit -f 1; exec {program} export examples/indexing-table.toml --out {}", out.display());
    let found = std::process::Command::new("bash").args(["-c", &line]).current_dir(run::root()).output().unwrap();
    let said = String::from_utf8_lossy(&found.stderr);
    assert_eq!(found.status.code(), Some(2), "{said}");
    let left: Vec<_> = std::fs::read_dir(folder.path()).unwrap().flatten().map(|entry| entry.file_name()).collect();
    assert!(left.is_empty(), "{left:?}: {said}");
}

/// Help and version are answers like any other: where standard output does not take them, that is a fault.
#[cfg(target_os = "linux")]
#[test]
fn help_and_version_are_answers_too() {
    let program = env!("CARGO_BIN_EXE_antrieb");
    for call in ["--help", "-h", "--version", "help", "help size", "size --help", "code parse CHA-25A-100-H-C1024"] {
        for (to, code) in [
            (">&-", 0),
            (">/dev/full", 2),
            (">/dev/null", 0),
            ("1<>/dev/null", 0),
            ("| head -c 1 >/dev/null; exit ${PIPESTATUS[0]}", 0),
        ] {
            let line = format!("{program} {call} {to}");
            let found = std::process::Command::new("bash").args(["-c", &line]).output().unwrap();
            assert_eq!(found.status.code(), Some(code), "{call} {to}: {}", String::from_utf8_lossy(&found.stderr));
            assert_eq!(found.stderr.is_empty(), code == 0, "{call} {to}");
        }
    }
}

/// `--json=1` is `--json`, and a faulty call answers JSON too.
#[test]
fn a_flag_with_a_value_is_the_flag() {
    let plain = run::run(&["code", "parse", "CHA-25A-100-H-C1024", "--json"]).out;
    assert_eq!(run::run(&["code", "parse", "CHA-25A-100-H-C1024", "--json=1"]).out, plain);
    assert!(!run::run(&["code", "parse", "CHA-25A-100-H-C1024", "--json=0"]).out.starts_with('{'));
    let faulty = run::run(&["size", "--json=yes", "x"]);
    assert!(faulty.code == 2 && faulty.out.contains("\"errors\""), "{}{}", faulty.out, faulty.err);
}

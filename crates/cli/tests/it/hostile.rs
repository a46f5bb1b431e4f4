//! Hostile input as a user would meet it: files that claim too much, names that steer a terminal, calls that are wrong.
#![cfg(unix)]
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run;

use quantities::is_unseen;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use testkit::parquet::{FileColumn, claimed_children, file, nested_groups, page, ramp_of_deltas};

/// Address space that a refusal may take, in KiB: a fraction of what the files claim.
const SPACE_KIB: u32 = 400_000;

/// Processor time that a refusal may take unoptimised, in seconds; the system ends a process that takes more. Optimised it is a
/// fifth of that. The time by the clock also depends on the work of others.
const PROCESSOR_S: u32 = 10;

fn antrieb(folder: &Path, arguments: &[&str]) -> Output {
    let script = format!("ulimit -v {SPACE_KIB}; ulimit -t {PROCESSOR_S}; exec \"$0\" \"$@\"");
    let output = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_antrieb")])
        .args(arguments)
        .current_dir(folder)
        .env_remove("ANTRIEB_LANG")
        .env("COLUMNS", "100")
        // Colours as on a terminal: nothing is taken out on the way.
        .env("CLICOLOR_FORCE", "1")
        .stdin(Stdio::null())
        .output()
        .unwrap();
    assert!(output.status.code().is_some(), "{arguments:?}: {}", output.status);
    output
}

/// The reported faults, in JSON; never together with a verdict.
fn faults(folder: &Path, arguments: &[&str]) -> serde_json::Value {
    let output = antrieb(folder, &[arguments, &["--json"]].concat());
    let out = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {out}{}", String::from_utf8_lossy(&output.stderr));
    let found: serde_json::Value =
        serde_json::from_str(&out).unwrap_or_else(|error| panic!("{arguments:?}: {error}: {out}"));
    let errors = found["errors"].as_array().unwrap();
    assert!(!errors.is_empty() && errors.iter().all(|error| error["message"].is_string()), "{found}");
    assert!(found.get("verdict").is_none() && found.get("axes").is_none(), "{found}");
    found["errors"].clone()
}

fn project(files: &[&str]) -> String {
    let segments: String =
        files.iter().map(|file| format!("[[motion]]\nlaw = \"recorded\"\nfile = \"{file}\"\n")).collect();
    format!("format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1 kg m^2\"\n{segments}")
}

/// A folder with a recording and a project that names it once or several times.
fn with_recording(name: &str, bytes: &[u8], times: usize) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join(name), bytes).unwrap();
    fs::write(folder.path().join("axis.toml"), project(&vec![name; times])).unwrap();
    folder
}

#[test]
fn a_parquet_file_that_claims_too_much_is_refused_in_little_memory() {
    let values = 1_i64 << 24;
    let column = |name, codec, packed: &[u8], unpacked| {
        let pages = page(0, values, packed, unpacked);
        FileColumn { name, physical: 5, codec, values, pages }
    };
    let packed = [0x28; 3_000];
    let two_gib = |name| column(name, 6, &packed, i64::from(i32::MAX));
    let gzip = |name| column(name, 2, &packed, 1 << 28);
    let deltas = ramp_of_deltas(1 << 20, 1 << 20);
    let ramp = |name| {
        let pages = page(5, 1 << 20, &deltas, deltas.len() as i64);
        FileColumn { name, physical: 2, codec: 0, values: 1 << 20, pages }
    };
    let cases = [
        ("recording_groups_too_deep", nested_groups(5_000)),
        ("recording_groups_too_deep", nested_groups(10_000)),
        ("recording_parquet_unreadable", claimed_children()),
        ("recording_parquet_unreadable", file(values, &[two_gib("t [s]"), two_gib("q [deg]")])),
        ("recording_page_ratio", file(values, &[gzip("t [s]"), gzip("q [deg]")])),
        ("recording_delta_block", file(1 << 20, &[ramp("t [ms]"), ramp("q [deg]")])),
    ];
    for (id, bytes) in cases {
        let folder = with_recording("run.parquet", &bytes, 4);
        let errors = faults(folder.path(), &["size", "axis.toml"]);
        assert_eq!((errors[0]["id"].as_str(), errors.as_array().unwrap().len()), (Some(id), 1), "{errors}");
    }
}

#[test]
fn the_memory_for_recordings_is_that_of_the_project() {
    let rows: String = (0..60_000).map(|row| format!("{row},0\n")).collect();
    let folder = with_recording("run.csv", format!("t [s],q [deg]\n{rows}").as_bytes(), 3);
    let id = |arguments: &[&str]| faults(folder.path(), arguments)[0]["id"].as_str().unwrap().to_owned();
    // 16 bytes a sample once, 32 for each segment: 6.7 MB.
    assert_eq!(id(&["check", "axis.toml", "--memory", "4 MiB"]), "recording_memory");
    let asked = faults(folder.path(), &["check", "axis.toml", "--memory", "4"]);
    assert_eq!((asked[0]["option"].as_str(), asked[0]["hint"].is_string()), (Some("memory"), true));
    let huge = with_recording("run.csv", b"", 1);
    fs::File::options().write(true).open(huge.path().join("run.csv")).unwrap().set_len(1_100_000_000).unwrap();
    assert_eq!(faults(huge.path(), &["size", "axis.toml"])[0]["id"], "recording_file_too_large");
}

#[test]
fn times_and_positions_of_no_machine_have_no_verdict() {
    for text in [
        "t [s],q [deg],M [Nm]\n0,0,95\n1e307,0,95\n2e307,0,95\n",
        "t [s],q [deg],M [Nm]\n0,1e308,95\n1,1e308,95\n2,1e308,95\n",
    ] {
        let folder = with_recording("run.csv", text.as_bytes(), 1);
        assert_eq!(faults(folder.path(), &["size", "axis.toml"])[0]["id"], "recording_value_implausible");
    }
}

#[test]
fn what_is_no_regular_file_is_refused_and_not_waited_for() {
    let folder = tempfile::tempdir().unwrap();
    assert!(Command::new("mkfifo").arg(folder.path().join("run.csv")).status().unwrap().success());
    for name in ["run.csv", "/dev/zero", "run.parquet/../run.csv"] {
        fs::write(folder.path().join("axis.toml"), project(&[name])).unwrap();
        let errors = faults(folder.path(), &["size", "axis.toml"]);
        assert_eq!(errors[0]["id"], "file_unreadable", "{name}: {errors}");
    }
}

#[test]
fn many_columns_have_a_short_message() {
    let header: String = (0..32_000).map(|_| "q,").collect();
    let folder = with_recording("run.csv", format!("{header}t\n").as_bytes(), 1);
    let output = antrieb(folder.path(), &["size", "axis.toml"]);
    assert!(output.stderr.len() < 2_000, "{}", output.stderr.len());
    let columns: String = (0..9_000).map(|_| "q,").collect();
    let folder = with_recording("run.csv", format!("{columns}t\n").as_bytes(), 1);
    let output = antrieb(folder.path(), &["size", "axis.toml"]);
    assert!(output.stderr.len() < 2_000, "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn the_encoding_that_was_guessed_is_reported() {
    let latin = b"Zeit [s];Winkel [\xb0]\n0;0\n1;0\n2;0\n";
    let folder = with_recording("run.csv", latin, 1);
    let text = antrieb(folder.path(), &["size", "axis.toml"]);
    assert!(String::from_utf8_lossy(&text.stdout).contains("text read as Windows-1252"));
    let json = antrieb(folder.path(), &["size", "axis.toml", "--json"]);
    assert!(String::from_utf8_lossy(&json.stdout).contains("\"encoding\": \"windows1252_guessed\""));
}

/// Requires that no control sequence is left except colours, and none of the user.
fn assert_seen(output: &Output, what: &str) {
    for stream in [&output.stdout, &output.stderr] {
        let text = String::from_utf8(stream.clone()).unwrap();
        assert!(!text.contains("\u{1b}[31mX") && !text.contains("\u{1b}]"), "{what}: {text:?}");
        let unseen = |sign: &char| is_unseen(*sign) && !matches!(sign, '\n' | '\t' | '\u{1b}');
        assert_eq!(text.chars().find(unseen), None, "{what}: {text:?}");
    }
}

#[test]
fn nothing_that_steers_a_terminal_gets_there() {
    const EVIL: &str = "\u{1b}[31mX\u{1b}]0;t\u{7}\u{9b}5m\u{202e}\u{61c}\r";
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let axis = fs::read_to_string(run::root().join("examples/indexing-table.toml")).unwrap();
    fs::write(here.join("axis.toml"), &axis).unwrap();
    let named = format!("axis{EVIL}.toml");
    fs::write(here.join(&named), "format = 2\n").unwrap();
    fs::write(here.join("key.toml"), format!("format = 1\n\"k{EVIL}\" = 1\nname{EVIL} = 2\n")).unwrap();
    fs::write(here.join("long.toml"), format!("format = 1\n\"k{EVIL}\" = \"{}{EVIL}\"\n", "x".repeat(500))).unwrap();
    fs::write(here.join("name.toml"), axis.replace("indexing table", "a\u{9b}\u{202e}b")).unwrap();
    fs::write(here.join("file.toml"), project(&["a\\u009b\\u202e.csv"])).unwrap();
    let out = format!("{EVIL}.svg");
    let calls: [&[&str]; 17] = [
        &["size", &named],
        &["size", "key.toml"],
        &["size", "long.toml"],
        &["size", "name.toml"],
        &["size", "file.toml"],
        &["size", EVIL],
        &["size", "axis.toml", "--axis", EVIL],
        &["size", "axis.toml", "--memory", EVIL],
        &["check", "axis.toml", "--code", EVIL],
        &["export", "axis.toml", "--table", EVIL],
        &["export", "axis.toml", "--date", EVIL, "--out", EVIL],
        &["plot", "axis.toml", "--figure", EVIL],
        &["report", "axis.toml", "--out", EVIL],
        &["curve", "CHA-20A-100-H-C1024", "--voltage", EVIL],
        &["man", EVIL],
        &[EVIL],
        &["size", "axis.toml", "--\u{1b}[31mX"],
    ];
    for call in calls {
        for more in [&[][..], &["--json"], &["--lang", "de"]] {
            let output = antrieb(here, &[call, more].concat());
            assert_eq!(output.status.code(), Some(2), "{call:?}: {}", String::from_utf8_lossy(&output.stderr));
            assert_seen(&output, &format!("{call:?} {more:?}"));
        }
    }
    // A name is shown where it was written too.
    let written = antrieb(here, &["curve", "CHA-20A-100-H-C1024", "--svg", &out]);
    assert_eq!(written.status.code(), Some(0));
    assert_seen(&written, "a file written");
    assert!(String::from_utf8_lossy(&written.stdout).contains("\\u{9b}5m\\u{202e}"));
}

#[test]
fn whoever_asks_for_json_gets_every_fault_as_json() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    let axis = fs::read_to_string(run::root().join("examples/indexing-table.toml")).unwrap();
    fs::write(here.join("axis.toml"), axis).unwrap();
    let calls: [&[&str]; 12] = [
        &["size", "axis.toml", "--top", "0"],
        &["size", "axis.toml", "--top"],
        &["size"],
        &[],
        &["siz"],
        &["size", "axis.toml", "--tpo", "1"],
        &["size", "axis.toml", "--top", "1", "--top", "2"],
        &["size", "axis.toml", "--report", "no/x.pdf"],
        &["size", "axis.toml", "--report", "-"],
        &["export", "axis.toml", "--out", "no/x.xlsx"],
        &["man", "siz"],
        &["size", "axis.toml", "--memory", "1"],
    ];
    for call in calls {
        let english = faults(here, call);
        let german = faults(here, &[call, &["--lang", "de"]].concat());
        assert_ne!(english[0]["message"], german[0]["message"], "{call:?}");
    }
    assert_eq!(faults(here, &["size", "axis.toml", "--top", "0"])[0]["option"], "top");
    assert_eq!(faults(here, &["siz"])[0]["hint"], "did you mean `size`?");
    let long = "x".repeat(201);
    assert_eq!(faults(here, &["report", "axis.toml", "--out", "a.pdf", "--title", &long])[0]["option"], "title");
    assert_eq!(fs::read_dir(here).unwrap().count(), 1, "nothing was written");
}

/// Long work is not started without a deadline, which every form of the answer reports.
#[test]
fn reserves_of_a_long_recording_under_losses_are_not_sought_unasked() {
    let rows: String = (0..=50_001_u32)
        .map(|k| {
            let t = f64::from(k) / 1000.0;
            format!("{t:.3},{:.6}\n", (1.0 - (t * std::f64::consts::TAU / 25.0005).cos()) * 0.4)
        })
        .collect();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("swing.csv"), format!("time [s],position [rad]\n{rows}")).unwrap();
    let text = "format = 1\n[axis]\nsingle_move = true\n[mechanism.arm]\ninertia = \"0.5 kg m^2\"\nmass = \"2 kg\"\n\
                centre_distance = \"100 mm\"\naxis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\nefficiency = 0.9\n\
                [[motion]]\nlaw = \"recorded\"\nfile = \"swing.csv\"\n";
    fs::write(folder.path().join("axis.toml"), text).unwrap();
    let check = ["check", "axis.toml", "--code", "CHA-25A-100-H-C1024", "--lang", "en"];
    let run = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        let output = command.args(check).args(more).current_dir(folder.path()).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let reply = run(&[]).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(reply.contains("not searched: other loads and cycle times"), "{reply}");
    // Beside each sample three instants of the loads on the flange, of which each counts a quarter.
    assert!(reply.contains("87502 recorded samples") && reply.contains("--deadline"), "{reply}");
    let found: serde_json::Value = serde_json::from_str(&run(&["--json"])).unwrap();
    let reserve = &found["reserve"];
    assert_eq!(reserve["not_sought"]["samples"], 50_002 + 50_001 * 3 / 4, "{reserve}");
    assert_eq!(reserve["not_sought"]["quantities"][2], "cycle_time", "{reserve}");
    assert!(reserve["cycle_time"].is_null() && reserve["ambient"].is_number(), "{reserve}");
}

/// A recording `swing.csv` of so many intervals: twenty times up and down by 0.4 rad within a time \[s\].
fn swing(folder: &Path, count: u32, seconds: f64) {
    let row = |k: u32| {
        let share = f64::from(k) / f64::from(count);
        format!("{:.6},{:.9}\n", share * seconds, (1.0 - (share * 20.0 * std::f64::consts::TAU).cos()) * 0.2)
    };
    let rows: String = (0..=count).map(row).collect();
    fs::write(folder.join("swing.csv"), format!("time [s],position [rad]\n{rows}")).unwrap();
}

/// Beyond what is answered within five seconds a time has to be named; within it the answer is given.
#[test]
fn longer_recordings_than_are_judged_unasked_are_refused_by_their_number() {
    // Up and down by 0.4 rad, once a second: every segment begins where the one before it ended.
    let count = 52_429_u32;
    let folder = tempfile::tempdir().unwrap();
    swing(folder.path(), count, 20.0);
    let segment = "[[motion]]\nlaw = \"recorded\"\nfile = \"swing.csv\"\n";
    let axis = |segments: usize| {
        let head = "format = 1\n[axis]\nsingle_move = true\n[mechanism.arm]\ninertia = \"0.5 kg m^2\"\nmass = \"2 kg\"\n\
                    centre_distance = \"100 mm\"\naxis_tilt = \"90 deg\"\nstart_angle = \"0 deg\"\n";
        fs::write(folder.path().join("axis.toml"), format!("{head}{}", segment.repeat(segments))).unwrap();
    };
    let run = |args: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        let output = command.args(args).current_dir(folder.path()).output().unwrap();
        (output.status.code().unwrap(), serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap())
    };
    // The weight counts each sample twice, and the loads on the flange a little more.
    let refused = |args: &[&str], (samples, plain, seconds): (&str, usize, &str)| {
        let (code, reply) = run(args);
        let message = reply["errors"][0]["message"].as_str().unwrap();
        assert_eq!((code, reply.as_object().unwrap().len()), (2, 1), "{reply}");
        for part in [samples, seconds, "--deadline"] {
            assert!(message.contains(part), "{args:?}: {message}");
        }
        let most = message.split_once("at most ").and_then(|(_, rest)| rest.split(' ').next()?.parse::<usize>().ok());
        let most = most.unwrap_or_else(|| panic!("{message}"));
        assert!((9 * plain / 20..=plain / 2).contains(&most), "{args:?}: {message}");
    };
    axis(20);
    refused(&["size", "axis.toml", "--json"], ("1048600", 1 << 21, "5 seconds"));
    refused(&["report", "axis.toml", "--json", "--out", "axis.pdf"], ("1048600", 1 << 21, "10 seconds"));
    assert!(!folder.path().join("axis.pdf").exists());
    // What else there is may take twice as long: together the two revisions are more than that.
    refused(&["diff", "axis.toml", "axis.toml", "--json"], ("2097200", 1 << 22, "10 seconds"));
    axis(40);
    let explain = ["explain", "axis.toml", "--json", "--code", "CHA-25A-100-H-C1024"];
    refused(&explain, ("2097200", 1 << 22, "10 seconds"));
    refused(&["export", "axis.toml", "--json", "--out", "axis.xlsx"], ("2097200", 1 << 20, "10 seconds"));
    assert!(!folder.path().join("axis.xlsx").exists());
    axis(20);
    let check = ["check", "axis.toml", "--json", "--code", "CHA-25A-100-H-C1024"];
    let (code, reply) = run(&[&check[..], &["--deadline", "0.001 s"]].concat());
    let message = reply["errors"][0]["message"].as_str().unwrap();
    assert!(code == 2 && message.contains("no answer within 0.001"), "{reply}");
    axis(1);
    assert!(run(&check).0 < 2);
}

/// Tolerances and stage ratios that would recompute a long recording many times are not started without a deadline.
#[test]
fn what_makes_a_long_recording_anew_is_counted_before() {
    let count = 100_000_u32;
    let folder = tempfile::tempdir().unwrap();
    swing(folder.path(), count, 100.0);
    let write = |name: &str, inertia: &str, tables: &str, segments: usize| {
        let segment = "[[motion]]\nlaw = \"recorded\"\nfile = \"swing.csv\"\n".repeat(segments);
        let head = format!("format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"{inertia}\"\n{tables}");
        fs::write(folder.path().join(name), format!("{head}{segment}")).unwrap();
    };
    // The unoptimised program takes seconds to read so much.
    let refused = |call: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        let output = command.args(call).arg("--json").current_dir(folder.path()).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        let reply: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        reply["errors"][0]["message"].as_str().unwrap().to_owned()
    };
    write("uncertain.toml", "0.5 kg m^2 ± 5 %", "", 3);
    let message = refused(&["check", "uncertain.toml", "--code", "CHA-25A-100-H-C1024"]);
    assert!(message.starts_with("100 samples of these tolerances") && message.contains("--deadline"), "{message}");
    let ratios = "[stage]\nkind = \"belt\"\nratios = [1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2.0]\nefficiency = 0.95\n";
    write("ratios.toml", "0.5 kg m^2", ratios, 2);
    let message = refused(&["size", "ratios.toml"]);
    assert!(message.contains("each of 11 stage ratios") && message.contains("--deadline"), "{message}");
    // A quarter of one of them is not long.
    write("part.toml", "0.5 kg m^2", ratios, 1);
    let text = fs::read_to_string(folder.path().join("part.toml")).unwrap();
    fs::write(folder.path().join("part.toml"), text + "to = \"25 s\"\n").unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
    let explain = ["explain", "part.toml", "--code", "CHA-25A-100-H-C1024", "--check", "peak_torque"];
    assert_eq!(command.args(explain).current_dir(folder.path()).output().unwrap().status.code(), Some(0));
}

/// Axes are counted together: each is quick, all of them are not.
#[test]
fn more_axes_than_are_answered_in_time_are_refused_by_their_number() {
    let folder = tempfile::tempdir().unwrap();
    let axis = |number: u32| {
        format!(
            "[[axis]]\nname = \"a{number}\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"manual\"\n\
             speed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n"
        )
    };
    let project = |axes: u32| format!("format = 1\n{}", (1..=axes).map(axis).collect::<String>());
    fs::write(folder.path().join("many.toml"), project(600)).unwrap();
    fs::write(folder.path().join("some.toml"), project(60)).unwrap();
    let code = ["--code", "CHA-32A-50-H-C1024"];
    let calls: [(&[&str], &str); 5] = [
        (&["size", "many.toml"], "600 axes together take more than about 5 seconds"),
        (&["check", "many.toml", code[0], code[1]], "600 axes together take more than about 5 seconds"),
        (&["explain", "many.toml", code[0], code[1]], "600 axes together take more than about 10 seconds"),
        (&["diff", "many.toml", "some.toml"], "660 axes together take more than about 10 seconds"),
        (&["report", "some.toml", "--out", "some.pdf"], "60 axes together take more than about 10 seconds"),
    ];
    for (call, wanted) in calls {
        let errors = faults(folder.path(), call);
        let message = errors[0]["message"].as_str().unwrap();
        assert!(message.contains(wanted), "{call:?}: {message}");
        assert!(message.contains("--axis") && message.contains("--deadline"), "{message}");
    }
    // One of them by its name, and all where a time is named.
    for more in [&["--axis", "a599"][..], &["--deadline", "60 s"]] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        let call = [&["explain", "many.toml", code[0], code[1], "--check", "peak_torque"], more].concat();
        let output = command.args(call).current_dir(folder.path()).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{more:?}");
    }
}

/// The steps of a simulation are counted over all axes, before an actuator is judged.
#[test]
fn the_steps_of_all_axes_are_counted_together() {
    let folder = tempfile::tempdir().unwrap();
    let axis = |number: u32| {
        format!(
            "[[axis]]\nname = \"a{number}\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"manual\"\n\
             speed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n"
        )
    };
    let project = |axes: u32| format!("format = 1\n{}", (1..=axes).map(axis).collect::<String>());
    fs::write(folder.path().join("axes.toml"), project(60)).unwrap();
    let code = ["--code", "CHA-32A-50-H-C1024"];
    let begun = std::time::Instant::now();
    let errors = faults(folder.path(), &["simulate", "axes.toml", code[0], code[1]]);
    // 1.3 s at 16 kHz and six steps, up to eight more cycles for the settled state: 1.1 million steps of each.
    let message = errors[0]["message"].as_str().unwrap();
    assert!(message.starts_with("7\u{a0}488\u{a0}000 steps and up to 59\u{a0}904\u{a0}000"), "{message}");
    assert!(["--cold", "--axis", "--deadline"].iter().all(|each| message.contains(each)), "{message}");
    assert!(begun.elapsed() < std::time::Duration::from_secs(20), "{:?}", begun.elapsed());
}

/// A table of the course holds every sample: it is made within the memory that is allowed, and a workbook does without it.
#[test]
fn a_table_of_a_long_course_is_held_to_the_memory() {
    let count = 200_010_u32;
    let folder = tempfile::tempdir().unwrap();
    swing(folder.path(), count, 200.0);
    let text = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"0.5 kg m^2\"\n\
                [[motion]]\nlaw = \"recorded\"\nfile = \"swing.csv\"\n";
    fs::write(folder.path().join("axis.toml"), text).unwrap();
    let run = |args: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
        let code = ["export", "axis.toml", "--json", "--code", "CHA-25A-100-H-C1024", "--top", "1"];
        let output = command.args(code).args(args).current_dir(folder.path()).output().unwrap();
        (output.status.code().unwrap(), serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap())
    };
    for (ending, needed) in [("csv", "98 MiB"), ("json", "196 MiB"), ("parquet", "98 MiB")] {
        let name = format!("course.{ending}");
        let (code, reply) = run(&["--table", "course", "--out", &name, "--memory", "50 MiB"]);
        let message = reply["errors"][0]["message"].as_str().unwrap();
        assert_eq!((code, reply.as_object().unwrap().len()), (2, 1), "{reply}");
        for part in ["400020 rows", needed, "50 MiB", "--memory"] {
            assert!(message.contains(part), "{message}");
        }
        assert!(!folder.path().join(name).exists());
    }
    let (_, reply) = run(&["--table", "course", "--out", "course.csv", "--memory", "98 MiB"]);
    let rows = reply["tables"][0]["rows"].as_u64().unwrap();
    assert!((200_011..=400_020).contains(&rows), "{reply}");
    let lines = fs::read_to_string(folder.path().join("course.csv")).unwrap().lines().count();
    assert_eq!(lines as u64, rows + 1);
    let (_, reply) = run(&["--out", "all.xlsx", "--memory", "50 MiB"]);
    assert!(reply["tables"].as_array().unwrap().iter().all(|table| table["name"] != "course"), "{reply}");
    assert_eq!(reply["left_out"], serde_json::json!([{ "name": "course", "rows": 400_020 }]));
    assert!(fs::metadata(folder.path().join("all.xlsx")).unwrap().len() < 1 << 20);
}

#[test]
fn an_axis_that_cannot_be_answered_has_no_verdict_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let axis = |name: &str, own: &str| {
        format!(
            "[[axis]]\nname = \"{name}\"\n[axis.load]\ninertia = \"1 kg m^2\"\n[[axis.motion]]\nlaw = \"manual\"\n\
             speed = \"40 1/min\"\naccelerate = \"0.1 s\"\nrun = \"0.1 s\"\nbrake = \"0.1 s\"\npause = \"1 s\"\n{own}"
        )
    };
    let text = format!("format = 1\n{}{}", axis("one", ""), axis("two", ""));
    fs::write(folder.path().join("two-axes.toml"), text).unwrap();
    // Nothing is known of this actuator.
    let errors = faults(folder.path(), &["check", "two-axes.toml", "--code", "CHA-58A-50-H-RES"]);
    assert_eq!(errors.as_array().unwrap().len(), 1, "the same fault of both axes is reply once: {errors}");
}

/// Whatever reads a file of columns refuses the same claims in as little memory and time: recordings, tables of a sweep, recorded runs.
#[test]
fn no_entry_takes_a_file_at_its_word() {
    let values = 1_i64 << 24;
    let packed = [0x28; 3_000];
    let column = |name, codec, unpacked| FileColumn {
        name,
        physical: 5,
        codec,
        values,
        pages: page(0, values, &packed, unpacked),
    };
    let (of_run, of_table) = (["time_s", "position_rad"], ["load.inertia [kg m^2]", "load.friction_torque [N m]"]);
    let of_two =
        |names: [&'static str; 2], codec, unpacked| file(values, &names.map(|name| column(name, codec, unpacked)));
    let mut cases: Vec<(&str, Vec<u8>)> = vec![
        ("groups.parquet", nested_groups(10_000)),
        ("children.parquet", claimed_children()),
        ("nothing.parquet", b"PAR1".to_vec()),
        ("commas.csv", vec![b','; 20 << 20]),
        ("quotes.csv", [b"time_s,position_rad\n".to_vec(), vec![b'"'; 20 << 20]].concat()),
        ("lines.csv", [b"time_s,position_rad\n".to_vec(), b"x\n".repeat(1 << 22)].concat()),
        (
            "cells.csv",
            [b"load.inertia [kg m^2],load.friction_torque [N m]\n".to_vec(), b"x,y\n".repeat(1 << 21)].concat(),
        ),
    ];
    for names in [of_run, of_table] {
        cases.push(("zstd.parquet", of_two(names, 6, i64::from(i32::MAX))));
        cases.push(("gzip.parquet", of_two(names, 2, 1 << 28)));
    }
    let folder = tempfile::tempdir().unwrap();
    let axis = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"1 N m\"\n[[motion]]\nlaw = \"polynomial_5\"\n\
                distance = \"90 deg\"\ntime = \"1 s\"\n";
    fs::write(folder.path().join("axis.toml"), axis).unwrap();
    for (name, bytes) in cases {
        fs::write(folder.path().join(name), bytes).unwrap();
        fs::write(folder.path().join("recorded.toml"), project(&[name])).unwrap();
        let calls: [&[&str]; 3] = [
            &["size", "recorded.toml"],
            &["sweep", "axis.toml", "--table", name, "--out", "out.csv"],
            &["identify", name, "axis.toml", "--code", "CHA-25A-100-H-C1024"],
        ];
        for call in calls {
            let errors = faults(folder.path(), call);
            let length: usize = errors.as_array().unwrap().iter().map(|error| error.to_string().len()).sum();
            assert!(length < 20_000, "{call:?}: {length} characters");
            // What is wrong throughout is not read to its end.
            if call[0] == "sweep" && name == "cells.csv" {
                let last = errors.as_array().unwrap().last().unwrap()["message"].as_str().unwrap();
                assert_eq!(last, "and 10000 more faults; the rest of the table was not checked");
            }
            // Nor are many rows below headings of which some are none.
            assert!(call[0] != "sweep" || name != "lines.csv" || errors.as_array().unwrap().len() <= 60, "{errors}");
        }
        assert!(!folder.path().join("out.csv").exists());
    }
}

/// A run that unpacks to more than the project may hold, or that never ends, is refused while it is read.
#[test]
fn a_packed_run_is_held_to_the_memory() {
    let folder = tempfile::tempdir().unwrap();
    let axis = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n";
    fs::write(folder.path().join("axis.toml"), axis).unwrap();
    let head = b"time_s;position_rad;motor_speed_rad_s;torque_nm;current_q_a\n".to_vec();
    let packed = |row: &[u8]| {
        let mut packer = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        std::io::Write::write_all(&mut packer, &[head.clone(), row.repeat(100_000)].concat()).unwrap();
        packer.finish().unwrap()
    };
    let id = |name: &str, bytes: Vec<u8>| {
        fs::write(folder.path().join(name), bytes).unwrap();
        let call = ["identify", name, "axis.toml", "--code", "CHA-25A-100-H-C1024", "--memory", "4 MiB"];
        faults(folder.path(), &call)[0]["message"].as_str().unwrap().to_owned()
    };
    let message = id("run.csv.gz", packed(b"0;0;0;0;0\n"));
    assert!(message.contains("MiB") || message.contains("bytes of memory"), "{message}");
    assert!(id("notes.csv.gz", packed(b"# x\n")).contains("few samples"));
    assert!(id("run.xlsx", b"PK\x03\x04".repeat(100)).contains("zip"), "a workbook is named");
}

/// `--force` replaces the file that is named, not a recording beside it that the user has made.
#[test]
fn a_recording_beside_a_new_project_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let new = ["new", "recording", "--out", "axis.toml", "--force"];
    let code = |more: &[&str]| antrieb(folder.path(), &[&new[..], more].concat()).status.code();
    assert_eq!((code(&[]), code(&[])), (Some(0), Some(0)), "the example's own is written again");
    let beside = folder.path().join("axis.csv");
    assert!(beside.is_file());
    let own = "t [s],q [deg]\n0,1\n1,2\n2,1\n";
    fs::write(&beside, own).unwrap();
    let errors = faults(folder.path(), &new);
    assert!(errors[0]["file"].as_str().unwrap().ends_with("axis.csv"), "{errors}");
    assert_eq!(errors[0]["message"], "the file already exists");
    assert_eq!(fs::read_to_string(&beside).unwrap(), own);
}

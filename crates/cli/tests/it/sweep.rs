//! `sweep` and `new sweep` as a script uses them.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run;

use run::run;
use serde_json::Value;
use std::fmt::Write as _;
use std::io::Read as _;
use std::path::Path;
use std::time::{Duration, Instant};

const MOVE: &str = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\n\
    law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"0.5 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n";

fn path(folder: &Path, name: &str) -> String {
    folder.join(name).display().to_string()
}

fn put(folder: &Path, name: &str, text: &str) -> String {
    std::fs::write(folder.join(name), text).unwrap();
    path(folder, name)
}

#[test]
fn a_written_table_is_answered_in_both_formats_alike() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table = path(folder, "tasks.csv");
    let keys = ["--key", "load.inertia [kg m^2] = 0.1..300 log", "--key", "motion[1].time [s] = 0.05..2"];
    let new = [&["new", "sweep", "--samples", "40", "--out", &table][..], &keys].concat();
    assert_eq!(run(&new).code, 0);
    let text = std::fs::read_to_string(&table).unwrap();
    assert_eq!(text.lines().next(), Some("load.inertia [kg m^2],motion[1].time [s]"));
    assert_eq!(text.lines().count(), 41);
    let (csv, parquet) = (path(folder, "best.csv"), path(folder, "best.parquet"));
    let first = run(&["sweep", &axis, "--table", &table, "--out", &csv]);
    assert_eq!(first.code, 0, "{}", first.err);
    assert!(first.out.contains("40 rows") && first.err.contains("motion[1].time"), "{} {}", first.out, first.err);
    let answers = std::fs::read_to_string(&csv).unwrap();
    assert_eq!(answers.lines().next(), Some("row,fit,code,utilisation,tightest,error,fit_if_estimate"));
    assert!(answers.lines().skip(1).any(|line| line.contains("CHA-")));
    let second = run(&["sweep", &axis, "--table", &table, "--out", &parquet, "--json"]);
    let record: Value = serde_json::from_str(&second.out).unwrap();
    assert_eq!(record["rows"], 40);
    assert!(record["fitting"].as_u64().unwrap() > 5 && !record["none_fits"].as_array().unwrap().is_empty(), "{record}");
    // What was written is a table again; of its headings `code` alone is a key, and empty where nothing
    // fits; the others would stand twice in the answer.
    let again = run(&["sweep", &axis, "--table", &parquet, "--out", &path(folder, "x.csv"), "--json"]);
    let faults: Value = serde_json::from_str(&again.out).unwrap();
    let faults = faults["errors"].as_array().unwrap();
    let of = |id: &str| faults.iter().filter(|fault| fault["id"] == id).count();
    let empty = 40 - usize::try_from(record["fitting"].as_u64().unwrap()).unwrap();
    assert_eq!((again.code, of("column_twice"), of("no_value"), faults.len()), (2, 6, empty, 6 + empty), "{faults:?}");
    assert!(faults.iter().filter(|fault| fault["id"] == "no_value").all(|fault| fault["heading"] == "code"));
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 4, "nothing else is left");
    // A name that ends in .csv.gz is packed; another packing is refused.
    let packed = path(folder, "best.csv.gz");
    assert_eq!(run(&["sweep", &axis, &table, &packed]).code, 0);
    let mut unpacked = String::new();
    let file = std::fs::File::open(&packed).unwrap();
    let _ = flate2::read::GzDecoder::new(file).read_to_string(&mut unpacked).unwrap();
    assert_eq!(unpacked, answers);
    let other = run(&["sweep", &axis, "--table", &table, "--out", &path(folder, "best.csv.zst")]);
    assert!(other.code == 2 && other.err.contains(".csv.gz"), "{}", other.err);
}

#[test]
fn every_fault_of_a_table_is_reported_with_heading_and_row() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table = put(
        folder,
        "tasks.csv",
        "load.inertia [kg m^2],motion[1].law,code\n1,trapezoid,CHA-25A-50-H-C1024\nheavy,trapezoyd,CHA-25A-50-H-C1025\n,constant,\n",
    );
    let out = path(folder, "best.csv");
    let found = run(&["sweep", &axis, "--table", &table, "--out", &out]);
    assert_eq!(found.code, 2);
    insta::assert_snapshot!("faults_of_cells", found.err.replace(&folder.display().to_string(), ""));
    let table = put(
        folder,
        "heads.csv",
        "load.inerta [kg m^2],load.friction_torque,motion[1].time [kg],motion[5].time [s]\n1,1,1,1\n",
    );
    let found = run(&["sweep", &axis, "--table", &table, "--out", &out]);
    insta::assert_snapshot!("faults_of_headings", found.err.replace(&folder.display().to_string(), ""));
    let table = put(folder, "empty.csv", "load.inertia [kg m^2]\n");
    assert!(run(&["sweep", &axis, "--table", &table, "--out", &out]).err.contains("no row"));
    assert!(!Path::new(&out).exists());
}

/// Faults of the project, of the headings, of the cells under those that are read, of a line and of the place of the answers.
#[test]
fn faults_of_project_table_and_answers_are_reported_together() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", &MOVE.replace("90 deg", "90 kg"));
    let table = put(
        folder,
        "tasks.csv",
        "load.inerta [kg m^2],motion[1].time [s],motion[8].time [s],code\n\
         1,heavy,1,CHA-25A-50-H-C1025\n1,0.5\n1,,1,CHA-25A-50-H-C1024\n",
    );
    let found = run(&["sweep", &axis, "--table", &table, "--out", &path(folder, "best.txt")]);
    assert_eq!(found.code, 2);
    insta::assert_snapshot!("faults_of_everything", found.err.replace(&folder.display().to_string(), ""));
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 2, "nothing is written");
}

/// No axis is named among several, beside what is wrong with the table; then a name that no axis has.
#[test]
fn an_axis_that_is_not_named_is_reported_beside_the_faults_of_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let table = put(folder, "tasks.csv", "motion[1].payload [kg],motion[1].tyme [s]\nmuch,1\n");
    let out = path(folder, "best.csv");
    for axis in [[].as_slice(), &["--axis", "none"]] {
        let call = [&["sweep", "examples/two-axes.toml", "--table", &table, "--out", &out, "--json"], axis].concat();
        let found = run(&call);
        let faults: Value = serde_json::from_str(&found.out).unwrap();
        let faults = faults["errors"].as_array().unwrap();
        assert_eq!((found.code, faults.len()), (2, 3), "{faults:?}");
        assert!(faults[0]["message"].as_str().unwrap().contains("swivel, lift"), "{faults:?}");
        assert_eq!(
            (faults[1]["id"].as_str(), faults[1]["heading"].as_str()),
            (Some("unknown_key"), Some("motion[1].tyme [s]"))
        );
        assert_eq!((faults[2]["id"].as_str(), faults[2]["row"].as_u64()), (Some("not_a_number"), Some(0)));
    }
}

/// A table as spreadsheets write it: the answers have the same bytes in every dialect.
#[test]
fn a_table_is_answered_alike_in_every_dialect() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table =
        "load.inertia [kg m^2],load.friction_torque [N·m],motion[1].law\n0.5,5.25,trapezoid\n1,5,polynomial_5\n";
    let german =
        |sign: &str| table.replace(',', sign).replace('.', ",").replace("load,", "load.").replace("],law", "].law");
    let utf16 = |text: &str| "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let windows = |text: &str| text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect::<Vec<u8>>();
    let out = path(folder, "best.csv");
    let answered = |name: &str, bytes: &[u8]| {
        let tasks = folder.join("tasks.csv");
        std::fs::write(&tasks, bytes).unwrap();
        let found = run(&["sweep", &axis, "--table", tasks.to_str().unwrap(), "--out", &out, "--force"]);
        assert_eq!(found.code, 0, "{name}: {}", found.err);
        std::fs::read_to_string(&out).unwrap()
    };
    let expected = answered("plain", table.as_bytes());
    assert!(expected.lines().count() == 3 && !expected.contains(';'), "{expected}");
    let dialects: [(&str, Vec<u8>); 6] = [
        ("semicolons", table.replace(',', ";").into_bytes()),
        ("decimal commas", german(";").into_bytes()),
        ("tabs and decimal commas", german("\t").into_bytes()),
        ("a line that names the separator", format!("sep=;\r\n{}", german(";").replace('\n', "\r\n")).into_bytes()),
        ("UTF-16", utf16(&german("\t"))),
        ("Windows-1252", windows(&german(";"))),
    ];
    for (name, bytes) in dialects {
        assert_eq!(answered(name, &bytes), expected, "{name}");
    }
    // A thousand or a unit and a fraction: refused, and so are groups of thousands.
    for (cell, id) in [("1.234", "decimal_mixed"), ("1.234,5", "not_a_number"), ("1,234,5", "not_a_number")] {
        let table = put(
            folder,
            "mixed.csv",
            &format!("load.inertia [kg m^2];load.friction_torque [N m]\n0,5;5,5\n{cell};5,0\n"),
        );
        let found = run(&["sweep", &axis, "--table", &table, "--out", &out, "--force", "--json"]);
        let faults: Value = serde_json::from_str(&found.out).unwrap();
        let fault = &faults["errors"][0];
        assert_eq!(
            (found.code, fault["id"].as_str(), fault["row"].as_u64()),
            (2, Some(id), Some(1)),
            "{cell}: {faults}"
        );
    }
}

/// A heading means the same segment whatever other columns there are; where one counts from zero each is answered with its new form.
#[test]
fn headings_count_from_one_and_the_old_form_is_refused_with_the_new_one() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let out = path(folder, "best.csv");
    let heads = "load.inertia [kg m^2],motion[0].time [s],motion[1].time [ms],motion[0].law";
    let table = put(folder, "tasks.csv", &format!("{heads}\n1,0.5,400,trapezoid\n"));
    let found = run(&["sweep", &axis, "--table", &table, "--out", &out, "--json"]);
    let faults: Value = serde_json::from_str(&found.out).unwrap();
    let each = |key: &str| -> Vec<String> {
        faults["errors"].as_array().unwrap().iter().map(|fault| fault[key].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(each("heading"), ["motion[0].time [s]", "motion[1].time [ms]", "motion[0].law"]);
    assert_eq!(each("id"), ["counts_from_zero"; 3]);
    let hints = each("hint");
    for (hint, now) in hints.iter().zip(["motion[1].time [s]", "motion[2].time [ms]", "motion[1].law"]) {
        assert!(hint.contains(now), "{hint}");
    }
    let now = heads.replace("[1]", "[2]").replace("[0]", "[1]");
    let table = put(folder, "tasks.csv", &format!("{now}\n1,0.5,400,trapezoid\n"));
    assert_eq!(run(&["sweep", &axis, "--table", &table, "--out", &out]).code, 0);
    // Fewer columns: the second segment stays the second.
    let fewer = put(folder, "fewer.csv", "motion[2].time [ms]\n400\n");
    let said = run(&["sweep", &axis, "--table", &fewer, "--out", &path(folder, "fewer-best.csv")]);
    assert!(said.code == 0 && said.err.contains("motion[2].time"), "{}", said.err);
    let wrong = put(folder, "wrong.csv", "motion[3].time [s],motion[1].time [s]\n1,-\n");
    let said = run(&["sweep", &axis, "--table", &wrong, "--out", &out, "--force"]);
    assert!(
        said.err.contains("`motion[3].time`: the project has no such entry") && said.err.contains("`motion[1].time`: "),
        "{}",
        said.err
    );
    let both = run(&["sweep", &axis, "--table", &fewer, "--out", &out, "--force", "--front", "--check", "thermal"]);
    assert!(both.code == 2 && both.err.contains("exclude each other"), "{}", both.err);
}

#[test]
fn a_single_row_is_spoken_of_in_the_singular() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table = put(folder, "tasks.csv", "load.inertia [kg m^2]\n1\n");
    let call = ["sweep", &axis, "--table", &table, "--out", &path(folder, "best.csv"), "--force"];
    assert!(run(&call).out.contains("best.csv: 1 row\nan actuator fits: 1 row (100.0 %)\n"));
    let german = run(&[&call[..], &["--lang", "de"]].concat()).out;
    assert!(german.contains("best.csv: 1 Zeile\nein Antrieb ist geeignet: 1 Zeile (100,0 %)\n"), "{german}");
}

/// Returns the answer of `size` for a project with one axis, or for the named axis.
fn sized(file: &str, axis: Option<&str>) -> Value {
    let axis: Vec<&str> = axis.into_iter().flat_map(|name| ["--axis", name]).collect();
    let found = run(&[&["size", file, "--top", "1", "--json"], &axis[..]].concat());
    let answer: Value = serde_json::from_str(&found.out).unwrap();
    answer.get("axes").map_or(answer.clone(), |axes| axes[0].clone())
}

/// Compares each row of a table with the answer of `size` to the file edited by hand: ambient data, a load moved by a
/// recording, the second axis of several.
#[test]
fn a_row_has_the_digits_of_size_with_the_edited_file() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let example = |name: &str| std::fs::read_to_string(run::root().join("examples").join(name)).unwrap();
    std::fs::copy(run::root().join("examples/robot-joint.csv"), folder.join("robot-joint.csv")).unwrap();
    // A turn of 90° and back with an acceleration that is smooth, recorded every 5 ms.
    let turn = |t: f64| 45.0 * (1.0 - (std::f64::consts::TAU * t / 2.0).cos());
    let samples: String = (0..=400).map(|n| f64::from(n) * 0.005).map(|t| format!("{t:.3},{:.6}\n", turn(t))).collect();
    put(folder, "turn.csv", &format!("time [s],position [deg]\n{samples}"));
    let recorded = "format = 1\n[load]\ninertia = \"1 kg m^2\"\nfriction_torque = \"5 N m\"\n[[motion]]\nlaw = \"recorded\"\n\
        file = \"turn.csv\"\n";
    // The file, the axis, and of each column its heading, the text of the file and the values of the rows.
    type Column = (&'static str, &'static str, [&'static str; 3]);
    let cases: [(String, Option<&str>, Vec<Column>); 4] = [
        (
            example("indexing-table.toml"),
            None,
            vec![
                ("requirements.ambient [degC]", "ambient = \"35 degC\"", ["-5", "20", "39.5"]),
                ("requirements.supply [V]", "supply = \"560 V\"", ["100", "325", "560"]),
            ],
        ),
        (
            example("robot-joint.toml"),
            None,
            vec![
                ("mechanism.joint.inertia [kg m^2]", "inertia = \"1.4 kg m^2\"", ["0.2", "1.4", "90"]),
                ("mechanism.joint.holding_torque [N m]", "holding_torque = \"30 N m\"", ["5", "30", "60"]),
            ],
        ),
        (
            recorded.to_owned(),
            None,
            vec![
                ("load.inertia [kg m^2]", "inertia = \"1 kg m^2\"", ["0.1", "3", "2000"]),
                ("load.friction_torque [N m]", "friction_torque = \"5 N m\"", ["0", "7", "2"]),
            ],
        ),
        (
            example("two-axes.toml"),
            Some("lift"),
            vec![
                ("mechanism.belt.mass [kg]", "mass = \"9 kg\"", ["4", "9", "900"]),
                ("mechanism.belt.friction_force [N]", "friction_force = \"25 N\"", ["0", "40", "25"]),
            ],
        ),
    ];
    let (mut fitting, mut codes) = (0, std::collections::BTreeSet::new());
    for (text, axis, columns) in &cases {
        let file = put(folder, "axis.toml", text);
        let mut table = columns.iter().map(|(heading, ..)| *heading).collect::<Vec<_>>().join(",");
        for row in 0..3 {
            write!(table, "\n{}", columns.iter().map(|(.., values)| values[row]).collect::<Vec<_>>().join(","))
                .unwrap();
        }
        let (tasks, out) = (put(folder, "tasks.csv", &table), path(folder, "best.csv"));
        let named: Vec<&str> = axis.iter().flat_map(|name| ["--axis", name]).collect();
        let found = run(&[&["sweep", &file, "--table", &tasks, "--out", &out, "--force"], &named[..]].concat());
        assert!(found.code < 2, "{table}: {}", found.err);
        let answers = std::fs::read_to_string(&out).unwrap();
        for (row, line) in answers.lines().skip(1).enumerate() {
            let cells: Vec<&str> = line.split(',').collect();
            let mut edited = text.clone();
            for (heading, written, values) in columns {
                let (key, old) = written.split_once(" = ").unwrap();
                let unit = old.trim_matches('"').split_once(' ').unwrap().1;
                assert!(edited.contains(written) && heading.contains(key), "{written}");
                edited = edited.replace(written, &format!("{key} = \"{} {unit}\"", values[row]));
            }
            let expected = sized(&put(folder, "axis.toml", &edited), *axis);
            let context = format!("{line}: {expected}");
            assert_eq!(cells[1].parse::<u64>().ok(), expected["fit"].as_u64(), "{context}");
            assert_eq!(cells[6].parse::<u64>().ok(), expected["fit_if_estimate"].as_u64(), "{context}");
            assert_eq!(cells[2], expected["answer"].as_str().unwrap_or_default(), "{context}");
            if cells[2].is_empty() {
                continue;
            }
            fitting += 1;
            codes.insert(cells[2].to_owned());
            let best = &expected["ranking"][0];
            // A record has twelve digits.
            let rounded: f64 = format!("{:.11e}", cells[3].parse::<f64>().unwrap()).parse().unwrap();
            assert_eq!(Some(rounded), best["utilisation"].as_f64(), "{context}");
            assert_eq!(Some(cells[4]), best["tightest"].as_str(), "{context}");
        }
    }
    assert!((6..12).contains(&fitting) && codes.len() > 4, "{fitting} {codes:?}");
}

/// A table of three parts, most of whose rows are refused quickly.
fn long_table(folder: &Path) -> String {
    let mut text = String::from("load.inertia [kg m^2],motion[1].time [s]\n");
    for row in 0..36_000 {
        let inertia = if row % 128 == 0 { 0.1 + f64::from(row % 97) } else { -1.0 };
        writeln!(text, "{inertia},{}", 0.2 + f64::from(row % 13) / 10.0).unwrap();
    }
    put(folder, "tasks.csv", &text)
}

/// Number of kills from the environment variable, for a campaign of a night; few by default.
fn kills() -> usize {
    std::env::var("ANTRIEB_SWEEP_KILLS").ok().and_then(|kills| kills.parse().ok()).unwrap_or(6)
}

/// Runs that are killed at seeded moments, from their start to behind the end of a whole run: at every moment there is no answer or the
/// whole one and every part is whole; the next run continues, and the answer has the bytes of a run that nothing interrupted.
#[cfg(unix)]
#[test]
fn runs_that_are_killed_at_any_moment_continue_with_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table = long_table(folder);
    let mut state = 20_261_126_u64;
    for ending in ["csv", "parquet"] {
        let whole = path(folder, &format!("whole.{ending}"));
        let begun = Instant::now();
        assert_eq!(run(&["sweep", &axis, "--table", &table, "--out", &whole]).code, 0);
        let (mut length, whole) = (begun.elapsed(), std::fs::read(&whole).unwrap());
        let out = folder.join(format!("best.{ending}"));
        let parts = folder.join(format!("best.{ending}.parts"));
        let arguments = ["sweep", &axis, "--table", &table, "--out", out.to_str().unwrap()];
        let (mut killed, mut finished, mut resumed, mut in_a_row) = (0, 0, 0, 0);
        while killed < kills() {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let share = (state >> 11) as f64 / (1_u64 << 53) as f64;
            let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_antrieb"))
                .args(arguments)
                .stdout(std::process::Stdio::null())
                .stderr(std::process::Stdio::null())
                .spawn()
                .unwrap();
            let moment = length.mul_f64(1.1 * share);
            std::thread::sleep(moment);
            child.kill().unwrap();
            let was_killed = std::os::unix::process::ExitStatusExt::signal(&child.wait().unwrap()) == Some(9);
            let mut kept = 0;
            for part in std::fs::read_dir(&parts).into_iter().flatten().map(|entry| entry.unwrap().path()) {
                if part.extension().is_some_and(|ending| ending == "parquet") {
                    let bytes = std::fs::read(&part).unwrap();
                    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"), "{}", part.display());
                    kept += 1;
                }
            }
            let is_there = out.exists();
            assert!(!is_there || std::fs::read(&out).unwrap() == whole, "{ending}: the answer is not whole");
            assert!(was_killed || is_there, "{ending}: a run ended without its answer");
            if !was_killed {
                // The first run was slower, for neighbours are at work.
                length = length.min(moment);
            }
            (killed, in_a_row) = (killed + usize::from(was_killed), in_a_row + usize::from(was_killed));
            eprintln!(
                "{ending}: {:.2} s of {:.2} s: {kept} parts kept, answer {is_there}",
                moment.as_secs_f64(),
                length.as_secs_f64()
            );
            // Thrice in a row, then a run that nothing interrupts.
            if !is_there && (in_a_row >= 3 || killed == kills()) {
                let last = run(&arguments);
                assert_eq!(last.code, 0, "{}", last.err);
                assert_eq!(last.err.contains("of an interrupted run"), kept > 0, "{kept}: {}", last.err);
                resumed += usize::from(kept > 0);
                assert!(std::fs::read(&out).unwrap() == whole, "{ending}: other bytes after {in_a_row} kills");
            }
            if out.exists() {
                // A run that is killed between its answer and the end of its parts leaves them to the next one.
                (finished, in_a_row) = (finished + 1, 0);
                std::fs::remove_file(&out).unwrap();
            }
        }
        eprintln!(
            "{ending}: {killed} runs killed, {finished} answers with the bytes of an uninterrupted run, {resumed} continued"
        );
        assert!(finished > 0 && (kills() < 20 || resumed > 0));
    }
}

/// Requires that the remark states the rows of the finished parts, including the last, shorter one.
#[test]
fn parts_that_are_kept_are_counted() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let table = long_table(folder);
    let out = path(folder, "best.parquet");
    let arguments = ["sweep", &axis, "--table", &table, "--out", &out];
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_antrieb")).args(arguments).spawn().unwrap();
    let second = folder.join("best.parquet.parts/part-00000001.parquet");
    let begun = Instant::now();
    while !second.exists() && begun.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(second.exists());
    std::fs::remove_file(&out).ok();
    let resumed = run(&arguments);
    assert_eq!(resumed.code, 0, "{}", resumed.err);
    let said = [
        "2 parts with 32768 rows of an interrupted run are kept",
        "3 parts with 36000 rows of an interrupted run are kept",
    ];
    assert!(said.iter().any(|said| resumed.err.contains(said)), "{}", resumed.err);
    assert!(!second.exists());
}

/// The first part is refused row by row, the rows behind it take longer: what is finished stays, however early the deadline is.
#[test]
fn a_deadline_ends_a_run_and_keeps_its_parts() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let axis = put(folder, "axis.toml", MOVE);
    let mut rows = "-1\n".repeat(1 << 14);
    (0..20_000).for_each(|row| writeln!(rows, "{}", 1.0 + f64::from(row) / 1e4).unwrap());
    let table = put(folder, "tasks.csv", &format!("load.inertia [kg m^2]\n{rows}"));
    let out = path(folder, "best.csv");
    let call = ["sweep", &axis, "--table", &table, "--out", &out];
    let late = run(&[&call[..], &["--deadline", "1 ms"]].concat());
    assert_eq!((late.code, Path::new(&out).exists()), (2, false), "{}", late.err);
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_antrieb")).args(call).spawn().unwrap();
    let first = folder.join("best.csv.parts/part-00000000.parquet");
    let begun = Instant::now();
    while !first.exists() && begun.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let late = run(&[&call[..], &["--deadline", "1 ms"]].concat());
    assert_eq!((late.code, Path::new(&out).exists(), first.exists()), (2, false, true), "{}", late.err);
}

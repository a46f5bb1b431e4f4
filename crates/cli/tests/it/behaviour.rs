//! Promises to users: exit codes, streams, JSON, refusals.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run;

use run::{root, run, run_with};
use serde_json::Value;
use testkit::agrees;

#[rustfmt::skip] // several to a line
const EXAMPLES: [&str; 20] = [
    "belt-axis", "cam-motion", "cam-table", "conveyor", "four-bar", "hoist",
    "indexing-table", "manual-example", "robot-joint", "scissor-lift", "screw-axis",
    "slewing-arm", "slider-crank", "stage-axis", "tilting-arm", "tolerances",
    "turntable", "two-axes", "two-way-shuttle", "winder",
];

#[test]
fn the_examples_are_all_there_and_fit() {
    let mut files: Vec<String> = std::fs::read_dir(root().join("examples"))
        .unwrap()
        .flatten()
        .map(|entry| format!("examples/{}", entry.file_name().to_string_lossy()))
        .filter(|name| name.ends_with(".toml"))
        .collect();
    files.sort();
    assert_eq!(files, EXAMPLES.map(|name| format!("examples/{name}.toml")));
    for example in &files {
        let run = run(&["size", example]);
        // Nothing but the calls that go on from the answer.
        let is_quiet = run.err.is_empty() || run.err.starts_with("\nfurther calls:\n  antrieb ");
        assert!(run.code == 0 && is_quiet, "{example}: {}", run.err);
    }
}

#[test]
fn the_worked_example_in_json() {
    let run = run(&["check", "examples/manual-example.toml", "--json"]);
    assert_eq!(run.code, 0);
    let value: Value = serde_json::from_str(&run.out).unwrap();
    let demand = &value["demand"];
    for (name, printed) in
        [("T_1", "103.98"), ("T_2", "5.00"), ("T_3", "-93.98"), ("T_rms", "38.90"), ("n_av", "6.15"), ("ED", "23.08")]
    {
        assert!(agrees(demand[name].as_f64().unwrap(), printed), "{name}: {}", demand[name]);
        if name.len() > 3 {
            assert!(agrees(demand["integral"][name].as_f64().unwrap(), printed), "{name}");
        }
    }
    let checks = value["checks"].as_array().unwrap();
    for check in checks {
        for field in ["id", "verdict", "value", "limit", "unit", "utilisation", "at", "grade", "source", "missing"] {
            assert!(check.get(field).is_some(), "{field} in {check}");
        }
        assert_eq!(check["verdict"] == "not_checked", check["missing"].is_string(), "{check}");
    }
    assert_eq!(checks.iter().find(|check| check["id"] == "peak_torque").unwrap()["verdict"], "pass");
    assert_eq!(checks.iter().find(|check| check["id"] == "continuous_torque").unwrap()["missing"], "T_0");
}

#[test]
fn sizing_in_json_names_an_answer_and_a_reason_for_each_rejection() {
    let run = run(&["size", "examples/indexing-table.toml", "--json", "--top", "2"]);
    let value: Value = serde_json::from_str(&run.out).unwrap();
    assert_eq!(value["ranking"].as_array().unwrap().len(), 2);
    assert_eq!(value["answer"], value["ranking"][0]["code"]);
    let rejected = value["rejected"].as_array().unwrap();
    assert_eq!(value["judged"].as_u64().unwrap(), value["fitting"].as_u64().unwrap() + rejected.len() as u64);
    for each in rejected {
        let by_check = each["check"].is_string() && each["value"].is_number();
        assert!(by_check || !each["objections"].as_array().unwrap().is_empty(), "{each}");
    }
}

#[test]
fn tolerances_in_json() {
    let code = "CHA-14A-80-H-RES-B";
    let report_of = |code: &str, more: &[&str]| {
        let answer = run(&[&["check", "examples/tolerances.toml", "--code", code, "--json"], more].concat());
        assert_eq!(answer.code, 0, "the exit code is that of the nominal verdict");
        serde_json::from_str::<Value>(&answer.out).unwrap()["tolerance"].clone()
    };
    let run_it = |more: &[&str]| report_of(code, more);
    let found = run_it(&["--samples", "2000", "--seed", "3"]);
    assert_eq!(
        (&found["samples"], &found["seed"], &found["distribution"]),
        (&2000.into(), &3.into(), &"uniform".into())
    );
    assert_eq!(found["share"].as_f64().unwrap(), found["passes"].as_f64().unwrap() / 2000.0);
    let worst = &found["worst_corner"];
    assert_eq!((&worst["verdict"], &worst["exhaustive"]), (&"does_not_fit".into(), &true.into()));
    assert_eq!(worst["values"].as_array().unwrap().len(), 4);
    assert_eq!(worst["values"][0].as_object().unwrap().keys().collect::<Vec<_>>(), ["quantity", "value", "unit"]);
    let shares = found["influence"].as_array().unwrap().iter().map(|each| each["share"].as_f64().unwrap());
    assert!((shares.sum::<f64>() - 1.0).abs() < 1e-9, "{found}");
    let usual = run_it(&[]);
    assert_eq!((&usual["samples"], &usual["seed"]), (&10_000.into(), &1.into()));
    assert_eq!(usual, run_it(&["--samples", "10000", "--seed", "1"]));

    let size = run(&["size", "examples/tolerances.toml", "--json", "--top", "12", "--samples", "2000", "--seed", "3"]);
    let value: Value = serde_json::from_str(&size.out).unwrap();
    let ranking = value["ranking"].as_array().unwrap();
    let there: Vec<bool> = ranking.iter().map(|each| each["tolerance"].is_object()).collect();
    assert_eq!(there, [[true; 10].as_slice(), &[false; 2]].concat(), "of at most ten");
    let tenth = &ranking[9];
    let alone = report_of(tenth["code"].as_str().unwrap(), &["--samples", "2000", "--seed", "3"]);
    assert_eq!(tenth["tolerance"], alone, "size and check say the same of one code");

    let exact = run(&["check", "examples/indexing-table.toml", "--code", "CHA-32A-50-H-C1024", "--json"]);
    assert!(!exact.out.contains("\"tolerance\""));
    for wrong in ["0", "1000001", "-1", "x"] {
        assert_eq!(run(&["size", "examples/tolerances.toml", "--samples", wrong]).code, 2, "{wrong}");
    }
}

#[test]
fn every_command_answers_in_json() {
    for arguments in [
        &["code", "list", "--json"][..],
        &["code", "complete", "CHA-20A", "--json"],
        &["data", "CHA-20A-100-H-C1024", "--json"],
        &["catalogue", "export", "--format", "json"],
        &["catalogue", "export", "--json"],
        &["schema", "--json"],
        &["inertia", "point mass=1kg distance=1m", "--json"],
        &["curve", "CHA-20A-50-H-C1024", "--voltage", "220 V", "--json"],
        &["curve", "CHA-32A-50-H-C1024", "--json"],
        &["bearing", "examples/turntable.toml", "--json"],
        &["battery", "--hours-per-day", "10", "--json"],
    ] {
        let run = run(arguments);
        assert_eq!(run.code, 0, "{arguments:?}");
        let _: Value = serde_json::from_str(&run.out).unwrap_or_else(|error| panic!("{arguments:?}: {error}"));
    }
}

#[test]
fn exit_codes_tell_fit_misfit_and_no_answer() {
    assert_eq!(run(&["check", "examples/indexing-table.toml", "--code", "CHA-32A-50-H-C1024"]).code, 0);
    assert_eq!(run(&["check", "examples/indexing-table.toml", "--code", "CHA-14A-30-E-RES"]).code, 1);
    assert_eq!(run(&["check", "examples/indexing-table.toml", "--code", "CHA-14A-31-E-RES"]).code, 2);
    assert_eq!(run(&["check", "examples/indexing-table.toml", "--code", "CHA-58A-50-H-RES"]).code, 2, "no data");
    let best = run(&["check", "examples/indexing-table.toml"]);
    assert_eq!(best.code, 0);
    assert!(best.out.contains("no actuator is stated"), "the best of the ranking, and it is said: {}", best.out);
    assert_eq!(run(&["size"]).code, 2);
    assert_eq!(run(&["--version"]).code, 0);
    let heavy = std::fs::read_to_string(root().join("examples/indexing-table.toml"))
        .unwrap()
        .replace("1.3 kg m^2", "1300 kg m^2");
    let run = run_with(&["size", "-"], heavy.as_bytes());
    assert_eq!(run.code, 1);
    assert!(run.out.contains("no actuator in the catalogue fits") && run.out.contains("smallest excess"));
}

#[test]
fn the_inertia_of_bodies_and_what_refuses_it() {
    let run_json = |bodies: &[&str]| {
        let run = run(&[&["inertia", "--json"], bodies].concat());
        (run.code, serde_json::from_str::<Value>(&run.out).unwrap())
    };
    // By hand: 4 (0.6 · 0.005/12 + 0.6 · 0.08²) = 0.01636 kgm².
    let (code, value) = run_json(&["box a=50mm b=50mm height=30mm mass=0.6kg distance=80mm count=4"]);
    assert_eq!((code, value["J"].as_f64(), value["m"].as_f64()), (0, Some(0.01636), Some(2.4)));
    assert_eq!(value["centre"]["r"].as_f64(), Some(0.0));
    // One piece of it alone hangs: 0.6 kg · 9.80665 m/s² · 0.08 m.
    let (_, value) = run_json(&["box a=50mm b=50mm height=30mm mass=0.6 kg distance=80mm angle=-90deg"]);
    assert!((value["T_gravity_max"].as_f64().unwrap() - 0.470_719_2).abs() < 1e-9, "{value}");
    assert!((value["centre"]["angle"].as_f64().unwrap() + 90.0).abs() < 1e-9, "{value}");
    for (bodies, line, column) in [
        (&["point mass=1kg", "sphere mass=1kg diameter=5"][..], 2, 26),
        (&["tube outer=5mm inner=5mm length=1mm mass=1kg"], 1, 22),
        (&["sphere diameter=5mm"], 1, 1),
        (&["sphere diameter=5mm mass=1kg density=1kg/m^3"], 1, 38),
        (&["ball diameter=5mm mass=1kg"], 1, 1),
        (&[""], 1, 1),
        (&["point mass=1kg", " "], 2, 2),
    ] {
        let (code, value) = run_json(bodies);
        let first = &value["errors"][0];
        let place = (first["line"].as_u64(), first["column"].as_u64());
        assert_eq!((code, place), (2, (Some(line), Some(column))), "{bodies:?} {value}");
    }
    assert_eq!(run(&["inertia"]).code, 2);
}

#[test]
fn a_pipe_gets_no_colour_and_no_line_is_wider_than_100() {
    for arguments in [
        &["size", "examples/indexing-table.toml", "--all"][..],
        &["size", "examples/two-way-shuttle.toml", "--lang", "de"],
        &["check", "examples/indexing-table.toml", "--code", "CHA-25A-50-H-M512P", "--lang", "de"],
        &["data", "CHA-14A-30-E-M128S-B", "--lang", "de"],
        &["data", "CHA-20A-100-H-C1024-B-EC"],
        &["code", "parse", "CHA-20A-100-H-C1024-B-EC-K-SP", "--lang", "de"],
        &["code", "complete", "CHA-20A-100-H"],
        &[
            "inertia",
            "cylinder diameter=123456mm length=1234567mm density=7850kg/m^3 distance=7m angle=-170deg count=99999",
        ],
    ] {
        let run = run(arguments);
        assert!(!run.out.contains('\u{1b}') && !run.err.contains('\u{1b}'), "{arguments:?}");
        for line in run.out.lines() {
            assert!(line.chars().count() <= 100, "{arguments:?}: {line}");
        }
    }
}

#[test]
fn the_same_call_gives_the_same_bytes() {
    for arguments in [&["size", "examples/indexing-table.toml", "--json"][..], &["catalogue", "export"]] {
        assert_eq!(run(arguments).out, run(arguments).out);
    }
}

#[test]
fn broken_input_is_refused_without_a_panic() {
    let junk: Vec<u8> = (0..=255).cycle().take(4096).collect();
    let big = vec![b'#'; 10 << 20];
    for (name, input) in [
        ("empty", &b""[..]),
        ("junk", &junk),
        ("10 MB", &big),
        ("latin-1", b"format = 1 # \xe4\n"),
        ("nesting", "[".repeat(100_000).as_bytes()),
        ("null", &[0; 64]),
        ("bom", "\u{feff}format = 1".as_bytes()),
    ] {
        for json in [false, true] {
            let mut arguments = vec!["size", "-"];
            if json {
                arguments.push("--json");
            }
            let run = run_with(&arguments, input);
            assert_eq!(run.code, 2, "{name}: {}", run.err);
            assert!(!run.err.is_empty() && !run.err.contains("panicked"), "{name}: {}", run.err);
            if json {
                let value: Value = serde_json::from_str(&run.out).unwrap();
                assert!(!value["errors"].as_array().unwrap().is_empty(), "{name}");
            } else {
                assert_eq!(run.out, "", "{name}");
            }
        }
    }
    assert_eq!(run(&["size", "examples"]).code, 2, "a folder is no project");
}

#[test]
fn a_code_one_letter_off_finds_its_neighbours() {
    let run = run(&["code", "parse", "CHA-20A-100-H-C1204"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("C1024") && run.err.contains("CHA-20A-100-H-C1024"), "{}", run.err);
}

#[test]
fn the_long_form_has_the_columns_of_the_contract() {
    let run = run(&["catalogue", "export", "--format", "csv"]);
    let mut lines = run.out.lines();
    assert_eq!(lines.next(), Some("drive,feedback,ratio,symbol,condition,printed,value,unit,table,erratum"));
    let rows: Vec<&str> = lines.collect();
    for row in [
        r"CHA-20A-C1024,C1024,50,T_max,,56,56,Nm,26.1,",
        r#"CHA-14A-E,,30,I_0,,"5,8",5.8,A,14.1,"#,
        r#"CHA-25A-M512P,M512P,50,J_out,,"0,97",1.1,kgm^2,40.2,25A-M512P-J_out-50"#,
        r#"CHA-32A-M512P,M512P,,tau_m,20 degC,"7,1",7.1,ms,42.1,T42.1-tau_m;32A-M512P-tau_m"#,
        r#"CHA-14A-H/N,RES,30,J_out,,"0,031",0.031,kgm^2,18.1,"#,
        r"CHA-20A-C1024,C1024,,U_M,,220 ... 430,220...430,V,26.1,",
        r"CHA-14A-E,,,I_E,,-,,A,14.1,",
        r"CHA-20A-C1024,C1024,,L,,118,118,mm,51.3,",
    ] {
        assert!(rows.contains(&row), "{row}");
    }
}

/// The example of section 7.2: 60 Nm on the values of 32A-100 twist 7.15e-4 rad, printed 2.5 arcmin.
#[test]
fn the_torsion_of_the_worked_example() {
    let run_it = run(&["torsion", "CHA-32A-100-H-C1024", "--torque", "60 N m", "--json"]);
    let value: Value = serde_json::from_str(&run_it.out).unwrap();
    assert!((value["angle_rad"].as_f64().unwrap() - 7.15e-4).abs() < 0.005e-4);
    assert!((value["angle_arcmin"].as_f64().unwrap() - 2.46).abs() < 0.005);
    assert_eq!(value["region"], 2);
    assert_eq!(run(&["torsion", "CHA-32A-100-H-C1024", "--torque", "60"]).code, 2);
    assert_eq!(run(&["torsion", "CHA-32A-100-H-C1024", "--torque", "-60 N m"]).code, 0);
}

#[test]
fn completions_and_manual_pages_are_made_for_every_command() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let run = run(&["completions", shell]);
        assert_eq!(run.code, 0);
        assert!(run.out.contains("catalogue"), "{shell}");
    }
    for page in ["size", "check", "torsion", "code", "data", "catalogue", "schema", "completions", "man"] {
        assert!(run(&["man", page]).out.contains(".TH"), "{page}");
    }
    assert!(run(&["man"]).out.contains("antrieb"));
    assert_eq!(run(&["man", "none"]).code, 2);
}

#[test]
fn the_chapters_alone() {
    // Domain: ten years at ten hours a day, 6.7 after two years of storage; 6.1 without operation.
    let life = |arguments: &[&str]| {
        let run = run(&[&["battery", "--json", "--hours-per-day"], arguments].concat());
        (run.code, serde_json::from_str::<Value>(&run.out).map_or(0.0, |value| value["life"].as_f64().unwrap_or(0.0)))
    };
    assert!(agrees(life(&["10"]).1, "10.0") && agrees(life(&["10 h", "--storage", "2 a"]).1, "6.7"));
    assert!(agrees(life(&["0"]).1, "6.1"));
    for bad in [&["25"][..], &["-1 h"], &["ten"], &["10", "--storage", "4 a"]] {
        assert_eq!(life(bad).0, 2, "{bad:?}");
    }
    // The published corner points of 20A-50: 32 Nm at standstill, 20 at 70 1/min.
    let value: Value = serde_json::from_str(&run(&["curve", "CHA-20A-50-H-C1024", "--json"]).out).unwrap();
    let continuous = &value["curves"][0];
    assert_eq!((continuous["kind"].as_str(), continuous["grade"].as_str()), (Some("continuous"), Some("published")));
    assert!(agrees(continuous["points"][0][1].as_f64().unwrap(), "32"), "{continuous}");
    assert_eq!(run(&["curve", "CHA-58A-50-H-RES"]).code, 2, "no data");
    assert_eq!(run(&["curve", "CHA-20A-50-H-C1024", "--voltage", "220"]).code, 2, "no unit");
    assert_eq!(run(&["bearing", "examples/turntable.toml"]).code, 0);
    let open = run(&["bearing", "examples/belt-axis.toml"]);
    assert!(open.code == 0 && open.out.contains("bearing.belt_tension"), "{}{}", open.out, open.err);
    let without = run(&["bearing", "examples/cam-motion.toml"]);
    assert!(without.code == 2 && without.err.contains("[bearing] is missing"), "{}", without.err);
    for kind in ["manual", "table", "arm", "screw", "belt"] {
        let template = run(&["new", kind]);
        assert_eq!(template.code, 0);
        assert_eq!(run_with(&["size", "-"], template.out.as_bytes()).code, 0, "{kind}");
    }
    assert_eq!(run(&["new", "spring"]).code, 2);
}

#[test]
fn several_axes_get_a_verdict_each() {
    let value: Value = serde_json::from_str(&run(&["size", "examples/two-axes.toml", "--json"]).out).unwrap();
    let names: Vec<&str> =
        value["axes"].as_array().unwrap().iter().map(|axis| axis["axis"].as_str().unwrap()).collect();
    assert_eq!((names, value["verdict"].as_str()), (vec!["swivel", "lift"], Some("fits")));
    let one: Value =
        serde_json::from_str(&run(&["size", "examples/two-axes.toml", "--axis", "lift", "--json"]).out).unwrap();
    assert_eq!(one, value["axes"][1], "an axis alone is what it is among others");
    let text = std::fs::read_to_string(root().join("examples/two-axes.toml")).unwrap();
    // One axis that does not fit decides, and the other is still answered.
    let heavy = run_with(&["size", "-"], text.replace("mass = \"9 kg\"", "mass = \"9 t\"").as_bytes());
    assert_eq!(heavy.code, 1);
    assert!(heavy.out.contains("swivel: CHA-") && heavy.out.contains("lift: no actuator"));
    let missing = run(&["size", "examples/two-axes.toml", "--axis", "left"]);
    assert!(missing.code == 2 && missing.err.contains("swivel, lift"));
    let outside = run_with(&["size", "-"], format!("{text}\n[load]\ninertia = \"1 kg m^2\"\n").as_bytes());
    assert!(outside.code == 2 && outside.err.contains("belongs inside [[axis]]"), "{}", outside.err);
    let without =
        run_with(&["size", "-"], b"format = 1\n[[axis]]\nname = \"a\"\n[axis.load]\ninertia = \"1 kg m^2\"\n");
    assert!(without.code == 2 && without.err.contains("[[motion]]"), "{}", without.err);
}

/// A folder of its own for what a test writes.
fn scratch(name: &str) -> std::path::PathBuf {
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

const RECORDED: &str =
    "format = 1\n[load]\ninertia = \"0.5 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = \"run.csv\"\n";

#[test]
fn a_recording_is_read_from_beside_the_project() {
    let folder = scratch("recording");
    let project = folder.join("axis.toml");
    std::fs::write(&project, RECORDED).unwrap();
    // A swing of 60 degrees and back in two seconds, at 100 Hz.
    let rows = (0..=200).map(|k| {
        let t = f64::from(k) * 0.01;
        format!("{t};{}\n", 30.0 * (1.0 - (std::f64::consts::PI * t).cos()))
    });
    let text = format!("# logger 7\nZeit;Winkel\ns;deg\n{}", rows.collect::<String>().replace('.', ","));
    std::fs::write(folder.join("run.csv"), text).unwrap();
    let found = run(&["size", project.to_str().unwrap(), "--json"]);
    assert_eq!((found.code, found.err.as_str()), (0, ""));
    let value: Value = serde_json::from_str(&found.out).unwrap();
    let recording = &value["motion"]["segments"][0]["recording"];
    assert_eq!(
        (recording["samples"].as_u64(), recording["columns"][1]["unit_by"].as_str()),
        (Some(201), Some("unit_row"))
    );
    // 30° π/s = 15.708 1/min; 0.5 kgm² · 30° π² s⁻² = 2.5838 Nm for the load alone.
    let speed = value["motion"]["segments"][0]["speed"].as_f64().unwrap();
    assert!((speed - 15.708).abs() < 0.01, "{speed}");
}

#[test]
fn a_bad_recording_is_refused_with_its_lines() {
    let folder = scratch("bad-recording");
    let project = folder.join("axis.toml");
    let check = |project_text: &str, csv: Option<&str>, expected: &[&str]| {
        std::fs::write(&project, project_text).unwrap();
        let file = folder.join("run.csv");
        match csv {
            Some(text) => std::fs::write(&file, text).unwrap(),
            None => drop(std::fs::remove_file(&file)),
        }
        let found = run(&["size", project.to_str().unwrap()]);
        assert_eq!((found.code, found.out.as_str()), (2, ""), "{expected:?}");
        for words in expected {
            assert!(found.err.contains(words), "{words} is missing in {}", found.err);
        }
    };
    check(RECORDED, None, &["run.csv: there is no such file", "axis.toml:6:"]);
    check(RECORDED, Some("t [s],q [deg]\n0,0\n0.1,1\n0.05,2\n0.2,x\n0.3,3\n"), &["line 4", "line 5"]);
    check(RECORDED, Some("t,q [deg]\n0,0\n1,1\n2,0\n"), &["unit"]);
    check(RECORDED, Some("t [s],q [deg]\n0,0\n1,1\n2,5\n"), &["single_move"]);
    check(RECORDED, Some("\0\0\0"), &["run.csv"]);
    check(&RECORDED.replace("run.csv", "."), Some(""), &["folder"]);
    check(
        &format!("{RECORDED}standstill = \"1 mm/s\"\n"),
        Some("t [s],q [deg]\n0,0\n1,1\n2,0\n"),
        &["no fixed travel"],
    );
    check(
        &RECORDED.replace("[load]\ninertia = \"0.5 kg m^2\"", "[mechanism.joint]\ninertia = \"1 kg m^2\""),
        Some("t [s],q [deg]\n0,0\n1,1\n2,0\n"),
        &["every [[motion]] must be a recording"],
    );
    check(
        &format!("{RECORDED}from = \"0 s ± 1 s\"\n"),
        Some("t [s],q [deg],n [1/min]\n0,0,0\n1,1,0\n2,0,0\n"),
        &["no tolerance permitted here"],
    );
}

#[test]
fn explain_gives_a_tree_for_every_check() {
    let found = run(&["explain", "examples/tilting-arm.toml", "--code", "CHA-17A-100-H-M128S-B", "--json"]);
    assert_eq!((found.code, found.err.as_str()), (0, ""));
    let value: Value = serde_json::from_str(&found.out).unwrap();
    for check in value["checks"].as_array().unwrap() {
        for (figure, root) in [("value", "value"), ("limit", "limit")] {
            let tree = &check["derivation"][root];
            match check[figure].as_f64() {
                Some(number) => {
                    let found = tree["value"].as_f64().unwrap_or(f64::NAN);
                    assert!((found - number).abs() <= 1e-9 * number.abs(), "{} {figure}", check["id"]);
                    assert!(tree["source"].is_string(), "{}", check["id"]);
                }
                None => assert!(tree.is_null(), "{} {figure}", check["id"]),
            }
        }
    }
    let one = run(&["explain", "examples/tilting-arm.toml", "--code", "CHA-17A-100-H-M128S-B", "--check", "voltage"]);
    assert!(one.out.contains("u_q") && !one.out.contains("inertia ratio"), "{}", one.out);
    let none = run(&[
        "explain",
        "examples/tilting-arm.toml",
        "--code",
        "CHA-17A-100-H-M128S-B",
        "--check",
        "collision_torque",
    ]);
    assert_eq!(none.code, 2);
    let unknown = run(&["explain", "examples/tilting-arm.toml", "--check", "contineous_torque"]);
    assert!(unknown.code == 2 && unknown.err.contains("continuous_torque"), "{}", unknown.err);
}

fn names(folder: &std::path::Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn a_picture_goes_to_standard_output_or_whole_into_files() {
    let project = "examples/indexing-table.toml";
    let plain = run(&["plot", project, "--figure", "torque_speed"]);
    assert_eq!((plain.code, plain.err.as_str()), (0, ""));
    assert!(plain.out.starts_with("<svg ") && plain.out.ends_with("</svg>\n"));
    let dash = run(&["plot", project, "--figure", "torque_speed", "--svg", "-"]);
    assert_eq!(dash.out, plain.out);
    let folder = scratch("pictures");
    let (svg, png) = (folder.join("a.svg"), folder.join("a.png"));
    let (svg, png) = (svg.to_str().unwrap(), png.to_str().unwrap());
    for _ in 0..2 {
        let run = run(&["plot", project, "--figure", "torque_speed", "--svg", svg, "--png", png, "--json", "--force"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let value: Value = serde_json::from_str(&run.out).unwrap();
        assert_eq!((value["figure"].as_str(), value["file"].as_str()), (Some("torque_speed"), Some(svg)));
        assert_eq!((value["width"].as_f64(), value["height"].as_f64()), (Some(165.0), Some(125.0)));
        assert!(value["description"].as_str().unwrap().contains("110.6 Nm"));
        assert_eq!(names(&folder), ["a.png", "a.svg"]);
    }
    assert_eq!(std::fs::read_to_string(svg).unwrap().trim_end(), plain.out.trim_end());
    assert!(std::fs::read(png).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn nothing_is_written_where_something_is_wrong() {
    let folder = scratch("unwritten");
    let (svg, png) = (folder.join("a.svg"), folder.join("none/a.png"));
    let (svg, png) = (svg.to_str().unwrap(), png.to_str().unwrap());
    let table = "examples/indexing-table.toml";
    for (arguments, expected) in [
        (vec!["plot", table, "--figure", "cycle", "--svg", svg, "--png", png], "there is no such folder"),
        (vec!["plot", table, "--figure", "cycle", "--svg", svg, "--png", "-"], "--png requires a file name"),
        (vec!["plot", table, "--figure", "cycle", "--svg", folder.to_str().unwrap()], "this is a folder"),
        (vec!["plot", "examples/screw-axis.toml", "--figure", "bearing_load", "--svg", svg], "bearing.flange_share"),
        (vec!["plot", table, "--figure", "cycle", "--svg", svg, "--width", "30"], "--width"),
        (vec!["plot", table, "--figure", "cycl", "--svg", svg], "cycle"),
        (vec!["curve", "CHA-20A-100-H-C1024", "--svg", svg, "--height", "9 m"], "--height"),
    ] {
        let run = run(&arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
        assert!(run.err.contains(expected), "{arguments:?}: {}", run.err);
        assert!(names(&folder).is_empty(), "{arguments:?}");
    }
}

#[test]
fn a_picture_of_what_does_not_fit_says_so_by_its_code() {
    let run = run(&["plot", "examples/indexing-table.toml", "--code", "CHA-25A-50-H-M512P", "--figure", "utilisation"]);
    assert_eq!(run.code, 1);
    assert!(run.out.contains("class=\"bar fail\""));
}

#[test]
fn a_curve_has_a_picture_and_without_a_file_its_text() {
    let folder = scratch("curve");
    let path = folder.join("c.svg");
    let path = path.to_str().unwrap();
    let code = "CHA-32A-50-H-C1024";
    let run_with_file = run(&["curve", code, "--voltage", "400 V", "--svg", path, "--theme", "dark"]);
    assert_eq!((run_with_file.code, run_with_file.err.as_str()), (0, ""));
    assert!(run_with_file.out.contains("c.svg (165 × 125 mm)"));
    assert!(std::fs::read_to_string(path).unwrap().contains("400 V"));
    assert!(run(&["curve", code, "--voltage", "400 V"]).out.contains("T Nm"));
}

/// Compares the figures with those of the guides; to draw them again: `antrieb plot examples/EXAMPLE.toml --figure
/// FIGURE --svg FILE --force`.
#[test]
fn the_pictures_of_the_guide_are_what_the_tool_draws() {
    let mut pictures = vec![("indexing-table", "candidate_map", "candidate-map.svg".to_owned())];
    for example in ["indexing-table", "tilting-arm", "screw-axis", "belt-axis", "robot-joint"] {
        pictures.push((example, "torque_speed", format!("{example}-torque-speed.svg")));
        pictures.push((example, "cycle", format!("{example}-cycle.svg")));
    }
    for ((example, figure, file), (folder, language)) in
        pictures.iter().flat_map(|picture| [("guide", "en"), ("anleitung", "de")].map(|guide| (picture, guide)))
    {
        let drawn = run(&["plot", &format!("examples/{example}.toml"), "--figure", figure, "--lang", language]).out;
        let shown = std::fs::read_to_string(root().join("docs").join(folder).join("pictures").join(file)).unwrap();
        let again = format!("antrieb plot examples/{example}.toml --figure {figure} --lang {language}");
        assert!(drawn == shown, "{folder}/pictures/{file} is stale: {again}");
    }
}

#[test]
fn a_report_is_written_once_and_the_same_twice() {
    let folder = scratch("report");
    let (first, second) = (folder.join("a.pdf"), folder.join("b.pdf"));
    let (first, second) = (first.to_str().unwrap(), second.to_str().unwrap());
    let project = "examples/indexing-table.toml";
    let sheet = ["--date", "2026-11-21", "--revision", "B", "--title", "Anlage Ä µ ²", "--archive"];
    let found = run(&[&["report", project, "--out", first], sheet.as_slice()].concat());
    assert_eq!((found.code, found.err.as_str()), (0, ""));
    let found = run(&[&["size", project, "--report", second], sheet.as_slice()].concat());
    assert_eq!(found.code, 0);
    assert!(found.err.contains("b.pdf"), "{}", found.err);
    let bytes = std::fs::read(first).unwrap();
    assert!(bytes.starts_with(b"%PDF-1.7") && bytes.len() < 2_000_000, "{}", bytes.len());
    assert!(bytes == std::fs::read(second).unwrap(), "the same axis and actuator give other bytes");
    let again = run(&["report", project, "--out", first]);
    assert!(again.code == 2 && again.err.contains("--force"), "{}", again.err);
    let nowhere = folder.join("no/such/a.pdf");
    let lost = run(&["size", project, "--report", nowhere.to_str().unwrap()]);
    assert!(lost.code == 2 && lost.out.is_empty() && lost.err.contains("folder"), "{}", lost.err);
    let date = run(&["report", project, "--out", second, "--force", "--date", "21.13.2026"]);
    assert_eq!((date.code, names(&folder)), (2, vec!["a.pdf".to_owned(), "b.pdf".to_owned()]));
    let several = run(&["report", "examples/two-axes.toml", "--out", second, "--force"]);
    assert!(several.code == 0 && ["swivel", "lift"].iter().all(|axis| several.out.contains(axis)), "{}", several.out);
    let coded = ["report", "examples/two-axes.toml", "--out", second, "--force", "--code", "CHA-25A-100-H-C1024"];
    let coded = run(&coded);
    assert!(coded.code == 2 && coded.err.contains("--axis"), "{}", coded.err);
}

#[test]
fn a_check_names_the_errata_that_it_rests_on() {
    let run = run(&["check", "examples/indexing-table.toml", "--code", "CHA-25A-50-H-M512P", "--json"]);
    let value: Value = serde_json::from_str(&run.out).unwrap();
    for check in value["checks"].as_array().unwrap() {
        let rests =
            ["peak_torque", "continuous_torque", "peak_current", "voltage"].contains(&check["id"].as_str().unwrap());
        let named = check["errata"].as_array().is_some_and(|ids| ids.contains(&"25A-M512P-J_out-50".into()));
        assert!(!rests || named, "{check:#}");
        assert!(check["errata"].as_array().is_none_or(|ids| !ids.is_empty()));
    }
}

//! Calls as people write them: other values for one call, other words, several projects.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::run::{examples, root, run};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    let run = run(&[arguments, &["--json"]].concat());
    serde_json::from_str(&run.out).unwrap_or_else(|fault| panic!("{arguments:?}: {fault}\n{}\n{}", run.out, run.err))
}

/// A key of an example, set to the value that the file states: the answer is that of the file.
#[test]
fn a_key_that_is_set_to_its_own_value_changes_nothing() {
    for (place, example) in examples().iter().enumerate() {
        let text = std::fs::read_to_string(root().join(example)).unwrap();
        let keys: Vec<project::Written> = project::written(&text).unwrap();
        let values = keys.iter().filter_map(|key| Some((key.path.as_str(), key.value.as_deref()?)));
        // Some keys of each example, others in each.
        let some: Vec<(&str, &str)> = values.filter(|(path, _)| *path != "format").skip(place % 3).step_by(7).collect();
        let changes: Vec<String> = some.iter().map(|(path, value)| format!("{path}={value}")).collect();
        let arguments: Vec<&str> = changes.iter().flat_map(|change| ["--set", change.as_str()]).collect();
        let changed = json(&[&["size", example.as_str()], &arguments[..]].concat());
        assert_eq!(changed, json(&["size", example]), "{example} {changes:?}");
    }
}

#[test]
fn a_value_for_one_call_is_that_of_a_file_which_states_it() {
    let example = "examples/belt-axis.toml";
    let text = std::fs::read_to_string(root().join(example)).unwrap();
    for (change, from, to) in [
        (["--set", "mechanism.belt.mass=31 kg"], "mass = \"18 kg\"", "mass = \"31 kg\""),
        // A key that is stated once needs no table.
        (["--set", "pulley_diameter=90 mm"], "pulley_diameter = \"120 mm\"", "pulley_diameter = \"90 mm\""),
        (["--set", "requirements.brake=true"], "[requirements]\n", "[requirements]\nbrake = true\n"),
    ] {
        assert!(text.contains(from), "{from}");
        let stated = crate::run::run_with(&["size", "-", "--json"], text.replace(from, to).as_bytes());
        let set = run(&["size", example, change[0], change[1], "--json"]);
        assert_eq!(set.out, stated.out, "{change:?}");
        assert!(set.err.starts_with("for this call: "), "{}", set.err);
    }
    let of_hoist =
        |change: [&str; 2]| run(&["check", "hoist", "CHA-32A-100-H-C1024-B", change[0], change[1], "--json"]);
    let scaled = of_hoist(["--scale", "load=2"]);
    let stated = of_hoist(["--set", "mechanism.hoist.mass=80 kg"]);
    assert_eq!(scaled.out, stated.out, "{}", scaled.err);
}

#[test]
fn every_change_that_cannot_be_made_is_named_at_once() {
    let faulty = ["--set", "mss=3 kg", "--set", "nothing", "--scale", "load=0", "--scale", "nothing=2"];
    let refused = run(&[&["size", "examples/belt-axis.toml"], &faulty[..]].concat());
    assert_eq!((refused.code, refused.out.as_str()), (2, ""));
    assert_eq!(refused.err.matches("error:").count(), 4, "{}", refused.err);
    for part in ["no key \"mss\"", "KEY=VALUE", "0.001 to 1000", "load, payload, time, distance"] {
        assert!(refused.err.contains(part), "{part}\n{}", refused.err);
    }
    // A key that several tables state leads to each of them; one that a single table states is that one.
    let several = run(&["size", "examples/two-axes.toml", "--scale", "supply=1.1"]);
    for call in ["axis[1].requirements.supply=1.1", "axis[2].requirements.supply=1.1"] {
        assert!(several.code == 2 && several.err.contains(call), "{}", several.err);
    }
    let of_belt = |change: [&str; 2]| run(&["size", "examples/belt-axis.toml", change[0], change[1], "--json"]);
    assert_eq!(of_belt(["--scale", "mass=2"]).out, of_belt(["--set", "mechanism.belt.mass=36 kg"]).out);
    let several = run(&["size", "examples/two-axes.toml", "--set", "load.inertia=2 kg m^2"]);
    assert!(several.code == 2 && several.err.contains("axis[1].load.inertia"), "{}", several.err);
}

#[test]
fn several_projects_have_a_line_each_with_the_answer_of_each() {
    let files = ["examples/belt-axis.toml", "examples/hoist.toml", "examples/two-axes.toml"];
    let table = run(&["size", files[0], files[1], files[2]]);
    assert_eq!((table.code, table.err.as_str()), (0, ""));
    let together = json(&["size", files[0], files[1], files[2]]);
    let axes = together["axes"].as_array().unwrap();
    assert_eq!(axes.len(), 4);
    for (axis, file) in axes.iter().zip([files[0], files[1], files[2], files[2]]) {
        let code = axis["answer"].as_str().unwrap();
        let name = file.trim_start_matches("examples/");
        assert!(table.out.lines().any(|line| line.starts_with(name) && line.contains(code)), "{code}\n{}", table.out);
    }
    let missing = run(&["size", files[0], "no-such-file.toml", "nor-this.toml"]);
    assert!(
        missing.code == 2 && missing.err.contains("no-such-file") && missing.err.contains("nor-this"),
        "{}",
        missing.err
    );
}

#[test]
fn words_of_both_languages_and_any_case_lead_to_the_same_bytes() {
    let plain = run(&["check", "examples/belt-axis.toml", "--code", "CHA-14A-50-N-D2048", "--lang", "de"]);
    for call in [
        ["PRÜFEN", "examples/belt-axis.toml", "CHA-14A-50-N-D2048", "--lang", "DE"],
        ["Nachweis", "CHA-14A-50-N-D2048", "examples/belt-axis.toml", "--lang", "Deutsch"],
    ] {
        let other = run(&call);
        assert_eq!((other.code, other.out), (plain.code, plain.out.clone()), "{call:?}\n{}", other.err);
    }
    let figure = run(&["plot", "examples/belt-axis.toml", "--figure", "torque_speed"]);
    assert_eq!(run(&["Diagramm", "examples/belt-axis.toml", "Torque-Speed", "EN"]).out, figure.out);
}

/// A report without a file name lies beside its project, and replaces nothing.
#[test]
fn a_report_without_a_file_lies_beside_its_project() {
    let folder = tempfile::tempdir().unwrap();
    let project = folder.path().join("press.toml");
    std::fs::copy(root().join("examples/belt-axis.toml"), &project).unwrap();
    let project = project.display().to_string();
    let report = folder.path().join("press.pdf");
    let first = run(&["Bericht", &project]);
    assert!(first.code == 0 && first.out.contains("press.pdf") && report.is_file(), "{}{}", first.out, first.err);
    std::fs::write(&report, "mine").unwrap();
    let second = run(&["report", &project]);
    assert!(second.code == 2 && second.err.contains("press.pdf") && second.err.contains("--force"), "{}", second.err);
    assert_eq!(std::fs::read(&report).unwrap(), b"mine");
    let piped = crate::run::run_with(&["report", "-"], b"format = 1");
    assert!(piped.code == 2 && piped.err.contains("--out"), "{}", piped.err);
}

/// A project begins with a recording: its columns are recognised, what is not known is a comment.
#[test]
fn a_project_begins_with_a_recording() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let row = |step: i32| {
        let t = f64::from(step) * 0.01;
        let turn = (std::f64::consts::TAU * t).cos();
        format!("{t:.2};{:.6};{:.6};7\r\n", 40.0 * (1.0 - turn), 3.0 * turn)
    };
    let rows: String = (0..=100).map(row).collect();
    for (heading, kind, base) in [
        ("t [s];Position [deg];M [Nm];spare", "recording", "[mechanism.joint]"),
        ("t [s];Position [mm];note;spare", "recording", "[mechanism.belt]"),
        ("t [s];Position [deg];note;spare", "arm", "[mechanism.arm]"),
        ("t [s];Position [deg];note;spare", "recording", "[load]"),
    ] {
        let (table, out) = (path("run.csv"), path("axis.toml"));
        std::fs::write(&table, format!("{heading}\r\n{rows}")).unwrap();
        let made = run(&["new", kind, "--from", &table, "--out", &out, "--force"]);
        assert_eq!(made.code, 0, "{}", made.err);
        let text = std::fs::read_to_string(&out).unwrap();
        for part in [base, "file = \"run.csv\"", "columns.time = \"t", "columns.position = \"Position"] {
            assert!(text.contains(part), "{heading} {part}\n{text}");
        }
        assert!(text.contains("# columns.speed") && text.contains("spare"), "{text}");
        // What a recording with a torque does not need is all that is missing: the figures of the template are comments.
        let refused = run(&["size", &out, "--top", "1"]);
        assert_eq!(refused.code < 2, base == "[mechanism.joint]", "{heading}\n{}\n{text}", refused.err);
        let missing = refused.err.lines().filter_map(|line| line.strip_suffix("` is missing")?.rsplit('.').next());
        let stated =
            missing.fold(text.clone(), |text, key| text.replacen(&format!("# {key} = "), &format!("{key} = "), 1));
        std::fs::write(&out, stated).unwrap();
        let sized = run(&["size", &out, "--top", "1"]);
        assert!(sized.code < 2, "{heading}\n{}\n{text}", sized.err);
    }
    // What the segment or a change of values puts right is stated, and the project is written.
    for (heading, part) in [
        ("t [s];A1 Istposition [deg];A2 Istposition [deg];spare", "A1 Istposition"),
        ("t [s];note;Motordrehzahl [1/min];spare", "Motordrehzahl"),
        ("t [s];Position;note;spare", "\"Position\""),
        ("mark;Position [deg];note;spare", "\"mark\""),
        ("t [s];Position [deg];Istmoment [%];spare", "6076h"),
        ("epoch_ms;Position [deg];note;spare", ""),
    ] {
        let (table, out) = (path("run.csv"), path("axis.toml"));
        for damage in ["", "0,05;#NV;#NV;7\r\n"] {
            let more: String = (101..=110).map(row).collect();
            std::fs::write(&table, format!("{heading}\r\n{rows}{damage}{more}")).unwrap();
            let made = run(&["new", "recording", "--from", &table, "--out", &out, "--force"]);
            assert_eq!(made.code, 0, "{heading} {}", made.err);
            assert!(made.err.contains(part) && !made.err.contains("axis.toml:"), "{heading}\n{}", made.err);
            let refused = run(&["size", &table]);
            assert!(refused.code == 2 && refused.err.contains("(new project with "), "{heading}\n{}", refused.err);
            let mut places = refused.err.lines().filter(|line| line.trim_start().starts_with("-->"));
            assert!(places.all(|line| line.contains("(new project with ")), "{}", refused.err);
        }
    }
    std::fs::write(path("note.csv"), "a note\n").unwrap();
    for file in ["note.csv", "missing.csv"] {
        let refused = run(&["new", "recording", "--from", &path(file)]);
        assert!(refused.code == 2 && refused.err.contains(file), "{}", refused.err);
    }
}

/// Bodies keep their dimensions; their masses or densities grow with the load.
#[test]
fn a_load_of_bodies_is_scaled_by_its_masses() {
    let project = "format = 1\n[mechanism.turntable]\nbodies = [\"disc diameter=400mm mass=8kg\"]\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"0.8 s\"\n\
        [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-90 deg\"\ntime = \"0.8 s\"\n";
    let scaled = crate::run::run_with(&["size", "-", "--scale", "load=1.5", "--json"], project.as_bytes());
    let stated = project.replace("mass=8kg", "mass=12kg");
    let stated = crate::run::run_with(&["size", "-", "--json"], stated.as_bytes());
    assert_eq!((scaled.code, scaled.out), (stated.code, stated.out), "{}", scaled.err);
    assert!(scaled.err.contains("load × 1.5"), "{}", scaled.err);
}

#[test]
fn samples_of_a_project_without_tolerances_are_refused() {
    for (command, option) in [("size", "--samples"), ("check", "--seed")] {
        let run = run(&[command, "examples/belt-axis.toml", option, "7"]);
        assert!(run.code == 2 && run.err.contains(option) && run.err.contains("30 kg ± 5 %"), "{}", run.err);
    }
}

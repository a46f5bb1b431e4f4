//! Calls that are plain though they lack a word or state it elsewhere: ratios, codes without a project, a file without a name.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::refusals::{call, named};
use crate::run::{examples, run, run_at};

/// A folder with two projects, so that none of them is plainly meant.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for kind in ["arm", "belt"] {
        let made = call(folder.path(), &format!("antrieb new {kind} --out {kind}.toml"));
        assert_eq!(made.code, 0, "{}", made.err);
    }
    folder
}

const A: &str = "CHA-25A-50-H-C1024";
const B: &str = "CHA-25A-80-H-C1024";

#[test]
fn a_ratio_of_the_catalogue_is_that_of_the_actuator_in_all_commands() {
    let folder = folder();
    for (written, parts) in [
        ("size arm.toml --ratio 50,100", &["antrieb sweep arm.toml --vary code=", "-50-", "-100-"][..]),
        ("size arm.toml --ratio 50", &["antrieb check arm.toml --code ", "-50-", "the best of them"]),
        ("check arm.toml ratio=100", &["antrieb check arm.toml --code ", "-100-"]),
        ("check arm.toml Untersetzung 100", &["-100-"]),
        ("simulate arm.toml --gear-ratio 80", &["-80-"]),
        ("sweep arm.toml --ratio 30..100", &["-30-", "-50-", "-80-", "-100-"]),
        ("sweep arm.toml --vary ratio=50,100", &["-50-", "-100-"]),
        ("sweep arm.toml ratio 50,100", &["-50-", "-100-"]),
        ("compare arm.toml --ratio 50,100", &["antrieb compare arm.toml --code ", "-50-", "-100-"]),
        ("check belt.toml --ratio 50", &["-50-"]),
    ] {
        let found = call(folder.path(), &format!("antrieb {written}"));
        assert!(found.code < 2, "{written}\n{}", found.err);
        for part in parts {
            assert!(found.err.contains(part), "{written}: {part}\n{}", found.err);
        }
    }
    // No ratio of the catalogue.
    let other = call(folder.path(), "antrieb check arm.toml --ratio 55");
    assert_eq!((other.code, other.out.as_str()), (2, ""), "{}", other.err);
}

#[test]
fn codes_without_a_project_are_compared_by_their_data() {
    let folder = folder();
    for written in [format!("compare {A} {B}"), format!("Vergleich {A} {B}"), format!("compare --code {A} --code {B}")]
    {
        let found = call(folder.path(), &format!("antrieb {written}"));
        assert_eq!(found.code, 0, "{written}\n{}", found.err);
        assert!(found.err.contains(&format!("data {A} --beside {B}")), "{}", found.err);
        assert!(found.out.contains(A) && found.out.contains(B) && found.out.contains("k_Tout"), "{}", found.out);
    }
    for wrong in [format!("data {A} --beside {B} --json"), format!("data {A} --beside CHA-25A-85-H-C1024")] {
        assert_eq!(call(folder.path(), &format!("antrieb {wrong}")).code, 2, "{wrong}");
    }
}

#[test]
fn a_workbook_without_a_name_stands_beside_its_project_and_replaces_nothing() {
    let folder = folder();
    for (written, code) in [("workbook arm.toml", 0), ("Mappe arm.toml", 2), ("export belt.toml", 0)] {
        let found = call(folder.path(), &format!("antrieb {written}"));
        assert_eq!(found.code, code, "{written}\n{}", found.err);
    }
    assert!(folder.path().join("arm.xlsx").is_file() && folder.path().join("belt.xlsx").is_file());
}

#[test]
fn a_value_of_another_command_leads_to_it() {
    let folder = folder();
    for written in [format!("wiring {A} --sinamics"), format!("wiring {A} sinamics"), format!("data {A} --sinamics")] {
        let found = call(folder.path(), &format!("antrieb {written}"));
        let calls = named(&found.err);
        assert_eq!(found.code, 2, "{written}");
        assert_eq!(calls.first(), Some(&format!("antrieb commission {A} --for sinamics")), "{written}\n{}", found.err);
        assert_eq!(call(folder.path(), &calls[0]).code, 0, "{written}");
    }
}

#[test]
fn a_change_of_the_load_is_no_project_of_this_kind() {
    let folder = folder();
    for written in ["size arm.toml load +5kg", "check arm.toml load +5kg", "size arm.toml +5kg load"] {
        let found = call(folder.path(), &format!("antrieb {written}"));
        assert!(found.code < 2 && found.err.contains("mechanism.arm.mass 4 kg → 9 kg"), "{written}\n{}", found.err);
    }
}

#[test]
fn help_on_a_check_names_it_and_the_call_that_derives_it() {
    let folder = folder();
    for (written, parts) in [
        ("help thermal", ["winding temperature", "antrieb explain arm.toml --check thermal"]),
        ("help continuous_torque", ["continuous torque", "--check continuous_torque"]),
        ("Hilfe thermal", ["Wicklungstemperatur", "--check thermal"]),
    ] {
        let found = call(folder.path(), &format!("antrieb {written}"));
        assert_eq!(found.code, 0, "{written}\n{}", found.err);
        assert!(parts.iter().all(|part| found.out.contains(part)), "{written}\n{}", found.out);
    }
}

#[test]
fn a_run_without_a_code_is_that_of_the_best_actuator() {
    let folder = folder();
    let run = call(folder.path(), "antrieb simulate arm.toml --out run.csv");
    assert!(run.code < 2, "{}", run.err);
    let found = call(folder.path(), "antrieb identify arm.toml run.csv");
    assert!(found.code < 2 && found.err.contains("the best of the ranking"), "{}", found.err);
    // A record states what the call does.
    assert_eq!(call(folder.path(), "antrieb identify arm.toml run.csv --json").code, 2);
}

/// A table of words has the answers of the table of keys.
#[test]
fn headings_by_words_are_columns_of_every_move() {
    let folder = folder();
    let sweep = |name: &str, table: &str| {
        std::fs::write(folder.path().join(format!("{name}.csv")), table).unwrap();
        let found = call(folder.path(), &format!("antrieb sweep arm.toml --table {name}.csv --out {name}-best.csv"));
        let answers = std::fs::read_to_string(folder.path().join(format!("{name}-best.csv"))).unwrap_or_default();
        (found, answers)
    };
    let (_, keys) = sweep("keys", "motion[1].distance [deg],motion[3].distance [deg]\n60,-60\n120,-120\n");
    assert!(keys.lines().count() == 3, "{keys}");
    for heading in ["distance [deg]", "Weg [deg]"] {
        let (found, words) = sweep("words", &format!("{heading}\n60\n120\n"));
        assert_eq!(words, keys, "{heading}\n{}", found.err);
        std::fs::remove_file(folder.path().join("words-best.csv")).unwrap();
    }
    // An arm has an angle at its start, too.
    for heading in ["Winkel [deg]", "angle [deg]"] {
        let (found, _) = sweep("words", &format!("{heading}\n60\n120\n"));
        let names = ["mechanism.arm.start_angle", "motion[1].distance"];
        assert!(found.code == 2 && names.iter().all(|name| found.err.contains(name)), "{heading}: {}", found.err);
    }
    // Dwells fill a cycle; a table states their times.
    for heading in ["cycle [s]", "Zyklus [s]", "Taktzeit [s]"] {
        let (found, _) = sweep("cycle", &format!("{heading}\n5\n6\n"));
        assert_eq!(found.code, 2);
        assert!(found.err.contains("motion[2].time [s]") && found.err.contains("label_"), "{heading}\n{}", found.err);
    }
    // A heading that is understood and cannot stand names the label too.
    let (found, _) = sweep("twice", "motion[1].time [s],time [s]\n1,2\n");
    assert!(found.code == 2 && found.err.contains("label_time"), "{}", found.err);
}

#[test]
fn decimal_commas_of_a_binary_file_are_refused_once() {
    let folder = folder();
    let found = call(folder.path(), "antrieb sweep arm.toml --vary time=1;2s --out a.parquet --decimal-comma");
    assert_eq!(found.code, 2);
    assert_eq!(found.err.matches("--decimal-comma").count(), 1, "{}", found.err);
}

#[test]
fn a_table_without_a_file_for_its_answers_has_one_beside_it_that_replaces_nothing() {
    let folder = folder();
    let made = call(folder.path(), "antrieb new disc --out plain.toml --force");
    assert_eq!(made.code, 0, "{}", made.err);
    std::fs::write(folder.path().join("tasks.csv"), "motion[1].time [s]\n1\n2\n").unwrap();
    for file in ["tasks_answers.csv", "tasks_answers_2.csv", "tasks_answers_3.csv"] {
        let run = call(folder.path(), "antrieb sweep plain.toml tasks.csv");
        assert!(run.code == 0 && run.err.contains(&format!("--out {file}")), "{}", run.err);
        assert!(folder.path().join(file).is_file(), "{file}");
    }
    let run = call(folder.path(), "antrieb sweep plain.toml tasks.csv --json");
    assert_eq!(run.code, 2, "{}", run.err);
}

#[test]
fn a_misspelt_code_is_the_fault_of_a_call_that_needs_none() {
    let folder = folder();
    for (words, part) in
        [("CHA-25A-50-H-C1025", "`C1024`"), ("WRONG-CODE", "CHA"), ("CHA-25A-50-H-C1025 --json", "C1024")]
    {
        let run = call(folder.path(), &format!("antrieb battery {words}"));
        assert!(run.code == 2 && format!("{}{}", run.out, run.err).contains(part), "{words}\n{}", run.err);
        assert!(!run.err.contains("argument"), "{words}\n{}", run.err);
    }
}

#[test]
fn an_option_of_another_command_is_named_as_such() {
    let folder = folder();
    let run = call(folder.path(), "antrieb wiring CHA-25A-50-H-C1024 --for sinamics");
    let is_named = run.err.contains("\"--for\" is an option of `antrieb commission`, not of `antrieb wiring`");
    assert!(run.code == 2 && is_named, "{}", run.err);
}

#[test]
fn a_missing_project_is_the_fault_of_a_call_with_further_words() {
    let folder = folder();
    for words in ["size nowhere.toml load +5kg", "check nowhere.toml soon", "size nowhere.toml"] {
        let run = call(folder.path(), &format!("antrieb {words}"));
        let is_named = run.err.contains("nowhere.toml: there is no such file");
        assert!(run.code == 2 && is_named && !run.err.contains("is no argument"), "{words}\n{}", run.err);
    }
}

#[test]
fn a_heading_for_a_cycle_that_no_dwell_states_says_why_it_is_refused() {
    let folder = folder();
    let made = call(folder.path(), "antrieb new arm --out plain.toml --force");
    assert_eq!(made.code, 0, "{}", made.err);
    for heading in ["cycle [s]", "Zyklus [s]", "Taktzeit [ms]"] {
        std::fs::write(folder.path().join("tasks.csv"), format!("{heading}\n6\n7\n")).unwrap();
        let run = call(folder.path(), "antrieb sweep plain.toml tasks.csv --out best.csv");
        let unit = heading.split_once(' ').unwrap().1;
        let times = format!("motion[2].time {unit}, motion[4].time {unit}");
        let is_named = run.err.contains("no dwell of the project states `cycle`") && run.err.contains(&times);
        assert!(run.code == 2 && is_named, "{}", run.err);
        // As the refusal says.
        let text = std::fs::read_to_string(folder.path().join("plain.toml")).unwrap();
        let place = text.rfind("time = \"1 s\"").unwrap();
        let with_cycle = format!("{}cycle = \"9 s\"{}", &text[..place], &text[place + 12..]);
        std::fs::write(folder.path().join("cycle.toml"), with_cycle).unwrap();
        let run = call(folder.path(), "antrieb sweep cycle.toml tasks.csv --out best.csv --force");
        assert!(run.code < 2, "{}", run.err);
    }
}

#[test]
fn a_workbook_of_two_projects_has_the_names_of_both() {
    let folder = folder();
    let run = call(folder.path(), "antrieb workbook arm.toml belt.toml");
    assert!(run.code < 2 && run.err.contains("--out arm-belt.xlsx"), "{}", run.err);
    assert!(folder.path().join("arm-belt.xlsx").is_file(), "{}", run.out);
}

#[test]
fn a_plan_of_maintenance_of_a_delivery_to_come_begins_with_it() {
    let folder = folder();
    for words in ["2099-03-01", "--delivered 2099-03-01", "01.03.2099"] {
        let run = call(folder.path(), &format!("antrieb upkeep {A} {words}"));
        assert!(run.code == 0 && run.err.contains("--today 2099-03-01"), "{words}\n{}", run.err);
    }
    let run = call(folder.path(), &format!("antrieb upkeep {A} --delivered 2099-03-01 --json"));
    assert_eq!(run.code, 2, "{}", run.err);
}

#[test]
fn two_words_for_one_kind_are_one() {
    let folder = folder();
    for words in ["rotary table disc", "disc turntable", "lift hoist"] {
        let run = call(folder.path(), &format!("antrieb new {words}"));
        assert!(run.code == 0 && run.out.contains("format = 1"), "{words}\n{}", run.err);
    }
}

/// The calls below the help of the program work as they stand, one after the other, in an empty folder with a recording.
#[test]
fn the_calls_below_the_help_work_in_an_empty_folder() {
    for (language, head) in [("en", "Examples:"), ("de", "Beispiele:")] {
        let help = run(&["--help", "--lang", language]).out;
        let (_, below) = help.split_once(head).unwrap_or_else(|| panic!("{help}"));
        let calls: Vec<&str> = below.trim().lines().flat_map(|line| line.trim().split(" && ")).collect();
        assert!(calls.len() >= 7, "{calls:?}");
        let folder = tempfile::tempdir().unwrap();
        let turned = |place: i32| 40.0 * (1.0 - (f64::from(place) * 0.0314).cos());
        let rows = (0..=200).map(|place| format!("{:.2},{:.4},12\n", f64::from(place) * 0.01, turned(place)));
        let text = format!("time_s,position_deg,torque_nm\n{}", rows.collect::<String>());
        std::fs::write(folder.path().join("recording.csv"), text).unwrap();
        for call in calls {
            let words: Vec<&str> = call.split(' ').skip(1).collect();
            let found = run_at(folder.path(), &[&words[..], &["--lang", language]].concat());
            assert!(found.code == 0 || found.code == 1, "{call}: {} {}", found.out, found.err);
            assert!(!found.out.is_empty() || !found.err.is_empty(), "{call}");
        }
    }
}

/// The columns of a recording are those of their names, labels of axes and words of a logger aside. A column that no name
/// states is named by the user: it may hold a limit, a deviation or the quantity of another joint.
#[test]
fn a_recording_is_read_alike_under_every_heading_or_asks_for_its_columns() {
    let folder = tempfile::tempdir().unwrap();
    let mut first = None;
    for (place, (head, stated)) in [
        ("time_s,position_deg,torque_nm", ""),
        ("t_log [s],J3 angle [deg],J3 torque [Nm]", ""),
        ("log time [s],A1 Position [deg],A1 Drehmoment [Nm]", ""),
        ("time [s],angle [deg],gearbox out [Nm]", "torque=gearbox out [Nm]"),
        ("time [s],angle [deg],J3 load [Nm]", "torque=J3 load [Nm]"),
        ("time [s],angle [deg],torque limit [Nm]", "torque=torque limit [Nm]"),
        ("time [s],angle [deg],Reibmoment [Nm]", "torque=Reibmoment [Nm]"),
        ("time [s],following error [deg],torque [Nm]", "position=following error [deg]"),
        ("time [s],shoulder_pos [deg],torque [Nm]", "position=shoulder_pos [deg]"),
        ("clock [s],angle [deg],torque [Nm]", "time=clock [s]"),
    ]
    .into_iter()
    .enumerate()
    {
        let turned = |row: i32| 40.0 * (1.0 - (f64::from(row) * std::f64::consts::TAU / 200.0).cos());
        let torque = |row: i32| 12.0 + 9.0 * (f64::from(row) * std::f64::consts::TAU / 200.0).cos();
        let rows = (0..=200).map(|row| format!("{:.2},{:.4},{:.3}\n", f64::from(row) * 0.01, turned(row), torque(row)));
        let name = format!("r{place}.csv");
        std::fs::write(folder.path().join(&name), format!("{head}\n{}", rows.collect::<String>())).unwrap();
        let mut call = vec!["size", &name, "--json", "--top", "1"];
        let set = format!("motion.1.columns.{stated}");
        if !stated.is_empty() {
            let refused = run_at(folder.path(), &call);
            let (_, column) = stated.split_once('=').unwrap();
            assert!(refused.code == 2 && refused.out.contains(column), "{head}: {}{}", refused.out, refused.err);
            call.extend(["--set", &set]);
        }
        let found = run_at(folder.path(), &call);
        assert!(found.code == 0, "{head}: {}{}", found.out, found.err);
        let record: serde_json::Value = serde_json::from_str(&found.out).unwrap();
        let best = &record["ranking"][0];
        let told = (record["answer"].clone(), best["demand"].clone(), best["utilisation"].clone());
        assert!(told.0.is_string(), "{head}");
        assert_eq!(first.get_or_insert_with(|| told.clone()), &told, "{head}");
    }
}

/// Values that the heading does not state in its unit, and columns of several joints, are refused, whatever the call states.
#[test]
fn a_factor_in_a_heading_and_columns_of_two_joints_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (place, (head, stated)) in [
        ("time [s],angle [deg],torque x10 [Nm]", "torque=torque x10 [Nm]"),
        ("time [s],angle [deg],torque*10 [Nm]", ""),
        ("time [s],angle*100 [deg],torque [Nm]", ""),
        ("time [s],angle [deg],torque [Nm] (scaled 0.1)", "torque=torque [Nm] (scaled 0.1)"),
        ("time x10 [s],angle [deg],torque [Nm]", "time=time x10 [s]"),
        ("time [s],q1 [deg],tau2 [Nm]", ""),
        ("time [s],A1 Position [deg],A2 Drehmoment [Nm]", ""),
        ("time [s],angle [deg],torque [Nm],torque [Nm].1", ""),
        ("time [s],angle [deg],angle [deg]_duplicated_0,torque [Nm]", ""),
        ("time [s],Winkel vor Getriebe [deg],torque [Nm]", "position=Winkel vor Getriebe [deg]"),
    ]
    .into_iter()
    .enumerate()
    {
        let turned = |row: i32| 40.0 * (1.0 - (f64::from(row) * std::f64::consts::TAU / 200.0).cos());
        let more = head.split(',').count() - 3;
        let row =
            |row: i32| format!("{:.2},{:.4},{:.3}{}\n", f64::from(row) * 0.01, turned(row), 12.0, ",5".repeat(more));
        let name = format!("r{place}.csv");
        std::fs::write(folder.path().join(&name), format!("{head}\n{}", (0..=200).map(row).collect::<String>()))
            .unwrap();
        let set = format!("motion.1.columns.{stated}");
        let mut call = vec!["size", &name];
        if !stated.is_empty() {
            call.extend(["--set", &set]);
        }
        let found = run_at(folder.path(), &call);
        assert!(found.code == 2 && found.out.is_empty(), "{head}: {}\n{}", found.out, found.err);
    }
}

/// A payload of the call is that of every segment that states one: what a move carries, its dwell holds.
#[test]
fn a_payload_is_that_of_moves_and_of_the_dwells_that_hold_it() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(call(folder.path(), "antrieb new arm --out arm.toml").code, 0);
    let path = folder.path().join("arm.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    // The dwell behind the first move holds what that carries.
    let text = text.replacen("\n[[motion]]", "\n[[motion]]\npayload = \"5 kg\"", 2);
    std::fs::write(&path, text).unwrap();
    for (option, carried) in [("--set payload=2kg", "2kg"), ("--scale payload=0.4", "2 kg")] {
        let found = call(folder.path(), &format!("antrieb size arm.toml {option}"));
        for segment in [1, 2] {
            let key = format!("motion[{segment}].payload 5 kg → {carried}");
            assert!(found.err.contains(&key), "{option}: {key}\n{}", found.err);
        }
    }
    let swept = call(folder.path(), "antrieb sweep arm.toml --vary payload=0:4:2kg");
    assert!(swept.out.contains("motion[1].payload") && swept.out.contains("motion[2].payload"), "{}", swept.out);
    let refused = call(folder.path(), "antrieb moves arm.toml --step 4ms --out s.csv");
    assert!(refused.err.contains("antrieb moves arm.toml --every 4ms --out s.csv"), "{}", refused.err);
}

/// The calls below a ranking work as they stand, for every example; without the report, which has tests of its own.
#[test]
fn the_calls_below_a_ranking_work() {
    let mut tried = 0;
    for example in examples() {
        let ranked = run(&["size", &example]);
        let below = ranked.err.split_once("further calls:\n").map_or("", |(_, below)| below);
        for call in below.lines().map(str::trim).filter(|call| !call.is_empty() && !call.contains(" report ")) {
            let words: Vec<&str> = call.split(' ').skip(1).collect();
            let found = run(&words);
            assert!(found.code < 2 && !found.out.is_empty(), "{call}: {}", found.err);
            tried += 1;
        }
    }
    assert!(tried > 12, "{tried}");
}

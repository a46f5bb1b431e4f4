use super::*;

const TEXT: &str = "# a remark\nformat = 1\n\n[load]                # what moves\ninertia = \"1.3 kg m^2\"  # measured\n\n\
    [[motion]] # first\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n[motion.bearing]\n\
    radial_force = \"10 N\"\n\n[[motion]] # second\nlaw = \"dwell\"\ntime = \"0.5 s\"\n\n[requirements]\n\
    feedback = [\"C1024\", \"M512P\"]\n";

fn value(text: &str, path: &str) -> Option<String> {
    written(text).unwrap().into_iter().find(|key| key.path == path)?.value
}

#[test]
fn a_value_changes_and_nothing_else() {
    let changed = edit(TEXT, "load.inertia", Edit::Value("2 kg m^2")).unwrap();
    assert_eq!(changed, TEXT.replace("1.3 kg", "2 kg"));
    assert_eq!(edit(TEXT, "load.inertia", Edit::Value("1.3 kg m^2")).unwrap(), TEXT);
    let second = edit(TEXT, "motion[2].time", Edit::Value("700 ms")).unwrap();
    assert_eq!(second, TEXT.replace("0.5 s", "700 ms"));
}

#[test]
fn every_example_is_the_same_after_its_values_are_typed_again() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut count = 0;
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        for key in written(&text).unwrap() {
            let Some(value) = key.value else { continue };
            let again = edit(&text, &key.path, Edit::Value(&value)).unwrap();
            count += 1;
            let same = |text: &str| text.split_whitespace().collect::<String>().replace(",]", "]");
            assert_eq!(same(&again), same(&text), "{} {}", path.display(), key.path);
            let inputs = |text: &str| crate::inputs(text).into_iter().map(|input| (input.path, input.written));
            assert!(inputs(&again).eq(inputs(&text)), "{} {}", path.display(), key.path);
        }
    }
    assert!(count > 150, "{count}");
}

#[test]
fn a_key_that_is_new_stands_in_its_table_and_one_without_value_goes() {
    let with = edit(TEXT, "load.friction_torque", Edit::Value("5 N m")).unwrap();
    assert!(with.contains("# measured\nfriction_torque = \"5 N m\"\n"), "{with}");
    assert_eq!(edit(&with, "load.friction_torque", Edit::Value("  ")).unwrap(), TEXT);
    let stage = edit(TEXT, "stage.ratio", Edit::Value("2.5")).unwrap();
    assert!(stage.contains("# measured\n\n[stage]\nratio = 2.5\n\n[[motion]] # first\n"), "{stage}");
    let named = edit(TEXT, "axis.name", Edit::Value("arm")).unwrap();
    assert!(named.starts_with("# a remark\nformat = 1\n\n[axis]\nname = \"arm\"\n\n[load]  "), "{named}");
    assert_eq!(edit(&stage, "stage.ratio", Edit::Value("")).unwrap().matches("[stage]").count(), 1);
    let tilt = edit("format = 1\n", "mechanism.arm.axis_tilt", Edit::Value("90 deg")).unwrap();
    assert_eq!(tilt, "format = 1\n\n[mechanism.arm]\naxis_tilt = \"90 deg\"\n");
    let first = edit("format = 1\n", "motion[1].law", Edit::Value("dwell")).unwrap();
    assert!(first.contains("[[motion]]\nlaw = \"dwell\"\n"), "{first}");
}

#[test]
fn types_are_those_of_the_keys_and_what_is_none_stays_text() {
    let typed = |path: &str, value: &str| {
        let text = edit("format = 1\n", path, Edit::Value(value)).unwrap();
        text.lines().skip(2).collect::<Vec<_>>().join("\n").split_once("= ").unwrap().1.to_owned()
    };
    assert_eq!(typed("requirements.brake", "true"), "true");
    assert_eq!(typed("requirements.brake", "perhaps"), "\"perhaps\"");
    assert_eq!(typed("requirements.emergency_stops", "12"), "12");
    assert_eq!(typed("requirements.holding_safety", "1.5"), "1.5");
    assert_eq!(typed("requirements.holding_safety", "1,5"), "\"1,5\"");
    assert_eq!(typed("requirements.feedback", "C1024, RES"), "[\"C1024\", \"RES\"]");
    assert_eq!(typed("stage.ratios", "1; 2.5, 4"), "[1, 2.5, 4]");
    let rows = typed("mechanism.table.points", "0 deg; 1 kg m^2; 2 N m\n90 deg; 1 kg m^2; 0 N m");
    assert!(rows.contains("\n  [\"0 deg\", \"1 kg m^2\", \"2 N m\"],\n  [\"90 deg\""), "{rows}");
    assert_eq!(typed("load.inertia", "a \"quoted\" \\ one"), "'a \"quoted\" \\ one'");
}

/// A list typed in brackets is the one typed without.
#[test]
fn a_list_may_be_typed_as_the_file_writes_it() {
    let plain = edit(TEXT, "requirements.feedback", Edit::Value("C1024, D2048")).unwrap();
    for typed in ["[\"C1024\", \"D2048\"]", " ['C1024','D2048'] ", "[\n \"C1024\",\n \"D2048\",\n]"] {
        let listed = edit(TEXT, "requirements.feedback", Edit::Value(typed)).unwrap();
        assert_eq!(value(&listed, "requirements.feedback"), value(&plain, "requirements.feedback"), "{typed}");
    }
    let plain = edit(TEXT, "stage.ratios", Edit::Value("0.5, 6")).unwrap();
    let listed = edit(TEXT, "stage.ratios", Edit::Value("[0.5, 6]")).unwrap();
    assert_eq!(value(&listed, "stage.ratios"), value(&plain, "stage.ratios"));
    // What is no list stays what was typed, for its fault.
    let broken = edit(TEXT, "stage.ratios", Edit::Value("[0.5, 6")).unwrap();
    assert!(broken.contains("[0.5"), "{broken}");
}

#[test]
fn entries_of_a_list_come_go_and_change_places_with_all_that_is_theirs() {
    let swapped = edit(TEXT, "motion[1]", Edit::Down).unwrap();
    assert_eq!(value(&swapped, "motion[1].law").as_deref(), Some("dwell"));
    assert_eq!(value(&swapped, "motion[2].bearing.radial_force").as_deref(), Some("10 N"));
    assert!(swapped.contains("[[motion]] # first") && swapped.contains("[[motion]] # second"), "{swapped}");
    assert_eq!(edit(&swapped, "motion[1]", Edit::Down).unwrap(), TEXT);
    let more = edit(TEXT, "motion[2]", Edit::Table).unwrap();
    let more = edit(&more, "motion[2].law", Edit::Value("constant")).unwrap();
    let laws = |text: &str| -> Vec<String> {
        (1..=4).filter_map(|place| value(text, &format!("motion[{place}].law"))).collect()
    };
    assert_eq!(laws(&more), ["trapezoid", "constant", "dwell"]);
    assert_eq!(value(&more, "motion[1].bearing.radial_force").as_deref(), Some("10 N"));
    assert_eq!(value(&more, "requirements.feedback").as_deref(), Some("C1024, M512P"));
    let fewer = edit(&more, "motion[2]", Edit::Gone).unwrap();
    assert_eq!(laws(&fewer), ["trapezoid", "dwell"]);
    let none = edit(&edit(TEXT, "motion[1]", Edit::Gone).unwrap(), "motion[1]", Edit::Gone).unwrap();
    assert!(!none.contains("motion"), "{none}");
    assert_eq!(edit(TEXT, "motion[7]", Edit::Gone).unwrap(), TEXT);
}

#[test]
fn one_mechanism_takes_the_place_of_another() {
    let text = "format = 1\n[mechanism.belt]\nmass = \"1 kg\"\n[[motion]]\nlaw = \"dwell\"\n";
    let arm = edit(text, "mechanism.arm", Edit::Instead).unwrap();
    assert!(arm.contains("[mechanism.arm]") && !arm.contains("belt"), "{arm}");
    assert!(crate::key_at("mechanism.arm").is_some());
}

#[test]
fn tables_within_lines_are_changed_too() {
    let text = "format = 1\nload = { inertia = \"1 kg m^2\" }\nmotion = [ { law = \"dwell\", time = \"1 s\" } ]\n";
    let changed = edit(text, "load.inertia", Edit::Value("2 kg m^2")).unwrap();
    assert_eq!(changed, text.replace("1 kg", "2 kg"));
    let changed = edit(text, "motion[1].time", Edit::Value("3 s")).unwrap();
    assert_eq!(changed, text.replace("1 s", "3 s"));
    let more = edit(text, "motion[2]", Edit::Table).unwrap();
    assert_eq!(written(&more).unwrap().iter().filter(|key| key.path == "motion[2]").count(), 1, "{more}");
    assert!(edit(&edit(text, "motion[1]", Edit::Gone).unwrap(), "motion[1]", Edit::Gone).is_ok());
}

#[test]
fn what_has_no_place_is_reported() {
    assert_eq!(edit("format = = 1", "load.inertia", Edit::Value("1")), Err(EditFault::Syntax));
    for path in ["", ".", "load.weight", "motion[0].law", "motion[1", "motion[99999999]", "load.inertia.x", "[1]"] {
        assert_eq!(edit(TEXT, path, Edit::Value("1")), Err(EditFault::Path), "{path}");
    }
    assert_eq!(edit("load = 3\n", "load.inertia", Edit::Value("1")).unwrap(), "load = 3\n");
    assert_eq!(written("a ="), None);
}

#[test]
fn spans_are_those_of_the_values() {
    let all = written(TEXT).unwrap();
    let inertia = all.iter().find(|key| key.path == "load.inertia").unwrap();
    assert_eq!(&TEXT[inertia.span.clone()], "\"1.3 kg m^2\"");
    assert!(all.iter().any(|key| key.path == "motion[1]" && key.value.is_none()));
}

/// Comments behind the last table, switches of it in a plain project, stay behind it when a further table is made.
#[test]
fn a_new_table_follows_the_comments_of_the_last_one() {
    let text = "format = 1\n[load]\ninertia = \"1 kg m^2\"\n\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\n\
        [requirements]                  # the site\n# supply = \"560 V\"\n# brake = true   # holds\n";
    let with = edit(text, "twin.position_gain", Edit::Value("25 1/s")).unwrap();
    assert!(with.starts_with(text), "{with}");
    assert!(with.ends_with("\n\n[twin]\nposition_gain = \"25 1/s\"\n"), "{with}");
    // The switch belongs to its table once it is on.
    let on = with.replace("# brake = true", "brake = true");
    assert_eq!(value(&on, "requirements.brake").as_deref(), Some("true"));
    // A table that is made before others leaves the end of the file as it is.
    let before = edit(text, "stage.kind", Edit::Value("gear")).unwrap();
    assert!(before.ends_with("# brake = true   # holds\n"), "{before}");
    let same = edit(text, "load.friction_torque", Edit::Value("1 N m")).unwrap();
    assert!(same.ends_with("# brake = true   # holds\n"), "{same}");
    let entry = edit(text, "motion[2]", Edit::Table);
    assert!(entry.is_err() || entry.unwrap().ends_with("# brake = true   # holds\n"));
}

//! Products with a name instead of an ordering code, in every call that takes one.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::run::run_at;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Names with signs that an ordering code does not have.
const NAMES: [&str; 6] = ["NR 14/100", "HX-20", "PMX25", "Größe 3 (neu)", "a,b;c", "N. R. 5"];

const MOTION: &str = "[[motion]]\nlaw = \"polynomial_5\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n\
                      [[motion]]\nlaw = \"polynomial_5\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n";

const DATA: &str = "ratio = 50\ntorque_max = \"90 N m\"\nspeed_max = \"60 1/min\"\nspeed_motor_max = \"6000 1/min\"\n\
                    inertia_out = \"0.3 kg m^2\"\nstall_torque = \"40 N m\"\n";

/// Writes a project with a catalogue file of the names, and one whose own actuator has the first name.
fn written(folder: &Path) {
    let products = NAMES.map(|name| format!("[[actuator]]\nid = \"{name}\"\nsource = \"sheet\"\n{DATA}")).concat();
    fs::write(folder.join("stock.toml"), products).unwrap();
    let head = "format = 1\n[axis]\nname = \"x\"\n";
    let load = "[load]\ninertia = \"1 kg m^2\"\n";
    let catalogue = "[catalogue]\nfiles = [\"stock.toml\"]\n";
    fs::write(folder.join("axis.toml"), format!("{head}{catalogue}{load}{MOTION}")).unwrap();
    fs::write(folder.join("bare.toml"), format!("{head}{load}{MOTION}")).unwrap();
    let own = format!("[actuator]\nname = \"{}\"\n{DATA}", NAMES[0]);
    fs::write(folder.join("own.toml"), format!("{head}{load}{MOTION}{own}")).unwrap();
}

/// A name is that of its product by an option, as a word of the call, as a cell of a table, with `--catalogue` and as that of
/// the project's own actuator.
#[test]
fn a_name_of_any_form_is_taken_where_a_code_is() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    written(here);
    let judged = |call: &[&str]| {
        let run = run_at(here, call);
        assert!(run.code < 2, "{call:?}: {}", run.err);
        let found: Value = serde_json::from_str(&run.out).unwrap();
        let name = if found["code"].is_null() { &found["name"] } else { &found["code"] };
        name.as_str().map(str::to_owned)
    };
    for name in NAMES {
        let calls: [&[&str]; 3] = [
            &["check", "axis.toml", "--code", name, "--json"],
            &["check", "axis.toml", name, "--json"],
            &["check", "bare.toml", "--catalogue", "stock.toml", name, "--json"],
        ];
        for call in calls {
            assert_eq!(judged(call).as_deref(), Some(name), "{call:?}");
        }
        for call in [&["explain", "axis.toml", name][..], &["plot", "axis.toml", "--figure", "cycle", name]] {
            let run = run_at(here, call);
            assert!(run.code < 2, "{call:?}: {}", run.err);
        }
    }
    assert_eq!(judged(&["check", "own.toml", NAMES[0], "--json"]).as_deref(), Some(NAMES[0]));
    let words = NAMES[0].split(' ');
    let words: Vec<&str> = ["check", "axis.toml"].into_iter().chain(words).chain(["--json"]).collect();
    assert_eq!(judged(&words).as_deref(), Some(NAMES[0]));
    let compared = run_at(here, &["compare", "axis.toml", NAMES[0], NAMES[1], NAMES[2]]);
    assert!(compared.code < 2 && NAMES[..3].iter().all(|name| compared.out.contains(name)), "{}", compared.err);
}

/// A near name leads to the product.
#[test]
fn a_near_name_leads_to_that_of_the_product() {
    let folder = tempfile::tempdir().unwrap();
    written(folder.path());
    let run = run_at(folder.path(), &["check", "axis.toml", "NR 14/10"]);
    assert!(run.code == 2 && run.err.contains("--code \"NR 14/100\""), "{}", run.err);
}

/// The column `code` of a table takes the names that the project knows, and names the nearest one for another.
#[test]
fn a_column_of_codes_takes_names() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    written(here);
    let rows = |names: &[&str]| names.iter().map(|name| format!("\"{name}\"\n")).collect::<String>();
    fs::write(here.join("rows.csv"), format!("code\n{}", rows(&NAMES))).unwrap();
    let run = run_at(here, &["sweep", "axis.toml", "--table", "rows.csv", "--out", "out.csv"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let answers = fs::read_to_string(here.join("out.csv")).unwrap();
    assert!(NAMES[..4].iter().all(|name| answers.contains(name)), "{answers}");
    assert!(!answers.contains("no catalogue file"), "{answers}");
    fs::write(here.join("rows.csv"), format!("code\n{}", rows(&NAMES[..1]))).unwrap();
    let run = run_at(here, &["sweep", "own.toml", "--table", "rows.csv", "--out", "own.csv"]);
    assert_eq!(run.code, 0, "{}", run.err);
    fs::write(here.join("rows.csv"), format!("code\n{}", rows(&["NR 14/10", "CHA-25A-50-H-C1024"]))).unwrap();
    let run = run_at(here, &["sweep", "axis.toml", "--table", "rows.csv", "--out", "none.csv"]);
    assert!(run.code == 2 && run.err.contains("similar: NR 14/100"), "{}", run.err);
}

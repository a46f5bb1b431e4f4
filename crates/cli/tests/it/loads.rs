//! The load that a factor changes: that of the guide, for every mechanism, and nothing else.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::refusals::{call, named};
use crate::run::root;
use project::{LOADS, key_at, written};
use std::collections::BTreeSet;

/// Returns the rows of the table of the guide: mechanism, keys that are multiplied, keys that are not.
fn rows_of_the_guide(guide: &str) -> Vec<(String, Vec<String>, Vec<String>)> {
    let text = std::fs::read_to_string(root().join(guide)).unwrap();
    let names = |cell: &str| -> Vec<String> { cell.split('`').skip(1).step_by(2).map(str::to_owned).collect() };
    let table = text.lines().skip_while(|line| !line.contains("`load` mul")).skip(2);
    let rows = table.take_while(|line| line.starts_with('|')).flat_map(|line| {
        let cells: Vec<&str> = line.split('|').collect();
        let (scaled, kept) = (names(cells[2]), names(cells[3]));
        names(cells[1]).into_iter().map(move |name| (name, scaled.clone(), kept.clone()))
    });
    rows.collect()
}

/// A project of each mechanism with every key of a mass or an inertia stated.
fn project(kind: &str) -> String {
    let run = crate::run::run(&["new", kind]);
    assert_eq!(run.code, 0, "{}", run.err);
    let is_of_load = |line: &str| {
        let inner = line.strip_prefix("# ").unwrap_or_default();
        let key = inner.split(" = ").next().unwrap_or_default();
        ["inertia", "mass", "counterweight", "hanging"].iter().any(|end| key.ends_with(end))
            && !key.starts_with("payload")
    };
    // Of an arm the centre of mass is then stated too.
    let lines = run.out.lines().map(|line| if is_of_load(line) { line.trim_start_matches("# ") } else { line });
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_factor_changes_what_the_guide_says_and_nothing_else() {
    let rows = rows_of_the_guide("docs/guide/first-axis.md");
    assert_eq!(rows, rows_of_the_guide("docs/anleitung/first-axis.md"));
    let folder = tempfile::tempdir().unwrap();
    let mut seen = BTreeSet::new();
    for (table, _) in LOADS {
        let kind = table.rsplit('.').next().unwrap();
        let Some((_, scaled, kept)) = rows.iter().find(|(name, ..)| name == kind) else {
            assert!(["joint", "table"].contains(&kind), "{kind} is not in the guide");
            continue;
        };
        let text = project(kind);
        std::fs::write(folder.path().join("a.toml"), &text).unwrap();
        let run = call(folder.path(), "antrieb moves a.toml --scale load=1.25");
        assert_eq!(run.code, 0, "{kind}: {}\n{text}", run.err);
        let line = run.err.lines().find(|line| line.contains("× 1.25")).unwrap();
        let changed: BTreeSet<&str> = line
            .split(" → ")
            .filter_map(|part| {
                part.split(['.', ' ']).rev().find(|word| scaled.iter().chain(kept).any(|key| key == word))
            })
            .collect();
        let own = written(&text).unwrap();
        let stated = |key: &&String| {
            own.iter().any(|each| {
                each.value.is_some() && each.path.starts_with(table) && each.path.ends_with(&format!(".{key}"))
            })
        };
        let expected: BTreeSet<&str> = scaled.iter().filter(stated).map(String::as_str).collect();
        assert_eq!(changed, expected, "{kind}: {line}");
        for key in scaled.iter().chain(kept) {
            let path = if kind == "turntable" { format!("{table}.body[1].{key}") } else { format!("{table}.{key}") };
            assert!(key_at(&path).is_some() || kept.contains(key), "{path}");
        }
        let _ = seen.insert(kind);
    }
    assert!(seen.len() >= 11, "{seen:?}");
}

#[test]
fn a_factor_is_one_of_all_loads_and_a_mass_is_refused_with_a_call_for_each() {
    let folder = tempfile::tempdir().unwrap();
    for (kind, more) in [("arm", "--payload 3kg"), ("screw", "--payload 3kg"), ("hoist", "--payload 3kg")] {
        let made = call(folder.path(), &format!("antrieb new {kind} {more} --out {kind}.toml"));
        assert_eq!(made.code, 0, "{}", made.err);
        for words in ["--load +15%", "--scale load=1.15"] {
            let done = call(folder.path(), &format!("antrieb moves {kind}.toml {words}"));
            let line = done.err.lines().find(|line| line.contains("load × 1.15")).unwrap_or_default();
            assert!(line.contains(".mass") && line.contains("].payload 3kg → 3.45kg"), "{kind}: {}", done.err);
        }
        for words in ["--load 9kg", "--mass 9kg", "--mass +5kg", "--load 15%"] {
            let refused = call(folder.path(), &format!("antrieb moves {kind}.toml {words}"));
            let calls = named(&refused.err);
            assert!(refused.code == 2 && calls.len() >= 2, "{kind} {words}\n{}", refused.err);
            for proposed in calls {
                let done = call(folder.path(), &proposed);
                assert!(done.code < 2, "{proposed}\n{}", done.err);
            }
        }
    }
    for (words, part) in [
        ("--mass +5kg", "mechanism.screw.mass 40 kg → 45 kg"),
        ("--load -5kg", "mechanism.screw.mass 40 kg → 35 kg"),
        ("--mass +15%", "mechanism.screw.mass 40 kg → 46 kg"),
        ("--set mechanism.screw.mass=+5000g", "mechanism.screw.mass 40 kg → 45 kg"),
        ("--time +0.5s", "motion[1].time 3 s → 3.5 s; motion[3].time 3 s → 3.5 s"),
        ("--mass 5kg", "mechanism.screw.mass 40 kg → 5kg"),
    ] {
        let made = call(folder.path(), "antrieb new screw --out plain.toml --force");
        assert_eq!(made.code, 0, "{}", made.err);
        let done = call(folder.path(), &format!("antrieb moves plain.toml {words}"));
        assert!(done.code == 0 && done.err.contains(part), "{words}\n{}", done.err);
    }
    let way = call(folder.path(), "antrieb moves plain.toml --distance +10mm");
    assert!(way.code == 2 && named(&way.err).len() == 2, "{}", way.err);
}

/// A mass for a load that is a moment of inertia or a torque is refused with the keys of the load; the proposed calls work.
#[test]
fn a_mass_is_added_to_the_load_or_refused_with_what_the_load_is() {
    let folder = tempfile::tempdir().unwrap();
    let made = call(folder.path(), "antrieb new turntable --out axis.toml");
    assert_eq!(made.code, 0, "{}", made.err);
    let (mut refused, mut taken) = (0, 0);
    for (table, _) in LOADS {
        let kind = table.rsplit('.').next().unwrap();
        // A joint reads a recording.
        if ["joint", "table"].contains(&kind) {
            continue;
        }
        let made = call(folder.path(), &format!("antrieb new {kind} --out {kind}.toml"));
        assert_eq!(made.code, 0, "{}", made.err);
        for words in ["load +5kg", "--load +5kg", "--load 5kg", "--mass 5kg", "--payload 5kg", "--set payload=5kg"] {
            let run = call(folder.path(), &format!("antrieb moves {kind}.toml {words}"));
            if run.code == 0 {
                taken += 1;
                continue;
            }
            let calls = named(&run.err);
            assert!(run.code == 2 && !calls.is_empty(), "{kind} {words}\n{}", run.err);
            if run.err.contains("0.05 kg m²") {
                refused += 1;
                assert!(run.err.contains(table), "{kind} {words}\n{}", run.err);
            }
            for proposed in calls {
                let done = call(folder.path(), &proposed);
                assert!(done.code < 2, "{proposed}\n{}", done.err);
            }
        }
    }
    assert!(refused >= 12 && taken >= 20, "{refused} {taken}");
}

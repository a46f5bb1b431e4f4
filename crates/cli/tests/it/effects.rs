//! Options: each changes the answer of a call, or is refused in it.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "a test fails loudly")]

use crate::refusals::call;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

const CODE: &str = "CHA-14A-30-N-D2048-B";
const ENCODER: &str = "CHA-25A-100-H-M512P";

/// Calls of the commands with options.
fn calls() -> Vec<String> {
    let of_project = |command: &str| format!("antrieb {command} axis.toml --code {CODE}");
    let of_code = |command: &str| format!("antrieb {command} {ENCODER}");
    vec![
        "antrieb size axis.toml".to_owned(),
        of_project("check"),
        "antrieb sweep axis.toml --vary mass=20kg;30kg".to_owned(),
        of_project("explain"),
        of_project("simulate"),
        format!("antrieb plot axis.toml --code {CODE} --figure cycle"),
        of_code("wiring"),
        of_code("encoder"),
        of_code("curve"),
        format!("antrieb upkeep {ENCODER} --delivered 2026-01-02 --today 2026-03-01"),
        "antrieb new screw".to_owned(),
        format!("antrieb commission {ENCODER} --for sinamics"),
    ]
}

/// Values of options with a value.
const VALUES: [(&str, &str); 34] = [
    ("top", "7"),
    ("samples", "9"),
    ("seed", "5"),
    ("date", "2026-01-02"),
    ("revision", "B"),
    ("title", "T"),
    ("number", "N"),
    ("author", "AU"),
    ("company", "CO"),
    ("customer", "CU"),
    ("order", "OR"),
    ("check", "thermal"),
    ("steps", "3"),
    ("inputs", "all"),
    ("at", "0.5s"),
    ("reaction", "coast"),
    ("failure", "track"),
    ("cycles", "2"),
    ("hours-per-day", "8"),
    ("every", "10ms"),
    ("signals", "current"),
    ("figure", "simulation"),
    ("theme", "dark"),
    ("width", "150mm"),
    ("height", "100mm"),
    ("svg", "o.svg"),
    ("png", "o.png"),
    ("connector", "motor"),
    ("length", "5m"),
    ("cross-section", "1.5mm^2"),
    ("turn", "3"),
    ("ambient", "35degC"),
    ("name", "plan"),
    ("ical", "o.ics"),
];

/// Options of every command, and those whose effect depends on the data of the actuator.
const LEFT_OUT: [&str; 9] = ["json", "lang", "help", "set", "scale", "catalogue", "deadline", "memory", "window"];

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder).unwrap().flatten();
    entries
        .map(|entry| (entry.file_name().into_string().unwrap(), std::fs::read(entry.path()).unwrap()))
        .filter(|(name, _)| name != "axis.toml")
        .collect()
}

#[test]
fn an_option_changes_the_answer_or_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(call(folder.path(), "antrieb new screw --out axis.toml").code, 0);
    let clean = || files(folder.path()).keys().for_each(|name| std::fs::remove_file(folder.path().join(name)).unwrap());
    let (mut ignored, mut count) = (Vec::new(), 0);
    for base in calls() {
        let command = base.split(' ').nth(1).unwrap();
        let plain = call(folder.path(), &base);
        assert!(plain.code < 2, "{base}\n{}", plain.err);
        clean();
        let help = call(folder.path(), &format!("antrieb {command} --help")).out;
        let options: BTreeSet<&str> = help
            .lines()
            .filter_map(|line| line.trim_start().strip_prefix("--").or_else(|| line.split(", --").nth(1)))
            .map(|rest| rest.split([' ', '=']).next().unwrap())
            .collect();
        for option in
            options.into_iter().filter(|option| !LEFT_OUT.contains(option) && !base.contains(&format!("--{option} ")))
        {
            let takes_value = help.contains(&format!("--{option} <"));
            let value = VALUES.iter().find(|(name, _)| *name == option).map(|(_, value)| format!(" {value}"));
            let Some(value) = (if takes_value { value } else { Some(String::new()) }) else { continue };
            let written = format!("{base} --{option}{value}");
            let run = call(folder.path(), &written);
            count += 1;
            if run.code < 2 && run.out == plain.out && files(folder.path()).is_empty() {
                ignored.push(written);
            } else if run.code == 2 {
                assert!(run.err.starts_with("error: "), "{written}\n{}", run.err);
            }
            clean();
        }
    }
    assert!(ignored.is_empty() && count > 60, "{count}: {ignored:#?}");
}

#[test]
fn what_an_option_needs_is_named_and_works() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(call(folder.path(), "antrieb new screw --out axis.toml").code, 0);
    for (written, needed) in [
        ("antrieb simulate axis.toml --at 0.5s", "--scenario"),
        ("antrieb simulate axis.toml --reaction coast", "--scenario"),
        ("antrieb simulate axis.toml --every 10ms", "--out"),
        ("antrieb simulate axis.toml --theme dark", "--svg"),
        ("antrieb size axis.toml --force", "--report"),
        ("antrieb curve CHA-25A-100-H-M512P --width 150mm", "--svg"),
        ("antrieb upkeep CHA-25A-100-H-M512P --name plan", "--ical"),
    ] {
        let refused = call(folder.path(), written);
        assert!(refused.code == 2 && refused.err.contains(needed), "{written}\n{}", refused.err);
        let proposed = crate::refusals::named(&refused.err);
        assert!(!proposed.is_empty(), "{written}\n{}", refused.err);
    }
    // A time without its option is one of the motion.
    let bare = call(folder.path(), "antrieb size axis.toml 2s");
    assert!(bare.code == 2 && bare.err.contains("motion[1].time=2s") && !bare.err.contains("deadline"), "{}", bare.err);
}

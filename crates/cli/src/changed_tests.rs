//! Changes of a call over every key of every project of the examples and of every new one.

use super::*;
use crate::source::SourceFile;
use project::{KEYS, Key, example};
use questions::list::new::{template, template_kinds};
use std::collections::BTreeMap;
use std::path::Path;

/// Returns the answer to a call with options that change the project.
fn made(text: &str, options: &[&str]) -> Result<Option<Changed>, String> {
    changed(text, &Statements::of_words(options), Language::En).map_err(|why| format!("{why:?}"))
}

/// Returns the texts of the examples and of the new projects, each with its name.
fn projects() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let files = std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path());
    let files = files.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let examples = files.map(|path| (path.display().to_string(), std::fs::read_to_string(path).unwrap()));
    let new = template_kinds().filter_map(|kind| Some((kind.to_owned(), template(kind, "axis", Language::En)?.text)));
    let found: Vec<(String, String)> = examples.chain(new).filter(|(_, text)| written(text).is_some()).collect();
    assert!(found.len() > 20, "{}", found.len());
    found
}

/// Collects the paths of the keys below some tables without numbers of entries, each with an example of its value.
fn paths(keys: &'static [Key], above: &str, found: &mut Vec<(String, String)>) {
    for key in keys {
        let path = if above.is_empty() { key.name.to_owned() } else { format!("{above}.{}", key.name) };
        let below: Vec<&'static [Key]> =
            [key.kind.keys(false), key.kind.keys(true)].into_iter().filter(|keys| !keys.is_empty()).collect();
        for keys in &below {
            paths(keys, &path, found);
        }
        let is_single = !matches!(key.kind, Kind::Rows(_) | Kind::Bodies | Kind::Numbers(..));
        if below.is_empty() && is_single {
            let line = example(key).unwrap();
            let value = line.split_once(" = ").unwrap().1.trim_matches(['"', '[', ']']).to_owned();
            found.push((path, value));
        }
    }
}

fn values(text: &str) -> BTreeMap<String, String> {
    let all = written(text).unwrap().into_iter();
    all.filter_map(|each| Some((each.path, each.value?))).collect()
}

/// Step between the keys that are tried with one project.
const STRIDE: usize = 13;

#[test]
fn a_change_that_is_reported_changes_the_project_at_the_reported_key() {
    let mut keys = Vec::new();
    paths(KEYS, "", &mut keys);
    keys.sort();
    keys.dedup();
    assert!(keys.len() > 250, "{}", keys.len());
    let (mut taken, mut refused) = (0_usize, 0_usize);
    for (place, (name, text)) in projects().into_iter().enumerate() {
        let before = values(&text);
        // One key of so many of each project, others of the next one.
        for (path, value) in keys.iter().skip(place % STRIDE).step_by(STRIDE) {
            let last = path.rsplit('.').next().unwrap();
            let first = path.replacen("motion.", "motion[1].", 1).replacen("body.", "body[1].", 1);
            for spelt in [path.clone(), first, last.to_owned(), path.to_uppercase(), path.replace('_', "-")] {
                let change = format!("{spelt}={value}");
                let Ok(done) = made(&text, &["--set", &change]) else {
                    refused += 1;
                    continue;
                };
                let done = done.unwrap();
                let after = values(&done.text);
                taken += 1;
                let is_stated = done.made.iter().flat_map(|made| made.split("; ")).all(|made| {
                    let Some((key, rest)) = made.split_once(' ') else { return false };
                    let Some((from, to)) = rest.split_once(" → ") else { return true };
                    let is_same = before.get(key).map_or("–", String::as_str) == from;
                    let to = if to == "–" { None } else { Some(to) };
                    let now = after.get(key).map(String::as_str);
                    is_same
                        && (now == to || key_at(key).is_some_and(|key| !keys::is_measured(key.kind)) && now.is_some())
                });
                assert!(is_stated, "{name}: {change}: {:?}", done.made);
            }
        }
    }
    assert!(taken > 600 && refused > 600, "{taken} {refused}");
}

#[test]
fn a_key_of_a_list_without_its_entry_is_the_only_one_or_refused_with_the_lines_to_write() {
    for (name, text) in projects() {
        for each in written(&text).unwrap().iter().filter(|each| each.value.is_some() && each.path.contains(']')) {
            let plain: String =
                each.path.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest)).collect();
            let value = each.value.clone().unwrap();
            // A list is typed in brackets.
            if key_at(&each.path).is_none_or(|key| !keys::is_measured(key.kind)) {
                continue;
            }
            match made(&text, &["--set", &format!("{plain}={value}")]) {
                Ok(done) => assert!(done.unwrap().made[0].starts_with(&each.path), "{name}: {plain}"),
                Err(refusal) => assert!(
                    refusal.contains(&format!("{}={value}", each.path)) || refusal.contains("write:"),
                    "{name}: {plain}: {refusal}"
                ),
            }
        }
    }
}

/// Returns what the echo of a call says: the changes, and what follows from them.
fn echoed(text: &str, options: &[&str], language: Language) -> Vec<String> {
    let mut file = SourceFile::of_text("axis.toml".to_owned(), text.as_bytes().to_vec(), Path::new(""), 1 << 30);
    file.change(&Statements::of_words(options), language).unwrap_or_default()
}

/// Returns the numbers of a text.
fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn a_cycle_that_the_call_does_not_name_is_echoed() {
    let mut seen = 0;
    for (name, text) in projects().into_iter().filter(|(_, text)| !text.contains("recorded")) {
        let said = echoed(&text, &["--scale", "time=0.5"], Language::En);
        let cycle = |said: &[String]| {
            let is_it = |each: &&String| {
                each.rsplit(": ").next().is_some_and(|each| each.starts_with("cycle ")) && each.contains(" → ")
            };
            said.iter().find(is_it).cloned()
        };
        if let Some(cycle) = cycle(&said)
            && let [before, after] = numbers(&cycle)[..]
        {
            assert!((before - 2.0 * after).abs() < 1e-4 * before, "{name}: {said:?}");
            seen += 1;
        }
        assert_eq!(cycle(&echoed(&text, &["--set", "requirements.ambient=21 degC"], Language::En)), None, "{name}");
        assert_eq!(cycle(&echoed(&text, &["--set", "cycle=50 s"], Language::En)), None, "{name}");
    }
    assert!(seen > 10, "{seen}");
    let table = template("turntable", "axis", Language::En).unwrap().text;
    let said = echoed(&table, &["--set", "time=0.4s"], Language::De);
    assert!(said.last().is_some_and(|said| said.starts_with("Zyklus ")), "{said:?}");
}

#[test]
fn a_new_payload_is_echoed_with_the_mass_of_the_mechanism() {
    let mut seen = Vec::new();
    for (name, text) in projects() {
        let said = echoed(&text, &["--set", "payload=7kg"], Language::En);
        let sum = said.iter().find(|each| each.contains("moved mass"));
        let all = written(&text).unwrap();
        let is_several = all.iter().any(|each| each.path.starts_with("axis[2]"));
        let has_payload = all.iter().any(|each| each.path.ends_with("].payload"));
        let is_load = |path: &str| {
            let of_table = |(table, keys): &(&str, &[&str])| {
                path.strip_prefix(table).is_some_and(|key| keys.contains(&key.trim_start_matches('.')))
            };
            path.starts_with("mechanism.turntable.body[") || project::LOADS.iter().any(of_table)
        };
        let is_own =
            |key: &&Written| key.path.ends_with("mass") && key.path.starts_with("mechanism.") && is_load(&key.path);
        let of_load = all.iter().find(is_own);
        if said.is_empty() || is_several {
            continue;
        }
        let is_due = of_load.is_some() && !has_payload && project::takes_payload(&all, "");
        let is_zero = of_load.and_then(|each| each.value.as_deref()).is_some_and(|value| value.starts_with("0 "));
        assert_eq!(sum.is_some(), is_due && !is_zero, "{name}: {said:?}");
        if let Some(sum) = sum {
            let [own, payload, both] = numbers(sum)[..] else { panic!("{sum}") };
            assert!(payload == 7.0 && (own + payload - both).abs() < 1e-4 * both, "{name}: {sum}");
            seen.push(of_load.unwrap().path.clone());
        }
    }
    seen.sort();
    seen.dedup();
    assert!(seen.len() > 3, "{seen:?}");
}

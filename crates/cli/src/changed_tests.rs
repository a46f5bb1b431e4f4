//! Changes of a call over every key of every project of the examples and of every new one.

use super::*;
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

//! A value of a derivation that the file leaves open is graded assumed, and its source says that the key is not stated.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::catalogue_actuators;
use axis::Files;
use provenance::{Grade, Source};
use quantities::Language;
use questions::explain;
use questions::list::new::{example, template, template_kinds};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{Cursor, Read};

/// Recording of a template.
struct Recording(Option<(String, String)>);

impl Files for Recording {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        let found = self.0.as_ref().filter(|(file, _)| file == name);
        let (_, text) = found.ok_or(std::io::ErrorKind::NotFound)?;
        Ok(Box::new(Cursor::new(text.clone().into_bytes())))
    }
}

/// Returns the paths of the keys that a file states.
fn stated(text: &str) -> BTreeSet<String> {
    let (mut table, mut counts) = (String::new(), BTreeMap::<String, usize>::new());
    let mut found = BTreeSet::new();
    for line in text.lines() {
        let line = line.trim();
        if let Some(name) = line.strip_prefix("[[").and_then(|rest| rest.split("]]").next()) {
            let count = counts.entry(name.to_owned()).or_default();
            *count += 1;
            table = format!("{name}[{count}].");
        } else if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.split(']').next()) {
            // A table below one of several belongs to the last of them.
            let (head, rest) = name.split_once('.').unwrap_or((name, ""));
            table = match counts.get(head) {
                Some(count) if !rest.is_empty() => format!("{head}[{count}].{rest}."),
                _ => format!("{name}."),
            };
        } else if let Some((key, _)) = line.split_once('=').filter(|_| !line.starts_with('#')) {
            found.insert(format!("{table}{}", key.trim()));
        }
    }
    found
}

/// Returns `true` if a key, a part of its value, or a key of its table is stated.
fn is_stated(key: &str, stated: &BTreeSet<String>) -> bool {
    let is_within = |inner: &str, outer: &str| {
        inner.strip_prefix(outer).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
    };
    stated.iter().any(|path| is_within(path, key) || is_within(key, path))
}

#[test]
fn no_derivation_cites_a_key_that_the_file_does_not_state() {
    let (mut wrong, mut open, mut seen) = (BTreeSet::new(), BTreeSet::new(), 0);
    let of_kind = |kind| [template, example].map(|of| (kind, of(kind, "axis.toml", Language::En).unwrap()));
    for (kind, template) in template_kinds().flat_map(of_kind) {
        let stated = stated(&template.text);
        let project = questions::read_all(&template.text, &Recording(template.recording)).unwrap().remove(0);
        for (code, _) in catalogue_actuators().step_by(211) {
            let Ok(candidate) = explain(&project, code) else { continue };
            let checks = &candidate.judgement.checks;
            for step in checks.iter().flat_map(|check| check.workings.iter()) {
                match &step.source {
                    Source::Project { key } => {
                        seen += 1;
                        if !key.split(", ").any(|key| is_stated(key, &stated)) {
                            wrong.insert(format!("{kind}: {} = {} cites {key}", step.symbol, step.si));
                        }
                    }
                    Source::NotStated { key } => {
                        open.insert(key.to_string());
                        let texts =
                            [Language::En, Language::De].map(|language| words::source_text(&step.source, language));
                        if key.split(", ").any(|key| stated.contains(key))
                            || step.grade != Grade::Assumed
                            || texts != [format!("{key} not stated"), format!("{key} nicht angegeben")]
                        {
                            wrong.insert(format!("{kind}: {} = {} leaves {key} open", step.symbol, step.si));
                        }
                    }
                    _ => {}
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(open.len() > 10 && seen > 1000, "{seen} {open:#?}");
}

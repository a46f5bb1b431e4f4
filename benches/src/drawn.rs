//! Projects at the extremes of their keys: every key of every section, from the schema that the reader of the project
//! file uses, with values far from those of the examples. New keys and mechanisms are included without a change here.

use axis::Files;
use mechanism::MechanismId;
use project::{Edit, edit, schema};
use serde_json::Value;
use std::collections::BTreeSet;

/// A project that is read without a fault.
pub struct Drawn {
    /// Mechanism, and the multiplied element.
    pub name: String,
    /// Text of the file.
    pub text: String,
    /// Keys that it states in addition to its example.
    pub keys: Vec<String>,
}

/// Pseudo-random numbers, the same on every run.
pub struct Chance(u64);

impl Chance {
    /// Creates the generator of a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed ^ 0x9e37_79b9_7f4a_7c15)
    }

    /// Returns a number from zero to below `count`.
    pub const fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if count == 0 { 0 } else { (self.0 >> 33) as usize % count }
    }

    fn of<'t, T>(&mut self, all: &'t [T]) -> Option<&'t T> {
        all.get(self.below(all.len()))
    }
}

/// A key with its description in the schema.
pub type SchemaKey = (String, Value);

/// Returns every key of a section that holds a single value, by its path.
#[must_use]
pub fn keys(schema: &Value, path: &str) -> Vec<SchemaKey> {
    let mut found = Vec::new();
    for (name, about) in schema.get("properties").and_then(Value::as_object).into_iter().flatten() {
        let path = format!("{path}.{name}");
        match about.get("type").and_then(Value::as_str) {
            Some("object") => found.extend(keys(about, &path)),
            // Lists are multiplied, not drawn.
            Some("array") => {}
            _ => found.push((path, about.clone())),
        }
    }
    found
}

/// Powers of ten by which a quantity deviates from its example.
const POWERS: [i32; 8] = [-4, -3, -2, -1, 1, 2, 3, 4];

/// Returns a value for a key: an extreme of its range, or its example times a power of ten.
fn value(about: &Value, stated: Option<&str>, chance: &mut Chance) -> Option<String> {
    if let Some(words) = about.get("enum").and_then(Value::as_array) {
        return chance.of(words)?.as_str().map(str::to_owned);
    }
    match about.get("type").and_then(Value::as_str) {
        Some("boolean") => return chance.of(&["true", "false"]).map(|word| (*word).to_owned()),
        Some("integer" | "number") => {
            let ends = ["minimum", "maximum"].map(|end| about.get(end).and_then(Value::as_f64));
            return chance.of(&ends)?.map(|end| end.to_string());
        }
        _ => {}
    }
    let example =
        about.get("examples").and_then(Value::as_array).and_then(|examples| examples.first()).and_then(Value::as_str);
    let (number, unit) = stated.or(example)?.split_once(' ')?;
    let power = *chance.of(&POWERS)?;
    Some(format!("{} {unit}", number.parse::<f64>().ok()? * 10_f64.powi(power)))
}

/// Returns the value that the text states for a path, from the line of its key in its section.
fn stated<'t>(text: &'t str, path: &str) -> Option<&'t str> {
    let (section, key) = path.rsplit_once('.')?;
    let behind = text.split_once(&format!("\n[{section}]"))?.1;
    let section = behind.split("\n[").next()?;
    let line = section.lines().find(|line| line.split('=').next().is_some_and(|name| name.trim() == key))?;
    line.split('"').nth(1)
}

/// Recording that the example of a joint names.
pub const RECORDING: (&str, &str) = ("robot-joint.csv", include_str!("../../examples/robot-joint.csv"));

/// Files of a drawn project.
struct Example;

impl Files for Example {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(RECORDING.1.as_bytes()))
    }
}

fn reads(text: &str) -> bool {
    questions::read_all(text, &Example).is_ok()
}

/// Sections that any project may have.
const SHARED: [&str; 6] = ["axis", "stage", "bearing", "requirements", "drive", "twin"];

/// Returns the keys that projects of a mechanism may state.
#[must_use]
pub fn keys_of(id: MechanismId) -> Vec<SchemaKey> {
    let root = schema(&|_| String::new());
    let section = |path: &str| {
        path.split('.').try_fold(&root, |about, name| about.get("properties")?.get(name)).unwrap_or(&Value::Null)
    };
    let own = if id == MechanismId::Load { "load".to_owned() } else { format!("mechanism.{}", id.key()) };
    let sections = std::iter::once(own.as_str()).chain(SHARED);
    sections.flat_map(|path| keys(section(path), path)).collect()
}

/// Draws a project of a mechanism with values at the extremes; a value is kept if the project can be read with it.
#[must_use]
pub fn drawn(id: MechanismId, seed: u64) -> Drawn {
    let mut chance = Chance::new(seed);
    let mut text = id.example().to_owned();
    let mut kept = Vec::new();
    for (path, about) in keys_of(id) {
        // About every second key; the others stay as in the example.
        if chance.below(2) == 0 {
            continue;
        }
        let Some(value) = value(&about, stated(&text, &path), &mut chance) else { continue };
        let Ok(with) = edit(&text, &path, Edit::Value(&value)) else { continue };
        if reads(&with) {
            text = with;
            kept.push(path);
        }
    }
    Drawn { name: format!("{} at the extremes, seed {seed}", id.key()), text, keys: kept }
}

/// Returns the text with its moves repeated, each time a little slower, so that none is equal to another; `None` if it
/// cannot be read.
#[must_use]
pub fn repeated(text: &str, times: usize) -> Option<String> {
    let mut parts: Vec<String> = Vec::new();
    for line in text.lines() {
        if line.starts_with('[') || parts.is_empty() {
            parts.push(String::new());
        }
        let part = parts.last_mut()?;
        part.push_str(line);
        part.push('\n');
    }
    let is_move = |part: &String| part.starts_with("[[motion]]");
    let moves: Vec<&String> = parts.iter().filter(|part| is_move(part)).collect();
    let slower = |part: &str, time: usize| -> String {
        let line = |line: &str| {
            let stretched =
                line.strip_prefix("time = \"").and_then(|rest| rest.split_once(' ')).and_then(|(number, rest)| {
                    let number: f64 = number.parse().ok()?;
                    Some(format!("time = \"{} {rest}\n", number * (1.0 + 1e-4 * time as f64)))
                });
            stretched.unwrap_or_else(|| format!("{line}\n"))
        };
        part.lines().map(line).collect()
    };
    let all = (0..times).flat_map(|time| moves.iter().map(move |part| (part, time)));
    let all: String = all.map(|(part, time)| slower(part, time)).collect();
    let others: String = parts.iter().filter(|part| !is_move(part)).map(String::as_str).collect();
    let found = others + &all;
    reads(&found).then_some(found)
}

/// Returns the text with a tolerance of the first quantity that can have one; `None` if none can.
#[must_use]
pub fn toleranced(text: &str) -> Option<String> {
    let sections: BTreeSet<&str> = text.lines().filter_map(|line| line.strip_prefix('[')?.strip_suffix(']')).collect();
    let of = sections.iter().filter(|section| section.starts_with("mechanism.") || **section == "load");
    of.flat_map(|section| text.split_once(&format!("\n[{section}]")).map(|(_, behind)| behind.split("\n[").next()))
        .flatten()
        .flat_map(str::lines)
        .filter_map(|line| {
            let quantity = line.split('"').nth(1).filter(|quantity| quantity.contains(' '))?;
            Some(text.replacen(line, &line.replacen(quantity, &format!("{quantity} ± 10 %"), 1), 1))
        })
        .find(|text| reads(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requires that each key of the schema is drawn in some project, and that each project states some.
    #[test]
    fn every_key_is_drawn_and_some_are_kept() {
        for id in MechanismId::ALL.iter().copied() {
            let paths: Vec<String> = keys_of(id).into_iter().map(|(path, _)| path).collect();
            assert!(paths.len() > 60, "{}: {paths:?}", id.key());
            let projects: Vec<Drawn> = (0..3).map(|seed| drawn(id, seed)).collect();
            assert!(projects.iter().all(|project| reads(&project.text)), "{}", id.key());
            let kept: BTreeSet<&String> = projects.iter().flat_map(|project| &project.keys).collect();
            assert!(kept.len() > 15, "{}: {kept:?}", id.key());
            let own = |path: &&&String| path.starts_with("mechanism.") || path.starts_with("load.");
            assert!(kept.iter().filter(own).count() > 1 || id == MechanismId::Joint, "{}: {kept:?}", id.key());
        }
    }
}

//! New projects with other values: each is read by the other commands without a fault, or refused.

use crate::command::build_for;
use crate::dispatch;
use axis::{Files, NoFiles};
use project::{KEYS, Key, Kind, example, key_at, written};
use quantities::Language;
use questions::list::{Unanswered, new};
use std::ffi::OsString;
use std::io::Read;

/// Words for values that people state, and those of several moves.
const WORDS: [&str; 24] = [
    "payload=2kg",
    "nutzlast=2,5kg",
    "payload_inertia=0.01 kg m^2",
    "mass=12kg",
    "diameter=0.3m",
    "length=0.5m",
    "time=2s",
    "distance=45deg",
    "distance=100mm",
    "speed=20rpm",
    "speed=0.2m/s",
    "acceleration=2rad/s^2",
    "cycle=30s",
    "pause=3s",
    "hold=brake",
    "brake=true",
    "stations=8",
    "inclination=90deg",
    "lead=20mm",
    "process_torque=5Nm",
    "process_force=50N",
    "supply=48V",
    "ambient=40degC",
    "stage=2",
];

/// The recording of a template, beside its project.
struct Recording(Option<(String, String)>);

impl Files for Recording {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        match &self.0 {
            Some((own, text)) if own == name => Ok(Box::new(std::io::Cursor::new(text.clone().into_bytes()))),
            _ => NoFiles.open(name),
        }
    }
}

/// Visits every value below these keys with its path in a project of a kind.
fn walk(keys: &'static [Key], above: &str, each: &mut impl FnMut(&str, &'static Key)) {
    for key in keys {
        let path = if above.is_empty() { key.name.to_owned() } else { format!("{above}.{}", key.name) };
        match (key.kind.keys(false), key.kind) {
            ([], _) => each(&path, key),
            (inside, Kind::Variants(_)) => {
                walk(inside, &format!("{path}[1]"), each);
                walk(inside, &format!("{path}[2]"), each);
            }
            (inside, _) => walk(inside, &path, each),
        }
    }
}

/// Returns every value of a key that stands for its permissible ones.
fn values(key: &Key) -> Vec<String> {
    match key.kind {
        Kind::OneOf(words) => words.iter().map(|word| (*word).to_owned()).collect(),
        Kind::Bool => vec!["true".to_owned(), "false".to_owned()],
        _ => {
            let line = example(key).unwrap_or_default();
            let value = line.split_once(" = ").map(|(_, value)| value.trim_matches('"').to_owned());
            value.into_iter().collect()
        }
    }
}

/// Returns the text of a new project, or its refusal.
fn made(kind: &str, more: &[String]) -> Result<String, Unanswered> {
    let own = ["antrieb", "new", kind].map(str::to_owned);
    let words: Vec<OsString> = own.iter().chain(more).map(OsString::from).collect();
    let matches = build_for(&words, Language::En).try_get_matches_from(&words).unwrap();
    dispatch(&matches, Language::En).map(|answer| answer.data)
}

/// Number of kinds of which one tries a key; a word is tried in all of them.
const KINDS_OF_A_KEY: usize = 3;

/// Returns the words and the keys of a project, each with a value that it may have.
fn sets(text: &str, number: usize) -> Vec<String> {
    let stated = written(text).unwrap();
    let mut sets: Vec<String> = WORDS.map(str::to_owned).to_vec();
    let mut place = number;
    walk(KEYS, "", &mut |path, key| {
        place += 1;
        let of_other = path.starts_with("mechanism.")
            && !stated
                .iter()
                .any(|each| each.path.starts_with("mechanism.") && path.starts_with(&format!("{}.", each.path)));
        let is_due = place.is_multiple_of(KINDS_OF_A_KEY) || path.starts_with("mechanism.");
        if is_due && !of_other && !path.starts_with("axis[") && key_at(path).is_some() {
            sets.extend(values(key).iter().map(|value| format!("{path}={value}")));
        }
    });
    sets
}

#[test]
fn a_new_project_with_other_values_is_read_or_refused() {
    let (mut read, mut refused) = (0, 0);
    for (number, kind) in new::template_kinds().enumerate() {
        let templates =
            [new::template(kind, new::USUAL_NAME, Language::En), new::example(kind, new::USUAL_NAME, Language::En)];
        for (template, option) in templates.into_iter().zip(["", "--example"]) {
            let template = template.unwrap();
            let sets = if option.is_empty() { sets(&template.text, number) } else { WORDS.map(str::to_owned).to_vec() };
            for set in sets {
                let more = [option, "--set", &set].into_iter().filter(|word| !word.is_empty()).map(str::to_owned);
                let more: Vec<String> = more.collect();
                match made(kind, &more) {
                    Ok(text) => {
                        let files = Recording(template.recording.clone());
                        let faults = questions::read_all(&text, &files).err();
                        assert!(faults.is_none(), "{kind} {more:?}: {faults:?}");
                        read += 1;
                    }
                    Err(why) => {
                        let faults = why.faults(None, Language::En);
                        assert!(faults.errors.iter().all(|fault| !fault.message.is_empty()), "{kind} {more:?}");
                        refused += 1;
                    }
                }
            }
        }
    }
    assert!(read > 500 && refused > 100, "{read} {refused}");
}

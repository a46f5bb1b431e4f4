//! A project with other values for one call: `--set KEY=VALUE` and `--scale WHAT=FACTOR`.

pub(crate) mod keys;

use crate::command::typed::{number_and_unit, typed};
use clap::ArgMatches;
use project::{
    Edit, Kind, Written, distance_of_stations, edit, key_at, load_scaled, other_names, paced, stretch, truth, written,
};
use quantities::{Language, seen};
use questions::list::Unanswered;
use std::borrow::Cow;
use words::{Usage, UsageHint, terminal, usage_hint, usage_text};

/// Quantities that a call may scale.
pub(crate) const SCALED: [&str; 4] = ["load", "payload", "time", "distance"];

/// Largest number of characters of a change in the name of the project.
const NAMED_MOST: usize = 120;

/// Largest number of characters of the changes in a file name.
#[cfg(feature = "report")]
const FILE_NAME_MOST: usize = 80;

/// Largest number of keys that a refusal names.
const NAMED_KEYS_MOST: usize = 4;

/// A text with the changes of a call.
pub(crate) struct Changed {
    pub(crate) text: String,
    /// Changes as they were made: key, value before and after.
    pub(crate) made: Vec<String>,
}

/// Applies the changes of a call to the text of a project; `None` without changes, or for a text that is no TOML, whose
/// faults are reported when it is read.
///
/// # Errors
/// Every change that cannot be made.
pub(crate) fn changed(text: &str, matches: &ArgMatches, language: Language) -> Result<Option<Changed>, Unanswered> {
    let given = |name: &str| -> Vec<String> {
        let all = matches.try_get_many::<String>(name).ok().flatten();
        all.map(|all| all.cloned().collect()).unwrap_or_default()
    };
    let (sets, scales) = (given("set"), given("scale"));
    if sets.is_empty() && scales.is_empty() {
        return Ok(None);
    }
    let Some(prefix) = prefix(text, matches.try_get_one::<String>("axis").ok().flatten()) else { return Ok(None) };
    let (mut changed, mut faults) = (Changed { text: text.to_owned(), made: Vec::new() }, Vec::new());
    // Only a new project has an example.
    let is_new = matches.try_get_one::<bool>("example").ok().flatten().is_some();
    let steps = sets.iter().map(|change| ("set", change)).chain(scales.iter().map(|change| ("scale", change)));
    for (option, change) in steps {
        let made = match option {
            "set" => match stations(&changed.text, change, &prefix) {
                Some(made) => Ok(made),
                None => {
                    let to_and_fro = is_new.then(|| moves_alike(&changed.text, change, &sets)).flatten();
                    to_and_fro.map_or_else(|| set(&changed.text, change, &prefix, language), Ok)
                }
            },
            _ => scale(&changed.text, change, &prefix, language),
        };
        match made {
            Ok((text, made)) => {
                changed.text = text;
                changed.made.push(made);
            }
            Err(fault) => faults.push(Unanswered::option(option, fault)),
        }
    }
    if faults.is_empty() { Ok(Some(changed)) } else { Err(Unanswered::combined(faults)) }
}

impl Changed {
    /// Returns the name of a project with its changes, for faults, reports and records.
    pub(crate) fn named(&self, name: &str) -> String {
        let all: String = self.made.join("; ");
        let short: String = all.chars().take(NAMED_MOST).collect();
        let dots = if short.len() < all.len() { " …" } else { "" };
        format!("{name} ({short}{dots})")
    }
}

/// Returns the changes of a call as part of a file name: `_mass=60kg_load=1.15`; empty without changes.
#[cfg(feature = "report")]
pub(crate) fn file_name_of_changes(matches: &ArgMatches) -> String {
    let given = |name: &str| -> Vec<String> {
        let all = matches.try_get_many::<String>(name).ok().flatten();
        all.map(|all| all.cloned().collect()).unwrap_or_default()
    };
    let is_plain = |sign: char| sign.is_alphanumeric() || "=.-[]".contains(sign);
    let plain = |change: &String| -> String {
        let signs = change.chars().filter(|sign| !sign.is_whitespace());
        signs.map(|sign| if is_plain(sign) { sign } else { '-' }).collect()
    };
    let all =
        given("set").iter().chain(&given("scale")).map(|change| format!("_{}", plain(change))).collect::<String>();
    all.chars().take(FILE_NAME_MOST).collect()
}

/// Returns the prefix of the keys of the wanted axis: empty for a project with one; `None` for a text that is no TOML.
pub(crate) fn prefix(text: &str, wanted: Option<&String>) -> Option<String> {
    let all = written(text)?;
    let value = |path: &str| all.iter().find(|key| key.path == path).and_then(|key| key.value.clone());
    let place = (1..).take_while(|place| all.iter().any(|key| key.path == format!("axis[{place}]")));
    let named =
        place.into_iter().find(|place| wanted.is_some() && value(&format!("axis[{place}].name")).as_ref() == wanted);
    Some(named.map(|place| format!("axis[{place}].")).unwrap_or_default())
}

type Fault = (String, Option<String>);

fn bad(written: &str, option: &str, hint: UsageHint, language: Language) -> Fault {
    let usage = Usage::BadValue { written: seen(written).into_owned(), name: format!("--{option}") };
    (usage_text(&usage, language), Some(usage_hint(&hint, language)))
}

/// Sets one value; a key without its table is the one that the project states.
fn set(text: &str, change: &str, prefix: &str, language: Language) -> Result<(String, String), Fault> {
    let Some((key, value)) = change.split_once('=').map(|(key, value)| (key.trim(), value.trim())) else {
        return Err((terminal::set_form(language).to_owned(), None));
    };
    let all = written(text).unwrap_or_default();
    let stated = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
    let key = keys::with_brackets(key);
    let path = match key_at(key.strip_prefix(prefix).unwrap_or(&key)) {
        Some(_) if key.starts_with("axis[") || stated(&key).is_some() => key,
        Some(_) => format!("{prefix}{key}"),
        None => match &keys::named(&all, prefix, &key, value)[..] {
            [path] => path.clone(),
            [] => {
                let stated: Vec<&str> = all.iter().map(|each| each.path.as_str()).collect();
                let with_unit = with_units(&all, (prefix, &key), value);
                let option = |(path, value): &(String, String)| typed(["--set", &format!("{path}={value}")]);
                let hint = match with_unit.is_empty() {
                    false => UsageHint::Calls(with_unit.iter().map(option).collect()),
                    true => UsageHint::Words(keys::nearest(&all, &key, &stated)),
                };
                return Err((terminal::set_no_key(&seen(&key), language), Some(usage_hint(&hint, language))));
            }
            found => {
                let option = |path: &String| typed(["--set", &format!("{path}={}", seen(value))]);
                let hint = UsageHint::Calls(found.iter().take(NAMED_KEYS_MOST).map(option).collect());
                let message = match found {
                    [one, other, ..] => terminal::set_which(&key, one, other, language),
                    _ => String::new(),
                };
                return Err((message, Some(usage_hint(&hint, language))));
            }
        },
    };
    // Without the prefix a key of a project with several axes belongs to none of them.
    if prefix.is_empty() && !path.starts_with("axis[") && all.iter().any(|each| each.path.starts_with("axis[1]")) {
        return Err((terminal::set_which_axis(&format!("axis[1].{path}"), language), None));
    }
    let before = stated(&path).unwrap_or("–").to_owned();
    let is_truth = key_at(&path).is_some_and(|key| matches!(key.kind, Kind::Bool));
    let value = truth(value).filter(|_| is_truth).unwrap_or(value);
    let value = &*with_point(&path, value);
    let lacking = with_units(&all, ("", &path), value);
    if !lacking.is_empty() {
        let option = |(path, value): &(String, String)| typed(["--set", &format!("{path}={value}")]);
        let hint = UsageHint::Calls(lacking.iter().map(option).collect());
        return Err((terminal::set_unit(&path, language), Some(usage_hint(&hint, language))));
    }
    let done = edit(text, &path, Edit::Value(value)).map_err(|fault| (fault.to_string(), None))?;
    Ok((done, format!("{path} {before} → {}", if value.is_empty() { "–" } else { value })))
}

/// Returns the value of a quantity with a decimal point in place of a comma, unless that may separate thousands: `1,200 kg`.
fn with_point<'v>(path: &str, value: &'v str) -> Cow<'v, str> {
    let is_measured = key_at(path).is_some_and(|key| matches!(key.kind, Kind::Quantity(..) | Kind::Along(..)));
    let (number, _) = number_and_unit(value);
    match number.split_once(',') {
        Some((whole, rest)) if is_measured && !rest.contains([',', '.']) && !whole.contains('.') && rest.len() != 3 => {
            Cow::Owned(value.replacen(',', ".", 1))
        }
        _ => Cow::Borrowed(value),
    }
}

/// Turns a table on by one station in each of its moves; `None` if the change is no number of stations, or nothing turns.
fn stations(text: &str, change: &str, prefix: &str) -> Option<(String, String)> {
    let (key, value) = change.split_once('=')?;
    let distance = distance_of_stations(key.trim(), value.trim())?;
    let all = written(text)?;
    let is_move = |each: &&Written| each.path.starts_with(prefix) && each.path.ends_with(".distance");
    let turns = |each: &&Written| each.value.as_deref().is_some_and(keys::is_angle);
    let (mut done, mut made) = (text.to_owned(), Vec::new());
    for each in all.iter().filter(is_move).filter(turns) {
        done = edit(&done, &each.path, Edit::Value(&distance)).ok()?;
        made.push(format!("{} {} → {distance}", each.path, each.value.as_deref().unwrap_or_default()));
    }
    (!made.is_empty()).then(|| (done, made.join("; ")))
}

/// Sets a value of a new project in all its moves, there and back, if they state the same amount; `pause=1s` sets the dwells.
/// `None` if the change names one key, or the moves differ.
fn moves_alike(text: &str, change: &str, sets: &[String]) -> Option<(String, String)> {
    let (key, value) = change.split_once('=').map(|(key, value)| (key.trim(), value.trim()))?;
    let all = written(text)?;
    let stated = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
    let is_dwell = |path: &str| {
        let segment = path.rsplit_once('.').map(|(segment, _)| segment).filter(|segment| is_segment(segment));
        segment.and_then(|segment| stated(&format!("{segment}.law"))) == Some("dwell")
    };
    let (name, of_dwells) = if words::spoken::is_pause(key) { ("time", true) } else { (key, false) };
    let found = keys::named(&all, "", &keys::with_brackets(name), value);
    let is_due =
        |path: &&String| path.starts_with("motion[") && is_dwell(path) == of_dwells && keys::takes(path, value);
    let due: Vec<&String> = found.iter().filter(is_due).collect();
    let amount = |path: &str| stated(path).map(|value| value.trim_start_matches('-').to_owned());
    let first = amount(due.first()?);
    let is_alike = due.iter().all(|path| amount(path) == first);
    if !is_alike || found.len() < 2 || value.starts_with('-') {
        return None;
    }
    let (mut done, mut made) = (text.to_owned(), Vec::new());
    for path in due {
        let before = stated(path).unwrap_or("–");
        let sign = if before.starts_with('-') { "-" } else { "" };
        let value = format!("{sign}{}", with_point(path, value));
        done = edit(&done, path, Edit::Value(&value)).ok()?;
        made.push(format!("{path} {before} → {value}"));
        // A move is stated by two of its values: the speed replaces the time of the template.
        let time = path.rsplit_once('.').map(|(segment, _)| format!("{segment}.time")).unwrap_or_default();
        let has_time = sets.iter().any(|set| set.split_once('=').is_some_and(|(key, _)| is_time(key.trim())));
        let (Some(before), true) = (stated(&time), OF_SPEED.contains(&name) && !has_time) else { continue };
        done = edit(&done, &time, Edit::Value("")).ok()?;
        made.push(format!("{time} {before} → –"));
    }
    Some((done, made.join("; ")))
}

/// Keys of a move that a new project states in place of its time.
const OF_SPEED: [&str; 2] = ["speed", "acceleration"];

/// Returns `true` if a key is that of a time, by any of its names.
fn is_time(key: &str) -> bool {
    let last = key.rsplit('.').next().unwrap_or_default().to_lowercase();
    last == "time" || other_names(&last).contains(&"time")
}

/// Returns the keys that the end of a path names, each with the number and the unit that it lacks: that of the stated value, else
/// one of every quantity that the key may be.
pub(crate) fn with_units(all: &[Written], (prefix, key): (&str, &str), value: &str) -> Vec<(String, String)> {
    let number = value.replace(',', ".");
    if number.parse::<f64>().is_err() {
        return Vec::new();
    }
    let mut found: Vec<(String, String)> = Vec::new();
    for unit in keys::UNITS {
        let value = format!("{number} {unit}");
        let paths = if key_at(key).is_some() { vec![key.to_owned()] } else { keys::named(all, prefix, key, &value) };
        let lacking = paths.into_iter().filter(|path| keys::is_quantity(path, &value));
        found.extend(lacking.map(|path| (path, value.clone())));
    }
    let own = |path: &str| {
        let stated = all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref())?;
        Some(number_and_unit(stated).1.to_owned()).filter(|unit| !unit.is_empty())
    };
    for (path, value) in &mut found {
        if let Some(unit) = own(path) {
            *value = format!("{number} {unit}");
        }
    }
    found.dedup();
    found.truncate(NAMED_KEYS_MOST);
    found
}

/// Percentage without a sign from which it is a share, below an increase.
const SHARE_LEAST: f64 = 50.0;

/// Returns the factor that a percentage states: `+15%` and `15%` are 1.15, `80%` is 0.8.
pub(crate) fn share(text: &str) -> Option<f64> {
    let number = text.strip_suffix('%')?.trim();
    let percent: f64 = number.replace(',', ".").parse().ok()?;
    let is_change = number.starts_with(['+', '-']) || percent < SHARE_LEAST;
    Some(if is_change { 100.0 + percent } else { percent } / 100.0)
}

/// Returns the factor that a word states as a percentage or with a sign of multiplication.
pub(crate) fn factor(word: &str) -> Option<f64> {
    if let Some(factor) = share(word) {
        return Some(factor);
    }
    let number = word.strip_prefix(['x', '×', '*']).or_else(|| word.strip_suffix(['x', '×']))?;
    number.replace(',', ".").parse().ok()
}

/// Scales load, payloads, times or distances.
fn scale(text: &str, change: &str, prefix: &str, language: Language) -> Result<(String, String), Fault> {
    let (what, factor) = change.split_once('=').map_or((change, ""), |(what, factor)| (what.trim(), factor.trim()));
    let what = words::spoken::scaled(what).unwrap_or(what);
    if !SCALED.contains(&what) {
        let words: Vec<String> = SCALED.iter().map(|word| (*word).to_owned()).collect();
        return Err(bad(change, "scale", UsageHint::Words(project::Hint::ValidAre(words)), language));
    }
    let number = share(factor).or_else(|| factor.replace(',', ".").parse().ok());
    let number = number.filter(|number: &f64| (1e-3..=1e3).contains(number));
    let Some(number) = number else {
        return Err(bad(change, "scale", UsageHint::Range("0.001".to_owned(), "1000".to_owned()), language));
    };
    let all = written(text).unwrap_or_default();
    let further = |way: f64| {
        // A recording has no value that a factor could change, and the roll decides the length of a web.
        let is_given = |key: &project::Written| {
            let law = all.iter().find(|each| each.path == format!("{}.law", key.path));
            matches!(law.and_then(|law| law.value.as_deref()), Some("recorded" | "points" | "web"))
        };
        let segments = || all.iter().filter(|key| key.path.strip_prefix(prefix).is_some_and(is_segment));
        if segments().any(is_given) {
            return None;
        }
        segments().try_fold(text.to_owned(), |text, key| stretch(&text, &key.path, 1.0, way).ok())
    };
    let done = match what {
        "load" => load_scaled(text, prefix, number, number),
        "payload" => load_scaled(text, prefix, 1.0, number),
        "time" => paced(text, prefix, number),
        _ => further(number),
    };
    let done = done.filter(|done| done != text || number == 1.0);
    done.map(|done| (done, format!("{what} × {number}")))
        .ok_or_else(|| (terminal::scale_not_possible(&what, language), None))
}

fn is_segment(path: &str) -> bool {
    path.strip_prefix("motion[")
        .and_then(|rest| rest.strip_suffix(']'))
        .is_some_and(|place| place.parse::<u32>().is_ok())
}

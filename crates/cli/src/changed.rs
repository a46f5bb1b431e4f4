//! A project with other values for one call: `--set KEY=VALUE` and `--scale WHAT=FACTOR`.

pub(crate) mod accepted;
mod consequence;
mod factor;
pub(crate) mod keys;
mod load;
pub(crate) mod mass;
pub(crate) mod motion;
pub(crate) mod places;
mod relative;
mod value;

use crate::command::typed::{number_and_unit, typed};
use clap::ArgMatches;
pub(crate) use consequence::consequences;
pub(crate) use factor::factor;
use factor::{any_factor, percentage, undecided_factors};
use project::{
    Edit, Kind, Written, distance_of_stations, edit, key_at, load_scaled, other_names, paced, stretch, truth, written,
};
use quantities::{Language, seen};
use questions::list::Unanswered;
use relative::{Relative, relative, undecided};
use std::borrow::Cow;
use std::ops::RangeInclusive;
use value::{FACTORS, Fault, NAMED_KEYS_MOST, thousands, with_point};
use words::{Usage, UsageHint, sweeps, terminal, unpadded, usage_hint, usage_text};

/// Quantities that a call may scale.
pub(crate) const SCALED: [&str; 4] = ["load", "payload", "time", "distance"];

/// Largest number of characters of a change in the name of the project.
const NAMED_MOST: usize = 120;

/// Largest number of values that a scaling lists.
const CHANGES_MOST: usize = 6;

/// Largest number of characters of the changes in a file name.
#[cfg(feature = "report")]
const FILE_NAME_MOST: usize = 80;

/// Changes that a call states.
#[derive(Clone, Debug, Default)]
pub(crate) struct Statements {
    pub(crate) sets: Vec<String>,
    pub(crate) scales: Vec<String>,
    /// Name of the wanted axis.
    pub(crate) axis: Option<String>,
}

impl Statements {
    /// Returns the changes of a call that the command-line library read.
    pub(crate) fn of(matches: &ArgMatches) -> Self {
        let all = |name: &str| -> Vec<String> {
            let all = matches.try_get_many::<String>(name).ok().flatten();
            all.map(|all| all.cloned().collect()).unwrap_or_default()
        };
        let axis = matches.try_get_one::<String>("axis").ok().flatten().cloned();
        Self { sets: all("set"), scales: all("scale"), axis }
    }

    /// Returns the changes among the words of a call.
    pub(crate) fn of_words(words: &[&str]) -> Self {
        let all = |option: &str| -> Vec<String> {
            let behind = words.windows(2).filter(|pair| pair.first() == Some(&option)).filter_map(|pair| pair.get(1));
            let joined = words.iter().filter_map(|word| word.strip_prefix(option)?.strip_prefix('='));
            behind.copied().chain(joined).map(str::to_owned).collect()
        };
        Self { sets: all("--set"), scales: all("--scale"), axis: all("--axis").pop() }
    }
}

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
pub(crate) fn changed(text: &str, stated: &Statements, language: Language) -> Result<Option<Changed>, Unanswered> {
    let Statements { sets, scales, axis } = stated;
    if sets.is_empty() && scales.is_empty() {
        return Ok(None);
    }
    let Some(prefix) = prefix(text, axis.as_ref()) else { return Ok(None) };
    let (mut changed, mut faults) = (Changed { text: text.to_owned(), made: Vec::new() }, Vec::new());
    let (mut keys_set, mut scaled): (Vec<String>, Vec<String>) = (Vec::new(), Vec::new());
    let of = |change: &String| change.split_once('=').map_or_else(String::new, |(key, _)| key.trim().to_owned());
    let further: Vec<String> = sets.iter().map(of).collect();
    // What fills the cycle follows from the moves.
    let is_cycle = |change: &&String| motion::meaning(&of(change)) == Some(motion::MotionWord::Cycle);
    let ordered = sets.iter().filter(|change| !is_cycle(change)).chain(sets.iter().filter(is_cycle));
    let steps = ordered.map(|change| ("set", change)).chain(scales.iter().map(|change| ("scale", change)));
    for (option, change) in steps {
        let change = &*unquoted(change);
        let made = match option {
            "set" => mass_without_radius(&changed.text, change, &prefix, language)
                .map(Err)
                .or_else(|| stations(&changed.text, change, &prefix).map(Ok))
                .or_else(|| motion::set(&changed.text, change, &prefix, &further, language))
                .unwrap_or_else(|| set(&changed.text, change, &prefix, language)),
            _ => scale(&changed.text, change, &prefix, language),
        };
        match made {
            Ok((text, made)) => {
                let touched = paths_changed(&changed.text, &text);
                if let Some(fault) = of_another_axis(&text, &touched, &prefix, language) {
                    faults.push(Unanswered::option(option, fault));
                    continue;
                }
                if let Some(path) = touched.iter().find(|path| option == "scale" && scaled.contains(path)) {
                    let usage = Usage::Twice { name: path.clone() };
                    faults.push(Unanswered::option(option, (usage_text(&usage, language), None)));
                    continue;
                }
                scaled.extend(touched.into_iter().filter(|_| option == "scale"));
                if let Some(key) = twice(&mut keys_set, option, change, &made) {
                    let usage = Usage::Twice { name: key };
                    faults.push(Unanswered::option(option, (usage_text(&usage, language), None)));
                    continue;
                }
                changed.text = text;
                changed.made.push(made);
            }
            Err(fault) => faults.push(Unanswered::option(option, fault)),
        }
    }
    // A value that the template has too is stated nevertheless.
    let kept = changed.made.iter().flat_map(|made| made.split("; ")).filter_map(kept_value);
    let kept: Vec<&str> = kept.filter(|path| key_at(path).is_some()).collect();
    if !kept.is_empty() {
        changed.text = questions::list::new::stating(&changed.text, &kept, language);
    }
    if faults.is_empty() { Ok(Some(changed)) } else { Err(Unanswered::combined(faults)) }
}

/// Returns the path of a change that left the value as it was: `motion[1].distance 90 deg → 90 deg`.
fn kept_value(made: &str) -> Option<&str> {
    let (path, values) = made.split_once(' ')?;
    let (before, after) = values.split_once(" → ")?;
    (before == after).then_some(path)
}

/// Returns the paths of the values that differ between two texts of a project.
fn paths_changed(before: &str, after: &str) -> Vec<String> {
    let before = written(before).unwrap_or_default();
    let is_new = |each: &Written| {
        each.value.is_some() && !before.iter().any(|old| (&old.path, &old.value) == (&each.path, &each.value))
    };
    written(after).unwrap_or_default().into_iter().filter(is_new).map(|each| each.path).collect()
}

/// Returns the refusal of a change of another axis than that of the call, whose answer would not show it.
fn of_another_axis(text: &str, touched: &[String], prefix: &str, language: Language) -> Option<Fault> {
    let other = touched.iter().find(|path| path.starts_with("axis[") && !path.starts_with(prefix))?;
    let all = written(text)?;
    let name = places::name(&all, other.split_inclusive("].").next()?)?;
    let own = places::name(&all, prefix)?;
    Some((terminal::change_of_another_axis(other, &name, &own, language), None))
}

/// Returns the key or the quantity of a change if an earlier change of the call has it already: of two values one would be lost.
fn twice(earlier: &mut Vec<String>, option: &str, change: &str, made: &str) -> Option<String> {
    let key = match option {
        "set" => made.split(' ').next().unwrap_or_default(),
        _ => change.split('=').next().unwrap_or_default().trim(),
    };
    let is_known = earlier.iter().any(|known| known == key);
    earlier.push(key.to_owned());
    is_known.then(|| key.to_owned())
}

/// Returns a change without the quotes around its value: those of a project file, also as word processors write them.
fn unquoted(change: &str) -> Cow<'_, str> {
    const PAIRS: [(char, char); 6] = [
        ('"', '"'),
        ('\'', '\''),
        ('\u{201c}', '\u{201d}'),
        ('\u{201e}', '\u{201c}'),
        ('\u{2018}', '\u{2019}'),
        ('\u{201d}', '\u{201d}'),
    ];
    let Some((key, value)) = change.split_once('=') else { return Cow::Borrowed(change) };
    let inside = |(open, close): &(char, char)| value.trim().strip_prefix(*open)?.strip_suffix(*close);
    PAIRS.iter().find_map(inside).map_or(Cow::Borrowed(change), |value| Cow::Owned(format!("{key}={value}")))
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
    let Statements { sets, scales, .. } = Statements::of(matches);
    let is_plain = |sign: char| sign.is_alphanumeric() || "=.-[]".contains(sign);
    let plain = |change: &String| -> String {
        let signs = change.chars().filter(|sign| !sign.is_whitespace());
        signs.map(|sign| if is_plain(sign) { sign } else { '-' }).collect()
    };
    let all = sets.iter().chain(&scales).map(|change| format!("_{}", plain(change))).collect::<String>();
    all.chars().take(FILE_NAME_MOST).collect()
}

/// Returns the prefix of the keys of the wanted axis: empty for a project with one; `None` for a text that is no TOML.
pub(crate) fn prefix(text: &str, wanted: Option<&String>) -> Option<String> {
    let all = written(text)?;
    Some(wanted.and_then(|name| places::axis_named(&all, name)).unwrap_or_default())
}

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
    let key = project::with_brackets(key);
    if let Some(fault) = number_of_scaled(&all, (prefix, &key), value, language) {
        return Err(fault);
    }
    let is_value = |key: &&project::Key| !accepted::is_table(key.kind);
    let axes = if prefix.is_empty() { places::axes(&all) } else { Vec::new() };
    let is_whole = |key: &str| key.starts_with("axis[") || stated(key).is_some();
    let path = match key_at(key.strip_prefix(prefix).unwrap_or(&key)).filter(is_value) {
        Some(_) if is_whole(&key) => key,
        Some(_) if axes.is_empty() => format!("{prefix}{key}"),
        _ => {
            let of_axes = || axes.iter().flat_map(|axis| keys::named(&all, axis, &key, value)).collect();
            let mut found = keys::named(&all, prefix, &key, value);
            found = if found.is_empty() { of_axes() } else { found };
            if found.is_empty() {
                found = places::anywhere(&all, prefix, &key, value);
            }
            match <[String; 1]>::try_from(found) {
                Ok([path]) => path,
                Err(found) if found.is_empty() => return Err(no_key(&all, (prefix, &key), value, language)),
                Err(found) => return Err(several_keys(&found, &key, value, "--set", language)),
            }
        }
    };
    // Without the prefix a key of a project with several axes belongs to none of them.
    if !axes.is_empty() && !path.starts_with("axis[") && stated(&path).is_none() {
        let found: Vec<String> = axes.iter().map(|axis| format!("{axis}{path}")).collect();
        let is_key = |path: &&String| key_at(path).is_some();
        let found: Vec<String> = found.iter().filter(is_key).cloned().collect();
        return Err(match found.first() {
            None => no_key(&all, (prefix, &path), value, language),
            Some(first) => {
                let option = |path: &String| typed(["--set", &format!("{path}={}", seen(value))]);
                let hint = UsageHint::Calls(found.iter().take(NAMED_KEYS_MOST).map(option).collect());
                (terminal::set_which_axis(first, language), Some(usage_hint(&hint, language)))
            }
        });
    }
    if let Some((entry, count)) = keys::no_entry(&all, &path) {
        let call = project::nearest_entry(&all, &path).map(|path| typed(["--set", &format!("{path}={}", seen(value))]));
        let hint = call.map(|call| usage_hint(&UsageHint::Calls(vec![call]), language));
        return Err((sweeps::no_entry(&seen(&entry), &count, language), hint));
    }
    let before = stated(&path).unwrap_or("–").to_owned();
    let is_truth = key_at(&path).is_some_and(|key| matches!(key.kind, Kind::Bool));
    let value = truth(value).filter(|_| is_truth).unwrap_or(value);
    if let Some([whole, decimal]) = thousands(&path, value, language) {
        let calls = [whole, decimal].map(|value| typed(["--set", &format!("{path}={value}")])).to_vec();
        let hint = usage_hint(&UsageHint::Calls(calls), language);
        return Err((terminal::set_thousands(&path, &seen(value), language), Some(hint)));
    }
    let value = &*with_point(&path, value);
    let lacking = with_units(&all, ("", &path), value);
    if !lacking.is_empty() {
        let option = |(path, value): &(String, String)| typed(["--set", &format!("{path}={value}")]);
        let hint = UsageHint::Calls(lacking.iter().map(option).collect());
        return Err((terminal::set_unit(&path, language), Some(usage_hint(&hint, language))));
    }
    let relative = match relative(&path, stated(&path), value) {
        Relative::Undecided(values) => return Err(undecided(&path, value, &values, language)),
        Relative::Value(value) => Some(value),
        Relative::Absolute => None,
    };
    let value = relative.as_deref().unwrap_or(value);
    let done = edit(text, &path, Edit::Value(value)).map_err(|fault| (fault.to_string(), None))?;
    // A change that is reported is one of the project.
    if done == text && before != value && !(before == "–" && value.is_empty()) {
        return Err(no_key(&all, (prefix, &path), value, language));
    }
    Ok((done, format!("{path} {before} → {}", if value.is_empty() { "–" } else { value })))
}

/// Returns the refusal of a key that the project cannot have, with the lines that have their unit or the nearest key.
fn no_key(all: &[Written], (prefix, key): (&str, &str), value: &str, language: Language) -> Fault {
    let stated: Vec<&str> = all.iter().map(|each| each.path.as_str()).collect();
    let with_unit = with_units(all, (prefix, key), value);
    let option = |(path, value): &(String, String)| typed(["--set", &format!("{path}={value}")]);
    // A key that the project does not state, by another name for it.
    let plain = key.to_lowercase().replace(['-', ' '], "_");
    let other = match other_names(&plain) {
        [name] => places::anywhere(all, prefix, name, value),
        _ => Vec::new(),
    };
    let hint = match (with_unit.is_empty(), &other[..]) {
        (false, _) => UsageHint::Calls(with_unit.iter().map(option).collect()),
        (true, [path]) => UsageHint::Calls(vec![typed(["--set", &format!("{path}={}", seen(value))])]),
        (true, _) => UsageHint::Words(keys::nearest(all, key, &stated)),
    };
    (terminal::set_no_key(&seen(key), language), Some(usage_hint(&hint, language)))
}

/// Returns the refusal of a key that may be one of several, with the line for each; moves that have a word in common have its
/// line first.
fn several_keys(found: &[String], key: &str, value: &str, option: &str, language: Language) -> Fault {
    // The payloads of several moves have one word.
    let is_payload = |path: &&String| path.ends_with("].payload");
    let is_one = found.iter().filter(is_payload).count() < 2;
    let of_moves = |path: &String| {
        let (segment, last) = path.rsplit_once('.')?;
        let is_segment = segment.rsplit_once("motion[").is_some_and(|(_, rest)| !rest.contains('.'));
        motion::meaning(last).filter(|_| is_segment && !key.eq_ignore_ascii_case(last)).map(|_| last.to_owned())
    };
    let word = found.first().and_then(of_moves).filter(|_| is_one);
    let is_common = word.is_some() && found.iter().all(|path| of_moves(path) == word);
    let mut keys: Vec<&str> = word.as_deref().filter(|_| is_common).into_iter().collect();
    keys.extend(found.iter().filter(|path| is_one || !is_payload(path)).map(String::as_str));
    keys.extend((!is_one).then_some("payload"));
    let call = |path: &&str| typed([option, &format!("{path}={}", seen(value))]);
    let hint = UsageHint::Calls(keys.iter().take(NAMED_KEYS_MOST).map(call).collect());
    let message = match found {
        [one, other, ..] => terminal::set_which(&seen(key), one, other, language),
        _ => String::new(),
    };
    (message, Some(usage_hint(&hint, language)))
}

/// Returns the refusal of a mass that the axis does not take.
fn mass_without_radius(text: &str, change: &str, prefix: &str, language: Language) -> Option<Fault> {
    let (word, value) = change.split_once('=')?;
    mass::without_radius(&written(text)?, prefix, (word.trim(), value.trim()), language)
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

/// Returns the refusal of a bare number for all that a factor scales, with both forms; `None` for anything else.
fn number_of_scaled(all: &[Written], (prefix, key): (&str, &str), value: &str, language: Language) -> Option<Fault> {
    let what = words::spoken::scaled(key)?;
    let number = value.replace(',', ".");
    let factor: f64 = number.parse().ok()?;
    let units = with_units(all, (prefix, key), value);
    let mut calls: Vec<String> =
        units.iter().map(|(path, value)| typed(["--set", &format!("{path}={value}")])).collect();
    if FACTORS.contains(&factor) {
        calls.push(typed(["--scale", &format!("{what}={number}")]));
    }
    Some((terminal::set_unit(&seen(key), language), Some(usage_hint(&UsageHint::Calls(calls), language))))
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
        let paths = if key_at(key).is_some_and(|key| !accepted::is_table(key.kind)) {
            vec![key.to_owned()]
        } else {
            keys::named(all, prefix, key, &value)
        };
        let lacking = paths.into_iter().filter(|path| accepted::is_quantity(path, &value));
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

/// Factors that a bare number plainly states for the whole load.
pub(crate) const LOAD_FACTORS: RangeInclusive<f64> = 0.5..=2.0;

/// Scales load, payloads, times or distances.
fn scale(text: &str, change: &str, prefix: &str, language: Language) -> Result<(String, String), Fault> {
    let (what, factor) = change.split_once('=').map_or((change, ""), |(what, factor)| (what.trim(), factor.trim()));
    let what = words::spoken::scaled(what).unwrap_or(what);
    let all = written(text).unwrap_or_default();
    if !SCALED.contains(&what) {
        // The value of one key: the percentage says the same.
        if let Some(number) = any_factor(factor) {
            let of_key = |key: &str| set(text, &format!("{key}={}", percentage(number)), prefix, language).ok();
            // Only a stated value can be scaled.
            let is_stated = |path: &String| all.iter().any(|each| each.path == *path && each.value.is_some());
            let keys: Vec<String> = keys::named(&all, prefix, what, "").into_iter().filter(is_stated).collect();
            let own = || <[String; 1]>::try_from(keys.clone()).ok().and_then(|[key]| of_key(&key));
            if let Some(made) = of_key(what).or_else(own) {
                return Ok(made);
            }
            if keys.len() > 1 {
                return Err(several_keys(&keys, what, factor, "--scale", language));
            }
        }
        let words: Vec<String> = SCALED.iter().map(|word| (*word).to_owned()).collect();
        return Err(bad(change, "scale", UsageHint::Words(project::Hint::ValidAre(words)), language));
    }
    let number = any_factor(factor);
    let undecided = undecided_factors(factor);
    if number.is_none() && !undecided.is_empty() {
        let calls = undecided.iter().map(|factor| typed(["--scale", &format!("{what}={factor}")])).collect();
        let message = terminal::factor_undecided(&seen(factor), language);
        return Err((message, Some(usage_hint(&UsageHint::Calls(calls), language))));
    }
    let number = number.filter(|number: &f64| (1e-3..=1e3).contains(number));
    let Some(number) = number else {
        return Err(bad(change, "scale", UsageHint::Range("0.001".to_owned(), "1000".to_owned()), language));
    };
    // Without a wanted axis the factor is one of each.
    let axes = if prefix.is_empty() { places::axes(&all) } else { Vec::new() };
    let prefixes: Vec<&str> = if axes.is_empty() { vec![prefix] } else { axes.iter().map(String::as_str).collect() };
    let (mut done, mut fault, mut scaled) = (None, None, Vec::new());
    for prefix in prefixes {
        let before: &str = done.as_deref().unwrap_or(text);
        match scaled_axis(before, (&all, prefix), (what, number), language) {
            Ok(Some(changed)) => {
                done = Some(changed);
                scaled.extend(places::name(&all, prefix));
            }
            // Every axis has a motion, not every one a payload.
            Ok(None) if ["time", "distance"].contains(&what) => {
                fault = Some((places::name(&all, prefix), (terminal::scale_not_possible(&what, language), None)));
            }
            Ok(None) => {}
            Err(why) => fault = Some((places::name(&all, prefix), why)),
        }
    }
    if let Some((axis, (why, hint))) = fault {
        // A factor of some of the axes alone would look like one of all.
        return Err(match axis {
            Some(axis) if !scaled.is_empty() => (terminal::not_scaled(&axis, &why, &scaled.join(", "), language), hint),
            _ => (why, hint),
        });
    }
    let done = done.filter(|done| done != text || number == 1.0);
    let said = |done: &str| {
        let scaled = format!("{} × {}", words::spoken::scaled_name(what, language), unpadded(number, 9, language));
        format!("{scaled}: {}", values_changed(&all, done))
    };
    done.map(|done| (said(&done), done))
        .map(|(said, done)| (done, said))
        .ok_or_else(|| (terminal::scale_not_possible(&what, language), None))
}

/// Returns the text with load, payloads, times or distances of an axis multiplied; `None` if the axis has none.
fn scaled_axis(
    text: &str,
    (all, prefix): (&[Written], &str),
    (what, number): (&str, f64),
    language: Language,
) -> Result<Option<String>, Fault> {
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
    Ok(match what {
        "load" => Some(load::scaled(text, (all, prefix), number, language)?),
        "payload" => load_scaled(text, prefix, 1.0, number),
        "time" => paced(text, prefix, number),
        _ => further(number),
    })
}

/// Returns the values that differ from those of a project, each with its key: `mechanism.screw.mass 80 kg → 92 kg`.
fn values_changed(before: &[Written], after: &str) -> String {
    let after = written(after).unwrap_or_default();
    let was = |path: &str| before.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
    let all = after.iter().filter_map(|each| {
        let (old, new) = (was(&each.path), each.value.as_deref()?);
        (old != Some(new)).then(|| format!("{} {} → {new}", each.path, old.unwrap_or("–")))
    });
    let all: Vec<String> = all.collect();
    let shown = all.iter().take(CHANGES_MOST).map(String::as_str).collect::<Vec<_>>().join(", ");
    if all.len() > CHANGES_MOST { format!("{shown}, …") } else { shown }
}

fn is_segment(path: &str) -> bool {
    path.strip_prefix("motion[")
        .and_then(|rest| rest.strip_suffix(']'))
        .is_some_and(|place| place.parse::<u32>().is_ok())
}

#[cfg(test)]
#[path = "changed_tests.rs"]
mod tests;

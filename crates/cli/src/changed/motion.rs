//! Words of a call for the motion: a time, a distance, a payload of every move, the cycle that its dwells fill.

use super::accepted;
use super::keys::{self, UNITS};
use super::relative::{Relative, relative, undecided};
use super::value::{FACTORS, Fault, NAMED_KEYS_MOST, with_point};
use crate::command::typed::{number_and_unit, typed};
use project::{FilledCycle, Unfilled, Written, cycle_filled, edit_values, key_at, other_names, written};
use quantities::{Dimension, Language, parse, seen};
use words::{UsageHint, spoken, terminal, usage_hint};

/// Keys of a move that a word without a table states for every move.
const OF_MOVES: [&str; 13] = [
    "distance",
    "time",
    "speed",
    "acceleration",
    "jerk",
    "payload",
    "payload_inertia",
    "process_force",
    "process_torque",
    "end_speed",
    "accelerate",
    "run",
    "law",
];

/// Keys of which any two determine a move.
const OF_TWO: [&str; 4] = ["distance", "time", "speed", "acceleration"];

/// Keys of what is carried: where no segment states one, all do.
const CARRIED: [&str; 2] = ["payload", "payload_inertia"];

/// Largest number of calls that a refusal proposes for moves of different distances.
const SCALED_MOST: usize = 3;

/// MotionWord of a word for the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MotionWord {
    /// A key of the moves.
    Moves(&'static str),
    /// A key of the dwells.
    Dwells(&'static str),
    /// Duration of the whole cycle.
    Cycle,
}

/// Returns the meaning of a word for the motion; `None` for a path and for a word of something else.
pub(crate) fn meaning(word: &str) -> Option<MotionWord> {
    let word = word.trim().to_lowercase();
    if spoken::is_pause(&word) {
        return Some(MotionWord::Dwells("time"));
    }
    let usual = other_names(&word).first().copied();
    let is = |name: &str| word == name || usual == Some(name);
    if is("cycle") {
        return Some(MotionWord::Cycle);
    }
    if is("hold") {
        return Some(MotionWord::Dwells("hold"));
    }
    OF_MOVES.into_iter().find(|name| is(name)).map(MotionWord::Moves)
}

/// Keys with the value that each has then; an empty value removes the key.
pub(crate) type Values = Vec<(String, String)>;

/// Keys of the segments that a word stands for.
struct Due<'p> {
    all: &'p [Written],
    prefix: &'p str,
    key: &'static str,
    /// Paths of the keys.
    paths: Vec<String>,
    /// Keys that the new one replaces, since two determine a move.
    replaced: Vec<String>,
}

/// Returns the segments of the motion of an axis, each with `true` for a dwell.
fn segments(all: &[Written], prefix: &str) -> Vec<(String, bool)> {
    let value = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
    let place = (1..).map(|place: usize| format!("{prefix}motion[{place}]"));
    let paths = place.take_while(|path| all.iter().any(|each| each.path == *path));
    paths
        .map(|path| {
            let is_dwell = value(&format!("{path}.law")) == Some("dwell");
            (path, is_dwell)
        })
        .collect()
}

/// Returns the dwells of the motion of an axis.
pub(crate) fn dwells(all: &[Written], prefix: &str) -> Vec<String> {
    segments(all, prefix).into_iter().filter_map(|(path, is_dwell)| is_dwell.then_some(path)).collect()
}

/// Returns the first of several dwells whose times fill a cycle; `None` where one dwell states the cycle itself.
pub(crate) fn filling_dwell(text: &str, prefix: &str, cycle: &str) -> Option<String> {
    let first = match &dwells(&written(text)?, prefix)[..] {
        [first, _, ..] => first.clone(),
        _ => return None,
    };
    let states_no_cycle = |text: &str| {
        written(text)
            .is_some_and(|all| !all.iter().any(|each| each.path.starts_with(prefix) && each.path.ends_with(".cycle")))
    };
    match cycle_filled(text, prefix, cycle) {
        Ok(filled) => states_no_cycle(&filled.text).then_some(first),
        // Each row reports its own moves.
        Err(Unfilled::TooShort { .. }) => Some(first),
        Err(Unfilled::NoCycle) => None,
    }
}

impl<'p> Due<'p> {
    fn of(all: &'p [Written], prefix: &'p str, meaning: MotionWord) -> Self {
        let (key, of_dwells) = match meaning {
            MotionWord::Moves(key) => (key, false),
            MotionWord::Dwells(key) => (key, true),
            MotionWord::Cycle => ("cycle", true),
        };
        let value = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
        let all_segments = segments(all, prefix);
        let own = || all_segments.iter().filter(|(_, is_dwell)| *is_dwell == of_dwells).map(|(segment, _)| segment);
        let path = |segment: &String| format!("{segment}.{key}");
        let mut due = Self { all, prefix, key, paths: Vec::new(), replaced: Vec::new() };
        let is_stated = |path: &String| value(path).is_some();
        due.paths = own().map(path).filter(is_stated).collect();
        // What a move carries, its dwell holds: every segment that states it has the new value.
        if CARRIED.contains(&key) && !due.paths.is_empty() {
            due.paths = all_segments.iter().map(|(segment, _)| path(segment)).filter(is_stated).collect();
        }
        if !due.paths.is_empty() {
            return due;
        }
        if CARRIED.contains(&key) {
            due.paths = all_segments
                .iter()
                .map(|(segment, _)| segment)
                .filter(|segment| accepted::permits(all, segment, key))
                .map(path)
                .collect();
        } else if of_dwells && key == "hold" {
            due.paths = own().map(path).collect();
        } else if OF_TWO.contains(&key) && key != "distance" {
            for segment in own().filter(|segment| accepted::permits(all, segment, key)) {
                let stated = OF_TWO.iter().map(|other| format!("{segment}.{other}"));
                let stated: Vec<String> = stated.filter(|path| value(path).is_some()).collect();
                let [distance, other] = &stated[..] else { return Self { paths: Vec::new(), ..due } };
                if !distance.ends_with(".distance") {
                    return Self { paths: Vec::new(), ..due };
                }
                due.replaced.push(other.clone());
                due.paths.push(path(segment));
            }
        }
        due
    }

    fn stated(&self, path: &str) -> Option<&'p str> {
        self.all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref())
    }

    /// Returns the keys of this name that the project states elsewhere and that take the value; for a negative angle also those
    /// that it may have.
    fn elsewhere(&self, word: &str, value: &str) -> Vec<String> {
        let motion = format!("{}motion[", self.prefix);
        let found = keys::named_exactly(self.all, self.prefix, word, value).into_iter();
        let is_stated = |path: &String| self.stated(path).is_some() || value.starts_with('-');
        found.filter(|path| !path.starts_with(&motion) && is_stated(path) && accepted::takes(path, value)).collect()
    }

    /// Returns the value of each key: the stated signs are the directions of the moves.
    fn values(&self, value: &str) -> Values {
        let is_turned = value.starts_with('-');
        let has_direction = ["distance", "speed", "end_speed"].contains(&self.key);
        let amount = value.trim_start_matches('-');
        let of = |path: &String| {
            let has_sign = self.key == "distance" || has_direction && !self.has_distance(path);
            let is_back = has_sign && self.stated(path).is_some_and(|stated| stated.starts_with('-'));
            let sign = if is_back == is_turned { "" } else { "-" };
            (path.clone(), format!("{sign}{amount}"))
        };
        let mut values: Values = self.paths.iter().map(of).collect();
        values.extend(self.replaced.iter().map(|path| (path.clone(), String::new())));
        values
    }

    fn has_distance(&self, path: &str) -> bool {
        let segment = path.rsplit_once('.').map_or("", |(segment, _)| segment);
        self.stated(&format!("{segment}.distance")).is_some()
    }

    /// Returns the calls that scale the distances so that those of one amount get a value, and the others keep their share;
    /// empty where all moves have one amount.
    fn scaled(&self, value: &str) -> Vec<String> {
        let si = |text: &str| {
            let read = [Dimension::Angle, Dimension::Length].into_iter().find_map(|of| parse(of, text).ok());
            read.map(|read| read.si.abs())
        };
        let mut amounts: Vec<f64> = Vec::new();
        for amount in self.paths.iter().filter_map(|path| si(self.stated(path)?)) {
            if amounts.iter().all(|known| (known / amount - 1.0).abs() > SAME_SHARE) {
                amounts.push(amount);
            }
        }
        if amounts.len() < 2 {
            return Vec::new();
        }
        amounts.sort_by(|a, b| b.total_cmp(a));
        let new = si(value).unwrap_or_default();
        let factors = amounts.iter().take(SCALED_MOST).map(|amount| new / amount).filter(|factor| *factor > 0.0);
        factors.map(|factor| typed(["--scale", &format!("distance={}", plain(factor, FACTOR_DIGITS))])).collect()
    }
}

/// Relative difference below which two distances are the same: that of typed digits.
const SAME_SHARE: f64 = 1e-6;

/// Digits of a proposed factor.
const FACTOR_DIGITS: u8 = 6;

/// Returns a positive number with some digits, without zeros at its end.
fn plain(number: f64, digits: u8) -> String {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "decimals of a number, at least zero")]
    let decimals = (f64::from(digits) - 1.0 - number.log10().floor()).max(0.0) as usize;
    let text = format!("{number:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Returns the text with a word for the motion set in every segment that it is for, and the changes; `None` as [`values`].
pub(super) fn set(
    text: &str,
    change: &str,
    prefix: &str,
    further: &[String],
    language: Language,
) -> Option<Result<(String, String), Fault>> {
    let (word, value) = change.split_once('=').map(|(key, value)| (key.trim(), value.trim()))?;
    let done = |(text, changes): (String, Vec<String>)| (text, changes.join("; "));
    if meaning(word) == Some(MotionWord::Cycle) {
        return Some(cycle(text, (prefix, word), value, language)?.map(done));
    }
    let all = written(text)?;
    let changed = |values: Values| {
        let edited = edit_values(text, &values).map_err(|fault| (fault.to_string(), None))?;
        let before = |path: &str| all.iter().find(|each| each.path == path).and_then(|each| each.value.as_deref());
        let shown = |value: &str| if value.is_empty() { "–".to_owned() } else { value.to_owned() };
        let change = |(path, to): &(String, String)| format!("{path} {} → {}", before(path).unwrap_or("–"), shown(to));
        Ok(done((edited, values.iter().map(change).collect())))
    };
    Some(values(text, (prefix, word), value, further, language)?.and_then(changed))
}

/// Returns the value of each key of the motion that a word states; `None` for a word of something else, or if the motion has no
/// such key. `further` are the keys that the call states besides.
pub(crate) fn values(
    text: &str,
    (prefix, word): (&str, &str),
    value: &str,
    further: &[String],
    language: Language,
) -> Option<Result<Values, Fault>> {
    let meaning = meaning(word).filter(|meaning| *meaning != MotionWord::Cycle && !value.is_empty())?;
    let all = written(text)?;
    let due = Due::of(&all, prefix, meaning);
    let first = due.paths.first()?;
    let value = with_point(first, value);
    let value = value.as_ref();
    let set = |key: &str, value: &str| typed(["--set", &format!("{key}={}", seen(value))]);
    let refused = |message: String, calls: Vec<String>| {
        Some(Err((message, Some(usage_hint(&UsageHint::Calls(calls), language)))))
    };
    let is_quantity = key_at(first).is_some_and(|key| keys::is_measured(key.kind));
    if is_quantity && value.replace(',', ".").parse::<f64>().is_ok() {
        return Some(Err(without_unit(&due, word, value, language)));
    }
    let elsewhere = due.elsewhere(word, value);
    if let Some(other) = elsewhere.first() {
        let mut calls: Vec<String> = elsewhere.iter().take(NAMED_KEYS_MOST).map(|path| set(path, value)).collect();
        match word.eq_ignore_ascii_case(due.key) {
            false => calls.push(set(due.key, value)),
            true => calls.extend(due.paths.iter().take(NAMED_KEYS_MOST).map(|path| set(path, value))),
        }
        return refused(terminal::set_which(&seen(word), other, first, language), calls);
    }
    if due.key == "distance" {
        let calls = due.scaled(value);
        if !calls.is_empty() {
            return refused(terminal::distances_differ(&seen(word), language), calls);
        }
    }
    if due.replaced.iter().any(|path| further.iter().any(|key| is_key(path, key))) {
        let names = OF_TWO.join(", ");
        return Some(Err((terminal::two_of_a_move(&names, language), None)));
    }
    let mut changed = Vec::new();
    for path in &due.paths {
        match relative(path, due.stated(path), value) {
            Relative::Absolute => return Some(Ok(due.values(value))),
            Relative::Undecided(values) => {
                let amounts: Vec<String> =
                    values.iter().map(|value| value.trim_start_matches('-').to_owned()).collect();
                return Some(Err(undecided(word, value, &amounts, language)));
            }
            Relative::Value(value) => changed.push((path.clone(), value)),
        }
    }
    Some(Ok(changed))
}

/// Returns the unit of the stated values that a word for the motion is for.
pub(crate) fn unit(text: &str, (prefix, word): (&str, &str)) -> Option<String> {
    let all = written(text)?;
    let due = Due::of(&all, prefix, meaning(word)?);
    let first = due.paths.first()?;
    // A word, as a law of motion, has no unit.
    let quantity = due.stated(first).map(number_and_unit).filter(|(number, _)| !number.is_empty());
    let own = quantity.map(|(_, unit)| unit).filter(|unit| !unit.is_empty());
    let fitting = || UNITS.into_iter().find(|unit| accepted::is_quantity(first, &format!("1 {unit}")));
    own.or_else(fitting).map(str::to_owned)
}

/// Returns `true` if a word states the key at a path.
fn is_key(path: &str, word: &str) -> bool {
    let last = path.rsplit('.').next().unwrap_or_default();
    matches!(meaning(word), Some(MotionWord::Moves(key)) if key == last)
}

/// Returns the refusal of a number without a unit, with every call that it may mean: a value with its unit, and a factor.
fn without_unit(due: &Due<'_>, word: &str, value: &str, language: Language) -> Fault {
    let number = value.replace(',', ".");
    let own =
        due.paths.iter().find_map(|path| Some(number_and_unit(due.stated(path)?).1).filter(|unit| !unit.is_empty()));
    let first = due.paths.first().cloned().unwrap_or_default();
    let fitting = UNITS.into_iter().filter(|unit| accepted::is_quantity(&first, &format!("{number} {unit}")));
    let units: Vec<&str> = own.map_or_else(|| fitting.take(2).collect(), |own| vec![own]);
    let mut calls: Vec<String> =
        units.iter().map(|unit| typed(["--set", &format!("{}={number} {unit}", seen(word))])).collect();
    let is_factor = number.parse().is_ok_and(|factor: f64| FACTORS.contains(&factor));
    if let Some(what) =
        spoken::scaled(word).filter(|_| is_factor && due.paths.iter().any(|path| due.stated(path).is_some()))
    {
        calls.push(typed(["--scale", &format!("{what}={number}")]));
    }
    (terminal::set_unit(&seen(word), language), Some(usage_hint(&UsageHint::Calls(calls), language)))
}

/// Returns the text whose dwells fill a cycle, and the changes.
fn cycle(
    text: &str,
    (prefix, word): (&str, &str),
    value: &str,
    language: Language,
) -> Option<Result<(String, Vec<String>), Fault>> {
    let number = value.replace(',', ".");
    if number.parse::<f64>().is_ok() {
        let call = typed(["--set", &format!("{}={number} s", seen(word))]);
        let hint = usage_hint(&UsageHint::Calls(vec![call]), language);
        return Some(Err((terminal::set_unit(&seen(word), language), Some(hint))));
    }
    match cycle_filled(text, prefix, &number) {
        Ok(FilledCycle { text, changes }) => {
            let shown = |value: String| if value.is_empty() { "–".to_owned() } else { value };
            let change = |(path, from, to)| format!("{path} {} → {}", shown(from), shown(to));
            let moves = segments(&written(&text)?, prefix).iter().filter(|(_, is_dwell)| !is_dwell).count();
            let whole = terminal::cycle_of_all(&seen(&number), &moves, language);
            Some(Ok((text, changes.into_iter().map(change).chain([whole]).collect())))
        }
        Err(Unfilled::TooShort { moves }) => {
            let time = time_for_cycle(text, prefix, &number);
            let call = |time| typed(["--set", &format!("time={time}"), "--set", &format!("{}={number}", seen(word))]);
            let hint = time.map(|time| usage_hint(&UsageHint::Calls(vec![call(time)]), language));
            Some(Err((terminal::cycle_too_short(&seen(&number), &moves, language), hint)))
        }
        Err(Unfilled::NoCycle) => None,
    }
}

/// Returns a time of each move of an axis that leaves a fifth of a cycle to the dwells.
pub(crate) fn time_for_cycle(text: &str, prefix: &str, cycle: &str) -> Option<String> {
    Due::of(&written(text)?, prefix, MotionWord::Moves("time")).example_time(cycle)
}

impl Due<'_> {
    /// Returns a time of each move that leaves a fifth of a cycle to its dwells.
    fn example_time(&self, cycle: &str) -> Option<String> {
        const OF_MOVES_SHARE: f64 = 0.8;
        let cycle_s = parse(Dimension::Time, cycle).ok()?.si;
        #[allow(clippy::cast_precision_loss, reason = "a count of segments")]
        let time = OF_MOVES_SHARE * cycle_s / self.paths.len().max(1) as f64;
        Some(format!("{}s", plain(time, 3)))
    }
}

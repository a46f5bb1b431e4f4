//! Values of keys that a call states in place of a table: `--vary payload=0,10,20kg`.

use super::factors;
use crate::changed::{accepted, keys, motion, places, prefix};
use crate::command::own::VARY;
use crate::command::typed::{number_and_unit, typed};
use project::{Heading, Hint, Unfilled, Written, key_at, written};
use quantities::{Language, Unit, seen};
use questions::list::Unanswered;
use questions::list::new::{Method, SAMPLES_MOST, table};
use questions::sweep::{Unstepped, stepped};
use std::borrow::Cow;
use words::spoken::{has_decimal_commas, scaled};
use words::{UsageHint, sweeps, terminal, usage_hint};

/// Largest number of keys that a refusal names.
const NAMED_MOST: usize = 4;

type Fault = (String, Option<String>);

/// Returns the table in CSV of every combination of the stated values, a range in so many steps.
///
/// # Errors
/// Every statement that is not understood; more rows than a table may have.
pub(super) fn rows(
    text: &str,
    axis: Option<&String>,
    stated: &[String],
    steps: usize,
    language: Language,
) -> Result<String, Unanswered> {
    let all = written(text).unwrap_or_default();
    let is_name = |each: &&Written| each.path.starts_with("axis[") && each.path.ends_with("].name");
    let names: Vec<&Written> = all.iter().filter(is_name).collect();
    if axis.is_none() && names.len() > 1 {
        // Of keys that name their axis only this one is meant.
        let of_axis = |each: &&Written| {
            let of_axis = each.path.trim_end_matches("name");
            stated.iter().all(|stated| stated.starts_with(of_axis))
        };
        let named: Vec<&Written> = names.iter().copied().filter(of_axis).collect();
        let names = if named.is_empty() { names } else { named };
        let names = names.into_iter().filter_map(|each| each.value.clone()).collect();
        return Err(Unanswered::which_axis(names, |names| terminal::several_axes(&names, language)));
    }
    let prefix = prefix(text, axis).unwrap_or_default();
    let (mut columns, mut faults) = (Vec::new(), Vec::new());
    for each in stated {
        match column(text, (&all, &prefix), each, language) {
            Ok(column) => columns.push(column),
            Err(fault) => faults.push(Unanswered::option(VARY, fault)),
        }
    }
    if !faults.is_empty() {
        return Err(Unanswered::combined(faults));
    }
    let rows = table(columns.iter().map(|column| column.spec.as_str()), Method::Grid, steps, 0, language);
    let rows = with_further_keys(&rows.map_err(of_vary)?, &columns);
    let rows = match columns.iter().position(|column| column.is_cycle) {
        Some(place) => {
            let cycle = stated.get(place).map(String::as_str).unwrap_or_default();
            with_filled_cycles((text, &prefix), &rows, (place, cycle), language).map_err(of_vary)?
        }
        None => rows,
    };
    match columns.iter().find(|column| column.is_load) {
        Some(column) => {
            let heading = column.spec.split(" = ").next().unwrap_or_default();
            let own = |name: &str| factors::of_load(&all, &prefix, name);
            factors::with_loads(&rows, heading, own, language).map_err(|fault| Unanswered::option(VARY, fault))
        }
        None => Ok(rows),
    }
}

/// Returns the table with the times of the dwells that fill the cycle of each row, in place of the cycle.
///
/// # Errors
/// A row whose moves take longer than its cycle.
fn with_filled_cycles(
    (text, prefix): (&str, &str),
    rows: &str,
    (place, stated): (usize, &str),
    language: Language,
) -> Result<String, Unanswered> {
    let mut lines = rows.lines();
    let head: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let dwells: Vec<String> = motion::dwells(&written(text).unwrap_or_default(), prefix);
    let others = |cells: &[&str]| -> Vec<String> {
        let other = |(at, cell): (usize, &&str)| (at != place).then(|| (*cell).to_owned());
        cells.iter().enumerate().filter_map(other).collect()
    };
    let own = |path: &String| format!("{}.time [s]", path.strip_prefix(prefix).unwrap_or(path));
    let headings = others(&head).into_iter().chain(dwells.iter().map(own));
    let mut table = headings.collect::<Vec<_>>().join(",");
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let of_row = |(heading, cell): (&&str, &&str)| match heading.split_once(" [") {
            Some((path, unit)) => (format!("{prefix}{path}"), format!("{cell} {}", unit.trim_end_matches(']'))),
            None => (format!("{prefix}{heading}"), (*cell).to_owned()),
        };
        let mut values: Vec<(String, String)> = head.iter().zip(&cells).map(of_row).collect();
        let (_, cycle) = if place < values.len() { values.remove(place) } else { continue };
        values.retain(|(path, _)| key_at(path).is_some());
        let changed = project::edit_values(text, &values).unwrap_or_else(|_| text.to_owned());
        let filled = project::cycle_filled(&changed, prefix, &cycle).map_err(|why| {
            let moves = match why {
                Unfilled::TooShort { moves } => moves,
                Unfilled::NoCycle => String::new(),
            };
            let time = motion::time_for_cycle(text, prefix, &cycle);
            let call = |time| typed(["--set", &*format!("time={time}"), &*format!("--{VARY}"), stated]);
            let hint = time.map(|time| usage_hint(&UsageHint::Calls(vec![call(time)]), language));
            Unanswered::option(VARY, (terminal::cycle_too_short(&seen(&cycle), &moves, language), hint))
        })?;
        let filled = written(&filled.text).unwrap_or_default();
        let time = |dwell: &String| {
            let path = format!("{dwell}.time");
            let time = filled.iter().find(|each| each.path == path).and_then(|each| each.value.clone());
            time.map(|time| number_and_unit(&time).0.to_owned()).unwrap_or_default()
        };
        table.push('\n');
        table.push_str(&others(&cells).into_iter().chain(dwells.iter().map(time)).collect::<Vec<_>>().join(","));
    }
    table.push('\n');
    Ok(table)
}

/// Returns the table with each further key of a word behind its last column, with the values of the first one.
fn with_further_keys(rows: &str, columns: &[Column]) -> String {
    let opposite = |cell: &str| cell.strip_prefix('-').map_or_else(|| format!("-{cell}"), str::to_owned);
    let mut lines = rows.lines();
    let mut text: String = lines.next().unwrap_or_default().to_owned();
    for further in columns.iter().flat_map(|column| &column.further) {
        text.push(',');
        text.push_str(&further.heading);
    }
    text.push('\n');
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        text.push_str(line);
        for (column, cell) in columns.iter().zip(&cells) {
            for further in &column.further {
                text.push(',');
                text.push_str(&if further.is_opposite { opposite(cell) } else { (*cell).to_owned() });
            }
        }
        text.push('\n');
    }
    text
}

/// A column of the table.
struct Column {
    /// Key and values, as a table of rows takes them.
    spec: String,
    /// Keys that the same word states.
    further: Vec<FurtherKey>,
    /// The values are durations of the whole cycle, in place of those of the first dwell.
    is_cycle: bool,
    /// The values are factors of the load, in place of those of its first key.
    is_load: bool,
}

/// A key with the values of a column.
struct FurtherKey {
    heading: String,
    /// The values have the opposite sign: a move back.
    is_opposite: bool,
}

/// Returns a fault of the table as one of the option.
fn of_vary(why: Unanswered) -> Unanswered {
    match why {
        Unanswered::Option { fault, .. } => Unanswered::option(VARY, fault),
        Unanswered::Together(all) => Unanswered::combined(all.into_iter().map(of_vary).collect()),
        other => other,
    }
}

/// Values of a key, their unit apart.
struct Stated {
    /// Numbers or words.
    values: Vec<String>,
    is_range: bool,
    is_log: bool,
    unit: String,
}

impl Stated {
    /// Splits values into a list or a range; a unit may stand behind the last value or behind each.
    fn of(key: &str, text: &str, language: Language) -> Result<Self, Fault> {
        let form = || (sweeps::vary_form(&seen(text), language), Some(sweeps::vary_form_hint(language).to_owned()));
        let whole = text;
        let (text, is_log) = text.strip_suffix("log").map_or((text, false), |text| (text.trim(), true));
        let (text, step) = apart(text);
        let is_time =
            |(low, high): &(&str, &str)| (step.is_some() || number_and_unit(low).0 == *low) && !high.contains(':');
        let dashed = || {
            let (low, high) = text.split_once(['-', '–'])?;
            let is_number = |text: &str| text.starts_with(|sign: char| sign.is_ascii_digit());
            (is_number(low) && is_number(high) && number_and_unit(high).1.find(['-', '.']).is_none())
                .then_some((low, high))
        };
        let range = text.split_once("..").or_else(dashed).or_else(|| text.split_once(':').filter(is_time));
        let parts: Vec<String> = match range {
            // An end of a range is one number; its comma is a decimal one.
            Some((low, high)) => [low, high].map(|end| with_point(end).into_owned()).to_vec(),
            None if text.contains(';') => text.split(';').map(|part| part.replace(',', ".")).collect(),
            None => listed(key, text, language)?,
        };
        let parts: Vec<&str> = parts.iter().map(|part| part.trim()).collect();
        let (mut values, mut units) = (Vec::new(), Vec::new());
        for part in &parts {
            let (number, unit) = number_and_unit(part);
            if number.parse::<f64>().is_ok() {
                values.push(number.to_owned());
                units.extend((!unit.is_empty()).then(|| unit.to_owned()));
            } else {
                values.push((*part).to_owned());
            }
        }
        units.dedup();
        if let Some(step) = step {
            if units.len() > 1 || range.is_none() {
                return Err(form());
            }
            return Self::stepped((key, whole), &values, (with_point(step), units.pop(), is_log), language);
        }
        if units.len() > 1 || values.iter().any(String::is_empty) {
            return Err(form());
        }
        Ok(Self { values, is_range: range.is_some(), is_log, unit: units.pop().unwrap_or_default() })
    }

    /// Returns the values of a range at a step, whose unit may be another one of the same quantity.
    fn stepped(
        (key, whole): (&str, &str),
        ends: &[String],
        (step, unit, is_log): (Cow<'_, str>, Option<String>, bool),
        language: Language,
    ) -> Result<Self, Fault> {
        let shown = seen(whole);
        let (number, own) = number_and_unit(step.trim());
        let unit = unit.unwrap_or_else(|| own.to_owned());
        let number = if own.is_empty() || own == unit {
            number.to_owned()
        } else {
            let converted = Unit::of(own).zip(Unit::of(&unit)).and_then(|(from, to)| in_unit(number, from, to));
            let other = || (sweeps::step_of_another_quantity(&seen(step.trim()), &shown, language), None);
            converted.ok_or_else(other)?
        };
        if is_log {
            return Err((sweeps::step_of_log(&shown, language), None));
        }
        let [low, high] = ends else { return Err((sweeps::vary_form(&shown, language), None)) };
        let call = |values: &[&str]| change(key, &format!("{}{unit}", values.join(":")));
        match stepped(low, high, &number) {
            Ok(values) => Ok(Self { values, is_range: false, is_log: false, unit }),
            Err(Unstepped::Missed(nearest)) => {
                // `30:5:60` has its step in the middle, as other programs write it.
                let is_middle = stepped(low, &number, high).is_ok_and(|values| values.len() > 2);
                let calls: Vec<String> = match is_middle {
                    true => vec![call(&[low, &number, high])],
                    false => nearest.iter().map(|step| call(&[low, high, step])).collect(),
                };
                let hint = usage_hint(&UsageHint::Calls(calls), language);
                Err((sweeps::step_misses(&shown, &format!("{number} {unit}").trim(), language), Some(hint)))
            }
            Err(Unstepped::NoNumber | Unstepped::TooMany) => {
                Err((sweeps::step_too_small(&shown, &seen(&step), &SAMPLES_MOST, language), None))
            }
        }
    }

    /// Returns the last value with its unit.
    fn last(&self, unit: &str) -> String {
        format!("{} {unit}", self.values.last().map_or("", String::as_str)).trim().to_owned()
    }
}

/// Splits the step off a range that states one: `30..60:5kg`, `30:60:5kg`.
fn apart(text: &str) -> (&str, Option<&str>) {
    let is_number = |text: &str| {
        let text = text.trim();
        text.starts_with(|sign: char| sign.is_ascii_digit() || "+-.".contains(sign))
            && !number_and_unit(text).0.is_empty()
    };
    let dashed = || text.split_once(['-', '–']).filter(|(low, high)| low.parse::<f64>().is_ok() && is_number(high));
    let rest = text.split_once("..").or_else(dashed).or_else(|| text.split_once(':'));
    let stepped = rest.and_then(|(low, rest)| Some((low, rest.split_once(':')?)));
    match stepped.filter(|(low, (high, step))| [low, high, step].into_iter().all(|text| is_number(text))) {
        Some((_, (_, step))) => (text.get(..text.len() - step.len() - 1).unwrap_or(text), Some(step.trim())),
        None => (text, None),
    }
}

/// Converts a difference between two values to another unit of its quantity, as an exact decimal number.
fn in_unit(number: &str, from: &Unit, to: &Unit) -> Option<String> {
    let number: f64 = number.parse().ok()?;
    let si = from.to_si(number) - from.to_si(0.0);
    let value = to.from_si(si) - to.from_si(0.0);
    let rounded: f64 = format!("{value:.9e}").parse().ok()?;
    (from.dimension == to.dimension).then(|| rounded.to_string())
}

/// Splits a list at its commas, some of which may be decimal signs. Where a unit stands behind every second piece, the commas
/// before these are. An even number of pieces without blanks is ambiguous where numbers usually have decimal commas; so are two
/// pieces in every language, unless the second one ends in a zero, and pieces that do not rise: none if one of them has a point.
fn listed(key: &str, text: &str, language: Language) -> Result<Vec<String>, Fault> {
    let pieces: Vec<&str> = text.split(',').collect();
    let is_number = |piece: &&str| piece.starts_with(|sign: char| sign.is_ascii_digit()) && !piece.ends_with(' ');
    let is_even = pieces.len().is_multiple_of(2) && pieces.iter().skip(1).all(is_number);
    let has_unit = |piece: &&str| !number_and_unit(piece.trim()).1.is_empty();
    let with_unit: Vec<bool> = pieces.iter().map(has_unit).collect();
    let pairs = || pieces.chunks(2).map(|pair| pair.join(".")).collect::<Vec<String>>();
    if is_even && pieces.len() > 2 && with_unit.chunks(2).all(|pair| pair == [false, true]) {
        return Ok(pairs());
    }
    let is_list = with_unit.iter().filter(|has_unit| **has_unit).count() > 1;
    let has_point = pieces.iter().any(|piece| piece.contains('.'));
    let numbers: Vec<&str> = pieces.iter().map(|piece| number_and_unit(piece.trim()).0).collect();
    // `0,500` has three decimals or separates thousands, `0,90` are two values.
    let is_longer = || matches!(numbers[..], [one, other] if other.len() > 2 && other.len() > one.len());
    let is_pair = || pieces.len() == 2 && (is_longer() || !numbers.iter().skip(1).any(|number| number.ends_with('0')));
    let value = |number: &&str| number.parse::<f64>().unwrap_or(f64::NAN);
    let rises = || numbers.windows(2).all(|pair| pair.first().map(value) < pair.get(1).map(value));
    if is_even && !is_list && !has_point && (has_decimal_commas(language) || is_pair() || !rises()) {
        let options = [pieces.join(";"), pairs().join(";")].map(|values| change(key, &values));
        let hint = usage_hint(&UsageHint::Calls(options.to_vec()), language);
        return Err((sweeps::vary_commas(&seen(text), language), Some(hint)));
    }
    Ok(pieces.into_iter().map(str::to_owned).collect())
}

/// Returns a number with a decimal point in place of its comma, unless that may separate thousands.
fn with_point(number: &str) -> Cow<'_, str> {
    let (digits, _) = number_and_unit(number.trim());
    match digits.split_once(',') {
        Some((_, rest)) if !rest.contains([',', '.']) && rest.len() != 3 => Cow::Owned(number.replacen(',', ".", 1)),
        _ => Cow::Borrowed(number),
    }
}

/// Returns the option with other words.
fn change(key: &str, values: &str) -> String {
    typed([&*format!("--{VARY}"), &*format!("{key}={}", seen(values))])
}

/// Returns a column with its values.
fn column(
    text_of_project: &str,
    (all, prefix): (&[Written], &str),
    stated: &str,
    language: Language,
) -> Result<Column, Fault> {
    let form = || (sweeps::vary_form(&seen(stated), language), Some(sweeps::vary_form_hint(language).to_owned()));
    let (key, text) = stated.split_once('=').ok_or_else(form)?;
    let (key, text) = (key.trim(), text.trim());
    let values = Stated::of(key, text, language)?;
    if let Some(column) = of_motion((text_of_project, all, prefix), (key, text), &values, language)? {
        return Ok(column);
    }
    if scaled(key) == Some("load") && values.unit.is_empty() {
        let first = factors::of_load(all, prefix, "1").and_then(|all| all.into_iter().next());
        let (heading, _) = first.ok_or_else(|| (terminal::no_load_to_scale(language).to_owned(), None))?;
        let spec = spec(&heading, &values);
        return Ok(Column { spec, further: Vec::new(), is_cycle: false, is_load: true });
    }
    let key = project::with_brackets(key);
    let key = key.strip_prefix(prefix).unwrap_or(&key);
    let path = if key == questions::sweep::CODE || key_at(key).is_some_and(|key| !accepted::is_table(key.kind)) {
        key.to_owned()
    } else {
        let own = |path: &String| path.strip_prefix(prefix).unwrap_or(path).to_owned();
        let find = |value: &str| -> Vec<String> { keys::named(all, prefix, key, value).iter().map(own).collect() };
        let mut found = find(&values.last(&values.unit));
        if found.is_empty() && values.unit.is_empty() {
            // The unit is missing below.
            found = keys::UNITS
                .iter()
                .map(|unit| find(&values.last(unit)))
                .find(|found| !found.is_empty())
                .unwrap_or_default();
        }
        if found.is_empty() {
            found = places::anywhere(all, prefix, key, &values.last(&values.unit)).iter().map(own).collect();
        }
        match &found[..] {
            [path] => path.clone(),
            [] => {
                let stated: Vec<&str> = all.iter().map(|each| each.path.as_str()).collect();
                let hint = match keys::nearest(all, key, &stated) {
                    Hint::DidYouMean(path) if key_at(&path).is_some() => UsageHint::Calls(vec![change(&path, text)]),
                    hint => UsageHint::Words(hint),
                };
                let hint = usage_hint(&hint, language);
                return Err((terminal::set_no_key(&seen(key), language), Some(hint)));
            }
            [one, other, ..] => {
                let options = found.iter().take(NAMED_MOST).map(|path| change(path, text)).collect();
                let hint = usage_hint(&UsageHint::Calls(options), language);
                return Err((terminal::set_which(&seen(key), one, other, language), Some(hint)));
            }
        }
    };
    let needs_unit = Heading::lacks_unit_of(&path).is_some();
    if needs_unit && values.unit.is_empty() {
        let value =
            all.iter().find(|each| each.path == format!("{prefix}{path}")).and_then(|each| each.value.as_deref());
        let own = value.map(|value| number_and_unit(value).1).filter(|unit| !unit.is_empty());
        let fitting = keys::UNITS.into_iter().filter(|unit| accepted::is_quantity(&path, &values.last(unit)));
        let units: Vec<&str> = own.map_or_else(|| fitting.collect(), |own| vec![own]);
        let options = units.into_iter().take(NAMED_MOST).map(|unit| change(&path, &format!("{text} {unit}"))).collect();
        let hint = usage_hint(&UsageHint::Calls(options), language);
        return Err((sweeps::vary_unit(&path, language), Some(hint)));
    }
    if let Some((entry, count)) = keys::no_entry(all, &format!("{prefix}{path}")) {
        let nearest = project::nearest_entry(all, &format!("{prefix}{path}"));
        let call = nearest.map(|path| change(path.strip_prefix(prefix).unwrap_or(&path), text));
        let hint = call.map(|call| usage_hint(&UsageHint::Calls(vec![call]), language));
        return Err((sweeps::no_entry(&seen(&entry), &count, language), hint));
    }
    Ok(Column { spec: spec(&path, &values), further: Vec::new(), is_cycle: false, is_load: false })
}

fn spec(path: &str, values: &Stated) -> String {
    let separator = if values.is_range { ".." } else { "; " };
    let log = if values.is_log { " log" } else { "" };
    format!("{} = {}{log}", heading(path, values), values.values.join(separator))
}

fn heading(path: &str, values: &Stated) -> String {
    if values.unit.is_empty() { path.to_owned() } else { format!("{path} [{}]", values.unit) }
}

/// Returns the column of a word for the motion, with every move that it is for; `None` for another word.
fn of_motion(
    (text, all, prefix): (&str, &[Written], &str),
    (word, stated): (&str, &str),
    values: &Stated,
    language: Language,
) -> Result<Option<Column>, Fault> {
    let Some(meaning) = motion::meaning(word) else { return Ok(None) };
    let is_stated = all.iter().any(|each| each.path.starts_with(prefix) && each.path.ends_with(".cycle"));
    // The call that states the word with one value before it is varied.
    let set_first = || {
        let set = typed([
            "--set",
            &format!("{word}={}", values.last(&values.unit)),
            &*format!("--{VARY}"),
            &format!("{word}={}", seen(stated)),
        ]);
        usage_hint(&UsageHint::Calls(vec![set]), language)
    };
    if meaning == motion::MotionWord::Cycle && values.unit.is_empty() {
        let hint = usage_hint(&UsageHint::Calls(vec![change(word, &format!("{stated} s"))]), language);
        return Err((sweeps::vary_unit(&seen(word), language), Some(hint)));
    }
    if meaning == motion::MotionWord::Cycle
        && !is_stated
        && let Some(dwell) = motion::filling_dwell(text, prefix, &values.last(&values.unit))
    {
        let path = format!("{}.time", dwell.strip_prefix(prefix).unwrap_or(&dwell));
        return Ok(Some(Column { spec: spec(&path, values), further: Vec::new(), is_cycle: true, is_load: false }));
    }
    if meaning == motion::MotionWord::Cycle && !is_stated {
        return Err((sweeps::vary_no_cycle(&seen(word), language), Some(set_first())));
    }
    let unit = match &*values.unit {
        "" => motion::unit(text, (prefix, word)).unwrap_or_default(),
        unit => unit.to_owned(),
    };
    let Some(found) = motion::values(text, (prefix, word), &values.last(&unit), &[], language) else { return Ok(None) };
    let found = found.map_err(|(message, hint)| {
        let begin = usage_hint(&UsageHint::Calls(vec![String::new()]), language);
        let options = hint.as_deref().and_then(|hint| hint.strip_prefix(&begin)).unwrap_or_default();
        let keys = options
            .lines()
            .filter_map(|option| Some(option.strip_prefix("--set ")?.trim_matches('"').split_once('=')?.0));
        let calls: Vec<String> = keys.map(|key| change(key, stated)).collect();
        (message, (!calls.is_empty()).then(|| usage_hint(&UsageHint::Calls(calls), language)))
    })?;
    if values.unit.is_empty() && !unit.is_empty() {
        let hint = usage_hint(&UsageHint::Calls(vec![change(word, &format!("{stated} {unit}"))]), language);
        return Err((sweeps::vary_unit(&seen(word), language), Some(hint)));
    }
    if found.iter().any(|(_, value)| value.is_empty()) {
        return Err((sweeps::vary_replaces(&seen(word), language), Some(set_first())));
    }
    let own = |path: &String| path.strip_prefix(prefix).unwrap_or(path).to_owned();
    let is_back = |value: &String| value.starts_with('-');
    let mut found = found.iter();
    let Some((first, value)) = found.next() else { return Ok(None) };
    let further = found.map(|(path, other)| FurtherKey {
        heading: heading(&own(path), values),
        is_opposite: is_back(other) != is_back(value),
    });
    Ok(Some(Column { spec: spec(&own(first), values), further: further.collect(), is_cycle: false, is_load: false }))
}

//! Values of keys that a call states in place of a table: `--vary payload=0,10,20kg`.

use crate::changed::{keys, prefix};
use crate::command::own::VARY;
use crate::command::typed::{number_and_unit, typed};
use project::{Heading, Written, key_at, written};
use quantities::{Language, seen};
use questions::list::Unanswered;
use questions::list::new::{Method, table};
use words::spoken::has_decimal_commas;
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
    let prefix = prefix(text, axis).unwrap_or_default();
    let (mut columns, mut faults) = (Vec::new(), Vec::new());
    for each in stated {
        match column(&all, &prefix, each, language) {
            Ok(column) => columns.push(column),
            Err(fault) => faults.push(Unanswered::option(VARY, fault)),
        }
    }
    if !faults.is_empty() {
        return Err(Unanswered::combined(faults));
    }
    table(columns.iter().map(String::as_str), Method::Grid, steps, 0, language).map_err(of_vary)
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
        let (text, is_log) = text.strip_suffix("log").map_or((text, false), |text| (text.trim(), true));
        let is_time = |(low, high): &(&str, &str)| number_and_unit(low).0 == *low && !high.contains(':');
        let range = text.split_once("..").or_else(|| text.split_once(':').filter(is_time));
        let parts: Vec<String> = match range {
            Some((low, high)) => vec![low.to_owned(), high.to_owned()],
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
        if units.len() > 1 || values.iter().any(String::is_empty) {
            return Err(form());
        }
        Ok(Self { values, is_range: range.is_some(), is_log, unit: units.pop().unwrap_or_default() })
    }

    /// Returns the last value with its unit.
    fn last(&self, unit: &str) -> String {
        format!("{} {unit}", self.values.last().map_or("", String::as_str)).trim().to_owned()
    }
}

/// Splits a list at its commas. In German these may be decimal signs: an even number of pieces without blanks is ambiguous.
fn listed(key: &str, text: &str, language: Language) -> Result<Vec<String>, Fault> {
    let pieces: Vec<&str> = text.split(',').collect();
    let is_number = |piece: &&str| piece.starts_with(|sign: char| sign.is_ascii_digit()) && !piece.ends_with(' ');
    let is_of_numbers = pieces.iter().skip(1).all(is_number) && pieces.len().is_multiple_of(2);
    if has_decimal_commas(language) && is_of_numbers {
        let pairs: Vec<String> = pieces.chunks(2).map(|pair| pair.join(",")).collect();
        let options = [pieces.join(";"), pairs.join(";").replace(',', ".")].map(|values| change(key, &values));
        let hint = usage_hint(&UsageHint::Calls(options.to_vec()), language);
        return Err((sweeps::vary_commas(&seen(text), language), Some(hint)));
    }
    Ok(pieces.into_iter().map(str::to_owned).collect())
}

/// Returns the option with other words.
fn change(key: &str, values: &str) -> String {
    typed([&*format!("--{VARY}"), &*format!("{key}={}", seen(values))])
}

/// Returns a column with its values, as a table of rows takes it.
fn column(all: &[Written], prefix: &str, stated: &str, language: Language) -> Result<String, Fault> {
    let form = || (sweeps::vary_form(&seen(stated), language), Some(sweeps::vary_form_hint(language).to_owned()));
    let (key, text) = stated.split_once('=').ok_or_else(form)?;
    let (key, text) = (key.trim(), text.trim());
    let values = Stated::of(key, text, language)?;
    let key = keys::with_brackets(key);
    let key = key.strip_prefix(prefix).unwrap_or(&key);
    let path = if key == questions::sweep::CODE || key_at(key).is_some() {
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
        match &found[..] {
            [path] => path.clone(),
            [] => {
                let stated: Vec<&str> = all.iter().map(|each| each.path.as_str()).collect();
                let hint = usage_hint(&UsageHint::Words(keys::nearest(all, key, &stated)), language);
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
        let fitting = keys::UNITS.into_iter().filter(|unit| keys::is_quantity(&path, &values.last(unit)));
        let units: Vec<&str> = own.map_or_else(|| fitting.collect(), |own| vec![own]);
        let options = units.into_iter().take(NAMED_MOST).map(|unit| change(&path, &format!("{text} {unit}"))).collect();
        let hint = usage_hint(&UsageHint::Calls(options), language);
        return Err((sweeps::vary_unit(&path, language), Some(hint)));
    }
    let unit = if values.unit.is_empty() { String::new() } else { format!(" [{}]", values.unit) };
    let separator = if values.is_range { ".." } else { "; " };
    let log = if values.is_log { " log" } else { "" };
    Ok(format!("{path}{unit} = {}{log}", values.values.join(separator)))
}

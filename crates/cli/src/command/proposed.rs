//! Options for a word that is the value of none: a factor of the load, a key of the project with this quantity.

use super::example::filled;
use super::folder::{RECORDINGS, axes_of, has_ending, text_of};
use super::meant::Called;
use super::typed::typed;
use crate::changed::keys;
use clap::Arg;
use project::{Hint, Written, key_at, nearest_name, written};
use questions::list::{Argument, Entry, LIST};
use std::ffi::OsString;
use std::path::Path;

/// Commands and options whose words name what another command may be meant to show.
const OTHER_COMMANDS: [(&str, &str); 3] = [("explain", "check"), ("plot", "figure"), ("simulate", "scenario")];

/// Largest number of options that a refusal names.
const PROPOSALS_MOST: usize = 4;

/// Unit and key of a column whose range is stated as `payload=0..10kg`.
struct RangeWord<'w> {
    name: &'w str,
    low: &'w str,
    high: &'w str,
    unit: &'w str,
}

/// Returns the factor that a word states as a percentage or with a sign of multiplication.
fn factor(word: &str) -> Option<f64> {
    if let Some(number) = word.strip_suffix('%') {
        let percent: f64 = number.replace(',', ".").parse().ok()?;
        let is_change = number.starts_with(['+', '-']) || percent < SHARE_LEAST;
        return Some(if is_change { 100.0 + percent } else { percent } / 100.0);
    }
    let number = word.strip_prefix(['x', '×', '*']).or_else(|| word.strip_suffix(['x', '×']))?;
    number.replace(',', ".").parse().ok()
}

/// Percentage without a sign from which it is a share, below an increase.
const SHARE_LEAST: f64 = 50.0;

/// Splits a number from its unit.
pub(super) fn number_and_unit(text: &str) -> (&str, &str) {
    let is_number = |sign: char| sign.is_ascii_digit() || ".,+-".contains(sign);
    let end = text.find(|sign| !is_number(sign)).unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    (number, unit.trim())
}

impl<'w> RangeWord<'w> {
    fn of(word: &'w str) -> Option<Self> {
        let (name, values) = word.split_once('=')?;
        let (low, high) = values.split_once("..").or_else(|| values.split_once(':'))?;
        let ((low, unit_low), (high, unit)) = (number_and_unit(low.trim()), number_and_unit(high.trim()));
        let is_range = !name.trim().is_empty() && low.parse::<f64>().is_ok() && high.parse::<f64>().is_ok();
        (is_range && (unit_low.is_empty() || unit_low == unit)).then_some(Self { name: name.trim(), low, high, unit })
    }

    /// Returns the column of a table of rows.
    fn column(&self, all: &[Written]) -> Option<String> {
        let name = keys::with_brackets(self.name);
        let value = format!("{} {}", self.high, self.unit);
        let path = if key_at(&name).is_some() {
            Some(name)
        } else {
            keys::named(all, "", &name, value.trim()).into_iter().next()
        };
        let unit = if self.unit.is_empty() { String::new() } else { format!(" [{}]", self.unit) };
        Some(format!("{}{unit} = {}..{}", path?, self.low, self.high))
    }
}

/// Returns the calls that write a table with columns, and evaluate it for a project.
fn calls_of_columns(columns: &[String], project: Option<&str>) -> Vec<String> {
    let keys = columns.iter().flat_map(|column| ["--key", column]);
    let table = ["antrieb", "new", "sweep"].into_iter().chain(keys).chain(["--out", TABLE]);
    let answer = project.map(|project| typed(["antrieb", "sweep", project, "--table", TABLE, "--out", ANSWERS]));
    std::iter::once(typed(table)).chain(answer).collect()
}

/// Returns a column with a range about the first time, else the first quantity, of the motion of a project.
fn example_column(all: &[Written]) -> String {
    let is_of_motion = |each: &&Written| each.path.contains("motion[");
    let column = |each: &Written| {
        let (number, unit) = number_and_unit(each.value.as_deref()?);
        let number: f64 = number.parse().ok().filter(|number| *number > 0.0 && !unit.is_empty())?;
        let [low, high] = [RANGE_LOW, RANGE_HIGH].map(|share| format!("{:.4}", share * number));
        let [low, high] = [&low, &high].map(|text| text.trim_end_matches('0').trim_end_matches('.'));
        Some(format!("{} [{unit}] = {low}..{high}", each.path))
    };
    let own = || all.iter().filter(is_of_motion);
    let of_time = own().filter(|each| each.path.ends_with(".time")).find_map(column);
    of_time.or_else(|| own().find_map(column)).unwrap_or_else(|| "motion[1].time [s] = 1..3".to_owned())
}

/// Shares of a stated value between which an example varies it.
const RANGE_LOW: f64 = 0.8;
const RANGE_HIGH: f64 = 1.25;

/// Names of the table of rows and of its answers in an example.
const TABLE: &str = "tasks.csv";
const ANSWERS: &str = "best.csv";

impl Called<'_> {
    pub(super) fn has(&self, name: &str) -> bool {
        self.options().any(|option| option.get_long() == Some(name))
    }

    /// Returns `true` if a word is the name of an axis of the projects of the call.
    pub(super) fn is_axis(&self, word: &str) -> bool {
        !has_ending(word, &[".toml"]) && self.projects.iter().any(|path| axes_of(path).iter().any(|name| name == word))
    }

    /// Returns `true` if a word is a recording and a call lacks its project.
    pub(super) fn stands_for_project(&self, word: &str, texts: &[&str]) -> bool {
        let is_project = |text: &&str| has_ending(text, &[".toml"]);
        let lacks =
            !texts.iter().any(is_project) && self.command.get_positionals().any(|each| each.get_id() == "project");
        lacks && has_ending(word, &RECORDINGS)
    }

    /// Returns the text of the first project of the call.
    pub(super) fn project_text(&self) -> Option<String> {
        self.projects.first().and_then(|path| text_of(path))
    }

    /// Returns the call of another command about the project, of which a word is the name of a check, a figure or a scenario.
    pub(super) fn other_command(&self, word: &str) -> Option<String> {
        let project = self.projects.first()?.to_str()?;
        let takes = |entry: &Entry| {
            let of_others =
                |argument: &&Argument| OTHER_COMMANDS.contains(&(entry.command, argument.name)) && argument.takes(word);
            let option = format!("--{}", entry.arguments.iter().find(of_others)?.name);
            Some(typed([super::NAME, entry.command, project, &option, word]))
        };
        LIST.iter().copied().find_map(takes)
    }

    /// Returns options that take what a word may mean for the project: a factor of the load, a value of a key.
    pub(super) fn proposals(&self, word: &str) -> Vec<(String, String)> {
        if Path::new(word).exists() {
            return Vec::new();
        }
        if let Some(factor) = factor(word).filter(|_| self.has("scale")) {
            let factor = format!("{factor:.6}");
            let factor = factor.trim_end_matches('0').trim_end_matches('.');
            return vec![("--scale".to_owned(), format!("load={factor}"))];
        }
        if !self.has("set") || !word.starts_with(|sign: char| sign.is_ascii_digit() || "+-.".contains(sign)) {
            return Vec::new();
        }
        let text = self.project_text().unwrap_or_default();
        let paths = keys::of_quantity(&text, "", word);
        paths.into_iter().take(PROPOSALS_MOST).map(|path| ("--set".to_owned(), format!("{path}={word}"))).collect()
    }

    /// Returns the option with the most similar name.
    pub(super) fn near_option(&self, word: &str) -> Option<String> {
        let names: Vec<&str> = self.options().filter_map(Arg::get_long).collect();
        let name = word.trim_start_matches('-').split('=').next().unwrap_or_default();
        match nearest_name(name, &names) {
            Hint::DidYouMean(name) => Some(format!("--{name}")),
            _ => None,
        }
    }

    /// Returns the calls with an option that exists in place of an unknown one: a key of the project, a factor, or the option
    /// that is meant.
    pub(super) fn calls_instead_of(&self, word: &str, meant: Option<&str>, arguments: &[OsString]) -> Vec<String> {
        let texts: Vec<&str> = arguments.iter().filter_map(|word| word.to_str()).collect();
        let is_it = |text: &&str| text.split('=').next() == word.split('=').next();
        let Some(place) = texts.iter().position(is_it).filter(|_| texts.len() == arguments.len()) else {
            return Vec::new();
        };
        let name = word.trim_start_matches('-').split('=').next().unwrap_or_default().replace('-', "_");
        let (value, behind) = match texts.get(place).and_then(|text| text.split_once('=')) {
            Some((_, value)) => (value, place + 1),
            None => match texts.get(place + 1).filter(|next| !next.starts_with("--")) {
                Some(value) => (*value, place + 2),
                None => ("", place + 1),
            },
        };
        let is_number = value.replace(',', ".").parse::<f64>().is_ok();
        let scaled = if crate::changed::SCALED.contains(&name.as_str()) { name.as_str() } else { "load" };
        let named = || {
            let all = self.project_text().and_then(|text| written(&text)).unwrap_or_default();
            keys::named(&all, "", &name, value)
        };
        let options: Vec<[String; 2]> = match meant {
            _ if value.is_empty() => meant.map(|meant| [meant.to_owned(), String::new()]).into_iter().collect(),
            _ if is_number && self.has("scale") && (meant == Some("--scale") || scaled == name) => {
                vec![["--scale".to_owned(), format!("{scaled}={value}")]]
            }
            Some(meant) if meant != "--scale" && meant != "--set" || value.contains('=') => {
                vec![[meant.to_owned(), value.to_owned()]]
            }
            _ if self.has("set") => {
                let paths = named().into_iter().take(PROPOSALS_MOST);
                paths.map(|path| ["--set".to_owned(), format!("{path}={value}")]).collect()
            }
            _ => Vec::new(),
        };
        let call = |option: &[String; 2]| {
            let (head, _) = arguments.split_at(place);
            let tail = arguments.get(behind..).unwrap_or_default();
            let option = option.iter().filter(|word| !word.is_empty()).map(OsString::from);
            let whole: Vec<OsString> = head.iter().cloned().chain(option).chain(tail.iter().cloned()).collect();
            filled(&whole, self)
        };
        options.iter().filter_map(call).collect()
    }

    /// Returns the calls that write a table of the ranges of a call and evaluate it; empty unless all of its words
    /// without an option are ranges of keys of its project.
    pub(super) fn calls_of_ranges(&self, words: &[&str]) -> Vec<String> {
        if self.entry.is_none_or(|entry| entry.command != "sweep") {
            return Vec::new();
        }
        let (Some(project), Some(text)) = (self.projects.first().and_then(|path| path.to_str()), self.project_text())
        else {
            return Vec::new();
        };
        let all = written(&text).unwrap_or_default();
        let columns: Vec<String> = words.iter().filter_map(|word| RangeWord::of(word)?.column(&all)).collect();
        if columns.is_empty() { Vec::new() } else { calls_of_columns(&columns, Some(project)) }
    }

    /// Returns the calls that write a table with a range of one key of the project and evaluate it.
    pub(super) fn calls_of_example_range(&self) -> Vec<String> {
        let all = self.project_text().and_then(|text| written(&text)).unwrap_or_default();
        let project = self.projects.first().and_then(|path| path.to_str());
        calls_of_columns(&[example_column(&all)], project)
    }
}

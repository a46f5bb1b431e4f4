//! Calls in place of one that was parsed and cannot be answered.

use super::best::{ProjectOfCall, best_products};
use super::effects;
use super::example::{filled, split};
use super::folder::{RECORDINGS, axes_of, has_ending, project_name, projects_in};
use super::meant::Called;
use super::own::is_of_several;
use super::replaced::{code_of, more_codes};
use super::solid;
use super::spoken::seems_code;
use super::typed::{number_and_unit, typed};
use crate::changed::{mass, motion};
use clap::Command;
use project::{Hint, Kind, Written, example, key_at, nearest_name, other_names, written};
use quantities::Language;
use questions::Refusal;
use questions::list::Unanswered;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use words::{UsageHint, spoken, usage_hint};

/// Key of the kind of a stage, and the kind that a ratio alone means.
const STAGE_KIND: &str = "stage.kind";
const GEAR: &str = "gear";

/// Largest number of axes of which one is proposed.
const AXES_MOST: usize = 6;

/// Largest number of projects of a folder that are named in place of a missing one.
const PROJECTS_MOST: usize = 3;

/// Returns the calls in place of a refused one; empty if none is known.
pub(crate) fn calls(why: &Unanswered, arguments: &[OsString], whole: &Command, language: Language) -> Vec<String> {
    let Some(called) = Called::of(arguments, whole, language) else { return Vec::new() };
    let call = Call { called, arguments };
    // A number that may be read in two ways has its own proposals.
    let begin = usage_hint(&UsageHint::Calls(vec![String::new()]), language);
    let is_answered =
        matches!(why, Unanswered::Option { name: "set", fault: (_, Some(hint)) } if hint.starts_with(&begin));
    if let Some(swept) = call.with_several_values().filter(|_| !is_answered) {
        return vec![swept];
    }
    match why {
        Unanswered::File { name, is_too_large: false, .. } => call.with_other_file(name),
        Unanswered::Text { faults, .. }
            if faults.len() == 1 && faults.iter().any(|fault| fault.id.ends_with("_not_closed")) =>
        {
            let both = call.with_both_ways();
            both.into_iter().chain(call.with(&["--set", "axis.single_move=true"])).collect()
        }
        Unanswered::Text { faults, text, .. } if faults.iter().any(|fault| fault.id == NO_EFFECT) => {
            call.with_load_for_payload(text)
        }
        Unanswered::Text { faults, text, .. }
            if call.is_about_a_recording() && faults.iter().all(|fault| fault.id == MISSING) =>
        {
            call.with_missing_values(text, &faults.iter().map(|fault| fault.message.clone()).collect::<Vec<_>>())
        }
        Unanswered::Text { faults, .. } if faults.iter().all(|fault| fault.id == MISSING) && call.called.has("set") => {
            call.with_missing_choices(&faults.iter().map(|fault| fault.message.as_str()).collect::<Vec<_>>())
        }
        // Lengths without a unit are in millimetres, if nothing else is wrong.
        Unanswered::Text { faults, .. } if faults.iter().all(|fault| fault.id == UNIT_MISSING) => {
            let meant = solid::with_units(arguments, &call.called);
            meant.and_then(|arguments| filled(&arguments, &call.called)).into_iter().collect()
        }
        Unanswered::Code { .. } | Unanswered::Text { .. } if call.with_any_fields(language).is_some() => {
            call.with_any_fields(language).into_iter().collect()
        }
        Unanswered::Refused(Refusal::NoActuator, _) => call.with_own_best(),
        Unanswered::Option { name: "from", .. } => call.as_recording(),
        Unanswered::Option { name: "at" | "reaction", .. } if !call.states("scenario") => {
            call.with(&["--scenario", "emergency_stop"])
        }
        Unanswered::Option { name: "steps" | "step" | "decimal-comma", .. } => Vec::new(),
        Unanswered::Option { name, .. } if call.is_idle(name) => {
            call.with_needed(&effects::needs(call.command(), name))
        }
        Unanswered::Option { name: "hours-per-day", .. } if call.command() == "simulate" && !call.states("days") => {
            call.with(&["--days", "1"])
        }
        Unanswered::Option { name: "key", .. } if !call.states("key") => call.called.calls_of_example_table(),
        Unanswered::WhichAxis { names, .. } => {
            names.iter().take(AXES_MOST).flat_map(|name| call.of_axis(name)).collect()
        }
        Unanswered::Message(_) if call.command() == "export" && !call.states("table") => {
            call.with_option_of_example("out")
        }
        Unanswered::Message(_) if call.command() == "compare" => call.with_compared_codes(language),
        Unanswered::Together(all) => match &all[..] {
            [one] => calls(one, arguments, whole, language),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// Options whose faults name what to write in place of their values.
const CHANGES: [&str; 3] = ["set", "vary", "scale"];

/// Returns a fault whose hint names whole calls where it names options alone; of several such faults the last one names the calls
/// that remedy all of them.
///
/// `keep` selects the calls that are named.
pub(crate) fn with_whole_calls(
    why: Unanswered,
    arguments: &[OsString],
    language: Language,
    keep: &dyn Fn(Vec<String>) -> Vec<String>,
) -> Unanswered {
    let words: Option<Vec<String>> = arguments.iter().skip(1).map(|word| word.to_str().map(str::to_owned)).collect();
    let Some(words) = words else { return why };
    let begin = usage_hint(&UsageHint::Calls(vec![String::new()]), language);
    let options_of = |why: &Unanswered| -> Option<Vec<Vec<String>>> {
        match why {
            Unanswered::Option { name, fault: (_, Some(hint)) } if CHANGES.contains(name) => {
                Some(hint.strip_prefix(&begin)?.lines().map(split).collect())
            }
            _ => None,
        }
    };
    let written = |calls: &[Vec<String>]| {
        let call = |words: &Vec<String>| typed(std::iter::once(super::NAME).chain(words.iter().map(String::as_str)));
        let calls = keep(calls.iter().map(call).collect());
        (!calls.is_empty()).then(|| usage_hint(&UsageHint::Calls(calls), language))
    };
    let all: Vec<Unanswered> = match why {
        Unanswered::Together(all) => all,
        one => vec![one],
    };
    let options: Option<Vec<Vec<Vec<String>>>> = all.iter().map(options_of).collect();
    let Some(options) = options else {
        // Faults of other kinds: each has its own calls.
        let each = all.into_iter().map(|why| match (options_of(&why), why) {
            (Some(options), Unanswered::Option { name, fault: (message, hint) }) => {
                let calls: Option<Vec<_>> = options.iter().map(|option| with_option(&words, option)).collect();
                Unanswered::Option { name, fault: (message, calls.map_or(hint, |calls| written(&calls))) }
            }
            (_, why) => why,
        });
        return Unanswered::combined(each.collect());
    };
    let most = options.iter().map(Vec::len).max().unwrap_or_default();
    let call = |place: usize| {
        options.iter().try_fold(words.clone(), |words, options| {
            with_option(&words, options.get(place).or_else(|| options.first())?)
        })
    };
    let calls: Option<Vec<Vec<String>>> = (0..most).map(call).collect();
    let Some(calls) = calls.filter(|calls| !calls.is_empty()) else { return Unanswered::combined(all) };
    let last = all.len() - 1;
    let each = all.into_iter().enumerate().map(|(place, why)| match why {
        Unanswered::Option { name, fault: (message, _) } => {
            Unanswered::Option { name, fault: (message, if place == last { written(&calls) } else { None }) }
        }
        other => other,
    });
    Unanswered::combined(each.collect())
}

/// Returns the words of a call with an option in place of the statement that it corrects; `None` if there is none.
fn with_option(words: &[String], option: &[String]) -> Option<Vec<String>> {
    let last = |path: &str| path.rsplit('.').next().unwrap_or_default().to_lowercase();
    let (key, value) = option.iter().rev().find_map(|word| word.split_once('='))?;
    // The statement of the same key, by any of its names, else of the same value.
    let is_of_key = |word: &str| {
        word.split_once('=').is_some_and(|(other, stated)| {
            let (other, key) = (last(other.trim()), last(key));
            other == key
                || other_names(&other).contains(&&*key)
                || spoken::scaled(&other).is_some_and(|scaled| scaled == key || scaled == "load")
                || value.ends_with(stated)
                || mass::is_mass_of_load(&other, stated.trim())
        })
    };
    let statement = |at: usize| {
        let word = words.get(at)?;
        let name = CHANGES.iter().find(|name| word.strip_prefix("--").is_some_and(|word| word.starts_with(**name)))?;
        match word.strip_prefix(&format!("--{name}")) {
            Some("") => words.get(at + 1).filter(|next| is_of_key(next)).map(|_| 2),
            Some(rest) => rest.strip_prefix('=').filter(|rest| is_of_key(rest)).map(|_| 1),
            None => None,
        }
    };
    let (at, count) = (0..words.len()).find_map(|at| Some((at, statement(at)?)))?;
    let mut words = words.to_vec();
    words.splice(at..at + count, option.iter().cloned());
    Some(words)
}

/// Identifier of the fault of a number without its unit.
const UNIT_MISSING: &str = "unit_missing";

/// Identifiers of the faults of a key without effect, and of one that is missing.
const NO_EFFECT: &str = "without_effect";
const MISSING: &str = "missing_key";

/// Returns a text of values in which a number in a unit is added to each number: `0..10kg` and 30 kg are `30..40kg`.
fn added(values: &str, (number, unit): (f64, &str)) -> Option<String> {
    let (mut text, mut rest) = (String::new(), values);
    let mut found = false;
    while let Some(at) = rest.find(|sign: char| sign.is_ascii_digit()) {
        let (before, behind) = rest.split_at(at);
        let is_digit = |(place, sign): (usize, char)| {
            sign.is_ascii_digit()
                || sign == '.'
                    && behind.get(place + 1..).is_some_and(|next| next.starts_with(|sign: char| sign.is_ascii_digit()))
        };
        let end = behind.char_indices().find(|each| !is_digit(*each)).map_or(behind.len(), |(place, _)| place);
        let (own, further) = behind.split_at(end);
        let own_unit = further.trim_start().split(|sign: char| !sign.is_alphabetic()).next().unwrap_or_default();
        if !own_unit.is_empty() && own_unit != unit {
            return None;
        }
        let sum = format!("{:.6}", number + own.parse::<f64>().ok()?);
        text.push_str(before);
        text.push_str(sum.trim_end_matches('0').trim_end_matches('.'));
        (rest, found) = (further, true);
    }
    text.push_str(rest);
    found.then_some(text)
}

/// A refused call.
struct Call<'c> {
    called: Called<'c>,
    arguments: &'c [OsString],
}

impl Call<'_> {
    fn command(&self) -> &str {
        self.called.entry.map(|entry| entry.command).unwrap_or_default()
    }

    fn states(&self, option: &str) -> bool {
        let begin = format!("--{option}");
        self.arguments.iter().filter_map(|word| word.to_str()).any(|word| word.split('=').next() == Some(&begin))
    }

    /// Returns the sweep over several values of a key that the call states: `--set mass=10..20kg`.
    fn with_several_values(&self) -> Option<String> {
        let words: Vec<&str> = self.arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
        let project = self.called.projects.first()?.to_str()?;
        let is_several = |word: &str| word.split_once('=').is_some_and(|(_, values)| is_of_several(values));
        let sets: Vec<&str> = (1..words.len())
            .filter(|place| words.get(place - 1) == Some(&"--set"))
            .filter_map(|place| words.get(place).copied())
            .collect();
        if self.command() == "sweep" || !sets.iter().any(|set| is_several(set)) {
            return None;
        }
        let option = |set: &&str| [if is_several(set) { "--vary" } else { "--set" }.to_owned(), (*set).to_owned()];
        let stated: Vec<String> = sets.iter().flat_map(option).collect();
        Some(typed([super::NAME, "sweep", project].into_iter().chain(stated.iter().map(String::as_str))))
    }

    /// Returns `true` if a recording stands in place of the project.
    fn is_about_a_recording(&self) -> bool {
        self.called.first.first().is_some_and(|word| has_ending(word, &RECORDINGS)) && self.called.has("set")
    }

    /// Returns the call with `*` in place of what is unreadable or missing at the end of a field of a code: `CHA-25A-100-H-?`,
    /// `CHA-25A-1?0-H-M`; `None` if no code is the better for it.
    fn with_any_fields(&self, language: Language) -> Option<String> {
        let is_pattern = |text: &str| questions::list::code_list::read_pattern(text, language).is_ok();
        // Several letters that cannot be read, at the end of a field or in all of it, are any number of them.
        let any_letters = |field: &str| {
            let known = field.trim_end_matches(['?', '#', '_']);
            match field.len() - known.len() {
                0 => field.to_owned(),
                1 if !known.is_empty() => field.to_owned(),
                _ => format!("{known}*"),
            }
        };
        let any = |word: &str| -> String {
            let text = word.split('-').map(any_letters).collect::<Vec<_>>().join("-");
            // A field that ends in the middle of its word.
            let begun = || Some(format!("{text}*")).filter(|begun| word.contains(['?', '*', '…']) && is_pattern(begun));
            if is_pattern(&text) { text } else { begun().unwrap_or(text) }
        };
        let mut is_changed = false;
        let words = self.arguments.iter().map(|word| {
            let changed = word.to_str().filter(|text| seems_code(text)).map(any);
            let changed = changed.filter(|text| is_pattern(text) && *word != text.as_str());
            is_changed |= changed.is_some();
            changed.map_or_else(|| word.clone(), OsString::from)
        });
        let words: Vec<OsString> = words.collect();
        let takes_pattern =
            !self.called.projects.is_empty() || self.called.entry.is_some_and(|entry| entry.command().contains("code"));
        // A question about one actuator has no use for several.
        let listed = || {
            let text =
                words.iter().filter_map(|word| word.to_str()).find(|text| seems_code(text) && text.contains('*'))?;
            Some(typed([super::NAME, "code", "list", text]))
        };
        match (is_changed, takes_pattern) {
            (false, _) => None,
            (true, true) => filled(&words, &self.called),
            (true, false) => listed(),
        }
    }

    /// Returns the call with the travel of the way back changed too, where it states that of one move: `distance` is that of both.
    fn with_both_ways(&self) -> Option<String> {
        let words: Vec<&str> = self.arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
        let (place, value) = words.iter().enumerate().find_map(|(place, word)| {
            let (key, value) = word.trim_start_matches("--set=").split_once('=')?;
            (key.starts_with("motion[") || key.contains("].motion[")).then_some(())?;
            key.ends_with("].distance").then_some((place, value))
        })?;
        let mut arguments = self.arguments.to_vec();
        let whole = format!("distance={value}");
        let is_joined = words.get(place)?.starts_with("--set=");
        *arguments.get_mut(place)? = if is_joined { format!("--set={whole}") } else { whole }.into();
        let axes = axes_of(self.called.projects.first()?);
        if axes.len() > 1 && !self.states("axis") {
            let stated = words.get(place)?.split_once("axis[")?.1.split_once(']')?.0.parse::<usize>().ok()?;
            arguments.extend(["--axis", axes.get(stated.checked_sub(1)?)?].map(OsString::from));
        }
        filled(&arguments, &self.called)
    }

    /// Returns the call with a payload added to the mass of a load that has none apart.
    fn with_load_for_payload(&self, text: &str) -> Vec<String> {
        let call = || {
            let mut words: Vec<String> =
                self.arguments.iter().skip(1).map(|word| word.to_str().map(str::to_owned)).collect::<Option<_>>()?;
            let is_payload = |word: &str| {
                word.split_once('=')
                    .is_some_and(|(key, _)| motion::meaning(key) == Some(motion::MotionWord::Moves("payload")))
            };
            let at = words.iter().position(|word| is_payload(word))?;
            let stated = words.get(at)?.split_once('=')?.1.to_owned();
            let all = written(text)?;
            let is_mass = |each: &&Written| {
                !each.path.contains("motion[") && each.path.ends_with(".mass") && each.value.is_some()
            };
            let mass = all.iter().find(is_mass)?;
            let (number, unit) = number_and_unit(mass.value.as_deref()?);
            let values = added(&stated, (number.parse().ok()?, unit))?;
            *words.get_mut(at)? = format!("{}={values}", mass.path);
            // The sum replaces the mass that the call states besides.
            let is_mass = |word: &str| {
                word.split_once('=').is_some_and(|(key, _)| key == mass.path || key.rsplit('.').next() == Some("mass"))
            };
            let is_other = |place: usize| {
                let own = |at: usize| words.get(at).map(String::as_str).unwrap_or_default();
                place != at && own(place.saturating_sub(1)) == "--set" && is_mass(own(place))
            };
            let others: Vec<usize> = (1..words.len()).filter(|place| is_other(*place)).collect();
            for place in others.into_iter().rev() {
                words.drain(place - 1..=place);
            }
            Some(typed(std::iter::once(super::NAME).chain(words.iter().map(String::as_str))))
        };
        call().into_iter().collect()
    }

    /// Returns the call with an example of each missing key that is a word or a number; empty if a quantity is missing.
    fn with_missing_choices(&self, messages: &[&str]) -> Vec<String> {
        let choice = |message: &&str| {
            let path = message.split('`').nth(1)?;
            // A ratio alone is that of a gear.
            if path.ends_with(STAGE_KIND) {
                return Some(format!("{path}={GEAR}"));
            }
            let key = key_at(path).filter(|key| matches!(key.kind, Kind::OneOf(_) | Kind::Number(..)))?;
            let line = example(key)?;
            Some(format!("{path}={}", line.split_once(" = ")?.1.trim_matches('"')))
        };
        let values: Option<Vec<String>> = messages.iter().map(choice).collect();
        let words = values.iter().flatten().flat_map(|value| ["--set", value.as_str()]);
        values.as_ref().map(|_| self.with(&words.collect::<Vec<_>>())).unwrap_or_default()
    }

    /// Returns the call with an example of each value that is missing, as the template of the project has it.
    fn with_missing_values(&self, text: &str, messages: &[String]) -> Vec<String> {
        let mut table = String::new();
        let mut values: Vec<String> = Vec::new();
        for line in text.lines() {
            let line = line.trim_start_matches("# ");
            if let Some(name) = line.strip_prefix('[').and_then(|line| line.split_once(']')) {
                table = name.0.trim_start_matches('[').to_owned();
            } else if let Some((key, value)) = line.split_once(" = ") {
                let value = value.split('"').nth(1).unwrap_or_default();
                let path = format!("{table}.{key}");
                let is_missing = messages.iter().any(|message| message.contains(&format!("`{path}`")));
                if is_missing && !value.is_empty() {
                    values.push(format!("{path}={value}"));
                }
            }
        }
        let words: Vec<&str> = values.iter().flat_map(|value| ["--set", value.as_str()]).collect();
        if values.len() < messages.len() { Vec::new() } else { self.with(&words) }
    }

    /// Returns the call with further words.
    fn with(&self, words: &[&str]) -> Vec<String> {
        let more = words.iter().map(OsString::from);
        let arguments: Vec<OsString> = self.arguments.iter().cloned().chain(more).collect();
        filled(&arguments, &self.called).into_iter().collect()
    }

    /// Returns the call about one axis, with its name in that of the file to be written.
    fn of_axis(&self, name: &str) -> Vec<String> {
        let is_plain = name.chars().all(|sign| sign.is_alphanumeric() || "-_".contains(sign));
        let mut words = self.arguments.to_vec();
        let out = words.iter().position(|word| word == "--out").map(|place| place + 1);
        if let Some(word) = out.and_then(|place| words.get_mut(place)).filter(|_| is_plain) {
            let path = Path::new(word.as_os_str());
            let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let ending = path.extension().map(|ending| format!(".{}", ending.to_string_lossy())).unwrap_or_default();
            *word = path.with_file_name(format!("{stem}-{name}{ending}")).into_os_string();
        }
        words.extend(["--axis", name].map(OsString::from));
        filled(&words, &self.called).into_iter().collect()
    }

    /// Returns `true` if an option has no effect in the call, which lacks the options that it needs.
    fn is_idle(&self, option: &str) -> bool {
        let needs = effects::needs(self.command(), option);
        !needs.is_empty() && !needs.iter().any(|other| self.states(other))
    }

    /// Returns the call with each of the files of which an option needs one.
    fn with_needed(&self, needs: &[&str]) -> Vec<String> {
        let of = |option: &&str| {
            let file = self.called.entry?.files().find(|file| file.option == *option)?;
            let ending = *super::folder::endings(file).first()?;
            let name = super::begun::file_beside(&self.called.projects, ending);
            self.with(&[&format!("--{option}"), &name]).into_iter().next()
        };
        needs.iter().filter_map(of).collect()
    }

    /// Returns the call with an option as in the example of the command.
    fn with_option_of_example(&self, option: &str) -> Vec<String> {
        let value = match (self.command(), option) {
            ("export", _) => {
                self.called.projects.first().map(|path| path.with_extension("xlsx").to_string_lossy().into_owned())
            }
            _ => {
                let text = self.called.entry.map(|entry| entry.example).unwrap_or_default();
                let mut words = text.split_whitespace().skip_while(|word| *word != format!("--{option}"));
                words.nth(1).map(str::to_owned)
            }
        };
        value.map(|value| self.with(&[&format!("--{option}"), &value])).unwrap_or_default()
    }

    /// Returns the call with other words in place of one.
    fn with_instead(&self, word: &str, others: &[&str]) -> Option<String> {
        let place = self.arguments.iter().position(|argument| argument == word)?;
        let mut arguments = self.arguments.to_vec();
        arguments.splice(place..=place, others.iter().map(OsString::from));
        filled(&arguments, &Called::of(&arguments, self.called.whole(), self.called.language())?)
    }

    /// Returns the call with a file in place of standard output, which does not take its format.
    fn with_file_instead_of_stdout(&self) -> Vec<String> {
        let options: Vec<&str> = self.called.options().filter_map(|option| option.get_long()).collect();
        let words: Vec<&str> = self.arguments.iter().filter_map(|word| word.to_str()).collect();
        let is_option = |place: usize| {
            let before = place.checked_sub(1).and_then(|before| words.get(before)).copied().unwrap_or_default();
            before == "-o" || before.strip_prefix("--").is_some_and(|name| options.contains(&name))
        };
        let Some(place) = (0..words.len()).find(|place| words.get(*place) == Some(&"-") && is_option(*place)) else {
            return Vec::new();
        };
        let option = place.checked_sub(1).and_then(|before| words.get(before)).copied().unwrap_or_default();
        let option = if option == "-o" { "out" } else { option.trim_start_matches('-') };
        let Some(file) = self.called.file_name(option) else { return Vec::new() };
        let mut arguments = self.arguments.to_vec();
        arguments.splice(place..=place, [OsString::from(file)]);
        filled(&arguments, &self.called).into_iter().collect()
    }

    /// Returns the calls with a project of the folder in place of a file that does not exist, else one that creates it.
    fn with_other_file(&self, name: &str) -> Vec<String> {
        let is_position = self.called.command.get_positionals().any(|position| position.get_id() == "project");
        let path = Path::new(name);
        if name == "-" {
            return self.with_file_instead_of_stdout();
        }
        if !is_position || path.exists() || has_ending(name, &RECORDINGS) {
            return Vec::new();
        }
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut projects = projects_in(folder);
        projects.retain(|path| !self.called.projects.contains(path));
        let shown = |path: &PathBuf| path.to_string_lossy().into_owned();
        let names: Vec<String> = projects.iter().map(shown).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let own = format!("{name}.toml");
        if names.contains(&own.as_str()) {
            return self.with_instead(name, &[&own]).into_iter().collect();
        }
        let has_axis = |path: &&PathBuf| axes_of(path).iter().any(|axis| axis == name);
        if let Some(with_axis) = projects.iter().find(has_axis).filter(|_| self.called.has("axis")) {
            return self.with_instead(name, &[&shown(with_axis), "--axis", name]).into_iter().collect();
        }
        if names.is_empty() && self.called.projects.is_empty() {
            let out = if has_ending(name, &[".toml"]) { name } else { &own };
            return vec![typed(["antrieb", "new", "screw", "--out", out])];
        }
        let meant = match nearest_name(name, &names) {
            Hint::DidYouMean(name) => vec![name],
            _ if !self.called.projects.is_empty() => Vec::new(),
            _ => names.iter().take(PROJECTS_MOST).map(|name| (*name).to_owned()).collect(),
        };
        meant.iter().filter_map(|other| self.with_instead(name, &[other])).collect()
    }

    /// Returns the call with the best actuator of its project.
    fn with_own_best(&self) -> Vec<String> {
        let project = self.called.projects.first().and_then(|path| path.to_str());
        let project = project.and_then(|project| ProjectOfCall::of_call(project, self.arguments, &self.called));
        let code = project.and_then(|project| best_products(&project, 1, |_| true).into_iter().next());
        code.map(|code| self.with(&["--code", &code])).unwrap_or_else(|| self.with_option_of_example("code"))
    }

    /// Returns the comparison with the best actuators of its project.
    fn with_compared_codes(&self, language: Language) -> Vec<String> {
        let more = || {
            let texts: Vec<&str> = self.arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
            let parts = self.called.parts(&texts)?;
            let codes: Vec<String> = parts.iter().filter_map(|part| code_of(part, &self.called, language)).collect();
            let project = self.called.projects.first()?.to_str()?;
            more_codes(&ProjectOfCall::of_call(project, self.arguments, &self.called)?, &codes)
        };
        let more = more().unwrap_or_default();
        let words: Vec<&str> = more.iter().flat_map(|code| ["--code", code]).collect();
        if words.is_empty() { Vec::new() } else { self.with(&words) }
    }

    /// Returns the call that begins a project with its recording.
    fn as_recording(&self) -> Vec<String> {
        let words: Vec<&str> = self.arguments.iter().filter_map(|word| word.to_str()).collect();
        let from = words.iter().position(|word| *word == "--from").and_then(|place| words.get(place + 1));
        let from = from.copied().or_else(|| words.iter().find_map(|word| word.strip_prefix("--from=")));
        from.map(|from| typed(["antrieb", "new", "recording", "--from", from, "--out", &project_name(from)]))
            .into_iter()
            .collect()
    }
}

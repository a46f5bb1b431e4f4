//! Calls in place of one that was parsed and cannot be answered.

use super::example::{filled, split};
use super::folder::{RECORDINGS, axes_of, best_of_project, has_ending, project_name, projects_in};
use super::meant::Called;
use super::replaced::{code_of, more_codes};
use super::solid;
use super::typed::typed;
use clap::Command;
use project::{Hint, nearest_name};
use quantities::Language;
use questions::Refusal;
use questions::list::Unanswered;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use words::{UsageHint, usage_hint};

/// Largest number of projects of a folder that are named in place of a missing one.
const PROJECTS_MOST: usize = 3;

/// Returns the calls in place of a refused one; empty if none is known.
pub(crate) fn calls(why: &Unanswered, arguments: &[OsString], whole: &Command, language: Language) -> Vec<String> {
    let Some(called) = Called::of(arguments, whole, language) else { return Vec::new() };
    let call = Call { called, arguments };
    match why {
        Unanswered::File { name, is_too_large: false, .. } => call.with_other_file(name),
        Unanswered::Text { faults, .. }
            if faults.len() == 1 && faults.iter().any(|fault| fault.id.ends_with("_not_closed")) =>
        {
            call.with(&["--set", "axis.single_move=true"])
        }
        // Lengths without a unit are in millimetres, if nothing else is wrong.
        Unanswered::Text { faults, .. } if faults.iter().all(|fault| fault.id == UNIT_MISSING) => {
            let meant = solid::with_units(arguments, &call.called);
            meant.and_then(|arguments| filled(&arguments, &call.called)).into_iter().collect()
        }
        Unanswered::Refused(Refusal::NoActuator, _) => call.with_own_best(language),
        Unanswered::Option { name: "from", .. } => call.as_recording(),
        Unanswered::Option { name: "hours-per-day", .. } if call.command() == "simulate" && !call.states("days") => {
            call.with(&["--days", "1"])
        }
        Unanswered::Option { name: "key", .. } if !call.states("key") => call.called.calls_of_example_table(),
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
const CHANGES: [&str; 2] = ["set", "vary"];

/// Returns a fault whose hint names whole calls where it names options alone.
pub(crate) fn with_whole_calls(why: Unanswered, arguments: &[OsString], language: Language) -> Unanswered {
    match why {
        Unanswered::Option { name, fault: (message, Some(hint)) } if CHANGES.contains(&name) => {
            let hint = whole_calls(&hint, arguments, language).unwrap_or(hint);
            Unanswered::Option { name, fault: (message, Some(hint)) }
        }
        Unanswered::Together(all) => {
            Unanswered::Together(all.into_iter().map(|one| with_whole_calls(one, arguments, language)).collect())
        }
        other => other,
    }
}

/// Returns the hint with the whole call around each option that it names; `None` if it names none.
fn whole_calls(hint: &str, arguments: &[OsString], language: Language) -> Option<String> {
    let before = usage_hint(&UsageHint::Calls(vec![String::new()]), language);
    let options = hint.strip_prefix(&before)?;
    let words: Vec<&str> = arguments.iter().skip(1).map(|word| word.to_str()).collect::<Option<_>>()?;
    let call = |option: &str| {
        let [name, value] = &split(option)[..] else { return None };
        let (key, _) = value.split_once('=')?;
        // The statement of the same key, else of the same value.
        let is_of_key = |word: &str| {
            let last = |path: &str| path.rsplit('.').next().unwrap_or_default().to_lowercase();
            word.split_once('=')
                .is_some_and(|(other, stated)| last(other.trim()) == last(key) || value.ends_with(stated))
        };
        let stated = |at: &usize| {
            let own = words.get(*at).and_then(|word| word.strip_prefix(&format!("{name}=")));
            match own {
                Some(word) => is_of_key(word),
                None => words.get(*at) == Some(&name.as_str()) && words.get(at + 1).is_some_and(|word| is_of_key(word)),
            }
        };
        let at = (0..words.len()).find(stated)?;
        let skipped = if words.get(at) == Some(&name.as_str()) { 2 } else { 1 };
        let head = words.iter().take(at).copied();
        let tail = words.iter().skip(at + skipped).copied();
        Some(typed(std::iter::once(super::NAME).chain(head).chain([name.as_str(), value.as_str()]).chain(tail)))
    };
    let calls: Vec<String> = options.lines().map(call).collect::<Option<_>>()?;
    Some(usage_hint(&UsageHint::Calls(calls), language))
}

/// Identifier of the fault of a number without its unit.
const UNIT_MISSING: &str = "unit_missing";

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

    /// Returns the call with further words.
    fn with(&self, words: &[&str]) -> Vec<String> {
        let more = words.iter().map(OsString::from);
        let arguments: Vec<OsString> = self.arguments.iter().cloned().chain(more).collect();
        filled(&arguments, &self.called).into_iter().collect()
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
    fn with_own_best(&self, language: Language) -> Vec<String> {
        let project = self.called.projects.first().and_then(|path| path.to_str());
        let code = project.and_then(|project| best_of_project(&[project], language));
        code.map(|code| self.with(&["--code", &code])).unwrap_or_else(|| self.with_option_of_example("code"))
    }

    /// Returns the comparison with the best actuators of its project.
    fn with_compared_codes(&self, language: Language) -> Vec<String> {
        let more = || {
            let texts: Vec<&str> = self.arguments.iter().map(|word| word.to_str()).collect::<Option<_>>()?;
            let parts = self.called.parts(&texts)?;
            let codes: Vec<String> = parts.iter().filter_map(|part| code_of(part, language)).collect();
            more_codes(self.called.projects.first()?.to_str()?, &codes, language)
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

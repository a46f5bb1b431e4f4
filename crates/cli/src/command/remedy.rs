//! Calls in place of one that was parsed and cannot be answered.

use super::example::filled;
use super::folder::{RECORDINGS, axes_of, best_of_project, has_ending, project_name, projects_in};
use super::meant::Called;
use super::typed::typed;
use clap::Command;
use project::{Hint, nearest_name};
use quantities::Language;
use questions::Refusal;
use questions::list::Unanswered;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

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
        Unanswered::Refused(Refusal::NoActuator, _) => call.with_own_best(language),
        Unanswered::Option { name: "from", .. } => call.as_recording(),
        Unanswered::Option { name: "hours-per-day", .. } if call.command() == "simulate" && !call.states("days") => {
            call.with(&["--days", "1"])
        }
        Unanswered::Option { name: "key", .. } if !call.states("key") => call.called.calls_of_example_range(),
        Unanswered::Message(_) if call.command() == "export" && !call.states("table") => {
            call.with_option_of_example("out")
        }
        Unanswered::Together(all) => match &all[..] {
            [one] => calls(one, arguments, whole, language),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
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

    /// Returns the calls with a project of the folder in place of a file that does not exist, else one that creates it.
    fn with_other_file(&self, name: &str) -> Vec<String> {
        let is_position = self.called.command.get_positionals().any(|position| position.get_id() == "project");
        let path = Path::new(name);
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

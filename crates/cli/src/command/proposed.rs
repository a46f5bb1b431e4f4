//! Options for a word that is the value of none: a factor of the load, a key of the project with this quantity.

use super::begun::template;
use super::effects;
use super::example::filled;
use super::folder::{RECORDINGS, axes_of, has_ending, kind_in_place_of_a_file, projects_in, text_of};
use super::meant::Called;
use super::own::{VARY, is_of_several};
use super::spoken::{option_meant, twin_options};
use super::typed::{number_and_unit, typed};
use super::unknown;
use crate::changed::{accepted, factor, keys, with_units};
use clap::{Arg, Command};
use project::{Hint, Written, example, key_at, nearest_name, other_names, written};
use quantities::{Dimension, parse};
use questions::list::new::template_kinds;
use questions::list::report::TITLE_PAGE;
use questions::list::{Argument, ArgumentKind, Entry, LIST};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use words::Usage;

/// Commands and options whose words name what another command may be meant to show.
const OTHER_COMMANDS: [(&str, &str); 3] = [("explain", "check"), ("plot", "figure"), ("simulate", "scenario")];

/// Largest number of options that a refusal names.
const PROPOSALS_MOST: usize = 4;

/// Range of a key.
struct ExampleRange {
    path: String,
    /// Unit, and the ends of the range.
    unit: String,
    low: String,
    high: String,
}

/// Returns a range about the first time, else the first quantity, of the motion of a project.
fn example_range(all: &[Written]) -> ExampleRange {
    let is_of_motion = |each: &&Written| each.path.contains("motion[");
    let own = || all.iter().filter(is_of_motion);
    let of_time = own().filter(|each| each.path.ends_with(".time")).find_map(range_of);
    let usual = ("motion[1].time", "s", "1", "3");
    of_time.or_else(|| own().find_map(range_of)).unwrap_or_else(|| {
        let (path, unit, low, high) = usual;
        ExampleRange { path: path.into(), unit: unit.into(), low: low.into(), high: high.into() }
    })
}

/// Returns a range about a stated quantity; `None` for another value, and for one that is not positive.
fn range_of(each: &Written) -> Option<ExampleRange> {
    let (number, unit) = number_and_unit(each.value.as_deref()?);
    let number: f64 = number.parse().ok().filter(|number| *number > 0.0 && !unit.is_empty())?;
    let [low, high] = [RANGE_LOW, RANGE_HIGH].map(|share| {
        let text = format!("{:.4}", share * number);
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    });
    Some(ExampleRange { path: each.path.clone(), unit: unit.to_owned(), low, high })
}

/// Shares of a stated value between which an example varies it.
const RANGE_LOW: f64 = 0.8;
const RANGE_HIGH: f64 = 1.25;

/// Name of a new project in an example.
const PROJECT: &str = "axis.toml";

/// Returns `true` if an option of this name is the file to write, by its name or its ending.
fn is_file(name: &str) -> bool {
    ["o", "out", "output", "pdf", "png", "svg", "csv", "xlsx", "parquet", "ics"].contains(&name)
}

/// Names of the table of rows and of its answers in an example.
const TABLE: &str = "tasks.csv";
const ANSWERS: &str = "best.csv";

/// Returns `true` if an option may be proposed for an unknown one. A field of the title page takes any text, so that a figure
/// would be lost in it: its name must begin alike. `name` and `option` may have hyphens in front.
pub(super) fn may_mean(name: &str, option: &str) -> bool {
    /// Letters that both names must share.
    const ALIKE: usize = 3;
    let [name, option] = [name, option].map(|text| text.trim_start_matches('-'));
    // The option of another command is no slip of letters.
    if name != option && LIST.iter().any(|entry| entry.arguments.iter().any(|argument| argument.name == name)) {
        return false;
    }
    let shared = name.chars().zip(option.chars()).take_while(|(one, other)| one == other).count();
    shared >= ALIKE || !TITLE_PAGE.iter().any(|field| field.name == option)
}

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

    /// Returns the project of a call that does not exist: it is what is wrong with the call, not the words behind it.
    pub(super) fn missing_project(&self) -> Option<&str> {
        let reads = self.command.get_positionals().next().is_some_and(|each| each.get_id() == "project");
        let first = self.first.first().filter(|word| reads && has_ending(word, &[".toml"]))?;
        (!Path::new(first).exists()).then_some(first)
    }

    /// Returns the text of the first project of the call, or of the kind of a new one.
    pub(super) fn project_text(&self) -> Option<String> {
        match self.entry {
            Some(entry) if entry.command == "new" => template(&self.first, self.language()),
            _ => self.projects.first().and_then(|path| text_of(path)),
        }
    }

    /// Returns `true` if a word is a project that the call names.
    pub(super) fn is_project_of_call(&self, word: &str) -> bool {
        self.projects.iter().any(|path| path == Path::new(word))
    }

    /// Returns the calls in place of one with a project too many, at a place: all of them side by side, and the same command
    /// for each.
    pub(super) fn calls_of_projects(&self, arguments: &[OsString], place: usize) -> Vec<String> {
        let names: Vec<&str> = self.projects.iter().filter_map(|path| path.to_str()).collect();
        let mut distinct = names.clone();
        distinct.dedup();
        let side_by_side = (distinct.len() > 1).then(|| typed(["antrieb", "size"].into_iter().chain(distinct)));
        // The file of one project is not that of another.
        let beside = |word: &OsString, left: usize| -> OsString {
            let text = word.to_str().unwrap_or_default();
            let own =
                self.projects.iter().find(|path| arguments.get(left).is_none_or(|word| path.as_os_str() != *word));
            let of_another = self.projects.iter().any(|path| {
                let stem = path.with_extension("");
                Path::new(text).with_extension("") == stem && !has_ending(text, &[".toml"])
            });
            match own.filter(|_| of_another) {
                Some(own) => match Path::new(text).extension() {
                    Some(ending) => own.with_extension(ending).into_os_string(),
                    None => word.clone(),
                },
                None => word.clone(),
            }
        };
        let without = |left: usize| -> Option<String> {
            let others = arguments.iter().enumerate().filter(|(at, _)| *at != left);
            let rest: Vec<OsString> = others.map(|(_, word)| beside(word, left)).collect();
            filled(&rest, self)
        };
        let first = arguments
            .iter()
            .position(|word| Some(word.as_os_str()) == self.projects.first().map(|path| path.as_os_str()));
        side_by_side.into_iter().chain(without(place)).chain(first.and_then(without)).collect()
    }

    /// Returns the call of another command about the project, of which a word is the name of a check, a figure or a scenario.
    pub(super) fn other_command(&self, word: &str) -> Option<String> {
        let project = self.projects.first()?.to_str()?;
        let takes = |entry: &Entry| {
            if self.entry.is_none_or(|own| own.reads != entry.reads) {
                return None;
            }
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

    /// Returns the change of a new project that a quantity alone states: the travel or the time of its moves, else the only key
    /// that may have it.
    pub(super) fn value_of_new(&self, word: &str) -> Option<String> {
        let is_kind = |path: &PathBuf| path.to_str().is_some_and(|word| kind_in_place_of_a_file(word).is_some());
        let is_new = self.entry?.command == "new" || self.has("set") && self.projects.first().is_some_and(is_kind);
        let all = self.project_text().filter(|_| is_new).and_then(|text| written(&text))?;
        // A key of a move takes an angle or a length; the stated one says which.
        let is_alike = |stated: &str| {
            Dimension::ALL.iter().any(|dimension| parse(*dimension, stated).is_ok() && parse(*dimension, word).is_ok())
        };
        let is_stated =
            |each: &&Written| each.value.as_deref().is_some_and(is_alike) && accepted::is_quantity(&each.path, word);
        let found: Vec<&str> = all.iter().filter(is_stated).map(|each| each.path.as_str()).collect();
        let of_moves = ["distance", "time"]
            .into_iter()
            .find(|key| found.iter().any(|path| path.starts_with("motion[") && path.ends_with(&format!("].{key}"))));
        match (&found[..], of_moves) {
            (_, Some(key)) => Some(format!("{key}={word}")),
            ([path], None) => Some(format!("{path}={word}")),
            _ => None,
        }
    }

    /// Returns the options for two words of which one names a quantity that a call may change: `load +15%`, `+15% load`.
    pub(super) fn change_of_two(&self, first: &str, second: &str) -> Option<[String; 2]> {
        let is_value = |word: &str| word.starts_with(|sign: char| sign.is_ascii_digit() || "+-.".contains(sign));
        let (name, value) = match (is_value(first), is_value(second)) {
            (true, false) => (second, first),
            (false, true) => (first, second),
            _ => return None,
        };
        let what = words::spoken::scaled(name)?;
        if self.has(VARY) && is_of_several(value) {
            return Some([format!("--{VARY}"), format!("{name}={value}")]);
        }
        match factor(value).is_some() || value.ends_with('%') {
            true => self.has("scale").then(|| ["--scale".to_owned(), format!("{what}={value}")]),
            false => (self.has("set") && value.parse::<f64>().is_err())
                .then(|| ["--set".to_owned(), format!("{name}={value}")]),
        }
    }

    /// Returns `true` if no position of the command is a recording or a folder.
    pub(super) fn reads_no_table(&self) -> bool {
        self.command.get_positionals().all(|position| !["trace", "folder"].contains(&position.get_id().as_str()))
    }

    /// Returns the option with the most similar name.
    pub(super) fn near_option(&self, word: &str) -> Option<String> {
        let name = word.trim_start_matches('-').split('=').next().unwrap_or_default();
        let names: Vec<&str> = self.options().filter_map(Arg::get_long).filter(|long| may_mean(name, long)).collect();
        match nearest_name(name, &names) {
            Hint::DidYouMean(name) => Some(format!("--{name}")),
            _ => None,
        }
    }

    /// Returns the fault of an unknown option that the command of the first proposed call has.
    pub(super) fn owner_of_option(&self, word: &str, calls: &[String]) -> Option<Usage> {
        let written = word.split('=').next()?;
        let name = written.strip_prefix("--")?;
        let call = calls.first()?.strip_prefix(super::NAME)?.trim_start();
        let is_called = |entry: &&Entry| call.strip_prefix(entry.command()).is_some_and(|rest| rest.starts_with(' '));
        let has = |entry: &&Entry| entry.arguments.iter().any(|argument| argument.name == name);
        let owner = LIST.iter().copied().filter(is_called).find(has)?;
        let other = format!("{} {}", super::NAME, owner.command());
        (other != self.name).then(|| Usage::OptionOf { written: written.to_owned(), command: self.name.clone(), other })
    }

    /// Returns the calls with an option that exists in place of an unknown one: a key of the project, a factor, or the option
    /// that is meant.
    pub(super) fn calls_instead_of(&self, word: &str, meant: Option<&str>, arguments: &[OsString]) -> Vec<String> {
        let texts: Vec<&str> = arguments.iter().filter_map(|word| word.to_str()).collect();
        if let Some(call) = self.call_of_setpoints(word, &texts) {
            return vec![call];
        }
        let others = self.calls_without_project(word, arguments);
        if !others.is_empty() {
            return others;
        }
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
        let named = || -> Vec<[String; 2]> {
            let all = self.project_text().and_then(|text| written(&text)).unwrap_or_default();
            let change = |path: &String, value: &str| ["--set".to_owned(), format!("{path}={value}")];
            let with_units = with_units(&all, ("", &name), value);
            if !with_units.is_empty() {
                return with_units.iter().map(|(path, value)| change(path, value)).collect();
            }
            let paths = keys::named(&all, "", &name, value);
            paths.iter().filter(|path| accepted::takes(path, value)).map(|path| change(path, value)).collect()
        };
        let options: Vec<[String; 2]> = match meant {
            _ if is_file(&name) && !self.has(&name) => {
                let files = self.entry.into_iter().flat_map(Entry::files).map(|file| file.option);
                let named = files.filter_map(|file| Some([format!("--{file}"), self.file_name(file)?]));
                let named: Vec<[String; 2]> = named.collect();
                // A command without files writes to standard output.
                if named.is_empty() { vec![[String::new(), String::new()]] } else { named }
            }
            // An option without a value that is near none leaves a call that works.
            None if value.is_empty() => vec![[String::new(), String::new()]],
            _ if value.is_empty() => meant.map(|meant| [meant.to_owned(), String::new()]).into_iter().collect(),
            _ if is_number && self.has("scale") && (meant == Some("--scale") || scaled == name) => {
                vec![["--scale".to_owned(), format!("{scaled}={value}")]]
            }
            _ if self.has("set") && option_meant(&name, self.command).is_none() && !named().is_empty() => {
                named().into_iter().take(PROPOSALS_MOST).collect()
            }
            Some(meant) if meant != "--scale" && meant != "--set" || value.contains('=') => {
                vec![[meant.to_owned(), value.to_owned()]]
            }
            _ => Vec::new(),
        };
        // An option of this command for the same is nearer than one of another by the same name.
        let is_own = option_meant(&name, self.command).is_some();
        let of_other = self
            .with_command_of_option(&name, arguments)
            .or_else(|| self.with_command_of_value(&name, (place, behind), arguments))
            .filter(|_| !is_own);
        let options = match (&of_other, meant) {
            // The call without the option remains.
            (Some(_), _) => vec![[String::new(), String::new()]],
            _ => options,
        };
        let call = |option: &[String; 2]| {
            let (head, _) = arguments.split_at(place);
            let tail = arguments.get(behind..).unwrap_or_default();
            let option = option.iter().filter(|word| !word.is_empty()).map(OsString::from);
            let whole: Vec<OsString> = head.iter().cloned().chain(option).chain(tail.iter().cloned()).collect();
            filled(&whole, self)
        };
        let calls = of_other.into_iter().chain(options.iter().filter_map(call));
        // Operation per day is that of some days.
        let lacks_days =
            |call: &String| call.contains("--hours-per-day ") && self.has("days") && !call.contains("--days");
        calls.map(|call| if lacks_days(&call) { format!("{call} --days 1") } else { call }).collect()
    }

    /// Returns the call of the only other command that has an unknown option, by its own name or by another for it, with all words of
    /// the call.
    fn with_command_of_option(&self, name: &str, arguments: &[OsString]) -> Option<String> {
        let whole = super::build(self.language());
        let written = name.replace('_', "-");
        let own = std::iter::once(written.as_str());
        own.chain(twin_options(&written).iter().copied()).find_map(|long| {
            let has = |command: &&Command| command.get_arguments().any(|argument| argument.get_long() == Some(long));
            let mut others = whole.get_subcommands().filter(has);
            let other = others.next().filter(|_| others.next().is_none() && self.entry.is_some())?;
            let words = [super::NAME, other.get_name()].into_iter().map(OsString::from);
            // A stop needs its scenario.
            let of_scenario = effects::needs(other.get_name(), long).contains(&"scenario");
            let scenario = ["--scenario", "emergency_stop"].into_iter().filter(|_| of_scenario).map(OsString::from);
            let named = arguments.iter().skip(self.begin).map(|word| {
                match word.to_str().and_then(|word| word.strip_prefix("--")) {
                    Some(option) if option.split('=').next() == Some(&*written) => {
                        OsString::from(format!("--{}", option.replacen(&written, long, 1)))
                    }
                    _ => word.clone(),
                }
            });
            let words: Vec<OsString> = words.chain(named).chain(scenario).collect();
            filled(&words, &Called::of(&words, &whole, self.language())?)
        })
    }

    /// Returns the call of the only other command that has an option with the value which an unknown option names: `wiring CODE
    /// --sinamics` is a commissioning for SINAMICS.
    pub(super) fn with_command_of_value(
        &self,
        name: &str,
        (place, behind): (usize, usize),
        arguments: &[OsString],
    ) -> Option<String> {
        let takes = |entry: &&'static Entry| {
            let of_words = entry
                .arguments
                .iter()
                .filter(|argument| matches!(argument.kind, ArgumentKind::Word(_)) && !argument.is_list());
            let word = of_words.filter_map(|argument| Some((argument.name, argument.word(name)?))).next()?;
            Some((entry.command(), word))
        };
        // A question about an actuator is not answered by one about a project, nor the other way round.
        let own = self.entry?;
        let is_akin = |entry: &&&'static Entry| entry.option().is_none() && entry.reads == own.reads;
        let mut found: Vec<(&str, (&str, &str))> = LIST.iter().filter(is_akin).filter_map(takes).collect();
        found.dedup();
        let [(command, (option, value))] = found[..] else { return None };
        if own.command() == command {
            return None;
        }
        let kept = |(at, _): &(usize, &OsString)| *at >= self.begin && !(place..behind).contains(at);
        let kept = arguments.iter().enumerate().filter(kept).map(|(_, word)| word.clone());
        let words = [super::NAME].into_iter().chain(command.split(' ')).map(OsString::from);
        let more = [format!("--{option}"), value.to_owned()].map(OsString::from);
        let words: Vec<OsString> = words.chain(kept).chain(more).collect();
        filled(&words, &Called::of(&words, self.whole(), self.language())?)
    }

    /// Returns the calls in place of one that states a value of a key and no project: with a project of the folder, else those
    /// that create a project with the key and evaluate it.
    fn calls_without_project(&self, word: &str, arguments: &[OsString]) -> Vec<String> {
        let is_position = self.command.get_positionals().any(|position| position.get_id() == "project");
        let is_stated = self.first.iter().any(|word| has_ending(word, &[".toml"]) || word == "-");
        if !is_position || is_stated || !self.has("set") {
            return Vec::new();
        }
        let with = |project: &str, command: &str| {
            let mut words: Vec<&str> = vec![super::NAME, command, project];
            words.extend(arguments.iter().skip(self.begin).filter_map(|word| word.to_str()));
            let words: Vec<OsString> = words.into_iter().map(OsString::from).collect();
            let (meant, is_changed) = unknown::with_meaning(words, &super::build(self.language()), self.language());
            is_changed.then(|| filled(&meant, self)).flatten()
        };
        let own = projects_in(Path::new(""));
        let own: Vec<&str> = own.iter().filter_map(|path| path.to_str()).collect();
        let command = self.entry.map_or("size", |entry| entry.command);
        if !own.is_empty() {
            return own.into_iter().take(PROPOSALS_MOST).filter_map(|project| with(project, command)).collect();
        }
        let name = word.trim_start_matches('-').split('=').next().unwrap_or_default().replace('-', "_");
        let has_key = |kind: &&str| {
            let all =
                template(&[(*kind).to_owned()], self.language()).and_then(|text| written(&text)).unwrap_or_default();
            all.iter().any(|each| each.value.is_some() && each.path.ends_with(&format!(".{name}")))
        };
        let kinds = template_kinds().filter(has_key).take(PROPOSALS_MOST);
        let new = kinds.filter_map(|kind| with(kind, "new")).map(|call| format!("{call} --out {PROJECT}"));
        let mut calls: Vec<String> = new.collect();
        if !calls.is_empty() {
            calls.push(typed([super::NAME, command, PROJECT]));
        }
        calls
    }

    fn example_range(&self) -> ExampleRange {
        example_range(&self.project_text().and_then(|text| written(&text)).unwrap_or_default())
    }

    /// Returns the call that writes the setpoints of a motion, if a word of a call names them: `--setpoints`, `--motion`, or the
    /// table of the motion for a drive.
    fn call_of_setpoints(&self, word: &str, texts: &[&str]) -> Option<String> {
        let name = |text: &str| text.strip_prefix("--").map(|name| name.split('=').next().unwrap_or(name).to_owned());
        let is_asked = |text: &&str| name(text).is_some_and(|name| words::spoken::is_setpoints(&name));
        let of_table = || {
            let table =
                texts.windows(2).any(|pair| matches!(pair, ["--table", table] if words::spoken::is_setpoints(table)));
            table && name(word).as_deref() == Some("for")
        };
        if !texts.iter().any(is_asked) && !of_table() {
            return None;
        }
        let project = self.projects.first()?.to_str()?;
        let axis = texts.iter().position(|text| *text == "--axis").and_then(|place| texts.get(place + 1));
        let axis = axis.into_iter().flat_map(|axis| ["--axis", axis]);
        let head = [super::NAME, "moves", project].into_iter();
        Some(typed(head.chain(axis).chain(["--every", "2ms", "--out", "setpoints.csv"])))
    }

    /// Returns the call with a range of one key of the project in place of a table.
    pub(super) fn with_example_range(&self, arguments: &[OsString]) -> Option<String> {
        let ExampleRange { path, unit, low, high } = self.example_range();
        let more = [format!("--{VARY}"), format!("{path}={low}..{high} {unit}")];
        let whole: Vec<OsString> = arguments.iter().cloned().chain(more.map(OsString::from)).collect();
        filled(&whole, self)
    }

    /// Returns the sweep over a range of each key of the project that a word of the call names alone: `map arm.toml payload time`.
    pub(super) fn swept(&self, arguments: &[OsString]) -> Option<String> {
        let all = self.project_text().filter(|_| self.has(VARY)).and_then(|text| written(&text))?;
        let range = |word: &str| {
            let names: Vec<&str> = std::iter::once(word).chain(other_names(word).iter().copied()).collect();
            let is_it = |each: &&Written| {
                names.contains(&each.path.rsplit('.').next().unwrap_or_default()) && range_of(each).is_some()
            };
            if let Some(ExampleRange { unit, low, high, .. }) = all.iter().find(is_it).and_then(range_of) {
                return Some(format!("{word}={low}..{high} {unit}"));
            }
            // What the project does not state ranges from nothing to the value of the example.
            let of_motion = |name: &&str| example(key_at(&format!("motion[1].{name}"))?);
            let line = names.iter().find_map(of_motion)?;
            let (number, unit) = number_and_unit(line.split_once(" = ")?.1.trim_matches('"'));
            let number = number.parse::<f64>().ok().filter(|number| *number > 0.0 && !unit.is_empty())?;
            Some(format!("{word}=0..{number} {unit}"))
        };
        let mut is_changed = false;
        let words = arguments.iter().enumerate().flat_map(|(place, word)| {
            let text = word.to_str().unwrap_or_default().to_lowercase();
            match range(&text).filter(|_| place >= self.begin && !self.is_project_of_call(&text)) {
                Some(range) => {
                    is_changed = true;
                    vec![OsString::from(format!("--{VARY}")), range.into()]
                }
                None => vec![word.clone()],
            }
        });
        let words: Vec<OsString> = words.collect();
        filled(&words, self).filter(|_| is_changed)
    }

    /// Returns the calls that write a table with a range of one key of the project and evaluate it.
    pub(super) fn calls_of_example_table(&self) -> Vec<String> {
        let ExampleRange { path, unit, low, high } = self.example_range();
        let column = format!("{path} [{unit}] = {low}..{high}");
        let project = self.projects.first().and_then(|path| path.to_str());
        let answer = project.map(|project| typed(["antrieb", "sweep", project, "--table", TABLE, "--out", ANSWERS]));
        let table = typed(["antrieb", "new", "sweep", "--key", &column, "--out", TABLE]);
        std::iter::once(table).chain(answer).collect()
    }
}

//! Words of a call that no position takes: the options whose values they are, from the declaration of the command.

mod ordered;

use super::effects;
use super::folder::{RECORDINGS, TABLES, catalogues, endings, has_ending, is_project, kind_in_place_of_a_file};
use super::own;
use super::spoken::seems_code;
use super::typed::is_negative;
use clap::{Arg, ArgAction, Command};
use project::Hint;
use quantities::Language;
use questions::list::{Argument, ArgumentForm, ArgumentKind, Entry, LIST, Reads, recognises};
use std::cell::OnceCell;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use words::UsageHint;

/// The command of a call.
pub(crate) struct Called<'c> {
    /// Name of the program and of the command.
    pub(super) name: String,
    whole: &'c Command,
    pub(super) command: &'c Command,
    /// First question of the command; `None` for a command that only the command line has.
    pub(super) entry: Option<&'static Entry>,
    /// Place of the first word behind the command.
    pub(super) begin: usize,
    language: Language,
    /// Project files that the call names.
    pub(super) projects: Vec<PathBuf>,
    /// Catalogue files that the call names.
    pub(super) catalogues: Vec<PathBuf>,
    /// Names of the products of the call, read on first use.
    pub(super) names: OnceCell<Vec<String>>,
    /// First words behind the command.
    pub(super) first: Vec<String>,
}

/// A part of a call behind the command.
pub(super) enum Part<'w> {
    /// A word without an option.
    Bare(usize, &'w str),
    /// An option and its value.
    Option(&'w Arg, Option<&'w str>),
}

impl Part<'_> {
    /// Returns the place of a word without an option.
    pub(super) const fn place(&self) -> Option<usize> {
        match self {
            Self::Bare(place, _) => Some(*place),
            Self::Option(..) => None,
        }
    }
}

/// A word that neither a position nor exactly one option takes.
pub(crate) struct Stray {
    pub(super) place: usize,
    pub(super) word: String,
    /// Options of which it may be the value, with the value.
    pub(super) options: Vec<(String, String)>,
    /// Option of which it is the value, and which the call gives already.
    pub(super) given: Option<String>,
}

/// A call as it is meant.
pub(crate) struct Understood {
    pub(crate) arguments: Vec<OsString>,
    /// First word that remains.
    pub(crate) stray: Option<Stray>,
}

/// An option that may take a word.
struct Candidate {
    name: String,
    /// Smaller numbers come first.
    rank: u8,
}

/// Kind of a project that begins with a recording.
const RECORDING: &str = "recording";

impl<'c> Called<'c> {
    /// Returns the whole command line.
    pub(super) const fn whole(&self) -> &'c Command {
        self.whole
    }

    /// Returns the language of the call.
    pub(super) const fn language(&self) -> Language {
        self.language
    }

    /// Finds the command of a call; `None` without one, or if its subcommand is missing.
    pub(crate) fn of(arguments: &[OsString], whole: &'c Command, language: Language) -> Option<Self> {
        let (mut command, mut names, mut begin) = (whole, Vec::new(), None);
        let mut place = 1;
        while let Some(word) = arguments.get(place).and_then(|word| word.to_str()) {
            if word == "--lang" {
                place += 1;
            } else if !word.starts_with('-') {
                let Some(below) = command.find_subcommand(word) else { break };
                (command, begin) = (below, Some(place + 1));
                names.push(word.to_owned());
            }
            place += 1;
        }
        let begin = begin.filter(|_| !command.has_subcommands())?;
        let names = names.join(" ");
        let entry = LIST.iter().copied().find(|entry| entry.command() == names);
        let is_project = |word: &&OsString| word.to_str().is_some_and(|word| has_ending(word, &[".toml"]));
        let files = arguments.iter().filter(is_project).map(PathBuf::from).filter(|path| path.is_file());
        let reads_a_project = command.get_positionals().any(|position| position.get_id() == "project");
        let is_kind = |word: &&OsString| {
            reads_a_project && word.to_str().is_some_and(|word| kind_in_place_of_a_file(word).is_some())
        };
        let kind = arguments.get(begin).filter(is_kind).map(PathBuf::from);
        let projects = kind.into_iter().chain(files).collect();
        let words = arguments.iter().skip(begin).map_while(|word| word.to_str());
        let first = words.take_while(|word| !word.starts_with('-')).map(str::to_owned).collect();
        let name = format!("{} {names}", super::NAME);
        let (catalogues, names) = (catalogues(arguments), OnceCell::new());
        Some(Self { name, whole, command, entry, begin, language, projects, catalogues, names, first })
    }

    /// Returns the parts of a call behind the command; `None` if it requests help or has an unknown option.
    pub(super) fn parts<'w>(&'w self, words: &[&'w str]) -> Option<Vec<Part<'w>>> {
        let mut parts = Vec::new();
        let mut place = self.begin;
        while let Some(&word) = words.get(place) {
            if word == "--" {
                return None;
            }
            if !word.starts_with('-') || word == "-" || is_negative(word) {
                parts.push(Part::Bare(place, word));
            } else {
                let name = word.split('=').next().unwrap_or_default();
                let option = self.options().find(|option| {
                    option.get_long().is_some_and(|long| name.strip_prefix("--") == Some(long))
                        || option.get_short().is_some_and(|short| *name == format!("-{short}"))
                })?;
                if matches!(option.get_action(), ArgAction::Help | ArgAction::Version) {
                    return None;
                }
                let value = match word.split_once('=') {
                    Some((_, value)) => Some(value),
                    None if option.get_action().takes_values() => {
                        place += 1;
                        words.get(place).copied()
                    }
                    None => None,
                };
                parts.push(Part::Option(option, value));
            }
            place += 1;
        }
        Some(parts)
    }

    /// Returns the first word of a call that is an option which the command does not have.
    pub(super) fn unknown_option(&self, arguments: &[OsString]) -> Option<String> {
        let words = arguments.iter().skip(self.begin).map_while(|word| word.to_str().filter(|word| *word != "--"));
        let is_known = |word: &str| {
            let name = word.split('=').next().unwrap_or_default();
            self.options().any(|option| {
                option.get_long().is_some_and(|long| name.strip_prefix("--") == Some(long))
                    || option.get_short().is_some_and(|short| name.strip_prefix('-') == Some(&short.to_string()))
            })
        };
        let mut unknown =
            words.filter(|word| word.starts_with('-') && *word != "-" && !is_negative(word) && !is_known(word));
        unknown.next().map(str::to_owned)
    }

    pub(super) fn options(&self) -> impl Iterator<Item = &Arg> {
        self.command.get_arguments().chain(self.whole.get_arguments()).filter(|option| !option.is_positional())
    }

    /// Iterates over the questions of the command.
    fn questions(&self) -> impl Iterator<Item = &'static Entry> {
        self.entry.into_iter().flat_map(|entry| std::iter::once(entry).chain(entry.others()))
    }

    /// Returns the declaration of an argument, that of a question of the command before that of another question.
    pub(super) fn argument(&self, name: &str) -> Option<&'static Argument> {
        let named = |entry: &'static Entry| entry.arguments.iter().find(|argument| argument.name == name);
        let own = self.questions().find_map(named);
        own.or_else(|| self.entry.and_then(|_| LIST.iter().copied().find_map(named)))
    }

    /// Returns `true` if an argument is an ordering code.
    pub(super) fn is_code(&self, argument: &Arg) -> bool {
        let name = argument.get_id().as_str();
        match self.entry {
            Some(_) => self.argument(name).is_some_and(|argument| matches!(argument.kind, ArgumentKind::Code)),
            None => name == "code",
        }
    }

    /// Returns a name for the file of an option.
    pub(super) fn file_name(&self, option: &str) -> Option<String> {
        let file = self.entry?.files().find(|file| file.option == option)?;
        Some(format!("axis{}", endings(file).first()?))
    }

    /// Returns `true` if an argument is one of the command's first question.
    fn is_own(&self, name: &str) -> bool {
        self.entry.is_some_and(|entry| entry.arguments.iter().any(|argument| argument.name == name))
    }

    /// Returns the order among the options that take a word; `None` if the option does not take it.
    fn rank(&self, option: &Arg, word: &str, given: &[&str]) -> Option<u8> {
        let name = option.get_long().filter(|_| option.get_action().takes_values())?;
        let exists = Path::new(word).exists();
        if let Some((entry, file)) =
            self.entry.and_then(|entry| Some((entry, entry.files().find(|file| file.option == name)?)))
        {
            let is_replaced = exists && given.contains(&"force");
            // A project in the place of a code is no file to write.
            if entry.command != "new" && self.projects.iter().any(|path| path == Path::new(word) && is_project(path)) {
                return None;
            }
            let is_packed = entry.command == "sweep" && has_ending(word, &[".csv.gz"]);
            return ((is_packed || has_ending(word, &endings(file))) && !is_replaced).then_some(2);
        }
        let read = self.questions().skip(1).find(|other| other.option() == Some(name));
        let file_endings: Option<&[&str]> = match (self.argument(name).map(|argument| argument.kind), read) {
            (_, Some(other)) => Some(match other.reads {
                Reads::Measured if self.projects.iter().any(|path| path == Path::new(word) && is_project(path)) => &[],
                Reads::Project | Reads::Measured => &[".toml"],
                Reads::Pins => &[".csv"],
                Reads::Nothing | Reads::TwoProjects => &[],
            }),
            (Some(ArgumentKind::File), None) => Some(&TABLES),
            (None, None) if name == "project" => Some(&[".toml"]),
            (None, None) if name == "from" => Some(&RECORDINGS),
            _ => None,
        };
        let is_required = option.is_required_set();
        if name == "axis" {
            return self.is_axis(word).then_some(0);
        }
        if let Some(endings) = file_endings {
            return has_ending(word, endings).then_some(if exists || is_required { 0 } else { 2 });
        }
        match self.argument(name) {
            Some(argument) if argument.kind_is_known() => {
                // An option without effect in the call is none that a word may mean.
                if self.entry.is_some_and(|entry| effects::is_idle(entry.command(), name, given)) {
                    return None;
                }
                let is_ready = argument.needs.is_none_or(|needs| given.contains(&needs))
                    && argument.instead_of.is_none_or(|other| !given.contains(&other));
                let rank = match (is_required, self.is_own(name) && is_ready) {
                    (true, _) => 0,
                    (false, true) => 1,
                    (false, false) => 3,
                };
                recognises(argument, word, self.language).then_some(rank)
            }
            _ => {
                let values = option.get_possible_values();
                let is_one = values.iter().any(|value| value.matches(word, true));
                (is_one || own::recognises(name, word, self.language)).then_some(3)
            }
        }
    }

    /// Returns the options that take a word, and one that takes it but is given already.
    pub(super) fn takers(&self, word: &str, given: &[&str]) -> (Vec<String>, Option<String>) {
        let mut found: Vec<Candidate> = Vec::new();
        let mut twice = None;
        for option in self.options() {
            let (Some(name), Some(rank)) = (option.get_long(), self.rank(option, word, given)) else { continue };
            let name = format!("--{name}");
            let is_repeated = matches!(option.get_action(), ArgAction::Append);
            if given.contains(&name.trim_start_matches('-')) && !is_repeated {
                twice = twice.or(Some(name));
            } else {
                found.push(Candidate { name, rank });
            }
        }
        let best = found.iter().map(|candidate| candidate.rank).min();
        let names = found.into_iter().filter(|candidate| Some(candidate.rank) == best).map(|candidate| candidate.name);
        let mut names: Vec<String> = names.collect();
        // Several values of a key are no single one.
        if names.iter().any(|name| name == "--vary") {
            names.retain(|name| name == "--vary");
        }
        // The angle of the shaft, not the range that is drawn.
        names.truncate(if names == ["--angle", "--window"] { 1 } else { names.len() });
        // A code with a slip has no option of its own; the question names the nearest codes.
        if names.is_empty()
            && let Some(code) = self.code_option(given)
            && (seems_code(word) || self.is_product(word))
        {
            names.push(code);
        }
        (names, twice)
    }

    /// Returns the option that a bare word names, and whether it takes a value.
    fn named(&self, word: &str) -> Option<(&str, bool)> {
        let word = word.to_lowercase();
        let option = self.options().find(|option| option.get_long() == Some(&word))?;
        let is_help = matches!(option.get_action(), ArgAction::Help | ArgAction::Version);
        Some((option.get_long()?, option.get_action().takes_values())).filter(|_| !is_help)
    }

    /// Returns the options that are not given, each with a value near a word.
    fn near_values(&self, word: &str, given: &[&str]) -> Vec<(String, String)> {
        let near = |option: &Arg| {
            let name = option.get_long().filter(|name| !given.contains(name))?;
            match self.argument(name)?.remedy(word)? {
                UsageHint::Words(Hint::DidYouMean(value)) => Some((format!("--{name}"), value)),
                _ => None,
            }
        };
        let product = || Some((self.code_option(given)?, self.near_product(word)?));
        let options = self.options().filter(|option| option.get_action().takes_values());
        options.filter_map(near).chain(product()).collect()
    }

    /// Returns `true` if a position takes a word: it is of the kind of the position, or of no kind of an option.
    fn fits(&self, position: &Arg, word: &str, given: &[&str]) -> bool {
        let name = position.get_id().as_str();
        let is_project = ["project", "old", "new", "folder"].contains(&name);
        let is_its = match self.entry.and_then(|_| self.argument(name)).map(|argument| (argument, argument.kind)) {
            // A recording stands for the project that begins with it; `sweep` reads a table besides.
            _ if is_project && name != "project" && self.reads_no_table() && has_ending(word, &RECORDINGS) => {
                return false;
            }
            _ if is_project && self.has("table") && has_ending(word, &RECORDINGS) => return false,
            _ if is_project => {
                let is_kind = name == "project" && kind_in_place_of_a_file(word).is_some();
                let is_file = has_ending(word, &[".toml"]) || has_ending(word, &RECORDINGS) || Path::new(word).exists();
                word == "-" || is_file || is_kind
            }
            Some((argument, ArgumentKind::Word(_))) => argument.takes(word),
            Some((_, ArgumentKind::Code)) => seems_code(word) || questions::read_code(word, self.language).is_ok(),
            Some(_) => true,
            None => seems_code(word),
        };
        let named =
            || position.get_num_args().is_some_and(|range| range.max_values() > 1) && self.named(word).is_some();
        let is_meant_otherwise =
            || is_project && (!self.proposals(word).is_empty() || self.other_command(word).is_some());
        is_its || self.takers(word, given).0.is_empty() && !named() && !is_meant_otherwise()
    }
}

/// Returns a call with each word that no position takes behind the option that it belongs to, and the words of a title
/// that a position takes as one. Words that stay are reported.
pub(crate) fn understood(arguments: Vec<OsString>, whole: &Command, language: Language) -> Understood {
    let unchanged = |arguments| Understood { arguments, stray: None };
    let texts: Option<Vec<&str>> = arguments.iter().map(|word| word.to_str()).collect();
    let (Some(texts), Some(called)) = (texts, Called::of(&arguments, whole, language)) else {
        return unchanged(arguments);
    };
    let Some(parts) = called.parts(&texts) else { return unchanged(arguments) };
    let mut given: Vec<&str> = Vec::new();
    let mut bare: Vec<(usize, &str)> = Vec::new();
    for part in &parts {
        match part {
            Part::Bare(place, word) => bare.push((*place, word)),
            Part::Option(option, _) => given.extend(option.get_long()),
        }
    }
    let mut sorting = Sorting { called: &called, given, placed: Vec::new(), stray: None, kind_due: false };
    sorting.sort(&bare);
    let Sorting { placed, stray, kind_due, .. } = sorting;
    let mut meant: Vec<OsString> = Vec::new();
    for (place, argument) in arguments.iter().enumerate() {
        if kind_due && place == called.begin {
            meant.push(RECORDING.into());
        }
        match placed.iter().find(|(of, _)| *of == place) {
            Some((_, words)) => meant.extend(words.iter().map(OsString::from)),
            None => meant.push(argument.clone()),
        }
    }
    // The stray word is named by its place in the new call.
    let before = |stray: &Stray| -> usize {
        let changed = placed.iter().filter(|(of, _)| *of < stray.place);
        let (more, fewer) = changed.fold((0, 0), |(more, fewer), (_, words)| (more + words.len(), fewer + 1));
        stray.place + more - fewer + usize::from(kind_due)
    };
    let stray = stray.map(|stray| Stray { place: before(&stray), ..stray });
    Understood { arguments: meant, stray }
}

/// Assignment of the bare words of a call.
struct Sorting<'c> {
    called: &'c Called<'c>,
    given: Vec<&'c str>,
    /// Words in place of that at a place.
    placed: Vec<(usize, Vec<String>)>,
    stray: Option<Stray>,
    /// The kind of a new project is missing, and a recording decides it.
    kind_due: bool,
}

impl<'c> Sorting<'c> {
    fn sort(&mut self, bare: &[(usize, &'c str)]) {
        let called = self.called;
        let mut positions = called.command.get_positionals().peekable();
        let mut rest = bare;
        let mut code = String::new();
        while let Some((&(place, word), behind)) = rest.split_first() {
            let taken = match positions.peek() {
                None => None,
                Some(position) => self.position(position, rest, &mut code),
            };
            let Some((count, is_filled)) = taken else {
                rest = self.elsewhere(place, word, behind);
                continue;
            };
            if is_filled {
                let _ = positions.next();
            }
            rest = rest.get(count..).unwrap_or_default();
        }
        self.ordered(bare);
        self.begun_by_recording(bare);
    }

    /// Returns the number of the next words that a position takes, and whether it is full then; `None` if it takes none.
    fn position(&mut self, position: &Arg, rest: &[(usize, &str)], code: &mut String) -> Option<(usize, bool)> {
        let (called, language) = (self.called, self.called.language);
        // No position takes a number with a minus sign.
        let &(place, word) = rest.first().filter(|(_, word)| !is_negative(word))?;
        // `load +5kg` changes the load, which is a kind of project too.
        let is_behind_project = called.projects.first().is_some_and(|project| project.as_path() != Path::new(word));
        if is_behind_project && rest.get(1).is_some_and(|(_, next)| called.change_of_two(word, next).is_some()) {
            return None;
        }
        let argument = called.entry.and_then(|_| called.argument(position.get_id().as_str()));
        let is_several = position.get_num_args().is_some_and(|range| range.max_values() > 1);
        let is_code = argument.is_some_and(|argument| matches!(argument.kind, ArgumentKind::Code));
        if is_code && code.is_empty() && (called.is_of_several_codes(rest) || called.is_of_several_axes(word)) {
            self.stray = Some(self.stray.take().unwrap_or_else(|| Stray::of(place, word)));
            return Some((1, !is_several));
        }
        match argument {
            // A code may be written as several words; behind a complete one there is another argument.
            Some(_) if is_several && is_code => {
                let joined = if code.is_empty() { word.to_owned() } else { format!("{code} {word}") };
                // A project in the place of a code is refused with the code of its best actuator.
                let is_complete =
                    has_ending(code, &[".toml"]) || !code.is_empty() && questions::read_code(code, language).is_ok();
                let is_longer = || questions::read_code(&joined, language).is_ok();
                let is_other = || {
                    let starts_with_number =
                        word.trim_start_matches('-').starts_with(|sign: char| sign.is_ascii_digit());
                    let is_plain = word.chars().all(|sign| sign.is_ascii_alphanumeric());
                    !called.takers(word, &self.given).0.is_empty()
                        && (code.is_empty() || seems_code(code) && !(starts_with_number && is_plain && word.len() < 4))
                };
                if is_complete && !is_longer() || !seems_code(word) && is_other() {
                    return None;
                }
                *code = joined;
                Some((1, false))
            }
            Some(argument) if is_several && argument.form == ArgumentForm::Words => {
                Some((rest.iter().take_while(|(_, word)| !is_negative(word)).count(), false))
            }
            // A title of several words: `new rotary table`.
            Some(argument) if matches!(argument.kind, ArgumentKind::Word(_)) => {
                let title = |count: &usize| -> String {
                    rest.iter().take(*count).map(|(_, word)| *word).collect::<Vec<_>>().join(" ")
                };
                let count = (1..=rest.len().min(3)).rev().find(|count| argument.takes(&title(count)));
                // A second word for the same value states nothing else: `new rotary table disc`.
                let is_same = |count: usize, word: &str| {
                    let value = argument.word(&title(&count));
                    value.is_some() && argument.word(word) == value
                };
                let all =
                    |count: usize| count + rest.iter().skip(count).take_while(|(_, word)| is_same(count, word)).count();
                if let Some((count, all)) = count.map(|count| (count, all(count))).filter(|(_, all)| *all > 1) {
                    self.placed.push((place, vec![title(&count)]));
                    self.placed.extend(rest.iter().take(all).skip(1).map(|(place, _)| (*place, Vec::new())));
                    return Some((all, true));
                }
                called.fits(position, word, &self.given).then_some((1, true))
            }
            _ => called.fits(position, word, &self.given).then_some((1, !is_several)),
        }
    }

    /// Places a word that no position takes behind its option; returns the words that follow.
    fn elsewhere<'r>(&mut self, place: usize, word: &str, behind: &'r [(usize, &'c str)]) -> &'r [(usize, &'c str)] {
        let called = self.called;
        // `top 5` and `top=5` are `--top 5`.
        if let Some((name, takes_value)) = called.named(word).filter(|(name, _)| !self.given.contains(name)) {
            if !takes_value {
                self.place_words(place, vec![format!("--{name}")], name);
                return behind;
            }
            if let Some(((next, value), rest)) =
                behind.split_first().map(|((next, value), rest)| ((*next, *value), rest))
            {
                self.place_words(place, vec![format!("--{name}"), value.to_owned()], name);
                self.placed.push((next, Vec::new()));
                return rest;
            }
        }
        if let Some((name, value)) = word.split_once('=')
            && let Some((name, true)) = called.named(name).filter(|(name, _)| !self.given.contains(name))
        {
            self.place_words(place, vec![format!("--{name}"), value.to_owned()], name);
            return behind;
        }
        // A number and its unit may be several words: `60 N m`.
        let units = behind.iter().take(3).take_while(|(_, unit)| unit.starts_with(char::is_alphabetic)).count();
        for count in (1..=units).rev().filter(|_| word.parse::<f64>().is_ok()) {
            let (unit, rest) = behind.split_at(count);
            let whole = unit.iter().fold(word.to_owned(), |text, (_, unit)| format!("{text} {unit}"));
            if let [option] = &called.takers(&whole, &self.given).0[..] {
                self.place_option(place, &option.clone(), whole);
                self.placed.extend(unit.iter().map(|(place, _)| (*place, Vec::new())));
                return rest;
            }
        }
        // A name without quotes: `NR 14/100`.
        if let Some(option) = called.code_option(&self.given)
            && let Some((name, count)) = called.product_of_words(word, behind)
        {
            let (more, rest) = behind.split_at(count);
            self.place_option(place, &option, name);
            self.placed.extend(more.iter().map(|(place, _)| (*place, Vec::new())));
            return rest;
        }
        // An identifier may be several words: `emergency stop`.
        for count in (1..=behind.len().min(2)).rev() {
            let (more, rest) = behind.split_at(count);
            let whole =
                more.iter().fold(word.to_lowercase(), |text, (_, more)| format!("{text}_{}", more.to_lowercase()));
            if let [option] = &called.takers(&whole, &self.given).0[..]
                && called.argument(option.trim_start_matches('-')).is_some_and(|argument| argument.takes(&whole))
            {
                self.place_option(place, &option.clone(), whole);
                self.placed.extend(more.iter().map(|(place, _)| (*place, Vec::new())));
                return rest;
            }
        }
        if let Some(((next, second), rest)) = behind.split_first()
            && let Some(change) = called.change_of_two(word, second)
        {
            self.placed.extend([(place, change.to_vec()), (*next, Vec::new())]);
            return rest;
        }
        let (takers, twice) = called.takers(word, &self.given);
        if takers.is_empty()
            && let Some(value) = called.value_of_new(word)
        {
            self.place_option(place, "--set", value);
            return behind;
        }
        match &takers[..] {
            [option] => self.place_option(place, &option.clone(), word.to_owned()),
            _ if self.stray.is_none() => {
                let mut options: Vec<(String, String)> =
                    takers.into_iter().map(|option| (option, word.to_owned())).collect();
                if options.is_empty() && twice.is_none() {
                    options = called.near_values(word, &self.given);
                }
                if options.is_empty() && twice.is_none() {
                    options = called.proposals(word);
                }
                self.stray = Some(Stray { place, word: word.to_owned(), options, given: twice });
            }
            _ => {}
        }
        behind
    }

    fn place_words(&mut self, place: usize, words: Vec<String>, name: &'c str) {
        self.placed.push((place, words));
        self.given.push(name);
    }

    fn place_option(&mut self, place: usize, option: &str, value: String) {
        let value = match words::spoken::language_of(&value) {
            Some(language) if option == "--lang" => language.id().to_owned(),
            _ => value,
        };
        self.placed.push((place, vec![option.to_owned(), value]));
        let long = self.called.options().find_map(|each| each.get_long().filter(|long| option == format!("--{long}")));
        self.given.extend(long);
    }
}

#[cfg(test)]
#[path = "meant_tests.rs"]
mod tests;

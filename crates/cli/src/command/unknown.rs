//! Options that a command does not have, as what they plainly mean: a key of the project, the ending of a file, a value of
//! another option.

use super::begun::file_beside;
use super::completed::operation;
use super::meant::Called;
use super::own::{VARY, is_of_several};
use super::spoken::{option_meant, seems_code, twin_options};
use crate::changed::{LOAD_FACTORS, accepted, factor, keys, mass, motion, prefix};
use clap::Command;
use project::{Written, distance_of_stations, written};
use quantities::Language;
use questions::list::{ArgumentKind, OutputFile};
use std::ffi::OsString;
use words::spoken;

/// Largest number of words behind a number that may be its unit.
const UNIT_MOST: usize = 3;

/// Largest number of bytes of a word that is a unit.
const UNIT_LETTERS_MOST: usize = 8;

/// The quantity of which a bare number is a factor.
const LOAD: &str = "load";

/// Words in place of an option, and the number of further words of the call that they contain.
type Meaning = (Vec<String>, usize);

/// Returns a call with each unknown option by what it plainly means, and `true` if there was one.
pub(super) fn with_meaning(arguments: Vec<OsString>, whole: &Command, language: Language) -> (Vec<OsString>, bool) {
    let unchanged = |arguments| (arguments, false);
    let texts: Option<Vec<&str>> = arguments.iter().map(|word| word.to_str()).collect();
    let (Some(texts), Some(called)) = (texts, Called::of(&arguments, whole, language)) else {
        return unchanged(arguments);
    };
    let unknown = Unknown { called: &called, texts: &texts };
    let mut meant: Vec<OsString> = arguments.iter().take(called.begin).cloned().collect();
    let (mut place, mut is_changed) = (called.begin, false);
    while let Some(word) = texts.get(place) {
        if *word == "--" {
            break;
        }
        let skipped = match unknown.meaning(place, word) {
            Some((words, further)) => {
                is_changed = true;
                meant.extend(words.into_iter().map(OsString::from));
                1 + further
            }
            None => {
                let is_with_value = unknown.takes_value(word);
                meant.extend(arguments.iter().skip(place).take(1 + usize::from(is_with_value)).cloned());
                1 + usize::from(is_with_value)
            }
        };
        place += skipped;
    }
    meant.extend(arguments.iter().skip(place).cloned());
    (meant, is_changed)
}

/// The unknown options of a call.
struct Unknown<'c> {
    called: &'c Called<'c>,
    texts: &'c [&'c str],
}

/// Value of a key whose option has none, and of one that begins with a negation.
const TRUE: &str = "true";
const FALSE: &str = "false";

/// Beginnings of options that exclude, and of one that includes: `--no-brake`.
const WITHOUT: [&str; 2] = ["no-", "without-"];
const WITH: &str = "with-";

/// Options for the format of the answer in other programs, and the format that is an option here.
const FORMATS: [&str; 2] = ["format", "output"];
const JSON: &str = "json";

/// Returns `true` if a word looks like a unit behind a number.
fn is_unit(word: &str) -> bool {
    word.starts_with(char::is_alphabetic) && !word.contains('.') && word.len() <= UNIT_LETTERS_MOST
}

/// Returns the name of an option, without the value behind a sign of equality.
fn name_of(word: &str) -> Option<&str> {
    let name = word.split('=').next().unwrap_or_default();
    match name {
        "-o" => Some("out"),
        _ => name.strip_prefix("--").filter(|name| !name.is_empty()),
    }
}

impl Unknown<'_> {
    fn is_known(&self, name: &str) -> bool {
        self.called.has(name) || twin_options(name).iter().any(|meant| self.called.has(meant))
    }

    /// Returns `true` if a word is an option whose value is the next word.
    fn takes_value(&self, word: &str) -> bool {
        let option = name_of(word)
            .filter(|_| !word.contains('='))
            .and_then(|name| self.called.options().find(|option| option.get_long() == Some(name)));
        option.is_some_and(|option| option.get_action().takes_values())
    }

    fn is_given(&self, name: &str) -> bool {
        self.texts.iter().any(|word| name_of(word) == Some(name))
    }

    /// Returns the meaning of the word at a place; `None` for a word that is no unknown option, or has no plain meaning.
    fn meaning(&self, place: usize, word: &str) -> Option<Meaning> {
        let name = name_of(word)?;
        if self.is_known(name) {
            return self.as_own_file(place, name, word);
        }
        let stated = word.split_once('=').map(|(_, value)| value);
        let next = || self.texts.get(place + 1).copied().filter(|next| !next.starts_with("--") && *next != "-o");
        let (value, further) = match stated {
            Some(value) => (Some(value), 0),
            None => (next(), usize::from(next().is_some())),
        };
        self.as_record(name, value, further)
            .or_else(|| self.as_flag(name))
            .or_else(|| self.as_excluded(place, name))
            .or_else(|| self.as_quantity(name))
            .or_else(|| self.as_operation(name, value, further))
            .or_else(|| self.as_factor(name, value, further))
            .or_else(|| self.as_file(name, value, further))
            .or_else(|| self.as_key(place, name, stated))
            .or_else(|| stated.is_none().then(|| self.as_value(name)).flatten())
    }

    /// Returns the key that an option includes or excludes: `--with-brake`, `--no-brake`.
    fn as_excluded(&self, place: usize, name: &str) -> Option<Meaning> {
        let excluded = WITHOUT.iter().find_map(|word| name.strip_prefix(word)).map(|name| (name, FALSE));
        let (name, value) = excluded.or_else(|| Some((name.strip_prefix(WITH)?, TRUE)))?;
        let (words, _) = self.as_key(place, name, Some(value))?;
        Some((words, 0))
    }

    /// Returns the option of a record for a format of that name: `--format json`.
    fn as_record(&self, name: &str, value: Option<&str>, further: usize) -> Option<Meaning> {
        let is_json = FORMATS.contains(&name) && value?.eq_ignore_ascii_case(JSON);
        (is_json && self.called.has(JSON)).then(|| (vec![format!("--{JSON}")], further))
    }

    /// Returns the only key of the project that a quantity in place of an option may state: `--48V`.
    fn as_quantity(&self, name: &str) -> Option<Meaning> {
        let is_number = name.starts_with(|sign: char| sign.is_ascii_digit());
        // The letters of an option are small, those of a unit may be capitals.
        let of = |name: &str| if is_number { self.called.proposals(name) } else { Vec::new() };
        let found = [of(name), of(&name.to_uppercase())].into_iter().find(|found| !found.is_empty())?;
        let [(option, value)] = &found[..] else { return None };
        Some((vec![option.clone(), value.clone()], 0))
    }

    /// Returns the key of the project that an option without a value states: `--vertical`; `--best` is the first of a ranking.
    fn as_flag(&self, name: &str) -> Option<Meaning> {
        if name == "best" && self.called.has("top") {
            return Some((vec!["--top".to_owned(), "1".to_owned()], 0));
        }
        if let Some(language) = spoken::language_of(name) {
            return Some((vec![format!("--lang={}", language.id())], 0));
        }
        let (key, value) = spoken::flag(name).filter(|_| self.called.has("set"))?;
        let all = written(&self.called.project_text()?)?;
        let [path] = &keys::named(&all, "", key, value)[..] else { return None };
        Some((vec!["--set".to_owned(), format!("{path}={value}")], 0))
    }

    /// Returns the options of an operation over hours or days, for the duration of a simulation.
    fn as_operation(&self, name: &str, value: Option<&str>, further: usize) -> Option<Meaning> {
        let is_run = self.called.has("days") && self.called.has("hours-per-day") && !self.is_given("days");
        let words = operation(name, value.filter(|_| is_run)?, self.called.language())?;
        Some((words, further))
    }

    /// Returns the factor of a quantity that a call may scale: `--load 1.15`, `--payload +10%`. A bare number is one only for the
    /// whole load, and near one.
    fn as_factor(&self, name: &str, value: Option<&str>, further: usize) -> Option<Meaning> {
        let what = spoken::scaled(name).filter(|_| self.called.has("scale"))?;
        let value = value?;
        let plain =
            || value.replace(',', ".").parse().ok().filter(|number| what == LOAD && LOAD_FACTORS.contains(number));
        let is_percentage =
            value.strip_suffix('%').is_some_and(|number| number.trim().replace(',', ".").parse::<f64>().is_ok());
        let is_signed = |number: &str| number.starts_with('+') && number.replace(',', ".").parse::<f64>().is_ok();
        let number = match factor(value).or_else(plain) {
            Some(number) => number.to_string(),
            // The refusal has both forms.
            None if is_percentage || is_signed(value) => value.to_owned(),
            None => return None,
        };
        Some((vec!["--scale".to_owned(), format!("{what}={number}")], further))
    }

    /// Returns a known option for a file with a name for it, if it has none: that of the project, or of the code.
    fn as_own_file(&self, place: usize, name: &str, word: &str) -> Option<Meaning> {
        let file = self.called.entry?.files().find(|file| file.option == name)?;
        let is_bare = !word.contains('=') && self.texts.get(place + 1).is_none_or(|next| next.starts_with("--"));
        let ending = *super::folder::endings(file).first().filter(|_| is_bare)?;
        let code = self.called.first.iter().find(|word| seems_code(word));
        let own = code.filter(|_| self.called.projects.is_empty()).map(|code| format!("{code}{ending}"));
        Some((vec![format!("--{name}"), own.unwrap_or_else(|| file_beside(&self.called.projects, ending))], 0))
    }

    /// Returns an option for a file by the ending that it names, or that the file of `--out` has.
    fn as_file(&self, name: &str, value: Option<&str>, further: usize) -> Option<Meaning> {
        let mut files = self.called.entry?.files();
        let has = |file: &&OutputFile, ending: &str| super::folder::endings(file).contains(&ending);
        if name == "out" {
            let value = value?;
            let ending = value.rfind('.').and_then(|at| value.get(at..))?.to_lowercase();
            let file = files.find(|file| has(file, &ending)).filter(|file| !self.is_given(file.option))?;
            return Some((vec![format!("--{}", file.option), value.to_owned()], further));
        }
        let ending = format!(".{}", name.to_lowercase());
        let file = files.find(|file| has(file, &ending)).filter(|file| !self.is_given(file.option))?;
        let own = value.filter(|value| value.to_lowercase().ends_with(&ending) || *value == "-");
        let (value, further) = match own {
            Some(value) => (value.to_owned(), further),
            None => (file_beside(&self.called.projects, &ending), 0),
        };
        Some((vec![format!("--{}", file.option), value], further))
    }

    /// Returns the change of a key of the project, if the name is that of one key and the value one of its values.
    fn as_key(&self, place: usize, name: &str, stated: Option<&str>) -> Option<Meaning> {
        let varies = self.called.has(VARY);
        // A word that stands for another option of the command is no key.
        if !self.called.has("set") && !varies || option_meant(name, self.called.command).is_some() {
            return None;
        }
        let text = self.called.project_text()?;
        let all = written(&text)?;
        let axis = self.texts.iter().position(|word| *word == "--axis").and_then(|at| self.texts.get(at + 1));
        let prefix = prefix(&text, axis.map(|name| (*name).to_owned()).as_ref()).unwrap_or_default();
        let key = project::with_brackets(&name.replace('-', "_"));
        if let Some(value) = stated {
            return Some((self.change(&all, &prefix, &key, value)?, 0));
        }
        // A number and its unit may be several words: `--mass 80 kg`.
        let is_word = |word: &&&str| !word.starts_with("--") && **word != "-o";
        let behind: Vec<&str> =
            self.texts.iter().skip(place + 1).take_while(is_word).take(UNIT_MOST).copied().collect();
        let joined = |count: usize| behind.get(..count).map(|words| words.join(" "));
        let is_value = |count: &usize| {
            let taken = |value: String| match varies && is_of_several(&value) {
                true => *count == 1 || is_unit(behind.last().copied().unwrap_or_default()),
                false => keys::named(&all, &prefix, &key, &value).iter().any(|path| accepted::takes(path, &value)),
            };
            joined(*count).is_some_and(taken)
        };
        let count = (1..=behind.len()).rev().find(is_value).unwrap_or_else(|| behind.len().min(1));
        let value = joined(count).filter(|value| !value.is_empty()).unwrap_or_else(|| TRUE.to_owned());
        Some((self.change(&all, &prefix, &key, &value)?, count))
    }

    /// Returns the option that changes a key, or those of the motion that a word stands for; faults of the value are those of the
    /// change.
    fn change(&self, all: &[Written], prefix: &str, key: &str, value: &str) -> Option<Vec<String>> {
        if self.called.has(VARY) && is_of_several(value) {
            return Some(vec![format!("--{VARY}"), format!("{key}={value}")]);
        }
        if !self.called.has("set") {
            return None;
        }
        let plainly = || Some(vec!["--set".to_owned(), format!("{key}={value}")]);
        let is_number = value.replace(',', ".").parse::<f64>().is_ok();
        // The refusal of a mass without a radius says what to state.
        if mass::is_mass_of_load(key, value)
            && mass::without_radius(all, prefix, (key, value), self.called.language()).is_some()
        {
            return plainly();
        }
        if motion::meaning(key).is_some() || distance_of_stations(key, value).is_some() {
            return plainly();
        }
        if is_number && spoken::scaled(key).is_some() {
            return plainly();
        }
        let found = keys::named(all, prefix, key, value);
        match &found[..] {
            [path] => Some(vec!["--set".to_owned(), format!("{path}={value}")]),
            // The refusal of an ambiguous key names each of them.
            [_, _, ..] => plainly(),
            [] if project::key_at(key).is_some_and(|key| !accepted::is_table(key.kind)) => {
                Some(vec!["--set".to_owned(), format!("{prefix}{key}={value}")])
            }
            [] => None,
        }
    }

    /// Returns an option whose value the name is: `--emergency-stop` is `--scenario emergency_stop`.
    fn as_value(&self, name: &str) -> Option<Meaning> {
        let of_words =
            self.called.entry?.arguments.iter().filter(|argument| matches!(argument.kind, ArgumentKind::Word(_)));
        let mut found = of_words.filter_map(|argument| {
            let word = argument.word(name).or_else(|| argument.word(spoken::value(name)?))?;
            (self.called.has(argument.name) && !self.is_given(argument.name)).then_some((argument.name, word))
        });
        let (option, word) = found.next().filter(|_| found.next().is_none())?;
        Some((vec![format!("--{option}"), word.to_owned()], 0))
    }
}

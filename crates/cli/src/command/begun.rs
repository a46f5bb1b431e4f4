//! Calls that begin with something else than a command: the kind of a new project, a project, an ordering code.

use super::folder::{has_ending, projects_in};
use super::kind::kind;
use super::own::BESIDE;
use super::spoken::{command_named, seems_code};
use quantities::Language;
use questions::list::new;
use std::ffi::OsString;
use std::path::Path;
use words::spoken::{self, language_of};

/// Name of a file without its ending, beside no project.
const USUAL_STEM: &str = "antrieb";

/// Subcommands of `code`.
const OF_CODE: [&str; 3] = ["parse", "list", "complete"];

/// Returns a call with the command that it lacks, and `true` if one was added: `lift mass=80kg` makes a project, a project is
/// sized, a code has its data sheet; `code CHA-20A` completes the code, `code CHA-20A-100-H-C1024` explains it.
pub(crate) fn with_command(mut arguments: Vec<OsString>, language: Language) -> (Vec<OsString>, bool) {
    let mut place = 1;
    while let Some(word) = arguments.get(place).and_then(|word| word.to_str()) {
        match word {
            "--" => return (arguments, false),
            "--lang" => place += 2,
            _ if word.starts_with('-') || language_of(word).is_some() && command_named(word).is_none() => place += 1,
            _ => break,
        }
    }
    let words: Vec<&str> = arguments.iter().skip(place).map_while(|word| word.to_str()).collect();
    let Some((first, behind)) = words.split_first() else { return (arguments, false) };
    if command_named(first) == Some("code")
        && let Some(words) = with_brake(behind)
    {
        arguments.splice(place + 1.., words.into_iter().map(OsString::from));
        return (arguments, true);
    }
    if command_named(first) == Some("compare")
        && let Some(words) = data_of_codes(behind, language)
    {
        arguments.splice(place.., words.into_iter().map(OsString::from));
        return (arguments, true);
    }
    if command_named(first).is_none()
        && let Some((scenario, count)) = scenario(&words)
    {
        let option = format!("--scenario={scenario}");
        let behind: Vec<String> = words.iter().skip(count).map(|word| (*word).to_owned()).collect();
        let whole = std::iter::once("simulate".to_owned()).chain(behind).chain([option]);
        arguments.splice(place.., whole.map(OsString::from));
        return (arguments, true);
    }
    let (at, added) = match command_named(first) {
        Some(command) if let Some(other) = other_command(command, behind, language) => {
            if let Some(word) = arguments.get_mut(place) {
                *word = other.into();
            }
            return (arguments, true);
        }
        Some("code") => match behind.first() {
            Some(word) if !OF_CODE.contains(word) => (place + 1, of_code(behind, language)),
            _ => (place, None),
        },
        Some(_) => (place, None),
        None => (place, of_first(&words, language)),
    };
    let Some(added) = added else { return (arguments, false) };
    arguments.insert(at, added.into());
    (arguments, true)
}

/// Pattern of the ordering codes with a holding brake.
const WITH_BRAKE: &str = "CHA-*-B";

/// Returns the words behind `code` that list the codes with a brake: `code list with brake`.
fn with_brake(words: &[&str]) -> Option<Vec<String>> {
    let is_bare = |word: &&str| !word.starts_with('-') || spoken::is_brake(word.trim_start_matches('-'));
    let (bare, options): (Vec<&str>, Vec<&str>) = words.iter().partition(|word| is_bare(word));
    let rest: Vec<&str> = bare.into_iter().filter(|word| *word != "list" && !spoken::is_with(word)).collect();
    let [word] = &rest[..] else { return None };
    let own = ["list", WITH_BRAKE].into_iter().chain(options).map(str::to_owned);
    spoken::is_brake(word.trim_start_matches('-')).then(|| own.collect())
}

/// Returns the call that shows the data of the codes of a comparison side by side, where no project is stated and the folder has
/// none that is plainly meant.
fn data_of_codes(words: &[&str], language: Language) -> Option<Vec<String>> {
    let is_project = |word: &&str| has_ending(word, &[".toml"]) || *word == "-" || Path::new(word).exists();
    if words.iter().any(|word| is_project(word) || *word == "--json") || projects_in(Path::new("")).len() == 1 {
        return None;
    }
    let (mut codes, mut rest, mut all) = (Vec::new(), Vec::new(), words.iter().copied());
    while let Some(word) = all.next() {
        let stated = if word == "--code" { all.next()? } else { word.strip_prefix("--code=").unwrap_or(word) };
        match questions::read_code(stated, language) {
            Ok(read) => codes.push(read.parsed.code.to_string()),
            Err(_) if word.starts_with("--lang") || language_of(word).is_some() => rest.push(word.to_owned()),
            Err(_) => return None,
        }
    }
    let (first, further) = codes.split_first().filter(|(_, further)| !further.is_empty())?;
    let further = further.iter().flat_map(|code| [format!("--{BESIDE}"), code.clone()]);
    Some(["data".to_owned(), first.clone()].into_iter().chain(further).chain(rest).collect())
}

/// Commands about a project, each with that about a code alone which is meant where the first word is one.
const OF_CODES: [(&str, &str); 2] = [("plot", "curve"), ("export", "data")];

/// Returns the command that the words behind another one require: an actuator is checked, a code alone has a curve.
fn other_command(command: &str, behind: &[&str], language: Language) -> Option<&'static str> {
    // A code with an unreadable field is one too.
    let is_readable = |word: &str| questions::list::code_list::read_pattern(word, language).is_ok();
    let is_code = |word: &&&str| seems_code(word) && (word.contains('?') || is_readable(word));
    let bare = || behind.iter().take_while(|word| !word.starts_with('-'));
    let has_code = bare().any(|word| is_code(&word));
    let has_project = behind.iter().any(|word| has_ending(word, &[".toml"]) || *word == "-");
    let stated = || behind.iter().enumerate().filter(|(place, word)| is_code(word) && is_value_of_code(behind, *place));
    let is_of_several = || stated().count() > 1 || behind.iter().filter(|word| **word == "--code").count() > 1;
    // The battery is that of every actuator; the faults of a code are those of the other commands.
    if let ("battery", [word, rest @ ..]) = (command, behind)
        && rest.iter().all(|option| *option == "--json" || option.starts_with("--lang="))
        && word.contains('-')
        && word.starts_with(char::is_alphabetic)
        && questions::read_code(word, language).is_err()
        && !is_readable(word)
    {
        return Some("data");
    }
    match (has_code, has_project) {
        (_, true) if ["size", "check"].contains(&command) && is_of_several() => Some("compare"),
        (true, true) if command == "size" => Some("check"),
        (true, false) => OF_CODES.iter().find(|(of, _)| *of == command).map(|(_, other)| *other),
        _ => None,
    }
}

/// Returns `true` if the word at a place stands alone or behind `--code`.
fn is_value_of_code(words: &[&str], place: usize) -> bool {
    let before = place.checked_sub(1).and_then(|before| words.get(before)).copied().unwrap_or_default();
    !before.starts_with('-') || before == "--code"
}

/// Returns the command for words that begin a call.
fn of_first(words: &[&str], language: Language) -> Option<&'static str> {
    let first = words.first()?;
    if has_ending(first, &[".toml"]) && Path::new(first).is_file() {
        let is_code =
            |word: &&str| seems_code(word) && questions::list::code_list::read_pattern(word, language).is_ok();
        return Some(if words.iter().skip(1).any(is_code) { "check" } else { "size" });
    }
    if seems_code(first) && questions::read_code(first, language).is_ok() {
        return Some("data");
    }
    kind(words).map(|_| "new")
}

/// Returns the scenario of a simulation with which some words begin, and the number of the words: `power failure axis.toml`.
fn scenario(words: &[&str]) -> Option<(&'static str, usize)> {
    /// Largest number of words of a scenario.
    const WORDS_MOST: usize = 3;
    let scenario = questions::list::simulate::Args::ARGUMENTS.iter().find(|argument| argument.name == "scenario")?;
    let of = |count: usize| Some((scenario.word(&words.get(..count)?.join("_"))?, count));
    (1..=words.len().min(WORDS_MOST)).rev().find_map(of)
}

/// Returns the subcommand of `code` for a code, a pattern of codes or the beginning of one.
fn of_code(words: &[&str], language: Language) -> Option<&'static str> {
    let bare: Vec<&str> = words.iter().copied().take_while(|word| !word.starts_with('-')).collect();
    let first = bare.first()?;
    let series = first.to_uppercase().starts_with("CHA");
    let is_whole = || questions::read_code(first, language).is_ok();
    if first.contains(['?', '*', '…']) || series && first.contains(['#', '_', '.', 'x', 'X']) && !is_whole() {
        return Some("list");
    }
    let is_whole =
        questions::read_code(&bare.join(" "), language).is_ok() || questions::read_code(first, language).is_ok();
    match is_whole {
        true => Some("parse"),
        false => series.then_some("complete"),
    }
}

/// Returns the text of a new project of the kind at the beginning of some words.
pub(super) fn template(words: &[String], language: Language) -> Option<String> {
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let (kind, _) = kind(&words)?;
    new::template(&kind, new::USUAL_NAME, language).map(|template| template.text)
}

/// Returns the name of a workbook beside the first of some projects, which names each of them.
pub(super) fn workbook_beside(projects: &[std::path::PathBuf], ending: &str) -> String {
    let further = projects.iter().skip(1).filter_map(|path| path.file_stem());
    let further: String = further.map(|stem| format!("-{}", stem.to_string_lossy())).collect();
    file_beside(projects, &format!("{further}{ending}"))
}

/// Returns the name of a file beside the first project of some words, with another ending; else one named like the project of
/// an example.
pub(super) fn file_beside(projects: &[std::path::PathBuf], ending: &str) -> String {
    let stem = projects.first().map(|path| path.with_extension("").to_string_lossy().into_owned());
    format!("{}{ending}", stem.unwrap_or_else(|| USUAL_STEM.to_owned()))
}

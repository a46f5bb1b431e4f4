//! Faults of the input, shown with file, line, column and the offending text underlined.

pub(crate) mod memory;

use crate::answer::Answer;
use crate::subject::refuse;
use crate::table::width;
use crate::waiting::patience;
use clap::ArgMatches;
pub(crate) use disk::path_text;
use disk::{Beside, Links};
use std::path::{Path, PathBuf};
use workbench::quantities::{Measure, seen};
use workbench::text::{Told, Usage, file_trouble, terminal, told, usage_text};
use workbench::{Grant, Language, PROJECT_MAX_BYTES, Project, Reach, Unread};

/// The text of a project file.
pub(crate) struct Source {
    /// What it is called in messages.
    pub(crate) name: String,
    pub(crate) text: String,
    path: PathBuf,
    memory: u64,
}

impl Source {
    /// Reads the text of a project file; a fault is the finished answer.
    pub(crate) fn read(path: &Path, matches: &ArgMatches, as_json: bool, language: Language) -> Result<Self, Answer> {
        let memory = memory::allowed(matches, as_json, language)?;
        let piped = path.as_os_str() == "-";
        let name = if piped { "stdin".to_owned() } else { path_text(path) };
        let bytes =
            read_bytes(path).map_err(|error| unreadable(&name, &file_trouble(&error, language), as_json, language))?;
        if bytes.len() > PROJECT_MAX_BYTES {
            let what = terminal::file_too_large(&PROJECT_MAX_BYTES, language);
            return Err(unreadable(&name, &what, as_json, language));
        }
        let text = String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            let line = error.as_bytes().iter().take(at).filter(|byte| **byte == b'\n').count() + 1;
            let what = terminal::not_utf_8(&line, language);
            unreadable(&name, &what, as_json, language)
        })?;
        Ok(Self { name, text, path: if piped { PathBuf::new() } else { path.to_owned() }, memory })
    }

    /// Bytes of memory that the project is allowed.
    pub(crate) const fn memory(&self) -> u64 {
        self.memory
    }

    fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    /// The files that are read: the project and its recordings. None of them is written.
    pub(crate) fn inputs<'p>(&self, projects: impl IntoIterator<Item = &'p Project>) -> Vec<PathBuf> {
        let recordings = projects.into_iter().flat_map(|project| &project.recordings);
        let recordings = recordings.map(|read| self.folder().join(&read.file));
        [self.path.clone()].into_iter().chain(recordings).collect()
    }

    /// All its axes; a fault is the finished answer.
    pub(crate) fn projects(&self, as_json: bool, language: Language) -> Result<Vec<Project>, Answer> {
        // Whoever calls the program may read what he may read: any path is taken, as in a shell.
        let grant = Grant { memory: self.memory, reach: Reach::Anywhere };
        let files = Beside { folder: self.folder().to_owned(), links: Links::Followed, grant };
        workbench::read_all_watched(&self.text, &files, patience()).map_err(|unread| match unread {
            Unread::Faults(faults) => report(&self.name, &self.text, &told(&faults, language), as_json, language),
            Unread::Refused(refusal) => refuse(&refusal, as_json, language),
        })
    }
}

/// At most one byte more than a project file may have: a large file or an endless stream is not read to its end.
fn read_bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    read_bytes_within(path, PROJECT_MAX_BYTES)
}

/// At most one byte more than `most`.
pub(crate) fn read_bytes_within(path: &Path, most: usize) -> std::io::Result<Vec<u8>> {
    if path.as_os_str() == "-" {
        disk::read_within(std::io::stdin().lock(), most)
    } else {
        disk::read_within(std::fs::File::open(path)?, most)
    }
}

/// A fault in one sentence.
pub(crate) fn simple(what: &str, as_json: bool, language: Language) -> Answer {
    Answer::refused(format!("{}: {}\n", error_word(language), seen(what)), workbench::answer::fault(what), as_json)
}

pub(crate) fn unreadable(file: &str, what: &str, as_json: bool, language: Language) -> Answer {
    let talk = format!("{}: {}: {}\n", error_word(language), seen(file), seen(what));
    Answer::refused(talk, workbench::answer::file_fault(file, what), as_json)
}

/// The word that heads a fault.
pub(crate) const fn error_word(language: Language) -> &'static str {
    terminal::error(language)
}

/// Every fault of a text, underlined.
pub(crate) fn report(file: &str, text: &str, faults: &[Told], as_json: bool, language: Language) -> Answer {
    let mut talk = String::new();
    let file = seen(file);
    let visible = |fault: &Told| Told {
        message: seen(&fault.message).into_owned(),
        hint: fault.hint.as_deref().map(|hint| seen(hint).into_owned()),
        ..fault.clone()
    };
    let faults: Vec<Told> = faults.iter().map(visible).collect();
    let (error, help) = (error_word(language), terminal::help(language));
    let style = excerpt::Style { file: &file, error, help, width: width() };
    for fault in &faults {
        let of_text = excerpt::Fault {
            span: fault.span.clone(),
            line: fault.line,
            column: fault.column,
            message: &fault.message,
            hint: fault.hint.as_deref(),
        };
        talk.push_str(&excerpt::show(text, &of_text, &style));
        talk.push('\n');
    }
    let counted = match faults.len() {
        51.. => terminal::more_than_fifty_errors(language).to_owned(),
        count => terminal::errors(count, language),
    };
    talk.push_str(&format!(
        "antrieb: {counted}; {}
",
        terminal::nothing_was_calculated(language)
    ));
    Answer::refused(talk, workbench::answer::faults(&file, &faults), as_json)
}

/// A fault of an option, with what would help.
pub(crate) fn option_fault(
    option: &str,
    (message, hint): (String, Option<String>),
    as_json: bool,
    language: Language,
) -> Answer {
    let line = hint.as_deref().map(|hint| format!("  {}\n", seen(hint))).unwrap_or_default();
    let talk = format!("{}: --{option}: {}\n{line}", error_word(language), seen(&message));
    Answer::refused(talk, workbench::answer::option_fault(option, (message, hint)), as_json)
}

/// A text given as an option: of a bounded length, and nothing in it that is not seen.
pub(crate) fn text_option(
    matches: &ArgMatches,
    option: &str,
    as_json: bool,
    language: Language,
) -> Result<Option<String>, Answer> {
    // As many as a text of a project may have.
    const MOST: usize = 200;
    let Ok(Some(text)) = matches.try_get_one::<String>(option) else { return Ok(None) };
    if text.chars().count() > MOST {
        let message = usage_text(&Usage::TooLong { most: MOST }, language);
        return Err(option_fault(option, (message, None), as_json, language));
    }
    Ok(Some(seen(text).into_owned()))
}

/// A quantity given as an option.
pub(crate) fn quantity<Q: Measure>(
    matches: &ArgMatches,
    option: &str,
    as_json: bool,
    language: Language,
) -> Result<Option<Q>, Answer> {
    matches
        .get_one::<String>(option)
        .map(|text| {
            workbench::read_quantity(text, language).map_err(|error| option_fault(option, error, as_json, language))
        })
        .transpose()
}

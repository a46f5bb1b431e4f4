//! Faults of the input, shown with file, line, column and the offending text underlined.

use crate::answer::Answer;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use clap::ArgMatches;
use std::io::Read;
use std::path::{Path, PathBuf};
use workbench::answers::{Fault, Faults};
use workbench::quantities::Measure;
use workbench::text::{Told, file_trouble, terminal, told};
use workbench::{Files, Language, PROJECT_MAX_BYTES, Project};

/// Longest line that is shown with an underline; a longer one is cut out of the picture.
const LINE_MAX: usize = 400;

/// The text of a project file.
pub(crate) struct Source {
    /// What it is called in messages.
    pub(crate) name: String,
    pub(crate) text: String,
    folder: PathBuf,
}

impl Source {
    /// Reads the text of a project file; a fault is the finished answer.
    pub(crate) fn read(path: &Path, as_json: bool, language: Language) -> Result<Self, Answer> {
        let piped = path.as_os_str() == "-";
        let name = if piped { "stdin".to_owned() } else { path.display().to_string() };
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
        let folder = if piped { Path::new("") } else { path.parent().unwrap_or(Path::new("")) };
        Ok(Self { name, text, folder: folder.to_owned() })
    }

    /// All its axes; a fault is the finished answer.
    pub(crate) fn projects(&self, as_json: bool, language: Language) -> Result<Vec<Project>, Answer> {
        workbench::read_all(&self.text, &Beside(&self.folder))
            .map_err(|faults| report(&self.name, &self.text, &told(&faults, language), as_json, language))
    }
}

/// Reads a project file with all its axes; a fault is the finished answer.
pub(crate) fn read_projects(path: &Path, as_json: bool, language: Language) -> Result<Vec<Project>, Answer> {
    Source::read(path, as_json, language)?.projects(as_json, language)
}

/// At most one byte more than a project file may have: a large file or an endless stream is not read to its end.
fn read_bytes(path: &Path) -> std::io::Result<Vec<u8>> {
    let limit = PROJECT_MAX_BYTES as u64 + 1;
    let mut bytes = Vec::new();
    if path.as_os_str() == "-" {
        std::io::stdin().lock().take(limit).read_to_end(&mut bytes)?;
    } else {
        std::fs::File::open(path)?.take(limit).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// The files beside a project file.
struct Beside<'p>(&'p Path);

impl Files for Beside<'_> {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        let path = self.0.join(name);
        if path.is_dir() {
            return Err(std::io::ErrorKind::IsADirectory.into());
        }
        Ok(Box::new(std::fs::File::open(path)?))
    }
}

/// A fault in one sentence.
pub(crate) fn simple(what: &str, as_json: bool, language: Language) -> Answer {
    Answer::refused(format!("{}: {what}\n", error_word(language)), Faults::of(what), as_json)
}

pub(crate) fn unreadable(file: &str, what: &str, as_json: bool, language: Language) -> Answer {
    let word = error_word(language);
    let talk = format!("{word}: {file}: {what}\n");
    let fault = Fault { file: Some(file.to_owned()), message: what.to_owned(), ..Fault::default() };
    Answer::refused(talk, Faults { errors: vec![fault] }, as_json)
}

/// The word that heads a fault.
pub(crate) const fn error_word(language: Language) -> &'static str {
    terminal::error(language)
}

const fn help_word(language: Language) -> &'static str {
    terminal::help(language)
}

/// Every fault of a text, underlined.
pub(crate) fn report(file: &str, text: &str, faults: &[Told], as_json: bool, language: Language) -> Answer {
    let mut talk = String::new();
    for fault in faults {
        talk.push_str(&render(file, text, fault, language));
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
    Answer::refused(talk, workbench::answer::faults(file, faults), as_json)
}

fn render(file: &str, text: &str, fault: &Told, language: Language) -> String {
    let place = format!("{file}:{}:{}", fault.line, fault.column);
    let line = text.lines().nth(fault.line.saturating_sub(1)).unwrap_or_default();
    let long = line.len() > LINE_MAX || fault.span.len() > LINE_MAX;
    let help = fault.hint.as_deref().map(|hint| format!("{}: {hint}", help_word(language)));
    if long {
        let help = help.map(|help| format!("  {help}\n")).unwrap_or_default();
        return format!("{}: {}\n  --> {place}\n{help}", error_word(language), fault.message);
    }
    let level = Level::ERROR.with_name(error_word(language));
    let mut group: Group<'_> = level
        .primary_title(fault.message.as_str())
        .element(Snippet::source(text).path(file).annotation(AnnotationKind::Primary.span(fault.span.clone())));
    if let Some(hint) = fault.hint.as_deref() {
        group = group.element(Level::HELP.with_name(help_word(language)).message(hint));
    }
    format!("{}\n", Renderer::styled().render(&[group]))
}

/// A fault of an option, with what would help.
pub(crate) fn option_fault(
    option: &str,
    (message, hint): (String, Option<String>),
    as_json: bool,
    language: Language,
) -> Answer {
    let line = hint.as_ref().map(|hint| format!("  {hint}\n")).unwrap_or_default();
    let talk = format!("{}: --{option}: {message}\n{line}", error_word(language));
    let fault = Fault { option: Some(option.to_owned()), message, hint, ..Fault::default() };
    Answer::refused(talk, Faults { errors: vec![fault] }, as_json)
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

//! A call of a command as a question: its files are read, its arguments become texts for the list.

use crate::answer::CommandAnswer;
#[cfg(feature = "report")]
use crate::changed::file_name_of_changes;
use crate::changed::{Statements, changed};
use crate::command::typed::typed;
use crate::fault::{memory, path_text};
use crate::save::Saver;
use crate::source::SourceFile as File;
use crate::waiting::{progress, waited_s};
use axis::Catalogue;
use clap::ArgMatches;
use clap::parser::ValueSource;
use project::{BODY_SHAPES, CATALOGUE_MAX_BYTES};
use quantities::Language;
use questions::list::{
    Argument, ArgumentForm, ArgumentKind, Entry, Given, Inquiry, Reads, ReferencedText, Unanswered, bounded, new,
};
use questions::{embedded_catalogue, read_code, with_catalogue_files};
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{SystemTime, UNIX_EPOCH};
use words::{file_trouble, terminal};

/// Seconds of a day.
const DAY_S: u64 = 86_400;

/// A call of a command.
pub(crate) struct Call<'m> {
    pub(crate) entry: &'static Entry,
    matches: &'m ArgMatches,
    pub(crate) as_json: bool,
    pub(crate) language: Language,
    files: Vec<File>,
    /// Remark on each value that the call states in place of a file.
    pub(crate) changes: String,
    /// Products that are offered.
    catalogue: Arc<dyn Catalogue>,
}

/// Returns the days since 1 January 1970 by the clock of this machine.
#[must_use]
pub fn days_since_1970() -> Option<u64> {
    SystemTime::now().duration_since(UNIX_EPOCH).ok().map(|time| time.as_secs() / DAY_S)
}

/// Returns the path of a file named in a call: relative to the working folder of the caller, not to that of the
/// project.
#[must_use]
pub fn named_file(value: &str) -> String {
    std::path::absolute(value).map_or_else(|_| value.to_owned(), |path| path.to_string_lossy().into_owned())
}

/// Returns the bodies of a call: the words behind a shape belong to it, also without quotes.
fn bodies(words: Vec<String>) -> Vec<String> {
    let mut bodies: Vec<String> = Vec::new();
    let mut is_open = false;
    for word in words {
        let is_shape = BODY_SHAPES.iter().any(|shape| shape.name.eq_ignore_ascii_case(&word));
        match bodies.last_mut().filter(|_| is_open && !is_shape && !word.contains(char::is_whitespace)) {
            Some(body) => {
                body.push(' ');
                body.push_str(&word);
            }
            None => {
                is_open = is_shape;
                bodies.push(word);
            }
        }
    }
    bodies
}

/// Layout of the answer to a question on the terminal.
pub(crate) type Show = fn(&Call<'_>, &Inquiry<'_>) -> Result<CommandAnswer, Unanswered>;

/// Reads the files that a question is about.
fn read(entry: &Entry, matches: &ArgMatches, language: Language) -> Result<Vec<File>, Unanswered> {
    let names: &[&str] = match (entry.reads, entry.option()) {
        (Reads::Nothing, _) => return Ok(Vec::new()),
        (Reads::Project | Reads::Pins | Reads::Measured | Reads::TwoProjects, Some(option)) => &[option],
        (Reads::TwoProjects, None) => &["old", "new"],
        (Reads::Project | Reads::Pins, None) => &["project"],
        (Reads::Measured, None) => &["files"],
    };
    let memory = memory::allowed(matches, language)?;
    let paths = names.iter().flat_map(|name| matches.get_many::<PathBuf>(name).into_iter().flatten());
    let (mut files, mut faults) = (Vec::new(), Vec::new());
    for path in paths {
        match File::read(path, entry.reads, memory, language) {
            Ok(file) => files.push(file),
            Err(fault) => faults.push(fault),
        }
    }
    if faults.is_empty() { Ok(files) } else { Err(Unanswered::combined(faults)) }
}

/// Returns the catalogue of a call: that of the program, with the products of its catalogue files.
fn catalogue(matches: &ArgMatches, language: Language) -> Result<Arc<dyn Catalogue>, Unanswered> {
    let named: Vec<PathBuf> =
        matches.try_get_many::<PathBuf>("catalogue").ok().flatten().into_iter().flatten().cloned().collect();
    catalogue_of(&named, language)
}

/// Returns the catalogue of the program with the products of some catalogue files.
pub(crate) fn catalogue_of(named: &[PathBuf], language: Language) -> Result<Arc<dyn Catalogue>, Unanswered> {
    let base = embedded_catalogue();
    if named.is_empty() {
        return Ok(Arc::clone(base));
    }
    let read = |path: &PathBuf| {
        let name = path_text(path);
        let bytes = disk::read_file(path, CATALOGUE_MAX_BYTES);
        match bytes {
            Ok(bytes) => Ok((name, bytes)),
            Err(error) => {
                let message = file_trouble(&error, language);
                Err(Unanswered::File { name, message, is_too_large: false })
            }
        }
    };
    let (files, faults): (Vec<_>, Vec<_>) = named.iter().map(read).partition(Result::is_ok);
    let faults: Vec<Unanswered> = faults.into_iter().filter_map(Result::err).collect();
    if !faults.is_empty() {
        return Err(Unanswered::combined(faults));
    }
    with_catalogue_files(base, files.into_iter().flatten(), language)
}

/// Changes the projects of a call as its options say; returns a remark on each change.
fn change(files: &mut [File], matches: &ArgMatches, language: Language) -> Result<String, Unanswered> {
    let mut remarks = String::new();
    for file in files {
        for made in file.change(&Statements::of(matches), language)? {
            remarks.push_str(&format!("{}\n", terminal::changed_for_this_call(&made, language)));
        }
        if let Some(assumed) = file.assumed() {
            let name = path_text(file.path());
            let stem = file.path().with_extension("");
            let out = format!("{}.toml", path_text(&stem));
            let sets: Vec<String> = assumed.iter().map(|each| each.replace(" = ", "=")).collect();
            let own = matches.try_get_many::<String>("set").ok().flatten().into_iter().flatten();
            let sets = sets.iter().chain(own).flat_map(|set| ["--set", set.as_str()]);
            let head = ["antrieb", "new", "recording", "--from", name.as_str()].into_iter();
            let new = typed(head.chain(sets).chain(["--out", out.as_str()]));
            for each in assumed {
                remarks.push_str(&format!("{}\n", terminal::option_assumed(each, language)));
            }
            remarks.push_str(&format!("{}\n", terminal::new_project_as_a_file(&new, language)));
        }
        if let Some(unstated) = file.unstated() {
            let kind = path_text(file.path());
            let out = format!("{kind}.toml");
            let sets = matches.try_get_many::<String>("set").ok().flatten().into_iter().flatten();
            let sets = sets.flat_map(|set| ["--set", set.as_str()]);
            let head = ["antrieb", "new", kind.as_str()].into_iter();
            let new = typed(head.chain(sets).chain(["--out", out.as_str()]));
            remarks.push_str(&format!("{}\n", terminal::values_of_a_new_project(&unstated.join("; "), language)));
            remarks.push_str(&format!("{}\n", terminal::new_project_as_a_file(&new, language)));
        }
    }
    Ok(remarks)
}

/// Returns an answer of the list.
fn record(answer: &questions::list::Answer) -> CommandAnswer {
    CommandAnswer { talk: answer.remarks.clone(), ..CommandAnswer::data(answer.text.clone()) }.fits(answer.fits)
}

impl<'m> Call<'m> {
    /// Reads the files of a call of the command of a question.
    pub(crate) fn read(
        entry: &'static Entry,
        matches: &'m ArgMatches,
        as_json: bool,
        language: Language,
    ) -> Result<Self, Unanswered> {
        let mut files = read(entry, matches, language)?;
        // Of two revisions the new one has the changes of the call.
        let unchanged = usize::from(entry.reads == Reads::TwoProjects && files.len() > 1);
        let changes = change(files.get_mut(unchanged..).unwrap_or_default(), matches, language)?;
        let catalogue = catalogue(matches, language)?;
        Ok(Self { entry, matches, as_json, language, files, changes, catalogue })
    }
}

impl Call<'_> {
    /// Returns `true` if the call names no catalogue file.
    pub(crate) fn names_no_catalogue(&self) -> bool {
        let named = self.matches.try_get_many::<PathBuf>("catalogue").ok().flatten();
        named.is_none_or(|mut paths| paths.next().is_none())
    }

    /// Returns the remarks on the values that the call states in place of the project, one a line.
    #[cfg(feature = "report")]
    pub(crate) fn changes(&self) -> impl Iterator<Item = &str> {
        self.changes.lines()
    }

    /// Converts the call to the question of its command.
    pub(crate) fn inquiry(&self, entry: &Entry) -> Result<Inquiry<'_>, Unanswered> {
        let sources: Vec<ReferencedText<'_>> = self.files.iter().map(File::source).collect();
        Ok(Inquiry {
            given: self.given(entry.arguments)?,
            sources,
            catalogue: &self.catalogue,
            days_since_1970: days_since_1970(),
            progress: progress(),
            refuses_long: waited_s().is_none(),
            by_axes: false,
            language: self.language,
        })
    }

    /// Returns the texts that the call gives for some arguments.
    pub(crate) fn given(&self, arguments: &[Argument]) -> Result<Given, Unanswered> {
        let mut pairs: Vec<(Cow<'_, str>, Cow<'_, str>)> = Vec::new();
        for argument in arguments {
            // With JSON output, the format is implied.
            let is_said = self.as_json && argument.name == "format";
            if !self.is_given(argument.name) || is_said {
                continue;
            }
            let values = self.matches.get_raw(argument.name).into_iter().flatten();
            let values: Vec<String> = values.map(|value| value.to_string_lossy().into_owned()).collect();
            match (argument.kind, argument.form) {
                (ArgumentKind::File, _) => {
                    pairs.extend(values.iter().map(|value| (argument.name.into(), named_file(value).into())));
                }
                _ if argument.name == "body" => {
                    pairs.extend(bodies(values).into_iter().map(|body| (argument.name.into(), body.into())))
                }
                (ArgumentKind::Flag, _) => pairs.push((argument.name.into(), "true".into())),
                (_, ArgumentForm::Words) => pairs.push((argument.name.into(), values.join(" ").into())),
                (_, ArgumentForm::Option | ArgumentForm::Bare | ArgumentForm::Each) => {
                    pairs.extend(values.into_iter().map(|value| (argument.name.into(), value.into())));
                }
            }
        }
        // The command line has already decided what is required: values of the call may stand in place of a table.
        let decided = |argument: &Argument| Argument { required: false, ..*argument };
        let arguments: &[Argument] = &arguments.iter().map(decided).collect::<Vec<_>>();
        let may_name = |file: &File| file.source().may_name_products();
        let has_names = self.catalogue.has_files() || self.files.iter().any(may_name);
        Ok(Given::of(arguments, pairs, self.language)?.naming_products(has_names))
    }

    fn is_given(&self, name: &str) -> bool {
        matches!(self.matches.try_contains_id(name), Ok(true))
            && self.matches.value_source(name) == Some(ValueSource::CommandLine)
    }

    /// Returns the file of an option.
    pub(crate) fn path(&self, name: &str) -> Option<&Path> {
        self.matches.try_get_one::<PathBuf>(name).ok().flatten().map(PathBuf::as_path)
    }

    /// Returns the file of an option, unless it is standard output.
    pub(crate) fn file(&self, name: &str) -> Option<&Path> {
        self.path(name).filter(|path| path.as_os_str() != "-")
    }

    /// Returns the file beside the project with its name, the values that the call states in place of the file's, and
    /// another extension; `None` for standard input.
    #[cfg(feature = "report")]
    pub(crate) fn file_beside(&self, ending: &str) -> Option<PathBuf> {
        let project = self.files.first()?.path();
        let stem = project.file_stem()?.to_string_lossy().into_owned();
        Some(project.with_file_name(format!("{stem}{}.{ending}", file_name_of_changes(self.matches))))
    }

    /// Returns the fault of an option that a call without it needs.
    #[cfg(feature = "report")]
    pub(crate) fn missing(&self, option: &str) -> Unanswered {
        let missing = words::Usage::Missing { names: option.to_owned() };
        Unanswered::message(words::usage_text(&missing, self.language))
    }

    /// Returns the text of a new project with the values that the call states, and each change; `None` if it states none.
    pub(crate) fn changed(&self, text: &str) -> Result<Option<(String, Vec<String>)>, Unanswered> {
        let is_stated = self.matches.try_contains_id("set").unwrap_or(false);
        let of_catalogue = is_stated && self.text("kind") == Some(new::CATALOGUE);
        if of_catalogue {
            let message = terminal::no_values_of_a_catalogue(self.language).to_owned();
            return Err(Unanswered::option("set", (message, None)));
        }
        let changed =
            changed(text, &Statements::of(self.matches), self.language)?.map(|changed| (changed.text, changed.made));
        if is_stated && changed.is_none() {
            // A table of rows has no keys.
            let message = terminal::no_values_of_a_table(self.language).to_owned();
            return Err(Unanswered::option("set", (message, None)));
        }
        Ok(changed)
    }

    /// Returns the writer of the files of the call, which protects those that it reads.
    pub(crate) fn saver(&self) -> Saver {
        Saver { inputs: self.inputs(), force: self.flag("force"), language: self.language }
    }

    /// Returns the answer as a record.
    pub(crate) fn record(&self, inquiry: &Inquiry<'_>) -> Result<CommandAnswer, Unanswered> {
        let answer = self.entry.answer.map(|answer| answer(inquiry)).transpose()?;
        Ok(answer.as_ref().map_or_else(CommandAnswer::none, record))
    }

    /// Returns the text of an option.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        self.matches.try_get_one::<String>(name).ok().flatten().map(String::as_str)
    }

    /// Returns all texts of a repeated option.
    pub(crate) fn texts(&self, name: &str) -> Vec<String> {
        let all = self.matches.try_get_many::<String>(name).ok().flatten();
        all.map(|all| all.cloned().collect()).unwrap_or_default()
    }

    /// Returns the number of an option.
    pub(crate) fn count(&self, name: &str) -> Option<u64> {
        self.matches.try_get_one::<u64>(name).ok().flatten().copied()
    }

    /// Returns the text of an option, of limited length and without invisible characters.
    pub(crate) fn label(&self, name: &'static str) -> Result<Option<String>, Unanswered> {
        self.text(name).map(|text| bounded(name, text, self.language)).transpose()
    }

    /// Returns `true` if an option is set.
    pub(crate) fn flag(&self, name: &str) -> bool {
        self.matches.try_get_one::<bool>(name).ok().flatten().copied().unwrap_or(false)
    }

    /// Returns `true` if files are written.
    pub(crate) fn writes(&self) -> bool {
        self.entry.files().any(|file| self.path(file.option).is_some())
    }

    /// Returns every file that the call reads: those that it names, and those that its projects name. None of them is written.
    ///
    /// No recording is read for it, which may take seconds.
    pub(crate) fn inputs(&self) -> Vec<PathBuf> {
        let is_written = |name: &str| self.entry.files().any(|file| file.option == name);
        let named = self.matches.ids().map(clap::Id::as_str).filter(|name| !is_written(name)).flat_map(|name| {
            let paths = self.matches.try_get_many::<PathBuf>(name).ok().flatten().into_iter().flatten();
            let is_file =
                self.entry.arguments.iter().any(|each| each.name == name && matches!(each.kind, ArgumentKind::File));
            let words = if is_file { self.texts(name) } else { Vec::new() };
            paths.cloned().chain(words.into_iter().map(PathBuf::from)).collect::<Vec<_>>()
        });
        let of_projects = self.files.iter().flat_map(|file| {
            let source = file.source();
            let (text, _) = project::decoded(&source.bytes);
            let folder = &file.project_files().folder;
            project::files_named(&text).into_iter().map(|name| folder.join(name)).collect::<Vec<_>>()
        });
        named.chain(of_projects).collect()
    }

    /// Returns the folder of the project.
    pub(crate) fn project_files(&self) -> Option<disk::ProjectFiles> {
        self.files.first().map(|file| file.project_files().clone())
    }

    /// Returns the memory that the project may use, in bytes.
    pub(crate) fn memory(&self) -> u64 {
        self.files.first().map_or(questions::MEMORY_USUAL, |file| file.project_files().grant.memory)
    }

    /// Returns a remark on each value that the call states in place of a file, and on each code that was not written
    /// canonically.
    pub(crate) fn understood(&self, inquiry: &Inquiry<'_>) -> String {
        let codes = self.entry.arguments.iter().filter(|argument| matches!(argument.kind, ArgumentKind::Code));
        let read = codes.flat_map(|argument| inquiry.given.all(argument.name)).filter_map(|text| {
            let reading = read_code(text, self.language).ok()?;
            (!reading.parsed.is_canonical())
                .then(|| format!("{}\n", terminal::understood_as(&reading.parsed.code, self.language)))
        });
        std::iter::once(self.changes.clone()).chain(read).collect()
    }
}

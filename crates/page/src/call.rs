//! Request, response, and the resources that a shell provides.

use answers::Commissioning;
use axis::{AxisProject, Catalogue, Files};
use figures::Theme;
use quantities::Language;
use questions::Progress;
use questions::list::report;
use std::borrow::Cow;
use std::io;
use std::sync::Arc;
use std::time::Duration;

/// Method of a request.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Reads a resource.
    Get,
    /// Sends a body.
    Post,
}

impl Method {
    /// Returns the name of the method in HTTP.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Get => "GET",
            Self::Post => "POST",
        }
    }

    /// Returns the HTTP methods that are answered in this way; GET includes HEAD.
    #[must_use]
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Get => &["GET", "HEAD"],
            Self::Post => &["POST"],
        }
    }
}

/// A request without the details of its transport.
#[derive(Clone, Copy, Debug)]
pub struct Call<'c> {
    /// Method.
    pub method: Method,
    /// The path, decoded, without the query.
    pub path: &'c str,
    /// The query as it was sent, without the question mark.
    pub query: &'c str,
    /// The media type of the body as it was sent.
    pub media: Option<&'c str>,
    /// The body.
    pub body: &'c [u8],
    /// The default language, unless the query has `lang`.
    pub language: Language,
}

impl<'c> Call<'c> {
    /// Returns the decoded values of the query and then, for a form, those of the body, in their order.
    pub fn fields(&self) -> impl Iterator<Item = (Cow<'c, str>, Cow<'c, str>)> + use<'c> {
        let form = self
            .media
            .is_some_and(|media| media.split(';').next().is_some_and(|kind| kind.trim().eq_ignore_ascii_case(FORM)));
        let body: &'c [u8] = if form { self.body } else { &[] };
        form_urlencoded::parse(self.query.as_bytes()).chain(form_urlencoded::parse(body))
    }

    /// Returns the values of a name in their order.
    pub(crate) fn all(&self, name: &str) -> impl Iterator<Item = Cow<'c, str>> {
        self.fields().filter(move |(key, _)| key == name).map(|(_, value)| value)
    }

    /// Returns the last value of a name.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<Cow<'c, str>> {
        self.all(name).last()
    }

    /// Returns the index of the requested way to begin.
    pub(crate) fn begin(&self) -> usize {
        self.field("kind").or_else(|| self.field("begin")).and_then(|kind| kind.parse().ok()).unwrap_or(usize::MAX)
    }

    /// Returns the requested colours of the page.
    pub(crate) fn theme(&self) -> Theme {
        if self.field("theme").is_some_and(|theme| theme == "dark") { Theme::Dark } else { Theme::Light }
    }

    /// Returns the decoded values of the query alone, in their order.
    pub fn query_fields(&self) -> impl Iterator<Item = (Cow<'c, str>, Cow<'c, str>)> + use<'c> {
        form_urlencoded::parse(self.query.as_bytes())
    }

    /// Returns the language that the query states, else the default language.
    #[must_use]
    pub fn query_language(&self) -> Language {
        let asked = self.query_fields().filter(|(key, _)| key == "lang").last();
        asked.and_then(|(_, wanted)| Language::of_id(&wanted)).unwrap_or(self.language)
    }

    /// Returns the language that query or form states, else the default language.
    #[must_use]
    pub fn language(&self) -> Language {
        self.field("lang").and_then(|wanted| Language::of_id(&wanted)).unwrap_or(self.language)
    }
}

const FORM: &str = "application/x-www-form-urlencoded";

/// Writes values as the query of an address.
pub(crate) fn query<N: AsRef<str>, V: AsRef<str>>(values: impl IntoIterator<Item = (N, V)>) -> String {
    form_urlencoded::Serializer::new(String::new()).extend_pairs(values).finish()
}

/// A reply.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reply {
    /// Status code of HTTP.
    pub status: u16,
    /// The media type of the body.
    pub media: &'static str,
    /// Further headers.
    pub headers: Vec<(&'static str, String)>,
    /// The body.
    pub body: Vec<u8>,
}

impl Reply {
    /// Creates a reply of plain text.
    #[must_use]
    pub fn text(status: u16, body: &str) -> Self {
        Self::of(status, "text/plain; charset=utf-8", body)
    }

    /// Creates a reply with a body of a media type.
    #[must_use]
    pub fn of(status: u16, media: &'static str, body: impl Into<Vec<u8>>) -> Self {
        Self { status, media, headers: Vec::new(), body: body.into() }
    }

    /// Adds a header.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.headers.push((name, value.into()));
        self
    }

    /// Adds a header with the name of a file; a header holds ASCII, other letters and `%` are percent-encoded.
    #[must_use]
    pub fn with_name(self, header: &'static str, name: &str) -> Self {
        let encoded = name.bytes().map(|byte| match byte {
            b' '..=b'~' if byte != b'%' => char::from(byte).to_string(),
            _ => format!("%{byte:02X}"),
        });
        self.with(header, encoded.collect::<String>())
    }

    /// Adds the header that makes a browser save the body as a file of this name.
    #[must_use]
    pub fn saved_as(self, name: &str) -> Self {
        // The header takes a quoted string of ASCII; file names of the page need no other characters.
        let name: String =
            name.chars().filter(|sign| sign.is_ascii_alphanumeric() || matches!(sign, '.' | '-' | '_')).collect();
        self.with("content-disposition", format!("attachment; filename=\"{name}\""))
    }
}

/// The resources that a shell provides.
pub trait Shell {
    /// Returns the files that a project may name.
    fn files(&self) -> &dyn Files;

    /// Returns the products that are offered.
    fn catalogue(&self) -> &Arc<dyn Catalogue>;

    /// Returns the time limit of an answer, if there is one.
    fn time_limit(&self) -> Option<Duration> {
        None
    }

    /// Returns the progress of a running work by the name that the page has given it: steps done and, if known, their
    /// number. `None` if the shell has no access to a running work.
    fn progress(&self, _work: &str) -> Option<(usize, Option<usize>)> {
        None
    }

    /// Cancels a running work; returns `true` if there was one.
    fn cancel(&self, _work: &str) -> bool {
        false
    }

    /// Returns the days since 1 January 1970 by the clock, if there is one.
    fn days_since_1970(&self) -> Option<u64> {
        None
    }

    /// Returns the working folder; `None` if the page has no disk.
    fn folder(&self) -> Option<&dyn Folder> {
        None
    }

    /// Returns the writer of reports as PDF; `None` without a typesetting engine.
    fn report(&self) -> Option<WritesReport> {
        None
    }

    /// Returns the writer of commissioning checklists as PDF; `None` without a typesetting engine.
    fn checklist(&self) -> Option<WritesChecklist> {
        None
    }

    /// Returns the identifier of a version of a file.
    fn version(&self, bytes: &[u8]) -> String;
}

/// A requested report.
#[derive(Clone, Copy, Debug)]
pub struct ReportInputs<'a> {
    /// The text of the project.
    pub text: &'a str,
    /// Axes of the report, each with its index in the project.
    pub axes: &'a [(usize, AxisProject)],
    /// Actuator, extent and title page.
    pub args: &'a report::Args,
    /// Language of the report.
    pub language: Language,
    /// Progress and cancellation of the caller.
    pub progress: &'a Progress,
}

/// Writes a report as PDF, or returns the reason in one sentence.
pub type WritesReport = fn(&ReportInputs<'_>) -> Result<Vec<u8>, String>;

/// Writes the checklists of a commissioning as PDF, or returns the reason in one sentence.
pub type WritesChecklist = fn(&Commissioning, Language) -> Result<Vec<u8>, String>;

/// Writers of a typesetting engine.
#[derive(Clone, Copy, Debug)]
pub struct Press {
    /// Reports.
    pub report: WritesReport,
    /// Checklists of a commissioning.
    pub checklist: WritesChecklist,
}

/// A project file in the folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileEntry {
    /// Name within the folder.
    pub name: String,
    /// Time of the last change \[s\] since 1 January 1970.
    pub modified_s: u64,
}

/// Reason why a file was not saved.
#[derive(Debug)]
pub enum SaveFault {
    /// The file differs from the version that was opened.
    Changed,
    /// The name leads out of the folder, or is not the name of a project file.
    Name,
    /// Error of the disk.
    Disk(io::Error),
}

/// Storage behind a folder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// A disk, shared with other programs.
    Disk,
    /// The storage of the browser, private to this page.
    Browser,
}

/// The working folder: project files by name, and no access outside of it.
pub trait Folder {
    /// Returns the storage behind the folder.
    fn place(&self) -> Storage {
        Storage::Disk
    }

    /// Returns the project files, the last written one first.
    ///
    /// # Errors
    /// Error of the disk.
    fn list(&self) -> io::Result<Vec<FileEntry>>;

    /// Reads a project file.
    ///
    /// # Errors
    /// Error of the disk; a name that leads out of the folder is reported as not found.
    fn read(&self, name: &str) -> io::Result<Vec<u8>>;

    /// Saves a text atomically. `known` is the version that was opened (its hash, as the page holds it), `None` for a
    /// new file; a file that has changed since is left unchanged.
    ///
    /// # Errors
    /// [`SaveFault`].
    fn save(&self, name: &str, text: &[u8], known: Option<&str>) -> Result<(), SaveFault>;

    /// Keeps a recording next to the projects and returns its name there: its own or, if another recording has that
    /// name, a similar one.
    ///
    /// # Errors
    /// [`SaveFault`].
    fn keep(&self, name: &str, bytes: &[u8]) -> Result<String, SaveFault>;
}

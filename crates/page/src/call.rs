//! Request, response, and the resources that a shell provides.

use answers::Commissioning;
use figures::Theme;
use order_code::OrderCode;
use project::{Files, Project};
use quantities::Language;
use questions::Patience;
use std::borrow::Cow;
use std::io;
use std::time::Duration;

/// How a request asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// For something that is there.
    Get,
    /// With a body.
    Post,
}

impl Method {
    /// Its name.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Get => "GET",
            Self::Post => "POST",
        }
    }

    /// The methods answered in this way: GET includes HEAD.
    #[must_use]
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::Get => &["GET", "HEAD"],
            Self::Post => &["POST"],
        }
    }
}

/// A request as a shell hands it in, with nothing of the transport in it.
#[derive(Clone, Copy, Debug)]
pub struct Call<'c> {
    /// How it asks.
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
    /// The values of the query and, of a form, those of the body behind them, decoded, in their order.
    pub fn fields(&self) -> impl Iterator<Item = (Cow<'c, str>, Cow<'c, str>)> + use<'c> {
        let form = self
            .media
            .is_some_and(|media| media.split(';').next().is_some_and(|kind| kind.trim().eq_ignore_ascii_case(FORM)));
        let body: &'c [u8] = if form { self.body } else { &[] };
        form_urlencoded::parse(self.query.as_bytes()).chain(form_urlencoded::parse(body))
    }

    /// The values of a name, in their order.
    pub(crate) fn all(&self, name: &str) -> impl Iterator<Item = Cow<'c, str>> {
        self.fields().filter(move |(key, _)| key == name).map(|(_, value)| value)
    }

    /// The last value of a name.
    #[must_use]
    pub fn field(&self, name: &str) -> Option<Cow<'c, str>> {
        self.all(name).last()
    }

    /// The requested colours of the page.
    pub(crate) fn theme(&self) -> Theme {
        if self.field("theme").is_some_and(|theme| theme == "dark") { Theme::Dark } else { Theme::Light }
    }

    /// The values of the query alone, decoded, in their order.
    pub fn query_fields(&self) -> impl Iterator<Item = (Cow<'c, str>, Cow<'c, str>)> + use<'c> {
        form_urlencoded::parse(self.query.as_bytes())
    }

    /// The language in the query.
    #[must_use]
    pub fn query_language(&self) -> Language {
        let asked = self.query_fields().filter(|(key, _)| key == "lang").last();
        asked.and_then(|(_, wanted)| Language::of_id(&wanted)).unwrap_or(self.language)
    }

    /// The requested language.
    #[must_use]
    pub fn language(&self) -> Language {
        self.field("lang").and_then(|wanted| Language::of_id(&wanted)).unwrap_or(self.language)
    }
}

const FORM: &str = "application/x-www-form-urlencoded";

/// Values as the query of an address.
pub(crate) fn query<N: AsRef<str>, V: AsRef<str>>(values: impl IntoIterator<Item = (N, V)>) -> String {
    form_urlencoded::Serializer::new(String::new()).extend_pairs(values).finish()
}

/// What a shell sends back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reply {
    /// The status as HTTP has it.
    pub status: u16,
    /// The media type of the body.
    pub media: &'static str,
    /// Further headers.
    pub headers: Vec<(&'static str, String)>,
    /// The body.
    pub body: Vec<u8>,
}

impl Reply {
    /// Plain text.
    #[must_use]
    pub fn text(status: u16, body: &str) -> Self {
        Self::of(status, "text/plain; charset=utf-8", body)
    }

    /// A body of a media type.
    #[must_use]
    pub fn of(status: u16, media: &'static str, body: impl Into<Vec<u8>>) -> Self {
        Self { status, media, headers: Vec::new(), body: body.into() }
    }

    /// The same with a further header.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.headers.push((name, value.into()));
        self
    }

    /// The same, kept by the browser as a file of this name.
    #[must_use]
    pub fn saved_as(self, name: &str) -> Self {
        // A quoted string of ASCII; a name of ours has nothing else.
        let name: String =
            name.chars().filter(|sign| sign.is_ascii_alphanumeric() || matches!(sign, '.' | '-' | '_')).collect();
        self.with("content-disposition", format!("attachment; filename=\"{name}\""))
    }
}

/// The resources that a shell provides.
pub trait Shell {
    /// The files that a project may name.
    fn files(&self) -> &dyn Files;

    /// How long an answer may take, where that is limited.
    fn time_limit(&self) -> Option<Duration> {
        None
    }

    /// How far a work under way is, by the name that the page has given it: steps done, and how many there are to be where
    /// that is known. None where a shell cannot tell while it works.
    fn progress(&self, _work: &str) -> Option<(usize, Option<usize>)> {
        None
    }

    /// Cancels a running work; returns whether there was one.
    fn cancel(&self, _work: &str) -> bool {
        false
    }

    /// The days since the first of 1970 by the clock, where there is one.
    fn days_since_1970(&self) -> Option<u64> {
        None
    }

    /// The folder that is worked in; none where the page has no disk.
    fn folder(&self) -> Option<&dyn Folder> {
        None
    }

    /// Writes the report of the axes as PDF; none where there is no typesetting engine.
    fn report(&self) -> Option<WritesReport> {
        None
    }

    /// Writes the check-lists of a commissioning as PDF; none where there is no typesetting engine.
    fn checklist(&self) -> Option<WritesChecklist> {
        None
    }

    /// The identifier of a version of a file.
    fn version(&self, bytes: &[u8]) -> String;
}

/// The requested report.
#[derive(Clone, Copy, Debug)]
pub struct ReportAsked<'a> {
    /// The text of the project.
    pub text: &'a str,
    /// Its axes, each with its place in it.
    pub axes: &'a [(usize, Project)],
    /// The actuator; none for the project's own, else the best.
    pub code: Option<OrderCode>,
    /// With the derivations.
    pub full: bool,
    /// With wiring, mounting and commissioning.
    pub installation: bool,
    /// The day that stands on it.
    pub date: Option<&'a str>,
    /// Its language.
    pub language: Language,
    /// The watch of the caller.
    pub patience: &'a Patience,
}

/// Writes a report as PDF, or says in one sentence why there is none.
pub type WritesReport = fn(&ReportAsked<'_>) -> Result<Vec<u8>, String>;

/// Writes the check-lists of a commissioning as PDF, or says in one sentence why there is none.
pub type WritesChecklist = fn(&Commissioning, Language) -> Result<Vec<u8>, String>;

/// What a typesetting engine writes.
#[derive(Clone, Copy, Debug)]
pub struct Press {
    /// Reports.
    pub report: WritesReport,
    /// Check-lists of a commissioning.
    pub checklist: WritesChecklist,
}

/// A project file in the folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileEntry {
    /// Its name within the folder.
    pub name: String,
    /// When it was last written, in seconds since 1970.
    pub modified_s: u64,
}

/// Why a file was not saved.
#[derive(Debug)]
pub enum SaveFault {
    /// Another version stands there than the one that was opened.
    Changed,
    /// The name leads out of the folder, or is no name of a project file.
    Name,
    /// What the disk says.
    Disk(io::Error),
}

/// Where a folder is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// On a disk, where other programs see it.
    Disk,
    /// In the browser, which keeps it for this page alone.
    Browser,
}

/// The working folder: project files by their names, nothing outside of it.
pub trait Folder {
    /// Where it is.
    fn place(&self) -> Storage {
        Storage::Disk
    }

    /// The project files in it, the last written first.
    ///
    /// # Errors
    /// What the disk says.
    fn list(&self) -> io::Result<Vec<FileEntry>>;

    /// The text of a project file.
    ///
    /// # Errors
    /// What the disk says; a name that leads out of the folder is not found.
    fn read(&self, name: &str) -> io::Result<Vec<u8>>;

    /// Saves a text atomically. `known` is the version (its hash, as the page has it) that was opened, `None` for a file that is not there yet:
    /// a file that changed since is left as it is.
    ///
    /// # Errors
    /// [`SaveFault`].
    fn save(&self, name: &str, text: &[u8], known: Option<&str>) -> Result<(), SaveFault>;

    /// Keeps a recording beside the projects, under its own name or, where that is taken by another, one like it; gives the
    /// name that it has.
    ///
    /// # Errors
    /// [`SaveFault`].
    fn keep(&self, name: &str, bytes: &[u8]) -> Result<String, SaveFault>;
}

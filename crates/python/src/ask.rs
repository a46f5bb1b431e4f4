//! A call from Python as a question of the list.

use crate::held::{HeldFiles, Recordings};
use antrieb::SourceFile;
use axis::{Catalogue, Files, NoFiles};
use disk::ProjectFiles;
use page::{Reply, Shell};
use quantities::Language;
use questions::list::{ArgumentKind, Entry, Given, Inquiry, LIST, Reads, ReferencedText, Unanswered};
use questions::{Progress, embedded_catalogue};
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// A text that a question is about, or its file.
#[derive(Clone, Debug)]
pub enum SourceText {
    /// A file.
    At(PathBuf),
    /// The text itself, its name in faults, and the folder of the recordings that it may name.
    Is {
        /// The text.
        text: String,
        /// Name in faults.
        name: String,
        /// Folder of the recordings.
        folder: PathBuf,
        /// Recordings that are not read from files.
        recordings: Recordings,
    },
}

/// A call.
#[derive(Clone, Debug)]
pub struct QuestionCall {
    /// Command of the question.
    pub command: String,
    /// Texts that it is about.
    pub texts: Vec<SourceText>,
    /// Names and values of its arguments.
    pub pairs: Vec<(String, String)>,
    /// Time limit.
    pub deadline: Option<Duration>,
    /// Limit of the memory for recordings, as written.
    pub memory: Option<String>,
    /// Answers a project with one axis as one with several.
    pub by_axes: bool,
    /// Language of the texts.
    pub language: Language,
}

/// Answer to a call.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CallOutcome {
    /// The answer.
    Answered(Reply),
    /// The record of the faults.
    Refused(String),
}

impl QuestionCall {
    /// Returns the cancellation of the call, with a time limit if the call has one.
    #[must_use]
    pub fn progress(&self) -> Progress {
        if self.deadline.is_some() { Progress::limited() } else { Progress::endless() }
    }

    /// Answers the call.
    #[must_use]
    pub fn answer(&self, progress: &Progress) -> CallOutcome {
        self.answered(progress).map_or_else(|why| self.refused(&why), CallOutcome::Answered)
    }

    fn answered(&self, progress: &Progress) -> Result<Reply, Unanswered> {
        let entry = entry(&self.command)?;
        let memory = antrieb::memory_allowed(self.memory.clone(), self.language)?;
        let read = self.texts.iter().map(|text| text.read(entry.reads, memory, self.language));
        let files: Vec<CallSource> = read.collect::<Result<_, _>>()?;
        let sources: Vec<_> = files.iter().map(CallSource::source).collect();
        let has_names = sources.iter().any(|source| source.may_name_products());
        let inquiry = Inquiry {
            given: Given::of(entry.arguments, self.given(entry), self.language)?.naming_products(has_names),
            sources,
            catalogue: embedded_catalogue(),
            days_since_1970: antrieb::days_since_1970(),
            progress,
            refuses_long: self.deadline.is_none(),
            by_axes: self.by_axes,
            language: self.language,
        };
        page::reply(entry, &inquiry, &Here { files: files.first() })
    }

    fn given<'c>(&'c self, entry: &Entry) -> Vec<(Cow<'c, str>, Cow<'c, str>)> {
        let is_file = |name: &str| {
            entry.arguments.iter().any(|known| known.name == name && matches!(known.kind, ArgumentKind::File))
        };
        let pairs = self.pairs.iter().map(|(name, value)| {
            let value = if is_file(name) { antrieb::named_file(value).into() } else { Cow::Borrowed(value.as_str()) };
            (Cow::Borrowed(name.as_str()), value)
        });
        pairs.collect()
    }

    fn refused(&self, why: &Unanswered) -> CallOutcome {
        CallOutcome::Refused(why.record(self.deadline.map(|most| most.as_secs_f64()), self.language))
    }
}

/// Returns the question of a command.
fn entry(command: &str) -> Result<&'static Entry, Unanswered> {
    let found = LIST.iter().copied().find(|entry| entry.command == command);
    found.ok_or(Unanswered::Refused(questions::Refusal::NoData, None))
}

impl SourceText {
    /// Reads the text.
    ///
    /// # Errors
    /// Error of the system about the file.
    pub fn read(&self, reads: Reads, memory: u64, language: Language) -> Result<CallSource, Unanswered> {
        let (file, recordings) = match self {
            Self::At(path) => (SourceFile::read(path, reads, memory, language)?, Recordings::default()),
            Self::Is { text, name, folder, recordings } => {
                let file = SourceFile::of_text(name.clone(), text.clone().into_bytes(), Path::new(folder), memory);
                (file, Arc::clone(recordings))
            }
        };
        let files = HeldFiles { recordings, files: file.project_files().clone() };
        Ok(CallSource { file, files })
    }
}

/// A text of a call with the files that it may name.
#[derive(Clone, Debug)]
pub struct CallSource {
    file: SourceFile,
    /// Files that it may name.
    pub files: HeldFiles<ProjectFiles>,
}

impl CallSource {
    /// Returns it in the form of a question.
    #[must_use]
    pub fn source(&self) -> ReferencedText<'_> {
        ReferencedText { files: &self.files, ..self.file.source() }
    }
}

/// Resources of this machine for an answer.
struct Here<'f> {
    files: Option<&'f CallSource>,
}

impl Shell for Here<'_> {
    fn files(&self) -> &dyn Files {
        self.files.map_or(&NoFiles, |source| &source.files)
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        embedded_catalogue()
    }

    fn days_since_1970(&self) -> Option<u64> {
        antrieb::days_since_1970()
    }

    fn report(&self) -> Option<page::WritesReport> {
        antrieb::PRESS.map(|press| press.report)
    }

    fn checklist(&self) -> Option<page::WritesChecklist> {
        antrieb::PRESS.map(|press| press.checklist)
    }

    fn version(&self, _: &[u8]) -> String {
        // There is no open page that could hold an older version.
        String::new()
    }
}

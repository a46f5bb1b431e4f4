//! A file that a question is about, with the files that it may name.

use crate::changed::keys::is_measured;
use crate::changed::{Statements, changed, consequences};
use crate::command::text_of_kind;
use crate::fault::{path_text, read_bytes};
use axis::{Grant, Reach};
use disk::{Links, ProjectFiles};
use project::{Written, key_at, written};
use quantities::Language;
use questions::list::{Reads, ReferencedText, Unanswered, new};
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use words::{file_trouble, terminal};

pub(crate) mod begun;

/// A file that a question is about: a project, a list or a record.
#[derive(Clone, Debug)]
pub struct SourceFile {
    path: PathBuf,
    name: String,
    bytes: Vec<u8>,
    project_files: ProjectFiles,
    /// Text of a new project, if the file is none but the kind of one.
    template: Option<String>,
    /// The file is a recording, with which a new project begins; assumptions of that project.
    of_recording: Option<Vec<String>>,
}

impl SourceFile {
    /// Reads the file at a path, `-` for standard input, up to the limit of what is read; `memory` limits the bytes of its recordings.
    ///
    /// # Errors
    /// Error of the system.
    pub fn read(path: &Path, reads: Reads, memory: u64, language: Language) -> Result<Self, Unanswered> {
        let piped = path.as_os_str() == "-";
        let name = if piped { "stdin".to_owned() } else { path_text(path) };
        let of_kind = || path.to_str().and_then(|word| text_of_kind(word, language));
        if let Some(text) = (reads == Reads::Project).then(of_kind).flatten() {
            let file = Self::of_text(name, text.clone().into_bytes(), Path::new(""), memory);
            return Ok(Self { path: path.to_owned(), template: Some(text), ..file });
        }
        if reads == Reads::Project && !piped && begun::is_recording(path) {
            return Self::of_recording(path, name, memory, language);
        }
        let bytes = read_bytes(path, reads.bytes_most()).map_err(|error| Unanswered::File {
            name: name.clone(),
            message: file_trouble(&error, language),
            is_too_large: false,
        })?;
        let path = if piped { Path::new("") } else { path };
        let folder = path.parent().unwrap_or(Path::new(""));
        Ok(Self { path: path.to_owned(), ..Self::of_text(name, bytes, folder, memory) })
    }

    /// Creates the project that begins with a recording; a motion that does not end where it began is a single move.
    fn of_recording(path: &Path, name: String, memory: u64, language: Language) -> Result<Self, Unanswered> {
        let text = begun::text_of(path, language)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let of = |text: String, assumed: Vec<String>| Self {
            path: path.to_owned(),
            of_recording: Some(assumed),
            ..Self::of_text(terminal::new_project_with(&name, language), text.into_bytes(), folder, memory)
        };
        let file = of(text.clone(), Vec::new());
        let read = file.source().projects(questions::embedded_catalogue(), crate::waiting::progress(), language);
        let is_open = matches!(&read, Err(Unanswered::Text { faults, .. })
            if faults.len() == 1 && faults.iter().any(|fault| fault.id.ends_with("_not_closed")));
        let single = is_open.then(|| begun::as_single_move(&text)).flatten();
        let assumed = format!("{} = true", new::SINGLE_MOVE);
        Ok(single.map_or(file, |text| of(text, vec![assumed])))
    }

    /// Replaces its text by one with the changes of a call; returns them, and what follows from them. A file that is no text keeps its bytes.
    ///
    /// # Errors
    /// Every change that cannot be made.
    pub(crate) fn change(&mut self, stated: &Statements, language: Language) -> Result<Vec<String>, Unanswered> {
        let Ok(text) = std::str::from_utf8(&self.bytes) else { return Ok(Vec::new()) };
        let Some(changed) = changed(text, stated, language)? else { return Ok(Vec::new()) };
        let after = ReferencedText {
            name: self.name.clone(),
            bytes: Cow::Borrowed(changed.text.as_bytes()),
            files: &self.project_files,
        };
        let further = consequences(&self.source(), &after, stated, language);
        self.name = changed.named(&self.name);
        self.bytes = changed.text.into_bytes();
        Ok(changed.made.into_iter().chain(further).collect())
    }

    /// Creates a file from a text, with a name for its faults, as if it lay in a folder.
    #[must_use]
    pub fn of_text(name: String, bytes: Vec<u8>, folder: &Path, memory: u64) -> Self {
        // As in a shell, any path is accepted that the caller may read.
        let grant = Grant { memory, reach: Reach::Anywhere };
        let project_files = ProjectFiles { folder: folder.to_owned(), links: Links::Followed, grant };
        Self { path: PathBuf::new(), name, bytes, project_files, template: None, of_recording: None }
    }

    /// Returns the values of a new project that the call does not state, each with its key; empty for a file.
    pub(crate) fn unstated(&self) -> Option<Vec<String>> {
        let template = written(self.template.as_deref()?)?;
        let own = std::str::from_utf8(&self.bytes).ok().and_then(written)?;
        let stated = std::str::from_utf8(&self.bytes).map(questions::list::new::stated).unwrap_or_default();
        let is_value = |path: &str| key_at(path).is_some_and(|key| is_measured(key.kind)) && !stated.contains(&path);
        let of = |each: &Written| {
            let value = each.value.as_deref().filter(|_| is_value(&each.path))?;
            let is_kept = own.iter().any(|now| now.path == each.path && now.value.as_deref() == Some(value));
            is_kept.then(|| format!("{} {value}", each.path))
        };
        Some(template.iter().filter_map(of).collect())
    }

    /// Returns the assumptions of the project that begins with the file, a recording; `None` for another file.
    pub(crate) fn assumed(&self) -> Option<&[String]> {
        self.of_recording.as_deref()
    }

    /// Returns its path; empty for a text.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the files that it may name.
    #[must_use]
    pub const fn project_files(&self) -> &ProjectFiles {
        &self.project_files
    }

    /// Returns it in the form of a question.
    #[must_use]
    pub fn source(&self) -> ReferencedText<'_> {
        ReferencedText { name: self.name.clone(), bytes: Cow::Borrowed(&self.bytes), files: &self.project_files }
    }
}

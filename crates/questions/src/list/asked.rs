//! A question as it was put: what is given for its arguments, the texts it is about, and who waits for the answer.

use super::cost::Cost;
use super::given::Given;
use super::unanswered::Unanswered;
use crate::answer::written;
use crate::patience::Patience;
use crate::reading::read_all_watched;
use crate::subject::{names, picked};
use answers::{Answered, Fit};
use project::{Files, PROJECT_MAX_BYTES, Project};
use quantities::Language;
use serde::Serialize;
use std::borrow::Cow;
use words::terminal;

/// An axis with its place in its file.
pub type Axis = (usize, Project);

/// A text that a question is about.
pub struct Source<'a> {
    /// What it is called in faults.
    pub name: String,
    /// Its bytes, at least one more than a project file may have where it has more.
    pub bytes: Cow<'a, [u8]>,
    /// The files that it may name.
    pub files: &'a dyn Files,
}

impl Source<'_> {
    /// The text.
    ///
    /// # Errors
    /// Where it is too large or not UTF-8.
    pub fn text(&self, language: Language) -> Result<&str, Unanswered> {
        let refused = |message, is_too_large| Unanswered::File { name: self.name.clone(), message, is_too_large };
        if self.bytes.len() > PROJECT_MAX_BYTES {
            return Err(refused(terminal::file_too_large(&PROJECT_MAX_BYTES, language), true));
        }
        std::str::from_utf8(&self.bytes).map_err(|error| {
            let before = self.bytes.get(..error.valid_up_to()).unwrap_or_default();
            let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
            refused(terminal::not_utf_8(&line, language), false)
        })
    }

    /// Every axis of a project file.
    ///
    /// # Errors
    /// The faults of the text, or why it is not read.
    pub fn projects(&self, patience: &Patience, language: Language) -> Result<Vec<Project>, Unanswered> {
        let text = self.text(language)?;
        read_all_watched(text, self.files, patience)
            .map_err(|unread| Unanswered::unread(unread, &self.name, text, language))
    }
}

/// A question as it was put.
pub struct Asked<'a> {
    /// What is given for its arguments.
    pub given: Given,
    /// The texts that it is about: none, a project, two revisions of one, a list or a record.
    pub sources: Vec<Source<'a>>,
    /// The days since the first of 1970, where there is a clock.
    pub days_since_1970: Option<u64>,
    /// Cancels the work.
    pub patience: &'a Patience,
    /// Whether an answer that would take long is refused before its work begins.
    pub refuses_long: bool,
    /// The language of the texts.
    pub language: Language,
}

impl<'a> Asked<'a> {
    /// The text that it is about.
    ///
    /// # Errors
    /// Where there is none.
    pub fn source(&self) -> Result<&Source<'a>, Unanswered> {
        self.sources.first().ok_or(Unanswered::Refused(crate::Refusal::NoData, None))
    }

    /// The axes of the project, or the one of a name.
    ///
    /// # Errors
    /// Faults of the project, an axis that it has not, a cost that is refused.
    pub fn axes(&self, wanted: Option<&str>, cost: Cost) -> Result<Vec<Axis>, Unanswered> {
        let axes = self.axes_of(self.source()?, wanted)?;
        self.within(cost, axes.iter())?;
        Ok(axes)
    }

    /// The same of one of the texts, whatever it costs.
    ///
    /// # Errors
    /// Faults of the project, an axis that it has not.
    pub fn axes_of(&self, source: &Source<'_>, wanted: Option<&str>) -> Result<Vec<Axis>, Unanswered> {
        let projects = source.projects(self.patience, self.language)?;
        picked(projects, wanted, self.language).map_err(Unanswered::message)
    }

    /// The only axis, or the one of a name.
    ///
    /// # Errors
    /// As [`Asked::axes`], and several axes where none is named.
    pub fn axis(&self, wanted: Option<&str>, cost: Cost) -> Result<Axis, Unanswered> {
        let axes = self.axes(wanted, cost)?;
        self.only(axes, |names| terminal::several_axes(&names, self.language))
    }

    /// The only one of some axes.
    ///
    /// # Errors
    /// The sentence about several.
    pub fn only(&self, axes: Vec<Axis>, several: impl FnOnce(&str) -> String) -> Result<Axis, Unanswered> {
        let one = <[Axis; 1]>::try_from(axes).map(|[one]| one);
        one.map_err(|axes| Unanswered::message(several(&names(axes.iter().map(|(_, project)| project)))))
    }

    /// Refuses what takes long, unless a time limit is stated.
    ///
    /// # Errors
    /// What [`Cost::is_quick`] says.
    pub fn within<'p>(&self, cost: Cost, axes: impl IntoIterator<Item = &'p Axis> + Clone) -> Result<(), Unanswered> {
        if !self.refuses_long {
            return Ok(());
        }
        let projects: Vec<&Project> = axes.into_iter().map(|(_, project)| project).collect();
        cost.is_quick(projects).map_err(Unanswered::from)
    }

    /// The answer about each axis; where one has none, only the faults of all.
    ///
    /// # Errors
    /// Why there is no answer about some of them.
    pub fn each<'p, T>(
        &self,
        axes: &'p [Axis],
        mut one: impl FnMut(&'p Project) -> Result<T, Unanswered>,
    ) -> Result<Vec<T>, Unanswered> {
        let (mut found, mut faults) = (Vec::new(), Vec::new());
        for (_, project) in axes {
            match one(project) {
                Ok(answer) => found.push(answer),
                Err(fault) => faults.push(fault),
            }
        }
        if faults.is_empty() { Ok(found) } else { Err(Unanswered::together(faults)) }
    }

    /// The record about each axis, with its verdict, as one.
    ///
    /// # Errors
    /// Why there is no answer about some of them.
    pub fn record_of_each<'p, T: Serialize>(
        &self,
        axes: &'p [Axis],
        one: impl FnMut(&'p Project) -> Result<(T, Fit), Unanswered>,
    ) -> Result<Answer, Unanswered> {
        let (records, fits): (Vec<T>, Vec<Fit>) = self.each(axes, one)?.into_iter().unzip();
        let verdict = Fit::of_all(fits);
        Ok(Answer::record(&Answered::of(records, verdict)).fits(verdict.fits()))
    }
}

/// Media types of answers.
pub mod media {
    /// A record.
    pub const JSON: &str = "application/json";
    /// A picture.
    pub const SVG: &str = "image/svg+xml";
    /// A picture in pixels.
    pub const PNG: &str = "image/png";
    /// A document.
    pub const PDF: &str = "application/pdf";
    /// A table as text.
    pub const CSV: &str = "text/csv; charset=utf-8";
    /// A project, or a record of measured values.
    pub const TOML: &str = "application/toml; charset=utf-8";
    /// A workbook.
    pub const XLSX: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";
    /// Text for a machine.
    pub const PLAIN: &str = "text/plain; charset=utf-8";
    /// A calendar.
    pub const CALENDAR: &str = "text/calendar; charset=utf-8";
    /// A table for programs.
    pub const PARQUET: &str = "application/vnd.apache.parquet";
}

/// An answer as its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Their media type.
    pub media: &'static str,
    /// A record, or another text.
    pub text: String,
    /// The name of the file that they are.
    pub file: Option<String>,
    /// Whether what it is about fits.
    pub fits: bool,
    /// What is to be said beside it, a line each.
    pub remarks: String,
}

impl Answer {
    /// A record.
    #[must_use]
    pub fn record(record: &impl Serialize) -> Self {
        Self::text(media::JSON, written(record))
    }

    /// A text of a media type.
    #[must_use]
    pub const fn text(media: &'static str, text: String) -> Self {
        Self { media, text, file: None, fits: true, remarks: String::new() }
    }

    /// The same as a file of a name.
    #[must_use]
    pub fn saved_as(self, file: String) -> Self {
        Self { file: Some(file), ..self }
    }

    /// The same with whether what it is about fits.
    #[must_use]
    pub fn fits(self, fits: bool) -> Self {
        Self { fits, ..self }
    }
}

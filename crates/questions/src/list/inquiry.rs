//! A call of a question: values of its arguments, its texts, and its cancellation.

use super::cost::Cost;
use super::given::Given;
use super::unanswered::Unanswered;
use crate::answer::written;
use crate::codes::may_name_products;
use crate::progress::Progress;
use crate::reading::{Unread, read_all_watched};
use crate::subject::picked;
use answers::{Answered, Axes, Fit};
use axis::{AxisProject, Catalogue, Files};
use project::{Diagnostic, PROJECT_MAX_BYTES};
use quantities::Language;
use serde::Serialize;
use std::borrow::Cow;
use std::sync::Arc;
use words::terminal;

/// An axis with its place in the file.
pub type PlacedAxis = (usize, AxisProject);

/// A text to which a question refers.
pub struct ReferencedText<'a> {
    /// Name of the text in faults.
    pub name: String,
    /// Bytes of the text; of a text beyond the limit of a project file at least one byte more than the limit.
    pub bytes: Cow<'a, [u8]>,
    /// Files to which the text may refer.
    pub files: &'a dyn Files,
}

impl ReferencedText<'_> {
    /// Returns `true` if the text may name catalogue files or describe an actuator, so that a product may have a name.
    #[must_use]
    pub fn may_name_products(&self) -> bool {
        may_name_products(&self.bytes)
    }

    /// Returns the names of the products that the text may mean beside the ordering codes.
    #[must_use]
    pub fn product_names(&self, catalogue: &Arc<dyn Catalogue>) -> Vec<String> {
        if !self.may_name_products() {
            return catalogue.names();
        }
        let (text, _) = project::decoded(&self.bytes);
        axis::product_names(&text, self.files, catalogue)
    }

    fn within_size(&self, language: Language) -> Result<(), Unanswered> {
        if self.bytes.len() > PROJECT_MAX_BYTES {
            let message = terminal::file_too_large(&PROJECT_MAX_BYTES, language);
            return Err(Unanswered::File { name: self.name.clone(), message, is_too_large: true });
        }
        Ok(())
    }

    /// Returns the text.
    ///
    /// # Errors
    /// If the text is too large or not UTF-8.
    pub fn text(&self, language: Language) -> Result<&str, Unanswered> {
        self.within_size(language)?;
        match (std::str::from_utf8(&self.bytes), project::decoded(&self.bytes)) {
            (Ok(text), (_, None)) => Ok(text),
            (_, (text, fault)) => {
                let faults = fault.map(Diagnostic::into_other).into_iter().collect();
                Err(Unanswered::unread(Unread::Faults(faults), &self.name, &text, language))
            }
        }
    }

    /// Reads every axis of a project file.
    ///
    /// # Errors
    /// Faults of the text, or the reason why it is not read.
    pub fn projects(
        &self,
        catalogue: &Arc<dyn Catalogue>,
        progress: &Progress,
        language: Language,
    ) -> Result<Vec<AxisProject>, Unanswered> {
        self.within_size(language)?;
        let (text, encoding) = project::decoded(&self.bytes);
        let read = read_all_watched(&text, self.files, catalogue, progress);
        let read = match (read, encoding.map(Diagnostic::into_other)) {
            (read, None) => read,
            (Ok(_), Some(fault)) => Err(Unread::Faults(vec![fault])),
            (Err(Unread::Faults(mut faults)), Some(fault)) => {
                let before = faults.partition_point(|each| each.span.start <= fault.span.start);
                faults.insert(before, fault);
                Err(Unread::Faults(faults))
            }
            (refused, Some(_)) => refused,
        };
        read.map_err(|unread| Unanswered::unread(unread, &self.name, &text, language))
    }
}

/// A call of a question.
pub struct Inquiry<'a> {
    /// Values of the arguments.
    pub given: Given,
    /// Texts of the call: none, a project, two revisions of one, a list or a record.
    pub sources: Vec<ReferencedText<'a>>,
    /// Products that are offered.
    pub catalogue: &'a Arc<dyn Catalogue>,
    /// Days since 1 January 1970; `None` without a clock.
    pub days_since_1970: Option<u64>,
    /// Cancellation of the work.
    pub progress: &'a Progress,
    /// `true` if an answer that takes long is refused before its work begins.
    pub refuses_long: bool,
    /// `true` if a project with one axis is answered as one with several.
    pub by_axes: bool,
    /// Language of the texts.
    pub language: Language,
}

impl<'a> Inquiry<'a> {
    /// Returns the text of the call.
    ///
    /// # Errors
    /// If the call has no text.
    pub fn source(&self) -> Result<&ReferencedText<'a>, Unanswered> {
        self.sources.first().ok_or(Unanswered::Refused(crate::Refusal::NoData, None))
    }

    /// Returns the axes of the project, or of several projects, or those with a name.
    ///
    /// # Errors
    /// Faults of the projects, an unknown axis, a cost that is refused.
    pub fn axes(&self, wanted: Option<&str>, cost: Cost) -> Result<Vec<PlacedAxis>, Unanswered> {
        self.source()?;
        let (mut axes, mut faults) = (Vec::new(), Vec::new());
        for source in &self.sources {
            match self.axes_of(source, wanted) {
                Ok(found) => axes.extend(found),
                Err(fault) => faults.push(fault),
            }
        }
        if !faults.is_empty() {
            return Err(Unanswered::combined(faults));
        }
        self.within(cost, axes.iter())?;
        Ok(axes)
    }

    /// Returns the axes of one of the texts, regardless of the cost.
    ///
    /// # Errors
    /// Faults of the project, an unknown axis.
    pub fn axes_of(&self, source: &ReferencedText<'_>, wanted: Option<&str>) -> Result<Vec<PlacedAxis>, Unanswered> {
        let projects = source.projects(self.catalogue, self.progress, self.language)?;
        picked(projects, wanted, self.language).map_err(Unanswered::message)
    }

    /// Returns the only axis, or the one with a name.
    ///
    /// # Errors
    /// As [`Inquiry::axes`], and several axes without a name.
    pub fn axis(&self, wanted: Option<&str>, cost: Cost) -> Result<PlacedAxis, Unanswered> {
        let axes = self.axes(wanted, cost)?;
        self.only(axes, |names| terminal::several_axes(&names, self.language))
    }

    /// Returns the only one of some axes.
    ///
    /// # Errors
    /// The sentence about several axes.
    pub fn only(&self, axes: Vec<PlacedAxis>, several: impl FnOnce(&str) -> String) -> Result<PlacedAxis, Unanswered> {
        let one = <[PlacedAxis; 1]>::try_from(axes).map(|[one]| one);
        let name = |(_, project): &PlacedAxis| project.name.clone();
        one.map_err(|axes| Unanswered::which_axis(axes.iter().map(name).collect(), several))
    }

    /// Refuses a cost beyond the usual time, unless the call states a time limit.
    ///
    /// # Errors
    /// Errors of [`Cost::is_quick`].
    pub fn within<'p>(
        &self,
        cost: Cost,
        axes: impl IntoIterator<Item = &'p PlacedAxis> + Clone,
    ) -> Result<(), Unanswered> {
        if !self.refuses_long {
            return Ok(());
        }
        let projects: Vec<&AxisProject> = axes.into_iter().map(|(_, project)| project).collect();
        cost.is_quick(projects).map_err(Unanswered::from)
    }

    /// Returns the answer about each axis; if one of them fails, only the faults of all.
    ///
    /// # Errors
    /// Reasons why there is no answer about some of them.
    pub fn each<'p, T>(
        &self,
        axes: &'p [PlacedAxis],
        mut one: impl FnMut(&'p AxisProject) -> Result<T, Unanswered>,
    ) -> Result<Vec<T>, Unanswered> {
        let (mut found, mut faults) = (Vec::new(), Vec::new());
        for (_, project) in axes {
            match one(project) {
                Ok(answer) => found.push(answer),
                Err(fault) => faults.push(fault),
            }
        }
        if faults.is_empty() { Ok(found) } else { Err(Unanswered::combined(faults)) }
    }

    /// Wraps the records about all axes with their verdict.
    #[must_use]
    pub fn answered<T>(&self, axes: Vec<T>, verdict: Fit) -> Answered<T> {
        if self.by_axes { Answered::Several(Axes { verdict, axes }) } else { Answered::of(axes, verdict) }
    }

    /// Returns the records about all axes, with their verdict, as one answer.
    ///
    /// # Errors
    /// Reasons why there is no answer about some of them.
    pub fn record_of_each<'p, T: Serialize>(
        &self,
        axes: &'p [PlacedAxis],
        one: impl FnMut(&'p AxisProject) -> Result<(T, Fit), Unanswered>,
    ) -> Result<Answer, Unanswered> {
        let (records, fits): (Vec<T>, Vec<Fit>) = self.each(axes, one)?.into_iter().unzip();
        let verdict = Fit::of_all(fits);
        Ok(Answer::record(&self.answered(records, verdict)).fits(verdict.fits()))
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
    /// A table in text form.
    pub const CSV: &str = "text/csv; charset=utf-8";
    /// A project, or a record of measured values.
    pub const TOML: &str = "application/toml; charset=utf-8";
    /// A workbook.
    pub const XLSX: &str = "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet";
    /// Text for programs.
    pub const PLAIN: &str = "text/plain; charset=utf-8";
    /// A calendar.
    pub const CALENDAR: &str = "text/calendar; charset=utf-8";
    /// A table for programs.
    pub const PARQUET: &str = "application/vnd.apache.parquet";
}

/// An answer as bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// Media type of the bytes.
    pub media: &'static str,
    /// A record, or another text.
    pub text: String,
    /// File name of the answer.
    pub file: Option<String>,
    /// `true` if the subject of the answer fits.
    pub fits: bool,
    /// Remarks beside the answer, one per line.
    pub remarks: String,
}

impl Answer {
    /// Creates an answer from a record.
    #[must_use]
    pub fn record(record: &impl Serialize) -> Self {
        Self::text(media::JSON, written(record))
    }

    /// Creates an answer from a text of a media type.
    #[must_use]
    pub const fn text(media: &'static str, text: String) -> Self {
        Self { media, text, file: None, fits: true, remarks: String::new() }
    }

    /// Returns the answer as a file with a name.
    #[must_use]
    pub fn saved_as(self, file: String) -> Self {
        Self { file: Some(file), ..self }
    }

    /// Returns the answer with the verdict on its subject.
    #[must_use]
    pub fn fits(self, fits: bool) -> Self {
        Self { fits, ..self }
    }
}

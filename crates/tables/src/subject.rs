//! Subject of the tables, and how a definition makes its columns.

use crate::rows::Rows;
use crate::table::{Column, ColumnContent, Table};
use axis::AxisProject;
use quantities::{Language, Unit};
use questions::{Candidate, Sizing};
use words::{Word, capitalised};

/// Subject of the tables: one axis of a project with its results.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// Text of the project file.
    pub text: &'a str,
    /// Index of the axis in the file.
    pub axis: usize,
    /// Axis.
    pub project: &'a AxisProject,
    /// Ranking of the catalogue for the axis.
    pub sizing: &'a Sizing<'a>,
    /// Actuator of the tables.
    pub chosen: &'a Candidate<'a>,
    /// Number of actuators shown from the top of the ranking, in addition to the chosen one and that of the project.
    pub top: usize,
    /// Language of the words.
    pub language: Language,
}

impl Subject<'_> {
    /// Returns the shown candidates, best first, each judged with every check, with its rank if it fits.
    pub(crate) fn shown(&self) -> Vec<(Option<usize>, Candidate<'_>)> {
        let ranked = self.sizing.candidates.iter().enumerate();
        let mut shown: Vec<(Option<usize>, Candidate<'_>)> = ranked
            .filter(|(index, candidate)| *index < self.top || candidate.id == self.chosen.id)
            .map(|(index, candidate)| {
                let full = questions::check(self.project, &candidate.id).ok();
                (candidate.fits().then_some(index + 1), full.unwrap_or_else(|| candidate.clone()))
            })
            .collect();
        let others = self.sizing.own.iter().chain(std::iter::once(self.chosen));
        for other in others {
            if shown.iter().all(|(_, each)| each.id != other.id) {
                shown.push((None, other.clone()));
            }
        }
        shown
    }

    pub(crate) fn made(&self, name: &'static str, title: Word, about: Word, columns: Vec<Column>, rows: Rows) -> Table {
        let (title, about) = (capitalised(title(self.language)), about(self.language).to_owned());
        Table { name, title, about, columns, rows, derived: Vec::new() }
    }
}

/// Creates a column of a definition.
pub(crate) fn column(
    name: &str,
    title: Word,
    kind: ColumnContent,
    unit: Option<&'static Unit>,
    about: Word,
    language: Language,
) -> Column {
    titled(name, title(language).to_owned(), kind, unit, about, language)
}

/// Creates a column whose title is composed from its content.
pub(crate) fn titled(
    name: &str,
    title: String,
    kind: ColumnContent,
    unit: Option<&'static Unit>,
    about: Word,
    language: Language,
) -> Column {
    Column { name: name.to_owned(), title, unit, about: about(language).to_owned(), kind }
}

//! Many axes at once: a project and a table whose columns are keys of the project; each row is the project with its
//! values.
//!
//! The common part of the rows is read once (`template`). A row with an impossible axis is answered with the reason; a
//! table with unreadable headings or cells is refused with every fault.
#![allow(clippy::result_large_err, reason = "a fault is found once for a table, not for each of its rows")]

mod cells;
pub mod csv;
mod head;
mod judged;
mod labels;
mod meant;
pub mod sample;
mod stepped;
mod summary;
mod template;

use cells::Decimals;
pub use cells::{CellFault, Cells, TableFaults};
pub use head::Head;
pub use judged::{Best, Every, Judged, OnFront};
pub use labels::{BEST_COLUMNS, STAGE_RATIO, TableColumns};
pub use meant::MeantHeading;
pub use stepped::{Unstepped, stepped};
pub use summary::{MissedBy, NotJudged, SweepCheck, SweepRow, SweepSummary, Tally};

use crate::list::Unanswered;
use crate::progress::{Progress, Stopped};
use crate::reading::{embedded_catalogue, read_all_with};
use answers::AssumptionEntry;
use axis::{AssumedKeys, AxisFault, Catalogue, Files};
use configurator::ProductId;
use project::{Edit, Fault, Heading, edit};
use quantities::Language;
use rayon::prelude::*;
use recording::Commas;
use sizing::{CheckId, StepObserver};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::Arc;
use template::{Judge, Screens, Template, Templates};

/// Heading of the column of ordering codes: its rows are judged for their code alone.
pub const CODE: &str = "code";

/// Largest number of rows that a thread processes at a time.
const PART: usize = 256;

/// Answer of a sweep for each row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Wanted {
    /// The best code, and the number of fitting ones.
    #[default]
    Best,
    /// Every code with its verdict, and these checks.
    Every(Vec<CheckId>),
    /// The codes that no other fitting one dominates in mass, length and margin.
    Front,
}

/// Options of a sweep.
#[derive(Clone, Debug)]
pub struct Options {
    /// Products that are offered.
    pub catalogue: Arc<dyn Catalogue>,
    /// Name of the axis in a project with several.
    pub axis: Option<String>,
    /// Answer for each row.
    pub wanted: Wanted,
    /// Commas that numbers given as text may have.
    pub commas: Commas,
    /// Language of the reasons.
    pub language: Language,
}

impl Default for Options {
    /// Returns the options without an axis, for the best product of the embedded catalogue.
    fn default() -> Self {
        Self {
            catalogue: Arc::clone(embedded_catalogue()),
            axis: None,
            wanted: Wanted::default(),
            commas: Commas::None,
            language: Language::default(),
        }
    }
}

/// A project and the headings of a table, prepared for rows.
pub struct Sweep {
    text: String,
    files: Box<dyn Files + Send + Sync>,
    /// Place of the axis in the file, and `true` if there are several.
    axis: (usize, bool),
    columns: Vec<Column>,
    /// Assumptions of the axis that no column states.
    assumed: Vec<AssumedKeys>,
    /// Names of the recordings of the project and of the cells that were checked.
    recordings: BTreeSet<String>,
    /// Largest number of codes that a row is judged for.
    codes: usize,
    options: Options,
    templates: Templates,
    screens: Screens,
}

/// A column with its original heading.
struct Column {
    written: String,
    holds: Holds,
    /// `true` if the values of the key are those of the cells with the opposite sign.
    is_opposite: bool,
}

/// Content of a column.
enum Holds {
    /// The ordering code for which the row is judged, or one of these names of products; any name for a project that is refused.
    Code(Option<Vec<String>>),
    /// A key of the project.
    Key(Heading),
}

/// A value of a row.
#[derive(Clone, Debug, PartialEq)]
enum Value<'c> {
    Number(f64),
    Text(&'c str),
}

/// Answer for a row, or the reason why there is none.
pub type Answer = Result<Judged, String>;

impl Sweep {
    /// Reads a project, from its name and text, and the headings of a table.
    ///
    /// # Errors
    /// Every fault of the project and of the headings.
    pub fn new(
        project: (&str, &str),
        files: Box<dyn Files + Send + Sync>,
        headings: &[&str],
        options: Options,
    ) -> Result<Self, Unanswered> {
        let headings: Vec<MeantHeading> = headings.iter().map(|heading| MeantHeading::from(*heading)).collect();
        Head::of(project, &*files, &headings, options).ready("", files)
    }

    /// Iterates over the headings in their order, as keys with entries counted from one.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(Column::key)
    }

    /// Returns the assumptions that hold for every row: those of the project that no column states.
    #[must_use]
    pub fn assumptions(&self) -> Vec<AssumptionEntry> {
        self.assumed.iter().map(|each| crate::answer::assumption(each.clone(), self.options.language)).collect()
    }

    /// Returns the numbers of the cells of a column, by its place among the headings, in the unit of its heading; `None` for a
    /// cell that is none.
    #[must_use]
    pub fn column_numbers(&self, place: usize, cells: &Cells<'_>) -> Vec<Option<f64>> {
        let number = |row| match self.columns.get(place)?.value(cells, row, self.options.commas).ok()? {
            Value::Number(number) => Some(number),
            Value::Text(_) => None,
        };
        (0..cells.len()).map(number).collect()
    }

    /// Returns the text of the project.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns the recordings that the project and the checked cells name, in order.
    #[must_use]
    pub const fn recordings(&self) -> &BTreeSet<String> {
        &self.recordings
    }

    /// Returns the options.
    #[must_use]
    pub const fn options(&self) -> &Options {
        &self.options
    }

    /// Returns the largest number of lines in the answer to a row.
    #[must_use]
    pub fn lines_of_row(&self) -> usize {
        let is_of_code = self.columns.iter().any(|column| matches!(column.holds, Holds::Code(_)));
        match self.options.wanted {
            Wanted::Every(_) | Wanted::Front if !is_of_code => self.codes.max(1),
            Wanted::Best | Wanted::Every(_) | Wanted::Front => 1,
        }
    }

    /// Adds every fault of some rows: cells that are empty, no numbers, or unknown names.
    pub fn check(&self, cells: &[Cells<'_>], first_row: u64, faults: &mut TableFaults) {
        let mut decimals = Decimals::of(&self.options);
        for (place, (column, cells)) in self.columns.iter().zip(cells).enumerate() {
            cells.check((place, column), first_row, self.options.language, &mut decimals, faults);
        }
        decimals.check(|place| self.columns.get(place), self.options.language, faults);
        if first_row == 0 && faults.is_empty() {
            let rows = cells.iter().map(Cells::len).min().unwrap_or(0);
            let ends = [0, rows.saturating_sub(1)].map(|row| cells.iter().map(|cells| cells.of_row(row)).collect());
            for fault in self.faults_of_all_rows(&ends).listed {
                faults.add(fault);
            }
        }
    }

    /// Returns the faults of headings whose keys have no meaning in this project, whatever their values, from the first and the
    /// last row: a load beside another one, a key of another law. Where words are swept too, they decide it, row by row.
    fn faults_of_all_rows(&self, ends: &[Vec<Cells<'static>>]) -> TableFaults {
        let mut faults = TableFaults::default();
        let words = |column: &Column| matches!(&column.holds, Holds::Key(heading) if !heading.is_number());
        let ends = ends.iter().map(|cells| self.values(cells, 0)).collect::<Result<Vec<_>, _>>();
        let (Some((first, rest)), false) =
            (ends.as_deref().ok().and_then(<[_]>::split_first), self.columns.iter().any(words))
        else {
            return faults;
        };
        let all: Vec<usize> = (0..self.columns.len()).collect();
        let mut found = self.faults_of_keys(first, &all);
        for values in rest {
            if found.is_empty() {
                return faults;
            }
            let last = self.faults_of_keys(values, &all);
            found.retain(|fault| last.contains(fault));
        }
        for (place, column) in self.columns.iter().enumerate().filter(|_| !found.is_empty()) {
            let others: Vec<usize> = all.iter().copied().filter(|other| *other != place).collect();
            let (left, alone) = (self.faults_of_keys(first, &others), self.faults_of_keys(first, &[place]));
            // Without the column, or of it alone: two columns may have the same fault.
            for fault in found.iter().filter(|fault| !left.contains(fault) || alone.contains(fault)) {
                let fault = CellFault::of(&column.written, None, &(fault.clone(), None), self.options.language);
                if !faults.listed.contains(&fault) {
                    faults.add(fault);
                }
            }
        }
        faults
    }

    /// Returns the faults of the keys of some columns, with the values of a row.
    fn faults_of_keys(&self, values: &[Value<'_>], places: &[usize]) -> Vec<Fault> {
        let text = self.text_of(values, places);
        let faults = read_all_with(&text, &*self.files, &self.options.catalogue).err().unwrap_or_default();
        let stated = faults.into_iter().filter_map(|each| match each.fault {
            AxisFault::Stated(fault) if fault.is_of_keys() => Some(fault),
            _ => None,
        });
        stated.collect()
    }

    /// Returns the answers for some rows, in their order.
    ///
    /// # Errors
    /// If the work was cancelled.
    pub fn judge(&self, cells: &[Cells<'_>], progress: &Progress) -> Result<Vec<Answer>, Stopped> {
        let rows = cells.iter().map(Cells::len).min().unwrap_or(0);
        // Few rows with long answers occupy every thread too.
        let share = rows.div_ceil(4 * rayon::current_num_threads()).clamp(1, PART);
        let parts: Vec<std::ops::Range<usize>> =
            (0..rows).step_by(share).map(|from| from..rows.min(from + share)).collect();
        let part = |range: &std::ops::Range<usize>| -> Result<Vec<Answer>, Stopped> {
            let mut open: Option<(Vec<String>, std::sync::Arc<Template>)> = None;
            let mut found = Vec::with_capacity(range.len());
            while found.len() < range.len() {
                // Rows that differ in numbers only share a template.
                let opened = self.values(cells, range.start + found.len()).and_then(|values| {
                    let words = self.words(&values);
                    match open.take().filter(|(known, _)| *known == words) {
                        Some(known) => Ok(known),
                        None => self.template(&words, &values).map(|template| (words, template)),
                    }
                });
                let (words, template) = match opened {
                    Ok(opened) => opened,
                    Err(why) => {
                        progress.step()?;
                        found.push(Err(why));
                        continue;
                    }
                };
                let mut judge = Judge::of(&template, self);
                while found.len() < range.len() {
                    let values = self.values(cells, range.start + found.len());
                    if values.as_ref().is_ok_and(|values| self.words(values) != words) {
                        break;
                    }
                    progress.step()?;
                    found.push(values.and_then(|values| judge.row(&values)));
                }
                drop(judge);
                open = Some((words, template));
            }
            Ok(found)
        };
        let found: Vec<Vec<Answer>> = parts.par_iter().map(part).collect::<Result<_, _>>()?;
        Ok(found.into_iter().flatten().collect())
    }

    /// Returns the values of a row.
    ///
    /// # Errors
    /// Cells that cannot be values of their keys.
    fn values<'c>(&self, cells: &'c [Cells<'_>], row: usize) -> Result<Vec<Value<'c>>, String> {
        let language = self.options.language;
        let mut values = Vec::with_capacity(self.columns.len());
        let mut faults: Vec<String> = Vec::new();
        for (column, cells) in self.columns.iter().zip(cells) {
            match column.value(cells, row, self.options.commas) {
                Ok(value) => values.push(value),
                Err(fault) => faults.push(words::fault_text(&fault, language)),
            }
        }
        if faults.is_empty() { Ok(values) } else { Err(faults.join("; ")) }
    }

    /// Returns the values that are no numbers.
    fn words(&self, values: &[Value<'_>]) -> Vec<String> {
        let of = |(column, value): (&Column, &Value<'_>)| match (&column.holds, value) {
            (Holds::Key(heading), Value::Number(_)) if heading.is_number() => None,
            (Holds::Key(_), Value::Number(number)) => Some(number.to_string()),
            (Holds::Key(_), Value::Text(text)) => Some((*text).to_owned()),
            (Holds::Code(_), _) => None,
        };
        self.columns.iter().zip(values).filter_map(of).collect()
    }

    /// Returns the project file with the values of a row.
    fn text_with(&self, values: &[Value<'_>]) -> String {
        self.text_of(values, &(0..self.columns.len()).collect::<Vec<_>>())
    }

    /// Returns the project file with the values of some columns of a row.
    fn text_of(&self, values: &[Value<'_>], places: &[usize]) -> String {
        let mut text = self.text.clone();
        for place in places {
            let (Some(column), Some(value)) = (self.columns.get(*place), values.get(*place)) else { continue };
            let Holds::Key(heading) = &column.holds else { continue };
            let written = match value {
                Value::Number(number) => heading.written(*number),
                Value::Text(text) => (*text).to_owned(),
            };
            let path = self.path(heading);
            // The path was found in the file when the headings were read.
            text = edit(&text, &path, Edit::Value(&written)).unwrap_or(text);
        }
        text
    }

    /// Returns the path of a key in the file.
    fn path<'h>(&self, heading: &'h Heading) -> Cow<'h, str> {
        let (place, is_of_several) = self.axis;
        if is_of_several {
            Cow::Owned(format!("axis[{}].{}", place + 1, heading.path))
        } else {
            Cow::Borrowed(&heading.path)
        }
    }

    /// Returns the codes that the rows of some cells state; `None` without a column of codes.
    #[must_use]
    pub fn codes_of_rows(&self, cells: &[Cells<'_>]) -> Option<Vec<Option<String>>> {
        let (place, column) =
            self.columns.iter().enumerate().find(|(_, column)| matches!(column.holds, Holds::Code(_)))?;
        match cells.get(place)? {
            Cells::Texts(texts) => {
                let of = |text: &Option<Cow<'_, str>>| {
                    let text = text.as_deref()?;
                    let product = column.product(text, self.options.language).ok();
                    Some(product.map_or_else(|| text.trim().to_owned(), |product| product.to_string()))
                };
                Some(texts.iter().map(of).collect())
            }
            _ => None,
        }
    }

    fn product(&self, values: &[Value<'_>]) -> Option<ProductId> {
        let of = |(column, value): (&Column, &Value<'_>)| match (&column.holds, value) {
            (Holds::Code(_), Value::Text(text)) => column.product(text, self.options.language).ok(),
            _ => None,
        };
        self.columns.iter().zip(values).find_map(of)
    }
}

#[cfg(test)]
mod dialects;
#[cfg(test)]
mod tests;

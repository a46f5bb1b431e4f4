//! Headings of a table, read for a project that may have faults of its own, and the faults of the cells below them.
#![allow(clippy::result_large_err, reason = "a fault is found once for a table, not for each of its rows")]

use super::cells::Decimals;
use super::meant::MeantHeading;
use super::template::{Screens, Templates};
use super::{CODE, CellFault, Cells, Column, Holds, Options, Sweep, TableFaults};
use crate::codes::may_name_products;
use crate::list::Unanswered;
use crate::reading::{Unread, read_all_with};
use crate::sizing_use::products_of;
use crate::subject::picked;
use axis::{AssumedKeys, AxisProject, Files};
use project::{Counted, Fault, Heading, Hint, Objection, TabularFault, Written, written};
use std::collections::BTreeSet;

/// A project and the headings of a table before its cells are read: faults of all three are collected and reported
/// together.
pub struct Head {
    text: String,
    /// Reason why the project cannot be used.
    refused: Option<Unanswered>,
    axis: Axis,
    /// Assumptions of the axis without the table.
    assumed: Vec<AssumedKeys>,
    /// Columns with readable headings.
    columns: Vec<Option<Column>>,
    faults: TableFaults,
    decimals: Decimals,
    /// Cells of the first row, and of the last row of the last batch.
    ends: Vec<Vec<Cells<'static>>>,
    recordings: BTreeSet<String>,
    /// Largest number of codes that a row is judged for.
    codes: usize,
    /// Names of products that a row may state in place of a code; `None` if they are those of a project that is refused.
    names: Option<Vec<String>>,
    /// `true` if each row chooses among several ratios of a stage.
    chooses_ratio: bool,
    /// `true` if a heading is refused.
    is_misread: bool,
    options: Options,
}

/// Heading that any project can have.
const EXAMPLE: &str = "load.inertia [kg m^2]";

/// Rows that are checked of a table whose headings are refused.
const ROWS_OF_A_REFUSED_TABLE: u64 = 1000;

/// Axis of a file.
#[derive(Clone, Copy)]
struct Axis {
    /// Place of the axis, if known.
    place: Option<usize>,
    is_of_several: bool,
}

impl Head {
    /// Reads a project, from its name and text, and the headings of a table for it.
    #[must_use]
    pub fn of((name, text): (&str, &str), files: &dyn Files, headings: &[MeantHeading], options: Options) -> Self {
        let unread = |faults| Unanswered::unread(Unread::Faults(faults), name, text, options.language);
        let projects = read_all_with(text, files, &options.catalogue).map_err(unread);
        Self::read(text, projects, headings, options)
    }

    /// Reads the headings of a table for a project, from its text and its axes, or the reason why they cannot be read.
    #[must_use]
    pub fn read(
        text: &str,
        projects: Result<Vec<AxisProject>, Unanswered>,
        headings: &[MeantHeading],
        options: Options,
    ) -> Self {
        let known = written(text);
        let recordings = projects.iter().flatten().flat_map(|project| &project.recordings);
        let recordings = recordings.map(|read| read.file.clone()).collect();
        let codes = projects.iter().flatten().map(|project| products_of(project).len());
        let codes = codes.max().unwrap_or(0);
        let chooses_ratio = projects.iter().flatten().any(|project| !project.ratios.is_empty());
        let of = |project: &AxisProject| {
            let own = project.actuator.iter().map(|own| own.id.to_string());
            project.catalogue().names().into_iter().chain(own).collect::<Vec<String>>()
        };
        let names = match &projects {
            Ok(projects) => Some(projects.iter().flat_map(of).collect()),
            Err(_) => (!may_name_products(text.as_bytes())).then(|| options.catalogue.names()),
        };
        let assumed = match &projects {
            Ok(projects) => of_axis(projects, &options),
            Err(_) => Vec::new(),
        };
        let (axis, refused) = match projects {
            Ok(projects) => of_projects(projects, &options),
            Err(why) => (of_text(known.as_deref().unwrap_or_default(), options.axis.as_deref()), Some(why)),
        };
        let mut head = Self {
            text: text.to_owned(),
            refused,
            axis,
            assumed,
            columns: Vec::new(),
            faults: TableFaults::default(),
            decimals: Decimals::of(&options),
            ends: Vec::new(),
            recordings,
            codes,
            names,
            chooses_ratio,
            is_misread: false,
            options,
        };
        let counted = Counted::of(headings.iter().map(|heading| &*heading.meant));
        for (number, heading) in (1..).zip(headings) {
            let column = head.column((number, heading), counted, known.as_deref()).map_err(|objection| {
                // Of two columns for one key, that with a word for it may be a label.
                let of_key = |other: &&Column| other.is_by_word() && matches!(&objection.0, Fault::Tabular(TabularFault::ColumnTwice { path }) if *path == other.key());
                let word = head.columns.iter().flatten().find(of_key).filter(|_| !heading.is_by_word());
                let written = word.map_or(&*heading.written, |word| &*word.written).to_owned();
                head.faults.add(CellFault::of(&written, None, &objection, head.options.language));
            });
            head.columns.push(column.ok());
        }
        if headings.is_empty() {
            let none = (Fault::Tabular(TabularFault::NoColumns), None);
            head.faults.add(CellFault::of("", None, &none, head.options.language));
        }
        head.is_misread = !head.faults.is_empty();
        // Below headings of which none is a key there is nothing to read.
        head.faults.is_unread = head.columns.iter().all(Option::is_none);
        head
    }

    fn column(
        &self,
        (number, asked): (usize, &MeantHeading),
        counted: Counted,
        known: Option<&[Written]>,
    ) -> Result<Column, Objection> {
        let heading = &*asked.meant;
        if heading.trim().is_empty() {
            return Err((Fault::Tabular(TabularFault::NoHeading { number }), None));
        }
        let holds = if heading.trim() == CODE {
            Holds::Code(self.names.clone())
        } else {
            // Any axis of several serves for the kind of a key.
            let place = self.axis.is_of_several.then(|| self.axis.place.unwrap_or(0));
            let unknown = |(fault, hint)| match fault {
                Fault::UnknownKey { .. } => self.unknown(heading, known).unwrap_or((fault, self.meant(heading, known))),
                fault => (fault, hint),
            };
            Holds::Key(Heading::read(heading, counted, place).map_err(unknown)?)
        };
        if let (Holds::Key(found), Some(known), Some(own)) = (&holds, known, self.axis.path())
            && let Some(fault) = missing_entry(known, &own, found)
        {
            let nearest = project::nearest_entry(known, &format!("{own}{}", found.path));
            let with_unit = |path: String| {
                let path = path.strip_prefix(&own).unwrap_or(&path).to_owned();
                found.unit.map_or_else(|| path.clone(), |unit| format!("{path} [{}]", unit.symbol))
            };
            return Err((Fault::Tabular(fault), nearest.map(with_unit).map(Hint::DidYouMean)));
        }
        let column = Column { written: asked.written.clone(), holds, is_opposite: asked.is_opposite };
        if self.columns.iter().flatten().any(|other| other.key() == column.key()) {
            return Err((Fault::Tabular(TabularFault::ColumnTwice { path: column.key().to_owned() }), None));
        }
        Ok(column)
    }

    /// Returns the fault of a heading that is the word for something which the motion of the project does not state, or for two
    /// keys.
    fn unknown(&self, heading: &str, known: Option<&[Written]>) -> Option<Objection> {
        let (known, own) = (known?, self.axis.path().unwrap_or_default());
        project::without_cycle(known, &own, heading).or_else(|| project::readings_of_angle(known, &own, heading))
    }

    /// Returns the heading that an unknown one stands for, else one that the project can have.
    fn meant(&self, heading: &str, known: Option<&[Written]>) -> Option<Hint> {
        let own = self.axis.path().unwrap_or_default();
        let stated: Vec<&str> = known.into_iter().flatten().filter_map(|each| each.path.strip_prefix(&own)).collect();
        project::nearest_heading(heading, &stated).or_else(|| Some(Hint::Example(EXAMPLE.to_owned())))
    }

    /// Adds the faults of some rows, the first of which has this number, in every column with a readable heading: cells
    /// that are empty, no numbers, or unknown names.
    pub fn check(&mut self, cells: &[Cells<'_>], first_row: u64) {
        // A refused heading refuses the table: the first rows show further faults of its kind, the rest is not read.
        if self.faults.is_unread {
            return;
        }
        let rows = cells.iter().map(Cells::len).max().unwrap_or(0) as u64;
        self.faults.is_unread |= self.is_misread && first_row + rows >= ROWS_OF_A_REFUSED_TABLE;
        if let Some(last) =
            cells.iter().map(Cells::len).max().and_then(|rows| rows.checked_sub(1)).filter(|_| !self.is_misread)
        {
            let first = self.ends.is_empty().then_some(0);
            self.ends.truncate(1);
            self.ends
                .extend(first.into_iter().chain([last]).map(|row| cells.iter().map(|each| each.of_row(row)).collect()));
        }
        for (place, (column, cells)) in self.columns.iter().zip(cells).enumerate() {
            if self.faults.is_enough() {
                return;
            }
            if let Some(column) = column {
                if let Cells::Texts(texts) = cells
                    && column.names_recordings()
                {
                    for name in texts.iter().flatten().map(|text| text.trim()) {
                        if !self.recordings.contains(name) {
                            self.recordings.insert(name.to_owned());
                        }
                    }
                }
                let language = self.options.language;
                cells.check((place, column), first_row, language, &mut self.decimals, &mut self.faults);
            }
        }
    }

    /// Returns `true` if each row chooses among several ratios of a stage (`stage.ratios`), of which its answer names one.
    #[must_use]
    pub const fn chooses_ratio(&self) -> bool {
        self.chooses_ratio
    }

    /// Returns `true` if the cells below a heading are numbers.
    #[must_use]
    pub fn is_of_numbers(&self, place: usize) -> bool {
        self.columns.get(place).and_then(Option::as_ref).is_some_and(Column::is_number)
    }

    /// Adds a fault of the headings.
    pub fn refuse(&mut self, fault: CellFault) {
        self.is_misread = true;
        self.faults.add(fault);
    }

    /// Adds the fault that the line with this row number is no row of the table.
    pub fn refuse_line(&mut self, fault: TabularFault, row: u64) {
        self.faults.add(CellFault::of("", Some(row), &(Fault::Tabular(fault), None), self.options.language));
    }

    /// Returns `true` if checking the rest of the table is pointless, because there are so many faults already.
    #[must_use]
    pub const fn is_enough(&self) -> bool {
        self.faults.is_enough() || self.faults.is_unread
    }

    /// Adds that there is no row, where there is none.
    pub fn refuse_empty(&mut self, rows: u64) {
        if rows == 0 {
            let none = (Fault::Tabular(TabularFault::NoRows), None);
            self.faults.add(CellFault::of("", None, &none, self.options.language));
        }
    }

    /// Returns the sweep over tables with these headings.
    ///
    /// # Errors
    /// Every fault of the project, of the headings and of the cells that were checked; `table` is what the table is called.
    pub fn ready(mut self, table: &str, files: Box<dyn Files + Send + Sync>) -> Result<Sweep, Unanswered> {
        let column = |place: usize| self.columns.get(place).and_then(Option::as_ref);
        self.decimals.check(column, self.options.language, &mut self.faults);
        let mut why: Vec<Unanswered> = self.refused.into_iter().collect();
        if !self.faults.is_empty() {
            why.push(Unanswered::Table { name: table.to_owned(), faults: self.faults });
        }
        match self.axis.place {
            Some(place) if why.is_empty() => {
                let columns: Vec<Column> = self.columns.into_iter().flatten().collect();
                let is_stated = |key: &String| columns.iter().any(|column| column.key() == key);
                let sweep = Sweep {
                    assumed: self.assumed.into_iter().filter(|each| !each.keys.iter().any(is_stated)).collect(),
                    text: self.text,
                    files,
                    axis: (place, self.axis.is_of_several),
                    columns,
                    recordings: self.recordings,
                    codes: self.codes,
                    options: self.options,
                    templates: Templates::default(),
                    screens: Screens::default(),
                };
                let faults = sweep.faults_of_all_rows(&self.ends);
                if faults.is_empty() { Ok(sweep) } else { Err(Unanswered::Table { name: table.to_owned(), faults }) }
            }
            _ => Err(Unanswered::combined(why)),
        }
    }
}

impl Axis {
    /// Returns the prefix of the axis in paths of the file; `None` if the axis is not known.
    fn path(self) -> Option<String> {
        if self.is_of_several { self.place.map(|place| format!("axis[{}].", place + 1)) } else { Some(String::new()) }
    }
}

/// Returns the assumptions of the only axis, or of the named one.
fn of_axis(projects: &[AxisProject], options: &Options) -> Vec<AssumedKeys> {
    let named = |project: &&AxisProject| options.axis.as_deref().is_none_or(|name| project.name == name);
    let mut found = projects.iter().filter(named);
    match (found.next(), found.next()) {
        (Some(project), None) => project.assumed(),
        _ => Vec::new(),
    }
}

/// Returns the only axis, or the named one; else the reason why there is none.
fn of_projects(projects: Vec<AxisProject>, options: &Options) -> (Axis, Option<Unanswered>) {
    let language = options.language;
    let is_of_several = projects.iter().any(AxisProject::is_of_several);
    let (place, refused) = match picked(projects, options.axis.as_deref(), language) {
        Err(why) => (None, Some(Unanswered::message(why))),
        Ok(found) => match found.as_slice() {
            [(place, _)] => (Some(*place), None),
            several => {
                let names = several.iter().map(|(_, project)| project.name.clone()).collect();
                (None, Some(Unanswered::which_axis(names, |names| words::terminal::several_axes(&names, language))))
            }
        },
    };
    (Axis { place, is_of_several }, refused)
}

/// Returns the axis of a text that is no project.
fn of_text(known: &[Written], wanted: Option<&str>) -> Axis {
    let has = |path: &str| known.iter().any(|each| each.path == path);
    let count = (1..).take_while(|number| has(&format!("axis[{number}]"))).count();
    let is_named = |place: &usize| {
        let path = format!("axis[{}].name", place + 1);
        known.iter().any(|each| each.path == path && each.value.as_deref() == wanted)
    };
    let place = if wanted.is_some() { (0..count).find(is_named) } else { (count < 2).then_some(0) };
    Axis { place, is_of_several: count > 0 }
}

/// Returns the fault of an entry of a list that the project does not have.
fn missing_entry(known: &[Written], own: &str, heading: &Heading) -> Option<TabularFault> {
    let path = format!("{own}{}", heading.path);
    for (at, _) in path.match_indices(']') {
        let entry = path.get(..=at).unwrap_or_default();
        if entry.len() <= own.len() || known.iter().any(|each| each.path == entry) {
            continue;
        }
        let list = entry.rsplit_once('[').map_or(entry, |(list, _)| list);
        let count = (1..).take_while(|n| known.iter().any(|each| each.path == format!("{list}[{n}]"))).count();
        return Some(TabularFault::NoEntry { path: heading.path.clone(), count });
    }
    None
}

//! `sweep PROJECT`: many axes, a table whose columns are keys of the project.

use super::given::{arguments, by_id, flag, text};
use super::{
    AXIS, Answer, Argument, ArgumentKind, Entry, Gives, Inquiry, OutputFile, Reads, Record, ReferencedText, Unanswered,
    media,
};
use crate::sizing_use::Refusal;
use crate::sweep::csv::{Broken, Columns, Lines};
use crate::sweep::{Cells, Head, MeantHeading, Options, SweepRow, SweepSummary, TableColumns, Tally, Wanted};
use axis::{AxisProject, Catalogue, Files};
use quantities::{Language, seen};
use recording::{Commas, Content, Fault};
use sizing::CheckId;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{Cursor, Read as _};
use std::sync::Arc;
use words::{help, help::values, sweeps, terminal};

arguments! {
    /// Arguments of `sweep`: axis, table, kind of the answer.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The table.
        table: Option<String> = Argument::option("table", values::file, help::sweep_table).of(ArgumentKind::File).required() => text,
        /// Checks of every code of every row.
        check: Vec<CheckId> = Argument::option("check", values::check, help::sweep_check)
            .of(ArgumentKind::Word(|| CheckId::ALL.iter().map(|check| check.id()).collect())).titled(super::explain::check_titles).repeated() => checks,
        /// The codes that no other code dominates.
        front: bool = Argument::flag("front", help::sweep_front) => flag,
    }
}

fn checks(given: &super::Given, argument: &Argument) -> Result<Vec<CheckId>, Unanswered> {
    Ok(given.all(argument.name).filter_map(by_id(CheckId::ALL, CheckId::id)).collect())
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "sweep",
    path: "sweep",
    about: help::sweep,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<SweepSummary>("sweep")),
    writes: &[OutputFile::of("out", &[media::CSV, media::PARQUET], help::sweep_out).required()],
    example: "axis.toml --table tasks.parquet --out best.parquet",
    answer: Some(|inquiry| Ok(Answer::record(&found(inquiry)?))),
};

/// Largest number of rows if the answers are not written to a file.
const ROWS_MOST: usize = 10_000;

/// Number of values in a line of an answer without its checks.
const VALUES_OF_LINE: usize = 9;

/// Largest number of values in the answers in this case: those of 10 000 rows with a line of few checks each.
const VALUES_MOST: usize = 1 << 20;

/// Largest size of a table in this case \[byte\].
const BYTES_MOST: u64 = 16 << 20;

impl Args {
    /// Returns the options of the sweep; `commas` are those of its numbers.
    ///
    /// # Errors
    /// If two forms of the answer are requested.
    pub fn options(
        &self,
        catalogue: &Arc<dyn Catalogue>,
        commas: Commas,
        language: Language,
    ) -> Result<Options, Unanswered> {
        let wanted = match (self.front, self.check.is_empty()) {
            (true, false) => {
                return Err(Unanswered::option("front", (sweeps::front_or_checks(language).to_owned(), None)));
            }
            (true, true) => Wanted::Front,
            (false, false) => Wanted::Every(self.check.clone()),
            (false, true) => Wanted::Best,
        };
        let catalogue = Arc::clone(catalogue);
        Ok(Options { catalogue, axis: self.axis.clone(), wanted, commas, language })
    }
}

/// Returns the answers of a small CSV table as a record.
///
/// # Errors
/// Faults of the project and of the table; a table that is too long.
pub fn found(inquiry: &Inquiry<'_>) -> Result<SweepSummary, Unanswered> {
    let args = Args::read(&inquiry.given)?;
    let language = inquiry.language;
    let source = inquiry.source()?;
    let text = source.text(language)?;
    let projects = source.projects(inquiry.catalogue, inquiry.progress, language);
    let name = args.table.clone().unwrap_or_default();
    let (lines, shelf) = match (opened(source, &name, language), Shelf::of(source, projects.as_deref(), language)) {
        (Ok(lines), Ok(shelf)) => (lines, shelf),
        (lines, shelf) => {
            let why = projects.err().into_iter().chain(lines.err()).chain(shelf.err());
            return Err(Unanswered::combined(why.collect()));
        }
    };
    let head = |keys: &[MeantHeading], options| Head::read(text, projects, keys, options);
    evaluated(inquiry, &args, (&name, lines), (head, text, Box::new(shelf)), false)
}

/// Returns the answers of a table in CSV that the call states, each with the cells of its row; `files` opens the recordings.
///
/// # Errors
/// Faults of the project and of the table; a table that is too long.
pub fn of_rows(
    inquiry: &Inquiry<'_>,
    rows: (&str, &str),
    files: Box<dyn Files + Send + Sync>,
) -> Result<SweepSummary, Unanswered> {
    let args = Args::read(&inquiry.given)?;
    let language = inquiry.language;
    let source = inquiry.source()?;
    let text = source.text(language)?;
    let projects = source.projects(inquiry.catalogue, inquiry.progress, language);
    let (name, rows) = rows;
    // The rows that the call states are counted before any of them is judged.
    let count = rows.lines().count().saturating_sub(1);
    if count > ROWS_MOST {
        let too_many = Unanswered::message(sweeps::too_many_rows(&count, &ROWS_MOST, language));
        return Err(Unanswered::combined(projects.err().into_iter().chain([too_many]).collect()));
    }
    let lines = Lines::open(Cursor::new(rows.as_bytes().to_vec()));
    let lines = lines.map_err(|broken| refused(name, broken.text(language)))?;
    let head = |keys: &[MeantHeading], options| Head::read(text, projects, keys, options);
    evaluated(inquiry, &args, (name, lines), (head, text, files), true)
}

/// Returns the answers of a table; `has_inputs` adds the cells of its keys to them.
fn evaluated(
    inquiry: &Inquiry<'_>,
    args: &Args,
    (name, mut lines): (&str, Lines<Cursor<Vec<u8>>>),
    (head, text, files): (impl FnOnce(&[MeantHeading], Options) -> Head, &str, Box<dyn Files + Send + Sync>),
    has_inputs: bool,
) -> Result<SweepSummary, Unanswered> {
    let language = inquiry.language;
    let headings = lines.headings().to_vec();
    let headings: Vec<&str> = headings.iter().map(String::as_str).collect();
    let mut places = TableColumns::of(&headings);
    let keys = places.as_meant(&headings, text, args.axis.as_deref());
    let options = args.options(inquiry.catalogue, lines.commas(), language)?;
    let mut head = head(&keys, options);
    places.faults(&[], language).for_each(|fault| head.refuse(fault));
    let mut columns: Columns = vec![Vec::new(); headings.len()];
    let mut rows = 0;
    while !head.is_enough() {
        match lines.rows(ROWS_MOST) {
            Ok(None) => break,
            Ok(Some(part)) => {
                let count = part.first().map_or(0, Vec::len) as u64;
                head.check(&cells(&part, &places.keys), rows);
                rows += count;
                // Of a table that is too long the rows are counted only.
                if rows <= ROWS_MOST as u64 {
                    columns.iter_mut().zip(part).for_each(|(all, cells)| all.extend(cells));
                }
            }
            Err(Broken::Line(fault)) => {
                head.refuse_line(fault, rows);
                rows += 1;
            }
            Err(unread @ Broken::Unread(_)) => return Err(refused(name, unread.text(language))),
        }
    }
    head.refuse_empty(rows);
    let ready = head.ready(name, files);
    if rows > ROWS_MOST as u64 {
        let too_many = Unanswered::message(sweeps::too_many_rows(&rows, &ROWS_MOST, language));
        return Err(Unanswered::combined(ready.err().into_iter().chain([too_many]).collect()));
    }
    let sweep = ready?;
    let values = sweep.lines_of_row()
        * match &sweep.options().wanted {
            Wanted::Best => VALUES_OF_LINE,
            Wanted::Every(checks) => VALUES_OF_LINE + 2 * checks.len(),
            Wanted::Front => VALUES_OF_LINE,
        };
    let most = (VALUES_MOST / values).max(1);
    if rows > most as u64 {
        return Err(Unanswered::message(sweeps::too_many_rows(&rows, &most, language)));
    }
    let answers = sweep.judge(&cells(&columns, &places.keys), inquiry.progress).map_err(Refusal::from)?;
    let mut tally = Tally::default();
    answers.iter().for_each(|answer| tally.add(answer));
    let labels = |row: usize| -> BTreeMap<String, String> {
        let cell = |place: usize| columns.get(place)?.get(row)?.as_deref();
        let of = |(place, name): &(usize, String)| Some((name.clone(), cell(*place)?.to_owned()));
        let inputs = places.keys.iter().filter(|_| has_inputs);
        let inputs = inputs.filter_map(|place| Some((*place, (*headings.get(*place)?).to_owned())));
        places.carried.iter().cloned().chain(inputs).filter_map(|each| of(&each)).collect()
    };
    let codes = sweep.codes_of_rows(&cells(&columns, &places.keys)).unwrap_or_default();
    let rows = answers.iter().enumerate().flat_map(|(row, answer)| {
        let (labels, code) = (labels(row), codes.get(row).cloned().flatten());
        let lines = SweepRow::of(row as u64, answer, &sweep.options().wanted).into_iter();
        lines.map(move |line| SweepRow {
            labels: labels.clone(),
            code: line.code.clone().or_else(|| code.clone()),
            ..line
        })
    });
    Ok(SweepSummary { answers: rows.collect(), ..tally.summary(&sweep, None) })
}

/// Opens the lines of a table, whose bytes are read at once.
fn opened(source: &ReferencedText<'_>, name: &str, language: Language) -> Result<Lines<Cursor<Vec<u8>>>, Unanswered> {
    let mut bytes = Vec::new();
    let unread = |error: std::io::Error| refused(name, words::file_trouble(&error, language));
    let (content, file) = source.files.open(name).and_then(recording::opened).map_err(unread)?;
    match content {
        Content::Text | Content::Packed(_) => {}
        Content::Parquet => return Err(refused(name, sweeps::parquet_elsewhere(language).to_owned())),
        Content::Foreign(format) => return Err(refused(name, words::table_text(&Fault::Foreign { format }, language))),
    }
    let _ = file.take(BYTES_MOST + 1).read_to_end(&mut bytes).map_err(unread)?;
    if bytes.len() as u64 > BYTES_MOST {
        let message = terminal::file_too_large(&BYTES_MOST, language);
        return Err(Unanswered::File { name: seen(name).into_owned(), message, is_too_large: true });
    }
    Lines::open(Cursor::new(bytes)).map_err(|broken| refused(name, broken.text(language)))
}

fn refused(name: &str, message: String) -> Unanswered {
    Unanswered::File { name: seen(name).into_owned(), message, is_too_large: false }
}

/// Returns the columns of the keys.
fn cells<'c>(columns: &'c Columns, keys: &[usize]) -> Vec<Cells<'c>> {
    let texts = keys
        .iter()
        .filter_map(|place| columns.get(*place))
        .map(|cells| cells.iter().map(|cell| cell.as_deref().map(Cow::Borrowed)).collect());
    texts.map(Cells::Texts).collect()
}

/// Recordings of a project, each read once.
struct Shelf(BTreeMap<String, Vec<u8>>);

impl Shelf {
    /// Reads the recordings of the axes of a project; empty if the project cannot be read.
    fn of(
        source: &ReferencedText<'_>,
        projects: Result<&[AxisProject], &Unanswered>,
        language: Language,
    ) -> Result<Self, Unanswered> {
        let mut found = BTreeMap::new();
        for name in projects.unwrap_or_default().iter().flat_map(|project| &project.recordings).map(|read| &read.file) {
            let mut bytes = Vec::new();
            let read = source.files.open(name).and_then(|mut file| file.read_to_end(&mut bytes));
            read.map_err(|error| Unanswered::message(words::file_trouble(&error, language)))?;
            found.insert(name.clone(), bytes);
        }
        Ok(Self(found))
    }
}

impl Files for Shelf {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        let bytes = self.0.get(name).cloned().ok_or(std::io::ErrorKind::NotFound)?;
        Ok(Box::new(std::io::Cursor::new(bytes)))
    }
}

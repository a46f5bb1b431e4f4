//! `sweep PROJECT`: many axes, a table whose columns are keys of the project.

use super::given::{arguments, flag, text};
use super::{AXIS, Answer, Argument, ArgumentKind, Asked, Entry, Gives, OutputFile, Reads, Record, Unanswered, media};
use crate::sizing_use::Refusal;
use crate::sweep::{Cells, Options, Sweep, SweepRow, SweepSummary, TableFaults, Tally, Wanted, csv};
use project::Files;
use quantities::{Language, seen};
use sizing::CheckId;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::Read as _;
use words::{help, help::values, sweeps, terminal};

arguments! {
    /// Which axis, which table, what is answered.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
        /// The table.
        table: Option<String> = Argument::option("table", values::file, help::sweep_table).of(ArgumentKind::File).required() => text,
        /// Every code of every row with these checks.
        check: Vec<CheckId> = Argument::option("check", values::check, help::sweep_check)
            .of(ArgumentKind::Word(|| CheckId::ALL.iter().map(|check| check.id()).collect())).repeated() => checks,
        /// The codes that no other beats.
        front: bool = Argument::flag("front", help::sweep_front) => flag,
    }
}

fn checks(given: &super::Given, argument: &Argument) -> Result<Vec<CheckId>, Unanswered> {
    let of = |id: &str| CheckId::ALL.iter().copied().find(|check| check.id() == id);
    Ok(given.all(argument.name).filter_map(of).collect())
}

/// The question.
pub const ENTRY: Entry = Entry {
    command: "sweep",
    path: "sweep",
    about: help::sweep,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<SweepSummary>("sweep")),
    writes: &[OutputFile::of("out", &[media::CSV, media::PARQUET], help::sweep_out).required()],
    example: "axis.toml --table tasks.parquet --out best.parquet",
    answer: Some(|asked| Ok(Answer::record(&found(asked)?))),
};

/// So many rows are judged where the answers are no file.
const ROWS_MOST: usize = 10_000;

/// So many bytes of a table are read there.
const BYTES_MOST: u64 = 16 << 20;

impl Args {
    /// How the table is judged.
    #[must_use]
    pub fn options(&self, language: Language) -> Options {
        let wanted = match (self.front, self.check.is_empty()) {
            (true, _) => Wanted::Front,
            (false, false) => Wanted::Every(self.check.clone()),
            (false, true) => Wanted::Best,
        };
        Options { axis: self.axis.clone(), wanted, language }
    }
}

/// The answers of a small table in CSV, as a record.
///
/// # Errors
/// Faults of the project or of the table; one that is too long.
pub fn found(asked: &Asked<'_>) -> Result<SweepSummary, Unanswered> {
    let args = Args::read(&asked.given)?;
    let language = asked.language;
    let source = asked.source()?;
    let name = args.table.clone().unwrap_or_default();
    let refused =
        |message: String, is_too_large| Unanswered::File { name: seen(&name).into_owned(), message, is_too_large };
    let mut text = String::new();
    let opened = source.files.open(&name).and_then(|file| file.take(BYTES_MOST + 1).read_to_string(&mut text));
    opened.map_err(|error| refused(words::file_trouble(&error, language), false))?;
    if text.len() as u64 > BYTES_MOST {
        return Err(refused(terminal::file_too_large(&BYTES_MOST, language), true));
    }
    let mut lines = text.lines();
    let headings = csv::cells(lines.next().unwrap_or_default().trim_start_matches('\u{feff}')).unwrap_or_default();
    let rows: Vec<&str> = lines.filter(|line| !line.trim().is_empty()).collect();
    if rows.len() > ROWS_MOST {
        return Err(Unanswered::message(sweeps::too_many_rows(&rows.len(), &ROWS_MOST, language)));
    }
    let mut columns: Vec<Vec<Option<Cow<'_, str>>>> = vec![Vec::with_capacity(rows.len()); headings.len()];
    for (line, row) in (2_usize..).zip(rows) {
        let cells = csv::cells(row).ok_or_else(|| refused(sweeps::open_quote(&line, language), false))?;
        if cells.len() != headings.len() {
            return Err(refused(sweeps::ragged(&line, &cells.len(), &headings.len(), language), false));
        }
        columns.iter_mut().zip(cells).for_each(|(column, cell)| column.push(Some(cell)));
    }
    let headings: Vec<&str> = headings.iter().map(AsRef::as_ref).collect();
    let cells: Vec<Cells<'_>> = columns.into_iter().map(Cells::Texts).collect();
    let files = Shelf::of(asked)?;
    let sweep = Sweep::new((&source.name, source.text(language)?), Box::new(files), &headings, args.options(language))
        .map_err(|why| why.of_table(&name))?;
    let mut faults = TableFaults::default();
    sweep.check(&cells, 0, &mut faults);
    faults.refuse_empty(cells.first().map_or(0, Cells::len), language);
    if !faults.is_empty() {
        return Err(Unanswered::Table { name, faults });
    }
    let answers = sweep.judge(&cells, asked.patience).map_err(|_| Unanswered::from(Refusal::Stopped))?;
    let mut tally = Tally::default();
    answers.iter().for_each(|answer| tally.add(answer));
    let rows = (0..).zip(&answers).flat_map(|(row, answer)| SweepRow::of(row, answer));
    Ok(SweepSummary { answers: rows.collect(), ..tally.summary(None, language) })
}

/// The recordings of a project, read once.
struct Shelf(BTreeMap<String, Vec<u8>>);

impl Shelf {
    fn of(asked: &Asked<'_>) -> Result<Self, Unanswered> {
        let source = asked.source()?;
        let projects = source.projects(asked.patience, asked.language)?;
        let mut found = BTreeMap::new();
        for name in projects.iter().flat_map(|project| &project.recordings).map(|read| &read.file) {
            let mut bytes = Vec::new();
            let read = source.files.open(name).and_then(|mut file| file.read_to_end(&mut bytes));
            read.map_err(|error| Unanswered::message(words::file_trouble(&error, asked.language)))?;
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

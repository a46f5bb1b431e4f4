//! Judgement of record batches.

use crate::columns::cells;
use arrow_array::cast::AsArray;
use arrow_array::types::UInt64Type;
use arrow_array::{ArrayRef, BooleanArray, Float64Array, RecordBatch, StringArray, UInt32Array, UInt64Array};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use arrow_select::take::take;
use axis::{AxisProject, Files};
use project::TabularFault;
use quantities::Language;
use quantities::unit::MILLIMETRE;
use questions::list::Unanswered;
use questions::sweep::{
    self, Answer, BEST_COLUMNS, Best, CODE, Every, Judged, MeantHeading, OnFront, Options, STAGE_RATIO, TableColumns,
    TableFaults, Wanted,
};
use questions::{CheckId, Progress, Refusal};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A project and the headings of a table, ready for record batches.
pub struct BatchSweep {
    sweep: sweep::Sweep,
    schema: SchemaRef,
    columns: TableColumns,
    /// Places of the carried columns whose texts are numbers, each with that among the keys.
    numbers: Vec<(usize, usize)>,
    /// Number of columns of the table.
    width: usize,
}

/// The head of a table before its cells are read: [`sweep::Head`] over record batches.
pub struct BatchHead {
    head: sweep::Head,
    schema: SchemaRef,
    columns: TableColumns,
    numbers: Vec<(usize, usize)>,
    width: usize,
}

/// Columns of a table that are repeated in its answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Repeats {
    /// Columns that are no keys, such as names of rows.
    #[default]
    Labels,
    /// Every column.
    Inputs,
    /// Every column, the values of keys as numbers where they are numbers, also if the table has texts.
    Values,
}

impl BatchHead {
    /// Reads a project, by its name and text, and the headings of a table for it.
    #[must_use]
    pub fn of(project: (&str, &str), files: &dyn Files, table: &Schema, repeats: Repeats, options: Options) -> Self {
        let read = |headings: &[MeantHeading], options| sweep::Head::of(project, files, headings, options);
        Self::with(project.1, table, repeats, options, read)
    }

    /// Reads the headings of a table for a project, by its text and its axes or the reason why they cannot be read.
    #[must_use]
    pub fn read(
        text: &str,
        projects: Result<Vec<AxisProject>, Unanswered>,
        table: &Schema,
        repeats: Repeats,
        options: Options,
    ) -> Self {
        let read = |headings: &[MeantHeading], options| sweep::Head::read(text, projects, headings, options);
        Self::with(text, table, repeats, options, read)
    }

    fn with(
        text: &str,
        table: &Schema,
        repeats: Repeats,
        options: Options,
        read: impl FnOnce(&[MeantHeading], Options) -> sweep::Head,
    ) -> Self {
        let (wanted, language) = (options.wanted.clone(), options.language);
        let names: Vec<&str> = table.fields().iter().map(|field| field.name().as_str()).collect();
        let mut columns = TableColumns::of(&names);
        let keys = columns.as_meant(&names, text, options.axis.as_deref());
        let mut head = read(&keys, options);
        let answers = answered(&wanted, head.chooses_ratio());
        if repeats != Repeats::Labels {
            let inputs = columns.keys.iter().filter_map(|place| Some((*place, (*names.get(*place)?).to_owned())));
            // Codes of the table are those of the answer.
            columns.carried.extend(inputs.filter(|(_, name)| name.trim() != CODE));
            columns.carried.sort();
            columns.carried.dedup();
        }
        let own: Vec<&str> = answers.fields().iter().map(|field| field.name().as_str()).collect();
        columns.faults(&own, language).for_each(|fault| head.refuse(fault));
        let is_text = |place: usize| table.fields().get(place).is_some_and(|field| field.data_type().is_string());
        let numbers: Vec<(usize, usize)> = columns
            .carried
            .iter()
            .filter(|_| repeats == Repeats::Values)
            .filter_map(|(place, _)| Some((*place, columns.keys.iter().position(|key| key == place)?)))
            .filter(|(place, key)| is_text(*place) && head.is_of_numbers(*key))
            .collect();
        let carried = columns.carried.iter().filter_map(|(place, name)| {
            let field = table.fields().get(*place)?;
            let is_number = numbers.iter().any(|(number, _)| number == place);
            let of = if is_number { DataType::Float64 } else { field.data_type().clone() };
            Some(Arc::new(Field::new(name, of, true)))
        });
        let schema = Arc::new(Schema::new(answers.fields().iter().cloned().chain(carried).collect::<Vec<_>>()));
        Self { head, schema, columns, numbers, width: table.fields().len() }
    }

    /// Refuses carried columns whose cells cannot be written to a file and read from it.
    pub fn refuse_unwritable(&mut self, table: &Schema, language: Language) {
        for (place, name) in &self.columns.carried {
            let Some(field) = table.fields().get(*place) else { continue };
            let is_written =
                field.data_type().is_numeric() || matches!(field.data_type(), DataType::Utf8 | DataType::Boolean);
            if !is_written {
                let fault = TabularFault::CellType { path: name.clone(), found: field.data_type().to_string() };
                let fault = (project::Fault::Tabular(fault), None);
                self.head.refuse(sweep::CellFault::of(name, None, &fault, language));
            }
        }
    }

    /// Checks the cells of a batch, whose first row has this number.
    pub fn check(&mut self, batch: &RecordBatch, first_row: u64) {
        self.head.check(&cells(batch, &self.columns.keys), first_row);
    }

    /// Adds the fault of a row that is not a row of the table, by its number.
    pub fn refuse_line(&mut self, fault: TabularFault, row: u64) {
        self.head.refuse_line(fault, row);
    }

    /// Returns `true` if checking the rest of the table is pointless, because there are so many faults already.
    #[must_use]
    pub const fn is_enough(&self) -> bool {
        self.head.is_enough()
    }

    /// Adds the fault of a table without rows, if it has none.
    pub fn refuse_empty(&mut self, rows: u64) {
        self.head.refuse_empty(rows);
    }

    /// Returns the sweep over tables with these headings.
    ///
    /// # Errors
    /// Every fault of the project, of the headings and of the checked cells; `table` is the name of the table.
    pub fn ready(self, table: &str, files: Box<dyn Files + Send + Sync>) -> Result<BatchSweep, Unanswered> {
        let Self { head, schema, columns, numbers, width } = self;
        Ok(BatchSweep { sweep: head.ready(table, files)?, schema, columns, numbers, width })
    }
}

impl BatchSweep {
    /// Returns the columns of the answer.
    #[must_use]
    pub fn schema(&self) -> SchemaRef {
        Arc::clone(&self.schema)
    }

    /// Returns the keys of the headings in their order, entries of lists counted from one.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        self.sweep.keys()
    }

    /// Returns the judging of the rows, without the columns of the batches.
    #[must_use]
    pub const fn sweep(&self) -> &sweep::Sweep {
        &self.sweep
    }

    /// Returns the names of the columns that are repeated in the answer.
    pub fn carried(&self) -> impl Iterator<Item = &str> {
        self.columns.carried.iter().map(|(_, name)| name.as_str())
    }

    /// Returns the number of columns of its tables.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width
    }

    /// Returns the text of the project.
    #[must_use]
    pub fn text(&self) -> &str {
        self.sweep.text()
    }

    /// Returns the recordings that the project and the checked cells name, in order.
    #[must_use]
    pub const fn recordings(&self) -> &BTreeSet<String> {
        self.sweep.recordings()
    }

    /// Returns the number of rows, at most `most`, whose answers are held at once: they take a quarter of the memory, with a line
    /// for each code, a value for each column and 64 bytes for each value.
    #[must_use]
    pub fn rows_within(&self, memory: u64, most: usize) -> usize {
        let of_row = self.sweep.lines_of_row() * self.schema.fields().len() * BYTES_OF_VALUE;
        usize::try_from(memory / 4).unwrap_or(usize::MAX).div_euclid(of_row.max(1)).clamp(1, most.max(1))
    }

    /// Returns the largest number of rows whose answers fit into the memory as one table, at least one: a line for each code, a value
    /// for each column and 24 bytes for each value.
    #[must_use]
    pub fn rows_held(&self, memory: u64) -> u64 {
        let of_row = self.sweep.lines_of_row() * self.schema.fields().len() * BYTES_HELD;
        (memory / of_row.max(1) as u64).max(1)
    }

    /// Returns the answers of a whole table, whose first row has this number. Rows are judged in parts of
    /// [`rows_within`](Self::rows_within), and before the first of them their number is compared with
    /// [`rows_held`](Self::rows_held).
    ///
    /// # Errors
    /// More rows than the memory holds answers of; [`Refusal::Stopped`] after a cancellation.
    pub fn whole(
        &self,
        batches: &[RecordBatch],
        first_row: u64,
        memory: u64,
        progress: &Progress,
    ) -> Result<Vec<RecordBatch>, Unanswered> {
        let rows: u64 = batches.iter().map(|batch| batch.num_rows() as u64).sum();
        let most = self.rows_held(memory);
        if rows > most {
            let language = self.sweep.options().language;
            return Err(Unanswered::message(words::sweeps::answers_too_large(&rows, &(memory >> 20), &most, language)));
        }
        let part = self.rows_within(memory, ROWS_OF_PART);
        let mut first_row = first_row;
        let mut answers = Vec::new();
        for batch in batches {
            for from in (0..batch.num_rows()).step_by(part) {
                let rows = batch.slice(from, part.min(batch.num_rows() - from));
                answers.push(self.batch(&rows, first_row, progress)?);
                first_row += rows.num_rows() as u64;
            }
        }
        Ok(answers)
    }

    /// Adds every fault of the cells of a batch, whose first row has this number.
    pub fn check(&self, batch: &RecordBatch, first_row: u64, faults: &mut TableFaults) {
        self.sweep.check(&cells(batch, &self.columns.keys), first_row, faults);
    }

    /// Returns the answers of a batch, whose first row has this number; a row that cannot be judged has the reason as
    /// its answer.
    ///
    /// # Errors
    /// [`Refusal::Stopped`] after a cancellation.
    pub fn batch(&self, batch: &RecordBatch, first_row: u64, progress: &Progress) -> Result<RecordBatch, Unanswered> {
        let cells = cells(batch, &self.columns.keys);
        let answers = self.sweep.judge(&cells, progress).map_err(Refusal::from)?;
        let mut columns = match &self.sweep.options().wanted {
            Wanted::Best => best(&answers, first_row),
            Wanted::Every(checks) => every(&answers, first_row, checks),
            Wanted::Front => front(&answers, first_row),
        };
        if self.schema.field_with_name(STAGE_RATIO).is_ok() {
            columns.push(Arc::new(stage_ratios(&answers)));
        }
        if let Some(codes) = self.sweep.codes_of_rows(&cells) {
            with_codes(&mut columns, &codes, first_row);
        }
        let broken = |error: arrow_schema::ArrowError| Unanswered::message(error.to_string());
        if !self.columns.carried.is_empty() {
            // An answer has several lines for a row.
            let rows = columns.first().and_then(|rows| rows.as_primitive_opt::<UInt64Type>().cloned());
            let rows: UInt64Array = rows.iter().flatten().map(|row| row.map(|row| row - first_row)).collect();
            for place in self.columns.carried.iter().map(|(place, _)| *place) {
                let of_key = self.numbers.iter().find(|(number, _)| *number == place).map(|(_, key)| *key);
                let values = of_key.and_then(|key| Some(self.sweep.column_numbers(key, cells.get(key)?)));
                let numbers = values.map(|values| Arc::new(Float64Array::from(values)) as ArrayRef);
                let Some(column) = numbers.as_ref().or_else(|| batch.columns().get(place)) else { continue };
                columns.push(take(column, &rows, None).map_err(broken)?);
            }
        }
        RecordBatch::try_new(self.schema(), columns).map_err(broken)
    }
}

/// Enters the code that a row states where its answer has none: a row that cannot be judged.
fn with_codes(columns: &mut [ArrayRef], codes: &[Option<String>], first_row: u64) {
    let rows: Vec<u64> = columns
        .first()
        .and_then(|rows| rows.as_primitive_opt::<UInt64Type>())
        .map(|rows| rows.values().to_vec())
        .unwrap_or_default();
    let Some(column) = columns.iter_mut().skip(1).find(|column| column.as_string_opt::<i32>().is_some()) else {
        return;
    };
    let filled = column.as_string_opt::<i32>().map(|known| {
        let stated = |row: &u64| codes.get(usize::try_from(row - first_row).ok()?)?.as_deref();
        known.iter().zip(&rows).map(|(code, row)| code.or_else(|| stated(row))).collect::<StringArray>()
    });
    if let Some(filled) = filled {
        *column = Arc::new(filled);
    }
}

/// Memory of a value in an answer \[byte\]: in the judgement of its row, in a column of the batch and in the bytes of a part.
/// Measured: 50 for verdict and utilisation of 36 checks.
const BYTES_OF_VALUE: usize = 64;

/// Memory of a value in an answer that is kept \[byte\]: in a column of the batch, whose texts grow by doubling.
const BYTES_HELD: usize = 24;

/// Largest number of rows that are judged at once for a whole table.
const ROWS_OF_PART: usize = 1 << 14;

/// Returns the columns of the answers: that of the ratio of a stage only if each row chooses one among several.
fn answered(wanted: &Wanted, chooses_ratio: bool) -> SchemaRef {
    let field = |name: &str, of: DataType| Field::new(name, of, true);
    let row = Field::new("row", DataType::UInt64, false);
    let (code, error) = (field("code", DataType::Utf8), field("error", DataType::Utf8));
    let share = |name: &str| field(name, DataType::Float64);
    let tightest = field("tightest", DataType::Utf8);
    let verdict = field("verdict", DataType::Utf8);
    let mut fields: Vec<Field> = match wanted {
        Wanted::Best => {
            let [_, fit, .., fit_if_estimate] = BEST_COLUMNS;
            let [fit, fit_if_estimate] = [fit, fit_if_estimate].map(|name| field(name, DataType::UInt32));
            vec![row, fit, code, share("utilisation"), tightest, error, fit_if_estimate]
        }
        Wanted::Every(checks) => {
            let each = checks.iter().flat_map(|check| {
                [
                    field(&format!("{}.verdict", check.id()), DataType::Utf8),
                    share(&format!("{}.utilisation", check.id())),
                ]
            });
            let first = [row, code, field("fits", DataType::Boolean), share("utilisation"), tightest];
            first.into_iter().chain(each).chain([error, verdict]).collect()
        }
        Wanted::Front => {
            let figures = [share("mass [kg]"), share("length [mm]"), share("utilisation")];
            let errata = field("errata", DataType::Utf8);
            [row, code].into_iter().chain(figures).chain([tightest, error, verdict, errata]).collect()
        }
    };
    fields.extend(chooses_ratio.then(|| share(STAGE_RATIO)));
    Arc::new(Schema::new(fields))
}

fn texts<T: AsRef<str>>(cells: impl Iterator<Item = Option<T>>) -> ArrayRef {
    Arc::new(cells.collect::<StringArray>())
}

fn best(answers: &[Answer], first_row: u64) -> Vec<ArrayRef> {
    fn of(answer: &Answer) -> Option<&Best> {
        match answer {
            Ok(Judged::Best(best)) => Some(best),
            Ok(Judged::Every(_) | Judged::Front(_)) | Err(_) => None,
        }
    }
    let found: Vec<Option<&Best>> = answers.iter().map(of).collect();
    let each = || found.iter().copied();
    vec![
        Arc::new((first_row..).take(answers.len()).collect::<UInt64Array>()),
        Arc::new(each().map(|best| Some(best?.fit)).collect::<UInt32Array>()),
        texts(each().map(|best| Some(best?.code.as_ref()?.to_string()))),
        Arc::new(each().map(|best| best?.utilisation).collect::<Float64Array>()),
        texts(each().map(|best| Some(best?.tightest?.id()))),
        texts(answers.iter().map(|answer| answer.as_ref().err())),
        Arc::new(each().map(|best| Some(best?.fit_if_estimate)).collect::<UInt32Array>()),
    ]
}

/// Returns the ratio of the stage of each line of the answers.
fn stage_ratios(answers: &[Answer]) -> Float64Array {
    let of = |answer: &Answer| match answer {
        Ok(Judged::Best(best)) => vec![best.stage_ratio],
        Ok(Judged::Every(every)) => every.iter().map(|one| one.stage_ratio).collect(),
        Ok(Judged::Front(front)) => front.iter().map(|one| one.stage_ratio).collect(),
        Err(_) => vec![None],
    };
    answers.iter().flat_map(of).collect()
}

/// Answers of the rows by row number, or the reason of a row without one.
type Lines<'a, T> = Vec<(u64, Result<&'a T, &'a String>)>;

fn lines<'a, T>(answers: &'a [Answer], first_row: u64, of: impl Fn(&'a Judged) -> &'a [T]) -> Lines<'a, T> {
    let mut lines: Lines<'a, T> = Vec::new();
    for (row, answer) in (first_row..).zip(answers) {
        match answer {
            Ok(judged) => lines.extend(of(judged).iter().map(|each| (row, Ok(each)))),
            Err(why) => lines.push((row, Err(why))),
        }
    }
    lines
}

fn every(answers: &[Answer], first_row: u64, checks: &[CheckId]) -> Vec<ArrayRef> {
    let lines = lines(answers, first_row, |judged| match judged {
        Judged::Every(every) => every.as_slice(),
        Judged::Best(_) | Judged::Front(_) => &[],
    });
    let each = || lines.iter().map(|(_, line)| line.as_ref().ok().copied());
    let mut columns: Vec<ArrayRef> = vec![
        Arc::new(lines.iter().map(|(row, _)| *row).collect::<UInt64Array>()),
        texts(each().map(|line| Some(line?.code.to_string()))),
        Arc::new(each().map(|line| Some(line?.fit.fits())).collect::<BooleanArray>()),
        Arc::new(each().map(|line| line?.utilisation).collect::<Float64Array>()),
        texts(each().map(|line| Some(line?.tightest?.id()))),
    ];
    for place in 0..checks.len() {
        let check = |line: Option<&Every>| line?.checks.get(place).copied().flatten();
        columns.push(texts(each().map(|line| Some(check(line)?.0.id()))));
        columns.push(Arc::new(each().map(|line| check(line)?.1).collect::<Float64Array>()));
    }
    columns.push(texts(lines.iter().map(|(_, line)| line.as_ref().err())));
    columns.push(texts(each().map(|line| Some(line?.fit.id()))));
    columns
}

fn front(answers: &[Answer], first_row: u64) -> Vec<ArrayRef> {
    let lines = lines(answers, first_row, |judged| match judged {
        Judged::Front(front) => front.as_slice(),
        Judged::Best(_) | Judged::Every(_) => &[],
    });
    let each = || lines.iter().map(|(_, line): &(u64, Result<&OnFront, _>)| line.as_ref().ok().copied());
    vec![
        Arc::new(lines.iter().map(|(row, _)| *row).collect::<UInt64Array>()),
        texts(each().map(|line| Some(line?.code.to_string()))),
        Arc::new(each().map(|line| line?.mass_kg).collect::<Float64Array>()),
        Arc::new(each().map(|line| Some(MILLIMETRE.from_si(line?.length_m?))).collect::<Float64Array>()),
        Arc::new(each().map(|line| Some(line?.utilisation)).collect::<Float64Array>()),
        texts(each().map(|line| Some(line?.tightest?.id()))),
        texts(lines.iter().map(|(_, line)| line.as_ref().err())),
        texts(each().map(|line| Some(line?.fit.id()))),
        texts(each().map(|line| Some(line?.errata.concat().join(";")).filter(|errata| !errata.is_empty()))),
    ]
}

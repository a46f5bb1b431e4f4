//! Sweeps as calls from Python.

use crate::SourceText;
use arrow_array::RecordBatch;
use arrow_schema::Schema;
use quantities::Language;
use questions::embedded_catalogue;
use questions::list::sweep::{Args, ENTRY};
use questions::list::{Argument, Given, Reads, Unanswered};
use std::borrow::Cow;
use sweep_io::{BatchHead, BatchSweep, Repeats, TableFaults};

/// Argument that is passed as a value and not by name.
const TABLE: &str = "table";

/// A sweep, with the parts that are read once for all rows.
#[derive(Clone, Debug)]
pub struct SweepCall {
    /// Project.
    pub text: SourceText,
    /// Names and values of the options: those of the question `sweep` except its table.
    pub pairs: Vec<(String, String)>,
    /// Limit of the memory for recordings and answers, as written.
    pub memory: Option<String>,
    /// Columns of the table that the answer repeats.
    pub repeats: Repeats,
    /// Language of the texts.
    pub language: Language,
}

impl SweepCall {
    /// Returns the limit of the memory for recordings and answers \[byte\].
    ///
    /// # Errors
    /// A limit that cannot be read or is out of range.
    pub fn memory_allowed(&self) -> Result<u64, Unanswered> {
        antrieb::memory_allowed(self.memory.clone(), self.language)
    }

    /// Returns the sweep over tables of these columns. The cells of `batches` are checked too; it holds all batches of
    /// a table, or none.
    ///
    /// # Errors
    /// Every fault of the options; else every fault of the project, of the headings and of the cells.
    pub fn prepared(&self, table: &Schema, batches: &[RecordBatch]) -> Result<BatchSweep, Unanswered> {
        let pairs = self.pairs.iter().map(|(name, value)| (Cow::Borrowed(name.as_str()), value.as_str().into()));
        let arguments = ENTRY.arguments.iter().copied().filter(|argument| argument.name != TABLE);
        let given = Given::of(&arguments.collect::<Vec<Argument>>(), pairs, self.language)?;
        let options = Args::read(&given)?.options(
            embedded_catalogue(),
            questions::sweep::Options::default().commas,
            self.language,
        )?;
        let file = self.text.read(Reads::Project, self.memory_allowed()?, self.language)?;
        let source = file.source();
        let text = source.text(self.language)?;
        let files = Box::new(file.files.clone());
        let mut head = BatchHead::of((&source.name, text), &*files, table, self.repeats, options);
        numbered(batches).for_each(|(batch, first_row)| head.check(batch, first_row));
        head.ready(TABLE, files)
    }
}

/// Returns the batches, each with the number of its first row.
fn numbered(batches: &[RecordBatch]) -> impl Iterator<Item = (&RecordBatch, u64)> {
    batches.iter().scan(0, |next, batch| {
        let first = *next;
        *next += batch.num_rows() as u64;
        Some((batch, first))
    })
}

/// Checks the cells of a table for a prepared sweep.
///
/// # Errors
/// Every fault of the cells.
pub fn checked(sweep: &BatchSweep, batches: &[RecordBatch]) -> Result<(), Unanswered> {
    let mut faults = TableFaults::default();
    numbered(batches).for_each(|(batch, first_row)| sweep.check(batch, first_row, &mut faults));
    if faults.is_empty() { Ok(()) } else { Err(Unanswered::Table { name: TABLE.into(), faults }) }
}

//! Sweeps as calls from Python put them.

use crate::Text;
use arrow_array::RecordBatch;
use arrow_schema::Schema;
use quantities::Language;
use questions::Patience;
use questions::list::sweep::{Args, ENTRY};
use questions::list::{Argument, Given, Unanswered};
use std::borrow::Cow;
use sweep_io::{Head, Sweep, TableFaults};

/// The argument that is handed over as it is, not named.
const TABLE: &str = "table";

/// A sweep that is put: what is read once for all rows.
#[derive(Clone, Debug)]
pub struct SweepCall {
    /// The project.
    pub text: Text,
    /// Names and values of the options: those of the question `sweep` but its table.
    pub pairs: Vec<(String, String)>,
    /// How much memory recordings may take, as it is written.
    pub memory: Option<String>,
    /// The language of the texts.
    pub language: Language,
}

impl SweepCall {
    /// The sweep over tables of these columns; what stands in the cells of `batches`, all or none of one, is checked too.
    ///
    /// # Errors
    /// Every fault of the options; else every fault of the project, of the headings and of the cells.
    pub fn prepared(&self, table: &Schema, batches: &[RecordBatch]) -> Result<Sweep, Unanswered> {
        let pairs = self.pairs.iter().map(|(name, value)| (Cow::Borrowed(name.as_str()), value.as_str().into()));
        let arguments = ENTRY.arguments.iter().copied().filter(|argument| argument.name != TABLE);
        let given = Given::of(&arguments.collect::<Vec<Argument>>(), pairs, self.language)?;
        let options = Args::read(&given)?.options(false, self.language)?;
        let memory = antrieb::memory_allowed(self.memory.clone(), self.language)?;
        let file = self.text.read(memory, self.language)?;
        let source = file.source();
        let text = source.text(self.language)?;
        let files = Box::new(file.beside().clone());
        let mut head = Head::of((&source.name, text), &*files, table, options);
        numbered(batches).for_each(|(batch, first_row)| head.check(batch, first_row));
        head.ready(TABLE, files)
    }
}

/// Each batch with the number of its first row.
fn numbered(batches: &[RecordBatch]) -> impl Iterator<Item = (&RecordBatch, u64)> {
    batches.iter().scan(0, |next, batch| {
        let first = *next;
        *next += batch.num_rows() as u64;
        Some((batch, first))
    })
}

/// The faults of the cells of a table whose sweep is prepared already.
///
/// # Errors
/// All of them.
pub fn checked(sweep: &Sweep, batches: &[RecordBatch]) -> Result<(), Unanswered> {
    let mut faults = TableFaults::default();
    numbered(batches).for_each(|(batch, first_row)| sweep.check(batch, first_row, &mut faults));
    if faults.is_empty() { Ok(()) } else { Err(Unanswered::Table { name: TABLE.into(), faults }) }
}

/// The answers to all batches of a table whose cells are checked.
///
/// # Errors
/// A cancelled `patience`.
pub fn swept(sweep: &Sweep, batches: &[RecordBatch], patience: &Patience) -> Result<Vec<RecordBatch>, Unanswered> {
    numbered(batches).map(|(batch, first_row)| sweep.batch(batch, first_row, patience)).collect()
}

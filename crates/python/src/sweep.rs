//! Sweeps as calls from Python put them.

use crate::Text;
use arrow_array::RecordBatch;
use arrow_schema::Schema;
use quantities::Language;
use questions::Patience;
use questions::list::sweep::{Args, ENTRY};
use questions::list::{Argument, Given, Unanswered};
use std::borrow::Cow;
use sweep_io::{Sweep, TableFaults};

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
    /// The sweep over tables of these columns.
    ///
    /// # Errors
    /// Every fault of the options; those of the project; those of the headings.
    pub fn prepared(&self, table: &Schema) -> Result<Sweep, Unanswered> {
        let pairs = self.pairs.iter().map(|(name, value)| (Cow::Borrowed(name.as_str()), value.as_str().into()));
        let arguments = ENTRY.arguments.iter().copied().filter(|argument| argument.name != TABLE);
        let given = Given::of(&arguments.collect::<Vec<Argument>>(), pairs, self.language)?;
        let options = Args::read(&given)?.options(self.language);
        let memory = antrieb::memory_allowed(self.memory.clone(), self.language)?;
        let file = self.text.read(memory, self.language)?;
        let source = file.source();
        let text = source.text(self.language)?;
        Sweep::new((&source.name, text), Box::new(file.beside().clone()), table, options)
    }
}

/// The answers to all batches of a table.
///
/// # Errors
/// Every fault of the cells, before any row is judged; a cancelled `patience`.
pub fn swept(sweep: &Sweep, batches: &[RecordBatch], patience: &Patience) -> Result<Vec<RecordBatch>, Unanswered> {
    let mut first_row = 0;
    let numbered: Vec<(&RecordBatch, u64)> = batches
        .iter()
        .map(|batch| {
            let first = first_row;
            first_row += batch.num_rows() as u64;
            (batch, first)
        })
        .collect();
    let mut faults = TableFaults::default();
    for (batch, first) in &numbered {
        sweep.check(batch, *first, &mut faults);
    }
    if !faults.is_empty() {
        return Err(Unanswered::Table { name: TABLE.into(), faults });
    }
    numbered.iter().map(|(batch, first)| sweep.batch(batch, *first, patience)).collect()
}

//! Many axes as Arrow and as files: a table in, a table out.
//!
//! [`BatchSweep`] is [`questions::sweep`] over record batches; it computes nothing itself.

mod batch;
mod columns;
mod constants;
mod files;
mod tally;

pub use batch::{BatchHead, BatchSweep, Repeats};
pub use constants::Constants;
pub use files::{Answers, Batches, Decimal, Format, NoBatch, part};
pub use questions::sweep::{CODE, CellFault, Options, TableFaults, Wanted};
pub use tally::count;

//! Many axes as Arrow and as files: a table in, a table out.
//!
//! [`Sweep`] is [`questions::sweep`] over record batches; it computes nothing itself.

mod batch;
mod columns;
mod files;
mod tally;

pub use batch::{Head, Sweep};
pub use files::{Answers, Batches, Format, Unread, part};
pub use questions::sweep::{CODE, CellFault, Options, TableFaults, Wanted};
pub use tally::count;

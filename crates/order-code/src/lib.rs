//! The grammar of the ordering code: `CHA-20A-100-H-C1024-B-EC-K-SP`.
//!
//! This crate reads and prints codes and says where a text departs from the grammar. What may be combined with what is
//! a matter of the ordering tables and of another crate.

mod error;
mod field;
mod parse;
mod pattern;

pub use error::{CodeError, CodeErrors};
pub use field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
pub use parse::{Departure, Parsed, parse};
pub use pattern::{Pattern, Slot};

/// Number of letters to insert, delete, change or swap to turn one text into the other; case does not count.
#[must_use]
pub fn edit_distance(a: &str, b: &str) -> usize {
    strsim::damerau_levenshtein(&a.to_uppercase(), &b.to_uppercase())
}

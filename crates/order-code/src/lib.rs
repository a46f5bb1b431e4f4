//! Grammar of ordering codes such as `CHA-20A-100-H-C1024-B-EC-K-SP`.
//!
//! Parses and prints codes and reports where a text departs from the grammar. The crate knows the words and their order
//! only: permitted combinations are in the tables of the manual and read by another crate, so `CHA-14A-160-L-C1024` is
//! a code here although it cannot be ordered.
//!
//! ```
//! use order_code::{Pattern, parse};
//!
//! let parsed = parse("cha 20a-100-HC1024")?;
//! assert_eq!(parsed.code.to_string(), "CHA-20A-100-H-C1024");
//! assert_eq!(parsed.code.size.as_str(), "20A");
//! assert!(!parsed.is_canonical());
//!
//! let faults = parse("CHA-21A-100-H-C1025").unwrap_err();
//! let hints: Vec<_> = faults.iter().map(|fault| (fault.span(), fault.nearest())).collect();
//! assert_eq!(hints, [(4..7, Some("20A")), (14..19, Some("C1024"))]);
//!
//! let pattern = Pattern::parse("CHA-*-100-H-*")?;
//! assert!(pattern.matches(&parsed.code));
//! # Ok::<(), order_code::CodeErrors>(())
//! ```
//!
//! # Grammar
//!
//! The words of each series, their order and their meanings are data: `code.toml` in its folder of `data/`. A value
//! such as a [`Size`] is the index of a word within its series; a code is read in the grammar of the series whose word
//! it begins with.
//!
//! The canonical spelling has capitals and one `-` between the words. Lower case, other dashes, spaces around or
//! instead of a hyphen, missing hyphens and surrounding white space are understood and reported as a [`Departure`].
//! Everything else is a fault: no text is replaced by a similar word.
//!
//! A text without hyphens has one reading: at each position no word is the beginning of another, except that option 2
//! `S` begins `SP`, and no word is the remaining `P`. The tests check this for all codes; a second reading would be an
//! error ([`CodeError::Ambiguous`]), not a guess.

mod departure;
mod error;
mod field;
mod grammar;
mod parse;
mod pattern;
mod scan;
mod tokens;

pub use departure::Departure;
pub use error::{CodeError, CodeErrors, Expected};
pub use field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
pub use grammar::{FEEDBACKS, FeedbackKind, FieldWords, Grammar, Meaning, OPTIONS_1, OPTIONS_2, Series, extend};
pub use parse::{Parsed, Spans, parse};
pub use pattern::{Pattern, Slot};

//! The grammar of the ordering code: `CHA-20A-100-H-C1024-B-EC-K-SP`.
//!
//! This crate reads and prints codes and says where a text departs from the grammar. It knows the words and their order
//! and nothing else: what may be combined stands in the tables of a manual and is read by another crate, so
//! `CHA-14A-160-L-C1024` is a code here although it cannot be ordered.
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
//! The words of each series, their order and what they mean are data: `code.toml` in its folder of `data/`. A value such as a
//! [`Size`] is a place among the words of its series, and a code is read in the grammar of the series whose word it begins with.
//!
//! Canonical are capitals with one `-` between the words. Understood, and reported as a [`Departure`], are small letters,
//! other dashes, spaces around or instead of a hyphen, no hyphen at all, and white space around the whole. Everything
//! else is a fault: nothing is ever taken for a word that it is not.
//!
//! A text without hyphens can be read in one way only, whichever words it holds: at each place no word begins with
//! another, except that option 2 `S` begins `SP`, and no word is the `P` that would be left. The tests walk all codes to
//! hold this, and a second reading would be an error ([`CodeError::Ambiguous`]), not a guess.

mod error;
mod field;
mod grammar;
mod parse;
mod pattern;
mod scan;
mod tokens;

pub use error::{CodeError, CodeErrors, Expected};
pub use field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
pub use grammar::{FEEDBACKS, FeedbackKind, FieldWords, Grammar, Meaning, OPTIONS_1, OPTIONS_2, Series, extend};
pub use parse::{Departure, Parsed, Spans, parse};
pub use pattern::{Pattern, Slot};

//! The grammar of the ordering code: `CHA-20A-100-H-C1024-B-EC-K-SP`.
//!
//! This crate reads and prints codes and says where a text departs from the grammar. It knows the words and their order
//! and nothing else: what may be combined is a matter of cha-manual table 12.1 and of another crate, so
//! `CHA-14A-160-L-C1024` is a code here though nobody can order it.
//!
//! ```
//! use order_code::{Feedback, Pattern, Size, parse};
//!
//! let parsed = parse("cha 20a-100-HC1024")?;
//! assert_eq!(parsed.code.to_string(), "CHA-20A-100-H-C1024");
//! assert_eq!(parsed.code.size, Size::S20A);
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
//! | field | words | source |
//! |---|---|---|
//! | series | `CHA` | cha-manual table 11.1 |
//! | size and version | `14A` `17A` `20A` `25A` `32A` `40A` `50A` `58A` | table 11.1 |
//! | ratio | `30` `50` `80` `100` `120` `160` | table 11.1 |
//! | winding and connectors | `E` `H` `N` and `L` | tables 11.2, 11.3; `L` table 12.1 only |
//! | feedback | `C1024` `M512P` `RES` `D2048` `M128S` | table 11.4 |
//! | brake, may be absent | `B` | table 11.1 |
//! | option 1, may be absent | `EC` | table 11.5 |
//! | option 2, may be absent | `K` `R` `S` | table 11.6 |
//! | special design, may be absent | `SP` | table 11.1 |
//!
//! Canonical are capitals with one `-` between the words. Understood, and reported as a [`Departure`], are small letters,
//! other dashes, spaces around or instead of a hyphen, no hyphen at all, and white space around the whole. Everything
//! else is a fault: nothing is ever taken for a word that it is not.
//!
//! A text without hyphens can be read in one way only, whichever words it holds: at each place no word begins with
//! another, except that option 2 `S` begins `SP`, and no word is the `P` that would be left. The tests walk all codes to
//! hold this, and a second reading would be an error ([`CodeError::Ambiguous`]), not a guess.

mod distance;
mod error;
mod field;
mod parse;
mod pattern;
mod scan;
mod tokens;

pub use distance::{Distances, Texts, edit_distance};
pub use error::{CodeError, CodeErrors};
pub use field::{Brake, Feedback, Field, Option1, Option2, OrderCode, Ratio, Size, Winding};
pub use parse::{Departure, Parsed, Spans, parse};
pub use pattern::{Pattern, Slot};

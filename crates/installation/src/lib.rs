//! From the ordering code to the running machine: wiring, joints and fits, commissioning values, upkeep.
//!
//! Each module answers one question about one ordering code with plain data that carry their sources. This crate speaks no
//! language and opens no file; `words` says what its identifiers mean.

pub mod calendar;
pub mod commission;
pub mod encoder;
pub mod facts;
pub mod fit;
pub mod joint;
pub mod mount;
pub mod upkeep;
pub mod wiring;

//! Installation of an actuator by its ordering code: wiring, joints and fits, commissioning values, maintenance.
//!
//! Each module answers one question about one ordering code with plain data and their sources. The crate has no
//! language and opens no file; `words` has the texts of its identifiers.

pub mod calendar;
pub mod commission;
pub mod encoder;
pub mod facts;
pub mod fit;
pub mod joint;
pub mod mount;
pub mod upkeep;
pub mod wiring;

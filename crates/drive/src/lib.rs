//! A virtual drive: the twin with the object dictionary of CiA 402.
//!
//! [`Drive`] has the state machine, the modes and the objects of a drive and steps its twin; [`mod@line`] and [`can`]
//! are its two protocols as pure functions of text and frames. The crate has no socket, no clock and no language: the
//! caller transports the data and determines the time.

mod abort;
pub mod can;
mod course;
mod dictionary;
mod drive;
mod given;
pub mod line;
mod mode;
mod pdo;
mod profile;
mod scale;
mod sdo;
pub mod socketcand;
mod state;
mod trouble;

pub use abort::Abort;
pub use dictionary::{Access, Address, Entry, Value, parts};
pub use drive::{Drive, HALF_MS_S};
pub use given::Given;
pub use installation::commission::cia402::DataType;
pub use state::{Command, State, Transition, transition};
pub use trouble::Trouble;

//! The web workbench over HTTP, on this machine.
//!
//! `page` answers; this crate is the transport. It listens on the loopback by default and requires a token; it
//! limits requests in size, time and number, rejects requests from other sites, opens and writes files in
//! one folder only, and shuts down gracefully. It sends no requests itself and logs none.

mod answer;
mod body;
mod folder;
mod gate;
mod limits;
mod pack;
mod serve;
mod token;

pub use limits::Limits;
pub use serve::{Access, Options, Server, Unserved};

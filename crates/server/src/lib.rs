//! The web workbench over HTTP, on this machine.
//!
//! `page` answers; this crate carries. It listens on the loopback unless it is told otherwise, and then asks for a token; it
//! holds every request to bounds of size, time and number, takes none that another site sends, opens and writes files in
//! one folder only, and ends in good order. Nothing here asks for anything on the network, and nothing is written down of
//! what is asked.

mod answer;
mod body;
mod folder;
mod gate;
mod limits;
mod serve;
mod token;

pub use limits::Limits;
pub use serve::{Options, Server, Unserved};

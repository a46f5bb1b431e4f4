//! The web workbench over HTTP, on this machine.
//!
//! `page` answers; this crate is the transport. It listens on the loopback by default and requires a token; it limits
//! requests in size, time and number, rejects requests from other sites, opens and writes files in one folder only, and
//! shuts down gracefully. It sends no requests itself and logs none. [`DriveServer`] is the transport of the virtual
//! drive, on the loopback only.

mod answer;
mod body;
mod drive;
mod folder;
mod gate;
mod idle;
mod lanes;
mod limits;
mod owner;
mod pack;
mod serve;
mod token;

pub use drive::{CLIENTS_MOST, DriveProtocol, DriveServer};
pub use limits::RequestLimits;
pub use serve::{Access, Options, Server, Unserved};

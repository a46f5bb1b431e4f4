//! The fuzz targets: functions that accept any bytes and test antrieb's promises on the input made from them.
//!
//! The bytes are choices, not the input itself: [`draft`] makes a mostly valid project of them, [`recorded`] a
//! recording, [`text`] an edited text. Thus an engine that changes bytes moves from one valid project to another. A
//! target is independent of the engine; `main.rs` runs it under libFuzzer, and `tests/` replays the corpora without an
//! engine.

use std::sync::atomic::AtomicU64;

pub mod axis;
pub mod code;
pub mod draft;
pub mod encoder;
pub mod packed;
pub mod project;
pub mod quantity;
pub mod recorded;
pub mod request;
pub mod run;
pub mod table;
pub mod text;

/// Number of cases that passed the first gate of their target: the footer for Parquet; the others have none.
pub static PAST_THE_GATE: AtomicU64 = AtomicU64::new(0);

/// A fuzz target.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Name of the target, and of its folders under `corpus` and `crashes`.
    pub name: &'static str,
    /// Function that tests one case and panics if a promise is broken.
    pub run: fn(&[u8]),
    /// Function that returns a readable form of a case.
    pub shown: fn(&[u8]) -> String,
}

/// The targets; `xtask/src/fuzz.rs` has their limits.
pub const TARGETS: [Target; 11] = [
    Target { name: "code", run: code::run, shown: code::shown },
    Target { name: "encoder", run: encoder::run, shown: encoder::shown },
    Target { name: "quantity", run: quantity::run, shown: quantity::shown },
    Target { name: "project", run: project::run, shown: project::shown },
    Target { name: "csv", run: recorded::csv, shown: recorded::shown_csv },
    Target { name: "parquet", run: recorded::parquet, shown: recorded::shown_parquet },
    Target { name: "packed", run: packed::run, shown: packed::shown },
    Target { name: "run", run: run::run, shown: run::shown },
    Target { name: "table", run: table::run, shown: table::shown },
    Target { name: "axis", run: axis::run, shown: axis::shown },
    Target { name: "request", run: request::run, shown: request::shown },
];

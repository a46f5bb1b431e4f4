//! The fuzz targets: functions that take any bytes and hold what is made of them to what antrieb promises.
//!
//! The bytes are choices, not the input itself: [`draft`] makes a project of them that is mostly valid, [`recorded`] a
//! recording, [`text`] an edited text. So an engine that changes bytes goes from one valid project to another.
//! A target knows no engine; `main.rs` puts it under libFuzzer, and `tests/` replays the corpora without one.

use std::sync::atomic::AtomicU64;

pub mod axis;
pub mod code;
pub mod draft;
pub mod encoder;
pub mod project;
pub mod quantity;
pub mod recorded;
pub mod request;
pub mod text;

/// How many cases got past the first gate of their target: for Parquet the footer. Others have none.
pub static PAST_THE_GATE: AtomicU64 = AtomicU64::new(0);

/// A fuzz target.
#[derive(Clone, Copy, Debug)]
pub struct Target {
    /// Its name, and that of its folders under `corpus` and `crashes`.
    pub name: &'static str,
    /// Holds one case to its promises; a promise that is broken panics.
    pub run: fn(&[u8]),
    /// What a case is, for people.
    pub shown: fn(&[u8]) -> String,
}

/// Every target; `xtask/src/fuzz.rs` has their limits.
pub const TARGETS: [Target; 8] = [
    Target { name: "code", run: code::run, shown: code::shown },
    Target { name: "encoder", run: encoder::run, shown: encoder::shown },
    Target { name: "quantity", run: quantity::run, shown: quantity::shown },
    Target { name: "project", run: project::run, shown: project::shown },
    Target { name: "csv", run: recorded::csv, shown: recorded::shown_csv },
    Target { name: "parquet", run: recorded::parquet, shown: recorded::shown_parquet },
    Target { name: "axis", run: axis::run, shown: axis::shown },
    Target { name: "request", run: request::run, shown: request::shown },
];

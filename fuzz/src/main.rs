//! One fuzz target under libFuzzer, named by `ANTRIEB_FUZZ_TARGET`. `cargo xtask fuzz` builds and starts this program.
#![no_main]

use fuzz::PAST_THE_GATE;
use std::alloc::System;
use std::io::Write as _;
use std::sync::OnceLock;
use std::sync::atomic::Ordering;

/// Number of cases past the gate between two reports.
const STEP: u64 = 1000;

/// Counts the allocated memory and refuses allocations beyond the limit of the target: libFuzzer reports such a case as
/// a crash, even if the memory is never touched.
#[global_allocator]
static ALLOCATOR: cap::Cap<System> = cap::Cap::new(System, usize::MAX);

static TARGET: OnceLock<fuzz::Target> = OnceLock::new();

/// Cases are printed, as required when one is repeated.
static SHOWN: OnceLock<bool> = OnceLock::new();

fn prepare() {
    let name = std::env::var("ANTRIEB_FUZZ_TARGET").unwrap_or_default();
    let found = fuzz::TARGETS.iter().find(|target| target.name == name);
    assert!(found.is_some(), "no target {name:?}; there are: {:?}", fuzz::TARGETS.map(|target| target.name));
    if let Some(target) = found.copied() {
        // Data loaded once per process must not count for the first case.
        (target.run)(&[]);
        let megabytes = std::env::var("ANTRIEB_FUZZ_MEMORY_MB").ok().and_then(|text| text.parse::<usize>().ok());
        assert!(megabytes.is_none_or(|most| ALLOCATOR.set_limit(ALLOCATOR.allocated() + (most << 20)).is_ok()));
        TARGET.get_or_init(|| target);
    }
}

libfuzzer_sys::fuzz_target!(init: prepare(), |data: &[u8]| {
    if let Some(target) = TARGET.get() {
        if *SHOWN.get_or_init(|| std::env::var_os("ANTRIEB_FUZZ_SHOW").is_some()) {
            let _ = writeln!(std::io::stderr(), "{}", (target.shown)(data));
        }
        let before = PAST_THE_GATE.load(Ordering::Relaxed);
        (target.run)(data);
        let past = PAST_THE_GATE.load(Ordering::Relaxed);
        // The engine does not report its end, so the number is printed in steps. `xtask/src/fuzz/engine.rs` reads it.
        if past / STEP > before / STEP {
            let _ = writeln!(std::io::stderr(), "stat::past_the_gate: {past}");
        }
    }
});

//! Cost of a work in processor time, which other programs of the machine disturb less than the time by the clock.

use std::time::Instant;

/// Returns the processor time of this process so far \[s\], of all its threads; by the clock where the system does not
/// state it.
#[must_use]
pub fn processor_seconds(since: Instant) -> f64 {
    /// Ticks per second in which Linux states it, on every architecture.
    const TICKS: f64 = 100.0;
    let stated = || {
        let text = std::fs::read_to_string("/proc/self/stat").ok()?;
        // The name of the program, in brackets, may contain blanks.
        let mut fields = text.rsplit_once(')')?.1.split_whitespace().skip(11);
        let mut next = || fields.next()?.parse::<f64>().ok();
        Some((next()? + next()?) / TICKS)
    };
    stated().unwrap_or_else(|| since.elapsed().as_secs_f64())
}

/// Returns the processor time of a work \[s\], the smallest of some runs.
pub fn processor_time(runs: usize, mut work: impl FnMut()) -> f64 {
    let since = Instant::now();
    let mut one = || {
        let before = processor_seconds(since);
        work();
        processor_seconds(since) - before
    };
    (0..runs).map(|_| one()).fold(f64::INFINITY, f64::min)
}

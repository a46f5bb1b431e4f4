//! Forecast of the duration of a run: the time of the same run here before, else the time where it was measured.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Cost of a step from an empty target directory.
///
/// Processor time, independent of other load, on a machine with two cores of 2026, rounded up: measured for what runs
/// and for the debug build, estimated from the sizes of the crates for the release build and the lints.
#[derive(Clone, Copy)]
pub(super) struct Cost {
    seconds: u32,
    /// Number of cores the step can use.
    cores: u32,
}

impl Cost {
    /// Creates the cost of a step on one core.
    pub(super) const fn on_one(seconds: u32) -> Self {
        Self { seconds, cores: 1 }
    }

    /// Creates the cost of a step that cargo distributes over the cores; beyond four cores the gain is small.
    pub(super) const fn shared(seconds: u32) -> Self {
        Self { seconds, cores: 4 }
    }

    fn on(self, cores: u32) -> f64 {
        f64::from(self.seconds) / f64::from(self.cores.min(cores).max(1))
    }
}

/// Times of earlier runs, stored in the target directory; empty in a fresh clone.
#[derive(Default)]
pub(super) struct Forecast {
    file: Option<PathBuf>,
    last: BTreeMap<String, f64>,
}

impl Forecast {
    pub(super) fn read(target: &Path) -> Self {
        let file = target.join("xtask").join("ci-seconds.txt");
        let line = |line: &str| {
            let (name, seconds) = line.split_once(' ')?;
            Some((name.to_owned(), seconds.parse().ok()?))
        };
        let last = fs::read_to_string(&file).unwrap_or_default().lines().filter_map(line).collect();
        Self { file: Some(file), last }
    }

    pub(super) fn took(&mut self, step: &str, seconds: f64) {
        self.last.insert(step.to_owned(), seconds);
    }

    /// Stores the times. A failure is ignored: the next run only has less data for its forecast.
    pub(super) fn write(&self) {
        let Some(file) = &self.file else { return };
        let text: String = self.last.iter().map(|(name, seconds)| format!("{name} {seconds:.1}\n")).collect();
        let folder = file.parent().unwrap_or(file);
        fs::create_dir_all(folder).and_then(|()| fs::write(file, text)).ok();
    }

    /// Returns the table of steps and expected times, printed before the first step.
    pub(super) fn table(&self, steps: &[(&str, Cost)]) -> String {
        let cores = std::thread::available_parallelism().map_or(1, |cores| u32::try_from(cores.get()).unwrap_or(1));
        let mut text = self.table_for(steps, cores);
        text.push_str(&busy(load(), cores));
        text
    }

    fn table_for(&self, steps: &[(&str, Cost)], cores: u32) -> String {
        let cold: f64 = steps.iter().map(|(_, cost)| cost.on(cores)).sum();
        let mut text = format!(
            "ci: {} steps; from an empty target directory about {} on {cores} {}, a slow machine or neighbours apart\n",
            steps.len(),
            duration(cold),
            if cores == 1 { "core" } else { "cores" },
        );
        if !self.last.is_empty() {
            let here = |(name, cost): &(&str, Cost)| self.last.get(*name).copied().unwrap_or_else(|| cost.on(cores));
            let total = duration(steps.iter().map(here).sum());
            text.push_str(&format!("ci: what the steps took here last adds up to {total}\n"));
        }
        for (name, cost) in steps {
            let last = self.last.get(*name).map(|seconds| format!(", here last {}", duration(*seconds)));
            let cold = duration(cost.on(cores));
            text.push_str(&format!("ci: {cold:>9} {name}{}\n", last.unwrap_or_default()));
        }
        text
    }
}

/// Formats a duration in seconds below a minute and a half, else in minutes.
pub(super) fn duration(seconds: f64) -> String {
    if seconds < 90.0 { format!("{seconds:.0} s") } else { format!("{:.0} min", seconds / 60.0) }
}

/// Returns the number of programs waiting for a core, if the system reports it.
fn load() -> Option<f64> {
    fs::read_to_string("/proc/loadavg").ok()?.split_whitespace().next()?.parse().ok()
}

fn busy(load: Option<f64>, cores: u32) -> String {
    let others = load.unwrap_or(0.0) / f64::from(cores.max(1));
    if others < 0.3 {
        return String::new();
    }
    format!("ci: others are at work here: expect up to {:.1} times as long\n", 1.0 + others)
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEPS: [(&str, Cost); 2] = [("fmt", Cost::on_one(2)), ("test", Cost::shared(600))];

    #[test]
    fn a_fresh_clone_is_reported_the_measured_times_for_its_cores() {
        let shown = Forecast::default().table_for(&STEPS, 1);
        assert!(shown.contains("about 10 min on 1 core,") && shown.contains("10 min test\n"), "{shown}");
        let shown = Forecast::default().table_for(&STEPS, 2);
        assert!(shown.contains("about 5 min on 2 cores,") && !shown.contains("here last"), "{shown}");
    }

    #[test]
    fn what_it_took_here_is_kept_and_shown() {
        let target = std::env::temp_dir().join(format!("antrieb-forecast-{}", std::process::id()));
        let mut first = Forecast::read(&target);
        assert!(first.last.is_empty());
        first.took("test", 125.04);
        first.write();
        let shown = Forecast::read(&target).table_for(&STEPS, 2);
        fs::remove_dir_all(&target).unwrap();
        assert!(shown.contains("adds up to 2 min\n") && shown.contains("5 min test, here last 2 min\n"), "{shown}");
    }

    #[test]
    fn neighbours_are_reported_of() {
        assert_eq!(busy(Some(0.2), 2), "");
        assert_eq!(busy(None, 2), "");
        assert!(busy(Some(4.0), 2).contains("3.0 times as long"));
    }
}

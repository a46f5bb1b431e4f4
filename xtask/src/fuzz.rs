//! Fuzzing: nightly steps, campaigns, and the coverage of the corpora. See `fuzz/README.md` for its use.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use crate::Error;
use arguments::{Arguments, Work};
use engine::{EndCondition, Engine, EngineRuns};

mod arguments;
mod corpus;
mod coverage;
mod engine;
pub mod instrument;

/// A fuzz target with its limits. A case that exceeds one of them is a find.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Target {
    /// Name in `fuzz/src/lib.rs`, and of the target's folders.
    name: &'static str,
    /// Duration in a nightly run of CI \[s\].
    ci_seconds: u32,
    /// Memory limit of a case \[MB\].
    memory_mb: u32,
    /// Maximum length of a case \[bytes\].
    bytes: u32,
    /// Minimum number of cases in a campaign.
    cases: u64,
    /// First gate of the target, behind which cases are counted; `None` for most targets.
    gate: Option<&'static str>,
}

impl Target {
    /// Returns the path of the packed corpus.
    fn corpus(&self, root: &Path) -> PathBuf {
        root.join("fuzz").join("corpus").join(format!("{}.txt", self.name))
    }
}

/// Promised maximum time of an answer \[s\], which no case may exceed.
const CASE_SECONDS: u32 = 5;

/// Maximum size of a project file \[bytes\]; also that of a recording, a body and the choices of a generated project.
const FILE_BYTES: u32 = 1 << 20;

const fn target(name: &'static str, ci_seconds: u32, memory_mb: u32, bytes: u32, cases: u64) -> Target {
    Target { name, ci_seconds, memory_mb, bytes, cases, gate: None }
}

const TARGETS: [Target; 11] = [
    target("code", 10, 64, 4096, 10_000_000),
    target("encoder", 10, 64, 4096, 1_000_000),
    target("quantity", 10, 64, 4096, 10_000_000),
    target("project", 20, 256, FILE_BYTES, 1_000_000),
    target("csv", 15, 256, FILE_BYTES, 1_000_000),
    Target { gate: Some("the footer"), ..target("parquet", 15, 256, FILE_BYTES, 200_000) },
    target("packed", 10, 256, FILE_BYTES, 200_000),
    target("run", 10, 256, FILE_BYTES, 100_000),
    target("table", 10, 256, FILE_BYTES, 200_000),
    target("axis", 40, 512, FILE_BYTES, 10_000),
    target("request", 30, 512, FILE_BYTES, 10_000),
];

/// Number of finds of a target after which a run ends; further ones are rarely different.
const FINDS_MOST: usize = 10;

/// Environment variable with the seed that repeats a run.
const SEED: &str = "ANTRIEB_FUZZ_SEED";

/// Runs the nightly step: all of the corpora and former crashes, then new cases from a new seed each time.
pub(crate) fn step(root: &Path) -> Result<(), Error> {
    let engine = Engine::build(root)?;
    let seed = seed();
    println!("fuzz: seed {seed}; {SEED}={seed} repeats this run");
    let mut failed = Ok(());
    for target in TARGETS {
        let stop = EndCondition::Seconds(target.ci_seconds);
        failed = failed.and(explored(&engine, &target, stop, 1, seed).map(drop));
    }
    failed
}

/// Runs the nightly step that reports the share of lines reached by the corpora.
pub(crate) fn coverage(root: &Path) -> Result<(), Error> {
    coverage::tell(root, &TARGETS.iter().collect::<Vec<_>>())
}

/// Runs `cargo xtask fuzz` with its arguments.
///
/// # Errors
/// An unknown argument, a failed build, or failing cases, which have been printed.
pub fn run(root: &Path, words: &[String]) -> Result<(), Error> {
    let arguments = Arguments::read(words, &TARGETS.map(|target| target.name))?;
    let chosen = || TARGETS.iter().filter(|target| arguments.target.as_deref().is_none_or(|name| name == target.name));
    match &arguments.work {
        Work::Coverage => coverage::tell(root, &chosen().collect::<Vec<_>>()),
        Work::Case(file) => {
            let engine = Engine::build(root)?;
            for target in chosen() {
                engine.repeat(target, file)?;
            }
            Ok(())
        }
        Work::Campaign { minutes } => {
            let (engine, seed) = (Engine::build(root)?, seed());
            println!("fuzz: seed {seed}; {SEED}={seed} repeats this run");
            let share = minutes.map(|minutes| minutes * 60 / u32::try_from(chosen().count().max(1)).unwrap_or(1));
            let mut failed = Ok(());
            for target in chosen() {
                let stop = share.map_or(EndCondition::Cases(target.cases), EndCondition::Seconds);
                let outcome = explored(&engine, target, stop, arguments.jobs, seed);
                engine.merge(target)?;
                failed = failed.and(outcome.map(drop));
            }
            failed
        }
    }
}

/// Runs a target to its end in several processes at once; a process that ends with a find is restarted.
fn explored(engine: &Engine, target: &Target, stop: EndCondition, jobs: u32, seed: u32) -> Result<EngineRuns, Error> {
    let begin = Instant::now();
    let finds = engine.finds(target)?;
    engine.unpack(target)?;
    let shares: Vec<EngineRuns> = std::thread::scope(|scope| {
        let one = |job: u32| scope.spawn(move || job_of(engine, target, stop.shared(jobs), seed.wrapping_add(job)));
        let started: Vec<_> = (0..jobs).map(one).collect();
        started
            .into_iter()
            .map(|job| job.join().unwrap_or(Err(Error::NoCases { target: target.name })))
            .collect::<Result<_, _>>()
    })?;
    let sum = shares.into_iter().fold(EngineRuns::default(), EngineRuns::and);
    let seconds = begin.elapsed().as_secs_f64();
    println!(
        "fuzz: {:<9} {:>9} cases in {seconds:.0} s, {:.0} in a second{}; {} of {} edges; finds: {}",
        target.name,
        sum.cases,
        sum.cases as f64 / seconds.max(1e-3),
        target.gate.map(|gate| format!("; at least {} past {gate}", sum.past)).unwrap_or_default(),
        sum.reached,
        sum.edges,
        sum.finds,
    );
    if sum.cases == 0 && sum.finds == 0 {
        return Err(Error::NoCases { target: target.name });
    }
    if sum.finds > 0 {
        for find in listed(&finds) {
            println!("fuzz: cargo xtask fuzz --target {} --case {}", target.name, find.display());
        }
        return Err(Error::Finds { target: target.name, count: sum.finds, folder: finds });
    }
    Ok(sum)
}

fn job_of(engine: &Engine, target: &Target, stop: EndCondition, seed: u32) -> Result<EngineRuns, Error> {
    let begin = Instant::now();
    let mut sum = EngineRuns::default();
    for attempt in 0.. {
        let Some(left) = stop.after(begin.elapsed(), sum.cases) else { break };
        // A new seed after a find: the same one leads to the same place.
        let run = engine.explore(target, left, seed.wrapping_add(attempt * 7919))?;
        sum = sum.and(run);
        if run.finds == 0 || sum.finds >= FINDS_MOST {
            break;
        }
    }
    Ok(sum)
}

impl EndCondition {
    /// Returns the share of the work of each of several processes.
    fn shared(self, jobs: u32) -> Self {
        match self {
            Self::Seconds(seconds) => Self::Seconds(seconds),
            Self::Cases(cases) => Self::Cases(cases.div_ceil(u64::from(jobs.max(1)))),
        }
    }

    /// Returns the remaining work; `None` if there is none.
    fn after(self, spent: Duration, done: u64) -> Option<Self> {
        match self {
            Self::Seconds(seconds) => {
                let left = Duration::from_secs(seconds.into()).checked_sub(spent)?.as_secs();
                u32::try_from(left).ok().filter(|left| *left > 0).map(Self::Seconds)
            }
            Self::Cases(cases) => cases.checked_sub(done).filter(|left| *left > 0).map(Self::Cases),
        }
    }
}

/// Returns the seed given in the environment, else a new one.
fn seed() -> u32 {
    let asked = std::env::var(SEED).ok().and_then(|text| text.parse().ok());
    asked.unwrap_or_else(|| {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        // libFuzzer treats zero as no seed.
        (now.subsec_nanos() ^ std::process::id()).max(1)
    })
}

fn listed(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().filter_map(Result::ok).map(|entry| entry.path());
    let mut files: Vec<PathBuf> = entries.filter(|path| path.is_file()).collect();
    files.sort();
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cargo::Workspace;

    #[test]
    fn every_target_of_the_package_has_its_limits() {
        let text = fs::read_to_string(crate::root().join("fuzz/src/lib.rs")).unwrap();
        let names: Vec<&str> =
            text.split("Target { name: \"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
        assert_eq!(names, TARGETS.map(|target| target.name));
        let seconds: u32 = TARGETS.iter().map(|target| target.ci_seconds).sum();
        assert!(seconds <= 180, "the step runs for {seconds} s");
    }

    #[test]
    fn what_is_left_is_what_was_not_done() {
        let spent = Duration::from_secs;
        assert_eq!(EndCondition::Seconds(60).after(spent(45), 9), Some(EndCondition::Seconds(15)));
        assert_eq!(EndCondition::Seconds(60).after(spent(60), 9), None);
        assert_eq!(EndCondition::Cases(100).shared(3), EndCondition::Cases(34));
        assert_eq!(EndCondition::Cases(34).after(spent(1), 30), Some(EndCondition::Cases(4)));
        assert_eq!(EndCondition::Cases(34).after(spent(1), 40), None);
    }

    #[test]
    fn the_tools_of_the_workspace_know_the_package() {
        assert!(Workspace::ask(&crate::root()).unwrap().require("fuzz").is_ok());
    }
}

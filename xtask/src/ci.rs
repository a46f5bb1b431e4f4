//! Steps of CI in their order: `.ci/run` starts [`push`] for a change and [`nightly`] once a day.
//!
//! A push runs the steps that can find a fault of the change: lints, tests, documents, the page with a server. One
//! debug build of the workspace serves all of it. Steps that need a build of their own or search for faults for a fixed
//! time run at night: the optimised program, the page without a server, a cluster that loses nodes, benches, a thousand
//! kills of a saving program and of sweeps, a day of the digital twin, fuzz campaigns, the coverage of the corpora.

use std::path::Path;
use std::time::Instant;

use crate::cargo::Workspace;
use crate::{
    Error, api, bench, book, browser, canopen, data, fuzz, german, lint, notices, python, readme, site, standard, test,
    tidy, tools,
};
use forecast::{Cost, Forecast};

mod forecast;

#[derive(Clone, Copy)]
struct Step {
    name: &'static str,
    cost: Cost,
    run: fn(&Path) -> Result<(), Error>,
}

const fn step(name: &'static str, cost: Cost, run: fn(&Path) -> Result<(), Error>) -> Step {
    Step { name, cost, run }
}

/// Steps of a push, cheap ones first: a slip is reported within seconds. For the costs see [`Cost`].
const PUSH: &[Step] = &[
    step("fmt", Cost::on_one(2), lint::fmt),
    step("tools", Cost::on_one(15), tools::install),
    step("typos", Cost::on_one(1), standard::typos),
    step("german", Cost::on_one(10), german::run),
    step("links", Cost::on_one(1), standard::links),
    step("book", Cost::on_one(6), book::run),
    step("deny", Cost::on_one(6), standard::deny),
    step("tidy", Cost::on_one(2), tidy::run),
    step("notices", Cost::on_one(3), notices::check),
    step("clippy", Cost::shared(540), lint::clippy),
    step("data", Cost::on_one(1), |_| data::run()),
    step("test", Cost::shared(1500), test::run),
    step("doc", Cost::shared(160), lint::doc),
    step("readme", Cost::on_one(60), readme::run),
    step("api", Cost::on_one(120), api::run),
    step("browser", Cost::on_one(120), browser::served),
    step("python", Cost::on_one(120), python::push),
];

const NIGHTLY: &[Step] = &[
    step("tools", Cost::on_one(15), tools::install),
    step("release", Cost::shared(1200), lint::release),
    step("site", Cost::shared(480), site::run),
    step("browser", Cost::on_one(300), browser::both),
    step("python", Cost::shared(300), python::night),
    step("bench", Cost::shared(150), |root| bench::run(root, &[])),
    step("canopen", Cost::on_one(10), canopen::run),
    step("kills", Cost::on_one(360), test::kills),
    step("day", Cost::on_one(900), test::day),
    step("fuzz", Cost::on_one(450), fuzz::step),
    step("coverage", Cost::shared(450), fuzz::coverage),
];

/// Runs every step of a push, or those named. Each is announced on stderr; the expected times are printed beforehand,
/// the actual ones at the end.
///
/// # Errors
/// The first step that fails, by name; the steps after it do not run. An unknown name of a step.
pub fn push(root: &Path, names: &[String]) -> Result<(), Error> {
    run(PUSH, root, names)
}

/// Runs every step of a night, or those named.
///
/// # Errors
/// As [`push`].
pub fn nightly(root: &Path, names: &[String]) -> Result<(), Error> {
    run(NIGHTLY, root, names)
}

fn run(steps: &[Step], root: &Path, names: &[String]) -> Result<(), Error> {
    let steps = named(steps, names)?;
    let target = Workspace::ask(root)?.target;
    all(&steps, root, Forecast::read(&target), is_ci())
}

/// Returns the steps with these names in their order; all steps if no name is given.
fn named(steps: &[Step], names: &[String]) -> Result<Vec<Step>, Error> {
    let is = |step: &Step, name: &String| step.name == name;
    if let Some(unknown) = names.iter().find(|name| !steps.iter().any(|step| is(step, name))) {
        let known: Vec<&str> = steps.iter().map(|step| step.name).collect();
        return Err(Error::NoStep { name: unknown.clone(), known: known.join(" ") });
    }
    Ok(steps.iter().filter(|step| names.is_empty() || names.iter().any(|name| is(step, name))).copied().collect())
}

/// Returns `true` in a run of CI, where a missing tool is a failure.
pub(crate) fn is_ci() -> bool {
    std::env::var_os("CI").is_some_and(|value| value == "true")
}

fn all(steps: &[Step], root: &Path, mut forecast: Forecast, strict: bool) -> Result<(), Error> {
    let costs: Vec<(&str, Cost)> = steps.iter().map(|step| (step.name, step.cost)).collect();
    eprint!("{}", forecast.table(&costs));
    let begin = Instant::now();
    let (mut lines, mut left_out) = (String::new(), Vec::new());
    let mut outcome = Ok(());
    for (number, step) in (1..).zip(steps) {
        eprintln!("ci: {number}/{} {} …", steps.len(), step.name);
        let (step_begin, worked_before) = (Instant::now(), worked());
        let result = (step.run)(root);
        let seconds = step_begin.elapsed().as_secs_f64();
        let cost =
            worked_before.zip(worked()).map(|(before, now)| format!(", {:.0} s of processor time", now - before));
        let cost = cost.unwrap_or_default();
        let word = match &result {
            Ok(()) => "passed",
            Err(
                Error::NoTool { .. }
                | Error::NoWords { .. }
                | Error::NoCompiler
                | Error::NoTarget { .. }
                | Error::NoBrowser { .. }
                | Error::NoCoverageTool { .. }
                | Error::NoSchemathesis
                | Error::NoCanopen
                | Error::NoPython,
            ) if !strict => "NOT RUN",
            Err(_) => "FAILED",
        };
        eprintln!("ci: {number}/{} {} {word} after {seconds:.1} s{cost}", steps.len(), step.name);
        lines.push_str(&format!("ci: {:>9} {:<8} {word}\n", forecast::duration(seconds), step.name));
        match result {
            Ok(()) => forecast.took(step.name, seconds),
            Err(error) if word == "NOT RUN" => {
                eprintln!("ci: {error}; CI itself runs this step and fails without it");
                left_out.push(step.name);
            }
            Err(error) => {
                outcome = Err(Error::Step { name: step.name, source: Box::new(error) });
                break;
            }
        }
    }
    forecast.write();
    eprint!("{lines}");
    outcome?;
    let total = forecast::duration(begin.elapsed().as_secs_f64());
    if left_out.is_empty() {
        eprintln!("ci: all {} steps passed in {total}", steps.len());
    } else {
        let passed = steps.len() - left_out.len();
        eprintln!("ci: {passed} of {} steps passed in {total}; NOT RUN: {}", steps.len(), left_out.join(", "));
    }
    Ok(())
}

/// Returns the processor time of this process and its finished children \[s\], the unit of a [`Cost`], independent of
/// other load on the machine; `None` without `/proc`.
pub(crate) fn worked() -> Option<f64> {
    const TICKS_PER_SECOND: f64 = 100.0;
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // After the name, which stands in brackets and may contain anything: utime, stime, cutime, cstime are words 12 to
    // 15.
    let ticks = stat.rsplit_once(')')?.1.split_whitespace().skip(11).take(4);
    let sum: f64 = ticks.filter_map(|word| word.parse::<f64>().ok()).sum();
    Some(sum / TICKS_PER_SECOND)
}

#[cfg(test)]
mod tests {
    use super::*;

    const COST: Cost = Cost::on_one(1);

    fn no_tool(_: &Path) -> Result<(), Error> {
        Err(Error::NoTool { program: "typos", from_crate: "typos-cli" })
    }

    #[test]
    fn the_first_failure_stops_and_is_named() {
        let steps = [
            step("good", COST, |_| Ok(())),
            step("bad", COST, |_| Err(Error::NoTests)),
            step("never", COST, |_| panic!("a step after a failure must not run")),
        ];
        let error = all(&steps, Path::new("."), Forecast::default(), false).unwrap_err();
        assert!(error.to_string().starts_with("step `bad` failed: "), "{error}");
    }

    #[test]
    fn a_missing_tool_is_passed_over_at_home_and_a_failure_in_ci() {
        let steps = [step("typos", COST, no_tool), step("good", COST, |_| Ok(()))];
        assert!(all(&steps, Path::new("."), Forecast::default(), false).is_ok());
        let error = all(&steps, Path::new("."), Forecast::default(), true).unwrap_err();
        assert!(error.to_string().contains("cargo install --locked typos-cli"), "{error}");
    }

    #[test]
    fn steps_may_be_named() {
        let names = |words: &[&str]| {
            let words: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
            named(PUSH, &words).map(|steps| steps.iter().map(|step| step.name).collect::<Vec<_>>())
        };
        assert_eq!(names(&["links", "typos"]).unwrap(), ["typos", "links"]);
        assert_eq!(names(&[]).unwrap().len(), PUSH.len());
        assert!(names(&["lint"]).unwrap_err().to_string().contains("clippy"));
        assert!(names(&["bench"]).is_err());
    }

    #[test]
    fn no_two_steps_have_one_name() {
        for steps in [PUSH, NIGHTLY] {
            let mut names: Vec<&str> = steps.iter().map(|step| step.name).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), steps.len());
        }
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_time_of_children_is_counted() {
        let before = worked().unwrap();
        let mut busy = std::process::Command::new("sh");
        assert!(busy.args(["-c", "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done"]).status().unwrap().success());
        assert!(worked().unwrap() > before);
    }
}

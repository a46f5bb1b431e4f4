//! Steps of CI in their order: `.ci/run` starts [`push`] for a change and [`nightly`] once a day.
//!
//! A push runs the steps that can find a fault of the change: lints, tests, documents, the page with a server. One
//! debug build of the workspace serves all of it. Steps that need a build of their own or search for faults for a fixed
//! time run at night: the optimised program, the page without a server, a cluster that loses nodes, benches, a thousand
//! kills of a saving program and of sweeps, a day of the digital twin, fuzz campaigns, the coverage of the corpora. The page is
//! gone through at night in every scenario and both browsers, in a push without the long ones.

use std::path::Path;
use std::time::Instant;

use crate::{
    Error, api, bench, book, browser, canopen, fuzz, german, lint, notices, python, readme, site, standard, test, tidy,
    tools,
};

#[derive(Clone, Copy)]
struct Step {
    name: &'static str,
    run: fn(&Path) -> Result<(), Error>,
}

const fn step(name: &'static str, run: fn(&Path) -> Result<(), Error>) -> Step {
    Step { name, run }
}

/// Steps of a push, cheap ones first: a slip is reported within seconds.
const PUSH: &[Step] = &[
    step("fmt", lint::fmt),
    step("tools", tools::install),
    step("typos", standard::typos),
    step("german", german::run),
    step("links", standard::links),
    step("book", book::run),
    step("deny", standard::deny),
    step("tidy", tidy::run),
    step("notices", notices::check),
    step("clippy", lint::clippy),
    step("test", test::run),
    step("doc", lint::doc),
    step("readme", readme::run),
    step("api", api::push),
    step("browser", browser::served),
    step("python", python::push),
];

const NIGHTLY: &[Step] = &[
    step("tools", tools::install),
    step("release", lint::release),
    step("site", site::run),
    step("browser", browser::both),
    step("python", python::night),
    step("api", api::night),
    step("bench", |root| bench::run(root, &[])),
    step("canopen", canopen::run),
    step("kills", test::kills),
    step("day", test::day),
    step("fuzz", fuzz::step),
    step("coverage", fuzz::coverage),
];

/// Runs every step of a push, or those named. Each is announced on stderr; the times are printed at the end.
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
    all(&named(steps, names)?, root, crate::tools::is_ci())
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

fn all(steps: &[Step], root: &Path, strict: bool) -> Result<(), Error> {
    let begin = Instant::now();
    let (mut lines, mut left_out) = (String::new(), Vec::new());
    let mut outcome = Ok(());
    for (number, step) in (1..).zip(steps) {
        eprintln!("ci: {number}/{} {} …", steps.len(), step.name);
        let step_begin = Instant::now();
        let result = (step.run)(root);
        let seconds = step_begin.elapsed().as_secs_f64();
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
        eprintln!("ci: {number}/{} {} {word} after {seconds:.1} s", steps.len(), step.name);
        lines.push_str(&format!("ci: {:>9} {:<8} {word}\n", duration(seconds), step.name));
        match result {
            Ok(()) => {}
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
    eprint!("{lines}");
    outcome?;
    let total = duration(begin.elapsed().as_secs_f64());
    if left_out.is_empty() {
        eprintln!("ci: all {} steps passed in {total}", steps.len());
    } else {
        let passed = steps.len() - left_out.len();
        eprintln!("ci: {passed} of {} steps passed in {total}; NOT RUN: {}", steps.len(), left_out.join(", "));
    }
    Ok(())
}

/// Writes a duration: minutes from two minutes on.
fn duration(seconds: f64) -> String {
    if seconds < 120.0 { format!("{seconds:.0} s") } else { format!("{:.0} min", seconds / 60.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn no_tool(_: &Path) -> Result<(), Error> {
        Err(Error::NoTool { program: "typos", from_crate: "typos-cli" })
    }

    #[test]
    fn the_first_failure_stops_and_is_named() {
        let steps = [
            step("good", |_| Ok(())),
            step("bad", |_| Err(Error::NoTests)),
            step("never", |_| panic!("a step after a failure must not run")),
        ];
        let error = all(&steps, Path::new("."), false).unwrap_err();
        assert!(error.to_string().starts_with("step `bad` failed: "), "{error}");
    }

    #[test]
    fn a_missing_tool_is_passed_over_at_home_and_a_failure_in_ci() {
        let steps = [step("typos", no_tool), step("good", |_| Ok(()))];
        assert!(all(&steps, Path::new("."), false).is_ok());
        let error = all(&steps, Path::new("."), true).unwrap_err();
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
}

//! What CI runs, in CI's order: `.ci/run` starts this and nothing else.

use std::path::Path;
use std::time::Instant;

use crate::cargo::{cargo, must_succeed};
use crate::{Error, bench, data, fuzz, readme, test, tidy};

struct Step {
    name: &'static str,
    run: fn(&Path) -> Result<(), Error>,
}

/// Cheap steps first: a slip is told within seconds.
const STEPS: [Step; 10] = [
    Step { name: "fmt", run: fmt },
    Step { name: "clippy", run: clippy },
    Step { name: "tidy", run: tidy::run },
    Step { name: "data", run: |_| data::run() },
    Step { name: "test", run: test::run },
    Step { name: "doc", run: doc },
    Step { name: "release", run: release },
    Step { name: "readme", run: readme::run },
    Step { name: "bench", run: |root| bench::run(root, &[]) },
    Step { name: "fuzz", run: fuzz::run },
];

/// Runs every step, announced on stderr with its time.
///
/// # Errors
/// The first step that fails, by name; the steps after it do not run.
pub fn run(root: &Path) -> Result<(), Error> {
    all(&STEPS, root)
}

fn all(steps: &[Step], root: &Path) -> Result<(), Error> {
    let begin = Instant::now();
    for (number, step) in (1..).zip(steps) {
        eprintln!("ci: {number}/{} {} …", steps.len(), step.name);
        let step_begin = Instant::now();
        let outcome = (step.run)(root);
        let seconds = step_begin.elapsed().as_secs_f64();
        let word = if outcome.is_ok() { "passed" } else { "FAILED" };
        eprintln!("ci: {number}/{} {} {word} after {seconds:.1} s", steps.len(), step.name);
        outcome.map_err(|source| Error::Step { name: step.name, source: Box::new(source) })?;
    }
    eprintln!("ci: all {} steps passed in {:.1} s", steps.len(), begin.elapsed().as_secs_f64());
    Ok(())
}

fn fmt(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["fmt", "--all", "--check", "--", "--color=never"]))
}

fn clippy(root: &Path) -> Result<(), Error> {
    let args = ["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"];
    must_succeed(&mut cargo(root, &args))
}

fn doc(root: &Path) -> Result<(), Error> {
    let mut command = cargo(root, &["doc", "--workspace", "--no-deps"]);
    must_succeed(command.env("RUSTDOCFLAGS", "-Dwarnings"))
}

fn release(root: &Path) -> Result<(), Error> {
    must_succeed(&mut cargo(root, &["build", "--release"]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_failure_stops_and_is_named() {
        let steps = [
            Step { name: "good", run: |_| Ok(()) },
            Step { name: "bad", run: |_| Err(Error::NoTests) },
            Step { name: "never", run: |_| panic!("a step after a failure must not run") },
        ];
        let error = all(&steps, Path::new(".")).unwrap_err();
        assert!(error.to_string().starts_with("step `bad` failed: "), "{error}");
    }
}

//! The page in a real browser: the same ways through it, served by `antrieb serve` and without any server.
//!
//! `cargo xtask browser [NAME…]` builds what is needed and calls it. A way is a function that takes a [`Stage`]; it stands in
//! [`ways::ALL`], and what it finds wrong it gives back as a sentence.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it tells what it found")]
#![allow(clippy::indexing_slicing, reason = "JSON gives null where there is nothing")]

mod driver;
mod shell;
mod stage;
mod tab;
mod ways;

use driver::Driver;
use shell::Shell;
use stage::Stage;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// What the command line says.
struct Options {
    program: PathBuf,
    site: PathBuf,
    axe: PathBuf,
    chromium: PathBuf,
    driver: PathBuf,
    names: Vec<String>,
}

impl Options {
    /// `browser PROGRAM SITE AXE CHROMIUM CHROMEDRIVER [NAME…]`
    fn read() -> Option<Self> {
        let mut words = std::env::args_os().skip(1).map(PathBuf::from);
        let mut path = || words.next();
        let (program, site, axe, chromium, driver) = (path()?, path()?, path()?, path()?, path()?);
        let names = words.map(|word| word.to_string_lossy().into_owned()).collect();
        Some(Self { program, site, axe, chromium, driver, names })
    }
}

fn main() -> ExitCode {
    let Some(options) = Options::read() else {
        eprintln!("usage: browser PROGRAM SITE AXE CHROMIUM CHROMEDRIVER [NAME…]");
        return ExitCode::from(2);
    };
    match all(&options) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(failed) => {
            eprintln!("browser: {failed} failed");
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("browser: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Goes every way against both shells; gives the number of those that failed.
fn all(options: &Options) -> Result<usize, String> {
    let axe = std::fs::read_to_string(&options.axe).map_err(|error| format!("{}: {error}", options.axe.display()))?;
    let driver = Driver::start(&options.driver)?;
    let (mut failed, mut gone) = (0, 0);
    for shell in [Shell::server(&options.program)?, Shell::site(&options.site)?] {
        let downloads = tempfile::tempdir().map_err(|error| error.to_string())?;
        for way in ways::ALL.iter().filter(|way| way.concerns(&shell)) {
            if !options.names.is_empty() && !options.names.iter().any(|name| way.name.contains(name.as_str())) {
                continue;
            }
            // Each begins in a browser that keeps nothing of the others.
            let tab = driver.browser(&options.chromium, downloads.path())?;
            let stage = Stage { tab, shell: &shell, downloads: downloads.path(), axe: &axe, site: &options.site };
            let begin = Instant::now();
            let outcome = (way.go)(&stage).and_then(|()| stage.no_fault_in_the_console());
            let seconds = begin.elapsed().as_secs_f64();
            gone += 1;
            match outcome {
                Ok(()) => println!("{:<6} {:<28} {seconds:>5.1} s", shell.name(), way.name),
                Err(error) => {
                    failed += 1;
                    let picture =
                        std::env::temp_dir().join(format!("antrieb-browser-{}-{}.png", shell.name(), way.name));
                    let seen =
                        stage.tab.picture().and_then(|png| std::fs::write(&picture, png).map_err(|e| e.to_string()));
                    let where_seen = if seen.is_ok() { format!(" ({})", picture.display()) } else { String::new() };
                    println!("{:<6} {:<28} FAILED after {seconds:.1} s: {error}{where_seen}", shell.name(), way.name);
                }
            }
            stage.tab.close();
        }
    }
    if gone == 0 { Err(format!("no way is named so: {}", options.names.join(" "))) } else { Ok(failed) }
}

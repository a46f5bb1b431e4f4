//! Tests of the page in a real browser: the same scenarios, served by `antrieb serve` and without a server.
//!
//! `cargo xtask browser [NAME…]` builds what is needed and calls this program. A scenario is a function of a [`OpenPage`],
//! listed in [`ways::ALL`]; it returns a failure as a sentence.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it tells what it found")]
#![allow(clippy::indexing_slicing, reason = "JSON gives null where there is nothing")]

mod driver;
mod make;
mod shell;
mod stage;
mod tab;
mod ways;

use driver::Driver;
use shell::Shell;
use stage::OpenPage;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Arguments of the command line.
struct Options {
    program: PathBuf,
    axe: PathBuf,
    /// Chromium or Firefox, matching the driver.
    browser: PathBuf,
    driver: PathBuf,
    /// Folder of the page without a server; `None` runs the scenarios with a server only, and leaves out the long ones.
    site: Option<PathBuf>,
    /// Parts of the names of the scenarios to run; empty for all.
    names: Vec<String>,
}

impl Options {
    fn read() -> Option<Self> {
        let mut words = std::env::args_os().skip(1).map(PathBuf::from).peekable();
        let (program, axe, browser, driver) = (words.next()?, words.next()?, words.next()?, words.next()?);
        let site = words.next_if(|word| word.as_os_str() == "--site").and_then(|_| words.next());
        let names = words.map(|word| word.to_string_lossy().into_owned()).collect();
        Some(Self { program, axe, browser, driver, site, names })
    }

    /// Returns `true` for a scenario to run: a named one, or without names each, the long ones only at night.
    fn selects(&self, way: &ways::Way) -> bool {
        if self.names.is_empty() {
            self.site.is_some() || !way.is_long
        } else {
            self.names.iter().any(|name| way.name.contains(name.as_str()))
        }
    }
}

const USAGE: &str = "usage: browser PROGRAM AXE BROWSER DRIVER [--site FOLDER] [NAME…]";

fn main() -> ExitCode {
    let Some(options) = Options::read() else {
        eprintln!("{USAGE}");
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

/// Runs every scenario against the available shells and returns the number of failures.
fn all(options: &Options) -> Result<usize, String> {
    let axe = std::fs::read_to_string(&options.axe).map_err(|error| format!("{}: {error}", options.axe.display()))?;
    let driver = Driver::start(&options.driver)?;
    let (mut failed, mut gone) = (0, 0);
    let site = options.site.as_deref().map(Shell::site).transpose()?;
    for shell in std::iter::once(Shell::server(&options.program)?).chain(site) {
        let downloads = tempfile::tempdir().map_err(|error| error.to_string())?;
        for way in ways::ALL.iter().filter(|way| way.concerns(&shell, driver.make)) {
            if !options.selects(way) {
                continue;
            }
            // Each scenario begins in a browser with an empty profile.
            let tab = driver.browser(&options.browser, downloads.path())?;
            let stage = OpenPage { tab, shell: &shell, downloads: downloads.path(), axe: &axe };
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

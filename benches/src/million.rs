//! A recording of a million samples that every candidate survives as far as it can: the catalogue judged on it, one
//! actuator checked and its reserves searched, in the process and as whole processes.
//!
//! Baseline: `numpy.loadtxt` of the same file, run in turn with the process.
#![allow(clippy::print_stdout, clippy::expect_used, reason = "a bench prints what it measured")]

use std::process::ExitCode;
use std::time::Instant;
use workbench::{Files, Language, Project, reserve_of, size};

struct Beside(String);

impl Files for Beside {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::fs::File::open(format!("{}/{name}", self.0))?))
    }
}

fn main() -> ExitCode {
    let folder = std::env::var("MILLION").expect("folder");
    for name in ["noisy", "clean", "rough"] {
        let text = std::fs::read_to_string(format!("{folder}/{name}.toml")).expect("file");
        let files = Beside(folder.clone());
        let start = Instant::now();
        let projects = Project::read_all(&text, &files, Language::En).expect("valid");
        println!("{name}: read {:?}", start.elapsed());
        let project = projects.first().expect("one");
        for round in 0..2 {
            let start = Instant::now();
            let sizing = size(project);
            println!("  size {:?}, {} fit", start.elapsed(), sizing.candidates.iter().filter(|c| c.fits()).count());
            if round == 0 && std::env::var("RESERVE").is_err() {
                continue;
            }
            let start = Instant::now();
            let found = reserve_of(project, &sizing.candidates[0]);
            println!("  reserve {:?} {found:?}", start.elapsed());
        }
    }
    ExitCode::SUCCESS
}

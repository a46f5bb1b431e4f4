//! `cargo xtask <command>`: the chores of the project. See [`xtask`] for what each one does.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a chore talks to the person who started it")]

use std::process::ExitCode;

use xtask::{
    Error, bench, book, browser, ci, data, fuzz, notices, picture, root, samples, site, snapshots, test, tidy, tools,
};

const COMMANDS: [(&str, &str); 16] = [
    ("test", "every test of the workspace, documentation examples and the fuzz corpora among them"),
    ("ci", "everything CI runs for a push, in its order, or the steps named after it; stops at the first failure"),
    (
        "nightly",
        "what CI runs once a day: optimised builds, the page without a server, Python on a cluster, benches, fuzz campaigns",
    ),
    ("tools", "installs the tools that ci needs beside Rust, under target/tools"),
    ("tidy", "the house rules: layers, lengths, marks, the map of the house, data files"),
    ("data", "cross-checks of the data"),
    ("snapshots", "run the tests and rewrite the snapshots, then list what changed"),
    ("samples", "rewrite the answers that the documents show, then read git diff"),
    ("book", "builds the book from docs/, under target/book, and tries its links"),
    ("picture", "compose the picture of the README from the program's own output"),
    ("site", "builds the page without a server, under target/site"),
    (
        "browser",
        "tries the page in Chromium or, with `firefox` after it, in Firefox, with and without a server; names after it choose",
    ),
    ("notices", "rewrite THIRD-PARTY.md from the lock file"),
    ("bench", "the bench gates; words after `bench` go to the benches"),
    (
        "fuzz",
        "a fuzz campaign; --minutes N, --target T, --jobs J; --coverage tells which share of lines the corpora reach",
    ),
    ("help", "this text"),
];

fn main() -> ExitCode {
    if let Some(compiled) = fuzz::instrument::as_wrapper() {
        return compiled;
    }
    let mut words = std::env::args().skip(1);
    let Some(command) = words.next() else {
        eprint!("{}", help());
        return ExitCode::from(2);
    };
    let rest: Vec<String> = words.collect();
    let outcome = match command.as_str() {
        "help" | "--help" | "-h" => {
            print!("{}", help());
            Ok(())
        }
        "bench" => bench::run(&root(), &rest),
        "test" | "tools" | "tidy" | "data" | "snapshots" | "samples" | "book" | "picture" | "site" | "notices"
            if !rest.is_empty() =>
        {
            eprintln!("error: `{command}` takes no further words, got `{}`", rest.join(" "));
            return ExitCode::from(2);
        }
        "fuzz" => fuzz::run(&root(), &rest),
        "ci" => ci::push(&root(), &rest),
        "nightly" => ci::nightly(&root(), &rest),
        "test" => test::run(&root()),
        "tools" => tools::install(&root()),
        "tidy" => tidy::run(&root()),
        "data" => data::run(&root()),
        "snapshots" => snapshots::run(&root()),
        "samples" => samples::run(&root()),
        "book" => book::run(&root()),
        "site" => site::run(&root()),
        "browser" => browser::run(&root(), &rest),
        "picture" => picture::run(&root()),
        "notices" => notices::run(&root()),
        unknown => {
            eprintln!("error: no command `{unknown}`");
            if let Some(near) = nearest(unknown) {
                eprintln!("help: did you mean `{near}`?");
            }
            eprint!("\n{}", help());
            return ExitCode::from(2);
        }
    };
    report(outcome)
}

fn report(outcome: Result<(), Error>) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn help() -> String {
    let mut text = String::from("usage: cargo xtask <command>\n\n");
    for (name, what) in COMMANDS {
        text.push_str(&format!("  {name:<10} {what}\n"));
    }
    text
}

fn nearest(unknown: &str) -> Option<&'static str> {
    COMMANDS
        .iter()
        .map(|(name, _)| (strsim::damerau_levenshtein(unknown, name), *name))
        .filter(|(distance, name)| *distance <= name.len().div_ceil(2))
        .min()
        .map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_finds_its_command() {
        assert_eq!(nearest("tydi"), Some("tidy"));
        assert_eq!(nearest("snapshot"), Some("snapshots"));
        assert_eq!(nearest("frobnicate"), None);
    }

    #[test]
    fn help_lists_every_command() {
        let text = help();
        assert!(COMMANDS.iter().all(|(name, _)| text.contains(name)), "{text}");
    }
}

//! Comparison of the answers shown in the documents with the answers of the program.
//!
//! A sample is a fenced block `console`: after `$ antrieb …` the lines of its answer, as printed on 100 columns, with
//! `…` alone on a line for omitted lines. Samples that read other files than the examples are not run.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::Error;
use crate::cargo::{Workspace, program};
use crate::readme_words::split;
use crate::tidy::tree::Tree;

const PROMPT: &str = "$ ";
const PROGRAM: &str = "antrieb ";
const GAP: &str = "…";
/// Minimum similarity of a line of the answer to be taken as a newer form of the line shown.
const LIKE: f64 = 0.5;
/// Similarity of lines that differ only in their numbers.
const FIGURES_APART: f64 = 0.95;

/// Rewrites lines that differ from the program's answer, each with the most similar one; `git diff` shows the changes.
///
/// # Errors
/// The program cannot be built or started, or a line has no similar one in the answer and needs a manual change.
pub fn run(root: &Path) -> Result<(), Error> {
    every(root, true)
}

pub(crate) fn check(root: &Path) -> Result<(), Error> {
    every(root, false)
}

fn every(root: &Path, rewrite: bool) -> Result<(), Error> {
    let program = built(root)?;
    let tree = Tree::read(root);
    let (mut tried, mut untried, mut stale) = (0, 0, 0);
    for file in tree.under("", ".md").filter(|file| *file == "README.md" || file.starts_with("docs/")) {
        let mut lines: Vec<String> = tree.text(file).unwrap_or_default().lines().map(String::from).collect();
        let mut changed = false;
        // A page may write a file that another one writes too.
        let desk = desk(root)?;
        for sample in samples(&lines).into_iter().rev() {
            if !stands_alone(&sample.words) {
                untried += 1;
                continue;
            }
            tried += 1;
            let shown: Vec<&str> =
                sample.shown.clone().filter_map(|at| lines.get(at)).map(|line| line.trim_end()).collect();
            let answers = answers(&desk, &program, &sample.words)?;
            // A terminal shows stderr and stdout in either order.
            let pairs = answers.iter().map(|answer| (answer, departures(&shown, answer)));
            let Some((answer, found)) = pairs.min_by_key(|(_, found)| found.len()) else { continue };
            for Departure { at, instead } in found.into_iter().rev() {
                let place = sample.shown.start + at.start..sample.shown.start + at.end;
                let given = instead.and_then(|range| answer.get(range));
                if let Some(given) = given.filter(|_| rewrite) {
                    lines.splice(place, given.iter().cloned());
                    changed = true;
                } else {
                    stale += 1;
                    println!("{file}:{}: shown, but not given:", place.start + 1);
                    lines.get(place).unwrap_or_default().iter().for_each(|line| println!("  - {line}"));
                    given.unwrap_or_default().iter().for_each(|line| println!("  + {line}"));
                }
            }
        }
        if changed {
            let path = root.join(file);
            fs::write(&path, lines.join("\n") + "\n").map_err(|source| Error::File { path, source })?;
        }
    }
    eprintln!("samples: {tried} compared with the program; {untried} read files that only their page describes");
    if stale > 0 {
        return Err(Error::Samples { count: stale });
    }
    if tried == 0 { Err(Error::NoReadmeCommand) } else { Ok(()) }
}

/// Returns the path of the program.
pub(crate) fn built(root: &Path) -> Result<std::path::PathBuf, Error> {
    program(root, "antrieb")
}

struct Sample {
    words: Vec<String>,
    /// Lines of the document that show the answer.
    shown: Range<usize>,
}

fn samples(lines: &[String]) -> Vec<Sample> {
    let mut found: Vec<Sample> = Vec::new();
    let (mut fenced, mut open) = (false, false);
    for (number, line) in lines.iter().enumerate() {
        if line.starts_with("```") {
            fenced = line == "```console";
            open = false;
        } else if let Some(command) = line.strip_prefix(PROMPT).filter(|_| fenced) {
            let words = command.strip_prefix(PROGRAM).and_then(|words| split(words).ok());
            let words: Option<Vec<String>> =
                words.and_then(|words| words.into_iter().map(|word| word.text()).collect());
            open = words.is_some();
            found.extend(words.map(|words| Sample { words, shown: number + 1..number + 1 }));
        } else if let Some(sample) = found.last_mut().filter(|_| open) {
            sample.shown.end = number + 1;
        }
    }
    found.retain(|sample| !sample.shown.is_empty());
    found
}

/// Returns `true` if a command reads no other files than the examples.
fn stands_alone(words: &[String]) -> bool {
    words.iter().filter(|word| word.ends_with(".toml")).all(|word| word.starts_with("examples/"))
}

/// Runs a command and returns its output: stdout only if JSON is requested, else stdout and stderr in both orders.
fn answers(desk: &Path, program: &Path, words: &[String]) -> Result<Vec<Vec<String>>, Error> {
    let mut command = Command::new(program);
    command.args(words).current_dir(desk).env("COLUMNS", "100").env_remove("ANTRIEB_LANG").stdin(Stdio::null());
    let output = command.output().map_err(|source| Error::NotStarted { command: words.join(" "), source })?;
    let lines = |bytes: &[u8]| -> Vec<String> {
        String::from_utf8_lossy(bytes).lines().map(|line| line.trim_end().to_owned()).collect()
    };
    let (answer, talk) = (lines(&output.stdout), lines(&output.stderr));
    if words.iter().any(|word| word == "--json") {
        return Ok(vec![answer]);
    }
    Ok(vec![[answer.clone(), talk.clone()].concat(), [talk, answer].concat()])
}

/// A block of shown lines that the program does not print, and the most similar lines of the answer.
#[derive(Debug, PartialEq)]
struct Departure {
    at: Range<usize>,
    instead: Option<Range<usize>>,
}

/// Returns the blocks that differ. Between two gaps the lines shown must be consecutive lines of the answer; the first
/// block begins with the answer and the last one ends with it, unless a gap stands there.
fn departures(shown: &[&str], answer: &[String]) -> Vec<Departure> {
    let is_gap = |line: &&str| line.trim() == GAP;
    let mut found = Vec::new();
    let (mut next, mut start) = (0, 0);
    for block in shown.split(is_gap) {
        let at = start..start + block.len();
        start = at.end + 1;
        if block.is_empty() {
            continue;
        }
        let (first, last) = (at.start == 0, at.end == shown.len());
        let place = place(block, answer, next, first);
        let whole = place.as_ref().filter(|place| same(block, answer.get((*place).clone()).unwrap_or_default()));
        match whole {
            Some(place) if !last || place.end == answer.len() => next = place.end,
            _ => {
                let instead = place.map(|place| if last { place.start..answer.len() } else { place });
                next = instead.as_ref().map_or(next, |place| place.end);
                found.push(Departure { at, instead });
            }
        }
    }
    found
}

fn same(block: &[&str], given: &[String]) -> bool {
    block.len() == given.len() && block.iter().zip(given).all(|(shown, given)| shown == given)
}

/// Returns the range of a block in the answer from `next` on, or the most similar range.
fn place(block: &[&str], answer: &[String], next: usize, first: bool) -> Option<Range<usize>> {
    let starts = if first { 0..1 } else { next..answer.len() };
    let exact = starts.clone().find(|from| same(block, answer.get(*from..from + block.len()).unwrap_or_default()));
    if let Some(from) = exact {
        return Some(from..from + block.len());
    }
    let likeness = |from: usize| {
        let rest = answer.get(from..).unwrap_or_default();
        block.iter().zip(rest).map(|(shown, given)| like(shown, given)).sum::<f64>()
    };
    // The first of the best.
    let mut best: Option<(usize, f64)> = None;
    for from in starts {
        let likeness = likeness(from);
        if best.is_none_or(|(_, most)| likeness > most) {
            best = Some((from, likeness));
        }
    }
    let (from, _) = best.filter(|(_, likeness)| *likeness >= LIKE * as_f64(block.len()))?;
    // Lines may have been inserted or removed: the block ends at its last line.
    let rest = answer.get(from..).unwrap_or_default();
    let ends = rest.iter().take(2 * block.len() + 2).skip(block.len() / 2);
    let last = block.last().copied().unwrap_or_default();
    let end = ends.enumerate().find(|(_, given)| like(last, given) >= FIGURES_APART);
    let length = end.map_or(block.len(), |(ahead, _)| block.len() / 2 + ahead + 1);
    Some(from..(from + length).min(answer.len()))
}

fn as_f64(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::INFINITY, f64::from)
}

/// Returns the similarity from 0 to 1; nearly 1 for lines that differ only in their numbers.
fn like(shown: &str, given: &str) -> f64 {
    if shown == given {
        return 1.0;
    }
    if without_figures(shown) == without_figures(given) {
        return FIGURES_APART;
    }
    strsim::normalized_levenshtein(shown, given).min(0.9)
}

fn without_figures(line: &str) -> String {
    line.chars().filter(|letter| !letter.is_ascii_digit() && !letter.is_whitespace()).collect()
}

/// Creates an empty folder under the target directory with a copy of `examples/`.
pub(crate) fn desk(root: &Path) -> Result<PathBuf, Error> {
    let desk = Workspace::ask(root)?.target.join("xtask").join("readme");
    if desk.exists() {
        fs::remove_dir_all(&desk).map_err(|source| Error::File { path: desk.clone(), source })?;
    }
    create(&desk)?;
    let examples = root.join("examples");
    if examples.is_dir() {
        copy(&examples, &desk.join("examples"))?;
    }
    Ok(desk)
}

fn create(folder: &Path) -> Result<(), Error> {
    fs::create_dir_all(folder).map_err(|source| Error::File { path: folder.to_path_buf(), source })
}

fn copy(from: &Path, to: &Path) -> Result<(), Error> {
    let file = |source| Error::File { path: from.to_path_buf(), source };
    create(to)?;
    for entry in fs::read_dir(from).map_err(file)? {
        let entry = entry.map_err(file)?;
        let target = to.join(entry.file_name());
        if entry.file_type().map_err(file)?.is_dir() {
            copy(&entry.path(), &target)?;
        } else {
            fs::copy(entry.path(), target).map_err(file)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(text: &str) -> Vec<String> {
        text.lines().map(String::from).collect()
    }

    #[test]
    fn a_sample_is_a_command_with_its_answer() {
        let page = lines(
            "```console\n$ antrieb size examples/a.toml --name \"x y\"\none\n…\n$ antrieb man\n```\n```sh\n$ antrieb no\nno\n```\n",
        );
        let found = samples(&page);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].words, ["size", "examples/a.toml", "--name", "x y"]);
        assert_eq!(found[0].shown, 2..4);
        assert!(stands_alone(&found[0].words) && !stands_alone(&["check".into(), "heavy.toml".into()]));
    }

    #[test]
    fn an_answer_shown_as_it_is_departs_nowhere() {
        let given = lines("head\n1  58.4\n2  64.2\nfoot\n");
        assert_eq!(departures(&["head", "1  58.4", "2  64.2", "foot"], &given), []);
        assert_eq!(departures(&["head", "…", "2  64.2", "  …"], &given), []);
        let twins = lines("{\n a\n}\n{\n b\n}\n");
        assert_eq!(departures(&["…", "{", " b", "}"], &twins), []);
    }

    #[test]
    fn what_is_no_longer_given_is_reported_with_its_successor() {
        let given = lines("head\n1  58.4\n2  64.2\nfoot\n");
        let departure = |at, instead| [Departure { at, instead }];
        assert_eq!(departures(&["head", "1  58.3", "…"], &given), departure(0..2, Some(0..2)));
        assert_eq!(departures(&["head", "…", "2  64.1", "foot"], &given), departure(2..4, Some(2..4)));
        assert_eq!(departures(&["head", "…", "quite another thing", "…"], &given), departure(2..3, None));
        // A longer answer, and an inserted line.
        assert_eq!(departures(&["head"], &given), departure(0..1, Some(0..4)));
        let given = lines("{\n  \"unit\": \"Nm\",\n  \"part\": \"drive\",\n  \"at\": 0.5\n}\n");
        assert_eq!(
            departures(&["{", "  \"unit\": \"Nm\",", "  \"at\": 0.5", "…"], &given),
            departure(0..3, Some(0..4))
        );
    }
}

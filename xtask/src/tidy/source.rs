//! Rules on Rust source: its length and what must be absent from it.

use std::path::Path;

use super::Finding;
use super::layers::{Room, room};
use super::manifest::Members;
use super::rust_text::{code, lines_with, std_group_names, without_tests};
use super::tree::Tree;

const LINES_MAX: usize = 600;

/// The highest layer that gets everything handed in.
const PURE_LAYER_MAX: u8 = 6;

/// Modules of `std` that reach out of the program.
const STD_MODULES: [&str; 5] = ["fs", "net", "env", "process", "thread"];

/// From this layer on a computation may be shared between scoped threads: fixed parts, and results in the order of the parts.
const SCOPED_THREADS_FROM: u8 = 2;

/// What of `std::thread` is no such sharing: it outlives the call, or looks at the schedule or the machine.
const THREAD_FREE: [&str; 6] =
    ["thread::spawn", "thread::sleep", "thread::current", "thread::park", "thread::yield_now", "available_parallelism"];

/// Names that bring in a clock or a thread's own randomness.
const NAMES: [&str; 3] = ["SystemTime", "Instant", "thread_rng"];

/// The mark of a flaw that was left in, in two parts: this file keeps the rule too.
const MARK: &str = concat!("FIX", "ME");

/// A file that cannot be read in one sitting is two files.
pub(super) fn length(root: &Path) -> Vec<Finding> {
    each(root, "", "length", |text| {
        let lines = text.lines().count();
        let message = format!("{lines} lines, at most {LINES_MAX}: split it by subject");
        (lines > LINES_MAX).then_some((LINES_MAX + 1, message)).into_iter().collect()
    })
}

/// Layers 0 to 6 reach for no file, network, clock, environment or thread, layers 2 to 6 for scoped threads only; build
/// scripts and tests may.
pub(super) fn absences(root: &Path) -> Vec<Finding> {
    let tree = Tree::read(root);
    let pure = |name: &str| matches!(room(name), Some(Room::Layer(layer)) if layer <= PURE_LAYER_MAX);
    let mut findings = Vec::new();
    for member in Members::read(&tree).list.iter().filter(|member| pure(&member.name)) {
        let sources = format!("{}/src", member.folder);
        let files: Vec<(&str, String, Vec<String>)> = tree
            .under(&sources, ".rs")
            .map(|file| {
                let (code, modules) = without_tests(&code(&tree.text(file).unwrap_or_default()));
                (file, code, modules.iter().map(|name| module_stem(file, name)).collect())
            })
            .collect();
        let of_tests = |file: &str| {
            let stems = files.iter().flat_map(|(_, _, stems)| stems);
            stems
                .into_iter()
                .any(|stem| file.strip_prefix(stem.as_str()).is_some_and(|rest| rest == ".rs" || rest.starts_with('/')))
        };
        for (file, code, _) in files.iter().filter(|(file, ..)| !of_tests(file)) {
            let scoped = matches!(room(&member.name), Some(Room::Layer(layer)) if layer >= SCOPED_THREADS_FROM);
            for (line, what) in reaches_out(code, scoped) {
                let message = format!("`{what}` in layers 0 to {PURE_LAYER_MAX}: have it handed in");
                findings.push(Finding { path: (*file).to_owned(), line, rule: "absence", message });
            }
        }
    }
    findings
}

/// Results follow no hash order: the maps and sets of the product are ordered ones.
pub(super) fn hash_order(root: &Path) -> Vec<Finding> {
    each(root, "crates", "hash-order", |text| {
        let code = code(text);
        let told = |(word, instead): (&'static str, &'static str)| {
            let message = format!("`{word}` has no order: use `{instead}`");
            lines_with(&code, word).into_iter().map(move |line| (line, message.clone()))
        };
        [("HashMap", "BTreeMap"), ("HashSet", "BTreeSet")].into_iter().flat_map(told).collect()
    })
}

/// Nothing is left for later in the tree: no `todo!`, no `unimplemented!`, no mark of a known flaw.
pub(super) fn markers(root: &Path) -> Vec<Finding> {
    let mut findings = each(root, "", "marker", |text| {
        let code = code(text);
        ["todo!", "unimplemented!"]
            .into_iter()
            .flat_map(|word| {
                let message = format!("`{word}` is unfinished work");
                lines_with(&code, word).into_iter().map(move |line| (line, message.clone()))
            })
            .collect()
    });
    let tree = Tree::read(root);
    for file in tree.files() {
        for line in lines_with(&tree.text(file).unwrap_or_default(), MARK) {
            let message = format!("`{MARK}`: mend it or open an issue");
            findings.push(Finding { path: file.to_owned(), line, rule: "marker", message });
        }
    }
    findings
}

/// A test runs or goes, and so does a documentation example.
pub(super) fn ignored(root: &Path) -> Vec<Finding> {
    each(root, "", "ignored", |text| {
        let mut found = Vec::new();
        for (number, line) in (1..).zip(code(text).lines()) {
            let attribute = line.split("#[").skip(1).any(|rest| {
                let path = rest.split(']').next().unwrap_or_default();
                path.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == "ignore")
            });
            if attribute {
                found.push((number, String::from("an ignored test: let it run or remove it")));
            }
        }
        for (number, line) in (1..).zip(text.lines().map(str::trim_start)) {
            let comment = line.starts_with("///") || line.starts_with("//!");
            let fence = line.split_once("```").map(|(_, info)| info);
            if comment && fence.is_some_and(|info| info.split(',').any(|word| word.trim() == "ignore")) {
                found.push((number, String::from("an ignored example: let it compile or mark it `text`")));
            }
        }
        found
    })
}

/// Applies a check to every Rust file under a folder.
fn each(root: &Path, folder: &str, rule: &'static str, check: impl Fn(&str) -> Vec<(usize, String)>) -> Vec<Finding> {
    let tree = Tree::read(root);
    let mut findings = Vec::new();
    for file in tree.under(folder, ".rs") {
        let told = check(&tree.text(file).unwrap_or_default());
        findings.extend(told.into_iter().map(|(line, message)| Finding { path: file.to_owned(), line, rule, message }));
    }
    findings
}

fn reaches_out(code: &str, scoped_threads: bool) -> Vec<(usize, String)> {
    // The macro of the same name as a module reads the environment of the build, not of the run.
    let code = code.replace("std::env!", "env!");
    let mut found = Vec::new();
    let barred = |module: &str| !(scoped_threads && module == "thread");
    if scoped_threads {
        for name in THREAD_FREE {
            found.extend(lines_with(&code, name).into_iter().map(|line| (line, name.to_owned())));
        }
    }
    for module in STD_MODULES.into_iter().filter(|module| barred(module)) {
        let path = format!("std::{module}");
        found.extend(lines_with(&code, &path).into_iter().map(|line| (line, path.clone())));
    }
    for (line, name) in std_group_names(&code) {
        if STD_MODULES.contains(&name.as_str()) && barred(&name) {
            found.push((line, format!("std::{name}")));
        }
    }
    for name in NAMES {
        found.extend(lines_with(&code, name).into_iter().map(|line| (line, name.to_owned())));
    }
    found
}

/// Where the file or folder of `mod name;` in `file` lies, without its ending.
fn module_stem(file: &str, name: &str) -> String {
    let (folder, last) = file.rsplit_once('/').unwrap_or(("", file));
    match last {
        "lib.rs" | "main.rs" | "mod.rs" => format!("{folder}/{name}"),
        _ => format!("{}/{name}", file.strip_suffix(".rs").unwrap_or(file)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const TOP: (&str, &str) = ("Cargo.toml", "[workspace]\nmembers = [\"crates/*\"]\n");
    const MOTION: (&str, &str) = ("crates/motion/Cargo.toml", "[package]\nname = \"motion\"\n");
    const CLI: (&str, &str) = ("crates/cli/Cargo.toml", "[package]\nname = \"antrieb\"\n");

    fn places(findings: &[Finding]) -> Vec<(&str, usize)> {
        findings.iter().map(|finding| (finding.path.as_str(), finding.line)).collect()
    }

    #[test]
    fn a_long_file_is_found() {
        let (fits, long) = ("\n".repeat(600), "\n".repeat(601));
        let scratch = Scratch::new(&[("a.rs", &fits), ("b.rs", &long), ("c.txt", &long)]);
        assert_eq!(places(&length(scratch.root())), [("b.rs", 601)]);
    }

    #[test]
    fn a_pure_layer_that_reaches_out_is_found() {
        let source = "use std::fs;\nuse std::{env, fmt};\nfn f() { std::net::lookup(); }\nfn g(t: Instant) {}\n\
                      use std::time::SystemTime;\nfn h() { std::thread::spawn(f); rand::thread_rng(); }\n";
        let scratch = Scratch::new(&[TOP, MOTION, ("crates/motion/src/laws/move.rs", source)]);
        let mut lines: Vec<usize> = absences(scratch.root()).iter().map(|found| found.line).collect();
        lines.sort_unstable();
        assert_eq!(lines, [1, 2, 3, 4, 5, 6, 6]);
    }

    #[test]
    fn the_facade_may_share_its_work_between_scoped_threads_only() {
        let workbench = ("crates/workbench/Cargo.toml", "[package]\nname = \"workbench\"\n");
        let source = "fn f() { std::thread::scope(|s| { s.spawn(g); }); }\nfn g() { std::thread::spawn(f); }\n\
                      fn h() { std::thread::sleep(t); std::thread::available_parallelism(); }\nuse std::fs;\n";
        let scratch = Scratch::new(&[TOP, workbench, ("crates/workbench/src/a.rs", source)]);
        let mut lines: Vec<usize> = absences(scratch.root()).iter().map(|found| found.line).collect();
        lines.sort_unstable();
        assert_eq!(lines, [2, 3, 3, 4]);
    }

    #[test]
    fn tests_build_scripts_faces_and_words_may_reach_out() {
        let lib = "//! std::fs is not used\nconst A: &str = env!(\"OUT_DIR\");\n#[cfg(test)]\nmod tests;\n\
                   fn instant() -> &'static str { \"std::net\" }\n#[cfg(test)]\nmod more {\n use std::fs;\n}\n";
        let scratch = Scratch::new(&[
            TOP,
            MOTION,
            CLI,
            ("crates/motion/src/lib.rs", lib),
            ("crates/motion/src/tests.rs", "use std::fs;\n"),
            ("crates/motion/src/tests/deep.rs", "use std::fs;\n"),
            ("crates/motion/tests/all.rs", "use std::fs;\n"),
            ("crates/motion/build.rs", "use std::fs;\n"),
            ("crates/cli/src/main.rs", "use std::fs;\n"),
        ]);
        assert_eq!(absences(scratch.root()), []);
    }

    #[test]
    fn hash_order_is_found_in_every_crate() {
        let source = "// HashMap\nuse std::collections::{HashMap, BTreeMap};\nfn f(s: HashSet<u8>) {}\n";
        let scratch = Scratch::new(&[("crates/cli/src/main.rs", source), ("xtask/src/main.rs", source)]);
        assert_eq!(places(&hash_order(scratch.root())), [("crates/cli/src/main.rs", 2), ("crates/cli/src/main.rs", 3)]);
    }

    #[test]
    fn unfinished_work_is_found() {
        let source = format!("fn f() {{ todo!() }}\nfn g() {{ unimplemented!(\"x\") }}\n// {MARK}\n// todo!\n");
        let scratch = Scratch::new(&[("a.rs", &source), ("data/b.toml", &format!("# {MARK}: digit\n"))]);
        assert_eq!(places(&markers(scratch.root())), [("a.rs", 1), ("a.rs", 2), ("a.rs", 3), ("data/b.toml", 1)]);
    }

    #[test]
    fn ignored_tests_and_examples_are_found() {
        let source = "#[ignore]\n#[ignore = \"slow\"]\n#[cfg_attr(unix, ignore)]\n/// ```ignore\n/// ```text\n\
                      // #[ignore]\n#[test]\nfn ignore() {}\n";
        let scratch = Scratch::new(&[("a.rs", source)]);
        let lines: Vec<usize> = ignored(scratch.root()).iter().map(|found| found.line).collect();
        assert_eq!(lines, [1, 2, 3, 4]);
    }
}

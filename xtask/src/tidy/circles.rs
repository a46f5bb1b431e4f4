//! Rule: the modules of a crate use each other in one direction. The root of a crate, which holds its modules together and
//! what all of them share, is not counted.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::Violation;
use super::one_voice::{SourcePiece, SourceSplitter, product_part};
use super::tree::Tree;

/// Files that still stand in circles, by folder of the crate. A number may only become smaller.
const REMAINING: [(&str, usize); 14] = [
    ("crates/mechanism", 3),
    ("crates/motion", 4),
    ("crates/order-code", 2),
    ("crates/page", 15),
    ("crates/project", 28),
    ("crates/quantities", 4),
    ("crates/questions", 60),
    ("crates/recording", 7),
    ("crates/sizing", 39),
    ("crates/trace", 8),
    ("crates/twin", 27),
    ("crates/words", 5),
    ("fuzz", 3),
    ("xtask", 4),
];

/// Arrows of one crate: a file, the files that it uses, and the names that it uses of each.
type Arrows = BTreeMap<String, BTreeMap<String, BTreeSet<String>>>;

/// Checks the modules of every crate.
pub(super) fn rule(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let mut crates: BTreeMap<&str, Vec<Module>> = BTreeMap::new();
    for file in tree.under("", ".rs") {
        let Some((folder, inside)) = file.split_once("/src/") else { continue };
        if !file.ends_with("tests.rs") && !inside.split('/').any(|part| part == "tests") {
            let text = tree.text(file).unwrap_or_default();
            crates.entry(folder).or_default().push(Module::read(file, inside, product_part(&text)));
        }
    }
    let mut findings = Vec::new();
    for (folder, modules) in &crates {
        let arrows = arrows(modules);
        let circles = circles(&arrows);
        let found = circles.iter().map(Vec::len).sum();
        let listed = REMAINING.iter().find(|(known, _)| known == folder).map_or(0, |(_, number)| *number);
        let violation = |path: &str, message| Violation { path: path.to_owned(), line: 1, rule: "circles", message };
        if listed < found {
            findings
                .extend(circles.iter().filter_map(|circle| Some(violation(circle.first()?, told(circle, &arrows)))));
        }
        if listed > found {
            let message =
                format!("{found} files stand in circles and {listed} are listed in xtask/src/tidy/circles.rs");
            findings.push(violation(folder, message));
        }
    }
    findings
}

/// Returns the arrows of a circle as text.
fn told(circle: &[String], arrows: &Arrows) -> String {
    let mut message = String::from("modules use each other in a circle; move the item that both need below both:");
    for (from, to) in arrows.iter().filter(|(from, _)| circle.contains(from)) {
        for (to, names) in to.iter().filter(|(to, _)| circle.contains(to)) {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            message.push_str(&format!("\n    {from} -> {to}: {}", names.join(", ")));
        }
    }
    message
}

/// Returns the sets of files that reach each other.
fn circles(arrows: &Arrows) -> Vec<Vec<String>> {
    let reached: BTreeMap<&str, BTreeSet<&str>> =
        arrows.keys().map(|from| (from.as_str(), reached(from, arrows))).collect();
    let mut circles: Vec<Vec<String>> = Vec::new();
    for (from, ahead) in &reached {
        if !ahead.contains(from) || circles.iter().flatten().any(|file| file == from) {
            continue;
        }
        let back = |file: &&&str| reached.get(**file).is_some_and(|ahead| ahead.contains(from));
        circles.push(ahead.iter().filter(back).map(|file| (*file).to_owned()).collect());
    }
    circles
}

fn reached<'arrows>(from: &str, arrows: &'arrows Arrows) -> BTreeSet<&'arrows str> {
    let mut reached = BTreeSet::new();
    let mut open: Vec<&str> = vec![from];
    while let Some(file) = open.pop() {
        for next in arrows.get(file).into_iter().flat_map(BTreeMap::keys) {
            if reached.insert(next.as_str()) {
                open.push(next);
            }
        }
    }
    reached
}

/// Returns who uses whom among the modules of one crate. A name that a module passes on counts for the module that
/// defines it.
fn arrows(modules: &[Module]) -> Arrows {
    let by_path: BTreeMap<&[String], &Module> = modules.iter().map(|module| (module.path.as_slice(), module)).collect();
    let mut arrows = Arrows::new();
    let root = by_path.get(&[][..]).map_or("", |root| &root.file);
    for module in modules.iter().filter(|module| module.file != root) {
        for path in &module.uses {
            let found = home(path, &by_path, 8);
            if let Some((target, name)) = found.filter(|(target, _)| *target != module.file && *target != root) {
                let of = arrows.entry(module.file.clone()).or_default();
                let _ = of.entry(target.to_owned()).or_default().insert(name);
            }
        }
    }
    arrows
}

/// Returns the file that defines what a path of the crate names, and the name. `left` bounds the number of modules that
/// pass it on.
fn home<'all>(
    path: &[String],
    modules: &BTreeMap<&[String], &'all Module>,
    left: usize,
) -> Option<(&'all str, String)> {
    let (module, rest) = (0..=path.len()).rev().find_map(|length| {
        let (head, rest) = path.split_at_checked(length)?;
        Some((*modules.get(head)?, rest))
    })?;
    let Some((name, rest)) = rest.split_first() else {
        return Some((&module.file, module.path.last().cloned().unwrap_or_default()));
    };
    match module.imports.get(name) {
        // Of another crate.
        Some(None) => None,
        Some(Some(passed_on)) if left > 0 => {
            let path: Vec<String> = passed_on.iter().chain(rest).cloned().collect();
            home(&path, modules, left - 1)
        }
        _ => Some((&module.file, name.clone())),
    }
}

/// A source file as a module of its crate.
#[derive(Debug, Default)]
struct Module {
    file: String,
    path: Vec<String>,
    /// Paths within the crate that the code of the file names.
    uses: Vec<Vec<String>>,
    /// Names from elsewhere that the file imports or passes on, with their paths if they are of the same crate.
    imports: BTreeMap<String, Option<Vec<String>>>,
}

impl Module {
    /// Reads the source with this path below `src`.
    fn read(file: &str, inside: &str, source: &str) -> Self {
        let stem = inside.trim_end_matches(".rs");
        let stem = stem.strip_suffix("/mod").unwrap_or(stem);
        let is_root = ["lib", "main"].contains(&stem);
        let path = if is_root { Vec::new() } else { stem.split('/').map(str::to_owned).collect() };
        let mut reader = Reader { tokens: tokens(source), at: 0, children: BTreeSet::new(), passed_on: Vec::new() };
        let mut module = Self { file: file.to_owned(), path, ..Self::default() };
        reader.children = reader.children();
        reader.read(&mut module);
        for (name, path) in std::mem::take(&mut reader.passed_on) {
            if reader.tokens.iter().filter(|token| **token == name).count() > 1 {
                module.uses.push(path);
            }
        }
        module
    }
}

/// Reader of paths among the tokens of a source.
struct Reader {
    tokens: Vec<String>,
    at: usize,
    /// Modules below this one.
    children: BTreeSet<String>,
    /// Names that the file passes on: used by the file itself if they occur again.
    passed_on: Vec<(String, Vec<String>)>,
}

impl Reader {
    fn token(&self, ahead: usize) -> &str {
        self.tokens.get(self.at + ahead).map_or("", String::as_str)
    }

    fn children(&self) -> BTreeSet<String> {
        let is_child = |three: &&[String]| three.first().is_some_and(|first| first == "mod");
        self.tokens.windows(3).filter(is_child).filter_map(|three| three.get(1).cloned()).collect()
    }

    fn read(&mut self, module: &mut Module) {
        // Modules inside the file: name and depth of braces at which each ends.
        let mut inner: Vec<(String, usize)> = Vec::new();
        let mut depth = 0_usize;
        let mut is_public = false;
        while self.at < self.tokens.len() {
            let here: Vec<String> = module.path.iter().chain(inner.iter().map(|(name, _)| name)).cloned().collect();
            match self.token(0) {
                "{" => depth += 1,
                "}" => {
                    depth = depth.saturating_sub(1);
                    let _ = inner.pop_if(|(_, end)| *end == depth);
                }
                "mod" if self.token(2) == "{" => {
                    inner.push((self.token(1).to_owned(), depth));
                    self.at += 1;
                }
                "use" => {
                    self.at += 1;
                    let mut leaves = Vec::new();
                    self.tree(&[], &mut leaves);
                    for (name, path) in leaves {
                        let path = self.absolute(&path, &here);
                        match &path {
                            Some(path) if is_public => self.passed_on.push((name.clone(), path.clone())),
                            Some(path) => module.uses.push(path.clone()),
                            None => {}
                        }
                        if inner.is_empty() {
                            let _ = module.imports.insert(name, path);
                        }
                    }
                    continue;
                }
                word if is_word(word) && self.token(1) == "::" && !self.is_inside_a_path() => {
                    let mut path = vec![word.to_owned()];
                    while self.token(1) == "::" && is_word(self.token(2)) {
                        path.push(self.token(2).to_owned());
                        self.at += 2;
                    }
                    module.uses.extend(self.absolute(&path, &here));
                }
                _ => {}
            }
            is_public = match self.token(0) {
                "pub" => true,
                "(" | ")" | "crate" | "super" | "self" | "in" | "::" => is_public,
                _ => false,
            };
            self.at += 1;
        }
    }

    fn is_inside_a_path(&self) -> bool {
        self.at.checked_sub(1).and_then(|before| self.tokens.get(before)).is_some_and(|token| token == "::")
    }

    /// Reads a tree of imports behind `head` and leaves the position at the token after it.
    fn tree(&mut self, head: &[String], leaves: &mut Vec<(String, Vec<String>)>) {
        let mut path = head.to_vec();
        loop {
            match self.token(0) {
                "::" => self.at += 1,
                "{" => {
                    self.at += 1;
                    while !["}", ""].contains(&self.token(0)) {
                        self.tree(&path, leaves);
                        self.at += usize::from(self.token(0) == ",");
                    }
                    self.at += 1;
                    return;
                }
                "*" => {
                    self.at += 1;
                    leaves.push((String::from("*"), path));
                    return;
                }
                "self" if !path.is_empty() => self.at += 1,
                word if is_word(word) && word != "as" => {
                    path.push(word.to_owned());
                    self.at += 1;
                }
                _ => break,
            }
        }
        let mut name = path.last().cloned().unwrap_or_default();
        if self.token(0) == "as" {
            name = self.token(1).to_owned();
            self.at += 2;
        }
        // A token that belongs to no tree is passed over, so that the reader always advances.
        self.at +=
            usize::from(path.len() == head.len() && ![",", "}", ";"].contains(&self.token(0)) && head.is_empty());
        leaves.push((name, path));
    }

    /// Returns a path from the root of the crate; `None` if it leads into another crate.
    fn absolute(&self, path: &[String], here: &[String]) -> Option<Vec<String>> {
        let mut base = here.to_vec();
        let mut rest = path;
        match path.first()?.as_str() {
            "crate" => {
                base.clear();
                rest = rest.get(1..)?;
            }
            "self" => rest = rest.get(1..)?,
            "super" => {
                while rest.first().is_some_and(|first| first == "super") {
                    let _ = base.pop();
                    rest = rest.get(1..)?;
                }
            }
            first if self.children.contains(first) => {}
            _ => return None,
        }
        base.extend_from_slice(rest);
        Some(base)
    }
}

fn is_word(token: &str) -> bool {
    token.starts_with(|sign: char| sign.is_alphabetic() || sign == '_')
}

/// Returns the words and signs of the code, without literals and comments.
fn tokens(source: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    for (_, piece) in SourceSplitter::of(source) {
        let SourcePiece::Code(code) = piece else { continue };
        let mut rest = code.as_str();
        while let Some(sign) = rest.chars().next() {
            let word = rest.find(|sign: char| !sign.is_alphanumeric() && sign != '_').unwrap_or(rest.len());
            let length = if rest.starts_with("::") { 2 } else { word.max(sign.len_utf8()) };
            let (token, behind) = rest.split_at_checked(length).unwrap_or((rest, ""));
            if !sign.is_whitespace() {
                tokens.push(token.to_owned());
            }
            rest = behind;
        }
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    fn found(files: &[(&str, &str)]) -> Vec<String> {
        rule(Scratch::new(files).root()).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn two_modules_that_use_each_other_are_found() {
        let found = found(&[
            ("crates/a/src/lib.rs", "mod b;\nmod c;\npub use b::B;\npub use c::{C, D as E};\n"),
            ("crates/a/src/b.rs", "use crate::{E, other};\npub struct B(E);\n"),
            ("crates/a/src/c.rs", "pub struct C;\npub struct D;\nfn f() -> super::B { super::B(D) }\n"),
        ]);
        assert_eq!(found.len(), 1, "{found:#?}");
        assert!(found[0].starts_with("crates/a/src/b.rs:1: circles"));
        assert!(found[0].contains("crates/a/src/b.rs -> crates/a/src/c.rs: D"));
        assert!(found[0].contains("crates/a/src/c.rs -> crates/a/src/b.rs: B"));
    }

    #[test]
    fn a_parent_and_its_child_are_found() {
        let parent = "mod child;\nmod inner { use super::child::g; }\npub struct P;\nfn f() { child::g(); }\n";
        let child = "use super::P;\npub fn g() {}\n";
        assert_eq!(found(&[("a/src/p.rs", parent), ("a/src/p/child.rs", child)]).len(), 1);
        let child = "use std::{self, fmt::{self, Debug}};\nuse super::super::other::P;\npub fn g() {}\n";
        assert_eq!(found(&[("a/src/p.rs", parent), ("a/src/p/child.rs", child)]).len(), 0);
    }

    #[test]
    fn a_listed_number_only_becomes_smaller() {
        let (folder, number) = REMAINING[0];
        let path = format!("{folder}/src/lib.rs");
        let found = found(&[(path.as_str(), "")]);
        assert_eq!(found.len(), 1);
        assert!(found[0].contains(&format!("0 files stand in circles and {number} are listed")), "{found:?}");
    }

    #[test]
    fn tests_comments_and_passed_on_names_make_no_circle() {
        let found = found(&[
            ("a/src/lib.rs", "mod b;\nmod c;\npub use b::{B, b};\n"),
            ("a/src/b.rs", "// crate::c::C\nuse crate::c::C;\npub struct B(C);\n"),
            (
                "a/src/c.rs",
                "pub struct C;\nconst X: &str = \"crate::b::B\";\n#[cfg(test)]\nmod tests { use crate::b::B; }\n",
            ),
            ("a/src/c_tests.rs", "use crate::b::B;\n"),
        ]);
        assert_eq!(found.len(), 0, "{found:#?}");
    }
}

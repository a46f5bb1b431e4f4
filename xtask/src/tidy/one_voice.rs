//! Rule: every sentence for a user is in `words`, in both languages, and is used by its name.

use std::path::Path;

use super::Violation;
use super::tree::Tree;

/// Source folder of the texts.
const WORDS: &str = "crates/words/src";

/// Sources that may distinguish the languages or hold German, with the reason for each.
const EXEMPT: [(&str, &str); 4] = [
    ("crates/quantities/src/lib.rs", "what the languages are"),
    ("crates/quantities/src/format.rs", "numbers in the signs of a language"),
    ("crates/series-files/src/facts.rs", "keys of the files of facts"),
    ("crates/quantities/src/dimension.rs", "names of dimensions, beside their units"),
];

/// Expressions that distinguish the languages.
const CHOICES: [&str; 4] = ["Language::En", "Language::De", "Language::{", "Language::*"];

/// Letters and quotation marks that occur in German only.
const GERMAN: [char; 9] = ['ä', 'ö', 'ü', 'Ä', 'Ö', 'Ü', 'ß', '„', '“'];

/// Checks that no product source outside `words` selects a language or contains German text; the same for the template
/// of the report.
pub(super) fn choices(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let mut findings = Vec::new();
    for file in tree.under("crates", ".rs").filter(|file| is_product(file) && !file.starts_with(WORDS)) {
        if EXEMPT.iter().any(|(exempt, _)| *exempt == file) {
            continue;
        }
        for (line, part) in SourceSplitter::of(product_part(&tree.text(file).unwrap_or_default())) {
            let found = match part {
                SourcePiece::Code(code) => {
                    CHOICES.iter().find(|choice| code.contains(**choice)).map(|choice| (*choice).to_owned())
                }
                SourcePiece::Literal(text) if text == "de" => Some("\"de\"".to_owned()),
                SourcePiece::Literal(text) => text.chars().find(|sign| GERMAN.contains(sign)).map(String::from),
            };
            findings.extend(found.map(|found| choice(file, line, &found)));
        }
    }
    for file in tree.under("crates/report/template", ".typ") {
        for (line, content) in (1..).zip(tree.text(file).unwrap_or_default().lines()) {
            let marks = ["lang ==", "lang !=", "\"de\"", "\"en\""];
            let found = marks.into_iter().find(|mark| content.contains(mark)).map(str::to_owned);
            let found = found.or_else(|| content.chars().find(|sign| GERMAN.contains(sign)).map(String::from));
            findings.extend(found.map(|found| choice(file, line, &found)));
        }
    }
    findings
}

fn choice(file: &str, line: usize, found: &str) -> Violation {
    let message = format!("`{found}`: a text that depends on the language stands in {WORDS} and is used by its name");
    Violation { path: file.to_owned(), line, rule: "one-voice", message }
}

/// Checks that every named text of `words` is used by its module and name. Texts of the report are used by its
/// template, which a test of the report checks.
pub(super) fn unused(root: &Path) -> Vec<Violation> {
    let tree = Tree::read(root);
    let sources: Vec<(&str, String)> = tree
        .under("crates", ".rs")
        .filter(|file| is_product(file))
        .map(|file| (file, product_part(&tree.text(file).unwrap_or_default()).to_owned()))
        .collect();
    let mut findings = Vec::new();
    for file in tree.under(WORDS, ".rs") {
        let module = file.rsplit('/').next().unwrap_or_default().trim_end_matches(".rs");
        if module == "report" {
            continue;
        }
        for (line, name) in names(&tree.text(file).unwrap_or_default()) {
            let outside = format!("{module}::{name}");
            let used = sources.iter().any(|(other, text)| {
                holds(text, &outside) || (*other == file && text.lines().any(|line| holds(line, &format!("{name},"))))
            });
            if !used {
                let message = format!("`{outside}` is not used: delete it");
                findings.push(Violation { path: file.to_owned(), line, rule: "unused-text", message });
            }
        }
    }
    findings
}

/// Returns the names in the `texts!` of a source, with their lines.
fn names(text: &str) -> Vec<(usize, String)> {
    let mut inside = false;
    let mut found = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        match content {
            "texts! {" => inside = true,
            "}" => inside = false,
            _ => {
                let indented = content.strip_prefix("    ").filter(|_| inside);
                let name = indented.and_then(|rest| rest.split_once(" =")).map(|(head, _)| head);
                let name = name.map(|head| head.split('(').next().unwrap_or_default());
                let is_name = |name: &&str| {
                    !name.is_empty() && name.bytes().all(|byte| matches!(byte, b'a'..=b'z' | b'0'..=b'9' | b'_'))
                };
                found.extend(name.filter(is_name).map(|name| (line, name.to_owned())));
            }
        }
    }
    found
}

/// Returns `true` if a text contains a name as a whole word.
fn holds(text: &str, name: &str) -> bool {
    let word = |sign: char| sign.is_alphanumeric() || sign == '_';
    text.match_indices(name).any(|(at, _)| {
        let before = text.get(..at).unwrap_or_default().chars().next_back();
        let after = text.get(at + name.len()..).unwrap_or_default().chars().next();
        !before.is_some_and(word) && !after.is_some_and(word)
    })
}

/// Returns `true` for a source of the product: no test, and no crate for tests.
fn is_product(file: &str) -> bool {
    file.contains("/src/") && !file.starts_with("crates/testkit/") && !file.ends_with("tests.rs")
}

/// Returns a source without its tests, which stand last.
pub(super) fn product_part(text: &str) -> &str {
    text.find("#[cfg(test)]\nmod ").and_then(|at| text.get(..at)).unwrap_or(text)
}

/// A piece of a source within one line.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum SourcePiece {
    /// Text outside literals and comments.
    Code(String),
    /// Text inside a literal.
    Literal(String),
}

/// Splitter of a source into code and literals, without comments.
pub(super) struct SourceSplitter {
    parts: Vec<(usize, SourcePiece)>,
    line: usize,
    text: String,
}

impl SourceSplitter {
    pub(super) fn of(source: &str) -> Vec<(usize, SourcePiece)> {
        let mut parts = Self { parts: Vec::new(), line: 1, text: String::new() };
        let mut signs = source.chars().peekable();
        while let Some(sign) = signs.next() {
            match sign {
                '/' if signs.peek() == Some(&'/') => while signs.next_if(|sign| *sign != '\n').is_some() {},
                '"' => {
                    // `r`, `r#` etc. stand before it; the same number of marks ends it, and a backslash has no meaning
                    // inside.
                    let marks = parts.text.chars().rev().take_while(|sign| *sign == '#').count();
                    let raw = parts.text.trim_end_matches('#').ends_with('r');
                    parts.end(SourcePiece::Code);
                    let end: String = std::iter::once('"').chain(std::iter::repeat_n('#', marks)).collect();
                    while let Some(sign) = signs.next() {
                        match sign {
                            '\\' if !raw => parts.text.extend(signs.next().filter(|next| *next != '\n')),
                            '\n' => {
                                parts.end(SourcePiece::Literal);
                                parts.line += 1;
                            }
                            _ => parts.text.push(sign),
                        }
                        if !raw && sign == '"' {
                            let _ = parts.text.pop();
                            break;
                        }
                        if raw && parts.text.ends_with(&end) {
                            parts.text.truncate(parts.text.len() - end.len());
                            break;
                        }
                    }
                    parts.end(SourcePiece::Literal);
                }
                // A character; a lifetime has no second quotation mark.
                '\'' => {
                    let ahead: String = signs.clone().take(3).collect();
                    let long = ahead.starts_with('\\');
                    if long || ahead.chars().nth(1) == Some('\'') {
                        parts.end(SourcePiece::Code);
                        parts.text.extend(signs.next());
                        if long {
                            parts.text.clear();
                            parts.text.extend(signs.next());
                        }
                        parts.end(SourcePiece::Literal);
                        while signs.next_if(|sign| *sign != '\'').is_some() {}
                        let _ = signs.next();
                    }
                }
                '\n' => {
                    parts.end(SourcePiece::Code);
                    parts.line += 1;
                }
                _ => parts.text.push(sign),
            }
        }
        parts.end(SourcePiece::Code);
        parts.parts
    }

    fn end(&mut self, part: fn(String) -> SourcePiece) {
        let text = std::mem::take(&mut self.text);
        if !text.trim().is_empty() {
            self.parts.push((self.line, part(text)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    fn places(findings: &[Violation]) -> Vec<(&str, usize)> {
        findings.iter().map(|finding| (finding.path.as_str(), finding.line)).collect()
    }

    #[test]
    fn a_source_is_taken_apart() {
        let source = "let a = \"x \\\" // y\"; // \"no\"\nlet b: &'static str = r#\"p \"q\" \\\"#; 'ß'; '\\n'";
        let literals: Vec<(usize, String)> = SourceSplitter::of(source)
            .into_iter()
            .filter_map(|(line, part)| match part {
                SourcePiece::Literal(text) => Some((line, text)),
                SourcePiece::Code(_) => None,
            })
            .collect();
        let expected = [(1, "x \" // y"), (2, "p \"q\" \\"), (2, "ß"), (2, "n")];
        assert_eq!(literals, expected.map(|(line, text)| (line, text.to_owned())));
    }

    #[test]
    fn a_face_that_chooses_between_the_languages_is_found() {
        let face = "/// Größe\nfn head(l: Language) -> &'static str {\n    // Größe\n    match l { Language::En => \"size\",\n        _ => \"Größe\" }\n}\n\n#[cfg(test)]\nmod tests { const L: Language = Language::De; }\n";
        let other = "fn is_german(l: Language) -> bool { l.id() == \"de\" }\n";
        let scratch = Scratch::new(&[
            ("crates/cli/src/size.rs", face),
            ("crates/cli/src/other.rs", other),
            ("crates/cli/tests/size.rs", face),
            ("crates/words/src/terms.rs", face),
            ("crates/report/template/a.typ", "#let a = t(\"a\")\n#if lang == \"de\" [Maße]\n"),
        ]);
        let found = choices(scratch.root());
        let expected = [
            ("crates/cli/src/other.rs", 1),
            ("crates/cli/src/size.rs", 4),
            ("crates/cli/src/size.rs", 5),
            ("crates/report/template/a.typ", 2),
        ];
        assert_eq!(places(&found), expected, "{found:#?}");
    }

    #[test]
    fn an_unused_text_is_found() {
        let words = "texts! {\n    asked = \"a\" | \"b\";\n    left(count) =\n        \"c\"\n        | \"d\";\n    half = \"e\";\n}\n";
        let face = "fn f() { terms::asked(l); terms::half_life(l) }\n";
        let scratch = Scratch::new(&[("crates/words/src/terms.rs", words), ("crates/cli/src/a.rs", face)]);
        let found = unused(scratch.root());
        assert_eq!(places(&found), [("crates/words/src/terms.rs", 3), ("crates/words/src/terms.rs", 6)]);
    }
}

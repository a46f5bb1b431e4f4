//! Rule: documents, comments and messages avoid the words listed in STYLE.md; texts for readers of the product use one
//! term per thing, in both languages.

use std::path::Path;

use super::Violation;
use super::one_voice::{SourcePiece, SourceSplitter};
use super::tree::Tree;

const STYLE: &str = "STYLE.md";
/// Section of STYLE.md with the words in the first column of its table, as code.
const SECTION: &str = "### Words that are not used";
/// Section of STYLE.md with the terms replaced by those of the glossary.
const TERMS: &str = "### Terms that are not used";
/// Texts of the product for its readers: documents, then data with texts in both languages.
const READ: [&str; 8] = [
    "README.md",
    "docs/guide/",
    "docs/anleitung/",
    "docs/theorie/",
    "docs/concepts/",
    "data/cha/facts/",
    "data/cha/code.toml",
    "data/cha/family.toml",
];
/// Messages of the product.
const MESSAGES: &str = "crates/words/src/";
/// Texts of third parties, and texts about earlier versions.
const FREE: [&str; 3] = ["CHANGELOG.md", "THIRD-PARTY.md", "third-party/"];
/// Files not yet reworded.
const PENDING: [&str; 0] = [];

pub(super) fn rule(root: &Path) -> Vec<Violation> {
    findings(root, &PENDING)
}

/// Returns the listed words and terms that occur in the files, except in pending ones.
fn findings(root: &Path, pending: &[&str]) -> Vec<Violation> {
    let tree = Tree::read(root);
    let style = tree.text(STYLE).unwrap_or_default();
    let (phrases, terms) = (phrases(&style, SECTION), phrases(&style, TERMS));
    let mut findings = Vec::new();
    for file in tree.under("", ".md").chain(tree.under("", ".rs")).chain(tree.under("", ".toml")) {
        if FREE.iter().chain(pending).any(|free| file.starts_with(free)) {
            continue;
        }
        let text = tree.text(file).unwrap_or_default();
        for (line, phrase) in found(&read(file, &text), &terms) {
            let message = format!("`{phrase}` has another term in its place ({STYLE}, {TERMS})");
            findings.push(Violation { path: file.to_owned(), line, rule: "one-term", message });
        }
        if file.ends_with(".toml") {
            continue;
        }
        let prose = if file.ends_with(".md") { document(&text) } else { comments(&text) };
        let messages = if file.starts_with(MESSAGES) { literals(&text) } else { Vec::new() };
        for (line, phrase) in [prose, messages].iter().flat_map(|words| found(words, &phrases)) {
            let message = format!("`{phrase}` is on the list of words that are not used ({STYLE})");
            findings.push(Violation { path: file.to_owned(), line, rule: "plain-words", message });
        }
    }
    findings
}

/// Returns the words of a file seen by a reader of the product; empty for other files.
fn read(file: &str, text: &str) -> Vec<Word> {
    match file.rsplit('.').next() {
        Some("rs") if file.starts_with(MESSAGES) => texts(text),
        Some("md") if READ.iter().any(|read| file.starts_with(read)) => document(&without_targets(text)),
        Some("toml") if READ.iter().any(|read| file.starts_with(read)) => values(text),
        _ => Vec::new(),
    }
}

/// Returns the words of the texts in a source, without identifiers.
fn texts(text: &str) -> Vec<Word> {
    let is_sign = |sign: char| sign.is_ascii_lowercase() || sign.is_ascii_digit() || "_-".contains(sign);
    let mut words = Vec::new();
    for (line, part) in SourceSplitter::of(text) {
        if let SourcePiece::Literal(literal) = part
            && !literal.chars().all(is_sign)
        {
            words_of(line, &literal, &mut words);
        }
        words.push((line, None));
    }
    words
}

/// Returns a document without the targets of its links, which are names of files.
fn without_targets(text: &str) -> String {
    let mut pieces = text.split("](");
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |kept, piece| kept + "]" + piece.split_once(')').map_or(piece, |(_, rest)| rest))
}

/// Returns the words of the English and German texts of a data file.
fn values(text: &str) -> Vec<Word> {
    let mut words = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        if content.starts_with("en = ") || content.starts_with("de = ") {
            words_of(line, content, &mut words);
        }
        words.push((line, None));
    }
    words
}

/// Returns the phrases of a list, each as its words.
fn phrases(style: &str, section: &str) -> Vec<Vec<String>> {
    let section = style.lines().skip_while(|line| *line != section).skip(1).take_while(|line| !line.starts_with('#'));
    let first = section.filter_map(|line| line.strip_prefix("| `")?.split('|').next());
    let phrases = first.flat_map(|cell| cell.split('`').step_by(2));
    let phrases = phrases.map(|phrase| phrase.split_whitespace().map(str::to_owned).collect::<Vec<_>>());
    phrases.filter(|phrase| phrase.first().is_some_and(|word| word != ",")).collect()
}

/// A word of a prose with its line; `None` where a sentence is interrupted.
type Word = (usize, Option<String>);

fn words_of(line: usize, prose: &str, words: &mut Vec<Word>) {
    // Every second piece is a code span.
    for (piece, text) in prose.split('`').enumerate() {
        if piece % 2 == 1 {
            words.push((line, None));
            continue;
        }
        let parts = text.split(|sign: char| !sign.is_alphanumeric() && sign != '_' && sign != '\'');
        words.extend(parts.filter(|part| !part.is_empty()).map(|part| (line, Some(part.to_lowercase()))));
        if text.trim_end().ends_with(['.', ':', ';', '|']) {
            words.push((line, None));
        }
    }
}

/// Returns the words of a Markdown document without its code blocks.
fn document(text: &str) -> Vec<Word> {
    let mut words = Vec::new();
    let mut fenced = false;
    for (line, content) in (1..).zip(text.lines()) {
        if content.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            words_of(line, content, &mut words);
            if content.is_empty() {
                words.push((line, None));
            }
        }
    }
    words
}

/// Returns the words of the comments of a source that stand on lines of their own.
fn comments(text: &str) -> Vec<Word> {
    let mut words = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        match content.trim_start().strip_prefix("//") {
            Some(comment) => words_of(line, comment.trim_start_matches(['/', '!']), &mut words),
            None => words.push((line, None)),
        }
    }
    words
}

/// Returns the words of the texts in a source.
fn literals(text: &str) -> Vec<Word> {
    let mut words = Vec::new();
    for (line, part) in SourceSplitter::of(text) {
        if let SourcePiece::Literal(literal) = part {
            words_of(line, &literal, &mut words);
        }
        words.push((line, None));
    }
    words
}

/// Returns the lines where a phrase begins, with the phrase.
fn found(words: &[Word], phrases: &[Vec<String>]) -> Vec<(usize, String)> {
    let begins = |at: usize, phrase: &[String]| words.get(at..).is_some_and(|rest| matches(rest, phrase));
    let lines = words.iter().enumerate().flat_map(|(at, (line, _))| {
        phrases.iter().filter(move |phrase| begins(at, phrase)).map(|phrase| (*line, phrase.join(" ")))
    });
    lines.collect()
}

fn matches(words: &[Word], phrase: &[String]) -> bool {
    match phrase.split_first() {
        None => true,
        Some((first, rest)) if first == "…" => (1..=2).any(|count| {
            let skipped = words.get(..count).is_some_and(|skipped| skipped.iter().all(|(_, word)| word.is_some()));
            skipped && words.get(count..).is_some_and(|after| matches(after, rest))
        }),
        Some((first, rest)) => match words.split_first() {
            Some(((_, Some(word)), after)) => is_word(word, first) && matches(after, rest),
            _ => false,
        },
    }
}

/// Returns `true` if a word equals that of a phrase; a trailing `*` matches any ending.
fn is_word(word: &str, phrase: &str) -> bool {
    phrase.strip_suffix('*').map_or(word == phrase, |begin| word.starts_with(begin))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::scratch::Scratch;

    const LIST: &str = "# Style\n\n### Words that are not used\n\nNot told.\n\n| not | instead |\n|---|---|\n| `told`, `asked for` | reported |\n| `what … has` | content |\n\n## Errors\n\n| `limit` | x |\n";

    fn places(files: &[(&str, &str)]) -> Vec<String> {
        let scratch = Scratch::new(&[&[(STYLE, LIST)], files].concat());
        let mut found = findings(scratch.root(), &[]);
        found.retain(|finding| finding.path != STYLE);
        found.sort();
        let place = |finding: &Violation| {
            let phrase = finding.message.split_inclusive('`').take(2).collect::<String>();
            format!("{}:{} {phrase}", finding.path, finding.line)
        };
        found.iter().map(place).collect()
    }

    #[test]
    fn a_word_of_the_list_is_found_in_documents_comments_and_messages() {
        let source = "/// Who is asked\n/// for a limit.\nfn told() { call(\"told\") } // told\n";
        let found = places(&[
            (
                "docs/a.md",
                "It is Told.\n\n`told`, retold, the limit\n\n```\ntold\n```\n\nwhat the file has, what a long file has\n",
            ),
            ("crates/cli/src/a.rs", source),
            ("crates/words/src/a.rs", "const A: &str = \"you are told\";\n"),
            ("CHANGELOG.md", "told\n"),
        ]);
        let expected = [
            "crates/cli/src/a.rs:1 `asked for`",
            "crates/words/src/a.rs:1 `told`",
            "docs/a.md:1 `told`",
            "docs/a.md:9 `what … has`",
        ];
        assert_eq!(found, expected, "{found:#?}");
    }

    #[test]
    fn a_term_is_held_where_a_reader_of_the_product_sees_it() {
        let list = format!(
            "{LIST}\n### Terms that are not used\n\n| not | instead |\n|---|---|\n| `reibzahl*`, `screw joint*` | x |\n"
        );
        let scratch = Scratch::new(&[
            (STYLE, list.as_str()),
            ("docs/anleitung/a.md", "Die Reibzahlen, `Reibzahl`, Reibungszahl\n"),
            ("docs/theory/a.md", "A screw joint.\n"),
            ("crates/words/src/a.rs", "// a screw joint\nconst A: &str = \"the screw joints\";\n"),
            ("crates/cli/src/a.rs", "const A: &str = \"the screw joints\";\n"),
            ("data/cha/facts/a.toml", "id = \"screw joint\"\nen = \"A screw joint.\"\nde = \"Die Reibzahl.\"\n"),
        ]);
        let mut found = findings(scratch.root(), &[]);
        found.retain(|finding| finding.rule == "one-term");
        found.sort();
        let places: Vec<String> =
            found.iter().map(|each| format!("{}:{} {}", each.path, each.line, each.rule)).collect();
        let expected = [
            "crates/words/src/a.rs:2 one-term",
            "data/cha/facts/a.toml:2 one-term",
            "data/cha/facts/a.toml:3 one-term",
            "docs/anleitung/a.md:1 one-term",
        ];
        assert_eq!(places, expected, "{found:#?}");
    }

    #[test]
    fn the_list_of_the_house_is_read() {
        let style = include_str!("../../../STYLE.md");
        assert!(phrases(style, TERMS).iter().any(|phrase| phrase == &["reibzahl*"]));
        let phrases = phrases(style, SECTION);
        assert!(phrases.iter().any(|phrase| phrase == &["nobody"]), "{phrases:#?}");
        assert!(phrases.iter().any(|phrase| phrase == &["what", "…", "has"]), "{phrases:#?}");
    }
}

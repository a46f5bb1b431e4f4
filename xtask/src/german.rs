//! Spelling of the German documents.
//!
//! A word is known if it stands in the list of German words that `tools` installs (forms of Wikidata's lexemes, without regard to
//! capitals and to ß for ss) or in `german-words.txt`, which holds the terms of the field and what that list lacks; if it is such a word
//! with an ending of the declension; or if it is put together from known words of four letters and more, with an s between them
//! or without. Code, formulas and words with capitals inside are not read. What this cannot tell: a slip that is a word itself,
//! capitals, grammar. Beside it no document says a word that `data/glossary.toml` keeps out for one thing.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use crate::Error;
use crate::book::is_german;
use crate::markdown::Document;
use crate::tidy::tree::Tree;
use crate::tools;

/// Words beside the list, one to a line, in order.
const OWN: &str = "xtask/german-words.txt";
/// What an adjective, a participle or a noun may end in.
const ENDINGS: [&str; 12] = ["e", "en", "er", "es", "em", "s", "n", "ere", "eren", "erer", "eres", "sten"];
/// Shorter pieces are found in any word.
const SHORTEST_PART: usize = 4;
/// More of them are put together by chance.
const MOST_PARTS: usize = 4;

/// Reads every German document.
///
/// # Errors
/// When the list of words is missing, or a word is not known; all of them are printed first.
pub fn run(root: &Path) -> Result<(), Error> {
    let tree = Tree::read(root);
    let words = Words::read(root, &tree)?;
    let (mut count, mut read) = (0, BTreeSet::new());
    for file in tree.under("docs", ".md").filter(|file| is_german(file)) {
        let text = tree.text(file).unwrap_or_default();
        for (line, word) in of_document(&text) {
            read.insert(folded(&word));
            if !words.knows(&word) {
                println!("{file}:{line}: `{word}`");
                count += 1;
            }
        }
        for (line, twin) in kept_out(&text) {
            println!("{file}:{line}: `{twin}` is kept out by data/glossary.toml");
            count += 1;
        }
    }
    for own in words.needless(&read) {
        println!("{OWN}: `{own}` stands in no document, or is known without it");
        count += 1;
    }
    eprintln!("german: {} different words read", read.len());
    if count > 0 { Err(Error::UnknownWords { count }) } else { Ok(()) }
}

/// The words of the running text with their lines.
fn of_document(text: &str) -> Vec<(usize, String)> {
    let document = Document::read(text);
    let mut found = Vec::new();
    for (line, piece) in document.sections.iter().flat_map(|section| &section.prose) {
        // A word with a digit or an underscore in it is a sign.
        let chunks = piece.split_whitespace().filter(|token| !is_path(token));
        let chunks = chunks.flat_map(|token| token.split(|sign: char| !(sign.is_alphanumeric() || sign == '_')));
        for chunk in chunks.filter(|chunk| chunk.chars().all(char::is_alphabetic)) {
            let capitals_inside = chunk.chars().skip(1).any(char::is_uppercase);
            if chunk.chars().count() > 2 && !capitals_inside && chunk.chars().all(is_latin) {
                found.push((*line, chunk.to_owned()));
            }
        }
    }
    found
}

/// Whether a word of the running text is the name of a file: a point with a letter behind it.
fn is_path(token: &str) -> bool {
    token.split('.').skip(1).any(|rest| rest.starts_with(|letter: char| letter.is_ascii_lowercase()))
}

fn is_latin(letter: char) -> bool {
    letter.is_ascii_alphabetic() || "äöüßÄÖÜé".contains(letter)
}

/// Words that the glossary keeps out, where they begin a word.
fn kept_out(text: &str) -> Vec<(usize, &'static str)> {
    let words = of_document(text);
    let twins =
        catalogue::words().iter().flat_map(|word| word.not_de.iter().copied()).filter(|twin| !twin.contains(' '));
    twins
        .flat_map(|twin| {
            let begins = move |word: &str| word.to_lowercase().starts_with(&twin.to_lowercase());
            words.iter().filter(move |(_, word)| begins(word)).map(move |(line, _)| (*line, twin)).collect::<Vec<_>>()
        })
        .collect()
}

/// What is known.
struct Words {
    /// The list that is installed.
    listed: BTreeSet<String>,
    /// Our own beside it.
    own: BTreeSet<String>,
}

impl Words {
    fn read(root: &Path, tree: &Tree) -> Result<Self, Error> {
        let path = tools::german_words(root)?;
        let file = |source| Error::File { path: path.clone(), source };
        let mut text = String::new();
        flate2::read::GzDecoder::new(BufReader::new(File::open(&path).map_err(file)?))
            .read_to_string(&mut text)
            .map_err(file)?;
        let own = tree.text(OWN).unwrap_or_default();
        Ok(Self { listed: text.lines().map(folded).collect(), own: own.lines().map(folded).collect() })
    }

    /// Our own words that the list has too, or that stand in none of the words read.
    fn needless<'w>(&'w self, read: &'w BTreeSet<String>) -> impl Iterator<Item = &'w String> {
        self.own.iter().filter(|own| self.listed.contains(*own) || !read.iter().any(|word| word.contains(own.as_str())))
    }

    fn has(&self, word: &str) -> bool {
        self.listed.contains(word) || self.own.contains(word)
    }

    fn knows(&self, word: &str) -> bool {
        self.put_together(&folded(word), MOST_PARTS)
    }

    /// Whether it is a known word, or known words one behind the other.
    fn put_together(&self, word: &str, parts: usize) -> bool {
        if self.with_ending(word) {
            return true;
        }
        let places = word.char_indices().map(|(at, _)| at).skip(SHORTEST_PART);
        parts > 1
            && places.into_iter().any(|at| {
                let (Some(head), Some(tail)) = (word.get(..at), word.get(at..)) else { return false };
                let joined = head.strip_suffix('s').is_some_and(|stem| self.has(stem) && long_enough(stem));
                long_enough(tail) && (self.has(head) || joined) && self.put_together(tail, parts - 1)
            })
    }

    fn with_ending(&self, word: &str) -> bool {
        let stem = |ending: &&str| word.strip_suffix(*ending).filter(|stem| long_enough(stem));
        self.has(word) || ENDINGS.iter().filter_map(stem).any(|stem| self.has(stem))
    }
}

fn long_enough(part: &str) -> bool {
    part.chars().count() >= SHORTEST_PART
}

/// As the list has it.
fn folded(word: &str) -> String {
    word.trim().to_lowercase().replace('ß', "ss")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words() -> Words {
        let listed =
            ["drehmoment", "moment", "kurve", "dreh", "zahl", "geeignet", "grenze", "antrieb", "antriebs", "welle"];
        Words { listed: listed.map(String::from).into(), own: BTreeSet::new() }
    }

    #[test]
    fn words_their_endings_and_what_is_put_together_are_known() {
        for word in ["Drehmoment", "geeigneten", "Drehzahlgrenze", "Antriebswelle", "Momentenkurve", "Grenzen"] {
            assert_eq!(words().knows(word), word != "Momentenkurve", "{word}");
        }
    }

    #[test]
    fn a_slip_is_not_known() {
        for slip in ["Drehmomnet", "geegnet", "Drehzahlgrezne", "Antriebswelel", "Grenzzze"] {
            assert!(!words().knows(slip), "{slip}");
        }
    }

    #[test]
    fn an_own_word_that_nobody_needs_is_reported() {
        let mut words = words();
        words.own = ["kipparm", "welle", "nirgends"].map(String::from).into();
        let read = ["kipparms", "welle"].map(String::from).into();
        assert_eq!(words.needless(&read).collect::<Vec<_>>(), ["nirgends", "welle"]);
    }

    #[test]
    fn code_signs_and_names_in_capitals_are_not_read() {
        let page =
            "Ein `Kodewort` mit [two-way.toml](x.toml), T_rms, U_DCmax, PDF und 90deg.\n\n```console\nMurks\n```\n";
        let found: Vec<String> = of_document(page).into_iter().map(|(_, word)| word).collect();
        assert_eq!(found, ["Ein", "mit", "und"]);
    }

    #[test]
    fn a_word_that_the_glossary_keeps_out_is_reported() {
        let found = kept_out("# Prüfungen\nDer Nachweis ist bestanden.\n");
        assert_eq!(found.iter().map(|(line, _)| *line).collect::<Vec<_>>(), [1, 2]);
    }
}

//! Spelling of the German documents.
//!
//! A word is known if it is in the list of German words that `tools` installs (forms of Wikidata's lexemes, ignoring
//! capitals and ß for ss) or in `german-words.txt`, which holds terms of the field and words missing in that list; if
//! it is such a word with an ending of the declension; or if it is composed of known words of at least four letters,
//! with or without an s between them. Code, formulas and words with capitals inside are not checked. Not detected: a
//! slip that is a word itself, wrong capitals, grammar. In addition, no document may use a word that
//! `data/glossary.toml` excludes for a term.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use crate::Error;
use crate::book::is_german;
use crate::markdown::MarkdownText;
use crate::tidy::tree::Tree;
use crate::tools;

/// Additional words, one per line, in order.
const OWN: &str = "xtask/german-words.txt";
/// Endings of adjectives, participles and nouns.
const ENDINGS: [&str; 12] = ["e", "en", "er", "es", "em", "s", "n", "ere", "eren", "erer", "eres", "sten"];
/// Minimum length of a part of a compound; shorter parts occur in any word.
const SHORTEST_PART: usize = 4;
/// Maximum number of parts of a compound; with more, words match by chance.
const MOST_PARTS: usize = 4;

/// Checks every German document.
///
/// # Errors
/// The list of words is missing, or a word is unknown; all of them are printed first.
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

/// Returns the words of the running text with their lines.
fn of_document(text: &str) -> Vec<(usize, String)> {
    let document = MarkdownText::read(text);
    let mut found = Vec::new();
    for (line, piece) in document.sections.iter().flat_map(|section| &section.prose) {
        // A word with a digit or an underscore is a symbol.
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

/// Returns `true` if a word of the running text is the name of a file: a point followed by a letter.
fn is_path(token: &str) -> bool {
    token.split('.').skip(1).any(|rest| rest.starts_with(|letter: char| letter.is_ascii_lowercase()))
}

fn is_latin(letter: char) -> bool {
    letter.is_ascii_alphabetic() || "äöüßÄÖÜé".contains(letter)
}

/// Returns words that begin like one excluded by the glossary.
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

/// Known words.
struct Words {
    /// Words of the installed list.
    listed: BTreeSet<String>,
    /// Words of the additional list.
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

    /// Iterates over additional words that the list also contains, or that occur in none of the words read.
    fn needless<'w>(&'w self, read: &'w BTreeSet<String>) -> impl Iterator<Item = &'w String> {
        self.own.iter().filter(|own| self.listed.contains(*own) || !read.iter().any(|word| word.contains(own.as_str())))
    }

    fn has(&self, word: &str) -> bool {
        self.listed.contains(word) || self.own.contains(word)
    }

    fn knows(&self, word: &str) -> bool {
        self.put_together(&folded(word), MOST_PARTS)
    }

    /// Returns `true` if a word is known or composed of known words.
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

/// Returns a word in the notation of the list.
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

//! The grammars: for each series its fields in their order, with their words and what they mean.

use crate::field::{Feedback, Field, OrderCode};
use std::sync::OnceLock;

include!(concat!(env!("OUT_DIR"), "/grammars.rs"));

/// The grammars of the program, once there are others than the embedded ones.
static EXTENDED: OnceLock<Vec<Grammar>> = OnceLock::new();

/// The ordering code of one series, read from its `code.toml`.
#[derive(Clone, Copy, Debug)]
pub struct Grammar {
    /// The word that every code begins with.
    pub series: &'static str,
    /// Its fields, in their order.
    pub fields: &'static [FieldWords],
}

/// One field of a grammar.
#[derive(Clone, Copy, Debug)]
pub struct FieldWords {
    /// Which one.
    pub field: Field,
    /// Whether it may be left out.
    pub is_optional: bool,
    /// Its words, in the order of the ordering tables.
    pub words: &'static [&'static str],
    /// What each word is, of the field of the feedback; empty of any other.
    pub kinds: &'static [FeedbackKind],
    /// What the words mean: the first that fits counts.
    pub meanings: &'static [Meaning],
}

/// What a word means.
#[derive(Clone, Copy, Debug)]
pub struct Meaning {
    /// The word; `None`: every word, and the absence of one.
    pub word: Option<&'static str>,
    /// Fields with their words, one of which must stand in the code.
    pub when: &'static [(Field, &'static [&'static str])],
    /// English text; `{}` is the word.
    pub en: &'static str,
    /// German text; `{}` is the word.
    pub de: &'static str,
}

/// What a motor feedback is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FeedbackKind {
    /// Incremental encoder with sine signals and a commutation track.
    SineIncremental,
    /// Multiturn absolute encoder, EnDat.
    EndatMultiturn,
    /// Resolver.
    Resolver,
    /// Incremental encoder with square-wave signals and commutation signals.
    SquareIncremental,
    /// Multiturn absolute encoder, SSI, buffered by a battery.
    SsiMultiturn,
}

/// A series of actuators with a grammar of its own; the default is the first that is embedded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Series(u8);

/// Adds grammars of series to the embedded ones, for the whole program; once, and before any code is read.
///
/// # Errors
/// The grammars, if some were added before.
pub fn extend(grammars: Vec<Grammar>) -> Result<(), Vec<Grammar>> {
    EXTENDED.set([EMBEDDED, &grammars].concat()).map_err(|_| grammars)
}

fn grammars() -> &'static [Grammar] {
    EXTENDED.get().map_or(EMBEDDED, Vec::as_slice)
}

impl Series {
    /// Every series, in order.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..).map(Self).take(grammars().len())
    }

    /// The series at a place of that order.
    #[must_use]
    pub const fn at(place: u8) -> Self {
        Self(place)
    }

    /// Its place in that order.
    #[must_use]
    pub fn place(self) -> usize {
        usize::from(self.0)
    }

    /// The word that its codes begin with.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        self.grammar().map_or("", |grammar| grammar.series)
    }

    /// The fields of its codes, in their order.
    pub fn fields(self) -> impl DoubleEndedIterator<Item = Field> + Clone {
        self.words_of_fields().iter().map(|known| known.field)
    }

    /// The words that may stand at a field; none where its codes do not have the field.
    #[must_use]
    pub fn words(self, field: Field) -> &'static [&'static str] {
        self.field(field).map_or(&[], |known| known.words)
    }

    /// Whether the field may be left out.
    #[must_use]
    pub fn is_optional(self, field: Field) -> bool {
        self.field(field).is_none_or(|known| known.is_optional)
    }

    /// The series whose word a text begins with, whatever its case, and that of the longest such word; the default if there
    /// is none.
    pub(crate) fn of_text(text: &str) -> Self {
        let text = text.trim_start();
        let begins = |series: &Self| {
            let word = series.as_str();
            text.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
        };
        Self::all().filter(begins).max_by_key(|series| series.as_str().len()).unwrap_or_default()
    }

    pub(crate) fn words_of_fields(self) -> &'static [FieldWords] {
        self.grammar().map_or(&[], |grammar| grammar.fields)
    }

    fn field(self, field: Field) -> Option<&'static FieldWords> {
        self.words_of_fields().iter().find(|known| known.field == field)
    }

    fn grammar(self) -> Option<&'static Grammar> {
        grammars().get(self.place())
    }
}

impl Feedback {
    /// What it is.
    #[must_use]
    pub fn kind(self) -> Option<FeedbackKind> {
        self.series().field(Field::Feedback)?.kinds.get(self.place()).copied()
    }
}

impl OrderCode {
    /// What the word at a field means, or its absence, in English and in German.
    #[must_use]
    pub fn meaning(&self, field: Field) -> Option<[String; 2]> {
        let word = self.token(field);
        let stands = |(of, words): &(Field, &[&str])| self.token(*of).is_some_and(|word| words.contains(&word));
        let fits =
            |meaning: &&Meaning| (meaning.word.is_none() || meaning.word == word) && meaning.when.iter().all(stands);
        let found = self.series().field(field)?.meanings.iter().find(fits)?;
        Some([found.en, found.de].map(|text| text.replace("{}", word.unwrap_or_default())))
    }
}

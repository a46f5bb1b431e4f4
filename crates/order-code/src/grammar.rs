//! Grammars of the series: fields in their order, with their words and the meanings of these.

use crate::field::{Feedback, Field, OrderCode};
use std::sync::OnceLock;

include!(concat!(env!("OUT_DIR"), "/grammars.rs"));

/// Grammars of the program, if some were added to the embedded ones.
static EXTENDED: OnceLock<Vec<Grammar>> = OnceLock::new();

/// Grammar of the ordering code of one series, read from `code.toml`.
#[derive(Clone, Copy, Debug)]
pub struct Grammar {
    /// Word at the beginning of every code.
    pub series: &'static str,
    /// Fields of the code, in their order.
    pub fields: &'static [FieldWords],
}

/// One field of a grammar.
#[derive(Clone, Copy, Debug)]
pub struct FieldWords {
    /// Field described.
    pub field: Field,
    /// The field may be omitted.
    pub is_optional: bool,
    /// Words of the field, in the order of the ordering tables.
    pub words: &'static [&'static str],
    /// Kind of feedback of each word; empty for every field other than the feedback.
    pub kinds: &'static [FeedbackKind],
    /// Meanings of the words; the first that applies is used.
    pub meanings: &'static [Meaning],
}

/// Meaning of a word of a code.
#[derive(Clone, Copy, Debug)]
pub struct Meaning {
    /// Word explained; `None` applies to every word and to its absence.
    pub word: Option<&'static str>,
    /// Conditions: the code must contain one of the words of each field listed.
    pub when: &'static [(Field, &'static [&'static str])],
    /// English text; `{}` stands for the word.
    pub en: &'static str,
    /// German text; `{}` stands for the word.
    pub de: &'static str,
}

/// Kind of motor feedback.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FeedbackKind {
    /// Incremental encoder with sine signals and a commutation track.
    SineIncremental,
    /// Multiturn absolute encoder, EnDat.
    EndatMultiturn,
    /// Resolver with sine and cosine winding.
    Resolver,
    /// Incremental encoder with square-wave signals and commutation signals.
    SquareIncremental,
    /// Multiturn absolute encoder, SSI, buffered by a battery.
    SsiMultiturn,
}

/// A series of actuators with a grammar of its own; the default is the first embedded one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Series(u8);

/// Adds grammars of series to the embedded ones for the whole program; allowed once, before any code is read.
///
/// # Errors
/// Returns the grammars if some were added before.
pub fn extend(grammars: Vec<Grammar>) -> Result<(), Vec<Grammar>> {
    EXTENDED.set([EMBEDDED, &grammars].concat()).map_err(|_| grammars)
}

fn grammars() -> &'static [Grammar] {
    EXTENDED.get().map_or(EMBEDDED, Vec::as_slice)
}

impl Series {
    /// Iterates over all series: embedded ones first, then added ones.
    pub fn all() -> impl Iterator<Item = Self> {
        (0..).map(Self).take(grammars().len())
    }

    /// Returns the series at an index of [`Series::all`].
    #[must_use]
    pub const fn at(place: u8) -> Self {
        Self(place)
    }

    /// Returns the index of the series in [`Series::all`].
    #[must_use]
    pub fn place(self) -> usize {
        usize::from(self.0)
    }

    /// Returns the word at the beginning of its codes.
    #[must_use]
    pub fn as_str(self) -> &'static str {
        self.grammar().map_or("", |grammar| grammar.series)
    }

    /// Iterates over the fields of its codes, in their order.
    pub fn fields(self) -> impl DoubleEndedIterator<Item = Field> + Clone {
        self.words_of_fields().iter().map(|known| known.field)
    }

    /// Returns the words of a field; empty if its codes lack the field.
    #[must_use]
    pub fn words(self, field: Field) -> &'static [&'static str] {
        self.field(field).map_or(&[], |known| known.words)
    }

    /// Returns `true` if its codes may omit the field.
    #[must_use]
    pub fn is_optional(self, field: Field) -> bool {
        self.field(field).is_none_or(|known| known.is_optional)
    }

    /// Returns the series whose word `text` begins with, ignoring case, or the default series.
    pub(crate) fn of_text(text: &str) -> Self {
        Self::beginning(text).unwrap_or_default()
    }

    /// Returns the series whose word `text` begins with, ignoring case; the longest such word wins.
    #[must_use]
    pub fn beginning(text: &str) -> Option<Self> {
        let text = text.trim_start();
        let begins = |series: &Self| {
            let word = series.as_str();
            text.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word))
        };
        Self::all().filter(begins).max_by_key(|series| series.as_str().len())
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
    /// Returns the kind of the motor feedback.
    #[must_use]
    pub fn kind(self) -> Option<FeedbackKind> {
        self.series().field(Field::Feedback)?.kinds.get(self.place()).copied()
    }
}

impl OrderCode {
    /// Returns the meaning of the word at a field, or of its absence, in English and German.
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

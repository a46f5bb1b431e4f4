//! One argument of a question: its description for every face, and the check of its text.

use project::Hint;
use quantities::Language;
use std::borrow::Cow;
use words::spoken::choice;
use words::{UsageHint, Word, help, help::values, requests};

/// An argument of a question.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// Name of the argument: `--NAME` on the command line, `NAME` in the query of a request.
    pub name: &'static str,
    /// Description of the argument.
    pub about: Word,
    /// Placeholder for the value in the usage of a command.
    pub value: Word,
    /// Kind of the value.
    pub kind: ArgumentKind,
    /// Form of the argument in a call.
    pub form: ArgumentForm,
    /// `true` if there is no answer without the argument.
    pub required: bool,
    /// `true` if the argument may be given several times.
    pub repeated: bool,
    /// Default value.
    pub usual: Option<&'static str>,
    /// Argument that this one requires.
    pub needs: Option<&'static str>,
    /// Argument that this one replaces; one of the two is required.
    pub instead_of: Option<&'static str>,
    /// `true` if a value may begin with a minus sign.
    pub signed: bool,
    /// Titles that are accepted for the words, each with its word.
    pub titles: Option<Titles>,
    /// Function that returns `true` if the question can read a text of the argument.
    pub reads: Option<fn(&str, Language) -> bool>,
}

/// Function that returns titles, each with its word.
pub(super) type Titles = fn() -> Vec<(String, &'static str)>;

/// Kind of the value of an argument.
#[derive(Clone, Copy, Debug)]
pub enum ArgumentKind {
    /// A text, or a quantity with its unit.
    Text,
    /// An ordering code.
    Code,
    /// A day.
    Date,
    /// A file besides the inputs; on a command line relative to the current folder.
    File,
    /// True or false; a name without a value is true.
    Flag,
    /// A whole number within a range, ends included.
    Whole(u64, u64),
    /// One of these words; for an argument that may be given several times also several words separated by commas.
    Word(fn() -> Vec<&'static str>),
}

/// Form of an argument in a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArgumentForm {
    /// After its name.
    Option,
    /// Without a name, one word.
    Bare,
    /// Without a name, several words that form one text.
    Words,
    /// Without a name, each word a separate value.
    Each,
}

impl Argument {
    /// Creates an optional text after its name.
    #[must_use]
    pub const fn option(name: &'static str, value: Word, about: Word) -> Self {
        Self {
            name,
            about,
            value,
            kind: ArgumentKind::Text,
            form: ArgumentForm::Option,
            required: false,
            repeated: false,
            usual: None,
            needs: None,
            instead_of: None,
            signed: false,
            titles: None,
            reads: None,
        }
    }

    /// Returns the argument with the reader of its question.
    #[must_use]
    pub(super) const fn read_by(self, reads: fn(&str, Language) -> bool) -> Self {
        Self { reads: Some(reads), ..self }
    }

    /// Creates a flag, true or false.
    #[must_use]
    pub const fn flag(name: &'static str, about: Word) -> Self {
        Self::option(name, values::what, about).of(ArgumentKind::Flag)
    }

    /// Returns the argument with another kind of value.
    #[must_use]
    pub const fn of(self, kind: ArgumentKind) -> Self {
        Self { kind, ..self }
    }

    /// Returns the argument in another form.
    #[must_use]
    pub const fn form(self, form: ArgumentForm) -> Self {
        Self { form, repeated: matches!(form, ArgumentForm::Each), ..self }
    }

    /// Returns the argument as a required one.
    #[must_use]
    pub const fn required(self) -> Self {
        Self { required: true, ..self }
    }

    /// Returns the argument as one that may be given several times.
    #[must_use]
    pub const fn repeated(self) -> Self {
        Self { repeated: true, ..self }
    }

    /// Returns the argument with a default value.
    #[must_use]
    pub const fn usually(self, usual: &'static str) -> Self {
        Self { usual: Some(usual), ..self }
    }

    /// Returns the argument as one that requires another.
    #[must_use]
    pub const fn with(self, needs: &'static str) -> Self {
        Self { needs: Some(needs), ..self }
    }

    /// Returns the argument as one that replaces another.
    #[must_use]
    pub const fn instead_of(self, other: &'static str) -> Self {
        Self { instead_of: Some(other), ..self }
    }

    /// Returns the argument with values that may begin with a minus sign.
    #[must_use]
    pub const fn signed(self) -> Self {
        Self { signed: true, ..self }
    }

    /// Returns the argument with titles that are accepted for its words: the names that an answer shows.
    #[must_use]
    pub const fn titled(self, titles: Titles) -> Self {
        Self { titles: Some(titles), ..self }
    }

    /// Returns the word with a title; case, spaces and signs between the words do not matter.
    fn word_titled(&self, written: &str) -> Option<&'static str> {
        let titles = self.titles?();
        let is_it = |title: &str| plain(title) == plain(written) || joined(title) == joined(written);
        titles.into_iter().find(|(title, _)| is_it(title)).map(|(_, word)| word)
    }

    /// Returns the valid words; empty if other values are valid too.
    #[must_use]
    pub fn words(&self) -> Vec<&'static str> {
        match self.kind {
            ArgumentKind::Word(words) => words(),
            ArgumentKind::Text
            | ArgumentKind::Code
            | ArgumentKind::Date
            | ArgumentKind::File
            | ArgumentKind::Flag
            | ArgumentKind::Whole(..) => Vec::new(),
        }
    }

    /// Returns `true` if a value is a list of words separated by commas.
    #[must_use]
    pub const fn is_list(&self) -> bool {
        self.repeated && matches!(self.kind, ArgumentKind::Word(_))
    }

    /// Returns `true` if a text is one of the words of the argument, or a title of one.
    #[must_use]
    pub fn takes(&self, value: &str) -> bool {
        matches!(self.kind, ArgumentKind::Word(_)) && self.checked(value).is_ok()
    }

    /// Returns the word of the argument that a text is, or is a title of.
    #[must_use]
    pub fn word(&self, value: &str) -> Option<&'static str> {
        let found = self.checked(value).ok()?;
        self.words().into_iter().find(|word| *word == found)
    }

    /// Returns `true` if the values have a form of their own: they are no file and no flag.
    #[must_use]
    pub const fn kind_is_known(&self) -> bool {
        !matches!(self.kind, ArgumentKind::File | ArgumentKind::Flag)
    }

    /// Returns the remedy for a text that is no value of the argument; `None` if it is one.
    #[must_use]
    pub fn remedy(&self, value: &str) -> Option<UsageHint> {
        self.checked(value).err().flatten()
    }

    /// Splits a text into the values that it names: the words of a list.
    pub(super) fn parts<'v>(&self, value: &'v str) -> Vec<&'v str> {
        // A title may contain commas.
        if self.is_list() && self.word_titled(value).is_none() {
            value.split(',').map(str::trim).collect()
        } else {
            vec![value]
        }
    }

    /// Returns a value in the form in which it is stored.
    ///
    /// # Errors
    /// The remedy, if there is one.
    pub(super) fn checked<'v>(&self, value: &'v str) -> Result<Cow<'v, str>, Option<UsageHint>> {
        match self.kind {
            ArgumentKind::Text | ArgumentKind::Code | ArgumentKind::Date | ArgumentKind::File => {
                Ok(Cow::Borrowed(value))
            }
            ArgumentKind::Flag => match value {
                "" | "1" => Ok(Cow::Borrowed(TRUE)),
                "0" => Ok(Cow::Borrowed("false")),
                TRUE | "false" => Ok(Cow::Borrowed(value)),
                _ => Err(Some(UsageHint::Words(Hint::ValidAre(vec![TRUE.to_owned(), "false".to_owned()])))),
            },
            ArgumentKind::Whole(least, most) => match value.parse::<u64>() {
                Ok(number) if (least..=most).contains(&number) => Ok(Cow::Borrowed(value)),
                Err(error) if !matches!(error.kind(), std::num::IntErrorKind::PosOverflow) && !is_whole(value) => {
                    Err(Some(UsageHint::WholeNumber))
                }
                _ => Err(Some(UsageHint::Range(least.to_string(), most.to_string()))),
            },
            ArgumentKind::Word(words) => {
                let words = words();
                if words.contains(&value) {
                    return Ok(Cow::Borrowed(value));
                }
                let spelled = |word: &&&str| joined(word) == joined(value);
                let chosen = || choice(self.name, value).filter(|word| words.contains(word));
                let own = || words.iter().find(spelled).copied();
                if let Some(word) = self.word_titled(value).or_else(own).or_else(chosen) {
                    return Ok(Cow::Borrowed(word));
                }
                let hint = match (nearest_words(value, &words), self.titles) {
                    (Hint::ValidAre(all), Some(titles)) => {
                        let titles: Vec<(String, &str)> =
                            titles().into_iter().map(|(title, word)| (plain(&title), word)).collect();
                        let names: Vec<&str> = titles.iter().map(|(title, _)| title.as_str()).collect();
                        let word = match nearest_words(&plain(value), &names) {
                            Hint::DidYouMean(near) => titles.iter().find(|(title, _)| *title == near),
                            _ => None,
                        };
                        word.map_or(Hint::ValidAre(all), |(_, word)| Hint::DidYouMean((*word).to_owned()))
                    }
                    (hint, _) => hint,
                };
                Err(Some(UsageHint::Words(hint)))
            }
        }
    }
}

/// Stored value of a flag that is set.
pub(super) const TRUE: &str = "true";

/// Returns `true` if a text is a whole number of any size and sign.
fn is_whole(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// Returns a name without case, and with single spaces between its words.
fn plain(name: &str) -> String {
    let words = name.split(|sign: char| sign.is_whitespace() || matches!(sign, '_' | '-' | ','));
    words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ").to_lowercase()
}

/// Returns a name as one word, with umlauts by two letters: `ball screw` is `ballscrew`.
fn joined(name: &str) -> String {
    let letters = plain(name).replace(' ', "");
    [('\u{e4}', "ae"), ('\u{f6}', "oe"), ('\u{fc}', "ue"), ('\u{df}', "ss")]
        .iter()
        .fold(letters, |text, (letter, plain)| text.replace(*letter, plain))
}

/// Returns the word that was probably meant, or all valid words.
pub(super) fn nearest_words(written: &str, words: &[&str]) -> Hint {
    let distance = |word: &&str| strsim::damerau_levenshtein(word, written);
    // A text much longer than every word is near none.
    let is_long = words.iter().all(|word| written.len() > 3 * word.len());
    let nearest = if is_long { None } else { words.iter().copied().min_by_key(distance) };
    match nearest.filter(|word| distance(word) * 2 <= word.len()) {
        Some(word) => Hint::DidYouMean(word.to_owned()),
        None => Hint::ValidAre(words.iter().map(|word| (*word).to_owned()).collect()),
    }
}

/// Name of an axis in a project with several.
pub const AXIS: Argument = Argument::option("axis", values::name, help::axis);

/// Ordering code to which a question refers.
pub const CODE: Argument = Argument::option("code", values::code, help::ordering_code)
    .of(ArgumentKind::Code)
    .form(ArgumentForm::Words)
    .required();

/// Creates an argument for an optional ordering code.
pub(super) const fn code(about: Word) -> Argument {
    Argument::option("code", values::code, about).of(ArgumentKind::Code)
}

/// Creates an argument for a number of candidates of a ranking.
pub(super) const fn top(usual: &'static str, about: Word) -> Argument {
    Argument::option("top", values::n, about).of(ArgumentKind::Whole(1, u16::MAX as u64)).usually(usual)
}

/// Language of the texts.
pub const LANG: Argument = Argument::option("lang", values::lang, requests::lang)
    .of(ArgumentKind::Word(|| quantities::Language::ALL.map(quantities::Language::id).to_vec()))
    .repeated();

/// Name of the project in faults and files.
pub const FILE: Argument = Argument::option("file", values::file, requests::file);

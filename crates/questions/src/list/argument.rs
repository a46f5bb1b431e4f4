//! One argument of a question: what every face knows of it, and how its text is checked.

use project::Hint;
use std::borrow::Cow;
use words::{UsageHint, Word, help, help::values, requests};

/// An argument of a question.
#[derive(Clone, Copy, Debug)]
pub struct Argument {
    /// Its name: `--NAME` on the command line, `NAME` in the query of a request.
    pub name: &'static str,
    /// What it says.
    pub about: Word,
    /// What stands for its value in the usage of a command.
    pub value: Word,
    /// What a value may be.
    pub kind: ArgumentKind,
    /// How a call has it.
    pub form: Form,
    /// Whether there is no answer without it.
    pub required: bool,
    /// Whether it may be given several times.
    pub repeated: bool,
    /// Its value where none is given.
    pub usual: Option<&'static str>,
    /// The argument without which it means nothing.
    pub needs: Option<&'static str>,
    /// The argument in whose place it stands; one of the two is required.
    pub instead_of: Option<&'static str>,
    /// Whether a value may begin with a minus sign.
    pub signed: bool,
}

/// What a value may be.
#[derive(Clone, Copy, Debug)]
pub enum ArgumentKind {
    /// A text, or a quantity with its unit.
    Text,
    /// An ordering code.
    Code,
    /// A day.
    Date,
    /// A file beside those that are read; on a command line from where it is called.
    File,
    /// True or false; a name without a value is true.
    Flag,
    /// A whole number from and to.
    Whole(u64, u64),
    /// One of these words; of an argument that may be given several times also some of them with commas between them.
    Word(fn() -> Vec<&'static str>),
}

/// How a call has an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Behind its name.
    Option,
    /// Without a name, one word.
    Bare,
    /// Without a name, several words that are one text.
    Words,
    /// Without a name, each word a value of its own.
    Each,
}

impl Argument {
    /// An optional text behind its name.
    #[must_use]
    pub const fn option(name: &'static str, value: Word, about: Word) -> Self {
        Self {
            name,
            about,
            value,
            kind: ArgumentKind::Text,
            form: Form::Option,
            required: false,
            repeated: false,
            usual: None,
            needs: None,
            instead_of: None,
            signed: false,
        }
    }

    /// True or false.
    #[must_use]
    pub const fn flag(name: &'static str, about: Word) -> Self {
        Self::option(name, values::what, about).of(ArgumentKind::Flag)
    }

    /// The same with another kind of value.
    #[must_use]
    pub const fn of(self, kind: ArgumentKind) -> Self {
        Self { kind, ..self }
    }

    /// The same, given in another form.
    #[must_use]
    pub const fn form(self, form: Form) -> Self {
        Self { form, repeated: matches!(form, Form::Each), ..self }
    }

    /// The same, required.
    #[must_use]
    pub const fn required(self) -> Self {
        Self { required: true, ..self }
    }

    /// The same, several times.
    #[must_use]
    pub const fn repeated(self) -> Self {
        Self { repeated: true, ..self }
    }

    /// The same with a value where none is given.
    #[must_use]
    pub const fn usually(self, usual: &'static str) -> Self {
        Self { usual: Some(usual), ..self }
    }

    /// The same, only with another argument.
    #[must_use]
    pub const fn with(self, needs: &'static str) -> Self {
        Self { needs: Some(needs), ..self }
    }

    /// The same, in the place of another argument.
    #[must_use]
    pub const fn instead_of(self, other: &'static str) -> Self {
        Self { instead_of: Some(other), ..self }
    }

    /// The same with values that may begin with a minus sign.
    #[must_use]
    pub const fn signed(self) -> Self {
        Self { signed: true, ..self }
    }

    /// The words that a value may be; none where it may be another.
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

    /// Whether a value is a list of words with commas between them.
    #[must_use]
    pub const fn is_list(&self) -> bool {
        self.repeated && matches!(self.kind, ArgumentKind::Word(_))
    }

    /// The values that a text names: of a list its words.
    pub(super) fn parts<'v>(&self, value: &'v str) -> Vec<&'v str> {
        if self.is_list() { value.split(',').map(str::trim).collect() } else { vec![value] }
    }

    /// A value as it is kept, or what would be right.
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
                    Ok(Cow::Borrowed(value))
                } else {
                    Err(Some(UsageHint::Words(near(value, &words))))
                }
            }
        }
    }
}

/// How a flag that is set is kept.
pub(super) const TRUE: &str = "true";

/// Whether a text is a whole number, however large and of whatever sign.
fn is_whole(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// The word that was probably meant, or all of them.
pub(super) fn near(written: &str, words: &[&str]) -> Hint {
    let distance = |word: &&str| strsim::damerau_levenshtein(word, written);
    // A text much longer than every word is near none.
    let is_long = words.iter().all(|word| written.len() > 3 * word.len());
    let nearest = if is_long { None } else { words.iter().copied().min_by_key(distance) };
    match nearest.filter(|word| distance(word) * 2 <= word.len()) {
        Some(word) => Hint::DidYouMean(word.to_owned()),
        None => Hint::ValidAre(words.iter().map(|word| (*word).to_owned()).collect()),
    }
}

/// The axis of a project with several.
pub const AXIS: Argument = Argument::option("axis", values::name, help::axis);

/// The ordering code that a question is about.
pub const CODE: Argument =
    Argument::option("code", values::code, help::ordering_code).of(ArgumentKind::Code).form(Form::Words).required();

/// An ordering code that may be named.
pub(super) const fn code(about: Word) -> Argument {
    Argument::option("code", values::code, about).of(ArgumentKind::Code)
}

/// How many of a ranking.
pub(super) const fn top(usual: &'static str, about: Word) -> Argument {
    Argument::option("top", values::n, about).of(ArgumentKind::Whole(1, u16::MAX as u64)).usually(usual)
}

/// The language of the texts.
pub const LANG: Argument = Argument::option("lang", values::lang, requests::lang)
    .of(ArgumentKind::Word(|| quantities::Language::ALL.map(quantities::Language::id).to_vec()))
    .repeated();

/// What the project is called in faults and files.
pub const FILE: Argument = Argument::option("file", values::file, requests::file);

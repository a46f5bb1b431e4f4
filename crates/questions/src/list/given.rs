//! Texts that a call or a request states for the arguments of a question, and their conversion to values.

use super::argument::{Argument, ArgumentKind, FILE, LANG, TRUE, nearest_words};
use super::unanswered::Unanswered;
use crate::codes::{read_code, read_pattern, read_pattern_begun, read_product};
use crate::upkeep::read_date;
use answers::Fault;
use chrono::NaiveDate;
use configurator::ProductId;
use order_code::{OrderCode, Pattern};
use quantities::{Language, seen};
use std::borrow::Cow;
use words::{Usage, UsageHint, usage_hint, usage_text};

/// A fault of a text, and a hint.
pub type Hinted = (String, Option<String>);

/// Texts for arguments, each checked for the kind of its argument.
#[derive(Clone, Debug)]
pub struct Given {
    values: Vec<(&'static str, String)>,
    /// A product may have a name instead of an ordering code.
    has_names: bool,
    language: Language,
}

impl Given {
    /// Checks the texts of a call against the arguments of a question.
    ///
    /// # Errors
    /// Every name that is unknown, missing or repeated, and every value of the wrong kind.
    pub fn of<'g>(
        arguments: &[Argument],
        pairs: impl IntoIterator<Item = (Cow<'g, str>, Cow<'g, str>)>,
        language: Language,
    ) -> Result<Self, Unanswered> {
        let mut given = Self { values: Vec::new(), has_names: false, language };
        let mut errors: Vec<Fault> = Vec::new();
        for (name, value) in pairs {
            let known = arguments.iter().chain([&LANG]).find(|argument| argument.name == name);
            let Some(argument) = known else {
                errors.push(unknown(&name, arguments, language));
                continue;
            };
            if !argument.repeated && given.all(argument.name).next().is_some() {
                let twice = Usage::Twice { name: argument.name.to_owned() };
                errors.push(usage(argument.name, &twice, None, language));
                continue;
            }
            for value in argument.parts(&value) {
                match argument.checked(value) {
                    Ok(value) => given.values.push((argument.name, value.into_owned())),
                    Err(hint) => {
                        let what = Usage::BadValue { written: shown(value), name: argument.name.to_owned() };
                        errors.push(usage(argument.name, &what, hint, language));
                    }
                }
            }
        }
        let needed = arguments.iter().filter(|argument| given.text(argument).is_some()).filter_map(|given| given.needs);
        let needed = needed.filter(|needs| arguments.iter().any(|argument| argument.name == *needs));
        let required = arguments.iter().filter(|argument| argument.required).map(|argument| argument.name);
        for missing in required.chain(needed) {
            let is_there = given.all(missing).next().is_some();
            if !is_there && !errors.iter().any(|fault| fault.option.as_deref() == Some(missing)) {
                errors.push(usage(missing, &Usage::Missing { names: missing.to_owned() }, None, language));
            }
        }
        if errors.is_empty() { Ok(given) } else { Err(Unanswered::Usage(errors)) }
    }

    /// Returns the texts for a call in which a product may have a name instead of an ordering code: that of a catalogue
    /// file.
    #[must_use]
    pub fn naming_products(self, has_names: bool) -> Self {
        Self { has_names, ..self }
    }

    /// Returns one text for one argument.
    pub(super) fn one(argument: &Argument, text: &str, language: Language) -> Self {
        Self { values: vec![(argument.name, text.to_owned())], language, has_names: false }
    }

    /// Returns the value of an argument, or its default.
    #[must_use]
    pub fn text(&self, argument: &Argument) -> Option<&str> {
        self.all(argument.name).next().or(argument.usual)
    }

    /// Iterates over the values of a name.
    pub fn all(&self, name: &str) -> impl Iterator<Item = &str> {
        self.values.iter().filter(move |(known, _)| *known == name).map(|(_, value)| value.as_str())
    }

    /// Returns `true` if a value other than the default is stated for an argument.
    #[must_use]
    pub(super) fn differs(&self, argument: &Argument) -> bool {
        self.all(argument.name).any(|value| argument.usual != Some(value))
    }

    /// Returns the language of the faults.
    #[must_use]
    pub const fn language(&self) -> Language {
        self.language
    }

    /// Returns the name of the project.
    ///
    /// # Errors
    /// A name that is too long.
    pub fn file(&self) -> Result<Option<String>, Unanswered> {
        label(self, &FILE)
    }
}

/// Returns `true` if a text is recognisably a value of an argument: a code, a day, a number in range, one of the words, a
/// quantity of the dimension. No text is recognisable for an argument that reads every one, nor a file.
#[must_use]
pub fn recognises(argument: &Argument, text: &str, language: Language) -> bool {
    /// A text that only an argument without a form of its own reads.
    const FORMLESS: &str = "\u{2203}";
    match argument.kind {
        ArgumentKind::File | ArgumentKind::Flag => false,
        ArgumentKind::Date => read_date(text, language).is_ok(),
        ArgumentKind::Code => read_code(text, language).is_ok(),
        ArgumentKind::Whole(..) | ArgumentKind::Word(_) => argument.checked(text).is_ok(),
        ArgumentKind::Text => argument.reads.is_some_and(|reads| reads(text, language) && !reads(FORMLESS, language)),
    }
}

/// Returns a text unchanged.
pub(super) fn text(given: &Given, argument: &Argument) -> Result<Option<String>, Unanswered> {
    Ok(given.text(argument).map(str::to_owned))
}

/// Returns the texts of an argument, one per line.
pub(super) fn lines(given: &Given, argument: &Argument) -> Result<String, Unanswered> {
    Ok(given.all(argument.name).collect::<Vec<_>>().join("\n"))
}

/// Returns a text of limited length, without invisible characters.
pub(super) fn label(given: &Given, argument: &Argument) -> Result<Option<String>, Unanswered> {
    given.text(argument).map(|text| bounded(argument.name, text, given.language)).transpose()
}

/// Returns a calendar date; without one, or with an empty text, `None`.
pub(super) fn day(given: &Given, argument: &Argument) -> Result<Option<NaiveDate>, Unanswered> {
    let Some(text) = given.text(argument).filter(|text| !text.is_empty()) else { return Ok(None) };
    read_date(text, given.language).map(Some).map_err(|fault| Unanswered::option(argument.name, fault))
}

/// Returns the text of an option, of limited length and without invisible characters.
///
/// # Errors
/// A text that is too long.
pub fn bounded(name: &'static str, text: &str, language: Language) -> Result<String, Unanswered> {
    // The limit of a text in a project.
    const MOST: usize = 200;
    if text.chars().count() > MOST {
        let message = usage_text(&Usage::TooLong { most: MOST }, language);
        return Err(Unanswered::option(name, (message, None)));
    }
    Ok(seen(text).into_owned())
}

/// Returns `true` if a flag is set.
pub(super) fn flag(given: &Given, argument: &Argument) -> Result<bool, Unanswered> {
    Ok(given.text(argument) == Some(TRUE))
}

/// Returns an optional whole number.
pub(super) fn number<N: std::str::FromStr>(given: &Given, argument: &Argument) -> Result<Option<N>, Unanswered> {
    Ok(given.text(argument).and_then(|value| value.parse().ok()))
}

/// Returns a whole number, or its default.
pub(super) fn count(given: &Given, argument: &Argument) -> Result<usize, Unanswered> {
    number(given, argument).map(Option::unwrap_or_default)
}

/// Returns a reader for one of the words of an argument.
pub(super) fn word<T>(of: impl Fn(&str) -> Option<T>) -> impl Fn(&Given, &Argument) -> Result<Option<T>, Unanswered> {
    move |given, argument| Ok(given.text(argument).and_then(&of))
}

/// Returns a function that finds the value of an identifier.
pub(super) fn by_id<T: Copy>(all: &'static [T], id: fn(T) -> &'static str) -> impl Fn(&str) -> Option<T> {
    move |text| all.iter().copied().find(|each| id(*each) == text)
}

/// Returns a reader for an optional value.
pub(super) fn some<T>(
    read: impl Fn(&str, Language) -> Result<T, Hinted>,
) -> impl Fn(&Given, &Argument) -> Result<Option<T>, Unanswered> {
    move |given, argument| {
        let value = given.text(argument).map(|text| read(text, given.language));
        value.transpose().map_err(|fault| Unanswered::option(argument.name, fault))
    }
}

/// Returns a reader for a required value.
pub(super) fn one<T>(
    read: impl Fn(&str, Language) -> Result<T, Hinted>,
) -> impl Fn(&Given, &Argument) -> Result<T, Unanswered> {
    move |given, argument| {
        let text = given.text(argument).unwrap_or_default();
        read(text, given.language).map_err(|fault| Unanswered::option(argument.name, fault))
    }
}

/// Returns the required ordering code; its faults form a record of their own.
pub(super) fn code(given: &Given, argument: &Argument) -> Result<OrderCode, Unanswered> {
    code_of(given.text(argument).unwrap_or_default(), false, given.language)
}

/// Returns the required ordering code; its faults are reported with those of other arguments.
pub(super) fn code_among(given: &Given, argument: &Argument) -> Result<OrderCode, Unanswered> {
    code_of(given.text(argument).unwrap_or_default(), true, given.language)
}

/// Returns the required product; the faults of its code form a record of their own.
pub(super) fn product(given: &Given, argument: &Argument) -> Result<ProductId, Unanswered> {
    product_of(given.text(argument).unwrap_or_default(), false, given)
}

/// Returns an optional product; the faults of its code form a record of their own.
pub(super) fn some_product(given: &Given, argument: &Argument) -> Result<Option<ProductId>, Unanswered> {
    given.text(argument).map(|text| product_of(text, false, given)).transpose()
}

/// Returns an optional product; the faults of its code are reported with those of the axes.
pub(super) fn some_product_among(given: &Given, argument: &Argument) -> Result<Option<ProductId>, Unanswered> {
    given.text(argument).map(|text| product_of(text, true, given)).transpose()
}

/// Returns the products, in the same order.
pub(super) fn products(given: &Given, argument: &Argument) -> Result<Vec<ProductId>, Unanswered> {
    given.all(argument.name).map(|text| product_of(text, false, given)).collect()
}

fn product_of(text: &str, among: bool, given: &Given) -> Result<ProductId, Unanswered> {
    let refused = |refusal| Unanswered::Code { text: text.to_owned(), refusal, among };
    read_product(text, |_| given.has_names, given.language).map_err(refused)
}

fn code_of(text: &str, among: bool, language: Language) -> Result<OrderCode, Unanswered> {
    let reading = read_code(text, language);
    reading.map(|reading| reading.parsed.code).map_err(|refusal| Unanswered::Code {
        text: text.to_owned(),
        refusal,
        among,
    })
}

/// Returns an optional partial code.
pub(super) fn pattern(given: &Given, argument: &Argument) -> Result<Option<Pattern>, Unanswered> {
    let Some(text) = given.text(argument) else { return Ok(None) };
    let refused = |refusal| Unanswered::Code { text: text.to_owned(), refusal, among: false };
    read_pattern(text, given.language).map(Some).map_err(refused)
}

/// Returns an optional partial code whose last word may be incomplete.
pub(super) fn begun(given: &Given, argument: &Argument) -> Result<Option<Pattern>, Unanswered> {
    let Some(text) = given.text(argument) else { return Ok(None) };
    let refused = |refusal| Unanswered::Code { text: text.to_owned(), refusal, among: false };
    read_pattern_begun(text, true, given.language).map(Some).map_err(refused)
}

fn usage(option: &str, usage: &Usage, hint: Option<UsageHint>, language: Language) -> Fault {
    Fault {
        id: Some("usage"),
        option: Some(option.to_owned()),
        message: usage_text(usage, language),
        hint: hint.map(|hint| usage_hint(&hint, language)),
        ..Fault::default()
    }
}

/// Largest number of characters of a value that a fault repeats.
const SHOWN_MOST: usize = 60;

fn shown(text: &str) -> String {
    let short: String = text.chars().take(SHOWN_MOST).collect();
    seen(&short).into_owned()
}

fn unknown(name: &str, arguments: &[Argument], language: Language) -> Fault {
    let names: Vec<&str> = arguments.iter().map(|argument| argument.name).chain([LANG.name]).collect();
    let hint = UsageHint::Words(nearest_words(name, &names));
    usage(&shown(name), &Usage::UnknownOption { written: shown(name) }, Some(hint), language)
}

/// Defines the arguments of a question: a plain struct, the list of its arguments, and the reader that reports every
/// fault at once.
macro_rules! arguments {
    (
        $(#[$about:meta])*
        pub struct Args {
            $($(#[$field_about:meta])* $field:ident: $of:ty = $argument:expr => $read:expr,)*
        }
    ) => {
        $(#[$about])*
        #[derive(Clone, Debug)]
        pub struct Args {
            $($(#[$field_about])* pub $field: $of,)*
        }

        impl Args {
            /// Arguments as the faces present them.
            pub const ARGUMENTS: &'static [$crate::list::Argument] = &[$($argument.read_by(|text, language| {
                let argument = $argument;
                let given = $crate::list::Given::one(&argument, text, language);
                let value: Result<$of, $crate::list::Unanswered> = ($read)(&given, &argument);
                value.is_ok()
            })),*];

            /// Reads the arguments.
            ///
            /// # Errors
            /// Every fault at once.
            #[allow(unused_mut, unused_variables, reason = "a question may take nothing")]
            pub fn read(given: &$crate::list::Given) -> Result<Self, $crate::list::Unanswered> {
                let mut faults = Vec::new();
                $(let $field = ($read)(given, &$argument).map_err(|fault| faults.push(fault)).ok();)*
                match ($($field,)*) {
                    ($(Some($field),)*) if faults.is_empty() => Ok(Self { $($field),* }),
                    _ => Err($crate::list::Unanswered::combined(faults)),
                }
            }
        }
    };
}

pub(super) use arguments;

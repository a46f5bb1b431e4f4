//! A question as it was put: the values of the query, held to what the endpoint takes, and the body.

use super::{Body, Endpoint, Kind, Parameter, Unanswered};
use crate::{Call, Shell};
use serde::Deserialize;
use std::borrow::Cow;
use workbench::answer::{code_faults, code_told, fault, faults, file_fault, option_fault, refusal_text};
use workbench::answers::{Fault, Faults};
use workbench::quantities::{Measure, seen};
use workbench::text::{Usage, UsageHint, requests, terminal, told, usage_hint, usage_text};
use workbench::{Draw, Hint, Language, OrderCode, PROJECT_MAX_BYTES, Patience, Project, Refusal, SEED_USUAL, Unread};

/// What the body is called in faults, unless the query says otherwise: as the command line calls what it reads from there.
const USUAL_NAME: &str = "stdin";

/// As many characters as a text of a project may have.
const TEXT_MOST: usize = 200;

/// A question with values that the endpoint takes.
pub(crate) struct Asked<'a> {
    call: &'a Call<'a>,
    values: Vec<(&'static str, String)>,
    pub(crate) shell: &'a dyn Shell,
    pub(super) patience: &'a Patience,
    pub(crate) language: Language,
}

impl<'a> Asked<'a> {
    /// Reads the query; every fault of it at once.
    pub(crate) fn of(
        endpoint: &Endpoint,
        call: &'a Call<'a>,
        shell: &'a dyn Shell,
        patience: &'a Patience,
    ) -> Result<Self, Unanswered> {
        let language = call.query_language();
        media(endpoint.body, call, language)?;
        let (mut values, mut errors): (Vec<(&'static str, String)>, Vec<Fault>) = (Vec::new(), Vec::new());
        for (name, value) in call.query_fields() {
            if name == "lang" {
                if Language::of_id(&value).is_none() {
                    let ids = Language::ALL.map(|language| language.id().to_owned());
                    errors.push(bad_value(
                        "lang",
                        &value,
                        Some(UsageHint::Words(Hint::ValidAre(ids.into()))),
                        language,
                    ));
                }
                continue;
            }
            let Some(parameter) = endpoint.parameters.iter().find(|parameter| parameter.name == name) else {
                errors.push(unknown(&name, endpoint, language));
                continue;
            };
            if !parameter.repeated && values.iter().any(|(known, _)| *known == parameter.name) {
                errors.push(usage(
                    Some(parameter.name),
                    &Usage::Twice { name: parameter.name.to_owned() },
                    None,
                    language,
                ));
                continue;
            }
            match valid(parameter, &value) {
                Ok(value) => values.push((parameter.name, value.into_owned())),
                Err(hint) => errors.push(bad_value(parameter.name, &value, hint, language)),
            }
        }
        for missing in endpoint.parameters.iter().filter(|parameter| parameter.required) {
            let there = values.iter().any(|(name, _)| *name == missing.name);
            let faulty = errors.iter().any(|fault| fault.option.as_deref() == Some(missing.name));
            if !there && !faulty {
                let what = Usage::Missing { names: missing.name.to_owned() };
                errors.push(usage(Some(missing.name), &what, None, language));
            }
        }
        if errors.is_empty() {
            Ok(Self { call, values, shell, patience, language })
        } else {
            Err(Faults { errors }.into())
        }
    }

    /// The value of a name.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        self.all(name).next()
    }

    /// Every value of a name that may stand there several times.
    pub(super) fn all(&self, name: &str) -> impl Iterator<Item = &str> {
        self.values.iter().filter(move |(known, _)| *known == name).map(|(_, value)| value.as_str())
    }

    /// Whether a name is set.
    pub(super) fn flag(&self, name: &str) -> bool {
        self.text(name) == Some(TRUE)
    }

    /// A whole number.
    pub(super) fn whole<N: std::str::FromStr>(&self, name: &str) -> Option<N> {
        self.text(name).and_then(|value| value.parse().ok())
    }

    /// A text of a bounded length, nothing in it that is not seen.
    pub(super) fn label(&self, name: &str) -> Result<Option<String>, Unanswered> {
        let Some(text) = self.text(name) else { return Ok(None) };
        if text.chars().count() > TEXT_MOST {
            let message = usage_text(&Usage::TooLong { most: TEXT_MOST }, self.language);
            return Err(option_fault(name, (message, None)).into());
        }
        Ok(Some(seen(text).into_owned()))
    }

    /// A quantity.
    pub(super) fn quantity<Q: Measure>(&self, name: &str) -> Result<Option<Q>, Unanswered> {
        let read =
            |text| workbench::read_quantity(text, self.language).map_err(|fault| option_fault(name, fault).into());
        self.text(name).map(read).transpose()
    }

    /// How tolerances are to be sampled.
    pub(super) fn draw(&self) -> Draw {
        Draw { samples: self.whole("samples"), seed: self.whole("seed").unwrap_or(SEED_USUAL) }
    }

    /// The code that a question is about, its faults as the record of a code.
    pub(super) fn code(&self) -> Result<OrderCode, Unanswered> {
        self.code_of(self.text("code").unwrap_or_default())
    }

    /// A code, its faults as the record of a code.
    pub(super) fn code_of(&self, text: &str) -> Result<OrderCode, Unanswered> {
        workbench::read_code(text, self.language)
            .map(|reading| reading.parsed.code)
            .map_err(|refusal| Unanswered::Code(code_faults(text, &refusal, self.language)))
    }

    /// The code that may be named, its faults as the record of a code.
    pub(super) fn code_if_any(&self) -> Result<Option<OrderCode>, Unanswered> {
        self.text("code").map(|text| self.code_of(text)).transpose()
    }

    /// A code, its faults among those of other questions.
    pub(super) fn code_among_others(&self, text: &str) -> Result<OrderCode, Faults> {
        workbench::read_code(text, self.language)
            .map(|reading| reading.parsed.code)
            .map_err(|refusal| faults(terminal::code(self.language), &code_told(text, &refusal)))
    }

    /// Why an actuator cannot be judged.
    pub(super) fn refused(&self, refusal: &Refusal) -> Unanswered {
        if *refusal == Refusal::Stopped {
            let waited = self.shell.time_limit().unwrap_or_default().as_secs();
            return Unanswered::Faults(503, fault(&requests::not_in_time(&waited, self.language)));
        }
        fault(&refusal_text(refusal, None, self.language)).into()
    }

    /// A name that another one needs.
    pub(super) fn missing(&self, name: &str) -> Unanswered {
        let what = Usage::Missing { names: name.to_owned() };
        Faults { errors: vec![usage(Some(name), &what, None, self.language)] }.into()
    }

    /// What the body is called.
    pub(super) fn name(&self) -> Result<String, Unanswered> {
        Ok(self.label("file")?.unwrap_or_else(|| USUAL_NAME.to_owned()))
    }

    /// The text of the body.
    pub(super) fn body(&self) -> Result<&'a str, Unanswered> {
        text_of(self.call.body, &self.name()?, self.language)
    }

    /// The bytes of the body.
    pub(super) fn bytes(&self) -> &'a [u8] {
        self.call.body
    }

    /// The axes of the project in the body, or the one that is asked for, each with its place.
    pub(super) fn axes(&self) -> Result<Vec<(usize, Project)>, Unanswered> {
        self.axes_of(self.body()?, &self.name()?)
    }

    /// The only axis, or the one that is asked for.
    pub(super) fn axis(&self) -> Result<(usize, Project), Unanswered> {
        self.axis_or(|names| terminal::several_axes(&names, self.language))
    }

    /// The only axis, or the one that is asked for; of several `told` says what is wrong.
    pub(super) fn axis_or(&self, told: impl FnOnce(&str) -> String) -> Result<(usize, Project), Unanswered> {
        let mut axes = self.axes()?;
        match (axes.len(), axes.pop()) {
            (1, Some(one)) => Ok(one),
            (_, last) => {
                axes.extend(last);
                Err(fault(&told(&workbench::names(axes.iter().map(|(_, project)| project)))).into())
            }
        }
    }

    /// The same of a text.
    pub(super) fn axes_of(&self, text: &str, name: &str) -> Result<Vec<(usize, Project)>, Unanswered> {
        let projects =
            workbench::read_all_watched(text, self.shell.files(), self.patience).map_err(|unread| match unread {
                Unread::Faults(found) => faults(name, &told(&found, self.language)).into(),
                Unread::Refused(refusal) => self.refused(&refusal),
            })?;
        workbench::picked(projects, self.text("axis"), self.language).map_err(|what| fault(&what).into())
    }

    /// The two texts of a body in JSON.
    pub(super) fn two_texts(&self) -> Result<(String, String), Unanswered> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Two {
            old: String,
            new: String,
        }
        let two: Two = serde_json::from_slice(self.call.body).map_err(|error| {
            Unanswered::from(fault(&requests::no_two_projects(&error.line(), &error.column(), self.language)))
        })?;
        Ok((two.old, two.new))
    }

    /// The measured values in the body, read as the command reads them.
    pub(super) fn measured(&self) -> Result<workbench::Measured, Unanswered> {
        workbench::measured(self.body()?)
            .map_err(|found| faults(&self.name().unwrap_or_default(), &told(&found, self.language)).into())
    }
}

/// The text of a body.
fn text_of<'b>(body: &'b [u8], name: &str, language: Language) -> Result<&'b str, Unanswered> {
    if body.len() > PROJECT_MAX_BYTES {
        let what = terminal::file_too_large(&PROJECT_MAX_BYTES, language);
        return Err(Unanswered::Faults(413, file_fault(name, &what)));
    }
    std::str::from_utf8(body).map_err(|error| {
        let before = body.get(..error.valid_up_to()).unwrap_or_default();
        let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
        file_fault(name, &terminal::not_utf_8(&line, language)).into()
    })
}

/// Media types in which a text may come: its own, none, and what clients send when nobody tells them.
const TEXTS: [&str; 6] = [
    "application/toml",
    "text/plain",
    "text/csv",
    "text/toml",
    "application/octet-stream",
    "application/x-www-form-urlencoded",
];

/// Whether the body is of a type that the endpoint reads.
fn media(body: Body, call: &Call<'_>, language: Language) -> Result<(), Unanswered> {
    let Some(media) = call.media.filter(|media| !media.trim().is_empty()) else { return Ok(()) };
    let plain = media.split(';').next().unwrap_or_default().trim().to_ascii_lowercase();
    let valid: &[&str] = match body {
        Body::None => return Ok(()),
        Body::Project | Body::Pins | Body::Measured => &TEXTS,
        Body::TwoProjects => &[super::JSON, "application/x-www-form-urlencoded"],
    };
    if valid.contains(&plain.as_str()) {
        return Ok(());
    }
    let wanted = valid.first().copied().unwrap_or_default();
    let message = requests::wrong_media(&seen(media), &wanted, language);
    let fault = Fault { id: Some("request"), message, ..Fault::default() };
    Err(Unanswered::Faults(415, Faults { errors: vec![fault] }))
}

/// How a flag that is set is kept.
const TRUE: &str = "true";

/// A value as it is kept, or what would be right.
fn valid<'v>(parameter: &Parameter, value: &'v str) -> Result<Cow<'v, str>, Option<UsageHint>> {
    match parameter.kind {
        Kind::Text | Kind::Date => Ok(Cow::Borrowed(value)),
        Kind::Flag => match value {
            "" | "1" => Ok(Cow::Borrowed(TRUE)),
            "0" => Ok(Cow::Borrowed("false")),
            TRUE | "false" => Ok(Cow::Borrowed(value)),
            _ => Err(Some(UsageHint::Words(Hint::ValidAre(vec![TRUE.to_owned(), "false".to_owned()])))),
        },
        Kind::Whole(least, most) => match value.parse::<u64>() {
            Ok(number) if (least..=most).contains(&number) => Ok(Cow::Borrowed(value)),
            Err(error) if !matches!(error.kind(), std::num::IntErrorKind::PosOverflow) && !is_whole(value) => {
                Err(Some(UsageHint::WholeNumber))
            }
            _ => Err(Some(UsageHint::Range(least.to_string(), most.to_string()))),
        },
        Kind::Word(words) => {
            let words = words();
            if words.contains(&value) {
                Ok(Cow::Borrowed(value))
            } else {
                Err(Some(UsageHint::Words(near(value, &words))))
            }
        }
    }
}

/// Whether a text is a whole number, however large and of whatever sign.
fn is_whole(text: &str) -> bool {
    let digits = text.strip_prefix(['-', '+']).unwrap_or(text);
    !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit())
}

/// The word that was probably meant, or all of them.
fn near(written: &str, words: &[&str]) -> Hint {
    let distance = |word: &&str| strsim::damerau_levenshtein(word, written);
    match words.iter().copied().min_by_key(distance).filter(|word| distance(word) * 2 <= word.len()) {
        Some(word) => Hint::DidYouMean(word.to_owned()),
        None => Hint::ValidAre(words.iter().map(|word| (*word).to_owned()).collect()),
    }
}

fn usage(option: Option<&str>, usage: &Usage, hint: Option<UsageHint>, language: Language) -> Fault {
    Fault {
        id: Some("usage"),
        option: option.map(str::to_owned),
        message: usage_text(usage, language),
        hint: hint.map(|hint| usage_hint(&hint, language)),
        ..Fault::default()
    }
}

/// So much of a value is told again.
const SHOWN_MOST: usize = 60;

fn shown(text: &str) -> String {
    let short: String = text.chars().take(SHOWN_MOST).collect();
    seen(&short).into_owned()
}

fn bad_value(name: &str, value: &str, hint: Option<UsageHint>, language: Language) -> Fault {
    let what = Usage::BadValue { written: shown(value), name: name.to_owned() };
    usage(Some(name), &what, hint, language)
}

fn unknown(name: &str, endpoint: &Endpoint, language: Language) -> Fault {
    let names: Vec<&str> = endpoint.parameters.iter().map(|parameter| parameter.name).chain(["lang"]).collect();
    let hint = UsageHint::Words(near(name, &names));
    usage(Some(&shown(name)), &Usage::UnknownOption { written: shown(name) }, Some(hint), language)
}

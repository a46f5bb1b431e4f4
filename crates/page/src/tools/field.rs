//! The fields of a tool: what the question takes, what was typed, what is wrong with it.

use super::MARK;
use answers::Fault;
use maud::{Markup, html};
use project::Key;
use quantities::Language;
use questions::list::{self, Argument, Unanswered};
use std::borrow::Cow;
use words::{key_word, page};

/// A field.
#[derive(Clone)]
pub(super) struct Field {
    /// As the interface calls it.
    pub(super) name: String,
    pub(super) label: String,
    /// What else is to be known of it.
    pub(super) remark: Option<String>,
    /// What stands in grey where nothing is typed.
    pub(super) ghost: Option<String>,
    entry: FieldEntry,
    pub(super) value: String,
    pub(super) troubles: Vec<Trouble>,
}

/// How it is filled in.
#[derive(Clone)]
pub(super) enum FieldEntry {
    Line,
    /// Several texts, a line each.
    Lines,
    Day,
    Whole,
    Mark,
    /// One of these words, each with its label.
    Choice(Vec<(String, String)>),
}

/// What is wrong.
#[derive(Clone)]
pub(super) struct Trouble {
    /// The field that it is about.
    pub(super) field: Option<String>,
    pub(super) message: String,
    pub(super) hint: Option<String>,
}

impl Trouble {
    pub(super) fn shown(&self) -> Markup {
        html! { p.fault { (self.message) @if let Some(hint) = &self.hint { " – " (hint) } } }
    }
}

/// What the page itself says in a question.
const SAID_OTHERWISE: [&str; 6] = ["code", "axis", "file", "width", "height", "theme"];

/// The words of a choice, each as it is said.
fn choice(name: &str, words: &[&str], language: Language) -> FieldEntry {
    let said = |word: &&str| {
        let text = key_word(name, word, language).map_or_else(|| (*word).to_owned(), Cow::into_owned);
        ((*word).to_owned(), text)
    };
    FieldEntry::Choice(words.iter().map(said).collect())
}

impl Field {
    /// The field of a key of a file, with its words or an example of its value in grey.
    pub(super) fn of_key(path: &str, label: &str, key: &Key, language: Language) -> Self {
        let entry = match key.kind {
            project::Kind::OneOf(words) => choice(key.name, words, language),
            _ => FieldEntry::Line,
        };
        let ghost = crate::value::sample(key).map(|sample| page::for_example(&sample, language));
        Self { ghost, ..Self::new(path, label, entry) }
    }

    /// The field of an argument; none for one that the page gives itself.
    pub(super) fn of_argument(argument: &Argument, language: Language) -> Option<Self> {
        if SAID_OTHERWISE.contains(&argument.name) {
            return None;
        }
        let entry = match argument.kind {
            list::ArgumentKind::Text if argument.repeated => FieldEntry::Lines,
            list::ArgumentKind::Text | list::ArgumentKind::Code | list::ArgumentKind::File => FieldEntry::Line,
            list::ArgumentKind::Date => FieldEntry::Day,
            list::ArgumentKind::Flag => FieldEntry::Mark,
            list::ArgumentKind::Whole(..) => FieldEntry::Whole,
            list::ArgumentKind::Word(words) => choice(argument.name, &words(), language),
        };
        let about = (argument.about)(language);
        let about = if argument.repeated { page::one_a_line(&about, language) } else { about.to_owned() };
        Some(Self::new(argument.name, &about, entry))
    }

    /// A field; the text behind its first full stop stands below it.
    pub(super) fn new(name: &str, about: &str, entry: FieldEntry) -> Self {
        let stop = [about.find("; "), about.find(": ")].into_iter().flatten().min();
        let (label, remark) = match stop.and_then(|stop| about.split_at_checked(stop)) {
            Some((label, remark)) => (label, remark.get(2..).map(str::to_owned)),
            None => (about, None),
        };
        Self {
            name: name.to_owned(),
            label: label.to_owned(),
            remark,
            ghost: None,
            entry,
            value: String::new(),
            troubles: Vec::new(),
        }
    }

    /// What is asked with it: nothing where nothing is typed.
    pub(super) fn values(&self) -> impl Iterator<Item = &str> {
        let whole = !matches!(self.entry, FieldEntry::Lines);
        let lines = self.value.lines().map(str::trim).filter(move |_| !whole);
        let one = Some(self.value.trim()).filter(|_| whole);
        one.into_iter().chain(lines).filter(|value| !value.is_empty())
    }

    /// The row of the field.
    pub(super) fn shown(&self, language: Language) -> Markup {
        let (id, name) = (format!("t-{}", self.name), format!("{MARK}{}", self.name));
        let wrong = !self.troubles.is_empty();
        let (about, fault) = (format!("{id}-a"), format!("{id}-x"));
        let by = [self.remark.is_some().then_some(about.as_str()), wrong.then_some(fault.as_str())];
        let by: Vec<&str> = by.into_iter().flatten().collect();
        let by = Some(by.join(" ")).filter(|by| !by.is_empty());
        let invalid = wrong.then_some("true");
        html! {
            div.row {
                label for=(id) { (self.label) }
                @match &self.entry {
                    FieldEntry::Lines => textarea id=(id) name=(name) rows="4" spellcheck="false" aria-invalid=[invalid] aria-describedby=[by] { (self.value) },
                    FieldEntry::Mark => input id=(id) name=(name) type="checkbox" value="true" checked[self.value == "true"] data-checked=(self.value == "true") aria-describedby=[by];,
                    FieldEntry::Choice(words) => select id=(id) name=(name) data-chosen=(self.value) aria-invalid=[invalid] aria-describedby=[by] {
                        option value="" selected[self.value.is_empty()] { (page::not_stated(language)) }
                        @for (value, title) in words { option value=(value) selected[self.value == *value] { (title) } }
                    },
                    FieldEntry::Day => input id=(id) name=(name) type="date" value=(self.value) aria-invalid=[invalid] aria-describedby=[by];,
                    FieldEntry::Whole => input id=(id) name=(name) type="text" inputmode="numeric" value=(self.value) autocomplete="off" aria-invalid=[invalid] aria-describedby=[by];,
                    FieldEntry::Line => input id=(id) name=(name) type="text" value=(self.value) placeholder=[self.ghost.as_ref()] autocomplete="off" spellcheck="false" aria-invalid=[invalid] aria-describedby=[by];,
                }
                @if let Some(remark) = &self.remark { p.small id=(about) { (remark) } }
                @if wrong { div.fault id=(fault) { @for trouble in &self.troubles { (trouble.shown()) } } }
            }
        }
    }
}

/// What is wrong with a question.
pub(super) fn troubles(unanswered: &Unanswered, language: Language) -> Vec<Trouble> {
    let of_code = matches!(unanswered, Unanswered::Code { .. });
    let trouble = |fault: Fault| Trouble {
        field: fault.option.or(fault.file).filter(|_| !of_code),
        // Of several texts in a field the line says which.
        message: match fault.place.filter(|_| !of_code) {
            Some(place) => format!("{}: {}", page::at_line(&place.line, &place.column, language), fault.message),
            None => fault.message,
        },
        hint: fault.hint,
    };
    unanswered.faults(None, language).errors.into_iter().map(trouble).collect()
}

/// Puts each fault to its field; gives back those that have none. Before anything is typed, an empty field is no fault.
pub(super) fn at_their_fields(fields: &mut [Field], troubles: Vec<Trouble>, is_filled: bool) -> Vec<Trouble> {
    let mut loose = Vec::new();
    for trouble in troubles {
        match fields.iter_mut().find(|field| trouble.field.as_ref() == Some(&field.name)) {
            Some(field) if is_filled || !field.value.is_empty() => field.troubles.push(trouble),
            Some(_) => {}
            None => loose.push(trouble),
        }
    }
    loose
}

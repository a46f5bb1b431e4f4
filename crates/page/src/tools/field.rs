//! Fields of a tool: arguments of the question, entries of the user, faults.

use crate::arithmetic::computed;
use answers::Fault;
use maud::{Markup, html};
use project::Key;
use quantities::Language;
use questions::list::{self, Argument, Unanswered};
use std::borrow::Cow;
use words::{key_word, page};

/// Prefix of the fields of a tool, which keeps them apart from those of the project.
pub(super) const MARK: &str = "t_";

/// A field.
#[derive(Clone)]
pub(super) struct ToolField {
    /// Name in the interface.
    pub(super) name: String,
    pub(super) label: String,
    /// Additional explanation.
    pub(super) remark: Option<String>,
    /// Placeholder, shown in grey without an entry.
    pub(super) ghost: Option<String>,
    entry: FieldEntry,
    pub(super) value: String,
    pub(super) troubles: Vec<Trouble>,
}

/// Kind of entry.
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

/// A fault of an entry.
#[derive(Clone)]
pub(super) struct Trouble {
    /// Field of the fault.
    pub(super) field: Option<String>,
    pub(super) message: String,
    pub(super) hint: Option<String>,
}

impl Trouble {
    pub(super) fn shown(&self, language: Language) -> Markup {
        html! { p.fault { (crate::sentences::worded(&self.message, self.hint.as_deref(), language)) } }
    }
}

/// Returns the faults with those of the arithmetic in place of the others of its fields.
pub(super) fn with_arithmetic(fields: &[ToolField], troubles: Vec<Trouble>, language: Language) -> Vec<Trouble> {
    let of_field = |field: &ToolField| {
        let fault = computed(&field.value, language).err().filter(|_| field.is_line())?;
        Some(Trouble { field: Some(field.name.clone()), message: fault.text("kg", language), hint: None })
    };
    let own: Vec<Trouble> = fields.iter().filter_map(of_field).collect();
    let others = troubles.into_iter().filter(|each| !own.iter().any(|one| one.field == each.field));
    let others: Vec<Trouble> = others.collect();
    own.into_iter().chain(others).collect()
}

/// Arguments that the page itself adds to a question.
const SAID_OTHERWISE: [&str; 6] = ["code", "axis", "file", "width", "height", "theme"];

/// Returns the words of a choice with their labels.
fn choice(name: &str, words: &[&str], language: Language) -> FieldEntry {
    let said = |word: &&str| {
        let text = key_word(name, word, language).map_or_else(|| (*word).to_owned(), Cow::into_owned);
        ((*word).to_owned(), text)
    };
    FieldEntry::Choice(words.iter().map(said).collect())
}

/// Returns a text without its example in quotes, and the example.
fn without_example(about: &str) -> (Cow<'_, str>, Option<&str>) {
    const LEADS: [&str; 4] = [", such as \"", ", for example \"", ", etwa \"", ", zum Beispiel \""];
    let found = LEADS.iter().find_map(|lead| {
        let (before, behind) = about.split_once(lead)?;
        let (example, after) = behind.split_once('"')?;
        Some((format!("{before}{after}"), example))
    });
    found.map_or((Cow::Borrowed(about), None), |(about, example)| (Cow::Owned(about), Some(example)))
}

impl ToolField {
    /// Creates the field of a key of a file, with its words, or with an example of its value in grey.
    pub(super) fn of_key(path: &str, label: &str, key: &Key, language: Language) -> Self {
        let entry = match key.kind {
            project::Kind::OneOf(words) => choice(key.name, words, language),
            _ => FieldEntry::Line,
        };
        let ghost = crate::value::sample(key).map(|sample| page::for_example(&sample, language));
        Self { ghost, ..Self::new(path, label, entry) }
    }

    /// Creates the field of an argument; `None` for one that the page itself states.
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
        let (about, example) = without_example(&about);
        let mut field = Self::new(argument.name, &about, entry);
        field.ghost = example.map(|example| page::for_example(&example, language));
        if let list::ArgumentKind::Word(words) = argument.kind {
            // The list of the words of the command line stands in the choice.
            field.remark = field.remark.filter(|remark| !words().iter().all(|word| remark.contains(word)));
        }
        Some(field)
    }

    /// Creates a field; the text behind its first full stop is shown below it.
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

    /// Returns a value of the question with its arithmetic computed; unchanged if there is none, or a faulty one.
    pub(super) fn computed(&self, value: &str, language: Language) -> String {
        let found = self.is_line().then(|| computed(value, language).ok().flatten()).flatten();
        found.unwrap_or_else(|| value.to_owned())
    }

    /// Returns `true` if the entry is a line, which may be a number.
    const fn is_line(&self) -> bool {
        matches!(self.entry, FieldEntry::Line | FieldEntry::Whole)
    }

    /// Returns the values of the question; none for an empty entry.
    pub(super) fn values(&self) -> impl Iterator<Item = &str> {
        let whole = !matches!(self.entry, FieldEntry::Lines);
        let lines = self.value.lines().map(str::trim).filter(move |_| !whole);
        let one = Some(self.value.trim()).filter(|_| whole);
        one.into_iter().chain(lines).filter(|value| !value.is_empty())
    }

    /// Returns the row of the field.
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
                    FieldEntry::Whole => input id=(id) name=(name) type="text" inputmode="numeric" value=(self.value) placeholder=[self.ghost.as_ref()] autocomplete="off" aria-invalid=[invalid] aria-describedby=[by];,
                    FieldEntry::Line => input id=(id) name=(name) type="text" value=(self.value) placeholder=[self.ghost.as_ref()] autocomplete="off" spellcheck="false" aria-invalid=[invalid] aria-describedby=[by];,
                }
                @if let Some(remark) = &self.remark { p.small id=(about) { (remark) } }
                @if wrong { div.fault id=(fault) { @for trouble in &self.troubles { (trouble.shown(language)) } } }
            }
        }
    }
}

/// Returns the faults of a question.
pub(super) fn troubles(unanswered: &Unanswered, language: Language) -> Vec<Trouble> {
    let of_code = matches!(unanswered, Unanswered::Code { .. });
    let trouble = |fault: Fault| Trouble {
        field: fault.option.or(fault.file).filter(|_| !of_code),
        // For several texts in a field, the line identifies the text.
        message: match fault.place.filter(|_| !of_code) {
            Some(place) => format!("{}: {}", page::at_line(&place.line, &place.column, language), fault.message),
            None => fault.message,
        },
        hint: fault.hint,
    };
    unanswered.faults(None, language).errors.into_iter().map(trouble).collect()
}

/// Returns the labels of the empty fields that an answer needs, before the first entry.
pub(super) fn awaited(fields: &[ToolField], troubles: &[Trouble], is_filled: bool) -> Vec<String> {
    let is_awaited = |field: &&ToolField| {
        !is_filled
            && field.value.is_empty()
            && troubles.iter().any(|trouble| trouble.field.as_ref() == Some(&field.name))
    };
    fields.iter().filter(is_awaited).map(|field| field.label.clone()).collect()
}

/// Adds each fault to its field and returns those without one. Before the first entry, an empty field is no fault.
pub(super) fn at_their_fields(fields: &mut [ToolField], troubles: Vec<Trouble>, is_filled: bool) -> Vec<Trouble> {
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

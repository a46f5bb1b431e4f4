//! Reasons why a question has no answer, before a face formats them.

use crate::answer::{
    code_faults, code_worded, fault, faults, file_fault, listed, option_fault, refusal_text, table_faults, written,
};
use crate::codes::CodeRefusal;
use crate::list::given::Hinted;
use crate::reading::Unread;
use crate::sizing_use::Refusal;
use crate::sweep::TableFaults;
use answers::{Fault, Faults};
use configurator::ProductId;
use quantities::{Language, seen};
use words::{Worded, terminal, worded};

/// Reason why a question has no answer.
#[derive(Clone, Debug)]
pub enum Unanswered {
    /// Faults of a text, each at its place.
    Text {
        /// Name of the text.
        name: String,
        /// The text.
        text: String,
        /// Faults of the text.
        faults: Vec<Worded>,
    },
    /// A text is no ordering code.
    Code {
        /// The text.
        text: String,
        /// Reasons, and nearest codes.
        refusal: CodeRefusal,
        /// `true` if the faults are reported with those of others; alone they are a record with the nearest codes.
        among: bool,
    },
    /// A file or a body is not read.
    File {
        /// Name of the file or body.
        name: String,
        /// Reason in one sentence.
        message: String,
        /// `true` if the size exceeds the limit.
        is_too_large: bool,
    },
    /// Faults of a table, each at its heading and row.
    Table {
        /// Name of the table.
        name: String,
        /// Faults of the table.
        faults: TableFaults,
    },
    /// The value of an argument is invalid.
    Option {
        /// The argument.
        name: &'static str,
        /// The fault of the value, and a hint.
        fault: Hinted,
    },
    /// Any other reason in one sentence, and a hint.
    Message(Hinted),
    /// The question is about one axis, and the project has several.
    WhichAxis {
        /// Reason in one sentence.
        message: String,
        /// Names of the axes.
        names: Vec<String>,
    },
    /// Names and values that the question does not accept.
    Usage(Vec<Fault>),
    /// The project is not judged; with the actuator if it is one of several.
    Refused(Refusal, Option<ProductId>),
    /// Several reasons.
    Together(Vec<Self>),
}

impl Unanswered {
    /// Creates the fault of an argument.
    #[must_use]
    pub const fn option(name: &'static str, fault: Hinted) -> Self {
        Self::Option { name, fault }
    }

    /// Refuses the invalid options, each with its reason.
    pub(super) fn unless_right<T: Into<String>>(
        options: impl IntoIterator<Item = (&'static str, bool, T)>,
    ) -> Result<(), Self> {
        let wrong = options.into_iter().filter(|(_, is_wrong, _)| *is_wrong);
        let faults: Vec<Self> = wrong.map(|(name, _, why)| Self::option(name, (why.into(), None))).collect();
        if faults.is_empty() { Ok(()) } else { Err(Self::combined(faults)) }
    }

    /// Creates a reason from one sentence.
    #[must_use]
    pub fn message(text: impl Into<String>) -> Self {
        Self::Message((text.into(), None))
    }

    /// Creates the reason that a question about one axis does not state which; `sentence` names the axes.
    #[must_use]
    pub fn which_axis(names: Vec<String>, sentence: impl FnOnce(&str) -> String) -> Self {
        Self::WhichAxis { message: sentence(&names.join(", ")), names }
    }

    /// Combines several reasons; a single one stays unchanged.
    #[must_use]
    pub fn combined(all: Vec<Self>) -> Self {
        <[Self; 1]>::try_from(all).map_or_else(Self::Together, |[one]| one)
    }

    /// Converts the reason why a project was not read.
    #[must_use]
    pub fn unread(unread: Unread, name: &str, text: &str, language: Language) -> Self {
        match unread {
            Unread::Faults(found) => {
                // The places are those of a text whose lines end with a newline.
                let text = project::with_newlines(text).into_owned();
                Self::Text { name: name.to_owned(), text, faults: worded(&found, language) }
            }
            Unread::Refused(refusal) => refusal.into(),
        }
    }

    /// Returns `true` if the work was cancelled, for example at its time limit.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        match self {
            Self::Refused(refusal, _) => *refusal == Refusal::Stopped,
            Self::Together(all) => all.iter().any(Self::is_stopped),
            Self::Text { .. }
            | Self::Table { .. }
            | Self::Code { .. }
            | Self::File { .. }
            | Self::Option { .. }
            | Self::Message(_)
            | Self::WhichAxis { .. }
            | Self::Usage(_) => false,
        }
    }

    /// Returns `true` if a text is too large.
    #[must_use]
    pub const fn is_too_large(&self) -> bool {
        matches!(self, Self::File { is_too_large: true, .. })
    }

    /// Returns the faults; `waited_s` is the time limit of the answer.
    #[must_use]
    pub fn faults(&self, waited_s: Option<f64>, language: Language) -> Faults {
        match self {
            Self::Text { name, faults: found, .. } => faults(name, found),
            Self::Code { text, refusal, .. } => Faults {
                nearest_codes: listed(&refusal.nearest, language),
                ..faults(terminal::code(language), &code_worded(text, refusal))
            },
            Self::Table { name, faults } => table_faults(name, faults, language),
            Self::File { name, message, .. } => file_fault(name, message),
            Self::Option { name, fault } => option_fault(name, fault.clone()),
            Self::Message((message, hint)) => {
                let fault = Fault { message: seen(message).into_owned(), hint: hint.clone(), ..Fault::default() };
                Faults::from(vec![fault])
            }
            Self::WhichAxis { message, .. } => fault(message),
            Self::Usage(errors) => Faults::from(errors.clone()),
            Self::Refused(refusal, _) => fault(&refusal_text(refusal, waited_s, language)),
            Self::Together(all) => Faults::combined(all.iter().map(|one| one.faults(waited_s, language))),
        }
    }

    /// Returns the record of the faults.
    #[must_use]
    pub fn record(&self, waited_s: Option<f64>, language: Language) -> String {
        match self {
            Self::Code { text, refusal, among: false } => written(&code_faults(text, refusal, language)),
            other => written(&other.faults(waited_s, language)),
        }
    }
}

impl From<Refusal> for Unanswered {
    fn from(refusal: Refusal) -> Self {
        Self::Refused(refusal, None)
    }
}

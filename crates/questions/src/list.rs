//! The questions: one list from which every face derives its use cases.
//!
//! A use case is one [`Entry`] in a module of its own: the command, a plain struct of its arguments, its inputs and
//! outputs, and the function that answers. The grammar of the command line, the route over HTTP with its parameters,
//! the reference page of the commands and the calculators of the page follow from it. A face adds the layout and the
//! transport.

mod argument;
mod cost;
mod given;
mod inquiry;
mod unanswered;

pub mod battery;
pub mod bearing;
pub mod catalogue;
pub mod catalogue_check;
pub mod check;
pub mod code_complete;
pub mod code_list;
pub mod code_parse;
pub mod commission;
pub mod commission_blank;
pub mod commission_checklist;
pub mod commission_drive;
pub mod commission_record;
pub mod compare;
pub mod curve;
pub mod data;
pub mod diff;
pub mod encoder;
pub mod encoder_trace;
pub mod errata;
pub mod explain;
pub mod export;
pub mod glossary;
pub mod identify;
pub mod inertia;
pub mod licences;
pub mod mount;
pub mod mount_project;
pub mod moves;
pub mod new;
pub mod plot;
pub mod report;
pub mod schema;
pub mod simulate;
pub mod size;
pub mod sweep;
pub mod torsion;
pub mod units;
pub mod upkeep;
pub mod upkeep_calendar;
pub mod wiring;
pub mod wiring_check;

pub use answers::Record;
pub use argument::{AXIS, Argument, ArgumentForm, ArgumentKind, CODE, FILE, LANG};
pub use cost::Cost;
pub use given::{Given, Hinted, bounded, recognises};
pub use inquiry::{Answer, Inquiry, PlacedAxis, ReferencedText, media};
pub use unanswered::Unanswered;

use project::{CATALOGUE_MAX_BYTES, PROJECT_MAX_BYTES};
use words::{Word, help};

/// Every question, in the order in which a face lists them.
pub static LIST: &[&Entry] = &[
    &size::ENTRY,
    &check::ENTRY,
    &sweep::ENTRY,
    &explain::ENTRY,
    &simulate::ENTRY,
    &identify::ENTRY,
    &report::ENTRY,
    &compare::ENTRY,
    &diff::ENTRY,
    &export::ENTRY,
    &code_parse::ENTRY,
    &code_list::ENTRY,
    &code_complete::ENTRY,
    &data::ENTRY,
    &wiring::ENTRY,
    &wiring_check::ENTRY,
    &encoder::ENTRY,
    &encoder_trace::ENTRY,
    &errata::ENTRY,
    &catalogue::ENTRY,
    &catalogue_check::ENTRY,
    &torsion::ENTRY,
    &commission::ENTRY,
    &commission_drive::ENTRY,
    &commission_checklist::ENTRY,
    &commission_blank::ENTRY,
    &commission_record::ENTRY,
    &inertia::ENTRY,
    &curve::ENTRY,
    &plot::ENTRY,
    &bearing::ENTRY,
    &moves::ENTRY,
    &battery::ENTRY,
    &mount::ENTRY,
    &mount_project::ENTRY,
    &upkeep::ENTRY,
    &upkeep_calendar::ENTRY,
    &new::ENTRY,
    &glossary::ENTRY,
    &units::ENTRY,
    &licences::ENTRY,
    &schema::ENTRY,
];

/// Records of commands that wrote a file, and of those that fail.
const OTHERS: [Record; 7] = [
    Record::of::<Vec<answers::CommissionWritten>>("commission --out"),
    Record::of::<answers::FilesWritten>("new --out"),
    Record::of::<answers::ReportWritten>("report"),
    Record::of::<answers::ExportWritten>("export --out"),
    Record::of::<answers::PlotWritten>("plot"),
    Record::of::<answers::CodeFaults>("faults of a code"),
    Record::of::<answers::Faults>("faults"),
];

/// Returns every record with its command.
pub fn records() -> Vec<Record> {
    let of_entries = LIST.iter().filter_map(|entry| match entry.gives {
        Gives::Record(record) | Gives::RecordOr(record, _) => Some(record),
        Gives::Json | Gives::Media(_) => None,
    });
    of_entries.chain(OTHERS).collect()
}

/// Function that answers a question.
pub type Function = fn(&Inquiry<'_>) -> Result<Answer, Unanswered>;

/// A use case.
#[derive(Clone, Copy)]
pub struct Entry {
    /// Words of the command; an option after them distinguishes a further question of the same command.
    pub command: &'static str,
    /// Path over HTTP: with the method GET if the question reads nothing, else POST.
    pub path: &'static str,
    /// Description of the question.
    pub about: Word,
    /// Texts to which the question refers.
    pub reads: Reads,
    /// Further arguments.
    pub arguments: &'static [Argument],
    /// Kind of the answer.
    pub gives: Gives,
    /// Files that the command writes on request.
    pub writes: &'static [OutputFile],
    /// Arguments of a valid call.
    pub example: &'static str,
    /// Function that computes the answer; `None` if a face draws, typesets or writes it.
    pub answer: Option<Function>,
}

impl Entry {
    /// Returns the command without the option that distinguishes the question.
    #[must_use]
    pub fn command(&self) -> &'static str {
        self.command.split_once(" --").map_or(self.command, |(command, _)| command)
    }

    /// Returns the option that distinguishes the question from others of its command.
    #[must_use]
    pub fn option(&self) -> Option<&'static str> {
        self.command.split_once(" --").map(|(_, option)| option)
    }

    /// Iterates over the other questions of the same command, each with an option of its own.
    pub fn others(&self) -> impl Iterator<Item = &'static Self> {
        questions_of(self.command).filter(|other| other.command != self.command)
    }

    /// Iterates over the files that the command writes on request, for this question or another of the same command.
    pub fn files(&self) -> impl Iterator<Item = &'static OutputFile> {
        questions_of(self.command()).flat_map(|other| other.writes)
    }
}

/// Iterates over the questions of a command, with or without an option.
fn questions_of(command: &str) -> impl Iterator<Item = &'static Entry> {
    let is_of = move |rest: &str| rest.is_empty() || rest.starts_with(" --");
    LIST.iter().copied().filter(move |entry| entry.command.strip_prefix(command).is_some_and(is_of))
}

/// A file that a command writes on request.
#[derive(Clone, Copy, Debug)]
pub struct OutputFile {
    /// Option that names the file.
    pub option: &'static str,
    /// Media type of the file, or those among which a call selects.
    pub media: &'static [&'static str],
    /// Description of the content.
    pub about: Word,
    /// `true` if the command requires the file.
    pub required: bool,
    /// Argument that the file requires.
    pub needs: Option<&'static str>,
}

/// A picture as SVG and as PNG.
const PICTURE: [OutputFile; 2] =
    [OutputFile::of("svg", &[media::SVG], help::svg), OutputFile::of("png", &[media::PNG], help::png)];

impl OutputFile {
    const fn of(option: &'static str, media: &'static [&'static str], about: Word) -> Self {
        Self { option, media, about, required: false, needs: None }
    }

    const fn required(self) -> Self {
        Self { required: true, ..self }
    }

    const fn with(self, needs: &'static str) -> Self {
        Self { needs: Some(needs), ..self }
    }

    /// Returns `true` if the file is a PDF, which the typesetting engine creates and standard output does not accept.
    #[must_use]
    pub fn is_pdf(&self) -> bool {
        self.media == [media::PDF]
    }
}

/// Texts to which a question refers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reads {
    /// No text.
    Nothing,
    /// A project file.
    Project,
    /// A list of pins.
    Pins,
    /// Values of the caller: measured ones, or those of catalogue files.
    Measured,
    /// Two revisions of a project.
    TwoProjects,
}

impl Reads {
    /// Returns the largest size of a text in bytes.
    #[must_use]
    pub const fn bytes_most(self) -> usize {
        match self {
            Self::Measured => CATALOGUE_MAX_BYTES,
            Self::Nothing | Self::Project | Self::Pins | Self::TwoProjects => PROJECT_MAX_BYTES,
        }
    }
}

/// Kind of an answer.
#[derive(Clone, Copy, Debug)]
pub enum Gives {
    /// A record.
    Record(Record),
    /// A record, or bytes of these media types if the arguments request them.
    RecordOr(Record, &'static [&'static str]),
    /// JSON that describes its own structure.
    Json,
    /// Bytes of these media types.
    Media(&'static [&'static str]),
}

impl Gives {
    /// Returns `true` if the answer is a record by default.
    #[must_use]
    pub const fn is_record(self) -> bool {
        match self {
            Self::Record(_) | Self::RecordOr(..) | Self::Json => true,
            Self::Media(_) => false,
        }
    }
}

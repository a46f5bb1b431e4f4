//! The questions: one list, from which every face takes what can be asked.
//!
//! A use case is one [`Entry`] in a module of its own: the command, a plain struct of its arguments, what it reads and gives,
//! and the function that answers. From it follow the grammar of the command line, the route over HTTP with its parameters, the
//! reference page of the commands and the calculators of the page. A face adds the layout and the transport.

mod argument;
mod asked;
mod cost;
mod given;
mod unanswered;

pub mod battery;
pub mod bearing;
pub mod catalogue;
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
pub use argument::{AXIS, Argument, ArgumentKind, CODE, FILE, Form, LANG};
pub use asked::{Answer, Asked, Axis, Source, media};
pub use cost::Cost;
pub use given::{Given, Hinted, bounded};
pub use unanswered::Unanswered;

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

/// What a command answers that wrote a file, and what any answers that cannot.
const OTHERS: [Record; 7] = [
    Record::of::<Vec<answers::CommissionWritten>>("commission --out"),
    Record::of::<answers::FilesWritten>("new --out"),
    Record::of::<answers::ReportWritten>("report"),
    Record::of::<answers::ExportWritten>("export --out"),
    Record::of::<answers::PlotWritten>("plot"),
    Record::of::<answers::CodeFaults>("faults of a code"),
    Record::of::<answers::Faults>("faults"),
];

/// Every record with the command that it answers.
pub fn records() -> Vec<Record> {
    let of_entries = LIST.iter().filter_map(|entry| match entry.gives {
        Gives::Record(record) | Gives::RecordOr(record, _) => Some(record),
        Gives::Json | Gives::Media(_) => None,
    });
    of_entries.chain(OTHERS).collect()
}

/// The function that answers a question.
pub type Function = fn(&Asked<'_>) -> Result<Answer, Unanswered>;

/// A use case.
#[derive(Clone, Copy)]
pub struct Entry {
    /// The words of its command; an option behind them makes another question of the command.
    pub command: &'static str,
    /// Its path over HTTP: with the method GET where it reads nothing, else POST.
    pub path: &'static str,
    /// What it answers.
    pub about: Word,
    /// The texts that it is about.
    pub reads: Reads,
    /// What else it takes.
    pub arguments: &'static [Argument],
    /// What it answers with.
    pub gives: Gives,
    /// The files that its command writes on request.
    pub writes: &'static [OutputFile],
    /// The arguments of a call that runs.
    pub example: &'static str,
    /// The answer; `None` where a face draws, typesets or writes it.
    pub answer: Option<Function>,
}

impl Entry {
    /// The command without the option that makes another question of it.
    #[must_use]
    pub fn command(&self) -> &'static str {
        self.command.split_once(" --").map_or(self.command, |(command, _)| command)
    }

    /// The option that makes this question of its command.
    #[must_use]
    pub fn option(&self) -> Option<&'static str> {
        self.command.split_once(" --").map(|(_, option)| option)
    }

    /// The other questions of its command, each by an option of its own.
    pub fn others(&self) -> impl Iterator<Item = &'static Self> {
        questions_of(self.command).filter(|other| other.command != self.command)
    }

    /// The files that the command writes on request, for this question or another of the same command.
    pub fn files(&self) -> impl Iterator<Item = &'static OutputFile> {
        questions_of(self.command()).flat_map(|other| other.writes)
    }
}

/// The questions of a command, by an option or without one.
fn questions_of(command: &str) -> impl Iterator<Item = &'static Entry> {
    let is_of = move |rest: &str| rest.is_empty() || rest.starts_with(" --");
    LIST.iter().copied().filter(move |entry| entry.command.strip_prefix(command).is_some_and(is_of))
}

/// A file that a command writes on request.
#[derive(Clone, Copy, Debug)]
pub struct OutputFile {
    /// The option that names it.
    pub option: &'static str,
    /// Its media type, or those of which a call says one.
    pub media: &'static [&'static str],
    /// What is written into it.
    pub about: Word,
    /// Whether the command needs it.
    pub required: bool,
    /// The argument without which it is not written.
    pub needs: Option<&'static str>,
}

/// A picture, as vectors and as pixels.
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

    /// Whether it is a PDF, which the typesetting engine makes and standard output does not take.
    #[must_use]
    pub fn is_pdf(&self) -> bool {
        self.media == [media::PDF]
    }
}

/// The texts that a question is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reads {
    /// None.
    Nothing,
    /// A project file.
    Project,
    /// A list of pins.
    Pins,
    /// Measured values.
    Measured,
    /// Two revisions of a project.
    TwoProjects,
}

/// What a question is answered with.
#[derive(Clone, Copy, Debug)]
pub enum Gives {
    /// A record.
    Record(Record),
    /// A record, and bytes of these media types where the arguments request them.
    RecordOr(Record, &'static [&'static str]),
    /// JSON that describes its own form.
    Json,
    /// Bytes of these media types.
    Media(&'static [&'static str]),
}

impl Gives {
    /// Whether it is a record unless something else is requested.
    #[must_use]
    pub const fn is_record(self) -> bool {
        match self {
            Self::Record(_) | Self::RecordOr(..) | Self::Json => true,
            Self::Media(_) => false,
        }
    }
}

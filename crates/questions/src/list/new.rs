//! `new KIND`: a commented project file, or catalogue file, to fill in.

use super::given::{arguments, by_id, count, flag, lines, text, word};
use super::{
    Answer, Argument, ArgumentForm, ArgumentKind, Entry, Gives, Inquiry, OutputFile, Reads, ReferencedText, Unanswered,
    media,
};
use crate::catalogue_template::{CatalogueFormat, catalogue_template};
pub use crate::incoming::previewed;
use crate::progress::Progress;
pub use crate::recorded_template::{begins_with_motion, recorded};
use crate::sizing_use::Refusal;
pub use crate::sweep::sample::{Method, SAMPLES_MOST, table};
pub use crate::templates::{Template, example, plain_text, stated, stating, template, template_kinds};
use axis::{Files, Grant};
use quantities::Language;
use std::borrow::Cow;
use std::io::Read;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use words::help::values;
use words::spoken::KINDS;
use words::{Worded, catalogue_template, help, requests};

arguments! {
    /// Arguments of `new`: kind of the file, and columns of a table.
    pub struct Args {
        /// The kind.
        kind: Option<String> = Argument::option("kind", values::kind, requests::kind)
            .of(ArgumentKind::Word(|| template_kinds().chain([SWEEP, CATALOGUE]).collect())).form(ArgumentForm::Bare).required().titled(other_words) => text,
        /// The example of a machine with all that it may have, in place of the plain file.
        example: bool = Argument::flag("example", help::new_example) => flag,
        /// Format of a catalogue file.
        format: Option<CatalogueFormat> = Argument::option("format", values::format, catalogue_template::format)
            .of(ArgumentKind::Word(|| CatalogueFormat::IDS.to_vec())) => word(by_id(&CatalogueFormat::ALL, CatalogueFormat::id)),
        /// Keys of a table with their ranges, one per line.
        key: String = Argument::option("key", values::text, help::new_key).repeated() => lines,
        /// Method of covering the ranges of a table.
        by: Option<Method> = Argument::option("by", values::name, help::new_by)
            .of(ArgumentKind::Word(|| Method::ALL.map(Method::id).to_vec())).usually("sobol")
            => word(by_id(&Method::ALL, Method::id)),
        /// Rows of a table, or steps of each range.
        samples: usize = Argument::option("samples", values::n, help::new_samples)
            .of(ArgumentKind::Whole(1, SAMPLES_MOST)).usually("100") => count,
        /// Seed of the samples of a table.
        seed: usize = Argument::option("seed", values::n, help::new_seed)
            .of(ArgumentKind::Whole(0, u32::MAX as u64)).usually("1") => count,
    }
}

/// The kind of a table of rows for a sweep.
const SWEEP: &str = "sweep";

/// The kind of a catalogue file.
pub const CATALOGUE: &str = "catalogue";

/// Name of a catalogue file without its ending.
const CATALOGUE_NAME: &str = "stock";

/// Returns the words of [`KINDS`], each with its kind.
fn other_words() -> Vec<(String, &'static str)> {
    let is_kind = |kind: &&str| [SWEEP, CATALOGUE].contains(kind) || template_kinds().any(|known| known == *kind);
    let of = |(kind, words): &(&'static str, &'static [&'static str])| {
        let kind = *kind;
        words.iter().map(move |word| ((*word).to_owned(), kind)).collect::<Vec<_>>()
    };
    KINDS.iter().filter(|(kind, _)| is_kind(kind)).flat_map(of).collect()
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "new",
    path: "new",
    about: help::new,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::TOML, media::CSV]),
    writes: &[OutputFile::of("out", &[media::TOML, media::CSV], help::new_out)],
    example: "arm --out axis.toml",
    answer: Some(|inquiry| {
        let Args { kind, format, .. } = Args::read(&inquiry.given)?;
        let is_table = kind.as_deref() == Some(SWEEP) || format == Some(CatalogueFormat::Csv);
        let media = if is_table { media::CSV } else { media::TOML };
        Ok(Answer::text(media, found(inquiry, USUAL_NAME)?.text))
    }),
};

/// Returns the description of a kind in a few words; `None` for an unknown one.
#[must_use]
pub fn kind_about(kind: &str, language: Language) -> Option<&'static str> {
    let about = match kind {
        "manual" => requests::kind_manual,
        "load" => requests::kind_load,
        "table" => requests::kind_table,
        "recording" => requests::kind_recording,
        "unwinder" => requests::kind_unwinder,
        SWEEP => requests::kind_sweep,
        CATALOGUE => catalogue_template::kind,
        mechanism => {
            let key = project::key_at(&format!("mechanism.{mechanism}"))?;
            return Some(words::about_text(key.about, language));
        }
    };
    Some(about(language))
}

/// Options that only the table of a sweep has.
const OF_A_SWEEP: [&str; 4] = ["key", "by", "samples", "seed"];

/// Default file name in the header of a new project.
pub const USUAL_NAME: &str = "axis.toml";

/// Returns the project file for a file name.
///
/// # Errors
/// If the kind does not exist, or has another format than the one that is stated.
pub fn found(inquiry: &Inquiry<'_>, file: &str) -> Result<Template, Unanswered> {
    let args = Args::read(&inquiry.given)?;
    let kind = args.kind.unwrap_or_default();
    if kind == CATALOGUE {
        return catalogue(args.format, file, inquiry.language);
    }
    if args.format.is_some() {
        let message = catalogue_template::format_of_catalogue_only(inquiry.language).to_owned();
        return Err(Unanswered::option("format", (message, None)));
    }
    let mut of_a_sweep = Args::ARGUMENTS.iter().filter(|argument| OF_A_SWEEP.contains(&argument.name));
    // A face may state every argument, the defaults too.
    if kind != SWEEP
        && let Some(option) = of_a_sweep.find(|argument| inquiry.given.differs(argument))
    {
        return Err(Unanswered::option(option.name, (requests::of_a_sweep_only(inquiry.language).to_owned(), None)));
    }
    if kind == SWEEP {
        let text =
            table(args.key.lines(), args.by.unwrap_or_default(), args.samples, args.seed as u64, inquiry.language)?;
        return Ok(Template { text, recording: None });
    }
    let of = if args.example { example } else { template };
    Ok(of(&kind, file, inquiry.language).ok_or(Refusal::NoData)?)
}

/// Identifier of the fault of a key that a project needs.
const MISSING: &str = "missing_key";

/// End of the identifiers of the faults of a motion that does not return to its beginning.
const NOT_CLOSED: &str = "_not_closed";

/// Key of a motion that does not return to its beginning.
pub const SINGLE_MOVE: &str = "axis.single_move";

/// State of a new project as a question would read it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Readiness {
    /// Messages about the keys that the user has yet to state: those of a recorded machine.
    pub missing: Vec<String>,
    /// Faults of the recording, each with what to write, in the file or in the project; none of the places that a call names.
    pub recording: Vec<String>,
    /// The motion does not return to its beginning.
    pub is_open: bool,
}

/// Identifiers of the faults of a recording that its segment or a change of its values puts right: the file is a table, and a
/// project with it has a meaning.
const OF_RECORDING: [&str; 34] = [
    "recording_time_missing",
    "recording_course_missing",
    "recording_columns_ambiguous",
    "recording_several_axes",
    "recording_heading_missing",
    "recording_heading_of_units",
    "recording_unit_missing",
    "recording_unit_unknown",
    "recording_unit_wrong",
    "recording_unit_scaled",
    "recording_unit_contradiction",
    "recording_unit_of_cell",
    "recording_course_mixed",
    "recording_clock_unknown",
    "recording_column_type",
    "recording_value_missing",
    "recording_value_unreadable",
    "recording_value_not_finite",
    "recording_value_implausible",
    "recording_decimal_mixed",
    "recording_thousands_grouped",
    "recording_thousands_possible",
    "recording_ragged",
    "recording_position_jumps",
    "recording_speed_jumps",
    "recording_time_backwards",
    "recording_same_time",
    "recording_times_too_close",
    "recording_times_differ",
    "recording_gap",
    "recording_scale_unknown",
    "recording_step_undecided",
    "recording_turn_begun",
    "recording_more_faults",
];

/// Number of faults of a recording that a call states; the next reading states the others.
const RECORDING_FAULTS_MOST: usize = 3;

/// Reads a new project as a question does, with its recording; `files` are those of its folder.
///
/// # Errors
/// Every fault, each with its place in the text; of a project that begins with a recording of the user (`is_recorded`) not the keys
/// that only the user knows, nor a motion that does not return, nor what is put right in the recording or in its segment.
pub fn checked(
    template: &Template,
    is_recorded: bool,
    files: &dyn Files,
    progress: &Progress,
    language: Language,
) -> Result<Readiness, Unanswered> {
    let files = Beside { recording: template.recording.as_ref(), files };
    let bytes = Cow::Borrowed(template.text.as_bytes());
    let source = ReferencedText { name: USUAL_NAME.to_owned(), bytes, files: &files };
    let mut readiness = Readiness::default();
    match source.projects(crate::embedded_catalogue(), progress, language) {
        Ok(_) => Ok(readiness),
        Err(Unanswered::Text { name, text, faults }) => {
            let of_recording = |fault: &&Worded| OF_RECORDING.contains(&fault.id);
            let of_program =
                |fault: &Worded| fault.id != MISSING && !fault.id.ends_with(NOT_CLOSED) && !of_recording(&fault);
            if !is_recorded || faults.iter().any(of_program) {
                return Err(Unanswered::Text { name, text, faults });
            }
            readiness.is_open = faults.iter().any(|fault| fault.id.ends_with(NOT_CLOSED));
            let told = |fault: &Worded| match &fault.hint {
                Some(hint) => format!("{} ({hint})", fault.message),
                None => fault.message.clone(),
            };
            readiness.recording = faults.iter().filter(of_recording).take(RECORDING_FAULTS_MOST).map(told).collect();
            readiness.missing =
                faults.into_iter().filter(|fault| fault.id == MISSING).map(|fault| fault.message).collect();
            Ok(readiness)
        }
        Err(why) => Err(why),
    }
}

/// Files of the folder of a new project, with a recording that is written together with it.
struct Beside<'t> {
    recording: Option<&'t (String, String)>,
    files: &'t dyn Files,
}

impl Files for Beside<'_> {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn Read>> {
        match self.recording {
            Some((own, text)) if own == name => Ok(Box::new(std::io::Cursor::new(text.clone().into_bytes()))),
            _ => self.files.open(name),
        }
    }

    fn size(&self, name: &str) -> Option<u64> {
        match self.recording {
            Some((own, text)) if own == name => Some(text.len() as u64),
            _ => self.files.size(name),
        }
    }

    fn cancelled(&self) -> Option<Arc<AtomicBool>> {
        self.files.cancelled()
    }

    fn grant(&self) -> Grant {
        self.files.grant()
    }
}

/// Returns the catalogue file for a file name, whose ending is that of the format.
fn catalogue(stated: Option<CatalogueFormat>, file: &str, language: Language) -> Result<Template, Unanswered> {
    let is_usual = file == USUAL_NAME;
    let ending = file.rsplit_once('.').map(|(_, ending)| ending.to_lowercase()).filter(|_| !is_usual);
    let by_ending = CatalogueFormat::ALL.into_iter().find(|format| ending.as_deref() == Some(format.id()));
    if let (Some(stated), Some(other)) = (stated, by_ending)
        && stated != other
    {
        return Err(Unanswered::option("format", (catalogue_template::other_ending(&other.id(), language), None)));
    }
    let format = stated.or(by_ending).unwrap_or(CatalogueFormat::Toml);
    let usual = || format!("{CATALOGUE_NAME}.{}", format.id());
    let file = if is_usual { usual() } else { file.to_owned() };
    Ok(Template { text: catalogue_template(format, &file, language), recording: None })
}

#[cfg(test)]
mod tests {
    use super::super::Given;
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn each_other_word_names_one_kind_and_is_no_kind_itself() {
        let words: Vec<&str> = KINDS.iter().flat_map(|(_, words)| words.iter().copied()).collect();
        let once: BTreeSet<&str> = words.iter().copied().collect();
        assert_eq!(words.len(), once.len());
        let kinds: BTreeSet<&str> = template_kinds().chain([SWEEP, CATALOGUE]).collect();
        for (kind, words) in KINDS {
            assert!(kinds.contains(kind), "{kind}");
            for word in *words {
                assert!(!kinds.contains(word), "{word}");
                let pairs = [("kind".into(), word.to_uppercase().replace(' ', "-").into())];
                let found = Given::of(Args::ARGUMENTS, pairs, Language::En).and_then(|given| Args::read(&given));
                assert_eq!(found.ok().and_then(|args| args.kind).as_deref(), Some(*kind), "{word}");
            }
        }
    }

    /// An option that a kind has no use for is refused, not ignored.
    #[test]
    fn options_of_a_sweep_are_refused_for_other_kinds() {
        let values = [("key", "motion[1].time [s] = 1, 2"), ("by", "grid"), ("samples", "5"), ("seed", "2")];
        // Python states every argument with its default.
        let defaults = [("by", "sobol"), ("samples", "100"), ("seed", "1")];
        for kind in template_kinds() {
            let stated: Vec<(&str, &str)> = [("kind", kind)].into_iter().chain(defaults).collect();
            let plain = made(&[("kind", kind)], USUAL_NAME);
            assert_eq!(made(&stated, USUAL_NAME).unwrap(), plain.unwrap(), "{kind}");
            for (option, value) in values {
                let refused = made(&[("kind", kind), (option, value)], USUAL_NAME);
                assert!(matches!(refused, Err(Unanswered::Option { name, .. }) if name == option), "{kind} {option}");
            }
        }
        assert!(made(&[("kind", SWEEP), ("key", "motion[1].time [s] = 1..3"), ("by", "grid")], USUAL_NAME).is_ok());
    }

    fn made(pairs: &[(&str, &str)], file: &str) -> Result<String, Unanswered> {
        let pairs = pairs.iter().map(|(name, value)| ((*name).into(), (*value).into()));
        let given = Given::of(Args::ARGUMENTS, pairs, Language::En)?;
        let progress = crate::Progress::endless();
        let catalogue = crate::embedded_catalogue();
        let (sources, language) = (Vec::new(), Language::En);
        let inquiry = Inquiry {
            given,
            sources,
            catalogue,
            days_since_1970: None,
            progress: &progress,
            refuses_long: true,
            by_axes: false,
            language,
        };
        found(&inquiry, file).map(|template| template.text)
    }

    #[test]
    fn the_format_of_a_catalogue_file_is_stated_or_that_of_its_ending() {
        let kind = ("kind", CATALOGUE);
        let is_toml = |text: Result<String, Unanswered>| text.unwrap().contains("[[actuator]]");
        assert!(is_toml(made(&[kind], USUAL_NAME)));
        assert!(is_toml(made(&[kind], "mine.TOML")));
        assert!(is_toml(made(&[kind], "mine")));
        assert!(!is_toml(made(&[kind], "mine.csv")));
        assert!(!is_toml(made(&[kind, ("format", "csv")], USUAL_NAME)));
        assert!(!is_toml(made(&[kind, ("format", "csv")], "mine")));
        assert!(made(&[kind, ("format", "csv")], "mine.toml").is_err());
        assert!(made(&[("kind", "arm"), ("format", "csv")], USUAL_NAME).is_err());
    }
}

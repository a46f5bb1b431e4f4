//! `new KIND`: a commented project file to fill in.

use super::given::{arguments, by_id, count, flag, lines, text, word};
use super::{
    Answer, Argument, ArgumentForm, ArgumentKind, Entry, Gives, Inquiry, OutputFile, Reads, Unanswered, media,
};
pub use crate::incoming::IncomingFile;
pub use crate::recorded_template::{begins_with_motion, recorded};
use crate::sizing_use::Refusal;
pub use crate::sweep::sample::{Method, SAMPLES_MOST, table};
pub use crate::templates::{Template, example, plain_text, template, template_kinds};
use quantities::Language;
use words::help::values;
use words::spoken::KINDS;
use words::{help, requests};

arguments! {
    /// Arguments of `new`: kind of the file, and columns of a table.
    pub struct Args {
        /// The kind.
        kind: Option<String> = Argument::option("kind", values::kind, requests::kind)
            .of(ArgumentKind::Word(|| template_kinds().chain([SWEEP]).collect())).form(ArgumentForm::Bare).required().titled(other_words) => text,
        /// The example of a machine with all that it may have, in place of the plain file.
        example: bool = Argument::flag("example", help::new_example) => flag,
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

/// Returns the words of [`KINDS`], each with its kind.
fn other_words() -> Vec<(String, &'static str)> {
    let is_kind = |kind: &&str| *kind == SWEEP || template_kinds().any(|known| known == *kind);
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
        let is_table = inquiry.given.all("kind").any(|kind| kind == SWEEP);
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
        SWEEP => requests::kind_sweep,
        mechanism => {
            let key = project::key_at(&format!("mechanism.{mechanism}"))?;
            return Some(words::about_text(key.about, language));
        }
    };
    Some(about(language))
}

/// Default file name in the header of a new project.
pub const USUAL_NAME: &str = "axis.toml";

/// Returns the project file for a file name.
///
/// # Errors
/// If the kind does not exist.
pub fn found(inquiry: &Inquiry<'_>, file: &str) -> Result<Template, Unanswered> {
    let args = Args::read(&inquiry.given)?;
    let kind = args.kind.unwrap_or_default();
    if kind == SWEEP {
        let text =
            table(args.key.lines(), args.by.unwrap_or_default(), args.samples, args.seed as u64, inquiry.language)?;
        return Ok(Template { text, recording: None });
    }
    let of = if args.example { example } else { template };
    Ok(of(&kind, file, inquiry.language).ok_or(Refusal::NoData)?)
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
        let kinds: BTreeSet<&str> = template_kinds().chain([SWEEP]).collect();
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
}

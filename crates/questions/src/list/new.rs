//! `new KIND`: a commented project file to fill in.

use super::given::{arguments, text};
use super::{Answer, Argument, ArgumentKind, Asked, Entry, Form, Gives, OutputFile, Reads, Unanswered, media};
use crate::sizing_use::Refusal;
pub use crate::templates::{Template, template, template_kinds};
use words::help::values;
use words::{help, requests};

arguments! {
    /// Which kind.
    pub struct Args {
        /// The kind.
        kind: Option<String> = Argument::option("kind", values::kind, requests::kind)
            .of(ArgumentKind::Word(|| template_kinds().collect())).form(Form::Bare).required() => text,
    }
}

/// The question.
pub const ENTRY: Entry = Entry {
    command: "new",
    path: "new",
    about: help::new,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Media(&[media::TOML]),
    writes: &[OutputFile::of("out", &[media::TOML], help::new_out)],
    example: "arm --out axis.toml",
    answer: Some(|asked| Ok(Answer::text(media::TOML, found(asked, USUAL_NAME)?.text))),
};

/// What the header of a new project calls its file, where it has no name.
pub const USUAL_NAME: &str = "axis.toml";

/// The project file, for a file of a name.
///
/// # Errors
/// Where there is no such kind.
pub fn found(asked: &Asked<'_>, file: &str) -> Result<Template, Unanswered> {
    let kind = Args::read(&asked.given)?.kind.unwrap_or_default();
    Ok(template(&kind, file, asked.language).ok_or(Refusal::NoData)?)
}

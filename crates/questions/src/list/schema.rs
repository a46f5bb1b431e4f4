//! `schema`: the JSON Schema of the project file, or of the answers.

use super::given::{arguments, flag};
use super::{Answer, Argument, Entry, Gives, Reads, records};
use crate::reading::schema;
use words::help;

arguments! {
    /// Arguments of `schema`: its subject.
    pub struct Args {
        /// Selects the schema of the answers.
        answers: bool = Argument::flag("answers", help::schema_answers) => flag,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "schema",
    path: "schema",
    about: help::schema,
    reads: Reads::Nothing,
    arguments: Args::ARGUMENTS,
    gives: Gives::Json,
    writes: &[],
    example: "",
    answer: Some(|asked| {
        let of_answers = Args::read(&asked.given)?.answers;
        Ok(if of_answers {
            Answer::record(&answers::schema(&records()))
        } else {
            Answer::record(&schema(asked.language))
        })
    }),
};

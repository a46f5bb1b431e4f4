//! `moves PROJECT`: the motion of an axis, with the solved values of every segment.

use super::given::{arguments, text};
use super::{AXIS, Answer, Cost, Entry, Gives, Reads, Record};
use crate::answer;
use crate::moves::moves;
use words::requests;

arguments! {
    /// Arguments of `moves`: the axis.
    pub struct Args {
        /// The axis of a project with several.
        axis: Option<String> = AXIS => text,
    }
}

/// The question.
pub static ENTRY: Entry = Entry {
    command: "moves",
    path: "moves",
    about: requests::moves,
    reads: Reads::Project,
    arguments: Args::ARGUMENTS,
    gives: Gives::Record(Record::of::<answers::Motion>("moves")),
    writes: &[],
    example: "axis.toml",
    answer: Some(|asked| {
        let args = Args::read(&asked.given)?;
        let (_, project) = asked.axis(args.axis.as_deref(), Cost::Other)?;
        Ok(Answer::record(&answer::motion(&moves(&project), asked.language)))
    }),
};
